//! Twist in degrees along the span, measured minus modelled.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::input::measurement::{Bound, Channel, Row, SigmaKind};
use crate::observation::{Place, TwistProfile};

use super::integrated::{IntegratedRates, weaker};
use super::row::{ComparedRow, misfit};

/// Twist in degrees along the span for one run of the measurement.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct SpanComparison {
    /// Name of the run; may be empty.
    pub run: String,
    /// Where the measured degrees come from.
    pub origin: ProfileOrigin,
    /// The stations, r rising.
    pub stations: Vec<ComparedStation>,
    /// Root mean square misfit over the stations.
    pub rmse_deg: f64,
    /// Root mean square misfit over the length from the base to the last station, straight between stations, none at
    /// the base: a pair of close stations does not count double.
    pub rmse_along_span_deg: f64,
    /// Root mean square misfit in standard deviations of the measurement, over the stations.
    pub rms_sigma: f64,
    /// Station with the largest misfit in degrees.
    pub worst_r_mm: f64,
    /// What limits the comparison, if anything does.
    pub limits: Vec<String>,
}

/// Where measured degrees come from.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "snake_case")]
pub enum ProfileOrigin {
    /// Twists as measured, at their own stations.
    Twists,
    /// Measured rates integrated from 0 deg at the base, at the stations of the model.
    IntegratedRates,
}

/// Measured and modelled twist at one station.
#[derive(Debug, Clone, Copy, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ComparedStation {
    /// What stands there, for a station of the model.
    pub place: Option<Place>,
    /// Distance from the wing base.
    pub r_mm: f64,
    /// Measured twist.
    pub measured_deg: f64,
    /// Its standard deviation; propagated from rates as if their errors were independent.
    pub sigma_deg: f64,
    /// Where it comes from; the weakest kind that went in.
    pub sigma_kind: SigmaKind,
    /// Whether the measured twist is only a bound.
    pub bound: Bound,
    /// Modelled twist.
    pub modelled_deg: f64,
    /// Whether the modelled twist is only a bound.
    pub modelled_bound: Bound,
    /// Measured minus modelled.
    pub error_deg: f64,
    /// The part of the error that no bound allows.
    pub misfit_deg: f64,
    /// That part in standard deviations.
    pub misfit_sigma: f64,
}

impl SpanComparison {
    /// The weakest kind of standard deviation of its stations.
    pub fn sigma_kind(&self) -> SigmaKind {
        self.stations
            .iter()
            .map(|station| station.sigma_kind)
            .fold(SigmaKind::Repeats, weaker)
    }

    /// The outermost station.
    pub fn outermost(&self) -> Option<&ComparedStation> {
        self.stations.last()
    }

    /// From the compared twists of one run.
    pub fn of_twists(run: &str, rows: &[&ComparedRow]) -> Option<SpanComparison> {
        let twists = rows.iter().filter(|row| row.channel == Channel::Twist);
        let stations = twists.filter_map(|row| {
            Some(ComparedStation {
                place: None,
                r_mm: row.r_mm?,
                measured_deg: row.measured,
                sigma_deg: row.sigma,
                sigma_kind: row.sigma_kind,
                bound: row.bound,
                modelled_deg: row.modelled,
                modelled_bound: row.modelled_bound,
                error_deg: row.error,
                misfit_deg: row.misfit,
                misfit_sigma: row.misfit_sigma,
            })
        });
        SpanComparison::new(run, ProfileOrigin::Twists, stations.collect(), Vec::new())
    }

    /// From the measured rates of one run, at the stations of the modelled profile outboard of the base.
    pub fn of_rates(run: &str, rows: &[&Row], profile: &TwistProfile) -> Option<SpanComparison> {
        let measured = IntegratedRates::new(rows)?;
        let mut limits: Vec<String> = measured.stopped.iter().cloned().collect();
        let mut stations = Vec::new();
        for reading in profile
            .readings
            .iter()
            .filter(|reading| reading.place != Place::Base)
        {
            let r_mm = reading.r_m * 1e3;
            let Some(twist) = measured.twist_at(r_mm) else {
                limits.push(format!("no measured twist at {r_mm:.1} mm"));
                continue;
            };
            let modelled_deg = reading.twist_rad.to_degrees();
            let error_deg = twist.twist_deg - modelled_deg;
            let misfit_deg = misfit(error_deg, twist.bound, reading.bound);
            stations.push(ComparedStation {
                place: Some(reading.place),
                r_mm,
                measured_deg: twist.twist_deg,
                sigma_deg: twist.sigma_deg,
                sigma_kind: twist.sigma_kind,
                bound: twist.bound,
                modelled_deg,
                modelled_bound: reading.bound,
                error_deg,
                misfit_deg,
                misfit_sigma: misfit_deg / twist.sigma_deg,
            });
        }
        SpanComparison::new(run, ProfileOrigin::IntegratedRates, stations, limits)
    }

    fn new(
        run: &str,
        origin: ProfileOrigin,
        mut stations: Vec<ComparedStation>,
        limits: Vec<String>,
    ) -> Option<SpanComparison> {
        stations.sort_by(|a, b| a.r_mm.total_cmp(&b.r_mm));
        let size = |station: &ComparedStation| station.misfit_deg.abs();
        let worst_r_mm = stations.iter().max_by(|a, b| size(a).total_cmp(&size(b)))?.r_mm;
        let root_mean_square = |part: fn(&ComparedStation) -> f64| {
            (stations.iter().map(|station| part(station).powi(2)).sum::<f64>() / stations.len() as f64).sqrt()
        };
        Some(SpanComparison {
            run: run.to_string(),
            origin,
            rmse_deg: root_mean_square(|station| station.misfit_deg),
            rmse_along_span_deg: rms_along_span(&stations),
            rms_sigma: root_mean_square(|station| station.misfit_sigma),
            worst_r_mm,
            limits,
            stations,
        })
    }
}

/// Root mean square over the length from the base to the last station, straight between stations, 0 at the base.
fn rms_along_span(stations: &[ComparedStation]) -> f64 {
    let mut before = [0.0, 0.0];
    let mut integral = 0.0;
    for station in stations {
        let [r, misfit] = [station.r_mm, station.misfit_deg];
        integral += (r - before[0]) * (misfit * misfit + misfit * before[1] + before[1] * before[1]) / 3.0;
        before = [r, misfit];
    }
    if before[0] > 0.0 {
        (integral / before[0]).sqrt()
    } else {
        before[1].abs()
    }
}
