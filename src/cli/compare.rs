//! `washout compare`: where the model misses the measurement, in degrees, in sigma and in words.

use std::path::PathBuf;

use clap::Args;
use serde_json::Value;

use crate::compare::study_comparison::CalibratedUnknown;
use crate::compare::{ComparedStudy, DesignComparison};
use crate::export::calibrated;
use crate::export::compare_report::CompareReport;
use crate::export::html::study::StudyParts;
use crate::export::html::{self, REPORT};
use crate::export::json;
use crate::export::pictures::compared::figure as compared_figure;
use crate::export::pictures::panels::Compared;
use crate::export::pictures::wing::figure as wing_figure;
use crate::export::pictures::write::{add_study, add_wing};
use crate::export::run::RunFolder;
use crate::export::study::{StudyReport, page as page_of_study};
use crate::input::measurement::Measurement;
use crate::input::sheet::{DesignReadings, Sigmas};
use crate::input::study::LoadedStudy;
use crate::input::{Loaded, seen_from};
use crate::study::UnknownKind;
use crate::wing::{WingError, WingModel};

use super::design_arguments::{DesignArguments, is_there};
use super::written::target;
use super::{Console, Failure};

/// The document that lists the files of a comparison.
pub const COMPARISON: &str = "comparison.json";

/// Arguments of `washout compare`.
#[derive(Debug, Args)]
#[command(mut_arg("design", |design| design.value_name("DESIGN|STUDY").help("Design or study file")))]
#[command(after_help = "Examples:
  washout compare designs/twist-v1.toml
  washout compare designs/twist-v2.toml \\
    --with measurements/colmenares-as-restated.csv
  # a table of readings: what was understood is printed first
  washout compare my-wing.toml --with sheet.csv
  # ratios of lift and efficiency too
  washout compare designs/twist-v2.toml --reference designs/rigid.toml
  # all cases of a study, before and after calibration
  washout compare studies/paper-wings.toml
  # report.html besides: the wing in 3D, pictures, tables
  washout compare designs/twist-v2.toml --report

Columns of a measurement file: see the files in measurements/. Writes output/NAME-compare/: model against measurement, and residuals in units and in sigma, as pictures (SVG) with the numbers behind each (CSV); comparison.json; of a study also calibrated-WING.toml, each wing as calibrated, to be solved at other operating points. An earlier comparison there is replaced only when all of that is complete.")]
pub struct Compare {
    /// The design
    #[command(flatten)]
    pub design: DesignArguments,
    /// Measurement file or table of readings (.csv, .tsv, .xlsx, .ods), of a design only [default: the file that the design names]
    #[arg(long, value_name = "FILE")]
    pub with: Option<PathBuf>,
    /// Standard deviation of readings of the table that state none, e.g. 0.3, or "0.3 deg, 0.05 mm" [default: 0.5 deg, 0.5 mm]
    #[arg(long, value_name = "SIGMA", requires = "with", allow_negative_numbers = true)]
    pub sigma: Option<Sigmas>,
    /// A condition of the table that no fit sees, so that it tests what is found, e.g. 22hz; can be given many times
    #[arg(long, value_name = "CONDITION", requires = "with")]
    pub hold_out: Vec<String>,
    /// Case in that file, of a design only [default: the one that the design names, or the name of the wing]
    #[arg(long, value_name = "NAME")]
    pub case: Option<String>,
    /// Design of the wing that measured ratios refer to, for a design only
    #[arg(long, value_name = "DESIGN")]
    pub reference: Option<PathBuf>,
    /// Folder to write into [default: output/NAME-compare]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Write report.html besides: the wing in 3D, pictures and tables in one file for a browser
    #[arg(long)]
    pub report: bool,
}

/// What is compared.
enum Subject {
    /// A design with a measurement.
    Design(Box<WingModel>),
    /// A study, and the table that it was made of, if it was.
    Study(Box<LoadedStudy>, Option<Box<DesignReadings>>),
}

