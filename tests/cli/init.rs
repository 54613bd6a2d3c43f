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

#[test]
fn the_new_study_is_compared_and_diagnosed_as_it_is() {
    let here = folder();
    let said = washout(here.path(), &["init", "bench-2", "--study"]);
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""));
    assert_eq!(
        said.out,
        "bench-2.toml written, with bench-2-wing.toml and bench-2-measured.csv; compare them with: washout compare \
         bench-2.toml\n"
    );
    let said = washout(here.path(), &["compare", "bench-2.toml", "--json"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let groups = said.document()["groups"].as_array().expect("groups").clone();
    assert_eq!(groups.len(), 2, "fitted and held out: {groups:?}");
    assert!(groups.iter().all(|group| group["wing"] == "bench-2-wing"));
    let said = washout(here.path(), &["diagnose", "bench-2.toml", "--json"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let found = &said.document()["hypotheses"][0];
    assert_eq!(
        found["effects"][0], "root-flexure",
        "made up with a soft root: {found}"
    );
    assert!(
        (found["strength"].as_f64().expect("a number") - 0.3).abs() < 0.1,
        "{found}"
    );
}

#[test]
fn a_study_is_written_whole_or_not_at_all() {
    for taken in ["s.toml", "s-wing.toml", "s-measured.csv"] {
        let here = folder();
        fs::write(here.path().join(taken), "mine").expect("written");
        let said = washout(here.path(), &["init", "s", "--study"]);
        assert_eq!(said.code, Some(2));
        assert_eq!(
            said.err,
            format!("washout: {taken} exists already; give another name, or move it away\n")
        );
        assert_eq!(entries(here.path()), [taken]);
    }
}

/// Every key of the schema stands in the text, and what is off by a # can be taken into use.
#[test]
fn the_text_of_the_new_study_is_in_step_with_the_schema() {
    let here = folder();
    washout(here.path(), &["init", "s", "--study"]);
    let text = fs::read_to_string(here.path().join("s.toml")).expect("read");
    let is_off = |line: &str| {
        let rest = line.strip_prefix("# ").unwrap_or_default();
        let key = rest.split(" = ").next().unwrap_or_default();
        rest.starts_with("[[")
            || (rest.contains(" = ") && key.chars().all(|c| c.is_ascii_lowercase() || c == '_'))
    };
    let on = |line: &str| {
        if is_off(line) {
            line[2..].to_string()
        } else {
            line.to_string()
        }
    };
    let all: Vec<String> = text.lines().map(on).collect();
    let stands = |key: &str| {
        all.iter()
            .any(|line| line.starts_with(&format!("{key} = ")) || *line == format!("[[{key}]]"))
    };
    let schema = schema(&["--study"]);
    let defined =
        ["Case", "Uncertain", "Ruler", "StudyEffect"].map(|name| &schema["$defs"][name]["properties"]);
    for table in defined.into_iter().chain([&schema["properties"]]) {
        for key in table.as_object().expect("keys").keys() {
            assert!(stands(key), "{key} is not explained");
        }
    }
    fs::write(here.path().join("s.toml"), all.join("\n")).expect("written");
    let next = "case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n\
                flapping-24,twist,chord_rotation,deg,washout,run-1,40,,,0.25,assumed,none\n";
    fs::write(here.path().join("s-next.csv"), next).expect("written");
    let said = washout(here.path(), &["compare", "s.toml"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
}
