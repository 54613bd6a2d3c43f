//! A diagnosis for people: the sentence first, then what it rests on.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::diagnose::effect_row::{EffectRow, LookAlike};
use crate::diagnose::ladder::LadderStep;
use crate::diagnose::misfit::Misfit;
use crate::diagnose::screening::Sight;
use crate::diagnose::verdict::{Draft, NoiseFound, Prediction};
use crate::diagnose::{Diagnosis, Verdict};
use crate::input::study::LoadedStudy;
use crate::page::text::{number, significant};
use crate::page::{Digits, Page, Part, Rows, Table};
use crate::program::MadeOf;
use crate::study::Work;

use super::hypotheses::{brief, falls, hypotheses, inputs, meanings, place};
use super::ladder::step_words;
use super::pictures::ladder::{self, Fall};
use super::pictures::{diagnosis as pictures, in_sigma};

/// What `washout diagnose` gives; `diagnosis.json` of its folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DiagnosisReport {
    /// The diagnosis.
    #[serde(flatten)]
    pub diagnosis: Diagnosis,
    /// What it took, with all that is kept of the campaign from earlier questions.
    pub work: Work,
    /// Commands to go on with, in their order: what takes the effects into the model, or what more readings could show.
    #[serde(default)]
    pub commands: Vec<String>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

impl DiagnosisReport {
    /// Of a study, before files are written.
    pub fn new(diagnosis: Diagnosis, work: Work, study: &LoadedStudy) -> DiagnosisReport {
        DiagnosisReport {
            diagnosis,
            work,
            commands: Vec::new(),
            made_of: MadeOf::files(&study.files),
            files: Vec::new(),
        }
    }
}

use Digits::{After, Significant};

/// Effects that text shows when there are more.
const SHOWN: usize = 24;
/// Cases of the misfit that text shows.
const CASES: usize = 12;

/// What `washout diagnose` says of a study.
pub fn page(study: &str, found: &Diagnosis) -> Page {
    let mut page = Page {
        title: study.to_string(),
        kind: "diagnosis",
        lead: vec![
            Part::Sentence(found.sentence.clone()),
            Part::Text(format!("{} {}", falls(found), tried(found)).trim().to_string()),
            Part::List(inputs(found).into_iter().chain(meanings(found)).collect()),
        ],
        brief: Vec::new(),
        sections: Vec::new(),
    };
    page.brief = [&page.lead[..2], &brief(found)].concat();
    page.section("hypotheses", "Hypotheses", hypotheses(found));
    page.section(
        "ladder",
        "Error from the uncalibrated model down to the noise",
        errors(study, found),
    );
    page.section("predictions", "Held-out cases", predictions(&found.predictions));
    page.section("misfit", "Where the calibrated model fails", misfit(study, found));
    page.section(
        "missing",
        "What is missing, along the span",
        missing(study, found),
    );
    page.section("next", "What to measure next", next(found));
    page.section("effects", "Effects, each alone", effects(study, found));
    page.section(
        "likely",
        "How likely each is, and what looks like it",
        vec![Part::Table(likely(&found.effects))],
    );
    page.section("notes", "Noise and notes", notes(found));
    page
}

/// How many effects of all were tried.
fn tried(found: &Diagnosis) -> String {
    format!(
        "{} of the {} known effects were tried.",
        found.tried,
        crate::effects::all().count()
    )
}

fn effects(study: &str, found: &Diagnosis) -> Vec<Part> {
    let table = Rows::of("/effects", &found.effects)
        .by(|row| row.score.abs())
        .words("effect", |row| row.effect.as_str())
        .words("where", |row| row.place.as_ref().map_or(String::new(), place))
        .number(["score", "score", "σ"], After(1), |row| row.score)
        .number(["one_step", "one step", ""], Significant(3), |row| row.one_step)
        .number(["one_step_error", "±", ""], Significant(2), |row| row.one_step_error)
        .number(["refitted", "refitted", ""], Significant(3), |row| row.refitted)
        .number(["refitted_error", "±", ""], Significant(2), |row| row.refitted_error)
        .number(["plausible_range/0", "plausible from", ""], Significant(3), |row| {
            row.plausible_range[0]
        })
        .number(["plausible_range/1", "to", ""], Significant(3), |row| row.plausible_range[1])
        .yes_or_no("within", |row| row.plausible)
        .words("unit", |row| row.unit.as_str())
        .number(["detectability", "detectable", "σ"], After(1), |row| row.detectability)
        .words("alone", |row| match row.sight {
            Sight::Possible => "possible",
            Sight::Absent => "absent",
            Sight::Undecidable => "undecidable",
        })
        .caption(
            "Score: distance from none, what the model can absorb left out. One step: strength by one linear step. Within: whether its \
             error reaches the plausible range. Detectable: the score that the largest plausible size would have, by the derivative at \
             none, or by the model where that says more than 100. Alone: whether it could be what is missing, by its score alone \
             (absent: a third of the plausible size would have been seen).",
        )
        .most_in_text(SHOWN)
        .folded(20, "Scores and strengths")
        .table();
    let mut parts = vec![Part::Table(table)];
    parts.extend(found.added_variables.iter().map(|plot| {
        let figure = pictures::added_variables(study, std::slice::from_ref(plot));
        Part::Folded(format!("{} against the residual", plot.effect), figure)
    }));
    if !found.unseen.is_empty() {
        parts.push(Part::Subtitle(
            "Not visible in this campaign at their plausible size:".to_string(),
        ));
        parts.push(Part::Text(found.unseen.join(", ")));
    }
    let is_tried = |name: &str| found.effects.iter().any(|row| row.effect == name);
    let names = crate::effects::all().map(|effect| effect.card().name);
    let others: Vec<&str> = names.filter(|name| !is_tried(name)).collect();
    if !others.is_empty() {
        let why = "Not tried, for they cannot act here, are part of the model, or were not asked for (what each needs: washout effects \
                   NAME):";
        parts.push(Part::Subtitle(why.to_string()));
        parts.push(Part::Text(others.join(", ")));
    }
    parts
}

