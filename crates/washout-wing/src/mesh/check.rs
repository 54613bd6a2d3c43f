//! Is a mesh sound? Every mesh is checked the same way, generated or imported.

use std::collections::BTreeMap;

use super::defect::{Defect, Member};
use super::{BeamPart, Mesh, signed_area_m2};

/// Checks that a mesh is one flat wing in one piece, with its sets, its leading edge on y = 0 from x = 0.
pub fn check(mesh: &Mesh) -> Result<(), Defect> {
    check_indices(mesh)?;
    let check = Check {
        mesh,
        slack_m: 1e-6 * span_m(mesh),
    };
    check.nodes()?;
    check.triangles()?;
    check.sets()?;
    check.connections()?;
    check.beams()
}

fn span_m(mesh: &Mesh) -> f64 {
    let [low, high] = mesh.bounds_m();
    (0..2).map(|k| high[k] - low[k]).fold(0.0, f64::max)
}

fn check_indices(mesh: &Mesh) -> Result<(), Defect> {
    let exists = |nodes: &[usize]| nodes.iter().all(|&node| node < mesh.nodes.len());
    let missing = |by: Member| Err(Defect::MissingNode { by });
    if let Some(index) = mesh.triangles.iter().position(|t| !exists(t)) {
        return missing(Member::Triangle(index));
    }
    if let Some(index) = mesh.beams.iter().position(|beam| !exists(&beam.nodes)) {
        return missing(Member::Beam(index));
    }
    match sets(mesh).into_iter().find(|(_, nodes)| !exists(nodes)) {
        Some((name, _)) => missing(Member::Set(name)),
        None => Ok(()),
    }
}

fn sets(mesh: &Mesh) -> [(&'static str, &[usize]); 3] {
    [
        ("root", &mesh.root),
        ("leading-edge", &mesh.leading_edge),
        ("trailing-edge", &mesh.trailing_edge),
    ]
}

struct Check<'a> {
    mesh: &'a Mesh,
    slack_m: f64,
}

