//! The assumed ranges of a design propagated to its results.
//!
//! Each assumed input is drawn uniformly over its range, independent of the others: a range says what is thought
//! possible and nothing more, so the band is one of ignorance, not of scatter between wings.

use std::fmt::Display;
use std::sync::atomic::{AtomicUsize, Ordering};

use rayon::iter::{IntoParallelRefIterator, ParallelIterator};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::assumption::Assumption;
use crate::input::design::Design;
use crate::progress::Progress;

use super::band::OutputBand;
use super::error::StudyError;
use super::output::Output;
use super::sample::{MOST_POINTS, unit_points};

/// How the ranges are sampled, in words for a report.
pub const DISTRIBUTION: &str = "each assumed input uniform over its range, independent of the others";

/// Fewest samples that make a band.
pub const FEWEST_SAMPLES: usize = 16;

/// Settings of a propagation.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub struct UncertaintySettings {
    /// Number of samples; powers of two fill the ranges most evenly.
    pub samples: usize,
    /// Seed of the scrambling; the same seed gives the same samples.
    pub seed: u32,
}

impl Default for UncertaintySettings {
    fn default() -> Self {
        UncertaintySettings { samples: 64, seed: 1 }
    }
}

/// The assumed ranges of a design propagated to its results.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Uncertainty {
    /// How the ranges are sampled.
    pub distribution: String,
    /// Samples drawn.
    pub samples: usize,
    /// The assumed inputs.
    pub inputs: Vec<UncertainInput>,
    /// Band of every output and the shares of the inputs in it.
    pub outputs: Vec<OutputBand>,
    /// Samples that gave no result; the bands rest on the others.
    pub failures: Vec<FailedSample>,
}

/// An assumed input.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct UncertainInput {
    /// Dotted key, unit in its name.
    pub key: String,
    /// Assumed value.
    pub value: f64,
    /// Range over which it is drawn.
    pub range: [f64; 2],
}

/// A sample that gave no result.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct FailedSample {
    /// Its number, from 0.
    pub sample: usize,
    /// Values of the inputs, in their order.
    pub values: Vec<f64>,
    /// Why it gave no result.
    pub reason: String,
}

/// Propagates the assumed ranges of `design` to what `evaluate` gives, one value per output.
///
/// Samples run on rayon's threads; each depends on its own inputs alone, so the result is the same for any number of
/// threads as long as `evaluate` is a function of its design (a warm start may come from the nominal design only).
/// A sample that fails or gives a value that is not finite is counted and listed, never dropped silently.
pub fn propagate<E, F>(
    design: &Design,
    outputs: &[Output],
    settings: UncertaintySettings,
    progress: &Progress,
    evaluate: F,
) -> Result<Uncertainty, StudyError>
where
    E: Display,
    F: Fn(&Design) -> Result<Vec<f64>, E> + Sync,
{
    let inputs = uncertain_inputs(design, settings)?;
    progress.say("uncertainty: the design itself");
    let read = |design: &Design| {
        checked(
            evaluate(design).map_err(|error| error.to_string())?,
            outputs.len(),
        )
    };
    let nominal = read(design);
    // an interrupted solve has failed for no reason of its own
    progress.check()?;
    let nominal = nominal.map_err(|reason| StudyError::Nominal { reason })?;
    let points = unit_points(settings.samples, inputs.len(), settings.seed);
    let done = AtomicUsize::new(0);
    let say = |done: usize| {
        progress.say(format_args!(
            "uncertainty: {done} of {} samples solved",
            settings.samples
        ));
    };
    say(0);
    let results: Vec<Result<Vec<f64>, String>> = points
        .par_iter()
        .map(|point| {
            if progress.is_cancelled() {
                return Err(String::new());
            }
            let result = sampled(design, &inputs, point).and_then(|sample| read(&sample));
            say(done.fetch_add(1, Ordering::Relaxed) + 1);
            result
        })
        .collect();
    progress.check()?;
    summarise(inputs, outputs, nominal, &points, results)
}

fn uncertain_inputs(
    design: &Design,
    settings: UncertaintySettings,
) -> Result<Vec<UncertainInput>, StudyError> {
    let asked = settings.samples;
    if asked < FEWEST_SAMPLES {
        return Err(StudyError::TooFewSamples {
            asked,
            fewest: FEWEST_SAMPLES,
        });
    }
    if asked > MOST_POINTS {
        return Err(StudyError::TooManySamples {
            asked,
            most: MOST_POINTS,
        });
    }
    let check = |Assumption {
                     key, value, range, ..
                 }: Assumption| {
        let [low, high] = range;
        if low.is_finite() && high.is_finite() && low <= value && value <= high {
            Ok(UncertainInput { key, value, range })
        } else {
            Err(StudyError::BadRange {
                key,
                value,
                low,
                high,
            })
        }
    };
    let inputs: Vec<UncertainInput> = design
        .assumptions()
        .into_iter()
        .map(check)
        .collect::<Result<_, _>>()?;
    if inputs.is_empty() {
        Err(StudyError::NothingAssumed)
    } else {
        Ok(inputs)
    }
}

