//! Cantilevers of beam elements.

use nalgebra::{Matrix6, Vector3, Vector6};

use crate::structure::{Model, Section, StructureError};

/// Section with the stiffnesses EA, GA edge, GA flap (N), GJ, EI flap, EI edge (N·m²), uncoupled.
///
/// # Errors
/// If one of them is not positive.
pub fn section(stiffness: [f64; 6]) -> Result<Section, StructureError> {
    Section::from_stiffness(&Matrix6::from_diagonal(&Vector6::from(stiffness)), 0.0)
}

/// Chain of beams through points (m), all with e₃ toward `normal`; the first node is clamped.
///
/// # Errors
/// If two points fall together or the chain runs along the normal.
pub fn chain(
    points: Vec<Vector3<f64>>,
    normal: &Vector3<f64>,
    section: Section,
) -> Result<Model, StructureError> {
    let last = points.len().saturating_sub(1);
    let mut model = Model::new(points);
    let section = model.add_section(section);
    for i in 0..last {
        model.add_beam([i, i + 1], normal, section)?;
    }
    model.clamp(0);
    Ok(model)
}

/// Points of a straight line along x from 0 to `length_m`.
pub fn straight(length_m: f64, elements: usize) -> Vec<Vector3<f64>> {
    (0..=elements)
        .map(|i| Vector3::new(length_m * i as f64 / elements as f64, 0.0, 0.0))
        .collect()
}
