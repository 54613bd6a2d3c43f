//! For each effect of the motion over the stroke the case of its card, with rates that are prescribed or known.

use std::f64::consts::{FRAC_PI_4, PI, TAU};
use std::sync::Arc;

use nalgebra::Vector3;
use washout::coupling::motion::motion;
use washout::coupling::wing::Wing;
use washout::coupling::{PeriodicSettings, periodic, solve_wing};
use washout::effects::{Motion, NodeLoad, StripMotion};
use washout::input::design::Design;
use washout::mesh::for_design;
use washout::progress::Progress;
use washout::structure::state::State;

use super::closed_forms::{rectangle, solve, wing, with};

const FILM: &str = "[film]\nmaterial = 'steel'\nthickness_mm = 0.01\n";
const FLAPPING: &str = "[flapping]\nfrequency_hz = 20.0\nhalf_amplitude_deg = 30.0\n";
const CHORD_M: f64 = 0.02;
/// Half as many elements along a line: a stiff plate is as it is on the default mesh.
const COARSE: &str = "[mesh]\nrefine = 0.5\n";

/// Force along z and moment about the leading edge of each strip of the wing at rest, per length, and its place.
fn strips(design: &Design, motion: &Motion) -> Vec<[f64; 3]> {
    let (_, mesh) = for_design(design, None).unwrap();
    let wing = Wing::with_motion(design, &mesh, None, Some(Arc::new(motion.clone()))).unwrap();
    let air = wing
        .strip_air(&wing.strips.shapes(&State::at_rest(mesh.nodes.len())), false)
        .unwrap();
    let strips = wing.strips.strips.iter().zip(&air);
    strips
        .map(|(strip, air)| {
            let points = strip.eta.iter().enumerate();
            let moment: f64 = points
                .map(|(k, eta)| eta * strip.chord_m * air.on_point_n(k).z)
                .sum();
            [strip.r_m, air.total_n.z / strip.width_m, moment / strip.width_m]
        })
        .collect()
}

/// Force and moment about the wing base by which a stiff wing that moves so is held, where it is solved.
fn held(mut design: Design, motion: Option<&Motion>) -> (Vector3<f64>, Vector3<f64>) {
    design.set("rod[0].section.diameter_mm", 10.0).unwrap();
    design.set("film.thickness_mm", 2.0).unwrap();
    let (_, mesh) = for_design(&design, None).unwrap();
    let wing = match motion {
        Some(known) => Wing::with_motion(&design, &mesh, None, Some(Arc::new(known.clone()))).unwrap(),
        None => wing(&design, &mesh),
    };
    let (solution, _) = solve_wing(&design, &wing, &mesh, None, &Progress::quiet()).unwrap();
    let report = solution.report;
    (report.reaction_force_n.into(), report.reaction_moment_n_m.into())
}

/// How an effect changes what holds the stiff wing.
fn held_more(base: &Design, effect: &str, motion: Option<&Motion>) -> (Vector3<f64>, Vector3<f64>) {
    let (before, after) = (
        held(base.clone(), motion),
        held(with(base.clone(), effect, 1.0), motion),
    );
    (after.0 - before.0, after.1 - before.1)
}

/// A wing that washes out at 100 rad/s at its base and 300 rad/s at its tip, with a drag torque of 0.64.
fn turning() -> Motion {
    let nothing = NodeLoad {
        force_n: Vector3::zeros(),
        moment_n_m: Vector3::zeros(),
    };
    let strip = |r_m: f64| StripMotion {
        r_m,
        twist_rate_rad_s: 100.0 + 2000.0 * r_m,
        twist_acceleration_rad_s2: 0.0,
    };
    Motion {
        inertia: vec![nothing; 2000],
        moved_air: vec![nothing; 2000],
        moved_air_of_stroke: vec![nothing; 2000],
        strips: vec![strip(0.0), strip(0.1)],
        drag_ratio: 0.64,
    }
}

