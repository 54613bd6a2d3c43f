//! Which numbers of a study stand in one panel, over what, in which mark.

use washout::export::pictures::panels::{Profiles, StudyPanel, panels};
use washout::export::pictures::{compared as picture, in_sigma, residuals};
use washout::input::measurement::{Bound, Channel};
use washout::plot::{Chart, Figure, Ink, Mark, Panel, Weight};

use crate::{case, compared, row, tunnel};

fn labels(panel: &StudyPanel) -> Vec<&str> {
    panel.curves.iter().map(|curve| curve.label.as_str()).collect()
}

fn charts(figure: &Figure) -> Vec<&Chart> {
    let chart = |panel: &Panel| match panel {
        Panel::Chart(chart) => Some(chart.clone()),
        _ => None,
    };
    assert!(figure.panels.iter().all(|panel| chart(panel).is_some()));
    figure
        .panels
        .iter()
        .filter_map(|panel| match panel {
            Panel::Chart(chart) => Some(chart),
            _ => None,
        })
        .collect()
}

#[test]
fn a_sweep_stands_over_the_number_that_takes_most_values_and_the_others_are_curves() {
    let panels = panels(&tunnel(), Profiles::Apart);
    assert_eq!(panels.len(), 1);
    assert_eq!(panels[0].x_label, "speed (m/s)");
    assert_eq!(labels(&panels[0]), ["root angle 1 deg", "root angle 2.5 deg"]);
    for curve in &panels[0].curves {
        let xs: Vec<f64> = curve.places.iter().map(|place| place.x).collect();
        assert_eq!(xs, [10.0, 20.0, 30.0, 40.0]);
    }
}

#[test]
fn a_curve_has_its_name_even_where_it_is_the_only_one_of_its_panel() {
    let mut tunnel = tunnel();
    let held_out = tunnel.rows.iter().filter(|row| row.is_held_out).cloned();
    let second: Vec<_> = held_out.collect();
    tunnel.rows.extend(second.into_iter().map(|mut row| {
        row.channel = Channel::Deflection;
        row
    }));
    let panels = panels(&tunnel, Profiles::Apart);
    assert_eq!(panels.len(), 2);
    assert_eq!(labels(&panels[1]), ["root angle 2.5 deg"]);
}

#[test]
fn cases_read_at_three_stations_stand_over_the_span_each_in_a_panel_or_all_in_one() {
    let (mut cases, mut rows) = (Vec::new(), Vec::new());
    for moment in 1..=3 {
        let case = case(
            "m-{moment}",
            &format!("m-{moment}"),
            &[("moment", "N·m", f64::from(moment))],
            false,
        );
        for r_mm in [70.0, 10.0, 40.0] {
            rows.push(row(&case, Channel::Twist, Some(r_mm), [r_mm; 3]));
        }
        cases.push(case);
    }
    let compared = compared(cases, rows);
    let apart = panels(&compared, Profiles::Apart);
    let titles: Vec<&str> = apart.iter().map(|panel| panel.title.as_str()).collect();
    assert_eq!(titles, ["m-1: twist", "m-2: twist", "m-3: twist"]);
    assert!(
        apart
            .iter()
            .all(|panel| panel.x_label == "distance from the wing base (mm)")
    );
    let xs: Vec<f64> = apart[0].curves[0].places.iter().map(|place| place.x).collect();
    assert_eq!(xs, [10.0, 40.0, 70.0]);
    let together = panels(&compared, Profiles::Together);
    assert_eq!(together.len(), 1);
    assert_eq!(labels(&together[0]), ["m-1", "m-2", "m-3"]);
}

#[test]
fn runs_stations_and_places_on_the_chord_are_curves_of_their_own() {
    let mut tunnel = tunnel();
    tunnel.cases.retain(|case| !case.is_held_out);
    tunnel.rows.retain(|row| !row.is_held_out);
    let mut other = tunnel.rows.clone();
    for row in &mut other {
        row.run = "second".to_string();
        row.r_mm = Some(200.0);
        row.chord_fraction = Some(0.5);
    }
    tunnel.rows.extend(other);
    let panels = panels(&tunnel, Profiles::Apart);
    assert_eq!(
        labels(&panels[0]),
        ["at 450 mm", "at 200 mm, at 0.5 of the chord, run second"]
    );
}

#[test]
fn runs_share_one_model_as_stated_which_knows_nothing_of_them() {
    let mut tunnel = tunnel();
    tunnel.cases.retain(|case| !case.is_held_out);
    tunnel.rows.retain(|row| !row.is_held_out);
    let mut second = tunnel.rows[..2].to_vec();
    for row in &mut second {
        row.run = "second".to_string();
        row.after += 1.0;
    }
    tunnel.rows.extend(second);
    let figure = picture::figure(&tunnel);
    let marks = &charts(&figure)[0].marks;
    let count = |is_it: fn(&Mark) -> bool| marks.iter().filter(|mark| is_it(mark)).count();
    assert_eq!(count(|mark| matches!(mark, Mark::Band { .. })), 1);
    assert_eq!(count(|mark| matches!(mark, Mark::Line { ink: Ink::Grey, .. })), 1);
    assert_eq!(
        count(|mark| matches!(
            mark,
            Mark::Line {
                weight: Weight::Thick,
                ..
            }
        )),
        2
    );
    assert_eq!(count(|mark| matches!(mark, Mark::Points { .. })), 2);
}