fn likely(effects: &[EffectRow]) -> Table {
    fn near(row: &EffectRow, place: usize) -> Option<&LookAlike> {
        row.look_alikes.get(place)
    }
    fn name(row: &EffectRow, place: usize) -> &str {
        near(row, place).map_or("", |near| near.effect.as_str())
    }
    Rows::of("/effects", effects)
        .by(|row| row.score.abs())
        .words("effect", |row| row.effect.as_str())
        .words("family", |row| row.family.as_str())
        .number(["ln_evidence", "ln evidence", ""], After(1), |row| row.ln_evidence)
        .number(["probability", "probability", ""], After(3), |row| row.probability)
        .number(["gain_left_out_conditions", "gain left out", "ln"], After(1), |row| {
            row.gain_left_out_conditions
        })
        .number(["held_out_gain", "held-out gain", ""], After(2), |row| row.held_out_gain)
        .words("looks like", |row| name(row, 0))
        .number(["look_alikes/0/cosine", "cosine", ""], After(2), |row| {
            near(row, 0).map(|near| near.cosine)
        })
        .number(["look_alikes/0/separation_sigma", "apart", "σ"], After(1), |row| {
            near(row, 0).map(|near| near.separation_sigma)
        })
        .words("and like", |row| name(row, 1))
        .number(["look_alikes/1/cosine", "cosine", ""], After(2), |row| {
            near(row, 1).map(|near| near.cosine)
        })
        .number(["look_alikes/1/separation_sigma", "apart", "σ"], After(1), |row| {
            near(row, 1).map(|near| near.separation_sigma)
        })
        .caption(
            "ln evidence: against nothing missing. Probability: of its family, alone or with a second that the data merely allow. Gain left \
             out: of the logarithm of the density that all other cases give to each. Held-out gain: held-out error without over with \
             it. Looks like, and like: the two nearest other effects, the cosine between both signatures, and how far apart they are at the strength found.",
        )
        .most_in_text(SHOWN)
        .folded(20, "Evidence and look-alikes")
        .table()
}

fn misfit(study: &str, found: &Diagnosis) -> Vec<Part> {
    let Misfit {
        by_condition,
        by_station,
        pulls,
        ..
    } = &found.misfit;
    let mut parts = Vec::new();
    if let Some(plot) = found.added_variables.first() {
        parts.push(Part::Figure(in_sigma::of_diagnosis(study, &plot.points)));
    }
    let places = by_station.iter().map(|station| station.r_over_length);
    if places.clone().any(|place| Some(place) != places.clone().next()) {
        parts.push(Part::Figure(pictures::by_station(study, by_station)));
    }
    let table = Rows::of("/misfit/by_condition", by_condition)
        .by(|row| row.share)
        .words("case", |row| row.condition.as_str())
        .words("channel", |row| row.channel.name().replace('_', " "))
        .number(["numbers", "numbers", ""], After(0), |row| row.numbers as f64)
        .number(["share", "share of the misfit", ""], After(2), |row| row.share)
        .number(["mean_error", "mean error", ""], Significant(3), |row| {
            row.mean_error
        })
        .number(["mean_uncertainty", "its σ", ""], Significant(2), |row| {
            row.mean_uncertainty
        })
        .number(["rms", "rms error", ""], Significant(3), |row| row.rms)
        .number(["rms_sigma", "rms", "σ"], After(1), |row| row.rms_sigma);
    parts.push(Part::Table(
        table.most_in_text(CASES).folded(20, "Misfit by case").table(),
    ));
    let pulled = pulls.iter().filter(|pull| pull.is_flagged).map(|pull| {
        format!(
            "{} was pulled to {} ({} σ of its prior): it may stand in for what is missing.",
            pull.unknown,
            significant(pull.value, 4),
            number(pull.pull, 1)
        )
    });
    parts.push(Part::List(pulled.collect()));
    parts
}

fn errors(study: &str, found: &Diagnosis) -> Vec<Part> {
    let falls = Fall::of_diagnosis(&found.ladder);
    let mut parts = Vec::new();
    if !falls.is_empty() {
        let title = format!("{study} – the error, step by step");
        parts.push(Part::Figure(ladder::figure(&title, &falls)));
    }
    parts.push(Part::Table(steps(&found.ladder)));
    parts
}

