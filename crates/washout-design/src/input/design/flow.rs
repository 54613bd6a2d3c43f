//! The flow and the laws of the air.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::zero;
use crate::input::quantity::Quantity;

/// Flapping about the stroke axis with the root pitch at its stop.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Flapping {
    /// The flapping frequency.
    #[schemars(extend("minimum" = 0.1, "maximum" = 1000.0, "examples" = [23.0]))]
    pub frequency_hz: Quantity,
    /// The half-stroke amplitude (half of the peak-to-peak stroke angle).
    #[schemars(extend("minimum" = 0.1, "maximum" = 90.0, "examples" = [34.5]))]
    pub half_amplitude_deg: Quantity,
    /// The angle of attack of the root at the pitch stop.
    #[serde(default = "stop_angle")]
    #[schemars(extend("minimum" = 0.0, "maximum" = 90.0, "examples" = [45.0]))]
    pub stop_angle_deg: Quantity,
    /// The phase of the stroke; 0 is mid-stroke (largest speed), 90 the reversal.
    #[serde(default = "zero")]
    #[schemars(extend("minimum" = -90.0, "maximum" = 90.0, "examples" = [0.0]))]
    pub phase_deg: Quantity,
}

/// Steady stream.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
pub struct Steady {
    /// The speed of the stream.
    #[schemars(extend("minimum" = 0.0, "maximum" = 300.0, "examples" = [8.0]))]
    pub speed_m_s: Quantity,
    /// The angle of attack of the root.
    #[schemars(extend("minimum" = -90.0, "maximum" = 90.0, "examples" = [5.0]))]
    pub root_angle_deg: Quantity,
    /// The sweep of the span axis, positive aft.
    #[serde(default = "zero")]
    #[schemars(extend("minimum" = -80.0, "maximum" = 80.0, "examples" = [0.0]))]
    pub sweep_deg: Quantity,
}

/// Air and its laws.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields, default)]
pub struct Air {
    /// The density of the air.
    #[schemars(extend("minimum" = 0.0, "maximum" = 2000.0, "examples" = [1.2]))]
    pub density_kg_m3: Quantity,
    /// The set of force coefficients.
    #[schemars(extend("examples" = ["dickinson"]))]
    pub coefficients: Coefficients,
    /// The lift-curve slope for `thin-airfoil`.
    #[schemars(extend("minimum" = 0.0, "maximum" = 20.0, "examples" = [5.7]))]
    pub lift_slope_per_rad: Quantity,
    /// The table of coefficients for `table`: a CSV file with the columns alpha_deg, cl, cd; or a polar as XFLR5, XFoil or
    /// airfoiltools.com writes it.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["coefficients.csv"]))]
    pub table: Option<String>,
    /// The law of the centre of pressure; without it `fixed` with `thin-airfoil` coefficients, whose theory has a quarter of the chord, and
    /// `dickson` with all others.
    #[serde(skip_serializing_if = "Option::is_none")]
    #[schemars(extend("examples" = ["dickson"]))]
    pub centre_of_pressure: Option<CentreOfPressure>,
    /// The centre of pressure for `fixed`, as a fraction of the chord from the leading edge.
    #[schemars(extend("minimum" = 0.01, "maximum" = 0.99, "examples" = [0.25]))]
    pub centre_of_pressure_fraction: Quantity,
}

/// Force coefficients by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Coefficients {
    /// Dickinson, Lehmann & Sane 1999.
    Dickinson,
    /// Whitney & Wood 2010.
    WhitneyWood,
    /// Linear lift with a given slope, no drag.
    ThinAirfoil,
    /// Table from a file.
    Table,
}

/// Centre-of-pressure law by name.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum CentreOfPressure {
    /// Dickson, Straw & Dickinson 2006.
    Dickson,
    /// Public code of the Purdue hummingbird robot.
    Purdue,
    /// A fixed fraction of the chord.
    Fixed,
}

impl Air {
    /// The law of the centre of pressure that is in force.
    pub fn centre_of_pressure(&self) -> CentreOfPressure {
        self.centre_of_pressure.unwrap_or(match self.coefficients {
            Coefficients::ThinAirfoil => CentreOfPressure::Fixed,
            Coefficients::Dickinson | Coefficients::WhitneyWood | Coefficients::Table => {
                CentreOfPressure::Dickson
            }
        })
    }
}

fn stop_angle() -> Quantity {
    Quantity::Stated(45.0)
}

impl Default for Air {
    fn default() -> Self {
        Air {
            density_kg_m3: Quantity::Stated(1.20),
            coefficients: Coefficients::Dickinson,
            lift_slope_per_rad: Quantity::Stated(std::f64::consts::TAU),
            table: None,
            centre_of_pressure: None,
            centre_of_pressure_fraction: Quantity::Stated(0.25),
        }
    }
}
