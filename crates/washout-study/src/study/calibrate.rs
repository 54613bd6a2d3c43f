//! Calibration: the unknowns that fit the measurement best, each held by its prior.
//!
//! Q(x) = ‖Σ^(−1/2)(y − f(x))‖² + Σ ((x − mean)/σ)² is made least by damped Gauss–Newton steps (Levenberg 1944, Marquardt
//! 1963) in units of the priors. An unknown at an end of its range stays there while Q would fall beyond it. A measured
//! bound counts only where the model breaks it.

use nalgebra::{DMatrix, DVector};

use crate::coupling::Care;
use crate::structure::larger;

use super::error::StudyError;
use super::forward::{Forward, Linear, WarmStart};
use super::normal_equations::NormalEquations;
use super::task::Task;

/// Steps allowed.
const PATIENCE: usize = 30;
/// Largest last step, in standard deviations of the posterior, that ends the search; a fall of Q by less than its square
/// (over 1 + Q) does too.
const TOLERANCE: f64 = 1e-2;
/// Fall of Q that the linear model promises, at most, for a last step that the model itself is not asked about any more: it is
/// less than a tenth of a standard deviation long, over which the model is linear.
const LITTLE: f64 = 1e-2;
/// A fall of Q that is promised and does not come is no reason to go on where it is less than this. Assumed: it is a sixth of a standard
/// deviation. Where a reading lies far off, its residual times the curvature of the model, which Gauss-Newton steps leave out, takes the fall.
const FEEBLE: f64 = 0.03;
/// Steps after which a search that need only come below some Q may be given up, and how many times the fall that a whole step then promises it
/// must be short of that: a step falls by about what it promises, and the next ones by less. Assumed.
const EARLIEST: usize = 4;
const FAR: f64 = 10.0;
/// Trials without a solution after which the search is given up: it walks along a cliff.
const CLIFF: usize = 8;
/// Damping of the step after one that did not lower Q, at least: with less it would be the same step.
const SHORTER: f64 = 0.1;
/// Share of a step that did not lower Q from which on it is tried, the way being right and the step too long; a way along which less is best
/// is wrong.
const SHORTEST: f64 = 0.2;
/// Share of the promised fall of Q from which on the next step is damped a hundred times less, not ten.
const KEPT: f64 = 0.75;
/// Damping above which a step is held back, so that a small one tells nothing.
const HELD_BACK: f64 = 1e-3;

/// The best fit.
#[derive(Debug, Clone)]
pub struct Fit {
    /// Value of every unknown; those not free where they were.
    pub at: Vec<f64>,
    /// Indices of the unknowns that were free.
    pub free: Vec<usize>,
    /// Indices of the observables that were fitted.
    pub rows: Vec<usize>,
    /// Least Q: misfit plus price of the priors.
    pub q: f64,
    /// The misfit's part of it.
    pub misfit: f64,
    /// Whitened residual of the fitted observables, measured minus modelled.
    pub residual: DVector<f64>,
    /// Whitened derivatives (fitted observables × free unknowns), per prior standard deviation.
    pub slopes: DMatrix<f64>,
    /// Covariance of the free unknowns, in their units.
    pub covariance: DMatrix<f64>,
    /// Those of the free unknowns that ended at an end of their range.
    pub at_end: Vec<usize>,
    /// Predictions for all observables, held-out ones included, in their units.
    pub predicted: DVector<f64>,
    /// Steps taken.
    pub steps: usize,
    /// What the model left there.
    pub warm_start: Option<WarmStart>,
}

