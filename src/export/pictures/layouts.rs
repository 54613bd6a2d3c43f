//! The twist that the best layout makes, with its tolerance, over the wanted one.

use crate::export::ExportError;
use crate::export::layouts::{LayoutSummary, layouts, profile};
use crate::export::run::RunFolder;
use crate::plot::{Chart, Figure, Ink, Key, Mark, Panel, Sample, Weight};

/// Adds `profile.svg`, `profile.csv` and `layouts.csv`; `wanted`: the whole wanted profile, mm and deg.
///
/// # Errors
/// If a file cannot be written, or a number is not finite.
pub fn add(folder: &mut RunFolder, summary: &LayoutSummary, wanted: &[[f64; 2]]) -> Result<(), ExportError> {
    folder.add("profile.svg", figure(summary, wanted).to_svg()?.as_bytes())?;
    folder.add("profile.csv", &profile(summary)?)?;
    folder.add("layouts.csv", &layouts(summary)?)
}

fn figure(summary: &LayoutSummary, wanted: &[[f64; 2]]) -> Figure {
    let band = &summary.band;
    let each = || band.r_mm.iter().zip(&band.twist_deg).zip(&band.tolerance_deg);
    let mut marks = vec![
        Mark::Band {
            points: each()
                .map(|((r, twist), off)| [*r, twist - off, twist + off])
                .collect(),
            ink: Ink::Curve(0),
        },
        Mark::Line {
            points: each().map(|((r, twist), _)| [*r, *twist]).collect(),
            ink: Ink::Curve(0),
            weight: Weight::Thick,
        },
    ];
    let mut legend = vec![Key {
        label: summary
            .layouts
            .first()
            .map_or(String::new(), |best| best.layout.clone()),
        sample: Sample::Band(Ink::Curve(0), Weight::Thick),
    }];
    if !wanted.is_empty() {
        marks.push(Mark::Line {
            points: wanted.to_vec(),
            ink: Ink::Black,
            weight: Weight::Thin,
        });
        legend.push(Key {
            label: "wanted".to_string(),
            sample: Sample::Line(Ink::Black, Weight::Thin),
        });
    }
    Figure {
        title: "Twist that the layout makes".to_string(),
        legend,
        panels: vec![Panel::Chart(Chart {
            title: String::new(),
            x_label: "r (mm)".to_string(),
            y_label: "twist at mid-stroke (deg)".to_string(),
            marks,
            x_includes: None,
            has_zero_line: true,
        })],
        columns: Some(1),
        caption: "Band: tolerance of fabrication, its causes added as if they were independent.".to_string(),
    }
}
