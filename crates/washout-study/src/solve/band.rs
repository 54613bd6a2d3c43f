//! The band of a twist profile that the ranges of the assumed inputs make.

use crate::compare::Reading;
use crate::input::Design;
use crate::observation::TwistProfile;
use crate::progress::Progress;
use crate::study::{ProfileOutputs, Uncertainty, UncertaintySettings, propagate};
use crate::wing::{SolvedWing, WingError};

use super::error::SolveError;

/// Propagates the ranges of the assumed inputs to a band of the profile.
pub(super) fn band(
    (wing, coarser): (&SolvedWing, Option<&SolvedWing>),
    reading: &Reading,
    samples: usize,
    progress: &Progress,
) -> Result<Uncertainty, SolveError> {
    let outputs = ProfileOutputs::new(&reading.profile, &stretches_mm(reading));
    let unseen = progress.unseen();
    let evaluate = |design: &Design| -> Result<Vec<f64>, String> {
        outputs.read(&profile_of(wing, design, &unseen).map_err(|error| error.to_string())?)
    };
    let settings = UncertaintySettings {
        samples,
        ..UncertaintySettings::default()
    };
    let design = wing.model.design();
    let found = propagate(design, &outputs.outputs, settings, progress, evaluate);
    let mut found = found.map_err(SolveError::Band)?;
    // a station that the coarser mesh does not read says nothing of the finer one
    let on_coarser = coarser.and_then(|coarser| outputs.read(&coarser.profile().ok()?).ok());
    for (output, other) in found.outputs.iter_mut().zip(on_coarser.into_iter().flatten()) {
        output.mesh_error = Some((output.nominal - other).abs());
    }
    Ok(found)
}

/// Stretches of the measured rates; those of the fitted stages where none was measured.
fn stretches_mm(reading: &Reading) -> Vec<[f64; 2]> {
    let measured = reading.measured.iter().flat_map(|comparison| &comparison.rows);
    let measured: Vec<[f64; 2]> = measured
        .filter_map(|row| Some([row.r_mm?, row.r_to_mm?]))
        .collect();
    if !measured.is_empty() {
        return measured;
    }
    let fitted = reading.stages.iter().flat_map(|fit| &fit.stages);
    fitted.map(|stage| [stage.from_mm, stage.to_mm]).collect()
}

/// The profile of another design, solved from a wing nearby.
fn profile_of(near: &SolvedWing, design: &Design, progress: &Progress) -> Result<TwistProfile, WingError> {
    let wing = near.model.with_design(design.clone())?;
    wing.solve_from(&near.solution, progress)?.profile()
}