#[test]
fn what_has_neither_station_nor_number_is_left_to_the_table() {
    let alone = case("v1", "v1", &[], false);
    let compared = compared(
        vec![alone.clone()],
        vec![row(&alone, Channel::LiftRatio, None, [1.4, 1.2, 1.3])],
    );
    assert!(panels(&compared, Profiles::Apart).is_empty());
    let figure = picture::figure(&compared);
    assert!(
        figure.panels.is_empty() && figure.caption.contains("table of residuals"),
        "{}",
        figure.caption
    );
    assert_eq!(in_sigma::heat_map(&compared).columns, ["lift ratio"]);
}

#[test]
fn a_chart_carries_the_measured_the_stated_and_the_calibrated_numbers() {
    let figure = picture::figure(&tunnel());
    let charts = charts(&figure);
    let marks = &charts[0].marks;
    let twists = |factor: f64, angle: f64| -> Vec<[f64; 2]> {
        [10.0, 20.0, 30.0, 40.0]
            .map(|v| [v, factor * (-angle * v * v / 1000.0)])
            .to_vec()
    };
    for (index, angle) in [1.0, 2.5].into_iter().enumerate() {
        let stated = Mark::Line {
            points: twists(0.8, angle),
            ink: Ink::Grey,
            weight: Weight::Thin,
        };
        let calibrated = Mark::Line {
            points: twists(0.9, angle),
            ink: Ink::Curve(index),
            weight: Weight::Thick,
        };
        assert!(
            marks.contains(&stated) && marks.contains(&calibrated),
            "{marks:?}"
        );
        let band = |mark: &Mark| {
            matches!(mark, Mark::Band { points, .. } if (points[3][2] - points[3][1] - 0.5).abs() < 1e-12
            && (points[3][1] + 0.25 - twists(0.8, angle)[3][1]).abs() < 1e-12)
        };
        assert!(marks.iter().any(band), "{marks:?}");
        let measured = marks.iter().find_map(|mark| match mark {
            Mark::Points {
                points,
                ink,
                is_filled,
                ..
            } if *ink == Ink::Curve(index) => Some((points, *is_filled)),
            _ => None,
        });
        let (points, is_filled) = measured.expect("measured points");
        assert_eq!(is_filled, angle < 2.0, "held out must be hollow");
        let drawn: Vec<[f64; 2]> = points.iter().map(|point| [point.x, point.y]).collect();
        assert_eq!(drawn, twists(1.0, angle));
        assert!(points.iter().all(|point| point.sigma == 0.5));
    }
}

#[test]
fn residuals_are_measured_minus_modelled_before_and_after() {
    let figure = residuals::figure(&tunnel());
    let charts = charts(&figure);
    assert_eq!(charts.len(), 2);
    for (chart, share) in charts.iter().zip([0.2, 0.1]) {
        let Mark::Points { points, .. } = &chart.marks[0] else {
            panic!("{chart:?}")
        };
        let expected: Vec<f64> = [10.0, 20.0, 30.0, 40.0]
            .map(|v: f64| share * -v * v / 1000.0)
            .to_vec();
        assert!(
            points
                .iter()
                .zip(&expected)
                .all(|(point, error)| (point.y - error).abs() < 1e-12),
            "{points:?} {expected:?}"
        );
        assert!(chart.has_zero_line);
    }
}

#[test]
fn the_heat_map_has_errors_in_sigma_nothing_where_nothing_was_measured_and_zero_where_a_bound_holds() {
    let mut tunnel = tunnel();
    tunnel.rows[1].channel = Channel::Deflection;
    tunnel.rows[2].bound = Bound::Upper;
    tunnel.rows[2].before = tunnel.rows[2].measured - 1.0;
    let map = in_sigma::heat_map(&tunnel);
    assert_eq!(map.columns, ["twist", "deflection"]);
    tunnel.rows[3].r_mm = Some(200.0);
    let apart = in_sigma::heat_map(&tunnel).columns;
    assert_eq!(
        apart,
        ["twist at 450 mm", "deflection at 450 mm", "twist at 200 mm"]
    );
    assert_eq!(map.rows[0], ("aero-1-20".to_string(), true));
    assert_eq!(map.rows[7], ("aero-2.5-30".to_string(), false));
    let [stated, calibrated] = map.tables.as_slice() else {
        panic!("{map:?}")
    };
    let twist = -0.4;
    assert!((stated.cells[0][0].unwrap() - 0.2 * twist / 0.5).abs() < 1e-12);
    assert!((calibrated.cells[0][0].unwrap() - 0.1 * twist / 0.5).abs() < 1e-12);
    assert_eq!((stated.cells[0][1], stated.cells[1][0]), (None, None));
    assert_eq!(stated.cells[2][0], Some(0.0));
}
