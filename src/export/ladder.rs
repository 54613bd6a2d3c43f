//! The ladder of a study as text: the error falling from the uncalibrated model to the noise.

use crate::compare::{StepGroup, StudyLadderStep};

use crate::page::text::{Table, significant};

/// A line for each step: errors of all channels in stated σ, fitted, left out and held out, and χ² per number.
pub fn steps(ladder: &[StudyLadderStep]) -> String {
    let mut table = Table::new(["model", "in_sample", "left_out", "held_out", "chi2"]);
    for step in ladder {
        let shown = |value: Option<f64>| value.map_or(String::new(), |value| significant(value, 3));
        table.row([
            step.name.clone(),
            shown(step.in_sample_sigma),
            shown(step.left_out_sigma),
            shown(step.held_out_sigma),
            shown(step.chi_square_per_number),
        ]);
    }
    table.render()
}

/// A line for each wing, channel and use of the data; a column for each step.
pub fn groups(ladder: &[StudyLadderStep]) -> String {
    let head = ["wing", "channel", "use", "of", "unit"].into_iter();
    let mut table = Table::new(head.chain(ladder.iter().map(|step| step.name.as_str())));
    let count = ladder.first().map_or(0, |step| step.groups.len());
    for index in 0..count {
        let mut line = |used: &str, of: &str, unit: &str, value: &dyn Fn(&StepGroup) -> Option<f64>| {
            let values = ladder.iter().map(|step| value(&step.groups[index]));
            let values: Vec<Option<f64>> = values.collect();
            if values.iter().all(Option::is_none) {
                return;
            }
            let group = &ladder[0].groups[index];
            let mut row = vec![group.wing.clone(), group.channel.name().to_string()];
            row.extend([used, of, unit].map(String::from));
            let shown = |value: &Option<f64>| value.map_or(String::new(), |value| significant(value, 3));
            row.extend(values.iter().map(shown));
            table.row(row);
        };
        let group = &ladder[0].groups[index];
        let used = if group.is_held_out { "held out" } else { "fit" };
        line(used, "rmse", &group.unit, &|group| Some(group.rmse));
        line("left out", "rmse", &group.unit, &|group| group.left_out);
        line(used, "chi2", "1", &|group| Some(group.chi_square_per_number));
    }
    table.render()
}
