//! Local refinement by bisecting longest edges (Rivara 1984): angles stay above half of the smallest before.

/// A plane mesh that is being refined: nodes, triangles and the chains of nodes that follow its lines.
#[derive(Debug, Clone, PartialEq)]
pub struct Refinable {
    /// Positions, m.
    pub nodes: Vec<[f64; 3]>,
    /// Triangles.
    pub triangles: Vec<[usize; 3]>,
    /// Chains of neighbouring nodes (edges of the wing, spars); new nodes on them are put in.
    pub chains: Vec<Vec<usize>>,
}

impl Refinable {
    /// Refines around `x_m` on the chain `chain`, which runs along x, until a node stands there; its index.
    ///
    /// `None` if the chain does not reach there.
    pub fn put_node_at(&mut self, chain: usize, x_m: f64) -> Option<usize> {
        // Each pass halves the edge that holds x; from a fraction below 0.3 the next one doubles it.
        for _ in 0..64 {
            let nodes = &self.nodes;
            let edge = self.chains[chain]
                .windows(2)
                .find(|w| nodes[w[0]][0] <= x_m && x_m <= nodes[w[1]][0])?;
            let (a, b) = (edge[0], edge[1]);
            if let Some(node) = [a, b].into_iter().find(|&node| nodes[node][0] == x_m) {
                return Some(node);
            }
            let fraction = (x_m - nodes[a][0]) / (nodes[b][0] - nodes[a][0]);
            let middle = self.bisect(a, b);
            if (0.3..=0.7).contains(&fraction) {
                self.nodes[middle][0] = x_m;
                return Some(middle);
            }
        }
        None
    }

    /// Bisects the edge between two nodes, first the longer edges of its triangles; the new node.
    fn bisect(&mut self, a: usize, b: usize) -> usize {
        while let Some((c, d)) = self.longer_neighbour(a, b) {
            self.bisect(c, d);
        }
        let middle = self.nodes.len();
        let (p, q) = (self.nodes[a], self.nodes[b]);
        self.nodes.push(std::array::from_fn(|k| 0.5 * (p[k] + q[k])));
        for index in 0..self.triangles.len() {
            let triangle = self.triangles[index];
            if triangle.contains(&a) && triangle.contains(&b) {
                self.triangles[index] = triangle.map(|node| if node == b { middle } else { node });
                self.triangles
                    .push(triangle.map(|node| if node == a { middle } else { node }));
            }
        }
        for chain in &mut self.chains {
            if let Some(at) = chain.windows(2).position(|w| w == [a, b] || w == [b, a]) {
                chain.insert(at + 1, middle);
            }
        }
        middle
    }

    /// The longest edge of a triangle at the edge a-b, if that is not a-b itself.
    fn longer_neighbour(&self, a: usize, b: usize) -> Option<(usize, usize)> {
        let own = self.squared_length(a, b) * (1.0 + 1e-9);
        self.triangles
            .iter()
            .filter(|t| t.contains(&a) && t.contains(&b))
            .find_map(|&[i, j, k]| {
                let edges = [(i, j), (j, k), (k, i)].map(|(m, n)| (self.squared_length(m, n), m, n));
                let longest = edges
                    .into_iter()
                    .fold(edges[0], |best, edge| if edge.0 > best.0 { edge } else { best });
                (longest.0 > own).then_some((longest.1, longest.2))
            })
    }

    fn squared_length(&self, a: usize, b: usize) -> f64 {
        (0..3)
            .map(|k| (self.nodes[a][k] - self.nodes[b][k]).powi(2))
            .sum()
    }
}

#[cfg(test)]
mod tests {
    use super::Refinable;
    use crate::mesh::{Mesh, Quality};

    #[test]
    fn a_node_very_near_to_another_makes_no_slivers_and_keeps_the_area() {
        for x_m in [1e-4, 0.003, 0.05, 0.21, 0.5, 0.77, 0.9999] {
            let mut mesh = Refinable {
                nodes: vec![[0.0, 0.0, 0.0], [1.0, 0.0, 0.0], [1.0, 1.0, 0.0], [0.0, 1.0, 0.0]],
                triangles: vec![[0, 1, 2], [0, 2, 3]],
                chains: vec![vec![0, 1], vec![3, 2]],
            };
            let node = mesh.put_node_at(0, x_m).unwrap();
            assert_eq!(mesh.nodes[node], [x_m, 0.0, 0.0]);
            assert!(
                mesh.chains[0]
                    .windows(2)
                    .all(|w| mesh.nodes[w[1]][0] > mesh.nodes[w[0]][0])
            );
            let refined = Mesh {
                nodes: mesh.nodes,
                triangles: mesh.triangles,
                ..Mesh::default()
            };
            assert!((refined.area_m2() - 1.0).abs() < 1e-14);
            let quality = Quality::of(&refined);
            assert!(
                quality.smallest_angle_deg > 15.0,
                "{x_m}: {}",
                quality.smallest_angle_deg
            );
            assert!(refined.nodes.len() < 60, "{x_m}: {} nodes", refined.nodes.len());
        }
    }
}
