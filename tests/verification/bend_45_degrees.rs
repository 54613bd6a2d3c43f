//! The 45° bend: a curved cantilever in space under a tip force across its plane.
//!
//! Bathe & Bolourchi, Int. J. Numer. Methods Eng. 14 (1979) 961-986.
//!
//! ```text
//!   y                      * tip (70.711, 29.289, 0), dead force P = 600 along z
//!   |                 .
//!   |          .            arc of 45°, R = 100, section 1 × 1
//!   +----.-------------- x  E = 1e7, G = 5e6
//!  clamp
//! ```
//!
//! Reference: own solution of the rod equations by shooting (to 1e-11) with EA = 1e7, GA = 5/6 · 5e6, EI = 1e7/12 and
//! the polar torsion constant J = 1/6 that the literature uses (St Venant's 0.1406 moves the result by 1 %):
//! u = (−23.560582, −13.604632, 53.475478). Published: Bathe & Bolourchi (−23.5, −13.4, 53.4).

use nalgebra::Vector3;
use washout::structure::Loads;

use crate::support::{chain, section, solve};

const REFERENCE: Vector3<f64> = Vector3::new(-23.560_582, -13.604_632, 53.475_478);

/// Largest error of the tip's displacement components, each relative to its own.
fn error(elements: usize) -> f64 {
    let radius = 100.0;
    let points = (0..=elements)
        .map(|i| {
            let angle = std::f64::consts::FRAC_PI_4 * i as f64 / elements as f64;
            radius * Vector3::new(angle.sin(), 1.0 - angle.cos(), 0.0)
        })
        .collect();
    let (shear, bending) = (5.0 / 6.0 * 5e6, 1e7 / 12.0);
    let model = chain(
        points,
        &Vector3::z(),
        section([1e7, shear, shear, 5e6 / 6.0, bending, bending]),
    );
    let mut loads = Loads::none(elements + 1);
    loads.force_n[elements] = 600.0 * Vector3::z();
    let (state, report) = solve(&model, &loads, 1);
    let tip = state.displacement[elements];
    println!("{elements} elements: {tip:?} {report:?}");
    (tip - REFERENCE).component_div(&REFERENCE).amax()
}

#[test]
fn tip_is_within_half_a_percent_with_8_elements_and_a_twentieth_with_32() {
    let (coarse, fine) = (error(8), error(32));
    println!("45° bend: {coarse:.2e} with 8, {fine:.2e} with 32");
    assert!(coarse < 5e-3, "{coarse}");
    assert!(fine < 5e-4, "{fine}");
}
