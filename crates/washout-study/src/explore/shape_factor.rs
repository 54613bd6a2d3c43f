//! The shape factor of a twisted wing: the strength of an effect that raises lift with twist, fitted to the effective lift
//! coefficients of several measured wings together.
//!
//! The paper's formula is not published. Here it is any effect whose strength raises lift; predicted is the mean lift of a
//! profile with the effect over that without, at the same stroke. A prior: what it says beyond the measured profiles is an
//! assumption.

use crate::coupling::BladeAir;
use crate::geometry::Planform;
use crate::input::design::Design;
use crate::lift::{Stroke, TwistAlongSpan};

use super::blades::Blades;
use super::error::ExploreError;

/// A measured wing.
#[derive(Debug, Clone, PartialEq)]
pub struct Gained {
    /// Its name.
    pub name: String,
    /// Its twist at mid-stroke.
    pub twist: TwistAlongSpan,
    /// Its effective lift coefficient over that of a wing without twist, measured.
    pub effective: f64,
    /// Standard deviation of that.
    pub sigma: f64,
}

/// The fitted strength of an effect.
#[derive(Debug, Clone, PartialEq)]
pub struct ShapeFactor {
    /// Name of the effect.
    pub effect: String,
    /// Its strength.
    pub strength: f64,
    /// Standard deviation of the strength; widened by the misfit where the wings disagree, 0 where it was given.
    pub sigma: f64,
    /// Misfit: sum of squares in standard deviations.
    pub chi_squared: f64,
    /// Measured wings less one.
    pub freedom: usize,
    /// Effective lift coefficient of each wing as fitted.
    pub fitted: Vec<(Gained, f64)>,
}

/// The design with an effect at a strength; other numbers of its table stay.
pub fn with_strength(design: &Design, effect: &str, strength: f64) -> Design {
    let mut design = design.clone();
    let table = design.effects.entry(effect.to_string()).or_default();
    table.insert("strength".to_string(), toml::Value::Float(strength));
    design
}

impl ShapeFactor {
    /// The least-squares strength.
    ///
    /// # Errors
    /// If nothing is measured, the effect is none or changes nothing, or the lift cannot be computed.
    pub fn fit(
        design: &Design,
        planform: &Planform,
        stroke: Stroke,
        air_table: Option<&[[f64; 3]]>,
        effect: &str,
        wings: &[Gained],
    ) -> Result<ShapeFactor, ExploreError> {
        if wings.is_empty() {
            return Err(ExploreError::NothingToFit);
        }
        let lifts = |strength: f64| -> Result<Vec<f64>, ExploreError> {
            let changed = with_strength(design, effect, strength);
            let air = BladeAir::new(&changed, planform, air_table)?;
            let blades = Blades::new(planform, air, stroke, crate::lift::twist::PAPER_RAMP);
            let lift = |wing: &Gained| Ok(blades.totals(&wing.twist)?.lift_n);
            wings.iter().map(lift).collect()
        };
        let bare = lifts(0.0)?;
        if !lifts(1e-4)?
            .iter()
            .chain(&bare)
            .all(|lift| lift.is_finite() && *lift > 0.0)
        {
            return Err(ExploreError::NoGain {
                effect: effect.to_string(),
            });
        }
        let gains = |strength: f64| -> Result<Vec<f64>, ExploreError> {
            let lifts = lifts(strength)?;
            Ok(lifts.iter().zip(&bare).map(|(lift, bare)| lift / bare).collect())
        };
        let [strength, information] = least_squares(wings, &gains, effect)?;
        let found = gains(strength)?;
        let fitted: Vec<(Gained, f64)> = wings.iter().cloned().zip(found).collect();
        let misfit = |(wing, gain): &(Gained, f64)| ((wing.effective - gain) / wing.sigma).powi(2);
        let chi_squared: f64 = fitted.iter().map(misfit).sum();
        let freedom = wings.len() - 1;
        let widened = match freedom {
            0 => 1.0,
            freedom => (chi_squared / freedom as f64).max(1.0).sqrt(),
        };
        Ok(ShapeFactor {
            effect: effect.to_string(),
            strength,
            sigma: widened / information.sqrt(),
            chi_squared,
            freedom,
            fitted,
        })
    }
}

/// The strength by Gauss and Newton's method, and its Fisher information.
fn least_squares(
    wings: &[Gained],
    gains: &dyn Fn(f64) -> Result<Vec<f64>, ExploreError>,
    effect: &str,
) -> Result<[f64; 2], ExploreError> {
    let (mut strength, step) = (0.0, 1e-4);
    let mut information = 0.0;
    for _ in 0..30 {
        let (now, next) = (gains(strength)?, gains(strength + step)?);
        let (mut pull, mut weight) = (0.0, 0.0);
        for ((wing, now), next) in wings.iter().zip(&now).zip(&next) {
            let slope = (next - now) / step / wing.sigma;
            pull += slope * (wing.effective - now) / wing.sigma;
            weight += slope * slope;
        }
        if !(weight > 1e-12 && weight.is_finite()) {
            return Err(ExploreError::NoGain {
                effect: effect.to_string(),
            });
        }
        information = weight;
        strength += pull / weight;
        if (pull / weight).abs() < 1e-9 * strength.abs().max(1e-3) {
            break;
        }
    }
    Ok([strength, information])
}
