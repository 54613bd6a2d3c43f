//! What a fit needs of a model: its unknowns, its observables, its predictions and how they answer to the unknowns.

use std::any::Any;
use std::collections::BTreeMap;
use std::fmt;
use std::sync::Arc;

use nalgebra::{DMatrix, DVector};
use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::coupling::Care;
use crate::input::measurement::{Bound, Channel};
use crate::structure::{larger, smaller};

use super::error::StudyError;
use super::work::Work;

/// Step from zero by which an effect with a switch is seen, over its scale.
const SWITCH_STEP: f64 = 0.05;

/// What a study may move.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Unknown {
    /// Its name: the dotted key of an input or of an effect's strength, or a nuisance of the ruler.
    pub name: String,
    /// Unit of its values; `1` for pure numbers.
    pub unit: String,
    /// What it is.
    pub kind: UnknownKind,
    /// Mean of its prior, where it starts; 0 for the strength of an effect that the model lacks.
    pub mean: f64,
    /// Standard deviation of its prior.
    pub sigma: f64,
    /// Values that it may take.
    pub range: [f64; 2],
}

impl Unknown {
    /// How well the change that it makes is known, as a share of that change: of the formula of an effect; 0 for the others.
    pub fn own_error(&self) -> f64 {
        match self.kind {
            UnknownKind::Effect { own_error, .. } => own_error,
            _ => 0.0,
        }
    }

    /// Step by which an effect with a switch is seen from zero, if `value` is that; none for the others.
    pub(super) fn switch_step(&self, value: f64) -> Option<f64> {
        match &self.kind {
            UnknownKind::Effect {
                has_switch: true,
                scale,
                ..
            } if value == 0.0 => Some(SWITCH_STEP * scale),
            _ => None,
        }
    }
}

/// What an unknown is.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum UnknownKind {
    /// An input of the design.
    Input,
    /// A nuisance of the ruler: it moves the reading, not the wing.
    Ruler,
    /// A number of a cause without a name: off, unless a fit tries it.
    Unnamed {
        /// Name of the cause.
        cause: String,
    },
    /// Where an effect sits; it counts while that effect has a strength.
    Place {
        /// Name of the unknown that is the strength.
        of: String,
        /// The effect's parameter.
        parameter: String,
        /// Other numbers with which it acts there, such as which spar.
        numbers: BTreeMap<String, f64>,
        /// The wing on which it acts; all where none is named.
        wing: Option<String>,
        /// Length of the rod that it is a fraction of, mm; none if it is no such fraction, or the wings have several lengths.
        rod_mm: Option<f64>,
    },
    /// The strength of an effect.
    Effect {
        /// Name of the effect.
        effect: String,
        /// Effects that are the same physics at another place, or another formula of it, share their family.
        family: String,
        /// Size of strength that is plausible: one standard deviation of what is thought possible.
        scale: f64,
        /// Strengths that are plausible in nature.
        plausible: [f64; 2],
        /// Whether only strengths of one sign make sense.
        one_sided: bool,
        /// Whether its response has a kink at zero, so that it must be seen from a step.
        has_switch: bool,
        /// Whether it is there with its plausible size or not at all: no strength between is of this world.
        all_or_none: bool,
        /// How well the change that it makes is known, as a share of that change.
        own_error: f64,
    },
}

/// One measured number.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Observable {
    /// Index of its condition.
    pub condition: usize,
    /// Line of the measurement file.
    pub line: usize,
    /// What was measured.
    pub channel: Channel,
    /// Run of the measurement; may be empty.
    pub run: String,
    /// Station or inner end of the interval, mm.
    pub r_mm: Option<f64>,
    /// Outer end of the interval, mm.
    pub r_to_mm: Option<f64>,
    /// Measured value in the unit of the channel.
    pub value: f64,
    /// Its standard deviation.
    pub sigma: f64,
    /// Whether it is only a bound.
    pub bound: Bound,
}

