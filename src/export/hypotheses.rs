//! The hypotheses of a diagnosis for people, and how the error falls with the most probable.

use crate::diagnose::Diagnosis;
use crate::diagnose::ladder::LadderStep;
use crate::diagnose::verdict::{Hypothesis, Strength};
use crate::page::Digits::{After, Significant};
use crate::page::text::significant;
use crate::page::{Fact, Part, Rows, Table};

/// What the column of the set holds.
const IN_SET: &str = " In set: the most probable, which hold 95 % together.";

/// What the column of errors holds.
const ERROR: &str = "Error: one standard error; none where a strength is all or none, or stands in steps.";

/// The hypotheses that count, and what to measure next.
pub fn brief(found: &Diagnosis) -> Vec<Part> {
    let in_set = found.hypotheses.iter().filter(|row| row.in_set).count();
    let mut parts = hypotheses(found);
    if let Some(Part::Table(table)) = parts.last_mut() {
        *table = table.clone().without(&["gain_left_out_conditions", "in set"]);
        table.caption = table.caption.replace(IN_SET, "");
        table.most_in_text = in_set.clamp(3, 7);
    }
    parts.push(Part::Notes(found.notes.clone()));
    parts.extend(
        found
            .next_experiment
            .iter()
            .map(|next| Part::Text(next.sentence.clone())),
    );
    parts
}

/// How the error falls, in one sentence.
pub fn falls(ladder: &[LadderStep]) -> String {
    let steps: Vec<String> = ladder
        .iter()
        .map(|step| {
            let name = match step.name.as_str() {
                "raw" => "uncalibrated",
                "calibrated" => "calibrated",
                "noise" => "from the scatter alone",
                own => &own.replacen("+ ", "with ", 1),
            };
            format!("{} {name}", significant(step.in_sample, 3))
        })
        .collect();
    let Some(first) = ladder.first() else {
        return String::new();
    };
    let channel = first.channel.name().replace('_', " ");
    format!(
        "Error of the {channel}, rms in {}: {}.",
        first.channel.unit(),
        steps.join(", ")
    )
}

/// How probable nothing, an unknown cause and each explanation are.
pub fn hypotheses(found: &Diagnosis) -> Vec<Part> {
    let fact = |place: &str, label, value| Fact {
        place: place.to_string(),
        label,
        value: Some(value),
        unit: "",
        digits: Significant(2),
    };
    vec![
        Part::Headline(vec![
            fact(
                "/p_nothing",
                "Probability that nothing is missing",
                found.p_nothing,
            ),
            fact(
                "/novel/probability",
                "Probability of an unknown cause",
                found.novel.probability,
            ),
        ]),
        Part::Table(hypothesis_table(found)),
    ]
}

fn hypothesis_table(found: &Diagnosis) -> Table {
    let strengths =
        |of: fn(&Strength) -> Option<f64>| move |row: &Hypothesis| row.strengths.iter().map(of).collect();
    let table = Rows::of("/hypotheses", &found.hypotheses)
        .words("what is missing", |row| match row.effects.as_slice() {
            [] => "nothing".to_string(),
            [only] if only == "novel" => "an unknown cause".to_string(),
            effects => effects.join(" + "),
        })
        .number(["probability", "probability", ""], After(3), |row| {
            row.probability
        })
        .numbers(
            ["strengths/*/value", "strength", ""],
            Significant(3),
            strengths(|own| Some(own.value)),
        )
        .numbers(
            ["strengths/*/standard_error", "error", ""],
            Significant(2),
            strengths(|own| Some(own.standard_error).filter(|error| *error > 0.0)),
        )
        .words("at its end", |row| {
            match row.strengths.iter().any(|strength| strength.at_end) {
                true => "yes",
                false => "",
            }
        })
        .yes_or_no("plausible", |row| row.plausible)
        .yes_or_no("in set", |row| row.in_set)
        .number(
            ["gain_left_out_conditions", "gain left out", "ln"],
            After(1),
            |row| row.gain_left_out_conditions,
        );
    let mut caption = format!("{ERROR}{IN_SET}");
    let mut strengths = found.hypotheses.iter().flat_map(|row| &row.strengths);
    if strengths.any(|strength| strength.at_end) {
        caption += " At its end: the most that is accepted; the data ask for no less.";
    }
    table.caption(&caption).table()
}
