//! `washout mesh`.

use crate::{below, conforms, contents, design, entries, folder, schema, washout};

#[test]
fn the_files_are_those_that_the_document_lists() {
    let here = folder();
    let said = washout(here.path(), &["mesh", &design("twist-v2.toml"), "--json"]);
    assert_eq!((said.code, said.err.as_str()), (Some(0), ""));
    conforms(&said.document(), &schema(&["--output", "mesh"]));
    let target = here.path().join("output/twist-v2-mesh");
    assert_eq!(
        entries(&target),
        ["mesh.msh", "mesh.vtu", "outline.geo", "summary.json"]
    );
    let summary = std::fs::read_to_string(target.join("summary.json")).expect("a summary");
    assert_eq!(summary, said.out);
}

#[test]
fn a_mesh_given_back_is_the_same_mesh() {
    let here = folder();
    let design = design("twist-v2.toml");
    washout(here.path(), &["mesh", &design, "--output", "a"]);
    let file = below(here.path(), "a/mesh.msh");
    let said = washout(here.path(), &["mesh", &design, "--mesh", &file, "--output", "b"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    // the summaries say what each was made of, and that differs
    let files = |folder: &str| {
        let mut all = contents(&here.path().join(folder));
        all.retain(|(name, _)| name != "summary.json");
        all
    };
    assert_eq!(files("a").len(), 3);
    assert_eq!(files("a"), files("b"));
}

#[test]
fn refining_twice_gives_about_four_times_the_triangles() {
    let here = folder();
    let design = design("twist-v2.toml");
    let triangles = |factor: &str| {
        let said = washout(here.path(), &["mesh", &design, "--json", "--refine", factor]);
        said.document()["triangles"].as_f64().expect("a count")
    };
    let ratio = triangles("2") / triangles("1");
    assert!((3.5..4.5).contains(&ratio), "{ratio}");
}

#[test]
fn a_design_that_is_refused_ends_with_2_and_leaves_no_file() {
    let here = folder();
    let design = design("twist-v2.toml");
    let said = washout(here.path(), &["mesh", &design, "--set", "spar[0].at_mm=70.5"]);
    assert_eq!((said.code, said.out.as_str()), (Some(2), ""));
    assert!(said.err.contains("spar[0].at_mm = 70.5"), "{}", said.err);
    assert!(entries(here.path()).is_empty());
}
