//! Twist from marks on both edges in video frames: the inverse of what the model's instruments do with a solved wing.
//!
//! **Along the span** the frame shows the chord at its angle: θ is how far the line between the edges has turned since the
//! wing was untwisted, whatever the scale. **Along the stroke or the flapping axis** it shows the chord times sin α or cos α,
//! so that a length becomes an angle only under an assumption: the chord keeps its own length and direction along the span.
//! With that, d/d₀ = sin α / sin α_root or cos α / cos α_root ([`super::camera`]), and twist is α_root − α.
//!
//! Errors to first order, both edges clicked with σ in x and in y, independently. A direction errs by √2 σ/c (c: the chord
//! in px), a length by √2 σ, hence θ by √2 σ/(c cos α) along the stroke, √2 σ/(c sin α) along the flapping axis; near a fold,
//! where the first order fails, by √(2 σ_share), which is where the second order stops it. What all stations of a frame share
//! (reference points, their distance, α_root, the camera's roll) is no scatter: it is kept apart, as a nuisance of the ruler.

use nalgebra::Vector2;

use super::camera::Camera;
use crate::input::design::CameraAxis;
use crate::input::measurement::{Bound, SigmaKind};
use crate::input::video::{Along, LoadedVideo, Mark, VideoFrame, VideoStation};

/// Degrees of freedom below which a scatter told from repeats is itself uncertain by a third or more.
const FEW: usize = 6;

/// What a video says.
#[derive(Debug, Clone, PartialEq)]
pub struct VideoTwist {
    /// Standard deviation of a click, px.
    pub sigma_px: f64,
    /// Whether it was told from repeats or stated.
    pub sigma_kind: SigmaKind,
    /// Degrees of freedom behind it, if it was told from repeats and they are few.
    pub few_repeats: Option<usize>,
    /// One reading for every station of every frame.
    pub readings: Vec<VideoReading>,
    /// What moves many readings together.
    pub shared: Vec<SharedError>,
}

/// Twist at a station in a frame.
#[derive(Debug, Clone, PartialEq)]
pub struct VideoReading {
    /// Frame.
    pub frame: String,
    /// Station, mm from the wing base, as the marks have it.
    pub r_mm: f64,
    /// Twist, rad, washout positive.
    pub twist_rad: f64,
    /// Its standard deviation from clicking, rad, the untwisted frame's own included.
    pub sigma_rad: f64,
    /// Whether it is only a bound: feathered, or at a fold of the projection.
    pub bound: Bound,
}

/// An error that moves many readings together.
#[derive(Debug, Clone, PartialEq)]
pub struct SharedError {
    /// Where it comes from.
    pub why: String,
    /// Whether all frames have the same; otherwise each has its own.
    pub same_in_all: bool,
    /// By how much one standard deviation of it moves each reading, rad.
    pub moves_rad: Vec<f64>,
}

/// Turns marks into twist.
pub fn twist_from_video(loaded: &LoadedVideo) -> VideoTwist {
    let (sigma_px, sigma_kind, few_repeats) = click_error(loaded);
    let reader = Reader { loaded, sigma_px };
    let mut twist = VideoTwist {
        sigma_px,
        sigma_kind,
        few_repeats,
        readings: Vec::new(),
        shared: Vec::new(),
    };
    let mut shared: Vec<Vec<(Shared, f64)>> = Vec::new();
    for frame in &loaded.frames {
        for station in &frame.stations {
            let (reading, errors) = match loaded.video.view.along {
                Along::Span => reader.direction(frame, station),
                Along::Stroke => reader.length(frame, station, CameraAxis::Stroke),
                Along::FlappingAxis => reader.length(frame, station, CameraAxis::FlappingAxis),
            };
            twist.readings.push(reading);
            shared.push(errors);
        }
    }
    for kind in Shared::ALL {
        let moves = |errors: &Vec<(Shared, f64)>| {
            let of = errors.iter().filter(|(known, _)| *known == kind);
            of.map(|(_, rad)| rad).sum()
        };
        let moves_rad: Vec<f64> = shared.iter().map(moves).collect();
        if moves_rad.iter().any(|rad| *rad != 0.0) {
            twist.shared.push(SharedError {
                why: kind.words().to_string(),
                same_in_all: kind != Shared::References && kind != Shared::Zero,
                moves_rad,
            });
        }
    }
    twist
}

/// Errors that stations share.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Shared {
    References,
    ReferencesAtRest,
    Distance,
    RootAngle,
    Zero,
}

impl Shared {
    const ALL: [Shared; 5] = [
        Shared::References,
        Shared::ReferencesAtRest,
        Shared::Distance,
        Shared::RootAngle,
        Shared::Zero,
    ];

