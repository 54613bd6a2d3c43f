//! What the model reads with each missing effect at a few strengths: finite steps, for what saturates, switches or has no derivative at
//! none. They depend on the campaign, not on its measured values.

use std::collections::BTreeMap;
use std::sync::atomic::{AtomicUsize, Ordering};

use nalgebra::{DMatrix, DVector};
use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use serde::{Deserialize, Serialize};

use crate::progress::Progress;
use crate::study::{Forward, Unknown, UnknownKind, WarmStart};

use super::data::Data;
use super::error::DiagnoseError;
use super::evidence::place_of_largest;
use super::interpolate::Curve;
use super::steps::Steps;

/// Strengths between none and the largest that was solved, to either side.
const NODES: usize = 16;
/// Closer nodes in the stead of each one where an effect is most likely.
const CLOSER: usize = 6;
/// How far between two places an effect is looked at.
const AWAY: f64 = 1.0 / 3.0;
/// Prior probability of a strength beyond what is plausible; assumed, well below that of a cause without a name.
const IMPLAUSIBLE: f64 = 0.002;

/// The steps of every missing effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Responses {
    /// By position among the missing effects.
    pub each: Vec<Response>,
}

/// The steps of one effect.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Response {
    /// Between the strengths that were solved.
    curve: Curve,
    /// Strengths at which the model has no solution.
    pub unsolved: Vec<f64>,
}

/// A strength that is weighed.
#[derive(Debug, Clone)]
pub struct Node {
    /// The strength, in its unit.
    pub strength: f64,
    /// Logarithm of its prior probability.
    pub ln_prior: f64,
    /// Whether it is plausible.
    pub is_plausible: bool,
    /// Whether the change is that at the effect's own place, and none between it and the next.
    pub is_in_place: bool,
    /// Change of every observable.
    pub change: DVector<f64>,
}

impl Responses {
    /// About `at`, with every missing effect off; `slopes`: derivatives there, per prior standard deviation, and what the model left.
    ///
    /// # Errors
    /// If the model has no solution there, or the user asked to stop.
    pub fn new(
        forward: &dyn Forward,
        data: &Data,
        at: &[f64],
        (slopes, warm_start): (&DMatrix<f64>, Option<&WarmStart>),
        progress: &Progress,
    ) -> Result<Responses, DiagnoseError> {
        let (here, left) = forward.linearize_from(warm_start, at, &|_| false)?;
        let left = left.as_ref().map(WarmStart::roughly);
        let steps = Steps::new(forward, data, at, &here.value, warm_start.or(left.as_ref()));
        let unknowns = forward.unknowns();
        let missing = &data.missing;
        let everywhere = |k: usize| {
            let is_its = |&other: &usize| is_same_on_all_wings(unknowns, missing[k], other);
            missing[..k].iter().position(is_its)
        };
        let asked: Vec<usize> = (0..missing.len()).filter(|&k| everywhere(k).is_none()).collect();
        let begun = AtomicUsize::new(0);
        let found: Vec<Response> = asked
            .par_iter()
            .map(|&k| {
                progress.check()?;
                let begun = 1 + begun.fetch_add(1, Ordering::Relaxed);
                progress.say(format_args!("effect {begun} of {}", asked.len()));
                let slope = slopes.column(k) / unknowns[missing[k]].sigma;
                let (curve, unsolved) = steps.of(missing[k], &slope)?;
                Ok(Response { curve, unsolved })
            })
            .collect::<Result<_, DiagnoseError>>()?;
        let mut each = vec![Response::default(); missing.len()];
        for (k, own) in asked.into_iter().zip(found) {
            each[k] = own;
        }
        for k in 0..missing.len() {
            if let Some(all) = everywhere(k) {
                each[k] = of_wing(forward, &each[all], unknowns, missing[k]);
            }
        }
        Ok(Responses { each })
    }
}

