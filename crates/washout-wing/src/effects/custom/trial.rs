//! Trial of a formula before a wing flies with it: at its places, chords, speeds and angles, with the derivatives of flight.

use super::Custom;
use super::section::Section;
use super::target::{ALONG, CHORD, TWIST_RATE, UNITS, VARIABLES};
use crate::aero::Flow;
use crate::effects::{Dual, EffectError, StripPlace};
use crate::geometry::Planform;
use crate::input::design::Design;

/// Parts of the span, and of a spar, at whose ends a formula is tried.
const PARTS: u32 = 20;
/// Angles of attack at which it is tried, deg, besides that of the untwisted wing.
const ANGLES_DEG: [f64; 6] = [-40.0, -5.0, 0.0, 5.0, 45.0, 80.0];
/// Shares of a flapping wing's speed at mid-stroke, as it meets them over the stroke.
const STROKE: [f64; 3] = [1.0, 0.5, 0.01];

impl Custom {
    /// Refuses a formula that is not finite, or a stiffness that is not positive, somewhere on the outline of a design.
    ///
    /// # Errors
    /// With the place where it is not.
    pub(in crate::effects) fn try_out(&self, design: &Design, strength: f64) -> Result<(), EffectError> {
        let length_m = design.planform.length_mm.value() * 1e-3;
        let planform = self.planform(design);
        for part in 0..=PARTS {
            let r_m = length_m * f64::from(part) / f64::from(PARTS);
            let chord_m = planform.as_ref().map_or(0.0, |planform| planform.chord_m(r_m));
            match self.target.is_stiffness() {
                true => self.try_stiffness(design, r_m, chord_m, strength)?,
                false => self.try_in_flight(design, r_m, chord_m)?,
            }
        }
        Ok(())
    }

    /// Refuses a formula that is not finite on a strip of the wing, at the speed that it flies with.
    ///
    /// # Errors
    /// With the angle at which it is not.
    pub fn try_on_strip(&self, place: &StripPlace) -> Result<(), EffectError> {
        let speed_m_s = place.flow.map_or(0.0, |flow| flow.velocity(place.r_m).norm());
        self.try_section(&Section::of(place), speed_m_s)
    }

    /// The factor of a stiffness, which stays positive.
    fn try_stiffness(
        &self,
        design: &Design,
        r_m: f64,
        chord_m: f64,
        strength: f64,
    ) -> Result<(), EffectError> {
        let mut at = self.constants(design, r_m);
        at[CHORD] = chord_m;
        let parts = if self.formula.uses(ALONG) { PARTS } else { 0 };
        for part in 0..=parts {
            at[ALONG] = f64::from(part) / f64::from(PARTS);
            let value = self.formula.value(&at);
            if value.is_finite() && 1.0 + strength * (value - 1.0) > 0.0 {
                continue;
            }
            let problem = format!("it is {value}");
            return Err(self.no_value(
                &problem,
                &at,
                "write a factor that stays positive from base to tip",
            ));
        }
        Ok(())
    }

    fn try_in_flight(&self, design: &Design, r_m: f64, chord_m: f64) -> Result<(), EffectError> {
        let flow = Flow::from_design(design);
        let (speed_m_s, shares, rates): (f64, &[f64], [f64; 3]) = match &flow {
            None => (0.0, &[1.0], [0.0; 3]),
            Some(Flow::Steady { speed_m_s, .. }) => (*speed_m_s, &[1.0], [0.0; 3]),
            Some(flow @ Flow::Flapping { frequency_hz, .. }) => {
                // a radian of twist at the frequency of the stroke
                let rate = std::f64::consts::TAU * frequency_hz;
                (
                    flow.velocity_at_phase(r_m, 0.0).norm(),
                    &STROKE,
                    [0.0, -rate, rate],
                )
            }
        };
        let rates = if self.formula.uses(TWIST_RATE) {
            &rates[..]
        } else {
            &rates[..1]
        };
        for share in shares {
            for &twist_rate_rad_s in rates {
                let section = Section {
                    design,
                    r_m,
                    chord_m,
                    root_angle_rad: flow.map_or(0.0, |flow| flow.root_angle_rad()),
                    density_kg_m3: design.air.density_kg_m3.value(),
                    twist_rate_rad_s,
                };
                self.try_section(&section, share * speed_m_s)?;
            }
        }
        Ok(())
    }

    /// The formula at one section, at all angles.
    fn try_section(&self, section: &Section, speed_m_s: f64) -> Result<(), EffectError> {
        let angles = ANGLES_DEG.map(f64::to_radians);
        for alpha in angles.into_iter().chain([section.root_angle_rad]) {
            let speed_squared = Dual::from_re(speed_m_s * speed_m_s).derivative(1);
            let at = self.on_strip(section, Dual::from_re(alpha).derivative(0), speed_squared);
            let found = self.formula.value(&at);
            let slopes = found
                .eps
                .unwrap_generic(nalgebra::Const::<6>, nalgebra::Const::<1>);
            let (problem, cure) = match found.re.is_finite() {
                false => (
                    format!("it is {}", found.re),
                    "write a formula that stays finite on the whole wing, e.g. with max(…, 1e-6)",
                ),
                true if slopes.iter().all(|slope| slope.is_finite()) => continue,
                true => (
                    format!(
                        "its value is {}, but its change with angle and speed is not finite",
                        found.re
                    ),
                    "without that change nobody knows whether the wing stands stable; keep roots and powers away from 0, \
                     e.g. sqrt(max(abs(twist), 1e-6))",
                ),
            };
            let at: Vec<f64> = at.iter().map(|variable| variable.re).collect();
            return Err(self.no_value(&problem, &at, cure));
        }
        Ok(())
    }

    /// The refusal, with the variables that the formula names as it sees them.
    fn no_value(&self, problem: &str, at: &[f64], cure: &str) -> EffectError {
        let mut place = format!("x = {:.2}", at[0]);
        for (variable, unit) in (1..VARIABLES.len())
            .zip(UNITS)
            .filter(|(variable, _)| self.formula.uses(*variable))
        {
            place += &match variable {
                ALONG => format!(", along = {:.2}", at[ALONG]),
                _ => format!(", {} = {:.5} {unit}", VARIABLES[variable], at[variable]),
            };
        }
        EffectError::NoValue {
            name: self.name.clone(),
            text: self.formula.text.clone(),
            problem: format!("{problem} at {place}"),
            cure: cure.to_string(),
        }
    }

    /// The outline, if the formula asks for its chord; a wing that is meshed has one.
    pub(super) fn planform(&self, design: &Design) -> Option<Planform> {
        self.formula
            .uses(CHORD)
            .then(|| Planform::from_design(design).ok())?
    }
}
