//! A `.vtu` file of a run read back, as far as a picture of the wing needs it.

use std::path::Path;

use vtkio::model::{Attribute, CellType, DataArray, DataSet, Piece, UnstructuredGridPiece, Vtk};

use super::ExportError;
use super::vtu::{Array, Grid, Values};

/// Arrays that are kept, with their components.
const KEPT: [(&str, usize); 4] = [
    ("twist_deg", 1),
    ("pressure_pa", 1),
    ("principal_tension_n_per_m", 2),
    ("part", 1),
];

/// Reads a file that [`Grid::to_vtu`] wrote; `path` names it in errors.
///
/// # Errors
/// If it is no such file.
pub fn read_vtu(bytes: &[u8], path: &Path) -> Result<Grid, ExportError> {
    let foreign = |reason: &str| ExportError::ForeignSummary {
        path: path.to_path_buf(),
        reason: reason.to_string(),
    };
    let file = Vtk::parse_xml(bytes).map_err(|error| foreign(&error.to_string()))?;
    let DataSet::UnstructuredGrid { pieces, .. } = file.data else {
        return Err(foreign("it holds no unstructured grid"));
    };
    let Some(Piece::Inline(piece)) = pieces.into_iter().next() else {
        return Err(foreign("it holds no inline piece"));
    };
    grid(*piece).ok_or_else(|| foreign("its cells are not triangles and lines on its points"))
}

fn grid(piece: UnstructuredGridPiece) -> Option<Grid> {
    let flat: Vec<f64> = piece.points.cast_into()?;
    let points_mm: Vec<[f64; 3]> = flat.chunks_exact(3).map(|p| [p[0], p[1], p[2]]).collect();
    let (nodes, ends) = piece.cells.cell_verts.into_xml();
    let (mut triangles, mut lines, mut from) = (Vec::new(), Vec::new(), 0);
    for (kind, end) in piece.cells.types.iter().zip(ends) {
        let end = usize::try_from(end).ok()?;
        let cell: Vec<usize> = nodes.get(from..end)?.iter().map(|&node| node as usize).collect();
        if cell.iter().any(|&node| node >= points_mm.len()) {
            return None;
        }
        match (kind, cell.as_slice()) {
            (CellType::Triangle, &[a, b, c]) => triangles.push([a, b, c]),
            (CellType::Line, &[a, b]) => lines.push([a, b]),
            _ => return None,
        }
        from = end;
    }
    let cells = triangles.len() + lines.len();
    Some(Grid {
        point_arrays: arrays(piece.data.point, points_mm.len())?,
        cell_arrays: arrays(piece.data.cell, cells)?,
        points_mm,
        triangles,
        lines,
    })
}

/// The arrays that are kept; none if one has not as many values as it should.
fn arrays(attributes: Vec<Attribute>, entries: usize) -> Option<Vec<Array>> {
    let mut kept = Vec::new();
    for attribute in attributes {
        let Attribute::DataArray(DataArray { name, data, .. }) = attribute else {
            continue;
        };
        let Some(&(name, components)) = KEPT.iter().find(|(kept, _)| *kept == name) else {
            continue;
        };
        let values: Vec<f64> = data.cast_into()?;
        if values.len() != entries * components || values.iter().any(|value| !value.is_finite()) {
            return None;
        }
        kept.push(Array {
            name,
            values: Values::Real(components, values),
        });
    }
    Some(kept)
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
}
