//! From a video file to the marks of its frames, all that is needed in place.

use std::path::{Path, PathBuf};

use serde::Deserialize;

use super::marks::{Mark, Point, Which, read};
use super::{Along, Video};
use crate::input::check::{format_is_one, refuse};
use crate::input::document::Node;
use crate::input::error::{InputError, Problem};
use crate::input::{file, form, keys};

/// Share of the untwisted chord that a frame must show at least.
const LEAST_SHARE: f64 = 0.05;
/// Distance of two marks below which they have no direction, px.
const NEAREST_PX: f64 = 1.0;

/// A video file with its marks.
#[derive(Debug, Clone)]
pub struct LoadedVideo {
    /// The description.
    pub video: Video,
    /// The file of the marks, as the user named it.
    pub marks_file: String,
    /// The frame that shows the wing untwisted, if there is one; it has every station of the others.
    pub rest: Option<VideoFrame>,
    /// The other frames, at least one, in the order of the file.
    pub frames: Vec<VideoFrame>,
}

/// One frame.
#[derive(Debug, Clone, PartialEq)]
pub struct VideoFrame {
    /// Name.
    pub name: String,
    /// Stations from base to tip, each with both edges.
    pub stations: Vec<VideoStation>,
    /// The reference points a and b; all frames have them, or none.
    pub references: Option<[Mark; 2]>,
}

/// Both edges at a station.
#[derive(Debug, Clone, PartialEq)]
pub struct VideoStation {
    /// Distance from the wing base on the wing at rest, mm.
    pub r_mm: f64,
    /// Chord, mm, if it was given; it always is where it is needed.
    pub chord_mm: Option<f64>,
    /// Mark on the leading edge.
    pub leading: Mark,
    /// Mark on the trailing edge.
    pub trailing: Mark,
}

impl Video {
    /// Reads a video file without its marks.
    ///
    /// # Errors
    /// Whatever is wrong with it, with place and cure.
    pub fn load(path: &Path) -> Result<Video, InputError> {
        Video::read(&file::shown(path), &file::read_text(path, "video file")?)
    }

    /// Reads its text; the name stands in errors.
    ///
    /// # Errors
    /// Whatever is wrong with it, with place and cure.
    pub fn read(name: &str, text: &str) -> Result<Video, InputError> {
        Ok(description(name, text)?.0)
    }
}

impl LoadedVideo {
    /// Reads a video file and its marks.
    ///
    /// # Errors
    /// Whatever is wrong with them, with place and cure.
    pub fn load(path: &Path) -> Result<LoadedVideo, InputError> {
        let (video, root) = description(&file::shown(path), &file::read_text(path, "video file")?)?;
        let marks_path: PathBuf = file::beside(path, &video.marks);
        if !marks_path.is_file() {
            let cure = format!(
                "Looked for {}; paths are relative to the video file",
                file::shown(&marks_path)
            );
            return refuse(&root, "marks", "no such file", &[], cure);
        }
        let text = file::read_text(&marks_path, "file of marks")?;
        LoadedVideo::of(video, &root, file::shown(&marks_path), &text)
    }

    /// Reads the text of a video file and that of its marks; the names stand in errors.
    ///
    /// # Errors
    /// Whatever is wrong with them, with place and cure.
    pub fn read(
        (name, text): (&str, &str),
        (marks_name, marks): (&str, &str),
    ) -> Result<LoadedVideo, InputError> {
        let (video, root) = description(name, text)?;
        LoadedVideo::of(video, &root, marks_name.to_string(), marks)
    }

    fn of(video: Video, root: &Node, marks_file: String, marks: &str) -> Result<LoadedVideo, InputError> {
        let points = read(&marks_file, marks)?;
        let mut frames = frames(&points)?;
        let rest = match &video.rest {
            None => None,
            Some(name) => match frames.iter().position(|frame| frame.name == *name) {
                Some(at) => Some(frames.remove(at)),
                None => {
                    let names: Vec<&str> = frames.iter().map(|frame| frame.name.as_str()).collect();
                    let cure = format!("The frames of {marks_file} are {}", names.join(", "));
                    return refuse(root, "rest", "there is no such frame", &["marks"], cure);
                }
            },
        };
        let loaded = LoadedVideo {
            video,
            marks_file,
            rest,
            frames,
        };
        loaded.is_enough(root, &points)?;
        Ok(loaded)
    }

