//! Effects of the structure: for each the case of its card, a closed form in the full model.

use nalgebra::{UnitQuaternion, Vector3};
use washout::coupling::wing::Wing;
use washout::effects::bind;
use washout::effects::custom::Custom;
use washout::input::design::{Design, Flat, Section};
use washout::mesh::{BeamPart, Mesh, for_design};
use washout::progress::Progress;
use washout::structure::state::State;
use washout::structure::{Equilibrium, Loads, Model, NewtonSettings};

use crate::closed_forms::{rectangle, solve, with};

const LENGTH_M: f64 = 0.1;
const CHORD_M: f64 = 0.02;
/// Of the 1 mm steel rod.
const GJ: f64 = 80e9 * std::f64::consts::PI / 32.0 * 1e-12;
const EI: f64 = 200e9 * std::f64::consts::PI / 64.0 * 1e-12;
pub const TORQUE: &str = "[[load]]\nat_mm = 100.0\nmoment_n_m = [0.001, 0.0, 0.0]\n";
pub const FORCE: &str = "[[load]]\nat_mm = 100.0\nforce_n = [0.0, 0.0, 1e-6]\n";
const GRAVITY: &str = "[gravity]\nacceleration_m_s2 = [0.0, 0.0, -10.0]\n";

pub fn also(mut design: Design, key: &str, value: f64) -> Design {
    design.set(key, value).unwrap();
    design
}

/// Rotation vector and displacement of the rod's end.
pub fn end_of_rod(design: &Design) -> (Vector3<f64>, Vector3<f64>) {
    let solution = solve(design);
    let tip = *solution.mesh.rod_nodes().last().unwrap();
    let turn = solution.state.rotation[tip].scaled_axis();
    (turn, solution.state.displacement[tip])
}

/// Twist under 1 mN·m over that of the steel rod.
pub fn relative_twist(design: &Design) -> f64 {
    end_of_rod(design).0.x / (0.001 * LENGTH_M / GJ)
}

/// Deflection under 1 µN over that of the steel rod; its shear adds 5e-5.
pub fn relative_deflection(design: &Design) -> f64 {
    end_of_rod(design).1.z / (1e-6 * LENGTH_M.powi(3) / (3.0 * EI))
}

pub fn assert_near(found: f64, expected: f64, tolerance: f64) {
    assert!(
        (found - expected).abs() <= tolerance * expected.abs(),
        "{found} {expected}"
    );
}

fn wing(design: &Design) -> (Wing, Mesh) {
    let (_, mesh) = for_design(design, None).unwrap();
    (Wing::new(design, &mesh, None).unwrap(), mesh)
}

/// A film of 6 µm, E t = 15,000 N/m, ν = 0.
fn film(more: &str) -> Design {
    rectangle(&format!(
        "[film]\nmaterial = 'soft'\nthickness_mm = 0.006\n{more}\n\
         [material.soft]\ne_gpa = 2.5\npoisson = 0.0\ndensity_kg_m3 = 1400.0\n"
    ))
}

/// Deflection of the middle of the film, held all around, under a pressure, m.
fn sag_m(design: &Design, pressure_pa: f64) -> f64 {
    let (wing, mesh) = wing(design);
    let mut model = wing.model;
    let mut loads = Loads::none(mesh.nodes.len());
    for (index, nodes) in mesh.triangles.iter().enumerate() {
        let third = pressure_pa * mesh.triangle_area_m2(index) / 3.0;
        nodes.iter().for_each(|&node| loads.force_n[node].z += third);
    }
    let inside = |x: f64, end: f64| x > 1e-9 && x < end - 1e-9;
    for (node, [x, y, _]) in mesh.nodes.iter().enumerate() {
        if !(inside(*x, LENGTH_M) && inside(*y, CHORD_M)) {
            model.hold(node, [true, true, true, false, false, false]);
        }
    }
    let away = |node: &[f64; 3]| (node[0] - 0.5 * LENGTH_M).hypot(node[1] - 0.5 * CHORD_M);
    let middle = (0..mesh.nodes.len()).min_by(|&a, &b| away(&mesh.nodes[a]).total_cmp(&away(&mesh.nodes[b])));
    let middle = middle.unwrap();
    assert!(away(&mesh.nodes[middle]) < 1e-3);
    let state = found(&model, &loads);
    state.displacement[middle].z
}

