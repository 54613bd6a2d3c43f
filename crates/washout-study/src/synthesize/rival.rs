//! Another formula of the same physics, so that data are not made by the formula that is to explain them.

use super::hidden::Hidden;
use crate::effects::named;

/// Another formula.
#[derive(Debug, Clone, PartialEq)]
pub enum Rival {
    /// An effect that the program knows, with its strength.
    Known(&'static str, f64),
    /// Formulas of its own that act together.
    Own(Vec<Hidden>),
}

/// Effects that are two formulas of one physics.
const PAIRS: [[&str; 2]; 3] = [
    ["tip-loss-prandtl", "tip-loss-exponential"],
    ["inflow-uniform", "inflow-momentum"],
    ["lift-gain-linear", "lift-gain-saturating"],
];

/// Another formula of an effect, of the same size; none if there is but one, or it takes no such strength or number.
///
/// Between known rivals, strengths are in the ratio of what is plausible. Formulas written out here vary a little along the
/// span, the spar or the angle about what the effect has as a constant, or blur what it has at one place.
pub fn rival(effect: &Hidden) -> Option<Rival> {
    let (name, strength) = (effect.name.as_str(), effect.strength);
    let number = |key: &str| {
        let card = named(name)?.card();
        let own = card.parameters.iter().find(|own| own.name == key)?.default;
        Some(
            effect
                .table
                .get(key)
                .map_or(own, |value| value.as_float().unwrap_or(own)),
        )
    };
    let numbers = effect.table.len();
    for [a, b] in PAIRS {
        for (from, to) in [(a, b), (b, a)] {
            if from == name {
                let scale = |name: &str| named(name).map(|effect| effect.card().parameters[0].scale());
                let other = strength * scale(to)? / scale(from)?;
                let [low, high] = named(to)?.card().parameters[0].range;
                let may = (low..=high).contains(&other) && numbers == 0;
                return may.then_some(Rival::Known(to, other));
            }
        }
    }
    let s = format!("({strength:?})");
    let parts = match (name, numbers) {
        ("rod-shear-modulus", 0) => vec![("torsion", format!("1 / (1 + {s} * (0.95 + 0.1 * x))"))],
        ("skin-torsion", 0) => vec![("torsion", format!("1 + {s} * (1.05 - 0.1 * x)"))],
        ("skin-bending", 0) => vec![("bending", format!("1 + {s} * (1.05 - 0.1 * x)"))],
        // sanded to a taper; its station is a number of its own
        ("rod-ends-early", _) => {
            // of what is missing, the compliance tapers: by as much in all, about the same station
            let softer = strength / (1.0 - strength);
            let factor = format!(
                "1 / (1 + {softer:?} * 0.5 * (1 + tanh((x - {:?}) / 0.03)))",
                number("from")?
            );
            vec![("torsion", factor.clone()), ("bending", factor)]
        }
        // a bending moment that falls to the free end as its square is felt at a sixth of the length in the mean
        ("spar-stiffness", 0) => vec![("spars", format!("1 / (1 + {s} * (0.95 + 0.3 * along))"))],
        ("centre-of-pressure-shift", 0) => vec![("centre-of-pressure", format!("{s} * (0.9 + 0.2 * x)"))],
        ("drag-scale", 0) => vec![("drag", format!("1 + {s} * (0.9 + 0.2 * x)"))],
        ("coefficient-scale", 0) => {
            let factor = format!("1 + {s} * (0.86 + 0.2 * x)");
            vec![("lift", factor.clone()), ("drag", factor)]
        }
        ("leading-edge-vortex-loss", 0) => {
            let factor = format!("1 - {s} * 0.5 * (1 + tanh(((x - 0.62) / 0.14)))");
            vec![("lift", factor.clone()), ("drag", factor)]
        }
        _ => return None,
    };
    let own = |(acts_on, formula): &(&str, String)| Hidden {
        wing: effect.wing.clone(),
        ..Hidden::own(&format!("{name}-{acts_on}"), acts_on, formula)
    };
    Some(Rival::Own(parts.iter().map(own).collect()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn rivals_are_other_effects_of_the_same_family_or_formulas_of_their_own() {
        for effect in crate::effects::all() {
            let card = effect.card();
            match rival(&Hidden::known(card.name, 0.5 * card.parameters[0].plausible[1])) {
                Some(Rival::Known(name, _)) => {
                    let other = named(name).unwrap().card();
                    assert!(other.name != card.name && other.family == card.family, "{name}");
                }
                Some(Rival::Own(parts)) => {
                    let own =
                        |part: &Hidden| part.table.contains_key("expression") && named(&part.name).is_none();
                    assert!(parts.iter().all(own), "{}", card.name);
                }
                None => {}
            }
        }
    }
}