    /// Refuses marks that give no twist with this view.
    fn is_enough(&self, root: &Node, points: &[Point]) -> Result<(), InputError> {
        if self.frames.is_empty() {
            let cure = "Add marks of a frame that shows the wing under load";
            return refuse(root, "marks", "there is no frame besides rest", &["rest"], cure);
        }
        self.references_are_enough(root)?;
        if self.video.sigma_px.is_none() && points.iter().all(|point| point.mark().scatter_px2 == 0.0) {
            let cure = "Give the standard deviation of a click, e.g. sigma_px = 0.5, or click each mark several times and \
                        number the clicks in the column repeat";
            let message = "is missing, and no mark was clicked twice at different places";
            return refuse(root, "sigma_px", message, &[], cure);
        }
        let mut stations = self.frames.iter().flat_map(|frame| &frame.stations);
        stations.try_for_each(|station| self.station_is_enough(station, points))
    }

    /// Refuses frames that do not say what untwisted is.
    fn references_are_enough(&self, root: &Node) -> Result<(), InputError> {
        let referred: Vec<&VideoFrame> = (self.frames.iter().chain(&self.rest))
            .filter(|frame| frame.references.is_some())
            .collect();
        let count = self.frames.len() + usize::from(self.rest.is_some());
        if !referred.is_empty() && referred.len() < count {
            let without = self
                .frames
                .iter()
                .chain(&self.rest)
                .find(|f| f.references.is_none());
            let name = without.map_or("", |frame| frame.name.as_str());
            let message = format!(
                "frame {name} has no reference points, frame {} has",
                referred[0].name
            );
            let cure = "Click reference_a and reference_b in every frame, or in none";
            return refuse(root, "marks", message, &[], cure);
        }
        let has_distance = self
            .video
            .references
            .as_ref()
            .is_some_and(|r| r.distance_mm.is_some());
        if self.rest.is_none() && referred.is_empty() {
            let cure = match self.video.view.along {
                Along::Span => {
                    "Name the frame that shows the wing untwisted, or click reference_a and reference_b on a line along \
                     the untwisted chord, from leading to trailing edge"
                }
                _ => {
                    "Name the frame that shows the wing untwisted, or click reference_a and reference_b and give \
                     references.distance_mm"
                }
            };
            let message =
                "is missing, and the frames show no reference points: nothing says what untwisted is";
            return refuse(root, "rest", message, &["references"], cure);
        }
        if self.rest.is_none() && self.video.view.along != Along::Span && !has_distance {
            let cure = "Give the distance between the reference points, or name the frame that shows the wing untwisted";
            return refuse(root, "references.distance_mm", "is missing", &["rest"], cure);
        }
        Ok(())
    }

    /// Refuses a station of which neither the untwisted wing nor the chord is known where it is needed.
    fn station_is_enough(&self, station: &VideoStation, points: &[Point]) -> Result<(), InputError> {
        let point = points
            .iter()
            .find(|point| point.record.line == station.leading.line);
        let Some(point) = point else { return Ok(()) };
        match &self.rest {
            Some(rest) if !rest.stations.iter().any(|s| s.r_mm == station.r_mm) => {
                let message = format!("frame {} has no marks at this station", rest.name);
                let cure = "Click both edges there too, or leave the station out";
                Err(point.record.conflict("r_mm", message, &["frame"], cure))
            }
            None if self.video.view.along != Along::Span && station.chord_mm.is_none() => {
                let cure = "Give the chord at the station in a column chord_mm; without a frame of the untwisted wing \
                            it says how much of the chord the frame shows";
                Err(point.record.conflict("chord_mm", "is missing", &["r_mm"], cure))
            }
            _ => Ok(()),
        }
    }
}

/// The description alone, all that stands in it in order.
fn description(name: &str, text: &str) -> Result<(Video, Node), InputError> {
    let root = Node::parse_file(name, text)?;
    format_is_one(&root)?;
    form::check(&root, keys::video())?;
    let video = Video::deserialize(&root.to_json()).map_err(|error| {
        let message = format!("cannot be read: {error}");
        InputError::new(root.file(), "", "", Problem::Syntax { message }, "")
    })?;
    check(&video, &root)?;
    Ok((video, root))
}