fn found(model: &Model, loads: &Loads) -> State {
    let nodes = model.nodes.len();
    let mut state = State::at_rest(nodes);
    let mut equilibrium = Equilibrium::new(model).unwrap();
    let settings = NewtonSettings::default();
    let from = Loads::none(nodes);
    equilibrium
        .solve(&mut state, &from, loads, &settings, &Progress::quiet())
        .unwrap();
    state
}

/// A long strip of width b in tension N: w = p b²/(8 N), 67.6 nm at 0.1 Pa and 74 N/m.
#[test]
fn a_film_in_tension_deflects_by_p_b_squared_over_8_n() {
    let design = with(film(""), "film-cure-tension", 74.0);
    assert_near(sag_m(&design, 0.1), 0.1 * CHORD_M.powi(2) / (8.0 * 74.0), 0.01);
}

/// Parabola of sag w: strain 8/3 (w/b)², tension p b²/(8 w) = E t (strain − slack).
#[test]
fn a_slack_film_carries_the_strain_beyond_its_slack() {
    let (slack, pressure_pa) = (0.002, 50.0);
    let excess = |w: f64| {
        let strain = 8.0 / 3.0 * (w / CHORD_M).powi(2);
        15_000.0 * (strain - slack) - pressure_pa * CHORD_M.powi(2) / (8.0 * w)
    };
    let (mut low, mut high) = (1e-4, 5e-3);
    for _ in 0..60 {
        let middle = 0.5 * (low + high);
        if excess(middle) < 0.0 {
            low = middle;
        } else {
            high = middle;
        }
    }
    let design = with(film(""), "film-slack", slack);
    assert_near(sag_m(&design, pressure_pa), low, 0.02);
}

/// Sag of a film without tension: w ∝ (p b⁴ / (E t))^⅓.
#[test]
fn a_film_of_half_the_modulus_sags_by_the_cube_root_of_two_more() {
    let tight = sag_m(&film(""), 1.0);
    let softer = sag_m(&with(film(""), "film-softening", 1.0), 1.0);
    assert_near(softer / tight, 2.0_f64.cbrt(), 1e-3);
    assert_near(tight, (3.0 * CHORD_M.powi(4) / (64.0 * 15_000.0)).cbrt(), 0.02);
}

/// Shear γ: E t γ/(2 (1 + ν)) in a film that carries compression; tension E t γ/2 at 45°, so E t γ/4 of shear, in one
/// that wrinkles.
#[test]
fn a_sheared_film_that_wrinkles_keeps_half_of_its_stiffness_times_one_plus_nu() {
    let base = rectangle("[film]\nmaterial = 'steel'\nthickness_mm = 0.01\ncompression = 'carries'\n");
    let energy = |design: &Design| {
        let (wing, mesh) = wing(design);
        let mut state = State::at_rest(mesh.nodes.len());
        for (moved, place) in state.displacement.iter_mut().zip(&mesh.nodes) {
            moved.x = 1e-5 * place[1];
        }
        wing.model.energy(&state)
    };
    let carries = energy(&base);
    assert_near(carries, 0.5 * 80e9 * 1e-5 * 1e-10 * LENGTH_M * CHORD_M, 1e-3);
    let wrinkles = energy(&with(base.clone(), "film-wrinkling", 1.0));
    assert_near(wrinkles / carries, 0.5 * 1.25, 1e-3);
    assert_near(energy(&with(base, "film-wrinkling", 0.5)) / carries, 0.8125, 1e-3);
}

