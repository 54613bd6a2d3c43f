//! What is read from a solved wing: profile, stages, lift, and how far it is from the measurement.

use std::collections::BTreeMap;

use crate::aero::Flow;
use crate::compare::{Comparison, ModelledStages, compare};
use crate::coupling::BladeAir;
use crate::coupling::solution::Solution;
use crate::input::measurement::Channel;
use crate::lift::{LiftReport, Stroke, StrokeMeans, TwistAlongSpan, TwistHistory, stroke_means};
use crate::observation::{Observer, TwistProfile};

use super::Failure;
use super::case::Case;

/// What is read from a solved wing.
#[derive(Debug, Clone)]
pub struct Reading {
    /// Twist along the span.
    pub profile: TwistProfile,
    /// Its stages, where it carries a fit.
    pub stages: Option<ModelledStages>,
    /// Lift, drag and power; none without flow.
    pub lift: Option<LiftReport>,
    /// Measured minus modelled; none without measurement.
    pub measured: Option<Comparison>,
}

impl Reading {
    /// Reads a solved wing. `ratios` are modelled ratios to a reference wing, where one was solved.
    pub fn of(case: &Case, solution: &Solution, ratios: &BTreeMap<Channel, f64>) -> Result<Reading, Failure> {
        let design = &case.loaded.design;
        let observer = Observer::new(design, &case.planform, solution).map_err(|error| case.fault(error))?;
        let profile = observer.profile();
        let lift = lift(case, solution)?;
        let mut whole_wing = ratios.clone();
        if let Some(mean) = lift.as_ref().and_then(|lift| lift.stroke_mean.as_ref()) {
            let values = [mean.lift_mn, mean.drag_mn, mean.power_mw];
            whole_wing.extend(
                [Channel::Lift, Channel::Drag, Channel::Power]
                    .into_iter()
                    .zip(values),
            );
        }
        let measurement = case.loaded.measurement.as_ref();
        Ok(Reading {
            stages: ModelledStages::of(&profile),
            measured: measurement.map(|measurement| compare(&observer, measurement, &whole_wing)),
            profile,
            lift,
        })
    }
}

/// Lift, drag and power of a solved wing; none without flow.
pub fn lift(case: &Case, solution: &Solution) -> Result<Option<LiftReport>, Failure> {
    let Some(flow) = Flow::from_design(&case.loaded.design) else {
        return Ok(None);
    };
    let law = air_law(case)?;
    let report = LiftReport::new(&case.planform, &law, &flow, &solution.strips);
    report.map(Some).map_err(|error| case.fault(error))
}

/// Means over the stroke with the solved twist on the paper's ramp; none for a wing that does not flap.
pub fn means_on_ramp(case: &Case, solution: &Solution) -> Result<Option<StrokeMeans>, Failure> {
    means(case, |stroke| {
        let full = TwistAlongSpan::from_strips(&solution.strips, stroke.stop_angle_rad)?;
        Ok(TwistHistory::paper_ramp(full))
    })
}

/// Means over the stroke with the twist that `history` gives; none for a wing that does not flap.
pub fn means(
    case: &Case,
    history: impl FnOnce(&Stroke) -> Result<TwistHistory, crate::lift::LiftError>,
) -> Result<Option<StrokeMeans>, Failure> {
    let Some(flow @ Flow::Flapping { .. }) = Flow::from_design(&case.loaded.design) else {
        return Ok(None);
    };
    let law = air_law(case)?;
    let found = Stroke::from_flow(&flow)
        .and_then(|stroke| stroke_means(&case.planform, &law, &stroke, &history(&stroke)?));
    found.map(Some).map_err(|error| case.fault(error))
}

/// The air of a design on blade elements, with its effects.
pub fn air_law(case: &Case) -> Result<BladeAir, Failure> {
    let table = case.loaded.air_table.as_deref();
    BladeAir::new(&case.loaded.design, &case.planform, table).map_err(|error| case.fault(error))
}
