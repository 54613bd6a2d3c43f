//! The hypotheses of a diagnosis for people, and how the error falls with the most probable.

use crate::diagnose::hypothesis::Hypothesis;
use crate::diagnose::ladder::LadderStep;
use crate::diagnose::misfit::Pull;
use crate::diagnose::of_study::NOT_COMPARED;
use crate::diagnose::strengths::{PlaceFound, Strength};
use crate::diagnose::{Diagnosis, Verdict};
use crate::page::Digits::{After, Significant};
use crate::page::text::significant;
use crate::page::{Fact, Part, Rows, Table};

use super::added::what;

/// Share by which the scatter may be off what is stated without a word.
const OFF: f64 = 0.05;

/// A held-out error up to so many times the scatter may be scatter: of a dozen readings, one draw in a hundred is larger.
const AS_SCATTER: f64 = 1.5;

/// Standard errors by which an input must move to be worth a word. A choice.
const APART: f64 = 1.0;

/// What the column of the set holds.
const IN_SET: &str = " In set: the most probable, which hold 95 % together.";

/// What the column of errors holds.
const ERROR: &str = "Error: one standard error; none where a strength is all or none, or stands in steps.";

/// Hypotheses that a screen shows at most; of a set with more the most probable.
const ROWS: usize = 5;

/// What to measure next, how probable each is (of one that is named, the others are for who wants all), what it means, and notes: what a
/// screen shows below the answer.
pub fn brief(found: &Diagnosis) -> Vec<Part> {
    // what had no part in the answer is always said
    let is_left_out = |note: &&String| note.starts_with(NOT_COMPARED);
    let (left_out, notes): (Vec<&String>, Vec<&String>) = found.notes.iter().partition(is_left_out);
    let next = found.next_experiment.iter();
    let mut parts: Vec<Part> = left_out
        .iter()
        .take(1)
        .map(|note| Part::Text(note.to_string()))
        .collect();
    parts.extend(next.map(|next| Part::Text(next.sentence.clone())));
    let labels = ["P(nothing missing)", "P(an unknown cause)"];
    parts.push(Part::Headline(probabilities(found, labels)));
    if found.verdict != Verdict::Effect {
        // all are plausible as a rule
        let is_plain = found.hypotheses.iter().all(|row| row.plausible || !row.in_set);
        let plausible = if is_plain { "plausible" } else { "" };
        let left_out = [
            "gain_left_out_conditions",
            "in set",
            "where",
            "at its end",
            plausible,
        ];
        let mut table = hypothesis_table(found).without(&left_out);
        table.caption = String::new();
        table.most_in_text = ROWS;
        parts.push(Part::Table(table));
    }
    parts.push(Part::List(
        meanings(found).into_iter().chain(inputs(found)).collect(),
    ));
    let notes = left_out.into_iter().skip(1).chain(notes);
    parts.push(Part::Notes(notes.cloned().collect()));
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
    let list = |error: fn(&LadderStep) -> Option<f64>, named: bool| {
        let each = models.iter().filter_map(|step| {
            let error = significant(error(step)?, 3);
            Some(match named {
                true => format!("{error} {}", names(step)),
                false => error,
            })
        });
        each.collect::<Vec<_>>().join(", ")
    };
    let times = match (&found.noise, found.noise.scale) {
        (noise, _) if noise.on_trust => {
            format!(" (as stated: {} numbers are too few to check it)", noise.numbers)
        }
        (_, scale) if (scale - 1.0).abs() < OFF => String::new(),
        (_, scale) => format!(" (it is {} times as stated)", significant(scale, 2)),
    };
    let scatter = noise.first().map_or(String::new(), |noise| {
        format!("; {} by scatter alone{times}", significant(noise.in_sample, 3))
    });
    let last = models.iter().rev().find_map(|step| step.held_out);
    // all steps as a rule, which are named already
    let is_named = models.iter().any(|step| step.held_out.is_none());
    let held_out = match (list(|step| step.held_out, is_named), last, noise.first()) {
        (list, Some(last), Some(noise)) => {
            let is_within = last <= AS_SCATTER * noise.in_sample;
            let than = if is_within { "no more" } else { "more" };
            format!(" Held out: {list}; the last is {than} than scatter explains.")
        }
        _ => String::new(),
    };
    let channel = first.channel.name().replace('_', " ");
    let calibrated = models.iter().find(|step| step.name == "calibrated");
    let is_nearer = match (calibrated, models.last()) {
        (Some(calibrated), Some(last)) => calibrated.in_sample < last.in_sample,
        _ => false,
    };
    let pulled = if is_nearer {
        pulled(&found.misfit.pulls)
    } else {
        String::new()
    };
    format!(
        "Error of the {channel}, rms in {}: {}{scatter}.{pulled}{held_out}{}",
        first.channel.unit(),
        list(|step| Some(step.in_sample), true),
        match (models.last(), noise.first()) {
            (Some(last), Some(noise)) => rest(
                found.verdict,
                found.noise.formulation,
                [last.in_sample, noise.in_sample]
            ),
            _ => String::new(),
        }
    )
}

/// Why a calibrated model that comes nearer without an effect is not the answer: the input that it had to pull most.
fn pulled(pulls: &[Pull]) -> String {
    let flagged = pulls.iter().filter(|pull| pull.is_flagged);
    let most = flagged.max_by(|a, b| a.pull.abs().total_cmp(&b.pull.abs()));
    most.map_or(String::new(), |most| {
        format!(
            " The calibrated model comes nearer, but for that it pulls {} by {:+.1} sigma.",
            most.unknown, most.pull
        )
    })
}

