//! The speed, or the amplitude, beyond which a wing has no equilibrium.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::aero::Flow;
use crate::coupling::CouplingError;
use crate::coupling::solution::Solution;
use crate::progress::Progress;

use super::error::WingError;
use super::model::WingModel;
use super::solved::SolvedWing;

/// Halvings of the interval that holds the limit.
const HALVINGS: usize = 7;

/// What a sweep found.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DivergenceReport {
    /// Name of the wing.
    pub wing: String,
    /// The key of the design that was raised.
    pub key: String,
    /// Every value that was solved, rising.
    pub steps: Vec<DivergenceStep>,
    /// Values at which the iteration did not settle: neither an equilibrium nor a divergence.
    pub undecided: Vec<Undecided>,
    /// Where it ended; absent if every step has an equilibrium.
    pub limit: Option<DivergenceLimit>,
}

/// An equilibrium on the way.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DivergenceStep {
    /// Value of the key.
    pub value: f64,
    /// Dynamic pressure at the tip.
    pub tip_dynamic_pressure_pa: f64,
    /// Twist of the tip; absent where it cannot be read.
    pub tip_twist_deg: Option<f64>,
    /// Lift of one wing as solved.
    pub lift_mn: f64,
    /// Iterations between air and structure.
    pub iterations: usize,
}

/// A value at which the iteration did not settle.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Undecided {
    /// Value of the key.
    pub value: f64,
    /// What the solver said.
    pub reason: String,
}

/// The end of the equilibria.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DivergenceLimit {
    /// Largest value with an equilibrium.
    pub last_converged: f64,
    /// Smallest value without.
    pub first_failed: f64,
    /// Dynamic pressure at the tip between the two.
    pub tip_dynamic_pressure_pa: f64,
    /// What the solver said there.
    pub reason: String,
}

/// The largest half amplitude that a design may have, deg.
const LARGEST_HALF_AMPLITUDE_DEG: f64 = 90.0;

/// Raises the speed of a steady stream, or else the half amplitude of a stroke, in `steps` even steps up to `highest` (m/s or deg; twice that
/// of the design if it is not given), and narrows down where the equilibria end.
///
/// # Errors
/// If the design has no flow to raise, a value cannot be, or the user asked to stop.
///
/// # Example
/// ```
/// # use washout_wing as washout;
/// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
/// # use washout::{progress::Progress, wing::{WingModel, divergence::divergence}};
/// let wing = WingModel::open("designs/twist-v1.toml", &["mesh.refine=0.4"])?;
/// let report = divergence(&wing, Some(40.0), 2, &Progress::quiet())?;
/// assert!(report.limit.is_none());
/// # Ok::<(), washout::wing::WingError>(())
/// ```
pub fn divergence(
    wing: &WingModel,
    highest: Option<f64>,
    steps: u16,
    progress: &Progress,
) -> Result<DivergenceReport, WingError> {
    let sweep = Sweep::new(wing, progress)?;
    let highest = highest.unwrap_or_else(|| sweep.twice());
    for end in [highest / f64::from(steps), highest] {
        sweep.at(end).map_err(|error| WingError::Question {
            question: "--to",
            reason: format!(
                "one of the {steps} steps to {highest} would be at {end}, which cannot be: {error}"
            ),
        })?;
    }
    let mut report = DivergenceReport {
        wing: wing.design().name.clone(),
        key: sweep.key.to_string(),
        steps: Vec::new(),
        undecided: Vec::new(),
        limit: None,
    };
    let mut last = None;
    for step in 1..=steps {
        let value = highest * f64::from(step) / f64::from(steps);
        match sweep.solve(value, &mut last)? {
            Found::Equilibrium(found) => report.steps.push(found),
            Found::Undecided(reason) => report.undecided.push(Undecided { value, reason }),
            Found::Nothing(reason) => {
                report.limit = Some(sweep.narrow(&mut report.steps, last, value, reason)?);
                break;
            }
        }
    }
    Ok(report)
}

/// What one value gives.
enum Found {
    /// An equilibrium.
    Equilibrium(DivergenceStep),
    /// There is none, or none is found by the structure.
    Nothing(String),
    /// The iteration between air and structure did not settle, which says nothing about divergence.
    Undecided(String),
}

