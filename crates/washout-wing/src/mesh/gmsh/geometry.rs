//! The outline of a mesh as a Gmsh geometry, to be meshed anew by Gmsh with elements of another size or kind.

use std::collections::{BTreeMap, BTreeSet};
use std::fmt::Write;

use crate::mesh::names::SetName;
use crate::mesh::{BeamPart, Mesh};

/// Share of the length of a line by which its nodes may stand beside it and it still counts as straight.
const STRAIGHT: f64 = 1e-9;

/// The geometry in metres: leading and trailing edge cut where rods and spars end, the film between them, spars and ribs within
/// it, all with the names of sets that [`super::read()`] knows. `gmsh -2 -format msh41` makes a mesh of it, `-clscale` or the `h` on
/// top another size. `None` without a film.
pub fn geometry(mesh: &Mesh) -> Option<String> {
    let (&base, &tip) = (mesh.leading_edge.first()?, mesh.leading_edge.last()?);
    let (&inner, &outer) = (mesh.trailing_edge.first()?, mesh.trailing_edge.last()?);
    if mesh.triangles.is_empty() {
        return None;
    }
    let mut drawing = Drawing {
        mesh,
        curves: Vec::new(),
        sets: BTreeMap::new(),
    };
    let chains = chains(mesh);
    let mut corners: BTreeSet<usize> = [base, tip, inner, outer].into();
    corners.extend(
        chains
            .iter()
            .flat_map(|(_, nodes)| [nodes[0], nodes[nodes.len() - 1]]),
    );
    let leading = drawing.cut(&mesh.leading_edge, &corners, SetName::LeadingEdge);
    let trailing = drawing.cut(&mesh.trailing_edge, &corners, SetName::TrailingEdge);
    let mut within = Vec::new();
    let mut at_tip = None;
    for (part, nodes) in &chains {
        let set = SetName::Beam(*part);
        match part {
            BeamPart::Rod(_) => drawing.name_between(&leading, nodes, set),
            _ if nodes[0] == tip && nodes[nodes.len() - 1] == outer => {
                at_tip = Some(drawing.curve(nodes, set));
            }
            _ => within.push(drawing.curve(nodes, set)),
        }
    }
    let mut outline: Vec<i64> = leading;
    outline.extend(match at_tip {
        None if tip != outer => Some(drawing.plain(&[tip, outer])),
        at_tip => at_tip,
    });
    outline.extend(trailing.iter().rev().map(|curve| -curve));
    if base != inner {
        let mut root: Vec<usize> = mesh.root.clone();
        if root.first() != Some(&base) || root.last() != Some(&inner) {
            root = vec![base, inner];
        }
        outline.push(-drawing.curve(&root, SetName::Root));
    }
    Some(drawing.text(&outline, &within))
}

/// The beams of a mesh, each as its nodes end to end.
fn chains(mesh: &Mesh) -> Vec<(BeamPart, Vec<usize>)> {
    let mut chains: Vec<(BeamPart, Vec<usize>)> = Vec::new();
    for beam in &mesh.beams {
        let [start, end] = beam.nodes;
        match chains.last_mut() {
            Some((part, nodes)) if *part == beam.part && nodes.last() == Some(&start) => nodes.push(end),
            _ => chains.push((beam.part, vec![start, end])),
        }
    }
    chains
}

struct Drawing<'a> {
    mesh: &'a Mesh,
    /// Nodes of each curve; its tag is its place plus 1.
    curves: Vec<Vec<usize>>,
    sets: BTreeMap<SetName, Vec<i64>>,
}

