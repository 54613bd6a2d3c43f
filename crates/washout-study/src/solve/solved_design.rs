//! A design solved, with all that was asked for.

use std::collections::BTreeMap;

use crate::compare::Reading;
use crate::coupling::Engineering;
use crate::progress::Progress;
use crate::study::Uncertainty;
use crate::wing::stroke::{PhaseShape, StrokeSummary};
use crate::wing::stroke_periodic::periodic_stroke;
use crate::wing::stroke_quasi_static::quasi_static_stroke;
use crate::wing::{DiscretizationError, Meshes, OtherEquilibrium, SolvedWing, WingError, WingModel};

use super::asked::{Asked, OverStroke};
use super::band::band;
use super::error::SolveError;

/// A design solved.
#[derive(Debug)]
pub struct SolvedDesign {
    /// The wing.
    pub wing: SolvedWing,
    /// Profile, lift, and how far it is from the measurement.
    pub reading: Reading,
    /// What the mesh leaves.
    pub mesh_error: DiscretizationError,
    /// What the usual options of the solver lead to, where the design has others and they led to another shape.
    pub other_equilibrium: Option<OtherEquilibrium>,
    /// Band from the assumed ranges.
    pub uncertainty: Option<Uncertainty>,
    /// The wing over its stroke.
    pub stroke: Option<StrokeSummary>,
    /// Mass, stiffness, stresses and margins.
    pub engineering: Engineering,
}

impl SolvedDesign {
    /// Solves.
    ///
    /// # Errors
    /// If what is asked for is out of range, the wing has no solution or cannot be read, or the user asked to stop.
    ///
    /// # Example
    /// ```
    /// # use washout_study as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// use washout::solve::{Asked, SolvedDesign};
    /// use washout::{progress::Progress, wing::WingModel};
    ///
    /// let wing = WingModel::open("designs/twist-v2.toml", &["mesh.refine=0.5"])?;
    /// let solved = SolvedDesign::new(&wing, &Asked::default(), &Progress::quiet())?;
    /// let left_deg = solved.mesh_error.tip_twist_deg;
    /// println!("the mesh leaves {left_deg:?} deg");
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(wing: &WingModel, asked: &Asked, progress: &Progress) -> Result<SolvedDesign, SolveError> {
        SolvedDesign::drawing(wing, asked, |_| (), progress)
    }

    /// The same; `draw` is shown the shape at each phase of the stroke.
    ///
    /// # Errors
    /// As [`SolvedDesign::new`].
    pub fn drawing(
        wing: &WingModel,
        asked: &Asked,
        mut draw: impl FnMut(&PhaseShape),
        progress: &Progress,
    ) -> Result<SolvedDesign, SolveError> {
        asked.check()?;
        progress.say(format_args!("solving {}", wing.design().name));
        let meshes = match asked.accuracy {
            None => Meshes::solve(wing, progress)?,
            Some(share) => Meshes::until(wing, share, progress)?,
        };
        let mesh_error = meshes.error()?;
        let wing = meshes.wing;
        let reading = Reading::of(&wing, &BTreeMap::new())?;
        let uncertainty = asked
            .uncertainty
            .map(|samples| band((&wing, meshes.coarser.as_ref().ok()), &reading, samples, progress));
        let uncertainty = uncertainty.transpose()?;
        let mut draw = |shape: PhaseShape| -> Result<(), WingError> {
            draw(&shape);
            Ok(())
        };
        let stroke = match asked.stroke {
            Some(OverStroke::Periodic(count)) => Some(periodic_stroke(&wing, count, progress, &mut draw)?),
            Some(OverStroke::QuasiStatic(count)) => {
                Some(quasi_static_stroke(&wing, count, progress, &mut draw)?)
            }
            None => None,
        };
        let engineering = wing.engineering(progress)?;
        let other_equilibrium = wing.with_usual_options(progress)?;
        Ok(SolvedDesign {
            wing,
            reading,
            mesh_error,
            other_equilibrium,
            uncertainty,
            stroke,
            engineering,
        })
    }
}
