//! The report of a diagnosis: the sentence, hypotheses, effects with the plots behind them, the ladder, what to measure next.

use crate::diagnose::verdict::EffectRow;
use crate::diagnose::{Diagnosis, Verdict};
use crate::export::ExportError;
use crate::export::diagnosis::DiagnosisReport;
use crate::export::pictures::ladder::{self, Fall};
use crate::export::pictures::{diagnosis as pictures, in_sigma};

use super::document::{Digits, Document, Shown};
use super::page::{Page, headline, mind};
use super::picture::picture;
use super::table::{HtmlTable, folded, list, paragraph};
use super::wing::Wings;

/// The report of a diagnosis by itself; `study` is its name, `wings` are those to be shown.
///
/// # Errors
/// If a number in a picture is not finite.
pub fn page(study: &str, report: &DiagnosisReport, wings: &Wings) -> Result<Page, ExportError> {
    let mut page = Page {
        title: study.to_string(),
        lead: sentence(&report.diagnosis),
        ..Page::default()
    };
    page.section("wing", "The wings", wings.section()?);
    add(&mut page, study, report)?;
    Ok(page)
}

/// What it says, and what must be minded.
pub fn sentence(found: &Diagnosis) -> String {
    format!(
        "<p class=\"sentence\">{}</p>\n",
        crate::plot::pen::escaped(&found.sentence)
    )
}

/// Adds the sections of a diagnosis, and its document.
///
/// # Errors
/// If a number in a picture is not finite.
pub fn add(page: &mut Page, study: &str, report: &DiagnosisReport) -> Result<(), ExportError> {
    let found = &report.diagnosis;
    let document = Document::new("diagnosis", report)?;
    page.section("hypotheses", "What may be missing", hypotheses(&document, found));
    let mut html = effects(&document, found);
    for plot in &found.added_variables {
        let figure = pictures::added_variables(study, std::slice::from_ref(plot));
        html.push_str(&folded(
            &format!("{} against the residual", plot.effect),
            &picture(&figure)?,
        ));
    }
    if !found.unseen.is_empty() {
        html.push_str("<h3>Not visible in this campaign at their plausible size</h3>\n");
        html.push_str(&paragraph(&found.unseen.join(", ")));
    }
    page.section("effects", "Effects", html);
    page.section(
        "misfit",
        "Where the calibrated model fails",
        misfit(&document, study, found)?,
    );
    page.section(
        "ladder",
        "The error, step by step",
        ladder(&document, study, found)?,
    );
    page.section(
        "missing",
        "What is missing, along the span",
        missing(study, found)?,
    );
    page.section("predictions", "Held-out cases", predictions(&document, found));
    page.section("next", "What to measure next", next(&document, found));
    page.section("sure-of-it", "How sure the diagnosis is", sure(&document, found));
    page.documents.push(document);
    Ok(())
}

fn hypotheses(document: &Document, found: &Diagnosis) -> String {
    let heads = [
        "what is missing",
        "probability",
        "strength",
        "standard error",
        "plausible",
        "in the 95 % set",
        "gain on cases left out (ln)",
    ];
    let mut table = HtmlTable::new(&heads);
    for (index, hypothesis) in found.hypotheses.iter().enumerate() {
        let what = match hypothesis.effects.as_slice() {
            [] => "nothing".to_string(),
            [only] if only == "novel" => "an unknown cause".to_string(),
            effects => effects.join(" + "),
        };
        let strengths = |name: &str, digits: usize| {
            let parts = (0..hypothesis.strengths.len()).map(|k| {
                let place = format!("/hypotheses/{index}/strengths/{k}/{name}");
                document.number(&place, Digits::Significant(digits)).html
            });
            Shown {
                html: parts.collect::<Vec<_>>().join(" / "),
                is_number: true,
            }
        };
        let at = |name: &str, digits: usize| {
            document.number(&format!("/hypotheses/{index}/{name}"), Digits::After(digits))
        };
        table.row(vec![
            Shown::text(what),
            at("probability", 3),
            strengths("value", 3),
            strengths("standard_error", 2),
            yes(hypothesis.plausible),
            yes(hypothesis.in_set),
            at("gain_left_out_conditions", 1),
        ]);
    }
    let p = document.number("/p_nothing", Digits::Significant(2));
    let novel = document.number("/novel/probability", Digits::Significant(2));
    headline(&[
        ("Probability that nothing is missing", p, ""),
        ("Probability of an unknown cause", novel, ""),
    ]) + &table.html()
}

fn yes(is: bool) -> Shown {
    Shown::text(if is { "yes" } else { "no" })
}

