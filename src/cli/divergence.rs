//! `washout divergence`: raises the speed, or the amplitude, until the wing has no equilibrium any more.

use clap::Args;

use crate::page::text::{Table, number, significant, wrapped};
use crate::wing::divergence::{DivergenceReport, divergence};

use super::design_arguments::DesignArguments;
use super::{Console, Failure};

/// Arguments of `washout divergence`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  # up to 40 m/s
  washout divergence my-wind-tunnel-wing.toml --to 40
  # up to 60 deg of half amplitude
  washout divergence designs/twist-v2.toml --to 60

A wing that is loaded behind its axis washes out and does not diverge: then the answer is that it did not. Where steps do not settle, the result is printed all the same, and the exit code is 3.")]
pub struct Divergence {
    /// The design
    #[command(flatten)]
    pub design: DesignArguments,
    /// Largest speed (m/s) or half amplitude (deg) [default: twice that of the design, an
    /// amplitude up to 90]
    #[arg(long, value_name = "VALUE")]
    pub to: Option<f64>,
    /// Steps up to it
    #[arg(long, value_name = "N", default_value_t = 12, value_parser = clap::value_parser!(u16).range(2..=1000))]
    pub steps: u16,
}

impl Divergence {
    /// Sweeps, and narrows the limit if there is one.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let wing = self.design.wing(console)?;
        let report = divergence(&wing, self.to, self.steps, console.progress())?;
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
