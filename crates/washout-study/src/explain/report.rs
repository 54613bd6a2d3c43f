//! What an explanation says, for people and programs.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::{Bound, Channel};

/// What it would take.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Explanation {
    /// The answer in plain words.
    pub sentence: String,
    /// Fitted numbers.
    pub numbers: usize,
    /// Distance within which every reading counts as reached, in its standard deviations.
    pub reach_sigma: f64,
    /// What was tried.
    pub tried: Tried,
    /// Mean square of measured minus modelled in units of σ, of all numbers fitted or held out: as stated, and with the first set.
    pub chi_square_per_number: [f64; 2],
    /// The sets: those that reach first; of those whose costs are alike the one of fewest changes first, else the least costly.
    pub sets: Vec<ExplainedSet>,
    /// What can be said with all standard deviations doubled.
    pub at_twice_sigma: String,
    /// What must be kept in mind.
    pub notes: Vec<String>,
}

/// What was tried.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Tried {
    /// Families of effects that the readings can see.
    pub families: usize,
    /// Strengths of effects, each place and wing counted.
    pub strengths: usize,
    /// Numbers of designs and ruler.
    pub inputs: usize,
    /// Words and alternatives, by name.
    pub alternatives: Vec<String>,
    /// Sets that were weighed by adding up.
    pub weighed: usize,
    /// Sets that were solved in the full model.
    pub solved: usize,
    /// Sets of which the full model has no solution.
    pub unsolved: usize,
}

/// Whether a set explains the readings.
#[derive(Debug, Clone, Copy, PartialEq, Eq, PartialOrd, Ord, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum Status {
    /// Every fitted reading is reached, and no number that was held out contradicts it.
    Reaches,
    /// Every fitted reading is reached, and a number that was held out contradicts it.
    Refuted,
    /// Some fitted reading is not reached.
    FallsShort,
}

/// A set of changes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ExplainedSet {
    /// Its changes in words; "nothing" where there is none.
    pub name: String,
    /// Whether it explains the readings.
    pub status: Status,
    /// −2 ln of its plausibility: fit, values and prices.
    pub cost: f64,
    /// The part of the fit.
    pub fit: f64,
    /// The part of the values.
    pub values: f64,
    /// The part that it takes to say which changes these are.
    pub price: f64,
    /// Sum of squares of the misfits of the fitted readings, in units of σ.
    pub chi_square: f64,
    /// Fitted readings within one standard deviation.
    pub within_one_sigma: usize,
    /// The largest misfit of a fitted reading, in its standard deviations.
    pub worst_sigma: f64,
    /// Its probability among all sets that were solved; none where the standard deviations are assumed.
    pub probability: Option<f64>,
    /// Its place in the order with all standard deviations doubled, from 1; none if it is not minimal then.
    pub rank_at_twice_sigma: Option<usize>,
    /// Words and alternatives that are otherwise.
    pub otherwise: Vec<Otherwise>,
    /// Numbers that change.
    pub changes: Vec<ChangeMade>,
    /// What it says of every reading.
    pub readings: Vec<ReadingOfSet>,
    /// What it says of readings that were not taken.
    pub forecasts: Vec<Forecast>,
    /// The cheapest readings that would refute it.
    pub refute: Vec<Refuting>,
    /// For each case, how to run it again by hand.
    pub by_hand: Vec<String>,
}

/// A word or an alternative that is otherwise.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Otherwise {
    /// Its name.
    pub name: String,
    /// Its probability before the readings.
    pub probability: f64,
    /// Why it may be so.
    pub why: String,
}

/// A number that changes.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ChangeMade {
    /// The effect, or the key of the number.
    pub name: String,
    /// The unknown of the study.
    pub unknown: String,
    /// Whether it is the strength of an effect.
    pub is_effect: bool,
    /// The wings that it concerns, if not all.
    pub wings: Vec<String>,
    /// Other numbers with which an effect acts there: where it sits, and which spar.
    pub numbers: BTreeMap<String, f64>,
    /// Its value.
    pub value: f64,
    /// Its value as the model stands.
    pub stated: f64,
    /// Its unit; `1` for pure numbers.
    pub unit: String,
    /// Values that are plausible.
    pub range: [f64; 2],
    /// How far it is from its stated value to the end of its range: 0 to 1.
    pub into_range: f64,
    /// What its value costs.
    pub cost: f64,
    /// What it takes to say that it is this one.
    pub price: f64,
}

/// What a set says of a reading.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ReadingOfSet {
    /// Case of the study.
    pub case: String,
    /// What was measured.
    pub channel: Channel,
    /// Station or inner end of the interval, mm.
    pub r_mm: Option<f64>,
    /// Outer end of the interval, mm.
    pub r_to_mm: Option<f64>,
    /// Measured value.
    pub measured: f64,
    /// Its standard deviation.
    pub sigma: f64,
    /// Whether it is a bound.
    pub bound: Bound,
    /// Whether it was kept out of the fit.
    pub is_held_out: bool,
    /// The model as stated, in the choice of words of the set.
    pub stated: f64,
    /// The model with the set.
    pub with_set: f64,
    /// Measured minus modelled with the set, in standard deviations; 0 where a bound is kept.
    pub misfit_sigma: f64,
}

/// What a set says of a reading that was not taken.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Forecast {
    /// The wing in its condition, or the experiment.
    pub condition: String,
    /// What would be measured.
    pub channel: Channel,
    /// Station or inner end of an interval, mm.
    pub r_mm: Option<f64>,
    /// Standard deviation that such a reading would have.
    pub sigma: f64,
    /// What the model says as stated; none where it has no solution.
    pub stated: Option<f64>,
    /// What the set says; none where the model has no solution with it.
    pub with_set: Option<f64>,
}

/// A reading that would refute a set.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Refuting {
    /// The wing in its condition, or the experiment.
    pub condition: String,
    /// What would be measured.
    pub channel: Channel,
    /// Station, mm.
    pub r_mm: Option<f64>,
    /// What the set says.
    pub with_set: f64,
    /// Standard deviation that is assumed of the reading.
    pub sigma: f64,
    /// How many of the other sets say otherwise by 3 σ or more.
    pub against: usize,
    /// How many other sets there are.
    pub others: usize,
    /// Distance from the median of the others, in standard deviations.
    pub apart_sigma: f64,
}
