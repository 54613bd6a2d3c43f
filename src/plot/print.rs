//! Pictures for print: SVG of a given width, and PNG of a given width and resolution.
//!
//! PNG are drawn by `resvg` with letters of its own (Arimo, as wide as Arial and Helvetica), so that a picture looks the same on every
//! machine.

use std::sync::{Arc, LazyLock};

use resvg::tiny_skia::{Color, Pixmap};
use resvg::usvg::{Options, Transform, Tree, fontdb};

use super::error::PlotError;

/// Millimetres in an inch.
const INCH_MM: f64 = 25.4;
/// Pixels of a picture that are its natural size, per inch, as CSS has them.
const NATURAL_DPI: f64 = 96.0;
/// Largest number of pixels along a side: what readers of PNG take.
pub const MOST_PX: f64 = 20_000.0;

static LETTERS: LazyLock<Arc<fontdb::Database>> = LazyLock::new(|| {
    let mut letters = fontdb::Database::new();
    letters.load_font_data(include_bytes!("letters/arimo-regular.ttf").to_vec());
    letters.load_font_data(include_bytes!("letters/arimo-bold.ttf").to_vec());
    letters.set_sans_serif_family("Arimo");
    Arc::new(letters)
});

/// How large a picture is on paper.
#[derive(Debug, Clone, Copy, PartialEq)]
pub struct Print {
    /// Width, mm; as drawn (96 pixels to the inch) where none is given.
    pub width_mm: Option<f64>,
    /// Pixels to the inch of a PNG.
    pub dpi: f64,
}

impl Print {
    /// The picture as a file of its own, as wide as asked.
    ///
    /// # Errors
    /// If it has no extent.
    pub fn svg(&self, picture: &str) -> Result<String, PlotError> {
        let refused = |reason: &str| PlotError::Drawing {
            reason: reason.to_string(),
        };
        let start = picture.find("<svg").ok_or(refused("it is no SVG"))?;
        let end = start + picture[start..].find('>').ok_or(refused("its SVG is cut off"))?;
        let head = &picture[start..end];
        let drawn = attribute(head, "viewBox").ok_or(refused("its SVG has no view box"))?;
        let extent: Vec<f64> = drawn
            .split_whitespace()
            .filter_map(|number| number.parse().ok())
            .collect();
        let [_, _, width, height] = extent[..] else {
            return Err(refused("its SVG has a view box of other than four numbers"));
        };
        let natural_px = attribute(head, "width").and_then(|width| width.parse().ok());
        let width_mm = self
            .width_mm
            .unwrap_or(natural_px.unwrap_or(width) * INCH_MM / NATURAL_DPI);
        let height_mm = width_mm * height / width;
        let body = &picture[end..];
        Ok(format!(
            "<svg xmlns=\"http://www.w3.org/2000/svg\" role=\"img\" viewBox=\"{drawn}\" width=\"{width_mm:.2}mm\" \
             height=\"{height_mm:.2}mm\"{}",
            body
        ))
    }

    /// The picture as PNG, which knows its size on paper.
    ///
    /// # Errors
    /// If it has more than [`MOST_PX`] pixels along a side, or cannot be drawn.
    pub fn png(&self, picture: &str) -> Result<Vec<u8>, PlotError> {
        let refused = |reason: String| PlotError::Drawing { reason };
        let options = Options {
            dpi: NATURAL_DPI as f32,
            fontdb: LETTERS.clone(),
            font_family: "Arimo".to_string(),
            ..Options::default()
        };
        let tree =
            Tree::from_str(&self.svg(picture)?, &options).map_err(|error| refused(error.to_string()))?;
        let scale = self.dpi / NATURAL_DPI;
        let [width, height] =
            [tree.size().width(), tree.size().height()].map(|px| (f64::from(px) * scale).round());
        if !(1.0..=MOST_PX).contains(&width.max(height)) {
            return Err(PlotError::TooLarge {
                width_px: width,
                height_px: height,
                most_px: MOST_PX,
            });
        }
        let mut paper = Pixmap::new(width as u32, height.max(1.0) as u32)
            .ok_or_else(|| refused("there is no room for it".to_string()))?;
        paper.fill(Color::WHITE);
        let scale = scale as f32;
        resvg::render(&tree, Transform::from_scale(scale, scale), &mut paper.as_mut());
        self.encoded(&paper).map_err(|error| refused(error.to_string()))
    }