impl Check<'_> {
    fn place_mm(&self, node: usize) -> (f64, f64) {
        let [x, y, _] = self.mesh.nodes[node];
        (x * 1000.0, y * 1000.0)
    }

    fn centre_mm(&self, nodes: &[usize]) -> (f64, f64) {
        let sum = nodes
            .iter()
            .map(|&node| self.place_mm(node))
            .fold((0.0, 0.0), |s, p| (s.0 + p.0, s.1 + p.1));
        (sum.0 / nodes.len() as f64, sum.1 / nodes.len() as f64)
    }

    fn nodes(&self) -> Result<(), Defect> {
        for (node, p) in self.mesh.nodes.iter().enumerate() {
            if p.iter().any(|v| !v.is_finite()) {
                return Err(Defect::NotFinite { node });
            }
            let (x_mm, y_mm) = self.place_mm(node);
            if p[2].abs() > self.slack_m {
                return Err(Defect::OffPlane {
                    node,
                    x_mm,
                    y_mm,
                    z_mm: p[2] * 1000.0,
                });
            }
        }
        let mut by_x: Vec<usize> = (0..self.mesh.nodes.len()).collect();
        by_x.sort_by(|&a, &b| self.mesh.nodes[a][0].total_cmp(&self.mesh.nodes[b][0]));
        for (position, &a) in by_x.iter().enumerate() {
            let near = by_x[position + 1..]
                .iter()
                .take_while(|&&b| self.mesh.nodes[b][0] - self.mesh.nodes[a][0] <= 1e-3 * self.slack_m);
            for &b in near {
                if (self.mesh.nodes[b][1] - self.mesh.nodes[a][1]).abs() <= 1e-3 * self.slack_m {
                    let (x_mm, y_mm) = self.place_mm(a);
                    return Err(Defect::SamePlace {
                        node: a.max(b),
                        x_mm,
                        y_mm,
                    });
                }
            }
        }
        Ok(())
    }

    fn triangles(&self) -> Result<(), Defect> {
        // Each directed edge may stand once: two triangles on one side of an edge lie over each other.
        let mut directed = BTreeMap::new();
        for (triangle, &[a, b, c]) in self.mesh.triangles.iter().enumerate() {
            let corners = [a, b, c].map(|node| self.mesh.nodes[node]);
            let (x_mm, y_mm) = self.centre_mm(&[a, b, c]);
            let longest = |p: [f64; 3], q: [f64; 3]| (q[0] - p[0]).powi(2) + (q[1] - p[1]).powi(2);
            let scale = (0..3)
                .map(|k| longest(corners[k], corners[(k + 1) % 3]))
                .fold(0.0, f64::max);
            let area_m2 = signed_area_m2(corners);
            if area_m2.abs() <= 1e-9 * scale {
                return Err(Defect::NoArea { triangle, x_mm, y_mm });
            }
            if area_m2 < 0.0 {
                return Err(Defect::Clockwise { triangle, x_mm, y_mm });
            }
            for edge in [[a, b], [b, c], [c, a]] {
                if directed.insert(edge, triangle).is_some() {
                    return Err(Defect::Inverted { triangle, x_mm, y_mm });
                }
            }
        }
        let boundary: Vec<[usize; 2]> = directed
            .keys()
            .filter(|&&[a, b]| !directed.contains_key(&[b, a]))
            .copied()
            .collect();
        self.hanging_nodes(&boundary)
    }

    /// A node inside a boundary edge: the film is torn open there.
    fn hanging_nodes(&self, boundary: &[[usize; 2]]) -> Result<(), Defect> {
        let mut nodes: Vec<usize> = boundary.iter().flatten().copied().collect();
        nodes.sort_unstable();
        nodes.dedup();
        nodes.sort_by(|&a, &b| self.mesh.nodes[a][0].total_cmp(&self.mesh.nodes[b][0]));
        for &[a, b] in boundary {
            let (p, q) = (self.mesh.nodes[a], self.mesh.nodes[b]);
            let (dx, dy) = (q[0] - p[0], q[1] - p[1]);
            let length_m = dx.hypot(dy);
            let from =
                nodes.partition_point(|&node| self.mesh.nodes[node][0] < p[0].min(q[0]) - self.slack_m);
            let to = nodes.partition_point(|&node| self.mesh.nodes[node][0] <= p[0].max(q[0]) + self.slack_m);
            for &node in nodes[from..to].iter().filter(|&&node| node != a && node != b) {
                let r = self.mesh.nodes[node];
                let along_m = ((r[0] - p[0]) * dx + (r[1] - p[1]) * dy) / length_m;
                let across_m = ((r[1] - p[1]) * dx - (r[0] - p[0]) * dy) / length_m;
                if across_m.abs() <= 1e-3 * self.slack_m && along_m > 0.0 && along_m < length_m {
                    let (x_mm, y_mm) = self.place_mm(node);
                    return Err(Defect::Hanging { node, x_mm, y_mm });
                }
            }
        }
        Ok(())
    }

    fn sets(&self) -> Result<(), Defect> {
        for (set, nodes) in sets(self.mesh) {
            // A rod without film and spars has no trailing edge.
            let may_be_empty = set == "trailing-edge" && self.mesh.triangles.is_empty();
            if nodes.is_empty() && !may_be_empty {
                return Err(Defect::MissingSet { set });
            }
            let axis = if set == "root" { 1 } else { 0 };
            if let Some(w) = nodes
                .windows(2)
                .find(|w| self.mesh.nodes[w[1]][axis] < self.mesh.nodes[w[0]][axis])
            {
                let (x_mm, y_mm) = self.place_mm(w[1]);
                return Err(Defect::Disorder {
                    set,
                    node: w[1],
                    x_mm,
                    y_mm,
                });
            }
        }
        for &node in &self.mesh.leading_edge {
            let (x_mm, y_mm) = self.place_mm(node);
            if self.mesh.nodes[node][1].abs() > self.slack_m {
                return Err(Defect::LeadingEdgeOff { node, x_mm, y_mm });
            }
        }
        for &node in &self.mesh.root {
            let (x_mm, y_mm) = self.place_mm(node);
            if self.mesh.nodes[node][0].abs() > self.slack_m {
                return Err(Defect::RootOff { node, x_mm, y_mm });
            }
        }
        Ok(())
    }

    /// With a film, the sets follow its edges from corner to corner.
    fn sets_on_edges(&self, edges: &[[usize; 2]]) -> Result<(), Defect> {
        if self.mesh.triangles.is_empty() {
            return Ok(());
        }
        for (set, nodes) in sets(self.mesh) {
            if let Some(w) = nodes.windows(2).find(|w| !contains(edges, w[0], w[1])) {
                let (x_mm, y_mm) = self.place_mm(w[1]);
                return Err(Defect::Interrupted {
                    set,
                    node: w[1],
                    x_mm,
                    y_mm,
                });
            }
        }
        let root = &self.mesh.root;
        let corners = [
            ("leading", root.first(), self.mesh.leading_edge.first()),
            ("trailing", root.last(), self.mesh.trailing_edge.first()),
        ];
        for (edge, end, first) in corners {
            if let Some(&node) = end.filter(|_| end != first) {
                let (x_mm, y_mm) = self.place_mm(node);
                return Err(Defect::RootCorner {
                    node,
                    edge,
                    x_mm,
                    y_mm,
                });
            }
        }
        Ok(())
    }

    fn beams(&self) -> Result<(), Defect> {
        let edges = self.film_edges();
        self.beams_on_edges(&edges)?;
        self.sets_on_edges(&edges)?;
        let mut last = None;
        let mut spar_end = BTreeMap::new();
        for (beam, element) in self.mesh.beams.iter().enumerate() {
            let [from, to] = element.nodes;
            let (x_mm, y_mm) = self.place_mm(from);
            let part = element.part;
            match part {
                BeamPart::Rod(_) => {
                    let starts = last.unwrap_or(self.mesh.root[0]);
                    let outward = self.mesh.nodes[to][0] > self.mesh.nodes[from][0];
                    let ends = [from, to].map(|node| self.mesh.nodes[node][1].abs() <= self.slack_m);
                    if from != starts || !outward || ends != [true, true] {
                        return Err(Defect::BrokenRod { beam, x_mm });
                    }
                    last = Some(to);
                }
                BeamPart::Rib(_) => {}
                BeamPart::Spar(_) => match spar_end.insert(part, (to, beam)) {
                    Some((end, _)) if end != from => {
                        return Err(Defect::BrokenSpar {
                            beam,
                            part,
                            x_mm,
                            y_mm,
                        });
                    }
                    None if !self.mesh.leading_edge.contains(&from) => {
                        return Err(Defect::ShortSpar {
                            beam,
                            part,
                            edge: "leading",
                            x_mm,
                            y_mm,
                        });
                    }
                    _ => {}
                },
            }
        }
        if last.is_none() {
            return Err(Defect::MissingSet { set: "rod-0" });
        }
        self.spars_reach_the_trailing_edge(&spar_end)
    }

    /// `spar_end`: last node and last beam of each spar.
    fn spars_reach_the_trailing_edge(
        &self,
        spar_end: &BTreeMap<BeamPart, (usize, usize)>,
    ) -> Result<(), Defect> {
        for (&part, &(end, beam)) in spar_end {
            if !self.mesh.trailing_edge.contains(&end) {
                let (x_mm, y_mm) = self.place_mm(end);
                return Err(Defect::ShortSpar {
                    beam,
                    part,
                    edge: "trailing",
                    x_mm,
                    y_mm,
                });
            }
        }
        Ok(())
    }

    /// Edges of the film's triangles, smaller node first, sorted.
    fn film_edges(&self) -> Vec<[usize; 2]> {
        let mut edges: Vec<[usize; 2]> = (self.mesh.triangles.iter())
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges
    }

    /// A beam between two nodes of the film must follow an edge, or the nodes between them are not held.
    fn beams_on_edges(&self, edges: &[[usize; 2]]) -> Result<(), Defect> {
        let mut on_film = vec![false; self.mesh.nodes.len()];
        self.mesh
            .triangles
            .iter()
            .flatten()
            .for_each(|&node| on_film[node] = true);
        for (beam, element) in self.mesh.beams.iter().enumerate() {
            let [a, b] = element.nodes;
            if on_film[a] && on_film[b] && !contains(edges, a, b) {
                let (x_mm, y_mm) = self.centre_mm(&[a, b]);
                return Err(Defect::OffEdges {
                    beam,
                    part: element.part,
                    x_mm,
                    y_mm,
                });
            }
        }
        Ok(())
    }

    fn connections(&self) -> Result<(), Defect> {
        let mut leader: Vec<usize> = (0..self.mesh.nodes.len()).collect();
        let mut used = vec![false; self.mesh.nodes.len()];
        let elements =
            (self.mesh.triangles.iter().map(|t| &t[..])).chain(self.mesh.beams.iter().map(|b| &b.nodes[..]));
        for nodes in elements {
            for &node in nodes {
                used[node] = true;
                let (a, b) = (find(&mut leader, nodes[0]), find(&mut leader, node));
                leader[a] = b;
            }
        }
        let base = find(&mut leader, self.mesh.root[0]);
        for (node, is_used) in used.into_iter().enumerate() {
            let (x_mm, y_mm) = self.place_mm(node);
            if !is_used {
                return Err(Defect::Loose { node, x_mm, y_mm });
            }
            if find(&mut leader, node) != base {
                return Err(Defect::Unconnected { node, x_mm, y_mm });
            }
        }
        Ok(())
    }
}

/// Whether the edge between two nodes is among sorted `edges`.
fn contains(edges: &[[usize; 2]], a: usize, b: usize) -> bool {
    edges.binary_search(&[a.min(b), a.max(b)]).is_ok()
}

/// Representative of a node's group, shortening the path to it.
fn find(leader: &mut [usize], mut node: usize) -> usize {
    while leader[node] != node {
        leader[node] = leader[leader[node]];
        node = leader[node];
    }
    node
}
