//! `washout divergence`: raises the speed, or the amplitude, until the wing has no equilibrium any more.

use clap::Args;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::aero::Flow;
use crate::coupling::CouplingError;
use crate::coupling::solution::Solution;
use crate::export::text::{Table, number, significant, wrapped};
use crate::observation::twist_at;

use super::case::{Case, DesignArguments};
use super::reading::lift;
use super::{Console, Failure};

/// Halvings of the interval that holds the limit.
const HALVINGS: usize = 7;

/// Arguments of `washout divergence`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout divergence my-wind-tunnel-wing.toml --to 40       up to 40 m/s
  washout divergence designs/twist-v2.toml --to 60          up to 60 deg of half amplitude

A wing that is loaded behind its axis washes out and does not diverge: then the answer is that it did not.
Where steps do not settle, the result is printed all the same, and the exit code is 3.")]
pub struct Divergence {
    /// The design
    #[command(flatten)]
    pub design: DesignArguments,
    /// Largest speed (m/s) or half amplitude (deg) [default: twice that of the design]
    #[arg(long, value_name = "VALUE")]
    pub to: Option<f64>,
    /// Steps up to it
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u16).range(2..=1000))]
    pub steps: u16,
}

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

impl Divergence {
    /// Sweeps, and narrows the limit if there is one.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let case = self.design.case(console)?;
        let sweep = Sweep::new(case, console)?;
        let highest = self.to.unwrap_or(2.0 * sweep.design_value);
        for end in [highest / f64::from(self.steps), highest] {
            sweep.at(end).map_err(|error| Failure::Option {
                option: "--to",
                reason: format!(
                    "one of the {} steps to {highest} would be at {}, which cannot be: {error}",
                    self.steps,
                    significant(end, 3)
                ),
            })?;
        }
        let mut report = DivergenceReport {
            wing: sweep.case.loaded.design.name.clone(),
            key: sweep.key.to_string(),
            steps: Vec::new(),
            undecided: Vec::new(),
            limit: None,
        };
        let mut last = None;
        for step in 1..=self.steps {
            let value = highest * f64::from(step) / f64::from(self.steps);
            match sweep.solve(value, &mut last)? {
                Ok(found) => report.steps.push(found),
                Err(Without::Patience(reason)) => report.undecided.push(Undecided { value, reason }),
                Err(Without::Equilibrium(reason)) => {
                    report.limit = Some(sweep.narrow(&mut report.steps, last, value, reason)?);
                    break;
                }
            }
        }
        console.result(&page(&report), &report)?;
        match report.undecided.len() {
            0 => Ok(()),
            steps => Err(Failure::Undecided {
                design: self.design.design.clone(),
                steps,
            }),
        }
    }
}

/// Why a value gave no equilibrium.
enum Without {
    /// There is none, or none is found by the structure.
    Equilibrium(String),
    /// The iteration between air and structure did not settle, which says nothing about divergence.
    Patience(String),
}

struct Sweep<'a> {
    case: Case,
    key: &'static str,
    design_value: f64,
    console: &'a Console,
}

