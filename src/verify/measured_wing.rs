//! A shipped design of a wing that was measured, and the measurement: both as shipped, nothing tuned.

use crate::input::design::Design;
use crate::input::measurement::{Channel, Measurement};
use crate::progress::Progress;
use crate::wing::WingModel;

use super::{Level, VerifyError};

/// A wing and what was measured on it.
#[derive(Debug, Clone, Copy)]
pub struct MeasuredWing {
    /// Text of the design.
    pub design: &'static str,
    /// Text of the measurement.
    pub measurement: &'static str,
}

/// The slender wing of Tang and Dowell.
pub const TANG_DOWELL: MeasuredWing = MeasuredWing {
    design: include_str!("../../designs/tang-dowell.toml"),
    measurement: include_str!("../../measurements/tang-dowell.csv"),
};

/// The tip of a loaded wing, against the unloaded one.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Tip {
    /// Mid-chord across the wing plane, mm, positive along +z.
    pub deflection_mm: f64,
    /// Mid-chord in the wing plane, mm, positive toward the trailing edge.
    pub chordwise_mm: f64,
    /// Twist, deg, positive washout.
    pub twist_deg: f64,
}

impl MeasuredWing {
    /// What a channel read in each of the named cases; nothing if one of them is not in the file.
    pub fn read(&self, cases: &[String], channel: Channel) -> Vec<f64> {
        let Ok(measurement) = Measurement::from_csv(self.measurement, "measurement") else {
            return Vec::new();
        };
        let value = |case: &String| {
            let mut rows = measurement.rows.iter();
            let row = rows.find(|row| row.case == *case && row.channel == channel)?;
            Some(row.value)
        };
        let values: Option<Vec<f64>> = cases.iter().map(value).collect();
        values.unwrap_or_default()
    }

    /// The tip as modelled, with keys of the design set to other values.
    ///
    /// # Errors
    /// If the design is refused or has no equilibrium.
    pub fn tip(&self, sets: &[(&str, f64)], level: Level, progress: &Progress) -> Result<Tip, VerifyError> {
        let mut design = Design::from_toml(self.design, "measured wing")?;
        for (key, value) in sets {
            design.set(key, *value)?;
        }
        design.mesh.refine = level.times(1) as f64;
        let wing = WingModel::of_design(design)?.solve(progress)?;
        let missing = VerifyError::Missing {
            what: "reading at the tip",
        };
        let tip_m = wing.model.planform.length_m();
        let read = || {
            let observer = wing.observer().ok()?;
            let moved = observer.displacement(tip_m, 0.5)?;
            Some((moved, observer.twist(tip_m).ok()?.twist_rad))
        };
        let (moved, twist_rad) = read().ok_or(missing)?;
        Ok(Tip {
            deflection_mm: 1e3 * moved.z,
            chordwise_mm: 1e3 * moved.y,
            twist_deg: twist_rad.to_degrees(),
        })
    }
}
