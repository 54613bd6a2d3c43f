//! `washout modes`: natural frequencies and mode shapes.

use std::path::PathBuf;

use clap::Args;
use nalgebra::Vector3;

use crate::aero::Flow;
use crate::coupling::vibration::Standing;
use crate::export::modes::{ModeRow, ModesSummary, mode_grid};
use crate::export::pvd;
use crate::export::run::RunFolder;
use crate::input::design::Kinematics;
use crate::observation::ModeReader;
use crate::program::MadeOf;
use crate::structure::state::State;
use crate::structure::{MassProperties, Mode, Vibration};

use super::design_arguments::DesignArguments;
use super::finished::finished;
use super::{Console, Failure};
use crate::wing::WingModel;

/// Arguments of `washout modes`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  # in flight: about the loaded shape, stiffened by the load
  washout modes designs/twist-v2.toml --loaded
  # the same with the air that moves with the film
  washout modes designs/twist-v2.toml --loaded --with-air
  washout modes designs/twist-v2.toml --set film.pretension_n_per_m=20 \\
    --count 12
  washout modes designs/twist-v2.toml --loaded \\
    --json | jq '.modes[0].frequency_hz'

Writes output/NAME-modes/: modes.pvd and one mode-NN.vtu for each, to be warped by displacement_mm in ParaView; summary.json. An unloaded film without pre-tension is slack, and swings by its bending alone.")]
pub struct Modes {
    /// The design
    #[command(flatten)]
    pub design: DesignArguments,
    /// Folder to write into [default: output/NAME-modes]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
    /// Write report.html besides: words, pictures and tables in one file for a browser
    #[arg(long)]
    pub report: bool,
    /// Modes that are wanted, from the lowest up
    #[arg(long, value_name = "N", default_value_t = 6, value_parser = clap::value_parser!(u16).range(1..=200))]
    pub count: u16,
    /// Solve the design first, and vibrate about its loaded shape, stiffened by the load
    #[arg(long)]
    pub loaded: bool,
    /// Count the air that moves with the film as mass (density × π/4 × chord per area)
    #[arg(long)]
    pub with_air: bool,
}

impl Modes {
    /// Finds and writes the modes.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let wing = self.design.wing(console)?;
        let design = &wing.loaded.design;
        let output = self.output.clone();
        let target = output.unwrap_or_else(|| PathBuf::from("output").join(format!("{}-modes", design.name)));
        let mut folder = RunFolder::create(&target, "modes")?;
        let standing = self.standing(&wing, console)?;
        let modes = self.modes(&wing, &standing, console)?;
        let flow = Flow::from_design(design);
        let mut axes = vec![(Vector3::zeros(), Vector3::x())];
        let mut flapping_hz = None;
        if let Some(flow @ Flow::Flapping { frequency_hz, .. }) = &flow {
            axes.push((
                Vector3::x() * -wing.planform.root_offset_m(),
                flow.lift_direction(),
            ));
            flapping_hz = Some(*frequency_hz);
        }
        let reader = ModeReader::new(&wing.mesh, &standing, &axes);
        let row = |(index, mode): (usize, &Mode)| ModeRow::new(index, mode, &reader.read(mode), flapping_hz);
        let rows: Vec<ModeRow> = modes.iter().enumerate().map(row).collect();
        for (row, mode) in rows.iter().zip(&modes) {
            folder.add(
                &row.file,
                &mode_grid(design, &wing.mesh, &standing, mode).to_vtu()?,
            )?;
        }
        let series: Vec<(f64, String)> = rows
            .iter()
            .map(|row| (row.mode as f64, row.file.clone()))
            .collect();
        folder.add("modes.pvd", pvd::collection(&series).as_bytes())?;
        let summary = ModesSummary {
            name: design.name.clone(),
            design: design.clone(),
            loaded: self.loaded,
            with_air: self.with_air,
            mass_mg: MassProperties::of(&standing.model, &State::at_rest(wing.mesh.nodes.len())).mass_kg
                * 1e6,
            flapping_frequency_hz: flapping_hz,
            modes: rows,
            warnings: self.warnings(&wing),
            made_of: MadeOf::files(&wing.loaded.files),
            files: folder.listed_with(self.report),
        };
        let page = summary.page();
        let written = finished(folder, self.report.then_some(&page), &summary, console)?;
        console.answer(&page, &console.listed(&written, &summary.files), &summary)
    }

    fn standing(&self, wing: &WingModel, console: &Console) -> Result<Standing, Failure> {
        let (design, progress) = (&wing.loaded.design, console.progress());
        let standing = if self.loaded {
            progress.say(format_args!("solving {}", design.name));
            Standing::loaded(design, &wing.solve(progress)?.solution)
        } else {
            Standing::unloaded(design, &wing.mesh, wing.air_table(), progress)
        };
        let standing = standing.map_err(|source| wing.unsolved(source))?;
        Ok(if self.with_air {
            standing.with_air(design, &wing.planform)
        } else {
            standing
        })
    }

    fn modes(&self, wing: &WingModel, standing: &Standing, console: &Console) -> Result<Vec<Mode>, Failure> {
        console.progress().say("finding modes");
        match standing.modes(self.count.into(), console.progress()) {
            Ok(Vibration::Stable(modes)) => Ok(modes),
            Ok(Vibration::Unstable { negative }) => Err(Failure::Unstable {
                design: wing.loaded.path.clone(),
                shape: if self.loaded { "loaded" } else { "unloaded" },
                directions: negative,
            }),
            Err(source) => Err(wing.unsolved(source).into()),
        }
    }

    fn warnings(&self, wing: &WingModel) -> Vec<String> {
        let design = &wing.loaded.design;
        let mut warnings = Vec::new();
        let slack = design
            .film
            .as_ref()
            .is_some_and(|film| film.pretension_n_per_m.value() == 0.0);
        if !self.loaded && slack {
            warnings.push(
                "The unloaded film has no tension and swings by its bending alone. Use --loaded for the modes in flight, \
                 where the load stretches it, or give film.pretension_n_per_m."
                    .to_string(),
            );
        }
        if self.loaded && design.structure.kinematics == Kinematics::Linear {
            warnings.push(
                "In linear kinematics a load does not stiffen: these are the modes at rest. Set structure.kinematics = \
                 \"large-rotation\" for those in flight."
                    .to_string(),
            );
        }
        warnings
    }
}
