//! How long the steps of a motion in pseudo-time are.
//!
//! On the way a step may be as long as turns no node far: what a film does in between is passed over. Where a wing does not come to rest so,
//! because triangles switch to and fro in every step, its steps are made so short that the residual comes out about as the tangent said.

use crate::structure::mixed::Distance;
use crate::structure::state::State;
use crate::structure::{Damper, Equilibrium, Mixed};

/// Turn of a node in a step beyond which steps are made shorter, rad.
const LONG: f64 = 0.3;
/// The first rate over that at which the load would move the wing by its own length.
const FIRST: f64 = 30.0;
/// Factors of the rate: where steps are too long, and where they are calm.
const HARDER: f64 = 3.0;
const SOFTER: f64 = 0.5;
/// Where the rate has fallen by this and the turn neither fell nor grew with it, triangles switch to and fro.
const IDLE: f64 = 50.0;
/// Factor of the rate then.
const AGAIN: f64 = 300.0;
/// Residual after a step less what the tangent said, over the residual before: above the largest steps are made shorter by the factor beside
/// it, above the next by less, below the last longer.
const FAR_OFF: (f64, f64) = (3.0, 2.0);
const OFF: (f64, f64) = (1.5, 1.2);
const GOOD: (f64, f64) = (0.75, 0.6);
/// Attempts to make a tangent positive definite.
const TRIES: usize = 40;

/// Pace of a motion.
#[derive(Debug)]
pub struct Pace {
    damper: Damper,
    /// Damping of the whole wing over the length of a step in time, N/m.
    rate_n_per_m: f64,
    /// Largest turn of a node in the last step, rad.
    turn: f64,
    /// Turn and rate since which the turn is alike.
    mark: (f64, f64),
    /// Whether triangles switched to and fro: the tangent's word counts since.
    is_watched: bool,
    /// What the tangent said of the residual after the last step by freedom, and the relative residual before it.
    expected: Option<(Vec<f64>, f64)>,
}

impl Pace {
    /// Before the first step of a structure whose load, and what its films pull at rest, is `load_n`.
    pub fn new(equilibrium: &Equilibrium, load_n: f64) -> Self {
        Pace {
            damper: Damper::new(equilibrium),
            rate_n_per_m: FIRST * load_n / equilibrium.model.extent_m(),
            turn: f64::INFINITY,
            mark: (f64::INFINITY, 0.0),
            is_watched: false,
            expected: None,
        }
    }

    /// Largest turn of a node in the last step, rad, and the rate, N/m.
    pub fn turn_and_rate(&self) -> (f64, f64) {
        (self.turn, self.rate_n_per_m)
    }

    /// Factorizes what was assembled for the next step; `false` if no rate makes it positive definite. `scale`: of forces (N) and moments (N·m).
    pub fn factorize(
        &mut self,
        equilibrium: &mut Equilibrium,
        distance: &Distance,
        scale: (f64, f64),
    ) -> bool {
        if let Some((said, before)) = self.expected.take().filter(|_| self.is_watched) {
            let apart: Vec<f64> = distance
                .right
                .iter()
                .zip(said)
                .map(|(is, said)| is - said)
                .collect();
            let off = equilibrium.relative(&apart, scale) / before;
            if off > FAR_OFF.0 || self.turn > LONG {
                self.rate_n_per_m *= FAR_OFF.1;
            } else if off > OFF.0 {
                self.rate_n_per_m *= OFF.1;
            } else if off < GOOD.0 && self.turn < 0.5 * LONG {
                self.rate_n_per_m *= GOOD.1;
            }
        }
        for _ in 0..TRIES {
            if equilibrium.factorize_damped(&self.damper, self.rate_n_per_m) {
                return true;
            }
            self.rate_n_per_m *= HARDER;
        }
        false
    }

    /// The state after a step that the factorization gave.
    pub fn step(
        &mut self,
        equilibrium: &Equilibrium,
        from: &State,
        distance: &Distance,
        scale: (f64, f64),
        (step, way): (&mut [f64], &mut Mixed),
    ) -> State {
        self.turn = equilibrium.largest_turn(step);
        let said = self.damper.force(step, self.rate_n_per_m);
        self.expected = Some((said, equilibrium.relative(&distance.right, scale)));
        if !self.is_watched {
            self.go_by_turn();
        }
        equilibrium.move_mixed(from, step, way)
    }

    /// Adapts the rate to the turn of the last step.
    fn go_by_turn(&mut self) {
        let (turn, rate) = (self.turn, self.rate_n_per_m);
        if turn < 0.5 * self.mark.0 || turn > 5.0 * self.mark.0 {
            self.mark = (turn, rate);
        }
        if turn > LONG {
            self.rate_n_per_m *= HARDER;
        } else if IDLE * rate < self.mark.1 {
            self.rate_n_per_m *= AGAIN;
            self.is_watched = true;
        } else if turn < 0.5 * LONG {
            self.rate_n_per_m *= SOFTER;
        }
    }
}
