//! A chart: marks over two axes.

use plotters::backend::SVGBackend;
use plotters::chart::ChartBuilder;
use plotters::coord::cartesian::Cartesian2d;
use plotters::drawing::DrawingArea;

use super::error::PlotError;
use super::palette::{Ink, Shape};
use super::pen::{Align, Area, BOLD, Letters, Pen, Spot, UNITS, cut, refused, width_px};
use super::scale::Scale;

/// Marks over two axes.
#[derive(Debug, Clone, PartialEq)]
pub struct Chart {
    /// Title; may be empty.
    pub title: String,
    /// What runs to the right, with its unit.
    pub x_label: String,
    /// What runs upward, with its unit.
    pub y_label: String,
    /// The marks, later ones over earlier ones.
    pub marks: Vec<Mark>,
    /// A place that must lie within the axis, whether anything stands there or not.
    pub x_includes: Option<f64>,
    /// Whether the line y = 0 is shown.
    pub has_zero_line: bool,
}

/// A mark.
#[derive(Debug, Clone, PartialEq)]
pub enum Mark {
    /// An area between a lower and an upper line: `[x, lower, upper]`, x rising.
    Band {
        /// Its edge points.
        points: Vec<[f64; 3]>,
        /// Its colour, which it has a quarter of.
        ink: Ink,
    },
    /// A line through points.
    Line {
        /// The points.
        points: Vec<[f64; 2]>,
        /// Its colour.
        ink: Ink,
        /// Its weight.
        weight: Weight,
    },
    /// A short level line at each point, for what has no neighbours to be joined with.
    Level {
        /// The points.
        points: Vec<[f64; 2]>,
        /// Its colour.
        ink: Ink,
        /// Its weight.
        weight: Weight,
    },
    /// Points with error bars.
    Points {
        /// The points.
        points: Vec<Point>,
        /// Their colour.
        ink: Ink,
        /// Their shape.
        shape: Shape,
        /// Whether they are filled.
        is_filled: bool,
    },
}

/// How strong a line is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Weight {
    /// What stands back.
    Thin,
    /// What matters.
    Thick,
}

impl Weight {
    pub(super) fn px(self) -> f64 {
        match self {
            Weight::Thin => 1.0,
            Weight::Thick => 2.2,
        }
    }
}

/// A measured point.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Point {
    /// Place.
    pub x: f64,
    /// Outer end, if it is a mean over an interval.
    pub x_to: Option<f64>,
    /// Value.
    pub y: f64,
    /// Half the length of its error bar.
    pub sigma: f64,
    /// Whether it is only a bound.
    pub limit: Limit,
}

/// Whether a point is only a bound.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Limit {
    /// It is a value.
    None,
    /// The true value lies at or below it.
    Upper,
    /// The true value lies at or above it.
    Lower,
}

impl Point {
    fn middle(&self) -> f64 {
        self.x_to.map_or(self.x, |to| 0.5 * (self.x + to))
    }
}

impl Mark {
    /// All places and values that must lie within the axes.
    pub(super) fn reach(&self) -> Vec<[f64; 2]> {
        match self {
            Mark::Band { points, .. } => points.iter().flat_map(|[x, a, b]| [[*x, *a], [*x, *b]]).collect(),
            Mark::Line { points, .. } | Mark::Level { points, .. } => points.clone(),
            Mark::Points { points, .. } => {
                let ends = |p: &Point| {
                    let to = p.x_to.unwrap_or(p.x);
                    [[p.x, p.y - p.sigma], [p.x, p.y + p.sigma], [to, p.y]]
                };
                points.iter().flat_map(ends).collect()
            }
        }
    }
}

/// Size of letters, px.
const TITLE_PX: f64 = 12.0;
const LABEL_PX: f64 = 11.0;
const TICK_PX: f64 = 10.0;

/// The plane between the axes of a chart.
type Plane<'a> = DrawingArea<SVGBackend<'a>, Cartesian2d<Scale, Scale>>;

impl Chart {
    /// Refuses numbers that have no place on an axis.
    pub(super) fn check(&self) -> Result<(), PlotError> {
        let finite = self
            .marks
            .iter()
            .flat_map(Mark::reach)
            .flatten()
            .all(f64::is_finite);
        match finite {
            true => Ok(()),
            false => Err(PlotError::NotFinite {
                panel: self.title.clone(),
            }),
        }
    }

