//! The effects that there are: those of washout, and those that a program in Rust adds to them.

use std::sync::OnceLock;

use super::error::EffectError;
use super::{ALL, Effect};

static OWN: OnceLock<Vec<&'static dyn Effect>> = OnceLock::new();

/// Adds effects of a program's own behind those of washout: designs, studies, diagnoses and the command line know them from then
/// on. Once, and before the first design is read.
///
/// # Errors
/// If a name is taken, or effects were added before.
pub fn register(own: Vec<&'static dyn Effect>) -> Result<(), EffectError> {
    for (place, effect) in own.iter().enumerate() {
        let name = effect.card().name;
        let before = own[..place].iter().chain(ALL);
        if before.into_iter().any(|known| known.card().name == name) {
            return Err(EffectError::NameTaken {
                name: name.to_string(),
            });
        }
    }
    OWN.set(own).map_err(|_| EffectError::RegisteredBefore)
}

/// Whether a program has added effects of its own, so that it computes with code that is not washout's.
pub fn others_are_registered() -> bool {
    OWN.get().is_some()
}

/// All that there are, in the order in which they act.
///
/// # Example
/// ```
/// # use washout_wing as washout;
/// // physics that a stiff wing on the bench can lack: what needs no air
/// let on_a_bench = washout::effects::all().filter(|effect| effect.card().needs.is_empty()).count();
/// assert!(on_a_bench > 5);
/// ```
pub fn all() -> impl Iterator<Item = &'static dyn Effect> {
    ALL.iter().chain(OWN.get().into_iter().flatten()).copied()
}

/// The effect of a name.
///
/// # Example
/// ```
/// # use washout_wing as washout;
/// let effect = washout::effects::named("root-flexure").expect("in the library");
/// println!("{}: {}", effect.card().name, effect.card().summary);
/// assert!(washout::effects::named("root-flexture").is_none());
/// ```
pub fn named(name: &str) -> Option<&'static dyn Effect> {
    all().find(|effect| effect.card().name == name)
}
