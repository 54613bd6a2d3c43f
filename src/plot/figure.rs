//! A figure: title, legend, panels in columns, caption.

use super::chart::{Chart, Weight};
use super::error::PlotError;
use super::heat_map::{CLASSES_PX, HeatMap};
use super::palette::{Ink, Shape};
use super::pen::{Align, Area, BOLD, Letters, Pen, Spot, lines, on_paper, width_px};
use super::stair::Stair;

/// A figure.
#[derive(Debug, Clone, PartialEq)]
pub struct Figure {
    /// Title.
    pub title: String,
    /// What the marks mean.
    pub legend: Vec<Key>,
    /// The panels, row by row.
    pub panels: Vec<Panel>,
    /// Columns of panels; as many as suit their number where none is given.
    pub columns: Option<usize>,
    /// Caption below; may be empty.
    pub caption: String,
}

/// What a mark means.
#[derive(Debug, Clone, PartialEq)]
pub struct Key {
    /// The meaning.
    pub label: String,
    /// The mark.
    pub sample: Sample,
}

/// A mark in a legend.
#[derive(Debug, Clone, Copy, PartialEq)]
pub enum Sample {
    /// A line.
    Line(Ink, Weight),
    /// A line within a band.
    Band(Ink, Weight),
    /// A marker with its error bar; filled or not.
    Marker(Ink, Shape, bool),
    /// A marker without error bar; filled or not.
    Dot(Ink, Shape, bool),
    /// A colour.
    Swatch(Ink),
}

/// A panel.
#[derive(Debug, Clone, PartialEq)]
pub enum Panel {
    /// Marks over two axes.
    Chart(Chart),
    /// Numbers in standard deviations by row and column.
    HeatMap(HeatMap),
    /// A number that falls step by step.
    Stair(Stair),
}

const MARGIN_PX: f64 = 14.0;
const TITLE_PX: f64 = 15.0;
const KEY_PX: f64 = 11.0;
const CAPTION_PX: f64 = 10.0;

impl Figure {
    /// The figure as SVG, the same bytes for the same figure.
    ///
    /// # Errors
    /// If a number is not finite, or a table not rectangular.
    pub fn to_svg(&self) -> Result<String, PlotError> {
        for panel in &self.panels {
            match panel {
                Panel::Chart(chart) => chart.check()?,
                Panel::HeatMap(map) => map.check()?,
                Panel::Stair(stair) => stair.check()?,
            }
        }
        let sheet = Sheet::of(self);
        on_paper(sheet.size[0], sheet.size[1], &self.title, |area| {
            sheet.draw(self, area)
        })
    }
}

/// Where everything goes, px.
struct Sheet {
    size: Spot,
    title: Vec<String>,
    legend: Vec<Spot>,
    panels: Vec<(Spot, Spot)>,
    caption: Vec<String>,
    caption_top: f64,
}

impl Sheet {
    fn of(figure: &Figure) -> Sheet {
        let charts = figure
            .panels
            .iter()
            .filter(|p| !matches!(p, Panel::HeatMap(_)))
            .count();
        let suited = match charts {
            0 | 1 => 1,
            2..=4 => 2,
            _ => 3,
        };
        let columns = figure.columns.unwrap_or(suited).max(1);
        let cell = match columns {
            1 => [660.0, 400.0],
            2 => [440.0, 310.0],
            _ => [350.0, 270.0],
        };
        let inner = columns as f64 * cell[0];
        let title = lines(&figure.title, inner / BOLD, TITLE_PX);
        let mut y = MARGIN_PX + 20.0 * title.len() as f64;
        let (legend, legend_px) = legend_places(&figure.legend, [MARGIN_PX, y], inner);
        y += legend_px + 6.0;
        let (panels, y) = panel_places(&figure.panels, columns, cell, y);
        let caption = lines(&figure.caption, inner, CAPTION_PX);
        let caption_top = y + 6.0;
        let bottom = if caption.is_empty() {
            y
        } else {
            caption_top + 14.0 * caption.len() as f64
        };
        Sheet {
            size: [(inner + 2.0 * MARGIN_PX).round(), (bottom + MARGIN_PX).round()],
            title,
            legend,
            panels,
            caption,
            caption_top,
        }
    }

