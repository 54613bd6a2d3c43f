//! Where the fitted observables lie along the span, and how the predicted twist runs there.

use nalgebra::{DMatrix, DVector};

use crate::input::measurement::{Bound, Channel};
use crate::study::Forward;

use super::data::Data;

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
    pub(super) hats: DMatrix<f64>,
    /// Predicted twist of the observable's condition at the stations (for all channels).
    pub(super) twist_at_stations: DMatrix<f64>,
    /// ∫ hat · dθ from base to the observable.
    pub(super) compliance: DMatrix<f64>,
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

    /// How many observables.
    pub(super) fn len(&self) -> usize {
        self.value.len()
    }

    /// What makes the response at `positions` as large as the prediction there; none if there is none.
    pub(super) fn factor(&self, response: &DMatrix<f64>, positions: &[usize]) -> Option<f64> {
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
    pub(super) fn levels_and_tilts(&self, forward: &dyn Forward, data: &Data) -> DMatrix<f64> {
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
    fn hats_sum_to_one() {
        for x in [0.0, 0.13, 0.5, 1.0] {
            assert!(((0..7).map(|j| hat(x, j, 7)).sum::<f64>() - 1.0).abs() < 1e-12);
        }
    }
}
