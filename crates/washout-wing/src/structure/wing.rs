//! The structure of a wing: its mesh with the sections, film, supports and bench loads of a design.

use nalgebra::Vector3;

use super::StructureError;
use super::largest::larger;
use super::loads::{ArmForce, Loads};
use super::material;
use super::model::{Model, PointMass};
use super::section::Section;
use super::spring::{Spring, Stiffening};
use crate::input::design::{BenchLoad, Design, RootChord};
use crate::mesh::{BeamPart, Mesh};

/// The structure of a wing. `model.beams[i]` is `mesh.beams[i]`, `model.shells[i]` is `mesh.triangles[i]`.
///
/// The rod is clamped at its base, with a spring about the span axis if the design gives a pitch stiffness; the film's
/// root chord is free or clamped.
///
/// # Errors
/// If the mesh and the design do not belong together, or an element has no size.
pub fn wing_model(design: &Design, mesh: &Mesh) -> Result<Model, StructureError> {
    wing_model_beside(design, mesh, None)
}

/// The same; `known` is the structure of another design on the same mesh, whose films are taken over where the sheets are equal.
///
/// # Errors
/// As [`wing_model`].
pub fn wing_model_beside(
    design: &Design,
    mesh: &Mesh,
    known: Option<&Model>,
) -> Result<Model, StructureError> {
    let mut model = Model::new(mesh.nodes.iter().map(|x| Vector3::from(*x)).collect());
    let mut sections: Vec<(BeamPart, usize)> = Vec::new();
    for beam in &mesh.beams {
        let same = |part: BeamPart| match (part, beam.part) {
            (BeamPart::Rib(_), BeamPart::Rib(_)) => true,
            (part, other) => part == other,
        };
        let known = sections
            .iter()
            .find(|(part, _)| same(*part))
            .map(|(_, index)| *index);
        let index = match known {
            Some(index) => index,
            None => {
                let index = model.add_section(section_of(design, beam.part)?);
                sections.push((beam.part, index));
                index
            }
        };
        model.add_beam(beam.nodes, &Vector3::z(), index)?;
    }
    if let Some(sheet) = material::film(design)? {
        let index = model.add_sheet(sheet);
        match known.filter(|known| known.sheets == model.sheets) {
            Some(known) => model.shells = known.shells.clone(),
            None => {
                for &triangle in &mesh.triangles {
                    model.add_shell(triangle, index)?;
                }
            }
        }
    }
    support(design, mesh, &mut model);
    for load in &design.load {
        let mass_kg = load.mass_kg.value();
        if mass_kg != 0.0 || load.inertia_kg_m2.iter().any(|&i| i != 0.0) {
            for (node, arm_m, share) in carriers(mesh, load) {
                let inertia_kg_m2 = Vector3::from(load.inertia_kg_m2) * share;
                model.masses.push(PointMass {
                    node,
                    arm_m,
                    mass_kg: share * mass_kg,
                    inertia_kg_m2,
                });
            }
        }
    }
    Ok(model)
}

/// Bench loads and gravity of a design.
pub fn bench_loads(design: &Design, mesh: &Mesh, model: &Model) -> Loads {
    let mut loads = Loads::none(model.nodes.len());
    for load in &design.load {
        for (node, arm_m, share) in carriers(mesh, load) {
            let force_n = Vector3::from(load.force_n) * share;
            if arm_m == Vector3::zeros() {
                loads.force_n[node] += force_n;
            } else if force_n != Vector3::zeros() {
                loads.arms.push(ArmForce { node, arm_m, force_n });
            }
            loads.moment_n_m[node] += Vector3::from(load.moment_n_m) * share;
        }
    }
    if let Some(gravity) = &design.gravity {
        weigh(model, &Vector3::from(gravity.in_wing_frame_m_s2()), &mut loads);
    }
    loads
}

/// Adds the weight of every element and mass under an acceleration, m/s².
pub fn weigh(model: &Model, acceleration: &Vector3<f64>, loads: &mut Loads) {
    for beam in &model.beams {
        let half = 0.5 * model.sections[beam.section].mass_kg_m * beam.length_m();
        for node in beam.nodes {
            loads.force_n[node] += acceleration * half;
        }
    }
    for shell in model.shells.iter() {
        let sheet = &model.sheets[shell.sheet];
        let third = sheet.density_kg_m3 * sheet.thickness_m * shell.area_m2() / 3.0;
        for node in shell.nodes {
            loads.force_n[node] += acceleration * third;
        }
    }
    for mass in &model.masses {
        loads.arms.push(ArmForce {
            node: mass.node,
            arm_m: mass.arm_m,
            force_n: acceleration * mass.mass_kg,
        });
    }
}

