//! Divergence of the uniform wing swept forward and aft: bending and torsion together against the strip equations.
//!
//! Along the span, with φ nose up and w the bending of the elastic axis, d behind the leading edge:
//! GJ φ″ = −e ℓ, EI w⁗ = ℓ, ℓ = q cos²Λ c a (φ − tan Λ (w′ + d φ′)); clamped at 0, free at L. The strips see the slope of
//! the leading edge, hence d φ′; without it the equations are those of Bisplinghoff, Ashley & Halfman (1955), section 8-3,
//! whose exact divergence pressures over that of the unswept wing are known for e/c = 1/4, GJ = EI.

use nalgebra::{Matrix3, SVector};

use crate::progress::Progress;
use crate::verify::strip_wing::StripWing;
use crate::verify::{Answer, Case, Confidence, Kind, Level, Order, Other, Quantity, VerifyError};

/// Sweep, deg, positive aft.
const SWEEPS_DEG: [f64; 5] = [-30.0, -20.0, -10.0, 0.0, 2.0];

/// Centre of pressure, fraction of the chord: almost on the leading edge, so that d is near e.
const CENTRE: f64 = 0.01;

const ARM_M: f64 = 0.05;

/// The case.
pub const CASE: Case = Case {
    name: "swept-wing-divergence",
    title: "Divergence of a uniform wing swept by -30° to 2°",
    kind: Kind::Verification,
    quantities: &[Quantity {
        name: "divergence pressure over that unswept",
        reference: || {
            SWEEPS_DEG
                .map(|sweep| exact_ratio(sweep, axis_m()).unwrap_or(f64::NAN))
                .to_vec()
        },
        source: "strip equations of the leading edge, integrated",
        tolerance: 5e-4,
        order: Order::Theory(2.0),
        others: &[Other {
            value: "0.241038, 0.292990, 0.430247, 1, 1.406019 where the strips see the elastic axis",
            source: "strip equations of Bisplinghoff, Ashley & Halfman 1955",
            confidence: Confidence::Derived,
        }],
        ..Quantity::BLANK
    }],
    short: Level::Fine,
    run,
};

fn axis_m() -> f64 {
    ARM_M + CENTRE * StripWing::WORKED.chord_m
}

fn run(level: Level, progress: &Progress) -> Result<Answer, VerifyError> {
    let columns = level.times(8);
    let mut found = Vec::new();
    for sweep_deg in SWEEPS_DEG {
        let wing = StripWing {
            columns,
            axis_m: axis_m(),
            centre: CENTRE,
            shear_n: 1e6,
            sweep_deg,
            ..StripWing::WORKED
        };
        let missing = VerifyError::Missing {
            what: "divergence of the strip equations",
        };
        let exact = exact_ratio(sweep_deg, axis_m()).ok_or(missing)?;
        let wing = StripWing {
            q_pa: 0.5 * exact * wing.divergence_pa(),
            ..wing
        };
        found.push(wing.found_divergence_pa(progress)? / wing.divergence_pa());
    }
    Ok(Answer::curves(format!("{columns} beams and strips"), [found]))
}

/// What is left at the free end (φ′, w″, w‴) of the three motions that the clamped end leaves: singular at divergence.
fn free_end(ratio: f64, sweep_rad: f64, axis_m: f64) -> f64 {
    let wing = StripWing {
        axis_m: ARM_M + StripWing::WORKED.centre * StripWing::WORKED.chord_m,
        ..StripWing::WORKED
    };
    let factor =
        ratio * wing.divergence_pa() * sweep_rad.cos().powi(2) * wing.chord_m * std::f64::consts::TAU;
    // φ, φ′, w′, w″, w‴
    let slope = |y: &SVector<f64, 5>| {
        let lift = factor * (y[0] - sweep_rad.tan() * (y[2] + axis_m * y[1]));
        SVector::<f64, 5>::from([
            y[1],
            -ARM_M * lift / wing.gj_n_m2,
            y[3],
            y[4],
            lift / wing.ei_n_m2,
        ])
    };
    let end = |free: usize| {
        let mut y = SVector::<f64, 5>::zeros();
        y[[1, 3, 4][free]] = 1.0;
        let steps = 400;
        let h = wing.length_m / f64::from(steps);
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

/// Lowest divergence pressure over that of the unswept wing; none below ten times that.
fn exact_ratio(sweep_deg: f64, axis_m: f64) -> Option<f64> {
    let at = |ratio: f64| free_end(ratio, sweep_deg.to_radians(), axis_m).signum();
    let start = at(0.0);
    let steps = (1..=1000).map(|step| 0.01 * f64::from(step));
    let mut high = steps.into_iter().find(|&ratio| at(ratio) != start)?;
    let mut low = high - 0.01;
    for _ in 0..50 {
        let middle = 0.5 * (low + high);
        if at(middle) == start {
            low = middle;
        } else {
            high = middle;
        }
    }
    Some(low)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_equations_give_the_known_pressures_where_the_strips_see_the_elastic_axis() {
        let known = [0.241038, 0.292990, 0.430247, 1.0, 1.406019];
        for (sweep_deg, known) in SWEEPS_DEG.into_iter().zip(known) {
            let found = exact_ratio(sweep_deg, 0.0).unwrap();
            assert!(
                (found / known - 1.0).abs() < 2e-6,
                "{sweep_deg} deg: {found} {known}"
            );
        }
    }
}
