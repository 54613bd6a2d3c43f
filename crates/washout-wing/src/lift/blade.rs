//! The air on a blade element: by its laws alone, or with the effects of a design.

use crate::aero::{AeroError, AirLaw};
use crate::coupling::{BladeAir, BladeSection};

/// What gives lift and drag of a blade element.
pub trait BladeLaw: Sync {
    /// Lift across the stream and drag along it, N/m.
    ///
    /// # Errors
    /// For an angle that a table of coefficients does not cover.
    fn force(&self, section: &BladeSection) -> Result<[f64; 2], AeroError>;

    /// Whether a section needs the rates of its motion.
    fn wants_motion(&self) -> bool {
        false
    }

    /// The laws by which forces hang on angle and speed alone, and on the speed by its square; none if an effect acts besides.
    fn plain(&self) -> Option<&AirLaw> {
        None
    }
}

impl BladeLaw for AirLaw {
    fn force(&self, section: &BladeSection) -> Result<[f64; 2], AeroError> {
        self.check(section.alpha_rad)?;
        let (cl, cd) = self.coefficients.lift_and_drag(section.alpha_rad);
        let load = 0.5 * self.density_kg_m3 * section.speed_m_s * section.speed_m_s * section.chord_m;
        Ok([load * cl, load * cd])
    }

    fn plain(&self) -> Option<&AirLaw> {
        Some(self)
    }
}

impl BladeLaw for BladeAir {
    fn force(&self, section: &BladeSection) -> Result<[f64; 2], AeroError> {
        BladeAir::force(self, section)
    }

    fn wants_motion(&self) -> bool {
        BladeAir::wants_motion(self)
    }

    fn plain(&self) -> Option<&AirLaw> {
        BladeAir::plain(self)
    }
}
