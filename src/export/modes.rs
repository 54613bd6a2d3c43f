//! Natural modes as a table, a document and VTK files.

use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::coupling::vibration::Standing;
use crate::input::design::Design;
use crate::mesh::Mesh;
use crate::observation::ModeReading;
use crate::origin::MadeOf;
use crate::structure::Mode;

use super::vtu::{Array, Grid};
use super::wing::shape_grid;
use crate::page::text::{Table, number, wrapped};

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
    /// The modes for people to read.
    pub fn page(&self, folder: &str) -> String {
        let mut table = Table::new([
            "mode",
            "hz",
            "x flapping",
            "twist",
            "flap",
            "edge",
            "film",
            "mx_mg",
            "my_mg",
            "mz_mg",
            "pitch_g_mm2",
            "flapping_g_mm2",
        ]);
        let optional =
            |value: Option<f64>, decimals: usize| value.map_or("–".into(), |v| number(v, decimals));
        for row in &self.modes {
            let [x, y, z] = row.effective_mass_mg.map(|mass| number(mass, 2));
            table.row([
                row.mode.to_string(),
                number(row.frequency_hz, 2),
                optional(row.flapping_ratio, 2),
                number(row.twist_share, 2),
                number(row.flap_share, 2),
                number(row.edge_share, 2),
                number(row.film_share, 2),
                x,
                y,
                z,
                number(row.effective_pitch_inertia_g_mm2, 3),
                optional(row.effective_flapping_inertia_g_mm2, 2),
            ]);
        }
        let about = if self.loaded {
            "its loaded shape, stiffened by the load"
        } else {
            "its unloaded shape"
        };
        let medium = if self.with_air {
            "with the air that moves with the film"
        } else {
            "without air"
        };
        let warnings: String = self.warnings.iter().map(|warning| wrapped(warning, 2)).collect();
        format!(
            "{}\nNatural modes about {about}, {medium}; mass {} mg\n\n{}\nShares of what moves: the rod turns and straight \
             chords with it (twist), it bends across the wing (flap)\nor in its plane (edge), film and spars bend off \
             those chords (film). mx … flapping: mass and inertia that\na base feels when it is shaken along x, y, z, \
             pitches or flaps.\n{warnings}\nFiles in {folder}: {}\n",
            self.name,
            number(self.mass_mg, 2),
            table.render(),
            self.files.join(" "),
        )
    }
}
