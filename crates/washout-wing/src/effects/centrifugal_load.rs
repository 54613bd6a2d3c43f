//! Centrifugal force of the flapping wing's own mass: it pulls the wing straight and turns it flat (propeller moment).

use nalgebra::{Matrix3, Vector3};

use super::card::{Card, Need, Parameter, Seam, WING_CHANNELS};
use super::{Effect, Structure, Values};
use crate::aero::Flow;
use crate::structure::{LinearForce, Loads};

/// See the module.
#[derive(Debug)]
pub struct CentrifugalLoad;

const CARD: Card = Card {
    name: "centrifugal-load",
    family: "inertia",
    summary: "The wing's mass is thrown outward from the flapping axis, which stretches the wing and turns the chord into the plane of motion.",
    formula: "dF = s Ω² ρ(d) dm, Ω = 2πfΦ |cos phase|, ρ(d) from the flapping axis to the deformed place, across the axis",
    source: "rigid-body kinematics; Houbolt & Brooks 1958, NACA Report 1346, for the terms it contains",
    when_right: "always, where mass and speed are known; at mid-stroke the rest of inertia vanishes",
    gets_wrong: "nothing at mid-stroke; away from it the angular acceleration acts too",
    case: "centrifugal_force_of_a_spinning_rod_is_m_omega_squared_r",
    seam: Seam::Load,
    parameters: &[Parameter {
        name: "strength",
        unit: "1",
        meaning: "share of the wing's own centrifugal force: 1 is all of it",
        default: 0.0,
        range: [0.0, 5.0],
        plausible: [0.0, 1.2],
    }],
    channels: WING_CHANNELS,
    needs: &[Need::Flapping],
    has_switch: false,
};

impl Effect for CentrifugalLoad {
    fn card(&self) -> Card<'_> {
        CARD
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
        let rate = std::f64::consts::TAU * frequency_hz * half_amplitude_rad * phase_rad.cos();
        let axis = Vector3::new(0.0, -stop_angle_rad.sin(), stop_angle_rad.cos());
        let across = Matrix3::identity() - axis * axis.transpose();
        let mut own = wing.model.lumped_mass_kg();
        for mass in &wing.model.masses {
            own[mass.node] -= mass.mass_kg;
        }
        let own = own.into_iter().enumerate();
        let own = own.map(|(node, mass_kg)| (node, Vector3::zeros(), mass_kg));
        let carried = wing.model.masses.iter();
        let carried = carried.map(|mass| (mass.node, mass.arm_m, mass.mass_kg));
        for (node, arm_m, mass_kg) in own.chain(carried) {
            let gradient_n_m = across * (values.strength() * rate * rate * mass_kg);
            let from_axis_m = wing.model.nodes[node] + arm_m + Vector3::new(root_offset_m, 0.0, 0.0);
            loads.linear.push(LinearForce {
                node,
                arm_m,
                force_n: gradient_n_m * from_axis_m,
                gradient_n_m,
            });
        }
    }
}
