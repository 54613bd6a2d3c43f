//! Is anything missing at all? Significance over all effects and fields at once, from draws of noise.
//!
//! Every draw goes through the same estimate of the scale of the noise as the data (studentised), so that a misstated
//! scale neither makes nor hides a discovery.

use nalgebra::{DMatrix, DVector};
use rayon::iter::{IntoParallelIterator, ParallelIterator};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::rough::Smooth;
use crate::study::draws::Draws;

/// Draws that are worked on at a time.
const BLOCK: usize = 250;
/// Relative difference of two statistics that are the same.
const SAME: f64 = 1e-9;
/// Stream of the draws' own scales.
const SCALES: u64 = 1 << 40;
/// Streams of the draws' signs.
const SIGNS: u64 = 1 << 41;

/// How probable a misfit at least as large is if nothing is missing.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Significance {
    /// By the largest score of any effect.
    pub p_largest_score: f64,
    /// By the misfit as a whole.
    pub p_misfit: f64,
    /// By the scores of smooth fields.
    pub p_field: f64,
    /// By the largest score and the fields, among residuals with the sign of each reading's share at random: noise that is
    /// larger where the signature of an effect is large is no discovery either.
    pub p_signs: f64,
    /// All together: the larger of three times the smallest of the first three, and of the last.
    pub p_null: f64,
}

impl Significance {
    /// Whether only the turning of signs lets the misfit pass as chance: it stands on few readings.
    pub fn stands_on_few(&self, level: f64) -> bool {
        self.p_null > level && self.p_misfit.max(self.p_largest_score) < level
    }
}

/// Whether `numbers` readings have too few ways to turn their signs for any misfit to be beyond chance: of 2ⁿ some four are as
/// one-sided as all of one sign.
pub fn are_few(numbers: usize, level: f64) -> bool {
    4.0 * 0.5f64.powf(numbers as f64) > level
}

/// How the scale of the noise is treated.
#[derive(Debug, Clone)]
pub enum Scale {
    /// Known: 1.
    Known,
    /// Taken on trust, for want of numbers, like that many numbers.
    Trusted(usize),
    /// Estimated from the rough part; the statement is worth that many numbers.
    Estimated(usize, Smooth),
}

/// Statistics that are judged together.
#[derive(Debug, Clone)]
pub struct NullTest {
    units: DMatrix<f64>,
    one_sided: Vec<bool>,
    fields: Vec<FieldScore>,
    scale: Scale,
}

/// ‖Fᵀe‖² with its mean and standard deviation under noise.
#[derive(Debug, Clone)]
struct FieldScore {
    columns: DMatrix<f64>,
    mean: f64,
    deviation: f64,
}

impl NullTest {
    /// For effects with `directions` (any length, zero if invisible; free of the fit), one-sided or not, and fields with
    /// such columns.
    pub fn new(
        directions: &DMatrix<f64>,
        one_sided: &[bool],
        fields: &[DMatrix<f64>],
        scale: Scale,
    ) -> NullTest {
        let mut units = directions.clone();
        for mut column in units.column_iter_mut() {
            let length = column.norm();
            if length > 0.0 {
                column /= length;
            }
        }
        NullTest {
            units,
            one_sided: one_sided.to_vec(),
            fields: fields.iter().map(FieldScore::new).collect(),
            scale,
        }
    }

    /// Significance of `residual` among `count` draws of `draws`; `to_readings` turns it to the basis where an entry belongs to
    /// one reading.
    pub fn significance(
        &self,
        residual: &DVector<f64>,
        to_readings: &DMatrix<f64>,
        draws: Draws,
        count: usize,
    ) -> Significance {
        let size = residual.len();
        let seen = DMatrix::from_column_slice(size, 1, residual.as_slice());
        let seen = self.statistics(&seen, &[1.0])[0];
        let noise = self.beyond(&seen, count, &|first, here| {
            let errors = DMatrix::from_fn(size, here, |i, k| draws.normal((first + k) as u64, i as u64));
            let factors = (0..here)
                .map(|k| self.factor(draws, (first + k) as u64))
                .collect();
            (errors, factors)
        });
        let by_reading = to_readings * residual;
        let signs = self.beyond(&seen, count, &|first, here| {
            let flipped = |i: usize, k: usize| {
                let is_up = draws.uniform(SIGNS + (first + k) as u64, i as u64) < 0.5;
                if is_up { by_reading[i] } else { -by_reading[i] }
            };
            let flipped = DMatrix::from_fn(size, here, flipped);
            (to_readings.tr_mul(&flipped), vec![1.0; here])
        });
        let [p_largest_score, p_misfit, p_field] = noise;
        let p_signs = (2.0 * signs[0].min(signs[2])).min(1.0);
        let p_noise = (3.0 * p_largest_score.min(p_misfit).min(p_field)).min(1.0);
        Significance {
            p_largest_score,
            p_misfit,
            p_field,
            p_signs,
            p_null: p_noise.max(p_signs),
        }
    }

