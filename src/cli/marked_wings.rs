//! The wings that `washout pareto` marks beside its fronts.

use std::path::PathBuf;

use crate::explore::shape_factor::Gained;
use crate::export::pareto::Marked;
use crate::lift::{TwistAlongSpan, TwistHistory};
use crate::origin::InputFile;
use crate::progress::Progress;
use crate::wing::flown::{is_profile, of_design, of_profile};
use crate::wing::lift_ratios::measured;
use crate::wing::{TwistSource, WingModel};

use super::Failure;
use super::design_arguments::DesignArguments;

/// A wing that is marked, with what was measured of it.
pub(super) struct Named {
    pub(super) name: String,
    pub(super) files: Vec<InputFile>,
    pub(super) twist: TwistAlongSpan,
    pub(super) gained: Option<Gained>,
}

/// The marked wings with their twist at mid-stroke.
pub(super) fn named(
    files: &[PathBuf],
    set: &[String],
    base: &WingModel,
    progress: &Progress,
) -> Result<Vec<Named>, Failure> {
    let mut marks = Vec::new();
    for file in files {
        let flown = if is_profile(file) {
            of_profile(file, base)?
        } else {
            let case = WingModel::new(DesignArguments::of_file(file, set, None).load(&[])?)?;
            of_design(case, TwistSource::Measured, 2, &[], progress)?
        };
        let twist = match &flown.flight.twist {
            TwistHistory::Ramp { full, .. } => full.clone(),
            TwistHistory::Solved(phases) => phases.first().map_or_else(TwistAlongSpan::flat, |p| p.1.clone()),
        };
        let effective = measured(&flown).and_then(|measured| measured.effective_lift);
        marks.push(Named {
            gained: effective.map(|[effective, sigma]| Gained {
                name: flown.name.clone(),
                twist: twist.clone(),
                effective,
                sigma,
            }),
            name: flown.name,
            files: flown.files,
            twist,
        });
    }
    Ok(marks)
}

/// A wing as it stands in the document, with its lift and efficiency over those of the wing without twist.
pub(super) fn marked(mark: &Named, lift: f64, efficiency: f64, length_m: f64) -> Marked {
    let mut profile: Vec<[f64; 2]> = mark.twist.points().to_vec();
    if profile.last().is_some_and(|[r, _]| *r < length_m) {
        profile.push([length_m, mark.twist.twist_rad(length_m)]);
    }
    Marked {
        name: mark.name.clone(),
        efficiency,
        lift: vec![lift],
        tip_deg: mark.twist.twist_rad(length_m).to_degrees(),
        profile: profile
            .into_iter()
            .map(|[r, twist]| [r * 1e3, twist.to_degrees()])
            .collect(),
    }
}
