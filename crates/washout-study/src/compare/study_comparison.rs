//! What a study against its measurements gives.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::{Bound, Channel};
use crate::input::study::CaseNumber;
use crate::study::Unknown;

/// A study compared with its measurements.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StudyComparison {
    /// Name of the study.
    pub study: String,
    /// Its title.
    pub title: String,
    /// The cases.
    pub cases: Vec<StudyCase>,
    /// Every measured number beside the model before and after calibration.
    pub rows: Vec<StudyRow>,
    /// Misfit by wing and channel, fitted and held-out apart.
    pub groups: Vec<GroupMisfit>,
    /// What was moved; empty if nothing is uncertain.
    pub unknowns: Vec<CalibratedUnknown>,
    /// Pairs of unknowns that stand for each other.
    pub correlations: Vec<Correlation>,
    /// Misfit of the fitted rows as χ² over their number, before and after.
    pub chi_square_per_row: [f64; 2],
    /// Measured rows that took no part, and why.
    pub not_compared: Vec<String>,
    /// The result in words.
    pub words: Vec<String>,
}

/// A case of a study.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StudyCase {
    /// Its name.
    pub name: String,
    /// Name of its wing.
    pub wing: String,
    /// The form of its family, such as `bending-{mass}`; its name, if it stands alone.
    pub family: String,
    /// The numbers in which it differs from others of its family.
    pub numbers: Vec<CaseNumber>,
    /// Whether it was kept out of the fit.
    pub is_held_out: bool,
}

/// A measured number beside the model.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct StudyRow {
    /// Name of the case.
    pub case: String,
    /// Name of the wing.
    pub wing: String,
    /// Line of the measurement file.
    pub line: usize,
    /// Channel.
    pub channel: Channel,
    /// Run; may be empty.
    pub run: String,
    /// Station, or inner end of the interval, mm.
    pub r_mm: Option<f64>,
    /// Outer end of the interval, mm.
    pub r_to_mm: Option<f64>,
    /// Chord fraction behind the leading edge at which a displacement is read.
    pub chord_fraction: Option<f64>,
    /// Measured value in the unit of the channel.
    pub measured: f64,
    /// Its standard deviation.
    pub sigma: f64,
    /// Whether it is only a bound.
    pub bound: Bound,
    /// The model with the study's means.
    pub before: f64,
    /// Standard deviation that the priors of the uncertain inputs give it.
    pub sigma_of_inputs: f64,
    /// The model as calibrated.
    pub after: f64,
    /// The model as calibrated to all other cases, linear about the calibration to all; none for what is held out, for bounds that
    /// are kept, and where only one case is fitted.
    pub left_out: Option<f64>,
    /// Whether it was kept out of the fit.
    pub is_held_out: bool,
}

/// Misfit of a group of rows.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct GroupMisfit {
    /// Name of the wing.
    pub wing: String,
    /// Channel.
    pub channel: Channel,
    /// Unit of all errors.
    pub unit: String,
    /// Whether its rows were kept out of the fit.
    pub is_held_out: bool,
    /// Number of rows.
    pub count: usize,
    /// Root mean square error before and after calibration.
    pub rmse: [f64; 2],
    /// The same with each case predicted by the model as calibrated to all others; none where no row has such a prediction.
    pub left_out: Option<f64>,
    /// Mean square error over its variance (sigma of the measurement, and the error that the study admits to the model)
    /// before and after: unlike the root mean square it counts each number by what it is worth.
    pub chi_square_per_row: [f64; 2],
    /// Mean error (measured minus modelled) before and after.
    pub bias: [f64; 2],
    /// Root mean square standard deviation of the measurement.
    pub sigma_of_measurement: f64,
    /// Root mean square standard deviation of the model that the priors of inputs and ruler give.
    pub sigma_of_inputs: f64,
    /// Share of the mean square error before calibration that both together would give on average (ASME V&V 20: |E| against
    /// its uncertainty); 1 and more means that nothing else is needed, none that there is no error: bounds that are kept.
    pub explained: Option<f64>,
}

/// An unknown after calibration.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct CalibratedUnknown {
    /// The unknown with its prior.
    pub unknown: Unknown,
    /// Best value.
    pub value: f64,
    /// Its standard error.
    pub standard_error: f64,
    /// (value − mean)/sigma of the prior.
    pub pull: f64,
    /// Whether the data know it better than the prior; those that are not stay near their prior.
    pub is_identified: bool,
    /// Whether it ended at an end of its range.
    pub at_end: bool,
}

/// Prior standard deviations by which what is calibrated may move before it must be told.
const FAR: f64 = 2.0;

impl CalibratedUnknown {
    /// Whether calibration has moved it farther than its prior lets expect.
    pub fn has_moved_far(&self) -> bool {
        self.pull.abs() > FAR
    }

    /// Whether it stands where its prior has it, and these data say little of it.
    pub fn is_at_its_prior(&self) -> bool {
        !self.is_identified && !self.has_moved_far()
    }
}

/// Two unknowns that the data cannot move apart.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Correlation {
    /// One.
    pub a: String,
    /// The other.
    pub b: String,
    /// Correlation of their errors.
    pub value: f64,
}
