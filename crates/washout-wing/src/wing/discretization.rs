//! What the mesh leaves of a result: the same wing on a mesh half as fine.
//!
//! Of an answer that comes nearer in proportion to the size of the elements (order one), the error is the whole difference to the mesh
//! with elements twice as large; of one of order two it is a third of that (Roache, *Perspective: a method for uniform reporting of grid
//! refinement studies*, J. Fluids Eng. 116, 1994). Twist at a film's free tip is of order one or less, so the whole difference is taken.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::observation::TwistProfile;
use crate::progress::Progress;

use super::error::WingError;
use super::model::WingModel;
use super::solved::SolvedWing;

/// Elements of the mesh that is compared with, over those of the own one, in number along a line.
const COARSER: f64 = 0.5;
/// Coarsest and finest meshes that are solved for an estimate (`mesh.refine`).
const REFINE: [f64; 2] = [0.1, 4.0];

/// What the mesh leaves: differences to the wing on a mesh half as fine.
#[derive(Debug, Clone, PartialEq, Default, Serialize, Deserialize, JsonSchema)]
pub struct DiscretizationError {
    /// `mesh.refine` of the coarser mesh.
    pub coarser_refine: Option<f64>,
    /// Error of the twist at the tip station, deg.
    pub tip_twist_deg: Option<f64>,
    /// The largest error of twist at any station, deg.
    pub largest_twist_deg: Option<f64>,
    /// Where that is, mm from the base.
    pub largest_at_mm: Option<f64>,
    /// Error of the lift of one wing as solved, mN.
    pub lift_mn: Option<f64>,
    /// Why it is not known; absent where it is.
    pub unknown_because: Option<String>,
}

/// A wing, and the same on a mesh half as fine; or why there is none.
#[derive(Debug, Clone)]
pub struct Meshes {
    /// The wing.
    pub wing: SolvedWing,
    /// The same on a mesh half as fine.
    pub coarser: Result<SolvedWing, String>,
}

impl Meshes {
    /// The wing on its own mesh, and on one half as fine.
    ///
    /// # Errors
    /// If the wing has no solution, or the user asked to stop; a coarser mesh without one is no error.
    ///
    /// # Example
    /// ```
    /// # use washout_wing as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use washout::{progress::Progress, wing::{Meshes, WingModel}};
    /// let wing = WingModel::open("designs/twist-v1.toml", &["mesh.refine=0.5"])?;
    /// let meshes = Meshes::solve(&wing, &Progress::quiet())?;
    /// assert!(meshes.error()?.tip_twist_deg < Some(0.1));
    /// # Ok::<(), washout::wing::WingError>(())
    /// ```
    pub fn solve(model: &WingModel, progress: &Progress) -> Result<Meshes, WingError> {
        let unseen = progress.unseen();
        let (wing, coarser) = rayon::join(|| model.solve(progress), || model.solve_coarser(&unseen));
        let wing = wing?;
        progress.check()?;
        Ok(Meshes { wing, coarser })
    }