/// Fits the free unknowns.
///
/// The last step is taken by the linear model where that promises next to no fall of Q. The search also ends where no step downhill, however short, lowers Q: the bottom of a kink.
///
/// # Errors
/// If the model has no solution at the start or where the search leads, the search does not settle, or the user asked
/// to stop; or if the search is far from where the fit would be of use.
pub fn calibrate(forward: &dyn Forward, task: &Task) -> Result<Fit, StudyError> {
    let unknowns = forward.unknowns();
    let free: Vec<usize> = task.free.to_vec();
    let wanted = |name: &str| free.iter().any(|&i| unknowns[i].name == name);
    let mut at = task.start.to_vec();
    let care = task.warm_start.map_or(Care::Full, WarmStart::care);
    let ask = |warm_start: Option<&WarmStart>, at: &[f64]| {
        let warm_start = warm_start.map(|left| left.with(care));
        forward.linearize_from(warm_start.as_ref(), at, &|unknown| wanted(&unknown.name))
    };
    let (mut linear, mut warm_start) = ask(task.warm_start, &at)?;
    let mut damping = HELD_BACK;
    // share of the next step that is taken: less than all only after one that did not lower Q
    let mut length = 1.0;
    let mut fall = f64::INFINITY;
    // why a trial had no solution, until whole steps succeed again: a search held back by such trials has found nothing
    let mut unsolved: Option<StudyError> = None;
    let mut failures = 0;
    // by how many prior standard deviations the last step that lowered Q moved each unknown that is free
    let mut moves: Vec<f64> = Vec::new();
    for step in 0..PATIENCE {
        let here = NormalEquations::new(forward, task, &at, &linear);
        let moved = here.step(forward, &free, &at, damping).shortened(&at, length);
        if moved.size < TOLERANCE || fall < TOLERANCE * TOLERANCE * (1.0 + here.q()) {
            return match unsolved {
                Some(error) => Err(error),
                None => Ok(fit_at(here, forward, task, (at, linear, warm_start), step)),
            };
        }
        let promise = |to: &[f64]| {
            let last = linear.moved(to, &at);
            let there = NormalEquations::new(forward, task, to, &last);
            (here.q() - there.q(), last, there)
        };
        let (promised, last, there) = promise(&moved.at);
        if unsolved.is_none() && damping <= HELD_BACK && length == 1.0 && (0.0..LITTLE).contains(&promised) {
            return Ok(fit_at(
                there,
                forward,
                task,
                (moved.at, last, warm_start),
                step + 1,
            ));
        }
        let is_far = |bound: f64| {
            let whole = here.step(forward, &free, &at, HELD_BACK);
            here.q() - FAR * promise(&whole.at).0 > bound
        };
        if step >= EARLIEST && task.of_use_below.is_some_and(is_far) {
            let still = farthest(forward, &free, &moves);
            return Err(unsolved.unwrap_or(StudyError::NotCalibrated { steps: step, still }));
        }
        match ask(warm_start.as_ref(), &moved.at) {
            Err(error) if failures + 1 == CLIFF => {
                return Err(error.while_fitting(&words(forward, &free, &moved.at)));
            }
            Err(cancelled @ StudyError::Cancelled(_)) => return Err(cancelled),
            Err(error) => {
                failures += 1;
                unsolved = Some(error);
                (damping, length) = (larger(10.0 * damping, SHORTER), 1.0);
            }
            Ok((trial, left)) => {
                if damping <= 1.0 {
                    unsolved = None;
                }
                let q = NormalEquations::new(forward, task, &moved.at, &trial).q();
                if q <= here.q() {
                    fall = here.q() - q;
                    let move_of = |&i: &usize| (moved.at[i] - at[i]).abs() / unknowns[i].sigma;
                    moves = free.iter().map(move_of).collect();
                    (at, linear, warm_start) = (moved.at, trial, left);
                    let easier = if fall > KEPT * promised { 0.01 } else { 0.1 };
                    (damping, length) = (larger(damping * easier, 1e-9), 1.0);
                } else if unsolved.is_none() && (0.0..FEEBLE).contains(&promised) {
                    return Ok(fit_at(here, forward, task, (at, linear, warm_start), step + 1));
                } else {
                    // least along the step by the parabola with the slope at its start and Q at its end
                    let least = promised / (2.0 * promised + q - here.q());
                    (damping, length) = match length == 1.0 && least > SHORTEST {
                        true => (damping, least),
                        false => (larger(10.0 * damping, SHORTER), 1.0),
                    };
                }
            }
        }
    }
    let still = farthest(forward, &free, &moves);
    Err(unsolved.unwrap_or(StudyError::NotCalibrated {
        steps: PATIENCE,
        still,
    }))
}

/// The two unknowns that a step moved farthest, by name; none if it moved nothing.
fn farthest(forward: &dyn Forward, free: &[usize], moves: &[f64]) -> Vec<String> {
    let mut order: Vec<usize> = (0..moves.len()).filter(|&k| moves[k] > 0.0).collect();
    order.sort_by(|&a, &b| moves[b].total_cmp(&moves[a]));
    let names = order.iter().take(2);
    names.map(|&k| forward.unknowns()[free[k]].name.clone()).collect()
}

/// Unknowns that a search has moved by more than a standard deviation, with where it has moved them.
fn words(forward: &dyn Forward, free: &[usize], at: &[f64]) -> String {
    let moved = free.iter().map(|&i| (&forward.unknowns()[i], at[i]));
    let moved = moved.filter(|(unknown, value)| (value - unknown.mean).abs() > unknown.sigma);
    let parts: Vec<String> = moved
        .map(|(unknown, value)| {
            let unit = if unknown.unit == "1" {
                ""
            } else {
                unknown.unit.as_str()
            };
            match value.abs() < 1e-2 {
                true => format!("{} = {value:.2e} {unit}", unknown.name),
                false => format!("{} = {value:.4} {unit}", unknown.name),
            }
            .trim_end()
            .to_string()
        })
        .collect();
    parts.join(", ")
}