impl Response {
    /// The strengths that are weighed, in ascending order: evenly spaced over what was solved, and closer where `likely` of them is
    /// largest (it is asked once, for all that are even).
    pub fn nodes(&self, unknown: &Unknown, likely: impl Fn(&[Node]) -> Vec<f64>) -> Vec<Node> {
        let UnknownKind::Effect {
            plausible: [low, high],
            all_or_none,
            scale,
            ..
        } = unknown.kind
        else {
            return Vec::new();
        };
        let (Some((least, _)), Some((most, _))) = (self.curve.knots.first(), self.curve.knots.last()) else {
            return Vec::new();
        };
        let strengths = match all_or_none {
            true => self.solved_at(scale),
            false => evenly(*least, *most),
        };
        let is_plausible = |strength: f64| (low..=high).contains(&strength);
        let inside = strengths.iter().filter(|own| is_plausible(**own)).count();
        let outside = strengths.len() - inside;
        let node = |strength: f64, share: f64, of: f64| Node {
            strength,
            ln_prior: (share * prior(is_plausible(of), inside, outside)).ln(),
            is_plausible: is_plausible(of),
            is_in_place: true,
            change: self.at(strength),
        };
        let even: Vec<Node> = strengths.iter().map(|&own| node(own, 1.0, own)).collect();
        let Some(best) = place_of_largest(&likely(&even)).filter(|_| !all_or_none) else {
            return even;
        };
        // a node stands for the stretch about it: of the best and its neighbours, for closer ones in their stead
        let end = if strengths[best] < 0.0 { -least } else { *most };
        let step = end / NODES as f64;
        let mut nodes: Vec<Node> = Vec::new();
        for (place, own) in even.into_iter().enumerate() {
            if place.abs_diff(best) > 1 || own.strength * strengths[best] < 0.0 {
                nodes.push(own);
                continue;
            }
            let size = own.strength.abs();
            let from = if size < 1.5 * step { 0.0 } else { size - 0.5 * step };
            let to = (size + 0.5 * step).min(end);
            for part in 0..CLOSER {
                let closer = from + (to - from) * (part as f64 + 0.5) / CLOSER as f64;
                let closer = closer.copysign(own.strength);
                nodes.push(node(closer, 1.0 / CLOSER as f64, own.strength));
            }
        }
        nodes.sort_by(|a, b| a.strength.total_cmp(&b.strength));
        nodes
    }

    /// The strengths that were solved at this size.
    fn solved_at(&self, scale: f64) -> Vec<f64> {
        let solved = self.curve.knots.iter().map(|knot| knot.0);
        let mut strengths: Vec<f64> = solved.filter(|own| *own == scale).collect();
        strengths.sort_by(f64::total_cmp);
        strengths
    }

    /// `nodes` and the same a third of the way to the places beside, where the change is mixed: what sits between two places must be no less
    /// probable than what sits on one.
    pub fn between_places(mut nodes: Vec<Node>, beside: &[&Response]) -> Vec<Node> {
        let share = ((1 + beside.len()) as f64).recip();
        for node in &mut nodes {
            node.ln_prior += share.ln();
        }
        let mixed = |other: &&Response| -> Vec<Node> {
            let there = |node: &Node| Node {
                change: &node.change * (1.0 - AWAY) + other.at(node.strength) * AWAY,
                is_in_place: false,
                ..node.clone()
            };
            nodes.iter().map(there).collect()
        };
        let more: Vec<Node> = beside.iter().flat_map(mixed).collect();
        nodes.extend(more);
        nodes.sort_by(|a, b| a.strength.total_cmp(&b.strength));
        nodes
    }

    /// Whether it is one of so many observables.
    pub fn is_of(&self, observables: usize) -> bool {
        let Curve { knots, slope, .. } = &self.curve;
        knots.iter().all(|knot| knot.1.len() == observables)
            && (slope.is_empty() || slope.len() == observables)
    }

    /// The smallest and the largest strength that was solved, none among them; nothing if none was.
    pub fn reach(&self) -> Option<[f64; 2]> {
        Some([self.curve.knots.first()?.0, self.curve.knots.last()?.0])
    }

    /// Whether the model was asked at a strength, or beyond.
    pub fn has(&self, strength: f64) -> bool {
        let ends = (self.curve.knots.first(), self.curve.knots.last());
        matches!(ends, (Some((low, _)), Some((high, _))) if strength != 0.0 && (*low..=*high).contains(&strength))
    }

    /// Change of every observable at a strength within the steps.
    pub fn at(&self, strength: f64) -> DVector<f64> {
        self.curve.at(strength)
    }
}

