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
fn a_new_design_in_a_stream_is_solved_as_it_is_at_the_speed_of_a_tunnel() {
    let here = folder();
    let said = washout(here.path(), &["init", "glider", "--steady"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let solved = washout(here.path(), &["solve", "glider.toml", "--json"]);
    assert_eq!(solved.code, Some(0), "{}", solved.err);
    let flow = &solved.document()["flow"];
    assert_eq!(flow["kind"], "steady", "{flow}");
    let refused = washout(here.path(), &["init", "other", "--steady", "--study"]);
    assert_eq!(refused.code, Some(2), "{}", refused.err);
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
    let defined = ["Case", "Uncertain", "Ruler", "StudyEffect", "Alternative"]
        .map(|name| &schema["$defs"][name]["properties"]);
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

/// A wing of 80 × 20 mm with a round tip: a path with an arc, its base at the left, drawn in millimetres.
const WING_SVG: &str = "<svg xmlns=\"http://www.w3.org/2000/svg\" width=\"100mm\" height=\"50mm\" viewBox=\"0 0 100 50\">\
     <path d=\"M 5 10 H 85 A 20 20 0 0 1 65 30 H 5 Z\" fill=\"none\" stroke=\"black\"/></svg>";

#[test]
fn a_drawing_gives_the_design_its_outline_and_the_words_say_what_was_understood() {
    let here = folder();
    fs::write(here.path().join("wing.svg"), WING_SVG).expect("written");
    let said = washout(here.path(), &["init", "drawn", "--outline", "wing.svg"]);
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""));
    let words = said.out.split_whitespace().collect::<Vec<_>>().join(" ");
    let wanted = "wing.svg: a wing of 80.00 mm, its chord 20.0 mm at the base, 20.0 mm at most";
    assert!(words.starts_with(wanted), "{words}");
    let design = fs::read_to_string(here.path().join("drawn.toml")).expect("a design");
    assert!(
        design.contains("length_mm = 80.0") && design.contains("to_mm = 80.0"),
        "{design}"
    );
    let said = washout(here.path(), &["solve", "drawn.toml", "--refine", "0.3"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
}

#[test]
fn a_drawing_that_is_no_wing_is_refused_with_its_cure() {
    let here = folder();
    let turned = WING_SVG.replace("<path ", "<path transform=\"rotate(10)\" ");
    let open = WING_SVG.replace(" Z", "");
    for (name, text, words) in [
        (
            "turned.svg",
            turned.as_str(),
            "leading edge, is not straight and level",
        ),
        ("open.svg", open.as_str(), "holds no closed line"),
        ("broken.svg", "<svg", "is no SVG that can be read"),
        (
            "empty.dxf",
            "  0\nSECTION\n  2\nENTITIES\n  0\nENDSEC\n  0\nEOF\n",
            "holds no closed line",
        ),
        (
            "binary.dxf",
            "AutoCAD Binary DXF\n1\n",
            "should be the number of a DXF group",
        ),
        ("wing.png", "x", "is no drawing that is read"),
    ] {
        fs::write(here.path().join(name), text).expect("written");
        let said = washout(here.path(), &["init", "drawn", "--outline", name]);
        assert_eq!(said.code, Some(2), "{name}: {}", said.err);
        let told = said.err.split_whitespace().collect::<Vec<_>>().join(" ");
        assert!(told.contains(words), "{name}: {told}");
        assert!(!here.path().join("drawn.toml").exists());
    }
}
