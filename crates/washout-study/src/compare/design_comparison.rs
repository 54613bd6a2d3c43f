//! A design solved and compared with its measurement, alone or against a reference wing.

use std::collections::BTreeMap;

use crate::program::MadeOf;
use crate::progress::Progress;
use crate::wing::{SolvedWing, WingError, WingModel};

use super::comparison::Comparison;
use super::reading::Reading;
use super::reference::ModelledRatios;

/// A design compared with its measurement.
#[derive(Debug)]
pub struct DesignComparison {
    /// The wing, solved.
    pub wing: SolvedWing,
    /// What was read from it.
    pub reading: Reading,
    /// Measured minus modelled.
    pub comparison: Comparison,
    /// The wing against the reference wing, if there is one.
    pub ratios: Option<ModelledRatios>,
    /// What it was made of.
    pub made_of: MadeOf,
}

impl DesignComparison {
    /// Solves a wing, and the reference wing that measured ratios refer to, and compares.
    ///
    /// # Errors
    /// If a wing has no solution or cannot be read, the design names no measurement, or one of the two does not flap.
    ///
    /// # Example
    /// ```
    /// # use washout_study as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// use washout::{compare::DesignComparison, progress::Progress, wing::WingModel};
    ///
    /// let wing = WingModel::open("designs/twist-v1.toml", &["mesh.refine=0.5"])?;
    /// let found = DesignComparison::new(&wing, None, &Progress::quiet())?;
    /// println!("{}", found.comparison.verdict);
    /// # Ok::<(), washout::wing::WingError>(())
    /// ```
    pub fn new(
        wing: &WingModel,
        reference: Option<&WingModel>,
        progress: &Progress,
    ) -> Result<DesignComparison, WingError> {
        if wing.loaded.measurement.is_none() {
            return Err(wing.no_measurement());
        }
        progress.say(format_args!("solving {}", wing.design().name));
        let solved = wing.solve(progress)?;
        let against = reference.map(|reference| ModelledRatios::between(&solved, reference, progress));
        let (ratios, channels) = match against.transpose()? {
            Some((ratios, channels)) => (Some(ratios), channels),
            None => (None, BTreeMap::new()),
        };
        let reading = Reading::of(&solved, &channels)?;
        let comparison = reading.measured.clone().ok_or_else(|| wing.no_measurement())?;
        let files = wing.loaded.files.iter();
        let made_of = MadeOf::files(files.chain(reference.into_iter().flat_map(|own| &own.loaded.files)));
        Ok(DesignComparison {
            wing: solved,
            reading,
            comparison,
            ratios,
            made_of,
        })
    }
}
