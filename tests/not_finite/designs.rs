//! Numbers of a design itself that are not finite, as no file can state them.

use washout::input::design::Design;

use crate::{refused, wing};

#[test]
fn loads_air_and_materials_that_are_not_finite_are_refused_without_an_effect_to_blame() {
    let load = "[[load]]\nat_mm = 35.0\nchord_offset_mm = 5.0\nforce_n = [0.0, 0.0, 0.001]\nmass_kg = 1e-5\n\
                [gravity]\nacceleration_m_s2 = [0.0, 0.0, -9.81]\n";
    type Change = fn(&mut Design);
    let changes: [(&str, Change); 9] = [
        ("the force (N)", |design| design.load[0].force_n[2] = f64::NAN),
        ("the moment (N·m)", |design| {
            design.load[0].moment_n_m[0] = f64::INFINITY
        }),
        ("the force (N)", |design| {
            design.gravity.as_mut().unwrap().acceleration_m_s2[2] = f64::NAN;
        }),
        ("the mass (kg)", |design| design.load[0].mass_kg = f64::NAN.into()),
        ("the angle of attack (rad)", |design| {
            design.flapping.as_mut().unwrap().frequency_hz = f64::NAN.into();
        }),
        ("the angle of attack (rad)", |design| {
            design.flapping.as_mut().unwrap().stop_angle_deg = f64::NAN.into();
        }),
        ("the compliance", |design| {
            design.material.get_mut("steel").unwrap().e_gpa = f64::NAN.into();
        }),
        ("the thickness (m) of the film", |design| {
            design.film.as_mut().unwrap().thickness_mm = f64::NAN.into();
        }),
        ("the pre-tension (N/m) of the film", |design| {
            design.film.as_mut().unwrap().pretension_n_per_m = f64::NAN.into();
        }),
    ];
    for (quantity, change) in changes {
        let mut design = wing(load);
        change(&mut design);
        let said = refused(&design, quantity);
        assert!(said.starts_with(quantity), "{quantity}: {said}");
        assert!(
            said.contains("correct the numbers of the design"),
            "{quantity}: {said}"
        );
    }
}
