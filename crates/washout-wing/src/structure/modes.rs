//! Natural frequencies and mode shapes about a loaded shape: the lowest of K φ = ω² M φ.
//!
//! Found by `lanczos`; that no mode is missed is checked by Sturm's count: K − s M has as many negative pivots as there
//! are modes below s (Bathe, Finite Element Procedures, 1996, §11.4).

use nalgebra::Vector3;

use super::StructureError;
use super::equilibrium::Equilibrium;
use super::factor::Factor;
use super::finite::{each, refuse_not_finite};
use super::lanczos::{Krylov, Ritz};
use super::loads::Loads;
use super::mass::mass_matrix;
use super::state::State;
use crate::progress::Progress;

/// Modes that are found besides those asked for, to place Sturm's count in a gap.
const SPARE: usize = 3;
/// Fresh starts at most, each after Sturm's count has found a mode missing.
const MAX_STARTS: usize = 4;

/// How a structure vibrates about one shape.
#[derive(Debug, Clone, PartialEq)]
pub enum Vibration {
    /// Its lowest modes by rising frequency; fewer than asked for where it has no more, none without mass.
    Stable(Vec<Mode>),
    /// The shape is not a stable equilibrium, so that it has no frequencies.
    Unstable {
        /// Negative pivots of the tangent: directions in which it would run away.
        negative: usize,
    },
}

/// A natural mode.
#[derive(Debug, Clone, PartialEq)]
pub struct Mode {
    /// Natural frequency, Hz; relative error at most 1e-8 besides that of the mesh.
    pub frequency_hz: f64,
    /// Motion of each node, wing frame, m for a modal mass of 1 kg (φᵀ M φ = 1 kg); its largest part is positive.
    pub displacement: Vec<Vector3<f64>>,
    /// Rotation of each node to the same scale, rad.
    pub rotation: Vec<Vector3<f64>>,
}

/// The lowest `count` modes about `state`, which is in equilibrium under `loads`; loads keep still.
///
/// `across_kg_m2`: see [`mass_matrix`]; empty in a vacuum. Held freedoms do not move.
///
/// # Errors
/// If the tangent is singular, a mass is not finite, the search finds fewer modes than Sturm's count, or the user asks to stop.
pub fn lowest_modes(
    equilibrium: &mut Equilibrium,
    state: &State,
    loads: &Loads,
    across_kg_m2: &[f64],
    count: usize,
    progress: &Progress,
) -> Result<Vibration, StructureError> {
    let negative = equilibrium.factorize(state, loads)?;
    if negative > 0 {
        return Ok(Vibration::Unstable { negative });
    }
    let mut mass = mass_matrix(equilibrium.model, &equilibrium.pattern, state, across_kg_m2);
    equilibrium.pattern.hold(&mut mass, equilibrium.held());
    for (node, held) in equilibrium.model.held.iter().enumerate() {
        for (component, _) in held.iter().enumerate().filter(|(_, held)| **held) {
            mass[equilibrium.pattern.diagonal(node, component)] = 0.0;
        }
    }
    for node in 0..equilibrium.model.nodes.len() {
        let of_node = (0..6).map(|part| &mass[equilibrium.pattern.diagonal(node, part)]);
        let place = || format!("that moves with the wing {}", equilibrium.model.place(node));
        refuse_not_finite(place, each("the mass (kg, kg·m²)", of_node))?;
    }
    let mut space = Krylov::new(mass);
    for start in 0..MAX_STARTS {
        space.add_start(equilibrium, start);
        let found = space.extend(equilibrium, count + SPARE, progress)?;
        let (below, shift) = gap(&found, count);
        let Some(shift) = shift else {
            return Ok(finish(equilibrium, &space, &found, count));
        };
        if modes_below(equilibrium, space.mass(), shift)? == below {
            return Ok(finish(equilibrium, &space, &found, count));
        }
    }
    Err(StructureError::NoMode {
        iterations: space.size(),
    })
}

/// Number of modes below ω² = `shift` (1/s²).
fn modes_below(equilibrium: &Equilibrium, mass: &[f64], shift: f64) -> Result<usize, StructureError> {
    let stiffness = equilibrium.tangent_values().iter();
    let shifted: Vec<f64> = stiffness.zip(mass).map(|(k, m)| k - shift * m).collect();
    Factor::new(equilibrium.factor.symbolic()).indefinite(&equilibrium.pattern, &shifted)
}

