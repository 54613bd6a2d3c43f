//! The periodic motion over the stroke in the full model.

use std::f64::consts::PI;
use std::path::Path;

use washout::coupling::{Periodic, PeriodicSettings, periodic};
use washout::input::design::Design;
use washout::lift::Forces;
use washout::mesh::for_design;
use washout::progress::Progress;

use super::closed_forms::{rectangle, solve};

fn moving(design: &Design) -> Periodic {
    let (_, mesh) = for_design(design, None).unwrap();
    periodic(
        design,
        &mesh,
        None,
        &PeriodicSettings::default(),
        &Progress::quiet(),
    )
    .unwrap_or_else(|error| panic!("{error}"))
}

fn plate(frequency_hz: f64, more: &str) -> Design {
    rectangle(&format!(
        "[film]\nmaterial = 'steel'\nthickness_mm = 0.15\n\
         [flapping]\nfrequency_hz = {frequency_hz:?}\nhalf_amplitude_deg = 30.0\n{more}[mesh]\nrefine = 0.5\n"
    ))
}

fn shipped(name: &str) -> Design {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("designs")
        .join(format!("{name}.toml"));
    Design::load(&path, &["mesh.refine=0.5".to_string()])
        .unwrap()
        .design
}

/// Load and inertia both go with f², so that a slow stroke does not tell: mass must vanish, that of the moved air too, and
/// the air's lag of the path that would stand still.
#[test]
fn as_inertia_vanishes_twist_is_that_of_standing_still() {
    let light = |density_kg_m3: f64| {
        let mut design = plate(20.0, "");
        design.set("material.steel.density_kg_m3", density_kg_m3).unwrap();
        let settings = PeriodicSettings {
            moved_air: 0.0,
            air_damping: 0.0,
            ..PeriodicSettings::default()
        };
        let (_, mesh) = for_design(&design, None).unwrap();
        let found = periodic(&design, &mesh, None, &settings, &Progress::quiet()).unwrap();
        let deviation = |phase: f64| {
            let at = found.stations_m().into_iter().map(|r_m| {
                let [twist, ..] = found.twist(r_m, phase).unwrap();
                (twist - found.standing_twist(r_m, phase).unwrap()).abs()
            });
            at.fold(0.0, f64::max) / found.standing_twist(0.097, 0.0).unwrap()
        };
        [0.0, 0.5, 1.2].map(deviation)
    };
    let [heavy, light] = [20.0, 2e-4].map(light);
    println!("{heavy:?} {light:?}");
    for (heavy, light) in heavy.into_iter().zip(light) {
        // structural damping goes with the root of the mass
        assert!(light < 1e-3 && light < 0.02 * heavy);
    }
}

#[test]
fn standing_twist_is_that_of_a_wing_solved_at_its_phase() {
    let found = moving(&plate(20.0, ""));
    let stations = found.stations_m();
    for (degrees, tolerance) in [(0.0, 1e-9), (20.0, 1e-4), (50.0, 2e-3)] {
        let solution = solve(&plate(20.0, &format!("phase_deg = {degrees:?}\n")));
        let shapes = found.wing.strips.shapes(&solution.state);
        for index in [10, stations.len() - 2] {
            let exact = shapes[6 * index + 2].atan2(shapes[6 * index + 1]);
            let path = found
                .standing_twist(stations[index], f64::to_radians(degrees))
                .unwrap();
            assert!(
                (path / exact - 1.0).abs() < tolerance,
                "{degrees}: {path} {exact}"
            );
        }
    }
}

