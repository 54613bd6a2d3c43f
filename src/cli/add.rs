//! `washout add`: an effect joins the model of a study, and the error falls, or does not.

use std::path::PathBuf;

use clap::Args;

use crate::add::{Fit, Joining, with_sets};
use crate::export::added::{AddReport, page, what};
use crate::export::calibrated;
use crate::export::html::{self, Document};
use crate::export::pictures::ladder::Fall;
use crate::export::pictures::write::add_falls;
use crate::export::run::RunFolder;
use crate::input::study::LoadedStudy;
use crate::program::MadeOf;

use super::study_file::StudyFile;
use super::written::target as target_of;
use super::{Console, Failure};

/// The document that lists the files of a ladder.
pub const LADDER: &str = "ladder.json";

/// Arguments of `washout add`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout add skin-bending --to studies/pre-pazy-skin.toml \\
    --output with-skin.toml
  washout add skin-bending --to with-skin.toml --remove
  washout add rod-split --number from=0.53 --on twist-v2 --to my-study.toml
  washout add glue-seam --own examples/effect_of_ones_own.toml \\
    --to my-study.toml

The effect is fitted together with all else that the study leaves open, and written with its fitted strength; the prior of the strength stays as wide as what is plausible. Comments of the study are kept. The error is shown step by step: uncalibrated and calibrated without any effect that was added, then with one after the other of those in the study, this one last (or taken out), down to the noise; fitted, left out (each case predicted from the others), held out. Writes output/NAME-ladder/ besides: the same as a picture (SVG), with its numbers (CSV); calibrated-WING.toml, each wing as calibrated; ladder.json.")]
pub struct Add {
    /// The effect: its name, or with --own that of a table [effects.NAME]
    pub effect: String,
    /// The study
    #[arg(long, value_name = "STUDY")]
    pub to: PathBuf,
    /// An effect of your own: the file with its table [effects.NAME], kind = "custom"
    #[arg(long, value_name = "FILE", conflicts_with = "remove")]
    pub own: Option<PathBuf>,
    /// Another number of the effect, e.g. from=0.53; can be given many times
    #[arg(long, value_name = "NAME=VALUE", conflicts_with_all = ["remove", "own"])]
    pub number: Vec<String>,
    /// The wing that has it, by the name of its design; can be given many times [default: candidates_on of the study, or all on which it can act]
    #[arg(long, value_name = "WING", conflicts_with = "remove")]
    pub on: Vec<String>,
    /// Hold the effect at this strength instead of fitting it; the others stay as they are
    #[arg(
        long,
        value_name = "S",
        conflicts_with = "remove",
        allow_negative_numbers = true
    )]
    pub strength: Option<f64>,
    /// Change a key in every design of the study, and write that into its cases; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Take the effect out instead
    #[arg(long)]
    pub remove: bool,
    /// Write the study here instead of over the old one; paths in it stay relative to it, so keep the folder
    #[arg(long, short, value_name = "FILE")]
    pub output: Option<PathBuf>,
    /// Folder for the picture of the error [default: output/NAME-ladder]
    #[arg(long, value_name = "DIR")]
    pub ladder: Option<PathBuf>,
    /// Write report.html into that folder besides: words, pictures and tables in one file for a browser
    #[arg(long)]
    pub report: bool,
}

impl Add {
    /// Fits, writes and shows.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let joining = Joining {
            effect: self.effect.clone(),
            own: self.own.clone(),
            numbers: self.number.clone(),
            on: self.on.clone(),
            strength: self.strength,
            is_removed: self.remove,
        };
        joining.check_name()?;
        let study = LoadedStudy::load(&self.to, &[])?;
        let file = StudyFile::read(&self.to, self.output.as_ref())?;
        let text = with_sets(&file.text, &self.set)?;
        let changed = LoadedStudy::from_text(&self.to, &text, &[])?;
        joining.check(&changed)?;
        let target = target_of(self.ladder.as_ref(), &study.study.name, "ladder");
        let folder = RunFolder::listed_by(&target, "add", LADDER)?;
        let fit = joining.fitted(&changed, &text, console.progress())?;
        self.write(fit, &study, &file, folder, console)
    }

    /// Writes the study and the folder, and says what was found.
    fn write(
        &self,
        fit: Fit,
        study: &LoadedStudy,
        file: &StudyFile,
        mut folder: RunFolder,
        console: &Console,
    ) -> Result<(), Failure> {
        add_falls(&mut folder, &study.study.name, &Fall::of_study(&fit.ladder))?;
        for design in &fit.designs {
            let (name, text) = calibrated::file(&study.study.name, design);
            folder.add(&name, text.as_bytes())?;
        }
        let report = AddReport {
            written: file.target.clone(),
            effect: self.effect.clone(),
            strength: fit.strength,
            what: what(&self.effect),
            stands_for: fit.stands_for,
            on_bench: fit.on_bench,
            others: fit.others,
            notes: fit.notes,
            ladder: fit.ladder,
            made_of: MadeOf::files(study.files.iter().chain(&fit.files)),
            files: folder.listed_with(self.report),
        };
        let page = page(&report);
        if self.report {
            html::folder::add(&mut folder, &page, Document::new(page.kind, &report)?)?;
        }
        folder.add_summary(&report)?;
        console.progress().check()?;
        // the study last: whoever is stopped between the two can do the same again
        let pictures = folder.commit()?;
        file.write(&fit.text)?;
        let first = report.files.iter().find(|file| file.starts_with("calibrated-"));
        let solve = first.map_or(String::new(), |file| {
            format!(
                "The wing as calibrated, in the condition of its first case: washout solve {}\n",
                pictures.join(file).display()
            )
        });
        let files = console.listed(&pictures, &report.files);
        console.answer(&page, &(solve + &files), &report)
    }
}
