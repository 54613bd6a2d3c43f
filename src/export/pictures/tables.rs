//! The numbers behind the pictures as CSV, one file beside each picture.

use crate::compare::{Comparison, StudyRow};
use crate::diagnose::Diagnosis;
use crate::diagnose::added_variable::AddedVariable;
use crate::diagnose::novel::Reconstruction;
use crate::export::{ExportError, csv};
use crate::input::measurement::Channel;

use super::ladder::{Fall, Measure};
use super::panels::{Compared, Profiles, panels};

const COMPARED_HEAD: [&str; 21] = [
    "panel",
    "curve",
    "at",
    "at_value",
    "at_value_to",
    "case",
    "wing",
    "use",
    "channel",
    "unit",
    "run",
    "line",
    "r_mm",
    "r_to_mm",
    "chord_fraction",
    "measured",
    "sigma",
    "bound",
    "stated",
    "sigma_of_inputs",
    "calibrated",
];

/// A row with panel, curve and abscissa, and its place there.
type Line<'a> = (usize, [&'a str; 3], [Option<f64>; 2]);

/// `compared.csv`: every number with its panel and curve; those without a panel come last.
pub fn compared(compared: &Compared) -> Result<Vec<u8>, ExportError> {
    let panels = panels(compared, Profiles::Apart);
    let mut places: Vec<Line> = Vec::new();
    for panel in &panels {
        for curve in &panel.curves {
            let names = [panel.title.as_str(), &curve.label, &panel.x_label];
            places.extend(
                curve
                    .places
                    .iter()
                    .map(|place| (place.row, names, [Some(place.x), place.x_to])),
            );
        }
    }
    let is_placed = |row: usize| places.iter().any(|(placed, ..)| *placed == row);
    let rest: Vec<usize> = (0..compared.rows.len()).filter(|row| !is_placed(*row)).collect();
    places.extend(rest.into_iter().map(|row| (row, [""; 3], [None; 2])));
    let lines = places.iter().map(|(index, names, at)| {
        let row = &compared.rows[*index];
        (
            (names, at),
            (
                &row.case,
                &row.wing,
                used(compared, row),
                row.channel.name(),
                row.channel.unit(),
                &row.run,
            ),
            (row.line, row.r_mm, row.r_to_mm, row.chord_fraction),
            (
                row.measured,
                row.sigma,
                row.bound,
                row.before,
                row.sigma_of_inputs,
                compared.is_calibrated.then_some(row.after),
            ),
        )
    });
    csv::table(&COMPARED_HEAD, &lines.collect::<Vec<_>>())
}

const RESIDUALS_HEAD: [&str; 16] = [
    "case",
    "wing",
    "use",
    "channel",
    "unit",
    "run",
    "line",
    "r_mm",
    "r_to_mm",
    "chord_fraction",
    "sigma",
    "bound",
    "error_stated",
    "error_calibrated",
    "stated_in_sigma",
    "calibrated_in_sigma",
];

/// `residuals.csv`: measured minus modelled, in the unit of the channel and in sigma; 0 where a bound is kept.
pub fn residuals(compared: &Compared) -> Result<Vec<u8>, ExportError> {
    let lines = compared.rows.iter().map(|row| {
        let [stated, calibrated] = row.errors();
        (
            (
                &row.case,
                &row.wing,
                used(compared, row),
                row.channel.name(),
                row.channel.unit(),
                &row.run,
            ),
            (
                row.line,
                row.r_mm,
                row.r_to_mm,
                row.chord_fraction,
                row.sigma,
                row.bound,
            ),
            (
                stated,
                compared.is_calibrated.then_some(calibrated),
                stated / row.sigma,
                compared.is_calibrated.then_some(calibrated / row.sigma),
            ),
        )
    });
    csv::table(&RESIDUALS_HEAD, &lines.collect::<Vec<_>>())
}

