//! Which explanations are in the running, and their fits in the whole model.

use crate::progress::Progress;
use crate::study::WarmStart;

use super::baseline::Baseline;
use super::bump::{Bump, Bumps, bumps};
use super::error::DiagnoseError;
use super::evidence::ln_sum;
use super::library::Trial;
use super::posterior::{Belief, Case, Weight, beliefs};
use super::refit::{Explanation, Refits};
use super::strengths::name;

/// Hypotheses that are fitted anew, the most probable first.
const FITTED: usize = 4;
/// Probability from which on a hypothesis is fitted anew.
const IN_THE_RUNNING: f64 = 0.03;
/// Probability of nothing from which on only the most probable explanation is fitted anew: nothing has to be told apart.
const NOTHING: f64 = 0.5;
/// Probability of a cause without a name from which on one is fitted.
const MAY_BE_UNKNOWN: f64 = 0.2;

/// Everything that was weighed.
pub struct Judgement {
    /// Explanations: single effects, then pairs.
    pub trials: Vec<Trial>,
    /// Those fitted anew, with the index of their trial.
    pub refits: Vec<(usize, Explanation)>,
    /// Trials whose fit settled nowhere.
    pub unsettled: Vec<usize>,
    /// Causes without a name that were fitted.
    pub bumps: Bumps,
    /// Hypotheses with probabilities, most probable first.
    pub beliefs: Vec<Belief>,
    /// Of each missing effect the first at whatever place: the same number, the same effect.
    effect: Vec<usize>,
}

/// Explanations by the same effects, at whatever places.
#[derive(Debug, Clone, PartialEq)]
pub struct OfEffects {
    /// The effects, by the first of each among the missing.
    pub effects: Vec<usize>,
    /// ln of prior times evidence of all places.
    pub ln_weight: f64,
    /// The trial that has most of it.
    pub heaviest: usize,
}

impl Judgement {
    /// Probability of a case.
    pub fn probability(&self, case: &Case) -> f64 {
        let own = self.beliefs.iter().find(|belief| belief.case == *case);
        own.map_or(0.0, |belief| belief.probability)
    }

    /// Whether something is missing, by a cause without a name sooner than by any other.
    pub fn is_unknown(&self) -> bool {
        self.beliefs
            .first()
            .is_some_and(|first| first.case == Case::Unknown)
    }

    /// The cause without a name that does best.
    pub fn best_bump(&self) -> Option<&Bump> {
        let fitted = self.bumps.fitted.iter();
        fitted.max_by(|a, b| a.ln_evidence.total_cmp(&b.ln_evidence))
    }

    /// Explanations by just these families, which stand in ascending order, those of the same effects together, the most probable first.
    pub fn by_effects(&self, families: &[usize]) -> Vec<OfEffects> {
        let mut found: Vec<OfEffects> = Vec::new();
        for (index, trial) in self.trials.iter().enumerate() {
            if trial.families != families {
                continue;
            }
            let mut effects: Vec<usize> = trial.members.iter().map(|&k| self.effect[k]).collect();
            effects.sort_unstable();
            effects.dedup();
            match found.iter_mut().find(|own| own.effects == effects) {
                Some(own) => {
                    if trial.ln_weight >= self.trials[own.heaviest].ln_weight {
                        own.heaviest = index;
                    }
                    own.ln_weight = ln_sum([own.ln_weight, trial.ln_weight].into_iter());
                }
                None => found.push(OfEffects {
                    effects,
                    ln_weight: trial.ln_weight,
                    heaviest: index,
                }),
            }
        }
        found.sort_by(|a, b| b.ln_weight.total_cmp(&a.ln_weight));
        found
    }

    /// The heaviest explanation by just these families, which stand in ascending order: where the most probable effects of them sit best.
    pub fn heaviest(&self, families: &[usize]) -> Option<usize> {
        self.by_effects(families).first().map(|own| own.heaviest)
    }

