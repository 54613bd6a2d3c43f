//! The ladder of a study for people: the error falling from the uncalibrated model to the noise.

use crate::compare::{StepGroup, StudyLadderStep};
use crate::page::Digits::Significant;
use crate::page::{Part, Rows, Table};

/// The name of a step, for people.
pub fn step_words(name: &str) -> &str {
    match name {
        "raw" => "uncalibrated",
        name => name,
    }
}

/// A line for each step: errors of all channels in stated σ, fitted, left out and held out, and χ² per number.
pub fn steps(ladder: &[StudyLadderStep]) -> Table {
    Rows::of("/ladder", ladder)
        .words("model", |step| step_words(&step.name))
        .number(["in_sample_sigma", "fitted", "σ"], Significant(3), |step| {
            step.in_sample_sigma
        })
        .number(["left_out_sigma", "left out", "σ"], Significant(3), |step| {
            step.left_out_sigma
        })
        .number(["held_out_sigma", "held out", "σ"], Significant(3), |step| {
            step.held_out_sigma
        })
        .number(["chi_square_per_number", "χ² per number", ""], Significant(3), |step| {
            step.chi_square_per_number
        })
        .caption(
            "Root mean square of all channels, in stated σ. χ²: per fitted number, with errors of the model that go together along the \
             span (discrepancy), which is what a fit makes least. Left out: each case predicted from the others.",
        )
        .table()
}

/// A table for each wing, channel and use of the data; a line for each step.
pub fn groups(ladder: &[StudyLadderStep]) -> Vec<Part> {
    let first = ladder.first().map_or(&[][..], |step| &step.groups);
    let of = |(index, group): (usize, &StepGroup)| {
        let used = if group.is_held_out { "held out" } else { "fit" };
        let title = format!("{}, {} ({used})", group.wing, group.channel.name());
        vec![
            Part::Subtitle(title),
            Part::Table(of_group(ladder, index, &group.unit)),
        ]
    };
    first.iter().enumerate().flat_map(of).collect()
}

fn of_group(ladder: &[StudyLadderStep], index: usize, unit: &str) -> Table {
    let rows: Vec<(&str, &StepGroup)> = ladder
        .iter()
        .map(|step| (step_words(&step.name), &step.groups[index]))
        .collect();
    let keyed = rows.iter().enumerate();
    let keyed = keyed.map(|(step, row)| (format!("{step}/groups/{index}"), row));
    Rows::keyed("/ladder", keyed)
        .words("model", |row| row.0)
        .number(["rmse", "rms", ""], Significant(3), |row| row.1.rmse)
        .number(["left_out", "left out", ""], Significant(3), |row| row.1.left_out)
        .number(
            ["chi_square_per_number", "χ² per number", ""],
            Significant(3),
            |row| row.1.chi_square_per_number,
        )
        .caption(&format!("Errors in {unit}; χ²: each number for itself"))
        .table()
}
