//! VTK unstructured grid (`.vtu`): triangles and lines in one file, inline base64, zlib.

use std::collections::BTreeSet;

use vtkio::model::{
    Attribute, Attributes, ByteOrder, CellType, Cells, DataSet, UnstructuredGridPiece, Version,
    VertexNumbers, Vtk,
};
use vtkio::xml::Compressor;

use super::ExportError;

/// A surface of triangles with lines on it, and arrays on its points and cells.
///
/// Cells are ordered triangles first, then lines; cell arrays follow that order.
#[derive(Debug, Clone, PartialEq, Default)]
pub struct Grid {
    /// Positions, mm.
    pub points_mm: Vec<[f64; 3]>,
    /// Triangles by points.
    pub triangles: Vec<[usize; 3]>,
    /// Lines by points.
    pub lines: Vec<[usize; 2]>,
    /// Arrays with one entry per point.
    pub point_arrays: Vec<Array>,
    /// Arrays with one entry per cell.
    pub cell_arrays: Vec<Array>,
}

/// A named array.
#[derive(Debug, Clone, PartialEq)]
pub struct Array {
    /// Name with unit, without spaces.
    pub name: &'static str,
    /// Values, entry after entry.
    pub values: Values,
}

/// The values of an array.
#[derive(Debug, Clone, PartialEq)]
pub enum Values {
    /// Numbers with so many components per entry.
    Real(usize, Vec<f64>),
    /// Numbers that name something.
    Index(Vec<i32>),
}

impl Array {
    /// One number per entry.
    pub fn scalar(name: &'static str, values: Vec<f64>) -> Self {
        Array {
            name,
            values: Values::Real(1, values),
        }
    }

    /// `N` numbers per entry.
    pub fn vector<const N: usize>(name: &'static str, values: &[[f64; N]]) -> Self {
        Array {
            name,
            values: Values::Real(N, values.concat()),
        }
    }

    /// One index per entry.
    pub fn index(name: &'static str, values: Vec<i32>) -> Self {
        Array {
            name,
            values: Values::Index(values),
        }
    }

    fn into_attribute(self) -> Attribute {
        match self.values {
            Values::Real(components, values) => {
                Attribute::generic(self.name, components as u32).with_data(values)
            }
            Values::Index(values) => Attribute::generic(self.name, 1).with_data(values),
        }
    }

    fn check(&self, entries: usize) -> Result<(), ExportError> {
        let (components, found) = match &self.values {
            Values::Real(components, values) => (*components, values.len()),
            Values::Index(values) => (1, values.len()),
        };
        if found != entries * components {
            return Err(ExportError::ArrayLength {
                name: self.name.to_string(),
                expected: entries * components,
                found,
            });
        }
        if let Values::Real(_, values) = &self.values {
            check_finite(self.name, values)?;
        }
        Ok(())
    }
}

impl Grid {
    /// The bytes of a `.vtu` file; refuses arrays of the wrong length and values that are not finite.
    ///
    /// # Example
    /// ```
    /// use washout::export::vtu::{Array, Grid};
    ///
    /// let grid = Grid {
    ///     points_mm: vec![[0.0; 3], [1.0, 0.0, 0.0], [0.0, 1.0, 0.0]],
    ///     triangles: vec![[0, 1, 2]],
    ///     point_arrays: vec![Array::scalar("twist_deg", vec![0.0, 1.0, 2.0])],
    ///     ..Grid::default()
    /// };
    /// assert!(String::from_utf8(grid.to_vtu()?)?.contains("UnstructuredGrid"));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn to_vtu(self) -> Result<Vec<u8>, ExportError> {
        self.check()?;
        let mut connectivity = Vec::with_capacity(3 * self.triangles.len() + 2 * self.lines.len());
        let mut offsets = Vec::with_capacity(self.triangles.len() + self.lines.len());
        let triangles = self.triangles.iter().map(|nodes| nodes.as_slice());
        let lines = self.lines.iter().map(|nodes| nodes.as_slice());
        for nodes in triangles.chain(lines) {
            connectivity.extend(nodes.iter().map(|&node| node as u64));
            offsets.push(connectivity.len() as u64);
        }
        let mut types = vec![CellType::Triangle; self.triangles.len()];
        types.extend(vec![CellType::Line; self.lines.len()]);
        let attributes = |arrays: Vec<Array>| arrays.into_iter().map(Array::into_attribute).collect();
        let piece = UnstructuredGridPiece {
            points: self.points_mm.concat().into(),
            cells: Cells {
                cell_verts: VertexNumbers::XML {
                    connectivity,
                    offsets,
                },
                types,
            },
            data: Attributes {
                point: attributes(self.point_arrays),
                cell: attributes(self.cell_arrays),
            },
        };
        let vtk = Vtk {
            version: Version::new_xml(1, 0),
            title: String::new(),
            byte_order: ByteOrder::LittleEndian,
            data: DataSet::inline(piece),
            file_path: None,
        };
        let mut bytes = Vec::new();
        vtk.try_into_xml_format(Compressor::ZLib, 1)
            .map_err(|error| encoding(error.to_string()))?
            .write(&mut bytes)
            .map_err(|error| encoding(error.to_string()))?;
        Ok(bytes)
    }

    fn check(&self) -> Result<(), ExportError> {
        let points = self.points_mm.len();
        let triangles = self.triangles.iter().map(|nodes| nodes.as_slice());
        let lines = self.lines.iter().map(|nodes| nodes.as_slice());
        for (cell, nodes) in triangles.chain(lines).enumerate() {
            if let Some(&point) = nodes.iter().find(|&&point| point >= points) {
                return Err(ExportError::CellPoint { cell, point, points });
            }
        }
        check_finite("points_mm", self.points_mm.as_flattened())?;
        let cells = self.triangles.len() + self.lines.len();
        for (arrays, entries) in [(&self.point_arrays, points), (&self.cell_arrays, cells)] {
            let mut names = BTreeSet::new();
            for array in arrays {
                array.check(entries)?;
                let bad = array.name.is_empty() || array.name.contains(char::is_whitespace);
                if bad || !names.insert(array.name) {
                    return Err(ExportError::ArrayName {
                        name: array.name.to_string(),
                    });
                }
            }
        }
        Ok(())
    }
}

