//! Measured minus modelled in the units of the channels, uncalibrated and calibrated: `residuals.svg`.

use crate::compare::StudyRow;
use crate::plot::{Chart, Figure, Key, Limit, Mark, Panel, Point, Sample};

use super::compared::{Looks, headline, point, use_keys};
use super::panels::{Compared, Profiles, StudyPanel, panels, read_words};
use super::{with_unit, words};

/// Residuals over station or operating point: uncalibrated on the left, calibrated on the right.
pub fn figure(compared: &Compared) -> Figure {
    let panels = panels(compared, Profiles::Together);
    let curves = Looks::of(&panels);
    let states: &[(usize, &str)] = if compared.is_calibrated {
        &[(0, "uncalibrated"), (1, "calibrated")]
    } else {
        &[(0, "")]
    };
    let charts = panels.iter().flat_map(|panel| {
        states
            .iter()
            .map(|(state, name)| chart(compared, panel, &curves, *state, name))
    });
    let mut legend: Vec<Key> = curves.keys();
    legend.extend(use_keys(compared, curves.common()));
    legend.retain(|key| matches!(key.sample, Sample::Marker(..)));
    Figure {
        title: format!("{} – measured minus modelled", headline(compared)),
        legend,
        panels: charts.collect(),
        columns: compared.is_calibrated.then_some(2),
        caption: format!(
            "{}Error bars: one standard deviation of the measurement. A bound that the model keeps has no residual.",
            read_words(compared)
        ),
    }
}

fn chart(compared: &Compared, panel: &StudyPanel, curves: &Looks, state: usize, name: &str) -> Panel {
    let error = |row: &StudyRow| row.errors()[state];
    let mut marks = Vec::new();
    for curve in &panel.curves {
        for is_fitted in [true, false] {
            let of_use = curve
                .places
                .iter()
                .filter(|p| compared.rows[p.row].is_held_out != is_fitted);
            let points: Vec<_> = of_use
                .map(|place| Point {
                    limit: Limit::None,
                    ..point(place, &compared.rows[place.row], error)
                })
                .collect();
            if !points.is_empty() {
                marks.push(Mark::Points {
                    points,
                    ink: curves.ink(curve),
                    shape: curves.shape(curve),
                    is_filled: is_fitted,
                });
            }
        }
    }
    let state = if name.is_empty() {
        String::new()
    } else {
        format!(" – {name}")
    };
    Panel::Chart(Chart {
        title: format!("{}{state}", panel.title),
        x_label: panel.x_label.clone(),
        x_includes: panel.x_includes,
        y_label: with_unit(
            &format!("error of {}", words(panel.channel)),
            panel.channel.unit(),
        ),
        marks,
        has_zero_line: true,
    })
}
