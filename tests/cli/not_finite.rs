//! Formulas that are not finite where the wing flies: refused by every verb as an input at fault, and nothing is written.

use std::fs;
use std::path::Path;

use crate::{design, entries, folder, washout};

/// twist-v2 with a formula of one's own, as `w.toml`.
fn with_formula(folder: &Path, acts_on: &str, expression: &str) {
    let text = fs::read_to_string(design("twist-v2.toml")).expect("a design");
    let own = format!(
        "\n[effects.mine]\nkind = \"custom\"\nacts_on = \"{acts_on}\"\nexpression = \"{expression}\"\nstrength = 1.0\n"
    );
    let root = env!("CARGO_MANIFEST_DIR");
    let text = text
        .replace(
            "\"materials.toml\"",
            &format!("\"{root}/designs/materials.toml\""),
        )
        .replace("../measurements", &format!("{root}/measurements"));
    fs::write(folder.join("w.toml"), text + &own).expect("a design");
}

const VERBS: [&[&str]; 6] = [
    &["solve"],
    &["compare"],
    &["divergence", "--steps", "2"],
    &["modes", "--loaded"],
    &["lift", "--phases", "2"],
    &["sweep", "--vary", "flapping.frequency_hz=20,23"],
];

#[test]
fn a_formula_that_is_not_finite_on_the_wing_is_refused_by_every_verb_and_leaves_no_folder() {
    for (acts_on, expression, said_of) in [
        (
            "moment",
            "1e-4*sqrt(chord-0.010)",
            ["it is NaN at x = 1.00, chord = 0.00"; 2],
        ),
        ("force", "0.01 * sqrt(8 - U)", ["it is NaN at x = ", "U = "]),
        ("moment", "1e-4 * ln(twist)", ["at x = 0.00, twist = ", "rad"]),
        (
            "moment",
            "1e-4 * abs(twist)^0.5",
            ["its value is 0, but its change", "twist = 0.00000 rad"],
        ),
        (
            "lift",
            "1 + 1 / (rho - 1.2)",
            ["it is inf at x = 0.00, rho = 1.20000 kg/m³", "max("],
        ),
    ] {
        let here = folder();
        with_formula(here.path(), acts_on, expression);
        let before = entries(here.path());
        for verb in VERBS {
            let mut arguments = vec![verb[0], "w.toml"];
            arguments.extend(&verb[1..]);
            if verb[0] != "divergence" {
                arguments.extend(["--output", "out"]);
            }
            let said = washout(here.path(), &arguments);
            assert_eq!(
                said.code,
                Some(2),
                "{arguments:?} {expression}: {}{}",
                said.out,
                said.err
            );
            let named = format!("effects.mine.expression = '{expression}'");
            for words in [named.as_str(), said_of[0], said_of[1]] {
                assert!(
                    said.err.contains(words),
                    "{arguments:?}: no '{words}' in {}",
                    said.err
                );
            }
            assert_eq!(entries(here.path()), before, "{arguments:?} {expression}");
        }
    }
}

/// tanh levels off between two strips, so that both are the same step; it is far beyond where cosh overflows.
#[test]
fn a_formula_that_is_steep_flies_as_one_that_is_steeper() {
    let here = folder();
    let twist = |steepness: u32| {
        let expression = format!("1e-3 * tanh((x - 0.5) * {steepness})");
        with_formula(here.path(), "force", &expression);
        let said = washout(
            here.path(),
            &["solve", "w.toml", "--refine", "0.3", "--json", "--output", "out"],
        );
        assert_eq!(said.code, Some(0), "{}", said.err);
        fs::remove_dir_all(here.path().join("out")).expect("a folder");
        said.document()["profile"].to_string()
    };
    assert_eq!(twist(100_000), twist(1_000_000));
}

#[test]
fn add_tells_that_a_formula_is_not_finite_and_speaks_of_no_divergence() {
    let here = folder();
    assert_eq!(washout(here.path(), &["init", "trial", "--study"]).code, Some(0));
    let own = "[effects.edge]\nkind = 'custom'\nacts_on = 'moment'\nexpression = '1e-5 * sqrt(chord - 0.010)'\nstrength = 1.0\n";
    fs::write(here.path().join("own.toml"), own).expect("a file");
    let before = entries(here.path());
    let arguments = [
        "add",
        "edge",
        "--own",
        "own.toml",
        "--to",
        "trial.toml",
        "--output",
        "with.toml",
    ];
    let said = washout(here.path(), &arguments);
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(
        said.err.contains("it is NaN at x = 1.00, chord = 0.00"),
        "{}",
        said.err
    );
    assert!(!said.err.contains("divergence"), "{}", said.err);
    assert_eq!(entries(here.path()), before);
}
