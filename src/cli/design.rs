//! `washout design`: the rods that make a wanted twist, or the most lift per power, and their cutting template.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::explore::ExploreError;
use crate::explore::rods::search::Workshop;
use crate::explore::rods::{Aim, Candidate, Choices, Found, Tolerances, band};
use crate::export::layouts::LayoutSummary;
use crate::export::pictures;
use crate::export::run::RunFolder;
use crate::export::template::Template;
use crate::geometry::Planform;
use crate::input::stock::load_stock;
use crate::lift::TwistAlongSpan;
use crate::program::MadeOf;

use super::design_arguments::DesignArguments;
use super::finished::finished;
use super::job::Job;
use super::layout_summary::{Best, layout_summary};
use super::layouts::Looks;
use super::rod_aim::RodAim;
use super::tasks::{TaskArguments, beside, unfinished};
use super::{Console, Failure};
use crate::wing::WingModel;
use crate::wing::flown::can_fly;

/// Arguments of `washout design`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout design designs/twist-v2.toml --stock designs/stock.csv \\
    --profile wanted.csv
  # the round trip
  washout design designs/twist-v2.toml --stock designs/stock.csv \\
    --like designs/twist-v2.toml
  # most lift per power from 25 mN on
  washout design designs/twist-v2.toml --stock designs/stock.csv --lift 25
  washout design designs/twist-v2.toml --stock designs/stock.csv \\
    --profile wanted.csv --spars 3,5 --tension 0,30
  # on a cluster
  washout design designs/twist-v2.toml --stock designs/stock.csv --lift 25 \\
    --slurm --partition night

The design gives outline, film, the section of its first spar, stroke and materials; rod, and spars and film tension where asked for, are chosen. A profile is a CSV table with r_mm and twist_deg, as washout pareto writes it; a list of rods has name, shape (round, half-round, tube), diameter_mm, material and, if wanted, inner_diameter_mm and tolerance_mm. Writes output/NAME-design/: layout.toml (a design to solve), template.svg and template.dxf at full size, profile.svg, profile.csv, layouts.csv, summary.json. What is solved is kept in output/NAME-design-tasks/: after an interruption the same command goes on where it stopped.")]
pub struct DesignRod {
    /// The design
    #[command(flatten)]
    pub design: DesignArguments,
    /// List of rods
    #[arg(long, value_name = "CSV")]
    pub stock: PathBuf,
    /// Wanted twist along the span at mid-stroke
    #[arg(long, value_name = "CSV", group = "aim")]
    pub profile: Option<PathBuf>,
    /// Wanted twist: that of this design, as it solves
    #[arg(long, value_name = "DESIGN", group = "aim")]
    pub like: Option<PathBuf>,
    /// Most lift per power of those that lift so much, mN, mean over the stroke of one wing
    #[arg(long, value_name = "MN", group = "aim", allow_negative_numbers = true)]
    pub lift: Option<f64>,
    /// Most pieces of rod
    #[arg(long, value_name = "N", default_value_t = 2, value_parser = clap::value_parser!(u8).range(1..=2))]
    pub pieces: u8,
    /// Numbers of spars to try, evenly from 4 % to 96 % of the length [default: the spars of the design]
    #[arg(long, value_name = "N,N", value_delimiter = ',', value_parser = clap::value_parser!(u8).range(2..=20))]
    pub spars: Vec<u8>,
    /// Tensions of the film to try, N/m [default: that of the design]
    #[arg(
        long,
        value_name = "N,N",
        value_delimiter = ',',
        allow_negative_numbers = true
    )]
    pub tension: Vec<f64>,
    /// Factor on the mesh of the first look at all layouts
    #[arg(long, value_name = "FACTOR", default_value_t = 0.5)]
    pub first_look: f64,
    /// How far a break may be off, mm
    #[arg(long, value_name = "MM", default_value_t = 0.5)]
    pub break_tolerance: f64,
    /// How far a shear modulus without assumed range may be off, as a share
    #[arg(long, value_name = "SHARE", default_value_t = 0.2)]
    pub modulus_tolerance: f64,
    /// Folder to write into [default: output/NAME-design]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Write report.html besides: words, pictures and tables in one file for a browser
    #[arg(long)]
    pub report: bool,
    /// Layouts of the first look in one task
    #[arg(long, value_name = "N", default_value_t = 10, value_parser = clap::value_parser!(u32).range(1..=100_000))]
    pub task_size: u32,
    /// Tasks
    #[command(flatten)]
    pub tasks: TaskArguments,
}

