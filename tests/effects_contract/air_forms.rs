//! For each effect of the air the case of its card, on a stiff rectangle in the full model.

use nalgebra::{UnitQuaternion, Vector3};
use std::f64::consts::{PI, TAU};
use washout::aero::CoefficientLaw;
use washout::coupling::BladeAir;
use washout::coupling::wing::Wing;
use washout::effects::{ALL, Need, Seam, is_applicable};
use washout::input::design::Design;
use washout::mesh::for_design;
use washout::structure::state::State;

use super::closed_forms::{rectangle, solve, with};

pub const FILM: &str = "[film]\nmaterial = 'steel'\nthickness_mm = 0.01\n";
const FLAPPING: &str = "[flapping]\nfrequency_hz = 20.0\nhalf_amplitude_deg = 30.0\n";
/// Wing, chord and axis of [`rectangle`].
const LENGTH_M: f64 = 0.1;
const CHORD_M: f64 = 0.02;
const OFFSET_M: f64 = 0.03;
const HALF_AMPLITUDE: f64 = PI / 6.0;

fn wing() -> Design {
    rectangle(&format!("{FILM}{FLAPPING}"))
}

/// One strip of the wing turned by `twist_rad` about its leading edge.
pub struct Found {
    pub r_m: f64,
    pub width_m: f64,
    pub chord_m: f64,
    /// Force per width along and across the stream of the root, N/m.
    pub drag: f64,
    pub lift: f64,
    /// Moment about the leading edge per width, N·m/m.
    pub moment: f64,
}

pub fn strips(design: &Design, twist_rad: f64) -> Vec<Found> {
    let (_, mesh) = for_design(design, None).unwrap();
    let wing = Wing::new(design, &mesh, None).unwrap();
    let turn = UnitQuaternion::from_axis_angle(&Vector3::x_axis(), twist_rad);
    let mut state = State::at_rest(mesh.nodes.len());
    for (node, x) in mesh.nodes.iter().enumerate() {
        state.displacement[node] = turn * Vector3::from(*x) - Vector3::from(*x);
        state.rotation[node] = turn;
    }
    let flow = wing.air.as_ref().unwrap().flow;
    let stream = flow.velocity(0.05).normalize();
    let across = flow.lift_direction();
    let air = wing.strip_air(&wing.strips.shapes(&state), false).unwrap();
    let found = |(strip, air): (
        &washout::coupling::strips::Strip,
        &washout::coupling::strip_air::StripAir,
    )| {
        let mut moment = 0.0;
        for (point, eta) in strip.eta.iter().enumerate() {
            let arm = turn * Vector3::new(0.0, eta * strip.chord_m, 0.0);
            moment += arm.cross(&air.on_point_n(point)).x;
        }
        Found {
            r_m: strip.r_m,
            width_m: strip.width_m,
            chord_m: strip.chord_m,
            drag: air.total_n.dot(&stream) / strip.width_m,
            lift: air.total_n.dot(&across) / strip.width_m,
            moment: moment / strip.width_m,
        }
    };
    wing.strips.strips.iter().zip(&air).map(found).collect()
}

/// Compares every strip of a wing without and with an effect.
fn each(base: &Design, effect: &str, strength: f64, twist_rad: f64, check: impl Fn(&Found, &Found)) {
    let before = strips(base, twist_rad);
    let after = strips(&with(base.clone(), effect, strength), twist_rad);
    assert!(before.len() > 10);
    for (before, after) in before.iter().zip(&after) {
        assert_eq!((before.r_m, before.width_m), (after.r_m, after.width_m));
        check(before, after);
    }
}

#[track_caller]
pub fn close(found: f64, expected: f64, tolerance: f64) {
    assert!((found / expected - 1.0).abs() < tolerance, "{found} {expected}");
}

/// ½ρU²c, N/m.
fn load(r_m: f64) -> f64 {
    let speed = TAU * 20.0 * HALF_AMPLITUDE * (r_m + OFFSET_M);
    0.5 * 1.2 * speed * speed * CHORD_M
}

