//! The cutting template of a wing at full size, film, spars and rod, as SVG and as DXF.
//!
//! DXF is the plain ASCII of AutoCAD R12, which every cutter reads; drawn in millimetres. The crate `dxf` 0.6.2 would do it,
//! but it brings forty crates (images, calendars) for these few lines, and writes the hour and random numbers into the file.

use std::fmt::Write;

use crate::geometry::Planform;
use crate::input::design::{Design, Section};
use crate::plot::pen::escaped;

/// Points along a curved edge.
const EDGE_POINTS: usize = 240;
/// Room around the wing, mm.
const MARGIN_MM: f64 = 12.0;

/// What is cut or laid, in millimetres: x from the wing base to the tip, y from the leading edge backward.
#[derive(Debug, Clone, PartialEq)]
pub struct Template {
    /// Name of the wing.
    pub name: String,
    /// Edge of the film, closed.
    pub film: Vec<[f64; 2]>,
    /// Edges of each spar, closed.
    pub spars: Vec<Vec<[f64; 2]>>,
    /// Edges of each piece of rod, closed, and what it is.
    pub rods: Vec<(Vec<[f64; 2]>, String)>,
}

impl Template {
    /// Of a design on its outline.
    pub fn new(design: &Design, planform: &Planform) -> Template {
        let tip_mm = planform.tip_m() * 1e3;
        let trailing = |x_mm: f64| planform.chord_m(x_mm * 1e-3) * 1e3;
        let mut film = vec![[0.0, 0.0], [tip_mm, 0.0]];
        film.extend((0..=EDGE_POINTS).rev().map(|k| {
            let x_mm = tip_mm * k as f64 / EDGE_POINTS as f64;
            [x_mm, trailing(x_mm)]
        }));
        let spar = |spar: &crate::input::design::Spar| {
            let from = spar.at_mm.value();
            let to = spar.trailing_edge_at_mm.as_ref().map_or(from, |at| at.value());
            let half = 0.5 * width_mm(&spar.section);
            let end = trailing(to);
            vec![
                [from - half, 0.0],
                [from + half, 0.0],
                [to + half, end],
                [to - half, end],
            ]
        };
        let rod = |segment: &crate::input::design::RodSegment| {
            let (from, to) = (segment.from_mm.value(), segment.to_mm.value());
            let half = 0.5 * width_mm(&segment.section);
            let ring = vec![[from, -half], [to, -half], [to, half], [from, half]];
            (
                ring,
                format!("{} from {from:.1} to {to:.1} mm", words(&segment.section)),
            )
        };
        Template {
            name: design.name.clone(),
            film,
            spars: design.spar.iter().map(spar).collect(),
            rods: design.rod.iter().map(rod).collect(),
        }
    }