/// The widest gap after the `count`-th of the eigenvalues: how many lie below it, and ω² in its middle.
fn gap(found: &[Ritz], count: usize) -> (usize, Option<f64>) {
    let last = found.len().saturating_sub(1);
    let ratio = |below: usize| found[below].omega2 / found[below - 1].omega2;
    let widest = (count.max(1)..=last).max_by(|&a, &b| ratio(a).total_cmp(&ratio(b)));
    match widest {
        Some(below) => {
            let shift = (found[below].omega2 * found[below - 1].omega2).sqrt();
            (below, Some(shift))
        }
        // all modes are found: none may lie anywhere near below the last one's double
        None => (found.len(), found.last().map(|last| 2.0 * last.omega2)),
    }
}

fn finish(equilibrium: &Equilibrium, space: &Krylov, found: &[Ritz], count: usize) -> Vibration {
    let mode = |ritz: &Ritz| {
        let motion = space.motion(ritz);
        let part = |node: usize, first: usize| {
            Vector3::from_fn(|i, _| motion[equilibrium.pattern.freedom(node, first + i)])
        };
        let nodes = 0..equilibrium.model.nodes.len();
        let mut mode = Mode {
            frequency_hz: ritz.omega2.sqrt() / std::f64::consts::TAU,
            displacement: nodes.clone().map(|node| part(node, 0)).collect(),
            rotation: nodes.map(|node| part(node, 3)).collect(),
        };
        mode.orient();
        mode
    };
    Vibration::Stable(found.iter().take(count).map(mode).collect())
}