/// π · 0.75 ρ U c² θ̇: at mid-span 2.3562 · 1.2 · 5.2638 · 4e-4 · 200 = 1.19067 N/m less.
#[test]
fn turning_sections_carry_rotational_lift() {
    let base = rectangle(&format!("{FILM}{FLAPPING}{COARSE}"));
    let before = strips(&base, &turning());
    let after = strips(&with(base.clone(), "rotational-lift", 1.0), &turning());
    for ([r_m, before, _], [_, after, _]) in before.iter().zip(&after) {
        let speed = TAU * 20.0 * PI / 6.0 * (r_m + 0.03);
        let expected = 0.75 * PI * 1.2 * speed * CHORD_M * CHORD_M * (100.0 + 2000.0 * r_m);
        assert!(
            ((before - after) / expected - 1.0).abs() < 1e-6,
            "{r_m}: {}",
            before - after
        );
    }
    // solved: 0.75 π ρ c² ω Φ ∫ (r + 0.03)(100 + 2000 r) dr = 0.0744148 · 1.766667 N less to hold
    let (force, _) = held_more(&base, "rotational-lift", Some(&turning()));
    assert!((force.z / 0.131466 - 1.0).abs() < 1e-3, "{force}");
}

/// ½ · 1.2 · 5 θ̇² c⁴/4: at mid-span 4.8e-3 N·m/m against the turn, with a force of 0.32 N/m.
#[test]
fn turning_sections_are_damped_by_the_square_of_the_rate() {
    let base = rectangle(&format!("{FILM}{FLAPPING}{COARSE}"));
    let before = strips(&base, &turning());
    let after = strips(&with(base.clone(), "rotational-damping", 1.0), &turning());
    for (before, after) in before.iter().zip(&after) {
        let rate = 100.0 + 2000.0 * before[0];
        let (force, moment) = (3.0 * rate * rate * 8e-6 / 3.0, 3.0 * rate * rate * 1.6e-7 / 4.0);
        assert!(((before[1] - after[1]) / force - 1.0).abs() < 1e-6);
        assert!(((before[2] - after[2]) / moment - 1.0).abs() < 1e-6);
    }
    // solved: ∫ θ̇² dr = (300³ − 100³) / 6000, so that 34.667 mN and 0.52 mN·m less are to be held
    let (force, moment) = held_more(&base, "rotational-damping", Some(&turning()));
    assert!((force.z / 0.034667 - 1.0).abs() < 1e-3, "{force}");
    assert!((moment.x / 5.2e-4 - 1.0).abs() < 1e-3, "{moment}");
}

/// Equal torque, Q ∝ 0.64 Φ²: 1.25 times the amplitude, 1.5625 times the load.
#[test]
fn amplitude_grows_as_drag_falls() {
    let base = rectangle(&format!("{FILM}{FLAPPING}{COARSE}"));
    let before = strips(&base, &turning());
    let after = strips(&with(base.clone(), "amplitude-drag", 0.5), &turning());
    for (before, after) in before.iter().zip(&after) {
        assert!((after[1] / before[1] - 1.5625).abs() < 1e-9);
    }
    // solved
    let (before, _) = held(base.clone(), None);
    let (after, _) = held(with(base, "amplitude-drag", 0.5), Some(&turning()));
    assert!(
        (after.norm() / before.norm() - 1.5625).abs() < 1e-3,
        "{after} {before}"
    );
}

