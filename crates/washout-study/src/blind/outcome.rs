//! One case, and whether what was said of it is true.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::baselines::Simpler;
use super::distance::Distance;
use super::followed::Followed;
use super::kind::Kind;
use super::truth::{is_truth, names_in_set, same, set_size};
use crate::diagnose::hypothesis::Hypothesis;
use crate::diagnose::posterior::SEPARATE;
use crate::diagnose::{Diagnosis, Verdict};
use crate::synthesize::{Acted, Answer};

/// One case with what was said of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Outcome {
    /// Its kind.
    pub kind: Kind,
    /// Its seed.
    pub seed: u64,
    /// What was hidden.
    pub truth: Vec<Acted>,
    /// Distance of the model with each hidden effect from that without, sigma, what it can absorb left out.
    pub detectability: Vec<f64>,
    /// Whether the nearest effect of another family is at least 3 sigma away from each.
    pub is_separable: bool,
    /// Background error of the wing that was measured.
    pub background: f64,
    /// The verdict.
    pub verdict: Verdict,
    /// The sentence.
    pub sentence: String,
    /// Families of the most probable hypothesis.
    pub named: Vec<String>,
    /// Its probability.
    pub probability: f64,
    /// Whether the truth is in the 95 % set.
    pub in_set: bool,
    /// Hypotheses in the set.
    pub set_size: usize,
    /// Different names among these: an effect with another that may or may not be there counts as itself.
    pub names_in_set: usize,
    /// Misfit over the numbers: Q less the numbers, in sigma.
    pub misfit_sigma: f64,
    /// Relative error of the strength, and its distance in standard errors, where the formula was the same.
    pub strength_error: Option<[f64; 2]>,
    /// Root mean square error of all held-out numbers, sigma: calibrated, with the best explanation, of the noise.
    pub held_out: Option<[f64; 3]>,
    /// What simpler methods name.
    pub simpler: Simpler,
    /// What came of the measurement that it asked for; only of twins, and if it asked for one.
    pub followed: Option<Followed>,
    /// Time of the diagnosis, s.
    pub seconds: f64,
    /// How often the case was drawn anew, because a wing had no equilibrium with what was hidden, or it was too faint.
    #[serde(default)]
    pub redrawn: u64,
}

/// A case that came to no answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Failed {
    /// Its kind.
    pub kind: Kind,
    /// Its seed.
    pub seed: u64,
    /// Why.
    pub failed: String,
}

impl Outcome {
    /// Whether something was said to be missing.
    pub fn is_alarm(&self) -> bool {
        !matches!(self.verdict, Verdict::Nothing | Verdict::Undecidable)
    }

    /// Families of the truth; none for a cause that no effect is.
    pub fn families(&self) -> Vec<&str> {
        match self.kind {
            Kind::Novel => Vec::new(),
            _ => self.truth.iter().map(|acted| acted.family.as_str()).collect(),
        }
    }

    /// Whether the most probable hypothesis is the truth.
    pub fn is_right(&self) -> bool {
        match self.kind {
            Kind::Novel => self.verdict == Verdict::Novel,
            _ if self.kind.is_null() => !self.is_alarm(),
            _ => self.verdict != Verdict::Novel && same(&self.named, &self.families()),
        }
    }

    /// Whether one of two hidden effects is in the most probable hypothesis.
    pub fn has_one_right(&self) -> bool {
        self.verdict != Verdict::Novel
            && self
                .named
                .iter()
                .any(|name| self.families().contains(&name.as_str()))
    }
}

/// Compares what was said with the answer.
pub fn judge(
    (kind, seed): (Kind, u64),
    (answer, distances): (&Answer, &[Distance]),
    said: &Diagnosis,
    (simpler, followed): (Simpler, Option<Followed>),
    (seconds, redrawn): (f64, u64),
) -> Outcome {
    let detectability = distances.iter().map(|distance| distance.seen).collect();
    let is_separable = distances.iter().all(|distance| distance.apart >= SEPARATE);
    let mut set = said.hypotheses.iter().filter(|hypothesis| hypothesis.in_set);
    let first = said.hypotheses.first();
    let steps = |name: &str| {
        said.ladder
            .iter()
            .find(|step| step.name == name)
            .and_then(|step| step.held_out_sigma)
    };
    let explained = said.ladder.iter().rev().find(|step| step.name.starts_with('+'));
    let held_out = steps("calibrated")
        .zip(explained.and_then(|step| step.held_out_sigma))
        .zip(steps("noise"))
        .map(|((before, after), noise)| [before, after, noise]);
    let numbers = said.noise.numbers as f64;
    Outcome {
        kind,
        seed,
        truth: answer.acted.clone(),
        detectability,
        is_separable,
        background: answer.recipe.made.background,
        verdict: said.verdict,
        sentence: said.sentence.clone(),
        named: first.map_or(Vec::new(), |first| first.families.clone()),
        probability: first.map_or(0.0, |first| first.probability),
        in_set: (kind == Kind::Novel && said.verdict == Verdict::Novel)
            || set.any(|hypothesis| is_truth(kind, answer, hypothesis)),
        set_size: set_size(said),
        names_in_set: names_in_set(said),
        misfit_sigma: (said.misfit.q - numbers).max(0.0).sqrt(),
        strength_error: strength_error(answer, first),
        held_out,
        simpler,
        followed,
        seconds,
        redrawn,
    }
}

fn strength_error(answer: &Answer, first: Option<&Hypothesis>) -> Option<[f64; 2]> {
    let [acted] = &answer.acted[..] else { return None };
    let found = first?
        .strengths
        .iter()
        .find(|strength| strength.effect == acted.asked)?;
    // a rival formula has a strength of its own, and what is all or none no error
    let is_comparable =
        (acted.formula == acted.asked || acted.formula.contains('(')) && found.standard_error > 0.0;
    let off = (found.value - acted.strength).abs();
    is_comparable.then(|| [off / acted.strength.abs(), off / found.standard_error])
}
