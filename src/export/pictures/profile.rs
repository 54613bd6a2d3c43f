//! A run along the span and over the stroke: twist with its band, stages and measurement; the air on each strip.

use serde::Deserialize;

use crate::compare::{ComparedStation, ProfileOrigin, SpanComparison};
use crate::coupling::solution::StripLoad;
use crate::export::summary::RunSummary;
use crate::input::measurement::Bound;
use crate::plot::{Chart, Figure, Ink, Key, Limit, Mark, Panel, Point, Sample, Shape, Weight};
use crate::study::Output;

const ALONG: &str = "distance from the wing base (mm)";

/// Twist along the span: modelled, its band and stages where there are such, measured where it was.
pub fn twist(summary: &RunSummary) -> Figure {
    let mut curves = Curves::default();
    curves.model(summary);
    curves.model_as_measured(summary);
    for span in summary.measured.iter().flat_map(|measured| &measured.span) {
        curves.measurement(span);
    }
    Figure {
        title: format!("{} – twist along the span", summary.name),
        legend: curves.legend,
        panels: vec![Panel::Chart(Chart {
            title: String::new(),
            x_label: ALONG.to_string(),
            x_includes: Some(0.0),
            y_label: "twist, washout positive (deg)".to_string(),
            marks: curves.marks,
            has_zero_line: true,
        })],
        columns: None,
        caption: String::new(),
    }
}

/// What is drawn of the twist along the span, with the legend.
#[derive(Default)]
struct Curves {
    marks: Vec<Mark>,
    legend: Vec<Key>,
}

impl Curves {
    fn key(&mut self, label: &str, sample: Sample) {
        self.legend.push(Key {
            label: label.to_string(),
            sample,
        });
    }

    fn line(&mut self, points: Vec<[f64; 2]>, ink: Ink, weight: Weight) {
        self.marks.push(Mark::Line { points, ink, weight });
    }

    fn model(&mut self, summary: &RunSummary) {
        let points = band(summary);
        if !points.is_empty() {
            let ink = Ink::Curve(0);
            self.key(
                "5 to 95 % over the assumed ranges",
                Sample::Band(ink, Weight::Thin),
            );
            self.marks.push(Mark::Band { points, ink });
        }
        if let Some(points) = stages(summary) {
            self.key("its stages", Sample::Line(Ink::Grey, Weight::Thin));
            self.line(points, Ink::Grey, Weight::Thin);
        }
        self.key("model", Sample::Line(Ink::Curve(0), Weight::Thick));
        let read = summary.along_span.iter().filter(|row| row.bound == Bound::None);
        let points = read.map(|row| [row.r_mm, row.twist_deg]).collect();
        self.line(points, Ink::Curve(0), Weight::Thick);
    }

    /// Only where the measurement has another instrument than the design.
    fn model_as_measured(&mut self, summary: &RunSummary) {
        let instrument = summary.design.observation.instrument;
        let foreign = summary
            .measured
            .as_ref()
            .filter(|measured| measured.instrument != instrument);
        for span in foreign.iter().flat_map(|measured| &measured.span).take(1) {
            self.key(
                "model as the instrument of the measurement reads it",
                Sample::Line(Ink::Curve(2), Weight::Thick),
            );
            let points = span.stations.iter().map(|s| [s.r_mm, s.modelled_deg]);
            self.line(points.collect(), Ink::Curve(2), Weight::Thick);
        }
    }