    /// As SVG at full size.
    pub fn to_svg(&self) -> String {
        let [low, high] = self.reach();
        let (width, height) = (
            high[0] - low[0] + 2.0 * MARGIN_MM,
            high[1] - low[1] + 3.0 * MARGIN_MM,
        );
        let [dx, dy] = [MARGIN_MM - low[0], MARGIN_MM - low[1]];
        let mut svg = format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"{width:.3}mm\" height=\"{height:.3}mm\" \
             viewBox=\"0 0 {width:.3} {height:.3}\">\n<title>{} at full size, millimetres</title>\n\
             <g fill=\"none\" stroke-width=\"0.1\" transform=\"translate({dx:.3} {dy:.3})\">\n",
            escaped(&self.name)
        );
        let ring = |points: &[[f64; 2]]| -> String {
            let points: Vec<String> = points.iter().map(|[x, y]| format!("{x:.4},{y:.4}")).collect();
            format!("<polygon points=\"{}\"/>\n", points.join(" "))
        };
        for (layer, colour, rings) in self.layers() {
            let _ = writeln!(svg, "<g id=\"{layer}\" stroke=\"{colour}\">");
            for points in rings {
                svg += &ring(points);
            }
            svg += "</g>\n";
        }
        let foot = high[1] + MARGIN_MM;
        let _ = writeln!(
            svg,
            "<g id=\"scale\" stroke=\"#000\"><path d=\"M0 {foot:.3}h50m0 -2v4m-50 -4v4\"/></g>\n\
             <g id=\"text\" fill=\"#000\" stroke=\"none\" font-family=\"sans-serif\" font-size=\"3\">\n\
             <text x=\"0\" y=\"{:.3}\">50 mm: check before cutting</text>",
            foot + 5.0
        );
        for (index, (points, words)) in self.rods.iter().enumerate() {
            // what begins in the outer half ends at the tip, so that it stays on the page
            let (x, anchor) = match points[0][0] > 0.5 * (low[0] + high[0]) {
                true => (high[0], "end"),
                false => (points[0][0], "start"),
            };
            let _ = writeln!(
                svg,
                "<text x=\"{x:.3}\" y=\"{:.3}\" text-anchor=\"{anchor}\">{}</text>",
                -3.0 - 3.5 * (self.rods.len() - 1 - index) as f64,
                escaped(words)
            );
        }
        svg += "</g>\n</g>\n</svg>\n";
        svg
    }

    /// As DXF (AutoCAD R12 ASCII), y upward from the leading edge's side away from the wing, millimetres.
    pub fn to_dxf(&self) -> String {
        let mut dxf = Dxf(String::new());
        let [low, high] = self.reach();
        dxf.header([low[0], -high[1] - MARGIN_MM], [high[0], -low[1]]);
        dxf.layers();
        dxf.pair(0, "SECTION");
        dxf.pair(2, "ENTITIES");
        for (layer, _, rings) in self.layers() {
            let layer = layer.to_uppercase();
            for points in rings {
                dxf.ring(&layer, points);
            }
        }
        let foot = -high[1] - MARGIN_MM;
        for [from, to] in [
            [[0.0, foot], [50.0, foot]],
            [[0.0, foot - 2.0], [0.0, foot + 2.0]],
            [[50.0, foot - 2.0], [50.0, foot + 2.0]],
        ] {
            dxf.line(from, to);
        }
        for (index, (points, words)) in self.rods.iter().enumerate() {
            dxf.text([points[0][0], 3.0 + 4.0 * index as f64], &plain(words));
        }
        dxf.text([0.0, -high[1] - 6.0], &plain(&self.name));
        dxf.text([52.0, foot - 1.0], "50 mm: check before cutting");
        dxf.pair(0, "ENDSEC");
        dxf.pair(0, "EOF");
        dxf.0
    }

    /// Layers with their colours and closed lines.
    fn layers(&self) -> [Layer<'_>; 3] {
        [
            ("film", "#0072b2", vec![&self.film]),
            ("spars", "#009e73", self.spars.iter().collect()),
            ("rod", "#d55e00", self.rods.iter().map(|(ring, _)| ring).collect()),
        ]
    }

    fn reach(&self) -> [[f64; 2]; 2] {
        let points = self
            .layers()
            .into_iter()
            .flat_map(|(_, _, rings)| rings)
            .flatten();
        points.fold([[f64::INFINITY; 2], [f64::NEG_INFINITY; 2]], |[low, high], p| {
            [
                [low[0].min(p[0]), low[1].min(p[1])],
                [high[0].max(p[0]), high[1].max(p[1])],
            ]
        })
    }
}

/// Name of a layer, its colour, its closed lines.
type Layer<'a> = (&'static str, &'static str, Vec<&'a Vec<[f64; 2]>>);

/// The text of a DXF file.
struct Dxf(String);

impl Dxf {
    fn pair(&mut self, code: u32, value: &str) {
        // group codes stand right-aligned in three columns
        let _ = writeln!(self.0, "{code:>3}\n{value}");
    }

