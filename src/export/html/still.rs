//! The wing as a still picture, for readers without scripts and for print: painter's algorithm from the viewer's first view.

use std::fmt::Write;

use crate::page::text::significant;

use super::wing::{Field, MAP, Wing};

const WIDTH: f64 = 720.0;
const HEIGHT: f64 = 300.0;
/// Turn about z and tilt, rad: those of the viewer's first view.
const VIEW: [f64; 2] = [-0.45, 0.5];

/// The picture as SVG, coloured by the wing's first field.
pub fn still(wing: &Wing) -> String {
    let [rest, loaded] =
        [&wing.rest_mm, &wing.loaded_mm].map(|points| points.iter().map(seen).collect::<Vec<_>>());
    let frame = Frame::of(rest.iter().chain(&loaded));
    let [rest, loaded] =
        [rest, loaded].map(|points| points.into_iter().map(|p| frame.place(p)).collect::<Vec<_>>());
    let field = wing.fields.first();
    let (low, high) = ends(field);
    let mut svg = format!(
        "<svg role=\"img\" viewBox=\"0 0 {WIDTH} {HEIGHT}\" style=\"display:block;width:100%\"><title>{}</title>\n\
         <g fill=\"none\" stroke=\"#888\" stroke-dasharray=\"5 4\">\n",
        crate::plot::pen::escaped(&wing.name)
    );
    // Writing to a String cannot fail.
    for [a, b] in outline(&wing.triangles) {
        let _ = write!(svg, "<path d=\"{}\"/>", path(&[rest[a], rest[b]]));
    }
    svg.push_str("</g>\n<g shape-rendering=\"crispEdges\">\n");
    svg.push_str(&coloured(wing, &loaded));
    svg.push_str("</g>\n<g stroke=\"#222\" stroke-linecap=\"round\">\n");
    for &([a, b], part) in &wing.lines {
        let width = if part == 1 { 3.0 } else { 1.4 };
        let _ = write!(
            svg,
            "<path stroke-width=\"{width}\" d=\"{}\"/>",
            path(&[loaded[a], loaded[b]])
        );
    }
    svg.push_str("</g>\n");
    if let Some(field) = field.filter(|_| high > low) {
        svg.push_str(&bar(&format!("{} ({})", field.name, field.unit), low, high));
    }
    svg.push_str("</svg>");
    svg
}

/// The lowest and the highest value.
fn ends(field: Option<&Field>) -> (f64, f64) {
    let values = field.map_or(&[][..], |field| &field.values);
    values
        .iter()
        .fold((f64::INFINITY, f64::NEG_INFINITY), |(low, high), &v| {
            (low.min(v), high.max(v))
        })
}

/// The triangles from the farthest to the nearest.
fn coloured(wing: &Wing, loaded: &[[f64; 3]]) -> String {
    let field = wing.fields.first();
    let (low, high) = ends(field);
    let share = |value: f64| {
        if high > low {
            (value - low) / (high - low)
        } else {
            0.5
        }
    };
    let value = |triangle: usize| match field {
        Some(field) if field.is_on_points => {
            wing.triangles[triangle]
                .iter()
                .map(|&n| field.values[n])
                .sum::<f64>()
                / 3.0
        }
        Some(field) => field.values[triangle],
        None => 0.0,
    };
    let depth = |triangle: &usize| {
        wing.triangles[*triangle]
            .iter()
            .map(|&n| loaded[n][2])
            .sum::<f64>()
    };
    let mut order: Vec<usize> = (0..wing.triangles.len()).collect();
    order.sort_by(|a, b| depth(b).total_cmp(&depth(a)));
    let mut svg = String::new();
    for triangle in order {
        let corners = wing.triangles[triangle].map(|n| loaded[n]);
        let _ = write!(
            svg,
            "<path fill=\"{}\" d=\"{}z\"/>",
            colour(share(value(triangle))),
            path(&corners)
        );
    }
    svg
}

/// To the right, upward, away.
fn seen(point: &[f64; 3]) -> [f64; 3] {
    let ([x, y, z], [turn, tilt]) = (*point, VIEW);
    let (right, away) = (turn.cos() * x - turn.sin() * y, turn.sin() * x + turn.cos() * y);
    [
        right,
        tilt.cos() * z + tilt.sin() * away,
        tilt.cos() * away - tilt.sin() * z,
    ]
}

