//! `washout diagnose`: which physics the model of a study lacks, and how sure that is.

use std::path::{Path, PathBuf};

use clap::Args;
use serde_json::Value;

use crate::add::joining::wings;
use crate::diagnose::candidates::known;
use crate::diagnose::hypothesis::Hypothesis;
use crate::diagnose::of_study::refuse_own_data;
use crate::diagnose::strengths::Strength;
use crate::diagnose::verdict::{Diagnosis, Verdict};
use crate::diagnose::words::{AGREED, one_strength, probability_of};
use crate::diagnose::{Cache, Candidates, Plan, Settings, StudyDiagnosis, plan_study};
use crate::effects::{instead_of, named};
use crate::export::diagnosis::{DiagnosisReport, page};
use crate::export::html::cases::{at_work, found};
use crate::export::html::{self, REPORT};
use crate::export::json;
use crate::export::pictures::write::add_diagnosis;
use crate::export::plan::page as page_of_plan;
use crate::export::run::RunFolder;
use crate::export::sheet::to_keep;
use crate::input::sheet::{DesignReadings, Sigmas};
use crate::input::study::LoadedStudy;
use crate::origin::InputFile;
use crate::page::Part;
use crate::page::text::{significant, wrapped};
use crate::study::Campaign;

use super::written::target;
use super::{Console, Failure};

/// The document that lists the files of a diagnosis.
pub const DIAGNOSIS: &str = "diagnosis.json";

/// Arguments of `washout diagnose`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout diagnose studies/pre-pazy-skin.toml
  # a design and a table of readings, long or wide, or .xlsx
  washout diagnose my-wing.toml --with sheet.csv
  # one condition is predicted, not fitted
  washout diagnose my-wing.toml --with sheet.csv --hold-out 22hz
  # these two only
  washout diagnose my-study.toml --effect root-flexure --effect tip-loss-prandtl
  # what that wing has and the others have not
  washout diagnose my-study.toml --on repaired-wing
  # before any measurement: what could be seen, what told apart
  washout diagnose my-study.toml --plan
  # report.html besides: the wings with and without what is found
  washout diagnose my-study.toml --report
  washout diagnose my-study.toml --json | jq .verdict

The verdict comes first, in one sentence; then what it rests on. Where explanations compete it says what to measure next: of tables [[experiment]] in the study (as [[case]], the values of their measurement files empty), which one; without such tables, the cheapest of these that decides: one more station, the still wing under a torque or a push, its deflection, half the frequency or the speed. Writes output/NAME-diagnosis/: effects against the residual, residuals in sigma, the error step by step and what is missing as pictures (SVG), with the numbers behind each (CSV); diagnosis.json. With --plan it writes no files. How the model answers to every effect takes most of the time. It does not depend on what was measured, and is kept for the next question, as is the answer for the same question, in the cache folder of the user: $XDG_CACHE_HOME/washout or ~/.cache/washout; WASHOUT_CACHE names another, and none if empty.")]
pub struct Diagnose {
    /// The study; with --with the design
    #[arg(value_name = "STUDY|DESIGN")]
    pub study: PathBuf,
    /// A table of readings, measured on the design: .csv, .tsv, .xlsx or .ods; what was understood is printed first
    #[arg(long, value_name = "TABLE", conflicts_with_all = ["plan", "on"])]
    pub with: Option<PathBuf>,
    /// Standard deviation of readings of the table that state none, e.g. 0.3, or "0.3 deg, 0.05 mm" [default: 0.5 deg, 0.5 mm]
    #[arg(long, value_name = "SIGMA", requires = "with", allow_negative_numbers = true)]
    pub sigma: Option<Sigmas>,
    /// A condition of the table that no fit sees, so that it tests what is found, e.g. 22hz; can be given many times
    #[arg(long, value_name = "CONDITION", requires = "with")]
    pub hold_out: Vec<String>,
    /// Change a key in every design of the study; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Try this effect; can be given many times [default: those that the study names, or all that can act]
    #[arg(long, value_name = "NAME")]
    pub effect: Vec<String>,
    /// Do not try this effect, which cannot be for a reason that no reading shows; can be given many times [default: excluded of the
    /// study]
    #[arg(long, value_name = "NAME")]
    pub without: Vec<String>,
    /// Try effects on this wing alone, by the name of its design, and hold the others to be as modelled; can be given many times
    /// [default: candidates_on of the study, or all]
    #[arg(long, value_name = "WING")]
    pub on: Vec<String>,
    /// Probability of a false alarm that is accepted where nothing is missing
    #[arg(long, value_name = "P", default_value_t = 0.01)]
    pub significance: f64,
    /// Judge the campaign instead of its measurements, whose values may still be missing
    #[arg(long)]
    pub plan: bool,
    /// Diagnose even data that were made by washout synthesize with the meshes, formulas or seed used here
    #[arg(long)]
    pub own_data: bool,
    /// Seed of the draws of noise
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// Folder to write into [default: output/NAME-diagnosis]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Write report.html besides: the wings without and with what is found, pictures and tables in one file for a browser
    #[arg(long, conflicts_with = "plan")]
    pub report: bool,
}

