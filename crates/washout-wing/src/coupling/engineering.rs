//! What a builder wants to know besides the twist: mass, inertia, natural frequencies, stresses and margins.

use nalgebra::Vector3;
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::CouplingError;
use super::build::large_share;
use super::solution::Solution;
use super::vibration::Standing;
use crate::aero::Flow;
use crate::effects::bind;
use crate::geometry::Planform;
use crate::input::design::{Design, Section};
use crate::mesh::BeamPart;
use crate::progress::Progress;
use crate::structure::state::State;
use crate::structure::{MassProperties, Model, Peak, Vibration, bending_peak, film_stress, torsion_peak};

/// Natural frequencies that are given.
const MODES: usize = 6;
/// Fibres that a section of plies has for each ply.
const FIBRES_PER_PLY: usize = 4;

/// What a builder wants to know besides the twist; absent values do not apply to the design.
#[derive(Debug, Clone, Default, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Engineering {
    /// Mass of the wing with the masses of its bench loads.
    pub mass_mg: Option<f64>,
    /// Moment of inertia of the unloaded wing about the flapping axis.
    pub inertia_flapping_g_mm2: Option<f64>,
    /// Moment of inertia of the unloaded wing about the leading edge.
    pub inertia_pitch_g_mm2: Option<f64>,
    /// Lowest natural frequencies about the loaded shape, without air.
    pub natural_frequencies_hz: Vec<f64>,
    /// The same with the mass of air that moves with the film (ρ π/4 c per area, spread evenly); empty without flow or film.
    pub natural_frequencies_in_air_hz: Vec<f64>,
    /// Directions in which the loaded shape would run away, so that it has no natural frequencies; 0: it is stable.
    pub unstable_directions: usize,
    /// Lowest natural frequency in air over the flapping frequency.
    pub frequency_ratio: Option<f64>,
    /// Largest shear stress of torsion in the rod.
    pub rod_shear_stress: Option<Extreme>,
    /// Largest bending and axial stress in the rod.
    pub rod_bending_stress: Option<Extreme>,
    /// Largest bending and axial stress in a spar.
    pub spar_stress: Option<Extreme>,
    /// Largest principal stress at a face of the film.
    pub film_stress: Option<Extreme>,
    /// Largest principal tension of the film.
    pub film_tension_max_n_per_m: Option<f64>,
    /// Smallest principal tension of the film; below zero it wrinkles there.
    pub film_tension_min_n_per_m: Option<f64>,
    /// Share of the film's area that is slack in at least one direction.
    pub film_wrinkled_share: Option<f64>,
}

/// A largest value and where it stands; where all places have a strength, the largest share of it.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Extreme {
    /// The value.
    pub stress_mpa: f64,
    /// Where along the span.
    pub r_mm: f64,
    /// Strength of the material; absent where the design does not state it.
    pub strength_mpa: Option<f64>,
    /// Strength over stress.
    pub margin: Option<f64>,
}

impl From<Peak> for Extreme {
    fn from(peak: Peak) -> Self {
        Extreme {
            stress_mpa: peak.stress_pa * 1e-6,
            r_mm: peak.place_m.x * 1e3,
            strength_mpa: peak.strength_pa.map(|strength| strength * 1e-6),
            margin: peak.margin(),
        }
    }
}

/// The engineering numbers of a solved wing.
///
/// # Errors
/// If its natural frequencies are not found, or the user asks to stop.
pub fn engineering(
    design: &Design,
    planform: &Planform,
    solution: &Solution,
    progress: &Progress,
) -> Result<Engineering, CouplingError> {
    let standing = Standing::loaded(design, solution)?;
    let mut found = Engineering::default();
    found.weigh(design, planform, &standing.model);
    let linear = large_share(design, &bind(design)?)? == 0.0;
    found.load(design, &standing.model, solution, linear);
    found.vibrate(design, planform, standing, progress)?;
    Ok(found)
}

impl Engineering {
    fn weigh(&mut self, design: &Design, planform: &Planform, model: &Model) {
        let properties = MassProperties::of(model, &State::at_rest(model.nodes.len()));
        if properties.mass_kg <= 0.0 {
            return;
        }
        self.mass_mg = Some(properties.mass_kg * 1e6);
        self.inertia_pitch_g_mm2 = Some(properties.about_kg_m2(&Vector3::zeros(), &Vector3::x()) * 1e9);
        if let Some(flow @ Flow::Flapping { .. }) = Flow::from_design(design) {
            let axis_at = Vector3::new(-planform.root_offset_m(), 0.0, 0.0);
            // for flapping, lift acts along the axis
            let inertia = properties.about_kg_m2(&axis_at, &flow.lift_direction());
            self.inertia_flapping_g_mm2 = Some(inertia * 1e9);
        }
    }

