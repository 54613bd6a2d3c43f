//! What might be missing that has no name: smooth fields along the span, as Gaussian processes, by how they scale.

use nalgebra::{Cholesky, DMatrix, DVector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::Channel;
use crate::study::{Condition, Forward};

use super::data::Data;
use super::places::{Places, channel};

/// Correlation length of a missing field, over the length of the wing.
const SPAN_LENGTH: f64 = 0.2;
/// Correlation of a free field between conditions.
const FREE_CORRELATION: f64 = 0.6;

/// Powers of frequency and amplitude of the loads that are weighed against the known effects.
const POWERS: [(f64, f64); 9] = [
    (0.0, 0.0),
    (1.0, 0.0),
    (0.0, 1.0),
    (1.0, 1.0),
    (2.0, 0.0),
    (0.0, 2.0),
    (2.0, 1.0),
    (1.0, 2.0),
    (2.0, 2.0),
];

/// Amplitudes tried, as the size of the response over that of the prediction.
pub const AMPLITUDES: [f64; 4] = [0.03, 0.1, 0.3, 1.0];

/// Prior share of loads that scale with the motion, among the unnamed fields.
pub(super) const LOADS: f64 = 0.45;
/// Prior share of springs.
pub(super) const SPRINGS: f64 = 0.1;
/// Prior share of compliances.
pub(super) const COMPLIANCES: f64 = 0.2;

/// How a missing field enters and scales.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case", tag = "kind")]
pub enum Law {
    /// A moment per length m(x) (f/f₁)^a (Φ/Φ₁)^b; index 1: the largest of the study.
    Load {
        /// a.
        frequency_power: f64,
        /// b.
        amplitude_power: f64,
    },
    /// A moment per length m(x) (v − v₀)₊/(v₁ − v₀) with the frequency or amplitude v.
    Onset {
        /// v.
        of: Driver,
        /// v₀, Hz or deg.
        from: f64,
    },
    /// A moment per length of its own in every condition.
    Free,
    /// A moment per length −b(x) θ.
    Spring,
    /// A twist rate β(x) dθ/dx: the wing is softer than modelled. (Of the deflection, where no twist was read.)
    Compliance,
    /// An error of the reading, the same in all conditions.
    Sensor,
}

impl Law {
    /// How large a load is in a condition, over that at the largest frequency `f1` (Hz) and amplitude `phi1` (deg); nought for what is
    /// no load that grows by a law.
    pub(super) fn factor(&self, condition: &Condition, f1: f64, phi1: f64) -> f64 {
        match *self {
            Law::Load {
                frequency_power,
                amplitude_power,
            } => {
                power(condition.frequency_hz, f1, frequency_power)
                    * power(condition.half_amplitude_deg, phi1, amplitude_power)
            }
            Law::Onset { of, from } => {
                let largest = match of {
                    Driver::Frequency => f1,
                    Driver::Amplitude => phi1,
                };
                let over = of.of(condition).map_or(0.0, |value| (value - from).max(0.0));
                over / (largest - from)
            }
            Law::Free | Law::Spring | Law::Compliance | Law::Sensor => 0.0,
        }
    }
}

/// What of the motion a missing load may grow with.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Driver {
    /// The flapping frequency, Hz.
    Frequency,
    /// The half amplitude of the stroke, deg.
    Amplitude,
}

impl Driver {
    /// Its value in a condition; none in a bench load.
    pub fn of(self, condition: &Condition) -> Option<f64> {
        match self {
            Driver::Frequency => condition.frequency_hz,
            Driver::Amplitude => condition.half_amplitude_deg,
        }
    }
}

/// A Gaussian field with columns of unit prior variance.
#[derive(Debug, Clone)]
pub struct Field {
    /// How it enters and scales.
    pub law: Law,
    /// Response of the fitted observables, in their units, when the response is as large as the prediction itself.
    pub columns: DMatrix<f64>,
    /// From the columns' weights to the field at the stations, for each condition or for all.
    pub profiles: Vec<(Option<usize>, DMatrix<f64>)>,
    /// The same response to the field at each station alone that moves a reading; none of a field of its own in every condition.
    pub local: DMatrix<f64>,
}