impl UncertainInput {
    fn at(&self, unit: f64) -> f64 {
        self.range[0] + unit * (self.range[1] - self.range[0])
    }
}

/// The design with its inputs at a point of the unit cube.
fn sampled(design: &Design, inputs: &[UncertainInput], point: &[f64]) -> Result<Design, String> {
    let mut sample = design.clone();
    for (input, unit) in inputs.iter().zip(point) {
        sample
            .set(&input.key, input.at(*unit))
            .map_err(|error| error.to_string())?;
    }
    Ok(sample)
}

fn checked(values: Vec<f64>, expected: usize) -> Result<Vec<f64>, String> {
    if values.len() != expected {
        return Err(format!("{} values instead of {expected}", values.len()));
    }
    match values.iter().position(|value| !value.is_finite()) {
        Some(place) => Err(format!("value {} is not a finite number", place + 1)),
        None => Ok(values),
    }
}

fn summarise(
    inputs: Vec<UncertainInput>,
    outputs: &[Output],
    nominal: Vec<f64>,
    points: &[Vec<f64>],
    results: Vec<Result<Vec<f64>, String>>,
) -> Result<Uncertainty, StudyError> {
    let samples = results.len();
    let (mut places, mut rows, mut failures) = (Vec::new(), Vec::new(), Vec::new());
    for (sample, (result, point)) in results.into_iter().zip(points).enumerate() {
        match result {
            Ok(row) => {
                places.push(point.iter().map(|unit| 2.0 * unit - 1.0).collect::<Vec<f64>>());
                rows.push(row);
            }
            Err(reason) => {
                let values = inputs
                    .iter()
                    .zip(point)
                    .map(|(input, unit)| input.at(*unit))
                    .collect();
                failures.push(FailedSample {
                    sample,
                    values,
                    reason,
                });
            }
        }
    }
    if rows.len() < FEWEST_SAMPLES {
        let reason = failures
            .first()
            .map_or_else(String::new, |failure| failure.reason.clone());
        return Err(StudyError::SamplesFailed {
            failed: failures.len(),
            samples,
            reason,
        });
    }
    let keys: Vec<String> = inputs.iter().map(|input| input.key.clone()).collect();
    let bands = outputs.iter().enumerate().map(|(k, output)| {
        let values: Vec<f64> = rows.iter().map(|row| row[k]).collect();
        OutputBand::of(output, nominal[k], &places, &values, &keys)
    });
    let outputs = bands.collect();
    Ok(Uncertainty {
        distribution: DISTRIBUTION.to_string(),
        samples,
        inputs,
        outputs,
        failures,
    })
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::observation::imposed;

    /// Three assumed inputs: amplitude 24 to 45 deg, film tension 0 to 74 N/m, stop angle 40 to 50 deg.
    fn assumed() -> Design {
        let mut design = imposed::design("");
        let assume = |assumed: f64, range: [f64; 2]| {
            let why = "not stated".to_string();
            crate::input::quantity::Quantity::Assumed(crate::input::quantity::Assumed { assumed, range, why })
        };
        let flapping = design.flapping.as_mut().unwrap();
        flapping.half_amplitude_deg = assume(34.5, [24.0, 45.0]);
        flapping.stop_angle_deg = assume(45.0, [40.0, 50.0]);
        design.planform.mean_chord_mm = Some(assume(20.5, [20.0, 21.0]));
        design
            .rod
            .iter_mut()
            .for_each(|rod| rod.material = Some("rod".into()));
        design
            .spar
            .iter_mut()
            .for_each(|spar| spar.material = Some("rod".into()));
        let material = "e_gpa = 134.0\ng_gpa = 4.0\ndensity_kg_m3 = 1500.0";
        for name in ["rod", "kapton"] {
            design
                .material
                .insert(name.into(), toml::from_str(material).unwrap());
        }
        design
    }

    fn values(design: &Design) -> [f64; 3] {
        let flapping = design.flapping.as_ref().unwrap();
        let scaled = |value: f64, [low, high]: [f64; 2]| (2.0 * value - low - high) / (high - low);
        [
            scaled(flapping.half_amplitude_deg.value(), [24.0, 45.0]),
            scaled(flapping.stop_angle_deg.value(), [40.0, 50.0]),
            scaled(
                design.planform.mean_chord_mm.as_ref().unwrap().value(),
                [20.0, 21.0],
            ),
        ]
    }

    fn quadratic(design: &Design) -> Result<Vec<f64>, String> {
        let [a, b, _] = values(design);
        Ok(vec![2.0 * a + b + 1.5 * a * b, 7.0])
    }

    fn outputs() -> [Output; 2] {
        ["f (deg)", "constant (deg)"].map(|name| Output::Named {
            name: name.to_string(),
        })
    }

    fn run<E: Display + Send>(
        evaluate: impl Fn(&Design) -> Result<Vec<f64>, E> + Sync,
    ) -> Result<Uncertainty, StudyError> {
        propagate(
            &assumed(),
            &outputs(),
            UncertaintySettings::default(),
            &Progress::quiet(),
            evaluate,
        )
    }

    #[test]
    fn shares_of_a_quadratic_of_three_assumptions_are_its_sobol_indices_and_an_inert_one_is_left_out() {
        let result = run(quadratic).unwrap();
        assert_eq!(result.inputs.len(), 3);
        let band = &result.outputs[0];
        let parts = [4.0 / 3.0, 1.0 / 3.0, 2.25 / 9.0];
        let variance: f64 = parts.iter().sum();
        let names: Vec<&str> = band.shares.iter().map(|share| share.key.as_str()).collect();
        assert_eq!(names, ["flapping.half_amplitude_deg", "flapping.stop_angle_deg"]);
        assert!((band.shares[0].first_order - parts[0] / variance).abs() < 1e-9);
        assert!((band.shares[0].total - (parts[0] + parts[2]) / variance).abs() < 1e-9);
        assert!((band.shares[1].total - (parts[1] + parts[2]) / variance).abs() < 1e-9);
        assert!(band.surrogate.unwrap().r_squared > 1.0 - 1e-12);
        let constant = &result.outputs[1];
        assert_eq!((constant.q05, constant.q95, constant.surrogate), (7.0, 7.0, None));
        assert!(constant.shares.is_empty());
    }

    #[test]
    fn the_band_of_one_uniform_input_is_its_quantiles() {
        let result = run(|design: &Design| Ok::<_, String>(vec![values(design)[0], 0.0])).unwrap();
        let band = &result.outputs[0];
        assert!((band.q05 + 0.9).abs() < 2.0 / 64.0, "{band:?}");
        assert!(band.median.abs() < 2.0 / 64.0, "{band:?}");
        assert!((band.q95 - 0.9).abs() < 2.0 / 64.0, "{band:?}");
        assert_eq!(band.nominal, values(&assumed())[0]);
    }

    #[test]
    fn the_result_is_bit_for_bit_the_same_for_one_two_and_five_threads() {
        let with = |threads: usize| {
            let pool = rayon::ThreadPoolBuilder::new()
                .num_threads(threads)
                .build()
                .unwrap();
            pool.install(|| run(quadratic).unwrap())
        };
        let one = with(1);
        assert_eq!(one, with(2));
        assert_eq!(one, with(5));
    }

    #[test]
    fn samples_that_fail_are_listed_with_reason_and_inputs_and_the_band_rests_on_the_others() {
        let result = run(|design: &Design| match values(design)[0] {
            a if a > 0.75 => Err("beyond divergence".to_string()),
            a if a < -0.9 => Ok(vec![f64::NAN, 0.0]),
            a => Ok(vec![a, 0.0]),
        })
        .unwrap();
        let reasons = |word: &str| result.failures.iter().filter(|f| f.reason.contains(word)).count();
        assert_eq!((reasons("beyond divergence"), reasons("not a finite")), (8, 3));
        assert!(result.outputs[0].q95 < 0.75);
        for failure in &result.failures {
            let amplitude_deg = failure.values[result
                .inputs
                .iter()
                .position(|i| i.key.contains("amplitude"))
                .unwrap()];
            assert!(!(25.1..=42.3).contains(&amplitude_deg), "{failure:?}");
        }
    }

    #[test]
    fn too_many_failures_or_a_design_that_fails_itself_are_errors_that_name_the_reason() {
        let nominal = values(&assumed())[0];
        let error = run(|design: &Design| match values(design)[0] {
            a if a == nominal => Ok(vec![0.0, 0.0]),
            _ => Err("no convergence"),
        })
        .unwrap_err();
        assert!(error.to_string().contains("64 of 64") && error.to_string().contains("no convergence"));
        let error = run(|_: &Design| Err::<Vec<f64>, _>("no convergence")).unwrap_err();
        assert!(matches!(error, StudyError::Nominal { .. }));
        let error = run(|_: &Design| Ok::<_, String>(vec![1.0])).unwrap_err();
        assert!(error.to_string().contains("1 values instead of 2"));
    }

    #[test]
    fn a_design_without_assumptions_too_few_samples_and_a_cancelled_run_are_refused() {
        let settings = UncertaintySettings::default();
        let quiet = Progress::quiet();
        let error = propagate(&imposed::design(""), &outputs(), settings, &quiet, quadratic).unwrap_err();
        assert_eq!(error, StudyError::NothingAssumed);
        let few = UncertaintySettings {
            samples: 5,
            ..settings
        };
        let error = propagate(&assumed(), &outputs(), few, &quiet, quadratic).unwrap_err();
        assert_eq!(error, StudyError::TooFewSamples { asked: 5, fewest: 16 });
        let interrupted = |_: &Design| -> Result<Vec<f64>, String> {
            quiet.cancel();
            Err("interrupted".to_string())
        };
        let error = propagate(&assumed(), &outputs(), settings, &quiet, interrupted).unwrap_err();
        assert!(matches!(error, StudyError::Cancelled(_)));
        let error = propagate(&assumed(), &outputs(), settings, &quiet, quadratic).unwrap_err();
        assert!(matches!(error, StudyError::Cancelled(_)));
    }
}
