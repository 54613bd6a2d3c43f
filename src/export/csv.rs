//! `profile.csv`, `strips.csv`, `edges.csv`, `stroke.csv`, `stroke-twist.csv`: twist along the span, the air on each strip,
//! where the edges go, all over the stroke; units in the head.

use serde::Serialize;

use crate::coupling::solution::StripLoad;
use crate::mesh::Mesh;

use super::ExportError;
use super::summary::ProfileRow;
use crate::wing::stroke::{PhaseRow, StrokeTwist};

/// Columns of `profile.csv`.
const PROFILE_HEAD: [&str; 9] = [
    "place",
    "r_mm",
    "chord_mm",
    "twist_deg",
    "sigma_deg",
    "bound",
    "alpha_deg",
    "le_deflection_mm",
    "le_sweep_mm",
];

/// Columns of `strips.csv`.
pub const STRIPS_HEAD: [&str; 10] = [
    "r_mm",
    "width_mm",
    "chord_mm",
    "speed_m_s",
    "alpha_deg",
    "cl",
    "cd",
    "centre_of_pressure",
    "normal_n_per_m",
    "tangential_n_per_m",
];

/// Columns of `edges.csv`.
const EDGES_HEAD: [&str; 7] = ["edge", "node", "r_mm", "y_mm", "ux_mm", "uy_mm", "uz_mm"];

/// Columns of `stroke.csv`.
const STROKE_HEAD: [&str; 11] = [
    "phase_deg",
    "time_ms",
    "sweep_deg",
    "pitch_deg",
    "flips",
    "tip_twist_deg",
    "standing_tip_twist_deg",
    "lift_mn",
    "drag_mn",
    "power_mw",
    "stop_mn_mm",
];

/// Columns of `stroke-twist.csv`.
const STROKE_TWIST_HEAD: [&str; 5] = ["phase_deg", "r_mm", "twist_deg", "standing_deg", "rate_deg_s"];

/// The phases of a stroke; what only a periodic motion has is blank otherwise.
pub fn stroke(rows: &[PhaseRow]) -> Result<Vec<u8>, ExportError> {
    let row = |row: &PhaseRow| {
        let (moving, forces) = (row.moving.as_ref(), row.forces.as_ref());
        (
            row.phase_deg,
            moving.map(|moving| moving.time_ms),
            moving.map(|moving| moving.sweep_deg),
            moving.map(|moving| moving.pitch_deg),
            moving.map(|moving| u8::from(moving.is_flipping)),
            row.tip_twist_deg,
            moving.and_then(|moving| moving.standing_tip_twist_deg),
            forces.map(|forces| forces.lift_mn),
            forces.map(|forces| forces.drag_mn),
            forces.map(|forces| forces.power_mw),
            row.stop_moment_mn_mm,
        )
    };
    table(&STROKE_HEAD, &rows.iter().map(row).collect::<Vec<_>>())
}

/// Twist along the span at the phases of a stroke.
pub fn stroke_twist(rows: &[StrokeTwist]) -> Result<Vec<u8>, ExportError> {
    table(&STROKE_TWIST_HEAD, rows)
}

/// The twist profile; `alpha_deg` is blank without flow.
pub fn profile(rows: &[ProfileRow]) -> Result<Vec<u8>, ExportError> {
    table(&PROFILE_HEAD, rows)
}

/// The strips of air from base to tip.
pub fn strips(strips: &[StripLoad]) -> Result<Vec<u8>, ExportError> {
    let rows: Vec<[f64; 10]> = strips.iter().map(strip_row).collect();
    table(&STRIPS_HEAD, &rows)
}

/// The row of one strip, by the columns of [`STRIPS_HEAD`].
pub fn strip_row(strip: &StripLoad) -> [f64; 10] {
    [
        strip.r_m * 1e3,
        strip.width_m * 1e3,
        strip.chord_m * 1e3,
        strip.speed_m_s,
        strip.alpha_rad.to_degrees(),
        strip.cl,
        strip.cd,
        strip.centre_of_pressure,
        strip.normal_n_per_m,
        strip.tangential_n_per_m,
    ]
}

