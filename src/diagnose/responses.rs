//! What the model reads with each missing effect at a few strengths: finite steps, for what saturates, switches or has no derivative at
//! none. They depend on the campaign, not on its measured values.

use nalgebra::{DMatrix, DVector};
use serde::{Deserialize, Serialize};

use crate::progress::Progress;
use crate::study::{Footing, Forward, Unknown, UnknownKind};

use super::data::Data;
use super::error::DiagnoseError;
use super::steps::Steps;
use super::table::columns::of_strengths;

/// Strengths between none and the largest that was solved, to either side.
const NODES: usize = 16;
/// Prior probability of a strength beyond what is plausible.
const IMPLAUSIBLE: f64 = 0.005;

/// The steps of every missing effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct Responses {
    /// By position among the missing effects.
    pub each: Vec<Response>,
}

/// The steps of one effect.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize)]
pub struct Response {
    /// Strengths in ascending order, none among them, with the change of every observable.
    #[serde(with = "of_strengths")]
    knots: Vec<(f64, DVector<f64>)>,
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
        (slopes, footing): (&DMatrix<f64>, Option<&Footing>),
        progress: &Progress,
    ) -> Result<Responses, DiagnoseError> {
        let (here, left) = forward.linearize_from(footing, at, &|_| false)?;
        let left = left.as_ref().map(Footing::for_trials);
        let steps = Steps::new(forward, data, at, &here.value, footing.or(left.as_ref()));
        let unknowns = forward.unknowns();
        let mut each: Vec<Response> = Vec::new();
        for (k, &i) in data.missing.iter().enumerate() {
            progress.check()?;
            progress.say(format_args!("effect {} of {}", k + 1, data.missing.len()));
            let everywhere = data.missing[..k]
                .iter()
                .position(|&other| is_same_on_all_wings(unknowns, i, other));
            each.push(match everywhere {
                Some(everywhere) => of_wing(forward, &each[everywhere], unknowns, i),
                None => {
                    let slope = slopes.column(k) / unknowns[i].sigma;
                    let (knots, unsolved) = steps.of(i, &slope)?;
                    Response { knots, unsolved }
                }
            });
        }
        Ok(Responses { each })
    }
}

impl Response {
    /// The strengths that are weighed.
    pub fn nodes(&self, unknown: &Unknown) -> Vec<Node> {
        let UnknownKind::Effect {
            plausible: [low, high],
            all_or_none,
            scale,
            ..
        } = unknown.kind
        else {
            return Vec::new();
        };
        let (Some((least, _)), Some((most, _))) = (self.knots.first(), self.knots.last()) else {
            return Vec::new();
        };
        let strengths: Vec<f64> = match all_or_none {
            true => self
                .knots
                .iter()
                .map(|knot| knot.0)
                .filter(|own| *own == scale)
                .collect(),
            false => (1..=NODES)
                .flat_map(|node| {
                    let share = node as f64 / NODES as f64;
                    [least * share, most * share]
                })
                .filter(|strength| *strength != 0.0)
                .collect(),
        };
        let is_plausible = |strength: f64| (low..=high).contains(&strength);
        let inside = strengths.iter().filter(|own| is_plausible(**own)).count();
        let outside = strengths.len() - inside;
        let prior = |strength: f64| match (is_plausible(strength), inside, outside) {
            (true, _, 0) => 1.0 / inside as f64,
            (false, 0, _) => IMPLAUSIBLE / outside as f64,
            (true, ..) => (1.0 - IMPLAUSIBLE) / inside as f64,
            (false, ..) => IMPLAUSIBLE / outside as f64,
        };
        let node = |strength: f64| Node {
            strength,
            ln_prior: prior(strength).ln(),
            is_plausible: is_plausible(strength),
            change: self.at(strength),
        };
        let mut nodes: Vec<Node> = strengths.into_iter().map(node).collect();
        nodes.sort_by(|a, b| a.strength.total_cmp(&b.strength));
        nodes
    }

    /// Changes at the strengths that were solved.
    pub fn changes(&self) -> impl Iterator<Item = &DVector<f64>> {
        self.knots.iter().map(|knot| &knot.1)
    }

    /// Whether the model was asked at a strength, or beyond.
    pub fn has(&self, strength: f64) -> bool {
        let ends = (self.knots.first(), self.knots.last());
        matches!(ends, (Some((low, _)), Some((high, _))) if strength != 0.0 && (*low..=*high).contains(&strength))
    }

