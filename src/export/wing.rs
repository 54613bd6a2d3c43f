//! A wing as a VTK grid: the mesh alone, or a solution on its deformed or unloaded shape.
//!
//! Points: `displacement_mm`, `rotation_deg` (rotation vector), `twist_deg`, `pressure_pa`.
//! Cells: `part`, `part_index`, `material`, `section`, `membrane_force_n_per_m`, `principal_tension_n_per_m`,
//! `beam_force_n` (N, V_edge, V_flap), `beam_moment_n_m` (T, M_flap, M_edge), `pressure_pa`.
//! A triangle has no beam force and a beam no membrane force: zeros stand there.

use nalgebra::Vector3;

use crate::coupling::solution::Solution;
use crate::input::design::{Design, Section};
use crate::mesh::{BeamPart, Mesh};
use crate::structure::state::State;

use super::vtu::{Array, Grid};

/// The values of `part`: film 0, rod 1, spar 2, stiff rib 3.
pub const PARTS: [&str; 4] = ["film", "rod", "spar", "rib"];

/// Which of the two shapes of a solution the points stand on.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Shape {
    /// Without load, after cure.
    Unloaded,
    /// Under load.
    Deformed,
}

/// The mesh at rest with its parts, materials and sections.
pub fn mesh_grid(design: &Design, mesh: &Mesh) -> Grid {
    grid(design, mesh, mesh.nodes.iter().map(|&node| Vector3::from(node)))
}

/// The mesh in a shape with its parts, materials and sections.
pub fn shape_grid(design: &Design, mesh: &Mesh, shape: &State) -> Grid {
    let moved = mesh.nodes.iter().zip(&shape.displacement);
    grid(design, mesh, moved.map(|(&node, u)| Vector3::from(node) + u))
}

/// A solution with all its arrays; displacement, rotation and twist count from the unloaded shape.
///
/// `twist_deg`: one value per node, the twist of the chord line through it.
pub fn solution_grid(design: &Design, solution: &Solution, twist_deg: Vec<f64>, shape: Shape) -> Grid {
    let mesh = &solution.mesh;
    let state = match shape {
        Shape::Unloaded => &solution.rest,
        Shape::Deformed => &solution.state,
    };
    let mut grid = shape_grid(design, mesh, state);
    let (triangles, beams) = (mesh.triangles.len(), mesh.beams.len());

    grid.point_arrays = vec![
        Array::vector(
            "displacement_mm",
            &displacement_mm(&solution.rest, &solution.state),
        ),
        Array::vector("rotation_deg", &rotation_deg(&solution.rest, &solution.state)),
        Array::scalar("twist_deg", twist_deg),
        Array::scalar("pressure_pa", pressure_at_nodes(mesh, &solution.pressure_pa)),
    ];
    // a wing of ribs has no film: its triangles carry nothing
    let mut membrane = solution.membrane_force_n_per_m.clone();
    membrane.resize(triangles, [0.0; 3]);
    let on_triangles = |values: Vec<[f64; 3]>| [values, vec![[0.0; 3]; beams]].concat();
    let on_beams = |first: usize| {
        let values = solution
            .beam_force
            .iter()
            .map(|f| [f[first], f[first + 1], f[first + 2]]);
        let mut all = vec![[0.0; 3]; triangles];
        all.extend(values);
        all
    };
    let mut principal: Vec<[f64; 2]> = membrane.iter().map(|&force| principal_tension(force)).collect();
    principal.resize(principal.len() + beams, [0.0; 2]);
    grid.cell_arrays.extend([
        Array::vector("membrane_force_n_per_m", &on_triangles(membrane)),
        Array::vector("principal_tension_n_per_m", &principal),
        Array::vector("beam_force_n", &on_beams(0)),
        Array::vector("beam_moment_n_m", &on_beams(3)),
        Array::scalar(
            "pressure_pa",
            [solution.pressure_pa.clone(), vec![0.0; beams]].concat(),
        ),
    ]);
    grid
}

