//! Hencky's membrane: a flat round film, held at its rim, under even pressure.
//!
//! Hencky 1915, corrected series of Fichter, NASA TP-3658 (1997).
//!
//! ```text
//!   ↑ ↑ p ↑ ↑            w₀ = C(ν) a (p a / (E t))^(1/3), no tension at rest, no bending stiffness
//!  |_________| 2a        N_r = S(ν) (E t p² a²)^(1/3) at the centre and at the rim
//! ```
//!
//! C and S: own solution of the differential equation to 10 digits (the often quoted 0.662 belongs to ν ≈ 0.265, not to
//! 0.3). Small deflection, dead pressure. Both film laws: one that carries compression, one that wrinkles.

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::{Equilibrium, Loads, Sheet};
use crate::verify::answer::equilibrium;
use crate::verify::grid::{Grid, disc, film, plate};
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

const RADIUS_M: f64 = 0.05;

/// ν, C, S at the centre, S at the rim.
const TABLE: [[f64; 4]; 7] = [
    [0.0, 0.718391, 0.405103, 0.289372],
    [0.2, 0.677503, 0.420683, 0.316109],
    [0.25, 0.665858, 0.425612, 0.324171],
    [0.3, 0.653509, 0.431101, 0.332957],
    [0.34, 0.643062, 0.435967, 0.340590],
    [0.4, 0.626318, 0.444218, 0.353233],
    [0.5, 0.594939, 0.461328, 0.378412],
];

/// The row of ν = 0.3.
const USUAL: usize = 3;

const PART: Quantity = Quantity {
    source: "differential equation, 10 digits (Hencky 1915, Fichter 1997)",
    tolerance: 0.01,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "hencky-membrane",
    title: "Hencky's membrane: round film under even pressure, ν = 0 to 0.5",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "deflection of the centre",
            reference: || TABLE.map(|row| row[1]).to_vec(),
            ..PART
        },
        Quantity {
            name: "tension of the centre",
            reference: || TABLE.map(|row| row[2]).to_vec(),
            order: Order::Exempt("stress of single triangles"),
            ..PART
        },
        Quantity {
            name: "tension of the rim, from the reactions",
            reference: || TABLE.map(|row| row[3]).to_vec(),
            ..PART
        },
        Quantity {
            name: "deflection of the centre, tension field",
            reference: || vec![TABLE[USUAL][1]],
            ..PART
        },
        Quantity {
            name: "tension of the centre, tension field",
            reference: || vec![TABLE[USUAL][2]],
            order: Order::Exempt("stress of single triangles"),
            ..PART
        },
    ],
    short: Level::Fine,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let cells = level.times(8);
    // so thin that bending is nothing: w₀/t is about 150
    let sheet = |poisson: f64, residual: f64| film(plate(1e9, poisson, 1e-5), residual);
    let mut found = Vec::new();
    for row in TABLE {
        found.push(inflated(cells, sheet(row[0], 1.0), progress)?);
    }
    let field = inflated(cells, sheet(TABLE[USUAL][0], 1e-4), progress)?;
    let curve = |k: usize| found.iter().map(|found| found[k]).collect();
    Ok(Answer::curves(
        format!("{cells} across"),
        [curve(0), curve(1), curve(2), vec![field[0]], vec![field[1]]],
    ))
}

/// Deflection over a (p a/(E t))^(1/3); membrane force at the centre and at the rim over (E t p² a²)^(1/3).
fn inflated(cells: usize, sheet: Sheet, progress: &Progress) -> Result<[f64; 3], VerifyError> {
    let mut grid = Grid::new([cells, cells], sheet, |xi, eta| RADIUS_M * disc(xi, eta))?;
    let mut rim = grid.rim();
    rim.sort_unstable();
    rim.dedup();
    grid.hold(&rim, [true, true, true, false, false, false]);
    let stretching = sheet.e_pa * sheet.thickness_m;
    let pressure = 1e-4 * stretching / RADIUS_M;
    let state = equilibrium(&grid.model, &grid.pressure(pressure * Vector3::z()), progress)?;
    let centre = grid.centre();
    let around: Vec<f64> = (grid.model.shells.iter())
        .filter(|shell| shell.nodes.contains(&centre))
        .map(|shell| {
            let (u, q) = grid.model.shell_state(shell, &state);
            let n = shell.membrane_force(&sheet, &u, &q, &Vector3::x());
            0.5 * (n[0] + n[1])
        })
        .collect();
    let mean = around.iter().sum::<f64>() / around.len() as f64;
    let solver = Equilibrium::new(&grid.model)?;
    let none = Loads::none(grid.model.nodes.len());
    let force = grid.model.residual(&solver.pattern, &state, &none);
    let outward = rim.iter().map(|&node| {
        let at = solver.pattern.freedom(node, 0);
        Vector3::from_column_slice(&force[at..at + 3]).dot(&grid.model.nodes[node].normalize())
    });
    let rim_force = outward.sum::<f64>() / (std::f64::consts::TAU * RADIUS_M);
    let unit = (stretching * (pressure * RADIUS_M).powi(2)).cbrt();
    Ok([
        state.displacement[centre].z / (RADIUS_M * (pressure * RADIUS_M / stretching).cbrt()),
        mean / unit,
        rim_force / unit,
    ])
}
