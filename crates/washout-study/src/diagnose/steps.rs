//! At which strengths the model is asked for an effect: at its plausible ends, and between and beyond them as often as cubics
//! between the answers need, in the conditions that need it.

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
/// How far from the middle of a stretch, as a share of it, a strength may be that is known already and bisects it.
const ABOUT_MIDDLE: f64 = 0.25;
/// Most bisections of one stretch.
const DEEPEST: usize = 3;
/// Error between two steps that is accepted, over the error of the effect's own formula.
const STRAIGHT: f64 = 0.5;
/// Error in all conditions together in which no further step is asked for, over the error between two steps that is accepted: what
/// is asked again may leave the rest.
const UNASKED: f64 = 0.5;
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
                    asked: self.all_conditions(),
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

    /// Every condition, as asked.
    fn all_conditions(&self) -> Vec<bool> {
        vec![true; self.forward.conditions().len()]
    }

    /// Whether an error of a change does not count beside that of the effect's own formula.
    fn is_faint(&self, error: &DVector<f64>, change: &DVector<f64>, unknown: &Unknown) -> bool {
        self.size(error) <= self.accepted(change, unknown)
    }

    /// The largest error of a change that does not count, over the readings.
    fn accepted(&self, change: &DVector<f64>, unknown: &Unknown) -> f64 {
        let count = self.data.rows.len() as f64;
        (STRAIGHT * unknown.own_error() * self.size(change)).max(FAINT * count.sqrt())
    }

    /// A change or its error over the readings.
    fn size(&self, of: &DVector<f64>) -> f64 {
        of.component_mul(&self.weights).norm()
    }

    /// By condition, whether it is among the few of those `asked` that hold most of an error: all others together hold so little
    /// that no further step is worth its time.
    fn worst(
        &self,
        error: &DVector<f64>,
        change: &DVector<f64>,
        unknown: &Unknown,
        asked: &[bool],
    ) -> Vec<bool> {
        let mut squares = vec![0.0; self.forward.conditions().len()];
        for (row, observable) in self.forward.observables().iter().enumerate() {
            squares[observable.condition] += (error[row] * self.weights[row]).powi(2);
        }
        let accepted = UNASKED * self.accepted(change, unknown);
        let worst = largest(&squares, accepted.powi(2));
        worst
            .iter()
            .zip(asked)
            .map(|(own, asked)| *own && *asked)
            .collect()
    }
}

