//! The front between lift and efficiency over twist profiles of a wing, and the same wing without twist at other stops.

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use serde::{Deserialize, Serialize};

use crate::coupling::BladeAir;
use crate::geometry::Planform;
use crate::input::design::Design;
use crate::lift::{Stroke, TwistAlongSpan};
use crate::progress::Progress;

use super::blades::{Blades, Totals};
use super::error::ExploreError;
use super::front::{hypervolume, non_dominated};
use super::nsga2::{Evaluation, Nsga2, Problem};
use super::profile::{StagedTwist, along_span, tip_deg};

/// What counts as efficiency.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Efficiency {
    /// Mean along the span of the local lift over drag: the paper's.
    LocalLiftToDrag,
    /// Mean lift over mean drag.
    LiftToDrag,
    /// Mean lift over mean aerodynamic power.
    LiftPerPower,
}

impl Efficiency {
    /// In words.
    pub fn words(self) -> &'static str {
        match self {
            Efficiency::LocalLiftToDrag => "local lift over drag, mean along the span",
            Efficiency::LiftToDrag => "lift over drag",
            Efficiency::LiftPerPower => "lift per power",
        }
    }

    fn of(self, totals: &Totals) -> f64 {
        match self {
            Efficiency::LocalLiftToDrag => totals.local_lift_to_drag,
            Efficiency::LiftToDrag => totals.lift_n / totals.drag_n,
            Efficiency::LiftPerPower => totals.lift_n / totals.power_w,
        }
    }
}

/// A wing with the aims that profiles are judged by.
#[derive(Debug, Clone)]
pub struct TwistFront {
    /// Lift: with every effect.
    lifting: Blades,
    /// Efficiency: without the shape factor; none where there is no such factor.
    efficient: Option<Blades>,
    efficiency: Efficiency,
    /// Lift and efficiency of the wing without twist at its own stop.
    base: [f64; 2],
    family: StagedTwist,
}

/// A profile with what it gives.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct FrontPoint {
    /// Stages `[length_mm, rate_deg_per_mm]` from the base outward.
    pub stages: Vec<[f64; 2]>,
    /// Twist at the tip, deg.
    pub tip_deg: f64,
    /// Lift over that of the wing without twist at its own stop.
    pub lift: f64,
    /// Efficiency over that of the wing without twist at its own stop.
    pub efficiency: f64,
}

impl TwistFront {
    /// Profiles of a family on the wing of a design; `with_gain` is the design with its shape factor, whose gain raises lift
    /// and leaves the efficiency that of blade elements; the share of the ramp as in [`Blades::new`].
    ///
    /// # Errors
    /// If the air cannot be set up.
    #[allow(clippy::too_many_arguments)]
    pub fn new(
        design: &Design,
        with_gain: &Design,
        planform: &Planform,
        stroke: Stroke,
        air_table: Option<&[[f64; 3]]>,
        efficiency: Efficiency,
        family: StagedTwist,
        share: f64,
    ) -> Result<TwistFront, ExploreError> {
        let blades = |design: &Design| -> Result<Blades, ExploreError> {
            Ok(Blades::new(
                planform,
                BladeAir::new(design, planform, air_table)?,
                stroke,
                share,
            ))
        };
        let mut front = TwistFront {
            lifting: blades(with_gain)?,
            efficient: (design.effects != with_gain.effects)
                .then(|| blades(design))
                .transpose()?,
            efficiency,
            base: [1.0, 1.0],
            family,
        };
        front.base = front.aims(&TwistAlongSpan::flat())?;
        if !front.base.iter().all(|aim| aim.is_finite() && *aim > 0.0) {
            return Err(ExploreError::NoBase {
                lift_n: front.base[0],
                efficiency: front.base[1],
            });
        }
        Ok(front)
    }

    /// Lift and efficiency of a profile over those of the wing without twist.
    ///
    /// # Errors
    /// If the lift cannot be computed.
    pub fn aims(&self, twist: &TwistAlongSpan) -> Result<[f64; 2], ExploreError> {
        let lifting = self.lifting.totals(twist)?;
        let efficiency = match &self.efficient {
            Some(efficient) => self.efficiency.of(&efficient.totals(twist)?),
            None => self.efficiency.of(&lifting),
        };
        Ok([lifting.lift_n / self.base[0], efficiency / self.base[1]])
    }

