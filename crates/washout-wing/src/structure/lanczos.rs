//! Block Lanczos on K⁻¹ M with full reorthogonalization: the lowest eigenvalues of K φ = ω² M φ.
//!
//! Golub & Underwood, in: Mathematical Software III, 1977, 361-377. Started from fixed vectors, so that it gives the same
//! result every time. M may be singular: freedoms without mass follow the others.

use nalgebra::{DMatrix, SymmetricEigen};

use super::StructureError;
use super::equilibrium::Equilibrium;
use super::largest::smaller;
use super::pattern::Pattern;
use crate::progress::Progress;

/// Vectors that are taken on together; so many equal frequencies are found at once.
const BLOCK: usize = 4;
/// Bound on the relative error of ω² at which a mode has converged.
const TOLERANCE: f64 = 1e-9;
/// Blocks at most.
const MAX_BLOCKS: usize = 60;

/// An eigenvalue and its vector in terms of the space.
pub struct Ritz {
    /// Square of the natural frequency, 1/s².
    pub omega2: f64,
    /// Parts of the mode along the vectors of the space.
    pub vector: Vec<f64>,
}

/// Vectors that are orthonormal in the mass, and K⁻¹ M in their terms.
pub struct Krylov {
    mass: Vec<f64>,
    basis: Vec<Vec<f64>>,
    /// M times each of them.
    momentum: Vec<Vec<f64>>,
    /// Column j: parts of K⁻¹ M v_j along the vectors there were after it was added.
    projected: Vec<Vec<f64>>,
}

impl Krylov {
    /// The space without a vector; `mass`: values on the pattern, nothing for held freedoms.
    pub fn new(mass: Vec<f64>) -> Self {
        Krylov {
            mass,
            basis: Vec::new(),
            momentum: Vec::new(),
            projected: Vec::new(),
        }
    }

    /// Adds start vectors that no structure is likely to be orthogonal to.
    pub fn add_start(&mut self, equilibrium: &mut Equilibrium, start: usize) {
        let size = equilibrium.pattern.len();
        let mut noise = Noise(start as u64 * 0x1000 + 1);
        let forces: Vec<Vec<f64>> = (0..BLOCK)
            .map(|_| {
                let motion: Vec<f64> = (0..size).map(|_| noise.next()).collect();
                equilibrium.pattern.multiply(&self.mass, &motion)
            })
            .collect();
        for motion in answer(equilibrium, forces) {
            self.add(&equilibrium.pattern, motion);
        }
    }

    /// Adds what of a vector is new; gives its parts along all vectors.
    fn add(&mut self, pattern: &Pattern, mut vector: Vec<f64>) -> Vec<f64> {
        let mut parts = vec![0.0; self.basis.len()];
        let before = self.norm(pattern, &vector);
        for _ in 0..2 {
            for (k, (v, m)) in self.basis.iter().zip(&self.momentum).enumerate() {
                let part = dot(m, &vector);
                parts[k] += part;
                axpy(&mut vector, -part, v);
            }
        }
        let rest = self.norm(pattern, &vector);
        if rest > 1e-11 * before {
            vector.iter_mut().for_each(|x| *x /= rest);
            self.momentum.push(pattern.multiply(&self.mass, &vector));
            self.basis.push(vector);
            parts.push(rest);
        }
        parts
    }

    fn norm(&self, pattern: &Pattern, vector: &[f64]) -> f64 {
        // rounding may leave a little less than nothing
        let square = dot(&pattern.multiply(&self.mass, vector), vector);
        if square < 0.0 { 0.0 } else { square.sqrt() }
    }

    /// Mass matrix that it was made with.
    pub fn mass(&self) -> &[f64] {
        &self.mass
    }

    /// Number of vectors.
    pub fn size(&self) -> usize {
        self.basis.len()
    }

    /// The motion of an eigenvector by freedom, with unit modal mass.
    pub fn motion(&self, ritz: &Ritz) -> Vec<f64> {
        let mut motion = vec![0.0; self.basis.first().map_or(0, Vec::len)];
        for (part, vector) in ritz.vector.iter().zip(&self.basis) {
            axpy(&mut motion, *part, vector);
        }
        motion
    }

