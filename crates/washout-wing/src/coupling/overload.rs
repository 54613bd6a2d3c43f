//! Why a wing has no equilibrium that can be found: to first order, its load turns it too far.

use super::error::Overload;
use super::wing::Wing;
use crate::structure::state::State;
use crate::structure::{Equilibrium, Loads, largest};

/// Turn of a rod to first order beyond which it is called too weak, rad.
const ROD: f64 = 5.0;
/// The same of a film without spars, rad.
const FILM: f64 = 100.0;

/// Share of the turn from which on it is that of the bench loads.
const MOST: f64 = 0.5;

/// What the load at rest turns too far, if anything: a rod or spar; the film, where the wing has no spars. (Between spars a film bends as far, to
/// first order, and then finds tension to hold it.)
pub fn overload(
    wing: &Wing,
    has_spars: bool,
    equilibrium: &mut Equilibrium,
    rest: &State,
) -> Option<Overload> {
    let loads = wing.loads(&wing.strips.shapes(rest)).ok()?;
    equilibrium.factorize(rest, &loads).ok()?;
    let mut to_first_order = |loads: &Loads| {
        let mut step = wing.model.residual(&equilibrium.pattern, rest, loads);
        step.iter_mut().for_each(|r| *r = -*r);
        equilibrium.solve_tangent(&mut step, 1);
        step
    };
    let (step, by_bench) = (to_first_order(&loads), to_first_order(&wing.bench));
    let mut has_rod = vec![false; wing.model.nodes.len()];
    for beam in &wing.model.beams {
        beam.nodes.into_iter().for_each(|node| has_rod[node] = true);
    }
    let turn_in = |step: &[f64], node: usize| {
        let at = equilibrium.pattern.freedom(node, 3);
        step[at..at + 3]
            .iter()
            .map(|turn| turn * turn)
            .sum::<f64>()
            .sqrt()
    };
    let turn = |node: usize| turn_in(&step, node);
    [(true, ROD), (false, FILM)]
        .into_iter()
        .filter(|(is_rod, _)| *is_rod || !has_spars)
        .find_map(|(is_rod, most)| {
            let nodes = (0..has_rod.len()).filter(|&node| has_rod[node] == is_rod);
            let turn_rad = largest(nodes.clone().map(turn));
            let node = nodes.into_iter().find(|&node| turn(node) == turn_rad)?;
            let r_m = wing.model.nodes[node].x;
            (turn_rad > most).then_some(Overload {
                is_rod,
                is_by_bench: turn_in(&by_bench, node) > MOST * turn_rad,
                turn_rad,
                r_m,
            })
        })
}
