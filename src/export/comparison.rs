//! Measured beside modelled, as text.

use crate::compare::verdict::sigma_words;
use crate::compare::{ComparedRow, Comparison, ModelledStages, ProfileOrigin, SpanComparison};
use crate::input::design::CameraAxis;
use crate::input::measurement::{Bound, Channel, SigmaKind};

use crate::page::text::{Table, number, significant, wrapped};

/// The page of `washout compare`.
pub fn page(comparison: &Comparison) -> String {
    let mut sections = vec![format!("{}\n", comparison.wing), rows(comparison)];
    sections.extend(comparison.span.iter().map(span));
    sections.extend(comparison.modelled_stages.as_ref().map(stages));
    if !comparison.not_compared.is_empty() {
        let rows = comparison.not_compared.iter().map(|row| {
            let at = row
                .r_mm
                .map_or(String::new(), |r_mm| format!(" at {} mm", number(r_mm, 1)));
            format!(
                "  line {}, {}{at}: {}\n",
                row.line,
                row.channel.name(),
                row.reason
            )
        });
        sections.push(format!("Not compared\n{}", rows.collect::<String>()));
    }
    if !comparison.notes.is_empty() {
        let notes = comparison.notes.iter().map(|note| wrapped(note, 2));
        sections.push(format!("Notes\n{}", notes.collect::<String>()));
    }
    sections.push(format!("In words\n{}", wrapped(&comparison.verdict, 2)));
    sections.join("\n")
}

/// Every measured number beside the modelled one.
pub fn rows(comparison: &Comparison) -> String {
    let mut table = Table::new([
        "channel", "r_mm", "to_mm", "measured", "sigma", "kind", "modelled", "error", "in_sigma", "unit",
        "run",
    ]);
    for row in &comparison.rows {
        let place = |place: Option<f64>| place.map_or(String::new(), |r_mm| number(r_mm, 1));
        let unit = if row.unit == "1" { "" } else { &row.unit };
        table.row([
            row.channel.name().to_string(),
            place(row.r_mm),
            place(row.r_to_mm),
            format!("{}{}", sign(row.bound), value(row.channel, row.measured)),
            value(row.channel, row.sigma),
            kind(row.sigma_kind).to_string(),
            format!("{}{}", sign(row.modelled_bound), value(row.channel, row.modelled)),
            value(row.channel, row.error),
            in_sigma(row),
            unit.to_string(),
            row.run.clone(),
        ]);
    }
    if table.is_empty() {
        return format!("No number of {} could be compared\n", comparison.file);
    }
    format!(
        "Measured ({}, case {}) beside modelled{}; error: measured minus modelled\n{}",
        comparison.file,
        comparison.case,
        seen_by(comparison),
        table.render()
    )
}

/// A camera sees something else than the rotation of the chord.
fn seen_by(comparison: &Comparison) -> &'static str {
    match comparison.camera_axis {
        None => "",
        Some(CameraAxis::Stroke) => " as a camera along the stroke sees it",
        Some(CameraAxis::FlappingAxis) => " as a camera along the flapping axis sees it",
    }
}

/// As many decimals for all values of a channel, so that they can be held against each other.
fn value(channel: Channel, value: f64) -> String {
    match channel {
        Channel::Twist => number(value, 2),
        Channel::TwistRate
        | Channel::LiftRatio
        | Channel::DragRatio
        | Channel::EfficiencyRatio
        | Channel::EffectiveLiftRatio => number(value, 3),
        _ => significant(value, 3),
    }
}

/// A bounded value that nothing contradicts has no distance.
fn in_sigma(row: &ComparedRow) -> String {
    let is_bounded = row.bound != Bound::None || row.modelled_bound != Bound::None;
    if is_bounded && row.misfit == 0.0 {
        "allowed".to_string()
    } else {
        number(row.misfit_sigma, 1)
    }
}

/// The stages of the modelled profile.
pub fn stages(fit: &ModelledStages) -> String {
    let mut table = Table::new(["from_mm", "to_mm", "±_mm", "deg_per_mm", "±_deg_per_mm"]);
    for stage in &fit.stages {
        table.row([
            number(stage.from_mm, 1),
            number(stage.to_mm, 1),
            stage.to_error_mm.map_or(String::new(), |error| number(error, 1)),
            number(stage.rate_deg_per_mm, 3),
            stage
                .rate_error_deg_per_mm
                .map_or(String::new(), |error| number(error, 3)),
        ]);
    }
    let scatter = fit
        .scatter_deg
        .map(|scatter| format!(" (scatter {}°)", number(scatter, 2)));
    format!(
        "Stages of the modelled profile{}\n{}{}",
        scatter.unwrap_or_default(),
        table.render(),
        wrapped(&fit.meaning_of_errors, 2)
    )
}

fn span(span: &SpanComparison) -> String {
    let mut table = Table::new([
        "r_mm",
        "measured_deg",
        "sigma_deg",
        "modelled_deg",
        "error_deg",
        "in_sigma",
    ]);
    for station in &span.stations {
        table.row([
            number(station.r_mm, 1),
            format!("{}{}", sign(station.bound), number(station.measured_deg, 1)),
            number(station.sigma_deg, 1),
            format!(
                "{}{}",
                sign(station.modelled_bound),
                number(station.modelled_deg, 1)
            ),
            number(station.error_deg, 1),
            number(station.misfit_sigma, 1),
        ]);
    }
    let origin = match span.origin {
        ProfileOrigin::Twists => "twists as measured",
        ProfileOrigin::IntegratedRates => "measured rates integrated from the base",
    };
    let run = if span.run.is_empty() {
        String::new()
    } else {
        format!(", run {}", span.run)
    };
    let limits: String = span.limits.iter().map(|limit| wrapped(limit, 2)).collect();
    format!(
        "Along the span ({origin}{run})\n{}  root mean square {}° over the span, {}° over the stations ({} {}); \
         worst at {} mm\n{limits}",
        table.render(),
        number(span.rmse_along_span_deg, 2),
        number(span.rmse_deg, 2),
        number(span.rms_sigma, 1),
        sigma_words(span.sigma_kind()),
        number(span.worst_r_mm, 1),
    )
}

/// "<" and ">" before a bound.
pub fn sign(bound: Bound) -> &'static str {
    match bound {
        Bound::None => "",
        Bound::Upper => "<",
        Bound::Lower => ">",
    }
}

fn kind(kind: SigmaKind) -> &'static str {
    match kind {
        SigmaKind::Stated => "stated",
        SigmaKind::Repeats => "repeats",
        SigmaKind::Assumed => "assumed",
    }
}
