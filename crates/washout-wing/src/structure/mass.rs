//! Mass: the consistent mass matrix, total mass, centre of mass and moments of inertia.
//!
//! Beams: cubic deflection with rotary inertia, linear stretch and twist (Archer, J. Struct. Div. ASCE 89 (1963)
//! 161-178), integrated exactly; of fourth order in the element size for slender beams (shear strains of the section do
//! not enter the shape of the motion). Shells: linear motion of the middle surface and linear rotation of the normal
//! (ρt³/12), of second order. The motion is that of the deformed elements, the masses are those at rest.

use nalgebra::{Matrix3, SMatrix, UnitQuaternion, Vector3};

use super::beam::Beam;
use super::model::{Model, PointMass};
use super::pattern::Pattern;
use super::rotation::skew;
use super::section::Section;
use super::sheet::Sheet;
use super::state::State;

/// Values of the mass matrix on `pattern` (lower triangle; kg, kg·m, kg·m²), held freedoms included.
///
/// `across_kg_m2`: mass per area of each shell that only resists motion along its normal, such as air that it moves; may
/// be shorter than the shells, the rest then have none.
pub fn mass_matrix(model: &Model, pattern: &Pattern, state: &State, across_kg_m2: &[f64]) -> Vec<f64> {
    let mut values = vec![0.0; pattern.entries()];
    for (index, beam) in model.beams.iter().enumerate() {
        let mass = beam_mass(model, beam, state);
        pattern.add_beam(&mut values, index, beam.nodes, |i, j| mass[(i, j)]);
    }
    for (index, shell) in model.shells.iter().enumerate() {
        let (u, _) = model.shell_state(shell, state);
        let normal = shell.normal(&u);
        let across = across_kg_m2.get(index).copied().unwrap_or(0.0);
        let [moving, turning] = sheet_mass(&model.sheets[shell.sheet], across, &normal);
        let share = shell.area_m2() / 12.0;
        pattern.add_shell(&mut values, index, shell.nodes, |i, j| {
            let share = if i / 6 == j / 6 { 2.0 * share } else { share };
            match (i % 6, j % 6) {
                (i @ 0..3, j @ 0..3) => share * moving[(i, j)],
                (i @ 3..6, j @ 3..6) => share * turning[(i - 3, j - 3)],
                _ => 0.0,
            }
        });
    }
    for mass in &model.masses {
        let block = mass.matrix(&state.rotation[mass.node]);
        pattern.add_node(&mut values, mass.node, |i, j| block[(i, j)]);
    }
    values
}

/// Mass per area of a sheet against motion (kg/m²) and against rotation of its normal (kg).
fn sheet_mass(sheet: &Sheet, across_kg_m2: f64, normal: &Vector3<f64>) -> [Matrix3<f64>; 2] {
    let per_area = sheet.density_kg_m3 * sheet.thickness_m;
    let along_normal = normal * normal.transpose();
    let rotary = per_area * sheet.thickness_m.powi(2) / 12.0;
    [
        per_area * Matrix3::identity() + across_kg_m2 * along_normal,
        rotary * (Matrix3::identity() - along_normal),
    ]
}

/// Places and weights of Gauss's rule on 0..1, exact to degree 7.
const GAUSS: [(f64, f64); 4] = [
    (0.069_431_844_202_973_71, 0.173_927_422_568_726_93),
    (0.330_009_478_207_571_87, 0.326_072_577_431_273_07),
    (0.669_990_521_792_428_1, 0.326_072_577_431_273_07),
    (0.930_568_155_797_026_3, 0.173_927_422_568_726_93),
];

fn beam_mass(model: &Model, beam: &Beam, state: &State) -> SMatrix<f64, 12, 12> {
    let section = &model.sections[beam.section];
    let (u, q) = model.beam_state(beam, state);
    let [a, b] = [0, 1].map(|end: usize| model.nodes[beam.nodes[end]] + u[end]);
    let local = local_mass(section, beam.length_m(), (b - a).norm());
    let mut turn = SMatrix::<f64, 12, 12>::zeros();
    for block in 0..4 {
        turn.fixed_view_mut::<3, 3>(3 * block, 3 * block)
            .copy_from(&beam.deformed_axes(&u, &q).transpose());
    }
    turn.transpose() * local * turn
}