#[test]
fn energy_over_the_stroke_closes_and_half_strokes_mirror_each_other() {
    for name in ["twist-v1", "twist-v2"] {
        let found = moving(&shipped(name));
        let work = found.work;
        println!("{name}: {work:?}");
        assert!(work.damped > 0.0);
        assert!((work.forced - work.damped - work.air_stiffness).abs() < 1e-9 * work.damped);
        let r_m = 0.8 * found.stations_m().last().unwrap();
        for phase in [0.0, 0.4, 1.2] {
            let [here, there] = [phase, phase + PI].map(|phase| found.twist(r_m, phase).unwrap());
            for k in 0..3 {
                assert!((here[k] + there[k]).abs() < 1e-9 * found.stroke.rate_rad_s.powi(k as i32));
            }
            let h = 1e-5;
            let [up, down] = [h, -h].map(|h| found.twist(r_m, phase + h).unwrap());
            for k in 0..2 {
                let rate = (up[k] - down[k]) / (2.0 * h) * found.stroke.rate_rad_s;
                assert!((rate - here[k + 1]).abs() < 1e-4 * rate.abs().max(found.stroke.rate_rad_s));
            }
        }
        for share in [0.3, 0.6, 0.97] {
            let r_m = 0.07 * share;
            let [twist, rate, _] = found.twist(r_m, 0.0).unwrap();
            let still = found.standing_twist(r_m, 0.0).unwrap();
            println!(
                "  r/R {share}: standing {:.1} deg, moving {:.1} deg, {:.0} deg/s; drag ratio {:.3}",
                still.to_degrees(),
                twist.to_degrees(),
                rate.to_degrees(),
                found.at(0.0).unwrap().drag_ratio
            );
        }
        let frequencies: Vec<f64> = found.modes.iter().map(|mode| mode.frequency_hz.round()).collect();
        println!(
            "  modes {frequencies:?} Hz; x cos {:?}",
            found.motion.cosine.iter().map(|x| x.norm()).collect::<Vec<_>>()
        );
    }
}

/// Next to no air, so that inertia alone moves the plate, which is 5 mm wide and 100 mm long.
fn strip_of_steel(frequency_hz: f64, e_gpa: f64, thickness_mm: f64) -> Design {
    let text = format!(
        "format = 1\nname = 'w'\n[planform]\nlength_mm = 100.0\nroot_offset_mm = 30.0\ntip_cut = 1.0\n\
         outline = [[0.0, 5.0], [100.0, 5.0]]\n\
         [[rod]]\nfrom_mm = 0.0\nto_mm = 100.0\nmaterial = 'steel'\nsection = {{ shape = 'round', diameter_mm = 0.05 }}\n\
         [flapping]\nfrequency_hz = {frequency_hz:?}\nhalf_amplitude_deg = 30.0\n[air]\ndensity_kg_m3 = 1e-7\n\
         [film]\nmaterial = 'steel'\nthickness_mm = {thickness_mm:?}\ncompression = 'carries'\n[root]\nchord = 'clamped'\n\
         [material.steel]\ne_gpa = {e_gpa:?}\npoisson = 0.3\ndensity_kg_m3 = 7800.0\n[mesh]\nrefine = 1.5\n"
    );
    Design::from_toml(&text, "w.toml").unwrap_or_else(|error| panic!("{error}"))
}

fn in_vacuum(design: &Design, modes: usize) -> Periodic {
    let (_, mesh) = for_design(design, None).unwrap();
    let settings = PeriodicSettings {
        modes,
        damping_ratio: 0.0,
        moved_air: 0.0,
        ..PeriodicSettings::default()
    };
    periodic(design, &mesh, None, &settings, &Progress::quiet()).unwrap_or_else(|error| panic!("{error}"))
}

