//! A loaded wing as an input deck for CalculiX: a second opinion on the structure.
//!
//! Millimetres, newtons, MPa. The film is written as shells of second order (S6), rod and spars as beams of second order
//! (B32R, see `section`) along it, tied to it by displacements, so that it turns freely about them; the loads are those of the converged shape, kept still in space. Pre-tension is
//! written as cooling of the film in a first step. A film that wrinkles has no counterpart there: in the deck it carries
//! compression.

pub mod mesh;

pub mod section;

use std::fmt::Write;

use nalgebra::Vector3;

use super::ExportError;
use super::nodal_loads::nodal_loads;
use crate::coupling::vibration::Standing;
use crate::structure::{Compression, Model, Sheet};

use mesh::QuadraticMesh;
use section::Rectangle;

/// Expansion of the film per degree; which one it is does not matter.
const EXPANSION: f64 = 1e-5;

/// A deck, and what it cannot say.
#[derive(Debug, Clone, PartialEq)]
pub struct Deck {
    /// The text of the `.inp` file.
    pub text: String,
    /// What has no counterpart in CalculiX and is left out.
    pub left_out: Vec<String>,
}

/// The deck of a loaded wing; displacements are printed at the nodes `printed`.
///
/// # Errors
/// If the wing stands on a spring.
pub fn deck(name: &str, standing: &Standing, printed: &[usize]) -> Result<Deck, ExportError> {
    let model = &standing.model;
    if !model.springs.is_empty() {
        return Err(ExportError::NoCounterpart {
            what: "the pitch stiffness of the root",
            cure: "solve it with a rigid root: leave out root.pitch_stiffness_n_m_per_rad",
        });
    }
    let mesh = QuadraticMesh::of(model);
    let mut text = format!(
        "** {name}, written by washout {}: mm, N, MPa\n",
        env!("CARGO_PKG_VERSION")
    );
    nodes(&mut text, &mesh, printed);
    film(&mut text, model, &mesh);
    beams(&mut text, model, &mesh);
    supports(&mut text, model, &mesh);
    let pretension = model.sheets.first().map_or(0.0, |sheet| sheet.pretension_n_per_m);
    if pretension != 0.0 {
        text.push_str("*INITIAL CONDITIONS,TYPE=TEMPERATURE\nNALL,0.\n");
        begin_step(&mut text);
        let sheet = &model.sheets[0];
        let cooling = -pretension * (1.0 - sheet.poisson) / (sheet.e_pa * sheet.thickness_m * EXPANSION);
        line(&mut text, format_args!("*TEMPERATURE\nNALL,{cooling:.10e}"));
        end_step(&mut text);
    }
    begin_step(&mut text);
    text.push_str("*CLOAD\n");
    let (force_n, moment_n_m) = nodal_loads(standing);
    for (node, (force, moment)) in force_n.iter().zip(&moment_n_m).enumerate() {
        for (first, values) in [(1, *force), (4, 1e3 * moment)] {
            for (component, value) in values.iter().enumerate().filter(|(_, value)| **value != 0.0) {
                line(
                    &mut text,
                    format_args!("{},{},{value:.10e}", mesh.carrier(node), first + component),
                );
            }
        }
    }
    end_step(&mut text);
    Ok(Deck {
        text,
        left_out: left_out(model),
    })
}

fn nodes(text: &mut String, mesh: &QuadraticMesh, printed: &[usize]) {
    text.push_str("*NODE,NSET=NALL\n");
    for (index, [x, y, z]) in mesh.nodes_mm.iter().enumerate() {
        line(text, format_args!("{},{x:.10e},{y:.10e},{z:.10e}", index + 1));
    }
    text.push_str("*NSET,NSET=EDGES\n");
    for node in printed {
        line(text, format_args!("{}", node + 1));
    }
}

fn film(text: &mut String, model: &Model, mesh: &QuadraticMesh) {
    let Some(sheet) = model.sheets.first() else {
        return;
    };
    text.push_str("*ELEMENT,TYPE=S6,ELSET=FILM\n");
    for (index, [a, b, c, ab, bc, ca]) in mesh.triangles.iter().enumerate() {
        line(text, format_args!("{},{a},{b},{c},{ab},{bc},{ca}", index + 1));
    }
    line(
        text,
        format_args!(
            "*MATERIAL,NAME=FILM\n*ELASTIC\n{:.10e},{:.10e}\n*EXPANSION,ZERO=0.\n{EXPANSION:e}\n\
             *SHELL SECTION,ELSET=FILM,MATERIAL=FILM\n{:.10e}",
            1e-6 * sheet.e_pa,
            sheet.poisson,
            1e3 * sheet.thickness_m
        ),
    );
}

