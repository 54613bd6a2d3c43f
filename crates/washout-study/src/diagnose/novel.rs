//! An unknown cause: the missing load or compliance along the span, with its error and how it scales.

use nalgebra::{Cholesky, DMatrix, DVector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::study::Forward;

use super::baseline::Baseline;
use super::bump::Around;
use super::evidence::{Likelihood, Spectrum, ln_sum};
use super::fields::{AMPLITUDES, Field, LOADS, Law, share};
use super::laws::{Growth, growths};
use super::places::channel;
use super::scaling::{Scaling, scaling};
use super::whitened::Whitened;

/// One law with its evidence.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LawRow {
    /// How the missing field scales.
    pub law: Law,
    /// Logarithm of its evidence minus that of the best law.
    pub delta_ln_evidence: f64,
}

/// Missing load or compliance at one place.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FieldPoint {
    /// Place over the length of the wing.
    pub r_over_length: f64,
    /// Value in the unit of the field.
    pub value: f64,
    /// Its standard deviation.
    pub standard_deviation: f64,
}

/// The missing field in one condition, or at the largest frequency and amplitude that are fitted.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FieldProfile {
    /// Name of the condition; none if one law holds in all.
    pub condition: Option<String>,
    /// Along the span.
    pub points: Vec<FieldPoint>,
    /// Integral over r/length.
    pub total: f64,
    /// Centroid of its size over the length of the wing.
    pub centroid: f64,
}

/// A missing field without a name.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Reconstruction {
    /// Best law.
    pub law: Law,
    /// All laws, best first.
    pub laws: Vec<LawRow>,
    /// Unit of the field: `N m/m` for loads, `N m/m/deg` for springs, `1` for compliances, that of the readings (deg of twist, or mm of deflection) for errors of these.
    pub unit: String,
    /// The field along the span.
    pub field: Vec<FieldProfile>,
    /// How a load scales; none for other kinds.
    pub scaling: Option<Scaling>,
}

/// Columns of unit covariance of each field, in the order given.
fn seen(fields: &[Field], whitened: &Whitened) -> Vec<DMatrix<f64>> {
    fields
        .iter()
        .map(|field| whitened.directions_of_rows(&field.columns))
        .collect()
}

/// ln Z of each field (amplitudes averaged) whose columns are `seen`, and its best amplitude.
fn weigh(seen: &[DMatrix<f64>], whitened: &Whitened, likelihood: Likelihood) -> Vec<(f64, f64)> {
    let q0 = whitened.q();
    seen.iter()
        .map(|columns| {
            let spectrum = Spectrum::new(columns, &whitened.residual);
            let gains: Vec<f64> = AMPLITUDES
                .iter()
                .map(|&amplitude| spectrum.ln_gain(likelihood, q0, amplitude).0)
                .collect();
            let best = (0..gains.len()).max_by(|&a, &b| gains[a].total_cmp(&gains[b]));
            let mean = ln_sum(gains.iter().copied()) - (gains.len() as f64).ln();
            (mean, AMPLITUDES[best.unwrap_or(0)])
        })
        .collect()
}

/// The best field along the span, of all laws by which a load may grow, and of the others; about a bump that was fitted, if there is one.
/// None if there is no field.
pub fn reconstruct(baseline: &Baseline, around: Option<&Around>) -> Option<Reconstruction> {
    let forward = baseline.forward;
    let (whitened, moment, value, known) = match around {
        Some(around) => (&around.whitened, &around.moment, &around.value, &around.fields),
        None => (
            &baseline.whitened,
            &baseline.moment,
            &baseline.fit.predicted,
            &baseline.fields,
        ),
    };
    let growths = growths(forward, &baseline.data, moment, value);
    let is_load = |field: &&Field| matches!(field.law, Law::Load { .. } | Law::Onset { .. });
    let others = known.iter().filter(|field| !is_load(field));
    let loads = growths.iter().map(|growth| &growth.field);
    let fields: Vec<Field> = loads.chain(others).cloned().collect();
    let seen = seen(&fields, whitened);
    let weighed = weigh(&seen, whitened, baseline.likelihood);
    let of_loads = scaling_of_loads(&growths, &weighed);
    // of the more probable kind of growth, whichever single law is best
    let is_likelier = |k: &usize| {
        let is_onset = matches!(fields[*k].law, Law::Onset { .. });
        *k >= growths.len() || of_loads.is_none_or(|found| found.is_onset() == is_onset)
    };
    let order = best_first(&growths, &fields, &weighed);
    let best = order.iter().copied().find(is_likelier)?;
    let law = match (fields[best].law, of_loads.and_then(|found| found.onset)) {
        (Law::Onset { .. }, Some(onset)) => onset.law(),
        (law, _) => law,
    };
    let amplitude = weighed[best].1;
    let weights = weights_of(&(&seen[best] * amplitude), &whitened.residual)?;
    let field = profiles(forward, &fields[best], amplitude, &weights);
    let scaling = match fields[best].law {
        Law::Load { .. } | Law::Onset { .. } => of_loads,
        Law::Free => scaling_of_conditions(forward, &fields[best], &field),
        _ => None,
    };
    let laws = order.iter().map(|&k| LawRow {
        law: fields[k].law,
        delta_ln_evidence: weighed[k].0 - weighed[best].0,
    });
    Some(Reconstruction {
        law,
        laws: laws.collect(),
        unit: unit(baseline, fields[best].law).into(),
        field,
        scaling,
    })
}

