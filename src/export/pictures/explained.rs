//! The first sets of an explanation beside the data: twist along every wing, `explained.svg`.

use crate::explain::Explanation;
use crate::explain::report::{ExplainedSet, ReadingOfSet};
use crate::input::measurement::{Bound, Channel};
use crate::plot::{Chart, Figure, Ink, Key, Limit, Mark, Panel, Point, Sample, Shape, Weight};

/// Sets that are drawn.
const DRAWN: usize = 3;

/// Twist along each wing that was fitted: as measured, as the model stands, and with the first sets; none where no twist is predicted.
pub fn figure(study: &str, found: &Explanation) -> Option<Figure> {
    let first = found.sets.first()?;
    let mut panels: Vec<Panel> = Vec::new();
    let mut cases: Vec<&str> = Vec::new();
    for reading in first.readings.iter().filter(|own| !own.is_held_out) {
        if !cases.contains(&reading.case.as_str()) {
            cases.push(&reading.case);
        }
    }
    for case in cases {
        let marks = marks(found, case);
        if !marks.is_empty() {
            panels.push(Panel::Chart(Chart {
                title: case.to_string(),
                x_label: "distance from the wing base (mm)".to_string(),
                x_includes: Some(0.0),
                y_label: "twist, washout positive (deg)".to_string(),
                marks,
                has_zero_line: true,
            }));
        }
    }
    (!panels.is_empty()).then(|| Figure {
        title: format!("{study} – what would explain it"),
        legend: legend(found),
        panels,
        columns: None,
        caption: "Lines join the stations that are predicted. Rates that were measured are integrated from the base, ± 1 σ.".to_string(),
    })
}

fn legend(found: &Explanation) -> Vec<Key> {
    let key = |label: String, ink: Ink, weight: Weight| Key {
        label,
        sample: Sample::Line(ink, weight),
    };
    let mut keys = vec![
        Key {
            label: "measured, ±1σ".to_string(),
            sample: Sample::Band(Ink::Black, Weight::Thin),
        },
        key("as stated".to_string(), Ink::Grey, Weight::Thick),
    ];
    let sets = found.sets.iter().take(DRAWN).enumerate();
    keys.extend(sets.map(|(place, set)| {
        let label = format!("{}. {}", place + 1, set.name);
        key(label, Ink::Curve(place), Weight::Thick)
    }));
    keys
}

fn marks(found: &Explanation, case: &str) -> Vec<Mark> {
    let Some(first) = found.sets.first() else {
        return Vec::new();
    };
    let stated = predicted(first, case, true);
    if stated.len() < 2 {
        return Vec::new();
    }
    let mut marks = measured(first, case);
    marks.push(Mark::Line {
        points: stated,
        ink: Ink::Grey,
        weight: Weight::Thick,
    });
    for (place, set) in found.sets.iter().take(DRAWN).enumerate() {
        marks.push(Mark::Line {
            points: predicted(set, case, false),
            ink: Ink::Curve(place),
            weight: Weight::Thick,
        });
    }
    marks
}

/// Twist along a wing in flight, as a set predicts it, or as the model stands.
fn predicted(set: &ExplainedSet, case: &str, is_stated: bool) -> Vec<[f64; 2]> {
    let condition = format!("{case} as measured");
    let rows = set
        .forecasts
        .iter()
        .filter(|own| own.condition == condition && own.channel == Channel::Twist);
    let point = |own: &crate::explain::report::Forecast| {
        let value = if is_stated { own.stated } else { own.with_set };
        Some([own.r_mm?, value?])
    };
    rows.filter_map(point).collect()
}

/// What was measured of the twist of a case.
fn measured(set: &ExplainedSet, case: &str) -> Vec<Mark> {
    let rows = || {
        set.readings
            .iter()
            .filter(|own| own.case == case && !own.is_held_out)
    };
    let mut rates: Vec<&ReadingOfSet> = rows().filter(|own| own.channel == Channel::TwistRate).collect();
    rates.sort_by(|a, b| a.r_mm.unwrap_or(0.0).total_cmp(&b.r_mm.unwrap_or(0.0)));
    let mut band = vec![[0.0; 3]];
    let (mut twist, mut variance): (f64, f64) = (0.0, 0.0);
    for own in rates {
        let (Some(from), Some(to)) = (own.r_mm, own.r_to_mm) else {
            continue;
        };
        twist += own.measured * (to - from);
        variance += (own.sigma * (to - from)).powi(2);
        band.push([to, twist - variance.sqrt(), twist + variance.sqrt()]);
    }
    let mut marks = Vec::new();
    if band.len() > 1 {
        marks.push(Mark::Band {
            points: band,
            ink: Ink::Black,
        });
    }
    let twists = rows().filter(|own| own.channel == Channel::Twist);
    let point = |own: &ReadingOfSet| Point {
        x: own.r_mm.unwrap_or(0.0),
        x_to: None,
        y: own.measured,
        sigma: own.sigma,
        limit: match own.bound {
            Bound::None => Limit::None,
            Bound::Upper => Limit::Upper,
            Bound::Lower => Limit::Lower,
        },
    };
    let points: Vec<Point> = twists.map(point).collect();
    if !points.is_empty() {
        marks.push(Mark::Points {
            points,
            ink: Ink::Black,
            shape: Shape::Circle,
            is_filled: true,
        });
    }
    marks
}
