//! The structure of a design with its effects, and the loads that do not come from the air.

use std::sync::Arc;

use super::cure::cured;
use super::error::CouplingError;
use super::finite::by_effect;
use crate::effects::{Bound, Motion, Structure};
use crate::input::design::{Design, Kinematics};
use crate::mesh::Mesh;
use crate::progress::Progress;
use crate::structure::{
    Equilibrium, Loads, Model, StructureError, bench_loads, refuse_not_finite, wing_model_beside,
};

/// The structure, and bench loads with gravity; `motion` as effects see it; `known`: the structure of another design on this
/// mesh.
///
/// # Errors
/// If design and mesh do not belong together, an effect makes a section that is none or a number that is not finite, or a
/// linear model beside large rotation has no shape without load.
pub fn built(
    design: &Design,
    mesh: &Mesh,
    effects: &[Bound],
    motion: Option<&Motion>,
    known: Option<&Model>,
) -> Result<(Model, Loads), CouplingError> {
    let mut model = wing_model_beside(design, mesh, known)?;
    model.refuse_not_finite()?;
    let mut structure = Structure {
        design,
        mesh,
        model: &mut model,
        motion,
    };
    for bound in effects {
        let by_effect = by_effect(bound.effect.card().name);
        match bound.effect.structure(&bound.values, &mut structure) {
            Err(StructureError::NotFinite(found)) => return Err(by_effect(found)),
            changed => changed?,
        }
        structure.model.refuse_not_finite().map_err(by_effect)?;
    }
    let mut bench = bench_loads(design, mesh, structure.model);
    bench.refuse_not_finite(structure.model)?;
    for bound in effects {
        bound.effect.load(&bound.values, &structure, &mut bench);
        let by_effect = by_effect(bound.effect.card().name);
        bench.refuse_not_finite(structure.model).map_err(by_effect)?;
    }
    let share = large_share(design, effects)?;
    if 0.0 < share && share < 1.0 {
        let mut equilibrium = Equilibrium::new(&model)?;
        let (rest, _) = cured(&model, &mut equilibrium, &Progress::quiet())?;
        let blend = model.linear(&equilibrium.pattern, rest, 1.0 - share);
        model.blend = Some(Arc::new(blend));
    }
    Ok((model, bench))
}

/// Share of large rotation: all of it unless the design asks for linear kinematics, and then what effects give back.
///
/// # Errors
/// If an effect's share is not finite.
pub fn large_share(design: &Design, effects: &[Bound]) -> Result<f64, CouplingError> {
    if design.structure.kinematics != Kinematics::Linear {
        return Ok(1.0);
    }
    let share = |bound: &Bound| {
        Some((
            bound.effect.card().name.to_string(),
            bound.effect.kinematics(&bound.values)?,
        ))
    };
    let Some((name, share)) = effects.iter().find_map(share) else {
        return Ok(0.0);
    };
    let number = ("the share of large rotation", share);
    refuse_not_finite(|| "of the wing", [number]).map_err(by_effect(&name))?;
    Ok(share)
}
