//! The solved shape as the page reads it.

use std::collections::BTreeMap;

use serde::Serialize;
use serde_json::Value;

use crate::compare::span::SpanComparison;
use crate::compare::{ComparedStation, Comparison, compare};
use crate::export::html::Wing;
use crate::export::html::measured::Measured;
use crate::export::html::stroke::Stroke;
use crate::input::measurement::{Bound, Channel, Measurement};
use crate::lift::LiftReport;
use crate::observation::TwistReading;
use crate::page::text::significant;
use crate::wing::SolvedWing;

use super::refusal::Refusal;

/// A curve along the span.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct Curve {
    /// What it is.
    #[serde(skip_serializing_if = "String::is_empty")]
    pub name: String,
    /// Places from the wing base, mm.
    pub r_mm: Vec<f64>,
    /// Twist there, deg, positive for washout.
    pub twist_deg: Vec<f64>,
}

/// Measured twist of one run.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MeasuredCurve {
    /// The run; may be empty.
    pub run: String,
    /// Places from the wing base, mm.
    pub r_mm: Vec<f64>,
    /// Twist there, deg.
    pub twist_deg: Vec<f64>,
    /// Its standard deviation, deg.
    pub sigma_deg: Vec<f64>,
    /// Whether it is only a bound.
    pub bound: Vec<Bound>,
}

/// A number of the whole wing.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Number {
    /// What programs call it.
    pub key: &'static str,
    /// What people call it, in a few words.
    pub label: String,
    /// What it is in full, where that is more.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub more: Option<String>,
    /// Its value.
    pub value: f64,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Its value as opened.
    #[serde(skip_serializing_if = "Option::is_none")]
    pub original: Option<f64>,
}

/// A measured number beside the model.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Residual {
    /// What was measured.
    pub quantity: &'static str,
    /// Its unit.
    pub unit: String,
    /// The run; may be empty.
    pub run: String,
    /// Where, mm from the base; none of the whole wing.
    pub r_mm: Option<f64>,
    /// As measured.
    pub measured: f64,
    /// As modelled.
    pub modelled: f64,
    /// Standard deviation of the measured value.
    pub sigma: f64,
    /// Measured less modelled, in that; nothing where a bound is kept.
    pub in_sigma: f64,
}

/// Whether the shape stands, in words.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Stability {
    /// Whether the wing stays in it.
    pub stable: bool,
    /// How far it is from where it would not.
    pub words: String,
}

/// What is read of a solved shape, all but the wing itself.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Read {
    /// Twist along the span, and what was measured.
    pub twist: Twist,
    /// Angle of attack along the span; none without flow.
    pub angle_of_attack: Option<Attack>,
    /// Numbers of the whole wing.
    pub numbers: Vec<Number>,
    /// Measured numbers beside the model.
    pub residuals: Vec<Residual>,
    /// Sum of squares of the residuals in sigma; none where nothing was measured.
    pub chi2: Option<f64>,
    /// Root mean square of the residuals of twist, deg.
    pub rms_deg: Option<f64>,
    /// Numbers compared.
    pub count: usize,
    /// Whether the shape stands.
    pub stability: Stability,
    /// Measured numbers that the model cannot be compared with, and why.
    #[serde(skip)]
    left_out: Vec<String>,
}

impl Read {
    /// What is not compared, in words; none if all is.
    pub fn not_compared(&self) -> Option<String> {
        let first = self.left_out.first()?;
        let more = match self.left_out.len() - 1 {
            0 => String::new(),
            more => format!("; and {more} more"),
        };
        Some(format!("Not compared: {first}{more}."))
    }
}

/// Twist along the span.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Twist {
    /// Places from the wing base, mm.
    pub r_mm: Vec<f64>,
    /// Twist there, deg.
    pub twist_deg: Vec<f64>,
    /// What was measured, run by run.
    pub measured: Vec<MeasuredCurve>,
    /// The same wing as opened.
    pub other: Option<Curve>,
}

/// Angle of attack along the span.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct Attack {
    /// Places from the wing base, mm.
    pub r_mm: Vec<f64>,
    /// The angle there, deg.
    pub deg: Vec<f64>,
}

/// Twist of a solved wing along its span.
///
/// # Errors
/// If the instrument cannot see it.
pub fn curve(name: &str, wing: &SolvedWing) -> Result<Curve, Refusal> {
    let readings = wing.observer()?.along_span();
    Ok(Curve {
        name: name.to_string(),
        r_mm: readings.iter().map(|reading| 1e3 * reading.r_m).collect(),
        twist_deg: twists(&readings),
    })
}

