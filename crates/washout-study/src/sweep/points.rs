//! The cases of a sweep: every combination of values, or samples that fill the ranges.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::axis::{Axis, Values};
use super::error::SweepError;
use crate::study::draws::Draws;
use crate::study::sample::{MOST_POINTS, unit_points};

/// Most cases of a grid.
pub const MOST_CASES: usize = 1_000_000;

/// How the cases are chosen.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[cfg_attr(feature = "cli", derive(clap::ValueEnum))]
#[serde(rename_all = "kebab-case")]
pub enum Method {
    /// Every combination.
    Grid,
    /// Owen-scrambled Sobol points: fill all directions evenly, powers of two best.
    Sobol,
    /// Latin hypercube: each range cut into as many slices as there are samples, one sample in each.
    Latin,
}

/// Values of every case, as text in the order of `axes`.
///
/// # Errors
/// If a grid meets a range without values, or there are too many.
pub fn points(
    axes: &[Axis],
    method: Method,
    samples: usize,
    seed: u32,
) -> Result<Vec<Vec<String>>, SweepError> {
    let at = |places: Vec<Vec<f64>>| {
        let values = |point: Vec<f64>| {
            axes.iter()
                .zip(point)
                .map(|(axis, place)| axis.at(place))
                .collect()
        };
        places.into_iter().map(values).collect()
    };
    match method {
        Method::Grid => grid(axes),
        _ if samples > MOST_POINTS => Err(SweepError::TooMany {
            asked: samples,
            most: MOST_POINTS,
        }),
        Method::Sobol => Ok(at(unit_points(samples, axes.len(), seed))),
        Method::Latin => Ok(at(latin(samples, axes.len(), seed))),
    }
}

/// The last axis moves fastest.
fn grid(axes: &[Axis]) -> Result<Vec<Vec<String>>, SweepError> {
    let mut cases: Vec<Vec<String>> = vec![Vec::new()];
    for axis in axes {
        let values = match &axis.values {
            Values::List(values) => values,
            Values::Range([low, high]) => {
                return Err(SweepError::RangeInGrid {
                    key: axis.key.clone(),
                    low: *low,
                    high: *high,
                });
            }
        };
        let asked = cases.len().saturating_mul(values.len());
        if asked > MOST_CASES {
            return Err(SweepError::TooMany {
                asked,
                most: MOST_CASES,
            });
        }
        let with = |case: &Vec<String>| -> Vec<Vec<String>> {
            let longer = |value: &String| case.iter().chain([value]).cloned().collect();
            values.iter().map(longer).collect()
        };
        cases = cases.iter().flat_map(with).collect();
    }
    Ok(cases)
}

/// McKay, Beckman & Conover, Technometrics 21 (1979) 239.
fn latin(count: usize, dimensions: usize, seed: u32) -> Vec<Vec<f64>> {
    let draws = Draws::new(u64::from(seed));
    let slices: Vec<Vec<usize>> = (0..dimensions as u64)
        .map(|dimension| {
            let mut order: Vec<usize> = (0..count).collect();
            for last in (1..count).rev() {
                let other = (draws.uniform(2 * dimension, last as u64) * (last + 1) as f64) as usize;
                order.swap(last, other);
            }
            order
        })
        .collect();
    let place = |sample: usize, dimension: usize| {
        let within = draws.uniform(2 * dimension as u64 + 1, sample as u64);
        (slices[dimension][sample] as f64 + within) / count as f64
    };
    (0..count)
        .map(|sample| {
            (0..dimensions)
                .map(|dimension| place(sample, dimension))
                .collect()
        })
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn axes(texts: &[&str]) -> Vec<Axis> {
        texts.iter().map(|text| Axis::parse(text).unwrap()).collect()
    }

    #[test]
    fn a_grid_is_every_combination_in_order() {
        let found = points(&axes(&["a=1,2", "b=x,y,z"]), Method::Grid, 0, 0).unwrap();
        let words: Vec<String> = found.iter().map(|point| point.join("")).collect();
        assert_eq!(words, ["1x", "1y", "1z", "2x", "2y", "2z"]);
        let error = points(&axes(&["a=1..2"]), Method::Grid, 0, 0).unwrap_err();
        assert!(error.to_string().contains("a=1..2:5"), "{error}");
        let error = points(&axes(&["a=0..1:10000", "b=0..1:10000"]), Method::Grid, 0, 0).unwrap_err();
        assert!(error.to_string().contains("100000000 cases"), "{error}");
    }

    #[test]
    fn samples_put_one_value_into_each_slice_of_each_range_and_hang_on_the_seed_alone() {
        for method in [Method::Latin, Method::Sobol] {
            let axes = axes(&["a=0..1", "b=10..20"]);
            let found = points(&axes, method, 32, 7).unwrap();
            for (axis, (low, width)) in [(0.0, 1.0), (10.0, 10.0)].into_iter().enumerate() {
                let slice = |point: &Vec<String>| {
                    (32.0 * (point[axis].parse::<f64>().unwrap() - low) / width) as usize
                };
                let mut slices: Vec<usize> = found.iter().map(slice).collect();
                slices.sort_unstable();
                assert_eq!(slices, (0..32).collect::<Vec<_>>(), "{method:?}");
            }
            assert_eq!(found, points(&axes, method, 32, 7).unwrap());
            assert_ne!(found, points(&axes, method, 32, 8).unwrap());
        }
    }
}