/// A wing that moves, without the forces in its structure; `in_space` takes its points (m) from the rod's frame to where they
/// are shown. Displacement, rotation and twist count from the unloaded shape in the rod's frame.
pub fn moving_grid(
    design: &Design,
    solution: &Solution,
    twist_deg: Vec<f64>,
    in_space: impl Fn(&Vector3<f64>) -> Vector3<f64>,
) -> Grid {
    let Solution {
        mesh, rest, state, ..
    } = solution;
    let moved = mesh.nodes.iter().zip(&state.displacement);
    let mut grid = grid(
        design,
        mesh,
        moved.map(|(&node, u)| in_space(&(Vector3::from(node) + u))),
    );
    grid.point_arrays = vec![
        Array::vector("displacement_mm", &displacement_mm(rest, state)),
        Array::vector("rotation_deg", &rotation_deg(rest, state)),
        Array::scalar("twist_deg", twist_deg),
        Array::scalar("pressure_pa", pressure_at_nodes(mesh, &solution.pressure_pa)),
    ];
    grid
}

/// What the numbers in `material` and `section` of the cells mean.
#[derive(Debug, Clone, PartialEq)]
pub struct Legend<'a> {
    /// Materials in the order of their numbers.
    pub materials: Vec<&'a str>,
    /// Sections in the order of their numbers; rod first, each distinct section once.
    pub sections: Vec<&'a Section>,
}

impl<'a> Legend<'a> {
    /// The materials and sections of a design.
    pub fn of(design: &'a Design) -> Self {
        let mut sections: Vec<&Section> = Vec::new();
        let rods = design.rod.iter().map(|rod| &rod.section);
        for section in rods.chain(design.spar.iter().map(|spar| &spar.section)) {
            if !sections.contains(&section) {
                sections.push(section);
            }
        }
        Legend {
            materials: design.material.keys().map(String::as_str).collect(),
            sections,
        }
    }

    /// Number of a material; -1 where there is none. A laminate counts as its first ply.
    fn material(&self, name: Option<&str>, section: Option<&Section>) -> i32 {
        let ply = match section {
            Some(Section::Laminate { plies, .. }) => plies.first().map(|ply| ply.material.as_str()),
            _ => None,
        };
        let name = ply.or(name);
        let found = self.materials.iter().position(|&known| Some(known) == name);
        found.map_or(-1, |index| index as i32)
    }

    fn section(&self, section: &Section) -> i32 {
        let found = self.sections.iter().position(|&known| known == section);
        found.map_or(-1, |index| index as i32)
    }
}

fn grid(design: &Design, mesh: &Mesh, positions_m: impl Iterator<Item = Vector3<f64>>) -> Grid {
    let legend = Legend::of(design);
    let film = legend.material(design.film.as_ref().map(|film| film.material.as_str()), None);
    let mut cells: Vec<[i32; 4]> = vec![[0, 0, film, -1]; mesh.triangles.len()];
    for beam in &mesh.beams {
        let (part, index, material, section) = match beam.part {
            BeamPart::Rib(index) => (3, index, None, None),
            BeamPart::Rod(index) => {
                let rod = design.rod.get(index);
                (
                    1,
                    index,
                    rod.and_then(|rod| rod.material.as_deref()),
                    rod.map(|rod| &rod.section),
                )
            }
            BeamPart::Spar(index) => {
                let spar = design.spar.get(index);
                (
                    2,
                    index,
                    spar.and_then(|spar| spar.material.as_deref()),
                    spar.map(|spar| &spar.section),
                )
            }
        };
        let number = section.map_or(-1, |section| legend.section(section));
        cells.push([part, index as i32, legend.material(material, section), number]);
    }
    let column = |index: usize| cells.iter().map(|cell| cell[index]).collect();
    Grid {
        points_mm: positions_m.map(|x| (x * 1e3).into()).collect(),
        triangles: mesh.triangles.clone(),
        lines: mesh.beams.iter().map(|beam| beam.nodes).collect(),
        point_arrays: Vec::new(),
        cell_arrays: vec![
            Array::index("part", column(0)),
            Array::index("part_index", column(1)),
            Array::index("material", column(2)),
            Array::index("section", column(3)),
        ],
    }
}

