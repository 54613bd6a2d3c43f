//! `washout mesh`: the mesh of a design as files, and how good it is.

use std::path::PathBuf;

use clap::Args;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::export::run::RunFolder;
use crate::export::wing::mesh_grid;
use crate::mesh::{Quality, gmsh};
use crate::page::text::number;
use crate::program::MadeOf;

use super::design_arguments::DesignArguments;
use super::{Console, Failure};

/// Arguments of `washout mesh`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  # output/twist-v2-mesh: mesh.vtu, mesh.msh, outline.geo
  washout mesh designs/twist-v2.toml
  washout mesh designs/twist-v2.toml --refine 2
  washout solve designs/twist-v2.toml --mesh output/twist-v2-mesh/mesh.msh
  # Gmsh's own mesh, half as coarse, for --mesh; MSH 4.1 or 2.2
  gmsh -2 -clscale 0.5 output/twist-v2-mesh/outline.geo")]
pub struct WriteMesh {
    /// The design
    #[command(flatten)]
    pub design: DesignArguments,
    /// Folder to write into [default: output/NAME-mesh]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

/// A mesh: how large and how good it is; `summary.json` of its folder.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct MeshReport {
    /// Name of the wing.
    pub name: String,
    /// Nodes.
    pub nodes: usize,
    /// Membrane triangles.
    pub triangles: usize,
    /// Beam elements.
    pub beams: usize,
    /// Area of the film in the mesh.
    pub area_mm2: f64,
    /// Area of the outline as built.
    pub outline_area_mm2: f64,
    /// Non-dimensional radius of the first moment of area, as built.
    pub r1_hat: f64,
    /// Non-dimensional radius of the second moment of area, as built.
    pub r2_hat: f64,
    /// Smallest angle of a triangle; 60 without triangles.
    pub smallest_angle_deg: f64,
    /// Largest ratio of circumradius to twice the inradius; 1 is equilateral.
    pub largest_aspect: f64,
    /// What it was made of.
    pub made_of: MadeOf,
    /// Files in the folder.
    pub files: Vec<String>,
}

impl WriteMesh {
    /// Meshes the wing and writes the files.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let wing = self.design.meshed(console)?;
        let design = &wing.loaded.design;
        let output = self.output.clone();
        let target = output.unwrap_or_else(|| PathBuf::from("output").join(format!("{}-mesh", design.name)));
        let mut folder = RunFolder::create(&target, "mesh")?;
        folder.add("mesh.vtu", &mesh_grid(design, &wing.mesh).to_vtu()?)?;
        folder.add("mesh.msh", gmsh::write(&wing.mesh).as_bytes())?;
        if let Some(outline) = gmsh::geometry(&wing.mesh) {
            folder.add("outline.geo", outline.as_bytes())?;
        }
        let quality = Quality::of(&wing.mesh);
        let report = MeshReport {
            name: design.name.clone(),
            nodes: quality.nodes,
            triangles: quality.triangles,
            beams: quality.beams,
            area_mm2: quality.area_m2 * 1e6,
            outline_area_mm2: wing.planform.area_m2() * 1e6,
            r1_hat: wing.planform.r1_hat(),
            r2_hat: wing.planform.r2_hat(),
            smallest_angle_deg: quality.smallest_angle_deg,
            largest_aspect: quality.largest_aspect,
            made_of: MadeOf::files(&wing.loaded.files),
            files: folder.listed(),
        };
        folder.add_summary(&report)?;
        console.progress().check()?;
        let path = folder.commit()?;
        console.result(&page(&report, &path.display().to_string()), &report)
    }
}

fn page(report: &MeshReport, folder: &str) -> String {
    format!(
        "{}\n  mesh    {} nodes, {} triangles, {} beam elements\n  area    {} mm² meshed, {} mm² as built; r1 {}, r2 {}\n  \
         shape   smallest angle {}°, largest aspect {}\n\nFiles in {folder}: {}\n",
        report.name,
        report.nodes,
        report.triangles,
        report.beams,
        number(report.area_mm2, 1),
        number(report.outline_area_mm2, 1),
        number(report.r1_hat, 4),
        number(report.r2_hat, 4),
        number(report.smallest_angle_deg, 1),
        number(report.largest_aspect, 2),
        report.files.join(" "),
    )
}
