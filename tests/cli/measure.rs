//! `washout measure`.

use std::fs;
use std::path::Path;

use crate::{conforms, design, entries, folder, schema, washout};

fn example(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples").join(name);
    path.to_str().expect("UTF-8 path").to_string()
}

/// The example was made up from the solved wing, so its twist must be that of the wing, within its stated error.
#[test]
fn the_example_becomes_a_measurement_that_compare_takes_and_the_model_meets() {
    let here = folder();
    let said = washout(
        here.path(),
        &["measure", &example("video.toml"), "--output", "t.csv", "--json"],
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    let document = said.document();
    conforms(&document, &schema(&["--output", "measure"]));
    assert_eq!(document["readings"].as_array().expect("readings").len(), 5);
    assert_eq!(document["ruler"][0]["kind"], "scale");
    let said = washout(
        here.path(),
        &[
            "compare",
            &design("twist-v2.toml"),
            "--with",
            "t.csv",
            "--case",
            "mid-stroke",
            "--json",
        ],
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    let rows = said.document()["comparison"]["rows"]
        .as_array()
        .expect("rows")
        .clone();
    assert_eq!(rows.len(), 5);
    let sigmas = rows
        .iter()
        .map(|row| row["misfit_sigma"].as_f64().expect("a number"));
    let chi_squared: f64 = sigmas.map(|sigma| sigma * sigma).sum();
    assert!((0.3..15.1).contains(&chi_squared), "{chi_squared} of 5 readings");
}

/// What the page says to put into a study can be put there.
#[test]
fn the_ruler_that_it_tells_is_taken_by_a_study() {
    let here = folder();
    let said = washout(here.path(), &["measure", &example("video.toml")]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let start = said.out.find("[[ruler]]").expect("a ruler");
    let end = said.out.find("video.csv written").expect("the file");
    fs::copy(design("materials.toml"), here.path().join("materials.toml")).expect("copied");
    fs::copy(design("twist-v2.toml"), here.path().join("v2.toml")).expect("copied");
    let text = fs::read_to_string(here.path().join("v2.toml")).expect("read");
    let text = text.replace("../measurements/colmenares-as-stated.csv", "video.csv");
    let text = text.replace("case = \"twist-v2\"", "case = \"mid-stroke\"");
    fs::write(here.path().join("v2.toml"), text).expect("written");
    let study = format!(
        "format = 1\nname = 's'\n[[case]]\ndesign = 'v2.toml'\nset = ['mesh.chordwise=6']\nmeasurement = 'video.csv'\n\
         measured = 'mid-stroke'\n{}",
        &said.out[start..end]
    );
    fs::write(here.path().join("s.toml"), study).expect("written");
    let said = washout(here.path(), &["compare", "s.toml", "--verbose"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    assert!(said.out.contains("scale of twist"), "{}", said.out);
}

#[test]
fn an_older_measurement_is_replaced_only_by_force_and_no_other_file_at_all() {
    let here = folder();
    let marks = fs::read_to_string(example("video-marks.csv")).expect("read");
    let video = fs::read_to_string(example("video.toml")).expect("read");
    let asked = ["measure", &example("video.toml"), "--output", "t.csv"];
    assert_eq!(washout(here.path(), &asked).code, Some(0));
    let said = washout(here.path(), &asked);
    assert_eq!(said.code, Some(2));
    assert_eq!(
        said.err,
        "washout: t.csv exists already; give another name, or move it away\n"
    );
    let forced = [&asked[..], &["--force"]].concat();
    let said = washout(here.path(), &forced);
    assert_eq!(said.code, Some(0), "{}", said.err);
    assert_eq!(entries(here.path()), ["t.csv"]);
    for text in ["mine", &marks, &video] {
        fs::write(here.path().join("t.csv"), text).expect("written");
        let said = washout(here.path(), &forced);
        assert_eq!(said.code, Some(2), "{}", said.out);
        assert!(
            said.err
                .contains("is not a measurement that washout measure wrote"),
            "{}",
            said.err
        );
        assert_eq!(fs::read_to_string(here.path().join("t.csv")).expect("read"), text);
    }
}

#[test]
fn the_example_conforms_to_the_schema_of_video_files() {
    let text = fs::read_to_string(example("video.toml")).expect("read");
    let value: toml::Value = toml::from_str(&text).expect("TOML");
    conforms(&serde_json::to_value(value).expect("JSON"), &schema(&["--video"]));
}
