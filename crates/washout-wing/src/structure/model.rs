//! A structure: nodes, elements, supports, springs and masses; its energy, forces and tangent.

use std::sync::Arc;

use rayon::iter::{IndexedParallelIterator, IntoParallelRefMutIterator, ParallelIterator};

use nalgebra::{SVector, UnitQuaternion, Vector3};

use super::StructureError;
use super::beam::Beam;
use super::blend::Blend;
use super::corotational::Response;
use super::loads::Loads;
use super::pattern::Pattern;
use super::section::Section;
use super::sheet::Sheet;
use super::shell::Shell;
use super::spring::Spring;
use super::state::State;

/// Elements whose responses are held at once.
const CHUNK: usize = 1024;
/// Elements from which on they are computed side by side: fewer are added one by one, without a place for each.
const SIDE_BY_SIDE: usize = 1024;

/// A structure at rest.
#[derive(Debug, Clone, Default)]
pub struct Model {
    /// Positions of the nodes, m.
    pub nodes: Vec<Vector3<f64>>,
    /// Sections that the beams name.
    pub sections: Vec<Section>,
    /// Sheets that the shells name.
    pub sheets: Vec<Sheet>,
    /// Beam elements.
    pub beams: Vec<Beam>,
    /// Films and plates; shared with the models that are made from this one and leave them alone.
    pub shells: Arc<Vec<Shell>>,
    /// Which freedoms of each node are held where the start of a solve has them: x, y, z, rotations about x, y, z.
    pub held: Vec<[bool; 6]>,
    /// Springs to the ground.
    pub springs: Vec<Spring>,
    /// Masses besides those of the elements.
    pub masses: Vec<PointMass>,
    /// The linear model that is mixed into this one, if any.
    pub blend: Option<Arc<Blend>>,
}

/// Mass on a rigid arm.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct PointMass {
    /// Node that carries it.
    pub node: usize,
    /// Place against the node at rest, m.
    pub arm_m: Vector3<f64>,
    /// Mass, kg.
    pub mass_kg: f64,
    /// Moments of inertia about axes through it, parallel to the frame, kg·m².
    pub inertia_kg_m2: Vector3<f64>,
}

impl Model {
    /// Nodes alone, all free.
    pub fn new(nodes: Vec<Vector3<f64>>) -> Self {
        let held = vec![[false; 6]; nodes.len()];
        Model {
            nodes,
            held,
            ..Model::default()
        }
    }

    /// Adds a section and gives its index.
    pub fn add_section(&mut self, section: Section) -> usize {
        self.sections.push(section);
        self.sections.len() - 1
    }

    /// Adds a sheet and gives its index.
    pub fn add_sheet(&mut self, sheet: Sheet) -> usize {
        self.sheets.push(sheet);
        self.sheets.len() - 1
    }

    /// Adds a beam element with e₃ toward `normal`.
    ///
    /// # Errors
    /// If it has no length or no side.
    pub fn add_beam(
        &mut self,
        nodes: [usize; 2],
        normal: &Vector3<f64>,
        section: usize,
    ) -> Result<(), StructureError> {
        let ends = nodes.map(|node| self.nodes[node]);
        self.beams
            .push(Beam::new(nodes, ends, normal, section, &self.sections[section])?);
        Ok(())
    }

    /// Adds a triangle.
    ///
    /// # Errors
    /// If it has no area.
    pub fn add_shell(&mut self, nodes: [usize; 3], sheet: usize) -> Result<(), StructureError> {
        let corners = nodes.map(|node| self.nodes[node]);
        let shell = Shell::new(nodes, corners, sheet, &self.sheets[sheet])?;
        Arc::make_mut(&mut self.shells).push(shell);
        Ok(())
    }

    /// Holds the freedoms of a node that are marked, besides those held already.
    pub fn hold(&mut self, node: usize, freedoms: [bool; 6]) {
        for (held, freedom) in self.held[node].iter_mut().zip(freedoms) {
            *held |= freedom;
        }
    }

