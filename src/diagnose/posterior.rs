//! From evidence to probabilities: hypotheses, the 95 % set, and what cannot be told apart.

use super::evidence::ln_sum;

/// Probability that the set of hypotheses is to hold.
const CREDIBLE: f64 = 0.95;
/// Distance in standard deviations from which on two explanations are told apart.
pub const SEPARATE: f64 = 3.0;

/// Distance below which no statistic can split two explanations.
pub const TWINS: f64 = 1.0;
/// Odds that priors may make between twins: plausible sizes are known to a factor of a few at best.
const AMONG_TWINS: f64 = 3.0;

/// What may be the case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Case {
    /// Nothing is missing.
    Nothing,
    /// One family of effects.
    One(usize),
    /// Two families.
    Two(usize, usize),
    /// None that is known.
    Novel,
}

/// A hypothesis with its logarithm of prior times evidence.
#[derive(Debug, Clone, PartialEq)]
pub struct Weight {
    /// What may be the case.
    pub case: Case,
    /// Logarithm of prior times evidence.
    pub ln_weight: f64,
    /// Logarithm of the likelihood of its best fit alone, prices of priors included.
    pub ln_likelihood: f64,
    /// Families that may be missing besides, with strengths that the data would show; their parts of the weight (logarithms).
    pub seconds: Vec<(usize, f64)>,
}

/// A hypothesis with its probability.
#[derive(Debug, Clone, PartialEq)]
pub struct Belief {
    /// What may be the case.
    pub case: Case,
    /// Its probability.
    pub probability: f64,
    /// Whether it belongs to the smallest set that holds the truth with 95 %.
    pub in_set: bool,
    /// Families that may be missing besides, with strengths that the data would show; their parts of the probability.
    pub seconds: Vec<(usize, f64)>,
    /// Whether the data show all of it; a second family may be one that they merely allow.
    pub is_shown: bool,
}

/// Hypotheses, most probable first. Evidence is raised to the power `tempering`; the priors stand in `ln_weight` already.
pub fn beliefs(weights: &[Weight], tempering: f64) -> Vec<Belief> {
    let total = ln_sum(weights.iter().map(|weight| tempering * weight.ln_weight));
    let mut beliefs: Vec<Belief> = weights
        .iter()
        .map(|weight| Belief {
            case: weight.case.clone(),
            probability: (tempering * weight.ln_weight - total).exp(),
            in_set: false,
            seconds: seconds(weight),
            is_shown: true,
        })
        .collect();
    choose(&mut beliefs);
    beliefs
}

/// The same with every second family that the data merely allow as a hypothesis of its own: these exclude one another.
pub fn unfolded(beliefs: &[Belief]) -> Vec<Belief> {
    let mut all = Vec::new();
    for belief in beliefs {
        let mut alone = 1.0;
        for &(second, share) in &belief.seconds {
            let Case::One(first) = belief.case else { continue };
            alone -= share;
            all.push(Belief {
                case: Case::Two(first, second),
                probability: belief.probability * share,
                in_set: false,
                seconds: Vec::new(),
                is_shown: false,
            });
        }
        all.push(Belief {
            probability: belief.probability * alone.max(0.0),
            seconds: Vec::new(),
            ..belief.clone()
        });
    }
    choose(&mut all);
    all
}

/// Gives "none that is known" what the others lose where the best of them is refuted: what it leaves arises by chance with probability
/// `p`. By convention they lose the most that p allows: against any other explanation they keep at least the factor −e p ln p (T. Sellke,
/// M. J. Bayarri, J. O. Berger, Calibration of p values for testing precise null hypotheses, The American Statistician 55 (2001) 62), and
/// that is what they are left with. `prior`: of none that is known. Where that has more already, nothing changes.
pub fn refuted(beliefs: &mut [Belief], prior: f64, p: f64) {
    let p = p.clamp(f64::MIN_POSITIVE, (-1.0_f64).exp());
    let factor = -std::f64::consts::E * p * p.ln();
    let taken = prior / (prior + (1.0 - prior) * factor);
    let Some(own) = beliefs.iter().find(|belief| belief.case == Case::Novel) else {
        return;
    };
    let before = own.probability;
    if before >= taken {
        return;
    }
    for belief in beliefs.iter_mut() {
        if belief.case == Case::Novel {
            belief.probability = taken;
        } else {
            belief.probability *= (1.0 - taken) / (1.0 - before);
        }
    }
    choose(beliefs);
}

