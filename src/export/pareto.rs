//! The front between lift and efficiency over twist profiles: the document, page and tables of `washout pareto`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::program::MadeOf;

use super::ExportError;
use super::csv::table;
use crate::page::Digits::After;
use crate::page::text::number;
use crate::page::{Page, Part, Rows, Table};

/// What `washout pareto` prints with `--json`; `summary.json` of its folder. Lift and efficiency are over those of the wing
/// without twist at its own stop.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ParetoSummary {
    /// Name of the design that gives outline, air and stroke.
    pub name: String,
    /// Flapping frequency.
    pub frequency_hz: f64,
    /// Half of the peak-to-peak stroke angle.
    pub half_amplitude_deg: f64,
    /// Angle of attack of the root at its stop; no profile twists its tip further.
    pub stop_angle_deg: f64,
    /// Share of each half-stroke over which the twist is ramped up, and down.
    pub ramp: f64,
    /// What counts as efficiency.
    pub efficiency: String,
    /// Straight stages of a profile.
    pub stages: usize,
    /// Bounds of each stage's rate.
    pub rates_deg_per_mm: [f64; 2],
    /// Shortest stage.
    pub shortest_stage_mm: f64,
    /// Size of the population, generations and seed.
    pub algorithm: Algorithm,
    /// The fronts: without the shape factor, and with it if there is one.
    pub fronts: Vec<Front>,
    /// The wing without twist at other stops.
    pub untwisted: Vec<UntwistedPoint>,
    /// Where the first front is furthest from that curve; absent where they share no lift.
    pub largest_gap: Option<Gap>,
    /// Wings and profiles that were named, at the same stroke.
    pub marks: Vec<Marked>,
    /// The shape factor; absent if none was asked for.
    pub shape_factor: Option<FittedFactor>,
    /// Things that limit what the numbers say.
    pub warnings: Vec<String>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

/// Settings of the search.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Algorithm {
    /// Profiles of a generation.
    pub population: usize,
    /// Generations after the first.
    pub generations: usize,
    /// Seed of the random numbers of the first search.
    pub seed: u64,
    /// Searches, each with the seed after that of the one before.
    pub restarts: u16,
}

impl Algorithm {
    /// The seeds in words.
    fn seeds(&self) -> String {
        match self.restarts {
            1 => format!("seed {}", self.seed),
            more => format!("{more} seeds from {} on", self.seed),
        }
    }
}

/// A front.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Front {
    /// Its name.
    pub name: String,
    /// Its profiles by rising lift.
    pub points: Vec<Profile>,
    /// Area between the front and the corner.
    pub hypervolume: f64,
    /// Lift and efficiency of the corner: the least of each on the front.
    pub corner: [f64; 2],
    /// Every profile of a coarse family; absent unless asked for.
    pub exhaustive: Option<Exhaustive>,
}

/// Every profile of a coarse family, tried.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Exhaustive {
    /// Profiles of the family.
    pub profiles: usize,
    /// Area between their front and the corner.
    pub hypervolume: f64,
    /// Area of the found front over that.
    pub found_over_exhaustive: f64,
    /// The same of the front that the search finds when it is held to the steps of the coarse family: 1 if it misses nothing.
    pub on_steps_over_exhaustive: f64,
}

/// A profile with what it gives.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Profile {
    /// Lift.
    pub lift: f64,
    /// Efficiency.
    pub efficiency: f64,
    /// Twist at the tip.
    pub tip_deg: f64,
    /// Length of each stage, from the base outward.
    pub length_mm: Vec<f64>,
    /// Twist rate of each stage.
    pub rate_deg_per_mm: Vec<f64>,
}

/// The wing without twist at one stop.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct UntwistedPoint {
    /// Angle of attack at the stop.
    pub stop_deg: f64,
    /// Lift.
    pub lift: f64,
    /// Efficiency.
    pub efficiency: f64,
}

/// Where the front without shape factor is furthest from the untwisted wing at other stops.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Gap {
    /// Lift there.
    pub lift: f64,
    /// Efficiency of the front over that of the untwisted wing, less one.
    pub largest: f64,
    /// Root mean square of the same over the front.
    pub rms: f64,
}

/// A wing or profile that was named.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Marked {
    /// Name.
    pub name: String,
    /// Efficiency.
    pub efficiency: f64,
    /// Lift in each front's model.
    pub lift: Vec<f64>,
    /// Twist at the tip.
    pub tip_deg: f64,
    /// Points of its profile: span position (mm) and twist (deg).
    pub profile: Vec<[f64; 2]>,
}

