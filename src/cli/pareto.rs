//! `washout pareto`: the front between lift and efficiency over twist profiles.

use std::path::{Path, PathBuf};

use clap::{Args, ValueEnum};

use crate::explore::shape_factor::{Gained, with_strength};
use crate::explore::twist_front::{efficiency_at, other_stops};
use crate::explore::{Efficiency, ExploreError, Nsga2, ShapeFactor, StagedTwist, TwistFront};
use crate::export::pareto::{Algorithm, Front, Gap, Marked, ParetoSummary, UntwistedPoint};
use crate::export::pictures;
use crate::export::run::RunFolder;
use crate::input::Design;
use crate::lift::{Stroke, TwistAlongSpan};
use crate::program::MadeOf;

use super::design_arguments::DesignArguments;
use super::finished::finished;
use super::fitted_factor::{fitted, misfit, without};
use super::fronts::Searches;
use super::job::Job;
use super::marked_wings::{Named, marked, named};
use super::tasks::{TaskArguments, beside};
use super::{Console, Failure};
use crate::wing::WingModel;
use crate::wing::flown::can_fly;

/// Arguments of `washout pareto`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout pareto designs/rigid.toml designs/twist-v1.toml designs/twist-v2.toml
  washout pareto designs/rigid.toml designs/twist-v1.toml \\
    designs/twist-v2.toml --rates 0.001,0.83 --exhaustive
  # blade elements alone, the twist held over the stroke
  washout pareto designs/rigid.toml --no-gain --ramp 0
  washout pareto designs/rigid.toml my-profile.csv \\
    --gain lift-gain-saturating --gain-strength 0.5
  # sixteen seeds, one front, on a cluster
  washout pareto designs/rigid.toml --no-gain --restarts 16 --slurm \\
    --partition night

The first design gives outline, air and stroke; the others, with their measured twist, and profiles (CSV: r_mm, twist_deg) are marked at that stroke, and the shape factor is fitted to the effective lift coefficients that were measured of them. Writes output/NAME-pareto/: front.svg, front.csv, profiles.svg, untwisted.csv, summary.json, and the ends of the front as profiles, highest-lift.csv and highest-efficiency.csv (of the front with the shape factor, unless --no-gain). The same seed gives the same front at any number of threads. The front of each seed is kept in output/NAME-pareto-tasks/ and found only once.")]
pub struct Pareto {
    /// Design that gives outline, air and stroke
    pub design: PathBuf,
    /// Designs with a measured twist, and profiles, to mark
    #[arg(value_name = "DESIGN|PROFILE")]
    pub marks: Vec<PathBuf>,
    /// Straight stages of a profile
    #[arg(long, value_name = "N", default_value_t = 3)]
    pub stages: usize,
    /// Least and largest twist rate of a stage, deg/mm
    #[arg(long, value_name = "LEAST,LARGEST", value_delimiter = ',', default_values_t = [0.001, 1.4])]
    pub rates: Vec<f64>,
    /// What counts as efficiency
    #[arg(long, value_enum, default_value_t = EfficiencyName::LocalLiftToDrag)]
    pub efficiency: EfficiencyName,
    /// Effect whose strength is the shape factor, fitted to the marked wings
    #[arg(long, value_name = "EFFECT", default_value = "lift-gain-linear")]
    pub gain: String,
    /// Strength of the shape factor, instead of a fit
    #[arg(long, value_name = "STRENGTH")]
    pub gain_strength: Option<f64>,
    /// No shape factor
    #[arg(long, conflicts_with_all = ["gain", "gain_strength"])]
    pub no_gain: bool,
    /// Share of each half-stroke over which the twist is ramped up, and down; 0 holds it
    #[arg(long, value_name = "SHARE", default_value_t = 0.2)]
    pub ramp: f64,
    /// Profiles of a generation
    #[arg(long, value_name = "N", default_value_t = 100, value_parser = clap::builder::RangedU64ValueParser::<usize>::new().range(..=10_000))]
    pub population: usize,
    /// Generations
    #[arg(long, value_name = "N", default_value_t = 150)]
    pub generations: usize,
    /// Seed of the random numbers
    #[arg(long, value_name = "N", default_value_t = 1)]
    pub seed: u64,
    /// Independent searches with this seed, the next, and so on; the front is that of them all
    #[arg(long, value_name = "N", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1000))]
    pub restarts: u16,
    /// Try every profile of a coarse family besides, and compare the areas of the fronts
    #[arg(long)]
    pub exhaustive: bool,
    /// Set a key of every design; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Folder to write into [default: output/NAME-pareto]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Write report.html besides: words, pictures and tables in one file for a browser
    #[arg(long)]
    pub report: bool,
    /// Tasks
    #[command(flatten)]
    pub tasks: TaskArguments,
}

/// What counts as efficiency.
#[derive(Debug, Clone, Copy, PartialEq, Eq, ValueEnum)]
pub enum EfficiencyName {
    /// Local lift over drag, mean along the span: the paper's
    LocalLiftToDrag,
    /// Mean lift over mean drag
    LiftToDrag,
    /// Mean lift per mean aerodynamic power
    LiftPerPower,
}

