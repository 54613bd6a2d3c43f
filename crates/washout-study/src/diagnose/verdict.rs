//! What a diagnosis says, for people and programs.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::Channel;
use crate::study::Work;

use super::added_variable::AddedVariable;
use super::effect_row::{EffectRow, LookAlike};
use super::hypothesis::Hypothesis;
use super::ladder::LadderStep;
use super::misfit::Misfit;
use super::next::NextExperiment;
use super::novel::Reconstruction;

/// The kind of answer.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Verdict {
    /// Nothing detectable is missing.
    Nothing,
    /// One effect is missing and may be named.
    Effect,
    /// One of several effects is missing.
    Set,
    /// Something is missing that no known effect is.
    Novel,
    /// This campaign cannot tell.
    Undecidable,
}

/// The result of a diagnosis.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Diagnosis {
    /// The answer in one plain sentence.
    pub sentence: String,
    /// The case that misses by far more than all others, to be checked before all else; none if there is none.
    #[serde(default)]
    pub check_first: Option<String>,
    /// Its kind.
    pub verdict: Verdict,
    /// Probability that nothing is missing.
    pub p_nothing: f64,
    /// Effects that were tried.
    pub tried: usize,
    /// Scatter that the data show, and error of the model.
    pub noise: NoiseFound,
    /// What may be the case, most probable first; the tail below one in a thousand is left out.
    pub hypotheses: Vec<Hypothesis>,
    /// An unknown cause.
    pub novel: Novel,
    /// Every effect that the model lacks.
    pub effects: Vec<EffectRow>,
    /// Effects that this campaign could not have seen at their plausible size.
    pub unseen: Vec<String>,
    /// Where the model fails.
    pub misfit: Misfit,
    /// The best explanations against the residual.
    pub added_variables: Vec<AddedVariable>,
    /// The error from the model as it is to the noise.
    pub ladder: Vec<LadderStep>,
    /// What the best known explanation, or a cause without a name where that is the verdict, predicts for the held-out observables.
    pub predictions: Vec<Prediction>,
    /// What to measure next; none if that is not known, or the answer needs nothing more.
    pub next_experiment: Option<NextExperiment>,
    /// What a reader must know besides.
    pub notes: Vec<String>,
    /// What the derivatives with every effect took, one factorization for each condition.
    pub screening: Work,
}

/// Scatter that the data show.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NoiseFound {
    /// Measured numbers that were fitted.
    pub numbers: usize,
    /// Factor on the stated standard deviations.
    pub scale: f64,
    /// Share of its own predictions by which the model is off in its formulation.
    pub formulation: f64,
    /// Whether the stated noise is taken on trust, for want of numbers.
    pub on_trust: bool,
    /// Numbers that are far from what all the others tell, with the factor by which their error was widened.
    pub outliers: Vec<Outlier>,
}

/// A number that is far from what all the others tell.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Outlier {
    /// Name of its condition.
    pub condition: String,
    /// Line of the measurement file.
    pub line: usize,
    /// Factor on its standard deviation.
    pub widening: f64,
}

/// An unknown cause.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Novel {
    /// Probability.
    pub probability: f64,
    /// The missing load, compliance or error of reading (`law`, `field`, … beside the probability); none if nothing is
    /// missing.
    #[serde(flatten)]
    pub reconstruction: Option<Reconstruction>,
    /// Known effects whose signature is nearest, with the cosine.
    pub nearest: Vec<LookAlike>,
    /// A formula to start an effect of one's own from; none if nothing is missing.
    pub draft: Option<Draft>,
}

/// A formula to start an effect of one's own from.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Draft {
    /// Formula over x = r/R, f (Hz), Phi (rad) and twist (rad): a moment per length, N·m/m; for a compliance, the factor of the
    /// rods' torsional stiffness; for an error of the reading, that error.
    pub expression: String,
    /// What it stands for.
    pub what: String,
    /// The same as a table `[effects.missing]` for a design or for `washout add missing --own`; none for an error of the
    /// reading, which is no effect.
    pub effect: Option<String>,
}

/// A prediction for a held-out observable.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Prediction {
    /// Name of its condition.
    pub condition: String,
    /// Line of the measurement file.
    pub line: usize,
    /// Channel.
    pub channel: Channel,
    /// Unit of all values.
    pub unit: String,
    /// Station, or inner end of the interval, mm.
    pub r_mm: Option<f64>,
    /// Outer end of the interval, mm.
    pub r_to_mm: Option<f64>,
    /// Measured value.
    pub measured: f64,
    /// By the model as it is, calibrated.
    pub calibrated: f64,
    /// By the model with the best known explanation, or with the cause without a name that was fitted, where that is the verdict.
    pub explained: f64,
    /// Standard deviation of the latter, noise of the measurement left out.
    pub standard_deviation: f64,
}
