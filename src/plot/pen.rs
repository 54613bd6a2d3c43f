//! Strokes on paper, in pixels: the one place that knows the drawing library's units.

use plotters::coord::Shift;
use plotters::drawing::{DrawingArea, DrawingAreaErrorKind, IntoDrawingArea};
use plotters::element::{Circle, PathElement, Polygon, Rectangle, Text};
use plotters::prelude::SVGBackend;
use plotters::style::text_anchor::{HPos, Pos, VPos};
use plotters::style::{
    Color, FontStyle, FontTransform, IntoFont, IntoTextStyle, RGBColor, ShapeStyle, TextStyle,
};

use super::error::PlotError;
use super::palette::{Ink, Shape};

/// Units of the drawing library in a pixel; it knows whole units only.
pub(super) const UNITS: f64 = 10.0;
/// The library divides sizes of letters by this.
const LETTER: f64 = 1.24;
/// Width of bold letters over that of others.
pub(super) const BOLD: f64 = 1.12;
/// Half the size of a marker, px.
const MARKER_PX: f64 = 3.4;

/// The paper, with the library's coordinates of whole units.
pub(super) type Area<'a> = DrawingArea<SVGBackend<'a>, Shift>;

/// A place on the paper, px from its upper left corner.
pub(super) type Spot = [f64; 2];

/// How letters stand at their spot.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub(super) enum Align {
    Left,
    Centre,
    Right,
}

/// How letters look.
#[derive(Debug, Clone, Copy)]
pub(super) struct Letters {
    pub size_px: f64,
    pub ink: RGBColor,
    pub is_bold: bool,
    pub align: Align,
    /// Whether they run upward.
    pub is_upright: bool,
}

impl Letters {
    pub fn new(size_px: f64, align: Align) -> Letters {
        Letters {
            size_px,
            ink: Ink::Black.colour(),
            is_bold: false,
            align,
            is_upright: false,
        }
    }

    pub fn bold(self) -> Letters {
        Letters {
            is_bold: true,
            ..self
        }
    }

    pub fn upright(self) -> Letters {
        Letters {
            is_upright: true,
            ..self
        }
    }

    pub fn in_colour(self, ink: RGBColor) -> Letters {
        Letters { ink, ..self }
    }

    /// As the library wants them; centred on the line of their spot.
    pub fn style(&self) -> TextStyle<'static> {
        let horizontal = match self.align {
            Align::Left => HPos::Left,
            Align::Centre => HPos::Center,
            Align::Right => HPos::Right,
        };
        let weight = if self.is_bold {
            FontStyle::Bold
        } else {
            FontStyle::Normal
        };
        let font = (
            "Helvetica, Arial, sans-serif",
            self.size_px * UNITS * LETTER,
            weight,
        )
            .into_font();
        let turn = if self.is_upright {
            FontTransform::Rotate270
        } else {
            FontTransform::None
        };
        font.transform(turn)
            .with_color(self.ink)
            .with_anchor::<RGBColor>(Pos::new(horizontal, VPos::Center))
            .into_text_style(&(0, 0))
    }
}

/// A pen over the paper.
pub(super) struct Pen<'p, 'a> {
    area: &'p Area<'a>,
}

/// Draws on a sheet of so many pixels; gives the SVG.
pub(super) fn on_paper(
    width_px: f64,
    height_px: f64,
    title: &str,
    draw: impl FnOnce(&Area) -> Result<(), PlotError>,
) -> Result<String, PlotError> {
    let size = [width_px, height_px].map(|px| (px * UNITS).round() as u32);
    let mut svg = String::new();
    {
        let area = SVGBackend::with_string(&mut svg, (size[0], size[1])).into_drawing_area();
        area.fill(&RGBColor(255, 255, 255)).map_err(refused)?;
        draw(&area)?;
        area.present().map_err(refused)?;
    }
    // Shown in pixels, drawn in units; the title is for readers who do not see.
    let head = format!("<svg width=\"{}\" height=\"{}\" ", size[0], size[1]);
    let shown = format!("<svg role=\"img\" width=\"{width_px:.0}\" height=\"{height_px:.0}\" ");
    let svg = svg.replacen(&head, &shown, 1);
    let title = format!(">\n<title>{}</title>\n", escaped(title));
    Ok(svg.replacen(">\n", &title, 1))
}

/// Text for an element or an attribute of SVG or HTML.
pub fn escaped(text: &str) -> String {
    let mut out = String::with_capacity(text.len());
    for c in text.chars() {
        match c {
            '<' => out.push_str("&lt;"),
            '>' => out.push_str("&gt;"),
            '&' => out.push_str("&amp;"),
            '"' => out.push_str("&quot;"),
            '\'' => out.push_str("&#39;"),
            c if c.is_control() && c != '\n' => out.push(' '),
            c => out.push(c),
        }
    }
    out
}

/// A refusal of the drawing library.
pub(super) fn refused<E: std::error::Error + Send + Sync>(error: DrawingAreaErrorKind<E>) -> PlotError {
    PlotError::Drawing {
        reason: error.to_string(),
    }
}

fn units(spot: Spot) -> (i32, i32) {
    ((spot[0] * UNITS).round() as i32, (spot[1] * UNITS).round() as i32)
}

fn stroke(colour: RGBColor, width_px: f64) -> ShapeStyle {
    ShapeStyle {
        color: colour.to_rgba(),
        filled: false,
        stroke_width: (width_px * UNITS).round() as u32,
    }
}

impl<'p, 'a> Pen<'p, 'a> {
    pub fn on(area: &'p Area<'a>) -> Self {
        Pen { area }
    }