/// Sorts hypotheses, most probable first, and marks the smallest set that holds the truth with 95 %.
fn choose(beliefs: &mut [Belief]) {
    beliefs.sort_by(|a, b| b.probability.total_cmp(&a.probability));
    let mut sum = 0.0;
    for belief in beliefs {
        belief.in_set = sum < CREDIBLE;
        sum += belief.probability;
    }
}

/// Parts of the probability of a hypothesis that come with a second family, largest first.
fn seconds(weight: &Weight) -> Vec<(usize, f64)> {
    let mut parts: Vec<(usize, f64)> = weight
        .seconds
        .iter()
        .map(|&(family, part)| (family, (part - weight.ln_weight).exp()))
        .collect();
    parts.sort_by(|a, b| b.1.total_cmp(&a.1));
    parts
}

/// Adds the weight of a pair to that of the one of it that the data show: the other may be there or not.
pub fn fold(weights: &mut [Weight], into: usize, ln_weight: f64) {
    weights[into].ln_weight = ln_sum([weights[into].ln_weight, ln_weight].into_iter());
}

/// Shares the probability of explanations that the data cannot tell apart (`class`: positions in `weights`) by how
/// well they fit, not by how wide their priors are: a plausible scale is known to a factor of a few at best. Those of the class that are
/// `twins` of its first get a third of the share of that at least.
pub fn level_class(weights: &mut [Weight], class: &[usize], twins: &[usize]) {
    if class.len() < 2 {
        return;
    }
    let total = ln_sum(class.iter().map(|&k| weights[k].ln_weight));
    let level = |k: usize| 0.5 * (weights[k].ln_weight + weights[k].ln_likelihood);
    let least = level(class[0]) - AMONG_TWINS.ln();
    let levelled: Vec<f64> = class
        .iter()
        .map(|&k| match twins.contains(&k) {
            true => level(k).max(least),
            false => level(k),
        })
        .collect();
    let sum = ln_sum(levelled.iter().copied());
    for (&k, level) in class.iter().zip(&levelled) {
        weights[k].ln_weight = total + level - sum;
    }
}

/// Members of the class around `first`: all that are linked to it by distances below [`SEPARATE`].
pub fn class_around(first: usize, count: usize, distance: &dyn Fn(usize, usize) -> f64) -> Vec<usize> {
    let mut class = vec![first];
    let mut next = 0;
    while next < class.len() {
        let from = class[next];
        for other in 0..count {
            if !class.contains(&other) && distance(from, other) < SEPARATE {
                class.push(other);
            }
        }
        next += 1;
    }
    class
}

#[cfg(test)]
mod tests {
    use super::*;

    fn weight(case: Case, ln_weight: f64) -> Weight {
        Weight {
            case,
            ln_weight,
            ln_likelihood: 0.0,
            seconds: Vec::new(),
        }
    }

    #[test]
    fn the_set_is_the_smallest_that_holds_95_percent() {
        let weights = [
            weight(Case::Nothing, 0.01f64.ln()),
            weight(Case::One(0), 0.7f64.ln()),
            weight(Case::One(1), 0.26f64.ln()),
            weight(Case::Novel, 0.03f64.ln()),
        ];
        let beliefs = beliefs(&weights, 1.0);
        let set: Vec<&Case> = beliefs.iter().filter(|b| b.in_set).map(|b| &b.case).collect();
        assert_eq!(set, [&Case::One(0), &Case::One(1)]);
        assert!((beliefs.iter().map(|b| b.probability).sum::<f64>() - 1.0).abs() < 1e-12);
    }

