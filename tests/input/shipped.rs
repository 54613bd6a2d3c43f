//! The files that are shipped: accepted, complete, and as the JSON schema says.

use std::fs;
use std::path::{Path, PathBuf};

use washout::input::measurement::{Bound, Channel, Measurement, SigmaKind};
use washout::input::schema::{design_schema, materials_schema};
use washout::input::{Design, Loaded};

const WINGS: [&str; 3] = ["rigid", "twist-v1", "twist-v2"];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn wing(name: &str) -> Loaded {
    let path = root().join("designs").join(format!("{name}.toml"));
    Design::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"))
}

fn files(folder: &str, ending: &str) -> Vec<PathBuf> {
    let entries = fs::read_dir(root().join(folder)).expect("the folder is there");
    let paths = entries.map(|entry| entry.expect("an entry").path());
    paths
        .filter(|path| path.extension().is_some_and(|found| found == ending))
        .collect()
}

#[test]
fn every_shipped_design_is_accepted() {
    let designs = files("designs", "toml");
    assert!(designs.len() >= 4);
    for path in designs.iter().filter(|path| !path.ends_with("materials.toml")) {
        if let Err(error) = Design::load(path, &[]) {
            panic!("{error}");
        }
    }
}

#[test]
fn every_shipped_measurement_is_accepted_and_says_source_and_licence() {
    let measurements = files("measurements", "csv");
    assert!(measurements.len() >= 2);
    for path in measurements {
        let measurement = Measurement::load(&path).unwrap_or_else(|error| panic!("{error}"));
        for word in ["source:", "licence:"] {
            let said = measurement
                .comments
                .iter()
                .any(|comment| comment.starts_with(word));
            assert!(said, "{}: no {word}", path.display());
        }
    }
}

#[test]
fn the_schema_accepts_the_shipped_designs_as_json() {
    let schema = jsonschema::validator_for(design_schema().as_value()).expect("a schema");
    let materials = jsonschema::validator_for(materials_schema().as_value()).expect("a schema");
    for path in files("designs", "toml") {
        let text = fs::read_to_string(&path).expect("text");
        let table: toml::Table = toml::from_str(&text).expect("TOML");
        let json = serde_json::to_value(&table).expect("JSON");
        let validator = if path.ends_with("materials.toml") {
            &materials
        } else {
            &schema
        };
        if let Err(error) = validator.validate(&json) {
            panic!("{}: {} at {}", path.display(), error, error.instance_path());
        }
    }
}

#[test]
fn the_schema_refuses_what_the_loader_refuses() {
    let schema = jsonschema::validator_for(design_schema().as_value()).expect("a schema");
    let good: toml::Table = toml::from_str(crate::bad_designs::WING).expect("TOML");
    let bad = [
        ("frequency_hz = 23.0", "frequency_hz = -3.0"),
        ("length_mm = 70.0", "lenght_mm = 70.0"),
        ("length_mm = 70.0", "length_mm = \"70\""),
        ("force_n = [0.0, 0.0, 0.01]", "force_n = [0.0, 0.01]"),
        ("force_n = [0.0, 0.0, 0.01]", "force_n = [0.0, 0.0, 1e9]"),
        ("shape = \"tube\"", "shape = \"pipe\""),
    ];
    assert!(schema.is_valid(&serde_json::to_value(&good).expect("JSON")));
    for (from, to) in bad {
        let text = crate::bad_designs::WING.replace(from, to);
        let table: toml::Table = toml::from_str(&text).expect("TOML");
        assert!(
            !schema.is_valid(&serde_json::to_value(&table).expect("JSON")),
            "{to}"
        );
    }
}

#[test]
fn what_the_paper_states_stands_as_a_fact() {
    for (name, frequency_hz, spars) in [("rigid", 21.0, 2), ("twist-v1", 22.0, 5), ("twist-v2", 23.0, 5)] {
        let design = wing(name).design;
        assert_eq!(design.spar.len(), spars, "{name}");
        let stated = [
            ("planform.length_mm", 70.0),
            ("planform.mean_chord_mm", 20.5),
            ("planform.r2_hat", 0.54),
            ("planform.root_offset_mm", 38.0),
            ("flapping.frequency_hz", frequency_hz),
            ("flapping.stop_angle_deg", 45.0),
            ("film.thickness_mm", 0.006),
        ];
        let assumptions = design.assumptions();
        for (key, value) in stated {
            assert_eq!(design.get(key), Some(value), "{name}: {key}");
            assert!(
                assumptions.iter().all(|assumption| assumption.key != key),
                "{name}: {key}"
            );
        }
    }
}

