//! The structure of a design with its effects, and the loads that do not come from the air.

use std::sync::Arc;

use super::cure::cured;
use super::error::CouplingError;
use crate::effects::{Bound, Motion, Structure};
use crate::input::design::{Design, Kinematics};
use crate::mesh::Mesh;
use crate::progress::Progress;
use crate::structure::{Blend, Equilibrium, Loads, Model, bench_loads, wing_model_beside};

/// The structure, and bench loads with gravity; `motion` as effects see it; `known`: the structure of another design on this
/// mesh.
///
/// # Errors
/// If design and mesh do not belong together, an effect makes a section that is none, or a linear model beside large
/// rotation has no shape without load.
pub fn built(
    design: &Design,
    mesh: &Mesh,
    effects: &[Bound],
    motion: Option<&Motion>,
    known: Option<&Model>,
) -> Result<(Model, Loads), CouplingError> {
    let mut model = wing_model_beside(design, mesh, known)?;
    let mut structure = Structure {
        design,
        mesh,
        model: &mut model,
        motion,
    };
    for bound in effects {
        bound.effect.structure(&bound.values, &mut structure)?;
    }
    let mut bench = bench_loads(design, mesh, structure.model);
    for bound in effects {
        bound.effect.load(&bound.values, &structure, &mut bench);
    }
    let share = large_share(design, effects);
    if 0.0 < share && share < 1.0 {
        let mut equilibrium = Equilibrium::new(&model)?;
        let (rest, _) = cured(&model, &mut equilibrium, &Progress::quiet())?;
        let blend = Blend::new(&model, &equilibrium.pattern, rest, 1.0 - share);
        model.blend = Some(Arc::new(blend));
    }
    Ok((model, bench))
}

/// Share of large rotation: all of it unless the design asks for linear kinematics, and then what effects give back.
pub fn large_share(design: &Design, effects: &[Bound]) -> f64 {
    if design.structure.kinematics != Kinematics::Linear {
        return 1.0;
    }
    let share = |bound: &Bound| bound.effect.kinematics(&bound.values);
    effects.iter().find_map(share).unwrap_or(0.0)
}
