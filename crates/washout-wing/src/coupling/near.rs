//! Where a solve starts, and how much is asked of it.

use super::solution::Solution;
use crate::input::design::Coupling;
use crate::structure::larger;

/// Largest change of twist in the last step of a rough solve, deg: a fifth of what a camera tells apart.
const ROUGH_DEG: f64 = 0.03;
/// Coupled residual of a rough solve, relative to the air load. It is that of the films' triangles, most of it, which pull at each other. Of the
/// 1862 trials of `tests/foreign/c005` the strip that was farthest off was then 0.06° from where it settles in 9 of 10, 0.23° in 99 of 100, and
/// 1.0° at most: the film near the tip settles last.
const ROUGH_RESIDUAL: f64 = 0.5;
/// Steps after which a rough solve is given up: one that settles takes five to ten.
const ROUGH_ITERATIONS: usize = 30;

/// Where a solve starts.
#[derive(Debug)]
pub struct Near<'a> {
    /// A solution of a design nearby.
    pub solution: &'a Solution,
    /// Step by freedom from there to where the shape is expected, to first order.
    pub step: Option<Vec<f64>>,
    /// How much is asked of it.
    pub care: Care,
}

/// How much is asked of a solve.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Default)]
pub enum Care {
    /// A shape to the tolerances of the design; where Newton's method does not settle, the slow fixed point is asked.
    #[default]
    Full,
    /// A trial that can be given up: the same by Newton's method alone.
    Trial,
    /// A trial that ends when a step moves no twist by more than 0.03° and leaves less than half of the load; a study leaves held-out cases as they are.
    Rough,
    /// The same between two of them that stand: divergence is not looked for again.
    RoughBetween,
}

impl Care {
    /// Whether it can be given up.
    pub fn is_trial(self) -> bool {
        self != Care::Full
    }

    /// Whether a shape near the solution will do.
    pub fn is_rough(self) -> bool {
        matches!(self, Care::Rough | Care::RoughBetween)
    }

    /// Tolerances to which it is solved.
    pub(super) fn tolerances(self, coupling: &Coupling) -> Coupling {
        let mut asked = coupling.clone();
        if self.is_rough() {
            asked.twist_tolerance_deg = larger(asked.twist_tolerance_deg, ROUGH_DEG);
            asked.residual_tolerance = larger(asked.residual_tolerance, ROUGH_RESIDUAL);
            asked.max_iterations = asked.max_iterations.min(ROUGH_ITERATIONS);
        }
        asked
    }
}
