//! A thin strip takes a load that bends it far at one go, on coarse meshes as on fine ones.
//!
//! ```text
//!   clamped |================  → bends up until its end points at some 65°
//! ```
//!
//! 70 × 20 × 0.086 mm, E 70 GPa, ν 0; F L²/(E I) = 4 across the end, dead. Elastica: the end rises by 46.8975 mm.

use nalgebra::Vector3;

use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads, NewtonSettings};
use washout::verify::grid::{Grid, plate};

#[test]
fn a_strip_that_bends_by_a_radian_takes_its_load_at_one_go_in_some_fifteen_steps_on_any_mesh() {
    let (length_m, width_m, thickness_m, e_pa) = (0.070, 0.020, 86e-6, 70e9);
    for count in [[20, 6], [30, 10], [60, 18]] {
        let sheet = plate(e_pa, 0.0, thickness_m);
        let corner = |xi: f64, eta: f64| Vector3::new(length_m * xi, width_m * eta, 0.0);
        let mut grid = Grid::new(count, sheet, corner).expect("a grid");
        grid.hold(&grid.side(false), [true; 6]);
        let force_n = 4.0 * e_pa * width_m * f64::powi(thickness_m, 3) / 12.0 / f64::powi(length_m, 2);
        let loads = grid.end_force(force_n * Vector3::z());
        let nodes = grid.model.nodes.len();
        let mut state = State::at_rest(nodes);
        let mut equilibrium = Equilibrium::new(&grid.model).expect("a pattern");
        let (none, settings, quiet) = (Loads::none(nodes), NewtonSettings::default(), Progress::quiet());
        let report = equilibrium.solve(&mut state, &none, &loads, &settings, &quiet);
        let report = report.expect("an equilibrium");
        assert_eq!(report.increments, 1, "{count:?}: {report:?}");
        assert!(report.steps <= 20, "{count:?}: {report:?}");
        let rise_mm = 1e3 * state.displacement[grid.node([count[0], 0])].z;
        assert!(
            (rise_mm / 46.897_49 - 1.0).abs() < 1e-3,
            "{count:?}: {rise_mm} mm"
        );
    }
}
