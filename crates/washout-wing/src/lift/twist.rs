//! The twist that the lift model flies with: along the span, and over the stroke.

use std::f64::consts::PI;

use serde::{Deserialize, Serialize};

use crate::coupling::solution::StripLoad;

use super::error::LiftError;

/// Share of each half-stroke over which the paper ramps the twist up, and down again (20/60/20).
pub const PAPER_RAMP: f64 = 0.2;

/// Washout along the span: straight between points, held beyond the first and the last.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct TwistAlongSpan {
    points: Vec<[f64; 2]>,
}

impl TwistAlongSpan {
    /// No twist anywhere.
    pub fn flat() -> Self {
        TwistAlongSpan {
            points: vec![[0.0, 0.0]],
        }
    }

    /// From points `[r_m, twist_rad]`, r from the wing base and rising, twist positive as washout.
    ///
    /// # Errors
    /// No point, a value that is not finite, r that does not rise.
    pub fn from_points(points: Vec<[f64; 2]>) -> Result<Self, LiftError> {
        if points.is_empty() {
            return Err(LiftError::NoTwist);
        }
        for (index, point) in points.iter().enumerate() {
            if !(point[0].is_finite() && point[1].is_finite()) {
                return Err(LiftError::TwistNotFinite { point: index + 1 });
            }
            if index > 0 && point[0] <= points[index - 1][0] {
                return Err(LiftError::TwistNotRising {
                    point: index + 1,
                    r_mm: point[0] * 1e3,
                    previous_mm: points[index - 1][0] * 1e3,
                });
            }
        }
        Ok(TwistAlongSpan { points })
    }

    /// From stages as the paper gives them, outward from the base without twist: `[length_mm, rate_deg_per_mm]`.
    ///
    /// # Errors
    /// As [`TwistAlongSpan::from_points`]; a stage without length counts as r that does not rise.
    pub fn from_stages(stages: &[[f64; 2]]) -> Result<Self, LiftError> {
        let mut points = vec![[0.0, 0.0]];
        let mut end = [0.0, 0.0];
        for [length_mm, rate_deg_per_mm] in stages {
            end = [end[0] + length_mm, end[1] + length_mm * rate_deg_per_mm];
            points.push([end[0] * 1e-3, end[1].to_radians()]);
        }
        Self::from_points(points)
    }

    /// The twist that the strips of a solved wing meet the air with: stop angle (rad) less their angle of attack.
    ///
    /// # Errors
    /// As [`TwistAlongSpan::from_points`].
    pub fn from_strips(strips: &[StripLoad], stop_angle_rad: f64) -> Result<Self, LiftError> {
        Self::from_points(
            strips
                .iter()
                .map(|strip| [strip.r_m, stop_angle_rad - strip.alpha_rad])
                .collect(),
        )
    }

    /// Twist at `r_m`, rad.
    pub fn twist_rad(&self, r_m: f64) -> f64 {
        let right = self.points.partition_point(|point| point[0] <= r_m);
        if right == 0 {
            return self.points[0][1];
        }
        if right == self.points.len() {
            return self.points[right - 1][1];
        }
        let ([r0, twist0], [r1, twist1]) = (self.points[right - 1], self.points[right]);
        twist0 + (twist1 - twist0) * (r_m - r0) / (r1 - r0)
    }

    /// The points `[r_m, twist_rad]` between which the twist is straight.
    pub fn points(&self) -> &[[f64; 2]] {
        &self.points
    }
}

/// A height of the ramp with the part of the stroke that is flown at it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Height {
    /// Share of the full twist.
    pub share: f64,
    /// Mean of the squared cosine of the phase, over that part.
    pub squares: f64,
    /// Mean of its cubed amount.
    pub cubes: f64,
}

/// Twist along the span and over the stroke. Both half-strokes are alike; phase −π/2 and π/2 are the reversals that
/// bound one, 0 is mid-stroke.
#[derive(Debug, Clone, PartialEq)]
pub enum TwistHistory {
    /// The paper's ramp: straight up from flat over the first share of the half-stroke's time, full, straight back
    /// over the last.
    Ramp {
        /// Twist of the plateau.
        full: TwistAlongSpan,
        /// Share of the half-stroke for each ramp; [`PAPER_RAMP`] is the paper's.
        share: f64,
    },
    /// As solved at given phases; see [`TwistHistory::solved`].
    Solved(Vec<(f64, TwistAlongSpan)>),
}

