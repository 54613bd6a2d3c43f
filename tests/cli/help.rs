//! Help, version and usage.

use crate::{folder, washout};

/// Every verb of the program, as its help lists them.
pub fn verbs() -> Vec<String> {
    let said = washout(folder().path(), &["--help"]);
    let listed = said.out.split("\nCommands:\n").nth(1).expect("commands");
    let listed = listed.split("\n\n").next().expect("a list");
    let is_verb = |line: &&str| line.starts_with("  ") && !line.starts_with("   ");
    let verbs = listed.lines().filter(is_verb);
    let verbs = verbs.filter_map(|line| line.split_whitespace().next());
    verbs.map(str::to_string).collect()
}

#[test]
fn help_names_the_verbs_and_the_exit_codes() {
    let said = washout(folder().path(), &["--help"]);
    assert_eq!(said.code, Some(0));
    let verbs = verbs();
    for verb in ["solve", "diagnose", "explain", "help"] {
        assert!(verbs.iter().any(|own| own == verb), "{verb}\n{verbs:?}");
    }
    assert!(
        said.out.contains("3 not converged,\n130 interrupted"),
        "{}",
        said.out
    );
    assert!(!said.out.contains('\u{1b}'), "colours in {}", said.out);
}

#[test]
fn no_line_of_help_is_wider_than_80_columns() {
    for verb in verbs().iter().filter(|verb| *verb != "help") {
        let said = washout(folder().path(), &[verb, "--help"]);
        for line in said.out.lines() {
            assert!(line.chars().count() <= 80, "{verb}: {line}");
        }
    }
}

#[test]
fn help_of_every_verb_shows_examples_that_begin_with_that_verb() {
    for verb in verbs().iter().filter(|verb| *verb != "help") {
        let said = washout(folder().path(), &[verb, "--help"]);
        assert_eq!(said.code, Some(0), "{verb}");
        let examples = said.out.split("Examples:").nth(1).unwrap_or_default();
        assert!(
            examples.contains(&format!("\n  washout {verb} ")),
            "{verb}\n{}",
            said.out
        );
    }
}

#[test]
fn version_is_that_of_the_package() {
    let said = washout(folder().path(), &["--version"]);
    assert_eq!(
        (said.code, said.out),
        (Some(0), format!("washout {}\n", env!("CARGO_PKG_VERSION")))
    );
}

#[test]
fn wrong_usage_ends_with_2_and_leaves_standard_output_empty() {
    for arguments in [
        vec![],
        vec!["twist"],
        vec!["mesh"],
        vec!["diff", "one"],
        vec!["mesh", "a.toml", "--threads", "0"],
    ] {
        let said = washout(folder().path(), &arguments);
        assert_eq!((said.code, said.out.as_str()), (Some(2), ""), "{arguments:?}");
        assert!(said.err.contains("--help"), "{arguments:?}\n{}", said.err);
    }
}
