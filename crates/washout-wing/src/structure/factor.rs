//! Factorizations of the stiffness matrix: analysed once per mesh, computed many times.

use std::sync::Arc;

use faer::dyn_stack::{MemBuffer, MemStack, StackReq};
use faer::linalg::cholesky::ldlt::factor::LdltRegularization;
use faer::linalg::cholesky::llt::factor::LltRegularization;
use faer::perm::PermRef;
use faer::sparse::SparseColMatRef;
use faer::sparse::linalg::SupernodalThreshold;
use faer::sparse::linalg::cholesky::{
    CholeskySymbolicParams, LdltRef, LltRef, SymbolicCholesky, SymbolicCholeskyRaw, SymmetricOrdering,
    factorize_symbolic_cholesky,
    supernodal::{self, SupernodalLdltRef},
};
use faer::{Conj, MatMut, Par, Side};

use super::StructureError;
use super::error::NotFinite;
use super::pattern::Pattern;

/// Analyses a pattern, whose order is kept.
///
/// # Errors
/// If the analysis runs out of memory.
pub fn analysed(pattern: &Pattern) -> Result<SymbolicCholesky<usize>, StructureError> {
    // `SymmetricOrdering::Identity` of faer 0.24 fails on a lower triangle: say the same as a permutation
    let order: Vec<usize> = (0..pattern.len()).collect();
    factorize_symbolic_cholesky(
        pattern.symbolic(),
        Side::Lower,
        SymmetricOrdering::Custom(PermRef::new_checked(&order, &order, pattern.len())),
        CholeskySymbolicParams {
            supernodal_flop_ratio_threshold: SupernodalThreshold::FORCE_SUPERNODAL,
            ..CholeskySymbolicParams::default()
        },
    )
    .map_err(|_| StructureError::Singular { node: 0 })
}

/// Factor of a symmetric matrix with a fixed pattern.
pub struct Factor {
    symbolic: Arc<SymbolicCholesky<usize>>,
    values: Vec<f64>,
    buffer: MemBuffer,
    kind: Kind,
    par: Par,
}

#[derive(Debug, Clone, Copy, PartialEq, Eq)]
enum Kind {
    None,
    Llt,
    Ldlt,
}

impl std::fmt::Debug for Factor {
    fn fmt(&self, f: &mut std::fmt::Formatter<'_>) -> std::fmt::Result {
        f.debug_struct("Factor")
            .field("entries", &self.values.len())
            .field("kind", &self.kind)
            .finish()
    }
}

impl Factor {
    /// To be computed, of matrices that were analysed.
    pub fn new(symbolic: Arc<SymbolicCholesky<usize>>) -> Self {
        Factor {
            buffer: MemBuffer::new(need(&symbolic, Par::Seq)),
            values: vec![0.0; symbolic.len_val()],
            symbolic,
            kind: Kind::None,
            par: Par::Seq,
        }
    }

    /// From now on by all threads: the same to rounding only, and not faster on two cores (`cargo bench --bench growth -- --threads 2`).
    pub fn spread(&mut self) {
        self.par = Par::rayon(0);
        self.buffer = MemBuffer::new(need(&self.symbolic, self.par));
    }

    /// How its matrices were analysed.
    pub fn symbolic(&self) -> Arc<SymbolicCholesky<usize>> {
        self.symbolic.clone()
    }

    /// Number of stored entries of the factor.
    pub fn entries(&self) -> usize {
        self.symbolic.len_val()
    }

    /// Cholesky factor; `false` if the matrix is not positive definite.
    pub fn positive(&mut self, pattern: &Pattern, matrix: &[f64]) -> bool {
        let view = SparseColMatRef::new(pattern.symbolic(), matrix);
        let stack = MemStack::new(&mut self.buffer);
        let done = match self.symbolic.raw() {
            // the order is that of the pattern: straight on, without a copy in the order of elimination
            SymbolicCholeskyRaw::Supernodal(symbolic) => supernodal::factorize_supernodal_numeric_llt(
                &mut self.values,
                view,
                LltRegularization::default(),
                symbolic,
                self.par,
                stack,
                Default::default(),
            )
            .is_ok(),
            SymbolicCholeskyRaw::Simplicial(_) => self
                .symbolic
                .factorize_numeric_llt(
                    &mut self.values,
                    view,
                    Side::Lower,
                    LltRegularization::default(),
                    self.par,
                    stack,
                    Default::default(),
                )
                .is_ok(),
        };
        self.kind = if done { Kind::Llt } else { Kind::None };
        done
    }

