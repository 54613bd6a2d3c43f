//! What is read from a solved wing: profile, stages, lift, and how far it is from the measurement.

use std::collections::BTreeMap;

use crate::input::measurement::Channel;
use crate::lift::LiftReport;
use crate::observation::{TwistProfile, TwistReading};
use crate::wing::{SolvedWing, WingError};

use super::comparison::Comparison;
use super::stages::ModelledStages;
use super::wing::compare;

/// What is read from a solved wing.
#[derive(Debug, Clone)]
pub struct Reading {
    /// Twist at the stations of the design.
    pub profile: TwistProfile,
    /// The same with places evenly between, for a curve.
    pub along_span: Vec<TwistReading>,
    /// Its stages, where it carries a fit.
    pub stages: Option<ModelledStages>,
    /// Lift, drag and power; none without flow.
    pub lift: Option<LiftReport>,
    /// Measured minus modelled; none without measurement.
    pub measured: Option<Comparison>,
}

impl Reading {
    /// Reads a solved wing. `ratios` are modelled ratios to a reference wing, where one was solved.
    ///
    /// # Errors
    /// If the instrument cannot see the wing, or the air cannot be set up.
    pub fn of(wing: &SolvedWing, ratios: &BTreeMap<Channel, f64>) -> Result<Reading, WingError> {
        let observer = wing.observer()?;
        let profile = observer.profile();
        let lift = wing.lift()?;
        let mut whole_wing = ratios.clone();
        if let Some(mean) = lift.as_ref().and_then(|lift| lift.stroke_mean.as_ref()) {
            let values = [mean.lift_mn, mean.drag_mn, mean.power_mw];
            whole_wing.extend(
                [Channel::Lift, Channel::Drag, Channel::Power]
                    .into_iter()
                    .zip(values),
            );
        }
        let measurement = wing.model.loaded.measurement.as_ref();
        Ok(Reading {
            stages: ModelledStages::of(&profile),
            measured: measurement.map(|measurement| compare(&observer, measurement, &whole_wing)),
            profile,
            along_span: observer.along_span(),
            lift,
        })
    }
}
