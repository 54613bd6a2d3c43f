//! What it takes to say which change it is: −2 ln of its share of what could have changed.

use std::collections::BTreeMap;

use crate::diagnose::PriorOdds;
use crate::input::study::Alternative;
use crate::study::{Unknown, UnknownKind};

/// Prices of all changes of a study.
#[derive(Debug, Clone, PartialEq)]
pub struct Prices {
    /// By family: how many members and places it has.
    families: BTreeMap<String, usize>,
    /// Numbers and nuisances of the ruler that may be off.
    numbers: usize,
}

impl Prices {
    /// Of a model with these unknowns, of which `changes` can change.
    pub fn new(unknowns: &[Unknown], changes: impl Iterator<Item = usize>) -> Prices {
        let mut families: BTreeMap<String, usize> = BTreeMap::new();
        let mut numbers = 0;
        for i in changes {
            match &unknowns[i].kind {
                UnknownKind::Effect { family, .. } => *families.entry(family.clone()).or_default() += 1,
                _ => numbers += 1,
            }
        }
        Prices { families, numbers }
    }

    /// Families of effects.
    pub fn families(&self) -> usize {
        self.families.len()
    }

    /// Numbers and nuisances of the ruler.
    pub fn numbers(&self) -> usize {
        self.numbers
    }

    /// Of a change of an unknown.
    pub fn of(&self, unknown: &Unknown) -> f64 {
        match &unknown.kind {
            UnknownKind::Effect { family, .. } => {
                let members = self.families.get(family).copied().unwrap_or(1);
                let odds = PriorOdds::default();
                2.0 * (self.families.len() as f64 * members as f64).ln()
                    - 2.0 * (odds.one / odds.nothing).ln()
            }
            _ => 2.0 * (self.numbers.max(1) as f64).ln(),
        }
    }
}

/// Of an alternative that holds with its probability.
pub fn of_alternative(alternative: &Alternative) -> f64 {
    2.0 * ((1.0 - alternative.probability) / alternative.probability).ln()
}

/// What the value of an unknown costs: the square of its distance from its mean, in standard deviations.
pub fn of_value(unknown: &Unknown, value: f64) -> f64 {
    ((value - unknown.mean) / unknown.sigma).powi(2)
}

#[cfg(test)]
mod tests {
    use super::of_alternative;
    use crate::input::study::Alternative;

    #[test]
    fn an_even_alternative_costs_nothing_and_a_rare_one_its_odds() {
        let of = |probability: f64| {
            let alternative: Alternative =
                toml::from_str(&format!("name = \"a\"\nprobability = {probability}")).unwrap();
            of_alternative(&alternative)
        };
        assert_eq!(of(0.5), 0.0);
        assert!((of(0.05) - 2.0 * 19f64.ln()).abs() < 1e-12);
    }
}
