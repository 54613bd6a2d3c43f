//! Natural modes as a table, a document and VTK files.

use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::coupling::vibration::Standing;
use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::observation::ModeReading;
use crate::program::MadeOf;
use crate::structure::Mode;

use super::vtu::{Array, Grid};
use super::wing::shape_grid;
use crate::page::Digits::After;
use crate::page::text::number;
use crate::page::{Page, Part, Rows, Table};

/// Natural modes of a wing; `summary.json` of their folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ModesSummary {
    /// Name of the wing.
    pub name: String,
    /// The design with every default, material and `--set` resolved.
    pub design: Design,
    /// Whether the wing vibrates about its loaded shape, stiffened by its load; else about its unloaded one.
    pub loaded: bool,
    /// Whether the air that moves with the film counts as mass.
    pub with_air: bool,
    /// Mass of the wing, without air.
    pub mass_mg: f64,
    /// Flapping frequency; absent for a wing that does not flap.
    pub flapping_frequency_hz: Option<f64>,
    /// The modes by rising frequency.
    pub modes: Vec<ModeRow>,
    /// Things that limit what the numbers say.
    pub warnings: Vec<String>,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files of the folder, this one among them.
    pub files: Vec<String>,
}

/// One mode.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ModeRow {
    /// Number, from 1.
    pub mode: usize,
    /// Natural frequency.
    pub frequency_hz: f64,
    /// Natural over flapping frequency; absent for a wing that does not flap.
    pub flapping_ratio: Option<f64>,
    /// Share in what moves of the rod's turning, straight chords with it.
    pub twist_share: f64,
    /// Share of the leading edge's motion across the wing.
    pub flap_share: f64,
    /// Share of the leading edge's motion in the plane of the wing.
    pub edge_share: f64,
    /// Share of film and spars that bend off those chords.
    pub film_share: f64,
    /// Mass that a base shaken along x, y, z feels, air included if it counts.
    pub effective_mass_mg: [f64; 3],
    /// The same for a base that pitches about the leading edge.
    pub effective_pitch_inertia_g_mm2: f64,
    /// The same for a base that flaps; absent for a wing that does not flap.
    pub effective_flapping_inertia_g_mm2: Option<f64>,
    /// File of its shape.
    pub file: String,
}

impl ModeRow {
    /// Mode `index` (from 0) as read; `reading` has pitch as its first axis, and flapping as its second if it flaps.
    pub fn new(index: usize, mode: &Mode, reading: &ModeReading, flapping_hz: Option<f64>) -> Self {
        let inertia = |axis: usize| reading.effective_inertia_kg_m2.get(axis).map(|i| i * 1e9);
        ModeRow {
            mode: index + 1,
            frequency_hz: mode.frequency_hz,
            flapping_ratio: flapping_hz.map(|flapping| mode.frequency_hz / flapping),
            twist_share: reading.share.twist,
            flap_share: reading.share.flap,
            edge_share: reading.share.edge,
            film_share: reading.share.film,
            effective_mass_mg: reading.effective_mass_kg.map(|mass| mass * 1e6),
            effective_pitch_inertia_g_mm2: inertia(0).unwrap_or(0.0),
            effective_flapping_inertia_g_mm2: inertia(1),
            file: format!("mode-{:02}.vtu", index + 1),
        }
    }
}

/// The shape about which the wing vibrates, with the motion of a mode: `displacement_mm`, largest 1 mm, and
/// `rotation_deg` to the same scale.
pub fn mode_grid(design: &Design, mesh: &Mesh, standing: &Standing, mode: &Mode) -> Grid {
    let largest = mode.displacement.iter().map(Vector3::norm).fold(0.0, f64::max);
    let scale = if largest > 0.0 { 1.0 / largest } else { 1.0 };
    let scaled = |vectors: &[Vector3<f64>], factor: f64| -> Vec<[f64; 3]> {
        vectors.iter().map(|v| (v * (scale * factor)).into()).collect()
    };
    let mut grid = shape_grid(design, mesh, &standing.state);
    grid.point_arrays = vec![
        Array::vector("displacement_mm", &scaled(&mode.displacement, 1.0)),
        Array::vector("rotation_deg", &scaled(&mode.rotation, 1e-3_f64.to_degrees())),
    ];
    grid
}

impl ModesSummary {
    /// What `washout modes` says.
    pub fn page(&self) -> Page {
        let about = match self.loaded {
            true => "its loaded shape, stiffened by the load",
            false => "its unloaded shape",
        };
        let medium = match self.with_air {
            true => "with the air that moves with the film",
            false => "without air",
        };
        let head = format!(
            "Natural modes about {about}, {medium}; mass {} mg.",
            number(self.mass_mg, 2)
        );
        let mut page = Page {
            title: self.name.clone(),
            kind: "summary",
            lead: vec![Part::Text(head), Part::Notes(self.warnings.clone())],
            ..Page::default()
        };
        page.brief = [page.lead.clone(), vec![Part::Table(self.shares())]].concat();
        page.section("modes", "Modes", vec![Part::Table(self.shares())]);
        page.section("effective", "Effective mass", vec![Part::Table(self.effective())]);
        page
    }

    fn shares(&self) -> Table {
        Rows::of("/modes", &self.modes)
            .number(["mode", "mode", ""], After(0), |row| row.mode as f64)
            .number(["frequency_hz", "f", "Hz"], After(2), |row| row.frequency_hz)
            .number(["flapping_ratio", "× flapping", ""], After(2), |row| {
                row.flapping_ratio
            })
            .number(["twist_share", "twist", ""], After(2), |row| row.twist_share)
            .number(["flap_share", "flap", ""], After(2), |row| row.flap_share)
            .number(["edge_share", "edge", ""], After(2), |row| row.edge_share)
            .number(["film_share", "film", ""], After(2), |row| row.film_share)
            .caption(
                "Shares of what moves: the rod turns and straight chords with it (twist), it bends across the wing (flap) or in its plane \
                 (edge), film and spars bend off those chords (film).",
            )
            .table()
    }

    fn effective(&self) -> Table {
        Rows::of("/modes", &self.modes)
            .number(["mode", "mode", ""], After(0), |row| row.mode as f64)
            .numbers(["effective_mass_mg/*", "mass x / y / z", "mg"], After(2), |row| {
                row.effective_mass_mg.map(Some).to_vec()
            })
            .number(
                ["effective_pitch_inertia_g_mm2", "pitch", "g mm²"],
                After(3),
                |row| row.effective_pitch_inertia_g_mm2,
            )
            .number(
                ["effective_flapping_inertia_g_mm2", "flapping", "g mm²"],
                After(2),
                |row| row.effective_flapping_inertia_g_mm2,
            )
            .caption("Mass and inertia that a base feels which is shaken along x, y, z, pitches or flaps")
            .table()
    }
}
