//! Another formula of the same physics, so that data are not made by the formula that is to explain them.

use super::hidden::Hidden;
use crate::effects::named;

/// Another formula.
#[derive(Debug, Clone, PartialEq)]
pub enum Rival {
    /// An effect that the program knows, with its strength.
    Known(&'static str, f64),
    /// A formula of its own.
    Own(Hidden),
}

/// Effects that are two formulas of one physics.
const PAIRS: [[&str; 2]; 3] = [
    ["tip-loss-prandtl", "tip-loss-exponential"],
    ["inflow-uniform", "inflow-momentum"],
    ["lift-gain-linear", "lift-gain-saturating"],
];

/// Another formula of an effect, of the same size at `strength`; none if there is but one, or it takes no such strength.
///
/// Between known rivals, strengths are in the ratio of what is plausible. Formulas written out here vary a little along the
/// span, or with the angle, about what the effect has as a constant.
pub fn rival(effect: &str, strength: f64) -> Option<Rival> {
    for [a, b] in PAIRS {
        for (from, to) in [(a, b), (b, a)] {
            if from == effect {
                let scale = |name: &str| named(name).map(|effect| effect.card().parameters[0].scale());
                let other = strength * scale(to)? / scale(from)?;
                let [low, high] = named(to)?.card().parameters[0].range;
                return (low..=high).contains(&other).then_some(Rival::Known(to, other));
            }
        }
    }
    let s = format!("({strength:?})");
    let (acts_on, expression) = match effect {
        "rod-shear-modulus" => ("torsion", format!("1 / (1 + {s} * (0.95 + 0.1 * x))")),
        "skin-torsion" => ("torsion", format!("1 + {s} * (1.05 - 0.1 * x)")),
        "skin-bending" => ("bending", format!("1 + {s} * (1.05 - 0.1 * x)")),
        "centre-of-pressure-shift" => ("centre-of-pressure", format!("{s} * (0.9 + 0.2 * x)")),
        "drag-scale" => ("drag", format!("1 + {s} * (0.9 + 0.2 * x)")),
        "leading-edge-vortex-loss" => ("lift", format!("1 - {s} * 0.5 * (1 + tanh(((x - 0.62) / 0.14)))")),
        _ => return None,
    };
    Some(Rival::Own(Hidden::own("hidden", acts_on, &expression)))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rivals_are_other_effects_of_the_same_family_or_formulas_of_their_own() {
        for effect in crate::effects::all() {
            let card = effect.card();
            match rival(card.name, 0.5 * card.parameters[0].plausible[1]) {
                Some(Rival::Known(name, _)) => {
                    let other = named(name).unwrap().card();
                    assert!(other.name != card.name && other.family == card.family, "{name}");
                }
                Some(Rival::Own(own)) => assert!(own.table.contains_key("expression"), "{}", card.name),
                None => {}
            }
        }
    }
}