    fn load(&mut self, design: &Design, model: &Model, solution: &Solution, linear: bool) {
        let (parts, force) = (&solution.mesh.beams, &solution.beam_force);
        let beams = |rod: bool| {
            let of = move |index: &usize| matches!(parts[*index].part, BeamPart::Rod(_)) == rod;
            (0..model.beams.len()).filter(of)
        };
        let strength = |index: usize, fibre: usize| strength_pa(design, parts[index].part, fibre);
        self.rod_shear_stress = torsion_peak(model, beams(true), force).map(Extreme::from);
        self.rod_bending_stress = bending_peak(model, beams(true), force, strength).map(Extreme::from);
        self.spar_stress = bending_peak(model, beams(false), force, strength).map(Extreme::from);
        let strength = design
            .film
            .as_ref()
            .and_then(|film| material_strength_pa(design, &film.material));
        let film = film_stress(
            model,
            &solution.state,
            &solution.membrane_force_n_per_m,
            linear,
            strength,
        );
        if let Some(film) = film {
            self.film_stress = Some(film.peak.into());
            self.film_tension_max_n_per_m = Some(film.tension_max_n_per_m);
            self.film_tension_min_n_per_m = Some(film.tension_min_n_per_m);
            self.film_wrinkled_share = Some(film.wrinkled_share);
        }
    }

    fn vibrate(
        &mut self,
        design: &Design,
        planform: &Planform,
        standing: Standing,
        progress: &Progress,
    ) -> Result<(), CouplingError> {
        let frequencies = |standing: &Standing| {
            Ok::<_, CouplingError>(match standing.modes(MODES, progress)? {
                Vibration::Stable(modes) => (modes.iter().map(|mode| mode.frequency_hz).collect(), 0),
                Vibration::Unstable { negative } => (Vec::new(), negative),
            })
        };
        (self.natural_frequencies_hz, self.unstable_directions) = frequencies(&standing)?;
        let flow = Flow::from_design(design);
        // only a film moves air
        if flow.is_some() && !standing.model.shells.is_empty() {
            (self.natural_frequencies_in_air_hz, _) = frequencies(&standing.with_air(design, planform))?;
        }
        if let Some(Flow::Flapping { frequency_hz, .. }) = flow {
            let in_air = self.natural_frequencies_in_air_hz.first();
            let lowest = in_air.or(self.natural_frequencies_hz.first());
            self.frequency_ratio = lowest.map(|lowest| lowest / frequency_hz);
        }
        Ok(())
    }
}

/// Strength of what a fibre of a part is made of, Pa.
fn strength_pa(design: &Design, part: BeamPart, fibre: usize) -> Option<f64> {
    let (section, material) = match part {
        BeamPart::Rib(_) => return None,
        BeamPart::Rod(index) => design.rod.get(index).map(|rod| (&rod.section, &rod.material))?,
        BeamPart::Spar(index) => design
            .spar
            .get(index)
            .map(|spar| (&spar.section, &spar.material))?,
    };
    match section {
        Section::Laminate { plies, .. } => {
            material_strength_pa(design, &plies.get(fibre / FIBRES_PER_PLY)?.material)
        }
        Section::Given { .. } => None,
        _ => material_strength_pa(design, material.as_ref()?),
    }
}

fn material_strength_pa(design: &Design, name: &str) -> Option<f64> {
    let strength = design.material.get(name)?.strength_mpa.as_ref()?;
    Some(strength.value() * 1e6)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::generate;
    use crate::structure::wing_model;

    fn twist_v2() -> Design {
        let path =
            std::path::Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("designs/twist-v2.toml");
        Design::load(&path, &[]).unwrap().design
    }

    #[test]
    fn twist_v2_weighs_what_its_lengths_areas_and_densities_give() {
        let design = twist_v2();
        let planform = Planform::from_design(&design).unwrap();
        let mesh = generate(&design, &planform).unwrap();
        let model = wing_model(&design, &mesh).unwrap();
        let mut found = Engineering::default();
        found.weigh(&design, &planform, &model);
        // by hand, mg: film 12.242 (∫ c dr · 6 µm · 1420 kg/m³), half rod 23.503, thin rod 3.117, spars 13.216;
        // inertia from the same slender pieces about x = −38 mm at 45°, and about the leading edge
        let near = |found: Option<f64>, hand: f64| (found.unwrap() / hand - 1.0).abs() < 1e-3;
        assert!(near(found.mass_mg, 52.079), "{found:?}");
        assert!(near(found.inertia_flapping_g_mm2, 248.245), "{found:?}");
        assert!(near(found.inertia_pitch_g_mm2, 4.0926), "{found:?}");
    }

    #[test]
    fn every_fibre_has_the_strength_of_its_own_ply() {
        let design = twist_v2();
        let mesh = generate(&design, &Planform::from_design(&design).unwrap()).unwrap();
        let sections = wing_model(&design, &mesh).unwrap().sections;
        let spar = sections
            .iter()
            .find(|section| section.fibres.len() == 12)
            .unwrap();
        for (fibre, at) in spar.fibres.iter().enumerate() {
            let strength = strength_pa(&design, BeamPart::Spar(0), fibre).unwrap();
            let expected = if at.modulus_pa > 1e11 { 800e6 } else { 69e6 };
            assert_eq!(strength, expected, "{fibre}");
        }
        assert_eq!(strength_pa(&design, BeamPart::Rod(1), 20), Some(1500e6));
        assert_eq!(strength_pa(&design, BeamPart::Rod(7), 0), None);
    }
}
