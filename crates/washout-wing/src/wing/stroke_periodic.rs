//! Twist, lift and what the stop carries over the whole stroke, from the periodic motion.

use crate::coupling::instant::Instant;
use crate::coupling::mid_stroke::left_out;
use crate::coupling::periodic::periodic_near;
use crate::coupling::{CouplingError, Periodic, PeriodicSettings};
use crate::lift::Forces;
use crate::observation::{TwistReading, read_profile};
use crate::progress::Progress;
use crate::structure::largest;

use super::error::WingError;
use super::solved::SolvedWing;
use super::stroke::{
    MovingRow, PeriodicSummary, PhaseRow, PhaseShape, StrokeKind, StrokeSummary, StrokeTwist, flapping,
};

/// How many phases of a half-stroke are looked at besides.
const LOOKS: usize = 180;

/// The periodic motion at `count` phases, evenly over the whole stroke from mid-stroke on; `draw` is shown each shape.
///
/// # Errors
/// If the design does not flap or has no periodic motion, or `draw` fails.
pub fn periodic_stroke<E: From<WingError>>(
    wing: &SolvedWing,
    count: u16,
    progress: &Progress,
    mut draw: impl FnMut(PhaseShape) -> Result<(), E>,
) -> Result<StrokeSummary, E> {
    let model = &wing.model;
    let design = model.design();
    let frequency_hz = flapping(model, "--stroke")?.frequency_hz.value();
    progress.say("moving over the stroke");
    let fault = |source| model.unsolved(source);
    let moving = moving(wing, progress).map_err(fault)?;
    let (mut phases, mut profile) = (Vec::new(), Vec::new());
    for index in 0..count {
        progress.check().map_err(WingError::from)?;
        let phase_deg = 360.0 * f64::from(index) / f64::from(count);
        let now = moving.instant(phase_deg.to_radians()).map_err(fault)?;
        let solution = now.solution(&moving.still);
        let read = read_profile(design, &model.planform, &solution).map_err(|error| model.fault(error))?;
        profile.extend(
            read.readings
                .iter()
                .map(|reading| twist_row(&moving, &now, phase_deg, reading.r_m, reading.twist_rad)),
        );
        draw(PhaseShape {
            model,
            solution: &solution,
            instant: Some(&now),
        })?;
        let file = format!("wing-phase-{index:03}.vtu");
        phases.push(phase_row(
            &moving,
            &now,
            phase_deg,
            frequency_hz,
            read.tip(),
            file,
        ));
    }
    let mean = moving.mean_forces().map_err(fault)?;
    Ok(StrokeSummary {
        kind: StrokeKind::Periodic,
        phases,
        profile,
        mean: Some(Forces::new(
            "mean over the stroke (periodic motion)",
            mean.lift_n,
            mean.drag_n,
            mean.power_w,
        )),
        periodic: Some(summary(wing, &moving)?),
    })
}

fn moving(wing: &SolvedWing, progress: &Progress) -> Result<Periodic, CouplingError> {
    let SolvedWing { model, solution } = wing;
    let design = model.design();
    let settings = PeriodicSettings::of_design(design)?;
    periodic_near(
        design,
        &model.mesh,
        model.air_table(),
        &settings,
        Some(solution),
        progress,
    )
}

fn summary(wing: &SolvedWing, moving: &Periodic) -> Result<PeriodicSummary, WingError> {
    let model = &wing.model;
    Ok(PeriodicSummary {
        mode_hz: moving.modes.iter().map(|mode| mode.frequency_hz).collect(),
        damping_ratio: moving.settings.damping_ratio,
        flip_share: moving.settings.flip_share,
        left_out: left_out(model.design()).map_err(|error| model.fault(error))?,
        largest_swing_deg: largest_swing_deg(moving),
        released_deg: released_deg(moving).map_err(|source| model.unsolved(source))?,
    })
}

fn phase_row(
    moving: &Periodic,
    now: &Instant,
    phase_deg: f64,
    frequency_hz: f64,
    tip: Option<&TwistReading>,
    file: String,
) -> PhaseRow {
    let forces = now.forces;
    PhaseRow {
        phase_deg,
        tip_twist_deg: tip.map(|tip| tip.twist_rad.to_degrees()),
        stop_moment_mn_mm: Some(now.stop_moment_n_m * 1e6),
        moving: Some(MovingRow {
            time_ms: phase_deg / 360.0 / frequency_hz * 1e3,
            sweep_deg: now.sweep_rad.to_degrees(),
            pitch_deg: now.pitch_rad.to_degrees(),
            is_flipping: now.is_flipping,
            standing_tip_twist_deg: tip.and_then(|tip| standing_deg(moving, tip.r_m, phase_deg)),
        }),
        forces: Some(Forces::new(
            format!("at stroke phase {phase_deg:.1} deg"),
            forces.lift_n,
            forces.drag_n,
            forces.power_w,
        )),
        file,
    }
}

fn standing_deg(moving: &Periodic, r_m: f64, phase_deg: f64) -> Option<f64> {
    let halves = (phase_deg / 180.0).round();
    let own = (phase_deg - 180.0 * halves).to_radians();
    moving.standing_twist(r_m, own).map(f64::to_degrees)
}

fn twist_row(moving: &Periodic, now: &Instant, phase_deg: f64, r_m: f64, twist_rad: f64) -> StrokeTwist {
    let half = std::f64::consts::PI;
    let own = now.phase_rad - (now.phase_rad / half).round() * half;
    StrokeTwist {
        phase_deg,
        r_mm: r_m * 1e3,
        twist_deg: twist_rad.to_degrees(),
        standing_deg: standing_deg(moving, r_m, phase_deg),
        rate_deg_s: moving.twist(r_m, own).map(|[_, rate, _]| rate.to_degrees()),
    }
}

/// Phases of a half-stroke at which motion and stop are looked at, deg.
fn looks() -> impl Iterator<Item = f64> {
    (0..LOOKS).map(|index| 180.0 * ((index as f64 + 0.5) / LOOKS as f64 - 0.5))
}

fn largest_swing_deg(moving: &Periodic) -> f64 {
    let stations = moving.stations_m();
    let swing = |phase_deg: f64, r_m: f64| {
        let phase = phase_deg.to_radians();
        let ([twist, ..], still) = (moving.twist(r_m, phase)?, moving.standing_twist(r_m, phase)?);
        Some((twist - still).abs().to_degrees())
    };
    let all = looks().flat_map(|phase_deg| stations.iter().filter_map(move |&r_m| swing(phase_deg, r_m)));
    largest(all)
}

/// Stretches of the half-stroke, deg, in which the rod is meant to rest on its stop, but the stop would have to pull.
fn released_deg(moving: &Periodic) -> Result<Vec<[f64; 2]>, CouplingError> {
    let step = 180.0 / LOOKS as f64;
    let mut found: Vec<[f64; 2]> = Vec::new();
    for phase_deg in looks() {
        let now = moving.instant(phase_deg.to_radians())?;
        if now.is_flipping || now.stop_moment_n_m >= 0.0 {
            continue;
        }
        let (from, to) = (phase_deg - 0.5 * step, phase_deg + 0.5 * step);
        match found.last_mut() {
            Some(last) if (last[1] - from).abs() < 1e-9 => last[1] = to,
            _ => found.push([from, to]),
        }
    }
    Ok(found)
}
