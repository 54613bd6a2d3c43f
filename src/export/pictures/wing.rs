//! A single wing against its measurement: twist in degrees along the span before the channels as measured.

use crate::compare::{ComparedStation, Comparison, ProfileOrigin, SpanComparison};
use crate::input::measurement::{Bound, Channel};
use crate::observation::TwistProfile;
use crate::plot::{Chart, Figure, Ink, Key, Limit, Mark, Panel, Point, Sample, Shape, Weight};

use super::panels::Compared;
use super::{compared, residuals};

/// Model against measurement; `profile` is the whole modelled profile, if it is at hand.
pub fn figure(comparison: &Comparison, profile: Option<&TwistProfile>) -> Figure {
    let mut rest = Compared::of_wing(comparison);
    let has_twists = comparison
        .span
        .iter()
        .any(|span| span.origin == ProfileOrigin::Twists);
    if has_twists {
        rest.rows.retain(|row| row.channel != Channel::Twist);
    }
    let mut figure = compared::figure(&rest);
    let spans = comparison
        .span
        .iter()
        .map(|span| chart(comparison, span, profile));
    figure.panels = spans.chain(figure.panels).collect();
    let has_rates = comparison
        .span
        .iter()
        .any(|span| span.origin == ProfileOrigin::IntegratedRates);
    if has_rates {
        figure.legend.insert(
            1,
            Key {
                label: "measured rates integrated from the base, ±1σ".to_string(),
                sample: Sample::Band(Ink::Black, Weight::Thin),
            },
        );
    }
    if comparison.rows.len() > rest.rows.iter().filter(|row| row.r_mm.is_none()).count() {
        figure.caption =
            "Error bars: one standard deviation of the measurement. Positive twist is washout.".to_string();
        if comparison.rows.iter().any(|row| row.bound != Bound::None) {
            figure.caption.push_str(" An arrow: only a bound.");
        }
        if rest.rows.iter().any(|row| row.r_mm.is_none()) {
            figure
                .caption
                .push_str(" Numbers of the whole wing stand in the table of residuals only.");
        }
    }
    figure
}

/// Measured minus modelled, along the span in degrees first.
pub fn residuals(comparison: &Comparison) -> Figure {
    let mut rest = Compared::of_wing(comparison);
    if comparison
        .span
        .iter()
        .any(|span| span.origin == ProfileOrigin::Twists)
    {
        rest.rows.retain(|row| row.channel != Channel::Twist);
    }
    let mut figure = residuals::figure(&rest);
    let spans = comparison.span.iter().map(error_chart);
    figure.panels = spans.chain(figure.panels).collect();
    figure
}

fn error_chart(span: &SpanComparison) -> Panel {
    let point = |s: &ComparedStation| Point {
        x: s.r_mm,
        x_to: None,
        y: if s.misfit_deg == 0.0 { 0.0 } else { s.error_deg },
        sigma: s.sigma_deg,
        limit: Limit::None,
    };
    Panel::Chart(Chart {
        title: title(span),
        x_label: "distance from the wing base (mm)".to_string(),
        y_label: "error of twist (deg)".to_string(),
        marks: vec![Mark::Points {
            points: span.stations.iter().map(point).collect(),
            ink: Ink::Curve(0),
            shape: Shape::Circle,
            is_filled: true,
        }],
        x_includes: Some(0.0),
        has_zero_line: true,
    })
}

fn title(span: &SpanComparison) -> String {
    match span.run.as_str() {
        "" => "twist along the span".to_string(),
        run => format!("twist along the span, run {run}"),
    }
}

fn chart(comparison: &Comparison, span: &SpanComparison, profile: Option<&TwistProfile>) -> Panel {
    let mut marks = vec![Mark::Line {
        points: modelled(comparison, span, profile),
        ink: Ink::Curve(0),
        weight: Weight::Thick,
    }];
    marks.extend(measured(span));
    Panel::Chart(Chart {
        title: title(span),
        x_label: "distance from the wing base (mm)".to_string(),
        x_includes: Some(0.0),
        y_label: "twist, washout positive (deg)".to_string(),
        marks,
        has_zero_line: true,
    })
}

/// The whole profile, if it is read as the measurement was.
fn modelled(comparison: &Comparison, span: &SpanComparison, profile: Option<&TwistProfile>) -> Vec<[f64; 2]> {
    let same = profile.filter(|profile| {
        profile.instrument == comparison.instrument && profile.camera_axis == comparison.camera_axis
    });
    if let Some(profile) = same {
        let values = profile
            .readings
            .iter()
            .filter(|reading| reading.bound == Bound::None);
        values
            .map(|reading| [reading.r_m * 1e3, reading.twist_rad.to_degrees()])
            .collect()
    } else {
        span.stations
            .iter()
            .map(|station| [station.r_mm, station.modelled_deg])
            .collect()
    }
}

fn measured(span: &SpanComparison) -> Vec<Mark> {
    let stations = span.stations.iter();
    match span.origin {
        ProfileOrigin::IntegratedRates => {
            let values = stations.map(|s| [s.r_mm, s.measured_deg, s.sigma_deg]);
            let points: Vec<[f64; 3]> = std::iter::once([0.0; 3]).chain(values).collect();
            vec![
                Mark::Band {
                    points: points
                        .iter()
                        .map(|[x, y, sigma]| [*x, y - sigma, y + sigma])
                        .collect(),
                    ink: Ink::Black,
                },
                Mark::Line {
                    points: points.iter().map(|[x, y, _]| [*x, *y]).collect(),
                    ink: Ink::Black,
                    weight: Weight::Thin,
                },
            ]
        }
        ProfileOrigin::Twists => vec![Mark::Points {
            points: stations
                .map(|s| Point {
                    x: s.r_mm,
                    x_to: None,
                    y: s.measured_deg,
                    sigma: s.sigma_deg,
                    limit: match s.bound {
                        Bound::None => Limit::None,
                        Bound::Upper => Limit::Upper,
                        Bound::Lower => Limit::Lower,
                    },
                })
                .collect(),
            ink: Ink::Curve(0),
            shape: Shape::Circle,
            is_filled: true,
        }],
    }
}