/// Mass of a straight beam along e₁ for (u₁, θ₁, u₂, θ₂), with the mass of `rest_m` on a length of `length_m`.
fn local_mass(section: &Section, rest_m: f64, length_m: f64) -> SMatrix<f64, 12, 12> {
    let l = length_m;
    let mut mass = SMatrix::<f64, 12, 12>::zeros();
    for (s, weight) in GAUSS {
        // cubics and their slopes for displacement and slope at either end
        let cubic = [
            1.0 - s * s * (3.0 - 2.0 * s),
            l * s * (1.0 - s) * (1.0 - s),
            s * s * (3.0 - 2.0 * s),
            -l * s * s * (1.0 - s),
        ];
        let slope = [
            -6.0 * s * (1.0 - s) / l,
            (1.0 - s) * (1.0 - 3.0 * s),
            6.0 * s * (1.0 - s) / l,
            s * (3.0 * s - 2.0),
        ];
        let (mut moved, mut turned) = (SMatrix::<f64, 3, 12>::zeros(), SMatrix::<f64, 3, 12>::zeros());
        for (node, linear) in [(0, 1.0 - s), (1, s)] {
            let (at, k) = (6 * node, 2 * node);
            moved[(0, at)] = linear;
            turned[(0, at + 3)] = linear;
            // slope of the motion along e₂ is a turn about e₃, of that along e₃ one about −e₂
            moved[(1, at + 1)] = cubic[k];
            moved[(1, at + 5)] = cubic[k + 1];
            moved[(2, at + 2)] = cubic[k];
            moved[(2, at + 4)] = -cubic[k + 1];
            turned[(2, at + 1)] = slope[k];
            turned[(2, at + 5)] = slope[k + 1];
            turned[(1, at + 2)] = -slope[k];
            turned[(1, at + 4)] = slope[k + 1];
        }
        let inertia = Matrix3::from_diagonal(&section.inertia_kg_m);
        mass += weight
            * rest_m
            * (section.mass_kg_m * moved.transpose() * moved + turned.transpose() * inertia * turned);
    }
    mass
}

impl PointMass {
    /// Mass matrix of its node's six freedoms, with the node turned.
    fn matrix(&self, turn: &UnitQuaternion<f64>) -> SMatrix<f64, 6, 6> {
        let mut moved = SMatrix::<f64, 3, 6>::zeros();
        moved.fixed_view_mut::<3, 3>(0, 0).fill_with_identity();
        moved
            .fixed_view_mut::<3, 3>(0, 3)
            .copy_from(&-skew(&(turn * self.arm_m)));
        let mut mass = self.mass_kg * moved.transpose() * moved;
        let mut about = mass.fixed_view_mut::<3, 3>(3, 3);
        about += self.turned_inertia(turn);
        mass
    }

    fn turned_inertia(&self, turn: &UnitQuaternion<f64>) -> Matrix3<f64> {
        let turn = turn.to_rotation_matrix();
        turn.matrix() * Matrix3::from_diagonal(&self.inertia_kg_m2) * turn.matrix().transpose()
    }
}

/// Mass, centre of mass and inertia of a structure in one shape.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct MassProperties {
    /// Total mass, kg.
    pub mass_kg: f64,
    /// Centre of mass, wing frame, m; the origin without mass.
    pub centre_m: Vector3<f64>,
    /// Inertia tensor about the centre of mass, wing frame, kg·m².
    pub inertia_kg_m2: Matrix3<f64>,
}

impl MassProperties {
    /// Of a structure in a shape, by exact integration over straight beams and plane triangles.
    pub fn of(model: &Model, state: &State) -> Self {
        let at = |node: usize| model.nodes[node] + state.displacement[node];
        let mut sum = Sum::default();
        for beam in &model.beams {
            let section = &model.sections[beam.section];
            let (u, q) = model.beam_state(beam, state);
            let [a, b] = beam.nodes.map(at);
            let mass = section.mass_kg_m * beam.length_m();
            let axes = beam.deformed_axes(&u, &q);
            let own = axes * Matrix3::from_diagonal(&section.inertia_kg_m) * axes.transpose();
            // Simpson's rule is exact for the square of the distance
            sum.add(mass / 6.0, &a, &Matrix3::zeros());
            sum.add(mass / 1.5, &(0.5 * (a + b)), &(own * beam.length_m()));
            sum.add(mass / 6.0, &b, &Matrix3::zeros());
        }
        for shell in model.shells.iter() {
            let (u, _) = model.shell_state(shell, state);
            let [moving, turning] = sheet_mass(&model.sheets[shell.sheet], 0.0, &shell.normal(&u));
            let share = shell.area_m2() / 3.0;
            let corners = shell.nodes.map(at);
            for side in 0..3 {
                // the middles of the sides are exact for squares
                let middle = 0.5 * (corners[side] + corners[(side + 1) % 3]);
                sum.add(share * moving[(0, 0)], &middle, &(share * turning));
            }
        }
        for mass in &model.masses {
            let turn = &state.rotation[mass.node];
            let place = at(mass.node) + turn * mass.arm_m;
            sum.add(mass.mass_kg, &place, &mass.turned_inertia(turn));
        }
        sum.finish()
    }

