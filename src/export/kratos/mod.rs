//! A loaded structure as a model part for Kratos Multiphysics (`.mdpa`): a second opinion by the same kind of theory,
//! written by others.
//!
//! Millimetres, newtons, MPa. Mesh and freedoms are those of washout: two-node corotational beams with the same
//! stiffnesses, three-node corotational shells, both on the same nodes, so that film and beams share rotations. Loads are
//! those of the converged shape, kept still in space. `shape.csv` holds that shape, node by node.

pub mod section;

use std::fmt::Write;

use nalgebra::Vector3;

use super::ExportError;
use super::nodal_loads::nodal_loads;
use crate::coupling::vibration::Standing;
use crate::structure::{Compression, Model, Sheet};

use section::BeamProperties;

/// A model part, and what it cannot say.
#[derive(Debug, Clone, PartialEq)]
pub struct ModelPart {
    /// The text of the `.mdpa` file.
    pub text: String,
    /// What has no counterpart in Kratos and is left out.
    pub left_out: Vec<String>,
}

/// The model part of a loaded structure.
///
/// # Errors
/// If it stands on springs.
pub fn model_part(name: &str, standing: &Standing) -> Result<ModelPart, ExportError> {
    let model = &standing.model;
    if !model.springs.is_empty() {
        return Err(ExportError::NoCounterpart {
            what: "the pitch stiffness of the root",
            cure: "solve it with a rigid root: leave out root.pitch_stiffness_n_m_per_rad",
        });
    }
    let mut text = format!(
        "// {name}, written by washout {}: mm, N, MPa\nBegin ModelPartData\nEnd ModelPartData\n",
        env!("CARGO_PKG_VERSION")
    );
    properties(&mut text, model);
    block(&mut text, "Nodes", model.nodes.iter().enumerate(), |(node, x)| {
        let x = x * 1e3;
        format!("{} {:.17e} {:.17e} {:.17e}", node + 1, x.x, x.y, x.z)
    });
    elements(&mut text, model);
    supports(&mut text, model);
    loads(&mut text, standing);
    Ok(ModelPart {
        text,
        left_out: left_out(model),
    })
}

/// Places at rest, displacements (mm) and rotation vectors (rad) of all nodes where washout has them, as a table.
pub fn shape(standing: &Standing) -> String {
    let mut text = String::from("node,x_mm,y_mm,z_mm,ux_mm,uy_mm,uz_mm,turn_x_rad,turn_y_rad,turn_z_rad\n");
    let state = &standing.state;
    for (node, place) in standing.model.nodes.iter().enumerate() {
        let _ = write!(text, "{}", node + 1);
        for vector in [
            1e3 * place,
            1e3 * state.displacement[node],
            state.rotation[node].scaled_axis(),
        ] {
            for value in vector.iter() {
                let _ = write!(text, ",{value:.12e}");
            }
        }
        text.push('\n');
    }
    text
}

fn properties(text: &mut String, model: &Model) {
    // those of the loads
    block(text, "Properties 0", std::iter::empty(), |row: String| row);
    for (number, sheet) in model.sheets.iter().enumerate() {
        let Sheet {
            e_pa,
            poisson,
            thickness_m,
            density_kg_m3,
            pretension_n_per_m,
            ..
        } = *sheet;
        let stress_mpa = 1e-6 * pretension_n_per_m / thickness_m;
        let rows = [
            format!("YOUNG_MODULUS {:.17e}", 1e-6 * e_pa),
            format!("POISSON_RATIO {poisson:.17e}"),
            format!("THICKNESS {:.17e}", 1e3 * thickness_m),
            // t/mm³
            format!("DENSITY {:.17e}", 1e-12 * density_kg_m3),
            format!("PRESTRESS_VECTOR [3] ({stress_mpa:.17e},{stress_mpa:.17e},0.0)"),
        ];
        block(
            text,
            &format!("Properties {}", number + 1),
            rows.into_iter(),
            |row| row,
        );
    }
    for (number, section) in model.sections.iter().enumerate() {
        let rows = BeamProperties::of(section).rows();
        block(
            text,
            &format!("Properties {}", model.sheets.len() + number + 1),
            rows.into_iter(),
            |row| row,
        );
    }
}

fn elements(text: &mut String, model: &Model) {
    let shells = model.shells.iter().enumerate();
    block(
        text,
        "Elements ShellThinElementCorotational3D3N",
        shells,
        |(element, shell)| {
            let [a, b, c] = shell.nodes.map(|node| node + 1);
            format!("{} {} {a} {b} {c}", element + 1, shell.sheet + 1)
        },
    );
    let first = model.shells.len() + 1;
    let beams = || model.beams.iter().enumerate();
    let section_id = |section: usize| model.sheets.len() + section + 1;
    block(text, "Elements CrBeamElement3D2N", beams(), |(element, beam)| {
        let [a, b] = beam.nodes.map(|node| node + 1);
        format!("{} {} {a} {b}", first + element, section_id(beam.section))
    });
    block(text, "ElementalData LOCAL_AXIS_2", beams(), |(element, beam)| {
        let edge = beam.axes().column(1);
        format!(
            "{} [3] ({:.17e},{:.17e},{:.17e})",
            first + element,
            edge.x,
            edge.y,
            edge.z
        )
    });
}