/// Rod nodes that carry a bench load, each with its arm (m) and share: the two that stand around it.
///
/// The load's chord offset counts from the leading edge (y = 0), wherever the rod lies.
fn carriers(mesh: &Mesh, load: &BenchLoad) -> Vec<(usize, Vector3<f64>, f64)> {
    let rod = mesh.rod_nodes();
    let x_m = 1e-3 * load.at_mm.value();
    let place = Vector3::new(
        x_m,
        1e-3 * load.chord_offset_mm.value(),
        1e-3 * load.normal_offset_mm.value(),
    );
    let at = |node: usize| Vector3::from(mesh.nodes[node]);
    let arm = |node: usize| place - at(node);
    let after = rod.partition_point(|&node| at(node).x < x_m - 1e-12);
    let near = |node: usize| (at(node).x - x_m).abs() < 1e-9;
    match (after.checked_sub(1).map(|i| rod[i]), rod.get(after).copied()) {
        (_, Some(node)) | (Some(node), _) if near(node) => {
            let arm_m = Vector3::new(0.0, arm(node).y, arm(node).z);
            vec![(node, arm_m, 1.0)]
        }
        (Some(a), Some(b)) => {
            let share = (x_m - at(a).x) / (at(b).x - at(a).x);
            vec![(a, arm(a), 1.0 - share), (b, arm(b), share)]
        }
        (Some(node), None) | (None, Some(node)) => vec![(node, arm(node), 1.0)],
        (None, None) => Vec::new(),
    }
}

fn support(design: &Design, mesh: &Mesh, model: &mut Model) {
    let Some(&base) = mesh.rod_nodes().first() else {
        return;
    };
    match &design.root.pitch_stiffness_n_m_per_rad {
        None => model.clamp(base),
        Some(stiffness) => {
            model.hold(base, [true, true, true, false, true, true]);
            model.springs.push(Spring {
                node: base,
                displacement_n_m: [0.0; 3],
                rotation_n_m_rad: [stiffness.value(), 0.0, 0.0],
                stiffening: Stiffening::NONE,
            });
        }
    }
    if design.root.chord == RootChord::Clamped {
        for &node in mesh.root.iter().filter(|&&node| node != base) {
            model.clamp(node);
        }
    }
}

/// Section of the rod at the base of a wing; none without a rod.
///
/// # Errors
/// If its material is missing, or the stiffness is not positive definite.
pub fn innermost_rod(design: &Design) -> Result<Option<Section>, StructureError> {
    let from = |index: &usize| design.rod[*index].from_mm.value();
    let inner = (0..design.rod.len()).min_by(|a, b| from(a).total_cmp(&from(b)));
    inner
        .map(|index| section_of(design, BeamPart::Rod(index)))
        .transpose()
}

/// Length of the leading edge along its rods, m.
pub fn rod_length_m(design: &Design) -> f64 {
    let ends = design.rod.iter().map(|rod| rod.to_mm.value());
    let starts = design.rod.iter().map(|rod| rod.from_mm.value());
    1e-3 * (ends.fold(0.0, f64::max) - starts.fold(f64::INFINITY, f64::min))
}

/// Twist of the rods from the base to a place under a torque there, over that torque, rad/(N·m): spars and film left out.
///
/// # Errors
/// As [`innermost_rod`].
pub fn rod_twist_rad_n_m(design: &Design, to_mm: f64) -> Result<f64, StructureError> {
    let root = design.root.pitch_stiffness_n_m_per_rad.as_ref();
    let mut twist = root.map_or(0.0, |stiffness| 1.0 / stiffness.value());
    for (index, rod) in design.rod.iter().enumerate() {
        let long_mm = rod.to_mm.value().min(to_mm) - rod.from_mm.value();
        if long_mm > 0.0 {
            twist += 1e-3 * long_mm / section_of(design, BeamPart::Rod(index))?.gj_n_m2();
        }
    }
    Ok(twist)
}

/// Deflection of the rods at a place under a force there across the wing, over that force, m/N: spars and film left out, held at the base.
///
/// # Errors
/// As [`innermost_rod`].
pub fn rod_deflection_m_n(design: &Design, to_mm: f64) -> Result<f64, StructureError> {
    let mut deflection = 0.0;
    for (index, rod) in design.rod.iter().enumerate() {
        // lever arms of the force at the ends of the rod: the integral of their square over its stiffness
        let arms = [rod.from_mm.value(), rod.to_mm.value().min(to_mm)].map(|end| 1e-3 * (to_mm - end));
        if arms[0] > arms[1] {
            let ei_n_m2 = section_of(design, BeamPart::Rod(index))?.ei_flap_n_m2();
            deflection += (arms[0].powi(3) - arms[1].powi(3)) / (3.0 * ei_n_m2);
        }
    }
    Ok(deflection)
}

fn section_of(design: &Design, part: BeamPart) -> Result<Section, StructureError> {
    let missing = |part: String| StructureError::UnknownPart { part };
    match part {
        BeamPart::Rod(index) => {
            let rod = design
                .rod
                .get(index)
                .ok_or_else(|| missing(format!("rod {index}")))?;
            let section = material::section(design, &rod.section, rod.material.as_ref())?;
            let structure = &design.structure;
            Ok(section.with_factors(
                structure.rod_bending_factor.value(),
                structure.rod_torsion_factor.value(),
            ))
        }
        BeamPart::Rib(_) => rib_section(design),
        BeamPart::Spar(index) => {
            let spar = design
                .spar
                .get(index)
                .ok_or_else(|| missing(format!("spar {index}")))?;
            material::section(design, &spar.section, spar.material.as_ref())
        }
    }
}

