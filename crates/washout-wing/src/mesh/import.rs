//! Outline and mesh of a design: generated, or from a mesh file that fits the design.

use super::error::MeshError;
use super::generate::generate;
use super::{BeamPart, Mesh, gmsh};
use crate::geometry::planform::OutlineSpec;
use crate::geometry::{Layout, Planform};
use crate::input::design::Design;

/// A mesh file that was read: its name as errors show it, and what stands in it.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MeshFile<'a> {
    /// Name of the file.
    pub name: &'a str,
    /// Its content, Gmsh MSH 4.1 text, metres.
    pub bytes: &'a [u8],
}

/// Places of parts may differ by this share of the wing's length.
const PLACE: f64 = 1e-3;

/// Chords may differ by this share of the mean chord.
const CHORD: f64 = 1e-2;

/// Outline and mesh of a design; from `file` if one is given.
///
/// A mesh file must have the design's rod pieces and spars at their places, and its outline; a design without
/// a shape of its own (no `r2_hat`, no `outline`) takes the outline of the mesh.
pub fn for_design(design: &Design, file: Option<MeshFile>) -> Result<(Planform, Mesh), MeshError> {
    let Some(file) = file else {
        let planform = Planform::from_design(design)?;
        let mesh = generate(design, &planform)?;
        return Ok((planform, mesh));
    };
    if design.ribs.is_some() {
        let file = file.name.to_string();
        return Err(MeshError::RibsFromFile { file });
    }
    let mesh = gmsh::read(file.bytes, file.name)?;
    let fit = Fit {
        mesh: &mesh,
        file: file.name,
    };
    fit.film(design)?;
    let planform = fit.planform(design)?;
    fit.parts(
        &Layout::from_design(design, &planform)?,
        PLACE * planform.length_m(),
    )?;
    Ok((planform, mesh))
}

struct Fit<'a> {
    mesh: &'a Mesh,
    file: &'a str,
}

impl Fit<'_> {
    fn film(&self, design: &Design) -> Result<(), MeshError> {
        let in_mesh = !self.mesh.triangles.is_empty();
        if in_mesh == design.film.is_some() {
            return Ok(());
        }
        let cure = if in_mesh {
            "add [film]"
        } else {
            "mesh this design again, or take [film] out"
        };
        Err(MeshError::FilmMismatch {
            file: self.file.to_string(),
            in_mesh,
            cure,
        })
    }

    /// Span and chord at the nodes of the trailing edge, m, the span rising.
    fn outline_m(&self) -> Vec<[f64; 2]> {
        let mut points: Vec<[f64; 2]> = Vec::new();
        for [x, y, _] in self.mesh.trailing_edge.iter().map(|&node| self.mesh.nodes[node]) {
            if points.last().is_none_or(|last| x > last[0]) {
                points.push([x, y]);
            }
        }
        points
    }

    fn planform(&self, design: &Design) -> Result<Planform, MeshError> {
        let (span_m, length_m) = (
            self.mesh.bounds_m()[1][0],
            design.planform.length_mm.value() / 1000.0,
        );
        let wrong_span = |in_design_m: f64| MeshError::Span {
            file: self.file.to_string(),
            in_mesh_mm: span_m * 1000.0,
            in_design_mm: in_design_m * 1000.0,
        };
        let has_shape = design.planform.r2_hat.is_some() || design.planform.outline.is_some();
        if !has_shape && !self.mesh.triangles.is_empty() {
            let tip_cut = span_m / length_m;
            if !(0.5..=1.0 + PLACE).contains(&tip_cut) {
                return Err(wrong_span(length_m));
            }
            return Ok(Planform::from_outline(&OutlineSpec {
                length_m,
                root_offset_m: design.planform.root_offset_mm.value() / 1000.0,
                points_m: &self.outline_m(),
                base_closure: 0.0,
                tip_cut: tip_cut.min(1.0),
            })?);
        }
        let planform = Planform::from_design(design)?;
        if !self.mesh.triangles.is_empty() && (span_m - planform.tip_m()).abs() > PLACE * length_m {
            return Err(wrong_span(planform.tip_m()));
        }
        for [r_m, chord_m] in self.outline_m() {
            let design_chord_m = planform.chord_m(r_m);
            if (chord_m - design_chord_m).abs() > CHORD * planform.mean_chord_m() {
                return Err(MeshError::Outline {
                    file: self.file.to_string(),
                    at_mm: r_m * 1000.0,
                    in_mesh_mm: chord_m * 1000.0,
                    in_design_mm: design_chord_m * 1000.0,
                });
            }
        }
        Ok(planform)
    }

    fn parts(&self, layout: &Layout, slack_m: f64) -> Result<(), MeshError> {
        let pieces = self.mesh.beams.iter().filter_map(|beam| match beam.part {
            BeamPart::Rod(index) => Some(index + 1),
            BeamPart::Spar(_) | BeamPart::Rib(_) => None,
        });
        let counts = [
            ("rod pieces", pieces.max().unwrap_or(0), layout.rod.len()),
            ("spars", self.mesh.spar_count(), layout.spars.len()),
        ];
        for (part, in_mesh, in_design) in counts {
            if in_mesh != in_design {
                return Err(MeshError::PartCount {
                    file: self.file.to_string(),
                    part,
                    in_mesh,
                    in_design,
                });
            }
        }
        let x_m = |node: usize| self.mesh.nodes[node][0];
        let same = |part: BeamPart, end: &'static str, in_mesh_m: f64, in_design_m: f64| {
            if (in_mesh_m - in_design_m).abs() <= slack_m {
                return Ok(());
            }
            let (in_mesh_mm, in_design_mm) = (in_mesh_m * 1000.0, in_design_m * 1000.0);
            Err(MeshError::PartPlace {
                file: self.file.to_string(),
                part,
                end,
                in_mesh_mm,
                in_design_mm,
            })
        };
        for piece in &layout.rod {
            let part = BeamPart::Rod(piece.index);
            let last = self.mesh.beams.iter().rev().find(|beam| beam.part == part);
            if let Some(beam) = last {
                same(part, "ends", x_m(beam.nodes[1]), piece.to_m)?;
            }
        }
        for spar in &layout.spars {
            let part = BeamPart::Spar(spar.index);
            let nodes = self.mesh.spar_nodes(spar.index);
            if let [first, .., last] = nodes[..] {
                same(part, "meets the leading edge", x_m(first), spar.leading_edge_m)?;
                same(part, "meets the trailing edge", x_m(last), spar.trailing_edge_m)?;
            }
        }
        Ok(())
    }
}
