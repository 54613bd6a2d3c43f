//! Why a wing has no equilibrium that can be found: to first order, its load turns it too far.

use super::error::CouplingError;
use super::wing::Wing;
use crate::structure::state::State;
use crate::structure::{Equilibrium, largest};

/// Turn of a rod to first order beyond which it is called too weak, rad.
const ROD: f64 = 5.0;
/// The same of a film, which a load bends far before it finds tension to hold it, rad.
const FILM: f64 = 100.0;

/// What a load would turn too far if the wing stayed as stiff as it is at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overload {
    /// Whether a rod or spar turns so, as opposed to a film beside them.
    pub is_rod: bool,
    /// Turn to first order, rad.
    pub turn_rad: f64,
    /// Station where it is largest, m.
    pub r_m: f64,
}

impl std::fmt::Display for Overload {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        let Overload { turn_rad, r_m, .. } = self;
        let (r_mm, turn) = (1e3 * r_m, turn_rad.round());
        if self.is_rod {
            write!(
                f,
                "the rods are far too weak for the load: if they stayed as stiff as they are at rest, it would turn them by {turn} rad at \
                 r = {r_mm:.1} mm. Lower the speed or the amplitude, or make the rods thicker"
            )
        } else {
            write!(
                f,
                "next to nothing but its own bending holds the film at r = {r_mm:.1} mm, and the load would turn it by {turn} rad if it \
                 stayed as stiff as it is at rest: it flies as a flag, with many shapes near equilibrium. Add a spar there, or make the \
                 film thicker"
            )
        }
    }
}

impl From<Overload> for CouplingError {
    fn from(overload: Overload) -> Self {
        CouplingError::Overloaded(overload)
    }
}

/// What the load at rest turns too far, if anything.
pub fn overload(wing: &Wing, equilibrium: &mut Equilibrium, rest: &State) -> Option<Overload> {
    let loads = wing.loads(&wing.strips.shapes(rest)).ok()?;
    let mut step = wing.model.residual(&equilibrium.pattern, rest, &loads);
    step.iter_mut().for_each(|r| *r = -*r);
    equilibrium.factorize(rest, &loads).ok()?;
    equilibrium.solve_tangent(&mut step, 1);
    let mut has_rod = vec![false; wing.model.nodes.len()];
    for beam in &wing.model.beams {
        beam.nodes.into_iter().for_each(|node| has_rod[node] = true);
    }
    let turn = |node: usize| {
        let at = equilibrium.pattern.freedom(node, 3);
        step[at..at + 3]
            .iter()
            .map(|turn| turn * turn)
            .sum::<f64>()
            .sqrt()
    };
    [(true, ROD), (false, FILM)]
        .into_iter()
        .find_map(|(is_rod, most)| {
            let nodes = (0..has_rod.len()).filter(|&node| has_rod[node] == is_rod);
            let turn_rad = largest(nodes.clone().map(turn));
            let node = nodes.into_iter().find(|&node| turn(node) == turn_rad)?;
            let r_m = wing.model.nodes[node].x;
            (turn_rad > most).then_some(Overload {
                is_rod,
                turn_rad,
                r_m,
            })
        })
}
