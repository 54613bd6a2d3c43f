//! `washout compare`: where the model misses the measurement, in degrees, in sigma and in words.

use std::collections::BTreeMap;
use std::path::{Path, PathBuf};

use clap::Args;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use crate::compare::{Comparison, Reading};
use crate::export::collect::{Solved, summarize};
use crate::export::comparison;
use crate::export::html::{self, Document, Page, REPORT, Wing};
use crate::export::json;
use crate::export::pictures::profile::StripRow;
use crate::export::pictures::wing::figure as wing_figure;
use crate::export::pictures::write::add_wing;
use crate::export::run::RunFolder;
use crate::input::Loaded;
use crate::input::measurement::{Channel, Measurement};
use crate::input::study::LoadedStudy;
use crate::lift::{Ratios, StrokeMeans};
use crate::origin::{InputFile, MadeOf};
use crate::page::text::number;
use crate::page::{Digits, Page as Answer, Part, Rows, Table};

use super::design_arguments::{DesignArguments, beside, is_there};
use super::sheet::FromSheet;
use super::study::{COMPARISON, listed, target};
use super::{Console, Failure};
use crate::wing::{DiscretizationError, SolvedWing, WingError, WingModel};

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

Columns of a measurement file: see the files in measurements/. Writes output/NAME-compare/: model against measurement, and residuals in units and in sigma, as pictures (SVG) with the numbers behind each (CSV); comparison.json. An earlier comparison there is replaced only when all of that is complete.")]
pub struct Compare {
    /// The design
    #[command(flatten)]
    pub design: DesignArguments,
    /// Measurement file or table of readings (.csv, .tsv, .xlsx, .ods), of a design only [default: the file that the design names]
    #[arg(long, value_name = "FILE")]
    pub with: Option<PathBuf>,
    /// Standard deviation of readings of the table that state none, in their unit [default: 0.5 deg, 0.5 mm]
    #[arg(long, value_name = "SIGMA", requires = "with", value_parser = super::sheet::number)]
    pub sigma: Option<f64>,
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

/// What `washout compare` prints.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CompareReport {
    /// Measured minus modelled.
    pub comparison: Comparison,
    /// The wing against the reference wing, as modelled; absent unless asked for.
    pub ratios: Option<ModelledRatios>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

/// Modelled ratios of a wing to a reference wing.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ModelledRatios {
    /// Name of the reference wing.
    pub reference: String,
    /// Largest angular speed of the stroke over that of the reference.
    pub rate_ratio: f64,
    /// The ratios: as both flap, and with the stroke of the wing set equal to that of the reference.
    pub ratios: Vec<NamedRatio>,
}

/// One ratio under two conditions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NamedRatio {
    /// What it is.
    pub name: String,
    /// Each wing at its own frequency and amplitude.
    pub as_solved: f64,
    /// Both at the same product of frequency and amplitude, with the twist as solved.
    pub at_equal_rate: f64,
}

impl CompareReport {
    /// What it says.
    fn page(&self) -> Answer {
        let mut page = comparison::page(&self.comparison);
        let ratios = self.page_of_ratios().sections;
        let parts = ratios.iter().flat_map(|section| &section.parts);
        page.brief.extend(parts.cloned());
        page.sections.extend(ratios);
        page
    }

    /// What it says of the reference wing alone.
    fn page_of_ratios(&self) -> Answer {
        let mut page = Answer {
            kind: "comparison",
            ..Answer::default()
        };
        let tables = self.ratios.iter().map(|found| Part::Table(table(found)));
        page.section("ratios", "Against the reference wing", tables.collect());
        page
    }
}

/// A wing against the reference wing, if there is one.
#[derive(Default)]
struct AgainstReference {
    whole_wing: BTreeMap<Channel, f64>,
    ratios: Option<ModelledRatios>,
    /// What the reference wing was read from.
    files: Vec<InputFile>,
}

/// What is compared.
enum Subject {
    /// A design with a measurement.
    Design(Box<Loaded>),
    /// A study, and the table that it was made of, if it was.
    Study(Box<LoadedStudy>, Option<Box<FromSheet>>),
}

/// A design solved and read, with its document, which names no files.
struct ComparedWing {
    wing: SolvedWing,
    reading: Reading,
    report: CompareReport,
}