    fn words(self) -> &'static str {
        match self {
            Shared::References => "clicks on the reference points of the frame",
            Shared::ReferencesAtRest => "clicks on the reference points of the untwisted frame",
            Shared::Distance => "distance between the reference points",
            Shared::RootAngle => "root angle and the camera's direction",
            Shared::Zero => "zero of the angle",
        }
    }
}

struct Reader<'a> {
    loaded: &'a LoadedVideo,
    sigma_px: f64,
}

/// Length of the chord in a frame over that of the untwisted chord.
struct Foreshortening {
    ratio: f64,
    /// Variance of its clicks, as a share of it.
    variance: f64,
    /// Errors that stations share, as a share of it.
    shares: Vec<(Shared, f64)>,
}

/// From one mark to another, px, y up.
fn between(from: &Mark, to: &Mark) -> Vector2<f64> {
    Vector2::new(to.x_px - from.x_px, from.y_px - to.y_px)
}

/// Angle from one direction to another, in (−π, π].
fn turn(from: &Vector2<f64>, to: &Vector2<f64>) -> f64 {
    from.perp(to).atan2(from.dot(to))
}

impl Reader<'_> {
    /// Error of a direction (rad) or, as a share, of a length between two marks.
    fn error(&self, from: &Mark, to: &Mark) -> f64 {
        let variance = 1.0 / from.clicks as f64 + 1.0 / to.clicks as f64;
        self.sigma_px * variance.sqrt() / between(from, to).norm()
    }

    /// The same station on the untwisted wing.
    fn at_rest(&self, station: &VideoStation) -> Option<&VideoStation> {
        let rest = self.loaded.rest.as_ref()?;
        rest.stations.iter().find(|other| other.r_mm == station.r_mm)
    }

    /// Reference points of the frame and, where there is one, of the untwisted frame.
    fn references<'f>(&'f self, frame: &'f VideoFrame) -> Option<(&'f [Mark; 2], Option<&'f [Mark; 2]>)> {
        let own = frame.references.as_ref()?;
        let rest = self.loaded.rest.as_ref();
        Some((own, rest.and_then(|rest| rest.references.as_ref())))
    }

    /// Along the span: the turn of the chord.
    fn direction(&self, frame: &VideoFrame, station: &VideoStation) -> (VideoReading, Vec<(Shared, f64)>) {
        let view = &self.loaded.video.view;
        let sign = match view.washout {
            Some(crate::input::video::Turn::Clockwise) => -1.0,
            _ => 1.0,
        };
        let chord = between(&station.leading, &station.trailing);
        let mut variance = self.error(&station.leading, &station.trailing).powi(2);
        let mut errors = Vec::new();
        if let Some(zero_deg) = view.zero_sigma_deg {
            errors.push((Shared::Zero, zero_deg.to_radians()));
        }
        let mut angle = 0.0;
        if let Some(rest) = self.at_rest(station) {
            variance += self.error(&rest.leading, &rest.trailing).powi(2);
            angle += turn(&between(&rest.leading, &rest.trailing), &chord);
        }
        if let Some(([a, b], rest)) = self.references(frame) {
            errors.push((Shared::References, self.error(a, b)));
            let line = between(a, b);
            angle = match rest {
                Some([a, b]) => {
                    errors.push((Shared::ReferencesAtRest, self.error(a, b)));
                    let rolled = turn(&between(a, b), &line);
                    wrapped(angle - rolled)
                }
                None => turn(&line, &chord),
            };
        }
        let reading = VideoReading {
            frame: frame.name.clone(),
            r_mm: station.r_mm,
            twist_rad: sign * angle,
            sigma_rad: variance.sqrt(),
            bound: Bound::None,
        };
        (reading, errors)
    }

    /// Across the span: the length of the chord in the frame.
    fn length(
        &self,
        frame: &VideoFrame,
        station: &VideoStation,
        axis: CameraAxis,
    ) -> (VideoReading, Vec<(Shared, f64)>) {
        let loaded = self.loaded;
        let root_angle_rad = loaded.video.view.root_angle_deg.unwrap_or_default().to_radians();
        let camera = Camera {
            axis,
            root_angle_rad,
            distance_error_m: 0.0,
        };
        let Foreshortening {
            ratio,
            variance,
            shares,
        } = self.foreshortening(frame, station, &camera);
        let found = camera.invert(ratio, 1.0);
        let alpha = root_angle_rad - found.twist_rad;
        let slope = match axis {
            CameraAxis::Stroke => alpha.cos().abs(),
            CameraAxis::FlappingAxis => alpha.sin().abs(),
        };
        let share = (ratio * camera.seen_share()).abs();
        let sigma_share = share * variance.sqrt();
        let sigma_rad = sigma_share / slope.max((0.5 * sigma_share).sqrt());
        let folds = slope.asin() < 2.0 * sigma_rad;
        let bound = match (found.bound, axis) {
            (Bound::None, CameraAxis::FlappingAxis) if folds => Bound::Lower,
            (Bound::None, CameraAxis::Stroke) if folds => Bound::Upper,
            (bound, _) => bound,
        };
        // dθ = −(dα/dshare) share d(ratio)/ratio; dα/dshare is 1/cos α, or −1/sin α
        let per_share = match axis {
            CameraAxis::Stroke => -1.0,
            CameraAxis::FlappingAxis => 1.0,
        } * ratio
            * camera.seen_share()
            / slope.max((0.5 * sigma_share).sqrt());
        let mut errors: Vec<(Shared, f64)> = shares
            .into_iter()
            .map(|(kind, share)| (kind, share * per_share))
            .collect();
        if let Some(sigma_deg) = loaded.video.view.root_angle_sigma_deg {
            let rate = self.rate_with_root_angle(&camera, ratio);
            errors.push((Shared::RootAngle, rate * sigma_deg.to_radians()));
        }
        let reading = VideoReading {
            frame: frame.name.clone(),
            r_mm: station.r_mm,
            twist_rad: found.twist_rad,
            sigma_rad,
            bound,
        };
        (reading, errors)
    }

    /// How much of the untwisted chord a frame shows.
    fn foreshortening(&self, frame: &VideoFrame, station: &VideoStation, camera: &Camera) -> Foreshortening {
        let chord = between(&station.leading, &station.trailing);
        let mut variance = self.error(&station.leading, &station.trailing).powi(2);
        let mut shares = Vec::new();
        let references = &self.loaded.video.references;
        let ratio = match self.at_rest(station) {
            Some(rest) => {
                let untwisted = between(&rest.leading, &rest.trailing);
                variance += self.error(&rest.leading, &rest.trailing).powi(2);
                let mut ratio = (chord.norm() / untwisted.norm()).copysign(chord.dot(&untwisted));
                if let Some(([a, b], Some([c, d]))) = self.references(frame) {
                    shares.push((Shared::References, self.error(a, b)));
                    shares.push((Shared::ReferencesAtRest, self.error(c, d)));
                    ratio *= between(c, d).norm() / between(a, b).norm();
                }
                ratio
            }
            None => match (self.references(frame), references, station.chord_mm) {
                (Some(([a, b], _)), Some(references), Some(chord_mm)) => {
                    let distance_mm = references.distance_mm.unwrap_or_default();
                    let sigma_mm = references.sigma_mm.unwrap_or_default();
                    shares.push((Shared::References, self.error(a, b)));
                    shares.push((Shared::Distance, sigma_mm / distance_mm));
                    let shown_mm = chord.norm() * distance_mm / between(a, b).norm();
                    shown_mm / (chord_mm * camera.seen_share())
                }
                // LoadedVideo::load refuses this
                _ => 1.0,
            },
        };
        Foreshortening {
            ratio,
            variance,
            shares,
        }
    }

    /// Change of the twist that a ratio tells per change of the root angle.
    fn rate_with_root_angle(&self, camera: &Camera, ratio: f64) -> f64 {
        let turned = |step: f64| {
            let turned = Camera {
                root_angle_rad: camera.root_angle_rad + step,
                ..*camera
            };
            // without a frame at rest the measured share stays, not the ratio to a share that moves
            let ratio = if self.loaded.rest.is_some() {
                ratio
            } else {
                ratio * (root_share(camera.axis, camera.root_angle_rad) / turned.seen_share())
            };
            turned.invert(ratio, 1.0).twist_rad
        };
        let step = 1e-6;
        (turned(step) - turned(-step)) / (2.0 * step)
    }
}