/// A force along the flat at the centroid has the lever e = 0.08488 a about the shear centre: θ = e F L / GJ.
#[test]
fn a_force_beside_the_shear_centre_twists_by_its_lever() {
    let mut base = rectangle("[[load]]\nat_mm = 100.0\nforce_n = [0.0, 1e-5, 0.0]\n");
    base.rod[0].section = Section::HalfRound {
        diameter_mm: 1.0.into(),
        flat: Flat::InPlane,
    };
    let radius_m: f64 = 0.5e-3;
    let gj = 80e9 * 0.297_556_8 * radius_m.powi(4);
    let expected = 0.084_882_6 * radius_m * 1e-5 * LENGTH_M / gj;
    assert_near(end_of_rod(&base).0.x.abs(), expected, 1e-4);
    let further = with(base, "half-rod-shear-centre", 1.0);
    assert_near(end_of_rod(&further).0.x.abs(), 2.0 * expected, 1e-4);
}

/// ∫ (1 − exp(−x/λ)) dx = L − λ (1 − exp(−L/λ)), for λ = 10 mm: 0.9 of the twist.
#[test]
fn a_clamp_that_stops_warping_shortens_the_rod_by_its_decay_length() {
    let design = with(rectangle(TORQUE), "warping-restraint", 10.0);
    assert_near(
        relative_twist(&design),
        1.0 - 0.1 * (1.0 - (-10.0_f64).exp()),
        1e-9,
    );
}

/// Half as far again on the bench; 8 ms at 20 Hz, of 100 s: (8e-5)^0.2 of that, 0.1514; and with n = 0.1 its root.
#[test]
fn a_rod_that_creeps_twists_further_the_longer_the_load_lasts() {
    let flapping = format!("{TORQUE}[flapping]\nfrequency_hz = 20.0\nhalf_amplitude_deg = 30.0\n");
    let crept = |load: &str| with(rectangle(load), "rod-creep", 0.5);
    assert_near(relative_twist(&crept(TORQUE)), 1.5, 1e-9);
    assert_near(relative_twist(&crept(&flapping)), 1.0 + 0.5 * 0.151_411, 1e-6);
    let slower = also(crept(&flapping), "effects.rod-creep.exponent", 0.1);
    assert_near(relative_twist(&slower), 1.0 + 0.5 * 0.151_411_f64.sqrt(), 1e-6);
}

/// A strip of 3 × 1 mm: EI = 354 GPa · 3 mm · 1 mm³/12, GJ = 4.5 GPa · 0.2633 · 3 mm · 1 mm³, 1650 · 3e-6 kg/m.
#[test]
fn a_frame_adds_its_own_stiffness_to_that_of_the_rod() {
    let frame = |load: &str| {
        let design = with(rectangle(load), "leading-edge-frame", 1.0);
        let design = also(design, "effects.leading-edge-frame.width_mm", 3.0);
        also(design, "effects.leading-edge-frame.plies", 25.0)
    };
    let (bending, torsion) = (354e9 * 3e-12 / 12.0, 4.5e9 * 0.2633 * 3e-12);
    assert_near(relative_twist(&frame(TORQUE)), GJ / (GJ + torsion), 1e-3);
    assert_near(relative_deflection(&frame(FORCE)), EI / (EI + bending), 1e-3);
    let mass_kg = |design: &Design| wing(design).0.model.lumped_mass_kg().iter().sum::<f64>();
    let more = mass_kg(&frame("")) - mass_kg(&rectangle(""));
    assert_near(more, 1650.0 * 3e-6 * LENGTH_M, 1e-9);
}

#[test]
fn a_beam_of_given_stiffness_has_no_frame_and_no_clamp_that_stops_its_warping() {
    let given =
        "section = { shape = 'given', ea_n = 1e5, gj_n_m2 = 1e-2, ei_flap_n_m2 = 1e-2, ei_edge_n_m2 = 1e-2 }";
    let mut design = rectangle("");
    let table: toml::Table = given.parse().unwrap();
    design.rod[0].section = table["section"].clone().try_into().unwrap();
    for name in ["leading-edge-frame", "warping-restraint"] {
        let refused = washout::effects::bind(&with(design.clone(), name, 1.0)).unwrap_err();
        assert!(refused.to_string().contains("are given"), "{refused}");
        assert!(washout::effects::bind(&with(rectangle(""), name, 1.0)).is_ok());
    }
}

