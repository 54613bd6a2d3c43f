//! `washout design`: the rods that make a wanted twist, or the most lift per power, and their cutting template.

use std::path::PathBuf;

use clap::Args;

use crate::explore::ExploreError;
use crate::explore::rods::search::{Workshop, read_twist};
use crate::explore::rods::{Aim, Candidate, Choices, Found, Tolerances, band};
use crate::export::layouts::{BandSummary, Cause, LayoutRow, LayoutSummary, PieceRow};
use crate::export::pictures;
use crate::export::run::RunFolder;
use crate::export::template::Template;
use crate::input::TwistTable;
use crate::input::stock::load_stock;
use crate::lift::TwistAlongSpan;
use crate::origin::{InputFile, MadeOf};

use super::design_arguments::DesignArguments;
use super::finished::finished;
use super::job::Job;
use super::layouts::Looks;
use super::tasks::{TaskArguments, beside, unfinished};
use super::{Console, Failure};
use crate::wing::flown::can_fly;
use crate::wing::{WingError, WingModel};

/// Share of lift per power within which two layouts count as equally good.
const ALIKE: f64 = 0.01;

/// Arguments of `washout design`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout design designs/twist-v2.toml --stock designs/stock.csv --profile wanted.csv
  washout design designs/twist-v2.toml --stock designs/stock.csv --like designs/twist-v2.toml    the round trip
  washout design designs/twist-v2.toml --stock designs/stock.csv --lift 25                     most lift per power from 25 mN on
  washout design designs/twist-v2.toml --stock designs/stock.csv --profile wanted.csv --spars 3,5 --tension 0,30
  washout design designs/twist-v2.toml --stock designs/stock.csv --lift 25 --slurm --partition night    on a cluster

