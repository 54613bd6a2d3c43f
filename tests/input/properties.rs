//! Properties: no text makes the reader panic, and what is written reads back the same.

use proptest::prelude::*;
use washout::input::measurement::Measurement;
use washout::input::{Design, InputError};

use crate::bad_designs::WING;

const PIECES: [&str; 24] = [
    "=",
    "[",
    "]",
    "{",
    "}",
    "\"",
    "'",
    "\n",
    "#",
    ".",
    ",",
    "nan",
    "inf",
    "-",
    "1e308",
    "1e-320",
    "[[rod]]\n",
    "[film]\n",
    "99999999999999999999",
    "0x",
    "é",
    "\u{0}",
    "\r",
    "range = [1, 2]",
];

const MEASUREMENT: &str = "# a\ncase,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n\
                           w,twist,camera,deg,washout,1,20,,4.5,0.5,stated,none\n\
                           w,twist_rate,camera,deg/mm,nose_up,,0,48,-0.29,0.04,assumed,upper\n";

/// Text with pieces put in, taken out and doubled at random places.
fn mutated(text: &'static str) -> impl Strategy<Value = String> {
    let edit = (0..text.len(), 0..PIECES.len(), 0..12usize, 0..3u8);
    prop::collection::vec(edit, 1..6).prop_map(move |edits| {
        let mut letters: Vec<char> = text.chars().collect();
        for (place, piece, length, kind) in edits {
            let start = place.min(letters.len());
            let end = (start + length).min(letters.len());
            match kind {
                0 => drop(letters.splice(start..start, PIECES[piece].chars())),
                1 => drop(letters.drain(start..end)),
                _ => {
                    let copy: Vec<char> = letters[start..end].to_vec();
                    letters.splice(start..start, copy);
                }
            }
        }
        letters.into_iter().collect()
    })
}

/// An error must be printable, name the file and say something.
fn well_formed(error: &InputError) -> bool {
    let message = error.to_string();
    message.starts_with(&error.place.file) && message.len() > error.place.file.len() + 10
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 3000, failure_persistence: None, ..ProptestConfig::default() })]

    #[test]
    fn a_mutated_design_never_panics(text in mutated(WING)) {
        if let Err(error) = Design::from_toml(&text, "wing.toml") {
            prop_assert!(well_formed(&error), "{}", error);
        }
    }

    #[test]
    fn a_mutated_measurement_never_panics(text in mutated(MEASUREMENT)) {
        match Measurement::from_csv(&text, "m.csv") {
            Ok(measurement) => prop_assert!(measurement.rows.iter().all(|row| row.value.is_finite() && row.sigma > 0.0)),
            Err(error) => prop_assert!(well_formed(&error), "{}", error),
        }
    }

    #[test]
    fn any_text_is_read_or_refused(text in "\\PC{0,200}") {
        let _ = Design::from_toml(&text, "any.toml");
        let _ = Measurement::from_csv(&text, "any.csv");
    }

    #[test]
    fn any_key_is_set_or_refused(key in "[a-z_.\\[\\]0-9]{0,40}", value in any::<f64>()) {
        let mut design = Design::from_toml(WING, "wing.toml").expect("the wing");
        let before = design.clone();
        match design.set(&key, value) {
            Ok(()) => prop_assert_eq!(design.get(&key), Some(value)),
            Err(error) => {
                prop_assert!(!error.to_string().is_empty());
                prop_assert_eq!(design, before);
            }
        }
    }

    #[test]
    fn a_written_design_reads_back_the_same(
        frequency_hz in 0.1..1000.0f64,
        amplitude_deg in 24.0..45.0f64,
        diameter_mm in 0.001..1000.0f64,
        station_mm in 0.0..69.0f64,
        force_n in prop::array::uniform3(-1e6..1e6f64),
        refine in 0.1..100.0f64,
        name in "[a-z][a-z0-9_-]{0,20}",
    ) {
        let mut design = Design::from_toml(WING, "wing.toml").expect("the wing");
        design.name = name;
        design.observation.stations_mm = vec![station_mm];
        design.load[0].force_n = force_n;
        for (key, value) in [
            ("flapping.frequency_hz", frequency_hz),
            ("flapping.half_amplitude_deg", amplitude_deg),
            ("rod[0].section.diameter_mm", diameter_mm),
            ("mesh.refine", refine),
        ] {
            design.set(key, value).map_err(|error| TestCaseError::fail(error.to_string()))?;
        }
        let again = Design::from_toml(&design.to_toml(), "again.toml");
        prop_assert_eq!(again.map_err(|error| error.to_string()), Ok(design));
    }
}
