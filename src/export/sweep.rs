//! Files of a sweep: what it is, results of its tasks, the table, its summary as text.

use std::io::ErrorKind;
use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::csv::{plain_cell, table as csv_table};
use super::tasks::write_json;
use super::{ExportError, json};
use crate::origin::InputFile;
use crate::page::Digits::After;
use crate::page::{Page, Part, Rows};
use crate::program::MadeOf;
use crate::sweep::{Row, Sensitivity, SweepPlan};

/// Failures that the page lists.
const LISTED: usize = 8;

/// What a sweep gave.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SweepSummary {
    /// What it was made of.
    pub made_of: MadeOf,
    /// What it is.
    pub plan: SweepPlan,
    /// Its cases.
    pub cases: usize,
    /// Cases that gave nothing; the table says why.
    pub failures: usize,
    /// Those of them whose input is at fault.
    pub refused: usize,
    /// Figures of the table with their least and largest value.
    pub figures: Vec<Span>,
    /// Shares of the axes in the variance of every figure.
    pub sensitivities: Vec<Sensitivity>,
}

/// Least and largest value of a figure.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Span {
    /// The figure.
    pub figure: String,
    /// Its least value.
    pub least: f64,
    /// Its largest value.
    pub largest: f64,
}

impl SweepSummary {
    /// Of all rows; `files`: what they were read from.
    pub fn new(
        plan: &SweepPlan,
        rows: &[Row],
        sensitivities: Vec<Sensitivity>,
        files: &[InputFile],
    ) -> SweepSummary {
        let span = |figure: String| {
            let values = || rows.iter().filter_map(|row| row.figure(&figure));
            Span {
                least: values().fold(f64::INFINITY, f64::min),
                largest: values().fold(f64::NEG_INFINITY, f64::max),
                figure,
            }
        };
        SweepSummary {
            made_of: MadeOf::files(files),
            plan: plan.clone(),
            cases: rows.len(),
            failures: rows.iter().filter(|row| row.failure.is_some()).count(),
            refused: rows.iter().filter(|row| row.is_refused).count(),
            figures: figures(rows).into_iter().map(span).collect(),
            sensitivities,
        }
    }

    /// What `washout sweep` says; `rows`: for the reasons of failures.
    pub fn page(&self, rows: &[Row]) -> Page {
        let lacking = match self.failures {
            0 => String::new(),
            failures => format!(", {failures} of which gave nothing"),
        };
        let mut page = Page {
            title: format!("{}: {} cases{lacking}", self.plan.base.display(), self.cases),
            kind: "summary",
            ..Page::default()
        };
        let figures = Rows::of("/figures", &self.figures)
            .words("figure", |span| span.figure.as_str())
            .number(["least", "least", ""], After(5), |span| span.least)
            .number(["largest", "largest", ""], After(5), |span| span.largest)
            .words("moved by (share of its variance)", |span| {
                self.moved_by(&span.figure)
            });
        page.section("figures", "Figures", vec![Part::Table(figures.table())]);
        page.section(
            "failures",
            "Cases that gave nothing",
            vec![Part::List(self.failed(rows))],
        );
        page
    }

    fn moved_by(&self, figure: &str) -> String {
        let own = self.sensitivities.iter().find(|known| known.figure == figure);
        let shares = own.into_iter().flat_map(|own| &own.shares);
        let shown = shares
            .filter(|share| share.total > 0.01)
            .map(|share| format!("{} {:.0} %", share.key, 100.0 * share.total));
        shown.collect::<Vec<_>>().join(", ")
    }

    fn failed(&self, rows: &[Row]) -> Vec<String> {
        let failed: Vec<&Row> = rows.iter().filter(|row| row.failure.is_some()).collect();
        let line = |row: &&Row| {
            let at = self.plan.axes.iter().zip(&row.values);
            let at: Vec<String> = at.map(|(axis, value)| format!("{}={value}", axis.key)).collect();
            format!("{}: {}", at.join(" "), row.failure.as_deref().unwrap_or_default())
        };
        let mut lines: Vec<String> = failed.iter().take(LISTED).map(line).collect();
        if failed.len() > LISTED {
            lines.push(format!("… and {} more (sweep.csv)", failed.len() - LISTED));
        }
        lines
    }
}

/// Names of all figures, in the order in which they first come.
pub fn figures(rows: &[Row]) -> Vec<String> {
    let mut names: Vec<String> = Vec::new();
    for figure in rows.iter().flat_map(|row| &row.figures) {
        if !names.contains(&figure.name) {
            names.push(figure.name.clone());
        }
    }
    names
}

/// `sweep.csv`: number, values of the axes, figures with unit, why a case gave nothing.
///
/// # Errors
/// If a row cannot be written.
pub fn table(plan: &SweepPlan, rows: &[Row]) -> Result<Vec<u8>, ExportError> {
    let names = figures(rows);
    let keys = plan.axes.iter().map(|axis| axis.key.as_str());
    let head: Vec<&str> = std::iter::once("case")
        .chain(keys)
        .chain(names.iter().map(String::as_str))
        .chain(["failure"])
        .collect();
    let record = |row: &Row| -> Vec<String> {
        let shown = |name: &String| {
            row.figure(name)
                .map_or(String::new(), |value| format!("{value:?}"))
        };
        std::iter::once(row.case.to_string())
            .chain(row.values.iter().map(|value| plain_cell(value)))
            .chain(names.iter().map(shown))
            .chain([plain_cell(
                &row.failure.clone().unwrap_or_default().replace('\n', " "),
            )])
            .collect()
    };
    let records: Vec<Vec<String>> = rows.iter().map(record).collect();
    csv_table(&head, &records)
}

/// Notes in a folder what its sweep is.
///
/// # Errors
/// If it cannot be written.
pub fn write_plan(folder: &Path, plan: &SweepPlan) -> Result<(), ExportError> {
    std::fs::create_dir_all(folder).map_err(ExportError::file("create", folder))?;
    write_json(&folder.join("sweep.json"), plan)
}

/// What the sweep of a folder is; none if it holds none.
///
/// # Errors
/// If the file is there but no plan of a sweep.
pub fn read_plan(folder: &Path) -> Result<Option<SweepPlan>, ExportError> {
    let path = folder.join("sweep.json");
    match std::fs::read_to_string(&path) {
        Ok(text) => json::read(text.as_bytes())
            .map(Some)
            .map_err(|error| ExportError::NoPlan {
                path: path.clone(),
                reason: error.to_string(),
            }),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(ExportError::file("read", &path)(error)),
    }
}
