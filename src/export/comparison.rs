//! A wing compared with its measurement, for people: the verdict, every measured number beside the modelled one, twist along the span.

use crate::compare::verdict::sigma_words;
use crate::compare::{ComparedRow, Comparison, ModelledStages, NotCompared, ProfileOrigin, SpanComparison};
use crate::input::design::CameraAxis;
use crate::input::measurement::{Bound, SigmaKind};
use crate::page::Digits::{After, Significant};
use crate::page::text::number;
use crate::page::{Page, Part, Rows, Table};

use super::pictures::panels::Compared;
use super::pictures::{in_sigma, wing as wing_pictures};

/// Measured numbers below which twist along the span has room beside them on a screen.
const FEW: usize = 6;

/// What `washout compare DESIGN` says; its document has the comparison at `comparison`.
pub fn page(found: &Comparison) -> Page {
    let mut page = Page {
        title: found.wing.clone(),
        kind: "comparison",
        lead: said(found),
        brief: brief(found),
        sections: Vec::new(),
    };
    let mut parts = vec![Part::Figure(wing_pictures::figure(found, None))];
    parts.extend(against("/comparison", found));
    let fit = found.modelled_stages.as_ref();
    parts.extend(
        fit.into_iter()
            .flat_map(|fit| stages("/comparison/modelled_stages", fit)),
    );
    page.section("measured", "Against the measurement", parts);
    page.section("left", "Not compared", left(found));
    page
}

/// Where it misses, the measured numbers; twist along the span where only few of them are twists.
fn brief(found: &Comparison) -> Vec<Part> {
    let mut parts = said(found);
    parts.push(Part::Table(
        rows("/comparison", found).without(&["chord_fraction", "kind of σ"]),
    ));
    if found.rows.len() < FEW {
        let spans = found.span.iter().enumerate();
        parts.extend(
            spans.map(|(index, span)| Part::Table(stations(&format!("/comparison/span/{index}"), span))),
        );
    }
    parts
}

/// Where the model misses, in words, and what to know besides.
pub fn said(found: &Comparison) -> Vec<Part> {
    vec![
        Part::Sentence(found.verdict.clone()),
        Part::Notes(found.notes.clone()),
    ]
}

/// Every measured number beside the modelled one, and along the span; `place` is where the comparison stands in the document.
pub fn against(place: &str, found: &Comparison) -> Vec<Part> {
    let compared = Compared::of_wing(found);
    let mut parts = Vec::new();
    if compared.rows.is_empty() {
        parts.push(Part::Text(format!(
            "No number of {} could be compared.",
            found.file
        )));
    } else {
        parts.push(Part::Figure(wing_pictures::residuals(found)));
        parts.push(Part::Figure(in_sigma::figure(&compared)));
        parts.push(Part::Table(rows(place, found)));
    }
    for (index, span) in found.span.iter().enumerate() {
        parts.extend(along(&format!("{place}/span/{index}"), span));
    }
    parts
}

/// What of the measurement was not compared, and why.
pub fn left(found: &Comparison) -> Vec<Part> {
    let line = |row: &NotCompared| {
        let at = row
            .r_mm
            .map_or(String::new(), |r_mm| format!(" at {} mm", number(r_mm, 1)));
        format!("line {}, {}{at}: {}", row.line, row.channel.name(), row.reason)
    };
    vec![Part::List(found.not_compared.iter().map(line).collect())]
}

