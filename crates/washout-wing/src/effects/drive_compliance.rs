//! A drive that gives under the load of the air, so that the stroke falls short of what it is at rest.

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Dual, Effect, StripPlace, Values};
use crate::aero::{Flow, SectionAir};

/// See the module.
#[derive(Debug)]
pub struct DriveCompliance;

const CARD: Card = Card {
    name: "drive-compliance",
    family: "drive",
    summary: "The drive slows or gives under the load of the air, so that the wing is swept less far the harder it is flapped.",
    formula: "(f Φ)' = f Φ / (1 + s/(1 − s) Q/Q₁), Q/Q₁ = ρ/(1.2 kg/m³) (f Φ / P)²: torque of the untwisted wing over that at the reference P, by blade elements",
    source: "linear speed-torque line of a motor (ω = ω₀ (1 − Q/Q_stall)) or linear spring of a linkage, solved for the loaded stroke with Q of the \
             stated one; Q ∝ ρ (f Φ)²: Ellington 1984, part VI",
    when_right: "amplitude or frequency were set without load or from the command, and not read from the video. Conditions of several f Φ, and thin air, \
                 show it: twist grows slower than (f Φ)² in the one and less than it should fall in the other",
    gets_wrong: "resonance, by which an amplitude may grow with the frequency; how the torque differs between wings (amplitude-drag); inertial loads \
                 and the lift's own stroke, which keep the stated amplitude",
    case: "a_drive_that_gives_sweeps_less_far_by_its_share",
    seam: Seam::Air,
    parameters: &[
        Parameter {
            name: "strength",
            unit: "1",
            meaning: "share of the amplitude that is lost at the reference",
            default: 0.0,
            range: [0.0, 0.95],
            plausible: [0.0, 0.25],
        },
        Parameter {
            name: "reference_hz_deg",
            unit: "Hz deg",
            meaning: "reference P: frequency times half amplitude, in air of 1.2 kg/m³",
            default: 700.0,
            range: [1e-3, 1e6],
            plausible: [100.0, 2000.0],
        },
    ],
    channels: WING_CHANNELS,
    needs: &[Need::Flapping],
    has_switch: false,
};

/// Density of the air at the reference, kg/m³.
const REFERENCE_KG_M3: f64 = 1.2;

impl Effect for DriveCompliance {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn depends_on_stroke(&self) -> bool {
        true
    }

    fn flow(&self, values: &Values, place: &StripPlace, air: &mut SectionAir<Dual>) {
        let Some(Flow::Flapping {
            frequency_hz,
            half_amplitude_rad,
            ..
        }) = place.flow
        else {
            return;
        };
        let speed = frequency_hz * half_amplitude_rad.to_degrees() / values.at(1);
        let torque = place.density_kg_m3 / REFERENCE_KG_M3 * speed * speed;
        let lost = values.strength();
        let left = 1.0 / (1.0 + lost / (1.0 - lost) * torque);
        air.speed_squared *= left * left;
    }
}