impl DesignRod {
    /// Finds the layout.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        self.check()?;
        let (stock, on_shelf) = load_stock(&self.stock)?;
        let case = self.design.wing(console)?;
        can_fly(&case)?;
        if case.loaded.design.mesh.file.is_some() {
            return Err(Failure::Option {
                option: "--mesh",
                reason: "each layout has a mesh of its own; leave mesh.file out of the design".to_string(),
            });
        }
        let sought = self.sought(&case, console)?;
        let name = &case.loaded.design.name;
        let target = self.output.clone();
        let target = target.unwrap_or_else(|| PathBuf::from("output").join(format!("{name}-design")));
        RunFolder::refuse(&target, "design")?;
        let choices = self.choices(&case, stock);
        let workshop = Workshop {
            wing: &case,
            aim: &sought.aim,
            tip_m: case.loaded.design.observation.tip_station * case.planform.length_m(),
        };
        let refused = |source: ExploreError| Failure::Explore {
            design: case.loaded.path.clone(),
            source,
        };
        let parts = (beside(&target), sought.content.as_str(), self.task_size as usize);
        let looks = Looks::new(&case.loaded.path, &workshop, &choices, parts);
        let Some(found) = self.searched(looks, console)? else {
            return Ok(());
        };
        let best = best_of(&found, &sought.aim).map_err(refused)?;
        let band = band(&workshop, best, self.tolerances(), console.progress()).map_err(refused)?;
        let mut design = best.layout.applied(&case.loaded.design)?;
        design.name = format!("{name}-layout");
        design.measured = None;
        let best = Best {
            candidate: best,
            band,
            design,
        };
        let files = case.loaded.files.iter().chain([&on_shelf]);
        let made_of = MadeOf::files(files.chain(&sought.files));
        let summary = layout_summary(&case, &sought, &found, best, made_of);
        self.write(&case, sought.wanted(), &target, summary, console)
    }

    /// What was found; none if it is not for this process to put it together.
    fn searched(&self, mut looks: Looks, console: &Console) -> Result<Option<Found>, Failure> {
        let job = Job::as_said(&looks.folder)?;
        if !self.tasks.finish(&mut looks, &job, console)? {
            return Ok(None);
        }
        let found = looks.found(console.progress());
        found
            .map(Some)
            .map_err(|failure| unfinished(failure, &looks, &job))
    }

    fn tolerances(&self) -> Tolerances {
        Tolerances {
            break_mm: self.break_tolerance,
            shear_modulus_share: self.modulus_tolerance,
        }
    }

    /// Writes the folder, and says what stands in it.
    fn write(
        &self,
        case: &WingModel,
        wanted: Option<&TwistAlongSpan>,
        target: &Path,
        mut summary: LayoutSummary,
        console: &Console,
    ) -> Result<(), Failure> {
        let design = &summary.design;
        let planform = Planform::from_design(design).map_err(|error| case.fault(error))?;
        let template = Template::new(design, &planform);
        let mut folder = RunFolder::create(target, "design")?;
        folder.add("layout.toml", design.to_toml().as_bytes())?;
        folder.add("template.svg", template.to_svg().as_bytes())?;
        folder.add("template.dxf", template.to_dxf().as_bytes())?;
        let points = wanted.map_or(Vec::new(), |twist| points(twist, case.planform.length_m()));
        pictures::layouts::add(&mut folder, &summary, &points)?;
        summary.files = folder.listed_with(self.report);
        let page = summary.page();
        let written = finished(folder, self.report.then_some(&page), &summary, console)?;
        console.answer(&page, &console.listed(&written, &summary.files), &summary)
    }

    fn check(&self) -> Result<(), Failure> {
        let refuse = |option: &'static str, reason: String| Err(Failure::Option { option, reason });
        if self.profile.is_none() && self.like.is_none() && self.lift.is_none() {
            let reason = "say what the rod is for: --profile CSV, --like DESIGN or --lift MN".to_string();
            return refuse("--profile", reason);
        }
        for (option, value, most) in [
            ("--first-look", self.first_look, 4.0),
            ("--break-tolerance", self.break_tolerance, 50.0),
            ("--lift", self.lift.unwrap_or(1.0), 1e6),
        ] {
            if !(value > 0.0 && value <= most) {
                return refuse(
                    option,
                    format!("{value} is out of range; give more than 0 and at most {most}"),
                );
            }
        }
        if !(0.0..1.0).contains(&self.modulus_tolerance) {
            return refuse(
                "--modulus-tolerance",
                format!("{} is no share; give 0 to below 1", self.modulus_tolerance),
            );
        }
        match self
            .tension
            .iter()
            .find(|tension| !(0.0..=1e5).contains(*tension))
        {
            Some(tension) => refuse(
                "--tension",
                format!("{tension} N/m is out of range; give 0 to 100000"),
            ),
            None => Ok(()),
        }
    }

    fn sought(&self, case: &WingModel, console: &Console) -> Result<RodAim, Failure> {
        if let Some(path) = &self.profile {
            return RodAim::of_profile(path);
        }
        if let Some(path) = &self.like {
            let known = DesignArguments::of_file(path, &self.design.set, self.design.refine);
            return RodAim::of_design(&known, console);
        }
        Ok(RodAim::of_lift(self.lift.unwrap_or(0.0), case))
    }

    fn choices(&self, case: &WingModel, stock: Vec<crate::input::stock::StockRod>) -> Choices {
        let length_mm = case.planform.length_m() * 1e3;
        let even = |count: &u8| -> Option<Vec<f64>> {
            let last = f64::from(count - 1);
            let places = (0..*count).map(|k| length_mm * (0.04 + 0.92 * f64::from(k) / last));
            // to a hundredth of a millimetre: nobody places them finer
            Some(places.map(|mm| (mm * 100.0).round() / 100.0).collect())
        };
        Choices {
            stock,
            pieces: self.pieces.into(),
            spars_mm: match self.spars.as_slice() {
                [] => vec![None],
                counts => counts.iter().map(even).collect(),
            },
            pretensions_n_per_m: match self.tension.as_slice() {
                [] => vec![None],
                tensions => tensions.iter().copied().map(Some).collect(),
            },
            refine: self.first_look,
        }
    }
}

/// The layout that comes nearest to the aim; for lift, one that lifts as much as is asked for.
fn best_of<'a>(found: &'a Found, aim: &Aim) -> Result<&'a Candidate, ExploreError> {
    let Some(best) = found.candidates.first() else {
        return Err(ExploreError::NoLayout);
    };
    if let (Aim::LiftPerPower { least_lift_n }, false) = (aim, best.is_feasible()) {
        let most = found
            .candidates
            .iter()
            .max_by(|a, b| a.lift_n.total_cmp(&b.lift_n));
        let most = most.unwrap_or(best);
        return Err(ExploreError::NotLifted {
            wanted_mn: least_lift_n * 1e3,
            most_mn: most.lift_n * 1e3,
            layout: most.layout.words(),
        });
    }
    Ok(best)
}

fn points(twist: &TwistAlongSpan, length_m: f64) -> Vec<[f64; 2]> {
    let mut points: Vec<[f64; 2]> = twist.points().to_vec();
    if let Some(last) = points.last().copied()
        && last[0] < length_m
    {
        points.push([length_m, last[1]]);
    }
    points
        .into_iter()
        .map(|[r, twist]| [r * 1e3, twist.to_degrees()])
        .collect()
}