/// The shape factor.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FittedFactor {
    /// The effect whose strength it is.
    pub effect: String,
    /// Its formula.
    pub formula: String,
    /// The strength.
    pub strength: f64,
    /// Its standard deviation, widened by the misfit; absent where it was given.
    pub sigma: Option<f64>,
    /// Unit of both.
    pub unit: String,
    /// Misfit of the wings together, sum of squares in standard deviations.
    pub chi_squared: Option<f64>,
    /// Degrees of freedom of that.
    pub freedom: usize,
    /// The wings it was fitted to.
    pub wings: Vec<FittedWing>,
}

/// A wing that the shape factor was fitted to.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FittedWing {
    /// Name.
    pub name: String,
    /// Effective lift coefficient over that of the wing without twist, measured.
    pub measured: f64,
    /// Its standard deviation.
    pub sigma: f64,
    /// The same as fitted.
    pub fitted: f64,
}

impl Profile {
    /// The stages in words.
    pub fn words(&self) -> String {
        let stages = self.length_mm.iter().zip(&self.rate_deg_per_mm);
        let stages: Vec<String> = stages
            .map(|(length, rate)| format!("{} over {} mm", number(*rate, 2), number(*length, 0)))
            .collect();
        format!("{} (deg/mm)", stages.join(", "))
    }

    /// The profile as points: span position (mm) and twist (deg).
    pub fn points(&self) -> Vec<[f64; 2]> {
        let mut points = vec![[0.0, 0.0]];
        let mut last = [0.0, 0.0];
        for (length, rate) in self.length_mm.iter().zip(&self.rate_deg_per_mm) {
            last = [last[0] + length, last[1] + length * rate];
            points.push(last);
        }
        points
    }
}

impl Front {
    /// The profile that lifts most.
    pub fn highest_lift(&self) -> Option<&Profile> {
        self.points.iter().max_by(|a, b| a.lift.total_cmp(&b.lift))
    }

    /// The most efficient profile.
    pub fn highest_efficiency(&self) -> Option<&Profile> {
        self.points
            .iter()
            .max_by(|a, b| a.efficiency.total_cmp(&b.efficiency))
    }
}

impl ParetoSummary {
    /// What `washout pareto` says.
    pub fn page(&self) -> Page {
        let mut page = Page {
            title: format!(
                "{}: front between lift and efficiency ({}) over twist profiles",
                self.name, self.efficiency
            ),
            kind: "summary",
            lead: vec![Part::Text(self.family()), Part::Notes(self.warnings.clone())],
            ..Page::default()
        };
        if let Some(factor) = &self.shape_factor {
            page.section(
                "factor",
                "Shape factor (assumed form, prior)",
                factor_parts(factor),
            );
        }
        let fronts = self.fronts.iter().enumerate();
        let fronts = fronts.flat_map(|(index, front)| self.front_parts(index, front));
        page.section("fronts", "Fronts", fronts.collect());
        if !self.marks.is_empty() {
            page.section("marks", "Marked wings", vec![Part::Table(self.marked())]);
        }
        page.section(
            "gap",
            "Without the shape factor",
            self.gap_words().into_iter().collect(),
        );
        page
    }

    fn family(&self) -> String {
        format!(
            "{} stages of at least {} mm and {} to {} deg/mm, tip at most {} deg; {} Hz, ±{} deg, ramp over {} % of each half-stroke; \
             population {}, {} generations, {}. Lift and efficiency are over those of the wing without twist at its stop of {} deg.",
            self.stages,
            number(self.shortest_stage_mm, 0),
            self.rates_deg_per_mm[0],
            self.rates_deg_per_mm[1],
            number(self.stop_angle_deg, 0),
            number(self.frequency_hz, 1),
            number(self.half_amplitude_deg, 1),
            number(100.0 * self.ramp, 0),
            self.algorithm.population,
            self.algorithm.generations,
            self.algorithm.seeds(),
            number(self.stop_angle_deg, 0),
        )
    }

