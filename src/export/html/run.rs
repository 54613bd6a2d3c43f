//! The report of a run: the wing in 3D, what it says, every input, every number.

use std::path::Path;

use crate::export::ExportError;
use crate::export::pictures::profile::StripRow;
use crate::export::report::page as answer;
use crate::export::summary::RunSummary;
use crate::export::vtu_read::read_vtu;

use super::document::Document;
use super::inputs::{all_numbers, inputs};
use super::page::Page;
use super::wing::Wing;
use super::wings::section;

const STRIPS: &str = "strips.csv";

/// What the model is not, for who reads the report alone.
const LIMITS: &str = "<p>Quasi-steady air on blade elements, the wing at one instant without its motion, film as the design has it. \
    How far that holds against published cases is said in “How far to trust washout”. What a finer mesh would change, \
    <code>--refine 2</code> says.</p>\n";

/// The report of a run out of the files of its folder; `read` gives one by its name, and `folder` names them in errors.
///
/// # Errors
/// If a file cannot be read or is not of a run, or a number is not finite.
pub fn of_files(
    summary: &RunSummary,
    folder: &Path,
    read: &dyn Fn(&str) -> Result<Vec<u8>, ExportError>,
) -> Result<Page, ExportError> {
    let (wing, strips) = drawn(summary, folder, read)?;
    page(summary, wing, &strips)
}

/// What of a run is drawn: the wing, and the air along its span where that was written; `read` gives a file by its name.
///
/// # Errors
/// If a file cannot be read or is not of a run.
pub fn drawn(
    summary: &RunSummary,
    folder: &Path,
    read: &dyn Fn(&str) -> Result<Vec<u8>, ExportError>,
) -> Result<(Wing, Vec<StripRow>), ExportError> {
    let [rest, loaded] = ["wing-rest.vtu", "wing.vtu"].map(|name| read_vtu(&read(name)?, &folder.join(name)));
    let wing = Wing::of_grids(&summary.name, &rest?, &loaded?);
    let has_strips = summary.files.iter().any(|file| file == STRIPS);
    let strips = has_strips.then(|| read(STRIPS)).transpose()?;
    Ok((wing, strips_of(strips.as_deref().unwrap_or_default(), folder)?))
}

/// The report of a run.
///
/// # Errors
/// If a number is not finite.
pub fn page(summary: &RunSummary, wing: Wing, strips: &[StripRow]) -> Result<Page, ExportError> {
    let answer = answer(summary, strips);
    let document = Document::new(answer.kind, summary)?;
    let [every_input, data] = [inputs(&document, "/design"), all_numbers(&document)];
    let mut page = Page {
        title: summary.name.clone(),
        ..Page::default()
    };
    page.section("wing", "The wing", section(&[wing])?);
    page.add(&answer, document)?;
    page.section("limits", "What the model is not", LIMITS.to_string());
    page.section("inputs", "Inputs", every_input);
    page.section("data", "Data", data);
    Ok(page)
}

fn strips_of(bytes: &[u8], folder: &Path) -> Result<Vec<StripRow>, ExportError> {
    let rows: Result<Vec<StripRow>, csv::Error> = csv::Reader::from_reader(bytes).deserialize().collect();
    rows.map_err(|error| ExportError::ForeignSummary {
        path: folder.join(STRIPS),
        reason: error.to_string(),
    })
}