#[test]
fn what_the_paper_does_not_state_is_assumed_with_its_range() {
    for name in WINGS {
        let assumptions = wing(name).design.assumptions();
        let range = |key: &str| {
            let found = assumptions.iter().find(|assumption| assumption.key == key);
            found.map(|assumption| (assumption.value, assumption.range))
        };
        assert_eq!(
            range("flapping.half_amplitude_deg"),
            Some((34.5, [24.0, 45.0])),
            "{name}"
        );
        assert_eq!(
            range("film.pretension_n_per_m"),
            Some((0.0, [0.0, 74.0])),
            "{name}"
        );
        assert_eq!(
            range("material.carbon-rod.g_gpa"),
            Some((4.0, [3.0, 6.0])),
            "{name}"
        );
        assert!(range("spar[0].at_mm").is_some(), "{name}");
        assert!(range("spar[0].section.width_mm").is_some(), "{name}");
        assert!(
            assumptions.iter().all(|assumption| !assumption.why.is_empty()),
            "{name}"
        );
    }
}

#[test]
fn the_spars_are_evenly_spaced_from_4_to_96_percent() {
    for name in ["twist-v1", "twist-v2"] {
        for (number, spar) in wing(name).design.spar.iter().enumerate() {
            let fraction = 0.04 + 0.92 * number as f64 / 4.0;
            assert!(
                (spar.at_mm.value() - 70.0 * fraction).abs() < 1e-9,
                "{name}: spar[{number}]"
            );
        }
    }
}

/// Twist at the tip and at the break, deg, from the rates of a case.
fn profile(measurement: &Measurement, case: &str) -> [f64; 2] {
    let rates: Vec<f64> = measurement
        .case(case)
        .rows
        .iter()
        .filter(|row| row.channel == Channel::TwistRate)
        .map(|row| row.value * (row.r_to_mm.unwrap_or(f64::NAN) - row.r_mm.unwrap_or(f64::NAN)))
        .collect();
    [rates[0], rates[0] + rates[1]]
}

#[test]
fn the_rates_add_up_to_the_profiles_of_the_paper() {
    let load = |name: &str| {
        let path = root().join("measurements").join(name);
        Measurement::load(&path).unwrap_or_else(|error| panic!("{error}"))
    };
    let stated = load("colmenares-as-stated.csv");
    let restated = load("colmenares-as-restated.csv");
    let expected = [
        (&stated, "twist-v1", [13.92, 44.5]),
        (&stated, "twist-v2", [0.0, 23.0]),
        (&restated, "twist-v1", [11.25, 43.0]),
        (&restated, "twist-v2", [3.4, 28.9]),
    ];
    for (measurement, case, twist) in expected {
        let found = profile(measurement, case);
        for (found, twist) in found.iter().zip(twist) {
            assert!(
                (found - twist).abs() < 1e-9,
                "{}: {case}: {found} instead of {twist}",
                measurement.file
            );
        }
    }
}

#[test]
fn the_rigid_wing_is_bounded_at_its_tip_station_and_every_sigma_is_assumed() {
    let loaded = wing("rigid");
    let rows = loaded.measurement.expect("a measurement").rows;
    assert_eq!(rows.len(), 1);
    assert_eq!((rows[0].bound, rows[0].value), (Bound::Upper, 3.0));
    let tip_mm = loaded.design.observation.tip_station * 70.0;
    assert!((rows[0].r_mm.unwrap_or(f64::NAN) - tip_mm).abs() < 1e-9);
    for name in WINGS {
        let rows = wing(name).measurement.expect("a measurement").rows;
        assert!(
            rows.iter().all(|row| row.sigma_kind == SigmaKind::Assumed),
            "{name}"
        );
    }
}
