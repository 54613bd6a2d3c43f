//! The single changes of a study in one choice of words and alternatives, each at a few sizes.

use nalgebra::DVector;

use crate::diagnose::interpolate::Measure;
use crate::diagnose::screening::whole_strength;
use crate::study::{Forward, Unknown, UnknownKind};

use super::answers::Answers;
use super::model::Model;
use super::price::{Prices, of_value};

/// Sizes between none and each end at which a change is weighed.
const SIZES: usize = 10;
/// Changes that move no reading by more than this, in its standard deviations, explain nothing.
const VISIBLE: f64 = 0.2;

/// One change of a model.
#[derive(Debug, Clone)]
pub struct Change {
    /// Index of its unknown.
    pub unknown: usize,
    /// By what it is known: the family of an effect, with its wing if it is on one; the number itself.
    pub key: String,
    /// What it takes to say that it is this one.
    pub price: f64,
    /// Its sizes.
    pub sizes: Vec<Size>,
}

/// A change of some size.
#[derive(Debug, Clone)]
pub struct Size {
    /// Value of the unknown.
    pub value: f64,
    /// What the value costs.
    pub cost: f64,
    /// Change of the fitted readings, in standard deviations.
    pub change: DVector<f64>,
}

/// The changes that `rows` can see; and the price of each.
pub fn changes(model: &Model, answers: &Answers, rows: &[usize]) -> (Vec<Change>, Prices) {
    let unknowns = model.unknowns();
    let sigmas = DVector::from_iterator(rows.len(), rows.iter().map(|&row| model.observables()[row].sigma));
    let in_sigmas = |change: DVector<f64>| change.select_rows(rows.iter()).component_div(&sigmas);
    let mut found: Vec<Change> = Vec::new();
    let mut add = |i: usize, sizes: Vec<Size>| {
        let is_finite = |size: &Size| size.change.iter().all(|own| own.is_finite());
        let sizes: Vec<Size> = sizes.into_iter().filter(is_finite).collect();
        let most = sizes.iter().map(|size| size.change.amax()).fold(0.0, f64::max);
        if most >= VISIBLE {
            found.push(Change {
                unknown: i,
                key: key(unknowns, i),
                price: 0.0,
                sizes,
            });
        }
    };
    for (&i, response) in answers.effects.iter().zip(&answers.responses.each) {
        let Some([least, most]) = response.reach() else {
            continue;
        };
        let [low, high] = unknowns[i].range;
        let values = match whole_strength(&unknowns[i]) {
            Some(whole) => vec![whole],
            None => between(
                least.max(low),
                most.min(high),
                Measure::within(model.campaign().unknowns()[i].range),
            ),
        };
        let values = values.into_iter().filter(|value| response.has(*value));
        let size = |value: f64| Size {
            value,
            cost: of_value(&unknowns[i], value),
            change: in_sigmas(response.at(value)),
        };
        add(i, values.map(size).collect());
    }
    let start = model.start();
    for (i, curve) in &answers.inputs {
        let (Some(first), Some(last)) = (curve.knots.first(), curve.knots.last()) else {
            continue;
        };
        let size = |step: f64| Size {
            value: start[*i] + step,
            cost: of_value(&unknowns[*i], start[*i] + step),
            change: in_sigmas(curve.at(step)),
        };
        let steps = between(first.0, last.0, Measure::Even);
        add(*i, steps.into_iter().map(size).collect());
    }
    let prices = Prices::new(unknowns, found.iter().map(|change| change.unknown));
    for change in &mut found {
        change.price = prices.of(&unknowns[change.unknown]);
    }
    (found, prices)
}

/// Values between none and the ends, in ascending order.
fn between(least: f64, most: f64, measure: Measure) -> Vec<f64> {
    let (low, high) = (measure.of(least.min(0.0)), measure.of(most.max(0.0)));
    let values = (1..=SIZES).flat_map(|step| {
        let share = step as f64 / SIZES as f64;
        [low * share, high * share]
    });
    let mut values: Vec<f64> = values
        .filter(|far| *far != 0.0)
        .map(|far| measure.strength(far))
        .collect();
    values.sort_by(f64::total_cmp);
    values
}

/// By what a change is known.
fn key(unknowns: &[Unknown], i: usize) -> String {
    let unknown = &unknowns[i];
    match &unknown.kind {
        UnknownKind::Effect { family, .. } => {
            let wing = unknowns.iter().find_map(|other| match &other.kind {
                UnknownKind::Place { of, wing, .. } if *of == unknown.name => wing.as_deref(),
                _ => None,
            });
            match wing {
                Some(wing) => format!("{family} on {wing}"),
                None => family.clone(),
            }
        }
        _ => format!("{} #{i}", unknown.name),
    }
}