fn beams(text: &mut String, model: &Model, mesh: &QuadraticMesh) {
    let first = mesh.triangles.len() + 1;
    for (number, section) in model.sections.iter().enumerate() {
        let of_section = || (0..model.beams.len()).filter(|&beam| model.beams[beam].section == number);
        let Some(one) = of_section().next() else {
            continue;
        };
        line(text, format_args!("*ELEMENT,TYPE=B32R,ELSET=BEAM{number}"));
        for beam in of_section() {
            let [a, middle, b] = mesh.beams[beam];
            line(text, format_args!("{},{a},{middle},{b}", first + beam));
        }
        let Rectangle {
            width_mm,
            height_mm,
            e_mpa: e,
            g_mpa: g,
        } = Rectangle::of(section);
        let axis = |k: usize| -> Vector3<f64> { model.beams[one].axes().column(k).into() };
        let [along, edge, normal] = [0, 1, 2].map(axis);
        line(
            text,
            format_args!(
                "*MATERIAL,NAME=BEAM{number}\n*ELASTIC,TYPE=ENGINEERING CONSTANTS\n\
                 {e:.10e},{e:.10e},{e:.10e},0.,0.,0.,{g:.10e},{g:.10e}\n{g:.10e}\n*EXPANSION,ZERO=0.\n0.\n\
                 *ORIENTATION,NAME=AXES{number},SYSTEM=RECTANGULAR\n{},{}\n\
                 *BEAM SECTION,ELSET=BEAM{number},MATERIAL=BEAM{number},ORIENTATION=AXES{number},SECTION=RECT\n\
                 {height_mm:.10e},{width_mm:.10e}\n{}",
                list(&along),
                list(&edge),
                list(&normal),
            ),
        );
    }
}

fn supports(text: &mut String, model: &Model, mesh: &QuadraticMesh) {
    for (film, beam) in &mesh.ties {
        for freedom in 1..=3 {
            line(
                text,
                format_args!("*EQUATION\n2\n{film},{freedom},1.,{beam},{freedom},-1."),
            );
        }
    }
    text.push_str("*BOUNDARY\n");
    let mut hold = |number: usize, held: [bool; 6]| {
        for freedom in (1..=6).filter(|freedom| held[freedom - 1]) {
            line(text, format_args!("{number},{freedom},{freedom}"));
        }
    };
    for (node, held) in model.held.iter().enumerate() {
        hold(mesh.carrier(node), *held);
    }
    // a held rim is held between its nodes too; a node that is tied to a beam goes with it
    for &([a, b], middle) in &mesh.rim {
        if !mesh.ties.contains_key(&middle) {
            hold(
                middle,
                std::array::from_fn(|k| model.held[a][k] && model.held[b][k]),
            );
        }
    }
}

fn begin_step(text: &mut String) {
    text.push_str("*STEP,NLGEOM,INC=100000\n*STATIC\n0.05,1.,1e-8,0.25\n");
}

fn end_step(text: &mut String) {
    text.push_str(
        "*NODE PRINT,NSET=EDGES,FREQUENCY=100000\nU\n*NODE FILE,OUTPUT=2D,FREQUENCY=100000\nU\n*END STEP\n",
    );
}

fn left_out(model: &Model) -> Vec<String> {
    let mut left_out = Vec::new();
    let wrinkles = |sheet: &Sheet| matches!(sheet.compression, Compression::TensionField { residual, .. } if residual < 1.0);
    if model.sheets.iter().any(wrinkles) {
        left_out.push("wrinkling: the film of the deck carries compression".to_string());
    }
    if model.sections.iter().any(|section| section.skin.is_some()) {
        left_out.push("the skin of the rod, which gives way".to_string());
    }
    if model.sections.iter().any(Rectangle::leaves_out) {
        left_out.push(
            "couplings of the sections, such as that of torsion and shear of a half-round rod".to_string(),
        );
    }
    left_out
}

fn list(vector: &Vector3<f64>) -> String {
    format!("{:.10e},{:.10e},{:.10e}", vector.x, vector.y, vector.z)
}

/// Adds a line; writing to a String cannot fail.
fn line(text: &mut String, content: std::fmt::Arguments) {
    let _ = text.write_fmt(content);
    text.push('\n');
}
