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
        let (black, grey) = (Ink::Black.colour(), Ink::Grey.colour());
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
        let height = |level: f64| bottom - (bottom - top) * (level - base) / (scale.range[1] - base);
        let title = cut(&self.title, (size[0] - left) / BOLD, TITLE_PX);
        pen.text(
            &title,
            [x0, corner[1] + 9.0],
            Letters::new(TITLE_PX, Align::Left).bold(),
        )?;
        for tick in scale.ticks.iter().filter(|tick| **tick >= base) {
            let y = height(*tick);
            pen.line(&[[x0, y], [x1, y]], plotters::style::RGBColor(228, 228, 228), 0.6)?;
            pen.text(
                &scale.label(*tick),
                [x0 - 6.0, y],
                Letters::new(TICK_PX, Align::Right),
            )?;
        }
        let middle = 0.5 * (top + bottom);
        let y_label = cut(&self.y_label, bottom - top + 20.0, LABEL_PX);
        let upright = Letters::new(LABEL_PX, Align::Centre).upright();
        pen.text(&y_label, [corner[0] + 8.0, middle], upright)?;

        let wide = (x1 - x0) / self.steps.len().max(1) as f64;
        let bar = (0.8 * wide / self.groups.len().max(1) as f64).min(46.0);
        let mut before: Vec<Option<f64>> = vec![None; self.groups.len()];
        for (index, step) in self.steps.iter().enumerate() {
            let centre = x0 + (index as f64 + 0.5) * wide;
            let first = centre - 0.5 * bar * self.groups.len() as f64;
            for (group, level) in step.levels.iter().enumerate() {
                let Some(level) = *level else { continue };
                let from = before[group].filter(|_| !step.is_total).unwrap_or(base);
                let (x, ink) = (first + group as f64 * bar, Ink::Curve(group).colour());
                let (high, low) = (height(level.max(from)), height(level.min(from)));
                // What fell is pale, what is left stands as a line: a fall and a total do not look alike.
                if step.is_total || before[group].is_none() {
                    pen.rectangle([x + 1.5, high], [x + bar - 1.5, low], ink)?;
                } else {
                    let ring = [
                        [x + 1.5, high],
                        [x + bar - 1.5, high],
                        [x + bar - 1.5, low],
                        [x + 1.5, low],
                    ];
                    pen.filled(&ring, ink, 0.3)?;
                    pen.line(
                        &[[x + 1.5, height(level)], [x + bar - 1.5, height(level)]],
                        ink,
                        2.4,
                    )?;
                }
                let text = short(level, 3);
                if width_px(&text, VALUE_PX) < bar + 4.0 {
                    let at = [x + 0.5 * bar, height(level) - 7.0];
                    pen.text(&text, at, Letters::new(VALUE_PX, Align::Centre))?;
                }
                before[group] = Some(level);
            }
            for (line, words) in lines(&step.label, wide - 4.0, TICK_PX).iter().take(2).enumerate() {
                let at = [centre, bottom + 12.0 + 12.0 * line as f64];
                pen.text(words, at, Letters::new(TICK_PX, Align::Centre))?;
            }
        }
        pen.line(&[[x0, top], [x0, bottom]], grey, 0.9)?;
        pen.line(&[[x0, bottom], [x1, bottom]], black, 0.9)
    }
}