const SPAN_HEAD: [&str; 9] = [
    "run",
    "origin",
    "r_mm",
    "measured_deg",
    "sigma_deg",
    "bound",
    "modelled_deg",
    "error_deg",
    "misfit_sigma",
];

/// `span.csv`: twist in degrees along the span of a single wing.
pub fn span(comparison: &Comparison) -> Result<Vec<u8>, ExportError> {
    let lines = comparison.span.iter().flat_map(|span| {
        span.stations.iter().map(move |s| {
            let values = (s.modelled_deg, s.error_deg, s.misfit_sigma);
            (
                &span.run,
                span.origin,
                (s.r_mm, s.measured_deg, s.sigma_deg, s.bound),
                values,
            )
        })
    });
    csv::table(&SPAN_HEAD, &lines.collect::<Vec<_>>())
}

/// `added-variables.csv`: the points of the plots of effects.
pub fn added_variables(plots: &[AddedVariable]) -> Result<Vec<u8>, ExportError> {
    let head = [
        "effect",
        "slope",
        "case",
        "wing",
        "channel",
        "run",
        "r_mm",
        "r_to_mm",
        "signature_sigma",
        "residual_sigma",
    ];
    let lines = plots.iter().flat_map(|plot| {
        plot.points.iter().map(move |point| {
            let channel = point.channel.name();
            let place = (
                &point.condition,
                &point.wing,
                channel,
                &point.run,
                point.r_mm,
                point.r_to_mm,
            );
            (&plot.effect, plot.slope, place, point.signature, point.residual)
        })
    });
    csv::table(&head, &lines.collect::<Vec<_>>())
}

/// `misfit-by-station.csv`: where along the span the calibrated model fails.
pub fn by_station(diagnosis: &Diagnosis) -> Result<Vec<u8>, ExportError> {
    let head = ["r_over_length", "channel", "share", "mean_sigma"];
    let lines = diagnosis.misfit.by_station.iter();
    let lines = lines.map(|s| (s.r_over_length, s.channel.name(), s.share, s.mean_sigma));
    csv::table(&head, &lines.collect::<Vec<_>>())
}

/// `missing-field.csv`: the missing load or compliance along the span.
pub fn field(found: &Reconstruction) -> Result<Vec<u8>, ExportError> {
    let head = ["case", "r_over_length", "value", "standard_deviation", "unit"];
    let lines = found.field.iter().flat_map(|profile| {
        profile.points.iter().map(|point| {
            let values = (point.r_over_length, point.value, point.standard_deviation);
            (profile.condition.as_deref().unwrap_or(""), values, &found.unit)
        })
    });
    csv::table(&head, &lines.collect::<Vec<_>>())
}

/// Errors that fall step by step, in long form: one line for each step and group of data.
pub fn falls(falls: &[Fall]) -> Result<Vec<u8>, ExportError> {
    let head = ["wing", "channel", "measure", "unit", "step", "group", "error"];
    let mut lines = Vec::new();
    for fall in falls {
        for (step, levels) in &fall.steps {
            for (group, level) in fall.groups.iter().zip(levels) {
                let (measure, unit) = match (fall.measure, fall.channel) {
                    (Measure::RootMeanSquare, Some(channel)) => ("root_mean_square", channel.unit()),
                    (Measure::RootMeanSquare | Measure::InSigma, _) => ("root_mean_square", "sigma"),
                    (Measure::ChiSquare, _) => ("chi_square_per_number", "1"),
                };
                let channel = fall.channel.map_or("all", Channel::name);
                lines.push((&fall.wing, channel, measure, unit, step, group, level));
            }
        }
    }
    csv::table(&head, &lines)
}

/// What a number was for; nothing where nothing was fitted.
fn used(compared: &Compared, row: &StudyRow) -> &'static str {
    match (row.is_held_out, compared.is_calibrated) {
        (true, _) => "held out",
        (false, true) => "fit",
        (false, false) => "",
    }
}
