//! Wings of ribs: stiff enough, loaded where the design says, and the air of a uniform wing in closed form.

use nalgebra::Vector3;
use washout::input::design::Design;

use crate::support::{Solved, near, shipped};

/// A massless beam with its elastic axis at mid-chord: length 0.5 m, chord 0.05 m, GJ 1, EI 0.5 and 20 N·m².
fn beam(more: &str) -> Solved {
    let text = format!(
        "format = 1\nname = 'beam'\n[planform]\nlength_mm = 500.0\noutline = [[0.0, 50.0], [500.0, 50.0]]\n\
         base_closure = 0.0\ntip_cut = 1.0\n[ribs]\nbays = 20\nrod_chord_fraction = 0.5\n\
         [[rod]]\nfrom_mm = 0.0\nto_mm = 500.0\n\
         section = {{ shape = 'given', ea_n = 1e6, gj_n_m2 = 1.0, ei_flap_n_m2 = 0.5, ei_edge_n_m2 = 20.0 }}\n\
         [observation]\ntip_station = 1.0\n{more}"
    );
    Solved::of(Design::from_toml(&text, "beam.toml").unwrap_or_else(|error| panic!("{error}")))
}

#[test]
fn ten_times_stiffer_ribs_move_twist_and_deflection_by_less_than_a_millionth() {
    let flow = [
        "gravity.root_pitch_deg=45",
        "steady.speed_m_s=30",
        "steady.root_angle_deg=2.2",
    ];
    let at = |ratio: &str| {
        let mut sets = flow.map(str::to_string).to_vec();
        sets.push(format!("ribs.stiffness_ratio={ratio}"));
        let wing = shipped("tang-dowell", &sets);
        [wing.tip_twist_deg(), wing.moved_mm(0.4508)[2]]
    };
    let (as_shipped, stiffer) = (at("1e4"), at("1e5"));
    for (a, b) in as_shipped.into_iter().zip(stiffer) {
        assert!((a / b - 1.0).abs() < 1e-6, "{a} {b}");
    }
}

#[test]
fn a_force_on_the_elastic_axis_bends_and_one_on_the_leading_edge_twists_by_its_lever_from_there() {
    let load = |offset_mm: f64| {
        beam(&format!(
            "[[load]]\nat_mm = 500.0\nchord_offset_mm = {offset_mm:?}\nforce_n = [0.0, 0.0, 0.001]\n"
        ))
    };
    assert!(load(25.0).tip_twist_deg().abs() < 1e-9);
    for offset_mm in [0.0, 50.0, -80.0] {
        // T L / GJ with the lever from the axis; a force aft of it, along +z, washes out
        let torque = 0.001 * (offset_mm - 25.0) * 1e-3;
        let expected = (torque * 0.5 / 1.0_f64).to_degrees();
        near(
            &format!("force at {offset_mm} mm"),
            load(offset_mm).tip_twist_deg(),
            expected,
            1e-6,
        );
    }
    near(
        "deflection",
        load(25.0).moved_mm(0.5)[2],
        1e3 * 0.001 * 0.125 / 1.5,
        1e-5,
    );
}

#[test]
fn the_weight_of_a_mass_on_an_arm_acts_where_the_arm_has_turned_to() {
    let wing = beam(
        "[[load]]\nat_mm = 500.0\nchord_offset_mm = -80.0\nnormal_offset_mm = 20.0\nmass_kg = 0.3\n\
         [gravity]\nacceleration_m_s2 = [0.0, 0.0, -9.80665]\nroot_pitch_deg = 30.0\n",
    );
    let solution = &wing.solution;
    let tip = *solution.mesh.rod_nodes().last().unwrap();
    assert!(solution.state.rotation[tip].angle().to_degrees() > 30.0);
    let node = Vector3::from(solution.mesh.nodes[tip]) + solution.state.displacement[tip];
    let place = node + solution.state.rotation[tip] * Vector3::new(0.0, -0.105, 0.020);
    let (sin, cos) = 30f64.to_radians().sin_cos();
    let weight = 0.3 * 9.80665 * Vector3::new(0.0, sin, -cos);
    let reaction = Vector3::from(solution.report.reaction_moment_n_m);
    let moment = place.cross(&weight);
    assert!((reaction + moment).norm() < 1e-5 * moment.norm());
}

#[test]
fn the_divergence_pressure_is_that_of_the_uniform_wing() {
    // e = c/4 between centre of pressure and axis: q_D = (π/2L)² GJ/(e c a), Bisplinghoff, Ashley & Halfman 1955, section 8-2
    let q_d = (std::f64::consts::PI / 1.0).powi(2) * 1.0 / (0.0125 * 0.05 * std::f64::consts::TAU);
    let speed = (2.0 * 0.5 * q_d / 1.225).sqrt();
    let wing = beam(&format!(
        "[steady]\nspeed_m_s = {speed:?}\nroot_angle_deg = 0.01\n[structure]\nkinematics = 'linear'\n\
         [air]\ndensity_kg_m3 = 1.225\ncoefficients = 'thin-airfoil'\ncentre_of_pressure = 'fixed'\n"
    ));
    let critical = wing.solution.report.critical_pressure_ratio.unwrap() * 0.5;
    near("critical pressure over q_D", critical, 1.0, 2e-3);
    // nose-up twist of the tip: α₀ (sec λL − 1), λL = (π/2)√½
    let lambda = std::f64::consts::FRAC_PI_2 * 0.5_f64.sqrt();
    near(
        "tip twist",
        -wing.tip_twist_deg(),
        0.01 * (1.0 / lambda.cos() - 1.0),
        2e-3,
    );
}

#[test]
fn a_pitched_bench_reads_the_plumb_line() {
    // a soft beam along its plane normal only: the wing's deflection d shows as d cos and d sin on the bench
    let at = |frame_deg: f64| {
        let wing = beam(&format!(
            "frame_pitch_deg = {frame_deg:?}\n[[load]]\nat_mm = 500.0\nchord_offset_mm = 25.0\nforce_n = [0.0, 0.0, -0.1]\n"
        ));
        wing.moved_mm(0.5)
    };
    let ([x, y, z], [x_30, y_30, z_30]) = (at(0.0), at(30.0));
    let (sin, cos) = 30f64.to_radians().sin_cos();
    assert!(y.abs() < 1e-9 && z < -5.0);
    assert!((x_30 - x).abs() < 1e-9 && (y_30 - z * sin).abs() < 1e-9 && (z_30 - z * cos).abs() < 1e-9);
}