    fn encoded(&self, paper: &Pixmap) -> Result<Vec<u8>, png::EncodingError> {
        let mut file = Vec::new();
        let mut encoder = png::Encoder::new(&mut file, paper.width(), paper.height());
        // the paper is opaque everywhere, so that its colours are not premultiplied
        encoder.set_color(png::ColorType::Rgb);
        encoder.set_depth(png::BitDepth::Eight);
        let per_metre = (self.dpi / INCH_MM * 1000.0).round() as u32;
        encoder.set_pixel_dims(Some(png::PixelDimensions {
            xppu: per_metre,
            yppu: per_metre,
            unit: png::Unit::Meter,
        }));
        let colours: Vec<u8> = paper
            .data()
            .chunks_exact(4)
            .flat_map(|px| [px[0], px[1], px[2]])
            .collect();
        let mut writer = encoder.write_header()?;
        writer.write_image_data(&colours)?;
        writer.finish()?;
        Ok(file)
    }
}

/// An attribute of a start tag.
fn attribute<'a>(head: &'a str, name: &str) -> Option<&'a str> {
    let from = head.find(&format!(" {name}=\""))? + name.len() + 3;
    head[from..].split('"').next()
}

#[cfg(test)]
mod tests {
    use super::*;

    const SQUARE: &str = "<svg viewBox=\"0 0 200 100\" style=\"width:100%\"><title>t</title>\n\
        <rect x=\"0\" y=\"0\" width=\"100\" height=\"100\" fill=\"#000\"/>\n\
        <text x=\"110\" y=\"60\" font-size=\"40\" font-family=\"Helvetica, Arial, sans-serif\">α−²</text></svg>\n";

    fn pixels(file: &[u8]) -> (png::Info<'static>, Vec<u8>) {
        let mut reader = png::Decoder::new(std::io::Cursor::new(file)).read_info().unwrap();
        let mut bytes = vec![0; reader.output_buffer_size().unwrap()];
        reader.next_frame(&mut bytes).unwrap();
        (reader.info().clone(), bytes)
    }

    #[test]
    fn a_png_has_the_size_on_paper_that_was_asked_for_and_shows_shapes_and_letters() {
        let print = Print {
            width_mm: Some(50.8),
            dpi: 150.0,
        };
        let (info, bytes) = pixels(&print.png(SQUARE).unwrap());
        assert_eq!((info.width, info.height), (300, 150));
        let dims = info.pixel_dims.unwrap();
        assert_eq!((dims.xppu, dims.unit), (5906, png::Unit::Meter));
        let at = |x: usize, y: usize| bytes[3 * (y * 300 + x)];
        assert_eq!((at(10, 10), at(140, 140), at(160, 10)), (0, 0, 255));
        // each of the three letters leaves ink in its own part of the right half
        for columns in [165..195, 200..230, 232..250] {
            let dark = columns.clone().any(|x| (30..110).any(|y| at(x, y) < 128));
            assert!(dark, "no letter between {columns:?}");
        }
    }

    #[test]
    fn an_svg_for_print_stands_alone_and_is_as_wide_as_asked() {
        let print = Print {
            width_mm: Some(85.0),
            dpi: 300.0,
        };
        let svg = print.svg(SQUARE).unwrap();
        assert!(
            svg.starts_with("<svg xmlns=\"http://www.w3.org/2000/svg\" "),
            "{svg}"
        );
        assert!(
            svg.contains("width=\"85.00mm\" height=\"42.50mm\"><title>t</title>"),
            "{svg}"
        );
    }

    #[test]
    fn a_png_too_large_to_open_is_refused() {
        let print = Print {
            width_mm: Some(2000.0),
            dpi: 1200.0,
        };
        assert!(matches!(print.png(SQUARE), Err(PlotError::TooLarge { .. })));
    }
}