    /// Clamps a node.
    pub fn clamp(&mut self, node: usize) {
        self.hold(node, [true; 6]);
    }

    /// Mass of each node when every element hands its mass to its nodes in equal parts, and every point mass to its own, kg.
    pub fn lumped_mass_kg(&self) -> Vec<f64> {
        let mut lumped = vec![0.0; self.nodes.len()];
        for beam in &self.beams {
            let half = 0.5 * self.sections[beam.section].mass_kg_m * beam.length_m();
            beam.nodes.into_iter().for_each(|node| lumped[node] += half);
        }
        for shell in self.shells.iter() {
            let sheet = &self.sheets[shell.sheet];
            let third = sheet.density_kg_m3 * sheet.thickness_m * shell.area_m2() / 3.0;
            shell.nodes.into_iter().for_each(|node| lumped[node] += third);
        }
        for mass in &self.masses {
            lumped[mass.node] += mass.mass_kg;
        }
        lumped
    }

    /// Number of freedoms that are not held.
    pub fn free_freedoms(&self) -> usize {
        self.held.iter().flatten().filter(|held| !**held).count()
    }

    /// Largest extent of the nodes, m.
    pub fn extent_m(&self) -> f64 {
        let mut low = Vector3::repeat(f64::INFINITY);
        let mut high = -low;
        for x in &self.nodes {
            low = low.inf(x);
            high = high.sup(x);
        }
        if self.nodes.is_empty() {
            0.0
        } else {
            (high - low).amax()
        }
    }

    /// Displacements and rotations of a shell's nodes.
    pub fn shell_state(&self, shell: &Shell, state: &State) -> ([Vector3<f64>; 3], [UnitQuaternion<f64>; 3]) {
        (
            shell.nodes.map(|n| state.displacement[n]),
            shell.nodes.map(|n| state.rotation[n]),
        )
    }

    /// Displacements and rotations of a beam's nodes.
    pub fn beam_state(&self, beam: &Beam, state: &State) -> ([Vector3<f64>; 2], [UnitQuaternion<f64>; 2]) {
        (
            beam.nodes.map(|n| state.displacement[n]),
            beam.nodes.map(|n| state.rotation[n]),
        )
    }

    /// Internal forces less loads of the large-rotation model, as [`Model::residual`].
    pub(super) fn large_residual(&self, pattern: &Pattern, state: &State, loads: &Loads) -> Vec<f64> {
        let mut residual = self.residual_without_shells(pattern, state, loads);
        for shell in self.shells.iter() {
            let (u, q) = self.shell_state(shell, state);
            let (_, force) = shell.force(&self.sheets[shell.sheet], &u, &q);
            scatter(pattern, &mut residual, &shell.nodes, force.as_slice());
        }
        residual
    }

    /// The same without the forces of films and plates: what tells models apart that share these.
    pub fn residual_without_shells(&self, pattern: &Pattern, state: &State, loads: &Loads) -> Vec<f64> {
        let mut residual = vec![0.0; pattern.len()];
        for (index, beam) in self.beams.iter().enumerate() {
            let (u, q) = self.beam_state(beam, state);
            let (_, force) = beam.force(&u, &q, loads.twist_rad(index));
            scatter(pattern, &mut residual, &beam.nodes, force.as_slice());
        }
        for spring in &self.springs {
            let (force, _) = spring.response(state);
            scatter(pattern, &mut residual, &[spring.node], force.as_slice());
        }
        loads.subtract(pattern, state, &mut residual);
        residual
    }

    /// Strain energy, J.
    pub fn energy(&self, state: &State) -> f64 {
        let shells = self.shells.iter().map(|shell| {
            let (u, q) = self.shell_state(shell, state);
            shell.force(&self.sheets[shell.sheet], &u, &q).0
        });
        let beams = self.beams.iter().map(|beam| {
            let (u, q) = self.beam_state(beam, state);
            beam.force(&u, &q, 0.0).0
        });
        let springs = self.springs.iter().map(|spring| spring.energy(state));
        shells.sum::<f64>() + beams.sum::<f64>() + springs.sum::<f64>()
    }

