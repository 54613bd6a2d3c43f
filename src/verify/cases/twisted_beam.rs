//! The twisted beam of MacNeal & Harder: a strip pretwisted by 90°, clamped at one end, loaded at the other.
//!
//! MacNeal & Harder, Finite Elem. Anal. Des. 1 (1985) 3-20.
//!
//! ```text
//!  |====≈≈≈≈∥   L = 12, b = 1.1, t = 0.32, E = 29e6, ν = 0.22; unit force along the width (in plane)
//!                or along the thickness (out of plane) of the free end
//! ```

use std::f64::consts::FRAC_PI_2;

use nalgebra::Vector3;

use crate::progress::Progress;
use crate::verify::cantilever::middle_of_end;
use crate::verify::grid::{Grid, plate};
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

const PART: Quantity = Quantity {
    source: "MacNeal & Harder 1985, in FinEtools",
    confidence: Confidence::Seen,
    tolerance: 0.01,
    order: Order::Exempt("singular corners at the clamp"),
    ..Quantity::BLANK
};

/// The case.
pub const CASE: Case = Case {
    name: "twisted-beam",
    title: "Twisted beam of medium thickness (t/b = 0.29), pretwist 90°, unit tip force",
    kind: Kind::Verification,
    quantities: &[
        Quantity {
            name: "tip, force along the width",
            reference: || vec![5.424e-3],
            others: &[Other {
                value: "5.424535e-3",
                source: "exact beam of Zupan & Saje",
                confidence: Confidence::Seen,
            }],
            ..PART
        },
        Quantity {
            name: "tip, force along the thickness",
            reference: || vec![1.754e-3],
            others: &[Other {
                value: "1.753248e-3",
                source: "exact beam of Zupan & Saje",
                confidence: Confidence::Seen,
            }],
            ..PART
        },
    ],
    short: Level::Middle,
    run,
};

fn run(level: Level, _: &Progress) -> Result<Answer, VerifyError> {
    let grid = twisted([level.times(12), level.times(2)], 0.32)?;
    let tips = [
        middle_of_end(&grid, Vector3::z())?,
        middle_of_end(&grid, Vector3::y())?,
    ];
    Ok(Answer::new(grid.words(), tips))
}

/// The strip in a thickness.
///
/// # Errors
/// If a triangle has no area.
pub fn twisted(count: [usize; 2], thickness: f64) -> Result<Grid, VerifyError> {
    let grid = Grid::new(count, plate(29e6, 0.22, thickness), |xi, eta| {
        let (sine, cosine) = (FRAC_PI_2 * xi).sin_cos();
        Vector3::new(12.0 * xi, 1.1 * (eta - 0.5) * cosine, 1.1 * (eta - 0.5) * sine)
    })?;
    Ok(grid)
}