#[test]
fn a_beam_of_twice_the_bending_stiffness_bends_half_as_far() {
    let design = with(rectangle(FORCE), "skin-bending", 1.0);
    assert_near(relative_deflection(&design), 0.5, 1e-3);
    assert_near(
        relative_twist(&with(rectangle(TORQUE), "skin-bending", 1.0)),
        1.0,
        1e-9,
    );
}

/// A moment at the end bends the rod to a circle, EI κ + s EI (k κ + (1 − k) κ₀ tanh(κ/κ₀)) = M: the end turns by κ L. Here κ = 5/m,
/// with a skin as stiff as the rod that gives way at κ₀ = 0.2 rad / L = 2/m and keeps nothing, then half.
#[test]
fn a_skin_that_gives_way_carries_its_moment_and_no_more() {
    for kept in [0.0, 0.5] {
        let (bending, gives_way) = (5.0, 2.0_f64);
        let skin = kept * bending + (1.0 - kept) * gives_way * (bending / gives_way).tanh();
        let moment = EI * (bending + skin);
        let load = format!("[[load]]\nat_mm = 100.0\nmoment_n_m = [0.0, {moment}, 0.0]\n");
        let design = with(rectangle(&load), "skin-yielding", 1.0);
        let design = also(design, "effects.skin-yielding.from", gives_way * LENGTH_M);
        let design = also(design, "effects.skin-yielding.kept", kept);
        assert_near(end_of_rod(&design).0.y, bending * LENGTH_M, 1e-6);
    }
    // far below, it is as stiff as a skin that never gives way
    let design = also(
        with(rectangle(FORCE), "skin-yielding", 1.0),
        "effects.skin-yielding.from",
        1.0,
    );
    assert_near(relative_deflection(&design), 0.5, 1e-3);
}

#[test]
fn a_beam_of_twice_the_torsional_stiffness_twists_half_as_far() {
    assert_near(
        relative_twist(&with(rectangle(TORQUE), "skin-torsion", 1.0)),
        0.5,
        1e-9,
    );
    assert_near(
        relative_deflection(&with(rectangle(FORCE), "skin-torsion", 1.0)),
        1.0,
        1e-3,
    );
}

/// Free of torque, GJ τ + K κ = 0: a moment M about the chord twists by −s M L / ((1 − s²) √(EI GJ)); a force toward +z bends
/// the other way, and so washes out.
#[test]
fn a_coupled_rod_twists_under_a_bending_moment() {
    let moment = "[[load]]\nat_mm = 100.0\nmoment_n_m = [0.0, 1e-6, 0.0]\n";
    let design = with(rectangle(moment), "bend-twist-coupling", 0.4);
    let expected = -0.4 / (1.0 - 0.16) * 1e-6 * LENGTH_M / (EI * GJ).sqrt();
    assert_near(end_of_rod(&design).0.x, expected, 1e-4);
    let lifted = with(rectangle(FORCE), "bend-twist-coupling", 0.4);
    assert!(end_of_rod(&lifted).0.x > 0.0);
}

/// A steel spar of 1 × 0.3 mm at mid-span, and a film that is hardly there.
fn with_spar() -> Design {
    rectangle(
        "[[spar]]\nat_mm = 50.0\nmaterial = 'steel'\nsection = { shape = 'rectangle', width_mm = 1.0, thickness_mm = 0.3 }\n\
         [film]\nmaterial = 'nothing'\nthickness_mm = 0.0001\nresidual_compression = 1.0\n\
         [material.nothing]\ne_gpa = 1e-6\npoisson = 0.0\ndensity_kg_m3 = 0.0\n",
    )
}