/// A uniform bar whose clamp turns by Σ p cos hτ + q sin hτ turns at its tip, beside the clamp, by each harmonic times
/// 1/cos(kL) − 1, k = hω/c; of a thin strip c = 2 (t/b) √(G/ρ), and its clamped end shortens L by b √(3E/(144 G)).
#[test]
fn a_strip_that_is_flipped_twists_by_the_wave_equation_of_torsion() {
    let (e, g, rho) = (200e9, 200e9 / 2.6, 7800.0);
    let (length, width, thickness) = (0.1_f64, 5e-3_f64, 0.15e-3_f64);
    let found = in_vacuum(&strip_of_steel(30.0, 200.0, 0.15), 16);
    let speed = 2.0 * thickness / width * f64::sqrt(g / rho);
    let reach = length - width * f64::sqrt(3.0 * e / (144.0 * g));
    let stroke = found.stroke;
    let harmonic = |order: usize| {
        let count = 3600;
        let mean = |wave: fn(f64) -> f64| {
            let at = |index: usize| (index as f64 + 0.5) * 2.0 * PI / count as f64;
            let sum: f64 = (0..count)
                .map(|i| stroke.pitch(at(i))[0] * wave(order as f64 * at(i)))
                .sum();
            2.0 * sum / count as f64
        };
        [mean(f64::cos), mean(f64::sin)]
    };
    let exact = |phase: f64| -> f64 {
        let orders = found.settings.orders.iter().map(|&order| {
            let k = order as f64 * stroke.rate_rad_s / speed;
            let [cosine, sine] = harmonic(order);
            let (sin, cos) = (order as f64 * phase).sin_cos();
            (1.0 / (k * reach).cos() - 1.0) * (cosine * cos + sine * sin)
        });
        orders.sum()
    };
    let tip = *found.stations_m().last().unwrap();
    let phases: Vec<f64> = (0..24).map(|index| f64::from(index) * PI / 12.0).collect();
    let largest = phases.iter().map(|&phase| exact(phase).abs()).fold(0.0, f64::max);
    let off = |phase: f64| (found.twist(tip, phase).unwrap()[0] - exact(phase)).abs();
    let worst = phases.iter().map(|&phase| off(phase)).fold(0.0, f64::max);
    println!("largest {largest} rad, off by {worst}");
    assert!(largest > 0.005 && worst < 0.02 * largest, "{worst} {largest}");
}

/// M = ρ t (∫y² p̈ + ∫y (x + r₀) a) of a plate that does not yield: p̈ of the flip, a Φω² sin τ across the wing.
#[test]
fn a_stiff_plate_needs_the_moment_of_its_inertia_about_the_rod() {
    let found = in_vacuum(&strip_of_steel(0.2, 2000.0, 0.4), 8);
    let (mass, width) = (7800.0 * 0.4e-3 * 5e-3 * 0.1, 5e-3_f64);
    for degrees in [-80.0_f64, -60.0, 30.0, 75.0, 85.0] {
        let phase = degrees.to_radians();
        let [_, _, jerk] = found.stroke.pitch(phase);
        let turning = mass * width * width / 3.0 * jerk * found.stroke.rate_rad_s.powi(2);
        let sweeping = mass * 0.5 * width * (0.05 + 0.03) * found.stroke.sweep_acceleration(phase);
        let exact = -(turning + sweeping);
        let moment = found.instant(phase).unwrap().stop_moment_n_m;
        let size = turning.abs() + sweeping.abs();
        assert!(
            (moment - exact).abs() < 0.01 * size,
            "{degrees}: {moment} {exact} {size}"
        );
    }
}

/// Nothing has mass and nothing lags: air, its forces and the moment of the stop are those of a wing solved at the phase.
#[test]
fn as_inertia_vanishes_forces_and_stop_are_those_of_standing_still() {
    let light = |phase: &str| {
        let mut design = plate(20.0, phase);
        design.set("material.steel.density_kg_m3", 2e-6).unwrap();
        design
    };
    let design = light("");
    let settings = PeriodicSettings {
        moved_air: 0.0,
        air_damping: 0.0,
        ..PeriodicSettings::default()
    };
    let (_, mesh) = for_design(&design, None).unwrap();
    let found = periodic(&design, &mesh, None, &settings, &Progress::quiet()).unwrap();
    for (degrees, tolerance) in [(0.0, 1e-3), (30.0, 2e-3)] {
        let still = solve(&light(&format!("phase_deg = {degrees:?}\n")));
        let forces = Forces::of_strips("still", &still.strips);
        let stop = -still.report.reaction_moment_n_m[0];
        for half in [0.0, PI] {
            let now = found.instant(f64::to_radians(degrees) + half).unwrap();
            for (moving, standing) in [
                (now.forces.lift_n * 1e3, forces.lift_mn),
                (now.forces.drag_n * 1e3, forces.drag_mn),
                (now.forces.power_w * 1e3, forces.power_mw),
                (now.stop_moment_n_m, stop),
            ] {
                assert!(
                    (moving / standing - 1.0).abs() < tolerance,
                    "{degrees}: {moving} {standing}"
                );
            }
        }
    }
}
