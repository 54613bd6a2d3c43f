//! At which strengths the model is asked for an effect: at its plausible ends, and between and beyond them as often as cubics
//! between the answers need.

use nalgebra::DVector;

use crate::study::{Forward, Unknown, UnknownKind, WarmStart};

use super::data::Data;
use super::error::{DiagnoseError, where_solved};
use super::interpolate::{Curve, Knots, Measure};

/// How far beyond a plausible end an effect is looked at, if its range reaches at least so far.
const BEYOND: f64 = 1.5;
const WORTHWHILE: f64 = 1.1;
/// Bisections by which the largest strength with a solution is looked for.
const RETREATS: usize = 3;
/// Most bisections of one stretch.
const DEEPEST: usize = 3;
/// Error between two steps that is accepted, over the error of the effect's own formula.
const STRAIGHT: f64 = 0.5;
/// Error between two steps that never counts, over the readings (root mean square): a fraction of any formulation error.
const FAINT: f64 = 0.002;
/// Readings near zero count like this share of the root mean square of all.
const FLOOR: f64 = 0.25;

/// The model about a point, with every missing effect off.
pub struct Steps<'a> {
    forward: &'a dyn Forward,
    data: &'a Data,
    at: &'a [f64],
    here: &'a DVector<f64>,
    warm_start: Option<&'a WarmStart>,
    /// By observable: one over what a reading is, typically; 0 for held-out ones.
    weights: DVector<f64>,
}

impl<'a> Steps<'a> {
    /// About `at`, where the model reads `here`.
    pub fn new(
        forward: &'a dyn Forward,
        data: &'a Data,
        at: &'a [f64],
        here: &'a DVector<f64>,
        warm_start: Option<&'a WarmStart>,
    ) -> Steps<'a> {
        let observables = forward.observables();
        let mut weights = DVector::zeros(here.len());
        for &row in &data.rows {
            let alike = data
                .rows
                .iter()
                .filter(|&&other| observables[other].channel == observables[row].channel);
            let squares: Vec<f64> = alike.map(|&other| here[other].powi(2)).collect();
            let typical = (squares.iter().sum::<f64>() / squares.len() as f64).sqrt();
            let own = here[row].abs().max(FLOOR * typical);
            if own > 0.0 {
                weights[row] = 1.0 / own;
            }
        }
        Steps {
            forward,
            data,
            at,
            here,
            warm_start,
            weights,
        }
    }

    /// The steps of unknown `i`, whose derivative at none is `slope`, and strengths without a solution.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn of(&self, i: usize, slope: &DVector<f64>) -> Result<(Curve, Vec<f64>), DiagnoseError> {
        let unknown = &self.forward.unknowns()[i];
        let has_slope = !is_all_or_none(unknown) && slope.iter().any(|own| *own != 0.0);
        let slope = has_slope.then_some(slope);
        let mut knots: Knots = vec![(0.0, DVector::zeros(self.here.len()))];
        let mut unsolved: Vec<f64> = Vec::new();
        for end in ends(unknown) {
            let mut side = Side {
                steps: self,
                i,
                slope,
                solved: vec![Solved {
                    strength: 0.0,
                    change: DVector::zeros(self.here.len()),
                    warm_start: self.warm_start.cloned(),
                }],
                unsolved: Vec::new(),
            };
            side.explore(end)?;
            knots.extend(side.solved.drain(1..).map(|own| (own.strength, own.change)));
            unsolved.append(&mut side.unsolved);
        }
        Ok((self.curve(i, knots, slope), unsolved))
    }

    /// Through knots of unknown `i` in any order, of which none has this derivative.
    fn curve(&self, i: usize, mut knots: Knots, slope: Option<&DVector<f64>>) -> Curve {
        knots.sort_by(|a, b| a.0.total_cmp(&b.0));
        Curve {
            knots,
            slope: slope.map_or_else(Vec::new, |slope| slope.as_slice().to_vec()),
            measure: Measure::within(self.forward.unknowns()[i].range),
        }
    }

    /// Whether an error of a change does not count beside that of the effect's own formula.
    fn is_faint(&self, error: &DVector<f64>, change: &DVector<f64>, unknown: &Unknown) -> bool {
        let size = |of: &DVector<f64>| of.component_mul(&self.weights).norm();
        let count = self.data.rows.len() as f64;
        size(error) <= (STRAIGHT * unknown.own_error() * size(change)).max(FAINT * count.sqrt())
    }
}

/// The steps of one effect to one side of none.
struct Side<'a> {
    steps: &'a Steps<'a>,
    i: usize,
    /// Derivative at none, where it has one.
    slope: Option<&'a DVector<f64>>,
    /// None first, then in the order in which they were solved.
    solved: Vec<Solved>,
    unsolved: Vec<f64>,
}

/// The model with an effect.
struct Solved {
    strength: f64,
    change: DVector<f64>,
    warm_start: Option<WarmStart>,
}