/// Leading, then trailing edge from base to tip: place at rest and displacement from the unloaded shape, mm; nodes are
/// numbered from 1.
pub fn edges(mesh: &Mesh, displacement_mm: &[[f64; 3]]) -> Result<Vec<u8>, ExportError> {
    let row = |edge: &'static str, node: usize| {
        let ([x, y, _], [ux, uy, uz]) = (mesh.nodes[node].map(|x| x * 1e3), displacement_mm[node]);
        (edge, node + 1, x, y, ux, uy, uz)
    };
    let leading = mesh.leading_edge.iter().map(|&node| row("leading", node));
    let trailing = mesh.trailing_edge.iter().map(|&node| row("trailing", node));
    let rows: Vec<_> = leading.chain(trailing).collect();
    table(&EDGES_HEAD, &rows)
}

/// A text of somebody's as a cell: what a spreadsheet would take for a formula has an apostrophe before it.
#[cfg(feature = "cli")]
pub(crate) fn plain_cell(text: &str) -> String {
    let is_formula = text.starts_with(['=', '+', '-', '@', '\t', '\r']) && text.parse::<f64>().is_err();
    if is_formula {
        format!("'{text}")
    } else {
        text.to_string()
    }
}

/// A table with a head; fields of a row stand in the order of the head.
pub(crate) fn table(head: &[&str], rows: &[impl Serialize]) -> Result<Vec<u8>, ExportError> {
    let refuse = |reason: String| ExportError::Encoding {
        format: "CSV",
        reason,
    };
    let mut writer = csv::WriterBuilder::new()
        .has_headers(false)
        .from_writer(Vec::new());
    writer
        .write_record(head)
        .map_err(|error| refuse(error.to_string()))?;
    for row in rows {
        writer.serialize(row).map_err(|error| refuse(error.to_string()))?;
    }
    writer.into_inner().map_err(|error| refuse(error.to_string()))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::measurement::Bound;

    #[cfg(feature = "cli")]
    #[test]
    fn no_cell_is_a_formula_of_a_spreadsheet_and_numbers_stay() {
        let cells = [
            "=cmd|x",
            "+1+1",
            "-2+3",
            "@sum",
            "--set: no",
            "-2.5",
            "+1e3",
            "kapton",
            "",
        ];
        let plain = [
            "'=cmd|x",
            "'+1+1",
            "'-2+3",
            "'@sum",
            "'--set: no",
            "-2.5",
            "+1e3",
            "kapton",
            "",
        ];
        assert_eq!(cells.map(plain_cell), plain);
    }

    #[test]
    fn the_head_names_the_fields_of_a_row_in_their_order() {
        let row = ProfileRow {
            place: "spar[0]".to_string(),
            r_mm: 2.8,
            chord_mm: 11.25,
            twist_deg: -0.5,
            sigma_deg: None,
            bound: Bound::Upper,
            alpha_deg: None,
            le_deflection_mm: 0.125,
            le_sweep_mm: 0.0,
        };
        let json = serde_json::to_value(&row).expect("object");
        let names: Vec<_> = json.as_object().expect("object").keys().cloned().collect();
        assert_eq!(names, PROFILE_HEAD);
        let text = String::from_utf8(profile(&[row]).expect("written")).expect("UTF-8");
        let (head, row) = text.split_once('\n').expect("two lines");
        assert_eq!(head, PROFILE_HEAD.join(","));
        assert_eq!(row, "spar[0],2.8,11.25,-0.5,,upper,,0.125,0.0\n");
    }

    #[test]
    fn strips_stand_in_millimetres_and_degrees() {
        let strip = StripLoad {
            r_m: 0.035,
            width_m: 0.002,
            chord_m: 0.025,
            speed_m_s: 5.0,
            alpha_rad: std::f64::consts::FRAC_PI_4,
            cl: 1.8,
            cd: 1.7,
            centre_of_pressure: 0.25,
            normal_n_per_m: 0.5,
            tangential_n_per_m: -0.25,
        };
        let text = String::from_utf8(strips(&[strip]).expect("written")).expect("UTF-8");
        assert!(
            text.ends_with("\n35.0,2.0,25.0,5.0,45.0,1.8,1.7,0.25,0.5,-0.25\n"),
            "{text}"
        );
    }
}
