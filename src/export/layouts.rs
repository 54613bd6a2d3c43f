//! The rods that make a wanted twist: the document, page and tables of `washout design`.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::ExportError;
use super::csv::table;
use crate::input::design::Design;
use crate::page::Digits::After;
use crate::page::text::number;
use crate::page::{Page, Part, Rows, Table};
use crate::program::MadeOf;

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
    /// What `washout design` says.
    pub fn page(&self) -> Page {
        let mut page = Page {
            title: format!("{}: rod for {}", self.name, self.aim),
            kind: "summary",
            lead: vec![Part::Sentence(self.verdict()), Part::Notes(self.warnings.clone())],
            ..Page::default()
        };
        page.section(
            "layouts",
            "Layouts",
            vec![
                Part::Table(self.table()),
                Part::Text(format!(
                    "{} layouts solved, {} without an equilibrium.",
                    self.solved, self.unsolved
                )),
            ],
        );
        let band = vec![Part::Table(self.pieces()), Part::Table(self.causes())];
        page.section("band", "The best layout with its tolerance", band);
        page
    }

    fn table(&self) -> Table {
        let rows: Vec<(usize, &LayoutRow)> = self.layouts.iter().enumerate().collect();
        Rows::keyed("/layouts", rows.iter().map(|row| (row.0, row)))
            .words("layout", |row| row.1.layout.as_str())
            .number(["distance_deg", "off", "deg"], After(2), |row| row.1.distance_deg)
            .number(["lift_mn", "lift", "mN"], After(2), |row| row.1.lift_mn)
            .number(["lift_per_power_n_per_w", "L/P", "N/W"], After(4), |row| {
                row.1.lift_per_power_n_per_w
            })
            .words("as good", |row| {
                match (row.1.is_feasible, row.0 < self.equally_good) {
                    (false, _) => "too little lift",
                    (true, true) => "yes",
                    (true, false) => "",
                }
            })
            .table()
    }

    fn pieces(&self) -> Table {
        Rows::of("/band/pieces", &self.band.pieces)
            .number(["from_mm", "from", "mm"], After(1), |row| row.from_mm)
            .number(["to_mm", "to", "mm"], After(1), |row| row.to_mm)
            .number(["rate_deg_per_mm", "twist rate", "deg/mm"], After(3), |row| {
                row.rate_deg_per_mm
            })
            .number(["tolerance_deg_per_mm", "±", "deg/mm"], After(3), |row| {
                row.tolerance_deg_per_mm
            })
            .table()
    }

    fn causes(&self) -> Table {
        Rows::of("/band/causes", &self.band.causes)
            .words("off", |row| row.what.as_str())
            .number(["rms_deg", "twist, rms", "deg"], After(2), |row| row.rms_deg)
            .table()
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