    /// LDLᵀ factor of a matrix that may be indefinite; gives the number of negative pivots.
    ///
    /// # Errors
    /// If a pivot vanishes or is not finite.
    pub fn indefinite(&mut self, pattern: &Pattern, matrix: &[f64]) -> Result<usize, StructureError> {
        let view = SparseColMatRef::new(pattern.symbolic(), matrix);
        self.kind = Kind::None;
        let done = self.symbolic.factorize_numeric_ldlt(
            &mut self.values,
            view,
            Side::Lower,
            LdltRegularization::default(),
            self.par,
            MemStack::new(&mut self.buffer),
            Default::default(),
        );
        if let Err(faer::linalg::cholesky::ldlt::factor::LdltError::ZeroPivot { index }) = done {
            let node = node_of(pattern, index);
            return Err(StructureError::Singular { node });
        }
        let pivots = self.pivots();
        if let Some(index) = pivots.iter().position(|pivot| !pivot.is_finite()) {
            return Err(StructureError::NotFinite(NotFinite {
                quantity: "the stiffness",
                place: format!("at node {}", node_of(pattern, index)),
                value: pivots[index],
            }));
        }
        self.kind = Kind::Ldlt;
        Ok(pivots.into_iter().filter(|&pivot| pivot < 0.0).count())
    }

    fn pivots(&self) -> Vec<f64> {
        match self.symbolic.raw() {
            SymbolicCholeskyRaw::Simplicial(symbolic) => symbolic.col_ptr()[..symbolic.ncols()]
                .iter()
                .map(|&start| self.values[start])
                .collect(),
            SymbolicCholeskyRaw::Supernodal(symbolic) => {
                let factor = SupernodalLdltRef::new(symbolic, &self.values);
                (0..symbolic.n_supernodes())
                    .flat_map(|s| {
                        let block = factor.supernode(s).val();
                        (0..block.ncols()).map(|j| block[(j, j)]).collect::<Vec<_>>()
                    })
                    .collect()
            }
        }
    }

    /// Solves with the last factor, in place; `count` right-hand sides one after the other.
    pub fn solve(&mut self, right: &mut [f64], count: usize) {
        let size = self.symbolic.nrows();
        let need = self.symbolic.solve_in_place_scratch::<f64>(count, self.par);
        let mut large;
        let buffer = if count == 1 {
            &mut self.buffer
        } else {
            large = MemBuffer::new(need);
            &mut large
        };
        let stack = MemStack::new(buffer);
        let mut right = MatMut::from_column_major_slice_mut(right, size, count);
        match self.kind {
            Kind::Llt => {
                LltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
                    Conj::No,
                    right,
                    self.par,
                    stack,
                );
            }
            Kind::Ldlt => {
                LdltRef::new(&self.symbolic, &self.values).solve_in_place_with_conj(
                    Conj::No,
                    right,
                    self.par,
                    stack,
                );
            }
            // asking before factorizing is a mistake of the caller: nothing sensible can be given back
            Kind::None => right.fill(f64::NAN),
        }
    }
}

/// Node of a freedom in the order of the factor.
fn node_of(pattern: &Pattern, freedom: usize) -> usize {
    pattern.node_at[(freedom / 6).min(pattern.node_at.len() - 1)]
}

/// Memory that factorizing and one solve need.
fn need(symbolic: &SymbolicCholesky<usize>, par: Par) -> StackReq {
    StackReq::any_of(&[
        symbolic.factorize_numeric_llt_scratch::<f64>(par, Default::default()),
        symbolic.factorize_numeric_ldlt_scratch::<f64>(par, Default::default()),
        symbolic.solve_in_place_scratch::<f64>(1, par),
    ])
}