impl Observable {
    /// Measured minus modelled: nothing where it is a bound that the model keeps.
    pub fn misfit(&self, modelled: f64) -> f64 {
        let error = self.value - modelled;
        match self.bound {
            Bound::None => error,
            Bound::Upper => smaller(error, 0.0),
            Bound::Lower => larger(error, 0.0),
        }
    }
}

/// One design at one operating point or under one bench load.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Condition {
    /// Name of the case in the study.
    pub name: String,
    /// Cases of one wing share this: the name of the design.
    pub wing: String,
    /// Whether it is kept out of every fit.
    pub is_held_out: bool,
    /// Flapping frequency, Hz.
    pub frequency_hz: Option<f64>,
    /// Half-stroke amplitude, deg.
    pub half_amplitude_deg: Option<f64>,
    /// Dynamic pressure at the tip (or of the stream), Pa; 0 for bench loads.
    pub dynamic_pressure_pa: f64,
    /// Length of the wing, m.
    pub length_m: f64,
}

/// Predictions and their derivatives.
#[derive(Debug, Clone, PartialEq)]
pub struct Linear {
    /// Predicted value of every observable, in the unit of its channel.
    pub value: DVector<f64>,
    /// Derivative of each observable (row) with each unknown (column), in their units.
    pub jacobian: DMatrix<f64>,
}

impl Linear {
    /// What the derivatives predict at `to`, where the unknowns stood at `from`.
    #[must_use]
    pub fn moved(&self, to: &[f64], from: &[f64]) -> Linear {
        let step = DVector::from_iterator(to.len(), to.iter().zip(from).map(|(to, from)| to - from));
        Linear {
            value: &self.value + &self.jacobian * step,
            jacobian: self.jacobian.clone(),
        }
    }
}

/// What the mesh of a model leaves of its predictions.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize)]
pub struct MeshError {
    /// What a finer mesh adds to every prediction, where the unknowns start; predictions have it.
    pub correction: Vec<f64>,
    /// Standard deviation of what still remains.
    pub deviation: Vec<f64>,
}

/// What an answer of a model leaves for its next ones; only the model that left it can read it.
#[derive(Clone)]
pub struct WarmStart {
    kept: Arc<dyn Any + Send + Sync>,
    care: Care,
    /// By condition: whether it is asked; none: all are.
    asked: Option<Arc<[bool]>>,
}

impl WarmStart {
    /// Of what a model wants to keep.
    pub fn new<T: Any + Send + Sync>(kept: T) -> WarmStart {
        WarmStart {
            kept: Arc::new(kept),
            care: Care::Full,
            asked: None,
        }
    }

    /// The same, with how much is asked of answers from there. What they leave asks for all.
    #[must_use]
    pub fn with(&self, care: Care) -> WarmStart {
        WarmStart { care, ..self.clone() }
    }

    /// The same for trials: answers from there may give up where a solution is hard to find.
    #[must_use]
    pub fn for_trials(&self) -> WarmStart {
        self.with(Care::Trial)
    }

    /// The same for rough answers.
    #[must_use]
    pub fn roughly(&self) -> WarmStart {
        self.with(Care::Rough)
    }

    /// The same for rough answers between two that stand.
    #[must_use]
    pub fn roughly_between(&self) -> WarmStart {
        self.with(Care::RoughBetween)
    }

    /// The same for answers of these conditions alone, by position; a rough answer leaves the others as they are.
    #[must_use]
    pub fn of_conditions(&self, asked: &[bool]) -> WarmStart {
        WarmStart {
            asked: Some(asked.into()),
            ..self.clone()
        }
    }

    /// Whether a condition is asked.
    pub fn asks(&self, condition: usize) -> bool {
        self.asked.as_ref().is_none_or(|asked| asked[condition])
    }

    /// How much is asked of answers from there.
    pub fn care(&self) -> Care {
        self.care
    }

