//! All explanations by one or two known effects, weighed by the linear model; families share their probability.

use crate::study::Forward;

use super::baseline::Baseline;
use super::data::Data;
use super::evidence::{Likelihood, LinearEvidence, of_one, of_two};
use super::prior::StrengthPrior;
use super::screening::{Directions, effect_of, is_one_sided, place_of};

/// Effects whose prior standard deviation moves the data by less than this, in standard deviations, explain nothing: if
/// they are missing, nothing detectable is.
const VISIBLE: f64 = 0.3;

/// Effects that are the same physics at another place or by another formula.
#[derive(Debug, Clone, PartialEq)]
pub struct Family {
    /// Its name.
    pub name: String,
    /// Positions of its members among the missing effects.
    pub members: Vec<usize>,
    /// Whether its members are places, so that something between two neighbours is one of it too.
    pub is_located: bool,
}

/// Families of the missing effects that these data can see, in the order of their first members; `lengths` of their
/// directions per prior standard deviation.
pub fn families(forward: &dyn Forward, data: &Data, lengths: &[f64]) -> Vec<Family> {
    let mut found: Vec<Family> = Vec::new();
    for (k, &i) in data.missing.iter().enumerate() {
        if lengths[k] < VISIBLE {
            continue;
        }
        let Some((_, name, _, _)) = effect_of(&forward.unknowns()[i]) else {
            continue;
        };
        match found.iter_mut().find(|family| family.name == name) {
            Some(family) => family.members.push(k),
            None => found.push(Family {
                name: name.to_string(),
                members: vec![k],
                is_located: false,
            }),
        }
    }
    for family in &mut found {
        let all_one_sided = family
            .members
            .iter()
            .all(|&k| is_one_sided(&forward.unknowns()[data.missing[k]]));
        // members that move to their place need none between two
        let all_fixed = family
            .members
            .iter()
            .all(|&k| place_of(forward.unknowns(), data.missing[k]).is_none());
        family.is_located = all_one_sided && all_fixed && family.members.len() > 2;
    }
    found
}

/// An explanation by the linear model.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// Positions of the effects among the missing.
    pub members: Vec<usize>,
    /// Its families: one (also for something between two places) or two.
    pub families: Vec<usize>,
    /// Logarithm of its prior probability.
    pub ln_prior: f64,
    /// Evidence against no effect.
    pub linear: LinearEvidence,
}

impl Trial {
    /// Logarithm of prior times evidence.
    pub fn ln_weight(&self) -> f64 {
        self.ln_prior + self.linear.ln_gain
    }
}

/// What the linear model needs to weigh effects.
pub struct Scales<'a> {
    /// The model.
    pub forward: &'a dyn Forward,
    /// What is missing from it.
    pub data: &'a Data,
    /// Directions of the missing effects.
    pub directions: &'a Directions,
    /// How the noise enters.
    pub likelihood: Likelihood,
    /// Misfit without any of them.
    pub q0: f64,
}

impl<'a> Scales<'a> {
    /// About the fit of a model.
    pub fn of(baseline: &'a Baseline) -> Scales<'a> {
        Scales {
            forward: baseline.forward,
            data: &baseline.data,
            directions: &baseline.directions,
            likelihood: baseline.likelihood,
            q0: baseline.whitened.q(),
        }
    }

    /// Evidence of one effect.
    pub fn one(&self, k: usize) -> LinearEvidence {
        let directions = self.directions;
        let dot = directions.scores[k] * directions.lengths[k];
        let prior = StrengthPrior::of(&self.forward.unknowns()[self.data.missing[k]]);
        of_one(self.likelihood, self.q0, directions.gram[(k, k)], dot, prior)
    }

    /// Evidence of two effects.
    pub fn two(&self, a: usize, b: usize) -> LinearEvidence {
        let directions = self.directions;
        let priors = [a, b].map(|k| StrengthPrior::of(&self.forward.unknowns()[self.data.missing[k]]));
        let dot = [a, b].map(|k| directions.scores[k] * directions.lengths[k]);
        let gram = [
            directions.gram[(a, a)],
            directions.gram[(a, b)],
            directions.gram[(b, b)],
        ];
        of_two(self.likelihood, self.q0, gram, dot, priors)
    }

    /// Every explanation by one family, `prior` shared evenly among families, and within a family among its members;
    /// half of a located family's share goes to places between two neighbours.
    pub fn singles(&self, families: &[Family], prior: f64) -> Vec<Trial> {
        let mut trials = Vec::new();
        for (index, family) in families.iter().enumerate() {
            let share = prior / families.len() as f64;
            let at_members = if family.is_located { 0.5 } else { 1.0 };
            for &k in &family.members {
                trials.push(Trial {
                    members: vec![k],
                    families: vec![index],
                    ln_prior: (share * at_members / family.members.len() as f64).ln(),
                    linear: self.one(k),
                });
            }
            if !family.is_located {
                continue;
            }
            for neighbours in family.members.windows(2) {
                trials.push(Trial {
                    members: neighbours.to_vec(),
                    families: vec![index],
                    ln_prior: (share * 0.5 / (family.members.len() - 1) as f64).ln(),
                    linear: self.two(neighbours[0], neighbours[1]),
                });
            }
        }
        trials
    }

    /// Every explanation by members of two families, `prior` shared evenly among pairs of families.
    pub fn pairs(&self, families: &[Family], prior: f64) -> Vec<Trial> {
        let count = (families.len() * families.len().saturating_sub(1) / 2).max(1) as f64;
        let mut trials = Vec::new();
        for (first, a) in families.iter().enumerate() {
            for (second, b) in families.iter().enumerate().skip(first + 1) {
                let each = prior / count / (a.members.len() * b.members.len()) as f64;
                for &i in &a.members {
                    for &j in &b.members {
                        trials.push(Trial {
                            members: vec![i, j],
                            families: vec![first, second],
                            ln_prior: each.ln(),
                            linear: self.two(i, j),
                        });
                    }
                }
            }
        }
        trials
    }
}

/// The `count` heaviest of `trials`, at most `per_group` of each group of families; ties in the order given.
pub fn heaviest(trials: &[Trial], count: usize, per_group: usize) -> Vec<usize> {
    let mut order: Vec<usize> = (0..trials.len()).collect();
    order.sort_by(|&a, &b| {
        trials[b]
            .ln_weight()
            .total_cmp(&trials[a].ln_weight())
            .then(a.cmp(&b))
    });
    let mut taken: Vec<usize> = Vec::new();
    for index in order {
        let same = taken
            .iter()
            .filter(|&&other| trials[other].families == trials[index].families)
            .count();
        if same < per_group {
            taken.push(index);
        }
        if taken.len() == count {
            break;
        }
    }
    taken
}
