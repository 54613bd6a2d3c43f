//! The front between lift and efficiency, and the profiles at its ends.

use crate::export::ExportError;
use crate::export::csv::table;
use crate::export::pareto::{Front, ParetoSummary, fronts, untwisted};
use crate::export::run::RunFolder;
use crate::plot::{Chart, Figure, Ink, Key, Limit, Mark, Panel, Point, Sample, Shape, Weight};

/// Adds `front.svg`, `profiles.svg` and the tables.
///
/// # Errors
/// If a file cannot be written, or a number is not finite.
pub fn add(folder: &mut RunFolder, summary: &ParetoSummary) -> Result<(), ExportError> {
    folder.add("front.svg", front(summary).to_svg()?.as_bytes())?;
    folder.add("front.csv", &fronts(summary)?)?;
    folder.add("untwisted.csv", &untwisted(summary)?)?;
    folder.add("profiles.svg", profiles(summary).to_svg()?.as_bytes())?;
    if let Some(front) = summary.fronts.last() {
        let ends = [
            ("highest-lift.csv", front.highest_lift()),
            ("highest-efficiency.csv", front.highest_efficiency()),
        ];
        for (name, profile) in ends {
            if let Some(profile) = profile {
                folder.add(name, &table(&["r_mm", "twist_deg"], &profile.points())?)?;
            }
        }
    }
    Ok(())
}

/// Lift against efficiency, a panel for each front.
pub fn front(summary: &ParetoSummary) -> Figure {
    let mut legend = vec![
        Key {
            label: "front over twist profiles".to_string(),
            sample: Sample::Line(Ink::Curve(0), Weight::Thick),
        },
        Key {
            label: "no twist, other stops".to_string(),
            sample: Sample::Line(Ink::Grey, Weight::Thin),
        },
    ];
    legend.extend(summary.marks.iter().enumerate().map(|(index, mark)| Key {
        label: mark.name.clone(),
        sample: Sample::Dot(Ink::Curve(index + 1), Shape::of_curve(index), true),
    }));
    Figure {
        title: "Front between lift and efficiency".to_string(),
        legend,
        panels: summary
            .fronts
            .iter()
            .enumerate()
            .map(|(index, front)| front_panel(summary, index, front))
            .collect(),
        columns: None,
        caption: format!(
            "Efficiency: {}. {:.1} Hz, ±{:.1} deg, every wing at the same stroke.",
            summary.efficiency, summary.frequency_hz, summary.half_amplitude_deg
        ),
    }
}

/// A front with the marked wings, whose lift over it is the one at `index`.
fn front_panel(summary: &ParetoSummary, index: usize, front: &Front) -> Panel {
    let lowest = front
        .points
        .iter()
        .map(|p| p.lift)
        .fold(f64::INFINITY, f64::min)
        .min(0.5);
    let stops: Vec<[f64; 2]> = summary
        .untwisted
        .iter()
        .filter(|p| p.lift > lowest && p.stop_deg <= summary.stop_angle_deg + 1e-9)
        .map(|p| [p.lift, p.efficiency])
        .collect();
    let mut marks = vec![
        Mark::Line {
            points: stops,
            ink: Ink::Grey,
            weight: Weight::Thin,
        },
        Mark::Line {
            points: front.points.iter().map(|p| [p.lift, p.efficiency]).collect(),
            ink: Ink::Curve(0),
            weight: Weight::Thick,
        },
    ];
    marks.extend(
        summary
            .marks
            .iter()
            .enumerate()
            .map(|(place, mark)| Mark::Points {
                points: vec![Point {
                    x: mark.lift[index],
                    x_to: None,
                    y: mark.efficiency,
                    sigma: 0.0,
                    limit: Limit::None,
                }],
                ink: Ink::Curve(place + 1),
                shape: Shape::of_curve(place),
                is_filled: true,
            }),
    );
    Panel::Chart(Chart {
        title: front.name.clone(),
        x_label: "lift over the untwisted wing".to_string(),
        y_label: "efficiency over the untwisted wing".to_string(),
        marks,
        x_includes: None,
        has_zero_line: false,
    })
}

/// Twist along the span at the ends of each front, beside the named wings.
pub fn profiles(summary: &ParetoSummary) -> Figure {
    let mut legend = vec![
        Key {
            label: "highest lift".to_string(),
            sample: Sample::Line(Ink::Curve(0), Weight::Thick),
        },
        Key {
            label: "highest efficiency".to_string(),
            sample: Sample::Line(Ink::Curve(1), Weight::Thick),
        },
    ];
    legend.extend(summary.marks.iter().enumerate().map(|(index, mark)| Key {
        label: mark.name.clone(),
        sample: Sample::Line(Ink::Curve(index + 2), Weight::Thin),
    }));
    let panel = |front: &Front| {
        let ends = [front.highest_lift(), front.highest_efficiency()]
            .into_iter()
            .enumerate();
        let mut marks: Vec<Mark> = summary
            .marks
            .iter()
            .enumerate()
            .map(|(index, mark)| Mark::Line {
                points: mark.profile.clone(),
                ink: Ink::Curve(index + 2),
                weight: Weight::Thin,
            })
            .collect();
        marks.extend(ends.filter_map(|(index, profile)| {
            Some(Mark::Line {
                points: profile?.points(),
                ink: Ink::Curve(index),
                weight: Weight::Thick,
            })
        }));
        Panel::Chart(Chart {
            title: front.name.clone(),
            x_label: "r (mm)".to_string(),
            y_label: "twist at mid-stroke (deg)".to_string(),
            marks,
            x_includes: None,
            has_zero_line: true,
        })
    };
    Figure {
        title: "Twist profiles at the ends of the front".to_string(),
        legend,
        panels: summary.fronts.iter().map(panel).collect(),
        columns: None,
        caption: String::new(),
    }
}