/// The error, step by step: the list `ladder` of a document.
pub fn steps(steps: &[LadderStep]) -> Table {
    Rows::of("/ladder", steps)
        .words("model", |row| step_words(&row.name))
        .words("channel", |row| row.channel.name().replace('_', " "))
        .number(["in_sample", "fitted", ""], Significant(3), |row| row.in_sample)
        .number(["left_out", "left out", ""], Significant(3), |row| row.left_out)
        .number(["held_out", "held out", ""], Significant(3), |row| row.held_out)
        .words("unit", |row| row.channel.unit())
        .number(
            ["chi_square_per_number", "χ² per number, all channels", ""],
            Significant(3),
            |row| row.chi_square_per_number,
        )
        .number(
            ["held_out_sigma", "held out, all channels", "σ"],
            Significant(3),
            |row| row.held_out_sigma,
        )
        .table()
}

fn missing(study: &str, found: &Diagnosis) -> Vec<Part> {
    let (Verdict::Novel, Some(field)) = (found.verdict, &found.novel.reconstruction) else {
        return Vec::new();
    };
    let mut parts = vec![Part::Figure(pictures::field(study, field))];
    for (index, profile) in field.field.iter().enumerate() {
        if let Some(condition) = &profile.condition {
            parts.push(Part::Subtitle(format!("in {condition}")));
        }
        let place = format!("/novel/field/{index}/points");
        let table = Rows::of(&place, &profile.points)
            .number(["r_over_length", "r/R", ""], After(2), |row| row.r_over_length)
            .number(["value", "value", ""], Significant(3), |row| row.value)
            .number(["standard_deviation", "σ", ""], Significant(2), |row| {
                row.standard_deviation
            })
            .words("unit", |_| field.unit.as_str());
        parts.push(Part::Table(table.folded(20, "Along the span").table()));
    }
    if let Some(Draft {
        what,
        effect,
        expression,
        ..
    }) = &found.novel.draft
    {
        parts.push(Part::Text(what.clone()));
        parts.push(match effect {
            Some(_) => Part::Text(
                "An effect of your own to start from (washout add missing --own FILE --to STUDY):"
                    .to_string(),
            ),
            None => Part::Text("Along the span (x = r/R):".to_string()),
        });
        parts.push(Part::Code(effect.as_ref().unwrap_or(expression).clone()));
    }
    parts
}

fn predictions(predictions: &[Prediction]) -> Vec<Part> {
    let table = Rows::of("/predictions", predictions)
        .words("case", |row| row.condition.as_str())
        .words("channel", |row| row.channel.name().replace('_', " "))
        .number(["r_mm", "r", "mm"], Significant(4), |row| row.r_mm)
        .number(["r_to_mm", "to", "mm"], Significant(4), |row| row.r_to_mm)
        .number(["measured", "measured", ""], Significant(4), |row| row.measured)
        .number(["calibrated", "calibrated", ""], Significant(4), |row| row.calibrated)
        .number(["explained", "explained", ""], Significant(4), |row| row.explained)
        .number(["standard_deviation", "σ of explained", ""], Significant(2), |row| {
            row.standard_deviation
        })
        .words("unit", |row| row.unit.as_str())
        .caption(
            "Explained: by the best of the known effects, or by the fitted cause without a name where the verdict is that the cause is \
             unknown.",
        );
    vec![Part::Table(table.folded(20, "Predictions").table())]
}

fn next(found: &Diagnosis) -> Vec<Part> {
    let Some(next) = &found.next_experiment else {
        return Vec::new();
    };
    let table = Rows::of("/next_experiment/candidates", &next.candidates)
        .words("experiment", |row| row.name.as_str())
        .number(
            ["separation_sigma", "sets the rivals apart by", "σ"],
            After(1),
            |row| row.separation_sigma,
        );
    vec![Part::Text(next.sentence.clone()), Part::Table(table.table())]
}

fn notes(found: &Diagnosis) -> Vec<Part> {
    let NoiseFound {
        numbers,
        scale,
        formulation,
        on_trust,
        outliers,
        ..
    } = &found.noise;
    let trust = if *on_trust { ", taken on trust" } else { "" };
    let basis = format!(
        "{numbers} numbers fitted; noise {} times as stated{trust}; error of the model's formulation {} % of what it predicts. {} effects \
         were tried.",
        significant(*scale, 3),
        significant(100.0 * formulation, 2),
        found.tried
    );
    let outliers = outliers.iter().map(|outlier| {
        format!(
            "{}, line {}: far from what all others tell; its σ was widened {} times.",
            outlier.condition,
            outlier.line,
            significant(outlier.widening, 2)
        )
    });
    let mut notes = found.notes.clone();
    if found.verdict == Verdict::Undecidable {
        notes.push("This campaign cannot tell: that is no proof that nothing is missing.".to_string());
    }
    vec![
        Part::Text(basis),
        Part::List(outliers.collect()),
        Part::Notes(notes),
    ]
}
