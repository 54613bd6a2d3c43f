//! The pictures of a comparison, a diagnosis or a ladder, each with its numbers as CSV, into a folder.

use crate::compare::{Comparison, StudyComparison};
use crate::diagnose::Diagnosis;
use crate::explain::Explanation;
use crate::export::ExportError;
use crate::export::run::RunFolder;
use crate::observation::TwistProfile;
use crate::plot::{Figure, Panel};

use super::ladder::Fall;
use super::panels::{Compared, distinct};
use super::{compared, diagnosis, explained, in_sigma, ladder, residuals, tables, wing};

/// Charts of one picture; more go into another.
const PANELS: usize = 12;

/// Adds `compared.svg`, `residuals.svg`, `residuals-in-sigma.svg` and the numbers behind them.
///
/// # Errors
/// If a file cannot be written, or a number is not finite.
pub fn add_study(folder: &mut RunFolder, comparison: &StudyComparison) -> Result<(), ExportError> {
    let found = Compared::of_study(comparison);
    add_compared(
        folder,
        &found,
        &compared::figure(&found),
        &residuals::figure(&found),
    )
}

/// The same for a single wing; `profile` is its whole modelled profile.
///
/// # Errors
/// As [`add_study`].
pub fn add_wing(
    folder: &mut RunFolder,
    comparison: &Comparison,
    profile: &TwistProfile,
) -> Result<(), ExportError> {
    let found = Compared::of_wing(comparison);
    add_compared(
        folder,
        &found,
        &wing::figure(comparison, Some(profile)),
        &wing::residuals(comparison),
    )?;
    if !comparison.span.is_empty() {
        folder.add("span.csv", &tables::span(comparison)?)?;
    }
    Ok(())
}

fn add_compared(
    folder: &mut RunFolder,
    found: &Compared,
    figure: &Figure,
    errors: &Figure,
) -> Result<(), ExportError> {
    if found.rows.is_empty() {
        return Ok(());
    }
    add_picture(folder, "compared", figure)?;
    folder.add("compared.csv", &tables::compared(found)?)?;
    add_picture(folder, "residuals", errors)?;
    add_picture(folder, "residuals-in-sigma", &in_sigma::figure(found))?;
    folder.add("residuals.csv", &tables::residuals(found)?)
}

/// Adds the pictures of a diagnosis: `added-variables.svg`, `residuals-in-sigma.svg`, `misfit-by-station.svg` where there
/// are several stations, `ladder.svg`, and `missing-field.svg` where the verdict is that none of the known effects is what
/// is missing.
///
/// # Errors
/// As [`add_study`].
pub fn add_diagnosis(folder: &mut RunFolder, study: &str, found: &Diagnosis) -> Result<(), ExportError> {
    if !found.added_variables.is_empty() {
        let figure = diagnosis::added_variables(study, &found.added_variables);
        add_picture(folder, "added-variables", &figure)?;
        folder.add(
            "added-variables.csv",
            &tables::added_variables(&found.added_variables)?,
        )?;
    }
    if let Some(plot) = found.added_variables.first() {
        add_picture(
            folder,
            "residuals-in-sigma",
            &in_sigma::of_diagnosis(study, &plot.points),
        )?;
    }
    // At a single station there is nothing to see along the span.
    let stations = distinct(
        found
            .misfit
            .by_station
            .iter()
            .map(|station| station.r_over_length),
    );
    if stations.len() > 1 {
        let figure = diagnosis::by_station(study, &found.misfit.by_station);
        add_picture(folder, "misfit-by-station", &figure)?;
        folder.add("misfit-by-station.csv", &tables::by_station(found)?)?;
    }
    if let Some(missing) = diagnosis::missing(found) {
        add_picture(folder, "missing-field", &diagnosis::field(study, missing))?;
        folder.add("missing-field.csv", &tables::field(missing)?)?;
    }
    add_falls(folder, study, &Fall::of_diagnosis(&found.ladder))
}

/// Adds `explained.svg`: the first sets beside the data, where twist is foretold.
///
/// # Errors
/// As [`add_study`].
pub fn add_explained(folder: &mut RunFolder, study: &str, found: &Explanation) -> Result<(), ExportError> {
    match explained::figure(study, found) {
        Some(figure) => add_picture(folder, "explained", &figure),
        None => Ok(()),
    }
}

/// Adds `ladder.svg`: the error falling step by step.
///
/// # Errors
/// As [`add_study`].
pub fn add_falls(folder: &mut RunFolder, study: &str, falls: &[Fall]) -> Result<(), ExportError> {
    if falls.is_empty() {
        return Ok(());
    }
    add_picture(
        folder,
        "ladder",
        &ladder::figure(&format!("{study} – the error, step by step"), falls),
    )?;
    folder.add("ladder.csv", &tables::falls(falls)?)
}

/// Adds a picture: `NAME.svg`, and `NAME-2.svg` and so on where it has too many panels for one.
fn add_picture(folder: &mut RunFolder, name: &str, figure: &Figure) -> Result<(), ExportError> {
    for (index, page) in sheets(figure).into_iter().enumerate() {
        let name = match index {
            0 => format!("{name}.svg"),
            _ => format!("{name}-{}.svg", index + 1),
        };
        folder.add(&name, page.to_svg()?.as_bytes())?;
    }
    Ok(())
}

/// A picture in as many sheets as its panels need.
pub fn sheets(figure: &Figure) -> Vec<Figure> {
    let sheet = |panels: &[Panel]| Figure {
        panels: panels.to_vec(),
        ..figure.clone()
    };
    figure.panels.chunks(PANELS).map(sheet).collect()
}