/// Fields to try: `moment` is the response of all observables to a moment at each station, `value` the prediction.
pub fn fields(forward: &dyn Forward, data: &Data, moment: &DMatrix<f64>, value: &DVector<f64>) -> Vec<Field> {
    let stations = moment.ncols();
    let root = smooth_root(stations);
    let moment = moment.select_rows(data.rows.iter());
    let place = Places::new(forward, data, value, stations);
    let powers = POWERS.map(|(frequency_power, amplitude_power)| Law::Load {
        frequency_power,
        amplitude_power,
    });
    let loads: Vec<Law> = powers.into_iter().chain(onsets(forward, data)).collect();
    let loads = load_fields(forward, data, &place, &moment, &root, &loads);
    let mut found: Vec<Field> = loads.into_iter().map(|(field, _)| field).collect();
    found.push(free_field(forward, data, &place, &moment, &root));
    let others = [
        (Law::Spring, -moment.component_mul(&place.twist_at_stations)),
        (Law::Compliance, place.compliance.clone()),
        (Law::Sensor, place.hats.clone()),
    ];
    for (law, response) in others {
        // what goes with the twist needs its reading
        if matches!(law, Law::Spring | Law::Compliance) && channel(forward, data) != Channel::Twist {
            continue;
        }
        found.extend(scaled(&place, law, &response, &root));
    }
    found
}

/// Loads that set in between two neighbouring frequencies or amplitudes of what is fitted, halfway.
fn onsets(forward: &dyn Forward, data: &Data) -> Vec<Law> {
    let mut found = Vec::new();
    for of in [Driver::Frequency, Driver::Amplitude] {
        let conditions = data.conditions(forward).into_iter();
        let values = conditions.filter_map(|(condition, _)| of.of(&forward.conditions()[condition]));
        let onset = |pair: &[f64]| Law::Onset {
            of,
            from: 0.5 * (pair[0] + pair[1]),
        };
        found.extend(distinct(values).windows(2).map(onset));
    }
    found
}

/// Values, rising, each once.
pub(super) fn distinct(values: impl Iterator<Item = f64>) -> Vec<f64> {
    let mut values: Vec<f64> = values.collect();
    values.sort_by(f64::total_cmp);
    values.dedup_by(|a, b| (*a - *b).abs() < 1e-9 * b.abs());
    values
}

/// A field for each way in which `laws` grow in the conditions that are fitted, with the laws that grow so, the first of which it has;
/// `response`: of the fitted observables to a moment at each station that is the same in all conditions.
pub(super) fn load_fields(
    forward: &dyn Forward,
    data: &Data,
    place: &Places,
    response: &DMatrix<f64>,
    root: &DMatrix<f64>,
    laws: &[Law],
) -> Vec<(Field, Vec<usize>)> {
    let of_row = |row: usize| &forward.conditions()[forward.observables()[row].condition];
    let largest = |driver: Driver| {
        let values = data.rows.iter().filter_map(|&row| driver.of(of_row(row)));
        values.fold(f64::MIN_POSITIVE, f64::max)
    };
    let [f1, phi1] = [Driver::Frequency, Driver::Amplitude].map(largest);
    let mut grown: Vec<DVector<f64>> = Vec::new();
    let mut found: Vec<(Field, Vec<usize>)> = Vec::new();
    for (index, law) in laws.iter().enumerate() {
        let factors = data.rows.iter().map(|&row| law.factor(of_row(row), f1, phi1));
        let factors = DVector::from_iterator(data.rows.len(), factors);
        let size = factors.amax();
        if size == 0.0 {
            continue;
        }
        let shape = &factors / size;
        if let Some(same) = grown.iter().position(|known| (known - &shape).amax() < 1e-9) {
            found[same].1.push(index);
        } else if let Some(field) = scaled(place, *law, &(DMatrix::from_diagonal(&factors) * response), root)
        {
            grown.push(shape);
            found.push((field, vec![index]));
        }
    }
    found
}

/// (x/x₁)^p; a bench load without x has no part in a law that needs it.
fn power(value: Option<f64>, largest: f64, power: f64) -> f64 {
    match value {
        _ if power == 0.0 => 1.0,
        Some(value) => (value / largest).powi(power as i32),
        None => 0.0,
    }
}