/// What of the sheet the wing fills.
struct Frame {
    middle: [f64; 2],
    scale: f64,
}

impl Frame {
    fn of<'a>(points: impl Iterator<Item = &'a [f64; 3]>) -> Frame {
        let (mut low, mut high) = ([f64::INFINITY; 2], [f64::NEG_INFINITY; 2]);
        for point in points {
            for k in 0..2 {
                (low[k], high[k]) = (low[k].min(point[k]), high[k].max(point[k]));
            }
        }
        let size = [0, 1].map(|k| (high[k] - low[k]).max(1e-9));
        Frame {
            middle: [0, 1].map(|k| 0.5 * (low[k] + high[k])),
            scale: (0.94 * WIDTH / size[0]).min(0.78 * HEIGHT / size[1]),
        }
    }

    fn place(&self, [right, up, away]: [f64; 3]) -> [f64; 3] {
        [
            0.5 * WIDTH + self.scale * (right - self.middle[0]),
            0.44 * HEIGHT - self.scale * (up - self.middle[1]),
            away,
        ]
    }
}

fn path(points: &[[f64; 3]]) -> String {
    let mut text = String::new();
    for (index, [x, y, _]) in points.iter().enumerate() {
        let _ = write!(text, "{}{x:.1} {y:.1}", if index == 0 { "M" } else { "L" });
    }
    text
}

/// Edges of one triangle only.
pub(super) fn outline(triangles: &[[usize; 3]]) -> Vec<[usize; 2]> {
    let edge = |&[a, b, c]: &[usize; 3]| [[a, b], [b, c], [c, a]].map(|[a, b]| [a.min(b), a.max(b)]);
    let mut edges: Vec<[usize; 2]> = triangles.iter().flat_map(edge).collect();
    edges.sort_unstable();
    let runs = edges.chunk_by(|a, b| a == b).filter(|run| run.len() == 1);
    runs.map(|run| run[0]).collect()
}

/// The colour of a share between the lowest and the highest value.
fn colour(share: f64) -> String {
    let at = share.clamp(0.0, 1.0) * (MAP.len() - 1) as f64;
    let k = (at.floor() as usize).min(MAP.len() - 2);
    let part = at - k as f64;
    let mixed = [0, 1, 2].map(|c| {
        let (from, to) = (f64::from(MAP[k][c]), f64::from(MAP[k + 1][c]));
        (from + part * (to - from)).round() as u8
    });
    format!("#{:02x}{:02x}{:02x}", mixed[0], mixed[1], mixed[2])
}

fn bar(name: &str, low: f64, high: f64) -> String {
    let (left, top, width) = (0.5 * WIDTH - 150.0, HEIGHT - 30.0, 300.0 / 60.0);
    let mut svg = String::from("<g shape-rendering=\"crispEdges\">");
    for k in 0..60 {
        let _ = write!(
            svg,
            "<rect x=\"{}\" y=\"{top}\" width=\"{width}\" height=\"10\" fill=\"{}\"/>",
            left + width * f64::from(k),
            colour((f64::from(k) + 0.5) / 60.0)
        );
    }
    let _ = write!(
        svg,
        "</g>\n<g font-size=\"12\" fill=\"#777\" font-family=\"sans-serif\"><text x=\"{left}\" y=\"{0}\">{1}</text>\
         <text x=\"{2}\" y=\"{0}\" text-anchor=\"middle\">{name}</text>\
         <text x=\"{3}\" y=\"{0}\" text-anchor=\"end\">{4}</text></g>\n",
        top + 25.0,
        significant(low, 3),
        0.5 * WIDTH,
        left + 300.0,
        significant(high, 3)
    );
    svg
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::export::html::wing::tests::wing;

    #[test]
    fn every_triangle_is_drawn_within_the_sheet_and_the_outline_is_the_rim() {
        let wing = wing("w");
        let svg = still(&wing);
        assert_eq!(svg.matches("<path fill=\"#").count(), 2);
        assert_eq!(outline(&wing.triangles), [[0, 1], [0, 2], [1, 3], [2, 3]]);
        assert!(svg.contains("twist (deg)") && !svg.contains("NaN"), "{svg}");
    }

    #[test]
    fn the_ends_of_the_scale_have_the_ends_of_the_map() {
        assert_eq!(
            [colour(-1.0), colour(0.0), colour(1.0)],
            ["#00224e", "#00224e", "#fee838"]
        );
    }
}