    /// Shares of `count` drawn residuals (and their factors) whose statistics reach those `seen`.
    fn beyond(
        &self,
        seen: &[f64; 3],
        count: usize,
        draw: &(dyn Fn(usize, usize) -> (DMatrix<f64>, Vec<f64>) + Sync),
    ) -> [f64; 3] {
        let blocks: Vec<[usize; 3]> = (0..count.div_ceil(BLOCK))
            .into_par_iter()
            .map(|block| {
                let first = block * BLOCK;
                let (errors, factors) = draw(first, BLOCK.min(count - first));
                let mut beyond = [0; 3];
                for drawn in self.statistics(&errors, &factors) {
                    for (count, (drawn, seen)) in beyond.iter_mut().zip(drawn.iter().zip(seen)) {
                        // a draw that is the residual itself counts, however its products are rounded
                        *count += usize::from(*drawn >= seen - SAME * seen.abs());
                    }
                }
                beyond
            })
            .collect();
        [0, 1, 2].map(|k| {
            let beyond: usize = blocks.iter().map(|block| block[k]).sum();
            (1 + beyond) as f64 / (1 + count) as f64
        })
    }

    /// Factor of a draw: what the true scale of the noise may be, over what was assumed.
    fn factor(&self, draws: Draws, draw: u64) -> f64 {
        match self.scale {
            Scale::Known => 1.0,
            Scale::Trusted(trust) | Scale::Estimated(trust, _) => {
                (trust as f64 / draws.chi_squared(SCALES + draw, 0, trust)).sqrt()
            }
        }
    }

    /// Largest score, misfit and largest standardised field score of each column of `errors` times its factor.
    fn statistics(&self, errors: &DMatrix<f64>, factors: &[f64]) -> Vec<[f64; 3]> {
        let scores = self.units.transpose() * errors;
        let fields: Vec<DMatrix<f64>> = self
            .fields
            .iter()
            .map(|field| field.columns.transpose() * errors)
            .collect();
        let rough = match &self.scale {
            Scale::Estimated(_, smooth) => smooth.rough_squares(errors),
            _ => DVector::zeros(0),
        };
        (0..errors.ncols())
            .map(|k| {
                let factor = factors[k];
                let ruler = match &self.scale {
                    Scale::Estimated(trust, smooth) => {
                        smooth.variance(rough[k] * factor * factor, *trust).sqrt()
                    }
                    _ => 1.0,
                };
                let size = factor / ruler;
                let largest = scores
                    .column(k)
                    .iter()
                    .zip(&self.one_sided)
                    .map(|(score, one_sided)| if *one_sided { *score } else { score.abs() })
                    .fold(0.0, f64::max);
                let field = self
                    .fields
                    .iter()
                    .zip(&fields)
                    .map(|(field, seen)| {
                        (seen.column(k).norm_squared() * size * size - field.mean) / field.deviation
                    })
                    .fold(f64::MIN, f64::max);
                [
                    largest * size,
                    errors.column(k).norm_squared() * size * size,
                    field,
                ]
            })
            .collect()
    }
}

impl FieldScore {
    fn new(columns: &DMatrix<f64>) -> FieldScore {
        let reduced = principal(columns);
        let gram = reduced.transpose() * &reduced;
        let mean = gram.trace();
        let deviation = (2.0 * gram.norm_squared()).sqrt().max(f64::MIN_POSITIVE);
        FieldScore {
            columns: reduced,
            mean,
            deviation,
        }
    }
}

/// The few columns that carry a field's covariance.
fn principal(columns: &DMatrix<f64>) -> DMatrix<f64> {
    let eigen = (columns * columns.transpose()).symmetric_eigen();
    let largest = eigen.eigenvalues.max().max(f64::MIN_POSITIVE);
    let kept: Vec<DVector<f64>> = eigen
        .eigenvalues
        .iter()
        .enumerate()
        .filter(|(_, value)| **value > 1e-4 * largest)
        .map(|(k, value)| eigen.eigenvectors.column(k) * value.sqrt())
        .collect();
    if kept.is_empty() {
        return DMatrix::zeros(columns.nrows(), 1);
    }
    DMatrix::from_columns(&kept)
}