    /// Change of every observable at a strength within the steps: cubics that keep what rises between two steps rising (Fritsch & Butland,
    /// SIAM J. Sci. Stat. Comput. 5 (1984) 300).
    pub fn at(&self, strength: f64) -> DVector<f64> {
        let knots = &self.knots;
        let count = knots.len();
        let Some(above) = knots.iter().position(|knot| knot.0 >= strength) else {
            return knots
                .last()
                .map_or_else(|| DVector::zeros(0), |knot| knot.1.clone());
        };
        if above == 0 {
            return knots[0].1.clone();
        }
        let below = above - 1;
        let ((from, low), (to, high)) = (&knots[below], &knots[above]);
        let width = to - from;
        let t = (strength - from) / width;
        let secant = |of: usize, row: usize| {
            let ((from, low), (to, high)) = (&knots[of], &knots[of + 1]);
            (high[row] - low[row]) / (to - from)
        };
        let span = |of: usize| knots[of + 1].0 - knots[of].0;
        let slope = |knot: usize, row: usize| match knot {
            _ if count == 2 => secant(0, row),
            0 => at_end([secant(0, row), secant(1, row)], [span(0), span(1)]),
            last if last + 1 == count => at_end(
                [secant(last - 1, row), secant(last - 2, row)],
                [span(last - 1), span(last - 2)],
            ),
            inner => {
                let (left, right) = (secant(inner - 1, row), secant(inner, row));
                let (before, after) = (span(inner - 1), span(inner));
                let (a, b) = (2.0 * after + before, after + 2.0 * before);
                match left * right > 0.0 {
                    true => (a + b) / (a / left + b / right),
                    false => 0.0,
                }
            }
        };
        let [h0, h1] = [(1.0 + 2.0 * t) * (1.0 - t).powi(2), t * (1.0 - t).powi(2)];
        let [g0, g1] = [t * t * (3.0 - 2.0 * t), t * t * (t - 1.0)];
        DVector::from_fn(low.len(), |row, _| {
            h0 * low[row] + g0 * high[row] + width * (h1 * slope(below, row) + g1 * slope(above, row))
        })
    }
}

/// Slope at an end, from the secants next to it and their widths: that of the parabola, kept from overshooting.
fn at_end([near, far]: [f64; 2], [width, next]: [f64; 2]) -> f64 {
    let slope = ((2.0 * width + next) * near - width * far) / (width + next);
    if slope * near <= 0.0 {
        0.0
    } else if near * far <= 0.0 && slope.abs() > 3.0 * near.abs() {
        3.0 * near
    } else {
        slope
    }
}

/// Whether `other` is the same effect at the same place on all wings as `own` is on one.
fn is_same_on_all_wings(unknowns: &[Unknown], own: usize, other: usize) -> bool {
    let place = |of: &Unknown| {
        unknowns.iter().find_map(|unknown| match &unknown.kind {
            UnknownKind::Place {
                of: strength,
                numbers,
                wing,
                ..
            } if *strength == of.name => Some((unknown.mean, numbers.clone(), wing.clone())),
            _ => None,
        })
    };
    let effect = |of: &Unknown| match &of.kind {
        UnknownKind::Effect { effect, .. } => Some(effect.clone()),
        _ => None,
    };
    let (own, other) = (&unknowns[own], &unknowns[other]);
    if effect(own) != effect(other) {
        return false;
    }
    match (place(own), place(other)) {
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
    for (_, change) in &mut response.knots {
        for row in (0..change.len()).filter(|&row| !is_its(row)) {
            change[row] = 0.0;
        }
    }
    response
}

#[cfg(test)]
mod tests {
    use super::*;

    fn of(knots: &[(f64, f64)]) -> Response {
        Response {
            knots: knots
                .iter()
                .map(|&(s, y)| (s, DVector::from_element(1, y)))
                .collect(),
            unsolved: Vec::new(),
        }
    }

    #[test]
    fn between_steps_a_line_stays_a_line_and_a_parabola_nearly_one() {
        let line = of(&[(-1.0, -2.0), (0.0, 0.0), (0.5, 1.0), (2.0, 4.0)]);
        let parabola = of(&[(0.0, 0.0), (0.5, 0.75), (1.0, 2.0), (1.5, 3.75)]);
        for k in 0..=15 {
            let s = 0.1 * f64::from(k);
            assert!((line.at(s)[0] - 2.0 * s).abs() < 1e-12, "{s}");
            // a straight line would be 0.06 off
            assert!(
                (parabola.at(s)[0] - (s + s * s)).abs() < 0.02,
                "{s}: {}",
                parabola.at(s)[0]
            );
        }
        let both = of(&[(0.0, 0.0), (1.0, 3.0)]);
        assert_eq!(both.at(0.5)[0], 1.5);
    }

    #[test]
    fn a_step_response_is_never_overshot() {
        let kink = of(&[(0.0, 0.0), (1.0, 0.0), (2.0, 1.0), (3.0, 1.0)]);
        for k in 0..=30 {
            let y = kink.at(0.1 * f64::from(k))[0];
            assert!((0.0..=1.0).contains(&y), "{y}");
        }
    }
}
