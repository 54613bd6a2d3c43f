//! The SVG itself: the right places, the same bytes, nothing that is no number, nothing off the sheet.

use washout::export::pictures::ladder::{self, Fall, Measure};
use washout::export::pictures::{compared as picture, in_sigma};
use washout::input::measurement::Channel;
use washout::plot::{
    Chart, Figure, HeatMap, HeatTable, Ink, Limit, Mark, Panel, PlotError, Point, Shape, Stair, Step, Weight,
};

use crate::tunnel;

fn chart(marks: Vec<Mark>) -> Figure {
    figure(vec![Panel::Chart(Chart {
        title: "a <b> & c".to_string(),
        x_label: "speed (m/s)".to_string(),
        y_label: "twist (deg)".to_string(),
        marks,
        x_includes: None,
        has_zero_line: false,
    })])
}

fn figure(panels: Vec<Panel>) -> Figure {
    Figure {
        title: "tip < root & \"quoted\"".to_string(),
        legend: Vec::new(),
        panels,
        columns: None,
        caption: String::new(),
    }
}

fn line(points: Vec<[f64; 2]>) -> Mark {
    Mark::Line {
        points,
        ink: Ink::Curve(0),
        weight: Weight::Thick,
    }
}

fn points(at: &[[f64; 2]]) -> Mark {
    let point = |[x, y]: &[f64; 2]| Point {
        x: *x,
        x_to: None,
        y: *y,
        sigma: 0.0,
        limit: Limit::None,
    };
    Mark::Points {
        points: at.iter().map(point).collect(),
        ink: Ink::Curve(1),
        shape: Shape::Square,
        is_filled: false,
    }
}

/// Values of an attribute in all elements of a kind.
fn attributes<'s>(svg: &'s str, element: &str, name: &str) -> Vec<&'s str> {
    let open = format!("<{element} ");
    let key = format!(" {name}=\"");
    svg.split(open.as_str())
        .skip(1)
        .filter_map(|rest| {
            let tag = rest.split('>').next()?;
            // The first attribute has no blank before it, for it was cut off with the element.
            let at = if tag.starts_with(&key[1..]) {
                key.len() - 1
            } else {
                tag.find(&key)? + key.len()
            };
            tag[at..].split('"').next()
        })
        .collect()
}

fn number(text: &str) -> f64 {
    text.parse().unwrap_or_else(|_| panic!("{text:?} is no number"))
}

/// Fails unless the elements are balanced, every coordinate is a number, and all of them lie on the sheet.
fn is_sound(svg: &str) {
    assert!(svg.starts_with("<svg role=\"img\" width=\"") && svg.ends_with("</svg>\n"));
    for wrong in ["NaN", "inf", "-2147483648", "2147483647"] {
        assert!(!svg.contains(wrong), "{wrong} in {svg}");
    }
    let size: Vec<f64> = attributes(svg, "svg", "viewBox")[0]
        .split(' ')
        .map(number)
        .collect();
    let on_sheet = |x: f64, y: f64| {
        assert!(
            (0.0..=size[2]).contains(&x) && (0.0..=size[3]).contains(&y),
            "({x}, {y}) is off the sheet\n{svg}"
        );
    };
    for (element, [x, y]) in [
        ("text", ["x", "y"]),
        ("line", ["x1", "y1"]),
        ("circle", ["cx", "cy"]),
        ("rect", ["x", "y"]),
    ] {
        for (x, y) in attributes(svg, element, x)
            .into_iter()
            .zip(attributes(svg, element, y))
        {
            on_sheet(number(x), number(y));
        }
    }
    for element in ["polyline", "polygon"] {
        for place in attributes(svg, element, "points")
            .iter()
            .flat_map(|points| points.split_whitespace())
        {
            let (x, y) = place.split_once(',').expect("a pair");
            on_sheet(number(x), number(y));
        }
    }
    assert_eq!(svg.matches("<text ").count(), svg.matches("</text>").count());
}

#[test]
fn a_line_stands_where_its_numbers_say() {
    let data = [[10.0, 1.0], [20.0, 3.0], [25.0, -2.0], [40.0, 0.5]];
    let svg = chart(vec![line(data.to_vec())]).to_svg().unwrap();
    is_sound(&svg);
    let drawn = svg
        .split("<polyline ")
        .find(|tag| tag.contains("stroke-width=\"22\""))
        .and_then(|tag| tag.split("points=\"").nth(1)?.split('"').next())
        .expect("the line");
    let spots: Vec<[f64; 2]> = drawn
        .split_whitespace()
        .map(|pair| {
            pair.split_once(',')
                .map(|(x, y)| [number(x), number(y)])
                .expect("a pair")
        })
        .collect();
    assert_eq!(spots.len(), 4);
    for axis in 0..2 {
        let scale = (spots[3][axis] - spots[0][axis]) / (data[3][axis] - data[0][axis]);
        assert!(
            if axis == 0 { scale > 0.0 } else { scale < 0.0 },
            "upward is less in SVG"
        );
        for (spot, value) in spots.iter().zip(&data) {
            let expected = spots[0][axis] + scale * (value[axis] - data[0][axis]);
            // A tenth of a pixel is one unit; the scale has two of them in it.
            assert!((spot[axis] - expected).abs() < 8.0, "{spots:?} {data:?}");
        }
    }
    // And the labels of the ticks belong to the same scale: "20" stands under the second point.
    let ticks = svg.split("<text ").filter(|tag| tag.contains(">\n20\n"));
    let x: Vec<f64> = ticks
        .map(|tag| number(attributes(&format!("<text {tag}"), "text", "x")[0]))
        .collect();
    assert!(x.iter().any(|x| (x - spots[1][0]).abs() < 3.0), "{x:?} {spots:?}");
}

