//! What moves in a natural mode, and how much of the wing's mass moves with it.
//!
//! The motion is taken apart at every node: the leading edge beside it moves across the wing (flap) and in its plane
//! (edge), the straight chord turns with the rod about it (twist), and what is left is film and spars bent off that chord
//! (film). Each part's share is its kinetic energy over the sum of the four; the parts are not orthogonal in the mass,
//! so that the sum is not the energy of the mode.

use nalgebra::Vector3;

use super::edges::leading_edge_point;
use crate::coupling::vibration::Standing;
use crate::mesh::Mesh;
use crate::structure::pattern::Pattern;
use crate::structure::{Mode, mass_matrix};

/// Shares of the parts of a motion in the sum of their kinetic energies.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MotionShare {
    /// The rod turns, and straight chords with it.
    pub twist: f64,
    /// The leading edge moves across the wing.
    pub flap: f64,
    /// The leading edge moves in the plane of the wing.
    pub edge: f64,
    /// Film and spars bend off those chords.
    pub film: f64,
}

/// What is read from a mode.
#[derive(Debug, Clone, PartialEq)]
pub struct ModeReading {
    /// What moves.
    pub share: MotionShare,
    /// Mass that a shaken base feels along x, y, z (wing frame), kg: (φᵀ M r)²/(φᵀ M φ), r a unit motion of the whole.
    pub effective_mass_kg: [f64; 3],
    /// The same for each of the reader's axes when the base turns about it, kg·m².
    pub effective_inertia_kg_m2: Vec<f64>,
}

/// An axis in the wing frame: a point (m) and a unit direction.
pub type Axis = (Vector3<f64>, Vector3<f64>);

/// Reads the modes of one wing.
#[derive(Debug)]
pub struct ModeReader<'a> {
    standing: &'a Standing,
    pattern: Pattern,
    mass: Vec<f64>,
    /// Momentum of each unit motion of the whole: along x, y, z, then about each axis.
    momenta: Vec<Vec<f64>>,
    stations: Vec<Option<Station>>,
    on_edge: Vec<bool>,
}

/// The section of the wing that a node stands in.
#[derive(Debug)]
struct Station {
    /// Leading-edge nodes around it.
    leading: [usize; 2],
    /// Their weights.
    weights: [f64; 2],
    /// Unit tangent of the deformed leading edge.
    span: Vector3<f64>,
}

impl<'a> ModeReader<'a> {
    /// For the modes of `standing`, a wing on `mesh`; `axes`: about which effective inertias are wanted.
    pub fn new(mesh: &Mesh, standing: &'a Standing, axes: &[Axis]) -> Self {
        let Standing {
            model,
            state,
            moved_air_kg_m2,
            ..
        } = standing;
        let pattern = model.pattern();
        let mass = mass_matrix(model, &pattern, state, moved_air_kg_m2);
        let at = |node: usize| model.nodes[node] + state.displacement[node];
        let momentum = |motion: &dyn Fn(usize) -> [Vector3<f64>; 2]| {
            pattern.multiply(&mass, &freedoms(&pattern, (0..model.nodes.len()).map(motion)))
        };
        let mut momenta: Vec<Vec<f64>> = (0..3)
            .map(|k| momentum(&|_| [Vector3::ith(k, 1.0), Vector3::zeros()]))
            .collect();
        for (point, direction) in axes {
            momenta.push(momentum(&|node| {
                [direction.cross(&(at(node) - point)), *direction]
            }));
        }
        let mut on_edge = vec![false; mesh.nodes.len()];
        mesh.leading_edge.iter().for_each(|&node| on_edge[node] = true);
        let station = |node: &[f64; 3]| {
            let (leading, weights) = leading_edge_point(mesh, node[0])?;
            Some(Station {
                leading,
                weights,
                span: (at(leading[1]) - at(leading[0])).normalize(),
            })
        };
        let stations = mesh.nodes.iter().map(station).collect();
        ModeReader {
            standing,
            pattern,
            mass,
            momenta,
            stations,
            on_edge,
        }
    }

