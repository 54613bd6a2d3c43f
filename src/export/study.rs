//! A study compared with its measurements, for people: what it says in words first, then what it rests on.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::compare::StudyComparison;
use crate::compare::study_words::of_group;
use crate::input::study::LoadedStudy;
use crate::origin::MadeOf;
use crate::page::Digits::{After, Significant};
use crate::page::text::number;
use crate::page::{Fact, Page, Part, Rows, Table};

use super::comparison::sign;
use super::pictures::panels::Compared;
use super::pictures::{compared, in_sigma, residuals};

/// What `washout compare STUDY` gives; `comparison.json` of its folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StudyReport {
    /// The comparison.
    #[serde(flatten)]
    pub comparison: StudyComparison,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

impl StudyReport {
    /// Of a study, before files are written.
    pub fn new(comparison: StudyComparison, study: &LoadedStudy) -> StudyReport {
        StudyReport {
            comparison,
            made_of: MadeOf::files(&study.files),
            files: Vec::new(),
        }
    }
}

/// Wings and channels of which a screen has room for a sentence each, and for a line each.
const FEW: usize = 3;
const GROUPS: usize = 8;

/// Measured numbers that text shows when there are more.
const SHOWN: usize = 12;

/// What `washout compare STUDY` says.
pub fn page(comparison: &StudyComparison) -> Page {
    let title = match comparison.title.as_str() {
        "" => String::new(),
        title => format!("{title}: "),
    };
    let counts = format!(
        "{title}{} cases, {} measured numbers",
        comparison.cases.len(),
        comparison.rows.len()
    );
    let mut page = Page {
        title: comparison.study.clone(),
        kind: "comparison",
        lead: vec![chi_square(comparison), Part::Text(counts)],
        brief: brief(comparison),
        sections: Vec::new(),
    };
    let found = Compared::of_study(comparison);
    let figures =
        |figures: Vec<crate::plot::Figure>| figures.into_iter().map(Part::Figure).collect::<Vec<_>>();
    let (mut over, mut residual) = (Vec::new(), Vec::new());
    if !found.rows.is_empty() {
        over = figures(vec![compared::figure(&found)]);
        residual = figures(vec![in_sigma::figure(&found), residuals::figure(&found)]);
    }
    let mut said = vec![
        Part::List(comparison.words.clone()),
        Part::Table(groups(comparison)),
    ];
    said.append(&mut over);
    page.section("compared", "Model against measurement", said);
    page.section("residuals", "Where it misses", residual);
    page.section(
        "calibrated",
        "What was calibrated",
        vec![
            Part::Table(unknowns(comparison)),
            Part::Table(correlations(comparison)),
        ],
    );
    page.section(
        "rows",
        "Every measured number",
        vec![Part::Table(rows(comparison))],
    );
    page.section(
        "left",
        "Not compared",
        vec![Part::List(comparison.not_compared.clone())],
    );
    page
}

/// What could not be compared, the error of each wing and channel, and what is said of it: of more than a few in the table alone.
fn brief(comparison: &StudyComparison) -> Vec<Part> {
    let of_groups: Vec<String> = match comparison.groups.len() {
        0..=FEW => Vec::new(),
        _ => comparison.groups.iter().map(of_group).collect(),
    };
    let words = comparison.words.iter().filter(|words| !of_groups.contains(words));
    let left_out = [
        "bias/0",
        "bias/1",
        "sigma_of_measurement",
        "sigma_of_inputs",
        "explained",
    ];
    let mut table = groups(comparison).without(&left_out);
    table.caption = "Error by wing and channel, root mean square:".to_string();
    table.most_in_text = GROUPS;
    let mut parts = vec![chi_square(comparison)];
    parts.extend(first_of(&comparison.not_compared).map(Part::Text));
    parts.push(Part::Table(table));
    parts.push(Part::List(words.cloned().collect()));
    parts
}

/// The first row that had no part, and how many more there are.
fn first_of(not_compared: &[String]) -> Option<String> {
    match not_compared {
        [] => None,
        [only] => Some(format!("Not compared: {only}")),
        [first, more @ ..] => Some(format!("Not compared: {first} ({} more)", more.len())),
    }
}

fn chi_square(comparison: &StudyComparison) -> Part {
    let labels = [
        "χ² per fitted number, uncalibrated",
        "χ² per fitted number, calibrated",
    ];
    let facts = labels.into_iter().zip(comparison.chi_square_per_row).enumerate();
    let fact = |(index, (label, value))| Fact {
        place: format!("/chi_square_per_row/{index}"),
        label,
        value: Some(value),
        unit: "",
        digits: Significant(3),
    };
    Part::Headline(facts.map(fact).collect())
}