/// The section of a stiff rib: no mass, rigid in shear, as stiff along its length as the rod.
fn rib_section(design: &Design) -> Result<Section, StructureError> {
    let (mut bending, mut axial) = (0.0_f64, 0.0_f64);
    for rod in &design.rod {
        let section = material::section(design, &rod.section, rod.material.as_ref())?;
        bending = larger(larger(bending, section.gj_n_m2()), section.ei_flap_n_m2());
        axial = larger(axial, section.axial_stiffness_n());
    }
    let bending = bending * design.ribs.as_ref().map_or(1.0, |ribs| ribs.stiffness_ratio);
    Ok(Section::uncoupled(axial, bending, bending, bending))
}

#[cfg(test)]
mod tests {
    use super::*;

    fn design(load: &str) -> (Design, Mesh) {
        let text = format!(
            "format = 1\nname = 'w'\n[planform]\nlength_mm = 70.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\n\
             [[rod]]\nfrom_mm = 0.0\nto_mm = 69.0\nmaterial = 'steel'\nsection = {{ shape = 'round', diameter_mm = 1.0 }}\n\
             [material.steel]\ne_gpa = 200.0\npoisson = 0.3\ndensity_kg_m3 = 7800.0\n{load}"
        );
        let design = Design::from_toml(&text, "w.toml").unwrap();
        let planform = crate::geometry::Planform::from_design(&design).unwrap();
        let mesh = crate::mesh::generate(&design, &planform).unwrap();
        (design, mesh)
    }

    #[test]
    fn rods_bend_as_a_cantilever_in_one_piece_or_two() {
        let (whole, _) = design("");
        let ei_n_m2 = 200e9 * std::f64::consts::PI * 1e-12 / 64.0;
        for at_mm in [30.0_f64, 69.0] {
            let found = rod_deflection_m_n(&whole, at_mm).unwrap();
            let cantilever = (1e-3 * at_mm).powi(3) / (3.0 * ei_n_m2);
            assert!((found / cantilever - 1.0).abs() < 1e-12, "{found} {cantilever}");
        }
        // the outer piece of half the diameter bends sixteen times as far as it did
        let mut stepped = whole.clone();
        let mut outer = stepped.rod[0].clone();
        stepped.rod[0].to_mm = crate::input::quantity::Quantity::Stated(40.0);
        outer.from_mm = crate::input::quantity::Quantity::Stated(40.0);
        stepped.rod.push(outer);
        let same = rod_deflection_m_n(&stepped, 60.0).unwrap();
        assert!((same / rod_deflection_m_n(&whole, 60.0).unwrap() - 1.0).abs() < 1e-12);
        stepped.set("rod[1].section.diameter_mm", 0.5).unwrap();
        let more = rod_deflection_m_n(&stepped, 60.0).unwrap() - same;
        let outer_alone = 0.02_f64.powi(3) / (3.0 * ei_n_m2);
        assert!(
            (more / (15.0 * outer_alone) - 1.0).abs() < 1e-9,
            "{more} {outer_alone}"
        );
    }

    #[test]
    fn a_load_between_two_nodes_keeps_its_force_and_moment() {
        let load = "[[load]]\nat_mm = 33.333\nchord_offset_mm = 5.0\nnormal_offset_mm = -2.0\nforce_n = [1.0, 2.0, 3.0]\n";
        let (design, mesh) = design(load);
        let model = wing_model(&design, &mesh).unwrap();
        let loads = bench_loads(&design, &mesh, &model);
        let (mut force, mut moment) = (Vector3::zeros(), Vector3::zeros());
        for arm in &loads.arms {
            force += arm.force_n;
            moment += (model.nodes[arm.node] + arm.arm_m).cross(&arm.force_n);
        }
        let wanted = Vector3::new(1.0, 2.0, 3.0);
        assert!((force - wanted).norm() < 1e-14);
        assert!((moment - Vector3::new(0.033333, 0.005, -0.002).cross(&wanted)).norm() < 1e-14);
    }

    #[test]
    fn weight_of_a_rod_is_its_mass_times_gravity() {
        let (design, mesh) = design("[gravity]\nacceleration_m_s2 = [0.0, 0.0, -10.0]\n");
        let model = wing_model(&design, &mesh).unwrap();
        let weight: f64 = bench_loads(&design, &mesh, &model)
            .force_n
            .iter()
            .map(|f| f.z)
            .sum();
        let expected = -10.0 * 7800.0 * std::f64::consts::PI * 0.25e-6 * 0.069;
        assert!((weight / expected - 1.0).abs() < 1e-9, "{weight} {expected}");
    }
}