/// Deflection of the spar's end under a force, its rod clamped, over F L³/(EI); and the share of its first element.
fn spar_deflection(design: &Design) -> (f64, f64) {
    let (wing, mesh) = wing(design);
    let mut model = wing.model;
    mesh.rod_nodes().into_iter().for_each(|node| model.clamp(node));
    let mut loads = Loads::none(mesh.nodes.len());
    let end = *mesh.spar_nodes(0).last().unwrap();
    loads.force_n[end].z = 1e-6;
    let rest = State::at_rest(mesh.nodes.len());
    let state = Equilibrium::new(&model)
        .unwrap()
        .solve_linear(&rest, &loads)
        .unwrap();
    let ei = 200e9 * 1e-3 * 0.3e-3_f64.powi(3) / 12.0;
    let first = mesh
        .beams
        .iter()
        .position(|beam| beam.part == BeamPart::Spar(0))
        .unwrap();
    let relative = state.displacement[end].z / (1e-6 * CHORD_M.powi(3) / ei);
    (relative, mesh.beam_length_m(first) / CHORD_M)
}

/// ⅓ + C EI/L · (mean of (1 − x/L)² over the first element, 1 − h + h²/3).
#[test]
fn a_joint_as_soft_as_its_spar_adds_three_deflections() {
    let (plain, _) = spar_deflection(&with_spar());
    assert_near(plain, 1.0 / 3.0, 1e-3);
    let (found, h) = spar_deflection(&with(with_spar(), "spar-joint-compliance", 1.0));
    assert_near(found - plain, 1.0 - h + h * h / 3.0, 1e-3);
}

/// s = ½: C = L/EI in the middle adds F L³/EI · ¼, spread over two elements ¼ + (2h)²/12.
#[test]
fn a_spar_cracked_in_the_middle_hinges_there() {
    let (plain, h) = spar_deflection(&with_spar());
    let cracked = also(
        with(with_spar(), "broken-spar", 0.5),
        "effects.broken-spar.place",
        0.5,
    );
    let (found, _) = spar_deflection(&cracked);
    assert_near(found - plain, 0.25 + h * h / 3.0, 1e-2);
    let missing = also(cracked, "effects.broken-spar.spar", 7.0);
    let (_, mesh) = for_design(&missing, None).unwrap();
    let refused = Wing::new(&missing, &mesh, None).unwrap_err().to_string();
    assert!(refused.contains("no spar 7"), "{refused}");
}

#[test]
fn a_spar_of_half_the_stiffness_bends_twice_as_far() {
    let (found, _) = spar_deflection(&with(with_spar(), "spar-stiffness", 1.0));
    assert_near(found, 2.0 / 3.0, 1e-3);
}

/// A formula of one's own on the spars, EI' = EI / (1 + x/L): ∫ (1 + ξ)(1 − ξ)² dξ = 5/12.
#[test]
fn a_spar_that_tapers_by_a_formula_of_ones_own_bends_by_its_integral() {
    let mut design = with_spar();
    let mut table = Custom::table("spars", "1 / (1 + along)");
    table.insert("strength".to_string(), toml::Value::Float(1.0));
    design.effects.insert("taper".to_string(), table);
    let (found, _) = spar_deflection(&design);
    assert_near(found, 5.0 / 12.0, 2e-3);
}

#[test]
fn a_root_as_soft_as_the_rod_doubles_the_twist_of_its_tip() {
    let design = with(rectangle(TORQUE), "root-flexure", 1.0);
    assert_near(relative_twist(&design), 2.0, 1e-9);
}

/// What the root turns by is the torque over the stiffness that its strength stands for, also where the table states the rod.
#[test]
fn the_stiffness_that_a_strength_of_a_root_stands_for_is_the_torque_over_the_turn() {
    let stated = also(
        with(rectangle(TORQUE), "root-flexure", 0.5),
        "effects.root-flexure.gj_n_m2",
        2.0 * GJ,
    );
    for design in [with(rectangle(TORQUE), "root-flexure", 0.5), stated] {
        let turn_rad = (relative_twist(&design) - 1.0) * 0.001 * LENGTH_M / GJ;
        let bound = bind(&design).unwrap();
        let (stiffness, unit) = bound[0].effect.stands_for(&bound[0].values, &design).unwrap();
        assert!(unit.starts_with("mN·m/rad"), "{unit}");
        assert_near(stiffness, 1.0 / turn_rad, 1e-9);
    }
}