fn effects(document: &Document, found: &Diagnosis) -> String {
    let heads = [
        "effect",
        "where",
        "score (σ)",
        "strength, one step",
        "±",
        "refitted",
        "±",
        "plausible from",
        "to",
        "within",
        "detectable (σ)",
        "alone",
        "ln evidence",
        "probability",
        "gain on cases left out (ln)",
        "held-out gain",
        "looks like",
        "apart (σ)",
    ];
    let mut table = HtmlTable::new(&heads).caption(
        "Score: distance from none, what the model can absorb left out; detectable: the score that the largest plausible size would \
         have; alone: whether it could be what is missing, by its score alone (absent: a third of the plausible size would have been seen); held-out gain: held-out error without over with it",
    );
    let mut order: Vec<usize> = (0..found.effects.len()).collect();
    let score = |index: &usize| found.effects[*index].score.abs();
    order.sort_by(|a, b| score(b).total_cmp(&score(a)));
    for index in order {
        let row = &found.effects[index];
        let at = |name: &str, digits: Digits| document.number(&format!("/effects/{index}/{name}"), digits);
        // An error that is not known is written as the largest number there is.
        let error = |name: &str, value: Option<f64>| match value {
            Some(value) if value < 1e300 => at(name, Digits::Significant(2)),
            _ => Shown::default(),
        };
        let near = row.look_alikes.first();
        table.row(vec![
            Shown::text(&row.effect),
            Shown::text(place(row)),
            at("score", Digits::After(1)),
            at("one_step", Digits::Significant(3)),
            error("one_step_error", Some(row.one_step_error)),
            at("refitted", Digits::Significant(3)),
            error("refitted_error", row.refitted_error),
            at("plausible_range/0", Digits::Significant(3)),
            at("plausible_range/1", Digits::Significant(3)),
            yes(row.plausible),
            at("detectability", Digits::After(1)),
            document.words(&format!("/effects/{index}/sight")),
            at("ln_evidence", Digits::After(1)),
            at("probability", Digits::After(3)),
            at("gain_left_out_conditions", Digits::After(1)),
            at("held_out_gain", Digits::After(2)),
            near.map_or(Shown::default(), |near| Shown::text(&near.effect)),
            at("look_alikes/0/separation_sigma", Digits::After(1)),
        ]);
    }
    table.html()
}

fn place(row: &EffectRow) -> String {
    let Some(place) = &row.place else {
        return String::new();
    };
    let wing = place
        .wing
        .as_ref()
        .map_or(String::new(), |wing| format!(" on {wing}"));
    let numbers: String = place
        .numbers
        .iter()
        .map(|(name, value)| format!(", {name} {value}"))
        .collect();
    format!(
        "{} {}{numbers}{wing}",
        place.parameter,
        crate::export::text::significant(place.value, 3)
    )
}

fn misfit(document: &Document, study: &str, found: &Diagnosis) -> Result<String, ExportError> {
    let mut html = String::new();
    if let Some(plot) = found.added_variables.first() {
        html.push_str(&picture(&in_sigma::of_diagnosis(study, &plot.points))?);
    }
    let first = found.misfit.by_station.first();
    let is_along = first.is_some_and(|first| {
        found
            .misfit
            .by_station
            .iter()
            .any(|station| station.r_over_length != first.r_over_length)
    });
    if is_along {
        html.push_str(&picture(&pictures::by_station(study, &found.misfit.by_station))?);
    }
    let heads = [
        "case",
        "channel",
        "numbers",
        "share of the misfit",
        "mean error",
        "its σ",
        "rms error",
        "rms in σ",
    ];
    let mut table = HtmlTable::new(&heads);
    let mut order: Vec<usize> = (0..found.misfit.by_condition.len()).collect();
    let share = |index: &usize| found.misfit.by_condition[*index].share;
    order.sort_by(|a, b| share(b).total_cmp(&share(a)));
    for index in order {
        let group = &found.misfit.by_condition[index];
        let place = format!("/misfit/by_condition/{index}");
        let at = |name: &str, digits: Digits| document.number(&format!("{place}/{name}"), digits);
        table.row(vec![
            Shown::text(&group.condition),
            Shown::text(group.channel.name().replace('_', " ")),
            document.exact(&format!("{place}/numbers")),
            at("share", Digits::After(3)),
            at("mean_error", Digits::Significant(3)),
            at("mean_uncertainty", Digits::Significant(2)),
            at("rms", Digits::Significant(3)),
            at("rms_sigma", Digits::After(1)),
        ]);
    }
    html.push_str(&table.folded(20, "Misfit by case"));
    let pulls = found.misfit.pulls.iter().filter(|pull| pull.is_flagged);
    let pulls: Vec<String> = pulls
        .map(|pull| {
            format!(
                "{} was pulled by {} σ of its prior: it may stand in for what is missing.",
                pull.unknown,
                crate::export::text::number(pull.pull, 1)
            )
        })
        .collect();
    Ok(html + &list(&pulls))
}

