//! Why a coupled solve gives no solution.

use std::fmt;

use crate::aero::AeroError;
use crate::effects::EffectError;
use crate::input::InputError;
use crate::mesh::MeshError;
use crate::progress::Cancelled;
use crate::structure::{NotFinite, StructureError};

/// Why a coupled solve gives no solution.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum CouplingError {
    /// An effect is made from the motion over the stroke, which was not given.
    #[error("{effect} is made from the motion over the stroke, which is not known here")]
    NeedsMotion {
        /// The effect.
        effect: String,
    },
    /// The air cannot be set up.
    #[error(transparent)]
    Air(#[from] AeroError),
    /// An effect's table is at fault.
    #[error(transparent)]
    Effect(Box<EffectError>),
    /// The structure cannot be set up, or finds no equilibrium.
    #[error(transparent)]
    Structure(StructureError),
    /// The wing stands beyond its divergence.
    #[error(
        "beyond divergence: the air's moment grows faster with twist than the structure's; the critical dynamic \
         pressure is about {:.3} times that of the design. Lower the speed or the amplitude, stiffen the rod in torsion, \
         or move the spars so that the load acts behind the axis; `washout divergence` shows the way there{}",
        critical_ratio, film_hint(*.linear_film)
    )]
    Diverged {
        /// Critical dynamic pressure over that of the design.
        critical_ratio: f64,
        /// Whether a film stands in linear kinematics, where little pre-tension looks like divergence.
        linear_film: bool,
    },
    /// The pitch stop, which only pushes, would have to pull.
    #[error(
        "the pitch stop would have to pull with {:.3} mN mm, but it only pushes: the wing would leave it, and this is no \
         equilibrium. Turn the load or the bench forces the other way, or give the pitch stiffness of a flexure in [root]",
        moment_n_m * 1e6
    )]
    StopPulls {
        /// Moment with which it would pull.
        moment_n_m: f64,
    },
    /// The wing has an equilibrium, but not one that it would stay in.
    #[error(
        "not stable: the loaded shape is an equilibrium, but with {negative_pivots} negative pivots of its tangent, so the \
         real wing would leave it. Where a load presses along the rod or the film they buckle: lower the load (speed, \
         amplitude or bench forces), stiffen what is pressed, or add a small force across it, which leads to the buckled \
         shape; else try structure.load_increments = 10"
    )]
    Unstable {
        /// Negative pivots of the tangent: directions in which the shape would run away.
        negative_pivots: usize,
    },
    /// The iteration did not converge.
    #[error(
        "not converged after {iterations} iterations (coupling.max_iterations = {allowed}): the twist still changes by \
         {twist_change_deg:.2e} deg, residual {residual:.2e}. {cure}"
    )]
    OutOfPatience {
        /// Iterations made.
        iterations: usize,
        /// Iterations allowed.
        allowed: usize,
        /// Last change of twist, deg.
        twist_change_deg: f64,
        /// Coupled residual relative to the load.
        residual: f64,
        /// What to try, of what is not in use.
        cure: String,
    },
    /// Nothing was found, and the load is far beyond what rods or film stand.
    #[error("no equilibrium was found: {0}")]
    Overloaded(Overload),
    /// A load, a stiffness or a result that is not finite: such a wing has no equilibrium, whatever its residual says.
    #[error("{found}; {cure}")]
    NotFinite {
        /// What and where.
        found: NotFinite,
        /// What to do, with the effect that it comes with if one is at fault.
        cure: String,
    },
    /// A trial that Newton's method did not settle.
    #[error("given up after {steps} Newton steps: too far from the last solution for a trial")]
    GivenUp {
        /// Newton steps made.
        steps: usize,
    },
    /// There is no periodic motion over the stroke.
    #[error(
        "no periodic motion over the stroke: {reason}; leave out the effects that need it (washout effects)"
    )]
    NoPeriodic {
        /// Why.
        reason: &'static str,
    },
    /// The user asked to stop.
    #[error(transparent)]
    Interrupted(#[from] Cancelled),
}