impl Diagnose {
    /// Diagnoses and writes; of a plan, judges the campaign.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let (study, table) = self.subject(console)?;
        if self.plan {
            let plan = self.planned(&study, console)?;
            // A plan is words only.
            return console.answer(&page_of_plan(&study.study.name, &plan), "", &plan);
        }
        let target = target(self.output.as_ref(), &study.study.name, "diagnosis");
        let folder = RunFolder::listed_by(&target, "diagnose", DIAGNOSIS)?;
        let (campaign, report) = self.found(&study, table.as_ref(), console)?;
        let earlier = read_from(&target.join(DIAGNOSIS));
        let is_other = earlier.is_some_and(|files| files != report.made_of.files);
        self.written(&campaign, report, folder, console)?;
        if is_other {
            console.note(format_args!(
                "{} replaces an earlier answer, of other inputs; --output DIR keeps both",
                target.display()
            ));
        }
        Ok(())
    }

    /// The document that `--json` prints; no files are written and none are named.
    ///
    /// # Errors
    /// As [`Diagnose::run`], but for those of writing.
    pub fn document(&self, console: &Console) -> Result<Value, Failure> {
        let (study, table) = self.subject(console)?;
        let document = match self.plan {
            true => json::document(&self.planned(&study, console)?),
            false => json::document(&self.found(&study, table.as_ref(), console)?.1),
        };
        Ok(document?)
    }

    /// What is diagnosed: the study, and the table that it was made of, if it was.
    fn subject(&self, console: &Console) -> Result<(LoadedStudy, Option<DesignReadings>), Failure> {
        known(&self.effect).map_err(|error| Failure::of_diagnosis(&self.study, error))?;
        if let Some(name) = self.without.iter().find(|name| named(name).is_none()) {
            return Err(Failure::Option {
                option: "--without",
                reason: format!("there is no effect {name}; {}", instead_of(name)),
            });
        }
        if let Some(name) = self.without.iter().find(|name| self.effect.contains(name)) {
            return Err(Failure::Option {
                option: "--without",
                reason: format!("{name} is asked for by --effect, too. Leave out one of the two"),
            });
        }
        if self.sigma.is_some() && self.with.is_none() {
            return Err(Failure::Option {
                option: "--sigma",
                reason: "is of the readings of a table; a study states that of its own. Leave it out"
                    .to_string(),
            });
        }
        let table = self.with.as_ref().map(|table| {
            DesignReadings::load(table, &self.study, &self.sigma.clone().unwrap_or_default())?
                .holding_out(&self.hold_out)
        });
        let table = table.transpose()?;
        if let Some(table) = &table {
            console.understood(&table.sheet);
        }
        let mut study = match (&table, self.plan) {
            (Some(table), _) => table.study(&self.set)?,
            (None, true) => LoadedStudy::load_planned(&self.study, &self.set)?,
            (None, false) => LoadedStudy::load(&self.study, &self.set)?,
        };
        wings(&study, &self.on)?;
        study.study.excluded.extend(self.without.iter().cloned());
        if !self.on.is_empty() {
            study.study.candidates_on = Some(self.on.clone());
        }
        if !self.own_data && !self.plan {
            refuse_own_data(&study, self.seed).map_err(|error| Failure::of_diagnosis(&study.path, error))?;
        }
        Ok((study, table))
    }

    fn settings(&self) -> Settings {
        Settings {
            significance: self.significance,
            seed: self.seed,
            ..Settings::default()
        }
    }

    /// The diagnosis, without files; what looks wrong in a table is said first, what is assumed of it last.
    fn found(
        &self,
        study: &LoadedStudy,
        table: Option<&DesignReadings>,
        console: &Console,
    ) -> Result<(Campaign, DiagnosisReport), Failure> {
        let (effects, cache) = (candidates(study, &self.effect, console)?, Cache::of_user());
        let found = StudyDiagnosis::new(study, &effects, self.settings(), &cache, console.progress());
        let of_study = |error| Failure::of_diagnosis(&study.path, error);
        let found = found.map_err(of_study)?;
        let found = match table {
            Some(table) => found
                .of_table(table, &self.set, console.progress())
                .map_err(of_study)?,
            None => found,
        };
        let mut report = DiagnosisReport::new(found.diagnosis, found.work, study);
        report.commands = self.commands(&report.diagnosis, table);
        Ok((found.campaign, report))
    }

    /// The commands to go on with: what keeps the study of a table, then what takes into the model what is named, or is most probable; of a
    /// table where there is nothing to take, what shows what more readings could show.
    fn commands(&self, diagnosis: &Diagnosis, table: Option<&DesignReadings>) -> Vec<String> {
        let path = table.map_or(self.study.clone(), |table| {
            PathBuf::from(format!("{}.toml", table.name()))
        });
        let is_sound = diagnosis.check_first.is_none();
        let to_add = if is_sound {
            to_add(&path, &self.on, diagnosis)
        } else {
            Vec::new()
        };
        let plan = table.filter(|_| to_add.is_empty());
        let plan = plan.map(|_| format!("washout diagnose {} --plan", path.display()));
        table.map(to_keep).into_iter().chain(to_add).chain(plan).collect()
    }

    /// What the campaign of a study could see and tell apart.
    fn planned(&self, study: &LoadedStudy, console: &Console) -> Result<Plan, Failure> {
        let (effects, cache) = (candidates(study, &self.effect, console)?, Cache::of_user());
        let plan = plan_study(study, &effects, self.settings(), &cache, console.progress());
        plan.map_err(|error| Failure::of_diagnosis(&study.path, error))
    }

    fn written(
        &self,
        campaign: &Campaign,
        mut report: DiagnosisReport,
        mut folder: RunFolder,
        console: &Console,
    ) -> Result<(), Failure> {
        let study = campaign.name.as_str();
        add_diagnosis(&mut folder, study, &report.diagnosis)?;
        report.files = folder.listed_with(self.report);
        if self.report {
            let wings = found(campaign, &report.diagnosis, console.progress())?;
            let at_work = at_work(campaign, &report.diagnosis, console.progress())?;
            let page = html::diagnosis::page(study, &report, &wings, &at_work)?;
            folder.add(REPORT, page.html().as_bytes())?;
        }
        folder.add_summary(&report)?;
        console.progress().check()?;
        let written = folder.commit()?;
        let screening = report.diagnosis.screening;
        let mut answer = page(study, &report.diagnosis);
        let work = format!(
            "Screening of every effect: {} derivatives with {} factorizations; in all {}",
            screening.derivatives, screening.factorizations, report.work
        );
        answer.section("work", "What it took", vec![Part::Text(work)]);
        let after = to_go_on(&report) + &console.listed(&written, &report.files);
        console.answer(&answer, &after, &report)
    }
}

