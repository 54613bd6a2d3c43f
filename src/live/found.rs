//! What a diagnosis says, as the page reads it, and what its hypotheses would do.

use serde::Serialize;

use crate::diagnose::StudyDiagnosis;
use crate::diagnose::fields::Law;
use crate::diagnose::hypothesis::Hypothesis;
use crate::diagnose::next::Candidate;
use crate::diagnose::strengths::{PlaceFound, Strength};
use crate::diagnose::verdict::{Diagnosis, Verdict};
use crate::effects::named;
use crate::input::study::LoadedStudy;
use crate::page::text::significant;
use crate::study::{Campaign, Forward, Unknown, UnknownKind};
use crate::wing::{SolvedWing, WingModel};

use super::refusal::Refusal;
use super::shape::{Curve, curve};
use super::values::Addition;

/// A diagnosis, and the campaign that it was made by.
pub struct Found {
    /// What it says.
    pub answer: Answer,
    diagnosis: Diagnosis,
    campaign: Campaign,
}

/// What a diagnosis says.
#[derive(Debug, Serialize)]
pub struct Answer {
    sentence: String,
    verdict: Verdict,
    tried: usize,
    of: usize,
    hypotheses: Vec<Told>,
    unknown_cause: Option<Unnamed>,
    probability_unknown: f64,
    probability_nothing: f64,
    next: Option<Next>,
    notes: Vec<String>,
}

#[derive(Debug, Serialize)]
struct Told {
    effects: Vec<String>,
    title: String,
    sentence: String,
    probability: f64,
    in_set: bool,
    strengths: Vec<StrengthTold>,
    curve: Option<Curve>,
    can_add: bool,
}

#[derive(Debug, Serialize)]
struct StrengthTold {
    effect: String,
    parameter: &'static str,
    /// What the number means.
    meaning: &'static str,
    value: f64,
    standard_error: f64,
    unit: String,
    place: Option<PlaceFound>,
}

/// A missing moment along the span.
#[derive(Debug, Serialize)]
struct Unnamed {
    r_mm: Vec<f64>,
    moment_mnm_per_m: Vec<f64>,
    low: Vec<f64>,
    high: Vec<f64>,
}

/// What to measure next.
#[derive(Debug, Serialize)]
struct Next {
    words: String,
    /// Where the hypotheses part: the best candidates, and how far apart they are expected there.
    candidates: Vec<Experiment>,
}

/// An experiment that could be made.
#[derive(Debug, Serialize)]
struct Experiment {
    #[serde(flatten)]
    candidate: Candidate,
    /// The wing and what is set on it, of one that the study lists; the name of any other says what to do.
    conditions: Option<String>,
}

/// Candidates that are shown.
const SHOWN: usize = 5;

impl Found {
    /// From a diagnosis of a study; `case`: that which is shown.
    pub fn new(found: StudyDiagnosis, study: &LoadedStudy, case: usize) -> Found {
        let StudyDiagnosis {
            campaign, diagnosis, ..
        } = found;
        let length_m = campaign
            .conditions()
            .get(case)
            .map_or(0.0, |condition| condition.length_m);
        let unknown_cause = unnamed(&diagnosis, length_m);
        let next = diagnosis.next_experiment.as_ref();
        let answer = Answer {
            sentence: diagnosis.sentence.clone(),
            verdict: diagnosis.verdict,
            tried: diagnosis.tried,
            of: crate::effects::all().count(),
            hypotheses: diagnosis.hypotheses.iter().map(told).collect(),
            unknown_cause,
            probability_unknown: diagnosis.novel.probability,
            probability_nothing: diagnosis.p_nothing,
            next: next.map(|next| Next {
                words: next.sentence.clone(),
                candidates: (next.candidates.iter().take(SHOWN))
                    .map(|candidate| Experiment {
                        candidate: candidate.clone(),
                        conditions: conditions(study, &candidate.name),
                    })
                    .collect(),
            }),
            notes: diagnosis.notes.clone(),
        };
        Found {
            answer,
            diagnosis,
            campaign,
        }
    }

    /// The twist of a case with a hypothesis, all else as stated; none if that is no known effect, or has no solution.
    pub fn curve(&self, hypothesis: usize, case: usize) -> Option<Curve> {
        let hypothesis = self.diagnosis.hypotheses.get(hypothesis)?;
        if hypothesis.strengths.is_empty() || case >= self.campaign.cases().len() {
            return None;
        }
        let mut at = self.campaign.start();
        let unknowns = self.campaign.unknowns();
        let position = |is_it: &dyn Fn(&Unknown) -> bool| unknowns.iter().position(is_it);
        for strength in &hypothesis.strengths {
            at[position(&|unknown| unknown.name == strength.unknown)?] = strength.value;
            if let Some(place) = &strength.place {
                let is_place = |unknown: &Unknown| matches!(&unknown.kind, UnknownKind::Place { of, .. } if *of == strength.unknown);
                at[position(&is_place)?] = place.value;
            }
        }
        let solved = self.campaign.solved_at(case, &at).ok()?;
        let found = &solved.at;
        let model = WingModel::on_mesh(found.design.clone(), found.solution.mesh.clone()).ok()?;
        let wing = SolvedWing::new(model, found.solution.clone());
        curve(&hypothesis.effects.join(" + "), &wing).ok()
    }

