//! What might be missing that has no name: smooth fields along the span, as Gaussian processes, by how they scale.

use nalgebra::{Cholesky, DMatrix, DVector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::{Bound, Channel};
use crate::study::{Condition, Forward};

use super::data::Data;

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
}

/// Fields to try: `moment` is the response of all observables to a moment at each station, `value` the prediction.
pub fn fields(forward: &dyn Forward, data: &Data, moment: &DMatrix<f64>, value: &DVector<f64>) -> Vec<Field> {
    let stations = moment.ncols();
    let root = smooth_root(stations);
    let moment = moment.select_rows(data.rows.iter());
    let place = Places::new(forward, data, value, stations);
    let loads = POWERS.map(|(frequency_power, amplitude_power)| Law::Load {
        frequency_power,
        amplitude_power,
    });
    let loads = load_fields(forward, data, &place, &(&moment * &root), &root, &loads);
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
        found.extend(place.scaled(law, &(response * &root), &root));
    }
    found
}

/// A field for each way in which `laws` grow in the conditions that are fitted, with the laws that grow so, the first of which it has;
/// `response`: of the fitted observables to a smooth moment that is the same in all conditions.
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
        } else if let Some(field) = place.scaled(*law, &(DMatrix::from_diagonal(&factors) * response), root) {
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

/// What is read along the span: twist, or deflection if no reading that is fitted is one of twist.
pub(super) fn channel(forward: &dyn Forward, data: &Data) -> Channel {
    let observables = forward.observables();
    let is_twist = |&row: &usize| observables[row].channel == Channel::Twist;
    match data.rows.iter().any(is_twist) {
        true => Channel::Twist,
        false => Channel::Deflection,
    }
}

/// Where the fitted observables lie, and how the predicted twist runs there.
pub(super) struct Places {
    /// Prediction and stated standard deviation.
    value: DVector<f64>,
    sigma: DVector<f64>,
    /// Hat functions of the stations at the observables that read twist (deflection, if none does).
    hats: DMatrix<f64>,
    /// Predicted twist of the observable's condition at the stations (for all channels).
    twist_at_stations: DMatrix<f64>,
    /// ∫ hat · dθ from base to the observable.
    compliance: DMatrix<f64>,
}

impl Places {
    pub(super) fn new(forward: &dyn Forward, data: &Data, value: &DVector<f64>, stations: usize) -> Places {
        let observables = forward.observables();
        let size = data.rows.len();
        let mut places = Places {
            value: DVector::from_iterator(size, data.rows.iter().map(|&row| value[row])),
            sigma: DVector::from_iterator(size, data.rows.iter().map(|&row| observables[row].sigma)),
            hats: DMatrix::zeros(size, stations),
            twist_at_stations: DMatrix::zeros(size, stations),
            compliance: DMatrix::zeros(size, stations),
        };
        let channel = channel(forward, data);
        for (condition, positions) in data.conditions(forward) {
            let length_mm = 1e3 * forward.conditions()[condition].length_m;
            let at = |position: usize| {
                let observable = &observables[data.rows[position]];
                let is_value = observable.channel == channel && observable.bound == Bound::None;
                is_value.then_some(observable.r_mm.unwrap_or(0.0) / length_mm)
            };
            let mut line: Vec<[f64; 2]> = positions
                .iter()
                .filter_map(|&position| Some([at(position)?, places.value[position]]))
                .collect();
            line.push([0.0, 0.0]);
            line.sort_by(|a, b| a[0].total_cmp(&b[0]));
            line.dedup_by(|a, b| (a[0] - b[0]).abs() < 1e-12);
            let twist: Vec<f64> = (0..stations)
                .map(|j| along(&line, j as f64 / (stations - 1) as f64))
                .collect();
            for &position in &positions {
                for (j, twist) in twist.iter().enumerate() {
                    places.twist_at_stations[(position, j)] = *twist;
                }
                let Some(x) = at(position) else { continue };
                for j in 0..stations {
                    places.hats[(position, j)] = hat(x, j, stations);
                }
                let steps = 200;
                for step in 0..steps {
                    let (x0, x1) = (
                        x * f64::from(step) / f64::from(steps),
                        x * f64::from(step + 1) / f64::from(steps),
                    );
                    let rise = along(&line, x1) - along(&line, x0);
                    for j in 0..stations {
                        places.compliance[(position, j)] += rise * hat(0.5 * (x0 + x1), j, stations);
                    }
                }
            }
        }
        places
    }

    /// What makes the response at `positions` as large as the prediction there; none if there is none.
    fn factor(&self, response: &DMatrix<f64>, positions: &[usize]) -> Option<f64> {
        let (mut predicted, mut responded) = (0.0, 0.0);
        for &position in positions {
            let weight = self.sigma[position].powi(-2);
            predicted += weight * self.value[position].powi(2);
            responded += weight * response.row(position).norm_squared();
        }
        (responded > 0.0 && predicted > 0.0).then(|| (predicted / responded).sqrt())
    }

    /// For each channel but twist on each wing, its prediction, and the same times the place along the span and the logarithm
    /// of the dynamic pressure (both from -1 to 1) where three or more tell them apart: smooth over stations and conditions, so
    /// that one number that is off stays one number.
    fn levels_and_tilts(&self, forward: &dyn Forward, data: &Data) -> DMatrix<f64> {
        let observables = forward.observables();
        let of = |position: usize| &observables[data.rows[position]];
        let condition = |position: usize| &forward.conditions()[of(position).condition];
        let mut groups: Vec<((Channel, &str), Vec<usize>)> = Vec::new();
        for position in (0..self.value.len()).filter(|&position| !of(position).channel.is_twist()) {
            let key = (of(position).channel, condition(position).wing.as_str());
            match groups.iter_mut().find(|(known, _)| *known == key) {
                Some((_, own)) => own.push(position),
                None => groups.push((key, vec![position])),
            }
        }
        let mut columns: Vec<DVector<f64>> = Vec::new();
        for (_, own) in groups {
            let place = centred(&own, &|position| of(position).r_mm.unwrap_or(0.0));
            let load = centred(&own, &|position| {
                condition(position).dynamic_pressure_pa.max(1e-9).ln()
            });
            for weights in [vec![], vec![&place], vec![&load], vec![&place, &load]] {
                let Some(weights) = weights
                    .into_iter()
                    .map(Option::as_ref)
                    .collect::<Option<Vec<_>>>()
                else {
                    continue;
                };
                let mut column = DVector::zeros(self.value.len());
                for (index, &position) in own.iter().enumerate() {
                    let weight: f64 = weights.iter().map(|weight: &&Vec<f64>| weight[index]).product();
                    column[position] = self.value[position] * weight;
                }
                columns.push(column);
            }
        }
        match columns.is_empty() {
            true => DMatrix::zeros(self.value.len(), 0),
            false => DMatrix::from_columns(&columns),
        }
    }

    pub(super) fn scaled(&self, law: Law, response: &DMatrix<f64>, root: &DMatrix<f64>) -> Option<Field> {
        let all: Vec<usize> = (0..self.value.len()).collect();
        let factor = self.factor(response, &all)?;
        Some(Field {
            law,
            columns: response * factor,
            profiles: vec![(None, root * factor)],
        })
    }
}

/// A number of each position, mapped to -1 to 1; none if it takes fewer than three values.
fn centred(positions: &[usize], of: &dyn Fn(usize) -> f64) -> Option<Vec<f64>> {
    let numbers: Vec<f64> = positions.iter().map(|&position| of(position)).collect();
    let mut values = numbers.clone();
    values.sort_by(f64::total_cmp);
    values.dedup_by(|a, b| (*a - *b).abs() < 1e-9);
    let [low, high] = [values.first()?, values.last()?];
    (values.len() >= 3).then(|| {
        numbers
            .iter()
            .map(|x| 2.0 * (x - low) / (high - low) - 1.0)
            .collect()
    })
}

fn hat(x: f64, station: usize, stations: usize) -> f64 {
    (1.0 - (x * (stations - 1) as f64 - station as f64).abs()).max(0.0)
}

/// Value at `x` of the broken line through `points`, constant beyond its ends.
fn along(points: &[[f64; 2]], x: f64) -> f64 {
    let after = points.partition_point(|point| point[0] < x);
    let Some(right) = points.get(after) else {
        return points.last().map_or(0.0, |point| point[1]);
    };
    let Some(left) = after.checked_sub(1).and_then(|before| points.get(before)) else {
        return right[1];
    };
    left[1] + (right[1] - left[1]) * (x - left[0]) / (right[0] - left[0])
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_broken_line_is_met_at_its_corners_and_held_beyond() {
        let line = [[0.0, 0.0], [0.5, 2.0], [1.0, 3.0]];
        assert_eq!(
            [along(&line, 0.25), along(&line, 0.5), along(&line, 0.75)],
            [1.0, 2.0, 2.5]
        );
        assert_eq!([along(&line, 2.0), along(&line, 0.0)], [3.0, 0.0]);
    }

    #[test]
    fn hats_sum_to_one_and_the_smooth_root_gives_unit_variance() {
        for x in [0.0, 0.13, 0.5, 1.0] {
            assert!(((0..7).map(|j| hat(x, j, 7)).sum::<f64>() - 1.0).abs() < 1e-12);
        }
        let root = smooth_root(9);
        let covariance = &root * root.transpose();
        assert!((covariance[(4, 4)] - 1.0).abs() < 1e-5);
        assert!((covariance[(4, 5)] - (-0.5 * (0.125f64 / 0.2).powi(2)).exp()).abs() < 1e-9);
    }
}
