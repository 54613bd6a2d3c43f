//! Physics that a model may lack: one file per effect, each off until it is added.
//!
//! An effect is a card ([`Card`]) and a function at one of a few seams. Its first number is its strength: 0 is off, bit
//! for bit. It adds or scales, and never overwrites. To add one: write its file, with its test, and name it here twice: as a module and in
//! [`ALL`].

pub mod bind;

pub mod card;

pub mod custom;

pub mod effect;

pub mod error;

pub mod library;

pub mod seam;

pub mod centrifugal_load;

pub mod twist_dynamics;

pub mod added_mass;

pub mod inertia_off_mid_stroke;

pub mod rod_shear_modulus;

pub mod rod_creep;

pub mod rotational_lift;

pub mod rotational_damping;

pub mod amplitude_drag;

pub mod drive_compliance;

pub mod phase_lag;

pub mod wagner_lag;

pub mod inflow_uniform;

pub mod inflow_momentum;

pub mod finite_span_downwash;

pub mod stall_shift;

pub mod film_camber;

pub mod coefficient_scale;

pub mod drag_scale;

pub mod lift_gain_linear;

pub mod lift_gain_saturating;

pub mod leading_edge_vortex_loss;

pub mod centre_of_pressure_shift;

pub mod gravity;

pub mod stop_backlash;

pub mod half_rod_shear_centre;

pub mod warping_restraint;

pub mod bend_twist_coupling;

pub mod skin_bending;

pub mod skin_yielding;

pub mod skin_torsion;

pub mod leading_edge_frame;

pub mod rod_ends_early;

pub mod rod_split;

pub mod rod_torsion_loss;

pub mod rod_bending_loss;

pub mod root_flexure;

pub mod root_stiffening;

pub mod root_bending;

pub mod root_chord_held;

pub mod spar_stiffness;

pub mod spar_joint_compliance;

pub mod broken_spar;

pub mod film_softening;

pub mod film_wrinkling;

pub mod film_slack;

pub mod film_cure_tension;

pub mod tip_mass;

pub mod distributed_mass;

pub mod large_rotation;

pub mod tip_loss_prandtl;

pub mod tip_loss_exponential;

pub mod air_density;

pub mod camera_perspective;

pub mod camera_tilt;

pub mod frame_timing;

pub use bind::{
    Acting, Bound, acting, bind, instead_of, is_applicable, lacks, stands_for, with_common_numbers,
};
pub use card::{Card, Need, Parameter, Places, Seam};
pub use effect::{Effect, OWN_ERROR};
pub use error::EffectError;
pub use library::{all, named, others_are_registered, register};
pub use seam::{Dual, Motion, MotionNumbers, NodeLoad, StripMotion, StripPlace, Structure, Values, View};

/// Every effect of washout, in the order in which they act.
pub static ALL: &[&dyn Effect] = &[
    &rod_shear_modulus::RodShearModulus,
    &rod_creep::RodCreep,
    &half_rod_shear_centre::HalfRodShearCentre,
    &warping_restraint::WarpingRestraint,
    &bend_twist_coupling::BendTwistCoupling,
    &skin_bending::SkinBending,
    &skin_yielding::SkinYielding,
    &skin_torsion::SkinTorsion,
    &leading_edge_frame::LeadingEdgeFrame,
    &rod_ends_early::RodEndsEarly,
    &rod_split::RodSplit,
    &rod_torsion_loss::RodTorsionLoss,
    &rod_bending_loss::RodBendingLoss,
    &root_flexure::RootFlexure,
    &root_stiffening::RootStiffening,
    &root_bending::RootBending,
    &root_chord_held::RootChordHeld,
    &spar_stiffness::SparStiffness,
    &spar_joint_compliance::SparJointCompliance,
    &broken_spar::BrokenSpar,
    &film_softening::FilmSoftening,
    &film_wrinkling::FilmWrinkling,
    &film_slack::FilmSlack,
    &film_cure_tension::FilmCureTension,
    &tip_mass::TipMass,
    &distributed_mass::DistributedMass,
    &large_rotation::LargeRotation,
    &amplitude_drag::AmplitudeDrag,
    &drive_compliance::DriveCompliance,
    &phase_lag::PhaseLag,
    &frame_timing::FrameTiming,
    &wagner_lag::WagnerLag,
    &inflow_uniform::InflowUniform,
    &inflow_momentum::InflowMomentum,
    &finite_span_downwash::FiniteSpanDownwash,
    &stall_shift::StallShift,
    &film_camber::FilmCamber,
    &coefficient_scale::CoefficientScale,
    &drag_scale::DragScale,
    &lift_gain_linear::LiftGainLinear,
    &lift_gain_saturating::LiftGainSaturating,
    &leading_edge_vortex_loss::LeadingEdgeVortexLoss,
    &centre_of_pressure_shift::CentreOfPressureShift,
    &tip_loss_prandtl::TipLossPrandtl,
    &tip_loss_exponential::TipLossExponential,
    &rotational_lift::RotationalLift,
    &rotational_damping::RotationalDamping,
    &air_density::AirDensity,
    &centrifugal_load::CentrifugalLoad,
    &twist_dynamics::TwistDynamics,
    &added_mass::AddedMass,
    &inertia_off_mid_stroke::InertiaOffMidStroke,
    &gravity::Gravity,
    &stop_backlash::StopBacklash,
    &camera_perspective::CameraPerspective,
    &camera_tilt::CameraTilt,
];