    /// The same with its fit, if there is one; of several places of an effect, one that was fitted.
    pub fn best_of(&self, families: &[usize]) -> Option<(usize, Option<&Explanation>)> {
        let mut families = families.to_vec();
        families.sort_unstable();
        let fitted = self
            .refits
            .iter()
            .find(|(index, _)| self.trials[*index].families == families);
        match fitted {
            Some((index, explanation)) => Some((*index, Some(explanation))),
            None => self.heaviest(&families).map(|index| (index, None)),
        }
    }

    /// The most probable explanation by known effects.
    pub fn best_known(&self) -> Option<&Belief> {
        self.beliefs
            .iter()
            .find(|belief| !belief.case.families().is_empty())
    }

    /// The families of the most probable explanation of the set that stands in place of the first, instead of beside it.
    fn rival_of_first(&self) -> Option<Vec<usize>> {
        let first = self.best_known()?.case.families();
        let known = self.beliefs.iter().filter(|belief| belief.in_set);
        let mut families = known.map(|belief| belief.case.families());
        families.find(|own| !own.is_empty() && !first.iter().all(|family| own.contains(family)))
    }

    /// Distance between the best explanations by two families, in standard deviations: how far the data tell them apart at the strengths
    /// found.
    pub fn distance(&self, baseline: &Baseline, a: usize, b: usize) -> f64 {
        let best = |family: usize| self.heaviest(&[family]).map(|index| &self.trials[index]);
        let (Some(a), Some(b)) = (best(a), best(b)) else {
            return f64::INFINITY;
        };
        let change = |trial: &Trial| baseline.change(trial.members[0], trial.best[0]);
        let apart = change(a) - change(b);
        let apart = nalgebra::DMatrix::from_column_slice(apart.len(), 1, apart.as_slice());
        baseline.whitened.directions_of_rows(&apart).norm()
    }
}

/// Gives every hypothesis its probability and fits those in the running.
///
/// # Errors
/// If the user asked to stop.
pub fn judge(baseline: &Baseline, progress: &Progress) -> Result<Judgement, DiagnoseError> {
    let weighing = &baseline.weighing;
    let trials: Vec<Trial> = weighing.singles.iter().chain(&weighing.pairs).cloned().collect();
    let mut weights = vec![
        Weight {
            case: Case::Nothing,
            ln_weight: weighing.ln_nothing,
        },
        Weight {
            case: Case::Unknown,
            ln_weight: weighing.ln_unknown,
        },
    ];
    weights.extend(trials.iter().map(|trial| Weight {
        case: match trial.families[..] {
            [first, second] => Case::Two(first, second),
            _ => Case::One(trial.families[0]),
        },
        ln_weight: trial.ln_weight,
    }));
    let mut judgement = Judgement {
        trials,
        refits: Vec::new(),
        unsettled: Vec::new(),
        bumps: Bumps::default(),
        effect: first_of_each(baseline),
        beliefs: beliefs(&weights, baseline.settings.tempering),
    };
    let warm_start = baseline.warm_start.as_ref().map(WarmStart::for_trials);
    let refits = Refits::of(baseline, warm_start.as_ref());
    refit(&mut judgement, baseline, &refits, progress)?;
    if judgement.probability(&Case::Unknown) > MAY_BE_UNKNOWN {
        judgement.bumps = bumps(baseline, &refits, progress)?;
    }
    Ok(judgement)
}

/// Of each missing effect the first that has its name.
fn first_of_each(baseline: &Baseline) -> Vec<usize> {
    let count = baseline.data.missing.len();
    let names: Vec<String> = (0..count).map(|k| name(baseline, k)).collect();
    let first = |own: &String| names.iter().position(|other| other == own);
    names.iter().filter_map(first).collect()
}