    /// Reads one mode.
    pub fn read(&self, mode: &Mode) -> ModeReading {
        let nodes = 0..self.standing.model.nodes.len();
        let parts: Vec<[[Vector3<f64>; 2]; 4]> = nodes.clone().map(|node| self.parts(mode, node)).collect();
        let energy = |part: usize| {
            let motion = freedoms(&self.pattern, parts.iter().map(|parts| parts[part]));
            dot(&self.pattern.multiply(&self.mass, &motion), &motion)
        };
        let [twist, flap, edge, film] = [0, 1, 2, 3].map(energy);
        let sum = twist + flap + edge + film;
        let motion = freedoms(
            &self.pattern,
            nodes.map(|node| [mode.displacement[node], mode.rotation[node]]),
        );
        let modal = dot(&self.pattern.multiply(&self.mass, &motion), &motion);
        let effective = |momentum: &Vec<f64>| dot(momentum, &motion).powi(2) / modal;
        let effective: Vec<f64> = self.momenta.iter().map(effective).collect();
        ModeReading {
            share: MotionShare {
                twist: twist / sum,
                flap: flap / sum,
                edge: edge / sum,
                film: film / sum,
            },
            effective_mass_kg: [effective[0], effective[1], effective[2]],
            effective_inertia_kg_m2: effective[3..].to_vec(),
        }
    }

    /// Displacement and rotation of a node by twist, flap, edge and film.
    fn parts(&self, mode: &Mode, node: usize) -> [[Vector3<f64>; 2]; 4] {
        let zero = Vector3::zeros();
        let (u, turn) = (mode.displacement[node], mode.rotation[node]);
        let Some(Station {
            leading,
            weights,
            span,
        }) = &self.stations[node]
        else {
            return [[zero; 2], [zero; 2], [zero; 2], [u, turn]];
        };
        let Standing { model, state, .. } = self.standing;
        let mean =
            |of: &dyn Fn(usize) -> Vector3<f64>| of(leading[0]) * weights[0] + of(leading[1]) * weights[1];
        let place = |node: usize| model.nodes[node] + state.displacement[node];
        let leading_moved = mean(&|node| mode.displacement[node]);
        let twist = mean(&|node| mode.rotation[node]).dot(span);
        let twisted = twist * span.cross(&(place(node) - mean(&place)));
        let flapped = Vector3::z() * leading_moved.z;
        let edged = leading_moved - flapped;
        let rest = u - twisted - leading_moved;
        if !self.on_edge[node] {
            return [[twisted, zero], [flapped, zero], [edged, zero], [rest, turn]];
        }
        let about_span = turn.dot(span) * span;
        let about_normal = Vector3::z() * (turn - about_span).z;
        let about_chord = turn - about_span - about_normal;
        [
            [twisted, about_span],
            [flapped, about_chord],
            [edged, about_normal],
            [rest, zero],
        ]
    }
}