/// k θ (1 + s (θ/θ₁)ᵖ) = T: the root turns by θ, the rod by T L/GJ beyond.
#[test]
fn a_root_that_stiffens_turns_until_its_torque_is_that_of_the_load() {
    let hinge = also(rectangle(TORQUE), "root.pitch_stiffness_n_m_per_rad", 0.002);
    let turn = |design: &Design| end_of_rod(design).0.x - 0.001 * LENGTH_M / GJ;
    assert_near(turn(&hinge), 0.5, 1e-9);
    for power in [2.0, 7.5] {
        let stiffened = with(hinge.clone(), "root-stiffening", 1.5);
        let stiffened = also(stiffened, "effects.root-stiffening.at", 25.0);
        let found = turn(&also(stiffened, "effects.root-stiffening.power", power));
        let torque = 0.002 * found * (1.0 + 1.5 * (found / 25.0_f64.to_radians()).powf(power));
        assert_near(torque, 0.001, 1e-6);
    }
}

/// 1 + 3 (1 − h + h²/3), h the share of the first element.
#[test]
fn a_root_as_soft_in_bending_as_the_rod_adds_three_deflections() {
    let design = with(rectangle(FORCE), "root-bending", 1.0);
    let (_, mesh) = for_design(&design, None).unwrap();
    let h = mesh.beam_length_m(0) / LENGTH_M;
    assert_near(relative_deflection(&design), 4.0 - 3.0 * h + h * h, 1e-3);
}

/// A rigid motion d of the whole wing meets the springs alone: s E t d, half of it at either half of the chord.
#[test]
fn a_held_root_edge_carries_what_its_springs_carry() {
    let (wing, mesh) = wing(&with(film(""), "root-chord-held", 2.0));
    let mut state = State::at_rest(mesh.nodes.len());
    state.displacement.iter_mut().for_each(|moved| moved.z = 1e-4);
    let equilibrium = Equilibrium::new(&wing.model).unwrap();
    let force = equilibrium.internal_loads(&state).force_n;
    let total: f64 = force.iter().map(|f| f.z).sum();
    assert_near(total, 2.0 * 15_000.0 * 1e-4, 1e-9);
    let moment: f64 = force.iter().zip(&mesh.nodes).map(|(f, x)| f.z * x[1]).sum();
    assert_near(moment, total * 0.5 * CHORD_M, 1e-9);
}

/// θ = T L/GJ + play, the way the load goes.
#[test]
fn play_at_the_stop_turns_the_wing_by_itself() {
    let elastic = 0.001 * LENGTH_M / GJ;
    let play = 2.0_f64.to_radians();
    let design = with(rectangle(TORQUE), "stop-backlash", 2.0);
    assert_near(end_of_rod(&design).0.x, elastic + play, 1e-9);
    let other = TORQUE.replace("0.001", "-0.001");
    let design = with(rectangle(&other), "stop-backlash", 2.0);
    assert_near(end_of_rod(&design).0.x, -elastic - play, 1e-9);
    assert_near(solve(&design).report.reaction_moment_n_m[0], 0.001, 1e-6);
}

/// Half of the rod's mass m = ρ A L at the trailing edge: reactions 1.5 m g, and m g c/2 about the span.
#[test]
fn a_mass_at_the_tip_pulls_with_its_weight() {
    let design = with(rectangle(GRAVITY), "tip-mass", 0.5);
    let design = also(design, "effects.tip-mass.chord", 1.0);
    let report = solve(&design).report;
    let weight_n = 8000.0 * std::f64::consts::FRAC_PI_4 * 1e-6 * LENGTH_M * 10.0;
    assert_near(report.reaction_force_n[2], 1.5 * weight_n, 1e-6);
    assert_near(report.reaction_moment_n_m[0], 0.5 * weight_n * CHORD_M, 1e-3);
}

#[test]
fn a_wing_of_twice_the_mass_weighs_twice_as_much() {
    let weight_n = |design: &Design| solve(design).report.reaction_force_n[2];
    let film = "[film]\nmaterial = 'steel'\nthickness_mm = 0.15\nresidual_compression = 1.0\n";
    let base = rectangle(&format!("{film}{GRAVITY}"));
    let heavier = weight_n(&with(base.clone(), "distributed-mass", 1.0));
    assert_near(heavier, 2.0 * weight_n(&base), 1e-6);
}

