//! Equilibrium under dead loads: Newton's method with an energy line search and load increments that adapt.
//!
//! Aids help on the way and vanish before the end, so none changes the answer: the tangent (never the residual) looks
//! ahead to the forces that a step is expected to lead to, films are regularised (`regularisation`), and a tangent that is not positive
//! definite is raised until it is.

use super::StructureError;
use super::equilibrium::Equilibrium;
use super::largest::{larger, largest};
use super::loads::Loads;
use super::model::{Aid, Guess};
use super::regularisation::Regularisation;
use super::sheet::{Compression, Sheet};
use super::state::State;
use crate::progress::Progress;

/// Largest turn of a node in a whole step of plates and rods, rad. With 0.5 a thin strip that bends by 1.1 rad took 110 steps on 30 × 10
/// cells, with 0.12 it takes 15; with 0.2 some meshes need the load in parts again.
const TURN: f64 = 0.12;
/// The same of films, which snap, and of searched steps, rad.
pub(super) const TURN_OF_FILM: f64 = 0.5;

/// Turn of a node in one increment of beams alone beyond which it is cut, rad: from further away Newton's method may land on another branch. A
/// strip under 20 N along its chord and 1 N across turned to the wrong side in increments of a third of the load, and stayed flat, where it
/// does not stay, in a single one.
const TURN_OF_INCREMENT: f64 = 0.25;
/// The shortest increment that is cut for that, as a share of the load.
const SHORTEST_CUT: f64 = 1.0 / 128.0;

/// How an equilibrium is sought.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct NewtonSettings {
    /// Residual relative to the load at which it is met.
    pub tolerance: f64,
    /// Load increments to begin with; more are made where they are needed.
    pub increments: usize,
    /// Newton steps per increment before it is cut.
    pub max_steps: usize,
    /// Newton steps in all after which no further increment is tried.
    pub patience: usize,
}

impl Default for NewtonSettings {
    fn default() -> Self {
        NewtonSettings {
            tolerance: 1e-9,
            increments: 1,
            max_steps: 150,
            patience: usize::MAX,
        }
    }
}

/// What it took to find an equilibrium.
#[derive(Debug, Clone, Copy, PartialEq, Default)]
pub struct NewtonReport {
    /// Newton steps in all.
    pub steps: usize,
    /// Increments that were completed.
    pub increments: usize,
    /// Residual relative to the load.
    pub residual: f64,
}

/// How steps are taken.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Way {
    /// The whole Newton step, as long as no node turns too far.
    Whole,
    /// As far along the step as the energy falls.
    Searched,
}

/// How far Newton's method has come at fixed loads, with the aids on its way.
struct Attempt {
    state: State,
    regularisation: Regularisation,
    aid: Aid,
    /// How much the tangent was raised last.
    raise: f64,
    /// Steps after which it is given up, those left out that were cut.
    patience: usize,
    /// Largest turn of a node in a whole step, rad.
    turn: f64,
    /// Steps that were cut do not count: there are as many as the turn needs.
    cut: usize,
}