fn refit(
    judgement: &mut Judgement,
    baseline: &Baseline,
    refits: &Refits,
    progress: &Progress,
) -> Result<(), DiagnoseError> {
    let known = judgement
        .beliefs
        .iter()
        .filter(|belief| !belief.case.families().is_empty());
    let mut chosen: Vec<Vec<usize>> = Vec::new();
    let fitted = match judgement.probability(&Case::Nothing) >= NOTHING {
        true => 1,
        false => FITTED,
    };
    for (rank, belief) in known.enumerate().take(fitted) {
        if rank > 0 && belief.probability < IN_THE_RUNNING {
            break;
        }
        chosen.push(belief.case.families());
    }
    // what to measure next is asked of the first and of what the set has in its place
    if fitted > 1 {
        let rival = judgement
            .rival_of_first()
            .filter(|families| !chosen.contains(families));
        chosen.extend(rival);
    }
    // the better half of a pair shows what the other adds
    let mut halves: Vec<Vec<usize>> = Vec::new();
    for pair in chosen.iter().filter(|families| families.len() == 2).take(1) {
        let weight = |family: &usize| {
            judgement
                .heaviest(&[*family])
                .map(|index| judgement.trials[index].ln_weight)
        };
        let better = pair.iter().max_by(|a, b| {
            weight(a)
                .unwrap_or(f64::MIN)
                .total_cmp(&weight(b).unwrap_or(f64::MIN))
        });
        halves.extend(better.map(|family| vec![*family]));
    }
    chosen.extend(
        halves
            .into_iter()
            .filter(|half| !chosen.contains(half))
            .collect::<Vec<_>>(),
    );
    let count = chosen.len();
    for (done, families) in chosen.into_iter().enumerate() {
        progress.check()?;
        progress.say(format_args!(
            "fit {} of {count} with what may be missing",
            done + 1
        ));
        let Some(index) = judgement.heaviest(&families) else {
            continue;
        };
        match refits.refit(baseline, &judgement.trials[index])? {
            Some(found) => judgement.refits.push((index, found)),
            None => judgement.unsettled.push(index),
        }
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    /// Effect 0 at two places (missing 0 and 1), effect 2 of the same family at one, effect 3 of another.
    fn judgement() -> Judgement {
        let trial = |members: &[usize], families: &[usize], weight: f64| Trial {
            members: members.to_vec(),
            families: families.to_vec(),
            ln_prior: 0.0,
            ln_weight: weight.ln(),
            best: vec![1.0; members.len()],
            strength: vec![1.0; members.len()],
            error: vec![0.1; members.len()],
            size: None,
        };
        Judgement {
            trials: vec![
                trial(&[0], &[0], 0.2),
                trial(&[1], &[0], 0.15),
                trial(&[2], &[0], 0.3),
                trial(&[0, 1], &[0], 0.05),
                trial(&[3], &[1], 0.3),
            ],
            refits: Vec::new(),
            unsettled: Vec::new(),
            bumps: Bumps::default(),
            beliefs: Vec::new(),
            effect: vec![0, 0, 2, 3],
        }
    }

    #[test]
    fn of_a_family_the_effect_is_taken_that_is_most_probable_at_whatever_place_where_it_sits_best() {
        let judgement = judgement();
        let all = judgement.by_effects(&[0]);
        assert_eq!(
            all.iter().map(|own| own.effects.clone()).collect::<Vec<_>>(),
            [[0], [2]]
        );
        let weights: Vec<f64> = all.iter().map(|own| own.ln_weight.exp()).collect();
        assert!(
            (weights[0] - 0.4).abs() < 1e-12 && (weights[1] - 0.3).abs() < 1e-12,
            "{weights:?}"
        );
        assert_eq!(
            judgement.heaviest(&[0]),
            Some(0),
            "not 2, whose one place has more than any of the other's"
        );
        assert_eq!(judgement.heaviest(&[1]), Some(4));
        assert_eq!(judgement.heaviest(&[0, 1]), None);
    }
}
