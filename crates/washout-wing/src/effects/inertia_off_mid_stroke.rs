//! Inertia of the wing's own mass against the speeding up and slowing down of the stroke, off mid-stroke.

use nalgebra::Vector3;

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Effect, Structure, Values};
use crate::aero::Flow;
use crate::structure::Loads;

/// See the module.
#[derive(Debug)]
pub struct InertiaOffMidStroke;

const CARD: Card = Card {
    name: "inertia-off-mid-stroke",
    family: "inertia",
    summary: "Off mid-stroke the stroke slows down (before it: speeds up), and the mass of the wing bends and twists it onward.",
    formula: "dF = −s Φ ω² sin(phase) (r + r₀) dm, along the stroke; phase 0 is mid-stroke",
    source: "rigid-body kinematics of a sinusoidal stroke",
    when_right: "twist is read off mid-stroke; with centrifugal-load it is all of the inertia of a rigid wing at its stop",
    gets_wrong: "the flip between the stops, and deforming: see twist-dynamics",
    case: "a_slowing_stroke_throws_the_wing_forward",
    seam: Seam::Load,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "share of the wing's own inertia: 1 is all of it",
        default: 0.0,
        range: [-2.0, 5.0],
        plausible: [0.0, 1.2],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::OffMidStroke],
    has_switch: false,
};

impl Effect for InertiaOffMidStroke {
    fn card(&self) -> Card<'_> {
        CARD
    }

    fn set_on_example(&self) -> &'static [&'static str] {
        &["flapping.phase_deg=20"]
    }

    fn load(&self, values: &Values, wing: &Structure, loads: &mut Loads) {
        let Some(Flow::Flapping {
            frequency_hz,
            half_amplitude_rad,
            stop_angle_rad,
            root_offset_m,
            phase_rad,
        }) = Flow::from_design(wing.design)
        else {
            return;
        };
        // the frame of the other half-stroke mirrors the first
        let phase_rad = phase_rad - (phase_rad / std::f64::consts::PI).round() * std::f64::consts::PI;
        let rate = std::f64::consts::TAU * frequency_hz;
        let acceleration = half_amplitude_rad * rate * rate * phase_rad.sin();
        let along = Vector3::new(0.0, stop_angle_rad.cos(), stop_angle_rad.sin());
        for (node, mass_kg) in wing.model.lumped_mass_kg().into_iter().enumerate() {
            let arm_m = wing.model.nodes[node].x + root_offset_m;
            loads.force_n[node] -= along * (values.strength() * mass_kg * acceleration * arm_m);
        }
    }
}