    #[test]
    fn where_the_best_explanation_is_refuted_none_that_is_known_takes_its_place() {
        let weights = [
            weight(Case::Nothing, 0.001f64.ln()),
            weight(Case::Two(0, 1), 0.996f64.ln()),
            weight(Case::One(0), 0.0028f64.ln()),
            weight(Case::Novel, 0.0002f64.ln()),
        ];
        let all = beliefs(&weights, 1.0);
        let of = |all: &[Belief], case: &Case| all.iter().find(|b| b.case == *case).unwrap().clone();
        // p = 5e-4: at most 1/(−e p ln p) = 96.8 times as probable, at prior odds of 1 to 9
        let mut doubted = all.clone();
        refuted(&mut doubted, 0.1, 5e-4);
        let novel = of(&doubted, &Case::Novel).probability;
        assert!((novel - 96.8 / (96.8 + 9.0)).abs() < 1e-3, "{novel}");
        assert_eq!(doubted[0].case, Case::Novel);
        assert!(doubted[1].in_set && !doubted[2].in_set, "{doubted:?}");
        assert!((doubted.iter().map(|b| b.probability).sum::<f64>() - 1.0).abs() < 1e-12);
        let share =
            |all: &[Belief]| of(all, &Case::One(0)).probability / of(all, &Case::Two(0, 1)).probability;
        assert!((share(&doubted) / share(&all) - 1.0).abs() < 1e-12);
        // what is more probable already stays
        let sure = beliefs(&[weight(Case::Novel, 0.0), weight(Case::One(0), -9.0)], 1.0);
        let mut same = sure.clone();
        refuted(&mut same, 0.1, 9e-4);
        assert_eq!(same, sure);
    }

    #[test]
    fn a_second_effect_that_is_merely_allowed_takes_its_part_from_the_first_alone() {
        let mut weights = [
            weight(Case::One(0), 0.6f64.ln()),
            weight(Case::One(1), 0.1f64.ln()),
            weight(Case::Nothing, 0.02f64.ln()),
        ];
        for share in [0.15f64, 0.05, 0.08] {
            fold(&mut weights, 0, share.ln());
        }
        weights[0].seconds = vec![(1, 0.15f64.ln()), (2, 0.08f64.ln())];
        let folded = beliefs(&weights, 1.0);
        assert!((folded[0].probability - 0.88).abs() < 1e-12 && folded[0].is_shown);
        let all = unfolded(&folded);
        let told: Vec<(&Case, f64, bool, bool)> = all
            .iter()
            .map(|b| (&b.case, (b.probability * 1e6).round() / 1e6, b.in_set, b.is_shown))
            .collect();
        assert_eq!(
            told,
            [
                (&Case::One(0), 0.65, true, true),
                (&Case::Two(0, 1), 0.15, true, false),
                (&Case::One(1), 0.1, true, true),
                (&Case::Two(0, 2), 0.08, true, false),
                (&Case::Nothing, 0.02, false, true),
            ]
        );
    }

    #[test]
    fn a_class_keeps_its_probability_when_it_is_levelled() {
        let mut weights = vec![
            weight(Case::One(0), 0.0),
            weight(Case::One(1), -4.0),
            weight(Case::Novel, -1.0),
        ];
        let before = ln_sum([0.0, -4.0].into_iter());
        level_class(&mut weights, &[0, 1], &[]);
        assert!((ln_sum([weights[0].ln_weight, weights[1].ln_weight].into_iter()) - before).abs() < 1e-12);
        assert!((weights[0].ln_weight - weights[1].ln_weight - 2.0).abs() < 1e-12);
        // between twins priors make odds of 3 at most
        level_class(&mut weights, &[0, 1], &[1]);
        assert!((weights[0].ln_weight - weights[1].ln_weight - 1.0).abs() < 1e-12);
        weights[1].ln_weight = -9.0;
        let before = ln_sum([weights[0].ln_weight, -9.0].into_iter());
        level_class(&mut weights, &[0, 1], &[1]);
        assert!((weights[0].ln_weight - weights[1].ln_weight - 3f64.ln()).abs() < 1e-12);
        assert!((ln_sum([weights[0].ln_weight, weights[1].ln_weight].into_iter()) - before).abs() < 1e-12);
    }

    #[test]
    fn classes_are_linked_through_their_members() {
        let place = [0.0f64, 2.0, 4.0, 9.0];
        let class = class_around(0, 4, &|a, b| (place[a] - place[b]).abs());
        assert_eq!(class, [0, 1, 2]);
    }
}
