//! The report of a design compared with its measurement.

use crate::compare::DesignComparison;
use crate::coupling::Engineering;
use crate::export::ExportError;
use crate::export::collect::{Solved, summarize};
use crate::export::compare_report::CompareReport;
use crate::export::pictures::profile::StripRow;
use crate::wing::{DiscretizationError, SolvedWing};

use super::document::Document;
use super::page::Page;
use super::run;
use super::wing::Wing;

/// The report with the run behind the comparison: the wing in 3D, its pictures and tables.
///
/// # Errors
/// If a number in a picture is not finite.
pub fn page(
    found: &DesignComparison,
    report: &CompareReport,
    engineering: &Engineering,
) -> Result<Page, ExportError> {
    let mut page = run_page(found, engineering)?;
    let ratios = report.page_of_ratios();
    page.add(&ratios, Document::new(ratios.kind, report)?)?;
    Ok(page)
}

/// The report of the run behind a comparison.
fn run_page(found: &DesignComparison, engineering: &Engineering) -> Result<Page, ExportError> {
    let SolvedWing { model, solution } = &found.wing;
    let summary = summarize(&Solved {
        wing: &found.wing,
        reading: &found.reading,
        mesh_error: &DiscretizationError::default(),
        other_equilibrium: None,
        uncertainty: None,
        engineering,
    });
    let strips: Vec<StripRow> = solution.strips.iter().map(StripRow::of).collect();
    let wing = Wing::of_solution(&model.design().name, model.design(), &model.planform, solution);
    run::page(&summary, wing, &strips)
}

/// The report of a comparison whose run is not at hand.
pub fn page_alone(report: &CompareReport) -> Result<Page, ExportError> {
    let answer = report.page();
    let mut page = Page {
        title: answer.title.clone(),
        ..Page::default()
    };
    page.add(&answer, Document::new(answer.kind, report)?)?;
    Ok(page)
}