/// Displacements and rotations of the nodes by freedom.
fn freedoms(pattern: &Pattern, motion: impl Iterator<Item = [Vector3<f64>; 2]>) -> Vec<f64> {
    let mut all = vec![0.0; pattern.len()];
    for (node, [moved, turned]) in motion.enumerate() {
        for i in 0..3 {
            all[pattern.freedom(node, i)] = moved[i];
            all[pattern.freedom(node, 3 + i)] = turned[i];
        }
    }
    all
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Planform;
    use crate::input::Design;
    use crate::mesh::generate;
    use crate::progress::Progress;
    use crate::structure::{MassProperties, Vibration};

    const FILM: &str = "[film]\nmaterial = 'steel'\nthickness_mm = 0.05\n";

    fn standing(film: &str) -> (Mesh, Standing) {
        let text = format!(
            "format = 1\nname = 'w'\n[planform]\nlength_mm = 70.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\n\
             [[rod]]\nfrom_mm = 0.0\nto_mm = 69.0\nmaterial = 'steel'\nsection = {{ shape = 'round', diameter_mm = 1.0 }}\n\
             [material.steel]\ne_gpa = 200.0\npoisson = 0.3\ndensity_kg_m3 = 7800.0\n{film}"
        );
        let design = Design::from_toml(&text, "w.toml").unwrap();
        let planform = Planform::from_design(&design).unwrap();
        let mesh = generate(&design, &planform).unwrap();
        let standing = Standing::unloaded(&design, &mesh, None, &Progress::quiet()).unwrap();
        (mesh, standing)
    }

    fn imposed(standing: &Standing, motion: impl Fn(&Vector3<f64>) -> [Vector3<f64>; 2]) -> Mode {
        let (displacement, rotation) = standing
            .model
            .nodes
            .iter()
            .map(motion)
            .map(|[u, turn]| (u, turn))
            .unzip();
        Mode {
            frequency_hz: 1.0,
            displacement,
            rotation,
        }
    }

    #[test]
    fn a_pure_motion_of_one_kind_is_all_of_that_kind() {
        let (mesh, standing) = standing(FILM);
        let reader = ModeReader::new(&mesh, &standing, &[]);
        let zero = Vector3::zeros();
        let share = |motion: &dyn Fn(&Vector3<f64>) -> [Vector3<f64>; 2]| {
            reader.read(&imposed(&standing, motion)).share
        };
        let flap = share(&|p| [Vector3::z() * p.x * p.x, zero]);
        assert!(flap.flap > 0.999_99, "{flap:?}");
        let edge = share(&|p| [Vector3::y() * p.x * p.x, zero]);
        assert!(edge.edge > 0.999_99, "{edge:?}");
        let twist = share(&|p| [Vector3::z() * p.x * p.y, Vector3::x() * p.x]);
        assert!(twist.twist > 0.999, "{twist:?}");
        // sagging off a rod that stands still
        let film = share(&|p| [Vector3::z() * p.y * p.y, zero]);
        assert!(film.film > 0.999_99, "{film:?}");
    }

    #[test]
    fn turning_of_a_bare_rod_is_twist() {
        let (mesh, standing) = standing("");
        let reader = ModeReader::new(&mesh, &standing, &[]);
        let mode = imposed(&standing, |p| [Vector3::zeros(), Vector3::x() * p.x]);
        assert!(reader.read(&mode).share.twist > 0.999_99);
    }

    #[test]
    fn effective_masses_of_all_modes_add_up_to_the_mass_and_the_moment_of_inertia() {
        // of a bare rod; 40 modes bend some 20 times in each plane, which leaves 4/(20 π²) of the mass
        let (mesh, standing) = standing("");
        let axis = (Vector3::zeros(), Vector3::y());
        let reader = ModeReader::new(&mesh, &standing, &[axis]);
        let Vibration::Stable(modes) = standing.modes(40, &Progress::quiet()).unwrap() else {
            panic!("unstable");
        };
        let read: Vec<ModeReading> = modes.iter().map(|mode| reader.read(mode)).collect();
        let whole = MassProperties::of(&standing.model, &standing.state);
        for k in 1..3 {
            let sum: f64 = read.iter().map(|mode| mode.effective_mass_kg[k]).sum();
            let missing = 1.0 - sum / whole.mass_kg;
            assert!((0.0..0.04).contains(&missing), "{k} {missing}");
        }
        let sum: f64 = read.iter().map(|mode| mode.effective_inertia_kg_m2[0]).sum();
        let about = whole.about_kg_m2(&axis.0, &axis.1);
        assert!((sum / about - 1.0).abs() < 1e-3, "{sum} {about}");
        // the first bending of a uniform cantilever carries 61.31 % of its mass (Blevins 1979)
        let first = read[0].effective_mass_kg;
        let pair = first[1] + first[2];
        assert!(
            (pair / whole.mass_kg - 0.6131).abs() < 1e-3,
            "{}",
            pair / whole.mass_kg
        );
    }
}