    fn number(&mut self, code: u32, value: f64) {
        self.pair(code, &format!("{value:.4}"));
    }

    fn header(&mut self, low: [f64; 2], high: [f64; 2]) {
        self.pair(999, "full size in millimetres");
        self.pair(0, "SECTION");
        self.pair(2, "HEADER");
        self.pair(9, "$ACADVER");
        self.pair(1, "AC1009");
        for (name, [x, y]) in [("$EXTMIN", low), ("$EXTMAX", high)] {
            self.pair(9, name);
            self.number(10, x);
            self.number(20, y);
        }
        self.pair(0, "ENDSEC");
    }

    fn layers(&mut self) {
        self.pair(0, "SECTION");
        self.pair(2, "TABLES");
        self.pair(0, "TABLE");
        self.pair(2, "LAYER");
        self.pair(70, "4");
        for (name, colour) in [("FILM", "5"), ("SPARS", "3"), ("ROD", "1"), ("TEXT", "7")] {
            self.pair(0, "LAYER");
            self.pair(2, name);
            self.pair(70, "0");
            self.pair(62, colour);
            self.pair(6, "CONTINUOUS");
        }
        self.pair(0, "ENDTAB");
        self.pair(0, "ENDSEC");
    }

    /// A closed line; y of the points is downward.
    fn ring(&mut self, layer: &str, points: &[[f64; 2]]) {
        self.pair(0, "POLYLINE");
        self.pair(8, layer);
        self.pair(66, "1");
        self.pair(70, "1");
        for [x, y] in points {
            self.pair(0, "VERTEX");
            self.pair(8, layer);
            self.number(10, *x);
            self.number(20, -y);
        }
        self.pair(0, "SEQEND");
        self.pair(8, layer);
    }

    fn line(&mut self, from: [f64; 2], to: [f64; 2]) {
        self.pair(0, "LINE");
        self.pair(8, "TEXT");
        for (code, value) in [(10, from[0]), (20, from[1]), (11, to[0]), (21, to[1])] {
            self.number(code, value);
        }
    }

    fn text(&mut self, [x, y]: [f64; 2], words: &str) {
        self.pair(0, "TEXT");
        self.pair(8, "TEXT");
        self.number(10, x);
        self.number(20, y);
        self.pair(40, "3.0");
        self.pair(1, words);
    }
}

/// Width in the plane of the wing, mm; a thin line where only stiffnesses are known.
fn width_mm(section: &Section) -> f64 {
    match section {
        Section::Round { diameter_mm } | Section::HalfRound { diameter_mm, .. } => diameter_mm.value(),
        Section::Tube {
            outer_diameter_mm, ..
        } => outer_diameter_mm.value(),
        Section::Rectangle { width_mm, .. } | Section::Laminate { width_mm, .. } => width_mm.value(),
        Section::Given { .. } => 0.1,
    }
}

fn words(section: &Section) -> String {
    match section {
        Section::Round { diameter_mm } => format!("round {} mm", diameter_mm.value()),
        Section::HalfRound { diameter_mm, .. } => format!("half of a round {} mm", diameter_mm.value()),
        Section::Tube {
            outer_diameter_mm,
            inner_diameter_mm,
        } => format!(
            "tube {} / {} mm",
            outer_diameter_mm.value(),
            inner_diameter_mm.value()
        ),
        Section::Rectangle {
            width_mm,
            thickness_mm,
        } => {
            format!("strip {} x {} mm", width_mm.value(), thickness_mm.value())
        }
        Section::Laminate { width_mm, .. } => format!("laminate {} mm wide", width_mm.value()),
        Section::Given { .. } => "rod".to_string(),
    }
}

/// Without what the plain ASCII of R12 has no letters for.
fn plain(text: &str) -> String {
    text.chars()
        .map(|c| if c.is_ascii() && !c.is_control() { c } else { '?' })
        .collect()
}