    /// Moment of inertia about the axis through `point` (m) along `direction`, kg·m².
    pub fn about_kg_m2(&self, point: &Vector3<f64>, direction: &Vector3<f64>) -> f64 {
        let direction = direction.normalize();
        let arm = (self.centre_m - point).cross(&direction).norm_squared();
        direction.dot(&(self.inertia_kg_m2 * direction)) + self.mass_kg * arm
    }
}

#[derive(Default)]
struct Sum {
    mass: f64,
    first: Vector3<f64>,
    /// About the origin.
    inertia: Matrix3<f64>,
}

impl Sum {
    fn add(&mut self, mass: f64, place: &Vector3<f64>, own: &Matrix3<f64>) {
        self.mass += mass;
        self.first += mass * place;
        self.inertia += own + mass * parallel(place);
    }

    fn finish(self) -> MassProperties {
        let centre_m = if self.mass > 0.0 {
            self.first / self.mass
        } else {
            Vector3::zeros()
        };
        MassProperties {
            mass_kg: self.mass,
            centre_m,
            inertia_kg_m2: self.inertia - self.mass * parallel(&centre_m),
        }
    }
}

/// Inertia about the origin of a unit mass at a place, |r|² 1 − r rᵀ, written as S(r)ᵀ S(r).
fn parallel(place: &Vector3<f64>) -> Matrix3<f64> {
    let across = skew(place);
    across.transpose() * across
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::section::BeamMaterial;
    use crate::structure::sheet::Compression;

    const CARBON: BeamMaterial = BeamMaterial {
        e_pa: 134e9,
        g_pa: 4e9,
        density_kg_m3: 1500.0,
    };

    /// A bent beam, two triangles and a mass on an arm, moved and turned rigidly by `turn`.
    fn frame(turn: &UnitQuaternion<f64>) -> (Model, State) {
        let nodes: Vec<Vector3<f64>> = [
            [0.0, 0.0, 0.0],
            [0.03, 0.0, 0.0],
            [0.07, 0.01, 0.005],
            [0.01, 0.02, 0.0],
            [0.04, 0.025, 0.003],
        ]
        .map(Vector3::from)
        .to_vec();
        let mut model = Model::new(nodes);
        let section = model.add_section(Section::half_round(5e-4, true, &CARBON));
        for ends in [[0, 1], [1, 2]] {
            model.add_beam(ends, &Vector3::z(), section).unwrap();
        }
        let sheet = model.add_sheet(Sheet {
            e_pa: 2.5e9,
            poisson: 0.34,
            thickness_m: 1e-3,
            density_kg_m3: 1420.0,
            pretension_n_per_m: 0.0,
            compression: Compression::Carries,
        });
        for corners in [[0, 1, 3], [1, 4, 3]] {
            model.add_shell(corners, sheet).unwrap();
        }
        model.masses.push(PointMass {
            node: 2,
            arm_m: Vector3::new(0.001, -0.004, 0.002),
            mass_kg: 3e-5,
            inertia_kg_m2: Vector3::new(1e-10, 2e-10, 4e-10),
        });
        let displacement = model.nodes.iter().map(|x| turn * x - x).collect();
        let rotation = vec![*turn; model.nodes.len()];
        (
            model,
            State {
                displacement,
                rotation,
            },
        )
    }

    /// Kinetic energy of the nodes turning at `spin` about `point` and moving at `velocity`.
    fn energy(
        model: &Model,
        state: &State,
        velocity: &Vector3<f64>,
        spin: &Vector3<f64>,
        point: &Vector3<f64>,
    ) -> f64 {
        let pattern = model.pattern();
        let mass = mass_matrix(model, &pattern, state, &[]);
        let mut motion = vec![0.0; pattern.len()];
        for node in 0..model.nodes.len() {
            let at = model.nodes[node] + state.displacement[node];
            let v = velocity + spin.cross(&(at - point));
            for i in 0..3 {
                motion[pattern.freedom(node, i)] = v[i];
                motion[pattern.freedom(node, 3 + i)] = spin[i];
            }
        }
        let momentum = pattern.multiply(&mass, &motion);
        0.5 * momentum.iter().zip(&motion).map(|(p, v)| p * v).sum::<f64>()
    }

    #[test]
    fn rigid_motion_has_the_energy_of_the_mass_and_the_moment_of_inertia() {
        let turn = UnitQuaternion::new(Vector3::new(0.4, -1.2, 0.7));
        for turn in [UnitQuaternion::identity(), turn] {
            let (model, state) = frame(&turn);
            let properties = MassProperties::of(&model, &state);
            for direction in [
                Vector3::x(),
                Vector3::y(),
                Vector3::z(),
                Vector3::new(1.0, -2.0, 0.5),
            ] {
                let translation = energy(&model, &state, &direction, &Vector3::zeros(), &Vector3::zeros());
                let exact = 0.5 * properties.mass_kg * direction.norm_squared();
                assert!((translation / exact - 1.0).abs() < 1e-12, "{direction}");
                let point = Vector3::new(-0.038, 0.01, 0.002);
                let rotation = energy(&model, &state, &Vector3::zeros(), &direction, &point);
                let about = properties.about_kg_m2(&point, &direction);
                let exact = 0.5 * about * direction.norm_squared();
                assert!(
                    (rotation / exact - 1.0).abs() < 1e-12,
                    "{direction} {rotation} {exact}"
                );
            }
        }
    }

    #[test]
    fn inertia_turns_with_the_structure_and_mass_does_not_change() {
        let turn = UnitQuaternion::new(Vector3::new(0.4, -1.2, 0.7));
        let (model, state) = frame(&turn);
        let rest = MassProperties::of(&model, &State::at_rest(model.nodes.len()));
        let moved = MassProperties::of(&model, &state);
        let r = turn.to_rotation_matrix();
        let turned = r.matrix() * rest.inertia_kg_m2 * r.matrix().transpose();
        assert!((turned - moved.inertia_kg_m2).norm() < 1e-12 * turned.norm());
        assert!((turn * rest.centre_m - moved.centre_m).norm() < 1e-15);
        assert_eq!(rest.mass_kg, moved.mass_kg);
    }

    #[test]
    fn properties_of_a_rod_a_square_plate_and_a_ball_are_the_closed_forms() {
        let (l, a, t, rho) = (0.07, 0.02, 1e-3, 1420.0);
        let mut model = Model::new([[0.0; 3], [l, 0.0, 0.0]].map(Vector3::from).to_vec());
        let section = model.add_section(Section::round(5e-4, &CARBON));
        model.add_beam([0, 1], &Vector3::z(), section).unwrap();
        let rod = MassProperties::of(&model, &State::at_rest(2));
        let mass = 1500.0 * std::f64::consts::PI * 2.5e-7 * l;
        assert!((rod.mass_kg / mass - 1.0).abs() < 1e-14);
        // solid cylinder: m(3a² + l²)/12 across, m a²/2 along
        let across = mass * (3.0 * 2.5e-7 + l * l) / 12.0;
        assert!((rod.inertia_kg_m2[(1, 1)] / across - 1.0).abs() < 1e-12);
        assert!((rod.inertia_kg_m2[(0, 0)] / (mass * 2.5e-7 / 2.0) - 1.0).abs() < 1e-12);
        let corners = [[0.0, 0.0, 0.0], [a, 0.0, 0.0], [a, a, 0.0], [0.0, a, 0.0]];
        let mut model = Model::new(corners.map(Vector3::from).to_vec());
        let sheet = model.add_sheet(Sheet {
            e_pa: 2.5e9,
            poisson: 0.34,
            thickness_m: t,
            density_kg_m3: rho,
            pretension_n_per_m: 0.0,
            compression: Compression::Carries,
        });
        for nodes in [[0, 1, 2], [0, 2, 3]] {
            model.add_shell(nodes, sheet).unwrap();
        }
        let plate = MassProperties::of(&model, &State::at_rest(4));
        let mass = rho * t * a * a;
        assert!((plate.mass_kg / mass - 1.0).abs() < 1e-14);
        assert!((plate.inertia_kg_m2[(0, 0)] / (mass * (a * a + t * t) / 12.0) - 1.0).abs() < 1e-12);
        assert!((plate.inertia_kg_m2[(2, 2)] / (mass * 2.0 * a * a / 12.0) - 1.0).abs() < 1e-12);
        let about_side = plate.about_kg_m2(&Vector3::zeros(), &Vector3::x());
        assert!((about_side / (mass * (a * a / 3.0 + t * t / 12.0)) - 1.0).abs() < 1e-12);
        assert!((plate.centre_m - Vector3::new(a / 2.0, a / 2.0, 0.0)).norm() < 1e-16);
    }

    #[test]
    fn mass_across_a_shell_resists_motion_along_its_normal_alone() {
        let (model, state) = frame(&UnitQuaternion::identity());
        let pattern = model.pattern();
        let [without, with] = [&[][..], &[0.02, 0.0][..]].map(|a| mass_matrix(&model, &pattern, &state, a));
        let added: Vec<f64> = with.iter().zip(&without).map(|(a, b)| a - b).collect();
        for (component, expected) in [(0, 0.0), (2, 0.02 * model.shells[0].area_m2())] {
            let mut motion = vec![0.0; pattern.len()];
            for node in 0..model.nodes.len() {
                motion[pattern.freedom(node, component)] = 1.0;
            }
            let momentum = pattern.multiply(&added, &motion);
            let mass: f64 = momentum.iter().zip(&motion).map(|(p, v)| p * v).sum();
            assert!((mass - expected).abs() < 1e-15, "{component} {mass} {expected}");
        }
    }
}
