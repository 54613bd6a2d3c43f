//! Measured minus modelled in standard deviations, case by station: `residuals-in-sigma.svg`.

use std::cmp::Ordering;

use crate::compare::StudyRow;
use crate::diagnose::added_variable::AddedPoint;
use crate::input::measurement::Channel;
use crate::plot::{Figure, HeatMap, HeatTable, Ink, Key, Panel, Sample, Shape};

use super::compared::headline;
use super::panels::{Compared, distinct, only_place, place_words, read_words};
use super::{plain, words};

/// A heat map: a row for each case, a column for each channel and station.
pub fn figure(compared: &Compared) -> Figure {
    let map = heat_map(compared);
    let has = |is_fitted: bool| compared.rows.iter().any(|row| row.is_held_out != is_fitted);
    let key = |label: &str, is_filled: bool| Key {
        label: label.to_string(),
        sample: Sample::Dot(Ink::Black, Shape::Circle, is_filled),
    };
    let legend = match (has(true), has(false)) {
        (true, true) => vec![key("fitted", true), key("held out", false)],
        _ => Vec::new(),
    };
    Figure {
        title: format!(
            "{} – measured minus modelled, in σ of the measurement",
            headline(compared)
        ),
        legend,
        panels: vec![Panel::HeatMap(map)],
        columns: None,
        caption: format!(
            "{}Orange: measured above modelled; blue: below. A bound that the model keeps counts as 0.",
            read_words(compared)
        ),
    }
}

/// `residuals-in-sigma.svg` of a diagnosis: what the calibrated model misses, fitted numbers only.
pub fn of_diagnosis(study: &str, points: &[AddedPoint]) -> Figure {
    let mut cases = distinct(points.iter().map(|point| point.condition.clone()));
    cases.sort_by(|a, b| natural(a).partial_cmp(&natural(b)).unwrap_or(Ordering::Equal));
    let has_runs = distinct(points.iter().map(|point| point.run.clone())).len() > 1;
    let has_places = distinct(points.iter().map(|point| (point.r_mm, point.r_to_mm))).len() > 1;
    let column = |point: &AddedPoint| {
        let mut name = words(point.channel);
        if has_places {
            name.push_str(&place_words(point.r_mm, point.r_to_mm));
        }
        if has_runs && !point.run.is_empty() {
            name.push_str(&format!(", run {}", point.run));
        }
        name
    };
    let columns = distinct(points.iter().map(column));
    let mut cells = vec![vec![None; columns.len()]; cases.len()];
    for point in points {
        let at = (
            cases.iter().position(|case| *case == point.condition),
            columns.iter().position(|name| *name == column(point)),
        );
        if let (Some(case), Some(place)) = at {
            cells[case][place] = Some(point.residual);
        }
    }
    Figure {
        title: format!("{study} – what the calibrated model misses, in σ of the noise"),
        legend: Vec::new(),
        panels: vec![Panel::HeatMap(HeatMap {
            title: String::new(),
            rows: cases.into_iter().map(|case| (case, true)).collect(),
            columns,
            tables: vec![HeatTable {
                title: "calibrated".to_string(),
                cells,
            }],
        })],
        columns: None,
        caption: "Orange: measured above modelled; blue: below. Fitted numbers only, standardised by the noise that the data show and by \
                  errors of the model, which neighbours share: the more of these, the smaller than residual over scatter."
            .to_string(),
    }
}

/// Words and numbers of a name in turn, so that `aero-9.5` stands before `aero-10`.
fn natural(name: &str) -> Vec<(String, f64)> {
    let is_of_number = |c: char| c.is_ascii_digit() || c == '.';
    let mut parts = Vec::new();
    let mut rest = name;
    while !rest.is_empty() {
        let (word, after) = rest.split_at(rest.find(is_of_number).unwrap_or(rest.len()));
        let (number, next) = after.split_at(after.find(|c| !is_of_number(c)).unwrap_or(after.len()));
        parts.push((word.to_string(), number.parse().unwrap_or(0.0)));
        rest = next;
    }
    parts
}

/// The numbers of the heat map.
pub fn heat_map(compared: &Compared) -> HeatMap {
    let key = |row: &StudyRow| (row.wing.clone(), row.case.clone());
    let cases = distinct(compared.rows.iter().map(key));
    let has_runs = distinct(compared.rows.iter().map(|row| row.run.clone())).len() > 1;
    let chords = |channel: Channel| {
        let of_channel = compared.rows.iter().filter(|row| row.channel == channel);
        distinct(of_channel.map(|row| row.chord_fraction)).len()
    };
    let has_places = only_place(compared).is_none();
    let column = |row: &StudyRow| {
        let mut name = words(row.channel);
        if has_places {
            name.push_str(&place_words(row.r_mm, row.r_to_mm));
        }
        if let Some(fraction) = row.chord_fraction.filter(|_| chords(row.channel) > 1) {
            name.push_str(&format!(", {} chord", plain(fraction)));
        }
        if has_runs && !row.run.is_empty() {
            name.push_str(&format!(", run {}", row.run));
        }
        name
    };
    let columns = distinct(compared.rows.iter().map(column));
    let table = |state: usize, title: &str| {
        let mut cells = vec![vec![None; columns.len()]; cases.len()];
        for row in &compared.rows {
            let at = (
                cases.iter().position(|case| *case == key(row)),
                columns.iter().position(|name| *name == column(row)),
            );
            if let (Some(case), Some(place)) = at {
                cells[case][place] = Some(row.errors()[state] / row.sigma);
            }
        }
        HeatTable {
            title: title.to_string(),
            cells,
        }
    };
    let tables = if compared.is_calibrated {
        vec![table(0, "uncalibrated"), table(1, "calibrated")]
    } else {
        vec![table(0, "uncalibrated")]
    };
    HeatMap {
        title: String::new(),
        rows: named_cases(compared, &cases),
        columns,
        tables,
    }
}

/// The cases, by wing and name, as they are called, and whether anything of each is fitted.
fn named_cases(compared: &Compared, cases: &[(String, String)]) -> Vec<(String, bool)> {
    let has_wings = cases.iter().any(|(wing, _)| *wing != cases[0].0);
    let rows = cases.iter().map(|(wing, case)| {
        let of_case = |row: &&StudyRow| row.wing == *wing && row.case == *case;
        let is_fitted = compared.rows.iter().filter(of_case).any(|row| !row.is_held_out);
        let name = if has_wings && !case.contains(wing.as_str()) {
            format!("{wing} {case}")
        } else {
            case.clone()
        };
        (name, is_fitted)
    });
    rows.collect()
}
