//! A rod sanded thinner toward its tip: an effect that washout does not have.

use washout::effects::{Card, Effect, Parameter, Seam, Structure, Values};
use washout::input::measurement::Channel;
use washout::structure::StructureError;

/// GJ falls linearly along the rod, to (1 − s) of its own at the end.
#[derive(Debug)]
pub struct TaperedRod;

impl Effect for TaperedRod {
    fn card(&self) -> Card<'_> {
        Card {
            name: "tapered-rod",
            family: "rod-torsion",
            summary: "The rod is sanded thinner toward its tip, so that it twists more there.",
            formula: "GJ' = (1 − s ξ) GJ, ξ = distance along the rod over its length",
            source: "definition",
            when_right: "a rod sanded by hand; prefer rod-ends-early if the change is a step",
            gets_wrong: "the thinner rod bends more too, which is left out; s = 1 cannot be",
            case: "the example's own: a torque at the tip twists it by −ln(1 − s)/s times as much there",
            seam: Seam::Structure,
            parameters: &[Parameter {
                name: "strength",
                unit: "1",
                meaning: "share of the torsional stiffness that is missing at the tip",
                default: 0.0,
                range: [0.0, 0.95],
                plausible: [0.0, 0.8],
            }],
            channels: &[
                Channel::Twist,
                Channel::TwistRate,
                Channel::Lift,
                Channel::Drag,
                Channel::Power,
            ],
            needs: &[],
            has_switch: false,
        }
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let rod = wing.rod_elements();
        let length_m = rod.last().map_or(0.0, |(_, [_, end_m])| *end_m);
        for (beam, [from_m, to_m]) in rod {
            let missing = values.strength() * 0.5 * (from_m + to_m) / length_m;
            wing.model
                .change_section(beam, |section| section.soften_torsion(missing / (1.0 - missing)))?;
        }
        Ok(())
    }
}