fn check(video: &Video, root: &Node) -> Result<(), InputError> {
    let name = &video.name;
    let allowed = |c: char| c.is_ascii_alphanumeric() || "_-".contains(c);
    if name.is_empty() || !name.chars().all(allowed) {
        let cure = "Use letters, digits, - and _, e.g. name = \"my-wing\"";
        return refuse(root, "name", "must be usable as the name of a file", &[], cure);
    }
    let view = &video.view;
    let with = ["view.along"];
    match view.along {
        Along::Span => {
            if view.washout.is_none() {
                let cure = "Write washout = \"counterclockwise\" where a trailing edge that washes out turns against the clock \
                            about the leading edge in the frame, or \"clockwise\"";
                return refuse(root, "view.washout", "is missing", &with, cure);
            }
            let strangers = [
                ("view.root_angle_deg", view.root_angle_deg.is_some()),
                ("view.root_angle_sigma_deg", view.root_angle_sigma_deg.is_some()),
            ];
            let cure = "Delete it: along the span the frame shows the angle itself";
            refuse_strangers(root, strangers, cure)
        }
        Along::Stroke | Along::FlappingAxis => {
            let Some(angle_deg) = view.root_angle_deg else {
                let cure = "Give the angle of attack of the untwisted chord, e.g. root_angle_deg = 45.0";
                return refuse(root, "view.root_angle_deg", "is missing", &with, cure);
            };
            let (sin, cos) = angle_deg.to_radians().sin_cos();
            let share = if view.along == Along::Stroke { sin } else { cos };
            if share < LEAST_SHARE {
                let message = format!("shows only {:.1} % of the untwisted chord", 100.0 * share);
                let cure = "Look along the other line: see docs/from-video-to-twist.md";
                return refuse(root, "view.root_angle_deg", message, &with, cure);
            }
            let strangers = [
                ("view.washout", view.washout.is_some()),
                ("view.zero_sigma_deg", view.zero_sigma_deg.is_some()),
            ];
            let cure = "Delete it: it belongs to along = \"span\"; here the length of the chord in the frame is read";
            refuse_strangers(root, strangers, cure)
        }
    }
}

/// Refuses keys that belong to another view, if they stand.
fn refuse_strangers(root: &Node, keys: [(&str, bool); 2], cure: &str) -> Result<(), InputError> {
    match keys.into_iter().find(|(_, stands)| *stands) {
        Some((key, _)) => refuse(root, key, "does not belong to this view", &["view.along"], cure),
        None => Ok(()),
    }
}

/// The frames in the order of the file, each with its stations from base to tip.
fn frames(points: &[Point]) -> Result<Vec<VideoFrame>, InputError> {
    let mut names: Vec<&str> = Vec::new();
    for point in points {
        if !names.contains(&point.frame.as_str()) {
            names.push(&point.frame);
        }
    }
    let mut frames = Vec::new();
    for name in names {
        let of: Vec<&Point> = points.iter().filter(|point| point.frame == name).collect();
        let find = |which: Which, r_mm: Option<f64>| {
            of.iter()
                .find(|point| point.which == which && point.r_mm == r_mm)
                .copied()
        };
        let partner = |point: &Point, which: Which| match find(which, point.r_mm) {
            Some(partner) => apart(point, partner).map(|()| partner),
            None => {
                let message = format!("has no {} beside it in frame {name}", which.name());
                let cure = format!("Click {} there too, or delete this row", which.name());
                Err(point.record.conflict("mark", message, &["frame", "r_mm"], &cure))
            }
        };
        let mut frame = VideoFrame {
            name: name.to_string(),
            stations: Vec::new(),
            references: None,
        };
        for &point in &of {
            match point.which {
                Which::Leading => {
                    let trailing = partner(point, Which::Trailing)?;
                    frame.stations.push(VideoStation {
                        r_mm: point.r_mm.unwrap_or_default(),
                        chord_mm: point.chord_mm.or(trailing.chord_mm),
                        leading: point.mark(),
                        trailing: trailing.mark(),
                    });
                }
                Which::Trailing => drop(partner(point, Which::Leading)?),
                Which::ReferenceA => {
                    let b = partner(point, Which::ReferenceB)?;
                    frame.references = Some([point.mark(), b.mark()]);
                }
                Which::ReferenceB => drop(partner(point, Which::ReferenceA)?),
            }
        }
        if frame.stations.is_empty()
            && let Some(point) = of.first()
        {
            let message = format!("frame {name} has reference points but no edge of the wing");
            let cure = "Click leading and trailing at some stations, or delete the frame";
            return Err(point.record.conflict("frame", message, &[], cure));
        }
        frame.stations.sort_by(|a, b| a.r_mm.total_cmp(&b.r_mm));
        frames.push(frame);
    }
    Ok(frames)
}

/// Refuses two marks that lie on one another.
fn apart(point: &Point, partner: &Point) -> Result<(), InputError> {
    let (a, b) = (point.mark(), partner.mark());
    if (a.x_px - b.x_px).hypot(a.y_px - b.y_px) >= NEAREST_PX {
        return Ok(());
    }
    let message = format!("lies on the mark of line {}", partner.record.line);
    let cure = "Two points less than a pixel apart have no direction; check the coordinates, or leave the station out";
    Err(point.record.conflict("mark", message, &["x_px", "y_px"], cure))
}
