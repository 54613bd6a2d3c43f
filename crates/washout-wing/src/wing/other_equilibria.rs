//! Other equilibria of a wing under its load: what it is solved to in other ways. Where there is one equilibrium, all ways lead there.
//!
//! A slack or buckled film can come to rest in several shapes. Which one a solve finds depends then on its way there; the real wing's
//! depends on its history.

use rayon::iter::{IntoParallelIterator, ParallelIterator};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::Loaded;
use crate::input::design::{Accelerator, Coupling, Design, Kinematics, Structure};
use crate::progress::Progress;
use crate::structure::larger;

use super::discretization::{differences, tip_deg};
use super::error::WingError;
use super::model::WingModel;
use super::solved::SolvedWing;

/// Difference of a twist from which on a shape is another one, where both were solved with the same stiffness, deg: a hundred times
/// what a solve leaves by default.
const APART_DEG: f64 = 1e-4;

/// The same where the drilling stiffness of the film was another, as a share of the largest twist, and no less than this, deg.
const APART_BY_DRILLING: f64 = 1e-3;
const LEAST_DEG: f64 = 1e-5;

/// Load increments that are tried.
const INCREMENTS: usize = 10;

/// Factors on the drilling stiffness that are tried.
const DRILLING: [f64; 2] = [0.1, 10.0];

/// A shape in which the wing rests under the same load, and which is not that of the result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct OtherEquilibrium {
    /// What it was solved with, which should change what an answer costs alone: keys of the design with their values.
    pub solved_with: Vec<String>,
    /// Twist at the tip station, deg, positive for washout; absent where it cannot be read.
    pub tip_twist_deg: Option<f64>,
    /// Largest difference of twist to the result at any station, deg.
    pub largest_difference_deg: f64,
}

impl SolvedWing {
    /// The shape that the usual options of the solver lead to, where the design has others and they led to another shape.
    ///
    /// # Errors
    /// If the twist cannot be read, or the user asked to stop; usual options without an answer are no error.
    pub fn with_usual_options(&self, progress: &Progress) -> Result<Option<OtherEquilibrium>, WingError> {
        let mut usual = self.model.design().clone();
        usual.coupling.accelerator = Coupling::default().accelerator;
        usual.structure.load_increments = Structure::default().load_increments;
        usual.structure.drilling_factor = Structure::default().drilling_factor;
        self.solved_otherwise(usual, progress)
    }

    /// Shapes that other options of the solver lead to, each different from the result: another accelerator, load increments, a tenth of
    /// the drilling stiffness and ten times of it. None is no proof that there are none.
    ///
    /// # Errors
    /// As [`SolvedWing::with_usual_options`].
    pub fn other_equilibria(&self, progress: &Progress) -> Result<Vec<OtherEquilibrium>, WingError> {
        let own = self.model.design();
        let changed = |change: &dyn Fn(&mut Design)| {
            let mut design = own.clone();
            change(&mut design);
            design
        };
        let mut designs = vec![
            changed(&|design| {
                design.coupling.accelerator = match own.coupling.accelerator {
                    Accelerator::Newton => Accelerator::Aitken,
                    _ => Accelerator::Newton,
                }
            }),
            changed(&|design| {
                design.structure.load_increments = match own.structure.load_increments {
                    1 => INCREMENTS,
                    _ => 1,
                }
            }),
        ];
        designs.extend(DRILLING.map(|factor| changed(&|design| design.structure.drilling_factor *= factor)));
        let found = designs
            .into_par_iter()
            .map(|design| self.solved_otherwise(design, progress));
        Ok(found
            .collect::<Result<Vec<_>, _>>()?
            .into_iter()
            .flatten()
            .collect())
    }

    /// The same wing with other options of the solver, if they are others and lead to another shape.
    fn solved_otherwise(
        &self,
        design: Design,
        progress: &Progress,
    ) -> Result<Option<OtherEquilibrium>, WingError> {
        let own = self.model.design();
        let solved_with = options(own, &design);
        let may_have_more = own.film.is_some() && own.structure.kinematics == Kinematics::LargeRotation;
        if solved_with.is_empty() || !may_have_more {
            return Ok(None);
        }
        let model = WingModel {
            loaded: Loaded {
                design,
                ..self.model.loaded.clone()
            },
            ..self.model.clone()
        };
        let solved = model.solve(&progress.unseen());
        progress.check()?;
        let Ok(other) = solved else {
            return Ok(None);
        };
        let (profile, found) = (self.profile()?, other.profile()?);
        let largest = differences(&profile, &found).fold(0.0, |largest, (_, off)| larger(largest, off));
        let most = profile
            .readings
            .iter()
            .map(|reading| reading.twist_rad.to_degrees().abs());
        let is_as_stiff = own.structure.drilling_factor == model.design().structure.drilling_factor;
        let apart = match is_as_stiff {
            true => APART_DEG,
            false => (APART_BY_DRILLING * most.fold(0.0, larger)).max(LEAST_DEG),
        };
        Ok((largest > apart).then(|| OtherEquilibrium {
            solved_with,
            tip_twist_deg: tip_deg(&found),
            largest_difference_deg: largest,
        }))
    }
}

/// The options of the solver in which a design differs from another, with its values.
fn options(own: &Design, other: &Design) -> Vec<String> {
    let mut found = Vec::new();
    if own.coupling.accelerator != other.coupling.accelerator {
        let word = toml::Value::try_from(other.coupling.accelerator);
        found.extend(word.ok().map(|word| format!("coupling.accelerator={word}")));
    }
    let numbers = [
        (
            "structure.load_increments",
            own.structure.load_increments as f64,
            other.structure.load_increments as f64,
        ),
        (
            "structure.drilling_factor",
            own.structure.drilling_factor,
            other.structure.drilling_factor,
        ),
    ];
    let others = numbers.iter().filter(|(_, own, other)| own != other);
    found.extend(others.map(|(key, _, other)| format!("{key}={other}")));
    found
}

impl OtherEquilibrium {
    /// What it is, in words.
    pub fn words(&self) -> String {
        let tip = self
            .tip_twist_deg
            .map_or(String::new(), |tip| format!("its tip twists by {tip:.2} deg; "));
        let away = match self.largest_difference_deg {
            large if large >= 0.1 => format!("{large:.1}"),
            small => format!("{small:.0e}"),
        };
        format!(
            "the wing has another equilibrium under the same load, with twist that differs by up to {away} deg ({tip}found with {}): \
             which of them the real wing takes depends on what was done to it before",
            self.solved_with.join(", ")
        )
    }
}
