//! Model against measurement: `compared.svg`.

use crate::compare::StudyRow;
use crate::input::measurement::Bound;
use crate::plot::{Chart, Figure, Ink, Key, Limit, Mark, Panel, Point, Sample, Shape, Weight};

use super::panels::{Compared, Curve, Placed, Profiles, StudyPanel, distinct, panels, read_words};
use super::{with_unit, words};

/// Model against measurement, panel by panel.
pub fn figure(compared: &Compared) -> Figure {
    let panels = panels(compared, Profiles::Apart);
    let curves = Looks::of(&panels);
    Figure {
        title: headline(compared),
        legend: legend(compared, &curves),
        panels: panels
            .iter()
            .map(|panel| chart(compared, panel, &curves))
            .collect(),
        columns: None,
        caption: caption(compared),
    }
}

/// Name and title.
pub(super) fn headline(compared: &Compared) -> String {
    match compared.title.as_str() {
        "" => compared.name.clone(),
        title => format!("{}: {title}", compared.name),
    }
}

/// Which colour and shape a curve has: one for each label, the same in all panels.
pub(super) struct Looks {
    labels: Vec<String>,
}

impl Looks {
    pub fn of(panels: &[StudyPanel]) -> Looks {
        let labels = panels
            .iter()
            .flat_map(|panel| panel.curves.iter().map(|curve| curve.label.clone()));
        Looks {
            labels: distinct(labels),
        }
    }

    pub fn ink(&self, curve: &Curve) -> Ink {
        Ink::Curve(self.index(curve))
    }

    pub fn shape(&self, curve: &Curve) -> Shape {
        Shape::of_curve(self.index(curve))
    }

    fn index(&self, curve: &Curve) -> usize {
        self.labels
            .iter()
            .position(|label| *label == curve.label)
            .unwrap_or(0)
    }

    /// Entries that name the curves; none where there is one look only.
    pub fn keys(&self) -> Vec<Key> {
        if self.labels.len() < 2 {
            return Vec::new();
        }
        let key = |(index, label): (usize, &String)| Key {
            label: if label.is_empty() {
                "the only curve of its panel"
            } else {
                label
            }
            .to_string(),
            sample: Sample::Marker(Ink::Curve(index), Shape::of_curve(index), true),
        };
        self.labels.iter().enumerate().map(key).collect()
    }

    /// Colour of what stands for all curves in a legend.
    pub fn common(&self) -> Ink {
        if self.labels.len() < 2 {
            Ink::Curve(0)
        } else {
            Ink::Black
        }
    }
}

/// Entries for fitted and held-out points, as far as there are such.
pub(super) fn use_keys(compared: &Compared, ink: Ink) -> Vec<Key> {
    let has = |is_held_out: bool| compared.rows.iter().any(|row| row.is_held_out == is_held_out);
    let key = |label: &str, is_filled: bool| Key {
        label: label.to_string(),
        sample: Sample::Marker(ink, Shape::Circle, is_filled),
    };
    match (compared.is_calibrated || has(true), has(false), has(true)) {
        (false, _, _) => vec![key("measured", true)],
        (true, true, true) => vec![key("measured, fitted", true), key("measured, held out", false)],
        (true, true, false) => vec![key("measured, fitted", true)],
        (true, false, _) => vec![key("measured, held out", false)],
    }
}

fn legend(compared: &Compared, curves: &Looks) -> Vec<Key> {
    let mut keys = curves.keys();
    keys.extend(use_keys(compared, curves.common()));
    let has_inputs = compared.rows.iter().any(|row| row.sigma_of_inputs > 0.0);
    let line = |label: &str, sample: Sample| Key {
        label: label.to_string(),
        sample,
    };
    let stated = if has_inputs {
        line(
            "uncalibrated model, ±1σ of its inputs",
            Sample::Band(Ink::Grey, Weight::Thin),
        )
    } else {
        line("uncalibrated model", Sample::Line(Ink::Grey, Weight::Thin))
    };
    if compared.is_calibrated {
        keys.push(stated);
        keys.push(line(
            "model calibrated",
            Sample::Line(curves.common(), Weight::Thick),
        ));
    } else {
        keys.push(line(
            "uncalibrated model",
            Sample::Line(curves.common(), Weight::Thick),
        ));
    }
    keys
}

fn caption(compared: &Compared) -> String {
    let mut text = read_words(compared);
    text.push_str("Error bars: one standard deviation of the measurement. Lines join what was solved.");
    if compared.rows.iter().any(|row| row.bound != Bound::None) {
        text.push_str(" An arrow: the measured number is only a bound.");
    }
    let placed: usize = panels(compared, Profiles::Apart)
        .iter()
        .flat_map(|panel| &panel.curves)
        .map(|curve| curve.places.len())
        .sum();
    if placed < compared.rows.len() {
        text.push_str(" Numbers of the whole wing stand in the table of residuals only.");
    }
    text
}