/// A field by its law, and `response`: of the fitted observables to it at each station; none if no reading answers.
fn scaled(place: &Places, law: Law, response: &DMatrix<f64>, root: &DMatrix<f64>) -> Option<Field> {
    let all: Vec<usize> = (0..place.len()).collect();
    let smooth = response * root;
    let factor = place.factor(&smooth, &all)?;
    let local: Vec<DVector<f64>> = response
        .column_iter()
        .filter_map(|own| {
            let own = DMatrix::from_column_slice(own.len(), 1, own.clone_owned().as_slice());
            let factor = place.factor(&own, &all)?;
            Some(own.column(0) * factor)
        })
        .collect();
    Some(Field {
        law,
        columns: smooth * factor,
        profiles: vec![(None, root * factor)],
        local: match local.is_empty() {
            true => DMatrix::zeros(response.nrows(), 0),
            false => DMatrix::from_columns(&local),
        },
    })
}

fn free_field(
    forward: &dyn Forward,
    data: &Data,
    place: &Places,
    moment: &DMatrix<f64>,
    root: &DMatrix<f64>,
) -> Field {
    let conditions = data.conditions(forward);
    let (size, width) = (data.rows.len(), root.ncols());
    let response = moment * root;
    let mut columns = DMatrix::zeros(size, width * (1 + conditions.len()));
    let mut profiles = Vec::new();
    let (shared, own) = (FREE_CORRELATION.sqrt(), (1.0 - FREE_CORRELATION).sqrt());
    for (index, (condition, positions)) in conditions.iter().enumerate() {
        let factor = place.factor(&response, positions).unwrap_or(0.0);
        for &position in positions {
            let row = response.row(position) * factor;
            columns
                .view_mut((position, 0), (1, width))
                .copy_from(&(&row * shared));
            let first = width * (1 + index);
            columns
                .view_mut((position, first), (1, width))
                .copy_from(&(&row * own));
        }
        let mut profile = DMatrix::zeros(root.nrows(), columns.ncols());
        profile
            .columns_mut(0, width)
            .copy_from(&(root * (factor * shared)));
        profile
            .columns_mut(width * (1 + index), width)
            .copy_from(&(root * (factor * own)));
        profiles.push((Some(*condition), profile));
    }
    // no moment moves a lift: what the other channels are off by is as free
    let others = place.levels_and_tilts(forward, data);
    for (_, profile) in &mut profiles {
        *profile = profile
            .clone()
            .resize_horizontally(columns.ncols() + others.ncols(), 0.0);
    }
    let first = columns.ncols();
    columns = columns.resize_horizontally(first + others.ncols(), 0.0);
    columns.columns_mut(first, others.ncols()).copy_from(&others);
    Field {
        law: Law::Free,
        columns,
        profiles,
        local: DMatrix::zeros(size, 0),
    }
}

/// Square root of the covariance of a smooth field at evenly spaced stations.
pub(super) fn smooth_root(stations: usize) -> DMatrix<f64> {
    let step = 1.0 / (stations.max(2) - 1) as f64;
    let covariance = DMatrix::from_fn(stations, stations, |i, j| {
        let apart = (i as f64 - j as f64) * step / SPAN_LENGTH;
        (-0.5 * apart * apart).exp() + if i == j { 1e-6 } else { 0.0 }
    });
    Cholesky::new(covariance).map_or_else(|| DMatrix::identity(stations, stations), |factor| factor.unpack())
}

/// Prior share of a law among the unnamed fields.
pub(super) fn share(law: Law, fields: &[Field]) -> f64 {
    let is_load = |law: Law| matches!(law, Law::Load { .. } | Law::Onset { .. });
    let is_kind = |a: Law, b: Law| std::mem::discriminant(&a) == std::mem::discriminant(&b);
    let same = |a: Law, b: Law| is_kind(a, b) || (is_load(a) && is_load(b));
    let rivals = fields.iter().filter(|field| same(field.law, law)).count() as f64;
    let group = match law {
        Law::Load { .. } | Law::Onset { .. } => LOADS,
        Law::Free => 0.15,
        Law::Spring => SPRINGS,
        Law::Compliance => COMPLIANCES,
        Law::Sensor => 0.1,
    };
    group / rivals
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn the_smooth_root_gives_unit_variance() {
        let root = smooth_root(9);
        let covariance = &root * root.transpose();
        assert!((covariance[(4, 4)] - 1.0).abs() < 1e-5);
        assert!((covariance[(4, 5)] - (-0.5 * (0.125f64 / 0.2).powi(2)).exp()).abs() < 1e-9);
    }
}
