//! Effects that make one number of a wing not finite, by the seams that every effect has.

use nalgebra::{Matrix3, Vector3};
use num_dual::DualNum;
use washout::aero::{SectionAir, SectionCoefficients};
use washout::effects::{Card, Dual, Effect, Parameter, Seam, StripPlace, Structure, Values};
use washout::structure::{
    ArmForce, BeamTwist, LinearForce, Loads, PointMass, Spring, Stiffening, StructureError,
};

/// What is poisoned on a strip, and how its name begins in what is said.
pub const AIR: [&str; 8] = [
    "the angle of attack",
    "the speed",
    "the lift coefficient",
    "the drag coefficient",
    "the centre of pressure",
    "the moment",
    "the normal force",
    "the change of force with the shape",
];

/// The same of the structure and of its loads.
pub const WING: [&str; 11] = [
    "the force (N) on the wing",
    "the moment (N·m) on the wing",
    "the force (N) of the force on an arm",
    "the change of force (N/m)",
    "the twist without torque",
    "the compliance",
    "Young's modulus",
    "the stiffness (N·m/rad) of the spring",
    "the mass (kg)",
    "the mass per length",
    "the density",
];

const PARAMETERS: &[Parameter] = &[
    Parameter {
        name: "strength",
        unit: "1",
        meaning: "the strength",
        default: 0.0,
        range: [-1.0, 1.0],
        plausible: [0.0, 1.0],
    },
    Parameter {
        name: "kind",
        unit: "1",
        meaning: "what is poisoned",
        default: 0.0,
        range: [0.0, 100.0],
        plausible: [0.0, 100.0],
    },
    Parameter {
        name: "beyond",
        unit: "deg",
        meaning: "twist from which on it acts",
        default: -1e3,
        range: [-1e3, 1e3],
        plausible: [0.0, 100.0],
    },
];

fn card(name: &'static str, seam: Seam) -> Card<'static> {
    Card {
        name,
        family: name,
        summary: "",
        formula: "",
        source: "",
        when_right: "",
        gets_wrong: "",
        case: "",
        seam,
        parameters: PARAMETERS,
        channels: &[],
        needs: &[],
        has_switch: false,
    }
}

/// On the strips of the outer half.
#[derive(Debug)]
pub struct PoisonedAir;

impl PoisonedAir {
    fn acts(values: &Values, place: &StripPlace, alpha: f64) -> bool {
        let twist_deg = (place.root_angle_rad - alpha).to_degrees();
        place.r_m > 0.5 * place.tip_m && twist_deg > values.at(2)
    }
}

impl Effect for PoisonedAir {
    fn card(&self) -> Card<'_> {
        card("poisoned-air", Seam::Air)
    }

    fn flow(&self, values: &Values, place: &StripPlace, air: &mut SectionAir<Dual>) {
        if !PoisonedAir::acts(values, place, air.alpha.re) {
            return;
        }
        match values.at(1) as usize {
            0 => air.alpha *= f64::NAN,
            1 => air.speed_squared *= f64::NAN,
            _ => {}
        }
    }

    fn coefficients(
        &self,
        values: &Values,
        place: &StripPlace,
        air: &SectionAir<Dual>,
        now: &mut SectionCoefficients<Dual>,
    ) {
        if !PoisonedAir::acts(values, place, air.alpha.re) {
            return;
        }
        let none = f64::NAN * values.strength();
        match values.at(1) as usize {
            2 => now.cl *= none,
            3 => now.cd += f64::INFINITY,
            4 => now.centre_of_pressure *= none,
            5 => now.moment_n += none,
            6 => now.normal_n_per_m += none,
            // no force, but an infinite slope
            7 => now.normal_n_per_m += ((air.alpha - air.alpha.re) * (air.alpha - air.alpha.re)).sqrt(),
            _ => {}
        }
    }
}

/// On the structure and its loads, in the middle of the rod.
#[derive(Debug)]
pub struct PoisonedWing;

impl Effect for PoisonedWing {
    fn card(&self) -> Card<'_> {
        card("poisoned-wing", Seam::Structure)
    }

    fn structure(&self, values: &Values, wing: &mut Structure) -> Result<(), StructureError> {
        let rod = wing.rod_elements();
        let (beam, _) = rod[rod.len() / 2];
        let node = wing.model.beams[beam].nodes[0];
        match values.at(1) as usize {
            5 => wing
                .model
                .change_section(beam, |section| section.compliance[(3, 3)] = f64::NAN)?,
            6 => wing.model.sheets[0].e_pa = f64::NAN,
            7 => wing.model.springs.push(Spring {
                node,
                displacement_n_m: [0.0; 3],
                rotation_n_m_rad: [f64::INFINITY, 0.0, 0.0],
                stiffening: Stiffening::NONE,
            }),
            8 => wing.model.masses.push(PointMass {
                node,
                arm_m: Vector3::zeros(),
                mass_kg: f64::NAN,
                inertia_kg_m2: Vector3::zeros(),
            }),
            9 => wing
                .model
                .change_section(beam, |section| section.mass_kg_m = f64::NAN)?,
            10 => wing.model.sheets[0].density_kg_m3 = f64::INFINITY,
            _ => {}
        }
        Ok(())
    }

    fn load(&self, values: &Values, wing: &Structure, loads: &mut Loads) {
        let rod = wing.rod_elements();
        let (beam, _) = rod[rod.len() / 2];
        let node = wing.model.beams[beam].nodes[0];
        let none = Vector3::new(0.0, f64::NAN, 0.0);
        match values.at(1) as usize {
            0 => loads.force_n[node] += none,
            1 => loads.moment_n_m[node] += none,
            2 => loads.arms.push(ArmForce {
                node,
                arm_m: Vector3::y(),
                force_n: none,
            }),
            3 => loads.linear.push(LinearForce {
                node,
                arm_m: Vector3::zeros(),
                force_n: Vector3::zeros(),
                gradient_n_m: Matrix3::identity() * f64::NAN,
            }),
            4 => loads.twists.push(BeamTwist {
                beam,
                angle_rad: f64::NAN,
            }),
            _ => {}
        }
    }
}

/// On the share of large rotation.
#[derive(Debug)]
pub struct PoisonedKinematics;

impl Effect for PoisonedKinematics {
    fn card(&self) -> Card<'_> {
        card("poisoned-kinematics", Seam::Kinematics)
    }

    fn kinematics(&self, values: &Values) -> Option<f64> {
        Some(f64::NAN * values.strength())
    }
}
