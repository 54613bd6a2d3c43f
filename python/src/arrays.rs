//! Rows of the library as NumPy arrays.

use numpy::ndarray::Array2;
use numpy::{IntoPyArray, PyArray1, PyArray2};
use pyo3::prelude::*;

/// One row of the array for each row of the library.
pub fn rows<'py, const N: usize>(
    py: Python<'py>,
    rows: impl Iterator<Item = [f64; N]>,
) -> Bound<'py, PyArray2<f64>> {
    let rows: Vec<[f64; N]> = rows.collect();
    Array2::from(rows).into_pyarray(py)
}

/// Numbers of nodes, counted from 0, one row for each element.
pub fn elements<'py, const N: usize>(
    py: Python<'py>,
    elements: impl Iterator<Item = [usize; N]>,
) -> Bound<'py, PyArray2<i64>> {
    let rows: Vec<[i64; N]> = elements.map(|nodes| nodes.map(|node| node as i64)).collect();
    Array2::from(rows).into_pyarray(py)
}

/// Numbers of nodes, counted from 0.
pub fn nodes<'py>(py: Python<'py>, nodes: &[usize]) -> Bound<'py, PyArray1<i64>> {
    let nodes: Vec<i64> = nodes.iter().map(|&node| node as i64).collect();
    nodes.into_pyarray(py)
}

/// Numbers.
pub fn numbers<'py>(py: Python<'py>, numbers: impl Iterator<Item = f64>) -> Bound<'py, PyArray1<f64>> {
    numbers.collect::<Vec<f64>>().into_pyarray(py)
}