impl Drawing<'_> {
    fn plain(&mut self, nodes: &[usize]) -> i64 {
        self.curves.push(nodes.to_vec());
        self.curves.len() as i64
    }

    fn curve(&mut self, nodes: &[usize], set: SetName) -> i64 {
        let curve = self.plain(nodes);
        self.sets.entry(set).or_default().push(curve);
        curve
    }

    /// Curves of an edge from corner to corner.
    fn cut(&mut self, edge: &[usize], corners: &BTreeSet<usize>, set: SetName) -> Vec<i64> {
        let (mut curves, mut piece) = (Vec::new(), Vec::new());
        for &node in edge {
            piece.push(node);
            if corners.contains(&node) {
                if piece.len() > 1 {
                    curves.push(self.curve(&piece, set));
                }
                piece = vec![node];
            }
        }
        curves
    }

    /// Gives the curves of an edge that lie between the ends of `nodes` a second name; where the edge does not pass there, a curve
    /// of its own.
    fn name_between(&mut self, edge: &[i64], nodes: &[usize], set: SetName) {
        let of = |curve: i64| &self.curves[curve as usize - 1];
        let own: Vec<i64> = (edge.iter().copied())
            .filter(|&curve| of(curve).iter().all(|node| nodes.contains(node)))
            .collect();
        match own.is_empty() {
            true => {
                self.curve(nodes, set);
            }
            false => self.sets.entry(set).or_default().extend(own),
        }
    }

    fn is_straight(&self, nodes: &[usize]) -> bool {
        let at = |node: usize| nalgebra::Vector3::from(self.mesh.nodes[node]);
        let (start, end) = (at(nodes[0]), at(nodes[nodes.len() - 1]));
        let along = end - start;
        let beside = nodes.iter().map(|&node| along.cross(&(at(node) - start)).norm());
        beside.fold(0.0, f64::max) <= STRAIGHT * along.norm_squared()
    }

    fn text(&self, outline: &[i64], within: &[i64]) -> String {
        let length = |nodes: &[usize]| {
            let at = |node: usize| nalgebra::Vector3::from(self.mesh.nodes[node]);
            nodes
                .windows(2)
                .map(|pair| (at(pair[1]) - at(pair[0])).norm())
                .sum::<f64>()
        };
        let leading = &self.mesh.leading_edge;
        let h_m = length(leading) / (leading.len() - 1).max(1) as f64;
        let mut text =
            format!("// Outline, rods and spars of a wing, m. h: size of the elements.\nh = {h_m};\n");
        self.write(&mut text, outline, within)
            .expect("writing to a string cannot fail");
        text
    }

    fn write(&self, text: &mut String, outline: &[i64], within: &[i64]) -> std::fmt::Result {
        let shapes = self.curves.iter().map(|nodes| match self.is_straight(nodes) {
            true => ("Line", vec![nodes[0], nodes[nodes.len() - 1]]),
            false => ("Spline", nodes.clone()),
        });
        let shapes: Vec<(&str, Vec<usize>)> = shapes.collect();
        let points: BTreeSet<usize> = shapes.iter().flat_map(|(_, nodes)| nodes.clone()).collect();
        for point in points {
            let [x, y, z] = self.mesh.nodes[point];
            writeln!(text, "Point({}) = {{{x:?}, {y:?}, {z:?}, h}};", point + 1)?;
        }
        let list = |numbers: &mut dyn Iterator<Item = i64>| {
            numbers
                .map(|number| number.to_string())
                .collect::<Vec<_>>()
                .join(", ")
        };
        for (index, (kind, nodes)) in shapes.iter().enumerate() {
            let nodes = list(&mut nodes.iter().map(|&node| node as i64 + 1));
            writeln!(text, "{kind}({}) = {{{nodes}}};", index + 1)?;
        }
        let outline = list(&mut outline.iter().copied());
        writeln!(text, "Curve Loop(1) = {{{outline}}};\nPlane Surface(1) = {{1}};")?;
        if !within.is_empty() {
            let within = list(&mut within.iter().copied());
            writeln!(text, "Curve{{{within}}} In Surface{{1}};")?;
        }
        for (set, curves) in &self.sets {
            let curves = list(&mut curves.iter().copied());
            writeln!(text, "Physical Curve(\"{set}\") = {{{curves}}};")?;
        }
        writeln!(text, "Physical Surface(\"{}\") = {{1}};", SetName::Membrane)
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::mesh::BeamElement;

    #[test]
    fn a_bay_has_its_outline_its_names_and_its_spar_within() {
        // 3─4─5   trailing edge
        // 0─1─2   leading edge with one rod, a spar at 1
        let nodes = (0..6).map(|k| [0.01 * f64::from(k % 3), 0.02 * f64::from(k / 3), 0.0]);
        let beam = |nodes, part| BeamElement { nodes, part };
        let mesh = Mesh {
            nodes: nodes.collect(),
            triangles: vec![[0, 1, 3], [1, 4, 3], [1, 2, 4], [2, 5, 4]],
            beams: vec![
                beam([0, 1], BeamPart::Rod(0)),
                beam([1, 2], BeamPart::Rod(0)),
                beam([1, 4], BeamPart::Spar(0)),
            ],
            root: vec![0, 3],
            leading_edge: vec![0, 1, 2],
            trailing_edge: vec![3, 4, 5],
        };
        let text = geometry(&mesh).unwrap();
        assert!(text.contains("Curve Loop(1) = {1, 2, 6, -4, -3, -7};"), "{text}");
        assert!(
            text.contains("Line(5) = {2, 5};\n") && text.contains("Curve{5} In Surface{1};"),
            "{text}"
        );
        assert!(text.contains("Physical Curve(\"rod-0\") = {1, 2};"), "{text}");
        assert!(text.contains("h = 0.01;") && !text.contains("Spline"), "{text}");
        let bare = Mesh {
            triangles: Vec::new(),
            ..mesh
        };
        assert_eq!(geometry(&bare), None);
    }
}
