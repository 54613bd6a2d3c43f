//! `washout doctor`, `completions` and `man`.

use crate::help::verbs;
use crate::{folder, schema, washout};

#[test]
fn the_doctor_finds_three_solves_right_and_its_document_conforms_to_its_schema() {
    let said = washout(folder().path(), &["doctor", "--json", "--quiet"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let document: serde_json::Value = serde_json::from_str(&said.out).expect("JSON");
    let checks = document["checks"].as_array().expect("checks");
    assert_eq!(checks.len(), 3);
    for check in checks {
        assert!(
            check["passed"] == true && check["error"].as_f64().is_some_and(|error| error < 0.02),
            "{check}"
        );
    }
    let validator = jsonschema::validator_for(&schema(&["--output", "doctor"])).expect("a schema");
    assert!(validator.is_valid(&document));
}

#[test]
fn completions_of_every_shell_know_every_verb() {
    for shell in ["bash", "zsh", "fish", "elvish", "powershell"] {
        let said = washout(folder().path(), &["completions", shell]);
        assert_eq!(said.code, Some(0), "{shell}: {}", said.err);
        for verb in &verbs() {
            assert!(said.out.contains(verb.as_str()), "{shell} lacks {verb}");
        }
    }
}

#[test]
fn there_is_a_manual_page_for_every_verb_with_its_examples() {
    let folder = folder();
    let said = washout(folder.path(), &["man", "pages"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let page =
        |name: String| std::fs::read_to_string(folder.path().join("pages").join(name)).expect("a page");
    assert!(page("washout.1".into()).contains("washout\\-solve"));
    for verb in verbs().iter().filter(|verb| *verb != "help") {
        let text = page(format!("washout-{verb}.1"));
        assert!(
            text.contains("Examples:") && text.starts_with(".ie"),
            "{verb}: {}",
            &text[..200]
        );
    }
}
