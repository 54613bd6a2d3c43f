//! A study compared with its measurements, for people: what it says in words first, then what it rests on.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::compare::StudyComparison;
use crate::compare::study::root_mean_square;
use crate::compare::study_comparison::StudyRow;
use crate::compare::study_words::of_group;
use crate::input::measurement::Channel;
use crate::input::study::LoadedStudy;
use crate::page::Digits::{After, Significant};
use crate::page::text::{number, significant};
use crate::page::{Fact, Page, Part, Rows, Table};
use crate::program::MadeOf;

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
/// Channels of which a screen says how far the model is from them.
const CHANNELS: usize = 3;

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
        lead: [
            errors(comparison),
            vec![chi_square(comparison), Part::Text(counts)],
        ]
        .concat(),
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

/// How far the model is from each channel, all wings together: as it is and calibrated, and what scatter alone would leave.
fn errors(comparison: &StudyComparison) -> Vec<Part> {
    let mut channels: Vec<Channel> = Vec::new();
    for row in &comparison.rows {
        if !channels.contains(&row.channel) {
            channels.push(row.channel);
        }
    }
    let each = channels
        .into_iter()
        .map(|channel| of_channel(comparison, channel));
    each.map(Part::Sentence).collect()
}

fn of_channel(comparison: &StudyComparison, channel: Channel) -> String {
    let rms = |is_held_out: bool, error: &dyn Fn(&StudyRow) -> f64| {
        let own = comparison.rows.iter().filter(|row| row.channel == channel);
        let own = own.filter(|row| row.is_held_out == is_held_out);
        root_mean_square(own.map(error)).map(|error| significant(error, 3))
    };
    let errors = |is_held_out: bool| {
        let [before, after] = [0, 1].map(|model| rms(is_held_out, &|row| row.errors()[model]));
        before.zip(after)
    };
    let in_full = |(before, after): (String, String), is_held_out: bool| {
        let scatter = rms(is_held_out, &|row| row.sigma).unwrap_or_default();
        format!("{before} uncalibrated, {after} calibrated, {scatter} by scatter")
    };
    let name = channel.name().replace('_', " ");
    let unit = match channel.unit() {
        "1" => String::new(),
        unit => format!(" in {unit}"),
    };
    match (errors(false), errors(true)) {
        (Some(fitted), None) => format!("Error of the {name}, rms{unit}: {}.", in_full(fitted, false)),
        (Some(fitted), Some((before, after))) => format!(
            "Error of the {name}, rms{unit}: {}. Held out: {before} and {after}.",
            in_full(fitted, false)
        ),
        (None, Some(held_out)) => {
            format!(
                "Error of the {name}, held out, rms{unit}: {}.",
                in_full(held_out, true)
            )
        }
        (None, None) => String::new(),
    }
}

/// What could not be compared, the error of each wing and channel, and what is said of it: of more than a few in the table alone.
fn brief(comparison: &StudyComparison) -> Vec<Part> {
    // what calibration had to move comes before what the table says too
    let of_groups: Vec<String> = comparison.groups.iter().map(of_group).collect();
    let is_of_group = |words: &&String| of_groups.contains(words);
    let (said, moved): (Vec<&String>, Vec<&String>) = comparison.words.iter().partition(is_of_group);
    let said = said.into_iter().filter(|_| comparison.groups.len() <= FEW);
    let words = moved.into_iter().chain(said);
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
    let mut parts = errors(comparison);
    parts.truncate(CHANNELS);
    parts.push(chi_square(comparison));
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
