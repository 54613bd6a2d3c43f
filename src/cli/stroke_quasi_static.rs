//! `washout solve --stroke-quasi-static N`: the wing over its stroke, each phase solved as if it stood still.

use std::f64::consts::FRAC_PI_2;

use crate::coupling::CouplingError;
use crate::coupling::solution::Solution;
use crate::export::stroke::{PhaseRow, StrokeKind, StrokeSummary, StrokeTwist};
use crate::export::wing::{Shape, solution_grid};
use crate::lift::{Forces, TwistAlongSpan, TwistHistory};
use crate::observation::field::twist_at_nodes;
use crate::observation::read_profile;
use crate::progress::Progress;

use super::Failure;
use super::case::Case;
use super::reading::{lift, means};
use super::stroke::StrokeRun;

/// The option that asks for it.
pub const OPTION: &str = "--stroke-quasi-static";

/// Solves at `count` phases, evenly from mid-stroke to just before the reversal; the first from `nearby`, each from the one before.
///
/// Nothing here has inertia or memory, so both sides of mid-stroke are the same.
pub fn solve(case: &Case, nearby: &Solution, count: u16, progress: &Progress) -> Result<StrokeRun, Failure> {
    let Some(flapping) = &case.loaded.design.flapping else {
        return Err(Failure::Option {
            option: OPTION,
            reason: "the design does not flap, so it has no stroke; give it a [flapping] table".to_string(),
        });
    };
    let stop_angle_rad = flapping.stop_angle_deg.value().to_radians();
    let (mut phases, mut shapes, mut twists, mut rows) = (Vec::new(), Vec::new(), Vec::new(), Vec::new());
    let mut last = nearby.clone();
    for index in 0..count {
        let phase_rad = FRAC_PI_2 * f64::from(index) / f64::from(count);
        let phase_deg = phase_rad.to_degrees();
        progress.say(format_args!("solving at phase {phase_deg:.1} deg of the stroke"));
        let case = at_phase(case, phase_deg)?;
        // the phase of the design is solved already
        let solution = if phase_deg == flapping.phase_deg.value() {
            nearby.clone()
        } else {
            case.solve_from(Some(&last), progress)
                .map_err(|source| not_solved(&case, phase_deg, source))?
        };
        let twist = TwistAlongSpan::from_strips(&solution.strips, stop_angle_rad);
        twists.push((phase_rad, twist.map_err(|error| case.fault(error))?));
        shapes.push(shape(&case, &solution)?);
        let profile = read_profile(&case.loaded.design, &case.planform, &solution);
        let profile = profile.map_err(|error| case.fault(error))?;
        rows.extend(profile.readings.iter().map(|reading| StrokeTwist {
            phase_deg,
            r_mm: reading.r_m * 1e3,
            twist_deg: reading.twist_rad.to_degrees(),
            standing_deg: None,
            rate_deg_s: None,
        }));
        phases.push(PhaseRow {
            phase_deg,
            tip_twist_deg: profile.tip().map(|tip| tip.twist_rad.to_degrees()),
            stop_moment_mn_mm: Some(-solution.report.reaction_moment_n_m[0] * 1e6),
            moving: None,
            forces: lift(&case, &solution)?.map(|report| report.solved),
            file: format!("wing-phase-{index:02}.vtu"),
        });
        last = solution;
    }
    let mean = means(case, |_| TwistHistory::solved(twists))?;
    let mean =
        mean.map(|means| Forces::of_means("mean over the stroke (twist as solved at each phase)", &means));
    Ok(StrokeRun {
        summary: StrokeSummary {
            kind: StrokeKind::QuasiStatic,
            phases,
            profile: rows,
            mean,
            periodic: None,
        },
        shapes,
    })
}

fn at_phase(case: &Case, phase_deg: f64) -> Result<Case, Failure> {
    let mut design = case.loaded.design.clone();
    design.set("flapping.phase_deg", phase_deg)?;
    case.with(design).map_err(|error| case.fault(error))
}

fn not_solved(case: &Case, phase_deg: f64, source: CouplingError) -> Failure {
    match source {
        CouplingError::Interrupted(cancelled) => cancelled.into(),
        source => Failure::Phase {
            design: case.loaded.path.clone(),
            phase_deg,
            source,
        },
    }
}

fn shape(case: &Case, solution: &Solution) -> Result<Vec<u8>, Failure> {
    let twist_rad = twist_at_nodes(&case.planform, solution);
    let twist_deg = twist_rad.into_iter().map(f64::to_degrees).collect();
    Ok(solution_grid(&case.loaded.design, solution, twist_deg, Shape::Deformed).to_vtu()?)
}
