//! What `washout measure` gives: a page, a document, and a measurement file that `compare` and studies take.

use std::fmt::Write;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::{Bound, COLUMNS, SigmaKind};
use crate::input::study::RulerKind;
use crate::input::video::{Along, LoadedVideo};
use crate::observation::{RulerHint, VideoTwist, ruler_hints, twist_from_video};
use crate::page::text::{Table, hanging, number, significant};

/// What `washout measure` prints.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MeasureReport {
    /// The measurement file as written.
    pub written: String,
    /// Standard deviation of a clicked coordinate, px.
    pub sigma_px: f64,
    /// Where it comes from.
    pub sigma_kind: SigmaKind,
    /// Degrees of freedom behind it, where they are few.
    pub few_repeats: Option<usize>,
    /// Twist at every station of every frame.
    pub readings: Vec<MeasuredTwist>,
    /// Nuisances that a study should have: what the readings share.
    pub ruler: Vec<SharedNuisance>,
}

/// Twist at a station in a frame.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MeasuredTwist {
    /// Frame; it becomes the case.
    pub frame: String,
    /// Station, mm from the wing base.
    pub r_mm: f64,
    /// Twist, deg, washout positive.
    pub twist_deg: f64,
    /// Its standard deviation from clicking, deg.
    pub sigma_deg: f64,
    /// Whether it is only a bound.
    pub bound: Bound,
    /// By how much the errors that many readings share move it, deg; not part of sigma.
    pub shared_deg: f64,
}

/// A nuisance that a study should have.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SharedNuisance {
    /// Offset or scale of twist.
    pub kind: RulerKind,
    /// The runs that share it; every run has its own where absent.
    pub runs: Option<Vec<String>>,
    /// Standard deviation: deg for an offset, a share for a scale.
    pub sigma: f64,
    /// Where it comes from.
    pub why: String,
    /// What it misses of any reading at most, deg.
    pub leaves_deg: f64,
}

/// How the first line of a measurement file ends.
const MADE: &str = " from marks in video frames, by washout measure.";

/// Whether a file holds a measurement that [`MeasureReport::csv`] made.
pub fn is_measured(bytes: &[u8]) -> bool {
    let first = bytes.split(|byte| *byte == b'\n').next().unwrap_or_default();
    first.ends_with(MADE.as_bytes())
}

impl MeasureReport {
    /// Of marks, to be written to `written`.
    pub fn new(loaded: &LoadedVideo, written: String) -> MeasureReport {
        let video = twist_from_video(loaded);
        let shared = |index: usize| {
            let moves = video.shared.iter().map(|shared| shared.moves_rad[index].powi(2));
            // a sum of nothing is -0
            (0.0 + moves.sum::<f64>()).sqrt().to_degrees()
        };
        let readings = video.readings.iter().enumerate();
        let readings = readings.map(|(index, reading)| MeasuredTwist {
            frame: reading.frame.clone(),
            r_mm: reading.r_mm,
            twist_deg: reading.twist_rad.to_degrees(),
            sigma_deg: reading.sigma_rad.to_degrees(),
            bound: reading.bound,
            shared_deg: shared(index),
        });
        MeasureReport {
            written,
            sigma_px: video.sigma_px,
            sigma_kind: video.sigma_kind,
            few_repeats: video.few_repeats,
            readings: readings.collect(),
            ruler: nuisances(&video, loaded),
        }
    }

    /// The page for people.
    pub fn page(&self, loaded: &LoadedVideo) -> String {
        let first = format!(
            "Twist from {} (positive: washout); a click errs by {} px, {}",
            loaded.marks_file,
            significant(self.sigma_px, 2),
            match self.sigma_kind {
                SigmaKind::Repeats => "as its repeats scatter",
                _ => "as stated",
            }
        );
        let mut text = hanging("", &first, 2);
        if let Some(freedom) = self.few_repeats {
            let _ = writeln!(
                text,
                "  told from {freedom} degrees of freedom only: sigma itself is uncertain by {:.0} %; click more marks twice",
                100.0 / (2.0 * freedom as f64).sqrt()
            );
        }
        let mut table = Table::new(["frame", "r_mm", "twist_deg", "sigma_deg", "shared_deg", "bound"]);
        for reading in &self.readings {
            table.row([
                reading.frame.clone(),
                number(reading.r_mm, 1),
                number(reading.twist_deg, 2),
                number(reading.sigma_deg, 2),
                number(reading.shared_deg, 2),
                bound(reading.bound).to_string(),
            ]);
        }
        text += &table.render();
        if self.ruler.is_empty() {
            text += "  sigma: of the clicks; what all stations of a frame share is small beside it\n";
        } else {
            text += "  sigma: of the clicks; shared: what moves many readings together, for a study to have as its ruler:\n\n";
            text += &self.ruler_tables();
        }
        let _ = writeln!(text, "\n{} written", self.written);
        text
    }

