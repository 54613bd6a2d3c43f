//! A wing on its stroke: outline, air, stroke and twist together.

use crate::coupling::BladeAir;
use crate::geometry::Planform;

use super::error::LiftError;
use super::means::StrokeMeans;
use super::stroke::{Instant, Stroke, forces_at_phase, stroke_means};
use super::twist::TwistHistory;

/// A wing on its stroke.
#[derive(Debug, Clone)]
pub struct Flight {
    /// Outline.
    pub planform: Planform,
    /// Air, with the effects that act on it.
    pub air: BladeAir,
    /// Stroke.
    pub stroke: Stroke,
    /// Twist over the stroke.
    pub twist: TwistHistory,
}

impl Flight {
    /// Means over the stroke of one wing.
    ///
    /// # Errors
    /// As [`stroke_means`].
    pub fn means(&self) -> Result<StrokeMeans, LiftError> {
        stroke_means(&self.planform, &self.air, &self.stroke, &self.twist)
    }

    /// Forces on one wing at `count` phases of one half-stroke, from reversal to reversal.
    ///
    /// # Errors
    /// As [`forces_at_phase`].
    pub fn instants(&self, count: usize) -> Result<Vec<Instant>, LiftError> {
        let last = count.saturating_sub(1).max(1) as f64;
        (0..count)
            .map(|index| {
                let phase = std::f64::consts::PI * (index as f64 / last - 0.5);
                forces_at_phase(&self.planform, &self.air, &self.stroke, &self.twist, phase)
            })
            .collect()
    }
}

/// Power to drive a wing against its own inertia.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct InertialPower {
    /// Inertia about the stroke axis, kg·m².
    pub inertia_kg_m2: f64,
    /// Largest inertial power of the stroke, W: ½ I Φ² ω³.
    pub largest_w: f64,
    /// Mean of what the drive gives if nothing comes back as the wing slows down, air and inertia together, W; with a spring
    /// that gives all back it is the aerodynamic power.
    pub mean_without_recovery_w: f64,
}

impl InertialPower {
    /// Of a wing of a given inertia (kg·m²) about the stroke axis; sweep Φ sin ωt, its instants as in [`Flight::instants`].
    pub fn of(flight: &Flight, inertia_kg_m2: f64, instants: &[Instant]) -> InertialPower {
        let rate = std::f64::consts::TAU * flight.stroke.frequency_hz;
        let scale = inertia_kg_m2 * flight.stroke.half_amplitude_rad.powi(2) * rate.powi(3);
        let total = |instant: &Instant| {
            let (sin, cos) = instant.phase_rad.sin_cos();
            let power_w = instant.power_w - scale * sin * cos;
            if power_w < 0.0 { 0.0 } else { power_w }
        };
        let means = instants.windows(2).map(|pair| {
            let width = (pair[1].phase_rad - pair[0].phase_rad) / std::f64::consts::PI;
            0.5 * width * (total(&pair[0]) + total(&pair[1]))
        });
        InertialPower {
            inertia_kg_m2,
            largest_w: 0.5 * scale,
            mean_without_recovery_w: means.sum(),
        }
    }
}
