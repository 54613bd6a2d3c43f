//! Morley's rhombic plate, acute angle 30°, simply supported, under even pressure.
//!
//! Morley, Skew Plates and Structures (1963). Its value is from memory, so it is shown and not judged; the moments are
//! singular in the obtuse corners, which makes uniform meshes converge slowly.
//!
//! ```text
//!      ________    side a, ν = 0.3; centre deflection in q a⁴/D
//!     /_______/ 30°
//! ```

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::answer::linear;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

/// The case.
pub const CASE: Case = Case {
    name: "morley-skew-plate",
    title: "Morley's skew plate, 30°, simply supported, under even pressure",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "deflection of the centre",
        unit: "q a⁴/D",
        reference: || vec![4.08e-4],
        source: "Morley 1963",
        confidence: Confidence::Memory,
        order: Order::Exempt("singular obtuse corners"),
        others: &[Other {
            value: "below 4.2005e-4",
            source: "Morley's elements, 256 a side, falling",
            confidence: Confidence::Derived,
        }],
        ..Quantity::BLANK
    }],
    short: Level::Middle,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let (cells, thickness, poisson) = (level.times(8), 1e-3, 0.3);
    let (sine, cosine) = 30.0_f64.to_radians().sin_cos();
    let mut grid = Grid::new([cells, cells], plate(1.0, poisson, thickness), |xi, eta| {
        Vector3::new(xi + cosine * eta, sine * eta, 0.0)
    })?;
    grid.hold(&grid.rim(), [true, true, true, false, false, true]);
    let bending = thickness.powi(3) / 12.0 / (1.0 - poisson * poisson);
    let loads = grid.pressure(Vector3::z());
    let deflection = linear(&grid.model, &loads)?[grid.centre()][0].z * bending;
    Ok(Answer::new(grid.words(), [deflection]))
}
