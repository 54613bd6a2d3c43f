//! One measured number against what the model gives for it.

use std::collections::BTreeMap;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::design::Instrument;
use crate::input::measurement::{Bound, Channel, Row, SigmaKind};
use crate::observation::{Observer, TwistProfile, read_channel};

/// A measured number and the modelled one, both in the unit of the channel.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ComparedRow {
    /// Line of the measurement file.
    pub line: usize,
    /// Name of the run; may be empty.
    pub run: String,
    /// What was measured.
    pub channel: Channel,
    /// Unit of all values of this row; `1` for ratios.
    pub unit: String,
    /// Instrument that measured a twist.
    pub instrument: Option<Instrument>,
    /// Station, or inner end of the interval.
    pub r_mm: Option<f64>,
    /// Outer end of the interval.
    pub r_to_mm: Option<f64>,
    /// Chord fraction behind the leading edge at which a displacement is read.
    #[serde(default, skip_serializing_if = "Option::is_none")]
    pub chord_fraction: Option<f64>,
    /// Where the model could be read last, if that is short of the outer end.
    pub read_to_mm: Option<f64>,
    /// Measured value.
    pub measured: f64,
    /// Its standard deviation.
    pub sigma: f64,
    /// Where the standard deviation comes from.
    pub sigma_kind: SigmaKind,
    /// Whether the measured value is only a bound.
    pub bound: Bound,
    /// Modelled value.
    pub modelled: f64,
    /// Whether the modelled value is only a bound, as a camera reads a feathered section.
    pub modelled_bound: Bound,
    /// Measured minus modelled.
    pub error: f64,
    /// The part of the error that no bound allows.
    pub misfit: f64,
    /// That part in standard deviations of the measurement.
    pub misfit_sigma: f64,
}

/// A measured number that was not compared.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct NotCompared {
    /// Line of the measurement file.
    pub line: usize,
    /// What was measured.
    pub channel: Channel,
    /// Station, or inner end of the interval.
    pub r_mm: Option<f64>,
    /// Why it was not compared.
    pub reason: String,
}

/// Compares one row; `whole_wing` holds the modelled channels of the whole wing in their units.
pub fn compare_row(
    row: &Row,
    observer: &Observer,
    profile: &TwistProfile,
    whole_wing: &BTreeMap<Channel, f64>,
) -> Result<ComparedRow, NotCompared> {
    let modelled = read_channel(row, observer, profile, whole_wing);
    let modelled = modelled.map_err(|reason| NotCompared {
        line: row.line,
        channel: row.channel,
        r_mm: row.r_mm,
        reason,
    })?;
    let error = row.value - modelled.value;
    let misfit = misfit(error, row.bound, modelled.bound);
    Ok(ComparedRow {
        line: row.line,
        run: row.run.clone(),
        channel: row.channel,
        unit: row.channel.unit().to_string(),
        instrument: row.instrument,
        r_mm: row.r_mm,
        r_to_mm: row.r_to_mm,
        chord_fraction: row.chord_fraction,
        read_to_mm: modelled.read_to_mm,
        measured: row.value,
        sigma: row.sigma,
        sigma_kind: row.sigma_kind,
        bound: row.bound,
        modelled: modelled.value,
        modelled_bound: modelled.bound,
        error,
        misfit,
        misfit_sigma: misfit / row.sigma,
    })
}

/// The part of `error` = measured − modelled that stays when either value may lie anywhere beyond its bound.
///
/// If the wing does at most the measured value, or the model at least the modelled one, then the true error is at
/// most `error`, and only a negative one is a misfit; and the other way round.
///
/// # Example
/// ```
/// # use washout_study as washout;
/// use washout::{compare::row::misfit, input::measurement::Bound};
///
/// // measured "at most 5", modelled 3: no misfit
/// assert_eq!(misfit(5.0 - 3.0, Bound::Upper, Bound::None), 0.0);
/// ```
pub fn misfit(error: f64, measured: Bound, modelled: Bound) -> f64 {
    let is_at_most = measured == Bound::Upper || modelled == Bound::Lower;
    let is_at_least = measured == Bound::Lower || modelled == Bound::Upper;
    match (is_at_most, is_at_least) {
        (false, false) => error,
        (true, false) => error.min(0.0),
        (false, true) => error.max(0.0),
        (true, true) => 0.0,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_bound_counts_only_beyond_itself() {
        for (error, measured, modelled, expected) in [
            (2.0, Bound::None, Bound::None, 2.0),
            (2.0, Bound::Upper, Bound::None, 0.0),
            (-2.0, Bound::Upper, Bound::None, -2.0),
            (2.0, Bound::Lower, Bound::None, 2.0),
            (-2.0, Bound::Lower, Bound::None, 0.0),
            (2.0, Bound::None, Bound::Lower, 0.0),
            (-2.0, Bound::None, Bound::Lower, -2.0),
            (2.0, Bound::None, Bound::Upper, 2.0),
            (-2.0, Bound::Lower, Bound::Lower, 0.0),
        ] {
            assert_eq!(
                misfit(error, measured, modelled),
                expected,
                "{error} {measured:?} {modelled:?}"
            );
        }
    }
}
