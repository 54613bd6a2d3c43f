//! The periodic motion over the stroke in the full model.

use std::f64::consts::PI;
use std::path::Path;

use washout::coupling::{Periodic, PeriodicSettings, periodic};
use washout::input::design::Design;
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
         [flapping]\nfrequency_hz = {frequency_hz:?}\nhalf_amplitude_deg = 30.0\n{more}"
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
                found.at(0.0).drag_ratio
            );
        }
        let frequencies: Vec<f64> = found.modes.iter().map(|mode| mode.frequency_hz.round()).collect();
        println!(
            "  modes {frequencies:?} Hz; x cos {:?}",
            found.motion.cosine.iter().map(|x| x.norm()).collect::<Vec<_>>()
        );
    }
}