/// m g along (sin β, cos β sin τ, −cos β cos τ), β = 20°, τ = 30°.
#[test]
fn a_wing_in_gravity_hangs_with_its_weight() {
    let design = with(rectangle(""), "gravity", 2.0);
    let design = also(design, "effects.gravity.tilt_deg", 30.0);
    let design = also(design, "effects.gravity.slope_deg", 20.0);
    let held = solve(&design).report.reaction_force_n;
    let weight_n = 8000.0 * std::f64::consts::FRAC_PI_4 * 1e-6 * LENGTH_M * 2.0 * 9.80665;
    for (held, direction) in held.into_iter().zip([0.342_020, 0.469_846, -0.813_798]) {
        assert_near(held, -direction * weight_n, 1e-5);
    }
}

/// A level stream at 30 deg to the wing, or a level stroke plane: weight stands across both, so that along the chord it is m g sin 30 and m g sin 45, forward sweep or none.
#[test]
fn gravity_stands_by_the_angle_of_the_design() {
    let flapping = "[flapping]\nfrequency_hz = 0.1\nhalf_amplitude_deg = 1.0\n";
    let steady = "[steady]\nspeed_m_s = 0.001\nroot_angle_deg = 30.0\n";
    let swept = format!("{steady}sweep_deg = 20.0\n");
    let weight_n = 8000.0 * std::f64::consts::FRAC_PI_4 * 1e-6 * LENGTH_M * 9.80665;
    let aft = 20f64.to_radians();
    for (flow, [x, y, z]) in [
        (flapping, [0.0, 0.5_f64.sqrt(), -(0.5_f64.sqrt())]),
        (steady, [0.0, 0.5, -(0.75_f64.sqrt())]),
        (&swept, [0.5 * aft.sin(), 0.5 * aft.cos(), -(0.75_f64.sqrt())]),
    ] {
        let held = solve(&with(rectangle(flow), "gravity", 1.0))
            .report
            .reaction_force_n;
        for (held, direction) in held.into_iter().zip([x, y, z]) {
            assert!(
                (held + direction * weight_n).abs() < 1e-5 * weight_n,
                "{flow}: {held:?}"
            );
        }
    }
}

/// All of it is the large-rotation model to the last digit; hardly any of it is the linear one.
#[test]
fn a_linear_model_with_all_of_large_rotation_is_the_large_rotation_model() {
    let more = "[film]\nmaterial = 'steel'\nthickness_mm = 0.05\nresidual_compression = 1.0\n\
                [mesh]\nchordwise = 4\n[flapping]\nfrequency_hz = 60.0\nhalf_amplitude_deg = 40.0\n";
    let large = rectangle(more);
    let linear = rectangle(&format!("{more}[structure]\nkinematics = 'linear'\n"));
    let shape = |design: &Design| solve(design).state.displacement;
    let apart = |a: &[Vector3<f64>], b: &[Vector3<f64>]| {
        let size = b.iter().map(|u| u.norm()).fold(0.0, f64::max);
        a.iter().zip(b).map(|(a, b)| (a - b).norm()).fold(0.0, f64::max) / size
    };
    let [large, none] = [&large, &linear].map(shape);
    let share = |s: f64| shape(&with(linear.clone(), "large-rotation", s));
    assert!(apart(&none, &large) > 0.02, "{}", apart(&none, &large));
    assert!(apart(&share(1.0), &large) < 1e-8);
    // either model is very stiff against the shape of the other: a thousandth of a percent is felt, a billionth is not
    let near = [apart(&share(1.0 - 1e-10), &large), apart(&share(1e-10), &none)];
    assert!(near.iter().all(|near| *near < 1e-5), "{near:?}");
}

