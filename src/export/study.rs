//! A study compared with its measurements, as text.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::compare::{StudyComparison, StudyRow};
use crate::input::measurement::Bound;
use crate::origin::MadeOf;

use crate::page::text::{Table, number, significant, wrapped};

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

/// The page of `washout compare STUDY`.
pub fn page(comparison: &StudyComparison) -> String {
    let title = match comparison.title.as_str() {
        "" => String::new(),
        title => format!(": {title}"),
    };
    let mut sections = vec![format!("{}{title}\n", comparison.study)];
    sections.push(format!("Measured minus modelled\n{}", rows(comparison)));
    sections.push(format!(
        "By wing and channel (explained: share of the mean square error, as stated, that sigma of measurement and inputs would give)\n{}",
        groups(comparison)
    ));
    if !comparison.unknowns.is_empty() {
        sections.push(format!("What was calibrated\n{}", unknowns(comparison)));
    }
    if !comparison.correlations.is_empty() {
        let mut table = Table::new(["one", "other", "correlation"]);
        for pair in comparison.correlations.iter().take(12) {
            table.row([pair.a.clone(), pair.b.clone(), number(pair.value, 2)]);
        }
        sections.push(format!("Unknowns that stand for each other\n{}", table.render()));
    }
    if !comparison.not_compared.is_empty() {
        let lines: String = comparison
            .not_compared
            .iter()
            .map(|line| format!("  {line}\n"))
            .collect();
        sections.push(format!("Not compared\n{lines}"));
    }
    let [before, after] = comparison.chi_square_per_row;
    let words: String = comparison.words.iter().map(|line| wrapped(line, 2)).collect();
    sections.push(format!(
        "In words (chi-square per fitted row {} as stated, {} calibrated)\n{words}",
        significant(before, 3),
        significant(after, 3)
    ));
    sections.join("\n")
}

fn rows(comparison: &StudyComparison) -> String {
    let mut table = Table::new([
        "case",
        "channel",
        "r_mm",
        "to_mm",
        "measured",
        "sigma",
        "as_stated",
        "of_inputs",
        "calibrated",
        "error",
        "in_sigma",
        "use",
    ]);
    for row in &comparison.rows {
        let place = |place: Option<f64>| place.map_or(String::new(), |r_mm| number(r_mm, 1));
        let digits = decimals(row);
        let sign = match row.bound {
            Bound::None => "",
            Bound::Upper => "<",
            Bound::Lower => ">",
        };
        let [_, error] = row.errors();
        table.row([
            row.case.clone(),
            row.channel.name().to_string(),
            place(row.r_mm),
            place(row.r_to_mm),
            format!("{sign}{}", number(row.measured, digits)),
            number(row.sigma, digits),
            number(row.before, digits),
            number(row.sigma_of_inputs, digits),
            number(row.after, digits),
            number(error, digits),
            number(error / row.sigma, 1),
            if row.is_held_out { "held out" } else { "fit" }.to_string(),
        ]);
    }
    table.render()
}

/// Digits after the point that show the measurement's sigma to two figures.
fn decimals(row: &StudyRow) -> usize {
    (1.0 - row.sigma.log10().floor()).clamp(0.0, 6.0) as usize
}

fn groups(comparison: &StudyComparison) -> String {
    let mut table = Table::new([
        "wing",
        "channel",
        "rows",
        "rmse_stated",
        "rmse_calibrated",
        "bias_stated",
        "bias_calibrated",
        "sigma_measured",
        "sigma_inputs",
        "explained",
        "unit",
        "use",
    ]);
    for group in &comparison.groups {
        table.row([
            group.wing.clone(),
            group.channel.name().to_string(),
            group.count.to_string(),
            significant(group.rmse[0], 3),
            significant(group.rmse[1], 3),
            significant(group.bias[0], 3),
            significant(group.bias[1], 3),
            significant(group.sigma_of_measurement, 3),
            significant(group.sigma_of_inputs, 3),
            format!("{:.0} %", (100.0 * group.explained).min(999.0)),
            group.unit.clone(),
            if group.is_held_out { "held out" } else { "fit" }.to_string(),
        ]);
    }
    table.render()
}

fn unknowns(comparison: &StudyComparison) -> String {
    let mut table = Table::new([
        "name", "prior", "sigma", "value", "error", "pull", "unit", "known",
    ]);
    for unknown in &comparison.unknowns {
        let known = match (unknown.at_end, unknown.is_identified) {
            (true, _) => "at the end of its range",
            (_, true) => "by these data",
            _ => "not: at its prior",
        };
        table.row([
            unknown.unknown.name.clone(),
            significant(unknown.unknown.mean, 4),
            significant(unknown.unknown.sigma, 3),
            significant(unknown.value, 4),
            significant(unknown.standard_error, 3),
            number(unknown.pull, 2),
            if unknown.unknown.unit == "1" {
                ""
            } else {
                &unknown.unknown.unit
            }
            .to_string(),
            known.to_string(),
        ]);
    }
    table.render()
}
