//! `--set key=value`: what it changes, and what it refuses with which message.

use std::fs;

use washout::input::{Design, InputError, Loaded};

use crate::bad_designs::WING;

fn load(sets: &[&str]) -> Result<Loaded, InputError> {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let path = folder.path().join("wing.toml");
    fs::write(&path, WING).expect("a file is written");
    let sets: Vec<String> = sets.iter().map(|set| set.to_string()).collect();
    Design::load(&path, &sets)
}

fn message(set: &str) -> String {
    match load(&[set]) {
        Ok(_) => "(accepted)".to_string(),
        Err(error) => match error.place.file == "--set" {
            true => error.to_string(),
            false => error.to_string().replace(&error.place.file, "wing.toml"),
        },
    }
}

/// The setting, and its message.
const CASES: &[(&str, &str)] = &[
    (
        "flapping.frequency_hz",
        "--set: flapping.frequency_hz must be KEY=VALUE.\n  \
         Write e.g. --set flapping.frequency_hz=23 or --set 'rod[0].section.diameter_mm=0.8'",
    ),
    (
        "flapping.frequency_hz=",
        "--set: flapping.frequency_hz= has no value.\n  \
         Write e.g. --set flapping.frequency_hz=23 or --set 'rod[0].section.diameter_mm=0.8'",
    ),
    (
        "flapping..frequency_hz=3",
        "--set: flapping..frequency_hz=3 is no dotted key: \"\" is no key (letters, digits, _ and - only).\n  \
         Write e.g. --set flapping.frequency_hz=23 or --set 'rod[0].section.diameter_mm=0.8'",
    ),
    (
        "rod[a].to_mm=3",
        "--set: rod[a].to_mm=3 is no dotted key: \"a\" must be a whole number from 0.\n  \
         Write e.g. --set flapping.frequency_hz=23 or --set 'rod[0].section.diameter_mm=0.8'",
    ),
    (
        "flapping.frequency_hz=-3",
        "--set: flapping.frequency_hz = -3: must lie in 0.1 … 1000 Hz.\n  \
         Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
    ),
    (
        "flapping.frequency_hz=fast",
        "--set: flapping.frequency_hz = \"fast\": must be a number, not text.\n  \
         Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
    ),
    (
        "flapping.frequency_hz=23Hz",
        "--set: flapping.frequency_hz = \"23Hz\": must be a number, not text.\n  \
         Write the number without quotes and without unit. Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
    ),
    (
        "flapping.frequency_hz=nan",
        "--set: flapping.frequency_hz = NaN: must be a finite number.\n  \
         Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
    ),
    (
        "flapping.frequency=23",
        "--set: flapping.frequency = 23: missing unit, frequency_hz is expected.\n  \
         Give the flapping frequency in hertz, e.g. frequency_hz = 23.0",
    ),
    (
        "flaping.frequency_hz=23",
        "--set: flaping: unknown key.\n  \
         Did you mean flapping? Allowed at the top level: format, name, materials, planform, flapping, steady, air, rod, spar, ribs, film, root, load, gravity, structure, mesh, coupling, observation, measured, material, assumed_choice, effects",
    ),
    (
        "flapping.frequency_hz.value=23",
        "--set: flapping.frequency_hz.value = 23: flapping.frequency_hz has no keys, so no value.\n  \
         Set flapping.frequency_hz itself",
    ),
    (
        "rod[2].to_mm=70",
        "--set: rod[2].to_mm = 70: there is no rod[2], rod has 2.\n  \
         Entries count from 0: rod[0] … rod[1]",
    ),
    (
        "spar.at_mm=30",
        "--set: spar.at_mm = 30: spar is a list, so its entry must be named.\n  \
         Entries count from 0: spar[0] … spar[1]",
    ),
    (
        "film[0].thickness_mm=0.01",
        "--set: film[0].thickness_mm = 0.01: film is no list.\n  \
         Leave the number in brackets out",
    ),
    (
        "structure.kinematics=nonlinear",
        "--set: structure.kinematics = \"nonlinear\": must be one of large-rotation, linear.\n  \
         Give the kinematics, e.g. kinematics = \"large-rotation\"",
    ),
    (
        "structure.load_increments=2.5",
        "--set: structure.load_increments = 2.5: must be a whole number, not a decimal number.\n  \
         Give the number of load increments to start with, e.g. load_increments = 1",
    ),
    (
        "rod[0].section.shape=square",
        "--set: rod[0].section.shape = \"square\": must be one of round, half-round, tube, rectangle, laminate, given.\n  \
         Give the shape, e.g. shape = \"round\"",
    ),
    (
        "rod[0].section.shape=tube",
        "wing.toml:18:35: rod[0].section.diameter_mm = 1.0: unknown key.\n  \
         diameter_mm belongs to the shape round or half-round. Allowed in rod[0].section of shape tube: shape, outer_diameter_mm, inner_diameter_mm",
    ),
    (
        "rod[0].to_mm=39",
        "wing.toml:21:11: rod[1].from_mm = 40.0: leaves a gap after rod[0], which ends at 39 mm.\n  \
         Write from_mm = 39.0, or let rod[0] end at 40.0",
    ),
    (
        "steady.speed_m_s=8",
        "--set: steady cannot stand together with flapping.\n  \
         Keep [flapping] or [steady]; delete both for bench loads only",
    ),
    (
        "observation.instrument=camera",
        "--set: observation.instrument = \"camera\": needs camera_axis.\n  \
         Give camera_axis = \"flapping-axis\" or \"stroke\", the axis along which the camera looks",
    ),
    (
        "material.carbon.poisson=0.7",
        "--set: material.carbon.poisson = 0.7: must lie in -1 … 0.5 (the ends excluded).\n  \
         Give the Poisson ratio (strain across per strain along the fibre), e.g. poisson = 0.34",
    ),
    (
        "flapping.half_amplitude_deg={ assumed = 50, range = [24, 45] }",
        "--set: flapping.half_amplitude_deg.assumed = 50: must lie in its own range 24 … 45.\n  \
         Widen the range, or assume a value inside it",
    ),
];

