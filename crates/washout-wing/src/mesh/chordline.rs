//! Where a plane x = r cuts the film: the chord line on which strips of air and instruments work.

use super::Mesh;

/// The cut of the plane x = r with the film at rest.
#[derive(Debug, Clone, PartialEq)]
pub struct ChordLine {
    /// Span position of the plane, m.
    pub r_m: f64,
    /// Crossings with the edges of the film's triangles, from leading to trailing edge, none twice.
    pub points: Vec<ChordPoint>,
}

/// A point of a chord line: a linear interpolation between two nodes (the same one twice where it is a node).
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct ChordPoint {
    /// The two nodes.
    pub nodes: [usize; 2],
    /// Their weights; the sum is 1.
    pub weights: [f64; 2],
    /// Distance from y = 0 at rest, m.
    pub y_m: f64,
}

/// The chord line at `r_m`; `None` where the plane misses the film. For many cuts use [`ChordLines`].
pub fn chord_line(mesh: &Mesh, r_m: f64) -> Option<ChordLine> {
    ChordLines::new(mesh).at(r_m)
}

/// The edges of a film, sorted into bins along the span, ready to be cut.
#[derive(Debug, Clone)]
pub struct ChordLines<'a> {
    mesh: &'a Mesh,
    from_m: f64,
    bin_m: f64,
    /// Edges that reach into each bin.
    bins: Vec<Vec<[usize; 2]>>,
    /// Nodes this near to the plane count as on it.
    slack_m: f64,
}

