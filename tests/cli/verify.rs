//! `washout verify`.

use washout::export::verification::VerifyReport;

use crate::{conforms, entries, folder, schema, washout};

#[test]
fn the_list_names_the_cases_and_runs_none() {
    let here = folder();
    let said = washout(here.path(), &["verify", "--list"]);
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""));
    for name in ["scordelis-lo-roof", "elastica", "hencky-membrane"] {
        assert!(said.out.contains(&format!("\n  {name} ")), "{name}\n{}", said.out);
    }
    assert_eq!(entries(here.path()), [""; 0]);
}

#[test]
fn one_case_is_run_on_three_meshes_and_written() {
    let here = folder();
    let said = washout(
        here.path(),
        &["verify", "elastica", "--json", "--output", "proof"],
    );
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""));
    let document = said.document();
    conforms(&document, &schema(&["--output", "verify"]));
    assert_eq!(
        document["verification"][0]["meshes"]
            .as_array()
            .expect("meshes")
            .len(),
        3
    );
    let report: VerifyReport = serde_json::from_value(document.clone()).expect("a report");
    assert_eq!(report.page().astray(&document), [""; 0]);
    assert!(!report.page().astray(&serde_json::Value::Null).is_empty());
    let proof = here.path().join("proof");
    assert_eq!(entries(&proof), ["verify.csv", "verify.json", "verify.md"]);
    let written = std::fs::read_to_string(proof.join("verify.json")).expect("a document");
    assert_eq!(written, said.out);
    let rows = std::fs::read_to_string(proof.join("verify.csv")).expect("a table");
    assert_eq!(rows.lines().count(), 4, "{rows}");
}

#[test]
fn the_short_version_runs_one_mesh_and_replaces_what_was_written() {
    let here = folder();
    for _ in 0..2 {
        let said = washout(here.path(), &["verify", "--short", "cook_membrane"]);
        assert_eq!(said.code, Some(0), "{}", said.err);
        assert!(said.out.contains("1 pass, 0 fail"), "{}", said.out);
    }
    assert_eq!(entries(here.path()), ["output"]);
}

#[test]
fn a_case_that_there_is_not_ends_with_2_and_the_nearest() {
    let here = folder();
    let said = washout(here.path(), &["verify", "elastika"]);
    assert_eq!((said.code, said.out.as_str()), (Some(2), ""));
    assert!(said.err.contains("did you mean 'elastica'?"), "{}", said.err);
    assert_eq!(entries(here.path()), [""; 0]);
}
