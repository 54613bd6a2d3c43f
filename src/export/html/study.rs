//! The report of a study: what it says in words, the wings, model against measurement, what was calibrated, every number.

use crate::compare::StudyComparison;
use crate::export::ExportError;
use crate::export::comparison::sign;
use crate::export::diagnosis::DiagnosisReport;
use crate::export::pictures::panels::Compared;
use crate::export::pictures::{compared, in_sigma, residuals};
use crate::export::study::StudyReport;
use crate::input::Assumption;

use super::diagnosis;
use super::document::{Digits, Document, Shown};
use super::inputs::{all_numbers, assumptions};
use super::page::{Page, headline};
use super::picture::picture;
use super::table::{HtmlTable, list};
use super::wings::Wings;

/// What a report of a study shows besides its comparison.
#[derive(Debug, Clone, Default)]
pub struct StudyParts {
    /// Its wings, case by case.
    pub wings: Wings,
    /// What its designs assume, design by design.
    pub assumed: Vec<(String, Vec<Assumption>)>,
    /// Its diagnosis, if one was made.
    pub diagnosis: Option<DiagnosisReport>,
}

/// The report of a study.
///
/// # Errors
/// If a number in a picture is not finite.
pub fn page(report: &StudyReport, parts: &StudyParts) -> Result<Page, ExportError> {
    let comparison = &report.comparison;
    let document = Document::new("comparison", report)?;
    let mut page = Page {
        title: comparison.study.clone(),
        lead: lead(&document, comparison),
        ..Page::default()
    };
    page.section("wing", "The wings", parts.wings.section()?);
    let found = Compared::of_study(comparison);
    let has_rows = !found.rows.is_empty();
    let mut html = format!("{}{}", list(&comparison.words), groups(&document, comparison));
    if has_rows {
        html.push_str(&picture(&compared::figure(&found))?);
    }
    page.section("compared", "Model against measurement", html);
    if has_rows {
        let html = picture(&in_sigma::figure(&found))? + &picture(&residuals::figure(&found))?;
        page.section("residuals", "Where it misses", html);
    }
    if let Some(found) = &parts.diagnosis {
        diagnosis::add(&mut page, &comparison.study, found)?;
    }
    page.section(
        "calibrated",
        "What was calibrated",
        unknowns(&document, comparison),
    );
    page.section("inputs", "Assumed inputs", assumptions(&parts.assumed));
    page.section("rows", "Every measured number", rows(&document, comparison));
    page.section("data", "Data", all_numbers_if_few(&document, comparison));
    page.documents.push(document);
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

fn lead(document: &Document, comparison: &StudyComparison) -> String {
    let number = |place: &str| document.number(place, Digits::Significant(3));
    let count = |place: &str| Shown {
        html: document.count(place).to_string(),
        is_number: true,
    };
    format!(
        "<p class=\"quiet\">{}</p>\n{}",
        crate::plot::pen::escaped(&comparison.title),
        headline(&[
            ("Cases", count("/cases"), ""),
            ("Measured numbers", count("/rows"), ""),
            (
                "χ² per fitted number, as stated",
                number("/chi_square_per_row/0"),
                ""
            ),
            (
                "χ² per fitted number, calibrated",
                number("/chi_square_per_row/1"),
                ""
            ),
        ])
    )
}

fn groups(document: &Document, comparison: &StudyComparison) -> String {
    let heads = [
        "wing",
        "channel",
        "use",
        "numbers",
        "rms error, as stated",
        "calibrated",
        "mean error, as stated",
        "calibrated",
        "σ of measurement",
        "σ of inputs",
        "explained",
        "unit",
    ];
    let mut table = HtmlTable::new(&heads).caption(
        "By wing and channel; explained: share of the mean square error, as stated, that the σ of measurement and inputs would give",
    );
    for (index, group) in comparison.groups.iter().enumerate() {
        let at = |name: &str| document.number(&format!("/groups/{index}/{name}"), Digits::Significant(3));
        table.row(vec![
            Shown::text(&group.wing),
            Shown::text(group.channel.name().replace('_', " ")),
            Shown::text(used(group.is_held_out)),
            document.exact(&format!("/groups/{index}/count")),
            at("rmse/0"),
            at("rmse/1"),
            at("bias/0"),
            at("bias/1"),
            at("sigma_of_measurement"),
            at("sigma_of_inputs"),
            at("explained"),
            Shown::text(&group.unit),
        ]);
    }
    table.html()
}

fn used(is_held_out: bool) -> &'static str {
    if is_held_out { "held out" } else { "fitted" }
}

fn unknowns(document: &Document, comparison: &StudyComparison) -> String {
    let heads = [
        "input",
        "prior",
        "σ of prior",
        "value",
        "standard error",
        "moved by (σ)",
        "unit",
        "known",
    ];
    let mut table = HtmlTable::new(&heads);
    for (index, unknown) in comparison.unknowns.iter().enumerate() {
        let at = |name: &str, digits: usize| {
            document.number(&format!("/unknowns/{index}/{name}"), Digits::Significant(digits))
        };
        let known = match (unknown.at_end, unknown.is_identified) {
            (true, _) => "at the end of its range",
            (_, true) => "by these data",
            _ => "not: at its prior",
        };
        let unit = &unknown.unknown.unit;
        table.row(vec![
            Shown::text(&unknown.unknown.name),
            at("unknown/mean", 4),
            at("unknown/sigma", 3),
            at("value", 4),
            at("standard_error", 3),
            document.number(&format!("/unknowns/{index}/pull"), Digits::After(2)),
            Shown::text(if unit == "1" { "" } else { unit }),
            Shown::text(known),
        ]);
    }
    let mut pairs =
        HtmlTable::new(&["one", "other", "correlation"]).caption("Unknowns that stand for each other");
    for (index, pair) in comparison.correlations.iter().enumerate() {
        let value = document.number(&format!("/correlations/{index}/value"), Digits::After(2));
        pairs.row(vec![Shown::text(&pair.a), Shown::text(&pair.b), value]);
    }
    table.html() + &pairs.folded(12, "Unknowns that stand for each other")
}

fn rows(document: &Document, comparison: &StudyComparison) -> String {
    let heads = [
        "case",
        "wing",
        "channel",
        "run",
        "r (mm)",
        "to (mm)",
        "chord fraction",
        "measured",
        "σ",
        "as stated",
        "σ of inputs",
        "calibrated",
        "use",
    ];
    let mut table = HtmlTable::new(&heads);
    for (index, row) in comparison.rows.iter().enumerate() {
        let at = |name: &str, digits: Digits| document.number(&format!("/rows/{index}/{name}"), digits);
        let value = Digits::Significant(4);
        table.row(vec![
            Shown::text(&row.case),
            Shown::text(&row.wing),
            Shown::text(row.channel.name().replace('_', " ")),
            Shown::text(&row.run),
            at("r_mm", Digits::After(1)),
            at("r_to_mm", Digits::After(1)),
            at("chord_fraction", Digits::Significant(3)),
            at("measured", value).after(sign(row.bound)),
            at("sigma", Digits::Significant(2)),
            at("before", value),
            at("sigma_of_inputs", Digits::Significant(2)),
            at("after", value),
            Shown::text(used(row.is_held_out)),
        ]);
    }
    let mut html = table.folded(40, "All rows");
    if !comparison.not_compared.is_empty() {
        html.push_str("<h3>Not compared</h3>\n");
        html.push_str(&list(&comparison.not_compared));
    }
    html
}