    fn measurement(&mut self, span: &SpanComparison) {
        let run = match span.run.as_str() {
            "" => String::new(),
            run => format!(", run {run}"),
        };
        match span.origin {
            ProfileOrigin::IntegratedRates => {
                self.key(
                    &format!("measured rates integrated from the base, ±1σ{run}"),
                    Sample::Band(Ink::Black, Weight::Thin),
                );
                let ends = span.stations.iter();
                let ends = ends.map(|s| [s.r_mm, s.measured_deg - s.sigma_deg, s.measured_deg + s.sigma_deg]);
                self.marks.push(Mark::Band {
                    points: std::iter::once([0.0; 3]).chain(ends).collect(),
                    ink: Ink::Black,
                });
                let line = span.stations.iter().map(|s| [s.r_mm, s.measured_deg]);
                let line = std::iter::once([0.0; 2]).chain(line);
                self.line(line.collect(), Ink::Black, Weight::Thin);
            }
            ProfileOrigin::Twists => {
                self.key(
                    &format!("measured, ±1σ{run}"),
                    Sample::Marker(Ink::Curve(1), Shape::Circle, true),
                );
                self.marks.push(Mark::Points {
                    points: span.stations.iter().map(measured).collect(),
                    ink: Ink::Curve(1),
                    shape: Shape::Circle,
                    is_filled: true,
                });
            }
        }
    }
}

fn measured(station: &ComparedStation) -> Point {
    Point {
        x: station.r_mm,
        x_to: None,
        y: station.measured_deg,
        sigma: station.sigma_deg,
        limit: match station.bound {
            Bound::None => Limit::None,
            Bound::Upper => Limit::Upper,
            Bound::Lower => Limit::Lower,
        },
    }
}

/// The band over the assumed ranges, from nothing at the base.
fn band(summary: &RunSummary) -> Vec<[f64; 3]> {
    let outputs = summary.uncertainty.iter().flat_map(|band| &band.outputs);
    let ends = outputs.filter_map(|output| match output.output {
        Output::Twist { r_mm } => Some([r_mm, output.q05, output.q95]),
        _ => None,
    });
    let ends: Vec<[f64; 3]> = ends.collect();
    if ends.is_empty() {
        return ends;
    }
    std::iter::once([0.0; 3]).chain(ends).collect()
}

/// The stages as a broken line from the reading at the base.
fn stages(summary: &RunSummary) -> Option<Vec<[f64; 2]>> {
    let stages = &summary.stages.as_ref()?.stages;
    let base = summary.profile.first().filter(|row| row.place == "base");
    let mut at = [stages.first()?.from_mm, base.map_or(0.0, |row| row.twist_deg)];
    let mut points = vec![at];
    for stage in stages {
        at = [stage.to_mm, at[1] + stage.rate_deg_per_mm * (stage.to_mm - at[0])];
        points.push(at);
    }
    Some(points)
}

/// A row of `strips.csv`, as far as it is drawn.
#[derive(Debug, Clone, Copy, PartialEq, Deserialize)]
pub struct StripRow {
    /// Place along the span.
    pub r_mm: f64,
    /// Speed of the air.
    pub speed_m_s: f64,
    /// Angle of attack.
    pub alpha_deg: f64,
    /// Force across the chord, per length.
    pub normal_n_per_m: f64,
    /// Force along the chord toward the trailing edge, per length.
    pub tangential_n_per_m: f64,
}

impl StripRow {
    /// Of a solved wing.
    pub fn of(strip: &StripLoad) -> StripRow {
        StripRow {
            r_mm: strip.r_m * 1e3,
            speed_m_s: strip.speed_m_s,
            alpha_deg: strip.alpha_rad.to_degrees(),
            normal_n_per_m: strip.normal_n_per_m,
            tangential_n_per_m: strip.tangential_n_per_m,
        }
    }

    /// Lift and drag per length, mN/mm: across the local stream and along it.
    pub fn lift_and_drag_mn_per_mm(&self) -> [f64; 2] {
        let (sin, cos) = self.alpha_deg.to_radians().sin_cos();
        let [normal, tangential] = [self.normal_n_per_m, self.tangential_n_per_m];
        [normal * cos - tangential * sin, normal * sin + tangential * cos]
    }
}