fn rows(place: &str, found: &Comparison) -> Table {
    let digits = Significant(4);
    let caption = format!(
        "Measured ({}, case {}) beside modelled{}; error: measured minus modelled",
        found.file,
        found.case,
        seen_by(found)
    );
    Rows::of(&format!("{place}/rows"), &found.rows)
        .words("channel", |row| row.channel.name().replace('_', " "))
        .number(["r_mm", "r", "mm"], After(1), |row| row.r_mm)
        .number(["r_to_mm", "to", "mm"], After(1), |row| row.r_to_mm)
        .number(["chord_fraction", "chord fraction", ""], Significant(3), |row| {
            row.chord_fraction
        })
        .bounded(["measured", "measured", ""], digits, |row| {
            (sign(row.bound), row.measured)
        })
        .number(["sigma", "σ", ""], Significant(2), |row| row.sigma)
        .words("kind of σ", |row| kind(row.sigma_kind))
        .bounded(["modelled", "modelled", ""], digits, |row| {
            (sign(row.modelled_bound), row.modelled)
        })
        .number(["error", "error", ""], Significant(3), |row| row.error)
        .words("error in σ", in_sigma)
        .words("unit", |row| if row.unit == "1" { "" } else { &row.unit })
        .words("run", |row| row.run.as_str())
        .caption(&caption)
        .table()
}

/// A camera sees something else than the rotation of the chord.
fn seen_by(found: &Comparison) -> &'static str {
    match found.camera_axis {
        None => "",
        Some(CameraAxis::Stroke) => " as a camera along the stroke sees it",
        Some(CameraAxis::FlappingAxis) => " as a camera along the flapping axis sees it",
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

/// The stages of a modelled profile, which stand at `place` in the document.
pub fn stages(place: &str, fit: &ModelledStages) -> [Part; 2] {
    let scatter = fit
        .scatter_deg
        .map(|scatter| format!(" (scatter {}°)", number(scatter, 2)));
    let table = Rows::of(&format!("{place}/stages"), &fit.stages)
        .number(["from_mm", "from", "mm"], After(1), |stage| stage.from_mm)
        .number(["to_mm", "to", "mm"], After(1), |stage| stage.to_mm)
        .number(["to_error_mm", "±", "mm"], After(1), |stage| stage.to_error_mm)
        .number(["rate_deg_per_mm", "rate", "deg/mm"], After(3), |stage| {
            stage.rate_deg_per_mm
        })
        .number(["rate_error_deg_per_mm", "±", "deg/mm"], After(3), |stage| {
            stage.rate_error_deg_per_mm
        })
        .caption(&format!(
            "Stages of the modelled profile{}",
            scatter.unwrap_or_default()
        ))
        .table();
    [Part::Table(table), Part::Text(fit.meaning_of_errors.clone())]
}

/// Measured and modelled twist at each station.
fn stations(place: &str, span: &SpanComparison) -> Table {
    let origin = match span.origin {
        ProfileOrigin::Twists => "twists as measured",
        ProfileOrigin::IntegratedRates => "measured rates integrated from the base",
    };
    let run = match span.run.as_str() {
        "" => String::new(),
        run => format!(", run {run}"),
    };
    Rows::of(&format!("{place}/stations"), &span.stations)
        .number(["r_mm", "r", "mm"], After(1), |station| station.r_mm)
        .bounded(["measured_deg", "measured", "deg"], After(1), |station| {
            (sign(station.bound), station.measured_deg)
        })
        .number(["sigma_deg", "σ", "deg"], After(1), |station| station.sigma_deg)
        .bounded(["modelled_deg", "modelled", "deg"], After(1), |station| {
            (sign(station.modelled_bound), station.modelled_deg)
        })
        .number(["error_deg", "error", "deg"], After(1), |station| {
            station.error_deg
        })
        .number(["misfit_sigma", "error in σ", ""], After(1), |station| {
            station.misfit_sigma
        })
        .caption(&format!("Twist along the span ({origin}{run})"))
        .table()
}

fn along(place: &str, span: &SpanComparison) -> [Part; 3] {
    let summary = format!(
        "Root mean square {}° over the span, {}° over the stations ({} {}); worst at {} mm.",
        number(span.rmse_along_span_deg, 2),
        number(span.rmse_deg, 2),
        number(span.rms_sigma, 1),
        sigma_words(span.sigma_kind()),
        number(span.worst_r_mm, 1),
    );
    [
        Part::Table(stations(place, span)),
        Part::Text(summary),
        Part::List(span.limits.clone()),
    ]
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