/// Half of the load is lost at the tip; half of a mean chord (10 mm) inward the loss has fallen to 18.4 %.
#[test]
fn exponential_tip_loss_fades_inward_within_half_a_chord() {
    each(&wing(), "tip-loss-exponential", 0.5, 0.0, |before, after| {
        let expected = 1.0 - 0.5 * (-(LENGTH_M - before.r_m) / 0.01).exp();
        close(after.lift / before.lift, expected, 1e-9);
        close(after.moment / before.moment, expected, 1e-9);
    });
}

/// 45 deg, s = 0.2: drag and lift at the strip at mid-span (U = 5.2638 m/s) are 1.2 · 0.33250 · 1.70375 and 1.2 · 0.33250 · 1.80456.
#[test]
fn scaled_coefficients_scale_force_and_moment() {
    each(&wing(), "coefficient-scale", 0.2, 0.0, |before, after| {
        close(after.drag, 1.2 * load(before.r_m) * 1.703746, 1e-5);
        close(after.lift, 1.2 * load(before.r_m) * 1.804561, 1e-5);
        close(after.moment, 1.2 * before.moment, 1e-12);
    });
}

#[test]
fn scaled_drag_leaves_lift() {
    each(&wing(), "drag-scale", 0.3, 0.0, |before, after| {
        close(after.drag, 1.3 * load(before.r_m) * 1.703746, 1e-5);
        close(after.lift, before.lift, 1e-12);
        // at 45 deg both coefficients push alike on the plate
        let expected = (1.804561 + 1.3 * 1.703746) / (1.804561 + 1.703746);
        close(after.moment / before.moment, expected, 1e-6);
    });
}

/// 12 deg of twist leave 33 deg, where the law is asked at 33 − 5 sin 66 = 28.432 deg: C_L = 1.39586 there, 1.53275 at 33.
#[test]
fn lift_at_an_angle_is_that_of_the_warped_angle() {
    let lift = |degrees: f64| 0.225 + 1.58 * (2.13 * degrees - 7.2).to_radians().sin();
    let warped = 33.0 - 5.0 * 66f64.to_radians().sin();
    each(
        &wing(),
        "stall-shift",
        5.0,
        12f64.to_radians(),
        |before, after| {
            close(before.lift, load(before.r_m) * lift(33.0), 1e-9);
            close(after.lift, load(before.r_m) * lift(warped), 1e-9);
            close(after.drag, before.drag, 1e-9);
        },
    );
}

#[test]
fn denser_air_scales_force_and_moment() {
    each(&wing(), "air-density", -0.1, 0.1, |before, after| {
        close(after.lift, 0.9 * before.lift, 1e-12);
        close(after.drag, 0.9 * before.drag, 1e-12);
        close(after.moment, 0.9 * before.moment, 1e-12);
    });
    let mut thin = wing();
    thin.air.density_kg_m3 = 1.08.into();
    let expected = strips(&thin, 0.1);
    for (found, expected) in strips(&with(wing(), "air-density", -0.1), 0.1)
        .iter()
        .zip(&expected)
    {
        close(found.lift, expected.lift, 1e-12);
    }
}

/// 0.2 rad of twist and a gain of 2 a radian: 1.4 times the lift at the same drag.
#[test]
fn lift_grows_with_local_twist_in_proportion() {
    each(&wing(), "lift-gain-linear", 2.0, 0.2, |before, after| {
        close(after.lift, 1.4 * before.lift, 1e-9);
        close(after.drag, before.drag, 1e-9);
    });
}

/// At its scale of 15 deg the gain has reached tanh 1 = 0.76159 of its bound, at 60 deg (beyond 45 the lift points down) 0.99933.
#[test]
fn lift_gain_levels_off_at_its_scale() {
    for (degrees, share) in [(15.0, 0.761594), (60.0, 0.999329)] {
        each(
            &wing(),
            "lift-gain-saturating",
            0.5,
            f64::to_radians(degrees),
            |before, after| {
                close(after.lift / before.lift, 1.0 + 0.5 * share, 1e-6);
                close(after.drag, before.drag, 1e-9);
            },
        );
    }
}