fn twists(readings: &[TwistReading]) -> Vec<f64> {
    readings
        .iter()
        .map(|reading| reading.twist_rad.to_degrees())
        .collect()
}

/// Reads a solved wing.
///
/// # Errors
/// If the instrument cannot see it, or the air cannot be set up.
pub fn read(wing: &SolvedWing, measured: Option<&Measurement>) -> Result<Read, Refusal> {
    let observer = wing.observer()?;
    let readings = observer.along_span();
    let lift = wing.lift()?;
    let mut whole_wing = BTreeMap::new();
    if let Some(mean) = lift.as_ref().and_then(|lift| lift.stroke_mean.as_ref()) {
        whole_wing.insert(Channel::Lift, mean.lift_mn);
        whole_wing.insert(Channel::Drag, mean.drag_mn);
        whole_wing.insert(Channel::Power, mean.power_mw);
    }
    let comparison = measured.map(|measured| compare(&observer, measured, &whole_wing));
    let residuals = comparison.as_ref().map(residuals).unwrap_or_default();
    let is_compared = comparison.is_some() && !residuals.is_empty();
    let chi2 = residuals.iter().map(|row| row.in_sigma * row.in_sigma).sum();
    Ok(Read {
        twist: Twist {
            r_mm: readings.iter().map(|reading| 1e3 * reading.r_m).collect(),
            twist_deg: twists(&readings),
            measured: comparison
                .iter()
                .flat_map(|own| &own.span)
                .map(measured_curve)
                .collect(),
            other: None,
        },
        angle_of_attack: attack(&readings),
        numbers: numbers(wing, lift.as_ref())?,
        chi2: is_compared.then_some(chi2),
        rms_deg: comparison.as_ref().and_then(rms_deg),
        count: residuals.len(),
        residuals,
        stability: stability(wing),
        left_out: comparison
            .iter()
            .flat_map(|own| &own.not_compared)
            .map(|own| format!("line {}, {}: {}", own.line, own.channel.name(), own.reason))
            .collect(),
    })
}

fn attack(readings: &[TwistReading]) -> Option<Attack> {
    let angles: Option<Vec<f64>> = readings
        .iter()
        .map(|reading| Some(reading.alpha_rad?.to_degrees()))
        .collect();
    Some(Attack {
        r_mm: readings.iter().map(|reading| 1e3 * reading.r_m).collect(),
        deg: angles.filter(|angles| !angles.is_empty())?,
    })
}

fn measured_curve(span: &SpanComparison) -> MeasuredCurve {
    let of = |value: fn(&ComparedStation) -> f64| span.stations.iter().map(value).collect();
    MeasuredCurve {
        run: span.run.clone(),
        r_mm: of(|station| station.r_mm),
        twist_deg: of(|station| station.measured_deg),
        sigma_deg: of(|station| station.sigma_deg),
        bound: span.stations.iter().map(|station| station.bound).collect(),
    }
}

fn residuals(comparison: &Comparison) -> Vec<Residual> {
    let rows = comparison.rows.iter();
    rows.map(|row| Residual {
        quantity: row.channel.name(),
        unit: row.unit.clone(),
        run: row.run.clone(),
        r_mm: row.r_mm,
        measured: row.measured,
        modelled: row.modelled,
        sigma: row.sigma,
        in_sigma: row.misfit_sigma,
    })
    .collect()
}

/// Root mean square misfit of all measured twists, or of rates integrated to twists.
fn rms_deg(comparison: &Comparison) -> Option<f64> {
    let stations = || comparison.span.iter().flat_map(|span| &span.stations);
    let count = stations().count();
    let sum: f64 = stations().map(|station| station.misfit_deg.powi(2)).sum();
    (count > 0).then(|| (sum / count as f64).sqrt())
}

