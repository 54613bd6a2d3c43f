//! Pictures of a diagnosis: the effects against the residual, where the model fails along the span, the missing field.

use crate::diagnose::added_variable::AddedVariable;
use crate::diagnose::misfit::MisfitStation;
use crate::diagnose::novel::{FieldProfile, Reconstruction};
use crate::diagnose::novel_words;
use crate::diagnose::{Diagnosis, Verdict};
use crate::plot::{Chart, Figure, Ink, Key, Limit, Mark, Panel, Point, Sample, Shape, Weight};

use super::panels::distinct;
use super::{plain, words};

/// `added-variables.svg`: residual against signature, one panel for each of the best explanations.
pub fn added_variables(study: &str, plots: &[AddedVariable]) -> Figure {
    let wings = distinct(
        plots
            .iter()
            .flat_map(|plot| plot.points.iter().map(|point| point.wing.clone())),
    );
    let key = |(index, wing): (usize, &String)| Key {
        label: wing.clone(),
        sample: Sample::Dot(Ink::Curve(index), Shape::of_curve(index), true),
    };
    let mut legend: Vec<Key> = wings.iter().enumerate().map(key).collect();
    legend.push(Key {
        label: "noise, ±1σ".to_string(),
        sample: Sample::Band(Ink::Grey, Weight::Thin),
    });
    legend.push(Key {
        label: "the strength that fits best by one step".to_string(),
        sample: Sample::Line(Ink::Black, Weight::Thick),
    });
    Figure {
        title: format!("{study} – does an effect explain the residual?"),
        legend,
        panels: plots.iter().map(|plot| added_variable(plot, &wings)).collect(),
        columns: None,
        caption: "Each point is a measured number: what the calibrated model misses against what a unit of the effect \
                  would change, both in σ of the noise, after the model has absorbed what it can. An effect that is \
                  missing lays the points on a line through 0."
            .to_string(),
    }
}

fn added_variable(plot: &AddedVariable, wings: &[String]) -> Panel {
    let mut marks = Vec::new();
    let reach = plot.points.iter().map(|point| point.signature);
    let ends = reach.fold([0.0_f64; 2], |[low, high], x| [low.min(x), high.max(x)]);
    marks.push(Mark::Band {
        points: ends.map(|x| [x, -1.0, 1.0]).to_vec(),
        ink: Ink::Grey,
    });
    marks.push(Mark::Line {
        points: ends.map(|x| [x, plot.slope * x]).to_vec(),
        ink: Ink::Black,
        weight: Weight::Thick,
    });
    for (index, wing) in wings.iter().enumerate() {
        let of_wing = plot.points.iter().filter(|point| point.wing == *wing);
        let points: Vec<Point> = of_wing
            .map(|point| value(point.signature, point.residual))
            .collect();
        if !points.is_empty() {
            marks.push(Mark::Points {
                points,
                ink: Ink::Curve(index),
                shape: Shape::of_curve(index),
                is_filled: true,
            });
        }
    }
    Panel::Chart(Chart {
        title: format!("{}, strength {}", plot.effect, plain(plot.slope)),
        x_label: "signature per unit of strength (σ)".to_string(),
        x_includes: Some(0.0),
        y_label: "residual (σ)".to_string(),
        marks,
        has_zero_line: true,
    })
}

/// `misfit-by-station.svg`: mean standardised error of each tenth of the span, by channel.
pub fn by_station(study: &str, stations: &[MisfitStation]) -> Figure {
    let channels = distinct(stations.iter().map(|station| station.channel));
    let key = |(index, channel)| Key {
        label: words(channel),
        sample: Sample::Dot(Ink::Curve(index), Shape::of_curve(index), true),
    };
    let mark = |(index, channel): (usize, _)| {
        let of_channel = stations.iter().filter(|station| station.channel == channel);
        Mark::Points {
            points: of_channel
                .map(|station| value(station.r_over_length, station.mean_sigma))
                .collect(),
            ink: Ink::Curve(index),
            shape: Shape::of_curve(index),
            is_filled: true,
        }
    };
    Figure {
        title: format!("{study} – where the calibrated model misses"),
        legend: channels.iter().copied().enumerate().map(key).collect(),
        panels: vec![Panel::Chart(Chart {
            title: String::new(),
            x_label: "place over the length of the wing".to_string(),
            x_includes: Some(0.0),
            y_label: "mean of measured minus modelled (σ)".to_string(),
            marks: channels.iter().copied().enumerate().map(mark).collect(),
            has_zero_line: true,
        })],
        columns: None,
        caption: "Means over a tenth of the span, all fitted cases together.".to_string(),
    }
}

/// The missing field, where the verdict is that none of the known effects is what is missing.
pub fn missing(diagnosis: &Diagnosis) -> Option<&Reconstruction> {
    let found = diagnosis.novel.reconstruction.as_ref();
    found.filter(|_| diagnosis.verdict == Verdict::Novel)
}

/// `missing-field.svg`: the missing load or compliance along the span with its band.
pub fn field(study: &str, found: &Reconstruction) -> Figure {
    let unit = if found.unit == "1" {
        "share of the twist rate"
    } else {
        &found.unit
    };
    Figure {
        title: format!("{study} – what is missing, along the span"),
        legend: vec![Key {
            label: "best estimate, ±1σ".to_string(),
            sample: Sample::Band(Ink::Curve(0), Weight::Thick),
        }],
        panels: found
            .field
            .iter()
            .map(|profile| profile_panel(profile, unit))
            .collect(),
        columns: None,
        caption: format!(
            "Under the law that the data favour: {}.",
            novel_words::what(found).unwrap_or_default()
        ),
    }
}

fn profile_panel(profile: &FieldProfile, unit: &str) -> Panel {
    let points = &profile.points;
    let band = points.iter().map(|p| {
        let [low, high] = [p.value - p.standard_deviation, p.value + p.standard_deviation];
        [p.r_over_length, low, high]
    });
    Panel::Chart(Chart {
        title: profile.condition.clone().unwrap_or_default(),
        x_label: "place over the length of the wing".to_string(),
        x_includes: Some(0.0),
        y_label: format!("missing ({unit})"),
        marks: vec![
            Mark::Band {
                points: band.collect(),
                ink: Ink::Curve(0),
            },
            Mark::Line {
                points: points.iter().map(|p| [p.r_over_length, p.value]).collect(),
                ink: Ink::Curve(0),
                weight: Weight::Thick,
            },
        ],
        has_zero_line: true,
    })
}

fn value(x: f64, y: f64) -> Point {
    Point {
        x,
        x_to: None,
        y,
        sigma: 0.0,
        limit: Limit::None,
    }
}