    /// The front as an evolving population finds it, by rising lift.
    ///
    /// # Errors
    /// As [`Nsga2::front`].
    pub fn search(&self, algorithm: &Nsga2, progress: &Progress) -> Result<Vec<FrontPoint>, ExploreError> {
        let [low, high] = self.family.rates_deg_per_mm;
        let even = (self.family.largest_deg / self.family.length_mm).min(high);
        let starts = [low, even].map(|rate| self.family.variables(&[[self.family.length_mm, rate]]));
        let starts: Vec<Vec<f64>> = starts.into_iter().flatten().collect();
        let found = algorithm.front(self, &starts, progress)?;
        let mut points: Vec<FrontPoint> = found
            .into_iter()
            .map(|individual| self.point(&individual.variables, &individual.evaluation.objectives))
            .collect();
        points.sort_by(|a, b| a.lift.total_cmp(&b.lift));
        Ok(points)
    }

    /// The front as an evolving population finds it on the steps of the coarse family of [`TwistFront::exhaust`].
    ///
    /// # Errors
    /// As [`Nsga2::front`].
    pub fn search_on_steps(
        &self,
        algorithm: &Nsga2,
        ends: usize,
        rates: usize,
        progress: &Progress,
    ) -> Result<Vec<FrontPoint>, ExploreError> {
        let steps = OnSteps {
            front: self,
            ends,
            rates,
        };
        let found = algorithm.front(&steps, &[], progress)?;
        let point = |individual: &super::nsga2::Individual| {
            let variables = steps.snapped(&individual.variables);
            self.point(&variables, &individual.evaluation.objectives)
        };
        Ok(found.iter().map(point).collect())
    }

    /// Every profile of a coarse family: rates on `rates` even steps, ends of stages on `ends`; the front of them all.
    ///
    /// # Errors
    /// If the user asks to stop.
    pub fn exhaust(
        &self,
        ends: usize,
        rates: usize,
        progress: &Progress,
    ) -> Result<(Vec<FrontPoint>, usize), ExploreError> {
        let bounds = self.family.bounds();
        let counts: Vec<usize> = (0..bounds.len())
            .map(|index| {
                if index + 1 < self.family.stages {
                    ends
                } else {
                    rates
                }
            })
            .collect();
        let total: usize = counts.iter().product();
        let variables = |mut number: usize| -> Vec<f64> {
            let each = bounds.iter().zip(&counts);
            each.map(|([low, high], count)| {
                let place = number % count;
                number /= count;
                low + (high - low) * place as f64 / (count.saturating_sub(1).max(1)) as f64
            })
            .collect()
        };
        progress.say(format_args!("{total} profiles"));
        let tried: Vec<(Vec<f64>, Evaluation)> = (0..total)
            .into_par_iter()
            .filter(|_| !progress.is_cancelled())
            .map(variables)
            .filter(|x| {
                let ends = &x[..self.family.stages - 1];
                ends.windows(2).all(|pair| pair[0] < pair[1]) && self.family.violation(x) == 0.0
            })
            .map(|x| {
                let evaluation = self.evaluate(&x);
                (x, evaluation)
            })
            .collect();
        progress.check()?;
        let objectives: Vec<Vec<f64>> = tried.iter().map(|(_, e)| e.objectives.clone()).collect();
        let mut front: Vec<FrontPoint> = non_dominated(&objectives)
            .into_iter()
            .map(|index| self.point(&tried[index].0, &objectives[index]))
            .collect();
        front.sort_by(|a, b| a.lift.total_cmp(&b.lift));
        Ok((front, tried.len()))
    }

    fn point(&self, variables: &[f64], objectives: &[f64]) -> FrontPoint {
        let stages = self.family.stages(variables);
        FrontPoint {
            tip_deg: tip_deg(&stages),
            stages,
            lift: -objectives[0],
            efficiency: -objectives[1],
        }
    }
}

/// The same front on the steps of a coarse family.
struct OnSteps<'a> {
    front: &'a TwistFront,
    ends: usize,
    rates: usize,
}