    /// What joins the model with a hypothesis, surest first.
    ///
    /// # Errors
    /// If there is no such hypothesis, or none of its causes has a name.
    pub fn additions(&self, hypothesis: usize) -> Result<Vec<Addition>, Refusal> {
        let found = self.diagnosis.hypotheses.get(hypothesis);
        let found = found.ok_or_else(|| Refusal::new(format!("there is no hypothesis {hypothesis}")))?;
        if !can_add(found) {
            return Err(Refusal::new("this is no known effect, so it cannot be added"));
        }
        let mut strengths: Vec<&Strength> = found.strengths.iter().collect();
        // what is surest first: a fit of the other alone might end elsewhere
        let in_errors = |own: &Strength| own.value.abs() / own.standard_error;
        strengths.sort_by(|a, b| in_errors(b).total_cmp(&in_errors(a)));
        Ok(strengths.into_iter().map(addition).collect())
    }
}

/// The wing of a listed experiment and what is set on it, the mesh left out.
fn conditions(study: &LoadedStudy, name: &str) -> Option<String> {
    let own = study.experiments.iter().find(|own| own.name == name)?;
    let sets = own.sets.iter().filter(|set| !set.starts_with("mesh."));
    let sets: Vec<&str> = sets.map(String::as_str).collect();
    Some(format!("{}: {}", own.loaded.design.name, sets.join(", ")))
}

fn addition(strength: &Strength) -> Addition {
    let place = strength.place.as_ref();
    let own = place.map(|place| format!("{}={}", place.parameter, significant(place.value, 3)));
    let others = place.iter().flat_map(|place| &place.numbers);
    Addition {
        effect: strength.effect.clone(),
        strength: strength.value,
        numbers: own
            .into_iter()
            .chain(others.map(|(name, value)| format!("{name}={value}")))
            .collect(),
        wing: place.and_then(|place| place.wing.clone()),
    }
}

fn can_add(hypothesis: &Hypothesis) -> bool {
    !hypothesis.strengths.is_empty() && hypothesis.effects.iter().all(|effect| named(effect).is_some())
}

fn told(hypothesis: &Hypothesis) -> Told {
    let title = match hypothesis.effects.as_slice() {
        [] => "nothing is missing".to_string(),
        effects => effects.join(" + ").replace('-', " "),
    };
    let cards = hypothesis.effects.iter().filter_map(|effect| named(effect));
    let sentences: Vec<&str> = cards.map(|effect| effect.card().summary).collect();
    let strengths = hypothesis.strengths.iter();
    Told {
        effects: hypothesis.effects.clone(),
        title,
        sentence: match sentences.is_empty() {
            true if hypothesis.effects.is_empty() => "The model explains what was measured.".to_string(),
            true => "Something is missing that no known effect is.".to_string(),
            false => sentences.join(" "),
        },
        probability: hypothesis.probability,
        in_set: hypothesis.in_set,
        strengths: strengths
            .map(|strength| StrengthTold {
                effect: strength.effect.clone(),
                parameter: "strength",
                meaning: named(&strength.effect).map_or("", |effect| effect.card().parameters[0].meaning),
                value: strength.value,
                standard_error: strength.standard_error,
                unit: strength.unit.clone(),
                place: strength.place.clone(),
            })
            .collect(),
        curve: None,
        can_add: can_add(hypothesis),
    }
}

/// The missing moment, if it is a load along the span.
fn unnamed(diagnosis: &Diagnosis, length_m: f64) -> Option<Unnamed> {
    let found = diagnosis.novel.reconstruction.as_ref()?;
    let is_load = matches!(found.law, Law::Load { .. } | Law::Onset { .. } | Law::Free);
    let points = found
        .field
        .first()
        .filter(|_| is_load)
        .map(|field| &field.points)?;
    // N·m/m is a thousand mN·m/m
    let of = |value: &dyn Fn(&crate::diagnose::novel::FieldPoint) -> f64| {
        points.iter().map(|point| 1e3 * value(point)).collect()
    };
    Some(Unnamed {
        r_mm: of(&|point| point.r_over_length * length_m),
        moment_mnm_per_m: of(&|point| point.value),
        low: of(&|point| point.value - 2.0 * point.standard_deviation),
        high: of(&|point| point.value + 2.0 * point.standard_deviation),
    })
}