/// Four chords of 20 mm from the axis are 50 mm from the base: half of the loss there, less inside, more outside; of lift, drag and moment, as all of it is across the
/// chord.
#[test]
fn sections_beyond_four_chords_lose_force_across_their_chord() {
    for twist in [0.0, 0.3] {
        each(
            &wing(),
            "leading-edge-vortex-loss",
            0.4,
            twist,
            |before, after| {
                let beyond = (before.r_m + OFFSET_M) / CHORD_M - 4.0;
                // tanh as a logistic function
                let left = 1.0 - 0.4 / (1.0 + (-4.0 * beyond).exp());
                let [was, now] = [before, after].map(|strip| across_and_along(strip, twist));
                close(now[0] / was[0], left, 1e-9);
                assert!((now[1] - was[1]).abs() < 1e-9 * was[0]);
                close(after.moment / before.moment, left, 1e-9);
                assert!(after.lift < before.lift && after.drag < before.drag);
            },
        );
    }
}

/// Thin airfoil at 3 deg, U = 5.2638 m/s at mid-span: p = ½ρU² · 6α cos α = 5.215 Pa there. With p₁ = 5 Pa h = 0.02 ∛2 u/(1 + u²)^⅓, and C_L grows by 4π h cos²α at
/// half the chord instead of a quarter. Turned to −3 deg all of it turns over, and at 0 there is none.
#[test]
fn the_bulge_of_the_film_goes_with_its_load_and_turns_with_it() {
    let mut base = rectangle(&format!(
        "{FILM}{FLAPPING}stop_angle_deg = 3.0\n[air]\ncoefficients = 'thin-airfoil'\nlift_slope_per_rad = 6.0\n\
         centre_of_pressure = 'fixed'\ncentre_of_pressure_fraction = 0.25\n"
    ));
    base.name = "cambered".into();
    base = with(base, "film-camber", 0.0);
    base.set("effects.film-camber.pressure_pa", 5.0).unwrap();
    for degrees in [3.0_f64, -3.0] {
        let alpha = degrees.to_radians();
        let twist = 3f64.to_radians() - alpha;
        each(&base, "film-camber", 0.02, twist, |before, after| {
            close(before.lift, load(before.r_m) * 6.0 * alpha, 1e-9);
            let pressure = load(before.r_m) / CHORD_M * 6.0 * alpha * alpha.cos() / 5.0;
            let bulge = 0.02 * (2.0 / (1.0 + pressure * pressure)).cbrt() * pressure;
            let gain = 4.0 * PI * bulge * alpha.cos().powi(2);
            close(after.lift - before.lift, load(before.r_m) * gain, 1e-9);
            let arm = 0.5 * CHORD_M * alpha.cos();
            close(after.moment - before.moment, load(before.r_m) * gain * arm, 1e-9);
        });
    }
    each(&base, "film-camber", 0.02, 3f64.to_radians(), |_, after| {
        assert!(after.lift.abs() < 1e-12 && after.moment.abs() < 1e-15);
    });
}

/// At 45 deg of twist a wing at 45 deg is feathered: with a bulge of any size it carries nothing there, and washes out before and in behind, so that no softness takes it beyond.
#[test]
fn a_bulging_film_leaves_feathering_where_it_is() {
    let bulging = with(wing(), "film-camber", 0.3);
    for degrees in [30.0_f64, 40.0, 44.0, 46.0, 50.0, 60.0] {
        for strip in strips(&bulging, degrees.to_radians()) {
            assert!(
                strip.moment * (45.0 - degrees) > 0.0,
                "{degrees} {}",
                strip.moment
            );
        }
    }
    let feathered = strips(&bulging, 45f64.to_radians());
    assert!(
        feathered
            .iter()
            .all(|strip| strip.moment.abs() < 1e-12 * load(strip.r_m))
    );
}