/// Where nothing is missing: what the `error` is that `scatter` does not explain, with the share of the prediction that is left to the
/// formulation.
fn rest(verdict: Verdict, formulation: f64, [error, scatter]: [f64; 2]) -> String {
    if verdict != Verdict::Nothing || error <= AS_SCATTER * scatter {
        return String::new();
    }
    format!(
        " What scatter does not explain is taken for errors of the model's own mesh and formulas ({} % of what they predict). These are \
         smooth along the span and alike in every condition.",
        significant(100.0 * formulation, 2)
    )
}

/// What the fit with the most probable explanation makes of the inputs that it moves farthest from where they are without it.
pub fn inputs(found: &Diagnosis) -> Option<String> {
    let leads = leading(found)?;
    let without = |own: &Pull| found.misfit.pulls.iter().find(|pull| pull.unknown == own.unknown);
    let moved = leads.inputs.iter().filter_map(|own| Some((own, without(own)?)));
    // in standard errors of the fit without: what these data do not know moves by nothing
    let far = |(own, without): &(&Pull, &Pull)| {
        (own.value - without.value).abs() / own.standard_error.min(without.standard_error)
    };
    let (own, without) = moved.max_by(|a, b| far(a).total_cmp(&far(b)))?;
    if far(&(own, without)) < APART {
        return None;
    }
    let unit = match own.unit.as_str() {
        "1" | "" => String::new(),
        unit => format!(" {unit}"),
    };
    let end = |pull: &Pull| {
        if pull.at_end {
            " (the end of its range)"
        } else {
            ""
        }
    };
    // what would have to be wrong instead
    let far_from_known = match without.is_flagged {
        true => format!(", {:.1} sigma from what is known of it", without.pull.abs()),
        false => String::new(),
    };
    Some(format!(
        "With it {} is fitted as {} ± {}{unit}{}, without it as {}{unit}{}{far_from_known}.",
        own.unknown,
        significant(own.value, 3),
        significant(own.standard_error, 2),
        end(own),
        significant(without.value, 3),
        end(without)
    ))
}

/// The most probable explanation by known effects, where there is one to go on with.
fn leading(found: &Diagnosis) -> Option<&Hypothesis> {
    match found.verdict {
        Verdict::Effect | Verdict::Set => found.hypotheses.iter().find(|row| !row.families.is_empty()),
        Verdict::Nothing | Verdict::Novel | Verdict::Undecidable => None,
    }
}

/// What the most probable effects are, and what their strengths mean; where nothing is missing, what could not have been seen.
pub fn meanings(found: &Diagnosis) -> Vec<String> {
    if found.verdict == Verdict::Nothing && found.unseen.len() > 1 {
        return vec![format!("Could not have been seen: {}.", found.unseen.join(", "))];
    }
    let words = |own: &Strength| {
        let (effect, [what, strength]) = (&own.effect, what(&own.effect)?);
        let here = own.stands_for.as_ref();
        let here = here.map_or(String::new(), |(value, unit)| {
            format!("; here {} {unit}", significant(*value, 3))
        });
        Some(format!("{effect}: {what} Strength: {strength}{here}."))
    };
    let leading = leading(found).map_or(&[][..], |row| row.strengths.as_slice());
    leading.iter().filter_map(words).collect()
}

/// How probable nothing, an unknown cause and each explanation are.
pub fn hypotheses(found: &Diagnosis) -> Vec<Part> {
    let labels = [
        "Probability of nothing missing",
        "Probability of an unknown cause",
    ];
    vec![
        Part::Headline(probabilities(found, labels)),
        Part::Table(hypothesis_table(found)),
    ]
}

/// How probable nothing and an unknown cause are, under these names.
fn probabilities(found: &Diagnosis, [nothing, unknown]: [&'static str; 2]) -> Vec<Fact> {
    let fact = |place: &str, label, value| Fact {
        place: place.to_string(),
        label,
        value: Some(value),
        unit: "",
        digits: Significant(2),
    };
    vec![
        fact("/p_nothing", nothing, found.p_nothing),
        fact("/novel/probability", unknown, found.novel.probability),
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
            _ => row.names(" + "),
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

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_calibrated_model_that_comes_nearer_is_said_to_have_pulled_what_it_pulled_most() {
        let pull = |unknown: &str, pull: f64| Pull {
            unknown: unknown.to_string(),
            value: 1.0,
            standard_error: 0.1,
            pull,
            is_flagged: pull.abs() > 2.0,
            unit: "1".to_string(),
            at_end: false,
        };
        let words = pulled(&[pull("a", -2.5), pull("b", 3.76), pull("c", 1.0)]);
        assert!(words.ends_with("pulls b by +3.8 sigma."), "{words}");
        assert_eq!(pulled(&[pull("a", -1.5)]), "");
    }

    #[test]
    fn an_error_above_the_scatter_is_explained_where_nothing_is_missing_and_only_there() {
        let words = rest(Verdict::Nothing, 0.021, [0.6, 0.3]);
        assert!(words.contains("(2.1 % of what they predict)"), "{words}");
        assert_eq!(rest(Verdict::Nothing, 0.021, [0.4, 0.3]), "");
        assert_eq!(rest(Verdict::Set, 0.021, [0.6, 0.3]), "");
    }
}
