//! A mass at the tip that the model does not know: glue, a marker, a sensor.

use super::card::{Card, Need, Parameter, STRUCTURE_CHANNELS, Seam};
use nalgebra::Vector3;

use super::{Effect, Structure, Values};
use crate::geometry::Planform;
use crate::structure::{PointMass, StructureError};

/// See the module.
#[derive(Debug)]
pub struct TipMass;

const CARD: Card = Card {
    name: "tip-mass",
    family: "mass",
    summary: "Something at the tip weighs: glue, a marker, a sensor.",
    formula: "m = s × the wing's own mass, on a rigid arm at the tip",
    source: "definition; a reflective marker of 3 mm weighs 5 to 20 mg",
    when_right: "markers and repairs; it shows under gravity, under centrifugal load and in frequencies",
    gets_wrong: "the size of the mass: it has no inertia about its own centre",
    case: "a_mass_at_the_tip_pulls_with_its_weight",
    seam: Seam::Structure,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "mass over the wing's own, of which more than a fifth is no marker and no repair",
            default: 0.0,
            range: [0.0, 100.0],
            plausible: [0.0, 0.2],
        },
        Parameter {
            name: "chord",
            unit: "1",
            meaning: "place behind the leading edge, in mean chords",
            default: 0.0,
            range: [-2.0, 2.0],
            plausible: [0.0, 1.0],
        },
    ],
    channels: STRUCTURE_CHANNELS,
    needs: &[Need::Gravity],
    has_switch: false,
};

impl Effect for TipMass {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn set_on_example(&self) -> &'static [&'static str] {
        &["effects.centrifugal-load.strength=1"]
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let own_kg: f64 = wing.model.lumped_mass_kg().iter().sum();
        let Some(&node) = wing.mesh.rod_nodes().last() else {
            return Ok(());
        };
        let chord_m = Planform::from_design(wing.design).map_or(0.0, |planform| planform.mean_chord_m());
        let place_m = Vector3::y() * (values.at(1) * chord_m - wing.model.nodes[node].y);
        wing.model.masses.push(PointMass {
            node,
            arm_m: place_m,
            mass_kg: values.strength() * own_kg,
            inertia_kg_m2: Vector3::zeros(),
        });
        Ok(())
    }
}
