//! A number that falls step by step: dots joined by a line for each group of data, and the floor below which it should not get.

use super::error::PlotError;
use super::palette::{Ink, Shape};
use super::pen::{Align, Area, BOLD, Letters, Pen, Spot, cut, lines, width_px};
use super::scale::{Scale, short};

/// A number that falls step by step.
#[derive(Debug, Clone, PartialEq)]
pub struct Stair {
    /// Title; may be empty.
    pub title: String,
    /// What the height is, with its unit.
    pub y_label: String,
    /// Groups of data; the k-th has the colour of the k-th curve.
    pub groups: Vec<String>,
    /// The steps.
    pub steps: Vec<Step>,
    /// The floor, a dashed line; none if there is none.
    pub floor: Option<Step>,
}

/// A step.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Its name.
    pub label: String,
    /// Level of each group; none where it has none.
    pub levels: Vec<Option<f64>>,
}

const TITLE_PX: f64 = 12.0;
const LABEL_PX: f64 = 11.0;
const TICK_PX: f64 = 10.0;
const VALUE_PX: f64 = 9.0;
const FOOT_PX: f64 = 40.0;
/// Between the dots of two groups of one step.
const APART_PX: f64 = 14.0;
/// Dashes of the floor, and the gaps between them.
const DASH_PX: [f64; 2] = [6.0, 4.0];

impl Stair {
    /// Refuses numbers that have no place on an axis, and steps that do not have a level for each group.
    pub(super) fn check(&self) -> Result<(), PlotError> {
        let steps = || self.steps.iter().chain(&self.floor);
        let levels = || steps().flat_map(|step| step.levels.iter().flatten());
        if steps().any(|step| step.levels.len() != self.groups.len()) {
            return Err(PlotError::Ragged {
                panel: self.title.clone(),
            });
        }
        match levels().all(|level| level.is_finite()) {
            true => Ok(()),
            false => Err(PlotError::NotFinite {
                panel: self.title.clone(),
            }),
        }
    }

    /// Draws it into a box of the paper.
    pub(super) fn draw(&self, area: &Area, corner: Spot, size: Spot) -> Result<(), PlotError> {
        let pen = Pen::on(area);
        let steps = self.steps.iter().chain(&self.floor);
        let levels = steps.flat_map(|step| step.levels.iter().flatten().copied());
        let scale = Scale::around(levels.chain([0.0]), 0.08, (size[1] / 55.0) as usize);
        let left = 26.0
            + scale
                .ticks
                .iter()
                .map(|t| width_px(&scale.label(*t), TICK_PX))
                .fold(0.0, f64::max);
        let (x0, x1) = (corner[0] + left, corner[0] + size[0] - 10.0);
        let (top, bottom) = (corner[1] + 22.0, corner[1] + size[1] - FOOT_PX);
        let base = scale.range[0].max(0.0).min(scale.range[1]);
        let axes = Axes {
            x: [x0, x1],
            y: [bottom, top],
            values: [base, scale.range[1]],
        };
        let title = cut(&self.title, (size[0] - left) / BOLD, TITLE_PX);
        pen.text(
            &title,
            [x0, corner[1] + 9.0],
            Letters::new(TITLE_PX, Align::Left).bold(),
        )?;
        axes.grid(&pen, &scale)?;
        let middle = 0.5 * (top + bottom);
        let y_label = cut(&self.y_label, bottom - top + 20.0, LABEL_PX);
        let upright = Letters::new(LABEL_PX, Align::Centre).upright();
        pen.text(&y_label, [corner[0] + 8.0, middle], upright)?;
        self.floor(&pen, &axes)?;
        self.dots(&pen, &axes)?;
        pen.line(&[[x0, top], [x0, bottom]], Ink::Grey.colour(), 0.9)?;
        pen.line(&[[x0, bottom], [x1, bottom]], Ink::Black.colour(), 0.9)
    }

    /// Across of the dot of a group at a step.
    fn across(&self, axes: &Axes, step: usize, group: usize) -> f64 {
        let wide = (axes.x[1] - axes.x[0]) / self.steps.len().max(1) as f64;
        let off = group as f64 - 0.5 * (self.groups.len() as f64 - 1.0);
        axes.x[0] + (step as f64 + 0.5) * wide + off * APART_PX
    }

