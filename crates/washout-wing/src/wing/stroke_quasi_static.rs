//! The wing over its stroke, each phase solved as if it stood still.

use std::f64::consts::FRAC_PI_2;

use crate::lift::{Forces, TwistAlongSpan, TwistHistory};
use crate::progress::Progress;

use super::error::WingError;
use super::solved::SolvedWing;
use super::stroke::{PhaseRow, PhaseShape, StrokeKind, StrokeSummary, StrokeTwist, flapping};

/// Solves at `count` phases, evenly from mid-stroke to just before the reversal, each from the one before; `draw` is shown each shape.
///
/// Nothing here has inertia or memory, so both sides of mid-stroke are the same.
///
/// # Errors
/// If the design does not flap, a phase has no solution, or `draw` fails.
pub fn quasi_static_stroke<E: From<WingError>>(
    wing: &SolvedWing,
    count: u16,
    progress: &Progress,
    mut draw: impl FnMut(PhaseShape) -> Result<(), E>,
) -> Result<StrokeSummary, E> {
    let own = flapping(&wing.model, "--stroke-quasi-static")?;
    let (own_deg, stop_angle_rad) = (own.phase_deg.value(), own.stop_angle_deg.value().to_radians());
    let (mut phases, mut twists, mut rows) = (Vec::new(), Vec::new(), Vec::new());
    let mut last = wing.clone();
    for index in 0..count {
        let phase_rad = FRAC_PI_2 * f64::from(index) / f64::from(count);
        let phase_deg = phase_rad.to_degrees();
        progress.say(format_args!("solving at phase {phase_deg:.1} deg of the stroke"));
        // the phase of the design is solved already
        let solved = match phase_deg == own_deg {
            true => wing.clone(),
            false => wing.model.at_phase(phase_deg, Some(&last), progress)?,
        };
        let twist = TwistAlongSpan::from_strips(&solved.solution.strips, stop_angle_rad);
        twists.push((phase_rad, twist.map_err(|error| wing.model.fault(error))?));
        draw(PhaseShape {
            model: &solved.model,
            solution: &solved.solution,
            instant: None,
        })?;
        let profile = solved.profile()?;
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
            stop_moment_mn_mm: Some(-solved.solution.report.reaction_moment_n_m[0] * 1e6),
            moving: None,
            forces: solved.lift()?.map(|report| report.solved),
            file: format!("wing-phase-{index:02}.vtu"),
        });
        last = solved;
    }
    let mean = wing.model.means(|_| TwistHistory::solved(twists))?;
    let mean =
        mean.map(|means| Forces::of_means("mean over the stroke (twist as solved at each phase)", &means));
    Ok(StrokeSummary {
        kind: StrokeKind::QuasiStatic,
        phases,
        profile: rows,
        mean,
        periodic: None,
    })
}