/// The files of which the document of an earlier answer was made; none where there is no such document.
fn read_from(document: &Path) -> Option<Vec<InputFile>> {
    let text = std::fs::read_to_string(document).ok()?;
    let document: Value = serde_json::from_str(&text).ok()?;
    serde_json::from_value(document["made_of"]["files"].clone()).ok()
}

/// What to go on with, for a screen.
fn to_go_on(report: &DiagnosisReport) -> String {
    if report.commands.is_empty() {
        return String::new();
    }
    let is_added = |command: &String| command.starts_with("washout add ");
    let why = match report.diagnosis.verdict {
        _ if !report.commands.iter().any(is_added) => {
            "To go on with a study, and to see what more readings could show"
        }
        Verdict::Set => &format!("To try {}, which is not sure", strengths(&report.diagnosis)),
        _ => &format!("To take it into the model{}", on_a_bench(&report.diagnosis)),
    };
    let lines = report.commands.iter().map(|command| format!("  {command}\n"));
    wrapped(&format!("{why}:"), 0) + &lines.collect::<String>()
}

/// What is most probable of a set, with its strengths.
fn strengths(diagnosis: &Diagnosis) -> String {
    let each = to_try(diagnosis).into_iter();
    let each = each.map(|own| one_strength(own) + &as_measured(own));
    each.collect::<Vec<_>>().join(" and ")
}