fn ladder(document: &Document, study: &str, found: &Diagnosis) -> Result<String, ExportError> {
    let falls = Fall::of_rungs(&found.ladder);
    if falls.is_empty() {
        return Ok(String::new());
    }
    let mut html = picture(&ladder::figure(
        &format!("{study} – the error, step by step"),
        &falls,
    ))?;
    let heads = [
        "model",
        "channel",
        "fitted",
        "each case predicted from the others",
        "held out",
        "unit",
        "χ² per number, all channels",
        "held out, all channels, σ",
    ];
    let mut table = HtmlTable::new(&heads);
    for (index, rung) in found.ladder.iter().enumerate() {
        let at = |name: &str| document.number(&format!("/ladder/{index}/{name}"), Digits::Significant(3));
        table.row(vec![
            Shown::text(&rung.name),
            Shown::text(rung.channel.name().replace('_', " ")),
            at("in_sample"),
            at("left_out"),
            at("held_out"),
            Shown::text(rung.channel.unit()),
            at("chi_square_per_number"),
            at("held_out_sigma"),
        ]);
    }
    html.push_str(&table.html());
    Ok(html)
}

fn missing(study: &str, found: &Diagnosis) -> Result<String, ExportError> {
    let Some(field) = pictures::missing(found) else {
        return Ok(String::new());
    };
    let mut html = picture(&pictures::field(study, field))?;
    if let Some(draft) = &found.novel.draft {
        let text = draft.effect.as_ref().unwrap_or(&draft.expression);
        html.push_str(&paragraph(&draft.what));
        html.push_str(&format!("<pre>{}</pre>\n", crate::plot::pen::escaped(text)));
    }
    Ok(html)
}

fn predictions(document: &Document, found: &Diagnosis) -> String {
    let heads = [
        "case",
        "channel",
        "r (mm)",
        "measured",
        "calibrated",
        "explained",
        "σ of explained",
        "unit",
    ];
    let mut table = HtmlTable::new(&heads);
    for (index, prediction) in found.predictions.iter().enumerate() {
        let at = |name: &str, digits: usize| {
            document.number(
                &format!("/predictions/{index}/{name}"),
                Digits::Significant(digits),
            )
        };
        table.row(vec![
            Shown::text(&prediction.condition),
            Shown::text(prediction.channel.name()),
            Shown::text(crate::export::diagnosis::station(prediction)),
            at("measured", 4),
            at("calibrated", 4),
            at("explained", 4),
            at("standard_deviation", 2),
            Shown::text(&prediction.unit),
        ]);
    }
    table.folded(20, "Predictions")
}

fn next(document: &Document, found: &Diagnosis) -> String {
    let Some(next) = &found.next_experiment else {
        return String::new();
    };
    let mut table = HtmlTable::new(&["experiment", "sets the rivals apart by (σ)"]);
    for (index, candidate) in next.candidates.iter().enumerate() {
        let place = format!("/next_experiment/candidates/{index}/separation_sigma");
        table.row(vec![
            Shown::text(&candidate.name),
            document.number(&place, Digits::After(1)),
        ]);
    }
    paragraph(&next.sentence) + &table.html()
}

fn sure(document: &Document, found: &Diagnosis) -> String {
    let trust = if found.noise.on_trust {
        ", taken on trust"
    } else {
        ""
    };
    let mut html = format!(
        "<p>{} numbers fitted; noise {} times as stated{trust}; error of the model's formulation {} of what it predicts. {} effects were \
         tried.</p>\n",
        document.exact("/noise/numbers").html,
        document.number("/noise/scale", Digits::Significant(3)).html,
        document.number("/noise/formulation", Digits::Significant(2)).html,
        document.exact("/tried").html,
    );
    let outliers = found.noise.outliers.iter().map(|outlier| {
        format!(
            "{}, line {}: far from what all others tell; its σ was widened {} times.",
            outlier.condition,
            outlier.line,
            crate::export::text::significant(outlier.widening, 2)
        )
    });
    html.push_str(&list(&outliers.collect::<Vec<_>>()));
    let mut notes = found.notes.clone();
    if found.verdict == Verdict::Undecidable {
        notes.push("This campaign cannot tell: that is no proof that nothing is missing.".to_string());
    }
    html + &mind(&notes)
}
