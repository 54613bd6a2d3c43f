//! Wings beside a solved one, for differences: what a parameter leaves alone is taken over from it, bit for bit.

use std::cell::OnceCell;
use std::sync::Arc;

use crate::effects::{Motion, Need, Seam, bind, named};
use crate::geometry::Planform;
use crate::input::design::Design;
use crate::mesh::{Mesh, MeshError};
use crate::progress::Progress;

use super::error::{CouplingError, SensitivityError};
use super::motion::{Motions, motion_by};
use super::periodic::PeriodicSettings;
use super::solution::Solution;
use super::wing::Wing;

/// Outline and mesh of a design, as the solved wing got its own.
pub type Remesh<'a> = &'a dyn Fn(&Design) -> Result<(Planform, Mesh), MeshError>;

/// Tables of a design whose numbers do not move the mesh.
const OFF_THE_MESH: [&str; 7] = [
    "effects", "material", "air", "flapping", "steady", "gravity", "film",
];

/// A solved wing, and what its neighbours share.
pub(super) struct Home<'a> {
    /// Its design.
    pub design: &'a Design,
    /// The wing of that design.
    pub wing: &'a Wing,
    /// Rows of a table of coefficients.
    pub air_table: Option<&'a [[f64; 3]]>,
    /// Its solution.
    pub solution: &'a Solution,
    /// Outline and mesh of a design.
    pub remesh: Remesh<'a>,
    planform: OnceCell<Planform>,
    motions: Motions,
}

/// A design beside the solved one, with its wing.
pub(super) struct Beside {
    /// The design.
    pub design: Design,
    /// Outline and mesh; none where they are those of the solved wing.
    pub moved: Option<(Planform, Mesh)>,
    /// Its wing.
    pub wing: Wing,
    /// Where it differs, if that is by the number of one effect.
    pub seam: Option<Seam>,
}

impl<'a> Home<'a> {
    /// Of a solved wing.
    pub fn new(
        design: &'a Design,
        wing: &'a Wing,
        air_table: Option<&'a [[f64; 3]]>,
        solution: &'a Solution,
        remesh: Remesh<'a>,
    ) -> Self {
        Home {
            design,
            wing,
            air_table,
            solution,
            remesh,
            planform: OnceCell::new(),
            motions: Motions::default(),
        }
    }

    /// Its outline.
    pub fn planform(&self) -> Result<&Planform, SensitivityError> {
        if let Some(planform) = self.planform.get() {
            return Ok(planform);
        }
        let (planform, _) = (self.remesh)(self.design)?;
        Ok(self.planform.get_or_init(|| planform))
    }

    /// The design with another value, meshed with the pattern of the solved wing, and its wing.
    pub fn beside(&self, key: &str, value: f64) -> Result<Beside, SensitivityError> {
        let mut design = self.design.clone();
        design.set(key, value)?;
        let table = key.split(['.', '[']).next().unwrap_or_default();
        if OFF_THE_MESH.contains(&table) {
            let effect = key
                .strip_prefix("effects.")
                .and_then(|rest| rest.split('.').next());
            let card = effect.and_then(named).map(|effect| effect.card());
            let needs_motion = card
                .as_ref()
                .is_some_and(|card| card.needs.contains(&Need::Motion));
            let settings = PeriodicSettings::of_design(&design)?;
            let moves_alike = settings == PeriodicSettings::of_design(self.design)?;
            let motion = if needs_motion {
                Some(self.motion(settings, moves_alike)?)
            } else {
                self.wing.motion.clone()
            };
            // another motion is felt wherever effects rest on it
            let seam = card.map(|card| card.seam).filter(|_| moves_alike);
            let mesh = &self.solution.mesh;
            let wing = self.wing.beside(&design, mesh, self.air_table, seam, motion)?;
            return Ok(Beside {
                design,
                moved: None,
                wing,
                seam,
            });
        }
        bind(&design).map_err(CouplingError::from)?;
        let (planform, mesh) = (self.remesh)(&design)?;
        let solved = &self.solution.mesh;
        let alike = mesh.nodes.len() == solved.nodes.len()
            && mesh.triangles == solved.triangles
            && mesh.beams == solved.beams;
        if !alike {
            return Err(SensitivityError::OtherPattern { key: key.to_string() });
        }
        let wing = Wing::with_motion(&design, &mesh, self.air_table, self.wing.motion.clone())?;
        Ok(Beside {
            design,
            moved: Some((planform, mesh)),
            wing,
            seam: None,
        })
    }

    /// What the stroke does at the phase of the design: computed once for the settings that are asked for, whatever is made from it; `is_own`: they are
    /// those of the solved wing.
    fn motion(&self, settings: PeriodicSettings, is_own: bool) -> Result<Arc<Motion>, SensitivityError> {
        if let Some(known) = self.wing.motion.as_ref().filter(|_| is_own) {
            return Ok(known.clone());
        }
        let found = self.motions.by(settings, |settings| {
            let near = Some(self.solution);
            motion_by(
                settings,
                self.design,
                &self.solution.mesh,
                self.air_table,
                near,
                &Progress::quiet(),
            )
        });
        Ok(found?)
    }
}
