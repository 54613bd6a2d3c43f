//! `washout export`: a run as input for another program.

use std::path::PathBuf;

use clap::{Args, ValueEnum};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::coupling::solution::Solution;
use crate::coupling::vibration::Standing;
use crate::export::file::input_file;
use crate::export::run::{RunFolder, SUMMARY, read_summary};
use crate::export::summary::RunSummary;
use crate::export::wing::displacement_mm;
use crate::export::{ExportError, calculix, csv, kratos};
use crate::input::design::Kinematics;
use crate::page::text::wrapped;
use crate::program::MadeOf;

use super::{Console, Failure};
use crate::wing::WingModel;

/// Tip displacements nearer than this are the same run, mm.
const SAME_MM: f64 = 1e-5;

/// Arguments of `washout export`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout solve designs/twist-v2.toml --set film.compression=carries
  # output/twist-v2/calculix/wing.inp
  washout export --to calculix output/twist-v2
  # solves it with ccx and compares
  python3 docs/second_opinion.py output/twist-v2
  # output/twist-v2/kratos/wing.mdpa
  washout export --to kratos output/twist-v2
  # solves it with Kratos and compares
  python3 docs/kratos_opinion.py output/twist-v2

Both hold the structure and the loads of the converged shape, kept still in space. edges.csv holds where washout puts the leading and the trailing edge, shape.csv (Kratos) every node.")]
pub struct Export {
    /// Folder of the run
    pub run: PathBuf,
    /// The other program
    #[arg(long)]
    pub to: Program,
    /// Folder to write into [default: RUN/calculix or RUN/kratos]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

/// A program that can be written for.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum Program {
    /// CalculiX (`ccx`), an open finite-element program
    Calculix,
    /// Kratos Multiphysics, an open finite-element library
    Kratos,
}

/// What was exported; `summary.json` of its folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ExportReport {
    /// Name of the wing.
    pub name: String,
    /// What has no counterpart there and is left out.
    pub left_out: Vec<String>,
    /// Whether the film is pre-tensioned: a deck then has a first step that cools it, and displacements count from its end.
    pub cured: bool,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder.
    pub files: Vec<String>,
}

impl Export {
    /// Solves the inputs of the run again, which gives its shape and its loads, and writes the deck.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let summary = read_summary(&self.run)?;
        let run = input_file(&self.run.join(SUMMARY))?;
        let place = match self.to {
            Program::Calculix => "calculix",
            Program::Kratos => "kratos",
        };
        let target = self.output.clone().unwrap_or_else(|| self.run.join(place));
        let mut folder = RunFolder::create(&target, "export")?;
        let design = summary.design.clone();
        let wing = WingModel::new(design.resolved(summary.design_file.as_ref())?)?;
        let solution = self.solved_again(&wing, &summary, console)?;
        let standing =
            Standing::loaded(&wing.loaded.design, &solution).map_err(|source| wing.unsolved(source))?;
        let left_out = self.add_deck(&mut folder, &summary.name, &standing, &solution)?;
        let report = ExportReport {
            name: summary.name,
            left_out,
            cured: standing
                .model
                .sheets
                .iter()
                .any(|sheet| sheet.pretension_n_per_m != 0.0),
            made_of: MadeOf::files([&run].into_iter().chain(&wing.loaded.files)),
            files: folder.listed(),
        };
        folder.add_summary(&report)?;
        console.progress().check()?;
        let path = folder.commit()?;
        console.result(&report.page(&path.display().to_string()), &report)
    }

    /// Refused if the run was another one.
    fn solved_again(
        &self,
        wing: &WingModel,
        summary: &RunSummary,
        console: &Console,
    ) -> Result<Solution, Failure> {
        if wing.loaded.design.structure.kinematics == Kinematics::Linear {
            return Err(Failure::Option {
                option: "--to",
                reason:
                    "what is exported is solved with large rotations; solve the design with structure.kinematics = \
                         \"large-rotation\""
                        .to_string(),
            });
        }
        console
            .progress()
            .say(format_args!("solving {} again", summary.name));
        let solution = wing.solve(console.progress())?.solution;
        let moved = displacement_mm(&solution.rest, &solution.state);
        let tip = moved.get(summary.tip.node).copied().unwrap_or([f64::INFINITY; 3]);
        let off = (0..3).any(|k| (tip[k] - summary.tip.displacement_mm[k]).abs() > SAME_MM);
        if off {
            return Err(Failure::Export(ExportError::ForeignSummary {
                path: self.run.clone(),
                reason: "its inputs give another tip displacement now".to_string(),
            }));
        }
        Ok(solution)
    }

    /// Adds the input of the other program and the edges that it should find; returns what has no counterpart there.
    fn add_deck(
        &self,
        folder: &mut RunFolder,
        name: &str,
        standing: &Standing,
        solution: &Solution,
    ) -> Result<Vec<String>, Failure> {
        let mesh = &solution.mesh;
        let mut edges = mesh.leading_edge.clone();
        edges.extend(
            mesh.trailing_edge
                .iter()
                .filter(|node| !mesh.leading_edge.contains(node)),
        );
        let left_out = match self.to {
            Program::Calculix => {
                let deck = calculix::deck(name, standing, &edges)?;
                folder.add("wing.inp", deck.text.as_bytes())?;
                deck.left_out
            }
            Program::Kratos => {
                let part = kratos::model_part(name, standing)?;
                folder.add("wing.mdpa", part.text.as_bytes())?;
                folder.add("shape.csv", kratos::shape(standing).as_bytes())?;
                part.left_out
            }
        };
        let moved = displacement_mm(&solution.rest, &solution.state);
        folder.add("edges.csv", &csv::edges(mesh, &moved)?)?;
        Ok(left_out)
    }
}

impl ExportReport {
    fn page(&self, folder: &str) -> String {
        let left_out: String = self
            .left_out
            .iter()
            .map(|what| wrapped(&format!("Left out: {what}"), 2))
            .collect();
        format!(
            "{}\n{left_out}\nFiles in {folder}: {}\n",
            self.name,
            self.files.join(" ")
        )
    }
}