fn root_share(axis: CameraAxis, root_angle_rad: f64) -> f64 {
    match axis {
        CameraAxis::Stroke => root_angle_rad.sin(),
        CameraAxis::FlappingAxis => root_angle_rad.cos(),
    }
}

fn wrapped(angle: f64) -> f64 {
    let (sin, cos) = angle.sin_cos();
    sin.atan2(cos)
}

/// Standard deviation of a click: pooled over all marks that were clicked more than once, or as stated.
fn click_error(loaded: &LoadedVideo) -> (f64, SigmaKind, Option<usize>) {
    let frames = loaded.frames.iter().chain(&loaded.rest);
    let (mut scatter, mut freedom) = (0.0, 0);
    let mut count = |mark: &Mark| {
        scatter += mark.scatter_px2;
        freedom += 2 * (mark.clicks - 1);
    };
    for frame in frames {
        frame.references.iter().flatten().for_each(&mut count);
        for station in &frame.stations {
            count(&station.leading);
            count(&station.trailing);
        }
    }
    match loaded.video.sigma_px {
        Some(stated) if freedom == 0 || scatter == 0.0 => (stated, SigmaKind::Stated, None),
        _ => {
            let few = (freedom < FEW).then_some(freedom);
            let sigma_px = (scatter / freedom.max(1) as f64).sqrt();
            (sigma_px, SigmaKind::Repeats, few)
        }
    }
}
