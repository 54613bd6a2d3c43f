//! Regularisation of films on the way to equilibrium: what the tangent takes besides the film's own stiffness.
//!
//! A flat film has no stiffness across itself and a slack one none in its plane, so whole Newton steps overshoot and its
//! regimes (taut, wrinkled, slack) chatter. Two additions to the tangent damp both: a fictitious tension, and a share of
//! compression that it pretends to carry. Both fall away as the residual does; the residual itself never has them.

use super::largest::largest;
use super::model::Model;
use super::sheet::Compression;

/// Relative residual below which the regularisation is taken back step by step.
const NEAR: f64 = 3.0;

/// Fictitious tension over the tension that the load would cause in a flat film.
const TENSION_SHARE: f64 = 0.1;

/// Share of compression that the tangent pretends to carry.
const CARRIED_SHARE: f64 = 0.02;

/// Steps without progress after which steps are searched.
const PATIENCE: usize = 10;

/// How strongly the films of a model are regularised in the present step.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Regularisation {
    /// Fictitious tension at full strength, N/m; 0 where none is needed.
    tension_n_per_m: f64,
    /// Present strength, 0 to 1.
    strength: f64,
    last: f64,
    /// Best residual since the last leap, and the step that had it.
    mark: (f64, usize),
}

impl Regularisation {
    /// Of a model under loads of this size (N): none for plates, whose bending carries them.
    ///
    /// Tension of a flat film of side √A under pressure p: (p² E t A / 24)^⅓ (shallow cylinder, small sag).
    pub fn new(model: &Model, force_n: f64) -> Self {
        let area: f64 = model.shells.iter().map(|shell| shell.area_m2()).sum();
        let films = model.sheets.iter().filter(|sheet| {
            let bending = sheet.e_pa * sheet.thickness_m.powi(3) / 12.0;
            matches!(sheet.compression, Compression::TensionField { .. })
                || bending < 1e-3 * force_n * area.sqrt()
        });
        let stretching = largest(films.map(|sheet| sheet.e_pa * sheet.thickness_m));
        let tension_n_per_m = if area > 0.0 {
            TENSION_SHARE * (force_n * force_n / area * stretching / 24.0).cbrt()
        } else {
            0.0
        };
        Regularisation {
            tension_n_per_m,
            strength: 1.0,
            last: f64::INFINITY,
            mark: (f64::INFINITY, 0),
        }
    }

    /// Whether the model has films that need it.
    pub fn is_needed(&self) -> bool {
        self.tension_n_per_m > 0.0
    }

    /// Fictitious tension of the present step, N/m.
    pub fn tension_n_per_m(&self) -> f64 {
        self.tension_n_per_m * self.strength
    }

    /// Share of compression that the tangent pretends to carry.
    pub fn carried(&self) -> f64 {
        if self.is_needed() {
            CARRIED_SHARE * self.strength
        } else {
            0.0
        }
    }

    /// Takes note of the relative residual of a step; tells whether whole steps have stopped helping.
    pub fn is_stuck(&mut self, count: usize, size: f64) -> bool {
        if size < 0.7 * self.mark.0 || size > 30.0 * self.mark.0 {
            self.mark = (size, count);
        }
        let stuck = self.is_needed() && count - self.mark.1 >= PATIENCE;
        if stuck {
            self.strength = self.strength.max(1e-2);
        } else if size < NEAR && size < 0.9 * self.last {
            self.strength *= 0.2;
        } else if size < NEAR && size > 3.0 * self.last {
            self.strength = (4.0 * self.strength).min(1.0);
        }
        self.last = size;
        stuck
    }

    /// Adapts to the share of a step that the search could take.
    pub fn searched(&mut self, share: f64) {
        if share < 0.3 {
            self.strength = (3.0 * self.strength).min(1.0);
        } else if share > 0.9 {
            self.strength *= 0.3;
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn films_are_regularised_more_after_a_short_step_and_less_after_a_whole_one_or_as_the_residual_falls() {
        let mut film = Regularisation {
            tension_n_per_m: 2.0,
            strength: 0.5,
            last: f64::INFINITY,
            mark: (f64::INFINITY, 0),
        };
        let tension = |film: &Regularisation| film.tension_n_per_m();
        film.searched(0.1);
        assert_eq!(tension(&film), 2.0);
        film.searched(0.5);
        assert_eq!(tension(&film), 2.0);
        film.searched(1.0);
        assert!((tension(&film) - 0.6).abs() < 1e-12);
        assert!(!film.is_stuck(1, 1.0));
        assert!((tension(&film) - 0.12).abs() < 1e-12);
        assert!(!film.is_stuck(2, 1e-3));
        // whole steps that do not bring it further are given up after a while, and the films held
        assert!(!film.is_stuck(PATIENCE + 1, 1e-3));
        assert!(film.is_stuck(PATIENCE + 2, 1e-3));
        assert!(film.carried() >= 1e-2 * CARRIED_SHARE);
    }
}