    /// A wing that was solved, and the same on a mesh half as fine.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn of_solved(wing: SolvedWing, progress: &Progress) -> Result<Meshes, WingError> {
        let coarser = wing.model.solve_coarser(progress);
        progress.check()?;
        Ok(Meshes { wing, coarser })
    }

    /// The wing on the first mesh, each twice as fine as the one before, that leaves no more than this share of the tip's twist.
    ///
    /// # Errors
    /// As [`Meshes::solve`], and if no mesh up to `mesh.refine` 4 reaches it.
    pub fn until(model: &WingModel, share: f64, progress: &Progress) -> Result<Meshes, WingError> {
        let mut meshes = Meshes::solve(model, progress)?;
        loop {
            let error = meshes.error()?;
            let (found, tip) = match (error.tip_twist_deg, meshes.wing.tip_twist_deg()?) {
                (Some(found), Some(tip)) => (found, tip),
                _ => {
                    let reason = error.unknown_because;
                    let reason = reason.unwrap_or_else(|| "the twist of the tip cannot be read".to_string());
                    return Err(question(format!("the error of the mesh is not known: {reason}")));
                }
            };
            if found <= share * tip.abs() {
                return Ok(meshes);
            }
            let refine = meshes.wing.model.design().mesh.refine / COARSER;
            // what the finest mesh would leave if the error fell with the square of the elements, which it does at best
            let finer = ((REFINE[1] / refine).log2().floor() + 1.0).max(0.0);
            let at_best = found * COARSER.powf(2.0 * finer);
            if refine > REFINE[1] || at_best > share * tip.abs() {
                return Err(WingError::MeshTooCoarse {
                    design: model.loaded.path.clone(),
                    refine: refine * COARSER,
                    found_percent: 100.0 * found / tip.abs(),
                    asked_percent: 100.0 * share,
                });
            }
            progress.say(format_args!(
                "the mesh leaves {:.2} % of the tip's twist; mesh.refine = {refine}",
                100.0 * found / tip.abs()
            ));
            let finer = model.with("mesh.refine", refine)?.solve(progress)?;
            meshes.coarser = Ok(std::mem::replace(&mut meshes.wing, finer));
        }
    }

    /// What the mesh leaves.
    ///
    /// # Errors
    /// If the instrument of the design cannot see the wing.
    pub fn error(&self) -> Result<DiscretizationError, WingError> {
        let coarser = match &self.coarser {
            Ok(coarser) => coarser,
            Err(reason) => {
                return Ok(DiscretizationError {
                    unknown_because: Some(reason.clone()),
                    ..DiscretizationError::default()
                });
            }
        };
        let (own, other) = (self.wing.profile()?, coarser.profile()?);
        let largest = differences(&own, &other).max_by(|a, b| a.1.total_cmp(&b.1));
        let lift = |wing: &SolvedWing| Ok::<_, WingError>(wing.lift()?.map(|lift| lift.solved.lift_mn));
        Ok(DiscretizationError {
            coarser_refine: Some(coarser.model.design().mesh.refine),
            tip_twist_deg: tip_deg(&own)
                .zip(tip_deg(&other))
                .map(|(own, other)| (own - other).abs()),
            largest_twist_deg: largest.map(|(_, error)| error),
            largest_at_mm: largest.map(|(r_mm, _)| r_mm),
            lift_mn: lift(&self.wing)?
                .zip(lift(coarser)?)
                .map(|(own, other)| (own - other).abs()),
            unknown_because: None,
        })
    }
}

impl SolvedWing {
    /// Twist at the tip station, deg, positive for washout; none where it cannot be read.
    ///
    /// # Errors
    /// As [`SolvedWing::observer`].
    pub fn tip_twist_deg(&self) -> Result<Option<f64>, WingError> {
        Ok(tip_deg(&self.profile()?))
    }
}

impl WingModel {
    /// The wing on a mesh half as fine, solved; or why not.
    fn solve_coarser(&self, progress: &Progress) -> Result<SolvedWing, String> {
        if self.loaded.mesh_file.is_some() {
            return Err("the mesh is from a file".to_string());
        }
        let refine = self.design().mesh.refine * COARSER;
        if refine < REFINE[0] {
            return Err(format!(
                "a mesh half as fine (mesh.refine = {refine}) says nothing"
            ));
        }
        let coarser = self.with("mesh.refine", refine);
        let solved = coarser.and_then(|coarser| coarser.solve(progress));
        solved.map_err(|error| format!("on a mesh half as fine (mesh.refine = {refine}): {error}"))
    }
}

fn question(reason: String) -> WingError {
    WingError::Question {
        question: "--accuracy",
        reason,
    }
}

/// Twist at the tip, deg.
pub(super) fn tip_deg(profile: &TwistProfile) -> Option<f64> {
    profile.tip().map(|reading| reading.twist_rad.to_degrees())
}

/// Differences of twist at each station that both read: where (mm), and how large (deg).
pub(super) fn differences<'a>(
    own: &'a TwistProfile,
    other: &'a TwistProfile,
) -> impl Iterator<Item = (f64, f64)> + 'a {
    own.readings.iter().filter_map(|reading| {
        let same = other.readings.iter().find(|found| found.place == reading.place)?;
        let off = (reading.twist_rad - same.twist_rad).to_degrees().abs();
        Some((1e3 * reading.r_m, off))
    })
}