/// Angle of attack, lift and drag along the span, as solved.
pub fn strips(name: &str, rows: &[StripRow]) -> Figure {
    let chart = |title: &str, y_label: &str, value: &dyn Fn(&StripRow) -> f64| {
        line_chart(
            title,
            ALONG,
            y_label,
            vec![rows.iter().map(|row| [row.r_mm, value(row)]).collect()],
        )
    };
    let panels = if rows.is_empty() {
        Vec::new()
    } else {
        vec![
            chart("Angle of attack", "angle of attack (deg)", &|row| row.alpha_deg),
            chart("Lift", "lift (mN/mm)", &|row| row.lift_and_drag_mn_per_mm()[0]),
            chart("Drag", "drag (mN/mm)", &|row| row.lift_and_drag_mn_per_mm()[1]),
        ]
    };
    Figure {
        title: format!("{name} – the air along the span, as solved"),
        legend: Vec::new(),
        panels,
        columns: Some(3),
        caption: "Lift across and drag along the stream of each section, one wing.".to_string(),
    }
}

/// Twist of the tip, lift and drag over the phases of the stroke; no panels where it was not solved.
pub fn stroke(summary: &RunSummary) -> Figure {
    let phases = summary.stroke.iter().flat_map(|stroke| &stroke.phases);
    let phases: Vec<_> = phases.collect();
    let curve = |value: &dyn Fn(&crate::wing::stroke::PhaseRow) -> Option<f64>| -> Vec<[f64; 2]> {
        phases
            .iter()
            .filter_map(|row| Some([row.phase_deg, value(row)?]))
            .collect()
    };
    let standing = curve(&|row| row.moving.as_ref()?.standing_tip_twist_deg);
    let x = "stroke phase (deg; 0 is mid-stroke)";
    let charts = [
        (
            "Twist of the tip",
            "twist (deg)",
            vec![curve(&|row| row.tip_twist_deg), standing],
        ),
        (
            "Lift",
            "lift (mN)",
            vec![curve(&|row| Some(row.forces.as_ref()?.lift_mn))],
        ),
        (
            "Drag",
            "drag (mN)",
            vec![curve(&|row| Some(row.forces.as_ref()?.drag_mn))],
        ),
    ];
    let drawn = charts.into_iter().filter(|(_, _, curves)| !curves[0].is_empty());
    let key = |index: usize, label: &str| Key {
        label: label.to_string(),
        sample: Sample::Line(Ink::Curve(index), Weight::Thick),
    };
    let is_moving = phases.iter().any(|row| row.moving.is_some());
    Figure {
        title: format!("{} – over the stroke", summary.name),
        legend: if is_moving {
            vec![
                key(0, "in motion"),
                key(1, "if it stood still under the load of the phase"),
            ]
        } else {
            Vec::new()
        },
        panels: drawn
            .map(|(title, label, curves)| line_chart(title, x, label, curves))
            .collect(),
        columns: Some(3),
        caption: String::new(),
    }
}

fn line_chart(title: &str, x_label: &str, y_label: &str, curves: Vec<Vec<[f64; 2]>>) -> Panel {
    let drawn = curves
        .into_iter()
        .enumerate()
        .filter(|(_, points)| !points.is_empty());
    Panel::Chart(Chart {
        title: title.to_string(),
        x_label: x_label.to_string(),
        x_includes: None,
        y_label: y_label.to_string(),
        marks: drawn
            .map(|(index, points)| Mark::Line {
                points,
                ink: Ink::Curve(index),
                weight: Weight::Thick,
            })
            .collect(),
        has_zero_line: true,
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn lift_is_across_the_stream_and_drag_along_it() {
        let row = StripRow {
            r_mm: 1.0,
            speed_m_s: 2.0,
            alpha_deg: 90.0,
            normal_n_per_m: 3.0,
            tangential_n_per_m: 0.5,
        };
        let [lift, drag] = row.lift_and_drag_mn_per_mm();
        assert!((lift + 0.5).abs() < 1e-12 && (drag - 3.0).abs() < 1e-12);
    }
}
