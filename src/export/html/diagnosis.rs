//! The report of a diagnosis.

use crate::export::ExportError;
use crate::export::diagnosis::{self, DiagnosisReport};
use crate::page::{Part, Section};

use super::document::Document;
use super::effects::{EffectsAtWork, effects};
use super::page::Page;
use super::wings::Wings;

/// The report of a diagnosis by itself; `study` is its name, `wings` are those to be shown, `at_work` its effects.
///
/// # Errors
/// If a number in a picture is not finite.
pub fn page(
    study: &str,
    report: &DiagnosisReport,
    wings: &Wings,
    at_work: &EffectsAtWork,
) -> Result<Page, ExportError> {
    let mut page = Page {
        title: study.to_string(),
        ..Page::default()
    };
    page.section("wing", "The wings", wings.section()?);
    add(&mut page, study, report, at_work)?;
    Ok(page)
}

/// Adds what a diagnosis says, its effects at work, and its document.
///
/// # Errors
/// If a number in a picture is not finite.
pub fn add(
    page: &mut Page,
    study: &str,
    report: &DiagnosisReport,
    at_work: &EffectsAtWork,
) -> Result<(), ExportError> {
    page.section("at-work", "What each effect is", effects(at_work));
    let mut answer = diagnosis::page(study, &report.diagnosis);
    if !report.commands.is_empty() {
        let commands = Part::Code(report.commands.join("\n"));
        let section = Section {
            id: "commands",
            title: "To go on with",
            parts: vec![commands],
        };
        answer.sections.insert(0, section);
    }
    page.add(&answer, Document::new(answer.kind, report)?)
}
