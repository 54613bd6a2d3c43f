//! For each effect the case of its card: a closed form in the full model that a wrong factor of 2 would miss.

use nalgebra::Vector3;
use washout::coupling::motion::motion_needed;
use washout::coupling::wing::Wing;
use washout::coupling::{self, solution::Solution};
use washout::input::design::Design;
use washout::mesh::{Mesh, for_design};
use washout::progress::Progress;
use washout::structure::state::State;

/// A 100 mm long rectangle of 20 mm chord with a 1 mm steel rod, and `more`.
pub fn rectangle(more: &str) -> Design {
    let text = format!(
        "format = 1\nname = 'w'\n[planform]\nlength_mm = 100.0\nroot_offset_mm = 30.0\ntip_cut = 1.0\n\
         outline = [[0.0, 20.0], [100.0, 20.0]]\n\
         [[rod]]\nfrom_mm = 0.0\nto_mm = 100.0\nmaterial = 'steel'\nsection = {{ shape = 'round', diameter_mm = 1.0 }}\n\
         [material.steel]\ne_gpa = 200.0\ng_gpa = 80.0\npoisson = 0.25\ndensity_kg_m3 = 8000.0\n\
         [coupling]\ntwist_tolerance_deg = 1e-7\nresidual_tolerance = 1e-8\n{more}"
    );
    Design::from_toml(&text, "w.toml").unwrap_or_else(|error| panic!("{error}"))
}

const FILM: &str = "[film]\nmaterial = 'steel'\nthickness_mm = 0.01\n";
const FLAPPING: &str = "[flapping]\nfrequency_hz = 20.0\nhalf_amplitude_deg = 30.0\n";

pub fn with(mut design: Design, effect: &str, strength: f64) -> Design {
    design
        .set(&format!("effects.{effect}.strength"), strength)
        .unwrap();
    design
}

/// The wing of a design, with its motion over the stroke where an effect is made from it.
pub fn wing(design: &Design, mesh: &Mesh) -> Wing {
    let motion = motion_needed(design, mesh, None, None, &Progress::quiet()).unwrap();
    Wing::with_motion(design, mesh, None, motion).unwrap()
}

pub fn solve(design: &Design) -> Solution {
    let (_, mesh) = for_design(design, None).unwrap();
    coupling::solve(design, &mesh, None, &Progress::quiet()).unwrap()
}

/// Total air force and moment about the wing base on the wing at rest.
fn air_at_rest(design: &Design) -> (Vec<f64>, Vector3<f64>) {
    let (_, mesh) = for_design(design, None).unwrap();
    let wing = wing(design, &mesh);
    let air = wing
        .strip_air(&wing.strips.shapes(&State::at_rest(mesh.nodes.len())), false)
        .unwrap();
    let nodal = wing.air_force(&air);
    let moment = nodal
        .iter()
        .zip(&mesh.nodes)
        .map(|(f, x)| Vector3::from(*x).cross(f))
        .sum();
    (air.iter().map(|strip| strip.total_n.norm()).collect(), moment)
}

/// θ = T L / GJ, GJ = 80 GPa · π/32 · (1 mm)⁴: 1 mN·m over 100 mm gives 0.7295 deg; with s = 1 twice that.
#[test]
fn a_rod_of_half_the_stiffness_twists_twice_as_far() {
    let load = "[[load]]\nat_mm = 100.0\nmoment_n_m = [0.001, 0.0, 0.0]\n";
    let turn = |design: &Design| {
        let solution = solve(design);
        let tip = *solution.mesh.rod_nodes().last().unwrap();
        solution.state.rotation[tip].scaled_axis().x
    };
    let expected = 0.001 * 0.1 / (80e9 * std::f64::consts::PI / 32.0 * 1e-12);
    assert!((turn(&rectangle(load)) / expected - 1.0).abs() < 1e-9);
    let softer = with(rectangle(load), "rod-shear-modulus", 1.0);
    assert!((turn(&softer) / expected - 2.0).abs() < 1e-9);
}

/// The moment about the leading edge is Σ F_n x c: at 45 deg Dickson's x is 0.255, so a shift by 0.0255 makes a tenth more.
#[test]
fn twist_of_a_stiff_chord_goes_with_the_lever_of_the_centre_of_pressure() {
    let base = rectangle(&format!("{FILM}{FLAPPING}"));
    let (_, before) = air_at_rest(&base);
    let (_, after) = air_at_rest(&with(base, "centre-of-pressure-shift", 0.0255));
    assert!(
        (after.x / before.x - 1.1).abs() < 1e-9,
        "{} {}",
        after.x,
        before.x
    );
    assert!((after.z / before.z - 1.0).abs() < 1e-12);
}

/// At r = 90 mm of 100 mm, 30 mm from the axis: f = 10/(120 · 0.196116) = 0.42492, F = (2/π) acos(e^−f) = 0.54636.
#[test]
fn prandtl_factor_scales_the_load_of_every_strip() {
    let base = rectangle(&format!("{FILM}{FLAPPING}"));
    let (before, _) = air_at_rest(&base);
    let (after, _) = air_at_rest(&with(base.clone(), "tip-loss-prandtl", 0.5));
    let (_, mesh) = for_design(&base, None).unwrap();
    let wing = Wing::new(&base, &mesh, None).unwrap();
    let loss =
        |r_m: f64| (-(0.1 - r_m) / ((r_m + 0.03) * 0.196116)).exp().acos() / std::f64::consts::FRAC_PI_2;
    assert!((loss(0.09) - 0.54636).abs() < 1e-4);
    for ((before, after), strip) in before.iter().zip(&after).zip(&wing.strips.strips) {
        let expected = 0.5 + 0.5 * loss(strip.r_m);
        assert!(
            (after / before - expected).abs() < 1e-6,
            "{} {}",
            after / before,
            expected
        );
    }
}

/// A uniform rod of mass m from r₀ to r₀ + L, turning at Ω, pulls on its clamp with m Ω² (r₀ + L/2), stretch aside.
#[test]
fn centrifugal_force_of_a_spinning_rod_is_m_omega_squared_r() {
    let mut design = with(rectangle(FLAPPING), "centrifugal-load", 1.0);
    design.air.density_kg_m3 = 0.0.into();
    let solution = solve(&design);
    let mass_kg = 8000.0 * std::f64::consts::FRAC_PI_4 * 1e-6 * 0.1;
    let rate = std::f64::consts::TAU * 20.0 * 30.0_f64.to_radians();
    let expected = mass_kg * rate * rate * (0.03 + 0.05);
    let found = solution.report.reaction_force_n[0];
    assert!((found / -expected - 1.0).abs() < 1e-5, "{found} {expected}");
}
