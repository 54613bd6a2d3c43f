//! `washout doctor`: what is installed here, and whether it computes what it should.

use clap::Args;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::page::text::{Table, number};
use crate::verify::{Case, Extent, Outcome, Verdict, named, run};

use super::{Console, Failure};

/// Cases with a closed form: a rod, a film, air and structure together.
const CHECKS: [&str; 3] = ["elastica", "taut-rectangle", "uniform-wing-twist"];

/// Arguments of `washout doctor`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  # version, features, threads, and three solves with a known answer
  washout doctor
  # the same for a bug report
  washout doctor --json

Exit code 1 if a check fails; `washout verify` runs all of them.")]
pub struct Doctor {}

/// What is installed, and what it computes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct DoctorReport {
    /// Version of washout.
    pub version: String,
    /// System and processor for which it was built.
    pub system: String,
    /// Optional parts that were built in.
    pub features: Vec<String>,
    /// Threads that it uses.
    pub threads: usize,
    /// Solves with a known answer.
    pub checks: Vec<Check>,
}

/// A solve with a known answer.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Check {
    /// Name of the case (`washout verify NAME`).
    pub case: String,
    /// What it is.
    pub title: String,
    /// Largest error relative to the closed form; none if there was no answer.
    pub error: Option<f64>,
    /// Whether that is within its limit.
    pub passed: bool,
    /// Time, s.
    pub time_s: f64,
}

impl Doctor {
    /// Runs the checks and prints what was found.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let cases: Vec<&'static Case> = CHECKS.iter().filter_map(|name| named(name)).collect();
        let outcomes = run(&cases, Extent::Short, console.progress())?;
        let report = DoctorReport {
            version: env!("CARGO_PKG_VERSION").to_string(),
            system: format!("{} on {}", std::env::consts::OS, std::env::consts::ARCH),
            features: features(),
            threads: rayon::current_num_threads(),
            checks: outcomes.iter().map(check).collect(),
        };
        console.result(&page(&report), &report)?;
        let failing = report.checks.iter().filter(|check| !check.passed);
        let failing: Vec<String> = failing.map(|check| check.case.clone()).collect();
        match failing.is_empty() {
            true => Ok(()),
            false => Err(Failure::Cases { failing }),
        }
    }
}

fn features() -> Vec<String> {
    let parquet = cfg!(feature = "parquet").then(|| "parquet".to_string());
    parquet.into_iter().collect()
}

fn check(outcome: &Outcome) -> Check {
    let errors = outcome.judged.iter().filter_map(|judged| judged.errors.last());
    let is_good = |verdict: Verdict| matches!(verdict, Verdict::Pass | Verdict::Excluded);
    Check {
        case: outcome.case.name.to_string(),
        title: outcome.case.title.to_string(),
        error: errors.copied().reduce(f64::max),
        passed: outcome.failure.is_none() && outcome.judged.iter().all(|judged| is_good(judged.verdict)),
        time_s: outcome.meshes.iter().map(|mesh| mesh.time_s).sum(),
    }
}

fn page(report: &DoctorReport) -> String {
    let features = match report.features.is_empty() {
        true => "none".to_string(),
        false => report.features.join(", "),
    };
    let mut table = Table::new(["check", "error_percent", "time_s", "passes", "what"]);
    for check in &report.checks {
        table.row([
            check.case.clone(),
            check
                .error
                .map_or_else(|| "no answer".into(), |error| number(100.0 * error, 3)),
            number(check.time_s, 2),
            if check.passed { "yes" } else { "NO" }.to_string(),
            check.title.clone(),
        ]);
    }
    format!(
        "washout {}, {}\n  features  {features} (built with --features)\n  threads   {}\n\n{}",
        report.version,
        report.system,
        report.threads,
        table.render()
    )
}
