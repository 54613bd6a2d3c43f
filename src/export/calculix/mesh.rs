//! The mesh of a wing with nodes in the middle of its sides, numbered from 1 as CalculiX wants it.

use std::collections::{BTreeMap, BTreeSet};

use nalgebra::Vector3;

use crate::structure::Model;

/// Nodes and elements of second order. Where a beam runs along the film it has nodes of its own, tied to those of the film:
/// in a node that both shared, CalculiX would make cross-section and edge of the film one rigid body, and then finds no
/// equilibrium of a thin film.
#[derive(Debug, Clone, PartialEq)]
pub struct QuadraticMesh {
    /// Places, mm; node n of the model is number n + 1, the middles of the sides follow.
    pub nodes_mm: Vec<[f64; 3]>,
    /// Node numbers of the triangles: corners, then middles of the sides 12, 23, 31.
    pub triangles: Vec<[usize; 6]>,
    /// Node numbers of the beams: end, middle, end.
    pub beams: Vec<[usize; 3]>,
    /// Node of the beams that each node of the film is tied to.
    pub ties: BTreeMap<usize, usize>,
    /// Sides of one triangle alone: their ends as nodes of the model, and the number of the node in their middle.
    pub rim: Vec<([usize; 2], usize)>,
}

impl QuadraticMesh {
    /// Number of the node that carries the loads and supports of node `index` of the model: that of the beam where there is
    /// one.
    pub fn carrier(&self, index: usize) -> usize {
        let number = index + 1;
        self.ties.get(&number).copied().unwrap_or(number)
    }

    /// That of a model.
    pub fn of(model: &Model) -> Self {
        let mut nodes_mm: Vec<[f64; 3]> = model.nodes.iter().map(|x| (x * 1e3).into()).collect();
        let mut middles: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        let mut middle = |a: usize, b: usize| {
            *middles.entry([a.min(b), a.max(b)]).or_insert_with(|| {
                let between: Vector3<f64> = 500.0 * (model.nodes[a] + model.nodes[b]);
                nodes_mm.push(between.into());
                nodes_mm.len()
            })
        };
        let shells = model.shells.iter().map(|shell| shell.nodes);
        let triangles =
            shells.map(|[a, b, c]| [a + 1, b + 1, c + 1, middle(a, b), middle(b, c), middle(c, a)]);
        let triangles: Vec<[usize; 6]> = triangles.collect();
        let beams = model.beams.iter().map(|beam| beam.nodes);
        let mut beams: Vec<[usize; 3]> = beams.map(|[a, b]| [a + 1, middle(a, b), b + 1]).collect();
        let mut sides: BTreeMap<[usize; 2], usize> = BTreeMap::new();
        for [a, b, c] in model.shells.iter().map(|shell| shell.nodes) {
            for [a, b] in [[a, b], [b, c], [c, a]] {
                *sides.entry([a.min(b), a.max(b)]).or_default() += 1;
            }
        }
        sides.retain(|_, triangles| *triangles == 1);
        let rim = sides.into_keys().map(|[a, b]| ([a, b], middle(a, b)));
        let rim = rim.collect();
        let film: BTreeSet<usize> = triangles.iter().flatten().copied().collect();
        let mut ties = BTreeMap::new();
        for node in beams.iter_mut().flatten().filter(|node| film.contains(node)) {
            *node = *ties.entry(*node).or_insert_with(|| {
                nodes_mm.push(nodes_mm[*node - 1]);
                nodes_mm.len()
            });
        }
        QuadraticMesh {
            nodes_mm,
            triangles,
            beams,
            ties,
            rim,
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::structure::{Compression, Section, Sheet};

    #[test]
    fn a_beam_on_a_side_of_two_triangles_has_nodes_of_its_own_at_their_places() {
        let corners = [
            [0.0, 0.0, 0.0],
            [2e-3, 0.0, 0.0],
            [2e-3, 2e-3, 0.0],
            [0.0, 2e-3, 0.0],
        ];
        let mut model = Model::new(corners.map(Vector3::from).to_vec());
        let sheet = model.add_sheet(Sheet {
            e_pa: 1e9,
            poisson: 0.3,
            thickness_m: 1e-5,
            density_kg_m3: 1.0,
            pretension_n_per_m: 0.0,
            compression: Compression::Carries,
        });
        model.add_shell([0, 1, 2], sheet).unwrap();
        model.add_shell([0, 2, 3], sheet).unwrap();
        let section = model.add_section(Section::uncoupled(1.0, 1.0, 1.0, 1.0));
        model.add_beam([2, 0], &Vector3::z(), section).unwrap();
        let mesh = QuadraticMesh::of(&model);
        assert_eq!(mesh.triangles, [[1, 2, 3, 5, 6, 7], [1, 3, 4, 7, 8, 9]]);
        assert_eq!(mesh.beams, [[10, 11, 12]]);
        let rim = [([0, 1], 5), ([0, 3], 9), ([1, 2], 6), ([2, 3], 8)];
        assert_eq!(mesh.rim, rim);
        assert_eq!(mesh.ties, BTreeMap::from([(3, 10), (7, 11), (1, 12)]));
        assert_eq!((mesh.carrier(0), mesh.carrier(1)), (12, 2));
        assert_eq!(mesh.nodes_mm.len(), 12);
        assert_eq!(
            (mesh.nodes_mm[6], mesh.nodes_mm[10]),
            ([1.0, 1.0, 0.0], [1.0, 1.0, 0.0])
        );
        model.shells = Default::default();
        assert_eq!(QuadraticMesh::of(&model).beams, [[3, 5, 1]]);
    }
}
