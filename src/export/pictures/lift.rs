//! Lift, drag and efficiency along the span, over the stroke and against power.

use crate::export::ExportError;
use crate::export::lift::{LiftSummary, tables};
use crate::export::run::RunFolder;
use crate::plot::{Chart, Figure, Ink, Key, Mark, Panel, Sample, Weight};

/// Adds `span.svg`, `stroke.svg`, `sweep.svg` and the tables.
///
/// # Errors
/// If a file cannot be written, or a number is not finite.
pub fn add(folder: &mut RunFolder, summary: &LiftSummary) -> Result<(), ExportError> {
    folder.add("lift.csv", &tables::wings(summary)?)?;
    if !summary.ratios.is_empty() {
        folder.add("ratios.csv", &tables::ratios(summary)?)?;
    }
    folder.add("span.svg", span(summary).to_svg()?.as_bytes())?;
    folder.add("span.csv", &tables::span(summary)?)?;
    folder.add("stroke.svg", stroke(summary).to_svg()?.as_bytes())?;
    folder.add("stroke.csv", &tables::stroke(summary)?)?;
    if !summary.sweep.is_empty() {
        folder.add("sweep.svg", sweep(summary).to_svg()?.as_bytes())?;
        folder.add("sweep.csv", &tables::sweep(summary)?)?;
    }
    if !summary.sensitivity.is_empty() {
        folder.add("sensitivity.csv", &tables::sensitivity(summary)?)?;
    }
    Ok(())
}

fn legend<'a>(names: impl Iterator<Item = &'a String>) -> Vec<Key> {
    let key = |(index, name): (usize, &String)| Key {
        label: name.clone(),
        sample: Sample::Line(Ink::Curve(index), Weight::Thick),
    };
    names.enumerate().map(key).collect()
}

fn chart(title: &str, x_label: &str, y_label: &str, curves: &[Vec<[f64; 2]>]) -> Panel {
    let line = |(index, points): (usize, &Vec<[f64; 2]>)| Mark::Line {
        points: points.clone(),
        ink: Ink::Curve(index),
        weight: Weight::Thick,
    };
    Panel::Chart(Chart {
        title: title.to_string(),
        x_label: x_label.to_string(),
        y_label: y_label.to_string(),
        marks: curves.iter().enumerate().map(line).collect(),
        x_includes: None,
        has_zero_line: true,
    })
}

fn joined(x: &[f64], y: &[f64]) -> Vec<[f64; 2]> {
    x.iter().zip(y).map(|(x, y)| [*x, *y]).collect()
}

/// Along the span: twist, mean lift and drag, local lift over drag.
pub fn span(summary: &LiftSummary) -> Figure {
    let curves = |of: &dyn Fn(&crate::export::lift::SpanCurve) -> Vec<[f64; 2]>| -> Vec<Vec<[f64; 2]>> {
        summary.span.iter().map(of).collect()
    };
    let x = "r (mm)";
    Figure {
        title: "Along the span, mean over the stroke".to_string(),
        legend: legend(summary.span.iter().map(|curve| &curve.wing)),
        panels: vec![
            chart(
                "Twist at mid-stroke",
                x,
                "twist (deg)",
                &curves(&|c| joined(&c.r_mm, &c.twist_deg)),
            ),
            chart(
                "Lift",
                x,
                "lift (mN/mm)",
                &curves(&|c| joined(&c.r_mm, &c.lift_mn_per_mm)),
            ),
            chart(
                "Drag",
                x,
                "drag (mN/mm)",
                &curves(&|c| joined(&c.r_mm, &c.drag_mn_per_mm)),
            ),
            chart(
                "Local lift over drag",
                x,
                "over the mean of the reference",
                &curves(&|c| {
                    let some = c.r_mm.iter().zip(&c.lift_to_drag);
                    some.filter_map(|(r, ratio)| Some([*r, (*ratio)?])).collect()
                }),
            ),
        ],
        columns: Some(2),
        caption: format!(
            "{}. Reference: {}.",
            capitalised(&summary.twist),
            summary.reference
        ),
    }
}

/// Over one half-stroke: lift, drag, power.
pub fn stroke(summary: &LiftSummary) -> Figure {
    let curves = |of: fn(&crate::export::lift::StrokeCurve) -> &Vec<f64>| -> Vec<Vec<[f64; 2]>> {
        let each = summary.stroke.iter();
        each.map(|curve| joined(&curve.phase_deg, of(curve))).collect()
    };
    let x = "stroke phase (deg; 0 is mid-stroke)";
    Figure {
        title: "One wing over one half-stroke".to_string(),
        legend: legend(summary.stroke.iter().map(|curve| &curve.wing)),
        panels: vec![
            chart("Lift", x, "lift (mN)", &curves(|c| &c.lift_mn)),
            chart("Drag", x, "drag (mN)", &curves(|c| &c.drag_mn)),
            chart("Aerodynamic power", x, "power (mW)", &curves(|c| &c.power_mw)),
        ],
        columns: Some(3),
        caption: format!("{}.", capitalised(&summary.twist)),
    }
}

/// Lift against aerodynamic power, and their ratio, over the amplitude.
pub fn sweep(summary: &LiftSummary) -> Figure {
    let lift = summary
        .sweep
        .iter()
        .map(|c| joined(&c.power_mw, &c.lift_mn))
        .collect::<Vec<_>>();
    let ratio = summary.sweep.iter().map(|c| {
        let points = c.power_mw.iter().zip(&c.lift_mn);
        points
            .filter(|(power, _)| **power > 0.0)
            .map(|(power, lift)| [*lift, lift / power])
            .collect()
    });
    let mut panels = vec![
        chart(
            "Lift against power",
            "aerodynamic power (mW)",
            "mean lift (mN)",
            &lift,
        ),
        chart(
            "Lift per power",
            "mean lift (mN)",
            "lift per power (N/W)",
            &ratio.collect::<Vec<_>>(),
        ),
    ];
    for panel in &mut panels {
        if let Panel::Chart(chart) = panel {
            chart.has_zero_line = false;
        }
    }
    let range = summary.sweep.first().and_then(|curve| {
        Some((
            curve.half_amplitude_deg.first()?,
            curve.half_amplitude_deg.last()?,
        ))
    });
    let range = range.map_or(String::new(), |(low, high)| {
        format!("Half amplitude from {low:.1} to {high:.1} deg, each wing at its frequency. ")
    });
    Figure {
        title: "Lift against aerodynamic power over the amplitude, one wing".to_string(),
        legend: legend(summary.sweep.iter().map(|curve| &curve.wing)),
        panels,
        columns: Some(2),
        caption: format!("{range}{}.", capitalised(&summary.twist)),
    }
}

fn capitalised(text: &str) -> String {
    let mut letters = text.chars();
    match letters.next() {
        Some(first) => first.to_uppercase().chain(letters).collect(),
        None => String::new(),
    }
}