    /// Residual and tangent of the large-rotation model, as [`Model::assemble`].
    pub(super) fn large_assemble(
        &self,
        pattern: &Pattern,
        state: &State,
        loads: &Loads,
        aid: Option<&Aid>,
        values: &mut [f64],
    ) -> Assembled {
        let is_mixed = aid.is_some_and(|aid| aid.is_mixed);
        let mut residual = vec![0.0; pattern.len()];
        // what the linear laws of a mixed step add to the residual
        let mut excess = vec![0.0; if is_mixed { pattern.len() } else { 0 }];
        self.each_shell(state, aid, |index, shell, (response, force)| {
            scatter(pattern, &mut residual, &shell.nodes, force.as_slice());
            if is_mixed {
                let more = response.force - force;
                scatter(pattern, &mut excess, &shell.nodes, more.as_slice());
            }
            pattern.add_shell(values, index, shell.nodes, |i, j| response.stiffness[(i, j)]);
        });
        let guess = aid.and_then(|aid| aid.guess.as_ref());
        for (index, beam) in self.beams.iter().enumerate() {
            let (u, q) = self.beam_state(beam, state);
            let guess = guess.map(|guess| &guess.beams[index]);
            let response = beam.response(&u, &q, loads.twist_rad(index), guess);
            scatter(pattern, &mut residual, &beam.nodes, response.force.as_slice());
            pattern.add_beam(values, index, beam.nodes, |i, j| response.stiffness[(i, j)]);
        }
        for spring in &self.springs {
            let (force, stiffness) = spring.response(state);
            scatter(pattern, &mut residual, &[spring.node], force.as_slice());
            let [along, about] = stiffness;
            pattern.add_node(values, spring.node, |i, j| match (i, j) {
                (0..3, 0..3) => along[(i, j)],
                (3..6, 3..6) => about[(i - 3, j - 3)],
                _ => 0.0,
            });
        }
        loads.add_tangent(pattern, state, values);
        loads.subtract(pattern, state, &mut residual);
        let linearized = if is_mixed {
            residual.iter().zip(&excess).map(|(r, more)| r + more).collect()
        } else {
            residual.clone()
        };
        Assembled { residual, linearized }
    }

    /// Hands over the response of each shell and its own force, one after the other in their order: sums do not depend on the number
    /// of threads.
    fn each_shell(
        &self,
        state: &State,
        aid: Option<&Aid>,
        mut add: impl FnMut(usize, &Shell, &(Response<18>, SVector<f64, 18>)),
    ) {
        let guess = aid.and_then(|aid| aid.guess.as_ref());
        let carried = aid.map_or(0.0, |aid| aid.carried);
        let is_mixed = aid.is_some_and(|aid| aid.is_mixed);
        let respond = |index: usize,
                       shell: &Shell,
                       (response, force): &mut (Response<18>, SVector<f64, 18>)| {
            let (u, q) = self.shell_state(shell, state);
            let guess = guess.and_then(|guess| guess.shell(index));
            let sheet = &self.sheets[shell.sheet];
            match guess {
                Some(about) if is_mixed => *force = shell.mixed_response(sheet, (&u, &q), about, response),
                _ => {
                    shell.respond(sheet, (&u, &q), guess, carried, response);
                    *force = response.force;
                }
            }
        };
        let none = (Response::zero(), SVector::zeros());
        if self.shells.len() < SIDE_BY_SIDE {
            let mut response = none;
            for (index, shell) in self.shells.iter().enumerate() {
                respond(index, shell, &mut response);
                add(index, shell, &response);
            }
            return;
        }
        let mut responses = vec![none; self.shells.len().min(CHUNK)];
        for (part, shells) in self.shells.chunks(CHUNK).enumerate() {
            let places = responses.par_iter_mut().zip(shells).enumerate().with_min_len(64);
            places.for_each(|(index, (place, shell))| respond(part * CHUNK + index, shell, place));
            for (index, (shell, response)) in shells.iter().zip(&responses).enumerate() {
                add(part * CHUNK + index, shell, response);
            }
        }
    }

