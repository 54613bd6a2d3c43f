//! What an effect is: a card, and a function at the one place of the solver where it acts.

use crate::aero::{SectionAir, SectionCoefficients};
use crate::input::Design;
use crate::structure::{Loads, StructureError};

use super::card::{Card, Places};
use super::seam::{Dual, MotionNumbers, StripPlace, Structure, Values, View};

/// How well the change that most effects make is known, as a share of it: between two models of one wing that share no code slopes were 0.98
/// (root flexure), 0.95 (tip loss), 1.04 (torsion lost outboard) and 1.07 (rod ends early).
pub const OWN_ERROR: f64 = 0.05;

/// One effect. Each acts at the one seam that its card names, by the function for it: `Structure` by [`Effect::structure`], `Air` by
/// [`Effect::flow`] and [`Effect::coefficients`], `Load` by [`Effect::load`], `Kinematics` by [`Effect::kinematics`], `Picture` by
/// [`Effect::view`]. No other is called, but for an effect on the wing that the
/// picture shows in another place, too ([`Effect::view`]), and for [`Effect::motion`].
pub trait Effect: Sync + Send + std::fmt::Debug {
    /// What it says about itself.
    fn card(&self) -> Card<'_>;

    /// Where it may sit, if that is not known.
    fn places(&self) -> Option<Places> {
        None
    }

    /// What is set on the wing of `washout init` for a picture of what it does, `KEY=VALUE`: else it would have nothing to act on there.
    fn set_on_example(&self) -> &'static [&'static str] {
        &[]
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

    /// What its strength is on this wing as something that a bench measures: the number, and its unit with what it is.
    fn stands_for(&self, _values: &Values, _design: &Design) -> Option<(f64, &'static str)> {
        None
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
