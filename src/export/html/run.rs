//! The report of a run: the wing in 3D, what it says, every input, every number.

use std::path::Path;

use crate::export::ExportError;
use crate::export::pictures::profile::StripRow;
use crate::export::report::page as answer;
use crate::export::run::SUMMARY;
use crate::export::summary::RunSummary;
use crate::export::vtu_read::read_vtu;
use crate::export::warnings::of_stroke;
use crate::wing::stroke::StrokeKind;

use super::document::Document;
use super::inputs::{all_numbers, inputs};
use super::measured::Measured;
use super::page::Page;
use super::stroke::Stroke;
use super::table::paragraph;
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
    let (mut wing, strips) = drawn(summary, folder, read)?;
    wing.stroke = stroke(summary, &wing, folder, read)?;
    page(summary, wing, &strips)
}

/// The motion over the stroke, where that was solved.
fn stroke(
    summary: &RunSummary,
    wing: &Wing,
    folder: &Path,
    read: &dyn Fn(&str) -> Result<Vec<u8>, ExportError>,
) -> Result<Option<Stroke>, ExportError> {
    let Some(stroke) = summary
        .stroke
        .as_ref()
        .filter(|own| own.kind == StrokeKind::Periodic)
    else {
        return Ok(None);
    };
    let (rows, points) = (&stroke.phases, wing.rest_mm.len());
    let mut shapes = Vec::new();
    for row in Stroke::shown(rows, points) {
        let file = &rows[row].file;
        // what a document says must not lead out of its folder
        if Path::new(file).file_name() != Some(file.as_ref()) {
            return Err(ExportError::ForeignSummary {
                path: folder.join(SUMMARY),
                reason: format!("the shape of a phase is no file of the run: {file}"),
            });
        }
        shapes.push((row, read_vtu(&read(file)?, &folder.join(file))?));
    }
    Ok(Stroke::new(
        rows,
        &shapes,
        &wing.rest_mm,
        summary.wing.root_offset_mm,
    ))
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
    let wing = Wing::of_grids(&summary.name, &rest?, &loaded?, &summary.legend.section);
    let has_strips = summary.files.iter().any(|file| file == STRIPS);
    let strips = has_strips.then(|| read(STRIPS)).transpose()?;
    Ok((wing, strips_of(strips.as_deref().unwrap_or_default(), folder)?))
}

/// The report of a run.
///
/// # Errors
/// If a number is not finite.
pub fn page(summary: &RunSummary, mut wing: Wing, strips: &[StripRow]) -> Result<Page, ExportError> {
    let measured = summary.measured.iter();
    wing.measured = measured.flat_map(|own| Measured::of_spans(&own.span)).collect();
    let answer = answer(summary, strips);
    let document = Document::new(answer.kind, summary)?;
    let [every_input, data] = [inputs(&document, "/design"), all_numbers(&document)];
    let mut page = Page {
        title: summary.name.clone(),
        ..Page::default()
    };
    let mut shown = section(&[wing])?;
    // a motion that is seen must not be seen without what limits it
    for words in summary.stroke.iter().flat_map(of_stroke) {
        shown.push_str(&paragraph(&format!("Note: {words}.")));
    }
    page.section("wing", "The wing", shown);
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