/// Which of some parts are the largest, so that all others together come to no more than `rest`.
fn largest(parts: &[f64], rest: f64) -> Vec<bool> {
    let mut smallest_first: Vec<usize> = (0..parts.len()).collect();
    smallest_first.sort_by(|&a, &b| parts[a].total_cmp(&parts[b]));
    let mut sum = 0.0;
    let mut is_large = vec![false; parts.len()];
    for part in smallest_first {
        sum += parts[part];
        is_large[part] = sum > rest;
    }
    is_large
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
    /// By condition: whether it was solved there; if not, its changes lie on the curve through the others.
    asked: Vec<bool>,
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
            self.between(0.0, reached, bend.as_ref(), &steps.all_conditions(), 0)?;
        }
        let [low, high] = unknown.range;
        let beyond = (BEYOND * end).clamp(low, high);
        if reached != end || beyond.abs() < end.abs() * WORTHWHILE {
            return Ok(());
        }
        let (Some(bend), Some(slope)) = (straight, self.slope) else {
            self.ask(beyond, &steps.all_conditions())?;
            return Ok(());
        };
        let far_beyond = self.measure().of(beyond);
        self.solved.push(Solved {
            strength: beyond,
            change: slope * far_beyond + bend * (far_beyond / far).powi(2),
            asked: steps.all_conditions(),
            warm_start: None,
        });
        Ok(())
    }

    /// The largest strength up to `end` with a solution, as far as bisections find it; 0 if none.
    fn reach(&mut self, end: f64) -> Result<f64, DiagnoseError> {
        let all = self.steps.all_conditions();
        if self.ask(end, &all)? || is_all_or_none(&self.steps.forward.unknowns()[self.i]) {
            return Ok(self.solved.last().map_or(0.0, |last| last.strength));
        }
        let (mut low, mut high) = (0.0, end);
        for _ in 0..RETREATS {
            let middle = self.measure().middle(low, high);
            if self.ask(middle, &all)? {
                low = middle;
            } else {
                high = middle;
            }
        }
        Ok(low)
    }

    /// Steps between two that a straight line does not hold for in the conditions `asked`; `bend`: the larger one less the slope at
    /// none.
    fn between(
        &mut self,
        from: f64,
        to: f64,
        bend: Option<&DVector<f64>>,
        asked: &[bool],
        depth: usize,
    ) -> Result<(), DiagnoseError> {
        let known = self.known_between(from, to);
        let middle = known.unwrap_or_else(|| self.measure().middle(from, to));
        if known.is_none() && !self.ask(middle, asked)? {
            return Ok(());
        }
        let here = self.at(middle);
        let expected = match bend {
            Some(bend) => {
                let share = self.share(from, to, middle);
                self.at(from) * (1.0 - share) + self.at(to) * share - bend * (share * (1.0 - share))
            }
            // through what was solved outside this stretch and at its ends
            None => self.interpolated(middle, |own| own <= from.abs() || own >= to.abs()),
        };
        // the step in the middle is expected to make cubics four times as good; where torsional stiffness is lost, they were found to be
        // twice as good, so that up to twice the error is left there
        let left = (&here - expected) * 0.25;
        let unknown = &self.steps.forward.unknowns()[self.i];
        if !self.steps.is_faint(&left, &here, unknown) && depth + 1 < DEEPEST {
            let worst = self.steps.worst(&left, &here, unknown, asked);
            self.between(from, middle, None, &worst, depth + 1)?;
            self.between(middle, to, None, &worst, depth + 1)?;
        }
        Ok(())
    }

    /// A strength that was solved while the end was looked for, if it is about in the middle between two.
    fn known_between(&self, from: f64, to: f64) -> Option<f64> {
        let off = |strength: f64| (self.share(from, to, strength) - 0.5).abs();
        let known = self.solved.iter().map(|own| own.strength);
        let known = known.filter(|own| off(*own) <= ABOUT_MIDDLE);
        known.min_by(|a, b| off(*a).total_cmp(&off(*b)))
    }

    /// How far a strength is on the way from one to another.
    fn share(&self, from: f64, to: f64, strength: f64) -> f64 {
        let measure = self.measure();
        let from = measure.of(from);
        (measure.of(strength) - from) / (measure.of(to) - from)
    }

    /// Change at a strength by the curve through those that were solved, as far as their size `is_used`.
    fn interpolated(&self, strength: f64, is_used: impl Fn(f64) -> bool) -> DVector<f64> {
        let used = self.solved.iter().filter(|own| is_used(own.strength.abs()));
        let knots = used.map(|own| (own.strength, own.change.clone()));
        self.steps.curve(self.i, knots.collect(), self.slope).at(strength)
    }

    fn measure(&self) -> Measure {
        Measure::within(self.steps.forward.unknowns()[self.i].range)
    }

    fn at(&self, strength: f64) -> DVector<f64> {
        let known = self.solved.iter().find(|own| own.strength == strength);
        known.map_or_else(|| DVector::zeros(self.steps.here.len()), |own| own.change.clone())
    }

    /// Solves the model at a strength in the conditions `asked`, from the nearest that was solved in these; false if there is no
    /// solution.
    fn ask(&mut self, strength: f64, asked: &[bool]) -> Result<bool, DiagnoseError> {
        let Steps {
            forward,
            data,
            at,
            here,
            ..
        } = self.steps;
        let measure = self.measure();
        let off = |own: &&Solved| (measure.of(own.strength) - measure.of(strength)).abs();
        let holds = |own: &&Solved| own.asked.iter().zip(asked).all(|(own, asked)| *own || !asked);
        let nearest = self
            .solved
            .iter()
            .filter(holds)
            .min_by(|a, b| off(a).total_cmp(&off(b)));
        let warm_start = nearest.and_then(|own| own.warm_start.as_ref());
        let is_between = self.solved.iter().any(|own| own.strength.abs() > strength.abs());
        let warm_start = match is_between {
            true => warm_start.map(|own| own.roughly_between().of_conditions(asked)),
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
        let unasked = |row: &usize| !asked[forward.observables()[*row].condition];
        let curve = self.interpolated(strength, |_| true);
        for row in (0..change.len()).filter(unasked) {
            change[row] = curve[row];
        }
        self.solved.push(Solved {
            strength,
            change,
            asked: asked.to_vec(),
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

#[cfg(test)]
mod tests {
    use super::largest;

    #[test]
    fn parts_left_out_come_to_no_more_than_the_rest_together() {
        assert_eq!(largest(&[0.4, 3.0, 0.5, 0.2], 1.0), [false, true, true, false]);
        assert_eq!(largest(&[0.4, 0.1], 0.0), [true, true]);
        assert_eq!(largest(&[0.4, 0.1], 0.5), [false, false]);
    }
}