/// Displacement of each node from the unloaded shape, mm, wing frame.
pub fn displacement_mm(rest: &State, state: &State) -> Vec<[f64; 3]> {
    let pairs = rest.displacement.iter().zip(&state.displacement);
    pairs
        .map(|(rest, loaded)| ((loaded - rest) * 1e3).into())
        .collect()
}

fn rotation_deg(rest: &State, state: &State) -> Vec<[f64; 3]> {
    let pairs = rest.rotation.iter().zip(&state.rotation);
    pairs
        .map(|(rest, loaded)| ((loaded * rest.inverse()).scaled_axis() * 1f64.to_degrees()).into())
        .collect()
}

/// Mean of the triangles around each node, weighted by their areas; zero where there are none.
fn pressure_at_nodes(mesh: &Mesh, pressure_pa: &[f64]) -> Vec<f64> {
    let mut sum = vec![[0.0; 2]; mesh.nodes.len()];
    for (nodes, pressure) in mesh.triangles.iter().zip(pressure_pa) {
        let [a, b, c] = nodes.map(|node| Vector3::from(mesh.nodes[node]));
        let area = 0.5 * (b - a).cross(&(c - a)).norm();
        for &node in nodes {
            sum[node][0] += area * pressure;
            sum[node][1] += area;
        }
    }
    let mean = |[load, area]: [f64; 2]| if area > 0.0 { load / area } else { 0.0 };
    sum.into_iter().map(mean).collect()
}

/// Larger and smaller principal value of N_x, N_y, N_xy.
fn principal_tension([x, y, xy]: [f64; 3]) -> [f64; 2] {
    let (mean, radius) = (0.5 * (x + y), (0.5 * (x - y)).hypot(xy));
    [mean + radius, mean - radius]
}

#[cfg(test)]
mod tests {
    use super::*;
    use nalgebra::UnitQuaternion;

    #[test]
    fn principal_tensions_of_pure_shear_are_plus_and_minus_the_shear() {
        assert_eq!(principal_tension([0.0, 0.0, 7.0]), [7.0, -7.0]);
        assert_eq!(principal_tension([2.0, 10.0, 3.0]), [11.0, 1.0]);
    }

    #[test]
    fn pressure_at_a_node_is_the_mean_by_area() {
        let mesh = Mesh {
            nodes: vec![
                [0.0; 3],
                [1.0, 0.0, 0.0],
                [0.0, 1.0, 0.0],
                [-3.0, 0.0, 0.0],
                [9.0; 3],
            ],
            triangles: vec![[0, 1, 2], [0, 2, 3]],
            ..Mesh::default()
        };
        let nodes = pressure_at_nodes(&mesh, &[8.0, 0.0]);
        assert_eq!(nodes, [2.0, 8.0, 2.0, 0.0, 0.0]);
    }

    #[test]
    fn rotation_and_displacement_count_from_the_unloaded_shape() {
        let mut rest = State::at_rest(1);
        let mut state = State::at_rest(1);
        rest.rotation[0] = UnitQuaternion::from_scaled_axis(Vector3::y() * 0.4);
        state.rotation[0] = UnitQuaternion::from_scaled_axis(Vector3::x() * 0.1) * rest.rotation[0];
        rest.displacement[0].z = 1e-3;
        state.displacement[0].z = 3e-3;
        let [x, y, z] = rotation_deg(&rest, &state)[0];
        assert!((x - 0.1f64.to_degrees()).abs() < 1e-12 && y.abs() < 1e-12 && z.abs() < 1e-12);
        assert!((displacement_mm(&rest, &state)[0][2] - 2.0).abs() < 1e-12);
    }
}