impl<'a> ChordLines<'a> {
    /// Index of the film of `mesh`.
    pub fn new(mesh: &'a Mesh) -> ChordLines<'a> {
        let mut edges: Vec<[usize; 2]> = (mesh.triangles.iter())
            .flat_map(|&[a, b, c]| [[a, b], [b, c], [c, a]])
            .map(|[a, b]| [a.min(b), a.max(b)])
            .collect();
        edges.sort_unstable();
        edges.dedup();
        let span = |&[a, b]: &[usize; 2]| {
            let (x, y) = (mesh.nodes[a][0], mesh.nodes[b][0]);
            (x.min(y), x.max(y))
        };
        let (from_m, to_m) = (edges.iter().map(span))
            .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), (a, b)| {
                (low.min(a), high.max(b))
            });
        let length_m = if edges.is_empty() { 0.0 } else { to_m - from_m };
        let count = (edges.len() as f64).sqrt().ceil().max(1.0) as usize;
        let mut lines = ChordLines {
            mesh,
            from_m: if edges.is_empty() { 0.0 } else { from_m },
            bin_m: length_m / count as f64,
            bins: vec![Vec::new(); count],
            slack_m: 1e-10 * length_m,
        };
        for edge in &edges {
            let (low, high) = span(edge);
            for bin in lines.bin_of(low - lines.slack_m)..=lines.bin_of(high + lines.slack_m) {
                lines.bins[bin].push(*edge);
            }
        }
        lines
    }

    fn bin_of(&self, x_m: f64) -> usize {
        // Casting saturates: places off the film fall into the first or last bin.
        (((x_m - self.from_m) / self.bin_m) as usize).min(self.bins.len() - 1)
    }

    /// The chord line at `r_m`; `None` where the plane misses the film.
    pub fn at(&self, r_m: f64) -> Option<ChordLine> {
        let nodes = &self.mesh.nodes;
        let mut points = Vec::new();
        for &[a, b] in &self.bins[self.bin_of(r_m)] {
            let (before, after) = (nodes[a][0] - r_m, nodes[b][0] - r_m);
            let on_plane = [before.abs() <= self.slack_m, after.abs() <= self.slack_m];
            for (node, _) in [a, b].into_iter().zip(on_plane).filter(|&(_, is_on)| is_on) {
                points.push(ChordPoint {
                    nodes: [node, node],
                    weights: [1.0, 0.0],
                    y_m: nodes[node][1],
                });
            }
            if on_plane == [false, false] && (before < 0.0) != (after < 0.0) {
                let weight = before / (before - after);
                let weights = [1.0 - weight, weight];
                let y_m = weights[0] * nodes[a][1] + weights[1] * nodes[b][1];
                points.push(ChordPoint {
                    nodes: [a, b],
                    weights,
                    y_m,
                });
            }
        }
        points.sort_by(|p, q| p.y_m.total_cmp(&q.y_m).then(p.nodes.cmp(&q.nodes)));
        // A node on the plane comes once per edge; edges that cross just beside a node come within the slack.
        points.dedup_by(|next, kept| next.y_m - kept.y_m <= self.slack_m);
        (points.len() >= 2).then_some(ChordLine { r_m, points })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::geometry::Planform;
    use crate::input::design::Design;

    fn wing(spars: &[[f64; 2]]) -> (Mesh, Planform) {
        let section = "section = { shape = 'round', diameter_mm = 1.0 }";
        let mut text = format!(
            "format = 1\nname = 'w'\n[planform]\nlength_mm = 70.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\n\
             [film]\nmaterial = 'kapton'\nthickness_mm = 0.006\n[[rod]]\nfrom_mm = 0.0\nto_mm = 70.0\n{section}\n"
        );
        for [at, trailing] in spars {
            text += &format!("[[spar]]\nat_mm = {at:?}\ntrailing_edge_at_mm = {trailing:?}\n{section}\n");
        }
        let design: Design = toml::from_str(&text).unwrap();
        let planform = Planform::from_design(&design).unwrap();
        (crate::mesh::generate(&design, &planform).unwrap(), planform)
    }

    /// Edges, columns, places just beside columns and in between.
    fn stations_m(mesh: &Mesh, tip_m: f64) -> Vec<f64> {
        let mut stations: Vec<f64> = (0..=500).map(|i| tip_m * f64::from(i) / 500.0).collect();
        for &node in &mesh.leading_edge {
            let x = mesh.nodes[node][0];
            stations
                .extend([-1e-9, -1e-12, -1e-17, 0.0, 1e-17, 1e-12, 1e-9].map(|d| (x + d).clamp(0.0, tip_m)));
        }
        stations
    }

    #[test]
    fn linear_fields_are_reproduced_and_lines_run_from_edge_to_edge() {
        for spars in [&[[21.0, 21.0], [49.0, 49.0]], &[[21.0, 14.0], [45.0, 52.0]]] {
            let (mesh, planform) = wing(spars);
            let lines = ChordLines::new(&mesh);
            let field = |p: [f64; 3]| 0.3 + 7.0 * p[0] - 4.0 * p[1];
            for r_m in stations_m(&mesh, planform.tip_m()) {
                let line = lines.at(r_m).unwrap_or_else(|| panic!("no line at {r_m}"));
                for point in &line.points {
                    assert!((point.weights[0] + point.weights[1] - 1.0).abs() < 1e-15);
                    assert!(point.weights.iter().all(|w| (0.0..=1.0).contains(w)));
                    let [a, b] = point.nodes.map(|node| mesh.nodes[node]);
                    let value = point.weights[0] * field(a) + point.weights[1] * field(b);
                    let exact = field([r_m, point.y_m, 0.0]);
                    assert!((value - exact).abs() < 1e-10, "{r_m}: {value} {exact}");
                }
                assert_eq!(line.points[0].y_m, 0.0);
                let last = line.points[line.points.len() - 1];
                assert!(last.nodes.iter().all(|node| mesh.trailing_edge.contains(node)));
                assert!((last.y_m / planform.chord_m(r_m) - 1.0).abs() < 0.03, "{r_m}");
                assert!(
                    line.points.windows(2).all(|w| w[1].y_m > w[0].y_m + 1e-12),
                    "{r_m}: a point twice"
                );
            }
        }
    }

    #[test]
    fn on_a_column_the_points_are_its_nodes() {
        let (mesh, _) = wing(&[[21.0, 21.0], [49.0, 49.0]]);
        let line = chord_line(&mesh, 0.021).unwrap();
        let nodes: Vec<usize> = line.points.iter().map(|point| point.nodes[0]).collect();
        assert_eq!(nodes, mesh.spar_nodes(0));
        assert!(line.points.iter().all(|point| point.nodes[0] == point.nodes[1]));
    }

    #[test]
    fn off_the_film_there_is_no_line() {
        let (mesh, planform) = wing(&[[21.0, 21.0]]);
        for r_m in [-1e-6, planform.tip_m() + 1e-6, 1.0, -1.0, f64::NAN, f64::INFINITY] {
            assert_eq!(chord_line(&mesh, r_m), None, "{r_m}");
        }
        assert_eq!(chord_line(&Mesh::default(), 0.0), None);
    }
}