    fn dots(&self, pen: &Pen, axes: &Axes) -> Result<(), PlotError> {
        for group in 0..self.groups.len() {
            let level = |(index, step): (usize, &Step)| {
                let level = step.levels[group]?;
                Some([self.across(axes, index, group), axes.height(level)])
            };
            let spots: Vec<Spot> = self.steps.iter().enumerate().filter_map(level).collect();
            let colour = Ink::Curve(group).colour();
            pen.line(&spots, colour, 1.6)?;
            for spot in spots {
                pen.marker(spot, Shape::Circle, colour, true)?;
            }
        }
        let wide = (axes.x[1] - axes.x[0]) / self.steps.len().max(1) as f64;
        for (index, step) in self.steps.iter().enumerate() {
            self.values(pen, axes, (index, step))?;
            let centre = axes.x[0] + (index as f64 + 0.5) * wide;
            for (line, words) in lines(&step.label, wide - 4.0, TICK_PX).iter().take(2).enumerate() {
                let at = [centre, axes.y[0] + 12.0 + 12.0 * line as f64];
                pen.text(words, at, Letters::new(TICK_PX, Align::Centre))?;
            }
        }
        Ok(())
    }

    /// The levels of a step as numbers: the highest above its dot, the lowest below, what is between to the side.
    fn values(&self, pen: &Pen, axes: &Axes, (index, step): (usize, &Step)) -> Result<(), PlotError> {
        let known = step.levels.iter().enumerate();
        let mut known: Vec<(usize, f64)> = known
            .filter_map(|(group, level)| Some((group, (*level)?)))
            .collect();
        known.sort_by(|a, b| b.1.total_cmp(&a.1));
        let last = known.len().saturating_sub(1);
        for (rank, &(group, level)) in known.iter().enumerate() {
            let (x, y) = (self.across(axes, index, group), axes.height(level));
            let is_left = 2 * group + 1 < self.groups.len();
            // below there would be the names of the steps
            let is_low = y + 18.0 > axes.y[0];
            let (at, align) = match rank {
                0 => ([x, y - 11.0], Align::Centre),
                rank if rank == last && !is_low => ([x, y + 12.0], Align::Centre),
                _ if is_left => ([x - 8.0, y], Align::Right),
                _ => ([x + 8.0, y], Align::Left),
            };
            let letters = Letters::new(VALUE_PX, align).in_colour(Ink::Curve(group).colour());
            pen.text(&short(level, 3), at, letters)?;
        }
        Ok(())
    }

    /// The floor of each group; those that are alike are drawn once.
    fn floor(&self, pen: &Pen, axes: &Axes) -> Result<(), PlotError> {
        let Some(floor) = &self.floor else {
            return Ok(());
        };
        let mut drawn: Vec<f64> = Vec::new();
        for (group, level) in floor.levels.iter().enumerate() {
            let Some(level) = *level else { continue };
            if drawn.iter().any(|known| short(*known, 3) == short(level, 3)) {
                continue;
            }
            let is_one = floor
                .levels
                .iter()
                .flatten()
                .all(|other| short(*other, 3) == short(level, 3));
            let colour = if is_one { Ink::Grey } else { Ink::Curve(group) }.colour();
            let ([x0, x1], y) = (axes.x, axes.height(level));
            let [dash, gap] = DASH_PX;
            let mut x = x0;
            while x < x1 {
                pen.line(&[[x, y], [(x + dash).min(x1), y]], colour, 1.2)?;
                x += dash + gap;
            }
            let words = format!("{} {}", floor.label, short(level, 3));
            let letters = Letters::new(VALUE_PX, Align::Left).in_colour(colour);
            pen.text(&words, [x0 + 4.0, y - 7.0 - 10.0 * drawn.len() as f64], letters)?;
            drawn.push(level);
        }
        Ok(())
    }
}

/// Where the axes lie on the paper.
struct Axes {
    /// From left to right.
    x: [f64; 2],
    /// From bottom to top.
    y: [f64; 2],
    /// What the bottom and the top stand for.
    values: [f64; 2],
}

impl Axes {
    fn height(&self, level: f64) -> f64 {
        let ([bottom, top], [base, highest]) = (self.y, self.values);
        bottom - (bottom - top) * (level - base) / (highest - base)
    }

    fn grid(&self, pen: &Pen, scale: &Scale) -> Result<(), PlotError> {
        let [x0, x1] = self.x;
        for tick in scale.ticks.iter().filter(|tick| **tick >= self.values[0]) {
            let y = self.height(*tick);
            pen.line(&[[x0, y], [x1, y]], plotters::style::RGBColor(228, 228, 228), 0.6)?;
            pen.text(
                &scale.label(*tick),
                [x0 - 6.0, y],
                Letters::new(TICK_PX, Align::Right),
            )?;
        }
        Ok(())
    }
}