/// What a load would turn too far if the wing stayed as stiff as it is at rest.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Overload {
    /// Whether a rod or spar turns so, as opposed to a film beside them.
    pub is_rod: bool,
    /// Whether it is the bench loads that turn it, as opposed to the air.
    pub is_by_bench: bool,
    /// Turn to first order, rad.
    pub turn_rad: f64,
    /// Station where it is largest, m.
    pub r_m: f64,
}

impl fmt::Display for Overload {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        let Overload { turn_rad, r_m, .. } = self;
        let (r_mm, turn) = (1e3 * r_m, turn_rad.round());
        let lower = if self.is_by_bench {
            "Check the number and the unit of the bench load"
        } else {
            "Lower the speed or the amplitude"
        };
        if self.is_rod {
            write!(
                f,
                "the rods are far too weak for the load. If they stayed as stiff as they are at rest, it would turn them by {turn} rad at \
                 r = {r_mm:.1} mm. {lower}, or make the rods thicker"
            )
        } else {
            write!(
                f,
                "the film has no spars and flies as a flag, with many shapes near equilibrium: next to nothing but its own bending holds \
                 it. If it stayed as stiff as it is at rest, the load would turn it by {turn} rad at r = {r_mm:.1} mm. Add spars, or make the \
                 film thicker"
            )
        }
    }
}

/// Why a sensitivity is not found.
#[derive(Debug, Clone, PartialEq, thiserror::Error)]
pub enum SensitivityError {
    /// The design has no such number.
    #[error(
        "{key}: no number stands there. Give the dotted key of a number, such as flapping.half_amplitude_deg"
    )]
    NoNumber {
        /// The key.
        key: String,
    },
    /// The design refuses values beside the present one.
    #[error(transparent)]
    Input(#[from] InputError),
    /// A design beside the present one cannot be meshed.
    #[error(transparent)]
    Mesh(#[from] MeshError),
    /// The mesh of a design beside the present one has other elements.
    #[error(
        "{key}: the mesh changes its pattern with it, so there is no derivative. Give the wing a mesh file"
    )]
    OtherPattern {
        /// The key.
        key: String,
    },
    /// The wing cannot be set up.
    #[error(transparent)]
    Coupling(#[from] CouplingError),
    /// The coupled tangent is singular: the wing stands at its divergence.
    #[error(
        "the coupled tangent is singular: the wing stands at its divergence. Lower the speed or the amplitude"
    )]
    Singular,
}

impl From<StructureError> for SensitivityError {
    fn from(error: StructureError) -> Self {
        SensitivityError::Coupling(error.into())
    }
}

impl From<EffectError> for CouplingError {
    fn from(error: EffectError) -> Self {
        CouplingError::Effect(Box::new(error))
    }
}

impl From<StructureError> for CouplingError {
    fn from(error: StructureError) -> Self {
        match error {
            StructureError::Interrupted(cancelled) => CouplingError::Interrupted(cancelled),
            StructureError::NotFinite(found) => found.into(),
            other => CouplingError::Structure(other),
        }
    }
}

impl CouplingError {
    /// Whether the equations had no solution that could be found, as opposed to an input at fault or an interruption.
    pub fn is_not_converged(&self) -> bool {
        match self {
            CouplingError::Diverged { .. }
            | CouplingError::Unstable { .. }
            | CouplingError::OutOfPatience { .. }
            | CouplingError::Overloaded(_)
            | CouplingError::NotFinite { .. }
            | CouplingError::GivenUp { .. }
            | CouplingError::NoPeriodic { .. } => true,
            CouplingError::Structure(error) => {
                matches!(
                    error,
                    StructureError::NoEquilibrium { .. } | StructureError::Singular { .. }
                )
            }
            CouplingError::Air(_)
            | CouplingError::Effect(_)
            | CouplingError::NeedsMotion { .. }
            | CouplingError::StopPulls { .. }
            | CouplingError::Interrupted(_) => false,
        }
    }
}

fn film_hint(linear_film: bool) -> &'static str {
    if linear_film {
        ". Or it is no divergence: in linear kinematics a film with little pre-tension sags by many chords; set \
         structure.kinematics = \"large-rotation\", or raise film.pretension_n_per_m"
    } else {
        ""
    }
}
