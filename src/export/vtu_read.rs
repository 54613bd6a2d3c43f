//! A `.vtu` file of a run read back, as far as a picture of the wing needs it.
//!
//! Only the form in which runs are written is read: one piece, inline base64 in zlib blocks, little endian, 64-bit heads. Every size is held
//! against the file before anything is allocated for it, so that a damaged file is refused, whatever stands in it.

use std::io::Read;
use std::path::Path;

use base64::Engine;
use base64::engine::general_purpose::STANDARD;
use flate2::read::ZlibDecoder;
use roxmltree::{Document, Node};

use super::ExportError;
use super::vtu::{Array, Grid, Values};

/// Arrays that are kept, with their components.
const KEPT: [(&str, usize); 7] = [
    ("displacement_mm", 3),
    ("rotation_deg", 3),
    ("twist_deg", 1),
    ("pressure_pa", 1),
    ("principal_tension_n_per_m", 2),
    ("part", 1),
    ("section", 1),
];

/// Attributes of the root of a file in this form.
const FORM: [(&str, &str); 4] = [
    ("type", "UnstructuredGrid"),
    ("byte_order", "LittleEndian"),
    ("header_type", "UInt64"),
    ("compressor", "vtkZLibDataCompressor"),
];

/// Types of cells in VTK.
const LINE: f64 = 3.0;
const TRIANGLE: f64 = 5.0;

/// No text of base64 holds more than so many bytes per character: the most that zlib makes of a byte.
const MOST_PER_CHARACTER: usize = 1032;

/// Reads a file that [`Grid::to_vtu`] wrote; `path` names it in errors.
///
/// # Errors
/// If it is no such file.
pub fn read_vtu(bytes: &[u8], path: &Path) -> Result<Grid, ExportError> {
    let foreign = |reason: &str| ExportError::ForeignSummary {
        path: path.to_path_buf(),
        reason: reason.to_string(),
    };
    let text = std::str::from_utf8(bytes).map_err(|error| foreign(&error.to_string()))?;
    let document = Document::parse(text).map_err(|error| foreign(&error.to_string()))?;
    let root = document.root_element();
    if FORM
        .iter()
        .any(|(name, value)| root.attribute(*name) != Some(value))
    {
        return Err(foreign("it holds no unstructured grid in the form of a run"));
    }
    grid(root).ok_or_else(|| foreign("it is damaged, or its cells are not triangles and lines on its points"))
}

fn grid(root: Node) -> Option<Grid> {
    let piece = child(child(root, "UnstructuredGrid")?, "Piece")?;
    let count = |name: &str| piece.attribute(name)?.parse::<usize>().ok();
    let (points, cells) = (count("NumberOfPoints")?, count("NumberOfCells")?);
    let flat = numbers(
        child(child(piece, "Points")?, "DataArray")?,
        points.checked_mul(3)?,
    )?;
    let of_cells = child(piece, "Cells")?;
    let offsets = numbers(named(of_cells, "offsets")?, cells)?;
    let nodes = numbers(
        named(of_cells, "connectivity")?,
        offsets.last().map_or(0, |end| *end as usize),
    )?;
    let kinds = numbers(named(of_cells, "types")?, cells)?;
    let (mut triangles, mut lines, mut from) = (Vec::new(), Vec::new(), 0);
    for (kind, end) in kinds.iter().zip(offsets) {
        let cell: Vec<usize> = nodes
            .get(from..end as usize)?
            .iter()
            .map(|&node| node as usize)
            .collect();
        if cell.iter().any(|&node| node >= points) {
            return None;
        }
        match (*kind, cell.as_slice()) {
            (TRIANGLE, &[a, b, c]) => triangles.push([a, b, c]),
            (LINE, &[a, b]) => lines.push([a, b]),
            _ => return None,
        }
        from = end as usize;
    }
    Some(Grid {
        points_mm: flat.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect(),
        triangles,
        lines,
        point_arrays: arrays(child(piece, "PointData"), points)?,
        cell_arrays: arrays(child(piece, "CellData"), cells)?,
    })
}

fn child<'a, 'i>(of: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    of.children().find(|own| own.has_tag_name(name))
}

fn named<'a, 'i>(of: Node<'a, 'i>, name: &str) -> Option<Node<'a, 'i>> {
    of.children().find(|own| own.attribute("Name") == Some(name))
}

/// The arrays that are kept; none if one has not as many values as it should.
fn arrays(data: Option<Node>, entries: usize) -> Option<Vec<Array>> {
    let mut kept = Vec::new();
    for array in data.into_iter().flat_map(|data| data.children()) {
        let own = KEPT
            .iter()
            .find(|(kept, _)| array.attribute("Name") == Some(kept));
        if let Some(&(name, components)) = own {
            kept.push(Array {
                name,
                values: Values::Real(components, numbers(array, entries.checked_mul(components)?)?),
            });
        }
    }
    Some(kept)
}

