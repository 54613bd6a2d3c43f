//! What may be missing: families of effects that these data can see, and the explanations that are made of them.

use crate::study::Forward;

use super::data::Data;
use super::screening::effect_of;

/// Effects whose plausible size moves the data by less than this, in standard deviations, explain nothing: if they are missing, nothing
/// detectable is.
const VISIBLE: f64 = 0.3;

/// Effects that are the same physics at another place or by another formula.
#[derive(Debug, Clone, PartialEq)]
pub struct Family {
    /// Its name.
    pub name: String,
    /// Positions of its members among the missing effects.
    pub members: Vec<usize>,
}

/// Families of the missing effects that these data can see, in the order of their first members; `distances`: how far the data lie with
/// each at its plausible size from without, in standard deviations.
pub fn families(forward: &dyn Forward, data: &Data, distances: &[f64]) -> Vec<Family> {
    let mut found: Vec<Family> = Vec::new();
    for (k, &i) in data.missing.iter().enumerate() {
        if distances[k] < VISIBLE {
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
            }),
        }
    }
    found
}

/// An explanation by one or two effects.
#[derive(Debug, Clone, PartialEq)]
pub struct Trial {
    /// Positions of the effects among the missing.
    pub members: Vec<usize>,
    /// Its families: one or two, in ascending order.
    pub families: Vec<usize>,
    /// ln of its prior.
    pub ln_prior: f64,
    /// ln of prior times evidence, on a scale common to all explanations of the same data.
    pub ln_weight: f64,
    /// Most probable strengths, in their units.
    pub best: Vec<f64>,
    /// Means of the strengths.
    pub strength: Vec<f64>,
    /// Their standard deviations.
    pub error: Vec<f64>,
    /// Mean share of formulation error and scale of the scatter under it, where that was looked at.
    pub size: Option<[f64; 2]>,
}
