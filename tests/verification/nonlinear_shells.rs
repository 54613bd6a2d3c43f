//! Large deflections of shells: cantilever under end shear, slit ring plate, open cylinder pulled apart.
//!
//! Sze, Liu & Lo, Finite Elem. Anal. Des. 40 (2004) 1551-1569, cases 3.1, 3.3 and 3.5 (3.2 is in `roll_up`); values as
//! transcribed by the public test suites of Elmer, NGSolve and MIGFEM. Their elements are shear-flexible and fine.
//!
//! ```text
//!  ====|↑ P      ◯ cut, one lip clamped,    ( ) → P   free ends, pulled apart in the middle
//!  clamp           the other lifted         
//! ```

use std::f64::consts::{FRAC_PI_2, TAU};

use nalgebra::Vector3;
use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads, Model, NewtonSettings};

use crate::support::{Grid, line_shares, off, plate, solve};

#[test]
fn cantilever_under_end_shear_follows_the_table() {
    // L = 10, b = 1, h = 0.1, E = 1.2e6, ν = 0, P = 4
    let mut grid = Grid::new([32, 2], plate(1.2e6, 0.0, 0.1), |xi, eta| {
        Vector3::new(10.0 * xi, eta - 0.5, 0.0)
    });
    for node in grid.side(false) {
        grid.model.clamp(node);
    }
    let tip = grid.side(true);
    for (share, u, w) in [
        (0.1, 0.103, 1.309),
        (0.25, 0.563, 3.015),
        (0.5, 1.604, 4.933),
        (1.0, 3.286, 6.698),
    ] {
        let mut loads = Loads::none(grid.model.nodes.len());
        for (&node, part) in tip.iter().zip(line_shares(&grid.model, &tip)) {
            loads.force_n[node].z = 4.0 * share * part;
        }
        let (state, report) = solve(&grid.model, &loads, 1);
        let moved = state.displacement[tip[1]];
        let error = [off(-moved.x, u), off(moved.z, w)];
        println!(
            "end shear {share}: {moved:.4?} off by {error:.4?} in {} steps",
            report.steps
        );
        // the table has three digits
        assert!(
            error[1] < 2e-3 && (moved.x + u).abs() < 4e-3,
            "{share}: {error:?}"
        );
    }
}

#[test]
fn slit_ring_plate_lifts_by_the_table_within_a_percent() {
    // radii 6 and 10, h = 0.03, E = 21e6, ν = 0, line force 0.8 on one lip
    let count = [80, 10];
    let mut grid = Grid::new(count, plate(21e6, 0.0, 0.03), |xi, eta| {
        let (sine, cosine) = (TAU * xi).sin_cos();
        Vector3::new(cosine, sine, 0.0) * (6.0 + 4.0 * eta)
    });
    for node in grid.side(false) {
        grid.model.clamp(node);
    }
    let lip = grid.side(true);
    let table = [(0.1, 5.876, 4.277), (0.5, 13.768, 10.468), (1.0, 17.528, 13.891)];
    follow(&grid.model, &table, |share, loads| {
        for (&node, part) in lip.iter().zip(line_shares(&grid.model, &lip)) {
            loads.force_n[node].z = 0.8 * share * part;
        }
        [lip[count[1]], lip[0]]
    });
}

#[test]
fn open_cylinder_is_pulled_out_by_the_table_within_a_percent() {
    // eighth of R = 4.953, L = 10.35, h = 0.094, E = 10.5e6, ν = 0.3125; P = 40000, a quarter of it here
    let mut grid = Grid::new([16, 16], plate(10.5e6, 0.3125, 0.094), |xi, eta| {
        let (sine, cosine) = (FRAC_PI_2 * eta).sin_cos();
        Vector3::new(4.953 * sine, 5.175 * xi, 4.953 * cosine)
    });
    for node in grid.side(false) {
        grid.model.hold(node, [false, true, false, true, false, true]);
    }
    for node in grid.edge(false) {
        grid.model.hold(node, [true, false, false, false, true, true]);
    }
    for node in grid.edge(true) {
        grid.model.hold(node, [false, false, true, true, true, false]);
    }
    let pulled = grid.node([0, 0]);
    let table = [0.1, 0.25, 0.5, 0.75, 1.0]
        .into_iter()
        .zip([1.707, 2.180, 2.473, 2.692, 2.768]);
    let table: Vec<_> = table.map(|(share, w)| (share, w, w)).collect();
    follow(&grid.model, &table, |share, loads| {
        loads.force_n[pulled].z = 10_000.0 * share;
        [pulled, pulled]
    });
}

/// Solves for one share of the load after the other, from the last shape; two deflections along z against the table.
fn follow(model: &Model, table: &[(f64, f64, f64)], load: impl Fn(f64, &mut Loads) -> [usize; 2]) {
    let mut equilibrium = Equilibrium::new(model).unwrap();
    let mut state = State::at_rest(model.nodes.len());
    let mut from = Loads::none(model.nodes.len());
    for &(share, first, second) in table {
        let mut to = Loads::none(model.nodes.len());
        let nodes = load(share, &mut to);
        let report = equilibrium
            .solve(
                &mut state,
                &from,
                &to,
                &NewtonSettings::default(),
                &Progress::quiet(),
            )
            .unwrap();
        from = to;
        let lifted = nodes.map(|node| state.displacement[node].z);
        let error = [lifted[0] / first - 1.0, lifted[1] / second - 1.0];
        println!("share {share}: off by {error:.4?} in {report:?}");
        assert!(error.iter().all(|e| e.abs() < 1e-2), "{share}: {error:?}");
    }
}
