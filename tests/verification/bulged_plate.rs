//! A limit that is known: a plate that carries pressure as a film, by stretching in large rotation, is too soft.
//!
//! Hencky's membrane (as in `verify`: ν = 0.3, radius 5000 or 500 thicknesses, deflection 0.03 radii) with plates in place of
//! films. The rotations about the normals of facets that meet at an angle strain the optimal triangle, and bending is
//! too weak to hold them. The figures stand in docs/elements.md and with `Compression::Carries`.

use nalgebra::Vector3;
use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads, NewtonSettings, Sheet};
use washout::verify::grid::{Grid, disc, film, plate};

const RADIUS_M: f64 = 0.05;
/// Deflection of the centre over a (p a/(E t))^(1/3).
const EXACT: f64 = 0.653509;

/// Deflection of the centre over the exact one, and negative pivots there; the load in so many parts.
fn ratio(cells: usize, sheet: Sheet, increments: usize) -> (f64, usize) {
    let mut grid = Grid::new([cells, cells], sheet, |xi, eta| RADIUS_M * disc(xi, eta)).unwrap();
    let rim = grid.rim();
    grid.hold(&rim, [true, true, true, false, false, false]);
    let pressure = 1e-4 * sheet.e_pa * sheet.thickness_m / RADIUS_M;
    let load = grid.pressure(pressure * Vector3::z());
    let nodes = grid.model.nodes.len();
    let (mut state, none) = (State::at_rest(nodes), Loads::none(nodes));
    let mut equilibrium = Equilibrium::new(&grid.model).unwrap();
    let settings = NewtonSettings {
        increments,
        ..NewtonSettings::default()
    };
    equilibrium
        .solve(&mut state, &none, &load, &settings, &Progress::quiet())
        .unwrap();
    let negative = equilibrium.factorize(&state, &load).unwrap();
    let found = state.displacement[grid.centre()].z / (RADIUS_M * 1e-4_f64.cbrt()) / EXACT;
    println!(
        "{cells} cells, t/a = {:.0e}, load in {increments}: {found:.4} of the exact deflection, {negative} negative pivots",
        sheet.thickness_m / RADIUS_M
    );
    (found, negative)
}

#[test]
fn a_plate_bulged_as_a_film_is_too_soft_by_what_is_documented() {
    // sides of 1250 and 125 thicknesses; finer: 1.181 and (load in 20 parts) 1.129 with sides of 625 and 312, 1.007 and 1.002 with 62 and 31
    for (thickness_m, expected) in [(1e-5, 1.191), (1e-4, 1.044)] {
        let (found, _) = ratio(8, plate(1e9, 0.3, thickness_m), 1);
        assert!((found - expected).abs() < 0.005, "{found}");
    }
    // the film that carries compression, on the same mesh
    let (found, _) = ratio(8, film(plate(1e9, 0.3, 1e-5), 1.0), 1);
    assert!((found - 1.014).abs() < 0.005, "{found}");
}

/// Which equilibrium a number of increments ends in is decided by rounding, so none of them is asserted alone.
#[test]
fn a_plate_bulged_as_a_film_has_several_equilibria_side_by_side() {
    let sheet = plate(1e9, 0.3, 1e-5);
    let found: Vec<f64> = (1..=16).map(|increments| ratio(8, sheet, increments).0).collect();
    assert!(
        found.iter().all(|ratio| (1.17..1.23).contains(ratio)),
        "{found:?}"
    );
    let largest = found.iter().copied().fold(f64::MIN, f64::max);
    let smallest = found.iter().copied().fold(f64::MAX, f64::min);
    assert!(largest - smallest > 0.01, "{found:?}");
}