/// A wing without shape factor, and with it, by name.
type NamedWings = Vec<(&'static str, TwistFront)>;

/// What the fronts are sought for.
struct Problem<'a> {
    case: &'a WingModel,
    stroke: Stroke,
    family: StagedTwist,
    factor: Option<ShapeFactor>,
    marks: Vec<Named>,
}

impl Problem<'_> {
    /// The design without the shape factor: it may name that itself, with numbers of its own.
    fn without_factor(&self) -> Design {
        let design = &self.case.loaded.design;
        match &self.factor {
            Some(factor) => without(design, &factor.effect),
            None => design.clone(),
        }
    }
}

impl Pareto {
    /// Finds the fronts.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        if !(0.0..=0.5).contains(&self.ramp) {
            return Err(Failure::Option {
                option: "--ramp",
                reason: format!("{} is no share of a half-stroke; give 0 to 0.5", self.ramp),
            });
        }
        if self.rates.len() != 2 {
            return Err(Failure::Option {
                option: "--rates",
                reason: "give the least and the largest rate in deg/mm, e.g. 0.001,1.4".to_string(),
            });
        }
        let case = WingModel::new(DesignArguments::of_file(&self.design, &self.set, None).load(&[])?)?;
        can_fly(&case)?;
        let marks = named(&self.marks, &self.set, &case, console.progress())?;
        let stroke = case.stroke()?;
        let family = self.family(&case, &stroke)?;
        let factor = self.factor(&case, stroke, &marks)?;
        let name = &case.loaded.design.name;
        let target = self.output.clone();
        let target = target.unwrap_or_else(|| PathBuf::from("output").join(format!("{name}-pareto")));
        RunFolder::refuse(&target, "pareto")?;
        let problem = Problem {
            case: &case,
            stroke,
            family,
            factor,
            marks,
        };
        let found = self.searched(&problem, &beside(&target), console)?;
        let Some(mut summary) = found else {
            return Ok(());
        };
        let mut folder = RunFolder::create(&target, "pareto")?;
        pictures::pareto::add(&mut folder, &summary)?;
        summary.files = folder.listed_with(self.report);
        let page = summary.page();
        let written = finished(folder, self.report.then_some(&page), &summary, console)?;
        console.answer(&page, &console.listed(&written, &summary.files), &summary)
    }

    fn family(&self, case: &WingModel, stroke: &Stroke) -> Result<StagedTwist, Failure> {
        let rates = [self.rates[0], self.rates[1]];
        let (length_mm, stop_deg) = (case.planform.length_m() * 1e3, stroke.stop_angle_rad.to_degrees());
        StagedTwist::new(self.stages, length_mm, rates, stop_deg).map_err(|source| refused(case, source))
    }

    fn factor(
        &self,
        case: &WingModel,
        stroke: Stroke,
        marks: &[Named],
    ) -> Result<Option<ShapeFactor>, Failure> {
        if self.no_gain {
            return Ok(None);
        }
        let design = &case.loaded.design;
        let effect = &self.gain;
        if let Some(strength) = self.gain_strength {
            crate::effects::bind(&with_strength(design, effect, strength))
                .map_err(|error| case.fault(error))?;
            return Ok(Some(ShapeFactor {
                effect: effect.clone(),
                strength,
                sigma: 0.0,
                chi_squared: 0.0,
                freedom: 0,
                fitted: Vec::new(),
            }));
        }
        let wings: Vec<Gained> = marks.iter().filter_map(|mark| mark.gained.clone()).collect();
        let table = case.loaded.air_table.as_deref();
        ShapeFactor::fit(design, &case.planform, stroke, table, effect, &wings)
            .map(Some)
            .map_err(|source| refused(case, source))
    }

    /// What was found; none if it is not for this process to put it together.
    fn searched(
        &self,
        problem: &Problem,
        parts: &Path,
        console: &Console,
    ) -> Result<Option<ParetoSummary>, Failure> {
        let case = problem.case;
        let design = problem.without_factor();
        let (wings, marks) = self.wings(problem, &design)?;
        let mut searches = Searches {
            folder: parts.to_path_buf(),
            design: &case.loaded.path,
            wings,
            algorithm: Nsga2 {
                population: self.population,
                generations: self.generations,
                seed: self.seed,
                ..Nsga2::default()
            },
            restarts: self.restarts.into(),
            content: self.content(case, &problem.family, &problem.marks),
        };
        let job = Job::as_said(parts)?;
        if !self.tasks.finish(&mut searches, &job, console)? {
            return Ok(None);
        }
        let fronts = searches.fronts(self.exhaustive, console.progress())?;
        let stops: Vec<f64> = (2..=120).map(|half| 0.5 * f64::from(half)).collect();
        let table = case.loaded.air_table.as_deref();
        let curve = other_stops(
            &design,
            &case.planform,
            problem.stroke,
            table,
            self.efficiency(),
            &stops,
        )
        .map_err(|source| refused(case, source))?;
        self.summary(problem, fronts, &curve, marks).map(Some)
    }

    /// The marked wings come with their lift by each of the others.
    fn wings(&self, problem: &Problem, design: &Design) -> Result<(NamedWings, Vec<Marked>), Failure> {
        let case = problem.case;
        let fault = |source: ExploreError| refused(case, source);
        let mut models: Vec<(&'static str, Design)> = vec![("without shape factor", design.clone())];
        if let Some(factor) = &problem.factor {
            models.push((
                "with shape factor",
                with_strength(design, &factor.effect, factor.strength),
            ));
        }
        let mut wings = Vec::new();
        let mut named: Vec<Marked> = Vec::new();
        for (name, gained) in &models {
            let wing = TwistFront::new(
                design,
                gained,
                &case.planform,
                problem.stroke,
                case.loaded.air_table.as_deref(),
                self.efficiency(),
                problem.family.clone(),
                self.ramp,
            );
            let wing = wing.map_err(fault)?;
            for (index, mark) in problem.marks.iter().enumerate() {
                let [lift, efficiency] = wing.aims(&mark.twist).map_err(fault)?;
                match named.get_mut(index) {
                    Some(marked) => marked.lift.push(lift),
                    None => named.push(marked(mark, lift, efficiency, case.planform.length_m())),
                }
            }
            wings.push((*name, wing));
        }
        Ok((wings, named))
    }

    /// `curve`: stop angle (deg), lift and efficiency of the wing without twist.
    fn summary(
        &self,
        problem: &Problem,
        fronts: Vec<Front>,
        curve: &[[f64; 3]],
        marks: Vec<Marked>,
    ) -> Result<ParetoSummary, Failure> {
        let (case, stroke) = (problem.case, problem.stroke);
        let below: Vec<[f64; 3]> = curve.iter().copied().filter(|p| p[0] <= 60.0).collect();
        let factor = problem.factor.as_ref();
        let files = problem.marks.iter().flat_map(|mark| &mark.files);
        Ok(ParetoSummary {
            name: case.loaded.design.name.clone(),
            frequency_hz: stroke.frequency_hz,
            half_amplitude_deg: stroke.half_amplitude_rad.to_degrees(),
            stop_angle_deg: stroke.stop_angle_rad.to_degrees(),
            ramp: self.ramp,
            efficiency: self.efficiency().words().to_string(),
            stages: self.stages,
            rates_deg_per_mm: problem.family.rates_deg_per_mm,
            shortest_stage_mm: problem.family.shortest_mm,
            algorithm: Algorithm {
                population: self.population,
                generations: self.generations,
                seed: self.seed,
                restarts: self.restarts,
            },
            largest_gap: fronts.first().and_then(|front| gap(front, &below)),
            fronts,
            untwisted: curve
                .iter()
                .map(|&[stop_deg, lift, efficiency]| UntwistedPoint {
                    stop_deg,
                    lift,
                    efficiency,
                })
                .collect(),
            marks,
            warnings: factor.and_then(misfit).into_iter().collect(),
            shape_factor: factor.map(|factor| fitted(case, factor.clone())).transpose()?,
            made_of: MadeOf::files(case.loaded.files.iter().chain(files)),
            files: Vec::new(),
        })
    }

    /// What a front hangs on besides the search; the shape factor is told by what it is fitted to, for another machine may fit it
    /// to other last digits.
    fn content(&self, case: &WingModel, family: &StagedTwist, marks: &[Named]) -> String {
        let gain = (!self.no_gain).then_some((&self.gain, self.gain_strength));
        let numbers = |gained: &Gained| format!("{:.9e} {:.9e}", gained.effective, gained.sigma);
        let marks = marks
            .iter()
            .map(|mark| (&mark.twist, mark.gained.as_ref().map(numbers)));
        let marks: Vec<(&TwistAlongSpan, Option<String>)> = marks.collect();
        format!(
            "{}{family:?}{:?}{:?}{gain:?}{marks:?}",
            case.loaded.content(),
            self.efficiency,
            self.ramp
        )
    }

    fn efficiency(&self) -> Efficiency {
        match self.efficiency {
            EfficiencyName::LocalLiftToDrag => Efficiency::LocalLiftToDrag,
            EfficiencyName::LiftToDrag => Efficiency::LiftToDrag,
            EfficiencyName::LiftPerPower => Efficiency::LiftPerPower,
        }
    }
}

fn refused(case: &WingModel, source: ExploreError) -> Failure {
    Failure::Explore {
        design: case.loaded.path.clone(),
        source,
    }
}

/// How far a front is from the wing without twist at other stops.
fn gap(front: &Front, curve: &[[f64; 3]]) -> Option<Gap> {
    let gaps: Vec<[f64; 2]> = front
        .points
        .iter()
        .filter_map(|p| Some([p.lift, p.efficiency / efficiency_at(curve, p.lift)? - 1.0]))
        .collect();
    let largest = gaps.iter().max_by(|a, b| a[1].abs().total_cmp(&b[1].abs()))?;
    let square: f64 = gaps.iter().map(|[_, gap]| gap * gap).sum();
    Some(Gap {
        lift: largest[0],
        largest: largest[1],
        rms: (square / gaps.len() as f64).sqrt(),
    })
}
