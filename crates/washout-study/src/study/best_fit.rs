//! A fit that looks beyond the valley in which it starts.

use super::calibrate::{Fit, calibrate};
use super::error::StudyError;
use super::forward::{Forward, UnknownKind};
use super::task::Task;
use crate::structure::largest;

/// Q by which a fit must be better than another to stand in its place; and the part of the plausible size by which its strength must lie
/// nearer to what is plausible if it is as good.
const SAME: f64 = 0.1;

/// The best of the fit from the start and of those in which an effect that starts at none starts at its plausible size, of either sign
/// that it may have: at none it may have no derivative (a phase lag), or lie in another valley. Between fits that are as good as each
/// other, the one whose strength is more plausible.
///
/// # Errors
/// Why the fit from the start fails, if all do, or if the user asked to stop.
pub fn best_fit(forward: &dyn Forward, task: &Task) -> Result<Fit, StudyError> {
    let mut best = calibrate(forward, task);
    if matches!(best, Err(StudyError::Cancelled(_))) {
        return best;
    }
    for &effect in task.free.iter().filter(|&&i| task.start[i] == 0.0) {
        let unknown = &forward.unknowns()[effect];
        let UnknownKind::Effect { scale, plausible, .. } = unknown.kind else {
            continue;
        };
        let [low, high] = unknown.range;
        let beyond = |fit: &Fit| {
            let strength = fit.at[effect];
            largest([plausible[0] - strength, strength - plausible[1]])
        };
        for size in [scale, -scale] {
            if !(low..=high).contains(&size) {
                continue;
            }
            let mut start = best.as_ref().map_or(task.start, |fit| &fit.at).to_vec();
            start[effect] = size;
            let task = Task {
                start: &start,
                ..task.clone()
            };
            best = match (best, calibrate(forward, &task)) {
                (_, Err(cancelled @ StudyError::Cancelled(_))) => return Err(cancelled),
                (known, Err(_)) => known,
                (Ok(known), Ok(found)) => {
                    let is_better = found.q + SAME < known.q;
                    let is_as_good = found.q < known.q + SAME;
                    let is_more_plausible = beyond(&found) + SAME * scale < beyond(&known);
                    match is_better || (is_as_good && is_more_plausible) {
                        true => Ok(found),
                        false => Ok(known),
                    }
                }
                (Err(_), found) => found,
            };
        }
    }
    best
}

#[cfg(test)]
mod tests {
    use nalgebra::{DMatrix, DVector};

    use super::*;
    use crate::study::forward::toy::{condition, reading};
    use crate::study::{Condition, Discrepancy, Linear, Noise, Observable, Unknown};

    /// y = s² for an effect of strength s, which has no derivative at none and either sign.
    struct Even {
        unknowns: [Unknown; 1],
        observables: [Observable; 1],
        conditions: [Condition; 1],
    }

    impl Even {
        fn new(value: f64, plausible: [f64; 2]) -> Even {
            let kind = UnknownKind::Effect {
                effect: "even".into(),
                family: "even".into(),
                scale: 2.0,
                plausible,
                one_sided: false,
                has_switch: false,
                all_or_none: false,
                own_error: 0.05,
            };
            Even {
                unknowns: [Unknown {
                    name: "s".into(),
                    unit: "1".into(),
                    kind,
                    mean: 0.0,
                    sigma: 3.0,
                    range: [-9.0, 9.0],
                }],
                observables: [reading(0, value, 0.01)],
                conditions: [condition()],
            }
        }

        fn fitted(&self, by: fn(&dyn Forward, &Task) -> Result<Fit, StudyError>) -> f64 {
            let none = Discrepancy::of_predictions(0.0, &DVector::zeros(1));
            let noise = Noise::new(&self.observables, &self.conditions, &[0], &none).unwrap();
            let task = Task {
                rows: &[0],
                noise: &noise,
                free: &[0],
                start: &[0.0],
                warm_start: None,
                of_use_below: None,
            };
            by(self, &task).unwrap().at[0]
        }
    }

    impl Forward for Even {
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
            Ok(DVector::from_element(1, at[0] * at[0]))
        }
        fn linearize(&self, at: &[f64], _: &dyn Fn(&Unknown) -> bool) -> Result<Linear, StudyError> {
            Ok(Linear {
                value: self.predict(at)?,
                jacobian: DMatrix::from_element(1, 1, 2.0 * at[0]),
            })
        }
        fn moment_response(&self, _: &[f64], stations: usize) -> Result<DMatrix<f64>, StudyError> {
            Ok(DMatrix::zeros(1, stations))
        }
    }

    #[test]
    fn an_effect_without_a_derivative_at_none_is_fitted_with_the_sign_that_is_plausible() {
        for (plausible, expected) in [([0.0, 2.0], 1.5), ([-2.0, 0.0], -1.5), ([0.0, 1.2], 1.5)] {
            let even = Even::new(2.25, plausible);
            assert_eq!(even.fitted(calibrate), 0.0);
            let found = even.fitted(best_fit);
            assert!((found - expected).abs() < 1e-3, "{found}");
        }
        assert!(Even::new(0.0, [0.0, 2.0]).fitted(best_fit).abs() < 0.1);
    }
}
