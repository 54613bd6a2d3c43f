//! Roll-up of a cantilever by an end moment, as beams and as a plate strip.
//!
//! ```text
//!  |                    ↷ M      φ = M L / EI; φ = 2π closes the circle
//!  |====================         tip: u = L (sin φ / φ − 1), w = L (1 − cos φ) / φ
//! ```
//!
//! The strip is case 3.2 of Sze, Liu & Lo, Finite Elem. Anal. Des. 40 (2004) 1551-1569: L = 12, b = 1, h = 0.1,
//! E = 1.2e6, ν = 0, full circle at M = 50π/3; their table agrees with the closed form to its last digit.

use std::f64::consts::TAU;

use nalgebra::Vector3;
use washout::structure::{Loads, Section};

use crate::support::{Grid, chain, line_shares, plate, solve, straight};

/// Tip displacement (along, across) after a turn by φ.
fn circle(length: f64, phi: f64) -> [f64; 2] {
    [length * (phi.sin() / phi - 1.0), length * (1.0 - phi.cos()) / phi]
}

#[test]
fn beam_rolls_up_to_the_circle_within_a_thousandth() {
    let (length, count, bending) = (10.0, 32, 100.0);
    let model = chain(
        straight(length, count),
        &Vector3::z(),
        Section::uncoupled(1e6, 80.0, bending, bending),
    );
    for turns in [0.25, 0.5, 1.0, 2.0] {
        let phi = turns * TAU;
        let mut loads = Loads::none(count + 1);
        loads.moment_n_m[count].y = -phi * bending / length;
        let (state, report) = solve(&model, &loads, 1);
        let tip = state.displacement[count];
        let exact = circle(length, phi);
        let error = ((tip.x - exact[0]) / length).hypot((tip.z - exact[1]) / length);
        println!("beam, {turns} turns: {error:.1e} in {} steps", report.steps);
        assert!(error < 1e-3, "{turns} turns: {error}");
    }
}

#[test]
fn plate_strip_rolls_up_to_the_circle_within_a_thousandth() {
    let (length, width) = (12.0, 1.0);
    let mut grid = Grid::new([48, 2], plate(1.2e6, 0.0, 0.1), |xi, eta| {
        Vector3::new(length * xi, width * (eta - 0.5), 0.0)
    });
    for node in grid.side(false) {
        grid.model.clamp(node);
    }
    let tip = grid.side(true);
    for share in [0.05, 0.1, 0.2, 0.3, 0.4, 0.5, 0.75, 1.0] {
        let mut loads = Loads::none(grid.model.nodes.len());
        for (&node, part) in tip.iter().zip(line_shares(&grid.model, &tip)) {
            loads.moment_n_m[node].y = -share * TAU * 100.0 / length * part;
        }
        let (state, report) = solve(&grid.model, &loads, 1);
        let exact = circle(length, share * TAU);
        let moved = state.displacement[tip[1]];
        let error = ((moved.x - exact[0]) / length).hypot((moved.z - exact[1]) / length);
        println!("strip, {share}: {moved:.5?} off by {error:.1e} in {report:?}");
        assert!(error < 1e-3, "{share}: {error}");
    }
}
