//! The effects that there are: those of washout, and those that a program in Rust adds to them.

use std::sync::OnceLock;

use super::error::EffectError;
use super::{
    Effect, added_mass, air_density, amplitude_drag, bend_twist_coupling, broken_spar, camera_perspective,
    camera_tilt, centre_of_pressure_shift, centrifugal_load, coefficient_scale, distributed_mass, drag_scale,
    drive_compliance, film_camber, film_cure_tension, film_slack, film_softening, film_wrinkling,
    finite_span_downwash, frame_timing, gravity, half_rod_shear_centre, inertia_off_mid_stroke,
    inflow_momentum, inflow_uniform, large_rotation, leading_edge_frame, leading_edge_vortex_loss,
    lift_gain_linear, lift_gain_saturating, phase_lag, rod_bending_loss, rod_creep, rod_ends_early,
    rod_shear_modulus, rod_split, rod_torsion_loss, root_bending, root_chord_held, root_flexure,
    rotational_damping, rotational_lift, skin_bending, skin_torsion, skin_yielding, spar_joint_compliance,
    spar_stiffness, stall_shift, stop_backlash, tip_loss_exponential, tip_loss_prandtl, tip_mass,
    twist_dynamics, wagner_lag, warping_restraint,
};

use crate::origin::with_code_of_its_own;

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
    with_code_of_its_own();
    OWN.set(own).map_err(|_| EffectError::RegisteredBefore)
}

/// All that there are, in the order in which they act.
///
/// # Example
/// ```
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
/// let effect = washout::effects::named("root-flexure").expect("in the library");
/// println!("{}: {}", effect.card().name, effect.card().summary);
/// assert!(washout::effects::named("root-flexture").is_none());
/// ```
pub fn named(name: &str) -> Option<&'static dyn Effect> {
    all().find(|effect| effect.card().name == name)
}