#[test]
fn every_bad_setting_is_refused_with_its_message() {
    let mut wrong = Vec::new();
    for (set, expected) in CASES {
        let found = message(set);
        if found != *expected {
            wrong.push(format!("{set}\n  expected: {expected}\n  found:    {found}"));
        }
    }
    assert!(
        wrong.is_empty(),
        "{} of {} messages differ:\n{}",
        wrong.len(),
        CASES.len(),
        wrong.join("\n")
    );
}

#[test]
fn numbers_words_lists_and_tables_can_be_set() {
    let sets = [
        "name=7",
        "flapping.frequency_hz = 21.5",
        "rod[1].section.outer_diameter_mm=0.8",
        "structure.kinematics=linear",
        "film.compression=\"carries\"",
        "load[0].force_n[1]=2",
        "observation.stations_mm=[5, 15, 25]",
        "gravity.acceleration_m_s2=[0, 0, -9.81]",
        "flapping.half_amplitude_deg={ assumed = 30, range = [20, 40] }",
        "effects.tip_loss.strength=0.5",
    ];
    let design = load(&sets).unwrap_or_else(|error| panic!("{error}")).design;
    assert_eq!(design.name, "7");
    assert_eq!(design.get("flapping.frequency_hz"), Some(21.5));
    assert_eq!(design.get("rod[1].section.outer_diameter_mm"), Some(0.8));
    assert_eq!(
        design.structure.kinematics,
        washout::input::design::Kinematics::Linear
    );
    assert_eq!(design.load[0].force_n, [0.0, 2.0, 0.01]);
    assert_eq!(design.observation.stations_mm, [5.0, 15.0, 25.0]);
    assert_eq!(
        design.gravity.as_ref().map(|gravity| gravity.acceleration_m_s2),
        Some([0.0, 0.0, -9.81])
    );
    assert_eq!(design.assumptions()[0].range, [20.0, 40.0]);
    assert_eq!(design.get("effects.tip_loss.strength"), Some(0.5));
}

#[test]
fn the_last_of_two_settings_counts() {
    let design = load(&["flapping.frequency_hz=20", "flapping.frequency_hz=25"])
        .expect("accepted")
        .design;
    assert_eq!(design.get("flapping.frequency_hz"), Some(25.0));
}

#[test]
fn a_set_number_is_no_longer_assumed() {
    let design = load(&["flapping.half_amplitude_deg=30"])
        .expect("accepted")
        .design;
    assert!(design.assumptions().is_empty());
}

#[test]
fn every_assumption_of_the_shipped_wings_can_be_set_to_either_end_of_its_range() {
    for name in ["rigid", "twist-v1", "twist-v2"] {
        let path = format!("{}/designs/{name}.toml", env!("CARGO_MANIFEST_DIR"));
        let design = Design::load(path.as_ref(), &[])
            .unwrap_or_else(|error| panic!("{error}"))
            .design;
        let assumptions = design.assumptions();
        assert!(assumptions.len() > 10, "{name}: {}", assumptions.len());
        for assumption in assumptions {
            for end in assumption.range {
                let mut moved = design.clone();
                let key = &assumption.key;
                moved
                    .set(key, end)
                    .unwrap_or_else(|error| panic!("{name}: {error}"));
                assert_eq!(moved.get(key), Some(end), "{name}: {key}");
                let kept = moved.assumptions().into_iter().find(|other| other.key == *key);
                assert_eq!(
                    kept.map(|kept| kept.range),
                    Some(assumption.range),
                    "{name}: {key}"
                );
            }
        }
    }
}
