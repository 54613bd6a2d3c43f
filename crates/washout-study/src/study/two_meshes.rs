//! A campaign on two meshes: it is solved on the coarser one, and every prediction is corrected by what the finer one says where nothing has
//! moved.

use nalgebra::DVector;
use serde::{Deserialize, Serialize};

use super::campaign::Campaign;
use super::error::StudyError;
use super::forward::{Forward, MeshError};
use crate::input::study::LoadedStudy;
use crate::progress::Progress;

/// Refinement up to which a study states the coarser of the two meshes.
pub(super) const COARSE: f64 = 0.75;
/// Refinement of the finer mesh over that of the coarser one.
const FINER: f64 = 2.0;
/// Error of the coarser mesh over that of the finer one: elements of second order.
const ORDER: f64 = FINER * FINER;
/// What remains uncertain, over the difference of the two meshes: where the mesh decides, in free film, the order is not sure, and two models
/// of one wing differ by as much as their meshes move them (three rods, near the tip: 0.7° and 1.1° of 23°, where
/// these two meshes differ by 1.2° and 0.7°).
const LEFT: f64 = 1.0;

/// A study on the coarser of two meshes, and on the finer one.
pub struct TwoMeshes {
    /// The coarser: on this one a diagnosis solves.
    pub coarser: LoadedStudy,
    /// The finer; none if a case reads its mesh from a file.
    pub finer: Option<LoadedStudy>,
}

impl TwoMeshes {
    /// The mesh that a study states is the coarser one up to a refinement of 0.75, and where no wing has a film: rods and spars alone cost
    /// little, and where along them an effect sits is seen no closer than an element. Else it is the finer one.
    pub fn of(study: &LoadedStudy) -> TwoMeshes {
        let finest = study.cases.iter().map(|case| case.loaded.design.mesh.refine);
        let finest = finest.fold(0.0, f64::max);
        let of_file = study.cases.iter().any(|case| case.loaded.mesh_file.is_some());
        let has_film = study.cases.iter().any(|case| case.loaded.design.film.is_some());
        let (coarser, finer) = match (of_file, finest <= COARSE || !has_film) {
            (true, _) => (study.clone(), None),
            (false, true) => (study.clone(), Some(refined(study, FINER))),
            (false, false) => (refined(study, FINER.recip()), Some(study.clone())),
        };
        TwoMeshes { coarser, finer }
    }
}

fn refined(study: &LoadedStudy, factor: f64) -> LoadedStudy {
    let mut study = study.clone();
    for case in &mut study.cases {
        case.loaded.design.mesh.refine *= factor;
    }
    study
}

impl Campaign {
    /// The same with every further prediction corrected by what is known of the mesh.
    pub fn with_mesh(self, mesh: &MeshLeaves) -> Campaign {
        Campaign {
            mesh_error: mesh.error.clone(),
            ..self
        }
    }

    /// What the mesh of this campaign leaves, by Richardson extrapolation from the same study on a mesh twice as fine.
    ///
    /// # Errors
    /// If a case has no solution there, or cannot be read as it can here, or the user asked to stop.
    pub fn mesh_error_by(
        &self,
        finer: &LoadedStudy,
        candidates: &[&str],
        progress: &Progress,
    ) -> Result<MeshError, StudyError> {
        progress.say("what the mesh leaves");
        let finer = Campaign::new(finer, candidates, &progress.unseen())?;
        let lines = |of: &Campaign| -> Vec<(usize, usize)> {
            let observables = of.observables().iter();
            observables.map(|own| (own.condition, own.line)).collect()
        };
        if lines(&finer) != lines(self) {
            return Err(StudyError::OtherRows);
        }
        let start = self.start();
        Ok(left(&self.predict(&start)?, &finer.predict(&start)?))
    }
}

/// What predictions on the coarser mesh lack.
fn left(coarser: &DVector<f64>, finer: &DVector<f64>) -> MeshError {
    let difference = finer - coarser;
    MeshError {
        correction: difference.iter().map(|own| ORDER / (ORDER - 1.0) * own).collect(),
        deviation: difference.iter().map(|own| LEFT * own).collect(),
    }
}

/// A campaign on the coarser of two meshes, and the study on the mesh that corrects it.
#[derive(Debug)]
pub struct OnCoarserMesh {
    /// The campaign.
    pub campaign: Campaign,
    finer: Option<LoadedStudy>,
    note: Option<String>,
}

/// What the mesh of a campaign leaves, and a sentence where that is not known.
#[derive(Debug, Clone, Default, Serialize, Deserialize)]
pub struct MeshLeaves {
    /// What is known.
    pub error: Option<MeshError>,
    /// Why it is not known.
    pub note: Option<String>,
}

impl OnCoarserMesh {
    /// On the coarser mesh of [`TwoMeshes::of`]; on that of the study where it has no solution there.
    ///
    /// # Errors
    /// As [`Campaign::new`].
    pub fn new(
        study: &LoadedStudy,
        candidates: &[&str],
        progress: &Progress,
    ) -> Result<OnCoarserMesh, StudyError> {
        let TwoMeshes { coarser, finer } = TwoMeshes::of(study);
        let refine = |of: &LoadedStudy| of.cases.first().map(|case| case.loaded.design.mesh.refine);
        match Campaign::new(&coarser, candidates, progress) {
            Ok(campaign) => Ok(OnCoarserMesh {
                campaign,
                finer,
                note: None,
            }),
            Err(error) if matches!(error, StudyError::Cancelled(_)) || refine(&coarser) == refine(study) => {
                Err(error)
            }
            Err(error) => Ok(OnCoarserMesh {
                campaign: Campaign::new(study, candidates, progress)?,
                finer: None,
                note: Some(not_known("half as fine", &error)),
            }),
        }
    }

    /// What the mesh leaves, or that it is not known.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn leaves(&self, candidates: &[&str], progress: &Progress) -> Result<MeshLeaves, StudyError> {
        let note = self.note.clone();
        let Some(finer) = &self.finer else {
            return Ok(MeshLeaves { error: None, note });
        };
        match self.campaign.mesh_error_by(finer, candidates, progress) {
            Ok(error) => Ok(MeshLeaves {
                error: Some(error),
                note,
            }),
            Err(error @ StudyError::Cancelled(_)) => Err(error),
            Err(error) => Ok(MeshLeaves {
                error: None,
                note: Some(not_known("twice as fine", &error)),
            }),
        }
    }
}

fn not_known(mesh: &str, error: &StudyError) -> String {
    format!(
        "What the mesh leaves is not known, and not in any error: on a mesh {mesh} there is no answer ({error})."
    )
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn predictions_of_second_order_are_corrected_to_what_a_mesh_without_end_would_give() {
        // y = 10 + h²
        let [coarser, finer] = [1.0, 0.5].map(|h: f64| DVector::from_element(1, 10.0 + h * h));
        let found = left(&coarser, &finer);
        assert!((coarser[0] + found.correction[0] - 10.0).abs() < 1e-12);
        // as uncertain as the two meshes are apart
        assert!((found.deviation[0].abs() - 0.75).abs() < 1e-12);
    }
}
