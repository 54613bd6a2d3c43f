//! Numbers as the data of the viewer has them.

use crate::export::ExportError;
use crate::export::vtu::{Array, Values};

/// Refuses what is no number.
pub fn finite(name: &str, values: &[f64]) -> Result<(), ExportError> {
    match values.iter().position(|value| !value.is_finite()) {
        None => Ok(()),
        Some(index) => Err(ExportError::NotFinite {
            name: name.to_string(),
            index,
            value: values[index],
        }),
    }
}

/// Lengths in mm as whole micrometres.
pub fn micrometres(lengths_mm: &[f64]) -> String {
    joined(lengths_mm, |x| format!("{}", (x * 1e3).round() as i64))
}

/// One component of an array over its first `entries` entries.
pub fn component_of(arrays: &[Array], name: &str, component: usize, entries: usize) -> Option<Vec<f64>> {
    let array = arrays.iter().find(|array| array.name == name)?;
    let values: Vec<f64> = match &array.values {
        Values::Real(components, values) => values
            .iter()
            .skip(component)
            .step_by((*components).max(1))
            .copied()
            .collect(),
        Values::Index(values) => values.iter().map(|&value| f64::from(value)).collect(),
    };
    values.get(..entries).map(<[f64]>::to_vec)
}

/// Values one after the other, each as `show` writes it.
pub fn joined(values: &[f64], show: impl Fn(f64) -> String) -> String {
    let mut text = String::with_capacity(6 * values.len());
    for (index, &value) in values.iter().enumerate() {
        if index > 0 {
            text.push(',');
        }
        text.push_str(&show(value));
    }
    text
}