/// The fit that ends at a point.
fn fit_at(
    here: NormalEquations,
    forward: &dyn Forward,
    task: &Task,
    (at, linear, warm_start): (Vec<f64>, Linear, Option<WarmStart>),
    steps: usize,
) -> Fit {
    let unknowns = forward.unknowns();
    let sigma = DVector::from_iterator(task.free.len(), task.free.iter().map(|&i| unknowns[i].sigma));
    let size = sigma.len();
    let inverse = here
        .curvature()
        .cholesky()
        .map_or_else(|| DMatrix::identity(size, size), |c| c.inverse());
    let covariance = DMatrix::from_fn(size, size, |i, j| inverse[(i, j)] * sigma[i] * sigma[j]);
    let ends = task.free.iter().copied().filter(|&i| {
        let [low, high] = unknowns[i].range;
        at[i] <= low || at[i] >= high
    });
    Fit {
        at_end: ends.collect(),
        free: task.free.to_vec(),
        rows: task.rows.to_vec(),
        q: here.q(),
        misfit: here.residual.norm_squared(),
        residual: here.residual,
        slopes: here.slopes,
        covariance,
        predicted: linear.value,
        at,
        steps,
        warm_start,
    }
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicUsize, Ordering};

    use super::*;
    use crate::input::measurement::Bound;
    use crate::study::Discrepancy;
    use crate::study::forward::Observable;
    use crate::study::forward::toy::{condition, reading};
    use crate::study::forward::{Condition, Unknown, UnknownKind};
    use crate::study::noise::Noise;

    /// y = a exp(−b x) at x = 0, 1, … with unknowns a and b.
    struct Decay {
        unknowns: Vec<Unknown>,
        observables: Vec<Observable>,
        conditions: Vec<Condition>,
    }

    impl Decay {
        fn new(values: &[f64], sigma: f64, range: [f64; 2]) -> Decay {
            let unknown = |name: &str, mean: f64, sigma: f64, range: [f64; 2]| Unknown {
                name: name.into(),
                unit: "1".into(),
                kind: UnknownKind::Input,
                mean,
                sigma,
                range,
            };
            let observable = |(line, &value): (usize, &f64)| reading(line, value, sigma);
            Decay {
                unknowns: vec![
                    unknown("a", 1.0, 10.0, [0.0, 100.0]),
                    unknown("b", 0.1, 1.0, range),
                ],
                observables: values.iter().enumerate().map(observable).collect(),
                conditions: vec![condition()],
            }
        }

        fn fit(&self) -> Fit {
            search(self).unwrap()
        }
    }

    fn search(forward: &dyn Forward) -> Result<Fit, StudyError> {
        search_below(forward, None)
    }

    fn search_below(forward: &dyn Forward, of_use_below: Option<f64>) -> Result<Fit, StudyError> {
        let rows: Vec<usize> = (0..forward.observables().len()).collect();
        let none = Discrepancy::of_predictions(0.0, &DVector::zeros(rows.len()));
        let task = Task {
            rows: &rows,
            noise: &Noise::new(forward.observables(), forward.conditions(), &rows, &none).unwrap(),
            free: &[0, 1],
            start: &[1.0, 0.1],
            warm_start: None,
            of_use_below,
        };
        calibrate(forward, &task)
    }

    impl Forward for Decay {
        fn unknowns(&self) -> &[Unknown] {
            &self.unknowns
        }
        fn observables(&self) -> &[Observable] {
            &self.observables
        }
        fn conditions(&self) -> &[Condition] {
            &self.conditions
        }
        fn predict(&self, at: &[f64]) -> Result<DVector<f64>, StudyError> {
            let value = (0..self.observables.len()).map(|x| at[0] * (-at[1] * x as f64).exp());
            Ok(DVector::from_iterator(self.observables.len(), value))
        }
        fn linearize(&self, at: &[f64], _: &dyn Fn(&Unknown) -> bool) -> Result<Linear, StudyError> {
            let value = self.predict(at)?;
            let jacobian = DMatrix::from_fn(value.len(), 2, |x, j| match j {
                0 => value[x] / at[0],
                _ => -(x as f64) * value[x],
            });
            Ok(Linear { value, jacobian })
        }
        fn moment_response(&self, _: &[f64], stations: usize) -> Result<DMatrix<f64>, StudyError> {
            Ok(DMatrix::zeros(self.observables.len(), stations))
        }
    }

    fn exact(a: f64, b: f64) -> Vec<f64> {
        (0..8).map(|x| a * (-b * x as f64).exp()).collect()
    }

    #[test]
    fn a_nonlinear_fit_from_afar_finds_what_made_the_data() {
        let fit = Decay::new(&exact(20.0, 0.7), 1e-3, [0.0, 5.0]).fit();
        assert!(
            (fit.at[0] - 20.0).abs() < 2e-3 && (fit.at[1] - 0.7).abs() < 1e-4,
            "{:?}",
            fit.at
        );
        assert!(fit.misfit < 1e-3 && fit.at_end.is_empty());
    }

    #[test]
    fn a_search_far_from_where_it_is_of_use_is_given_up_and_one_that_may_reach_it_is_not() {
        let decay = Decay::new(&exact(20.0, 0.7), 1e-3, [0.0, 5.0]);
        let given_up = search_below(&decay, Some(-1e12)).unwrap_err();
        let still = ["a", "b"].map(String::from);
        assert!(
            matches!(&given_up, StudyError::NotCalibrated { steps: EARLIEST, still: own } if still.iter().all(|name| own.contains(name))),
            "{given_up}"
        );
        assert!(given_up.to_string().contains("it still moves "), "{given_up}");
        assert_eq!(search_below(&decay, Some(1.0)).unwrap().at, decay.fit().at);
    }

    #[test]
    fn an_unknown_stops_at_the_end_of_its_range_and_says_so() {
        let fit = Decay::new(&exact(20.0, 0.7), 1e-3, [0.0, 0.5]).fit();
        assert_eq!((fit.at[1], &fit.at_end[..]), (0.5, &[1][..]));
    }

    #[test]
    fn without_information_the_prior_stays() {
        let fit = Decay::new(&exact(20.0, 0.7), 1e6, [0.0, 5.0]).fit();
        assert!((fit.at[0] - 1.0).abs() < 1e-6 && (fit.covariance[(0, 0)].sqrt() - 10.0).abs() < 1e-6);
    }

    #[test]
    fn a_bound_that_the_model_keeps_does_not_pull() {
        let mut decay = Decay::new(&exact(2.0, 0.1), 1e-2, [0.0, 5.0]);
        decay.observables[3].value = 5.0;
        decay.observables[3].bound = Bound::Upper;
        let fit = decay.fit();
        assert!((fit.at[0] - 2.0).abs() < 0.01, "{:?}", fit.at);
        decay.observables[3].bound = Bound::Lower;
        assert!((decay.fit().at[0] - 2.0).abs() > 0.3);
    }

    /// The decay, with no solution for a above 5; counts how often it was asked for one there.
    struct Cliff {
        decay: Decay,
        error: fn() -> StudyError,
        asked: AtomicUsize,
    }

    impl Forward for Cliff {
        fn unknowns(&self) -> &[Unknown] {
            self.decay.unknowns()
        }
        fn observables(&self) -> &[Observable] {
            self.decay.observables()
        }
        fn conditions(&self) -> &[Condition] {
            self.decay.conditions()
        }
        fn predict(&self, at: &[f64]) -> Result<DVector<f64>, StudyError> {
            self.decay.predict(at)
        }
        fn linearize(&self, at: &[f64], wanted: &dyn Fn(&Unknown) -> bool) -> Result<Linear, StudyError> {
            if at[0] > 5.0 {
                self.asked.fetch_add(1, Ordering::Relaxed);
                return Err((self.error)());
            }
            self.decay.linearize(at, wanted)
        }
        fn moment_response(&self, at: &[f64], stations: usize) -> Result<DMatrix<f64>, StudyError> {
            self.decay.moment_response(at, stations)
        }
    }

    #[test]
    fn a_search_along_a_cliff_ends_at_its_eighth_trial_without_solution_or_when_the_user_stops_it() {
        let unsolved = || StudyError::Unsolved {
            case: "c".into(),
            reason: "beyond divergence".into(),
        };
        let cancelled = || StudyError::Cancelled(crate::progress::Cancelled);
        for (error, trials) in [(unsolved as fn() -> StudyError, 8), (cancelled, 1)] {
            let cliff = Cliff {
                decay: Decay::new(&exact(20.0, 0.7), 1e-3, [0.0, 5.0]),
                error,
                asked: AtomicUsize::new(0),
            };
            assert_eq!(search(&cliff).unwrap_err(), error());
            assert_eq!(cliff.asked.into_inner(), trials);
        }
    }
}