impl Equilibrium<'_> {
    /// Moves `state`, in equilibrium under `from`, to equilibrium under `to`.
    ///
    /// # Errors
    /// If none is found, or a load is not finite; `state` is then left as it was.
    pub fn solve(
        &mut self,
        state: &mut State,
        from: &Loads,
        to: &Loads,
        settings: &NewtonSettings,
        progress: &Progress,
    ) -> Result<NewtonReport, StructureError> {
        to.refuse_not_finite(self.model)?;
        let mut report = NewtonReport::default();
        let mut step = 1.0 / settings.increments.max(1) as f64;
        let mut share = 0.0;
        let mut current = state.clone();
        while share < 1.0 {
            let next = if share + step > 1.0 - 1e-9 {
                1.0
            } else {
                share + step
            };
            let loads = to.between(from, next);
            // whole steps pass through states of high energy and so along inextensible bending; searched steps go surely
            let mut found = Err(f64::INFINITY);
            let before = report.steps;
            for &way in self.ways(next - share) {
                found = self.attempt(&current, &loads, settings, way, &mut report, progress)?;
                if found.is_ok() {
                    break;
                }
            }
            match found {
                Ok(found)
                    if next - share > SHORTEST_CUT && self.may_leave_branch(&current, &found, &loads) =>
                {
                    step = 0.5 * (next - share);
                }
                Ok(found) => {
                    current = found;
                    share = next;
                    report.increments += 1;
                    // an increment that took many steps is as long as it should be
                    if report.steps - before <= 12 {
                        step *= 1.5;
                    }
                }
                Err(residual) => {
                    step = 0.4 * (next - share);
                    if step < 1e-3 || report.steps >= settings.patience {
                        return Err(StructureError::NoEquilibrium {
                            load_share: next,
                            residual,
                            steps: report.steps,
                        });
                    }
                }
            }
        }
        *state = current;
        Ok(report)
    }

    /// Whether an increment may have led a structure of beams alone from the branch that it stood on: it turns far, or stands where it would
    /// not stay.
    fn may_leave_branch(&mut self, from: &State, to: &State, loads: &Loads) -> bool {
        if !self.model.shells.is_empty() {
            return false;
        }
        let turns = from.rotation.iter().zip(&to.rotation).map(|(q, r)| q.angle_to(r));
        largest(turns) > TURN_OF_INCREMENT || !matches!(self.factorize(to, loads), Ok(0))
    }

    /// Newton's method at fixed loads; the inner error is the best relative residual.
    fn attempt(
        &mut self,
        start: &State,
        loads: &Loads,
        settings: &NewtonSettings,
        way: Way,
        report: &mut NewtonReport,
        progress: &Progress,
    ) -> Result<Result<State, f64>, StructureError> {
        let scale = self.scale(start, loads);
        let mut attempt = self.begin(start, loads, settings, way);
        let (mut best, mut last) = (f64::INFINITY, f64::INFINITY);
        for count in 0..=settings.max_steps {
            let is_last = count - attempt.cut >= attempt.patience || count == settings.max_steps;
            progress.check()?;
            let residual = self.linearize(&mut attempt, loads);
            let size = self.relative(&residual, scale);
            if !size.is_finite() {
                return Ok(Err(best));
            }
            best = best.min(size);
            // below the estimate of rounding it goes on as long as steps still help
            let at_floor = size <= self.rounding_at(&attempt.state, scale);
            if size <= settings.tolerance || (at_floor && (size > 0.3 * last || is_last)) {
                report.residual = size;
                return Ok(Ok(attempt.state));
            }
            if is_last {
                return Ok(Err(best));
            }
            last = size;
            let way = if attempt.regularisation.is_stuck(count, size) {
                Way::Searched
            } else {
                way
            };
            let step = match self.step(&mut attempt, &residual, way) {
                Err(StructureError::NotFinite(_)) => return Ok(Err(best)),
                found => found?,
            };
            report.steps += 1;
            match self.next(&mut attempt, &step, &residual, loads, way) {
                Some(next) => attempt.state = next,
                None if at_floor => {
                    report.residual = size;
                    return Ok(Ok(attempt.state));
                }
                None => return Ok(Err(best)),
            }
        }
        Ok(Err(best))
    }

    fn begin(&self, start: &State, loads: &Loads, settings: &NewtonSettings, way: Way) -> Attempt {
        let (force, moment) = loads.size(start);
        let regularisation = Regularisation::new(self.model, larger(force, moment / self.extent_m));
        // plates and rods find equilibrium in a dozen whole steps or not at all; films wrinkle for longer
        let (patience, turn) = if way == Way::Whole && !regularisation.is_needed() {
            (20, TURN)
        } else {
            (settings.max_steps, TURN_OF_FILM)
        };
        Attempt {
            state: start.clone(),
            regularisation,
            aid: Aid::default(),
            raise: 0.0,
            patience,
            turn,
            cut: 0,
        }
    }

    /// The residual; the tangent goes into `values`.
    fn linearize(&mut self, attempt: &mut Attempt, loads: &Loads) -> Vec<f64> {
        attempt.aid.carried = attempt.regularisation.carried();
        self.values.fill(0.0);
        self.model.tangent(
            &self.pattern,
            &attempt.state,
            loads,
            Some(&attempt.aid),
            &mut self.values,
        )
    }

    /// The state after a step; none if the energy does not fall along it.
    fn next(
        &self,
        attempt: &mut Attempt,
        step: &[f64],
        residual: &[f64],
        loads: &Loads,
        way: Way,
    ) -> Option<State> {
        let Attempt {
            state,
            regularisation,
            aid,
            ..
        } = attempt;
        match way {
            Way::Whole => {
                let length = self.longest(step, attempt.turn);
                if length < 1.0 {
                    attempt.cut += 1;
                }
                let before = aid.guess.take();
                aid.guess = Some(self.look_ahead(before, state, step, length, !regularisation.is_needed()));
                Some(self.moved(state, step, length))
            }
            Way::Searched => {
                aid.guess = None;
                let (moved, length) = self.search(state, step, residual, loads)?;
                regularisation.searched(length);
                Some(moved)
            }
        }
    }

    /// What the next tangent takes its forces from, `share` of a step taken: all that the whole step leads to, or as far toward that
    /// from what was looked ahead to `before`. (Forces of the shape itself would bring in the stretch that a turn only seems to make.)
    fn look_ahead(
        &self,
        before: Option<Guess>,
        state: &State,
        step: &[f64],
        share: f64,
        shells: bool,
    ) -> Guess {
        let to = self.model.guess(&self.pattern, state, step, shells);
        if share == 1.0 {
            return to;
        }
        let still = || {
            self.model
                .guess(&self.pattern, state, &vec![0.0; step.len()], shells)
        };
        before.unwrap_or_else(still).toward(&to, share)
    }

    /// Newton step with a tangent that is raised until it is positive definite.
    fn step(
        &mut self,
        attempt: &mut Attempt,
        residual: &[f64],
        way: Way,
    ) -> Result<Vec<f64>, StructureError> {
        let tension = attempt.regularisation.tension_n_per_m();
        let must_be_positive = way == Way::Searched;
        self.factorize_raised(&attempt.state, tension, must_be_positive, &mut attempt.raise)?;
        let mut step = self.descent(residual);
        self.factor.solve(&mut step, 1);
        Ok(step)
    }

    /// The residual turned round, nothing where freedoms are held.
    pub(super) fn descent(&self, residual: &[f64]) -> Vec<f64> {
        let part = |(r, &held): (&f64, &bool)| if held { 0.0 } else { -r };
        residual.iter().zip(&self.held).map(part).collect()
    }

    /// Factorizes the tangent that stands in `values` with a fictitious tension (N/m), raised until it is positive definite;
    /// without tension it may stay indefinite unless it `must_be_positive`.
    pub(super) fn factorize_raised(
        &mut self,
        state: &State,
        tension: f64,
        must_be_positive: bool,
        raise: &mut f64,
    ) -> Result<(), StructureError> {
        self.is_linear = false;
        if tension > 0.0 {
            self.model
                .add_tension(&self.pattern, state, tension, &mut self.values);
        }
        self.pattern.hold(&mut self.values, &self.held);
        let mut tries = 0;
        *raise *= 0.1;
        if *raise < 1e-9 {
            *raise = 0.0;
        }
        loop {
            let raised = (*raise > 0.0).then(|| {
                let mut values = self.values.clone();
                self.pattern.raise_diagonal(&mut values, *raise);
                values
            });
            let values = raised.as_ref().unwrap_or(&self.values);
            if self.factor.positive(&self.pattern, values) {
                return Ok(());
            }
            if !must_be_positive && tension == 0.0 {
                self.factor.indefinite(&self.pattern, values)?;
                return Ok(());
            }
            *raise = if *raise > 0.0 { 10.0 * *raise } else { 1e-8 };
            tries += 1;
            if tries > 12 {
                return Err(StructureError::Singular { node: 0 });
            }
        }
    }

    /// Moves along a step as far as the energy falls; gives the share of the step too.
    fn search(&self, state: &State, step: &[f64], residual: &[f64], loads: &Loads) -> Option<(State, f64)> {
        let slope = |residual: &[f64]| -> f64 {
            (residual.iter().zip(step).zip(&self.held))
                .map(|((r, d), &held)| if held { 0.0 } else { r * d })
                .sum()
        };
        let start = slope(residual);
        let mut length = self.longest(step, TURN_OF_FILM);
        let (mut low, mut low_slope) = (0.0, start);
        let mut high: Option<f64> = None;
        for _ in 0..12 {
            let moved = self.moved(state, step, length);
            let here = slope(&self.model.residual(&self.pattern, &moved, loads));
            if here.is_finite() && here <= 0.6 * start.abs() {
                if here.abs() <= 0.9 * start.abs() || high.is_none() {
                    return Some((moved, length));
                }
                (low, low_slope) = (length, here);
            } else {
                high = Some(length);
            }
            let top = high.unwrap_or(length);
            let guess = if here.is_finite() && here > 0.0 {
                low + (top - low) * low_slope / (low_slope - here)
            } else {
                0.5 * (low + top)
            };
            length = guess.clamp(low + 0.1 * (top - low), low + 0.7 * (top - low));
        }
        None
    }

    /// The ways to try for an increment, in order: films snap on whole steps, rods crawl on searched ones.
    fn ways(&self, increment: f64) -> &'static [Way] {
        let film = |sheet: &Sheet| matches!(sheet.compression, Compression::TensionField { .. });
        match (self.model.sheets.iter().any(film), increment < 0.05) {
            (true, _) => &[Way::Whole, Way::Searched],
            (false, true) => &[Way::Whole, Way::Searched],
            (false, false) => &[Way::Whole],
        }
    }

    /// Longest share of a step to take: no node turns by more than `turn`, rad.
    pub(super) fn longest(&self, step: &[f64], turn: f64) -> f64 {
        let most = self.largest_turn(step);
        if most > turn { turn / most } else { 1.0 }
    }

    /// Largest turn of a node in a step, rad.
    pub fn largest_turn(&self, step: &[f64]) -> f64 {
        let square = |spin: &[f64]| spin[3..6].iter().map(|r| r * r).sum::<f64>();
        largest(step.chunks_exact(6).map(square)).sqrt()
    }
}
