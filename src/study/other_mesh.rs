//! What the mesh of a campaign leaves: its cases solved besides on a mesh twice as fine, or half as fine, nothing moved.

use std::sync::Arc;

use nalgebra::DVector;

use super::campaign::Campaign;
use super::error::StudyError;
use super::forward::{Forward, MeshError};
use crate::input::study::LoadedStudy;
use crate::progress::Progress;

/// Refinement up to which the other mesh is the finer one.
const COARSE: f64 = 0.75;
/// Error of a mesh over that of one twice as fine: elements of second order.
const ORDER: f64 = 4.0;
/// What remains uncertain, over the difference of the two meshes: where the mesh decides, in free film, the order is not sure, and two models
/// of one wing differ by as much as their meshes move them (three rods, near the tip: 0.7° and 1.1° of 23°, where
/// these two meshes differ by 1.2° and 0.7°).
const LEFT: f64 = 1.0;

/// A campaign on two meshes.
#[derive(Debug, Clone)]
pub(super) struct OtherMesh {
    /// What its mesh leaves.
    pub error: MeshError,
    /// The same campaign on the coarser mesh, if its own is the finer one.
    pub coarse: Option<Arc<Campaign>>,
}

impl Campaign {
    /// Corrects every further prediction by what is known of the mesh.
    pub fn with_mesh_error(self, error: MeshError) -> Campaign {
        self.beside(OtherMesh { error, coarse: None })
    }

    /// Looks at what the mesh leaves (Richardson extrapolation from a mesh twice as fine, or half as fine where its own is fine already);
    /// every further prediction is corrected by it. Campaigns of mesh files, or whose wings have no equilibrium on the other mesh, stay as
    /// they are.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn on_two_meshes(
        self,
        study: &LoadedStudy,
        candidates: &[&str],
        progress: &Progress,
    ) -> Result<Campaign, StudyError> {
        let refinements = study.cases.iter().map(|case| case.loaded.design.mesh.refine);
        let finest = refinements.fold(0.0, f64::max);
        if finest == 0.0 || study.cases.iter().any(|case| case.loaded.mesh_file.is_some()) {
            return Ok(self);
        }
        let is_coarse = finest <= COARSE;
        let factor = if is_coarse { 2.0 } else { 0.5 };
        let mut study = study.clone();
        for case in &mut study.cases {
            case.loaded.design.mesh.refine *= factor;
        }
        progress.say("what the mesh leaves");
        let other = match Campaign::new(&study, candidates, &progress.unseen()) {
            Ok(other) => other,
            Err(StudyError::Cancelled(cancelled)) => return Err(StudyError::Cancelled(cancelled)),
            Err(_) => return Ok(self),
        };
        if other.observables().len() != self.observables().len()
            || other.unknowns().len() != self.unknowns().len()
        {
            return Ok(self);
        }
        let start = self.start();
        let [own, others] = [self.predict(&start)?, other.predict(&start)?];
        let error = left(&own, &others, is_coarse);
        let coarse = (!is_coarse).then(|| Arc::new(other));
        Ok(self.beside(OtherMesh { error, coarse }))
    }
}

/// What predictions lack, from those of the other mesh.
fn left(own: &DVector<f64>, other: &DVector<f64>, is_coarse: bool) -> MeshError {
    let difference = if is_coarse { other - own } else { own - other };
    let share = if is_coarse {
        ORDER / (ORDER - 1.0)
    } else {
        1.0 / (ORDER - 1.0)
    };
    MeshError {
        correction: difference.iter().map(|own| share * own).collect(),
        deviation: difference.iter().map(|own| LEFT * own).collect(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn predictions_of_second_order_are_corrected_to_what_a_mesh_without_end_would_give() {
        // y = 10 + h²
        let [coarse, fine] = [1.0, 0.5].map(|h: f64| DVector::from_element(1, 10.0 + h * h));
        for (found, own) in [
            (left(&coarse, &fine, true), &coarse),
            (left(&fine, &coarse, false), &fine),
        ] {
            assert!((own[0] + found.correction[0] - 10.0).abs() < 1e-12);
            // as uncertain as the two meshes are apart
            assert!((found.deviation[0].abs() - 0.75).abs() < 1e-12);
        }
    }
}
