//! `washout init`.

use std::fs;

use crate::{conforms, entries, folder, schema, washout};

#[test]
fn the_new_design_can_be_meshed_as_it_is() {
    let here = folder();
    let said = washout(here.path(), &["init", "first-wing"]);
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""));
    assert_eq!(
        said.out,
        "first-wing.toml written; solve it with: washout solve first-wing.toml\n"
    );
    let said = washout(here.path(), &["mesh", "first-wing.toml"]);
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""));
}

#[test]
fn an_existing_file_is_not_touched() {
    let here = folder();
    fs::write(here.path().join("wing.toml"), "mine").expect("written");
    let said = washout(here.path(), &["init", "wing"]);
    assert_eq!((said.code, said.out.as_str()), (Some(2), ""));
    assert_eq!(
        said.err,
        "washout: wing.toml exists already; give another name, or move it away\n"
    );
    assert_eq!(
        fs::read_to_string(here.path().join("wing.toml")).expect("read"),
        "mine"
    );
}

#[test]
fn a_name_that_would_leave_the_folder_is_refused() {
    let here = folder();
    let said = washout(here.path(), &["init", "../wing"]);
    assert_eq!(said.code, Some(2));
    assert!(
        said.err.starts_with("washout: '../wing' is no name for a wing"),
        "{}",
        said.err
    );
    assert!(entries(here.path()).is_empty());
}

#[test]
fn the_document_names_the_file() {
    let here = folder();
    let said = washout(here.path(), &["init", "wing", "--json"]);
    conforms(&said.document(), &schema(&["--output", "init"]));
    assert_eq!(said.document()["file"], "wing.toml");
}