fn numbers(wing: &SolvedWing, lift: Option<&LiftReport>) -> Result<Vec<Number>, Refusal> {
    let number = |key, label: &str, more: Option<String>, value, unit| Number {
        key,
        label: label.to_string(),
        more,
        value,
        unit,
        original: None,
    };
    let tip = wing.tip_twist_deg()?;
    let station = (1000.0 * wing.model.design().observation.tip_station).round() / 10.0;
    let label = format!("tip twist, at {station} %");
    let tip = tip.map(|tip| number("tip_twist_deg", &label, None, tip, "deg"));
    let mut numbers: Vec<Number> = tip.into_iter().collect();
    if let Some(lift) = lift {
        let forces = &lift.solved;
        let more = |what: &str| Some(format!("{what}, {}", forces.name));
        numbers.push(number("lift_mn", "lift", more("lift"), forces.lift_mn, "mN"));
        numbers.push(number("drag_mn", "drag", more("drag"), forces.drag_mn, "mN"));
        numbers.push(number("power_mw", "power", more("power"), forces.power_mw, "mW"));
        if let Some(mean) = &lift.stroke_mean {
            let more = |what: &str| Some(format!("{what}, {}", mean.name));
            numbers.push(number(
                "mean_lift_mn",
                "mean lift",
                more("lift"),
                mean.lift_mn,
                "mN",
            ));
            numbers.push(number(
                "mean_drag_mn",
                "mean drag",
                more("drag"),
                mean.drag_mn,
                "mN",
            ));
            numbers.push(number(
                "mean_power_mw",
                "mean power",
                more("power"),
                mean.power_mw,
                "mW",
            ));
            let (key, label) = ("mean_lift_per_power_n_per_w", "lift per power");
            let ratio = mean.lift_per_power_n_per_w;
            numbers.extend(ratio.map(|value| number(key, label, more("lift per power"), value, "N/W")));
        }
    }
    let steps = wing.solution.report.newton_steps as f64;
    numbers.push(number("steps", "Newton steps", None, steps, ""));
    Ok(numbers)
}

fn stability(wing: &SolvedWing) -> Stability {
    let report = &wing.solution.report;
    let stable = report.negative_pivots == 0;
    let words = match (stable, report.critical_pressure_ratio) {
        (false, _) => "not stable: the wing would leave this shape".to_string(),
        (true, None) => "stable; the air does not drive it toward divergence".to_string(),
        (true, Some(ratio)) => format!(
            "stable; it would diverge at about {} times this dynamic pressure",
            significant(ratio, 3)
        ),
    };
    Stability { stable, words }
}

/// The wing as the viewer of a report has it, as JSON.
///
/// # Errors
/// If a value is not finite.
pub fn drawn(
    name: &str,
    wing: &SolvedWing,
    measured: Option<&Measurement>,
    stroke: Option<Stroke>,
) -> Result<String, Refusal> {
    let model = &wing.model;
    let mut drawn = Wing::of_solution(name, model.design(), &model.planform, &wing.solution);
    drawn.measured = measured
        .map(|measured| Measured::of_rows(&measured.rows))
        .unwrap_or_default();
    drawn.stroke = stroke;
    drawn.json().map_err(Refusal::new)
}

/// What is said about a shape besides what is read of it.
#[derive(Debug, Clone, PartialEq, Default, Serialize)]
pub struct About {
    /// Revision of the state that it is of.
    pub revision: u64,
    /// Rises whenever the answer would differ.
    pub shape_revision: u64,
    /// Case that it is of.
    pub case: usize,
    /// Whether that state has this shape; if not, it is the last one that was found.
    pub solved: bool,
    /// Whether it is the shape that is found from rest, as `washout solve` finds it; until then it was found from the last one.
    pub settled: bool,
    /// Why there is none.
    pub refusal: Option<Refusal>,
    /// What must be said of it.
    pub note: Option<String>,
    /// Largest error of twist that the mesh leaves, deg; none while that is not known.
    pub mesh_error_deg: Option<f64>,
    /// Phases of the stroke, if its motion was asked for.
    pub stroke_phases: Option<Vec<Phase>>,
    /// Time that it took, s.
    pub seconds: f64,
}

/// A phase of the stroke.
#[derive(Debug, Clone, Copy, PartialEq, Serialize)]
pub struct Phase {
    /// Phase, deg; 0 is mid-stroke.
    pub phase_deg: f64,
    /// Twist at the tip there, deg.
    pub tip_twist_deg: Option<f64>,
}

/// The document of a shape. `read` and `wing` may be of an earlier state.
pub fn document(about: &About, read: Option<&Read>, wing: Option<&str>) -> String {
    let tree = |value: serde_json::Result<Value>| match value {
        Ok(Value::Object(entries)) => entries,
        _ => serde_json::Map::new(),
    };
    let mut whole = tree(serde_json::to_value(about));
    match read {
        Some(read) => whole.extend(tree(serde_json::to_value(read))),
        None => {
            for key in ["twist", "angle_of_attack", "chi2", "rms_deg", "stability"] {
                whole.insert(key.to_string(), Value::Null);
            }
            for key in ["numbers", "residuals"] {
                whole.insert(key.to_string(), Value::Array(Vec::new()));
            }
            whole.insert("count".to_string(), Value::from(0));
        }
    }
    // the wing is text already, and large
    let rest = Value::Object(whole).to_string();
    format!("{{\"wing\":{},{}", wing.unwrap_or("null"), &rest[1..])
}