/// Strengths between none and the ends of what was solved, in ascending order.
fn evenly(least: f64, most: f64) -> Vec<f64> {
    let mut strengths: Vec<f64> = (1..=NODES)
        .flat_map(|node| {
            let share = node as f64 / NODES as f64;
            [least * share, most * share]
        })
        .filter(|strength| *strength != 0.0)
        .collect();
    strengths.sort_by(f64::total_cmp);
    strengths
}

/// Prior probability of a strength among so many inside the plausible range and outside of it.
fn prior(is_plausible: bool, inside: usize, outside: usize) -> f64 {
    match (is_plausible, inside, outside) {
        (true, _, 0) => 1.0 / inside as f64,
        (false, 0, _) => IMPLAUSIBLE / outside as f64,
        (true, ..) => (1.0 - IMPLAUSIBLE) / inside as f64,
        (false, ..) => IMPLAUSIBLE / outside as f64,
    }
}

/// Place of an effect, numbers with which it acts there and wing; none for what has no place.
fn place<'a>(
    unknowns: &'a [Unknown],
    of: &Unknown,
) -> Option<(f64, &'a BTreeMap<String, f64>, Option<&'a str>)> {
    unknowns.iter().find_map(|unknown| match &unknown.kind {
        UnknownKind::Place {
            of: strength,
            numbers,
            wing,
            ..
        } if *strength == of.name => Some((unknown.mean, numbers, wing.as_deref())),
        _ => None,
    })
}

fn effect(of: &Unknown) -> Option<&str> {
    match &of.kind {
        UnknownKind::Effect { effect, .. } => Some(effect),
        _ => None,
    }
}

/// Positions in `missing` of the same effect at the next places inboard and outboard.
pub fn beside(unknowns: &[Unknown], missing: &[usize], k: usize) -> Vec<usize> {
    let own = &unknowns[missing[k]];
    let Some((here, numbers, wing)) = place(unknowns, own) else {
        return Vec::new();
    };
    let mut inboard: Option<(f64, usize)> = None;
    let mut outboard: Option<(f64, usize)> = None;
    for (other, &i) in missing.iter().enumerate() {
        let is_same = effect(&unknowns[i]) == effect(own);
        let Some((there, _, _)) = place(unknowns, &unknowns[i])
            .filter(|(_, others, on)| is_same && *others == numbers && *on == wing)
        else {
            continue;
        };
        if there < here && inboard.is_none_or(|known| there > known.0) {
            inboard = Some((there, other));
        }
        if there > here && outboard.is_none_or(|known| there < known.0) {
            outboard = Some((there, other));
        }
    }
    inboard.into_iter().chain(outboard).map(|own| own.1).collect()
}

/// Whether `other` is the same effect at the same place on all wings as `own` is on one.
fn is_same_on_all_wings(unknowns: &[Unknown], own: usize, other: usize) -> bool {
    let (own, other) = (&unknowns[own], &unknowns[other]);
    if effect(own) != effect(other) {
        return false;
    }
    match (place(unknowns, own), place(unknowns, other)) {
        (Some((at, numbers, Some(_))), Some((other_at, other_numbers, None))) => {
            at == other_at && numbers == other_numbers
        }
        _ => false,
    }
}

/// The steps of an effect on one wing, from those on all.
fn of_wing(forward: &dyn Forward, all: &Response, unknowns: &[Unknown], own: usize) -> Response {
    let name = &unknowns[own].name;
    let wing = unknowns.iter().find_map(|unknown| match &unknown.kind {
        UnknownKind::Place { of, wing, .. } if of == name => wing.as_deref(),
        _ => None,
    });
    let is_its = |row: usize| {
        let condition = &forward.conditions()[forward.observables()[row].condition];
        Some(condition.wing.as_str()) == wing
    };
    let mut response = all.clone();
    let Curve { knots, slope, .. } = &mut response.curve;
    let changes = knots.iter_mut().map(|knot| knot.1.as_mut_slice());
    for change in changes.chain([slope.as_mut_slice()]) {
        let others = change.iter_mut().enumerate().filter(|(row, _)| !is_its(*row));
        others.for_each(|(_, value)| *value = 0.0);
    }
    response
}
