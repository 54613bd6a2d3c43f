//! The hypotheses of a diagnosis for people, and how the error falls with the most probable.

use crate::diagnose::ladder::LadderStep;
use crate::diagnose::verdict::{Hypothesis, PlaceFound, Strength};
use crate::diagnose::{Diagnosis, Verdict};
use crate::page::Digits::{After, Significant};
use crate::page::text::significant;
use crate::page::{Fact, Part, Rows, Table};

use super::added::what;

/// Share by which the scatter may be off what is stated without a word.
const OFF: f64 = 0.05;

/// A held-out error up to so many times the scatter may be scatter: of a dozen readings, one draw in a hundred is larger.
const AS_SCATTER: f64 = 1.5;

/// What the column of the set holds.
const IN_SET: &str = " In set: the most probable, which hold 95 % together.";

/// What the column of errors holds.
const ERROR: &str = "Error: one standard error; none where a strength is all or none, or stands in steps.";

/// Hypotheses that a screen has room for; of a set with more the most probable.
const ROWS: usize = 3;

/// Notes that a screen has room for: the one that changes the answer most.
const NOTES: usize = 1;

/// The most probable hypotheses, the first notes, and what to measure next: with the answer above, what fits on a screen.
pub fn brief(found: &Diagnosis) -> Vec<Part> {
    let mut parts = hypotheses(found);
    if let Some(Part::Table(table)) = parts.last_mut() {
        // all are plausible as a rule
        let is_plain = found.hypotheses.iter().all(|row| row.plausible || !row.in_set);
        let plausible = if is_plain { "plausible" } else { "" };
        *table = table.clone().without(&[
            "gain_left_out_conditions",
            "in set",
            "where",
            "at its end",
            plausible,
        ]);
        table.caption = String::new();
        table.most_in_text = ROWS;
    }
    parts.push(Part::Notes(found.notes.iter().take(NOTES).cloned().collect()));
    match found.notes.len().saturating_sub(NOTES) {
        0 => {}
        1 => parts.push(Part::Text("One more note: --verbose".to_string())),
        more => parts.push(Part::Text(format!("{more} more notes: --verbose"))),
    }
    parts.extend(
        found
            .next_experiment
            .iter()
            .map(|next| Part::Text(next.sentence.clone())),
    );
    parts
}

/// How the error falls, in a sentence or two: where it was fitted, and where it was held out. Where nothing is missing no effect has a
/// part in that.
pub fn falls(found: &Diagnosis) -> String {
    let is_step = |step: &&LadderStep| found.verdict != Verdict::Nothing || !step.name.starts_with('+');
    let steps: Vec<&LadderStep> = found.ladder.iter().filter(is_step).collect();
    let Some(first) = steps.first() else {
        return String::new();
    };
    let names = |step: &LadderStep| match step.name.as_str() {
        "raw" => "uncalibrated".to_string(),
        "calibrated" => "calibrated".to_string(),
        own => own.replacen("+ ", "with ", 1),
    };
    let (noise, models): (Vec<&LadderStep>, Vec<&LadderStep>) =
        steps.iter().copied().partition(|step| step.name == "noise");
    let list = |error: fn(&LadderStep) -> Option<f64>| {
        let each = models
            .iter()
            .filter_map(|step| Some(format!("{} {}", significant(error(step)?, 3), names(step))));
        each.collect::<Vec<_>>().join(", ")
    };
    let times = match found.noise.scale {
        scale if (scale - 1.0).abs() < OFF => String::new(),
        scale => format!(" (it is {} times as stated)", significant(scale, 2)),
    };
    let scatter = noise.first().map_or(String::new(), |noise| {
        format!("; {} by scatter alone{times}", significant(noise.in_sample, 3))
    });
    let last = models.iter().rev().find_map(|step| step.held_out);
    let held_out = match (list(|step| step.held_out), last, noise.first()) {
        (list, Some(last), Some(noise)) => {
            let is_within = last <= AS_SCATTER * noise.in_sample;
            let than = if is_within { "no more" } else { "more" };
            format!(" Held out: {list}; {than} than scatter explains.")
        }
        _ => String::new(),
    };
    let channel = first.channel.name().replace('_', " ");
    format!(
        "Error of the {channel}, rms in {}: {}{scatter}.{held_out}{}",
        first.channel.unit(),
        list(|step| Some(step.in_sample)),
        rest(found, models.last().copied(), noise.first().copied())
    )
}

/// Where nothing is missing: what the error is that scatter does not explain.
fn rest(found: &Diagnosis, last: Option<&LadderStep>, noise: Option<&LadderStep>) -> String {
    let is_more = |last: &LadderStep, noise: &LadderStep| last.in_sample > AS_SCATTER * noise.in_sample;
    match (last, noise) {
        (Some(last), Some(noise)) if found.verdict == Verdict::Nothing && is_more(last, noise) => format!(
            " What scatter does not explain is taken for errors of the model's own mesh and formulas ({} % of what they predict). These are \
             smooth along the span and alike in every condition.",
            significant(100.0 * found.noise.formulation, 2)
        ),
        _ => String::new(),
    }
}

/// What the most probable effects are, and what their strengths mean; where nothing is missing, what could not have been seen.
pub fn meanings(found: &Diagnosis) -> Vec<String> {
    if found.verdict == Verdict::Nothing && found.unseen.len() > 1 {
        return vec![format!("Could not have been seen: {}.", found.unseen.join(", "))];
    }
    let leads = match found.verdict {
        Verdict::Effect | Verdict::Set => found.hypotheses.iter().find(|row| !row.families.is_empty()),
        Verdict::Nothing | Verdict::Novel | Verdict::Undecidable => None,
    };
    let effects = leads.map_or(&[][..], |row| row.effects.as_slice());
    let words = effects.iter().filter_map(|effect| {
        let [what, strength] = what(effect)?;
        Some(format!("{effect}: {what} Strength: {strength}."))
    });
    words.collect()
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
            fact("/p_nothing", "Probability of nothing missing", found.p_nothing),
            fact(
                "/novel/probability",
                "Probability of an unknown cause",
                found.novel.probability,
            ),
        ]),
        Part::Table(hypothesis_table(found)),
    ]
}

/// Where an effect sits.
pub fn place(place: &PlaceFound) -> String {
    let numbers = place.numbers.iter();
    let numbers = numbers.map(|(name, value)| format!(", {name} {value}"));
    let wing = place.wing.iter().map(|wing| format!(" on {wing}"));
    let rest: String = numbers.chain(wing).collect();
    format!("{} {}{rest}", place.parameter, significant(place.value, 2))
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
        .share(["probability", "probability", ""], After(3), |row| {
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
        .words("where", |row| {
            let places = row.strengths.iter().filter_map(|own| own.place.as_ref());
            places.map(place).collect::<Vec<_>>().join("; ")
        })
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