fn groups(comparison: &StudyComparison) -> Table {
    Rows::of("/groups", &comparison.groups)
        .words("wing", |row| row.wing.as_str())
        .words("channel", |row| row.channel.name().replace('_', " "))
        .words("use", |row| used(row.is_held_out))
        .number(["count", "numbers", ""], After(0), |row| row.count as f64)
        .number(["rmse/0", "rms, uncalibrated", ""], Significant(3), |row| row.rmse[0])
        .number(["rmse/1", "calibrated", ""], Significant(3), |row| row.rmse[1])
        .number(["bias/0", "mean, uncalibrated", ""], Significant(3), |row| row.bias[0])
        .number(["bias/1", "calibrated", ""], Significant(3), |row| row.bias[1])
        .number(["sigma_of_measurement", "σ of measurement", ""], Significant(3), |row| {
            row.sigma_of_measurement
        })
        .number(["sigma_of_inputs", "σ of inputs", ""], Significant(3), |row| {
            row.sigma_of_inputs
        })
        .number(["explained", "explained", ""], Significant(3), |row| row.explained)
        .words("unit", |row| row.unit.as_str())
        .caption(
            "Error by wing and channel, root mean square and mean. Explained: share of the mean square error of the uncalibrated model that σ of \
             measurement and inputs would give; above 1, the error is smaller than they let expect.",
        )
        .table()
}

fn used(is_held_out: bool) -> &'static str {
    if is_held_out { "held out" } else { "fitted" }
}

fn unknowns(comparison: &StudyComparison) -> Table {
    Rows::of("/unknowns", &comparison.unknowns)
        .words("input", |row| row.unknown.name.as_str())
        .number(["unknown/mean", "prior", ""], Significant(4), |row| {
            row.unknown.mean
        })
        .number(["unknown/sigma", "σ of prior", ""], Significant(3), |row| {
            row.unknown.sigma
        })
        .number(["value", "value", ""], Significant(4), |row| row.value)
        .number(["standard_error", "standard error", ""], Significant(3), |row| {
            row.standard_error
        })
        .number(["pull", "moved by", "σ"], After(2), |row| row.pull)
        .words("unit", |row| match row.unknown.unit.as_str() {
            "1" => "",
            unit => unit,
        })
        .words("known", |row| match (row.at_end, row.is_identified) {
            (true, _) => "at the end of its range",
            (_, true) => "by these data",
            _ if row.is_at_its_prior() => "not: at its prior",
            _ => "no better than before",
        })
        .table()
}

fn correlations(comparison: &StudyComparison) -> Table {
    let title = "Unknowns that stand for each other";
    Rows::of("/correlations", &comparison.correlations)
        .words("one", |row| row.a.as_str())
        .words("other", |row| row.b.as_str())
        .number(["value", "correlation", ""], After(2), |row| row.value)
        .caption(title)
        .most_in_text(SHOWN)
        .folded(12, title)
        .table()
}

fn rows(comparison: &StudyComparison) -> Table {
    Rows::of("/rows", &comparison.rows)
        .words("case", |row| row.case.as_str())
        .words("wing", |row| row.wing.as_str())
        .words("channel", |row| row.channel.name().replace('_', " "))
        .words("run", |row| row.run.as_str())
        .number(["r_mm", "r", "mm"], After(1), |row| row.r_mm)
        .number(["r_to_mm", "to", "mm"], After(1), |row| row.r_to_mm)
        .number(["chord_fraction", "chord fraction", ""], Significant(3), |row| {
            row.chord_fraction
        })
        .bounded(["measured", "measured", ""], Significant(4), |row| {
            (sign(row.bound), row.measured)
        })
        .number(["sigma", "σ", ""], Significant(2), |row| row.sigma)
        .number(["before", "uncalibrated", ""], Significant(4), |row| row.before)
        .number(["sigma_of_inputs", "σ of inputs", ""], Significant(2), |row| {
            row.sigma_of_inputs
        })
        .number(["after", "calibrated", ""], Significant(4), |row| row.after)
        // Follows from measured, calibrated and σ of its row; the document does not repeat it.
        .words("error in σ", |row| number(row.errors()[1] / row.sigma, 1))
        .words("use", |row| used(row.is_held_out))
        .most_in_text(SHOWN)
        .folded(40, "All rows")
        .table()
}