fn supports(text: &mut String, model: &Model) {
    for component in 0..6 {
        let (kind, axis) = freedom(component, "DISPLACEMENT", "ROTATION");
        let held = (0..model.nodes.len()).filter(|&node| model.held[node][component]);
        block(text, &format!("NodalData {kind}_{axis}"), held, |node| {
            format!("{} 1 0.0", node + 1)
        });
    }
}

fn loads(text: &mut String, standing: &Standing) {
    let (force_n, moment_n_m) = nodal_loads(standing);
    let first_moment = force_n.iter().filter(|force| **force != Vector3::zeros()).count();
    for (vectors, condition, first) in [
        (&force_n, "PointLoadCondition3D1N", 0),
        (&moment_n_m, "PointMomentCondition3D1N", first_moment),
    ] {
        let loaded = (0..vectors.len()).filter(|&node| vectors[node] != Vector3::zeros());
        block(
            text,
            &format!("Conditions {condition}"),
            loaded.enumerate(),
            |(index, node)| format!("{} 0 {}", first + index + 1, node + 1),
        );
    }
    for component in 0..6 {
        let (kind, axis) = freedom(component, "POINT_LOAD", "POINT_MOMENT");
        // N, N·mm
        let values = if component < 3 { &force_n } else { &moment_n_m };
        let unit = if component < 3 { 1.0 } else { 1e3 };
        let rows = values
            .iter()
            .enumerate()
            .filter(|(_, value)| value[component % 3] != 0.0);
        block(
            text,
            &format!("NodalData {kind}_{axis}"),
            rows,
            |(node, value)| format!("{} 0 {:.17e}", node + 1, unit * value[component % 3]),
        );
    }
}

/// Names of a freedom by its number: kind and axis.
fn freedom<'n>(component: usize, along: &'n str, about: &'n str) -> (&'n str, &'static str) {
    (
        if component < 3 { along } else { about },
        ["X", "Y", "Z"][component % 3],
    )
}

/// A block of rows; none if there are no rows.
fn block<T>(text: &mut String, head: &str, rows: impl Iterator<Item = T>, row: impl Fn(T) -> String) {
    let rows: String = rows.map(|content| format!("  {}\n", row(content))).collect();
    if !rows.is_empty() || head.starts_with("Properties") {
        let kind = head.split(' ').next().unwrap_or(head);
        let _ = write!(text, "Begin {head}\n{rows}End {kind}\n");
    }
}

fn left_out(model: &Model) -> Vec<String> {
    let mut left_out = Vec::new();
    let wrinkles = |sheet: &Sheet| matches!(sheet.compression, Compression::TensionField { residual, .. } if residual < 1.0);
    if model.sheets.iter().any(wrinkles) {
        left_out.push("wrinkling: the shells of the model part carry compression".to_string());
    }
    if model.sections.iter().any(|section| section.skin.is_some()) {
        left_out.push("the skin of the rod, which gives way".to_string());
    }
    if model.sections.iter().any(BeamProperties::leaves_out) {
        left_out.push(
            "couplings of the sections, such as that of torsion and shear of a half-round rod".to_string(),
        );
    }
    left_out
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::state::State;
    use crate::structure::{Loads, Section};

    #[test]
    fn a_plate_with_a_rod_is_written_with_supports_loads_and_axes() {
        let corners = [[0.0, 0.0, 0.0], [2e-3, 0.0, 0.0], [0.0, 1e-3, 0.0]];
        let mut model = Model::new(corners.map(Vector3::from).to_vec());
        let sheet = model.add_sheet(Sheet {
            e_pa: 2.5e9,
            poisson: 0.34,
            thickness_m: 1e-5,
            density_kg_m3: 1420.0,
            pretension_n_per_m: 10.0,
            compression: Compression::Carries,
        });
        model.add_shell([0, 1, 2], sheet).unwrap();
        let section = model.add_section(Section::uncoupled(1.0, 1e-6, 2e-6, 3e-6));
        model.add_beam([0, 1], &Vector3::z(), section).unwrap();
        model.clamp(0);
        let mut loads = Loads::none(3);
        loads.force_n[1].z = 0.25;
        loads.moment_n_m[2].x = 1e-3;
        let standing = Standing {
            model,
            state: State::at_rest(3),
            loads,
            moved_air_kg_m2: Vec::new(),
        };
        let part = model_part("plate", &standing).unwrap();
        let has = |lines: &str| assert!(part.text.contains(lines), "{lines} in\n{}", part.text);
        has("Begin Elements ShellThinElementCorotational3D3N\n  1 1 1 2 3\nEnd Elements");
        has("Begin Elements CrBeamElement3D2N\n  2 2 1 2\nEnd Elements");
        has("Begin NodalData ROTATION_Z\n  1 1 0.0\nEnd NodalData");
        has("Begin Conditions PointLoadCondition3D1N\n  1 0 2\nEnd Conditions");
        has("Begin Conditions PointMomentCondition3D1N\n  2 0 3\nEnd Conditions");
        has("Begin NodalData POINT_LOAD_Z\n  2 0 2.5");
        // N·mm
        has("Begin NodalData POINT_MOMENT_X\n  3 0 1.0");
        // 10 N/m over 10 µm is 1 MPa
        assert!(
            part.text
                .lines()
                .any(|line| line.contains("PRESTRESS_VECTOR [3] (1.0") || line.contains("(9.99"))
        );
        assert!(part.left_out.is_empty());
        assert_eq!(shape(&standing).lines().count(), 4);
    }
}
