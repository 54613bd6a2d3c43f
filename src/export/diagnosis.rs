//! A diagnosis, as text: the sentence first, then what it rests on.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::diagnose::ladder::Rung;
use crate::diagnose::novel::Reconstruction;
use crate::diagnose::screening::Sight;
use crate::diagnose::verdict::{EffectRow, Hypothesis, Prediction, Strength};
use crate::diagnose::{Diagnosis, Verdict};
use crate::origin::MadeOf;
use crate::study::Work;

use super::text::{Table, number, significant, wrapped};

/// What `washout diagnose` gives; `diagnosis.json` of its folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DiagnosisReport {
    /// The diagnosis.
    #[serde(flatten)]
    pub diagnosis: Diagnosis,
    /// What it took.
    pub work: Work,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

/// What the columns of the effects mean.
const STRENGTHS: &str = "score: distance from none in sigma, what the model can absorb left out; one_step: strength by one linear step; within: \
                         whether its error reaches the plausible range; detectable: sigma that the largest plausible size would have, by the \
                         derivative at none, or by the model where that says more than 100; \
                         alone: whether it could be what is missing, by its score alone (absent: a third of the plausible size would have been seen).";
const LIKELY: &str = "ln_evidence: against nothing missing; probability: of its family, alone or with a second that the data merely allow; gain_left_out: of the logarithm of the \
                      density that all other cases give to each; held_out_gain: held-out error without over with it; look-alikes with \
                      the cosine between both signatures, and how many sigma apart they are at the strength found.";
/// Look-alikes of which the table tells.
const TOLD: usize = 2;
/// Effects whose rows are shown when there are more.
const SHOWN: usize = 24;

/// The page of `washout diagnose`.
pub fn page(study: &str, diagnosis: &Diagnosis) -> String {
    let mut sections = vec![format!("{study}\n\n{}", wrapped(&diagnosis.sentence, 0))];
    sections.push(format!(
        "Hypotheses{}\n{}",
        about_ends(&diagnosis.hypotheses),
        hypotheses(&diagnosis.hypotheses)
    ));
    sections.push(format!(
        "Effects, each alone\n{}{}",
        wrapped(STRENGTHS, 2),
        strengths(&diagnosis.effects)
    ));
    sections.push(format!(
        "How likely each is, and what looks like it\n{}{}",
        wrapped(LIKELY, 2),
        likely(&diagnosis.effects)
    ));
    if !diagnosis.unseen.is_empty() {
        let names = diagnosis.unseen.join(", ");
        sections.push(format!(
            "Not visible in this campaign at their plausible size\n{}",
            wrapped(&names, 2)
        ));
    }
    sections.push(format!("Where the calibrated model fails\n{}", misfit(diagnosis)));
    sections.push(format!(
        "Error from the model as stated down to the noise\n{}",
        ladder(&diagnosis.ladder)
    ));
    if let (Verdict::Novel, Some(found)) = (diagnosis.verdict, &diagnosis.novel.reconstruction) {
        sections.push(format!(
            "What is missing, along the span\n{}",
            reconstruction(found)
        ));
        if let Some(draft) = &diagnosis.novel.draft {
            sections.push(match &draft.effect {
                Some(effect) => format!(
                    "An effect of your own to start from (washout add missing --own FILE --to STUDY)\n{}",
                    indented(effect)
                ),
                None => format!(
                    "Along the span (x = r/R)\n  {}\n  {}\n",
                    draft.expression, draft.what
                ),
            });
        }
    }
    if !diagnosis.predictions.is_empty() {
        sections.push(format!(
            "Held-out cases (explained: by the best of the known effects, or by the fitted cause without a name where the verdict is novel)\n{}",
            predictions(diagnosis)
        ));
    }
    if let Some(next) = &diagnosis.next_experiment {
        let mut table = Table::new(["experiment", "separation_in_sigma"]);
        for candidate in &next.candidates {
            table.row([candidate.name.clone(), number(candidate.separation_sigma, 1)]);
        }
        sections.push(format!(
            "What to measure next\n{}{}",
            wrapped(&next.sentence, 2),
            table.render()
        ));
    }
    let noise = &diagnosis.noise;
    let mut notes: String = diagnosis.notes.iter().map(|note| wrapped(note, 2)).collect();
    notes.push_str(&wrapped(
        &format!(
            "{} numbers fitted; noise {} times as stated{}; error of the model's formulation {} % of what it predicts. {} effects were \
             tried.",
            noise.numbers,
            significant(noise.scale, 3),
            if noise.on_trust { ", taken on trust" } else { "" },
            significant(100.0 * noise.formulation, 2),
            diagnosis.tried
        ),
        2,
    ));
    for outlier in &noise.outliers {
        let line = format!(
            "{}, line {}: far from what all others tell; its sigma was widened {} times.",
            outlier.condition,
            outlier.line,
            significant(outlier.widening, 2)
        );
        notes.push_str(&wrapped(&line, 2));
    }
    sections.push(format!("Mind\n{notes}"));
    sections.join("\n")
}