    pub fn line(&self, spots: &[Spot], colour: RGBColor, width_px: f64) -> Result<(), PlotError> {
        let points: Vec<_> = spots.iter().copied().map(units).collect();
        let path = PathElement::new(points, stroke(colour, width_px));
        self.area.draw(&path).map_err(refused)
    }

    pub fn filled(&self, spots: &[Spot], colour: RGBColor, opacity: f64) -> Result<(), PlotError> {
        let points: Vec<_> = spots.iter().copied().map(units).collect();
        let style = colour.mix(opacity).filled();
        self.area.draw(&Polygon::new(points, style)).map_err(refused)
    }

    pub fn rectangle(&self, from: Spot, to: Spot, colour: RGBColor) -> Result<(), PlotError> {
        let shape = Rectangle::new([units(from), units(to)], colour.filled());
        self.area.draw(&shape).map_err(refused)
    }

    pub fn frame(&self, from: Spot, to: Spot, colour: RGBColor, width_px: f64) -> Result<(), PlotError> {
        let ring = [from, [to[0], from[1]], to, [from[0], to[1]], from];
        self.line(&ring, colour, width_px)
    }

    pub fn text(&self, text: &str, at: Spot, letters: Letters) -> Result<(), PlotError> {
        // A control character is no XML.
        let text: String = text
            .chars()
            .map(|c| if c.is_control() { ' ' } else { c })
            .collect();
        self.area
            .draw(&Text::new(text, units(at), letters.style()))
            .map_err(refused)
    }

    /// A marker; a hollow one is white inside, so that lines do not show through.
    pub fn marker(&self, at: Spot, shape: Shape, colour: RGBColor, is_filled: bool) -> Result<(), PlotError> {
        let (x, y, h) = (at[0], at[1], MARKER_PX);
        let inside = if is_filled {
            colour
        } else {
            RGBColor(255, 255, 255)
        };
        let corners: Vec<Spot> = match shape {
            Shape::Circle => {
                let circle = |style: ShapeStyle| Circle::new(units(at), (h * UNITS) as i32, style);
                self.area.draw(&circle(inside.filled())).map_err(refused)?;
                return match is_filled {
                    true => Ok(()),
                    false => self.area.draw(&circle(stroke(colour, 1.3))).map_err(refused),
                };
            }
            Shape::Square => vec![[x - h, y - h], [x + h, y - h], [x + h, y + h], [x - h, y + h]],
            Shape::Triangle => vec![
                [x, y - 1.2 * h],
                [x + 1.2 * h, y + 0.9 * h],
                [x - 1.2 * h, y + 0.9 * h],
            ],
            Shape::Diamond => vec![
                [x, y - 1.35 * h],
                [x + 1.35 * h, y],
                [x, y + 1.35 * h],
                [x - 1.35 * h, y],
            ],
        };
        self.filled(&corners, inside, 1.0)?;
        if !is_filled {
            let ring: Vec<Spot> = corners.iter().chain(corners.first()).copied().collect();
            self.line(&ring, colour, 1.3)?;
        }
        Ok(())
    }
}

/// About how wide a text is, px; letters are those of DejaVu Sans, the widest of the fonts that it is shown in.
pub(super) fn width_px(text: &str, size_px: f64) -> f64 {
    let width = |c: char| match c {
        'i' | 'j' | 'l' | '.' | ',' | ':' | ';' | '\'' | '|' | '!' | ' ' => 0.32,
        'f' | 't' | 'r' | '/' | '(' | ')' | '[' | ']' | '-' => 0.4,
        'm' | 'w' | 'M' | 'W' | '%' | '@' | '…' => 0.95,
        c if c.is_uppercase() => 0.72,
        '−' | '+' | '±' | '=' | '<' | '>' => 0.84,
        _ => 0.63,
    };
    size_px * text.chars().map(width).sum::<f64>()
}

/// A text cut to a width, with an ellipsis where something is lost.
pub(super) fn cut(text: &str, room_px: f64, size_px: f64) -> String {
    if width_px(text, size_px) <= room_px {
        return text.to_string();
    }
    let mut kept = String::new();
    for c in text.chars() {
        let longer = format!("{kept}{c}…");
        if width_px(&longer, size_px) > room_px {
            break;
        }
        kept.push(c);
    }
    format!("{}…", kept.trim_end())
}

/// A text in lines no wider than `room_px`.
pub(super) fn lines(text: &str, room_px: f64, size_px: f64) -> Vec<String> {
    let mut lines: Vec<String> = Vec::new();
    for word in text.split_whitespace() {
        match lines.last_mut() {
            Some(line) if width_px(&format!("{line} {word}"), size_px) <= room_px => {
                line.push(' ');
                line.push_str(word);
            }
            _ => lines.push(word.to_string()),
        }
    }
    lines.iter().map(|line| cut(line, room_px, size_px)).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn texts_are_cut_and_wrapped_to_their_room() {
        assert_eq!(cut("short", 100.0, 10.0), "short");
        let cut_text = cut("bending-2.40 of the wing with skin", 80.0, 10.0);
        assert!(
            cut_text.ends_with('…') && width_px(&cut_text, 10.0) <= 80.0,
            "{cut_text}"
        );
        let wrapped = lines("one two three four five six seven", 60.0, 10.0);
        assert!(
            wrapped.len() > 2 && wrapped.iter().all(|line| width_px(line, 10.0) <= 60.0),
            "{wrapped:?}"
        );
        assert_eq!(wrapped.join(" "), "one two three four five six seven");
    }
}