/// Mean lift of the wing at 45 deg as a uniform disc: w² = C_L Ω² c ((R+r₀)³ − r₀³) / (24 Φ ((R+r₀)² − r₀²)).
#[test]
fn uniform_downwash_of_an_actuator_disc() {
    let rate = TAU * 20.0 * HALF_AMPLITUDE;
    let (inner, outer) = (OFFSET_M, OFFSET_M + LENGTH_M);
    let square = 1.804561 * rate * rate * CHORD_M * (outer.powi(3) - inner.powi(3))
        / (24.0 * HALF_AMPLITUDE * (outer * outer - inner * inner));
    // force on the disc, 2ρAw², against the lift of the strips over half of the peak
    let disc = 2.0 * 1.2 * HALF_AMPLITUDE * (outer * outer - inner * inner) * square;
    let lift: f64 = strips(&wing(), 0.0)
        .iter()
        .map(|strip| 0.5 * strip.lift * strip.width_m)
        .sum();
    close(disc, lift, 1e-3);
    let law = CoefficientLaw::Dickinson;
    each(&wing(), "inflow-uniform", 0.5, 0.0, |before, after| {
        let speed = rate * (before.r_m + OFFSET_M);
        let down = 0.5 * square.sqrt();
        let turn = (down / speed).atan();
        let (cl, cd) = law.lift_and_drag(PI / 4.0 - turn);
        let load = load(before.r_m) * (1.0 + (down / speed).powi(2));
        close(after.lift, load * (cl * turn.cos() - cd * turn.sin()), 1e-5);
        close(after.drag, load * (cl * turn.sin() + cd * turn.cos()), 1e-5);
    });
}

/// A wake of its own width: the downwash is the same share of the tip speed at 30 and 60 deg of amplitude. Where the disc is the sector that the wing
/// sweeps, that share falls with the root of the amplitude. A tenth of the ideal downwash at the tip, where the wing turns the air by
/// a small angle: force over dynamic pressure tells it.
#[test]
fn downwash_of_a_wake_of_fixed_width_follows_the_tip_speed() {
    let turned = |effect: &str, half_amplitude_deg: f64, exponent: f64| {
        let text =
            format!("{FILM}[flapping]\nfrequency_hz = 20.0\nhalf_amplitude_deg = {half_amplitude_deg}\n");
        let base = rectangle(&text);
        let mut after = with(base.clone(), effect, 0.1);
        after
            .set(&format!("effects.{effect}.area_exponent"), exponent)
            .unwrap();
        let [before, after] = [strips(&base, 0.0), strips(&after, 0.0)];
        let [before, after] =
            [before, after].map(|all| all.last().map(|tip| tip.drag / tip.lift).expect("strips"));
        after - before
    };
    for effect in ["inflow-uniform", "inflow-momentum"] {
        let of = |exponent: f64| turned(effect, 60.0, exponent) / turned(effect, 30.0, exponent);
        close(of(0.0), 1.0, 1e-6);
        close(of(1.0), 0.5f64.sqrt(), 2e-2);
        // at 45 deg both are the same
        close(turned(effect, 45.0, 0.0), turned(effect, 45.0, 1.0), 1e-9);
    }
}

/// Thin airfoil at 2 deg: Leishman's root of the quadratic, φ = σa/2 (√(1 + 4α/σa) − 1), σ = c/(16Φr'); at the tip 1.58 deg
/// of the 2 are inflow. And at 45 deg lift and momentum of each ring balance.
#[test]
fn momentum_balances_lift_in_every_ring() {
    let base = rectangle(&format!(
        "{FILM}{FLAPPING}stop_angle_deg = 2.0\n[air]\ncoefficients = 'thin-airfoil'\nlift_slope_per_rad = 6.0\n"
    ));
    let alpha = 2f64.to_radians();
    each(&base, "inflow-momentum", 1.0, 0.0, |before, after| {
        let slope = CHORD_M / (16.0 * HALF_AMPLITUDE * (before.r_m + OFFSET_M)) * 6.0;
        let inflow = 0.5 * slope * ((1.0 + 4.0 * alpha / slope).sqrt() - 1.0);
        close(
            after.lift.hypot(after.drag) / before.lift,
            (alpha - inflow) / alpha,
            3e-3,
        );
        close(after.drag / after.lift, inflow, 1e-3);
    });
    each(&wing(), "inflow-momentum", 1.0, 0.0, |before, after| {
        // the resultant stands by the inflow's angle aft of that of the law
        let lean = |angle: f64| {
            let (cl, cd) = CoefficientLaw::Dickinson.lift_and_drag(PI / 4.0 - angle);
            (cd / cl).atan() + angle - (after.drag / after.lift).atan()
        };
        let (mut low, mut high) = (0.0, 0.6);
        for _ in 0..50 {
            let middle = 0.5 * (low + high);
            if lean(low) * lean(middle) <= 0.0 {
                high = middle;
            } else {
                low = middle;
            }
        }
        let (cl, _) = CoefficientLaw::Dickinson.lift_and_drag(PI / 4.0 - low);
        let speed = TAU * 20.0 * HALF_AMPLITUDE * (before.r_m + OFFSET_M);
        let down = speed * low.tan();
        let momentum = 2.0 * 1.2 * down * down * 2.0 * HALF_AMPLITUDE * (before.r_m + OFFSET_M);
        close(0.5 * load(before.r_m) * cl, momentum, 1e-3);
    });
}

