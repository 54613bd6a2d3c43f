//! Divergence of the uniform wing swept forward and aft: bending and torsion together against the strip equations.
//!
//! Along the span, with φ nose up and w the bending of the elastic axis, d behind the leading edge:
//! GJ φ″ = −e ℓ, EI w⁗ = ℓ, ℓ = q cos²Λ c a (φ − tan Λ (w′ + d φ′)); clamped at 0, free at L. The strips see the slope of
//! the leading edge, hence d φ′; without it the equations are those of Bisplinghoff, Ashley & Halfman (1955), section 8-3,
//! whose exact divergence pressures over that of the unswept wing are known for e/c = 1/4, GJ = EI.

use nalgebra::{Matrix3, SVector};

use crate::uniform_wing::{CHORD_M, GJ, LENGTH_M, Setup, uniform};

const EI: f64 = 10.0;
const SLOPE: f64 = std::f64::consts::TAU;
const ARM_M: f64 = 0.05;

/// Divergence pressure of the unswept wing, Pa.
fn unswept_pa() -> f64 {
    (0.5 * std::f64::consts::PI / LENGTH_M).powi(2) * GJ / (ARM_M * CHORD_M * SLOPE)
}

/// What is left at the free end (φ′, w″, w‴) of the three motions that the clamped end leaves: singular at divergence.
fn free_end(q_pa: f64, sweep_rad: f64, axis_m: f64) -> f64 {
    let factor = q_pa * sweep_rad.cos().powi(2) * CHORD_M * SLOPE;
    // φ, φ′, w′, w″, w‴
    let slope = |y: &SVector<f64, 5>| {
        let lift = factor * (y[0] - sweep_rad.tan() * (y[2] + axis_m * y[1]));
        SVector::<f64, 5>::from([y[1], -ARM_M * lift / GJ, y[3], y[4], lift / EI])
    };
    let end = |free: usize| {
        let mut y = SVector::<f64, 5>::zeros();
        y[[1, 3, 4][free]] = 1.0;
        let steps = 400;
        let h = LENGTH_M / f64::from(steps);
        for _ in 0..steps {
            let a = slope(&y);
            let b = slope(&(y + 0.5 * h * a));
            let c = slope(&(y + 0.5 * h * b));
            let d = slope(&(y + h * c));
            y += h / 6.0 * (a + 2.0 * b + 2.0 * c + d);
        }
        [y[1], y[3], y[4]]
    };
    let ends = [0, 1, 2].map(end);
    Matrix3::from_fn(|row, column| ends[column][row]).determinant()
}

/// Lowest divergence pressure over that of the unswept wing.
fn exact_ratio(sweep_deg: f64, axis_m: f64) -> f64 {
    let at = |ratio: f64| free_end(ratio * unswept_pa(), sweep_deg.to_radians(), axis_m);
    let start = at(0.0).signum();
    let mut high = 0.01;
    while at(high).signum() == start {
        high += 0.01;
        assert!(high < 10.0, "no divergence at {sweep_deg} deg");
    }
    let mut low = high - 0.01;
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if at(middle).signum() == start {
            low = middle;
        } else {
            high = middle;
        }
    }
    low
}

#[test]
fn the_equations_give_the_known_pressures_where_the_strips_see_the_elastic_axis() {
    for (sweep_deg, known) in [
        (-30.0, 0.241038),
        (-20.0, 0.292990),
        (-10.0, 0.430247),
        (0.0, 1.0),
        (2.0, 1.406019),
    ] {
        let found = exact_ratio(sweep_deg, 0.0);
        assert!(
            (found / known - 1.0).abs() < 2e-6,
            "{sweep_deg} deg: {found} {known}"
        );
    }
}

#[test]
fn a_swept_wing_diverges_at_the_pressure_of_its_strip_equations() {
    let centre = 0.01;
    let axis_m = ARM_M + centre * CHORD_M;
    for sweep_deg in [-30.0, -20.0, -10.0, 0.0, 2.0] {
        let exact = exact_ratio(sweep_deg, axis_m);
        for (columns, allowed) in [(8, 0.005), (32, 0.0005)] {
            let solution = uniform(&Setup {
                columns,
                q_pa: 0.5 * exact * unswept_pa(),
                axis_m,
                sweep_deg,
                centre,
                shear_n: 1e6,
            })
            .solve();
            let found = 0.5 * exact * solution.report.critical_pressure_ratio.unwrap();
            println!(
                "{sweep_deg} deg, {columns} elements: {found:.5} exact {exact:.5} {:.1e}",
                found / exact - 1.0
            );
            assert!(
                (found / exact - 1.0).abs() < allowed,
                "{sweep_deg} deg: {found} {exact}"
            );
        }
    }
}
