//! The paper's wings, for tests: planform, air, stroke and twist as first stated.

use crate::aero::{AirLaw, CentreOfPressureLaw, CoefficientLaw};
use crate::geometry::Planform;

use super::stroke::Stroke;
use super::twist::TwistAlongSpan;

/// The built planform: held inboard of 2 % and cut at 99 % of the length.
pub fn planform() -> Planform {
    planform_closed(0.02, 0.99)
}

/// The planform of the paper before it is built: the chord runs on until almost nothing is left at both ends.
pub fn planform_unclosed() -> Planform {
    planform_closed(1e-4, 0.9999)
}

fn planform_closed(base_closure: f64, tip_cut: f64) -> Planform {
    let text = format!(
        "format = 1\nname = \"paper\"\nrod = []\n[planform]\nlength_mm = 70.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\n\
         root_offset_mm = 38.0\nbase_closure = {base_closure}\ntip_cut = {tip_cut}\n"
    );
    Planform::from_design(&toml::from_str(&text).expect("a design")).expect("a planform")
}

/// Dickinson's coefficients at 1.20 kg/m³.
pub fn law() -> AirLaw {
    AirLaw {
        density_kg_m3: 1.2,
        coefficients: CoefficientLaw::Dickinson,
        centre_of_pressure: CentreOfPressureLaw::Dickson,
    }
}

/// Half amplitude 34.5° (assumed) with the stop at 45°.
pub fn stroke(frequency_hz: f64) -> Stroke {
    Stroke {
        frequency_hz,
        half_amplitude_rad: 34.5_f64.to_radians(),
        stop_angle_rad: 45.0_f64.to_radians(),
    }
}

/// Twist v1 as first stated.
pub fn twist_v1() -> TwistAlongSpan {
    TwistAlongSpan::from_stages(&[[48.0, 0.29], [22.0, 1.39]]).expect("stages")
}

/// Twist v2 as first stated.
pub fn twist_v2() -> TwistAlongSpan {
    TwistAlongSpan::from_stages(&[[20.0, 0.0], [50.0, 0.46]]).expect("stages")
}