/// 30 deg late at mid-stroke: cos² 30 = ¾ of the load; read at +30 deg of phase it is the whole of mid-stroke, 4/3 of that there.
#[test]
fn lagging_load_is_that_of_an_earlier_phase() {
    each(&wing(), "phase-lag", 30.0, 0.1, |before, after| {
        close(after.lift, 0.75 * before.lift, 1e-9);
    });
    let late = rectangle(&format!("{FILM}{FLAPPING}phase_deg = 30.0\n"));
    each(&late, "phase-lag", 30.0, 0.1, |before, after| {
        close(after.lift / before.lift, 4.0 / 3.0, 1e-9);
    });
}

/// Force across and along the chord of a strip that is turned by `twist_rad` from 45 deg, N/m.
fn across_and_along(strip: &Found, twist_rad: f64) -> [f64; 2] {
    let (sin, cos) = (PI / 4.0 - twist_rad).sin_cos();
    [
        strip.lift * cos + strip.drag * sin,
        strip.drag * cos - strip.lift * sin,
    ]
}

/// Way from the reversal to mid-stroke: Φ r', so 4.19 half-chords at mid-span, after which 0.768 of the circulation is there; half as far again 30 deg later.
#[test]
fn lift_after_the_reversal_is_that_of_wagners_function() {
    let wagner = |x: f64| 1.0 - 0.165 * (-0.0455 * x).exp() - 0.335 * (-0.3 * x).exp();
    assert!((wagner(HALF_AMPLITUDE * 0.08 / 0.01) - 0.768_288).abs() < 1e-6);
    let late = rectangle(&format!("{FILM}{FLAPPING}phase_deg = 30.0\n"));
    let early = rectangle(&format!("{FILM}{FLAPPING}phase_deg = -30.0\n"));
    for (design, way) in [(wing(), 1.0), (late, 1.5), (early, 0.5)] {
        each(&design, "wagner-lag", 0.8, 0.2, |before, after| {
            let half_chords = way * HALF_AMPLITUDE * (before.r_m + OFFSET_M) / (0.5 * CHORD_M);
            let left = 1.0 - 0.8 * (1.0 - wagner(half_chords));
            let [was, now] = [before, after].map(|strip| across_and_along(strip, 0.2));
            close(now[0] / was[0], left, 1e-9);
            assert!((now[1] - was[1]).abs() < 1e-9 * was[0]);
            close(after.moment / before.moment, left, 1e-9);
        });
    }
}

/// A fifth of the stroke is lost at the reference, and so 1 − 0.8² of the load; at 600 Hz deg of 700, and in air of half the density, less: 1/(1 + 0.25 · 0.7347 ρ/1.2).
#[test]
fn a_drive_that_gives_sweeps_less_far_by_its_share() {
    let mut at_reference = with(wing(), "drive-compliance", 0.0);
    at_reference
        .set("effects.drive-compliance.reference_hz_deg", 600.0)
        .unwrap();
    let mut thin = wing();
    thin.air.density_kg_m3 = 0.6.into();
    for (base, left) in [
        (at_reference, 0.8),
        (wing(), 1.0 / (1.0 + 0.25 * 0.734_694)),
        (thin, 1.0 / (1.0 + 0.25 * 0.367_347)),
    ] {
        each(&base, "drive-compliance", 0.2, 0.2, |before, after| {
            close(after.lift / before.lift, left * left, 1e-6);
            close(after.moment / before.moment, left * left, 1e-6);
        });
    }
}