    /// The nuisances as tables of a study.
    fn ruler_tables(&self) -> String {
        let mut text = String::new();
        for nuisance in &self.ruler {
            let kind = match nuisance.kind {
                RulerKind::Offset => "offset",
                RulerKind::Scale => "scale",
            };
            let _ = writeln!(text, "[[ruler]]\nkind = \"{kind}\"\nchannel = \"twist\"");
            if let Some(runs) = &nuisance.runs {
                let _ = writeln!(text, "runs = [{}]", quoted(runs));
            }
            let _ = writeln!(
                text,
                "sigma = {}\nwhy = \"{}\"",
                significant(nuisance.sigma, 2),
                nuisance.why
            );
            if nuisance.leaves_deg >= 0.005 {
                let _ = writeln!(
                    text,
                    "# leaves {} deg of it at most",
                    significant(nuisance.leaves_deg, 2)
                );
            }
        }
        text
    }

    /// The measurement file.
    pub fn csv(&self, loaded: &LoadedVideo) -> String {
        let video = &loaded.video;
        let (view, instrument) = match video.view.along {
            Along::Span => (
                "along the span: the chord shows its angle".to_string(),
                "chord_rotation",
            ),
            along => {
                let (line, law) = match along {
                    Along::Stroke => ("stroke", "sin"),
                    _ => ("flapping axis", "cos"),
                };
                let root_deg = video.view.root_angle_deg.unwrap_or_default();
                (
                    format!(
                        "along the {line}: d/d0 = {law} alpha / {law} alpha_root, alpha_root = {root_deg} deg"
                    ),
                    "camera",
                )
            }
        };
        let zero = match &loaded.rest {
            Some(rest) => format!("against the frame {}", rest.name),
            None => "against the reference points".to_string(),
        };
        let kind = match self.sigma_kind {
            SigmaKind::Repeats => "repeats",
            _ => "stated",
        };
        let mut text = format!(
            "# Twist of {}{MADE}\n# source: {}\n# marks: {}\n# view: {view}; {zero}\n\
             # sigma: of the clicks ({} px, {kind}); what all readings share is not in it, see below\n",
            video.name,
            match video.source.as_str() {
                "" => "not stated".to_string(),
                stated => stated.replace(['\n', '\r'], " "),
            },
            loaded.marks_file,
            significant(self.sigma_px, 2),
        );
        for line in self.ruler_tables().lines() {
            let _ = writeln!(text, "#   {line}");
        }
        let _ = writeln!(text, "{}", COLUMNS.join(","));
        for reading in &self.readings {
            let frame = &reading.frame;
            let _ = writeln!(
                text,
                "{frame},twist,{instrument},deg,washout,{frame},{},,{:.4},{:.4},{kind},{}",
                reading.r_mm,
                reading.twist_deg,
                reading.sigma_deg.max(1e-4),
                bound(reading.bound)
            );
        }
        text
    }
}

fn nuisances(video: &VideoTwist, loaded: &LoadedVideo) -> Vec<SharedNuisance> {
    let runs: Vec<String> = loaded.frames.iter().map(|frame| frame.name.clone()).collect();
    let nuisance = |hint: RulerHint| SharedNuisance {
        kind: hint.kind,
        runs: (hint.same_in_all && runs.len() > 1).then(|| runs.clone()),
        sigma: hint.sigma,
        why: hint.why.join("; "),
        leaves_deg: hint.leaves_deg,
    };
    ruler_hints(video).into_iter().map(nuisance).collect()
}

fn quoted(names: &[String]) -> String {
    let names: Vec<String> = names.iter().map(|name| format!("\"{name}\"")).collect();
    names.join(", ")
}

fn bound(bound: Bound) -> &'static str {
    match bound {
        Bound::None => "none",
        Bound::Upper => "upper",
        Bound::Lower => "lower",
    }
}
