//! What a diagnosis says, for people and programs.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::Channel;
use crate::study::Work;

use super::added_variable::AddedVariable;
use super::ladder::LadderStep;
use super::misfit::Misfit;
use super::next::NextExperiment;
use super::novel::Reconstruction;
use super::screening::Sight;

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

/// What may be the case.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Hypothesis {
    /// Effects that are missing: none (nothing is), one, two; `novel` for an unknown cause.
    pub effects: Vec<String>,
    /// Their families.
    pub families: Vec<String>,
    /// Strengths, with the unknowns that they are values of: two of one family mean a place between them.
    pub strengths: Vec<Strength>,
    /// Its probability.
    pub probability: f64,
    /// Strength of the first effect.
    pub strength: Option<f64>,
    /// Its standard error.
    pub standard_error: Option<f64>,
    /// Whether the plausible range of every strength lies within two standard errors of it.
    pub plausible: bool,
    /// Whether it belongs to the smallest set that holds the truth with 95 %.
    pub in_set: bool,
    /// Whether the strengths are those of a fit in the whole model.
    pub refitted: bool,
    /// Gain in predicting left-out conditions, in ln of the density; a necessary sign, not a ranking.
    pub gain_left_out_conditions: Option<f64>,
    /// The same for left-out wings.
    pub gain_left_out_wings: Option<f64>,
}

/// Strength of one effect.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Strength {
    /// The effect.
    pub effect: String,
    /// Its family.
    pub family: String,
    /// The unknown.
    pub unknown: String,
    /// Its value.
    pub value: f64,
    /// Whether that is an end of what is accepted, and the data ask for no less; never of what is all or none.
    pub at_end: bool,
    /// Its standard error; 0 of what is all or none, or was tried in steps alone.
    pub standard_error: f64,
    /// Its unit.
    pub unit: String,
    /// Where it sits, if that was not known.
    pub place: Option<PlaceFound>,
}

/// Where an effect sits.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct PlaceFound {
    /// The parameter of the effect that it is a value of.
    pub parameter: String,
    /// Its value.
    pub value: f64,
    /// The same from the wing base, mm, where it is a fraction of the length of a rod.
    #[serde(default)]
    pub at_mm: Option<f64>,
    /// Its standard error; none if it was not fitted.
    pub standard_error: Option<f64>,
    /// Unit of both; `1` if they have none.
    pub unit: String,
    /// Other numbers that the effect needs, such as which spar.
    pub numbers: BTreeMap<String, f64>,
    /// The wing on which it sits, by the name of its design; none if on all.
    pub wing: Option<String>,
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

/// One effect that the model lacks.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct EffectRow {
    /// The effect.
    pub effect: String,
    /// Its family.
    pub family: String,
    /// The unknown that is its strength.
    pub unknown: String,
    /// Unit of the strength.
    pub unit: String,
    /// Size of strength that is plausible.
    pub scale: f64,
    /// Score: distance from none in standard deviations, what the model can absorb left out.
    pub score: f64,
    /// Strength by one linear step; none where the readings do not feel it.
    pub one_step: Option<f64>,
    /// Its standard error.
    pub one_step_error: Option<f64>,
    /// Strength by a nonlinear fit.
    pub refitted: Option<f64>,
    /// Its standard error.
    pub refitted_error: Option<f64>,
    /// Where it sits, if that was not known: the row is that of its best place.
    pub place: Option<PlaceFound>,
    /// Whether its plausible range lies within two standard errors of that strength (by one step, if not refitted).
    pub plausible: bool,
    /// Strengths that are plausible in nature, in its unit.
    pub plausible_range: [f64; 2],
    /// Distance from none, in standard deviations, that its plausible size has.
    pub detectability: f64,
    /// Probability to see it at its plausible size.
    pub power: f64,
    /// What one glance tells.
    pub sight: Sight,
    /// Logarithm of its evidence against nothing missing.
    pub ln_evidence: f64,
    /// Probability that it alone is what is missing.
    pub probability: f64,
    /// Logarithm of the density that all other cases give to each, with it fitted over without, summed; by the linear model where it
    /// was not refitted; none where only one case is fitted.
    pub gain_left_out_conditions: Option<f64>,
    /// Root mean square error of what is held out (in stated standard deviations), calibrated without it over refitted with it: above
    /// one if it predicts better; none where nothing is held out, all of it is met, or it was not refitted.
    pub held_out_gain: Option<f64>,
    /// Other families that look like it, nearest first.
    pub look_alikes: Vec<LookAlike>,
}

/// An effect that looks like another.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct LookAlike {
    /// The other effect.
    pub effect: String,
    /// Cosine of the angle between their signatures, what the model can absorb left out.
    pub cosine: f64,
    /// Distance in standard deviations at the strength found.
    pub separation_sigma: f64,
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
