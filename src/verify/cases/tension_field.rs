//! A stretched strip in bending that wrinkles on its inner side.
//!
//! Stein & Hedgepeth, NASA TN D-813 (1961).
//!
//! ```text
//!   |~~~~~~~~~~~~~~~~~|      strip h × L under tension P and moment M: beyond M = P h/6 a band b wrinkles,
//!   |                 |-> P  b/h = 3 M/(P h) − 1/2, its stress is nothing, the rest's is a triangle:
//!   |_________________|) M   κ = 2 P / (E t (h − b)²); before, κ = 12 M/(E t h³)
//! ```

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::structure::Loads;
use crate::verify::answer::equilibrium;
use crate::verify::chain::section;
use crate::verify::grid::{Grid, film, plate};
use crate::verify::{Answer, Case, Kind, Level, Order, Quantity, VerifyError};

/// M/(P h).
const MOMENTS: [f64; 5] = [0.1, 1.0 / 6.0, 0.25, 0.3, 0.35];

const YOUNG_PA: f64 = 2.5e9;
const THICKNESS_M: f64 = 6e-6;

/// The case.
pub const CASE: Case = Case {
    name: "tension-field",
    title: "Stretched strip in bending, wrinkled on its inner side",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "curvature",
        unit: "P/(E t h²)",
        reference: || MOMENTS.map(curvature).to_vec(),
        source: "closed form (Stein & Hedgepeth 1961)",
        tolerance: 0.01,
        order: Order::Exempt("the edge of the wrinkles runs through elements"),
        ..Quantity::BLANK
    }],
    short: Level::Fine,
    run,
};

/// κ E t h²/P.
fn curvature(moment: f64) -> f64 {
    let wrinkled = (3.0 * moment - 0.5).max(0.0);
    if wrinkled > 0.0 {
        2.0 / (1.0 - wrinkled).powi(2)
    } else {
        12.0 * moment
    }
}

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let cells = level.times(8);
    let mut found = Vec::new();
    for moment in MOMENTS {
        found.push(bent(cells, moment, progress)?);
    }
    Ok(Answer::curves(format!("{cells} × {cells}"), [found]))
}

fn bent(cells: usize, moment: f64, progress: &Progress) -> Result<f64, VerifyError> {
    let (height, length) = (0.02, 0.02);
    let stretching = YOUNG_PA * THICKNESS_M;
    let sheet = film(plate(YOUNG_PA, 0.34, THICKNESS_M), 1e-4);
    let mut grid = Grid::new([cells, cells], sheet, |xi, eta| {
        Vector3::new(length * xi, height * (eta - 0.5), 0.0)
    })?;
    // the loaded end stays straight and may contract
    let stiff = grid.model.add_section(section([1e-3, 1e7, 1e7, 1e3, 1e3, 1e3])?);
    let end = grid.side(true);
    for pair in end.windows(2) {
        grid.model.add_beam([pair[0], pair[1]], &Vector3::z(), stiff)?;
    }
    let all: Vec<usize> = (0..grid.model.nodes.len()).collect();
    grid.hold(&all, [false, false, true, true, true, false]);
    grid.hold(&grid.side(false), [true, false, false, false, false, false]);
    grid.model.clamp(grid.node([0, cells / 2]));
    let tension = 1e-5 * stretching * height;
    let mut loads = Loads::none(grid.model.nodes.len());
    let middle = end[cells / 2];
    loads.force_n[middle].x = tension;
    loads.moment_n_m[middle].z = moment * tension * height;
    let state = equilibrium(&grid.model, &loads, progress)?;
    let turn = state.rotation[middle].scaled_axis().z;
    Ok(turn / length * stretching * height * height / tension)
}