#[test]
fn the_same_figure_gives_the_same_bytes() {
    let figure = picture::figure(&tunnel());
    let first = figure.to_svg().unwrap();
    is_sound(&first);
    assert!((0..3).all(|_| figure.clone().to_svg().unwrap() == first));
    let map = in_sigma::figure(&tunnel()).to_svg().unwrap();
    is_sound(&map);
    assert_eq!(in_sigma::figure(&tunnel()).to_svg().unwrap(), map);
}

#[test]
fn labels_are_escaped() {
    let svg = chart(vec![line(vec![[0.0, 0.0], [1.0, 1.0]])]).to_svg().unwrap();
    assert!(
        svg.contains("a &lt;b&gt; &amp; c") && svg.contains("tip &lt; root &amp; "),
        "{svg}"
    );
    assert!(!svg.contains("<b>"));
    let mut odd = chart(Vec::new());
    odd.title = "bell \u{7} end".to_string();
    let svg = odd.to_svg().unwrap();
    assert!(!svg.contains('\u{7}') && svg.contains("bell"), "{svg}");
}

#[test]
fn nothing_one_point_and_extremes_are_drawn() {
    let empty = chart(Vec::new()).to_svg().unwrap();
    is_sound(&empty);
    assert!(empty.contains("no numbers"));
    is_sound(&figure(Vec::new()).to_svg().unwrap());
    for at in [[0.0, 0.0], [5.0, -1e-9], [1e9, 3e12], [-3.0, 1e-300]] {
        is_sound(&chart(vec![points(&[at])]).to_svg().unwrap());
    }
    let wide = chart(vec![
        points(&[[0.0, -1e12], [1e-12, 1e12]]),
        line(vec![[0.0, 0.0], [1e-12, 5.0]]),
    ]);
    is_sound(&wide.to_svg().unwrap());
}

#[test]
fn a_number_that_has_no_place_is_refused() {
    for wrong in [f64::NAN, f64::INFINITY, f64::NEG_INFINITY] {
        let refused = chart(vec![points(&[[0.0, 1.0], [1.0, wrong]])]).to_svg();
        assert!(matches!(refused, Err(PlotError::NotFinite { .. })), "{refused:?}");
        let map = |cells| {
            figure(vec![Panel::HeatMap(HeatMap {
                title: String::new(),
                rows: vec![("case".to_string(), true)],
                columns: vec!["twist".to_string()],
                tables: vec![HeatTable {
                    title: String::new(),
                    cells,
                }],
            })])
        };
        assert!(matches!(
            map(vec![vec![Some(wrong)]]).to_svg(),
            Err(PlotError::NotFinite { .. })
        ));
        assert!(matches!(
            map(vec![Vec::new()]).to_svg(),
            Err(PlotError::Ragged { .. })
        ));
    }
}

#[test]
fn dots_of_a_stair_are_as_high_as_their_levels_and_the_floor_lies_below() {
    let step = |label: &str, level: f64| Step {
        label: label.to_string(),
        levels: vec![Some(level)],
    };
    let stair = figure(vec![Panel::Stair(Stair {
        title: String::new(),
        y_label: "root mean square error (mm)".to_string(),
        groups: vec!["fitted".to_string()],
        steps: vec![
            step("uncalibrated", 8.0),
            step("calibrated", 4.0),
            step("+ gravity", 3.0),
        ],
        floor: Some(step("noise", 2.0)),
    })]);
    let svg = stair.to_svg().unwrap();
    is_sound(&svg);
    let heights: Vec<f64> = attributes(&svg, "circle", "cy").into_iter().map(number).collect();
    assert_eq!(heights.len(), 3);
    let falls = [heights[1] - heights[0], heights[2] - heights[1]];
    assert!(
        falls[1] > 0.0 && (falls[0] / falls[1] - 4.0).abs() < 0.05,
        "{heights:?}"
    );
    assert!(svg.contains("noise 2.00"), "{svg}");
}

#[test]
fn a_ladder_shows_the_groups_that_it_has() {
    let fall = Fall {
        measure: Measure::RootMeanSquare,
        wing: String::new(),
        channel: Some(Channel::Deflection),
        groups: vec!["fitted".to_string(), "held out".to_string()],
        steps: vec![
            ("uncalibrated".to_string(), vec![Some(22.0), Some(23.0)]),
            ("+ skin-bending".to_string(), vec![Some(2.0), None]),
            ("noise".to_string(), vec![Some(1.7), Some(1.7)]),
        ],
    };
    let svg = ladder::figure("bench", &[fall]).to_svg().unwrap();
    is_sound(&svg);
    for words in [
        "fitted",
        "held out",
        "uncalibrated",
        "+ skin-bending",
        "noise",
        "root mean square error (mm)",
    ] {
        assert!(svg.contains(words), "{words}");
    }
}
