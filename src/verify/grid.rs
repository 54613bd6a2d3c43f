//! Mapped grids of triangles, their supports and loads.

use std::f64::consts::FRAC_PI_4;

use nalgebra::Vector3;

use crate::structure::{Compression, Loads, Model, Sheet, StructureError};

/// Sheet without tension that carries compression, 1 kg/m³.
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
            slack: 0.0,
        },
        ..sheet
    }
}

/// A mapped grid of `count[0]` × `count[1]` cells, each cut into two triangles.
#[derive(Debug, Clone)]
pub struct Grid {
    /// The structure.
    pub model: Model,
    /// Cells along ξ and η.
    pub count: [usize; 2],
}

impl Grid {
    /// Cuts alternate; `place` maps (ξ, η) of the unit square to a point, m.
    ///
    /// # Errors
    /// If a triangle has no area.
    pub fn new(
        count: [usize; 2],
        sheet: Sheet,
        place: impl Fn(f64, f64) -> Vector3<f64>,
    ) -> Result<Self, StructureError> {
        Grid::cut(count, sheet, place, |i, j| (i + j) % 2 == 0)
    }

    /// `forward` says which cells are cut from their corner (0, 0) to (1, 1), the others the other way.
    ///
    /// # Errors
    /// If a triangle has no area.
    pub fn cut(
        count: [usize; 2],
        sheet: Sheet,
        place: impl Fn(f64, f64) -> Vector3<f64>,
        forward: impl Fn(usize, usize) -> bool,
    ) -> Result<Self, StructureError> {
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
                    grid.model.add_shell(nodes, sheet)?;
                }
            }
        }
        Ok(grid)
    }

    /// Node at grid place (i, j).
    pub fn node(&self, [i, j]: [usize; 2]) -> usize {
        i * (self.count[1] + 1) + j
    }

    /// Node in the middle of the grid.
    pub fn centre(&self) -> usize {
        self.node(self.count.map(|count| count / 2))
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

    /// Nodes of all four sides.
    pub fn rim(&self) -> Vec<usize> {
        [false, true]
            .iter()
            .flat_map(|&end| [self.side(end), self.edge(end)].concat())
            .collect()
    }

    /// Holds the marked freedoms of nodes.
    pub fn hold(&mut self, nodes: &[usize], freedoms: [bool; 6]) {
        for &node in nodes {
            self.model.hold(node, freedoms);
        }
    }

    /// Load per area (Pa) over all triangles, a third of each to its nodes.
    pub fn pressure(&self, load_pa: Vector3<f64>) -> Loads {
        let mut loads = Loads::none(self.model.nodes.len());
        for shell in self.model.shells.iter() {
            for node in shell.nodes {
                loads.force_n[node] += load_pa * (shell.area_m2() / 3.0);
            }
        }
        loads
    }

    /// A force (N) spread evenly over the side ξ = 1.
    pub fn end_force(&self, force_n: Vector3<f64>) -> Loads {
        let mut loads = Loads::none(self.model.nodes.len());
        let end = self.side(true);
        let shares = line_shares(&self.model, &end);
        let total: f64 = shares.iter().sum();
        for (&node, share) in end.iter().zip(shares) {
            loads.force_n[node] = force_n * (share / total);
        }
        loads
    }

    /// The mesh in words.
    pub fn words(&self) -> String {
        format!("{} × {}", self.count[0], self.count[1])
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

/// The unit square on the unit disc: the larger coordinate gives the radius, the smaller the angle.
pub fn disc(xi: f64, eta: f64) -> Vector3<f64> {
    let (x, y) = (2.0 * xi - 1.0, 2.0 * eta - 1.0);
    let (large, small) = if x.abs() > y.abs() { (x, y) } else { (y, x) };
    let angle = if large == 0.0 {
        0.0
    } else {
        FRAC_PI_4 * small / large
    };
    let (sine, cosine) = angle.sin_cos();
    let (x, y) = if x.abs() > y.abs() {
        (cosine, sine)
    } else {
        (sine, cosine)
    };
    Vector3::new(x, y, 0.0) * large
}
