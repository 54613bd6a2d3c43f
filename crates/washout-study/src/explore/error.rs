//! Why a search gives nothing.

use std::error::Error;

use crate::coupling::CouplingError;
use crate::input::InputError;
use crate::lift::LiftError;
use crate::progress::Cancelled;
use crate::wing::WingError;

/// A search that cannot be made.
#[derive(Debug, thiserror::Error)]
pub enum ExploreError {
    /// A setting out of its range.
    #[error("{name} = {value}: {cure}")]
    Setting {
        /// What it is.
        name: &'static str,
        /// Its value.
        value: f64,
        /// What it may be.
        cure: &'static str,
    },
    /// The lift model refuses a wing.
    #[error(transparent)]
    Lift(#[from] LiftError),
    /// The air or a wing cannot be set up or solved.
    #[error(transparent)]
    Coupling(#[from] CouplingError),
    /// A changed design is refused.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A changed design makes no wing, or one whose twist cannot be read.
    #[error("{0}")]
    Design(Box<dyn Error + Send + Sync>),
    /// The wing without twist lifts nothing, or nothing that is a number.
    #[error(
        "the wing without twist has a mean lift of {lift_n} N and an efficiency of {efficiency}: nothing to compare with; give it \
         a stroke, and effects that are defined where there is no twist"
    )]
    NoBase {
        /// Mean lift, N.
        lift_n: f64,
        /// Efficiency.
        efficiency: f64,
    },
    /// Nothing measured to fit to.
    #[error(
        "no wing has a measured effective lift coefficient to fit the shape factor to; name designs whose measurement has \
         rows of channel effective_lift_ratio, or give its strength with --gain-strength"
    )]
    NothingToFit,
    /// A gain of lift that a wing without twist has too, or that no twist makes.
    #[error(
        "{effect} does not change the lift of any of the measured wings; choose an effect that grows with twist"
    )]
    NoGain {
        /// Name of the effect.
        effect: String,
    },
    /// No layout has an equilibrium.
    #[error(
        "no layout of these rods has an equilibrium that was found; add stiffer rods, or lower the amplitude"
    )]
    NoLayout,
    /// No layout lifts enough.
    #[error(
        "no layout of these rods lifts {wanted_mn} mN at this stroke; the most is {most_mn:.2} mN, of {layout}; ask for less, add \
         stiffer rods, or raise frequency or amplitude"
    )]
    NotLifted {
        /// What was asked for, mN.
        wanted_mn: f64,
        /// The most that was found, mN.
        most_mn: f64,
        /// Its layout.
        layout: String,
    },
    /// The user asked to stop.
    #[error(transparent)]
    Cancelled(#[from] Cancelled),
}

impl From<WingError> for ExploreError {
    fn from(error: WingError) -> ExploreError {
        match error {
            WingError::Input(error) => error.into(),
            WingError::Solve { source, .. } | WingError::Phase { source, .. } => source.into(),
            WingError::Interrupted(cancelled) => cancelled.into(),
            WingError::Design { reason, .. } => ExploreError::Design(reason),
            error => ExploreError::Design(Box::new(error)),
        }
    }
}
