//! Every figure of a sweep against every axis.

use crate::plot::{Chart, Figure, Ink, Limit, Mark, Panel, Point, Shape};
use crate::sweep::{Row, SweepPlan, Values};

use crate::export::sweep::figures;

/// Most figures, and most axes, that are drawn.
const MOST: [usize; 2] = [6, 4];

/// A panel for each figure and axis; none if no case gave anything.
pub fn scatter(plan: &SweepPlan, rows: &[Row]) -> Option<Figure> {
    let names = figures(rows);
    let all: Vec<&String> = names.iter().filter(|name| *name != "newton_steps").collect();
    let left_out = all.len() > MOST[0] || plan.axes.len() > MOST[1];
    let panels: Vec<Panel> = all
        .iter()
        .take(MOST[0])
        .flat_map(|name| (0..plan.axes.len().min(MOST[1])).map(move |axis| (name, axis)))
        .map(|(name, axis)| panel(plan, rows, name, axis))
        .collect();
    (!panels.is_empty()).then(|| Figure {
        title: format!("{} cases", rows.len()),
        legend: Vec::new(),
        panels,
        columns: Some(plan.axes.len().clamp(1, MOST[1])),
        caption: match left_out {
            true => format!(
                "The first {} of {} figures against the first {} of {} axes; sweep.csv has all.",
                MOST[0].min(all.len()),
                all.len(),
                MOST[1].min(plan.axes.len()),
                plan.axes.len()
            ),
            false => String::new(),
        },
    })
}

fn panel(plan: &SweepPlan, rows: &[Row], name: &str, axis: usize) -> Panel {
    let place = |row: &Row| {
        let value = &row.values[axis];
        value.parse().ok().or_else(|| match &plan.axes[axis].values {
            Values::List(values) => values
                .iter()
                .position(|known| known == value)
                .map(|place| place as f64 + 1.0),
            Values::Range(_) => None,
        })
    };
    let points = rows.iter().filter_map(|row| {
        Some(Point {
            x: place(row)?,
            x_to: None,
            y: row.figure(name)?,
            sigma: 0.0,
            limit: Limit::None,
        })
    });
    Panel::Chart(Chart {
        title: String::new(),
        x_label: plan.axes[axis].key.clone(),
        y_label: name.to_string(),
        marks: vec![Mark::Points {
            points: points.collect(),
            ink: Ink::Curve(0),
            shape: Shape::Circle,
            is_filled: true,
        }],
        x_includes: None,
        has_zero_line: false,
    })
}
