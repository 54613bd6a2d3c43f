//! Where on the wing a hidden effect sits: in reach of one of the places at which a diagnosis looks for it.

use crate::diagnose::screening::{effect_of, place_of};
use crate::effects::named;
use crate::study::draws::Draws;
use crate::study::{Campaign, Forward, Unknown, UnknownKind};
use crate::synthesize::Hidden;

/// One of the unknowns of a campaign by which an effect acts, and where it sits, if it has a place.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Spot {
    /// Index of the unknown that is its strength.
    pub strength: usize,
    /// Index of the unknown that is its place, and its value.
    pub place: Option<(usize, f64)>,
}

impl Spot {
    /// Where the wing of a campaign has `hidden`; none if a diagnosis of that campaign cannot try it.
    pub fn of(campaign: &Campaign, hidden: &Hidden) -> Option<Spot> {
        let unknowns = campaign.unknowns();
        let card = named(&hidden.name)?.card();
        let number = |name: &str| {
            let given = hidden.table.get(name);
            let given = given.and_then(|value| value.as_float().or_else(|| Some(value.as_integer()? as f64)));
            let own = || {
                card.parameters
                    .iter()
                    .find(|own| own.name == name)
                    .map(|own| own.default)
            };
            given.or_else(own)
        };
        let distance = |strength: usize| match place_of(unknowns, strength).map(|place| &unknowns[place]) {
            Some(Unknown {
                kind:
                    UnknownKind::Place {
                        parameter,
                        numbers,
                        wing,
                        ..
                    },
                mean,
                ..
            }) => {
                let elsewhere =
                    *wing != hidden.wing || numbers.iter().any(|(name, value)| number(name) != Some(*value));
                let off = number(parameter).map_or(f64::INFINITY, |value| (value - mean).abs());
                if elsewhere { f64::INFINITY } else { off }
            }
            _ => 0.0,
        };
        let nearest = strengths(unknowns, &hidden.name)
            .into_iter()
            .map(|strength| (distance(strength), strength))
            .filter(|(off, _)| off.is_finite())
            .min_by(|a, b| a.0.total_cmp(&b.0).then(a.1.cmp(&b.1)));
        let (_, strength) = nearest?;
        let place = place_of(unknowns, strength).and_then(|place| match &unknowns[place].kind {
            UnknownKind::Place { parameter, .. } => Some((place, number(parameter)?)),
            _ => None,
        });
        Some(Spot { strength, place })
    }

    /// Any of the places of an effect, and a point within its reach.
    pub fn drawn(campaign: &Campaign, effect: &str, draws: Draws, stream: u64) -> Option<Spot> {
        let unknowns = campaign.unknowns();
        let all = strengths(unknowns, effect);
        let which = (draws.uniform(stream, 0) * all.len() as f64) as usize;
        let strength = *all.get(which)?;
        let place = place_of(unknowns, strength).map(|place| {
            let unknown = &unknowns[place];
            let [low, high] = unknown.range;
            let off = unknown.sigma * (2.0 * draws.uniform(stream, 1) - 1.0);
            (place, (unknown.mean + off).clamp(low, high))
        });
        Some(Spot { strength, place })
    }

    /// The unknowns with the effect at `strength` and all others at `start`.
    pub fn with(&self, start: &[f64], strength: f64) -> Vec<f64> {
        let mut at = start.to_vec();
        at[self.strength] = strength;
        if let Some((place, value)) = self.place {
            at[place] = value;
        }
        at
    }

    /// The effect here, to be hidden.
    pub fn hidden(&self, campaign: &Campaign, effect: &str, strength: f64) -> Hidden {
        let mut hidden = Hidden::known(effect, strength);
        if let Some((place, value)) = self.place
            && let UnknownKind::Place {
                parameter,
                numbers,
                wing,
                ..
            } = &campaign.unknowns()[place].kind
        {
            let all = numbers
                .iter()
                .map(|(name, value)| (name, *value))
                .chain([(parameter, value)]);
            let all = all.map(|(name, value)| (name.clone(), toml::Value::Float(value)));
            hidden.table.extend(all);
            hidden.wing = wing.clone();
        }
        hidden
    }
}

fn strengths(unknowns: &[Unknown], name: &str) -> Vec<usize> {
    let is_it = |&i: &usize| effect_of(&unknowns[i]).is_some_and(|(effect, _, _, _)| effect == name);
    (0..unknowns.len()).filter(is_it).collect()
}
