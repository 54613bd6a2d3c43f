//! The report of a study: the wings, model against measurement, what was calibrated, what its designs assume, every number.

use crate::compare::StudyComparison;
use crate::export::ExportError;
use crate::export::diagnosis::DiagnosisReport;
use crate::export::study::{StudyReport, page as answer};
use crate::input::Assumption;

use super::diagnosis;
use super::document::Document;
use super::effects::EffectsAtWork;
use super::inputs::{all_numbers, assumptions};
use super::page::Page;
use super::wings::Wings;

/// What a report of a study shows besides its comparison.
#[derive(Debug, Clone, Default)]
pub struct StudyParts {
    /// Its wings, case by case.
    pub wings: Wings,
    /// What its designs assume, design by design.
    pub assumed: Vec<(String, Vec<Assumption>)>,
    /// Its diagnosis, if one was made, and the effects of that at work.
    pub diagnosis: Option<(DiagnosisReport, EffectsAtWork)>,
}

/// The report of a study.
///
/// # Errors
/// If a number in a picture is not finite.
pub fn page(report: &StudyReport, parts: &StudyParts) -> Result<Page, ExportError> {
    let comparison = &report.comparison;
    let answer = answer(comparison);
    let document = Document::new(answer.kind, report)?;
    let data = all_numbers_if_few(&document, comparison);
    let mut page = Page {
        title: comparison.study.clone(),
        ..Page::default()
    };
    page.section("wing", "The wings", parts.wings.section()?);
    page.add(&answer, document)?;
    if let Some((found, at_work)) = &parts.diagnosis {
        diagnosis::add(&mut page, &comparison.study, found, at_work)?;
    }
    page.section("inputs", "Assumed inputs", assumptions(&parts.assumed));
    page.section("data", "Data", data);
    Ok(page)
}

/// Beyond so many measured numbers the list of everything would be longer than the rest; the document stands in the page anyway.
const MANY: usize = 200;

fn all_numbers_if_few(document: &Document, comparison: &StudyComparison) -> String {
    if comparison.rows.len() <= MANY {
        return all_numbers(document);
    }
    "<p>All numbers stand in the page as JSON, in the element <code>comparison</code>.</p>\n".to_string()
}