/// What the mark at a strength means, if there is one.
fn about_ends(hypotheses: &[Hypothesis]) -> &'static str {
    let mut strengths = hypotheses.iter().flat_map(|hypothesis| &hypothesis.strengths);
    match strengths.any(|strength| strength.at_end) {
        true => " (end: the most that is accepted; the data ask for no less)",
        false => "",
    }
}

fn hypotheses(hypotheses: &[Hypothesis]) -> String {
    let mut table = Table::new([
        "what is missing",
        "probability",
        "strength",
        "error",
        "plausible",
        "in_95_set",
        "gain_left_out",
    ]);
    for hypothesis in hypotheses {
        let what = match hypothesis.effects.as_slice() {
            [] => "nothing".to_string(),
            [only] if only == "novel" => "an unknown cause".to_string(),
            effects => effects.join(" + "),
        };
        let strengths = |of: &dyn Fn(&Strength) -> String| {
            let parts = hypothesis.strengths.iter().map(of);
            parts.collect::<Vec<_>>().join(" / ")
        };
        table.row([
            what,
            number(hypothesis.probability, 3),
            strengths(&|s| {
                format!(
                    "{}{}",
                    significant(s.value, 3),
                    if s.at_end { " (end)" } else { "" }
                )
            }),
            strengths(&|s| significant(s.standard_error, 3)),
            yes(hypothesis.plausible),
            yes(hypothesis.in_set),
            hypothesis
                .gain_left_out_conditions
                .map_or(String::new(), |gain| number(gain, 1)),
        ]);
    }
    table.render()
}

fn yes(is: bool) -> String {
    if is { "yes" } else { "no" }.to_string()
}

/// Effects in the order of the tables, and what to say of those that are left out.
fn shown(effects: &[EffectRow]) -> (Vec<&EffectRow>, String) {
    let mut order: Vec<&EffectRow> = effects.iter().collect();
    order.sort_by(|a, b| b.score.abs().total_cmp(&a.score.abs()));
    order.truncate(SHOWN);
    let rest = match effects.len().saturating_sub(SHOWN) {
        0 => String::new(),
        more => format!("  … and {more} more with smaller scores (--json)\n"),
    };
    (order, rest)
}

fn strengths(effects: &[EffectRow]) -> String {
    let mut table = Table::new([
        "effect",
        "score",
        "one_step",
        "error",
        "refitted",
        "error",
        "plausible_from",
        "to",
        "within",
        "unit",
        "detectable",
        "alone",
    ]);
    let (order, rest) = shown(effects);
    for row in order {
        let error = |error: f64| {
            if error < 1e300 {
                significant(error, 2)
            } else {
                String::new()
            }
        };
        let [from, to] = row.plausible_range;
        table.row([
            row.effect.clone() + &place(row),
            number(row.score, 1),
            significant(row.one_step, 3),
            error(row.one_step_error),
            row.refitted.map_or(String::new(), |value| significant(value, 3)),
            row.refitted_error.map_or(String::new(), error),
            significant(from, 3),
            significant(to, 3),
            yes(row.plausible),
            row.unit.clone(),
            number(row.detectability, 1),
            match row.sight {
                Sight::Possible => "possible",
                Sight::Absent => "absent",
                Sight::Undecidable => "undecidable",
            }
            .to_string(),
        ]);
    }
    table.render() + &rest
}

fn place(row: &EffectRow) -> String {
    row.place.as_ref().map_or(String::new(), |place| {
        let numbers = place.numbers.values().map(|value| format!(" {value}"));
        let wing = place
            .wing
            .as_ref()
            .map_or(String::new(), |wing| format!(" on {wing}"));
        format!(
            "{} @ {}{wing}",
            numbers.collect::<String>(),
            significant(place.value, 2)
        )
    })
}