    /// What was kept, if it is of this type.
    pub fn get<T: Any>(&self) -> Option<&T> {
        self.kept.downcast_ref()
    }
}

impl fmt::Debug for WarmStart {
    fn fmt(&self, f: &mut fmt::Formatter<'_>) -> fmt::Result {
        f.write_str("WarmStart")
    }
}

/// A model with unknowns, seen through observables.
///
/// Vectors of unknowns are in the order of [`Forward::unknowns`] and in their units, predictions in the order of
/// [`Forward::observables`]. All methods are functions of their arguments alone: the same values give the same
/// bits, whatever was asked before and on any number of threads.
pub trait Forward: Sync {
    /// The unknowns.
    fn unknowns(&self) -> &[Unknown];

    /// The observables, held-out ones included.
    fn observables(&self) -> &[Observable];

    /// The conditions.
    fn conditions(&self) -> &[Condition];

    /// What the model gives for every observable.
    ///
    /// # Errors
    /// If a condition has no solution, with its name and the reason.
    fn predict(&self, at: &[f64]) -> Result<DVector<f64>, StudyError>;

    /// Predictions and their derivatives with the unknowns of which `wanted` holds; the other columns are zero.
    ///
    /// # Errors
    /// As [`Forward::predict`].
    fn linearize(&self, at: &[f64], wanted: &dyn Fn(&Unknown) -> bool) -> Result<Linear, StudyError>;

    /// As [`Forward::linearize`], from the warm start of an earlier answer, if there is one: the same but for the tolerance of
    /// the solves, and sooner. It leaves a warm start of its own.
    ///
    /// # Errors
    /// As [`Forward::predict`].
    fn linearize_from(
        &self,
        _warm_start: Option<&WarmStart>,
        at: &[f64],
        wanted: &dyn Fn(&Unknown) -> bool,
    ) -> Result<(Linear, Option<WarmStart>), StudyError> {
        Ok((self.linearize(at, wanted)?, None))
    }

    /// As [`Forward::moment_response`], from a warm start.
    ///
    /// # Errors
    /// As [`Forward::predict`].
    fn moment_response_from(
        &self,
        _warm_start: Option<&WarmStart>,
        at: &[f64],
        stations: usize,
    ) -> Result<DMatrix<f64>, StudyError> {
        self.moment_response(at, stations)
    }

    /// Response of every observable (row) to a moment per length about the span axis (N·m/m, positive: washout) in its
    /// own condition, spread as a hat function around each of `stations` places evenly spaced from base to tip
    /// (column).
    ///
    /// # Errors
    /// As [`Forward::predict`].
    fn moment_response(&self, at: &[f64], stations: usize) -> Result<DMatrix<f64>, StudyError>;

    /// What its mesh leaves, if that was looked at.
    fn mesh_error(&self) -> Option<&MeshError> {
        None
    }

    /// What was done so far, if that is counted.
    fn work(&self) -> Work {
        Work::default()
    }
}

/// A model's reading and condition, for tests.
#[cfg(test)]
pub(super) mod toy {
    use super::{Condition, Observable};
    use crate::input::measurement::{Bound, Channel};

    /// Twist, read at `line` mm of the one condition.
    pub fn reading(line: usize, value: f64, sigma: f64) -> Observable {
        Observable {
            condition: 0,
            line,
            channel: Channel::Twist,
            run: String::new(),
            r_mm: Some(line as f64),
            r_to_mm: None,
            value,
            sigma,
            bound: Bound::None,
        }
    }

    /// A wing of 1 m on the bench.
    pub fn condition() -> Condition {
        Condition {
            name: "c".into(),
            wing: "w".into(),
            is_held_out: false,
            frequency_hz: None,
            half_amplitude_deg: None,
            dynamic_pressure_pa: 0.0,
            length_m: 1.0,
        }
    }
}
