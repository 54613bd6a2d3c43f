//! Physics that a model may lack: one file per effect, each off until it is added.
//!
//! An effect is a card ([`Card`]) and a function at one of a few seams. Its first number is its strength: 0 is off, bit
//! for bit. It adds or scales, and never overwrites. To add one: write its file, and name it in [`ALL`].

pub mod bind;

pub mod card;

pub mod custom;

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

pub use bind::{Acting, Bound, acting, bind, instead_of, is_applicable, lacks, with_common_numbers};
pub use card::{Card, Need, Parameter, Places, Seam};
pub use error::EffectError;
pub use library::{ALL, all, named, register};
pub use seam::{Dual, Motion, MotionNumbers, NodeLoad, StripMotion, StripPlace, Structure, Values, View};

/// How well the change that most effects make is known, as a share of it: between two models of one wing that share no code slopes were 0.98
/// (root flexure), 0.95 (tip loss), 1.04 (torsion lost outboard) and 1.07 (rod ends early).
pub const OWN_ERROR: f64 = 0.05;

use crate::aero::{SectionAir, SectionCoefficients};
use crate::input::Design;
use crate::structure::{Loads, StructureError};

/// One effect. Each acts at the one seam that its card names; the other methods stay as they are, but for an effect on the wing that the
/// picture shows in another place, too ([`Effect::view`]).
pub trait Effect: Sync + Send + std::fmt::Debug {
    /// What it says about itself.
    fn card(&self) -> Card<'_>;

    /// Where it may sit, if that is not known.
    fn places(&self) -> Option<Places> {
        None
    }

    /// How well the change that it makes is known, as a share of that change: two models of one wing that share no code differ by that
    /// much in their answer to it.
    fn own_error(&self) -> f64 {
        OWN_ERROR
    }

    /// Key of a design that it is an error of: where a study states how uncertain that is, it has said so itself.
    fn is_error_of(&self) -> Option<&'static str> {
        None
    }

    /// Numbers that all wings of a study have in common, by what the first of them is made of: a mount is the same for all. Those that a
    /// table states stand.
    ///
    /// # Errors
    /// If a section of the first wing is none.
    fn common_numbers(&self, _first: &Design) -> Result<Vec<(&'static str, f64)>, StructureError> {
        Ok(Vec::new())
    }

    /// Whether it is there with its plausible size or not at all, so that a diagnosis fits no strength between.
    fn is_all_or_none(&self) -> bool {
        false
    }

    /// Whether phase, amplitude or frequency of the stroke matter to it by themselves, and not by the speed of the air alone.
    fn depends_on_stroke(&self) -> bool {
        false
    }

    /// Whether it is of the picture and not of the flight, so that a diagnosis tries it where a camera reads, and means over the stroke know
    /// nothing of it.
    fn is_of_picture(&self) -> bool {
        false
    }

    /// Whether it acts by a moment, or by where the force of the air attacks, alone: lift and drag of a section that does not move know nothing
    /// of it.
    fn is_of_moment(&self) -> bool {
        false
    }

    /// Changes sections, sheets, joints or supports.
    ///
    /// # Errors
    /// If a changed section is none.
    fn structure(&self, _values: &Values, _wing: &mut Structure) -> Result<(), StructureError> {
        Ok(())
    }

    /// Changes the angle and the speed at which a strip meets the air.
    fn flow(&self, _values: &Values, _place: &StripPlace, _air: &mut SectionAir<Dual>) {}

    /// Changes the coefficients, the centre of pressure, or adds force and moment.
    fn coefficients(
        &self,
        _values: &Values,
        _place: &StripPlace,
        _air: &SectionAir<Dual>,
        _now: &mut SectionCoefficients<Dual>,
    ) {
    }

    /// Adds loads to nodes.
    fn load(&self, _values: &Values, _wing: &Structure, _loads: &mut Loads) {}

    /// Changes how a picture of the wing is taken.
    fn view(&self, _values: &Values, _design: &Design, _view: &mut View) {}

    /// Numbers of the motion over the stroke, if it states them.
    fn motion(&self, _values: &Values) -> Option<MotionNumbers> {
        None
    }

    /// Share of large rotation in a linear model.
    fn kinematics(&self, _values: &Values) -> Option<f64> {
        None
    }
}
