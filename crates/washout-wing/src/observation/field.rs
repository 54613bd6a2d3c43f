//! Twist at every node, for pictures: the rotation of the chord line through it.

use std::collections::BTreeMap;

use crate::coupling::solution::Solution;
use crate::geometry::Planform;
use crate::mesh::ChordLines;

use super::edges::edges_at;
use super::observer::chord_rotation_rad;

/// Rotation of the chord line through each node about the span axis, rad, from the unloaded shape.
///
/// It is defined wherever the wing has a chord, however short; a profile leaves short chords out.
pub fn twist_at_nodes(planform: &Planform, solution: &Solution) -> Vec<f64> {
    let Solution {
        mesh, rest, state, ..
    } = solution;
    let lines = ChordLines::new(mesh);
    let read = |r_m: f64| {
        let [unloaded, loaded] = edges_at(mesh, &lines, [rest, state], r_m, planform.chord_m(r_m))?;
        Some(chord_rotation_rad(&unloaded, &loaded))
    };
    // The film may end a hair before the outermost node of the rod.
    let (mut known, mut latest) = (BTreeMap::new(), 0.0);
    let mut order: Vec<f64> = mesh.nodes.iter().map(|node| node[0]).collect();
    order.sort_by(f64::total_cmp);
    for r_m in order {
        known.entry(r_m.to_bits()).or_insert_with(|| {
            latest = read(r_m).unwrap_or(latest);
            latest
        });
    }
    mesh.nodes.iter().map(|node| known[&node[0].to_bits()]).collect()
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observation::imposed::{design, wing};

    #[test]
    fn every_node_of_a_column_has_the_twist_imposed_on_it() {
        let twist_rad = |r_m: f64| 6.0 * r_m;
        let (planform, solution) = wing(&design(""), twist_rad, |_| [0.0, 0.0]);
        let found = twist_at_nodes(&planform, &solution);
        assert_eq!(found.len(), solution.mesh.nodes.len());
        for (node, twist) in solution.mesh.nodes.iter().zip(found) {
            // Between two columns the film is straight: a chord of the imposed curve.
            assert!((twist - twist_rad(node[0])).abs() < 2e-3, "{node:?} {twist}");
        }
    }
}