    /// Draws it into a box of the paper.
    pub(super) fn draw(&self, area: &Area, corner: Spot, size: Spot) -> Result<(), PlotError> {
        let pen = Pen::on(area);
        let reach: Vec<[f64; 2]> = self.marks.iter().flat_map(Mark::reach).collect();
        let zero = self.has_zero_line.then_some(0.0);
        let y = Scale::around(
            reach.iter().map(|p| p[1]).chain(zero),
            0.06,
            (size[1] / 52.0) as usize,
        );
        let left = 26.0
            + y.ticks
                .iter()
                .map(|t| width_px(&y.label(*t), TICK_PX))
                .fold(0.0, f64::max);
        let places = reach.iter().map(|p| p[0]).chain(self.x_includes);
        let x = Scale::around(places, 0.04, ((size[0] - left) / 62.0) as usize);
        let title = cut(&self.title, size[0] / BOLD, TITLE_PX);
        let overhang = (BOLD * width_px(&title, TITLE_PX) - (size[0] - left)).max(0.0);
        let letters = Letters::new(TITLE_PX, Align::Left).bold();
        pen.text(&title, [corner[0] + left - overhang, corner[1] + 9.0], letters)?;

        let plane = self.axes(area, [corner, size], left, [&x, &y])?;
        let place = |point: [f64; 2]| -> Spot {
            let (x, y) = plane.map_coordinate(&(point[0], point[1]));
            [f64::from(x) / UNITS, f64::from(y) / UNITS]
        };
        if self.has_zero_line {
            let ends = [place([x.range[0], 0.0]), place([x.range[1], 0.0])];
            pen.line(&ends, Ink::Black.colour(), 0.9)?;
        }
        if reach.is_empty() {
            let middle = place([0.5 * (x.range[0] + x.range[1]), 0.5 * (y.range[0] + y.range[1])]);
            pen.text(
                "no numbers",
                middle,
                Letters::new(LABEL_PX, Align::Centre).in_colour(Ink::Grey.colour()),
            )?;
        }
        for mark in &self.marks {
            draw_mark(&pen, mark, &place)?;
        }
        Ok(())
    }

    /// Draws the axes with their grid and labels, `left` px of the box beside them; returns the plane between them.
    fn axes<'a>(
        &self,
        area: &Area<'a>,
        [corner, size]: [Spot; 2],
        left: f64,
        [x, y]: [&Scale; 2],
    ) -> Result<Plane<'a>, PlotError> {
        let title_px = if self.title.is_empty() { 6.0 } else { 20.0 };
        let split = |px: f64| (px * UNITS).round() as i32;
        let panel = area.clone().shrink(
            (split(corner[0]), split(corner[1])),
            (split(size[0]), split(size[1])),
        );
        let (grey, light) = (Ink::Grey.colour(), plotters::style::RGBColor(228, 228, 228));
        let mut chart = ChartBuilder::on(&panel)
            .margin_top(split(title_px))
            .margin_right(split(10.0))
            .x_label_area_size(split(36.0))
            .y_label_area_size(split(left))
            .build_cartesian_2d(x.clone(), y.clone())
            .map_err(refused)?;
        let tick = Letters::new(TICK_PX, Align::Centre).style();
        let desc = Letters::new(LABEL_PX, Align::Centre).style();
        chart
            .configure_mesh()
            .bold_line_style(plotters::style::ShapeStyle::from(light).stroke_width(6))
            .light_line_style(plotters::style::TRANSPARENT)
            .axis_style(plotters::style::ShapeStyle::from(grey).stroke_width(9))
            .set_all_tick_mark_size(split(4.0))
            .x_labels(x.ticks.len())
            .y_labels(y.ticks.len())
            .label_style(tick)
            .axis_desc_style(desc)
            .x_desc(cut(&self.x_label, size[0] - left, LABEL_PX))
            .y_desc(cut(&self.y_label, size[1] - 40.0, LABEL_PX))
            .draw()
            .map_err(refused)?;
        Ok(chart.plotting_area().clone())
    }
}

fn draw_mark(pen: &Pen, mark: &Mark, place: &dyn Fn([f64; 2]) -> Spot) -> Result<(), PlotError> {
    match mark {
        Mark::Band { points, ink } => {
            let lower = points.iter().map(|[x, lower, _]| place([*x, *lower]));
            let upper = points.iter().rev().map(|[x, _, upper]| place([*x, *upper]));
            let ring: Vec<Spot> = lower.chain(upper).collect();
            pen.filled(&ring, ink.colour(), 0.22)
        }
        Mark::Line { points, ink, weight } => {
            let spots: Vec<Spot> = points.iter().copied().map(place).collect();
            pen.line(&spots, ink.colour(), weight.px())
        }
        Mark::Level { points, ink, weight } => points.iter().try_for_each(|point| {
            let [x, y] = place(*point);
            pen.line(&[[x - 9.0, y], [x + 9.0, y]], ink.colour(), weight.px())
        }),
        Mark::Points {
            points,
            ink,
            shape,
            is_filled,
        } => points.iter().try_for_each(|point| {
            let colour = ink.colour();
            let at = place([point.middle(), point.y]);
            let ends = [-point.sigma, point.sigma].map(|off| place([point.middle(), point.y + off]));
            pen.line(&ends, colour, 1.1)?;
            if let Some(to) = point.x_to {
                pen.line(&[place([point.x, point.y]), place([to, point.y])], colour, 1.1)?;
            }
            let way = match point.limit {
                Limit::None => 0.0,
                Limit::Upper => 1.0,
                Limit::Lower => -1.0,
            };
            if way != 0.0 {
                let tip = [at[0], at[1] + way * 20.0];
                pen.line(&[at, tip], colour, 1.1)?;
                pen.line(
                    &[
                        [tip[0] - 4.0, tip[1] - way * 5.0],
                        tip,
                        [tip[0] + 4.0, tip[1] - way * 5.0],
                    ],
                    colour,
                    1.1,
                )?;
            }
            pen.marker(at, *shape, colour, *is_filled)
        }),
    }
}
