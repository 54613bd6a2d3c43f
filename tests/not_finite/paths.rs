//! Every seam of an effect poisoned, in a solve and in all else that asks for the same loads.

use washout::coupling::vibration::Standing;
use washout::coupling::wing::Wing;
use washout::coupling::{
    self, BladeAir, BladeSection, CouplingError, PeriodicSettings, Sensitivity, SensitivityError, periodic,
};
use washout::input::design::Design;
use washout::mesh::for_design;
use washout::progress::Progress;
use washout::structure::state::State;

use crate::poison::{AIR, WING};
use crate::{poisoned, refused, wing};

#[test]
fn air_that_is_not_finite_is_refused_with_the_strip_and_the_effect() {
    for (kind, quantity) in AIR.into_iter().enumerate() {
        for kinematics in ["large-rotation", "linear"] {
            let more = format!("[structure]\nkinematics = '{kinematics}'\n");
            let said = refused(&poisoned("poisoned-air", kind, &more), quantity);
            assert!(said.starts_with(quantity), "{quantity}: {said}");
            for word in [
                "of the strip at r = ",
                " mm (angle of attack 4",
                "effects.poisoned-air",
            ] {
                assert!(said.contains(word), "{quantity}: no '{word}' in {said}");
            }
        }
    }
}

/// Finite at rest, where the search starts, and poisoned where it would end.
#[test]
fn air_that_is_not_finite_on_the_way_to_equilibrium_is_refused_too() {
    for kind in [0, 2, 5, 6, 7] {
        for accelerator in ["newton", "anderson", "aitken", "none"] {
            let more = format!("[coupling]\naccelerator = '{accelerator}'\n");
            let mut design = poisoned("poisoned-air", kind, &more);
            design.set("effects.poisoned-air.beyond", 0.05).unwrap();
            let said = refused(&design, &format!("{} with {accelerator}", AIR[kind]));
            assert!(said.contains("effects.poisoned-air"), "{said}");
        }
    }
}

#[test]
fn a_structure_or_a_load_that_is_not_finite_is_refused_with_its_place_and_the_effect() {
    let gravity = "[gravity]\nacceleration_m_s2 = [0.0, 0.0, -9.81]\n";
    for (kind, quantity) in WING.into_iter().enumerate() {
        let said = refused(&poisoned("poisoned-wing", kind, gravity), quantity);
        assert!(said.starts_with(quantity), "{quantity}: {said}");
        let place = if matches!(kind, 6 | 10) {
            "of the film"
        } else {
            "at r = 3"
        };
        for word in [place, "effects.poisoned-wing"] {
            assert!(said.contains(word), "{quantity}: no '{word}' in {said}");
        }
    }
    let linear = "[structure]\nkinematics = 'linear'\n";
    let said = refused(&poisoned("poisoned-kinematics", 0, linear), "kinematics");
    assert!(
        said.starts_with("the share of large rotation") && said.contains("effects.poisoned-kinematics"),
        "{said}"
    );
}

fn not_finite<T>(found: Result<T, CouplingError>, what: &str) {
    match found {
        Err(CouplingError::NotFinite { .. }) => {}
        Err(other) => panic!("{what}: {other}"),
        Ok(_) => panic!("{what}: found"),
    }
}

#[test]
fn modes_and_the_motion_over_the_stroke_are_refused_as_the_solve_is() {
    let quiet = Progress::quiet();
    for (name, kind) in [("poisoned-wing", 9), ("poisoned-air", 2), ("poisoned-air", 7)] {
        let design = poisoned(name, kind, "");
        let (_, mesh) = for_design(&design, None).unwrap();
        let moving = periodic(&design, &mesh, None, &PeriodicSettings::default(), &quiet);
        not_finite(moving, "motion over the stroke");
    }
    let sound = wing("");
    let (_, mesh) = for_design(&sound, None).unwrap();
    let solution = coupling::solve(&sound, &mesh, None, &quiet).unwrap();
    for kind in [0, 5, 9] {
        let design = poisoned("poisoned-wing", kind, "");
        not_finite(Standing::unloaded(&design, &mesh, None, &quiet), "unloaded modes");
        not_finite(Standing::loaded(&design, &solution), "loaded modes");
    }
}

/// A rate whose right-hand side is not finite is no sign of divergence.
#[test]
fn a_rate_toward_a_load_that_is_not_finite_is_refused_and_not_taken_for_divergence() {
    for (name, kind) in [("poisoned-air", 2), ("poisoned-air", 6), ("poisoned-wing", 0)] {
        let design = wing(&format!("[effects.{name}]\nstrength = 0.0\nkind = {kind}\n"));
        let (_, mesh) = for_design(&design, None).unwrap();
        let solution = coupling::solve(&design, &mesh, None, &Progress::quiet()).unwrap();
        let solved = Wing::new(&design, &mesh, None).unwrap();
        let remesh = |design: &Design| for_design(design, None);
        let mut sensitivity = Sensitivity::new(&design, &solved, None, &solution, &remesh).unwrap();
        let error = sensitivity
            .rate(&format!("effects.{name}.strength"))
            .expect_err(name);
        assert!(
            matches!(error, SensitivityError::Coupling(CouplingError::NotFinite { .. })),
            "{name} {kind}: {error}"
        );
    }
}

#[test]
fn a_blade_element_that_is_not_finite_is_refused_with_the_effect() {
    let section = BladeSection {
        r_m: 0.06,
        chord_m: 0.02,
        alpha_rad: 0.7,
        speed_m_s: 5.0,
        phase_rad: 0.0,
        twist_rate_rad_s: 0.0,
        normal_acceleration_m_s2: 0.0,
        drag_ratio: 1.0,
    };
    for kind in [0, 1, 2, 3, 6] {
        let design = poisoned("poisoned-air", kind, "");
        let (planform, _) = for_design(&design, None).unwrap();
        let air = BladeAir::new(&design, &planform, None).unwrap();
        let said = air.force(&section).expect_err(AIR[kind]).to_string();
        assert!(
            said.contains("not finite") && said.contains("effects.poisoned-air"),
            "{said}"
        );
        let inboard = BladeSection { r_m: 0.02, ..section };
        assert!(air.force(&inboard).unwrap().iter().all(|part| part.is_finite()));
    }
}

/// The strips of a shape that is none say so, and carry no load.
#[test]
fn a_shape_that_is_not_finite_carries_no_load() {
    let design = wing("");
    let (_, mesh) = for_design(&design, None).unwrap();
    let solved = Wing::new(&design, &mesh, None).unwrap();
    let mut state = State::at_rest(mesh.nodes.len());
    state.displacement[mesh.leading_edge[2]].z = f64::NAN;
    for derivative in [false, true] {
        let said = solved
            .strip_air(&solved.strips.shapes(&state), derivative)
            .unwrap_err();
        assert!(
            said.to_string().starts_with("the shape (m) of the strip at r = "),
            "{said}"
        );
    }
    not_finite(solved.loads_on(&state), "loads");
}
