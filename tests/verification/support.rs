//! Small helpers that the cases share: chains of beams, strips of triangles, solves with default settings.

use nalgebra::{Matrix6, UnitQuaternion, Vector3, Vector6};
use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{
    Compression, Equilibrium, Loads, Model, NewtonReport, NewtonSettings, Section, Sheet,
};

/// Section with the stiffnesses EA, GA edge, GA flap (N), GJ, EI flap, EI edge (N·m²), uncoupled.
pub fn section(stiffness: [f64; 6]) -> Section {
    Section::from_stiffness(&Matrix6::from_diagonal(&Vector6::from(stiffness)), 0.0).unwrap()
}

/// Chain of beams through points (m), all with e₃ toward `normal`; the first node is clamped.
pub fn chain(points: Vec<Vector3<f64>>, normal: &Vector3<f64>, section: Section) -> Model {
    let last = points.len() - 1;
    let mut model = Model::new(points);
    let section = model.add_section(section);
    for i in 0..last {
        model.add_beam([i, i + 1], normal, section).unwrap();
    }
    model.clamp(0);
    model
}

/// Points of a straight line along x from 0 to `length_m`.
pub fn straight(length_m: f64, elements: usize) -> Vec<Vector3<f64>> {
    (0..=elements)
        .map(|i| Vector3::new(length_m * i as f64 / elements as f64, 0.0, 0.0))
        .collect()
}

/// Sheet without tension that carries compression.
pub fn plate(e_pa: f64, poisson: f64, thickness_m: f64) -> Sheet {
    Sheet {
        e_pa,
        poisson,
        thickness_m,
        density_kg_m3: 1.0,
        pretension_n_per_m: 0.0,
        compression: Compression::Carries,
    }
}

/// The same as a film that wrinkles, with the share of stiffness kept in compression.
pub fn film(sheet: Sheet, residual: f64) -> Sheet {
    Sheet {
        compression: Compression::TensionField {
            residual,
            drilling_factor: 1.0,
        },
        ..sheet
    }
}

/// A mapped grid of `count[0]` × `count[1]` cells, each cut into two triangles.
pub struct Grid {
    /// The structure.
    pub model: Model,
    count: [usize; 2],
}

impl Grid {
    /// Cuts alternate; `place` maps (ξ, η) of the unit square to a point, m.
    pub fn new(count: [usize; 2], sheet: Sheet, place: impl Fn(f64, f64) -> Vector3<f64>) -> Self {
        Grid::cut(count, sheet, place, |i, j| (i + j) % 2 == 0)
    }

    /// `forward` says which cells are cut from their corner (0, 0) to (1, 1), the others the other way.
    pub fn cut(
        count: [usize; 2],
        sheet: Sheet,
        place: impl Fn(f64, f64) -> Vector3<f64>,
        forward: impl Fn(usize, usize) -> bool,
    ) -> Self {
        let [m, n] = count;
        let nodes = (0..=m)
            .flat_map(|i| (0..=n).map(move |j| (i as f64 / m as f64, j as f64 / n as f64)))
            .map(|(xi, eta)| place(xi, eta))
            .collect();
        let mut grid = Grid {
            model: Model::new(nodes),
            count,
        };
        let sheet = grid.model.add_sheet(sheet);
        for i in 0..m {
            for j in 0..n {
                let [a, b, c, d] = [[i, j], [i + 1, j], [i + 1, j + 1], [i, j + 1]].map(|p| grid.node(p));
                let cut = if forward(i, j) {
                    [[a, b, c], [a, c, d]]
                } else {
                    [[a, b, d], [b, c, d]]
                };
                for nodes in cut {
                    grid.model.add_shell(nodes, sheet).unwrap();
                }
            }
        }
        grid
    }

    /// Node at grid place (i, j).
    pub fn node(&self, [i, j]: [usize; 2]) -> usize {
        i * (self.count[1] + 1) + j
    }

    /// Nodes of the side ξ = 0 or 1 by η.
    pub fn side(&self, end: bool) -> Vec<usize> {
        let i = if end { self.count[0] } else { 0 };
        (0..=self.count[1]).map(|j| self.node([i, j])).collect()
    }

    /// Nodes of the side η = 0 or 1 by ξ.
    pub fn edge(&self, end: bool) -> Vec<usize> {
        let j = if end { self.count[1] } else { 0 };
        (0..=self.count[0]).map(|i| self.node([i, j])).collect()
    }
}

/// Shares of a line load carried by the nodes of a line, by length (linear shape functions); they sum to its length.
pub fn line_shares(model: &Model, line: &[usize]) -> Vec<f64> {
    let mut shares = vec![0.0; line.len()];
    for (k, pair) in line.windows(2).enumerate() {
        let half = 0.5 * (model.nodes[pair[1]] - model.nodes[pair[0]]).norm();
        shares[k] += half;
        shares[k + 1] += half;
    }
    shares
}

/// Equilibrium from rest under dead loads, reached in at least `increments`.
pub fn solve(model: &Model, loads: &Loads, increments: usize) -> (State, NewtonReport) {
    let settings = NewtonSettings {
        increments,
        ..NewtonSettings::default()
    };
    let none = Loads::none(model.nodes.len());
    let mut state = State::at_rest(model.nodes.len());
    let report = Equilibrium::new(model)
        .unwrap()
        .solve(&mut state, &none, loads, &settings, &Progress::quiet())
        .unwrap();
    (state, report)
}

/// Small displacement and rotation of every node under dead loads: one solve with the tangent at rest.
pub fn linear(model: &Model, loads: &Loads) -> Vec<[Vector3<f64>; 2]> {
    let mut equilibrium = Equilibrium::new(model).unwrap();
    let rest = State::at_rest(model.nodes.len());
    let negative = equilibrium
        .factorize(&rest, &Loads::none(model.nodes.len()))
        .unwrap();
    assert_eq!(negative, 0, "negative pivots at rest");
    let mut right: Vec<f64> = model
        .residual(&equilibrium.pattern, &rest, loads)
        .iter()
        .zip(model.residual(&equilibrium.pattern, &rest, &Loads::none(model.nodes.len())))
        .map(|(with, without)| without - with)
        .collect();
    equilibrium.solve_tangent(&mut right, 1);
    (0..model.nodes.len())
        .map(|node| {
            let at = equilibrium.pattern.freedom(node, 0);
            [
                Vector3::from_column_slice(&right[at..at + 3]),
                Vector3::from_column_slice(&right[at + 3..at + 6]),
            ]
        })
        .collect()
}

/// A large turn about no special axis.
pub fn big_turn() -> UnitQuaternion<f64> {
    UnitQuaternion::new(Vector3::new(1.1, -0.8, 1.6))
}

/// |value/expected − 1|.
pub fn off(value: f64, expected: f64) -> f64 {
    (value / expected - 1.0).abs()
}
