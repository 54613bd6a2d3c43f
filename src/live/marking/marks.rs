//! What was clicked and how the camera stood, as the page holds it.

use std::path::{Path, PathBuf};

use serde::{Deserialize, Serialize};

use super::images::frame_name;
use crate::input::video::{Along, Click, Video, View};
use crate::live::refusal::Refusal;

/// Clicks that a campaign may have.
const MOST: usize = 20_000;

/// All that somebody says on the page.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Marks {
    /// How the camera stood.
    pub video: Video,
    /// Stations that are to be clicked, mm from the wing base.
    pub stations_mm: Vec<f64>,
    /// Every click.
    pub clicks: Vec<Click>,
    /// What reads millimetres off the picture.
    pub guides: Guides,
}

/// A line and a scale that place stations; no part of the measurement, and in no file.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Guides {
    /// Two points on the line through the wing base, across the span, px; or none.
    pub axis: Vec<[f64; 2]>,
    /// Two points whose distance is known, px; or none.
    pub scale: Vec<[f64; 2]>,
    /// That distance, mm.
    pub mm: Option<f64>,
}

impl Marks {
    /// Those of a new campaign in a folder.
    pub fn new(folder: &Path) -> Marks {
        let name = std::fs::canonicalize(folder).unwrap_or_else(|_| folder.to_path_buf());
        let name = frame_name(&name).replace('.', "-");
        let name = if name.is_empty() {
            "video".to_string()
        } else {
            name
        };
        Marks {
            video: Video {
                format: 1,
                marks: format!("{name}-marks.csv"),
                name,
                source: String::new(),
                rest: None,
                sigma_px: None,
                view: View {
                    along: Along::Stroke,
                    washout: None,
                    zero_sigma_deg: None,
                    root_angle_deg: None,
                    root_angle_sigma_deg: None,
                },
                references: None,
            },
            stations_mm: Vec::new(),
            clicks: Vec::new(),
            guides: Guides::default(),
        }
    }

    /// Reads what was saved before, with the file that describes it; nothing if there is none.
    ///
    /// # Errors
    /// If there are several, or the files are not what `washout measure` reads, or name frames that are not there.
    pub fn load(folder: &Path, frames: &[String]) -> Result<Option<(PathBuf, Marks)>, Refusal> {
        let Some(path) = description(folder)? else {
            return Ok(None);
        };
        let video = Video::load(&path).map_err(Refusal::new)?;
        let file = folder.join(&video.marks);
        let clicks = match file.exists() {
            true => Click::load(&file).map_err(Refusal::new)?,
            false => Vec::new(),
        };
        if let Some(click) = clicks.iter().find(|click| !frames.contains(&click.frame)) {
            let cure = "Put the image back, or delete the rows of this frame";
            let message = format!("{}: frame {} has no image", file.display(), click.frame);
            return Err(Refusal::new(message).cured(cure));
        }
        let mut stations_mm: Vec<f64> = clicks.iter().filter_map(|click| click.r_mm).collect();
        stations_mm.sort_by(f64::total_cmp);
        stations_mm.dedup();
        let marks = Marks {
            video,
            stations_mm,
            clicks,
            guides: Guides::default(),
        };
        Ok(Some((path, marks)))
    }

    /// Refuses what no page sends.
    ///
    /// # Errors
    /// If a click is of a frame that is not there, a number is out of range, or there are too many.
    pub fn check(&self, frames: &[String]) -> Result<(), Refusal> {
        if self.clicks.len() > MOST {
            return Err(Refusal::new(format!("at most {MOST} clicks")));
        }
        if [&self.guides.axis, &self.guides.scale]
            .iter()
            .any(|ends| ends.len() > 2)
        {
            return Err(Refusal::new("a guide has two ends"));
        }
        let is_length = |r_mm: &f64| (0.0..=100_000.0).contains(r_mm);
        let mut stations = self.stations_mm.iter();
        if let Some(r_mm) = stations.find(|r_mm| !is_length(r_mm)) {
            let cure = "Give the distance from the wing base in millimetres, e.g. 35";
            return Err(Refusal::at(
                "stations",
                format!("{r_mm} is not in [0, 100000] mm"),
                cure,
            ));
        }
        for click in &self.clicks {
            let is_sound = [click.x_px, click.y_px].iter().all(|px| px.abs() <= 1e6)
                && click.r_mm.is_none() == click.mark.is_reference()
                && click.r_mm.is_none_or(|r_mm| is_length(&r_mm))
                && click
                    .chord_mm
                    .is_none_or(|chord| chord > 0.0 && chord <= 100_000.0)
                && frames.contains(&click.frame);
            if !is_sound {
                let message = format!("a click in frame {} is no mark", click.frame);
                return Err(Refusal::new(message));
            }
        }
        Ok(())
    }
}

/// The one TOML file of a folder.
fn description(folder: &Path) -> Result<Option<PathBuf>, Refusal> {
    let fault = |error| Refusal::new(format!("{}: cannot be read: {error}", folder.display()));
    let mut found = Vec::new();
    for entry in std::fs::read_dir(folder).map_err(fault)? {
        let path = entry.map_err(fault)?.path();
        if path.extension().is_some_and(|ending| ending == "toml") {
            found.push(path);
        }
    }
    found.sort();
    match found.as_slice() {
        [] => Ok(None),
        [one] => Ok(Some(one.clone())),
        [one, other, ..] => {
            let message = format!(
                "{} and {} both lie in the folder of the frames",
                one.display(),
                other.display()
            );
            let cure = "Keep one: the file that describes the video";
            Err(Refusal::new(message).cured(cure))
        }
    }
}
