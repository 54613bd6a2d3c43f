//! The front between lift and efficiency over twist profiles: the document, page and tables of `washout pareto`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::origin::MadeOf;

use super::ExportError;
use super::csv::table;
use crate::page::text::{Table, number, wrapped};

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
    /// The page.
    pub fn page(&self, folder: &str) -> String {
        let mut page = format!(
            "{}: front between lift and efficiency ({}) over twist profiles\n",
            self.name, self.efficiency
        );
        page += &wrapped(
            &format!(
                "{} stages of at least {} mm and {} to {} deg/mm, tip at most {} deg; {} Hz, ±{} deg, ramp over {} % of each \
                 half-stroke; population {}, {} generations, {}. Lift and efficiency are over those of the wing without \
                 twist at its stop of {} deg.",
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
            ),
            2,
        );
        if let Some(factor) = &self.shape_factor {
            page += &format!("\n{}", factor_words(factor));
        }
        for (index, front) in self.fronts.iter().enumerate() {
            page += &format!("\n{}", self.front_words(front, index));
        }
        if let Some(gap) = &self.largest_gap {
            page.push('\n');
            page += &wrapped(
                &format!(
                    "Without the shape factor the front differs from the untwisted wing at other stops by at most {} % in \
                     efficiency at the same lift (at {} times the lift; {} % root mean square).",
                    number(100.0 * gap.largest.abs(), 2),
                    number(gap.lift, 3),
                    number(100.0 * gap.rms, 2)
                ),
                2,
            );
        }
        for warning in &self.warnings {
            page += &wrapped(warning, 2);
        }
        page += &format!("\nFiles in {folder}: {}\n", self.files.join(" "));
        page
    }

    fn front_words(&self, front: &Front, index: usize) -> String {
        let mut text = format!("Front {}, {} profiles\n", front.name, front.points.len());
        let mut rows = Table::new(["what", "lift", "efficiency", "tip_deg", "twist"]);
        for (name, profile) in [
            ("highest lift", front.highest_lift()),
            ("highest efficiency", front.highest_efficiency()),
        ] {
            if let Some(profile) = profile {
                rows.row([
                    name.to_string(),
                    number(profile.lift, 3),
                    number(profile.efficiency, 3),
                    number(profile.tip_deg, 1),
                    profile.words(),
                ]);
            }
        }
        for mark in &self.marks {
            rows.row([
                mark.name.clone(),
                number(mark.lift[index], 3),
                number(mark.efficiency, 3),
                number(mark.tip_deg, 1),
                String::new(),
            ]);
        }
        text += &rows.render();
        if let Some(highest) = front.highest_lift() {
            for mark in &self.marks {
                let more = 100.0 * (highest.lift / mark.lift[index] - 1.0);
                text += &format!("  highest lift over {}: {} %\n", mark.name, number(more, 1));
            }
        }
        if let Some(all) = &front.exhaustive {
            text += &format!(
                "  all {} profiles of a coarse family tried: the search held to its steps has {} times the area of their front, the \
                 front above {} times\n",
                all.profiles,
                number(all.on_steps_over_exhaustive, 4),
                number(all.found_over_exhaustive, 4)
            );
        }
        text
    }
}

fn factor_words(factor: &FittedFactor) -> String {
    let sigma = factor
        .sigma
        .map_or(String::new(), |sigma| format!(" ± {}", number(sigma, 2)));
    let mut text = format!(
        "Shape factor (assumed form, prior): {}, {}; strength {}{sigma} {}\n",
        factor.effect,
        factor.formula,
        number(factor.strength, 3),
        factor.unit
    );
    if !factor.wings.is_empty() {
        let mut rows = Table::new(["wing", "measured", "sigma", "fitted"]);
        for wing in &factor.wings {
            rows.row([
                wing.name.clone(),
                number(wing.measured, 3),
                number(wing.sigma, 3),
                number(wing.fitted, 3),
            ]);
        }
        text += &rows.render();
    }
    if let Some(chi_squared) = factor.chi_squared {
        text += &format!(
            "  misfit of the wings together: chi² {} with {} degree(s) of freedom\n",
            number(chi_squared, 1),
            factor.freedom
        );
    }
    text
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