impl Mode {
    /// Makes the largest part of the motion positive.
    fn orient(&mut self) {
        let parts = self.displacement.iter().flat_map(|u| u.iter().copied());
        let largest = parts.fold(0.0_f64, |a, b| if b.abs() > 1.000_001 * a.abs() { b } else { a });
        if largest < 0.0 {
            let all = self.displacement.iter_mut().chain(&mut self.rotation);
            all.for_each(|u| *u = -*u);
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::{Model, NewtonSettings, Section};
    use std::f64::consts::PI;

    /// Modes at rest or, with `loads`, in equilibrium under them.
    fn frequencies(model: &Model, loads: Option<&Loads>, count: usize) -> Vec<f64> {
        match vibration(model, loads, count) {
            Vibration::Stable(modes) => modes.iter().map(|mode| mode.frequency_hz).collect(),
            Vibration::Unstable { negative } => panic!("unstable {negative}"),
        }
    }

    fn vibration(model: &Model, loads: Option<&Loads>, count: usize) -> Vibration {
        let none = Loads::none(model.nodes.len());
        let mut equilibrium = Equilibrium::new(model).unwrap();
        let mut state = State::at_rest(model.nodes.len());
        if let Some(loads) = loads {
            let settings = NewtonSettings::default();
            equilibrium
                .solve(&mut state, &none, loads, &settings, &Progress::quiet())
                .unwrap();
        }
        let loads = loads.unwrap_or(&none);
        lowest_modes(&mut equilibrium, &state, loads, &[], count, &Progress::quiet()).unwrap()
    }

    const LENGTH_M: f64 = 0.5;
    const MASS_KG_M: f64 = 0.2;
    /// Moment of inertia per length about the beam, kg·m.
    const POLAR_KG_M: f64 = 3e-6;

    /// Slender beam along (1, 2, 2)/3: EA 8e4 N, GJ 2 N·m², EI 3 (flap) and 5 N·m² (edge).
    fn beam(count: usize) -> Model {
        let along = Vector3::new(1.0, 2.0, 2.0) / 3.0;
        let node = |i: usize| along * (LENGTH_M * i as f64 / count as f64);
        let mut model = Model::new((0..=count).map(node).collect());
        let mut section = Section::uncoupled(8e4, 2.0, 3.0, 5.0);
        section.mass_kg_m = MASS_KG_M;
        section.inertia_kg_m = Vector3::new(POLAR_KG_M, 0.0, 0.0);
        let section = model.add_section(section);
        for i in 0..count {
            model.add_beam([i, i + 1], &Vector3::z(), section).unwrap();
        }
        model
    }

    /// ω = (βL)² √(EI/(m L⁴)), Hz.
    fn bending_hz(beta_l: f64, ei: f64) -> f64 {
        beta_l.powi(2) * (ei / (MASS_KG_M * LENGTH_M.powi(4))).sqrt() / (2.0 * PI)
    }

    #[test]
    fn cantilever_bends_twists_and_stretches_at_the_closed_forms() {
        // cos βL cosh βL = −1
        let beta_l = [1.875_104_07_f64, 4.694_091_13, 7.854_757_44, 10.995_540_73];
        for root in beta_l {
            assert!(((root.cos() * root.cosh()) + 1.0).abs() < 1e-3, "{root}");
        }
        let wave =
            |stiffness: f64, mass: f64, n: f64| (2.0 * n - 1.0) / 4.0 * (stiffness / mass).sqrt() / LENGTH_M;
        let mut exact: Vec<f64> = beta_l
            .iter()
            .flat_map(|&root| [bending_hz(root, 3.0), bending_hz(root, 5.0)])
            .chain([wave(2.0, POLAR_KG_M, 1.0), wave(8e4, MASS_KG_M, 1.0)])
            .collect();
        exact.sort_by(f64::total_cmp);
        let mut model = beam(40);
        model.clamp(0);
        let found = frequencies(&model, None, 10);
        for (found, exact) in found.iter().zip(&exact) {
            // twist and stretch are of second order: (π/2/40)²/24 = 6.4e-5
            assert!((found / exact - 1.0).abs() < 7e-5, "{found} {exact}");
        }
    }

    #[test]
    fn bending_converges_with_the_fourth_power_of_the_element_size_and_twist_with_the_second() {
        let exact_twist = 0.25 * (2.0 / POLAR_KG_M).sqrt() / LENGTH_M;
        let errors = |count: usize| {
            let mut model = beam(count);
            model.clamp(0);
            let found = frequencies(&model, None, 6 * count);
            let nearest = |exact: f64| {
                let error = found.iter().map(|f| (f / exact - 1.0).abs());
                error.fold(f64::INFINITY, f64::min)
            };
            [nearest(bending_hz(4.694_091_13, 3.0)), nearest(exact_twist)]
        };
        let (coarse, fine) = (errors(4), errors(8));
        let order = |k: usize| (coarse[k] / fine[k]).log2();
        assert!((order(0) - 4.0).abs() < 0.3, "{}", order(0));
        assert!((order(1) - 2.0).abs() < 0.1, "{}", order(1));
    }

    #[test]
    fn equal_frequencies_are_all_found_with_modes_orthonormal_in_the_mass() {
        let mut model = beam(12);
        let mut round = Section::uncoupled(4e5, 2.0, 3.0, 3.0);
        round.mass_kg_m = MASS_KG_M;
        round.inertia_kg_m = Vector3::new(POLAR_KG_M, 0.0, 0.0);
        model.sections[0] = round;
        model.beams.clear();
        for i in 0..12 {
            model.add_beam([i, i + 1], &Vector3::z(), 0).unwrap();
        }
        model.clamp(0);
        let Vibration::Stable(modes) = vibration(&model, None, 5) else {
            panic!("unstable");
        };
        assert!((modes[0].frequency_hz / modes[1].frequency_hz - 1.0).abs() < 1e-8);
        assert!((modes[2].frequency_hz / modes[3].frequency_hz - 1.0).abs() < 1e-8);
        assert!(modes[2].frequency_hz > 6.0 * modes[1].frequency_hz);
        let pattern = model.pattern();
        let mass = mass_matrix(&model, &pattern, &State::at_rest(13), &[]);
        let motion = |mode: &Mode| {
            let mut motion = vec![0.0; pattern.len()];
            for node in 0..13 {
                for i in 0..3 {
                    motion[pattern.freedom(node, i)] = mode.displacement[node][i];
                    motion[pattern.freedom(node, 3 + i)] = mode.rotation[node][i];
                }
            }
            motion
        };
        for (i, a) in modes.iter().enumerate() {
            for (j, b) in modes.iter().enumerate() {
                let momentum = pattern.multiply(&mass, &motion(a));
                let product: f64 = momentum.iter().zip(motion(b)).map(|(p, v)| p * v).sum();
                let expected = if i == j { 1.0 } else { 0.0 };
                assert!((product - expected).abs() < 1e-9, "{i} {j} {product}");
            }
        }
    }

    #[test]
    fn a_small_structure_gives_all_the_modes_it_has_and_one_without_mass_gives_none() {
        let mut model = beam(1);
        model.clamp(0);
        // beyond the axial, torsional and four bending freedoms there is nothing
        assert_eq!(frequencies(&model, None, 20).len(), 6);
        model.sections[0].mass_kg_m = 0.0;
        model.sections[0].inertia_kg_m = Vector3::zeros();
        assert_eq!(frequencies(&model, None, 20).len(), 0);
    }

    /// Beam along x, hinged at both ends against motion across, under an axial force at its far end.
    fn strut(force_share_of_euler: f64) -> (Model, Loads) {
        let count = 16;
        let nodes = (0..=count).map(|i| Vector3::new(LENGTH_M * i as f64 / count as f64, 0.0, 0.0));
        let mut model = Model::new(nodes.collect());
        // stiff along, so that the strut keeps its length
        let mut section = Section::uncoupled(4e8, 2.0, 3.0, 500.0);
        section.mass_kg_m = MASS_KG_M;
        let section = model.add_section(section);
        for i in 0..count {
            model.add_beam([i, i + 1], &Vector3::z(), section).unwrap();
        }
        model.hold(0, [true, true, true, true, false, true]);
        model.hold(count, [false, true, true, true, false, true]);
        let mut loads = Loads::none(model.nodes.len());
        let euler = PI * PI * 3.0 / LENGTH_M.powi(2);
        loads.force_n[count].x = -force_share_of_euler * euler;
        (model, loads)
    }

    #[test]
    fn an_axial_force_shifts_the_square_of_the_frequency_by_its_share_of_the_euler_load() {
        let free = bending_hz(PI, 3.0);
        for share in [0.0, 0.5, 0.9, -2.0] {
            let (model, loads) = strut(share);
            let found = frequencies(&model, Some(&loads), 1)[0];
            let square = (found / free).powi(2);
            // within an element the chord stands for the bent line: the force counts for less by π²/(12 · 16²);
            // the cubics themselves leave (π/16)⁴/720
            assert!(
                (square - (1.0 - share)).abs() <= 3e-6 + share.abs() * 1.05 * PI * PI / (12.0 * 256.0),
                "{share} {square}"
            );
        }
    }

    #[test]
    fn a_strut_beyond_its_euler_load_is_said_to_be_unstable() {
        let (model, loads) = strut(1.5);
        assert_eq!(
            vibration(&model, Some(&loads), 3),
            Vibration::Unstable { negative: 1 }
        );
    }

    #[test]
    fn a_mass_on_an_arm_swings_at_the_closed_form() {
        // massless cantilever in torsion with a mass on an arm along its normal plane: ω² = GJ/(L (I + m d²))
        let mut model = beam(4);
        model.clamp(0);
        model.sections[0].mass_kg_m = 0.0;
        model.sections[0].inertia_kg_m = Vector3::zeros();
        let along = Vector3::new(1.0, 2.0, 2.0) / 3.0;
        let arm = 0.01 * along.cross(&Vector3::x()).normalize();
        model.masses.push(crate::structure::PointMass {
            node: 4,
            arm_m: arm,
            mass_kg: 0.0,
            inertia_kg_m2: Vector3::repeat(2e-5),
        });
        model.masses.push(crate::structure::PointMass {
            node: 4,
            arm_m: arm,
            mass_kg: 0.1,
            inertia_kg_m2: Vector3::zeros(),
        });
        // the tip is held but for its twist, so that nothing else moves
        for node in 1..=4 {
            model.hold(node, [true, true, true, false, false, false]);
        }
        let found = frequencies(&model, None, 3);
        let exact = (2.0 / (LENGTH_M * (2e-5 + 0.1 * 1e-4_f64))).sqrt() / (2.0 * PI);
        assert!(
            found.iter().any(|f| (f / exact - 1.0).abs() < 1e-6),
            "{found:?} {exact}"
        );
    }
}
