//! Inertia of the air that moves with the wing.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Effect, Structure, Values};
use crate::structure::Loads;

/// See the module.
#[derive(Debug)]
pub struct AddedMass;

const CARD: Card = Card {
    name: "added-mass",
    family: "inertia",
    summary: "Air that moves with the wing resists its acceleration across itself: of the stroke, of the flip and of the deforming wing.",
    formula: "dF = −s M_air (ü + a), M_air: ρ(π/4)c² per length along the normal; ü deforming, a: sweep and flip at the phase of the design",
    source: "Sedov 1965; Ellington 1984, part II; Sane & Dickinson 2002",
    when_right: "off mid-stroke, where the stroke slows down; at mid-stroke it is the part of twist-dynamics that the air has (do not add both there)",
    gets_wrong: "moments of the moved air about mid-chord; the motion is that of the wing without this effect",
    case: "added_mass_is_that_of_a_cylinder_on_the_chord",
    seam: Seam::Load,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "share of the air of a cylinder on the chord that moves along: 1 is all of it",
        default: 0.0,
        range: [-2.0, 3.0],
        plausible: [0.0, 1.3],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Motion],
    has_switch: false,
};

impl Effect for AddedMass {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn load(&self, values: &Values, wing: &Structure, loads: &mut Loads) {
        let Some(motion) = wing.motion else {
            return;
        };
        for (node, (a, b)) in motion
            .moved_air
            .iter()
            .zip(&motion.moved_air_of_stroke)
            .enumerate()
        {
            loads.force_n[node] += (a.force_n + b.force_n) * values.strength();
            loads.moment_n_m[node] += (a.moment_n_m + b.moment_n_m) * values.strength();
        }
    }
}