fn check_finite(name: &str, values: &[f64]) -> Result<(), ExportError> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => Err(ExportError::NotFinite {
            name: name.to_string(),
            index,
            value: values[index],
        }),
    }
}

fn encoding(reason: String) -> ExportError {
    ExportError::Encoding {
        format: "VTK XML",
        reason,
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use vtkio::model::{DataArray, Piece};

    fn grid() -> Grid {
        Grid {
            points_mm: vec![[0.0, 0.0, 0.0], [2.0, 0.0, 0.0], [0.0, 3.0, 0.0], [2.0, 3.0, 0.5]],
            triangles: vec![[0, 1, 2], [1, 3, 2]],
            lines: vec![[0, 1]],
            point_arrays: vec![
                Array::scalar("twist_deg", vec![0.0, 1.5, -2.0, 0.25]),
                Array::vector("displacement_mm", &[[0.0, 0.0, 1.0]; 4]),
            ],
            cell_arrays: vec![Array::index("part", vec![0, 0, 1])],
        }
    }

    fn read_back(bytes: &[u8]) -> UnstructuredGridPiece {
        let DataSet::UnstructuredGrid { pieces, .. } = Vtk::parse_xml(bytes).expect("readable").data else {
            panic!("not an unstructured grid");
        };
        let Piece::Inline(piece) = pieces.into_iter().next().expect("one piece") else {
            panic!("piece is not inline");
        };
        *piece
    }

    fn real(attribute: &Attribute) -> (String, Vec<f64>) {
        let Attribute::DataArray(DataArray { name, data, .. }) = attribute else {
            panic!("not a data array");
        };
        (name.clone(), data.cast_into().expect("numbers"))
    }

    #[test]
    fn points_cells_and_arrays_come_back_bit_for_bit() {
        let piece = read_back(&grid().to_vtu().expect("written"));
        assert_eq!(
            piece.points.cast_into::<f64>().expect("f64"),
            grid().points_mm.concat()
        );
        assert_eq!(
            piece.cells.types,
            [CellType::Triangle, CellType::Triangle, CellType::Line]
        );
        let (connectivity, offsets) = piece.cells.cell_verts.into_xml();
        assert_eq!(connectivity, [0, 1, 2, 1, 3, 2, 0, 1]);
        assert_eq!(offsets, [3, 6, 8]);
        assert_eq!(
            real(&piece.data.point[0]),
            ("twist_deg".to_string(), vec![0.0, 1.5, -2.0, 0.25])
        );
        assert_eq!(
            real(&piece.data.cell[0]),
            ("part".to_string(), vec![0.0, 0.0, 1.0])
        );
    }

    #[test]
    fn an_array_of_the_wrong_length_is_refused() {
        let mut grid = grid();
        grid.cell_arrays.push(Array::scalar("pressure_pa", vec![0.0; 4]));
        let error = grid.to_vtu().expect_err("four values for three cells");
        assert!(
            matches!(
                error,
                ExportError::ArrayLength {
                    expected: 3,
                    found: 4,
                    ..
                }
            ),
            "{error}"
        );
    }

    #[test]
    fn a_value_that_is_no_number_is_refused() {
        let mut grid = grid();
        grid.point_arrays
            .push(Array::scalar("pressure_pa", vec![0.0, f64::NAN, 0.0, 0.0]));
        assert!(matches!(
            grid.to_vtu(),
            Err(ExportError::NotFinite { index: 1, .. })
        ));
    }

    #[test]
    fn a_cell_that_names_no_point_is_refused() {
        let mut grid = grid();
        grid.lines[0][1] = 4;
        assert!(matches!(
            grid.to_vtu(),
            Err(ExportError::CellPoint {
                cell: 2,
                point: 4,
                points: 4
            })
        ));
    }

    #[test]
    fn names_that_readers_trip_over_are_refused() {
        for name in ["", "tip twist", "twist_deg"] {
            let mut grid = grid();
            grid.point_arrays.push(Array::scalar(name, vec![0.0; 4]));
            assert!(
                matches!(grid.to_vtu(), Err(ExportError::ArrayName { .. })),
                "{name:?}"
            );
        }
    }
}