impl TwistHistory {
    /// The paper's 20/60/20 ramp to a full twist.
    pub fn paper_ramp(full: TwistAlongSpan) -> Self {
        TwistHistory::Ramp {
            full,
            share: PAPER_RAMP,
        }
    }

    /// Twist as solved at phases (rad, rising, within ±π/2), straight between them and held beyond the first and the
    /// last. Phases that are all 0 or more stand for both sides of mid-stroke: a quasi-static shape knows only the
    /// speed.
    ///
    /// # Errors
    /// [`LiftError::BadPhase`] for no phase, phases that do not rise or lie beyond the reversals.
    pub fn solved(phases: Vec<(f64, TwistAlongSpan)>) -> Result<Self, LiftError> {
        let bad = |entry: usize, phase_rad: f64| LiftError::BadPhase {
            entry,
            phase_deg: phase_rad.to_degrees(),
        };
        if phases.is_empty() {
            return Err(bad(0, 0.0));
        }
        for (index, (phase_rad, _)) in phases.iter().enumerate() {
            let within = phase_rad.abs() <= PI / 2.0 * (1.0 + 1e-12);
            if !within || (index > 0 && *phase_rad <= phases[index - 1].0) {
                return Err(bad(index + 1, *phase_rad));
            }
        }
        Ok(TwistHistory::Solved(phases))
    }

    /// Twist at `r_m` and stroke phase, rad; any phase, the half-strokes repeat.
    pub fn twist_rad(&self, r_m: f64, phase_rad: f64) -> f64 {
        let phase_rad = phase_rad - (phase_rad / PI).round() * PI;
        match self {
            TwistHistory::Ramp { full, share } => {
                let from_reversal = 0.5 - phase_rad.abs() / PI;
                let height = if from_reversal < *share {
                    from_reversal / share
                } else {
                    1.0
                };
                full.twist_rad(r_m) * height
            }
            TwistHistory::Solved(phases) => {
                let phase_rad = if phases[0].0 >= 0.0 {
                    phase_rad.abs()
                } else {
                    phase_rad
                };
                let right = phases.partition_point(|(phase, _)| *phase <= phase_rad);
                let at = |index: usize| phases[index].1.twist_rad(r_m);
                if right == 0 {
                    return at(0);
                }
                if right == phases.len() {
                    return at(right - 1);
                }
                let (low, high) = (phases[right - 1].0, phases[right].0);
                at(right - 1) + (at(right) - at(right - 1)) * (phase_rad - low) / (high - low)
            }
        }
    }

    /// The heights of a ramp at quadrature points (phase, weight) of a half-stroke, the plateau as one; none for a solved twist.
    pub(super) fn heights(&self, phases: &[[f64; 2]]) -> Option<Vec<Height>> {
        let TwistHistory::Ramp { share, .. } = self else {
            return None;
        };
        let mut heights: Vec<Height> = Vec::new();
        // both sides of mid-stroke are alike
        for [phase_rad, weight] in phases.iter().filter(|[phase_rad, _]| *phase_rad >= 0.0) {
            let from_reversal = 0.5 - phase_rad / PI;
            let (share, part) = ((from_reversal / share).min(1.0), 2.0 * weight / PI);
            let cos = phase_rad.cos();
            let (squares, cubes) = (part * cos * cos, part * cos.powi(3));
            match heights.last_mut().filter(|last| last.share == share) {
                Some(last) => {
                    last.squares += squares;
                    last.cubes += cubes;
                }
                None => heights.push(Height {
                    share,
                    squares,
                    cubes,
                }),
            }
        }
        Some(heights)
    }

    /// Rate of the twist with the stroke phase at `r_m`, rad/rad; at a kink the mean of both sides.
    pub fn rate(&self, r_m: f64, phase_rad: f64) -> f64 {
        // straight between kinks, so the difference is exact but for rounding
        let step = 1e-5;
        (self.twist_rad(r_m, phase_rad + step) - self.twist_rad(r_m, phase_rad - step)) / (2.0 * step)
    }

    /// Phases in [−π/2, π/2] between which the twist is smooth in time, rising, both ends included.
    pub(super) fn phase_kinks_rad(&self) -> Vec<f64> {
        let mut kinks = vec![-PI / 2.0, PI / 2.0];
        match self {
            TwistHistory::Ramp { share, .. } => {
                kinks.extend([PI * (share - 0.5), PI * (0.5 - share)]);
            }
            TwistHistory::Solved(phases) => {
                let mirrored = phases[0].0 >= 0.0;
                for (phase, _) in phases {
                    kinks.push(*phase);
                    if mirrored {
                        kinks.push(-phase);
                    }
                }
            }
        }
        kinks.retain(|phase| phase.abs() <= PI / 2.0);
        kinks.sort_by(f64::total_cmp);
        kinks
    }

