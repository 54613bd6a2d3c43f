//! A wing read and meshed: what can be solved.

use std::error::Error;
use std::path::Path;

use crate::aero::Flow;
use crate::coupling::solution::Solution;
use crate::coupling::{self, BladeAir, CouplingError};
use crate::effects::bind;
use crate::geometry::Planform;
use crate::input::{Design, Loaded};
use crate::lift::{LiftError, Stroke};
use crate::mesh::{Mesh, MeshFile, for_design};
use crate::progress::Progress;

use super::error::WingError;

/// Share of the length to which the last rod reaches on a wing of which nothing is said.
const ROD_TO: f64 = 0.97;

/// A wing that is ready to be solved.
#[derive(Debug, Clone)]
pub struct WingModel {
    /// The design with all that its file refers to.
    pub loaded: Loaded,
    /// Its outline.
    pub planform: Planform,
    /// Its mesh.
    pub mesh: Mesh,
}

impl WingModel {
    /// Reads a design file, with keys set to other values (`"flapping.half_amplitude_deg=30"`), and meshes the wing.
    ///
    /// # Errors
    /// If a file is refused, or no such wing can be meshed.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// use washout::wing::WingModel;
    ///
    /// let wing = WingModel::open("designs/twist-v2.toml", &["flapping.half_amplitude_deg=30"])?;
    /// assert_eq!(wing.loaded.design.name, "twist-v2");
    /// # Ok::<(), washout::wing::WingError>(())
    /// ```
    pub fn open(path: impl AsRef<Path>, sets: &[&str]) -> Result<WingModel, WingError> {
        let sets: Vec<String> = sets.iter().map(|set| set.to_string()).collect();
        WingModel::new(Design::load(path.as_ref(), &sets)?)
    }

    /// Meshes a design that was read.
    ///
    /// # Errors
    /// If an effect is refused, or no such wing can be meshed.
    pub fn new(loaded: Loaded) -> Result<WingModel, WingError> {
        bind(&loaded.design).map_err(|source| WingError::effect(&loaded, source))?;
        let file = (loaded.mesh_file.as_ref()).map(|(name, bytes)| MeshFile { name, bytes });
        let (planform, mesh) =
            for_design(&loaded.design, file).map_err(|error| WingError::design(&loaded.path, error))?;
        Ok(WingModel {
            loaded,
            planform,
            mesh,
        })
    }

    /// Meshes a design that stands alone: it names no files.
    ///
    /// # Errors
    /// As [`WingModel::new`].
    pub fn of_design(design: Design) -> Result<WingModel, WingError> {
        WingModel::new(Loaded::alone(design))
    }

    /// A design that stands alone, on a mesh of one's own.
    ///
    /// # Errors
    /// If the design has no outline.
    pub fn on_mesh(design: Design, mesh: Mesh) -> Result<WingModel, WingError> {
        let loaded = Loaded::alone(design);
        let planform =
            Planform::from_design(&loaded.design).map_err(|error| WingError::design(&loaded.path, error))?;
        Ok(WingModel {
            loaded,
            planform,
            mesh,
        })
    }

    /// The same wing with one key of its design set to another value, in the key's unit.
    ///
    /// # Errors
    /// If the design refuses it, or no such wing can be meshed.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use washout::wing::WingModel;
    /// let wing = WingModel::open("designs/twist-v2.toml", &[])?.with("flapping.frequency_hz", 25.0)?;
    /// # Ok::<(), washout::wing::WingError>(())
    /// ```
    pub fn with(&self, key: &str, value: f64) -> Result<WingModel, WingError> {
        let mut design = self.design().clone();
        design.set(key, value)?;
        self.with_design(design)
    }

    /// The same wing with an effect of the library at a strength; 0 is none. All else of the effect stays as the design has it.
    ///
    /// # Errors
    /// As [`WingModel::with`].
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use washout::wing::WingModel;
    /// let wing = WingModel::open("designs/twist-v2.toml", &[])?.with_effect("root-flexure", 0.5)?;
    /// assert!(wing.design().effects.contains_key("root-flexure"));
    /// # Ok::<(), washout::wing::WingError>(())
    /// ```
    pub fn with_effect(&self, effect: &str, strength: f64) -> Result<WingModel, WingError> {
        self.with(&format!("effects.{effect}.strength"), strength)
    }

    /// Another design with the files of this one.
    ///
    /// # Errors
    /// As [`WingModel::new`].
    pub fn with_design(&self, design: Design) -> Result<WingModel, WingError> {
        WingModel::new(Loaded {
            design,
            ..self.loaded.clone()
        })
    }

    /// The design.
    pub fn design(&self) -> &Design {
        &self.loaded.design
    }

    /// Rows alpha_deg, cl, cd of its table of coefficients, if it has one.
    pub fn air_table(&self) -> Option<&[[f64; 3]]> {
        self.loaded.air_table.as_deref()
    }

    /// The bare loaded shape, from one nearby if there is one, or what the solver says.
    ///
    /// # Errors
    /// If there is none that is found, or the pitch stop would have to pull.
    pub fn shape(&self, nearby: Option<&Solution>, progress: &Progress) -> Result<Solution, CouplingError> {
        let solution = coupling::solve_from(self.design(), &self.mesh, self.air_table(), nearby, progress)?;
        solution.refuse_pull_of_stop(self.design())?;
        Ok(solution)
    }

    /// The air of the wing on blade elements, with its effects.
    ///
    /// # Errors
    /// If it cannot be set up.
    pub fn air(&self) -> Result<BladeAir, WingError> {
        BladeAir::new(self.design(), &self.planform, self.air_table()).map_err(|error| self.fault(error))
    }

    /// The stroke of the wing.
    ///
    /// # Errors
    /// If it does not flap.
    pub fn stroke(&self) -> Result<Stroke, WingError> {
        let flow = Flow::from_design(self.design()).ok_or_else(|| self.fault(LiftError::NotFlapping))?;
        Stroke::from_flow(&flow).map_err(|error| self.fault(error))
    }

    /// What is wrong with the design, with the name of its file.
    pub fn fault(&self, reason: impl Error + Send + Sync + 'static) -> WingError {
        WingError::design(&self.loaded.path, reason)
    }

    /// That the design names no measurement.
    pub fn no_measurement(&self) -> WingError {
        WingError::NoMeasurement {
            design: self.loaded.path.clone(),
        }
    }

    /// Why there is no solution, with the name of the file.
    pub fn unsolved(&self, source: CouplingError) -> WingError {
        match source {
            CouplingError::Interrupted(cancelled) => cancelled.into(),
            source => WingError::Solve {
                design: self.loaded.path.clone(),
                source,
                remark: self.bare_edge(),
            },
        }
    }

    /// Where the leading edge has no rod before the tip, in words; empty if it has one.
    fn bare_edge(&self) -> String {
        let design = self.design();
        let length_mm = design.planform.length_mm.value();
        let end_mm = design.rod.last().map_or(length_mm, |rod| rod.to_mm.value());
        match end_mm < ROD_TO * length_mm {
            true => format!(
                ". The rod ends at {end_mm} mm of {length_mm} mm, so that the film beyond hangs on itself alone: let the last rod \
                 end at the tip if that is not meant"
            ),
            false => String::new(),
        }
    }
}
