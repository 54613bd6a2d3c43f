//! What hypotheses are weighed by: the readings, the errors that are expected at every size, and each effect at its strengths.

use std::borrow::Cow;

use nalgebra::{DMatrix, DVector};

use crate::study::{Forward, WarmStart};

use super::data::Data;
use super::error::{DiagnoseError, where_solved};
use super::evidence::ln_sum;
use super::fields::Field;
use super::model_error::{ModelError, Size};
use super::responses::Node;
use super::root::Root;
use super::settings::Settings;

/// What effects are weighed by: the first fit, and the errors about it.
pub struct Seen<'a> {
    /// The model.
    pub forward: &'a dyn Forward,
    /// What is fitted.
    pub data: &'a Data,
    /// The error that is expected.
    pub error: ModelError,
    /// Measured minus modelled, inputs at their prior means.
    pub residual: DVector<f64>,
    /// Fields that have no name.
    pub fields: &'a [Field],
    /// Where the unknowns start.
    pub start: &'a [f64],
    /// What the model reads there.
    pub raw: &'a DVector<f64>,
    /// What the first fit left.
    pub warm_start: Option<WarmStart>,
}

impl Seen<'_> {
    /// Change of the fitted readings by two missing effects at these strengths; none if there is no solution.
    ///
    /// # Errors
    /// If the user asked to stop.
    pub fn with(&self, effects: [(usize, f64); 2]) -> Result<Option<DVector<f64>>, DiagnoseError> {
        let mut there = self.start.to_vec();
        for (k, strength) in effects {
            there[self.data.missing[k]] = strength;
        }
        let found = self
            .forward
            .linearize_from(self.warm_start.as_ref(), &there, &|_| false);
        let Some((with, _)) = where_solved(found)? else {
            return Ok(None);
        };
        let change = (with.value - self.raw).select_rows(self.data.rows.iter());
        Ok(change.iter().all(|own| own.is_finite()).then_some(change))
    }
}

/// The readings and what is expected of them.
pub struct Weights<'a> {
    /// The error that is expected.
    pub error: &'a ModelError,
    /// Sizes that are summed over.
    pub levels: Vec<Level>,
    /// A typical size: the formulation error of the prior, the scatter as stated.
    pub typical: Level,
    /// Measured minus modelled, inputs at their prior means.
    pub residual: &'a DVector<f64>,
}

/// One size of the errors.
#[derive(Clone)]
pub struct Level {
    /// The size.
    pub size: Size,
    /// Covariance of everything that is expected.
    covariance: DMatrix<f64>,
    root: Root,
}

impl Level {
    fn new(error: &ModelError, size: Size) -> Result<Level, DiagnoseError> {
        let covariance = error.of_all(&size);
        let root = Root::of(covariance.clone())?;
        Ok(Level {
            size,
            covariance,
            root,
        })
    }

    /// Root of the covariance, with `more` besides.
    ///
    /// # Errors
    /// If it is not positive definite.
    pub fn root(&self, more: Option<&DMatrix<f64>>) -> Result<Cow<'_, Root>, DiagnoseError> {
        match more {
            None => Ok(Cow::Borrowed(&self.root)),
            Some(more) => Root::of(&self.covariance + more).map(Cow::Owned),
        }
    }

    /// ln of the prior of the size over the root of the determinant.
    pub fn ln_size(&self, root: &Root) -> f64 {
        self.size.ln_prior - root.ln_determinant
    }
}

/// One missing effect and the strengths at which it is weighed.
pub struct Member {
    /// Its strengths.
    pub nodes: Vec<Node>,
    /// Changes of the fitted readings, a column each.
    pub changes: DMatrix<f64>,
    /// Share to which its change is known.
    pub own_error: f64,
    /// ln of its share of the prior of one effect.
    pub ln_prior: f64,
    /// Its family; none if these data cannot see it.
    pub family: Option<usize>,
}

impl Member {
    /// The same at some of its strengths; of no family if there are none.
    pub fn at(&self, is_kept: impl Fn(usize) -> bool) -> Member {
        let kept: Vec<usize> = (0..self.nodes.len()).filter(|&node| is_kept(node)).collect();
        Member {
            nodes: kept.iter().map(|&node| self.nodes[node].clone()).collect(),
            changes: self.changes.select_columns(kept.iter()),
            family: self.family.filter(|_| !kept.is_empty()),
            ..*self
        }
    }

    /// The same at plausible strengths alone.
    pub fn plausible(&self) -> Member {
        self.at(|node| self.nodes[node].is_plausible)
    }
}

impl<'a> Weights<'a> {
    /// Of all sizes.
    ///
    /// # Errors
    /// If a covariance is not positive definite.
    pub fn new(
        error: &'a ModelError,
        residual: &'a DVector<f64>,
        settings: &Settings,
    ) -> Result<Weights<'a>, DiagnoseError> {
        let sizes = ModelError::sizes(settings.discrepancy, settings.noise_scale, settings.noise_trust);
        let most = |a: &&Size, b: &&Size| a.ln_prior.total_cmp(&b.ln_prior);
        let typical = *sizes.iter().max_by(most).unwrap_or(&sizes[0]);
        Ok(Weights {
            error,
            levels: sizes
                .into_iter()
                .map(|size| Level::new(error, size))
                .collect::<Result<_, DiagnoseError>>()?,
            typical: Level::new(error, typical)?,
            residual,
        })
    }

    /// ln of the density of the readings for every size (row) and every column of `residuals`, the prior of the size in it.
    ///
    /// # Errors
    /// If a covariance is not positive definite.
    pub fn of(
        &self,
        more: Option<&DMatrix<f64>>,
        residuals: &DMatrix<f64>,
    ) -> Result<DMatrix<f64>, DiagnoseError> {
        let mut found = DMatrix::zeros(self.levels.len(), residuals.ncols());
        for (row, level) in self.levels.iter().enumerate() {
            let root = level.root(more)?;
            for (column, own) in root.whiten(residuals).column_iter().enumerate() {
                found[(row, column)] = level.ln_size(&root) - 0.5 * own.norm_squared();
            }
        }
        Ok(found)
    }

    /// Columns brought to unit covariance at the typical size.
    pub fn whitened(&self, columns: &DMatrix<f64>) -> DMatrix<f64> {
        self.typical.root.whiten(columns)
    }

    /// The readings less each of these changes.
    pub fn less(&self, changes: &DMatrix<f64>) -> DMatrix<f64> {
        let mut residuals = -changes;
        for mut column in residuals.column_iter_mut() {
            column += self.residual;
        }
        residuals
    }
}

/// Most probable strength, mean and standard deviation of one effect, from the ln of the weights of its nodes.
pub fn strength(member: &Member, ln_weights: &[f64]) -> [f64; 3] {
    let whole = ln_sum(ln_weights.iter().copied());
    let parts = || member.nodes.iter().zip(ln_weights);
    let best = parts()
        .max_by(|a, b| a.1.total_cmp(b.1))
        .map_or(0.0, |(node, _)| node.strength);
    let mean = |of: &dyn Fn(f64) -> f64| -> f64 {
        parts()
            .map(|(node, ln)| of(node.strength) * (ln - whole).exp())
            .sum()
    };
    let middle = mean(&|strength| strength);
    [best, middle, mean(&|strength| (strength - middle).powi(2)).sqrt()]
}