The design gives outline, film, the section of its first spar, stroke and materials; rod, and spars and film tension where
asked for, are chosen. A profile is a CSV table with r_mm and twist_deg, as washout pareto writes it; a list of rods has name,
shape (round, half-round, tube), diameter_mm, material and, if wanted, inner_diameter_mm and tolerance_mm.
Writes output/NAME-design/: layout.toml (a design to solve), template.svg and template.dxf at full size, profile.svg,
profile.csv, layouts.csv, summary.json. What is solved is kept in output/NAME-design-tasks/: after an interruption the same
command goes on where it stopped.")]
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
        let (aim, words, content, aimed_by) = self.aim(&case, console)?;
        let name = &case.loaded.design.name;
        let target = self.output.clone();
        let target = target.unwrap_or_else(|| PathBuf::from("output").join(format!("{name}-design")));
        RunFolder::refuse(&target, "design")?;
        let choices = self.choices(&case, stock);
        let workshop = Workshop {
            wing: &case,
            aim: &aim,
            tip_m: case.loaded.design.observation.tip_station * case.planform.length_m(),
        };
        let refused = |source: ExploreError| Failure::Explore {
            design: case.loaded.path.clone(),
            source,
        };
        let parts = (beside(&target), content.as_str(), self.task_size as usize);
        let mut looks = Looks::new(&case.loaded.path, &workshop, &choices, parts);
        let job = Job::as_said(&looks.folder)?;
        if !self.tasks.finish(&mut looks, &job, console)? {
            return Ok(());
        }
        let found = looks.found(console.progress());
        let found = found.map_err(|failure| unfinished(failure, &looks, &job))?;
        let Some(best) = found.candidates.first() else {
            return Err(refused(ExploreError::NoLayout));
        };
        if let (Aim::LiftPerPower { least_lift_n }, false) = (&aim, best.is_feasible()) {
            let most = found
                .candidates
                .iter()
                .max_by(|a, b| a.lift_n.total_cmp(&b.lift_n));
            let most = most.unwrap_or(best);
            return Err(refused(ExploreError::NotLifted {
                wanted_mn: least_lift_n * 1e3,
                most_mn: most.lift_n * 1e3,
                layout: most.layout.words(),
            }));
        }
        let tolerances = Tolerances {
            break_mm: self.break_tolerance,
            shear_modulus_share: self.modulus_tolerance,
        };
        let band = band(&workshop, best, tolerances, console.progress()).map_err(refused)?;
        let mut design = best.layout.applied(&case.loaded.design)?;
        design.name = format!("{name}-layout");
        design.measured = None;
        let wanted = match &aim {
            Aim::Twist(twist) => Some(twist),
            Aim::LiftPerPower { .. } => None,
        };
        let stations = &band.stations;
        let mut summary = LayoutSummary {
            name: name.clone(),
            aim: words,
            layouts: found.candidates.iter().map(row).collect(),
            equally_good: alike(&found, best, band.built_deg),
            wanted_deg: wanted.map_or(Vec::new(), |twist| {
                stations
                    .iter()
                    .map(|[r_m, _, _]| twist.twist_rad(*r_m).to_degrees())
                    .collect()
            }),
            band: BandSummary {
                pieces: band
                    .pieces
                    .iter()
                    .map(|piece| PieceRow {
                        from_mm: piece.from_mm,
                        to_mm: piece.to_mm,
                        rate_deg_per_mm: piece.rate_deg_per_mm,
                        tolerance_deg_per_mm: piece.tolerance_deg_per_mm,
                    })
                    .collect(),
                r_mm: stations.iter().map(|s| s[0] * 1e3).collect(),
                twist_deg: stations.iter().map(|s| s[1].to_degrees()).collect(),
                tolerance_deg: stations.iter().map(|s| s[2].to_degrees()).collect(),
                rms_deg: band.rms_deg,
                built_deg: band.built_deg,
                causes: band
                    .causes
                    .iter()
                    .map(|(what, rms_deg)| Cause {
                        what: what.clone(),
                        rms_deg: *rms_deg,
                    })
                    .collect(),
            },
            solved: found.solved,
            unsolved: found.unsolved,
            warnings: warnings(&case, best, band.built_deg),
            design: design.clone(),
            made_of: MadeOf::files(case.loaded.files.iter().chain([&on_shelf]).chain(&aimed_by)),
            files: Vec::new(),
        };
        let planform = crate::geometry::Planform::from_design(&design).map_err(|error| case.fault(error))?;
        let template = Template::new(&design, &planform);
        let mut folder = RunFolder::create(&target, "design")?;
        folder.add("layout.toml", design.to_toml().as_bytes())?;
        folder.add("template.svg", template.to_svg().as_bytes())?;
        folder.add("template.dxf", template.to_dxf().as_bytes())?;
        let points = wanted.map_or(Vec::new(), |twist| points(twist, case.planform.length_m()));
        pictures::layouts::add(&mut folder, &summary, &points)?;
        summary.files = folder.listed_with(self.report);
        let page = summary.page(&target.display().to_string());
        let words = self.report.then_some(page.as_str());
        finished(folder, words, ("summary", &summary), console)?;
        console.result(&page, &summary)
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

    /// The aim, the same in words, what it is made of, and the files that it is read from.
    fn aim(
        &self,
        case: &WingModel,
        console: &Console,
    ) -> Result<(Aim, String, String, Vec<InputFile>), Failure> {
        if let Some(path) = &self.profile {
            let table = TwistTable::load(path)?;
            let [(_, points)] = table.profiles.as_slice() else {
                return Err(Failure::Option {
                    option: "--profile",
                    reason: format!(
                        "{} has a profile for each of {} phases, and a rod is sought for one; give the one at mid-stroke \
                         (columns r_mm, twist_deg)",
                        path.display(),
                        table.profiles.len()
                    ),
                });
            };
            let points = points.iter().map(|[r_mm, deg]| [r_mm * 1e-3, deg.to_radians()]);
            let twist = TwistAlongSpan::from_points(points.collect());
            let twist = twist.map_err(|error| WingError::design(path, error))?;
            let content = format!("{twist:?}");
            return Ok((
                Aim::Twist(twist),
                format!("the twist of {}", path.display()),
                content,
                table.input.into_iter().collect(),
            ));
        }
        if let Some(path) = &self.like {
            let known = DesignArguments::of_file(path, &self.design.set, self.design.refine).wing(console)?;
            let twist = read_twist(&known.solve(console.progress())?);
            let twist = twist.map_err(|error| WingError::design(path, error))?;
            let known = &known.loaded;
            return Ok((
                Aim::Twist(twist),
                format!("the twist that {} has", known.design.name),
                // not the twist itself: another machine may solve it to other last digits
                known.content(),
                known.files.clone(),
            ));
        }
        let least_mn = self.lift.unwrap_or(0.0);
        let stroke = case.loaded.design.flapping.as_ref();
        let stroke = stroke.map_or(String::new(), |flapping| {
            format!(
                " at {} Hz, ±{} deg",
                flapping.frequency_hz.value(),
                flapping.half_amplitude_deg.value()
            )
        });
        let aim = Aim::LiftPerPower {
            least_lift_n: least_mn * 1e-3,
        };
        Ok((
            aim,
            format!("the most lift per power from {least_mn} mN of lift on{stroke}"),
            format!("{least_mn:?} mN"),
            Vec::new(),
        ))
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

fn row(candidate: &Candidate) -> LayoutRow {
    let pieces = &candidate.layout.pieces;
    LayoutRow {
        layout: candidate.layout.words(),
        rods: pieces.iter().map(|piece| piece.rod.name.clone()).collect(),
        to_mm: pieces.iter().map(|piece| piece.to_mm).collect(),
        distance_deg: candidate.distance_deg,
        lift_mn: candidate.lift_n * 1e3,
        lift_per_power_n_per_w: if candidate.power_w > 0.0 {
            candidate.lift_n / candidate.power_w
        } else {
            0.0
        },
        is_feasible: candidate.is_feasible(),
    }
}

/// How many candidates are as good as the best within what may be off as they are built.
fn alike(found: &Found, best: &Candidate, built_deg: f64) -> usize {
    let room = if best.distance_deg.is_some() {
        built_deg
    } else {
        ALIKE
    };
    let is_alike = |candidate: &&Candidate| candidate.is_feasible() && candidate.behind(best) <= room;
    found.candidates.iter().take_while(is_alike).count()
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

fn warnings(case: &WingModel, best: &Candidate, built_deg: f64) -> Vec<String> {
    let mut warnings = Vec::new();
    if let Some(distance) = best.distance_deg
        && distance > 2.0 * built_deg
    {
        warnings.push(format!(
            "The best layout stays {distance:.1} deg (root mean square over the span) from what is wanted, more than twice what \
             fabrication can have off: no layout of these rods makes that twist. Add rods to the list, or allow more pieces, \
             spars or tensions."
        ));
    }
    let amplitude = case
        .loaded
        .design
        .flapping
        .as_ref()
        .map(|flapping| &flapping.half_amplitude_deg);
    if amplitude.is_some_and(|amplitude| amplitude.assumption().is_some()) {
        warnings.push(
            "The amplitude is assumed: twist goes with its square over the shear modulus, and so does the layout.".to_string(),
        );
    }
    warnings
}
