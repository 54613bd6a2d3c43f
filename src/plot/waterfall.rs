//! A waterfall: a number that falls step by step, for several groups of data side by side.

use super::error::PlotError;
use super::palette::Ink;
use super::pen::{Align, Area, BOLD, Letters, Pen, Spot, cut, lines, width_px};
use super::scale::{Scale, short};

/// A number that falls step by step.
#[derive(Debug, Clone, PartialEq)]
pub struct Waterfall {
    /// Title; may be empty.
    pub title: String,
    /// What the height is, with its unit.
    pub y_label: String,
    /// Groups of data; the k-th has the colour of the k-th curve.
    pub groups: Vec<String>,
    /// The steps.
    pub steps: Vec<Step>,
}

/// A step of a waterfall.
#[derive(Debug, Clone, PartialEq)]
pub struct Step {
    /// Its name.
    pub label: String,
    /// Level of each group; none where it has none.
    pub levels: Vec<Option<f64>>,
    /// Whether its bars stand on zero, as a total, rather than hang from the step before.
    pub is_total: bool,
}

const TITLE_PX: f64 = 12.0;
const LABEL_PX: f64 = 11.0;
const TICK_PX: f64 = 10.0;
const VALUE_PX: f64 = 9.0;
const FOOT_PX: f64 = 40.0;

impl Waterfall {
    /// Refuses numbers that have no place on an axis, and steps that do not have a level for each group.
    pub(super) fn check(&self) -> Result<(), PlotError> {
        let levels = || self.steps.iter().flat_map(|step| step.levels.iter().flatten());
        if self
            .steps
            .iter()
            .any(|step| step.levels.len() != self.groups.len())
        {
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
        let levels = self
            .steps
            .iter()
            .flat_map(|step| step.levels.iter().flatten().copied());
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
        self.bars(&pen, &axes)?;
        pen.line(&[[x0, top], [x0, bottom]], Ink::Grey.colour(), 0.9)?;
        pen.line(&[[x0, bottom], [x1, bottom]], Ink::Black.colour(), 0.9)
    }

    fn bars(&self, pen: &Pen, axes: &Axes) -> Result<(), PlotError> {
        let ([x0, x1], [bottom, _]) = (axes.x, axes.y);
        let base = axes.values[0];
        let wide = (x1 - x0) / self.steps.len().max(1) as f64;
        let bar = (0.8 * wide / self.groups.len().max(1) as f64).min(46.0);
        let mut before: Vec<Option<f64>> = vec![None; self.groups.len()];
        for (index, step) in self.steps.iter().enumerate() {
            let centre = x0 + (index as f64 + 0.5) * wide;
            let first = centre - 0.5 * bar * self.groups.len() as f64;
            for (group, level) in step.levels.iter().enumerate() {
                let Some(level) = *level else { continue };
                let from = before[group].filter(|_| !step.is_total).unwrap_or(base);
                let x = first + group as f64 * bar;
                let is_full = step.is_total || before[group].is_none();
                axes.bar(pen, [x, bar], [from, level], Ink::Curve(group), is_full)?;
                before[group] = Some(level);
            }
            for (line, words) in lines(&step.label, wide - 4.0, TICK_PX).iter().take(2).enumerate() {
                let at = [centre, bottom + 12.0 + 12.0 * line as f64];
                pen.text(words, at, Letters::new(TICK_PX, Align::Centre))?;
            }
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

    /// What fell is pale, what is left stands as a line: a fall and a total do not look alike.
    fn bar(
        &self,
        pen: &Pen,
        [x, width]: [f64; 2],
        [from, level]: [f64; 2],
        ink: Ink,
        is_full: bool,
    ) -> Result<(), PlotError> {
        let colour = ink.colour();
        let (high, low) = (self.height(level.max(from)), self.height(level.min(from)));
        let (left, right) = (x + 1.5, x + width - 1.5);
        if is_full {
            pen.rectangle([left, high], [right, low], colour)?;
        } else {
            let ring = [[left, high], [right, high], [right, low], [left, low]];
            pen.filled(&ring, colour, 0.3)?;
            let height = self.height(level);
            pen.line(&[[left, height], [right, height]], colour, 2.4)?;
        }
        let text = short(level, 3);
        if width_px(&text, VALUE_PX) < width + 4.0 {
            let at = [x + 0.5 * width, self.height(level) - 7.0];
            pen.text(&text, at, Letters::new(VALUE_PX, Align::Centre))?;
        }
        Ok(())
    }
}