    /// Widens the space until its `count` lowest modes have converged, or it holds all there are.
    ///
    /// # Errors
    /// If they do not converge, or the user asks to stop.
    pub fn extend(
        &mut self,
        equilibrium: &mut Equilibrium,
        count: usize,
        progress: &Progress,
    ) -> Result<Vec<Ritz>, StructureError> {
        for _ in 0..MAX_BLOCKS {
            progress.check()?;
            if self.basis.is_empty() {
                return Ok(Vec::new());
            }
            let from = self.projected.len();
            let forces = self.momentum[from..].to_vec();
            for vector in answer(equilibrium, forces) {
                let parts = self.add(&equilibrium.pattern, vector);
                if parts.iter().any(|part| !part.is_finite()) {
                    return Err(self.none_found());
                }
                self.projected.push(parts);
            }
            let exhausted = self.projected.len() == self.basis.len();
            if let Some(found) = self.converged(count, exhausted) {
                return Ok(found);
            }
        }
        Err(self.none_found())
    }

    fn none_found(&self) -> StructureError {
        StructureError::NoMode {
            iterations: self.basis.len(),
        }
    }

    /// The lowest modes of the projected problem, if they have converged.
    fn converged(&self, count: usize, exhausted: bool) -> Option<Vec<Ritz>> {
        let size = self.projected.len();
        // an entry above the diagonal was known when its column was made, one below may have come later
        let matrix = DMatrix::from_fn(size, size, |i, j| {
            let (i, j) = (i.min(j), i.max(j));
            self.projected[j].get(i).copied().unwrap_or(0.0)
        });
        let eigen = SymmetricEigen::new(matrix);
        let mut order: Vec<usize> = (0..size).filter(|&k| eigen.eigenvalues[k] > 0.0).collect();
        order.sort_by(|&a, &b| eigen.eigenvalues[b].total_cmp(&eigen.eigenvalues[a]));
        let value = |k: usize| eigen.eigenvalues[k];
        if !exhausted && order.len() < count {
            return None;
        }
        // of the products with the vectors only what lies beyond the space is missing
        let beyond = |k: usize| {
            let mut missing = vec![0.0; self.basis.len() - size];
            for (j, column) in self.projected.iter().enumerate() {
                for (i, part) in column.iter().enumerate().skip(size) {
                    missing[i - size] += part * eigen.eigenvectors[(j, k)];
                }
            }
            dot(&missing, &missing).sqrt()
        };
        let met = |&k: &usize| {
            let missing = beyond(k);
            let others = order.iter().map(|&other| (value(other) - value(k)).abs());
            let apart = others
                .filter(|&apart| apart > 10.0 * missing)
                .fold(value(k), smaller);
            smaller(missing, missing * missing / apart) <= TOLERANCE * value(k)
        };
        let wanted = &order[..count.min(order.len())];
        let all = wanted.iter().all(met);
        let ritz = |&k: &usize| Ritz {
            omega2: 1.0 / value(k),
            vector: eigen.eigenvectors.column(k).iter().copied().collect(),
        };
        (exhausted || all).then(|| wanted.iter().map(ritz).collect())
    }
}

/// K⁻¹ times each of the forces.
fn answer(equilibrium: &mut Equilibrium, forces: Vec<Vec<f64>>) -> Vec<Vec<f64>> {
    let size = equilibrium.pattern.len();
    let mut right = forces.concat();
    if !forces.is_empty() {
        equilibrium.solve_tangent(&mut right, forces.len());
    }
    right.chunks_exact(size).map(<[f64]>::to_vec).collect()
}

fn dot(a: &[f64], b: &[f64]) -> f64 {
    a.iter().zip(b).map(|(a, b)| a * b).sum()
}

fn axpy(y: &mut [f64], factor: f64, x: &[f64]) {
    for (y, x) in y.iter_mut().zip(x) {
        *y += factor * x;
    }
}

/// Fixed numbers between −1 and 1 without pattern (Steele, Lea & Flood 2014: SplitMix64).
struct Noise(u64);

impl Noise {
    fn next(&mut self) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mut z = self.0;
        z = (z ^ (z >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        z = (z ^ (z >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        ((z ^ (z >> 31)) >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }
}