impl OnSteps<'_> {
    fn snapped(&self, variables: &[f64]) -> Vec<f64> {
        let bounds = self.front.bounds();
        let each = variables.iter().zip(bounds).enumerate();
        each.map(|(index, (value, [low, high]))| {
            let count = if index + 1 < self.front.family.stages {
                self.ends
            } else {
                self.rates
            };
            let steps = count.saturating_sub(1).max(1) as f64;
            low + (high - low) * ((value - low) / (high - low) * steps).round() / steps
        })
        .collect()
    }
}

impl Problem for OnSteps<'_> {
    fn bounds(&self) -> Vec<[f64; 2]> {
        self.front.bounds()
    }

    fn evaluate(&self, variables: &[f64]) -> Evaluation {
        let snapped = self.snapped(variables);
        let ends = &snapped[..self.front.family.stages - 1];
        if ends.windows(2).any(|pair| pair[0] >= pair[1]) {
            return Evaluation {
                objectives: vec![0.0, 0.0],
                violation: 1.0,
            };
        }
        self.front.evaluate(&snapped)
    }
}

impl Problem for TwistFront {
    fn bounds(&self) -> Vec<[f64; 2]> {
        self.family.bounds()
    }

    fn evaluate(&self, variables: &[f64]) -> Evaluation {
        let violation = self.family.violation(variables);
        if violation > 0.0 {
            return Evaluation {
                objectives: vec![0.0, 0.0],
                violation,
            };
        }
        let aims = along_span(&self.family.stages(variables))
            .map_err(ExploreError::from)
            .and_then(|twist| self.aims(&twist));
        match aims {
            Ok([lift, efficiency]) if lift.is_finite() && efficiency.is_finite() => Evaluation {
                objectives: vec![-lift, -efficiency],
                violation: 0.0,
            },
            _ => Evaluation {
                objectives: vec![0.0, 0.0],
                violation: 1e3,
            },
        }
    }
}

/// Area under a front up to the corner `[lift, efficiency]` that it is worth nothing at.
pub fn area(front: &[FrontPoint], corner: [f64; 2]) -> f64 {
    let points: Vec<[f64; 2]> = front
        .iter()
        .map(|point| [-point.lift, -point.efficiency])
        .collect();
    hypervolume(&points, corner.map(|value| -value))
}

/// The wing of a design without twist at other stops: `[stop_deg, lift, efficiency]` over those at its own stop.
///
/// # Errors
/// If the lift cannot be computed.
pub fn other_stops(
    design: &Design,
    planform: &Planform,
    stroke: Stroke,
    air_table: Option<&[[f64; 3]]>,
    efficiency: Efficiency,
    stops_deg: &[f64],
) -> Result<Vec<[f64; 3]>, ExploreError> {
    let at = |stop_deg: f64| -> Result<[f64; 2], ExploreError> {
        let mut design = design.clone();
        design.set("flapping.stop_angle_deg", stop_deg)?;
        let stroke = Stroke {
            stop_angle_rad: stop_deg.to_radians(),
            ..stroke
        };
        let blades = Blades::new(
            planform,
            BladeAir::new(&design, planform, air_table)?,
            stroke,
            0.0,
        );
        let totals = blades.totals(&TwistAlongSpan::flat())?;
        Ok([totals.lift_n, efficiency.of(&totals)])
    };
    let own = at(stroke.stop_angle_rad.to_degrees())?;
    let each = stops_deg.iter().map(|&stop_deg| {
        let [lift, efficiency] = at(stop_deg)?;
        Ok([stop_deg, lift / own[0], efficiency / own[1]])
    });
    each.collect()
}

/// Efficiency of a curve `[stop_deg, lift, efficiency]` at a lift: the best of the pieces between its points that pass there.
pub fn efficiency_at(curve: &[[f64; 3]], lift: f64) -> Option<f64> {
    let pieces = curve.windows(2).filter_map(|pair| {
        let ([_, a, ea], [_, b, eb]) = (pair[0], pair[1]);
        let within = (a.min(b)..=a.max(b)).contains(&lift) && a != b;
        within.then(|| ea + (eb - ea) * (lift - a) / (b - a))
    });
    pieces.reduce(f64::max)
}