impl<'a> Sweep<'a> {
    fn new(case: Case, console: &'a Console) -> Result<Sweep<'a>, Failure> {
        let design = &case.loaded.design;
        let steady = design
            .steady
            .as_ref()
            .map(|flow| ("steady.speed_m_s", flow.speed_m_s.value()));
        let flapping = design.flapping.as_ref();
        let flapping = flapping.map(|flow| ("flapping.half_amplitude_deg", flow.half_amplitude_deg.value()));
        let Some((key, design_value)) = steady.or(flapping) else {
            return Err(Failure::Option {
                option: "divergence",
                reason: "the design has no flow to raise; give it [steady] or [flapping]".to_string(),
            });
        };
        Ok(Sweep {
            case,
            key,
            design_value,
            console,
        })
    }

    /// The equilibrium at a value, sought from the last one that was found; or why there is none.
    fn solve(
        &self,
        value: f64,
        last: &mut Option<Solution>,
    ) -> Result<Result<DivergenceStep, Without>, Failure> {
        let progress = self.console.progress();
        progress.say(format_args!(
            "solving at {} = {}",
            self.key,
            significant(value, 4)
        ));
        let case = self.at(value)?;
        let solution = match case.solve_from(last.as_ref(), progress) {
            Ok(solution) => solution,
            Err(CouplingError::Interrupted(cancelled)) => return Err(cancelled.into()),
            Err(error @ CouplingError::OutOfPatience { .. }) => {
                return Ok(Err(Without::Patience(error.to_string())));
            }
            // what is not a number says nothing about divergence, at no value
            Err(source @ CouplingError::NotFinite { .. }) => {
                return Err(Failure::Coupling {
                    design: case.loaded.path.clone(),
                    source,
                });
            }
            Err(error) if error.is_not_converged() => {
                return Ok(Err(Without::Equilibrium(error.to_string())));
            }
            Err(error) => return Err(case.fault(error)),
        };
        let design = &case.loaded.design;
        let tip_m = design.observation.tip_station * case.planform.length_m();
        let found = DivergenceStep {
            value,
            tip_dynamic_pressure_pa: tip_dynamic_pressure_pa(&case),
            tip_twist_deg: twist_at(design, &case.planform, &solution, tip_m).map(f64::to_degrees),
            lift_mn: lift(&case, &solution)?.map_or(0.0, |report| report.solved.lift_mn),
            iterations: solution.report.iterations,
        };
        *last = Some(solution);
        Ok(Ok(found))
    }

    fn at(&self, value: f64) -> Result<Case, Failure> {
        let mut design = self.case.loaded.design.clone();
        design.set(self.key, value)?;
        self.case.with(design).map_err(|error| self.case.fault(error))
    }

    /// Halves the interval between the last equilibrium and the first failure.
    fn narrow(
        &self,
        steps: &mut Vec<DivergenceStep>,
        mut last: Option<Solution>,
        mut failed: f64,
        mut reason: String,
    ) -> Result<DivergenceLimit, Failure> {
        let mut converged = steps.last().map_or(0.0, |step| step.value);
        for _ in 0..HALVINGS {
            let middle = 0.5 * (converged + failed);
            match self.solve(middle, &mut last)? {
                Ok(found) => {
                    converged = middle;
                    steps.push(found);
                }
                Err(Without::Equilibrium(why)) => (failed, reason) = (middle, why),
                // Near the limit the iteration may creep: the bracket stays as narrow as what is known.
                Err(Without::Patience(_)) => break,
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

fn tip_dynamic_pressure_pa(case: &Case) -> f64 {
    let design = &case.loaded.design;
    let speed_m_s = Flow::from_design(design).map_or(0.0, |flow| flow.velocity(case.planform.tip_m()).norm());
    0.5 * design.air.density_kg_m3.value() * speed_m_s * speed_m_s
}

fn page(report: &DivergenceReport) -> String {
    let mut table = Table::new([
        &report.key,
        "tip_pressure_pa",
        "tip_twist_deg",
        "lift_mn",
        "iterations",
    ]);
    for step in &report.steps {
        table.row([
            significant(step.value, 5),
            number(step.tip_dynamic_pressure_pa, 2),
            step.tip_twist_deg.map_or(String::new(), |twist| number(twist, 2)),
            number(step.lift_mn, 2),
            step.iterations.to_string(),
        ]);
    }
    let verdict = match &report.limit {
        None if !report.undecided.is_empty() => format!(
            "No divergence was found up to {}, but {} of the steps did not settle, which is neither an equilibrium nor a \
             divergence\n",
            last(report),
            report.undecided.len()
        ),
        None => format!(
            "Divergence: none up to {}; every step has an equilibrium\n",
            last(report)
        ),
        Some(limit) => format!(
            "No equilibrium was found beyond {} = {} (none at {}; dynamic pressure {} Pa at the tip)\n{}",
            report.key,
            significant(limit.last_converged, 4),
            significant(limit.first_failed, 4),
            significant(limit.tip_dynamic_pressure_pa, 4),
            wrapped(&limit.reason, 2)
        ),
    };
    let undecided: String = report
        .undecided
        .iter()
        .map(|step| wrapped(&format!("at {}: {}", significant(step.value, 5), step.reason), 2))
        .collect();
    format!("{}\n{}{undecided}\n{verdict}", report.wing, table.render())
}

fn last(report: &DivergenceReport) -> String {
    let value = report.steps.last().map_or(0.0, |step| step.value);
    format!("{} = {}", report.key, significant(value, 4))
}