/// What the strengths of what is named are on a bench, as the end of a phrase.
fn on_a_bench(diagnosis: &Diagnosis) -> String {
    to_try(diagnosis).into_iter().map(as_measured).collect()
}

/// What a strength is as something that a bench measures, in brackets.
fn as_measured(strength: &Strength) -> String {
    let known = strength.stands_for.as_ref();
    known.map_or(String::new(), |(value, unit)| {
        format!(" ({} {unit})", significant(*value, 3))
    })
}

/// The commands that take what is named, or is most probable in a set, into the model of the study.
fn to_add(study: &Path, on: &[String], diagnosis: &Diagnosis) -> Vec<String> {
    let strengths = to_try(diagnosis).into_iter();
    strengths.map(|strength| add(strength, study, on)).collect()
}

/// The strengths of what is named, or is most probable in a set, the surest first; of a pair in a set those alone that most of the
/// probability agrees on, if it does on any.
fn to_try(diagnosis: &Diagnosis) -> Vec<&Strength> {
    let is_known = |hypothesis: &&Hypothesis| !hypothesis.families.is_empty() && hypothesis.in_set;
    let known = match diagnosis.verdict {
        Verdict::Effect | Verdict::Set => diagnosis.hypotheses.iter().find(is_known),
        Verdict::Nothing | Verdict::Novel | Verdict::Undecidable => None,
    };
    let Some(known) = known else {
        return Vec::new();
    };
    let mut strengths: Vec<&Strength> = known.strengths.iter().collect();
    // what is surest first: a fit of the other alone might end elsewhere
    let in_errors = |own: &Strength| own.value.abs() / own.standard_error;
    strengths.sort_by(|a, b| in_errors(b).total_cmp(&in_errors(a)));
    let is_agreed = |effect: &String| {
        let family = known
            .effects
            .iter()
            .position(|own| own == effect)
            .and_then(|place| known.families.get(place));
        family.is_some_and(|family| probability_of(diagnosis, family) >= AGREED)
    };
    let is_pair = diagnosis.verdict == Verdict::Set && known.families.len() > 1;
    if is_pair && strengths.iter().any(|own| is_agreed(&own.effect)) {
        strengths.retain(|own| is_agreed(&own.effect));
    }
    strengths
}

/// The command that takes an effect into the model of the study.
fn add(strength: &Strength, study: &Path, on: &[String]) -> String {
    let mut command = format!("washout add {}", strength.effect);
    if let Some(place) = &strength.place {
        let at = [(place.parameter.clone(), significant(place.value, 3))];
        let numbers = place.numbers.iter();
        let numbers = numbers.map(|(name, value)| (name.clone(), value.to_string()));
        for (name, value) in at.into_iter().chain(numbers) {
            command.push_str(&format!(" --number {name}={value}"));
        }
    }
    let wing = strength.place.as_ref().and_then(|place| place.wing.as_ref());
    for wing in wing.into_iter().chain(on.iter().filter(|_| wing.is_none())) {
        command.push_str(&format!(" --on {wing}"));
    }
    format!("{command} --to {}", study.display())
}

/// A study diagnosed as `washout diagnose STUDY` does it.
pub fn diagnosed(study: &LoadedStudy, console: &Console) -> Result<StudyDiagnosis, Failure> {
    let settings = Settings::default();
    let of_study = |error| Failure::of_diagnosis(&study.path, error);
    refuse_own_data(study, settings.seed).map_err(of_study)?;
    let effects = candidates(study, &[], console)?;
    StudyDiagnosis::new(study, &effects, settings, &Cache::of_user(), console.progress()).map_err(of_study)
}

/// The effects to try; of those that were named and cannot be, the reason is noted.
pub fn candidates(study: &LoadedStudy, asked: &[String], console: &Console) -> Result<Candidates, Failure> {
    let found = Candidates::new(study, asked);
    let found = found.map_err(|error| Failure::of_diagnosis(&study.path, error))?;
    found.left_out.iter().for_each(|words| console.note(words));
    Ok(found)
}