fn chart(compared: &Compared, panel: &StudyPanel, curves: &Looks) -> Panel {
    let mut marks = Vec::new();
    if compared.is_calibrated {
        for curve in stated(panel) {
            marks.extend(spread(compared, &curve));
            marks.extend(model(compared, &curve, |row| row.before, Ink::Grey, Weight::Thin));
        }
    }
    for curve in &panel.curves {
        marks.extend(model(
            compared,
            curve,
            |row| row.after,
            curves.ink(curve),
            Weight::Thick,
        ));
    }
    for curve in &panel.curves {
        marks.extend(measured(compared, curve, curves));
    }
    Panel::Chart(Chart {
        title: panel.title.clone(),
        x_label: panel.x_label.clone(),
        x_includes: panel.x_includes,
        y_label: with_unit(&words(panel.channel), panel.channel.unit()),
        marks,
        has_zero_line: false,
    })
}

/// The curves of the uncalibrated model: one for all runs, for it does not know of them.
fn stated(panel: &StudyPanel) -> Vec<Curve> {
    let kins = distinct(panel.curves.iter().map(|curve| curve.kin.clone()));
    let merged = kins.into_iter().map(|kin| {
        let of_kin = panel.curves.iter().filter(|curve| curve.kin == kin);
        let mut places: Vec<Placed> = of_kin.flat_map(|curve| curve.places.clone()).collect();
        places.sort_by(|a, b| a.x.total_cmp(&b.x));
        places.dedup_by(|a, b| a.x == b.x && a.x_to == b.x_to);
        Curve {
            label: kin.clone(),
            kin,
            places,
        }
    });
    merged.collect()
}

/// What the priors of the inputs allow the uncalibrated model: a band, or a stroke where there is nothing to join.
fn spread(compared: &Compared, curve: &Curve) -> Vec<Mark> {
    let ends = |place: &Placed| {
        let row = &compared.rows[place.row];
        [row.before - row.sigma_of_inputs, row.before + row.sigma_of_inputs]
    };
    if curve
        .places
        .iter()
        .all(|place| compared.rows[place.row].sigma_of_inputs == 0.0)
    {
        return Vec::new();
    }
    let ink = Ink::Grey;
    let edge = |x: f64, [low, high]: [f64; 2]| [x, low, high];
    if is_line(curve) {
        let points = curve
            .places
            .iter()
            .map(|place| edge(place.x, ends(place)))
            .collect();
        return vec![Mark::Band { points, ink }];
    }
    let mark = |place: &Placed| match place.x_to {
        Some(to) => Mark::Band {
            points: vec![edge(place.x, ends(place)), edge(to, ends(place))],
            ink,
        },
        None => Mark::Line {
            points: ends(place).map(|y| [place.x, y]).to_vec(),
            ink,
            weight: Weight::Thin,
        },
    };
    curve.places.iter().map(mark).collect()
}

/// Whether a curve has two places to draw a line between.
fn is_line(curve: &Curve) -> bool {
    curve.places.iter().any(|place| place.x != curve.places[0].x)
        && curve.places.iter().all(|p| p.x_to.is_none())
}

/// The model of a curve: a line, or level strokes where there is nothing to join.
fn model(
    compared: &Compared,
    curve: &Curve,
    value: fn(&StudyRow) -> f64,
    ink: Ink,
    weight: Weight,
) -> Vec<Mark> {
    let at = |place: &Placed| [place.x, value(&compared.rows[place.row])];
    if is_line(curve) {
        let points = curve.places.iter().map(at).collect();
        return vec![Mark::Line { points, ink, weight }];
    }
    let mark = |place: &Placed| match place.x_to {
        Some(to) => Mark::Line {
            points: vec![at(place), [to, at(place)[1]]],
            ink,
            weight,
        },
        None => Mark::Level {
            points: vec![at(place)],
            ink,
            weight,
        },
    };
    curve.places.iter().map(mark).collect()
}

/// The measured points of a curve, fitted and held out apart.
fn measured(compared: &Compared, curve: &Curve, curves: &Looks) -> Vec<Mark> {
    let marks = [true, false].map(|is_fitted| {
        let of_use = curve
            .places
            .iter()
            .filter(|p| compared.rows[p.row].is_held_out != is_fitted);
        Mark::Points {
            points: of_use
                .map(|place| point(place, &compared.rows[place.row], |row| row.measured))
                .collect(),
            ink: curves.ink(curve),
            shape: curves.shape(curve),
            is_filled: is_fitted,
        }
    });
    let is_empty = |mark: &Mark| matches!(mark, Mark::Points { points, .. } if points.is_empty());
    marks.into_iter().filter(|mark| !is_empty(mark)).collect()
}

/// A number at its place with its error bar.
pub(super) fn point(place: &Placed, row: &StudyRow, value: impl Fn(&StudyRow) -> f64) -> Point {
    Point {
        x: place.x,
        x_to: place.x_to,
        y: value(row),
        sigma: row.sigma,
        limit: match row.bound {
            Bound::None => Limit::None,
            Bound::Upper => Limit::Upper,
            Bound::Lower => Limit::Lower,
        },
    }
}
