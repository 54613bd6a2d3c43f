//! `washout verify`: the published cases, run and judged.

use std::path::PathBuf;

use clap::Args;

use crate::compare::ComparedStudy;
use crate::export::file::{refuse_page, write_page};
use crate::export::run::RunFolder;
use crate::export::trust::{TRUST_HEAD, markdown, trust_page};
use crate::export::verification::VerifyReport;
use crate::input::nearest;
use crate::input::study::LoadedStudy;
use crate::page::text::Table;
use crate::verify::{ALL, Case, Extent, Kind, named, run};

use super::finished::finished;
use super::{Console, Failure};

/// Name of the document of the folder.
pub const DOCUMENT: &str = "verify.json";

/// Arguments of `washout verify`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout verify                                all cases on three meshes each
  washout verify --short                        one mesh each, under a minute
  washout verify --list                         what cases there are
  washout verify cook-membrane elastica         these alone

A case passes if its error on the finest mesh is within the limit that good elements reach, and if the order of convergence is that of theory where theory gives one. Exit code 1 if one fails.")]
pub struct Verify {
    /// Cases to run [default: all]
    #[arg(value_name = "CASE")]
    pub cases: Vec<String>,
    /// Say what cases there are, and run nothing
    #[arg(long)]
    pub list: bool,
    /// Run each case on the coarsest mesh that is within its limit, and on no other
    #[arg(long)]
    pub short: bool,
    /// Folder to write into
    #[arg(long, short, value_name = "DIR", default_value = "output/verify")]
    pub output: PathBuf,
    /// Write report.html besides: words, pictures and tables in one file for a browser
    #[arg(long)]
    pub report: bool,
    /// Also write the page "How far to trust washout"
    #[arg(long, value_name = "FILE")]
    pub page: Option<PathBuf>,
    /// Study whose misfit that page shows too; as often as needed
    #[arg(long, value_name = "STUDY", requires = "page")]
    pub study: Vec<PathBuf>,
}

impl Verify {
    /// Runs the cases, prints and writes the tables.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let cases = self.chosen()?;
        if self.list {
            return console.names(&list(&cases), &names(&cases));
        }
        if let Some(page) = &self.page {
            refuse_page(page, TRUST_HEAD)?;
        }
        let compared = |path: &PathBuf| {
            let compared = ComparedStudy::new(&LoadedStudy::load(path, &[])?, console.progress());
            let compared = compared.map_err(|source| Failure::OfStudy {
                study: path.clone(),
                source,
            })?;
            Ok(compared.comparison)
        };
        let studies: Result<Vec<_>, Failure> = self.study.iter().map(compared).collect();
        let studies = studies?;
        let mut folder = RunFolder::listed_by(&self.output, "verify", DOCUMENT)?;
        let extent = if self.short { Extent::Short } else { Extent::Full };
        let outcomes = run(&cases, extent, console.progress())?;
        let mut report = VerifyReport::new(&outcomes, extent);
        folder.add("verify.md", markdown(&report).as_bytes())?;
        folder.add("verify.csv", &report.csv()?)?;
        report.files = folder.listed_with(self.report);
        let answer = report.page();
        let path = finished(folder, self.report.then_some(&answer), &report, console)?;
        if let Some(page) = &self.page {
            write_page(page, &trust_page(&report, &studies))?;
        }
        console.answer(&answer, &console.listed(&path, &report.files), &report)?;
        match report.failing() {
            failing if failing.is_empty() => Ok(()),
            failing => Err(Failure::Cases { failing }),
        }
    }

    fn chosen(&self) -> Result<Vec<&'static Case>, Failure> {
        if self.cases.is_empty() {
            return Ok(ALL.to_vec());
        }
        let find = |name: &String| {
            named(name).ok_or_else(|| Failure::UnknownCase {
                name: name.clone(),
                nearest: nearest(name, ALL.iter().map(|case| case.name)).map(str::to_string),
            })
        };
        self.cases.iter().map(find).collect()
    }
}

fn names(cases: &[&Case]) -> Vec<&'static str> {
    cases.iter().map(|case| case.name).collect()
}

fn list(cases: &[&Case]) -> String {
    let mut table = Table::new(["case", "kind", "what"]);
    for case in cases {
        let kind = match case.kind {
            Kind::Verification => "verification",
            Kind::Validation => "validation",
        };
        table.row([case.name.to_string(), kind.to_string(), case.title.to_string()]);
    }
    table.render()
}
