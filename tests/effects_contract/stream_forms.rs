//! Effects of a wing in a steady stream: for each the case of its card, on a stiff wing in the full model.

use std::f64::consts::{PI, TAU};

use washout::input::design::Design;

use crate::air_forms::{FILM, close, strips};
use crate::closed_forms::{rectangle, with};
use crate::structure_forms::also;

const SPEED_M_S: f64 = 10.0;
const ALPHA_DEG: f64 = 2.0;
/// ½ρU², Pa.
const PRESSURE_PA: f64 = 0.5 * 1.2 * SPEED_M_S * SPEED_M_S;

/// A stiff wing of 100 mm with thin-airfoil sections, at 2 deg in a stream.
fn in_stream() -> Design {
    rectangle(&format!(
        "{FILM}[steady]\nspeed_m_s = {SPEED_M_S:?}\nroot_angle_deg = {ALPHA_DEG:?}\n\
         [air]\ncoefficients = 'thin-airfoil'\nlift_slope_per_rad = {TAU:?}\n"
    ))
}

/// Lift coefficient over the angle of attack (1/rad) and drag over lift.
fn slope_and_glide(design: &Design) -> (f64, f64) {
    let strips = strips(design, 0.0);
    let area_m2: f64 = strips.iter().map(|strip| strip.width_m * strip.chord_m).sum();
    let sum = |of: &dyn Fn(usize) -> f64| (0..strips.len()).map(|k| of(k) * strips[k].width_m).sum::<f64>();
    let (lift, drag) = (sum(&|k| strips[k].lift), sum(&|k| strips[k].drag));
    (
        lift / (PRESSURE_PA * area_m2 * ALPHA_DEG.to_radians()),
        drag / lift,
    )
}

/// On an ellipse of aspect ratio A = 8 R/(π c₀), cut where its chord is 3 % of that at the root: a = 2π/(1 + 2/A), and the lift leans back by C_L/(π A) everywhere.
#[test]
fn an_elliptic_wing_in_a_stream_has_the_lift_slope_of_prandtl() {
    let root_mm = 20.0;
    let point = |step: u32| {
        let place = (f64::from(step) / 60.0 * 0.49 * PI).sin();
        [
            100.0 * place / (0.49 * PI).sin(),
            root_mm * (1.0 - place * place).sqrt(),
        ]
    };
    let mut design = in_stream();
    design.planform.outline = Some((0..=60).map(point).collect());
    let aspect = 8.0 * 100.0 / (PI * root_mm);
    let (slope, glide) = slope_and_glide(&design);
    close(slope, TAU, 1e-6);
    assert!(glide.abs() < 1e-12);
    let (slope, glide) = slope_and_glide(&with(design, "finite-span-downwash", 1.0));
    let expected = TAU / (1.0 + 2.0 / aspect);
    close(slope, expected, 5e-3);
    close(glide, expected * ALPHA_DEG.to_radians() / (PI * aspect), 2e-2);
}

/// A rectangle of 100 × 20 mm, by the series with 80 terms in another program: 5.04679 on a wall (A = 10), 4.31412 free at both ends (A = 5); and half of the
/// downwash is not half of the loss.
#[test]
fn a_rectangle_on_a_wall_lifts_more_than_one_that_is_free_at_both_ends() {
    let full = with(in_stream(), "finite-span-downwash", 1.0);
    close(slope_and_glide(&full).0, 5.046_79, 3e-3);
    let free = also(full, "effects.finite-span-downwash.wall", 0.0);
    close(slope_and_glide(&free).0, 4.314_12, 6e-3);
    // the load falls toward the tip
    let strips = strips(&with(in_stream(), "finite-span-downwash", 1.0), 0.0);
    let lift = |r_mm: f64| {
        let near = |a: &&crate::air_forms::Found| (1e3 * a.r_m - r_mm).abs();
        let found = strips.iter().min_by(|a, b| near(a).total_cmp(&near(b))).unwrap();
        found.lift / (PRESSURE_PA * 0.02 * TAU * ALPHA_DEG.to_radians())
    };
    close(lift(50.0), 1.0 - 0.1403, 0.01);
    assert!(lift(99.0) < 0.4, "{}", lift(99.0));
}

#[test]
fn tip_losses_of_a_flapping_wing_are_refused_in_a_stream_and_the_downwash_of_a_stream_on_a_flapping_wing() {
    let refused = |design: Design, words: &str| {
        let error = washout::effects::bind(&design).unwrap_err().to_string();
        assert!(error.contains(words), "{error}");
    };
    for name in ["tip-loss-prandtl", "tip-loss-exponential"] {
        refused(with(in_stream(), name, 0.5), "does not flap");
    }
    let flapping = rectangle("[flapping]\nfrequency_hz = 20.0\nhalf_amplitude_deg = 30.0\n");
    refused(with(flapping, "finite-span-downwash", 1.0), "no steady stream");
}
