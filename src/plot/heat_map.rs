//! A heat map: numbers in standard deviations, by row and column, in tables side by side.

use super::error::PlotError;
use super::palette::{CLASSES, Ink, Shape, class_of, diverging};
use super::pen::{Align, Area, BOLD, Letters, Pen, Spot, cut, width_px};
use super::scale::typeset;

/// Tables with the same rows and columns, side by side.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatMap {
    /// Title; may be empty.
    pub title: String,
    /// Names of the rows, and whether each was fitted (else it was held out).
    pub rows: Vec<(String, bool)>,
    /// Names of the columns.
    pub columns: Vec<String>,
    /// The tables.
    pub tables: Vec<HeatTable>,
}

/// A table of a heat map.
#[derive(Debug, Clone, PartialEq)]
pub struct HeatTable {
    /// Its title.
    pub title: String,
    /// Its numbers, row by row; none where nothing was measured.
    pub cells: Vec<Vec<Option<f64>>>,
}

const TITLE_PX: f64 = 12.0;
const NAME_PX: f64 = 10.0;
const GAP_PX: f64 = 14.0;

/// Sizes that follow from what is to be shown, px.
struct Plan {
    names: f64,
    heads: f64,
    cell: [f64; 2],
    title: f64,
}

impl HeatMap {
    /// Refuses numbers that are not finite, and rows of unequal length.
    pub(super) fn check(&self) -> Result<(), PlotError> {
        let panel = || self.title.clone();
        for table in &self.tables {
            let is_whole = table.cells.len() == self.rows.len()
                && table.cells.iter().all(|row| row.len() == self.columns.len());
            if !is_whole {
                return Err(PlotError::Ragged { panel: panel() });
            }
            if !table
                .cells
                .iter()
                .flatten()
                .flatten()
                .all(|cell| cell.is_finite())
            {
                return Err(PlotError::NotFinite { panel: panel() });
            }
        }
        Ok(())
    }

    /// Height that it needs, px.
    pub(super) fn height_px(&self, width_px: f64) -> f64 {
        let plan = self.plan(width_px);
        plan.title + plan.heads + plan.cell[1] * self.rows.len() as f64 + 30.0
    }

    fn plan(&self, room: f64) -> Plan {
        let longest = |names: &mut dyn Iterator<Item = &str>| {
            names.map(|name| width_px(name, NAME_PX)).fold(0.0, f64::max)
        };
        let names = longest(&mut self.rows.iter().map(|(name, _)| name.as_str())).min(0.35 * room) + 20.0;
        let count = (self.tables.len() * self.columns.len()).max(1) as f64;
        let free = room - names - GAP_PX * self.tables.len() as f64;
        let height = if self.rows.len() > 60 { 11.0 } else { 17.0 };
        Plan {
            names,
            heads: longest(&mut self.columns.iter().map(String::as_str)).min(190.0) + 10.0,
            cell: [(free / count).clamp(4.0, 54.0), height],
            title: 24.0,
        }
    }

    /// Draws it into a box of the paper.
    pub(super) fn draw(&self, area: &Area, corner: Spot, size: Spot) -> Result<(), PlotError> {
        let pen = Pen::on(area);
        let plan = self.plan(size[0]);
        let (black, grey) = (Ink::Black.colour(), Ink::Grey.colour());
        let [left, top] = corner;
        let first_row = top + plan.title + plan.heads;
        let name_px = NAME_PX.min(plan.cell[1] - 2.0);
        for (index, (name, is_fitted)) in self.rows.iter().enumerate() {
            let y = first_row + (index as f64 + 0.5) * plan.cell[1];
            let name = cut(name, plan.names - 20.0, name_px);
            pen.text(
                &name,
                [left + plan.names - 18.0, y],
                Letters::new(name_px, Align::Right),
            )?;
            pen.marker([left + plan.names - 9.0, y], Shape::Circle, black, *is_fitted)?;
        }
        let table_px = plan.cell[0] * self.columns.len() as f64;
        for (place, table) in self.tables.iter().enumerate() {
            let x0 = left + plan.names + place as f64 * (table_px + GAP_PX);
            let title = cut(&table.title, (table_px.max(90.0)) / BOLD, TITLE_PX);
            pen.text(
                &title,
                [x0, top + 9.0],
                Letters::new(TITLE_PX, Align::Left).bold(),
            )?;
            for (column, name) in self.columns.iter().enumerate() {
                let x = x0 + (column as f64 + 0.5) * plan.cell[0];
                let name = cut(name, plan.heads - 8.0, NAME_PX);
                let letters = Letters::new(NAME_PX, Align::Left).upright();
                pen.text(&name, [x, first_row - 5.0], letters)?;
            }
            for (row, cells) in table.cells.iter().enumerate() {
                for (column, cell) in cells.iter().enumerate() {
                    let from = [
                        x0 + column as f64 * plan.cell[0],
                        first_row + row as f64 * plan.cell[1],
                    ];
                    if let Some(value) = cell {
                        draw_cell(&pen, from, plan.cell, *value)?;
                    }
                }
            }
            let to = [x0 + table_px, first_row + self.rows.len() as f64 * plan.cell[1]];
            pen.frame([x0, first_row], to, grey, 0.8)?;
        }
        let below = first_row + self.rows.len() as f64 * plan.cell[1] + 18.0;
        draw_classes(&pen, [left + plan.names, below])
    }
}

fn draw_cell(pen: &Pen, from: Spot, size: [f64; 2], value: f64) -> Result<(), PlotError> {
    let to = [from[0] + size[0], from[1] + size[1]];
    pen.rectangle(from, to, diverging(value))?;
    let text = typeset(&format!("{value:.1}"));
    let letter_px = 9.5_f64.min(size[1] - 2.0);
    if width_px(&text, letter_px) > size[0] - 2.0 {
        return Ok(());
    }
    let is_dark = class_of(value) == CLASSES.len();
    let ink = if is_dark {
        plotters::style::RGBColor(255, 255, 255)
    } else {
        Ink::Black.colour()
    };
    let middle = [0.5 * (from[0] + to[0]), 0.5 * (from[1] + to[1])];
    pen.text(
        &text,
        middle,
        Letters::new(letter_px, Align::Centre).in_colour(ink),
    )
}

/// What the colours mean.
fn draw_classes(pen: &Pen, at: Spot) -> Result<(), PlotError> {
    let classes: [(f64, &str); 9] = [
        (-9.0, "< −5"),
        (-4.0, "−5 … −3"),
        (-2.5, "−3 … −2"),
        (-1.5, "−2 … −1"),
        (0.0, "within 1 σ"),
        (1.5, "1 … 2"),
        (2.5, "2 … 3"),
        (4.0, "3 … 5"),
        (9.0, "> 5"),
    ];
    let mut x = at[0];
    for (value, name) in classes {
        pen.rectangle([x, at[1] - 5.0], [x + 12.0, at[1] + 5.0], diverging(value))?;
        pen.frame([x, at[1] - 5.0], [x + 12.0, at[1] + 5.0], Ink::Grey.colour(), 0.6)?;
        pen.text(name, [x + 16.0, at[1]], Letters::new(9.5, Align::Left))?;
        x += 26.0 + width_px(name, 9.5);
    }
    Ok(())
}

/// Width that the colours' meaning takes, px.
pub(super) const CLASSES_PX: f64 = 500.0;