fn likely(effects: &[EffectRow]) -> String {
    let mut table = Table::new([
        "effect",
        "family",
        "ln_evidence",
        "probability",
        "gain_left_out",
        "held_out_gain",
        "look-alikes: cosine, sigma apart",
    ]);
    let (order, rest) = shown(effects);
    for row in order {
        let optional =
            |value: Option<f64>, digits| value.map_or(String::new(), |value| number(value, digits));
        let alike = row.look_alikes.iter().take(TOLD).map(|near| {
            format!(
                "{} {}, {}",
                near.effect,
                number(near.cosine, 2),
                number(near.separation_sigma, 1)
            )
        });
        table.row([
            row.effect.clone(),
            row.family.clone(),
            number(row.ln_evidence, 1),
            number(row.probability, 3),
            optional(row.gain_left_out_conditions, 1),
            optional(row.held_out_gain, 2),
            alike.collect::<Vec<_>>().join("; "),
        ]);
    }
    table.render() + &rest
}

fn misfit(diagnosis: &Diagnosis) -> String {
    let mut groups: Vec<_> = diagnosis.misfit.by_condition.iter().collect();
    groups.sort_by(|a, b| b.share.total_cmp(&a.share));
    let mut table = Table::new([
        "case",
        "channel",
        "numbers",
        "share",
        "mean_error",
        "uncertainty",
        "rms",
        "rms_in_sigma",
    ]);
    for group in groups.iter().take(12) {
        table.row([
            group.condition.clone(),
            group.channel.name().to_string(),
            group.numbers.to_string(),
            format!("{:.0} %", 100.0 * group.share),
            significant(group.mean_error, 3),
            significant(group.mean_uncertainty, 2),
            significant(group.rms, 3),
            number(group.rms_sigma, 1),
        ]);
    }
    let mut text = table.render();
    for pull in diagnosis.misfit.pulls.iter().filter(|pull| pull.is_flagged) {
        let line = format!(
            "{} was pulled to {} ({} of its prior's sigma): it may stand in for what is missing.",
            pull.unknown,
            significant(pull.value, 4),
            number(pull.pull, 1)
        );
        text.push_str(&wrapped(&line, 2));
    }
    text
}

/// The ladder of the error.
pub fn ladder(rungs: &[Rung]) -> String {
    let mut table = Table::new([
        "model",
        "channel",
        "in_sample",
        "left_out",
        "held_out",
        "unit",
        "chi2_all",
        "held_out_sigma",
    ]);
    for rung in rungs {
        let shown = |value: Option<f64>| value.map_or(String::new(), |value| significant(value, 3));
        table.row([
            rung.name.clone(),
            rung.channel.name().to_string(),
            significant(rung.in_sample, 3),
            shown(rung.left_out),
            shown(rung.held_out),
            rung.channel.unit().to_string(),
            shown(rung.chi_square_per_number),
            shown(rung.held_out_sigma),
        ]);
    }
    table.render()
}

fn reconstruction(found: &Reconstruction) -> String {
    let mut text = String::new();
    for profile in &found.field {
        if let Some(condition) = &profile.condition {
            text.push_str(&format!("  in {condition}\n"));
        }
        let mut table = Table::new(["r_over_R", "value", "sigma", "unit"]);
        for point in &profile.points {
            table.row([
                number(point.r_over_length, 2),
                significant(point.value, 3),
                significant(point.standard_deviation, 2),
                found.unit.clone(),
            ]);
        }
        text.push_str(&table.render());
    }
    text
}

/// Station or interval of a prediction, mm; nothing where it has none.
pub(super) fn station(prediction: &Prediction) -> String {
    let ends = [prediction.r_mm, prediction.r_to_mm].into_iter().flatten();
    let ends = ends.map(|r_mm| significant(r_mm, 4));
    ends.collect::<Vec<_>>().join(" to ")
}

fn predictions(diagnosis: &Diagnosis) -> String {
    let mut table = Table::new([
        "case",
        "channel",
        "r_mm",
        "measured",
        "calibrated",
        "explained",
        "sigma",
        "unit",
    ]);
    for prediction in &diagnosis.predictions {
        table.row([
            prediction.condition.clone(),
            prediction.channel.name().to_string(),
            station(prediction),
            significant(prediction.measured, 4),
            significant(prediction.calibrated, 4),
            significant(prediction.explained, 4),
            significant(prediction.standard_deviation, 2),
            prediction.unit.clone(),
        ]);
    }
    table.render()
}

fn indented(text: &str) -> String {
    text.lines().map(|line| format!("  {line}\n")).collect()
}