struct Sweep<'a> {
    wing: &'a WingModel,
    key: &'static str,
    design_value: f64,
    progress: &'a Progress,
}

impl<'a> Sweep<'a> {
    /// Twice the design's own value, or the largest that a stroke can have.
    fn twice(&self) -> f64 {
        let twice = 2.0 * self.design_value;
        match self.wing.design().steady {
            Some(_) => twice,
            None => twice.min(LARGEST_HALF_AMPLITUDE_DEG),
        }
    }

    fn new(wing: &'a WingModel, progress: &'a Progress) -> Result<Sweep<'a>, WingError> {
        let design = wing.design();
        let steady = design
            .steady
            .as_ref()
            .map(|flow| ("steady.speed_m_s", flow.speed_m_s.value()));
        let flapping = design.flapping.as_ref();
        let flapping = flapping.map(|flow| ("flapping.half_amplitude_deg", flow.half_amplitude_deg.value()));
        let Some((key, design_value)) = steady.or(flapping) else {
            return Err(WingError::Question {
                question: "divergence",
                reason: "the design has no flow to raise; give it [steady] or [flapping]".to_string(),
            });
        };
        Ok(Sweep {
            wing,
            key,
            design_value,
            progress,
        })
    }

    /// The equilibrium at a value, sought from the last one that was found; or why there is none.
    fn solve(&self, value: f64, last: &mut Option<Solution>) -> Result<Found, WingError> {
        self.progress
            .say(format_args!("solving at {} = {value:.4}", self.key));
        let wing = self.at(value)?;
        let solution = match wing.shape(last.as_ref(), self.progress) {
            Ok(solution) => solution,
            Err(error @ (CouplingError::OutOfPatience { .. } | CouplingError::Overloaded(_))) => {
                return Ok(Found::Undecided(error.to_string()));
            }
            // what is not a number says nothing about divergence, at no value
            Err(error) if error.is_not_converged() && !matches!(error, CouplingError::NotFinite { .. }) => {
                return Ok(Found::Nothing(error.to_string()));
            }
            Err(error) => return Err(wing.unsolved(error)),
        };
        let tip_m = wing.design().observation.tip_station * wing.planform.length_m();
        let solved = SolvedWing::new(wing, solution);
        let found = DivergenceStep {
            value,
            tip_dynamic_pressure_pa: tip_dynamic_pressure_pa(&solved.model),
            tip_twist_deg: solved.twist_at(tip_m).map(f64::to_degrees),
            lift_mn: solved.lift()?.map_or(0.0, |report| report.solved.lift_mn),
            iterations: solved.solution.report.iterations,
        };
        *last = Some(solved.solution);
        Ok(Found::Equilibrium(found))
    }

    fn at(&self, value: f64) -> Result<WingModel, WingError> {
        self.wing.with(self.key, value)
    }

    /// Halves the interval between the last equilibrium and the first failure.
    fn narrow(
        &self,
        steps: &mut Vec<DivergenceStep>,
        mut last: Option<Solution>,
        mut failed: f64,
        mut reason: String,
    ) -> Result<DivergenceLimit, WingError> {
        let mut converged = steps.last().map_or(0.0, |step| step.value);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (converged + failed);
            match self.solve(middle, &mut last)? {
                Found::Equilibrium(found) => {
                    converged = middle;
                    steps.push(found);
                }
                Found::Nothing(why) => (failed, reason) = (middle, why),
                // near the limit the iteration may creep: the bracket stays as narrow as what is known
                Found::Undecided(_) => break,
            }
        }
        Ok(DivergenceLimit {
            last_converged: converged,
            first_failed: failed,
            tip_dynamic_pressure_pa: tip_dynamic_pressure_pa(&self.at(0.5 * (converged + failed))?),
            reason,
        })
    }
}

fn tip_dynamic_pressure_pa(wing: &WingModel) -> f64 {
    let design = wing.design();
    let speed_m_s = Flow::from_design(design).map_or(0.0, |flow| flow.velocity(wing.planform.tip_m()).norm());
    0.5 * design.air.density_kg_m3.value() * speed_m_s * speed_m_s
}
