//! The weak spring that holds rotations about the normal of a film moves no result.
//!
//! ```text
//!  clamp |=====================  rod, round, carbon, 1 mm        film 6 µm between them, tension field,
//!        |  . film . . . . .     50 × 15 mm                      pressure 15 Pa across it
//!        |---------------------  spar, 0.3 mm
//! ```
//!
//! No publication: the spring's stiffness is a number of the method, so ten times more and ten times less of it must
//! leave deflection and twist as they are, to 1e-4.

use nalgebra::Vector3;
use washout::structure::section::BeamMaterial;
use washout::structure::{Compression, Section, Sheet};
use washout::verify::grid::{Grid, plate};

use crate::support::{off, solve};

/// Deflection (m) of the middle of the film and twist (rad) of the rod's tip.
fn answers(drilling_factor: f64) -> [f64; 2] {
    let sheet = Sheet {
        pretension_n_per_m: 1.0,
        compression: Compression::TensionField {
            residual: 1e-4,
            drilling_factor,
            slack: 0.0,
        },
        ..plate(2.5e9, 0.34, 6e-6)
    };
    let count = [20, 8];
    let mut grid = Grid::new(count, sheet, |xi, eta| Vector3::new(0.05 * xi, 0.015 * eta, 0.0)).unwrap();
    let carbon = BeamMaterial {
        e_pa: 120e9,
        g_pa: 4e9,
        density_kg_m3: 1600.0,
    };
    let rod = grid.model.add_section(Section::round(0.5e-3, &carbon));
    let spar = grid.model.add_section(Section::round(0.15e-3, &carbon));
    let lines = [
        (grid.edge(false), rod),
        (grid.edge(true), spar),
        (grid.side(true), spar),
    ];
    for (line, section) in lines {
        for pair in line.windows(2) {
            grid.model
                .add_beam([pair[0], pair[1]], &Vector3::z(), section)
                .unwrap();
        }
    }
    for node in grid.side(false) {
        grid.model.clamp(node);
    }
    let state = solve(&grid.model, &grid.pressure(15.0 * Vector3::z()));
    let tip = grid.node([count[0], 0]);
    [
        state.displacement[grid.node([10, 4])].z,
        state.rotation[tip].scaled_axis().x,
    ]
}

#[test]
fn ten_times_more_or_less_drilling_stiffness_moves_a_film_by_less_than_a_ten_thousandth() {
    let usual = answers(1.0);
    for factor in [0.1, 10.0] {
        let other = answers(factor);
        let moved = [off(other[0], usual[0]), off(other[1], usual[1])];
        println!("{usual:?}, × {factor}: {moved:?}");
        assert!(moved.iter().all(|m| *m < 1e-4), "{moved:?}");
    }
}
