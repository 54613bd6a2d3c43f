//! A wing against its measurement: rows, stations, words.

use crate::compare::Comparison;
use crate::export::ExportError;
use crate::export::comparison::sign;
use crate::export::pictures::panels::Compared;
use crate::export::pictures::{in_sigma, wing as wing_pictures};

use super::document::{Digits, Document, Shown};
use super::page::mind;
use super::picture::picture;
use super::table::{HtmlTable, list, paragraph};

/// What the comparison says, its rows and stations; `place` is where it stands in the document.
///
/// # Errors
/// If a number in a picture is not finite.
pub fn comparison(document: &Document, place: &str, found: &Comparison) -> Result<String, ExportError> {
    let mut html = format!(
        "<p class=\"sentence\">{}</p>\n",
        crate::plot::pen::escaped(&found.verdict)
    );
    html.push_str(&mind(&found.notes));
    let compared = Compared::of_wing(found);
    if !compared.rows.is_empty() {
        html.push_str(&picture(&wing_pictures::residuals(found))?);
        html.push_str(&picture(&in_sigma::figure(&compared))?);
    }
    html.push_str(&rows(document, place, found));
    for (index, span) in found.span.iter().enumerate() {
        html.push_str(&stations(
            document,
            &format!("{place}/span/{index}"),
            found,
            index,
        ));
        html.push_str(&list(&span.limits));
    }
    let left: Vec<String> = found
        .not_compared
        .iter()
        .map(|row| format!("line {}, {}: {}", row.line, row.channel.name(), row.reason))
        .collect();
    if !left.is_empty() {
        html.push_str("<h3>Not compared</h3>\n");
        html.push_str(&list(&left));
    }
    Ok(html)
}

fn rows(document: &Document, place: &str, found: &Comparison) -> String {
    let caption = format!(
        "Measured ({}, case {}) beside modelled; error: measured minus modelled",
        found.file, found.case
    );
    let heads = [
        "channel",
        "r (mm)",
        "to (mm)",
        "measured",
        "σ",
        "kind of σ",
        "modelled",
        "error",
        "error in σ",
        "unit",
        "run",
    ];
    let mut table = HtmlTable::new(&heads).caption(&caption);
    for (index, row) in found.rows.iter().enumerate() {
        let at =
            |name: &str, digits: Digits| document.number(&format!("{place}/rows/{index}/{name}"), digits);
        let word = |name: &str| document.words(&format!("{place}/rows/{index}/{name}"));
        let value = Digits::Significant(3);
        table.row(vec![
            Shown::text(row.channel.name().replace('_', " ")),
            at("r_mm", Digits::After(1)),
            at("r_to_mm", Digits::After(1)),
            at("measured", value).after(sign(row.bound)),
            at("sigma", value),
            word("sigma_kind"),
            at("modelled", value).after(sign(row.modelled_bound)),
            at("error", value),
            at("misfit_sigma", Digits::After(1)),
            Shown::text(if row.unit == "1" { "" } else { &row.unit }),
            word("run"),
        ]);
    }
    if table.is_empty() {
        return paragraph(&format!("No number of {} could be compared.", found.file));
    }
    table.html()
}

fn stations(document: &Document, place: &str, found: &Comparison, span: usize) -> String {
    let span = &found.span[span];
    let run = match span.run.as_str() {
        "" => String::new(),
        run => format!(", run {run}"),
    };
    let heads = [
        "r (mm)",
        "measured (deg)",
        "σ (deg)",
        "modelled (deg)",
        "error (deg)",
        "error in σ",
    ];
    let mut table = HtmlTable::new(&heads).caption(&format!("Twist along the span{run}"));
    for (index, station) in span.stations.iter().enumerate() {
        let at = |name: &str, digits: usize| {
            document.number(&format!("{place}/stations/{index}/{name}"), Digits::After(digits))
        };
        table.row(vec![
            at("r_mm", 1),
            at("measured_deg", 1).after(sign(station.bound)),
            at("sigma_deg", 1),
            at("modelled_deg", 1).after(sign(station.modelled_bound)),
            at("error_deg", 1),
            at("misfit_sigma", 1),
        ]);
    }
    let number = |name: &str, digits: usize| {
        document
            .number(&format!("{place}/{name}"), Digits::After(digits))
            .html
    };
    format!(
        "{}<p>Root mean square {}° over the span, {}° over the stations ({} σ); worst at {} mm.</p>\n",
        table.html(),
        number("rmse_along_span_deg", 2),
        number("rmse_deg", 2),
        number("rms_sigma", 1),
        number("worst_r_mm", 1)
    )
}
