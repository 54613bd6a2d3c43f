//! The clamped uniform wing in strip theory at, beyond and away from its divergence.
//!
//! Its twist along the span and its divergence pressure against the closed forms are cases of `verify`
//! (`uniform_wing_twist`, `uniform_wing_divergence`, `uniform_wing_washout`); here is what a solve says where there is
//! nothing to be found, and where nothing drives the wing.

use washout::coupling::CouplingError;
use washout::progress::Progress;
use washout::verify::VerifyError;
use washout::verify::strip_wing::StripWing;

/// The wing of the closed forms at a share of its divergence pressure.
fn at(columns: usize, ratio: f64) -> StripWing {
    StripWing {
        columns,
        q_pa: ratio * StripWing::WORKED.divergence_pa(),
        ..StripWing::WORKED
    }
}

/// How a solve fails.
fn failure(wing: StripWing) -> Option<CouplingError> {
    match wing.solve(&Progress::quiet()) {
        Ok(_) => None,
        Err(VerifyError::Coupling(error)) => Some(error),
        Err(other) => panic!("{other}"),
    }
}

#[test]
fn a_sweep_of_the_speed_ends_at_the_divergence_pressure_and_says_so() {
    let (mut stands, mut fails) = (0.9, 1.2);
    for _ in 0..10 {
        let middle = 0.5 * (stands + fails);
        match failure(at(8, middle)) {
            None => stands = middle,
            Some(CouplingError::Diverged { critical_ratio, .. }) => {
                assert!(
                    (critical_ratio * middle - 1.0).abs() < 0.005,
                    "{critical_ratio} at {middle}"
                );
                fails = middle;
            }
            Some(other) => panic!("at {middle} q_D: {other}"),
        }
    }
    println!("sweep: {stands} to {fails}");
    assert!(
        (stands - 1.0).abs() < 0.005 && (fails - 1.0).abs() < 0.005,
        "{stands} {fails}"
    );
}

#[test]
fn beyond_divergence_there_is_no_result_but_the_critical_pressure() {
    for ratio in [1.1, 2.0, 5.0, 20.0] {
        let Some(CouplingError::Diverged { critical_ratio, .. }) = failure(at(8, ratio)) else {
            panic!("no divergence at {ratio} q_D");
        };
        assert!(
            (critical_ratio * ratio - 1.0).abs() < 0.005,
            "{critical_ratio} at {ratio}"
        );
    }
}

#[test]
fn loaded_behind_its_axis_the_same_wing_never_diverges() {
    for ratio in [0.5, 4.0, 40.0] {
        let wing = StripWing {
            axis_m: 0.0,
            ..at(8, ratio)
        };
        let solution = wing.solve(&Progress::quiet()).unwrap();
        assert_eq!(solution.report.critical_pressure_ratio, None);
        assert_eq!(solution.report.negative_pivots, 0);
    }
}