/// ρ (π/4) c² Φ ω² sin 30 sin 45 over the span: 1.2 · 0.7854 · 4e-4 · 0.5236 · 15791 · 0.35355 · 8e-3 = 8.816e-3 N.
#[test]
fn added_mass_is_that_of_a_cylinder_on_the_chord() {
    let plate = FILM.replace("0.01", "0.15");
    let base = rectangle(&format!("{plate}{FLAPPING}phase_deg = 30.0\n{COARSE}"));
    let (_, mesh) = for_design(&base, None).unwrap();
    let motion = motion(&base, &mesh, None, None, &Progress::quiet()).unwrap();
    let sum = |loads: &[NodeLoad]| loads.iter().map(|load| load.force_n).sum::<Vector3<f64>>();
    let expected = 1.2
        * FRAC_PI_4
        * 4e-4
        * (PI / 6.0)
        * (TAU * 20.0).powi(2)
        * 0.5
        * FRAC_PI_4.sin()
        * 0.5
        * (0.13f64.powi(2) - 0.03f64.powi(2));
    assert!((expected / 8.816e-3 - 1.0).abs() < 1e-3);
    // slowing down, the wing decelerates along −z: its rod is pushed along +z, and air presses on, along −z
    let found = sum(&motion.moved_air_of_stroke);
    assert!((found.z / -expected - 1.0).abs() < 2e-3, "{found} {expected}");
    let on = with(base.clone(), "added-mass", 1.0);
    let [on, off] = [&on, &base].map(|design| wing(design, &mesh));
    let total = |wing: &Wing| wing.bench.force_n.iter().sum::<Vector3<f64>>();
    let added = total(&on) - total(&off);
    assert!((added - found - sum(&motion.moved_air)).norm() < 1e-12);
    // solved, a stiff wing that does not twist
    let (force, _) = held_more(&base, "added-mass", None);
    assert!((force.z / expected - 1.0).abs() < 5e-3, "{force} {expected}");
}

/// A rod of mass m from r₀ to r₀ + L at 30 deg of phase: its clamp holds back m Φ ω² sin 30 (r₀ + L/2), across the span.
#[test]
fn a_slowing_stroke_throws_the_wing_forward() {
    let mut design = with(
        rectangle(&format!("{FLAPPING}phase_deg = 30.0\n")),
        "inertia-off-mid-stroke",
        1.0,
    );
    design.air.density_kg_m3 = 0.0.into();
    let found = solve(&design).report.reaction_force_n;
    let mass_kg = 8000.0 * FRAC_PI_4 * 1e-6 * 0.1;
    let expected = mass_kg * PI / 6.0 * (TAU * 20.0).powi(2) * 0.5 * 0.08;
    // the wing moves against the air, along −y −z, and goes on that way: the clamp pulls along +y +z
    for part in [found[1], found[2]] {
        assert!(
            (part / (expected * FRAC_PI_4.sin()) - 1.0).abs() < 1e-6,
            "{found:?} {expected}"
        );
    }
}

/// In thin air little damps the wing, and twist under its own inertia at mid-stroke is the twist of the periodic motion.
#[test]
fn twist_with_its_inertia_is_that_of_the_periodic_motion() {
    let plate = FILM.replace("0.01", "0.15");
    let mut base = rectangle(&format!("{plate}{FLAPPING}{COARSE}"));
    base.air.density_kg_m3 = 0.05.into();
    let (_, mesh) = for_design(&base, None).unwrap();
    let found = periodic(
        &base,
        &mesh,
        None,
        &PeriodicSettings::default(),
        &Progress::quiet(),
    )
    .unwrap();
    let twist = |design: &Design| {
        let solution = solve(design);
        let wing = wing(design, &mesh);
        let shapes = wing.strips.shapes(&solution.state);
        let angles = shapes.chunks_exact(6).map(|shape| shape[2].atan2(shape[1]));
        angles.collect::<Vec<f64>>()
    };
    let [still, moving] = [&base, &with(base.clone(), "twist-dynamics", 1.0)].map(twist);
    let stations = found.stations_m().into_iter().enumerate();
    let pairs: Vec<[f64; 2]> = stations
        .map(|(index, r_m)| {
            let [periodic, ..] = found.twist(r_m, 0.0).unwrap();
            [moving[index] - still[index], periodic - still[index]]
        })
        .collect();
    let largest = pairs.iter().map(|pair| pair[1].abs()).fold(0.0, f64::max);
    let apart = pairs
        .iter()
        .map(|[more, expected]| (more - expected).abs())
        .fold(0.0, f64::max);
    println!("largest {largest:.4} rad, apart {apart:.4} rad");
    assert!(largest > 0.02);
    // modes beyond the eighth, harmonics beyond the thirteenth, and what damping there is
    assert!(apart < 0.1 * largest, "{pairs:?}");
}