    /// Local freedoms of the elements after a step (by freedom of `pattern`) from `state`, to first order; `shells`:
    /// those of the shells too. A film carries by the stretch of second order, which a guess lacks.
    pub fn guess(&self, pattern: &Pattern, state: &State, step: &[f64], shells: bool) -> Guess {
        let shell = |shell: &Shell| {
            let (u, q) = self.shell_state(shell, state);
            shell.guess(&u, &q, &gather(pattern, step, &shell.nodes))
        };
        let beam = |beam: &Beam| {
            let (u, q) = self.beam_state(beam, state);
            beam.guess(&u, &q, &gather(pattern, step, &beam.nodes))
        };
        Guess {
            shells: if shells {
                self.shells.iter().map(shell).collect()
            } else {
                Vec::new()
            },
            beams: self.beams.iter().map(beam).collect(),
        }
    }

    /// Adds the stiffness that an isotropic tension (N/m) would give the deformed films against motion across them.
    pub fn add_tension(&self, pattern: &Pattern, state: &State, tension_n_per_m: f64, values: &mut [f64]) {
        for (index, shell) in self.shells.iter().enumerate() {
            let (u, _) = self.shell_state(shell, state);
            let normal = shell.normal(&u);
            let factor = shell.unit_tension() * tension_n_per_m;
            pattern.add_shell(values, index, shell.nodes, |i, j| {
                let (a, b, i, j) = (i / 6, j / 6, i % 6, j % 6);
                if i < 3 && j < 3 {
                    factor[(a, b)] * normal[i] * normal[j]
                } else {
                    0.0
                }
            });
        }
    }
}

/// What helps a tangent on the way to equilibrium.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Aid {
    /// Local freedoms that the last step was expected to lead to: the tangent takes its forces from them.
    pub guess: Option<Guess>,
    /// Share of compression that films pretend to carry.
    pub carried: f64,
    /// Whether films take force and law from the guess too (see [`super::mixed`]).
    pub is_mixed: bool,
}

/// What an assembly gives besides the tangent, by freedom, N and N·m.
#[derive(Debug, Clone, PartialEq)]
pub struct Assembled {
    /// Internal forces less loads.
    pub residual: Vec<f64>,
    /// The same with the laws that a mixed step takes for linear: what its step undoes.
    pub linearized: Vec<f64>,
}

/// Local freedoms of the elements that a step is expected to lead to.
#[derive(Debug, Clone, PartialEq)]
pub struct Guess {
    pub(super) shells: Vec<SVector<f64, 18>>,
    pub(super) beams: Vec<SVector<f64, 12>>,
}

impl Guess {
    /// The same with a share of the way to another.
    pub(super) fn toward(mut self, other: &Guess, share: f64) -> Guess {
        let shells = self.shells.iter_mut().zip(&other.shells);
        shells.for_each(|(own, to)| *own += share * (to - *own));
        let beams = self.beams.iter_mut().zip(&other.beams);
        beams.for_each(|(own, to)| *own += share * (to - *own));
        self
    }
}

fn scatter(pattern: &Pattern, target: &mut [f64], nodes: &[usize], force: &[f64]) {
    for (k, &node) in nodes.iter().enumerate() {
        let at = pattern.freedom(node, 0);
        for i in 0..6 {
            target[at + i] += force[6 * k + i];
        }
    }
}

fn gather<const D: usize>(pattern: &Pattern, source: &[f64], nodes: &[usize]) -> SVector<f64, D> {
    SVector::from_fn(|i, _| source[pattern.freedom(nodes[i / 6], i % 6)])
}
