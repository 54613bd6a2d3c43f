//! The air of a design: density, coefficients and centre of pressure.

use crate::input::design::{CentreOfPressure, Coefficients, Design};

use super::centre_of_pressure::CentreOfPressureLaw;
use super::coefficients::CoefficientLaw;
use super::error::AeroError;
use super::pressure::{LARGEST_CENTRE, SMALLEST_CENTRE};
use super::table::CoefficientTable;

/// Density and laws of the air.
#[derive(Debug, Clone, PartialEq)]
pub struct AirLaw {
    /// Density, kg/m³.
    pub density_kg_m3: f64,
    /// Lift and drag coefficients.
    pub coefficients: CoefficientLaw,
    /// Centre of pressure.
    pub centre_of_pressure: CentreOfPressureLaw,
}

impl AirLaw {
    /// The air of a design; `table` holds rows `[alpha_deg, cl, cd]` and is needed for `coefficients = "table"`.
    ///
    /// # Errors
    /// A missing or bad table; density, lift slope or fixed centre of pressure that the laws cannot use.
    pub fn from_design(design: &Design, table: Option<&[[f64; 3]]>) -> Result<Self, AeroError> {
        let air = &design.air;
        let density_kg_m3 = within(
            "air.density_kg_m3",
            air.density_kg_m3.value(),
            [0.0, 1e5],
            "air at sea level has 1.2",
        )?;
        let coefficients = match air.coefficients {
            Coefficients::Dickinson => CoefficientLaw::Dickinson,
            Coefficients::WhitneyWood => CoefficientLaw::WhitneyWood,
            Coefficients::ThinAirfoil => CoefficientLaw::ThinAirfoil {
                lift_slope_per_rad: within(
                    "air.lift_slope_per_rad",
                    air.lift_slope_per_rad.value(),
                    [0.0, 100.0],
                    "give it per radian; thin-airfoil theory has 6.283",
                )?,
            },
            Coefficients::Table => {
                CoefficientLaw::Table(CoefficientTable::new(table.ok_or(AeroError::TableMissing)?)?)
            }
        };
        let centre_of_pressure = match air.centre_of_pressure() {
            CentreOfPressure::Dickson => CentreOfPressureLaw::Dickson,
            CentreOfPressure::Purdue => CentreOfPressureLaw::Purdue,
            CentreOfPressure::Fixed => CentreOfPressureLaw::Fixed {
                fraction: within(
                    "air.centre_of_pressure_fraction",
                    air.centre_of_pressure_fraction.value(),
                    [SMALLEST_CENTRE, LARGEST_CENTRE],
                    "a pressure of one sign cannot have its centre nearer to an edge; 0.25 is the quarter chord",
                )?,
            },
        };
        Ok(AirLaw {
            density_kg_m3,
            coefficients,
            centre_of_pressure,
        })
    }

    /// Refuses an angle of attack (rad) that the laws do not cover; to be asked of every converged strip.
    ///
    /// # Errors
    /// [`AeroError::OutsideTable`]; the laws by name cover every angle.
    pub fn check(&self, alpha_rad: f64) -> Result<(), AeroError> {
        match &self.coefficients {
            CoefficientLaw::Table(table) => table.check(alpha_rad),
            _ => Ok(()),
        }
    }
}

fn within(key: &'static str, value: f64, range: [f64; 2], cure: &'static str) -> Result<f64, AeroError> {
    let [low, high] = range;
    if (low..=high).contains(&value) {
        return Ok(value);
    }
    Err(AeroError::OutOfRange {
        key,
        value,
        low,
        high,
        cure,
    })
}

#[cfg(test)]
mod tests {
    use super::AirLaw;
    use crate::aero::error::AeroError;
    use crate::input::design::{CentreOfPressure, Coefficients, Design};

    fn design() -> Design {
        let text = "format = 1\nname = \"test\"\nrod = []\n[planform]\nlength_mm = 70.0\n";
        toml::from_str(text).expect("a minimal design")
    }

    #[test]
    fn the_default_air_is_dickinson_with_dickson_at_1_2_kg_m3() {
        let law = AirLaw::from_design(&design(), None).expect("default air");
        assert_eq!(law.density_kg_m3, 1.2);
        assert!((law.coefficients.lift_and_drag(std::f64::consts::FRAC_PI_4).0 - 1.8046).abs() < 1e-4);
        assert!((law.centre_of_pressure.fraction(0.0_f64) - 0.05).abs() < 1e-15);
        assert_eq!(law.check(3.0), Ok(()));
    }

    #[test]
    fn a_thin_airfoil_has_its_load_at_a_quarter_of_the_chord_unless_the_design_says_otherwise() {
        let mut design = design();
        design.air.coefficients = Coefficients::ThinAirfoil;
        let centre = |design: &Design| {
            let law = AirLaw::from_design(design, None).expect("a law");
            law.centre_of_pressure.fraction(0.1_f64)
        };
        assert_eq!(centre(&design), 0.25);
        design.air.centre_of_pressure = Some(CentreOfPressure::Dickson);
        assert!((centre(&design) - (0.82 * 0.1 / std::f64::consts::PI + 0.05)).abs() < 1e-12);
    }

    #[test]
    fn a_table_is_asked_for_used_and_checked() {
        let mut design = design();
        design.air.coefficients = Coefficients::Table;
        assert_eq!(AirLaw::from_design(&design, None), Err(AeroError::TableMissing));
        let law = AirLaw::from_design(&design, Some(&[[0.0, 0.0, 0.1], [20.0, 1.0, 0.3]])).expect("a table");
        assert_eq!(law.check(-0.3), Ok(()));
        assert!(law.check(0.4).is_err());
    }

    #[test]
    fn a_centre_that_no_one_signed_pressure_has_is_refused() {
        let mut design = design();
        design.air.centre_of_pressure = Some(CentreOfPressure::Fixed);
        design.air.centre_of_pressure_fraction = 0.0.into();
        let error = AirLaw::from_design(&design, None).expect_err("too far forward");
        assert_eq!(
            error.to_string(),
            "air.centre_of_pressure_fraction = 0 lies outside [0.01, 0.99]; a pressure of one sign cannot have its \
             centre nearer to an edge; 0.25 is the quarter chord"
        );
        design.air.density_kg_m3 = f64::NAN.into();
        assert!(AirLaw::from_design(&design, None).is_err());
    }
}