/// θ = Σ m r/GJ at the tip of a rod of GJ = 80 GPa · π/32 · (1 mm)⁴ that turns by a fifth of a degree: solved whole, coupled, each effect of the
/// air turns the wing by what the strips of its card carry at rest.
#[test]
fn solved_whole_a_stiff_wing_turns_by_the_moment_of_each_card() {
    let base = rectangle(&format!("[ribs]\nbays = 20\n{FLAPPING}"));
    let gj = 80e9 * PI / 32.0 * 1e-12;
    let at_rest = |design: &Design| -> f64 {
        let turned = strips(design, 0.0);
        turned
            .iter()
            .map(|strip| strip.moment * strip.width_m * strip.r_m / gj)
            .sum()
    };
    let solved = |design: &Design| {
        let solution = solve(design);
        let tip = *solution.mesh.rod_nodes().last().unwrap();
        solution.state.rotation[tip].scaled_axis().x
    };
    let [expected_before, before] = [at_rest(&base), solved(&base)];
    close(before, expected_before, 0.02);
    assert!(
        (0.1..0.5).contains(&before.to_degrees().abs()),
        "{}",
        before.to_degrees()
    );
    let mut tried = Vec::new();
    for effect in ALL {
        let card = effect.card();
        let turns_at_rest =
            card.needs.iter().all(|need| *need != Need::Motion) && is_applicable(&card, &base);
        if card.seam != Seam::Air || !turns_at_rest {
            continue;
        }
        let [from, to] = card.parameters[0].plausible;
        let on = with(base.clone(), card.name, 0.5 * (from.max(0.0) + to));
        let [expected, found] = [at_rest(&on) - expected_before, solved(&on) - before];
        // what goes with twist is next to nothing on a wing that hardly twists
        if expected.abs() < 0.01 * expected_before.abs() {
            assert!(found.abs() < 0.02 * before.abs(), "{}: {found}", card.name);
            continue;
        }
        let ratio = found / expected;
        println!("{:26} {:8.4} {ratio:.4}", card.name, found / before);
        assert!((ratio - 1.0).abs() < 0.05, "{}: {found} {expected}", card.name);
        tried.push(card.name);
    }
    assert!(tried.len() >= 10, "{tried:?}");
}

/// So a lift model on blade elements leaves them out.
#[test]
fn lift_and_drag_of_a_section_know_nothing_of_effects_that_act_by_a_moment() {
    let named = ALL.iter().filter(|effect| effect.is_of_moment());
    let found: Vec<&str> = named.map(|effect| effect.card().name).collect();
    assert_eq!(found, ["centre-of-pressure-shift"]);
    let own = |acts_on: &str| {
        let formula = "strength = 1.0\nexpression = '0.01 * x'";
        let own = format!("[effects.own]\nkind = 'custom'\nacts_on = '{acts_on}'\n{formula}\n");
        rectangle(&format!("{FILM}{FLAPPING}{own}"))
    };
    let shifted = with(wing(), "centre-of-pressure-shift", 0.05);
    for design in [shifted, own("moment"), own("centre-of-pressure")] {
        let (planform, _) = for_design(&design, None).unwrap();
        assert!(BladeAir::new(&design, &planform, None).unwrap().plain().is_some());
        for (with, without) in strips(&design, 0.1).iter().zip(strips(&wing(), 0.1)) {
            let near = |a: f64, b: f64| (a - b).abs() < 1e-12 * b.abs();
            assert!(near(with.lift, without.lift) && near(with.drag, without.drag));
            assert!(!near(with.moment, without.moment));
        }
    }
}