/// How a load scales, from ln Z of the fields of all laws by which it may grow, the first of those `weighed`.
fn scaling_of_loads(growths: &[Growth], weighed: &[(f64, f64)]) -> Option<Scaling> {
    let of_laws = growths.iter().enumerate().flat_map(|(k, growth)| {
        let gain = weighed[k].0;
        growth.laws.iter().map(move |own| (*own, gain + own.share.ln()))
    });
    scaling(&of_laws.collect::<Vec<_>>())
}

/// Positions of the fields, the most probable first.
fn best_first(growths: &[Growth], fields: &[Field], weighed: &[(f64, f64)]) -> Vec<usize> {
    let weight = |k: usize| {
        let share = match growths.get(k) {
            Some(growth) => LOADS * growth.laws.iter().map(|own| own.share).sum::<f64>(),
            None => share(fields[k].law, fields),
        };
        weighed[k].0 + share.ln()
    };
    let mut order: Vec<usize> = (0..fields.len()).collect();
    order.sort_by(|&a, &b| weight(b).total_cmp(&weight(a)).then(a.cmp(&b)));
    order
}

/// The profiles of a field of this amplitude, from mean and covariance of its weights.
fn profiles(
    forward: &dyn Forward,
    field: &Field,
    amplitude: f64,
    (mean, covariance): &(DVector<f64>, DMatrix<f64>),
) -> Vec<FieldProfile> {
    let profiles = field.profiles.iter().map(|(condition, map)| {
        let map = map * amplitude;
        let (value, spread) = (&map * mean, &map * covariance * map.transpose());
        let name = condition.map(|condition| forward.conditions()[condition].name.clone());
        profile(name, &value, &spread)
    });
    profiles.collect()
}

fn unit(baseline: &Baseline, law: Law) -> &'static str {
    match law {
        Law::Load { .. } | Law::Onset { .. } | Law::Free => "N m/m",
        Law::Spring => "N m/m/deg",
        Law::Compliance => "1",
        Law::Sensor => channel(baseline.forward, &baseline.data).unit(),
    }
}

/// Mean and covariance of the weights v ~ N(0, I) of columns `x` given e = x v + N(0, I).
fn weights_of(x: &DMatrix<f64>, residual: &DVector<f64>) -> Option<(DVector<f64>, DMatrix<f64>)> {
    let size = x.ncols();
    let factor = Cholesky::new(DMatrix::identity(size, size) + x.transpose() * x)?;
    Some((factor.solve(&(x.transpose() * residual)), factor.inverse()))
}

fn profile(condition: Option<String>, value: &DVector<f64>, spread: &DMatrix<f64>) -> FieldProfile {
    let last = (value.len().max(2) - 1) as f64;
    let points: Vec<FieldPoint> = (0..value.len())
        .map(|j| FieldPoint {
            r_over_length: j as f64 / last,
            value: value[j],
            standard_deviation: spread[(j, j)].max(0.0).sqrt(),
        })
        .collect();
    let trapezoid = |j: usize| {
        if j == 0 || j + 1 == points.len() {
            0.5 / last
        } else {
            1.0 / last
        }
    };
    let sum = |of: &dyn Fn(&FieldPoint) -> f64| -> f64 {
        points
            .iter()
            .enumerate()
            .map(|(j, point)| trapezoid(j) * of(point))
            .sum()
    };
    let total = sum(&|point| point.value);
    let size = sum(&|point| point.value.powi(2));
    let moment = sum(&|point| point.value.powi(2) * point.r_over_length);
    FieldProfile {
        condition,
        total,
        centroid: if size > 0.0 { moment / size } else { 0.5 },
        points,
    }
}

/// Powers from the sizes of a free field in every condition, by regression of logarithms weighted by their errors.
fn scaling_of_conditions(forward: &dyn Forward, field: &Field, profiles: &[FieldProfile]) -> Option<Scaling> {
    let mut rows: Vec<([f64; 3], f64, f64)> = Vec::new();
    for ((condition, _), profile) in field.profiles.iter().zip(profiles) {
        let condition = &forward.conditions()[(*condition)?];
        let (Some(f), Some(phi)) = (condition.frequency_hz, condition.half_amplitude_deg) else {
            continue;
        };
        let count = profile.points.len() as f64;
        let size = (profile.points.iter().map(|p| p.value.powi(2)).sum::<f64>() / count).sqrt();
        let error = (profile
            .points
            .iter()
            .map(|p| p.standard_deviation.powi(2))
            .sum::<f64>()
            / count)
            .sqrt();
        if size > 0.0 && f > 0.0 && phi > 0.0 {
            rows.push(([1.0, f.ln(), phi.ln()], size.ln(), (error / size).max(0.05)));
        }
    }
    if rows.len() < 3 {
        return None;
    }
    let mut normal = DMatrix::from_diagonal(&DVector::from_vec(vec![1e-6, 0.25, 0.25]));
    let mut right = DVector::from_vec(vec![0.0, 0.25, 0.25]);
    for (row, value, error) in &rows {
        for i in 0..3 {
            right[i] += row[i] * value / (error * error);
            for j in 0..3 {
                normal[(i, j)] += row[i] * row[j] / (error * error);
            }
        }
    }
    let factor = Cholesky::new(normal)?;
    let (best, covariance) = (factor.solve(&right), factor.inverse());
    Some(Scaling::of_powers(
        [best[1], covariance[(1, 1)].sqrt()],
        [best[2], covariance[(2, 2)].sqrt()],
    ))
}
