//! From evidence to probabilities: hypotheses, and the 95 % set.

use super::evidence::ln_sum;

/// Probability that the set of hypotheses is to hold.
const CREDIBLE: f64 = 0.95;
/// Distance in standard deviations from which on two explanations are told apart.
pub const SEPARATE: f64 = 3.0;
/// Distance below which no statistic can split two explanations.
pub const TWINS: f64 = 1.0;

/// What may be the case.
#[derive(Debug, Clone, PartialEq, Eq)]
pub enum Case {
    /// Nothing is missing.
    Nothing,
    /// One family of effects.
    One(usize),
    /// Two families.
    Two(usize, usize),
    /// A cause without a name.
    Unknown,
}

impl Case {
    /// Families of the known effects.
    pub fn families(&self) -> Vec<usize> {
        match self {
            Case::One(a) => vec![*a],
            Case::Two(a, b) => vec![*a, *b],
            Case::Nothing | Case::Unknown => Vec::new(),
        }
    }
}

/// An explanation with its logarithm of prior times evidence.
#[derive(Debug, Clone, PartialEq)]
pub struct Weight {
    /// What would be the case.
    pub case: Case,
    /// Logarithm of prior times evidence.
    pub ln_weight: f64,
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
}

/// Hypotheses, most probable first; explanations of one case add up. Evidence is raised to the power `tempering`.
pub fn beliefs(weights: &[Weight], tempering: f64) -> Vec<Belief> {
    let mut cases: Vec<(&Case, Vec<f64>)> = Vec::new();
    for weight in weights {
        match cases.iter_mut().find(|(case, _)| **case == weight.case) {
            Some((_, own)) => own.push(weight.ln_weight),
            None => cases.push((&weight.case, vec![weight.ln_weight])),
        }
    }
    let sums: Vec<f64> = cases
        .iter()
        .map(|(_, own)| tempering * ln_sum(own.iter().copied()))
        .collect();
    let total = ln_sum(sums.iter().copied());
    let belief = |((case, _), sum): (&(&Case, Vec<f64>), &f64)| Belief {
        case: (*case).clone(),
        probability: (sum - total).exp(),
        in_set: false,
    };
    let mut beliefs: Vec<Belief> = cases.iter().zip(&sums).map(belief).collect();
    beliefs.sort_by(|a, b| b.probability.total_cmp(&a.probability));
    let mut sum = 0.0;
    for belief in &mut beliefs {
        belief.in_set = sum < CREDIBLE;
        sum += belief.probability;
    }
    beliefs
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_set_is_the_smallest_that_holds_95_percent() {
        let weight = |case: Case, probability: f64| Weight {
            case,
            ln_weight: probability.ln(),
        };
        let weights = [
            weight(Case::Nothing, 0.01),
            weight(Case::One(0), 0.3),
            weight(Case::One(1), 0.26),
            weight(Case::One(0), 0.4),
            weight(Case::Unknown, 0.03),
        ];
        let beliefs = beliefs(&weights, 1.0);
        let set: Vec<&Case> = beliefs.iter().filter(|b| b.in_set).map(|b| &b.case).collect();
        assert_eq!(set, [&Case::One(0), &Case::One(1)]);
        assert!((beliefs[0].probability - 0.7).abs() < 1e-12);
        assert!((beliefs.iter().map(|b| b.probability).sum::<f64>() - 1.0).abs() < 1e-12);
    }
}
