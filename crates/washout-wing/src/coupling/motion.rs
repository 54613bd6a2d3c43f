//! What the periodic motion does at the phase of a design, frozen, for the effects that need rates.

use std::sync::{Arc, Mutex, PoisonError};

use super::error::CouplingError;
use super::periodic::{Periodic, PeriodicSettings, periodic_near};
use super::solution::Solution;
use super::wing::needs_motion;
use crate::effects::{Motion, StripMotion, bind};
use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::progress::Progress;
use crate::structure::state::State;

/// The motion that effects of a design are made from, at its phase, sought from a solution nearby if there is one; none where no
/// effect needs it.
///
/// # Errors
/// If its effects are not what their cards ask for, or as [`motion`].
pub fn motion_needed(
    design: &Design,
    mesh: &Mesh,
    air_table: Option<&[[f64; 3]]>,
    nearby: Option<&Solution>,
    progress: &Progress,
) -> Result<Option<Arc<Motion>>, CouplingError> {
    match bind(design)?.iter().any(needs_motion) {
        true => Ok(Some(Arc::new(motion(design, mesh, air_table, nearby, progress)?))),
        false => Ok(None),
    }
}

/// Motions of one wing, by the settings with which they were found: the strengths of effects that are made from its motion do not change it.
#[derive(Debug, Default)]
pub struct Motions(Mutex<Vec<(PeriodicSettings, Arc<Motion>)>>);

impl Motions {
    /// The motion with these settings, found once. Whoever asks must find the same.
    ///
    /// # Errors
    /// As `find`.
    pub fn by(
        &self,
        settings: PeriodicSettings,
        find: impl FnOnce(&PeriodicSettings) -> Result<Motion, CouplingError>,
    ) -> Result<Arc<Motion>, CouplingError> {
        // nothing that panics is done while it is locked
        let list = || self.0.lock().unwrap_or_else(PoisonError::into_inner);
        let known = list()
            .iter()
            .find(|own| own.0 == settings)
            .map(|own| own.1.clone());
        if let Some(known) = known {
            return Ok(known);
        }
        let found = Arc::new(find(&settings)?);
        list().push((settings, found.clone()));
        Ok(found)
    }

    /// As [`motion_needed`], of a design that [moves](super::mid_stroke::moving) as all others that ask here; `nearby` must be the same for all.
    ///
    /// # Errors
    /// As [`motion_needed`].
    pub fn needed(
        &self,
        design: &Design,
        mesh: &Mesh,
        air_table: Option<&[[f64; 3]]>,
        nearby: &Solution,
        progress: &Progress,
    ) -> Result<Option<Arc<Motion>>, CouplingError> {
        if !bind(design)?.iter().any(needs_motion) {
            return Ok(None);
        }
        let settings = PeriodicSettings::of_design(design)?;
        let find = |settings: &PeriodicSettings| {
            motion_by(settings, design, mesh, air_table, Some(nearby), progress)
        };
        self.by(settings, find).map(Some)
    }
}

/// The motion of a design at its phase. Effects that are made from it do not act back on it.
///
/// # Errors
/// As [`super::periodic()`].
pub fn motion(
    design: &Design,
    mesh: &Mesh,
    air_table: Option<&[[f64; 3]]>,
    nearby: Option<&Solution>,
    progress: &Progress,
) -> Result<Motion, CouplingError> {
    let settings = PeriodicSettings::of_design(design)?;
    motion_by(&settings, design, mesh, air_table, nearby, progress)
}

/// The same with settings that another design states.
///
/// # Errors
/// As [`super::periodic()`].
pub fn motion_by(
    settings: &PeriodicSettings,
    design: &Design,
    mesh: &Mesh,
    air_table: Option<&[[f64; 3]]>,
    nearby: Option<&Solution>,
    progress: &Progress,
) -> Result<Motion, CouplingError> {
    let periodic = periodic_near(design, mesh, air_table, settings, nearby, progress)?;
    let phase_deg = design
        .flapping
        .as_ref()
        .map_or(0.0, |flapping| flapping.phase_deg.value());
    periodic.at(phase_deg.to_radians())
}

impl Periodic {
    /// Loads and rates at a phase (rad), in the frame of its own half-stroke.
    ///
    /// # Errors
    /// If the air's force is not finite.
    pub fn at(&self, phase: f64) -> Result<Motion, CouplingError> {
        // the other half-stroke mirrors the first
        let phase = phase - (phase / std::f64::consts::PI).round() * std::f64::consts::PI;
        let fields = &self.fields;
        let deforming = self.acceleration(phase);
        let square = self.stroke.rate_rad_s.powi(2);
        let (sweep, pitch) = (
            self.stroke.sweep_acceleration(phase),
            square * self.stroke.pitch(phase)[2],
        );
        let rigid: Vec<f64> = (fields.sweep.iter().zip(&fields.pitch))
            .map(|(a, b)| sweep * a + pitch * b)
            .collect();
        let [wing, both] = &fields.mass;
        let air: Vec<f64> = both.iter().zip(wing).map(|(both, wing)| both - wing).collect();
        let resist = |mass: &[f64], acceleration: &[f64]| fields.inertia(mass, acceleration);
        let strips = self.stations_m().into_iter().filter_map(|r_m| {
            let [_, twist_rate_rad_s, twist_acceleration_rad_s2] = self.twist(r_m, phase)?;
            Some(StripMotion {
                r_m,
                twist_rate_rad_s,
                twist_acceleration_rad_s2,
            })
        });
        Ok(Motion {
            inertia: resist(wing, &deforming),
            moved_air: resist(&air, &deforming),
            moved_air_of_stroke: resist(&air, &rigid),
            strips: strips.collect(),
            drag_ratio: self.drag_ratio()?,
        })
    }

    /// Drag torque about the stroke axis at mid-stroke over that of the untwisted wing; 1 where there is no drag.
    fn drag_ratio(&self) -> Result<f64, CouplingError> {
        let Some(air) = &self.wing.air else {
            return Ok(1.0);
        };
        let offset_m = match air.flow {
            crate::aero::Flow::Flapping { root_offset_m, .. } => root_offset_m,
            crate::aero::Flow::Steady { .. } => 0.0,
        };
        let torque = |state: &State| {
            let strips = self.wing.strip_air(&self.wing.strips.shapes(state), false)?;
            let torque = strips.iter().zip(&self.wing.strips.strips).map(|(force, strip)| {
                let stream = air.flow.velocity(strip.r_m);
                force.total_n.dot(&stream) / stream.norm().max(f64::MIN_POSITIVE) * (strip.r_m + offset_m)
            });
            Ok::<f64, CouplingError>(torque.sum())
        };
        let (twisted, plain) = (torque(&self.still.state)?, torque(&self.still.rest)?);
        Ok(if plain > 0.0 && twisted > 0.0 {
            twisted / plain
        } else {
            1.0
        })
    }
}
