//! Hencky's membrane: a flat round film, held at its rim, under even pressure.
//!
//! Hencky 1915, corrected series of Fichter, NASA TP-3658 (1997).
//!
//! ```text
//!   ↑ ↑ p ↑ ↑            w₀ = C(ν) a (p a / (E t))^(1/3), no tension at rest, no bending stiffness
//!  |_________| 2a        σ_r at the centre = S(ν) (E p² a² / t²)^(1/3)
//! ```
//!
//! C(0.3) = 0.653509, S(0.3) = 0.431101: own solution of the differential equation to 10 digits (the often quoted 0.662
//! belongs to ν ≈ 0.265). Small deflection, dead pressure. Both film laws: one that wrinkles, one that carries compression.

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Sheet;
use crate::verify::answer::equilibrium;
use crate::verify::grid::{Grid, disc, film, plate};
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

const RADIUS_M: f64 = 0.05;

const SOURCE: &str = "differential equation, 10 digits (Hencky 1915, Fichter 1997)";

const DEFLECTION: Quantity = Quantity {
    reference: || vec![0.653_509],
    source: SOURCE,
    tolerance: 0.01,
    order: Order::Theory(2.0),
    ..Quantity::BLANK
};

const TENSION: Quantity = Quantity {
    reference: || vec![0.431_101],
    order: Order::Exempt("stress of single triangles"),
    ..DEFLECTION
};

/// The case.
pub const CASE: Case = Case {
    name: "hencky-membrane",
    title: "Hencky's membrane: round film under even pressure, ν = 0.3",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "deflection of the centre, carrying compression",
            ..DEFLECTION
        },
        Quantity {
            name: "tension of the centre, carrying compression",
            ..TENSION
        },
        Quantity {
            name: "deflection of the centre, tension field",
            ..DEFLECTION
        },
        Quantity {
            name: "tension of the centre, tension field",
            ..TENSION
        },
    ],
    short: Level::Middle,
    run,
};

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let cells = level.times(8);
    // so thin that bending is nothing: w₀/t is about 150
    let base = plate(1e9, 0.3, 1e-5);
    let [w_carries, n_carries] = centre(cells, film(base, 1.0), progress)?;
    let [w_field, n_field] = centre(cells, film(base, 1e-4), progress)?;
    Ok(Answer::new(
        format!("{cells} across"),
        [w_carries, n_carries, w_field, n_field],
    ))
}

/// Deflection over a (p a/(E t))^(1/3) and membrane force over (E t p² a²)^(1/3) at the centre.
fn centre(cells: usize, sheet: Sheet, progress: &Progress) -> Result<[f64; 2], VerifyError> {
    let mut grid = Grid::new([cells, cells], sheet, |xi, eta| RADIUS_M * disc(xi, eta))?;
    grid.hold(&grid.rim(), [true, true, true, false, false, false]);
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
    let share = (pressure * RADIUS_M / stretching).cbrt();
    Ok([
        state.displacement[centre].z / (RADIUS_M * share),
        mean / (stretching * (pressure * RADIUS_M).powi(2)).cbrt(),
    ])
}