impl Compare {
    /// Solves, compares and writes.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        match self.subject(console)? {
            Subject::Design(loaded) => self.run_design(*loaded, console),
            Subject::Study(study, table) => {
                let from = (self.source(table.as_deref()), &*study);
                super::study::compare(from, table.as_deref(), self.output.as_ref(), self.report, console)
            }
        }
    }

    /// The document that `--json` prints; no files are written and none are named.
    ///
    /// # Errors
    /// As [`Compare::run`], but for those of writing.
    pub fn document(&self, console: &Console) -> Result<Value, Failure> {
        match self.subject(console)? {
            Subject::Design(loaded) => Ok(json::document(&self.compared(*loaded, console)?.report)?),
            Subject::Study(study, table) => {
                let from = (self.source(table.as_deref()), &*study);
                super::study::document(from, table.as_deref(), console)
            }
        }
    }

    fn subject(&self, console: &Console) -> Result<Subject, Failure> {
        let path = &self.design.design;
        if LoadedStudy::is_study(path)? {
            let study = LoadedStudy::load(path, &self.study_sets()?)?;
            return Ok(Subject::Study(Box::new(study), None));
        }
        if let Some(table) = self.sheet()? {
            console.note(table.understood());
            let study = table.study(&self.sets())?;
            return Ok(Subject::Study(Box::new(study), Some(Box::new(table))));
        }
        let loaded = self.load()?;
        match loaded.measurement {
            Some(_) => Ok(Subject::Design(Box::new(loaded))),
            None => Err(WingError::NoMeasurement { design: loaded.path }.into()),
        }
    }

    /// The file that the readings of a study come from.
    fn source<'a>(&'a self, table: Option<&'a FromSheet>) -> &'a Path {
        table.map_or(&self.design.design, |table| &table.table)
    }

    fn compared(&self, loaded: Loaded, console: &Console) -> Result<ComparedWing, Failure> {
        let progress = console.progress();
        progress.say(format_args!("solving {}", loaded.design.name));
        let wing = WingModel::new(loaded)?.solve(progress)?;
        let reference = self.against_reference(&wing, console)?;
        let reading = Reading::of(&wing, &reference.whole_wing)?;
        let Some(comparison) = reading.measured.clone() else {
            return Err(wing.model.no_measurement().into());
        };
        let report = CompareReport {
            comparison,
            ratios: reference.ratios,
            made_of: MadeOf::files(wing.model.loaded.files.iter().chain(&reference.files)),
            files: Vec::new(),
        };
        Ok(ComparedWing {
            wing,
            reading,
            report,
        })
    }

    fn run_design(&self, loaded: Loaded, console: &Console) -> Result<(), Failure> {
        let progress = console.progress();
        let target = target(self.output.as_ref(), &loaded.design.name, "compare");
        let mut folder = RunFolder::listed_by(&target, "compare", COMPARISON)?;
        let ComparedWing {
            wing,
            reading,
            mut report,
        } = self.compared(loaded, console)?;
        let run = self
            .report
            .then(|| run_page(&wing, &reading, console))
            .transpose()?;
        add_wing(&mut folder, &report.comparison, &reading.profile)?;
        report.files = folder.listed_with(self.report);
        let ratios = report.page_of_ratios();
        if let Some(mut run) = run {
            run.add(&ratios, Document::new(ratios.kind, &report)?)?;
            folder.add(REPORT, run.html().as_bytes())?;
        }
        folder.add_summary(&report)?;
        progress.check()?;
        let written = folder.commit()?;
        let sketch = console.sketch(&wing_figure(&report.comparison, Some(&reading.profile)));
        let files = listed(&written, &report.files);
        console.answer(&report.page(), &format!("{files}{sketch}"), &report)
    }

    fn against_reference(&self, wing: &SolvedWing, console: &Console) -> Result<AgainstReference, Failure> {
        let Some(path) = &self.reference else {
            return Ok(AgainstReference::default());
        };
        let means = wing.means_on_ramp()?;
        let case = self.reference(path, console)?;
        let (name, reference) = reference_means(&case, console)?;
        let found = ratios(&wing.model, means, reference)?;
        Ok(AgainstReference {
            whole_wing: BTreeMap::from([
                (Channel::LiftRatio, found.lift),
                (Channel::DragRatio, found.drag),
                (Channel::EfficiencyRatio, found.local_lift_to_drag),
            ]),
            ratios: Some(named(name, &found, &wing.model)?),
            files: case.loaded.files,
        })
    }

    /// The table of `--with`, if it is one of readings and no measurement file.
    fn sheet(&self) -> Result<Option<FromSheet>, Failure> {
        let is_sheet = |table: &&PathBuf| table.is_file() && !Measurement::is_file(table);
        let Some(table) = self.with.as_ref().filter(is_sheet) else {
            return match self.sigma {
                Some(_) => Err(Failure::Option {
                    option: "--sigma",
                    reason:
                        "is of a table of readings; a measurement file states that of its own. Leave it out"
                            .to_string(),
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
            None => FromSheet::load(table, &self.design.design, self.sigma).map(Some),
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
            let file = beside(&self.design.design, file);
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

    fn reference(&self, path: &Path, console: &Console) -> Result<WingModel, Failure> {
        let arguments = DesignArguments {
            memory: self.design.memory,
            ..DesignArguments::of_file(path, &[], self.design.refine)
        };
        arguments.wing(console)
    }
}

fn reference_means(case: &WingModel, console: &Console) -> Result<(String, Option<StrokeMeans>), Failure> {
    let name = case.loaded.design.name.clone();
    console.progress().say(format_args!("solving {name}"));
    Ok((name, case.solve(console.progress())?.means_on_ramp()?))
}

fn ratios(
    case: &WingModel,
    wing: Option<StrokeMeans>,
    reference: Option<StrokeMeans>,
) -> Result<Ratios, Failure> {
    match (wing, reference) {
        (Some(wing), Some(reference)) => {
            Ratios::between(&wing, &reference).map_err(|error| case.fault(error).into())
        }
        _ => Err(Failure::Option {
            option: "--reference",
            reason: "ratios need two wings that flap; give both a [flapping] table".to_string(),
        }),
    }
}

fn named(reference: String, found: &Ratios, case: &WingModel) -> Result<ModelledRatios, Failure> {
    let equal = found.at_rate_ratio(1.0).map_err(|error| case.fault(error))?;
    let row = |name: &str, value: fn(&Ratios) -> f64| NamedRatio {
        name: name.to_string(),
        as_solved: value(found),
        at_equal_rate: value(&equal),
    };
    Ok(ModelledRatios {
        reference,
        rate_ratio: found.rate_ratio,
        ratios: vec![
            row("mean lift", |r| r.lift),
            row("mean drag", |r| r.drag),
            row("mean power", |r| r.power),
            row("mean lift over mean drag", |r| r.lift_to_drag),
            row(
                "local lift over drag along the span (the paper's efficiency)",
                |r| r.local_lift_to_drag,
            ),
            row("lift per power", |r| r.lift_per_power),
            row("lift at equal power", |r| r.lift_at_equal_power),
            row("lift per power at equal lift", |r| r.lift_per_power_at_equal_lift),
        ],
    })
}

/// The ratios; they stand at `ratios` in the document.
fn table(modelled: &ModelledRatios) -> Table {
    let caption = format!(
        "Modelled ratios to {} (20/60/20 ramp; 2πfΦ {} times its)",
        modelled.reference,
        number(modelled.rate_ratio, 4)
    );
    Rows::of("/ratios/ratios", &modelled.ratios)
        .words("ratio", |row| row.name.as_str())
        .number(["as_solved", "as both flap", ""], Digits::After(3), |row| {
            row.as_solved
        })
        .number(
            ["at_equal_rate", "at equal stroke", ""],
            Digits::After(3),
            |row| row.at_equal_rate,
        )
        .caption(&caption)
        .table()
}

/// The report of the run behind a comparison.
fn run_page(wing: &SolvedWing, reading: &Reading, console: &Console) -> Result<Page, Failure> {
    let SolvedWing { model, solution } = wing;
    let summary = summarize(&Solved {
        wing,
        reading,
        mesh_error: &DiscretizationError::default(),
        uncertainty: None,
        engineering: &wing.engineering(console.progress())?,
    });
    let strips: Vec<StripRow> = solution.strips.iter().map(StripRow::of).collect();
    let wing = Wing::of_solution(&model.design().name, model.design(), &model.planform, solution);
    Ok(html::run::page(&summary, wing, &strips)?)
}

/// The report of a comparison whose run is not at hand.
pub fn report_page(report: &CompareReport) -> Result<Page, Failure> {
    let answer = report.page();
    let mut page = Page {
        title: answer.title.clone(),
        ..Page::default()
    };
    page.add(&answer, Document::new(answer.kind, report)?)?;
    Ok(page)
}