    /// Span positions where the twist has a kink, m.
    pub(super) fn span_kinks_m(&self) -> Vec<f64> {
        let r_of = |along: &TwistAlongSpan| along.points.iter().map(|point| point[0]).collect::<Vec<f64>>();
        match self {
            TwistHistory::Ramp { full, .. } => r_of(full),
            TwistHistory::Solved(phases) => phases.iter().flat_map(|(_, along)| r_of(along)).collect(),
        }
    }
}

#[cfg(test)]
mod tests {
    use super::{TwistAlongSpan, TwistHistory};
    use crate::lift::error::LiftError;
    use std::f64::consts::PI;

    fn v1() -> TwistAlongSpan {
        TwistAlongSpan::from_stages(&[[48.0, 0.29], [22.0, 1.39]]).expect("the paper's profile")
    }

    #[test]
    fn the_papers_stages_of_v1_end_at_44_5_degrees() {
        for (r_mm, degrees) in [
            (0.0, 0.0),
            (24.0, 6.96),
            (48.0, 13.92),
            (59.0, 29.21),
            (70.0, 44.5),
            (80.0, 44.5),
        ] {
            assert!(
                (v1().twist_rad(r_mm * 1e-3).to_degrees() - degrees).abs() < 1e-10,
                "{r_mm}"
            );
        }
        assert_eq!(v1().twist_rad(-0.01), 0.0);
        assert_eq!(TwistAlongSpan::flat().twist_rad(0.03), 0.0);
    }

    #[test]
    fn the_ramp_is_20_60_20_of_each_half_stroke() {
        let history = TwistHistory::paper_ramp(v1());
        let full = v1().twist_rad(0.06);
        for (share_of_time, height) in [
            (0.0, 0.0),
            (0.1, 0.5),
            (0.2, 1.0),
            (0.5, 1.0),
            (0.8, 1.0),
            (0.95, 0.25),
        ] {
            for half_stroke in [0.0, 1.0, 2.0] {
                let phase_rad = PI * (share_of_time - 0.5 + half_stroke);
                let twist = history.twist_rad(0.06, phase_rad);
                assert!(
                    (twist - height * full).abs() < 1e-12,
                    "{share_of_time} {half_stroke}"
                );
            }
        }
    }

    #[test]
    fn a_solved_history_is_straight_between_phases_and_mirrors_if_one_sided() {
        let at = |twist_rad: f64| TwistAlongSpan::from_points(vec![[0.0, twist_rad]]).expect("a point");
        let both = TwistHistory::solved(vec![(0.0, at(0.4)), (PI / 4.0, at(0.2))]).expect("rising phases");
        for (phase, twist) in [
            (0.0, 0.4),
            (PI / 8.0, 0.3),
            (-PI / 8.0, 0.3),
            (1.5, 0.2),
            (PI - 0.01, 0.4),
        ] {
            assert!((both.twist_rad(0.0, phase) - twist).abs() < 0.003, "{phase}");
        }
        let one = TwistHistory::solved(vec![(-1.0, at(0.1)), (1.0, at(0.3))]).expect("rising phases");
        assert!((one.twist_rad(0.0, -0.5) - 0.15).abs() < 1e-12);
    }

    #[test]
    fn bad_profiles_and_phases_are_refused_with_their_place() {
        assert_eq!(TwistAlongSpan::from_points(vec![]), Err(LiftError::NoTwist));
        let infinite = TwistAlongSpan::from_points(vec![[0.0, 0.0], [0.1, f64::INFINITY]]);
        assert_eq!(infinite, Err(LiftError::TwistNotFinite { point: 2 }));
        let error = TwistAlongSpan::from_stages(&[[0.0, 1.0]]).expect_err("no length");
        assert_eq!(
            error.to_string(),
            "point 2 of the twist profile stands at r = 0 mm, not beyond 0 mm; sort the points and keep one at each r"
        );
        assert!(TwistHistory::solved(vec![]).is_err());
        for phases in [[0.2, 0.2], [0.0, 2.0], [0.0, f64::NAN]] {
            let entries = phases.map(|phase| (phase, TwistAlongSpan::flat())).to_vec();
            assert!(matches!(
                TwistHistory::solved(entries),
                Err(LiftError::BadPhase { entry: 2, .. })
            ));
        }
    }
}