/// A stiff wing on a pitch spring k, a force F at the lever c: k θ = F c ((1 − s) + s cos θ).
#[test]
fn halfway_between_the_models_the_lever_is_halfway_too() {
    let more = "[root]\npitch_stiffness_n_m_per_rad = 1e-4\n[structure]\nkinematics = 'linear'\n\
                [[load]]\nat_mm = 10.0\nchord_offset_mm = 10.0\nforce_n = [0.0, 0.0, 0.008]\n";
    let turn = |strength: f64| {
        let solution = solve(&with(rectangle(more), "large-rotation", strength));
        let base = solution.mesh.rod_nodes()[0];
        let turn: UnitQuaternion<f64> = solution.state.rotation[base];
        turn.scaled_axis().x
    };
    for (strength, expected) in [(0.5, 0.704_718), (1.0, 0.641_134), (0.25, 0.746_776)] {
        // the fixed point of θ = 0.8 (1 − s + s cos θ)
        let theta = (0..200).fold(0.7, |theta: f64, _| {
            0.8 * (1.0 - strength + strength * theta.cos())
        });
        assert_near(theta, expected, 1e-5);
        assert_near(turn(strength), theta, 1e-3);
    }
}

/// Each part is thrown outward from the axis by Ω² y across it: ∫ y · Ω² y sin β cos β dm = m c²/3 Ω² sin β cos β for a
/// plate whose chord stands at β to the plane of motion; a mass at the trailing edge adds m c².
#[test]
fn the_propeller_moment_of_a_plate_is_a_third_of_m_c_squared() {
    let more = "[film]\nmaterial = 'steel'\nthickness_mm = 0.15\nresidual_compression = 1.0\n\
                [flapping]\nfrequency_hz = 20.0\nhalf_amplitude_deg = 30.0\n";
    let spinning = with(rectangle(more), "centrifugal-load", 1.0);
    let moment = |design: &Design, washout: f64| {
        let (wing, mesh) = wing(design);
        let turn = UnitQuaternion::new(Vector3::x() * washout);
        let of = |linear: &washout::structure::LinearForce| {
            let at = Vector3::from(mesh.nodes[linear.node]) + linear.arm_m;
            let force = linear.force_n + linear.gradient_n_m * (turn * at - at);
            (turn * at).cross(&force).x
        };
        wing.bench.linear.iter().map(of).sum::<f64>()
    };
    let plate_kg = 8000.0 * 0.15e-3 * LENGTH_M * CHORD_M;
    let rod_kg = 8000.0 * std::f64::consts::FRAC_PI_4 * 1e-6 * LENGTH_M;
    let rate = std::f64::consts::TAU * 20.0 * 30.0_f64.to_radians();
    let with_mass = with(spinning.clone(), "tip-mass", 0.1);
    let with_mass = also(with_mass, "effects.tip-mass.chord", 1.0);
    for washout in [0.0, 0.3] {
        let (sine, cosine) = (std::f64::consts::FRAC_PI_4 - washout).sin_cos();
        let unit = rate * rate * CHORD_M.powi(2) * sine * cosine;
        let plain = moment(&spinning, washout);
        assert_near(plain, plate_kg / 3.0 * unit, 0.01);
        let more = moment(&with_mass, washout) - plain;
        assert_near(more, 0.1 * (plate_kg + rod_kg) * unit, 1e-6);
    }
}

/// A wing that turns as a rigid body strains its root spring alone: ½ k θ².
#[test]
fn a_rigid_turn_stores_energy_in_the_root_spring_alone() {
    let stiffness = 0.02;
    let base = film(&format!("[root]\npitch_stiffness_n_m_per_rad = {stiffness:?}\n"));
    let (wing, mesh) = wing(&base);
    let mut state = State::at_rest(mesh.nodes.len());
    let angle = 0.3_f64;
    let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), angle);
    let root = Vector3::from(mesh.nodes[*mesh.rod_nodes().first().unwrap()]);
    for (node, place) in mesh.nodes.iter().enumerate() {
        let arm = Vector3::from(*place) - root;
        state.displacement[node] = turn * arm - arm;
        state.rotation[node] = turn;
    }
    assert_near(wing.model.energy(&state), 0.5 * stiffness * angle * angle, 1e-6);
}
