//! The shape without load for a trial, from that of a solution nearby.

use super::cure::without_cure;
use super::error::CouplingError;
use super::near::Near;
use super::newton::carried;
use super::wing::Wing;
use crate::progress::Progress;
use crate::structure::mixed::Distance;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, Mixed, NewtonSettings, larger};

/// Mixed steps allowed from one start.
const PATIENCE: usize = 40;

/// The shape without load and the steps it took, by mixed steps from the shape without load of the solution nearby, or else from the flat wing; given up where they
/// do not settle on a shape that is stable. Where films buckle under cure it may be another one than [`super::cure::cured`] finds.
///
/// # Errors
/// If it is given up.
pub fn cured_near(
    wing: &Wing,
    equilibrium: &mut Equilibrium,
    near: &Near,
    progress: &Progress,
) -> Result<(State, usize), CouplingError> {
    if let Some(known) = without_cure(&wing.model) {
        return Ok((known, 0));
    }
    let flat = State::at_rest(wing.model.nodes.len());
    let nearby = carried(wing, &near.solution.mesh, &near.solution.rest);
    let mut lost = 0;
    for start in nearby.iter().chain([&flat]) {
        let (found, steps) = mixed(equilibrium, start, progress)?;
        lost += steps;
        if let Some(state) = found {
            return Ok((state, lost));
        }
    }
    Err(CouplingError::GivenUp { steps: lost })
}

/// The equilibrium that mixed steps lead to from `start`, if they settle on one that is stable; and how many they were.
fn mixed(
    equilibrium: &mut Equilibrium,
    start: &State,
    progress: &Progress,
) -> Result<(Option<State>, usize), CouplingError> {
    let none = Loads::none(start.displacement.len());
    let tolerance = NewtonSettings::default().tolerance;
    let mut way = Mixed::new();
    let mut state = start.clone();
    let mut distance = equilibrium.assemble_mixed(&state, &none, &way);
    let mut count = 0;
    let is_settled = |distance: &Distance| distance.relative <= larger(tolerance, distance.rounding);
    while distance.relative.is_finite() && !is_settled(&distance) {
        progress.check()?;
        if count == PATIENCE || equilibrium.factorize_mixed(&state, 0.0, &mut way).is_err() {
            return Ok((None, count));
        }
        let mut step = distance.right;
        equilibrium.solve_tangent(&mut step, 1);
        state = equilibrium.move_mixed(&state, &mut step, &mut way);
        distance = equilibrium.assemble_mixed(&state, &none, &way);
        count += 1;
    }
    let negative = equilibrium.factorize(&state, &none);
    let is_stable = is_settled(&distance) && negative.is_ok_and(|negative| negative == 0);
    Ok((is_stable.then_some(state), count))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::coupling::{Care, Wing, solve_wing};
    use crate::geometry::Planform;
    use crate::input::Design;
    use crate::mesh::{Mesh, generate};

    fn wing(pretension_n_per_m: f64) -> (Design, Mesh, Wing) {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("designs/twist-v2.toml");
        let sets = [
            "mesh.refine=0.5".to_string(),
            format!("film.pretension_n_per_m={pretension_n_per_m}"),
        ];
        let design = Design::load(&path, &sets).unwrap().design;
        let mesh = generate(&design, &Planform::from_design(&design).unwrap()).unwrap();
        let wing = Wing::new(&design, &mesh, None).unwrap();
        (design, mesh, wing)
    }

    #[test]
    fn a_trial_from_a_loose_film_finds_the_taut_one_or_is_given_up() {
        let (design, mesh, loose) = wing(0.0);
        let quiet = Progress::quiet();
        let solution = solve_wing(&design, &loose, &mesh, None, &quiet).unwrap().0;
        let trial = Near {
            solution: &solution,
            step: None,
            care: Care::Trial,
        };
        for tension in [5.0, 20.0] {
            let (design, mesh, taut) = wing(tension);
            let real = solve_wing(&design, &taut, &mesh, None, &quiet).unwrap().0;
            let found = solve_wing(&design, &taut, &mesh, Some(&trial), &quiet).unwrap().0;
            let shapes = found.state.displacement.iter().zip(&real.state.displacement);
            let apart_m = shapes.map(|(a, b)| (a - b).norm()).fold(0.0, f64::max);
            assert!(apart_m < 1e-9, "{tension} N/m: {apart_m} m apart");
            assert!(2 * found.report.newton_steps < real.report.newton_steps);
        }
        let (design, mesh, taut) = wing(234.0);
        let lost = solve_wing(&design, &taut, &mesh, Some(&trial), &quiet).unwrap_err();
        assert!(matches!(lost, CouplingError::GivenUp { .. }), "{lost}");
    }
}