    fn draw(&self, figure: &Figure, area: &Area) -> Result<(), PlotError> {
        let pen = Pen::on(area);
        for (index, line) in self.title.iter().enumerate() {
            let at = [MARGIN_PX, MARGIN_PX + 8.0 + 20.0 * index as f64];
            pen.text(line, at, Letters::new(TITLE_PX, Align::Left).bold())?;
        }
        for (key, at) in figure.legend.iter().zip(&self.legend) {
            draw_key(&pen, key, *at)?;
        }
        for (panel, (corner, size)) in figure.panels.iter().zip(&self.panels) {
            match panel {
                Panel::Chart(chart) => chart.draw(area, *corner, *size)?,
                Panel::HeatMap(map) => map.draw(area, *corner, *size)?,
                Panel::Stair(stair) => stair.draw(area, *corner, *size)?,
            }
        }
        let letters = Letters::new(CAPTION_PX, Align::Left).in_colour(Ink::Grey.colour());
        for (index, line) in self.caption.iter().enumerate() {
            pen.text(
                line,
                [MARGIN_PX, self.caption_top + 5.0 + 14.0 * index as f64],
                letters,
            )?;
        }
        Ok(())
    }
}

/// Where each panel goes, from `top` on, and where they end. A heat map has a row of its own.
fn panel_places(panels: &[Panel], columns: usize, cell: Spot, top: f64) -> (Vec<(Spot, Spot)>, f64) {
    let mut y = top;
    let mut places = Vec::new();
    let mut column = 0;
    for panel in panels {
        if let Panel::HeatMap(map) = panel {
            if column > 0 {
                y += cell[1];
            }
            let width = (columns as f64 * cell[0]).max(CLASSES_PX);
            let height = map.height_px(width);
            places.push(([MARGIN_PX, y], [width, height]));
            (y, column) = (y + height, 0);
            continue;
        }
        let x = MARGIN_PX + column as f64 * cell[0];
        places.push(([x, y], [cell[0] - 6.0, cell[1] - 8.0]));
        column += 1;
        if column == columns {
            (y, column) = (y + cell[1], 0);
        }
    }
    if column > 0 {
        y += cell[1];
    }
    (places, y)
}

/// Width of a mark in a legend, px.
const SAMPLE_PX: f64 = 26.0;

/// Where each entry of a legend goes, and how high they are together.
fn legend_places(legend: &[Key], corner: Spot, room_px: f64) -> (Vec<Spot>, f64) {
    let mut places = Vec::new();
    let (mut x, mut row) = (0.0, 0.0);
    for key in legend {
        let width = SAMPLE_PX + 6.0 + width_px(&key.label, KEY_PX) + 16.0;
        if x > 0.0 && x + width > room_px {
            (x, row) = (0.0, row + 1.0);
        }
        places.push([corner[0] + x, corner[1] + 9.0 + 17.0 * row]);
        x += width;
    }
    let height = if legend.is_empty() {
        0.0
    } else {
        17.0 * (row + 1.0)
    };
    (places, height)
}

fn draw_key(pen: &Pen, key: &Key, at: Spot) -> Result<(), PlotError> {
    let [x, y] = at;
    let (end, middle) = (x + SAMPLE_PX, x + 0.5 * SAMPLE_PX);
    match key.sample {
        Sample::Line(ink, weight) => pen.line(&[[x, y], [end, y]], ink.colour(), weight.px())?,
        Sample::Band(ink, weight) => {
            let ring = [[x, y - 5.0], [end, y - 5.0], [end, y + 5.0], [x, y + 5.0]];
            pen.filled(&ring, ink.colour(), 0.22)?;
            pen.line(&[[x, y], [end, y]], ink.colour(), weight.px())?;
        }
        Sample::Marker(ink, shape, is_filled) => {
            pen.line(&[[middle, y - 7.0], [middle, y + 7.0]], ink.colour(), 1.1)?;
            pen.marker([middle, y], shape, ink.colour(), is_filled)?;
        }
        Sample::Dot(ink, shape, is_filled) => pen.marker([middle, y], shape, ink.colour(), is_filled)?,
        Sample::Swatch(ink) => pen.rectangle([x + 6.0, y - 5.0], [end - 4.0, y + 5.0], ink.colour())?,
    }
    pen.text(&key.label, [end + 6.0, y], Letters::new(KEY_PX, Align::Left))
}
