//! The rods that make a wanted twist: the document, page and tables of `washout design`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::ExportError;
use super::csv::table;
use crate::input::design::Design;
use crate::origin::MadeOf;
use crate::page::text::{Table, number, wrapped};

/// What `washout design` prints with `--json`; `summary.json` of its folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LayoutSummary {
    /// Name of the design that gives outline, film, spars and stroke.
    pub name: String,
    /// What the layout is for, in words.
    pub aim: String,
    /// The layouts that came nearest, best first.
    pub layouts: Vec<LayoutRow>,
    /// How many of them, from the first on, fabrication cannot tell apart.
    pub equally_good: usize,
    /// The best one with its tolerance.
    pub band: BandSummary,
    /// Twist that is wanted, at the stations of the band; empty without one.
    pub wanted_deg: Vec<f64>,
    /// Layouts that were solved.
    pub solved: usize,
    /// Layouts without an equilibrium that was found.
    pub unsolved: usize,
    /// The best layout as a design.
    pub design: Design,
    /// Things that limit what the numbers say.
    pub warnings: Vec<String>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

/// One layout.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LayoutRow {
    /// It in words.
    pub layout: String,
    /// Names of its pieces of rod from the base on.
    pub rods: Vec<String>,
    /// Outer end of each piece.
    pub to_mm: Vec<f64>,
    /// Root mean square distance from the wanted twist over the span; absent without one.
    pub distance_deg: Option<f64>,
    /// Mean lift of one wing over the stroke.
    pub lift_mn: f64,
    /// Lift per aerodynamic power.
    pub lift_per_power_n_per_w: f64,
    /// Whether it lifts as much as is asked for.
    pub is_feasible: bool,
}

/// The best layout with its tolerance.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct BandSummary {
    /// Twist rate of each piece of the rod.
    pub pieces: Vec<PieceRow>,
    /// Where the twist is read.
    pub r_mm: Vec<f64>,
    /// Twist.
    pub twist_deg: Vec<f64>,
    /// Half the width of its band: causes added as if they were independent.
    pub tolerance_deg: Vec<f64>,
    /// Root mean square over the span of half the band.
    pub rms_deg: f64,
    /// The same by diameters and breaks alone: a shear modulus that is off is so in every layout of these rods, so this is what
    /// two layouts are told apart by.
    pub built_deg: f64,
    /// What was off, and by how much that changes the twist (root mean square over the span).
    pub causes: Vec<Cause>,
}

/// Twist rate of one piece.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PieceRow {
    /// From.
    pub from_mm: f64,
    /// To.
    pub to_mm: f64,
    /// Mean twist rate.
    pub rate_deg_per_mm: f64,
    /// Half the width of its band.
    pub tolerance_deg_per_mm: f64,
}

/// What fabrication may have off.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Cause {
    /// What.
    pub what: String,
    /// Change of twist, root mean square over the span.
    pub rms_deg: f64,
}

impl LayoutSummary {
    /// The page.
    pub fn page(&self, folder: &str) -> String {
        let mut page = format!("{}: rod for {}\n", self.name, self.aim);
        let mut rows = Table::new(["layout", "off_deg", "lift_mn", "lift/power", "as_good"]);
        for (index, row) in self.layouts.iter().enumerate() {
            rows.row([
                row.layout.clone(),
                row.distance_deg
                    .map_or("–".into(), |distance| number(distance, 2)),
                number(row.lift_mn, 2),
                number(row.lift_per_power_n_per_w, 4),
                match (row.is_feasible, index < self.equally_good) {
                    (false, _) => "too little lift".to_string(),
                    (true, true) => "yes".to_string(),
                    (true, false) => String::new(),
                },
            ]);
        }
        page += &rows.render();
        page += &wrapped(&self.verdict(), 2);
        page += "\nTwist rate of the best layout with its tolerance\n";
        let mut rows = Table::new(["from_mm", "to_mm", "deg_per_mm", "±"]);
        for piece in &self.band.pieces {
            rows.row([
                number(piece.from_mm, 1),
                number(piece.to_mm, 1),
                number(piece.rate_deg_per_mm, 3),
                number(piece.tolerance_deg_per_mm, 3),
            ]);
        }
        page += &rows.render();
        let mut rows = Table::new(["off", "twist_rms_deg"]);
        for cause in &self.band.causes {
            rows.row([cause.what.clone(), number(cause.rms_deg, 2)]);
        }
        page += &rows.render();
        for warning in &self.warnings {
            page += &wrapped(warning, 2);
        }
        page += &format!(
            "\n{} layouts solved, {} without an equilibrium\n",
            self.solved, self.unsolved
        );
        page += &format!("Files in {folder}: {}\n", self.files.join(" "));
        page
    }

    fn verdict(&self) -> String {
        if self.layouts.first().is_some_and(|best| !best.is_feasible) {
            return "No layout lifts as much as is asked for; the first comes nearest. Raise the amplitude or the frequency, ask \
                    for less, or add stiffer rods to the list."
                .to_string();
        }
        let within = match self.layouts.first().and_then(|best| best.distance_deg) {
            Some(_) => format!(
                "what diameters and breaks may have off ({} deg over the span)",
                number(self.band.built_deg, 2)
            ),
            None => "1 % of lift per power".to_string(),
        };
        match self.equally_good {
            0 | 1 => format!("No other layout comes within {within} of the first."),
            count => format!(
                "{count} layouts do equally well within {within}: choose among them by what is at hand."
            ),
        }
    }
}

/// `layouts.csv`: the layouts that came nearest.
pub fn layouts(summary: &LayoutSummary) -> Result<Vec<u8>, ExportError> {
    let rows = summary.layouts.iter().map(|row| {
        (
            row.layout.clone(),
            row.distance_deg,
            row.lift_mn,
            row.lift_per_power_n_per_w,
            row.is_feasible,
        )
    });
    let head = [
        "layout",
        "distance_deg",
        "lift_mn",
        "lift_per_power_n_per_w",
        "is_feasible",
    ];
    table(&head, &rows.collect::<Vec<_>>())
}

/// `profile.csv`: twist of the best layout with its band, and the wanted one.
pub fn profile(summary: &LayoutSummary) -> Result<Vec<u8>, ExportError> {
    let band = &summary.band;
    let rows = (0..band.r_mm.len()).map(|k| {
        (
            band.r_mm[k],
            band.twist_deg[k],
            band.tolerance_deg[k],
            summary.wanted_deg.get(k).copied(),
        )
    });
    table(
        &["r_mm", "twist_deg", "tolerance_deg", "wanted_deg"],
        &rows.collect::<Vec<_>>(),
    )
}