    /// The ends of a front, and how much more it lifts than each marked wing.
    fn front_parts(&self, index: usize, front: &Front) -> Vec<Part> {
        let title = format!("Front {}, {} profiles", front.name, front.points.len());
        let highest = |of: fn(&Profile) -> f64| {
            let points = front.points.iter().enumerate();
            points.max_by(|(_, a), (_, b)| of(a).total_cmp(&of(b)))
        };
        let ends = [
            ("highest lift", highest(|profile| profile.lift)),
            ("highest efficiency", highest(|profile| profile.efficiency)),
        ];
        let ends: Vec<(&str, usize, &Profile)> = ends
            .into_iter()
            .filter_map(|(name, end)| end.map(|(place, profile)| (name, place, profile)))
            .collect();
        let table = Rows::keyed(
            &format!("/fronts/{index}/points"),
            ends.iter().map(|end| (end.1, end)),
        )
        .words("profile", |end| end.0)
        .number(["lift", "lift", ""], After(3), |end| end.2.lift)
        .number(["efficiency", "efficiency", ""], After(3), |end| end.2.efficiency)
        .number(["tip_deg", "tip", "deg"], After(1), |end| end.2.tip_deg)
        .words("twist", |end| end.2.words())
        .table();
        let mut lines: Vec<String> = Vec::new();
        if let Some(highest) = front.highest_lift() {
            let more = |mark: &Marked| 100.0 * (highest.lift / mark.lift[index] - 1.0);
            let over = self
                .marks
                .iter()
                .map(|mark| format!("highest lift over {}: {} %", mark.name, number(more(mark), 1)));
            lines.extend(over);
        }
        lines.extend(front.exhaustive.as_ref().map(|all| {
            format!(
                "all {} profiles of a coarse family tried: the search held to its steps has {} times the area of their front, the front \
                 above {} times",
                all.profiles,
                number(all.on_steps_over_exhaustive, 4),
                number(all.found_over_exhaustive, 4)
            )
        }));
        vec![Part::Subtitle(title), Part::Table(table), Part::List(lines)]
    }

    fn marked(&self) -> Table {
        let names: Vec<&str> = self.fronts.iter().map(|front| front.name.as_str()).collect();
        Rows::of("/marks", &self.marks)
            .words("wing", |mark| mark.name.as_str())
            .numbers(["lift/*", "lift", ""], After(3), |mark| {
                mark.lift.iter().copied().map(Some).collect()
            })
            .number(["efficiency", "efficiency", ""], After(3), |mark| mark.efficiency)
            .number(["tip_deg", "tip", "deg"], After(1), |mark| mark.tip_deg)
            .caption(&format!("Lift {}", names.join(" / ")))
            .table()
    }

    fn gap_words(&self) -> Option<Part> {
        let gap = self.largest_gap.as_ref()?;
        Some(Part::Text(format!(
            "The front differs from the untwisted wing at other stops by at most {} % in efficiency at the same lift (at {} times the \
             lift; {} % root mean square).",
            number(100.0 * gap.largest.abs(), 2),
            number(gap.lift, 3),
            number(100.0 * gap.rms, 2)
        )))
    }
}

fn factor_parts(factor: &FittedFactor) -> Vec<Part> {
    let sigma = factor.sigma;
    let sigma = sigma.map_or(String::new(), |sigma| format!(" ± {}", number(sigma, 2)));
    let mut parts = vec![Part::Text(format!(
        "{}, {}; strength {}{sigma} {}",
        factor.effect,
        factor.formula,
        number(factor.strength, 3),
        factor.unit
    ))];
    let table = Rows::of("/shape_factor/wings", &factor.wings)
        .words("wing", |wing| wing.name.as_str())
        .number(["measured", "measured", ""], After(3), |wing| wing.measured)
        .number(["sigma", "σ", ""], After(3), |wing| wing.sigma)
        .number(["fitted", "fitted", ""], After(3), |wing| wing.fitted)
        .caption("Effective lift coefficient over that of the wing without twist")
        .table();
    parts.push(Part::Table(table));
    parts.extend(factor.chi_squared.map(|chi_squared| {
        Part::Text(format!(
            "Misfit of the wings together: χ² {} with {} degree(s) of freedom.",
            number(chi_squared, 1),
            factor.freedom
        ))
    }));
    parts
}

/// `front.csv`: the profiles of all fronts.
pub fn fronts(summary: &ParetoSummary) -> Result<Vec<u8>, ExportError> {
    let mut rows = Vec::new();
    for front in &summary.fronts {
        for (index, point) in front.points.iter().enumerate() {
            let stages = point.length_mm.iter().zip(&point.rate_deg_per_mm);
            for (stage, (length_mm, rate)) in stages.enumerate() {
                rows.push((
                    front.name.clone(),
                    index + 1,
                    point.lift,
                    point.efficiency,
                    point.tip_deg,
                    stage + 1,
                    *length_mm,
                    *rate,
                ));
            }
        }
    }
    let head = [
        "front",
        "profile",
        "lift",
        "efficiency",
        "tip_deg",
        "stage",
        "length_mm",
        "rate_deg_per_mm",
    ];
    table(&head, &rows)
}

/// `untwisted.csv`: the wing without twist at other stops.
pub fn untwisted(summary: &ParetoSummary) -> Result<Vec<u8>, ExportError> {
    let rows = summary
        .untwisted
        .iter()
        .map(|point| (point.stop_deg, point.lift, point.efficiency));
    table(&["stop_deg", "lift", "efficiency"], &rows.collect::<Vec<_>>())
}