impl Side<'_> {
    /// Steps to a plausible end, or as far as there are solutions, and beyond.
    fn explore(&mut self, end: f64) -> Result<(), DiagnoseError> {
        let steps = self.steps;
        let unknown = &steps.forward.unknowns()[self.i];
        let reached = self.reach(end)?;
        if is_all_or_none(unknown) || reached == 0.0 {
            return Ok(());
        }
        let last = self.at(reached);
        // a straight line is off a parabola by a quarter of the bend
        let far = self.measure().of(reached);
        let bend = self.slope.map(|slope| &last - slope * far);
        let straight = bend
            .as_ref()
            .filter(|bend| steps.is_faint(&(*bend * 0.25), &last, unknown));
        if straight.is_none() {
            self.between(0.0, reached, bend.as_ref(), 0)?;
        }
        let [low, high] = unknown.range;
        let beyond = (BEYOND * end).clamp(low, high);
        if reached != end || beyond.abs() < end.abs() * WORTHWHILE {
            return Ok(());
        }
        let (Some(bend), Some(slope)) = (straight, self.slope) else {
            self.ask(beyond)?;
            return Ok(());
        };
        let far_beyond = self.measure().of(beyond);
        self.solved.push(Solved {
            strength: beyond,
            change: slope * far_beyond + bend * (far_beyond / far).powi(2),
            warm_start: None,
        });
        Ok(())
    }

    /// The largest strength up to `end` with a solution, as far as bisections find it; 0 if none.
    fn reach(&mut self, end: f64) -> Result<f64, DiagnoseError> {
        if self.ask(end)? || is_all_or_none(&self.steps.forward.unknowns()[self.i]) {
            return Ok(self.solved.last().map_or(0.0, |last| last.strength));
        }
        let (mut low, mut high) = (0.0, end);
        for _ in 0..RETREATS {
            let middle = self.measure().middle(low, high);
            if self.ask(middle)? {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok(low)
    }

    /// Steps between two that a straight line does not hold for; `bend`: the larger one less the slope at none.
    fn between(
        &mut self,
        from: f64,
        to: f64,
        bend: Option<&DVector<f64>>,
        depth: usize,
    ) -> Result<(), DiagnoseError> {
        let middle = self.measure().middle(from, to);
        let straight = (self.at(from) + self.at(to)) * 0.5;
        let before = self.interpolated(middle);
        let is_known = self.solved.iter().any(|own| own.strength == middle);
        if !is_known && !self.ask(middle)? {
            return Ok(());
        }
        let here = self.at(middle);
        let expected = match bend {
            Some(bend) => straight - bend * 0.25,
            None => before,
        };
        // the step in the middle is expected to make cubics four times as good; where torsional stiffness is lost, they were found to be
        // twice as good, so that up to twice the error is left there
        let left = (&here - expected) * 0.25;
        let unknown = &self.steps.forward.unknowns()[self.i];
        if !self.steps.is_faint(&left, &here, unknown) && depth + 1 < DEEPEST {
            self.between(from, middle, None, depth + 1)?;
            self.between(middle, to, None, depth + 1)?;
        }
        Ok(())
    }

    /// Change at a strength between those that were solved.
    fn interpolated(&self, strength: f64) -> DVector<f64> {
        let knots = self.solved.iter().map(|own| (own.strength, own.change.clone()));
        self.steps.curve(self.i, knots.collect(), self.slope).at(strength)
    }

    fn measure(&self) -> Measure {
        Measure::within(self.steps.forward.unknowns()[self.i].range)
    }

    fn at(&self, strength: f64) -> DVector<f64> {
        let known = self.solved.iter().find(|own| own.strength == strength);
        known.map_or_else(|| DVector::zeros(self.steps.here.len()), |own| own.change.clone())
    }

    /// Solves the model at a strength, from the nearest that was solved; false if there is no solution.
    fn ask(&mut self, strength: f64) -> Result<bool, DiagnoseError> {
        let Steps {
            forward,
            data,
            at,
            here,
            ..
        } = self.steps;
        let measure = self.measure();
        let off = |own: &&Solved| (measure.of(own.strength) - measure.of(strength)).abs();
        let nearest = self.solved.iter().min_by(|a, b| off(a).total_cmp(&off(b)));
        let warm_start = nearest.and_then(|own| own.warm_start.as_ref());
        let is_between = self.solved.iter().any(|own| own.strength.abs() > strength.abs());
        let warm_start = match is_between {
            true => warm_start.map(WarmStart::roughly_between),
            false => warm_start.cloned(),
        };
        let mut there = at.to_vec();
        there[self.i] = strength;
        let found = where_solved(forward.linearize_from(warm_start.as_ref(), &there, &|_| false))?;
        let found = found.filter(|(moved, _)| moved.value.iter().all(|own| own.is_finite()));
        let Some((moved, left)) = found else {
            self.unsolved.push(strength);
            return Ok(false);
        };
        let mut change = moved.value - *here;
        for row in data.kept_bounds(*forward, here) {
            change[row] = 0.0;
        }
        self.solved.push(Solved {
            strength,
            change,
            warm_start: left.as_ref().map(WarmStart::roughly),
        });
        Ok(true)
    }
}

fn is_all_or_none(unknown: &Unknown) -> bool {
    matches!(
        unknown.kind,
        UnknownKind::Effect {
            all_or_none: true,
            ..
        }
    )
}

/// Ends of what is plausible, to either side of none.
fn ends(unknown: &Unknown) -> Vec<f64> {
    let UnknownKind::Effect {
        plausible,
        all_or_none,
        scale,
        one_sided,
        ..
    } = unknown.kind
    else {
        return Vec::new();
    };
    if all_or_none {
        return vec![scale];
    }
    let [low, high] = unknown.range;
    let ends = plausible
        .into_iter()
        .filter(|&end| end > 0.0 || (end < 0.0 && !one_sided));
    ends.map(|end: f64| end.clamp(low, high))
        .filter(|end| *end != 0.0)
        .collect()
}