/// The numbers of an array, all finite; none if there are not so many.
fn numbers(array: Node, count: usize) -> Option<Vec<f64>> {
    let (width, number): (usize, fn(&[u8]) -> f64) = match array.attribute("type")? {
        "Float64" => (8, |own| f64::from_le_bytes(whole(own))),
        "UInt64" => (8, |own| u64::from_le_bytes(whole(own)) as f64),
        "Int32" => (4, |own| f64::from(i32::from_le_bytes(whole(own)))),
        "UInt8" => (1, |own| f64::from(own[0])),
        _ => return None,
    };
    let bytes = inflated(array.text().unwrap_or_default().trim(), count.checked_mul(width)?)?;
    let numbers: Vec<f64> = bytes.chunks_exact(width).map(number).collect();
    numbers.iter().all(|own| own.is_finite()).then_some(numbers)
}

/// Bytes of a chunk as an array of its length.
fn whole<const N: usize>(chunk: &[u8]) -> [u8; N] {
    std::array::from_fn(|place| chunk[place])
}

/// What stands in base64: a head (number of blocks, their size, that of the last one if it is smaller, and what each takes compressed), and
/// the blocks behind it. None if it is not just `size` bytes.
fn inflated(text: &str, size: usize) -> Option<Vec<u8>> {
    if size > text.len().checked_mul(MOST_PER_CHARACTER)? {
        return None;
    }
    let head_of = |words: usize| {
        let characters = words.checked_mul(8)?.div_ceil(3).checked_mul(4)?;
        let bytes = STANDARD.decode(text.get(..characters)?).ok()?;
        let words = bytes
            .chunks_exact(8)
            .map(|own| usize::try_from(u64::from_le_bytes(whole(own))).ok());
        Some((characters, words.collect::<Option<Vec<usize>>>()?))
    };
    let blocks = match text.is_empty() {
        true => 0,
        false => *head_of(3)?.1.first()?,
    };
    if blocks == 0 {
        return (size == 0).then(Vec::new);
    }
    let (characters, head) = head_of(blocks.checked_add(3)?)?;
    let compressed = STANDARD.decode(text.get(characters..)?).ok()?;
    let (each, last) = (head[1], head[2]);
    let mut bytes = Vec::with_capacity(size);
    let mut from = 0_usize;
    for (block, length) in head[3..].iter().enumerate() {
        let is_short = block + 1 == blocks && last > 0;
        let (to, own) = (from.checked_add(*length)?, if is_short { last } else { each });
        let before = bytes.len();
        let room = (size - before).min(own) as u64;
        // one byte more than there should be, to see that there is an end
        let block = ZlibDecoder::new(compressed.get(from..to)?);
        block.take(room + 1).read_to_end(&mut bytes).ok()?;
        if bytes.len() - before != own {
            return None;
        }
        from = to;
    }
    (bytes.len() == size && from == compressed.len()).then_some(bytes)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_grid_comes_back_with_what_a_picture_needs_and_anything_else_is_refused() {
        let grid = Grid {
            points_mm: vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.5]],
            triangles: vec![[0, 1, 2]],
            lines: vec![[0, 1]],
            point_arrays: vec![Array::scalar("twist_deg", vec![0.0, 1.5, -2.0])],
            cell_arrays: vec![Array::vector(
                "principal_tension_n_per_m",
                &[[3.0, 1.0], [0.0, 0.0]],
            )],
        };
        let bytes = grid.clone().to_vtu().expect("written");
        assert_eq!(read_vtu(&bytes, Path::new("wing.vtu")).expect("read"), grid);
        let error = read_vtu(b"<html/>", Path::new("wing.vtu")).expect_err("no grid");
        assert!(
            error.to_string().starts_with("wing.vtu was not written"),
            "{error}"
        );
    }

    #[test]
    fn no_damage_to_a_file_does_more_than_to_have_it_refused() {
        let points = 900;
        let grid = Grid {
            points_mm: (0..points)
                .map(|i| [f64::from(i), (f64::from(i)).sin(), 0.25])
                .collect(),
            triangles: (2..points as usize).map(|i| [i - 2, i - 1, i]).collect(),
            lines: vec![[0, 1]],
            point_arrays: vec![Array::scalar(
                "twist_deg",
                (0..points).map(|i| f64::from(i).cos()).collect(),
            )],
            cell_arrays: Vec::new(),
        };
        let good = grid.clone().to_vtu().expect("written");
        let mut state = 20_261_125_u64;
        let mut draw = move |below: usize| {
            state = state
                .wrapping_mul(6_364_136_223_846_793_005)
                .wrapping_add(1_442_695_040_888_963_407);
            (state >> 33) as usize % below
        };
        let mut read = 0;
        for _ in 0..2000 {
            let mut bytes = good.clone();
            let at = draw(bytes.len());
            match draw(5) {
                0 => bytes[at] = draw(256) as u8,
                1 => drop(bytes.drain(at..(at + 4).min(good.len()))),
                2 => bytes.truncate(at),
                3 => bytes[at] = b"0123456789AAAA/="[draw(16)],
                _ => {
                    let piece = bytes[at..(at + 40).min(good.len())].to_vec();
                    let to = draw(bytes.len());
                    bytes.splice(to..to, piece);
                }
            }
            if let Ok(same) = read_vtu(&bytes, Path::new("wing.vtu")) {
                // what is damaged beside the numbers does no harm
                read += 1;
                assert_eq!(same.points_mm, grid.points_mm);
                assert_eq!(same.triangles, grid.triangles);
            }
        }
        assert!(read < 400, "{read} of 2000 were taken");
    }
}