impl Compare {
    /// Solves, compares and writes.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        match self.subject(console)? {
            Subject::Design(wing) => self.run_design(&wing, console),
            Subject::Study(study, table) => self.run_study(&study, table.as_deref(), console),
        }
    }

    /// The document that `--json` prints; no files are written and none are named.
    ///
    /// # Errors
    /// As [`Compare::run`], but for those of writing.
    pub fn document(&self, console: &Console) -> Result<Value, Failure> {
        let document = match self.subject(console)? {
            Subject::Design(wing) => {
                json::document(&CompareReport::new(&self.compared_design(&wing, console)?))
            }
            Subject::Study(study, table) => {
                let compared = self.compared_study(&study, table.as_deref(), console)?;
                json::document(&StudyReport::new(compared.comparison, &study))
            }
        };
        Ok(document?)
    }

    fn subject(&self, console: &Console) -> Result<Subject, Failure> {
        let path = &self.design.design;
        if LoadedStudy::is_study(path)? {
            let study = LoadedStudy::load(path, &self.study_sets()?)?;
            return Ok(Subject::Study(Box::new(study), None));
        }
        if let Some(table) = self.sheet()? {
            console.understood(&table.sheet);
            let study = table.study(&self.sets())?;
            return Ok(Subject::Study(Box::new(study), Some(Box::new(table))));
        }
        let loaded = self.load()?;
        match loaded.measurement {
            Some(_) => Ok(Subject::Design(Box::new(WingModel::new(loaded)?))),
            None => Err(WingError::NoMeasurement { design: loaded.path }.into()),
        }
    }

    fn compared_design(&self, wing: &WingModel, console: &Console) -> Result<DesignComparison, Failure> {
        let reference = self.reference.as_ref().map(|path| {
            let arguments = DesignArguments {
                memory: self.design.memory,
                ..DesignArguments::of_file(path, &[], self.design.refine)
            };
            arguments.wing(console)
        });
        let reference = reference.transpose()?;
        Ok(DesignComparison::new(
            wing,
            reference.as_ref(),
            console.progress(),
        )?)
    }

    fn run_design(&self, wing: &WingModel, console: &Console) -> Result<(), Failure> {
        let progress = console.progress();
        let target = target(self.output.as_ref(), &wing.design().name, "compare");
        let mut folder = RunFolder::listed_by(&target, "compare", COMPARISON)?;
        let found = self.compared_design(wing, console)?;
        let engineering = self
            .report
            .then(|| found.wing.engineering(progress))
            .transpose()?;
        let profile = &found.reading.profile;
        add_wing(&mut folder, &found.comparison, profile)?;
        let report = CompareReport {
            files: folder.listed_with(self.report),
            ..CompareReport::new(&found)
        };
        if let Some(engineering) = &engineering {
            let page = html::compared::page(&found, &report, engineering)?;
            folder.add(REPORT, page.html().as_bytes())?;
        }
        folder.add_summary(&report)?;
        progress.check()?;
        let written = folder.commit()?;
        let sketch = console.sketch(&wing_figure(&report.comparison, Some(profile)));
        let files = console.listed(&written, &report.files);
        console.answer_with(&report.page(), &files, &sketch, &report)
    }

    fn compared_study(
        &self,
        study: &LoadedStudy,
        table: Option<&DesignReadings>,
        console: &Console,
    ) -> Result<ComparedStudy, Failure> {
        let compared = ComparedStudy::new(study, console.progress()).map_err(|source| Failure::OfStudy {
            study: table.map_or(&self.design.design, |table| &table.table).clone(),
            source,
        })?;
        Ok(match table {
            Some(table) => compared.of_table(table),
            None => compared,
        })
    }

    fn run_study(
        &self,
        study: &LoadedStudy,
        table: Option<&DesignReadings>,
        console: &Console,
    ) -> Result<(), Failure> {
        let progress = console.progress();
        let target = target(self.output.as_ref(), &study.study.name, "compare");
        let mut folder = RunFolder::listed_by(&target, "compare", COMPARISON)?;
        let compared = self.compared_study(study, table, console)?;
        let parts = self
            .report
            .then(|| StudyParts::new(&compared, study, progress))
            .transpose()?;
        add_study(&mut folder, &compared.comparison)?;
        self.add_calibrated(&mut folder, &compared, study)?;
        let report = StudyReport {
            files: folder.listed_with(self.report),
            ..StudyReport::new(compared.comparison, study)
        };
        if let Some(parts) = parts {
            folder.add(REPORT, html::study::page(&report, &parts)?.html().as_bytes())?;
        }
        folder.add_summary(&report)?;
        progress.check()?;
        let written = folder.commit()?;
        let sketch = console.sketch(&compared_figure(&Compared::of_study(&report.comparison)));
        let files = console.listed(&written, &report.files);
        console.answer_with(&page_of_study(&report.comparison), &files, &sketch, &report)
    }

    /// A design of each wing as calibrated, to be solved under other conditions.
    fn add_calibrated(
        &self,
        folder: &mut RunFolder,
        compared: &ComparedStudy,
        study: &LoadedStudy,
    ) -> Result<(), Failure> {
        let is_of_wing = |found: &CalibratedUnknown| found.unknown.kind != UnknownKind::Ruler;
        if !compared.comparison.unknowns.iter().any(is_of_wing) && study.study.effect.is_empty() {
            return Ok(());
        }
        let designs = compared.calibrated_designs(study);
        let designs = designs.map_err(|source| Failure::OfStudy {
            study: study.path.clone(),
            source,
        })?;
        for design in designs {
            let (name, text) = calibrated::file(&study.study.name, &design);
            folder.add(&name, text.as_bytes())?;
        }
        Ok(())
    }

    /// The table of `--with`, if it is one of readings and no measurement file.
    fn sheet(&self) -> Result<Option<DesignReadings>, Failure> {
        // only a table is given a sigma, also one that is not there
        let is_sheet = |table: &&PathBuf| match table.is_file() {
            true => !Measurement::is_file(table),
            false => self.sigma.is_some() || !self.hold_out.is_empty(),
        };
        let Some(table) = self.with.as_ref().filter(is_sheet) else {
            let of_tables = [
                (
                    "--sigma",
                    self.sigma.is_some(),
                    "a measurement file states that of its own",
                ),
                (
                    "--hold-out",
                    !self.hold_out.is_empty(),
                    "a measurement file is one case",
                ),
            ];
            return match of_tables.into_iter().find(|(_, is_given, _)| *is_given) {
                Some((option, _, why)) => Err(Failure::Option {
                    option,
                    reason: format!("is of a table of readings; {why}. Leave it out"),
                }),
                None => Ok(None),
            };
        };
        let others = [
            ("--case", self.case.is_some()),
            ("--reference", self.reference.is_some()),
            ("--mesh", self.design.mesh.is_some()),
        ];
        match others.into_iter().find(|(_, is_given)| *is_given) {
            Some((option, _)) => Err(Failure::Option {
                option,
                reason: format!(
                    "does not go with {}, which is a table of readings and no measurement file; leave it out",
                    table.display()
                ),
            }),
            None => {
                let read = DesignReadings::load(
                    table,
                    &self.design.design,
                    &self.sigma.clone().unwrap_or_default(),
                )?;
                Ok(Some(read.holding_out(&self.hold_out)?))
            }
        }
    }

    /// What the command line changes in a design.
    fn sets(&self) -> Vec<String> {
        let refine = self.design.refine.map(|factor| format!("mesh.refine={factor}"));
        self.design.set.iter().cloned().chain(refine).collect()
    }

    /// What the command line changes in every design of a study.
    fn study_sets(&self) -> Result<Vec<String>, Failure> {
        let others = [
            ("--with", self.with.is_some()),
            ("--case", self.case.is_some()),
            ("--reference", self.reference.is_some()),
            ("--mesh", self.design.mesh.is_some()),
        ];
        if let Some((option, _)) = others.into_iter().find(|(_, is_given)| *is_given) {
            let reason = "belongs to a design; a study names its measurements and meshes itself".to_string();
            return Err(Failure::Option { option, reason });
        }
        Ok(self.sets())
    }

    fn load(&self) -> Result<Loaded, Failure> {
        let mut sets = Vec::new();
        if let Some(file) = &self.with {
            is_there("--with", file)?;
            let file = seen_from(&self.design.design, file);
            sets.push(format!("measured.file={}", file.display()));
        }
        match &self.case {
            Some(case) => sets.push(format!("measured.case={case}")),
            None if self.with.is_some() => {
                let plain = self.design.load(&[])?.design;
                let case = plain.measured.map_or(plain.name, |measured| measured.case);
                sets.push(format!("measured.case={case}"));
            }
            None => {}
        }
        self.design.load(&sets)
    }
}
