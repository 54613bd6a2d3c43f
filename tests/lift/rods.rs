//! `washout design`: the rod layout that makes a twist, its tolerance, its template.

use serde_json::Value;
use washout::export::template::Template;
use washout::geometry::Planform;
use washout::input::Design;

use crate::{Said, design, file, folder, washout};

const SHELF: &str = "name,shape,diameter_mm,material,tolerance_mm\nround-1.0,round,1.0,carbon-rod,0.03\n\
                     half-1.0,half-round,1.0,carbon-rod,0.03\nround-0.3,round,0.3,carbon-rod,0.01\n";
const COARSE: [&str; 4] = ["--set", "mesh.refine=0.25", "--first-look", "1"];

fn designed(shelf: &str, more: &[&str]) -> (tempfile::TempDir, Said) {
    let here = folder();
    let shelf = file(here.path(), "shelf.csv", shelf);
    let base = design("twist-v2");
    let arguments = [&["design", &base, "--stock", &shelf, "--json"], &COARSE[..], more].concat();
    let said = washout(here.path(), &arguments);
    (here, said)
}

fn numbers(value: &Value) -> Vec<f64> {
    value
        .as_array()
        .expect("numbers")
        .iter()
        .map(|x| x.as_f64().expect("a number"))
        .collect()
}

#[test]
fn a_known_layout_is_recovered_from_the_twist_that_it_makes() {
    let known = design("twist-v2");
    let (here, said) = designed(SHELF, &["--like", &known]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let document = said.document();
    let best = &document["layouts"][0];
    let rods: Vec<&str> = best["rods"]
        .as_array()
        .expect("rods")
        .iter()
        .filter_map(Value::as_str)
        .collect();
    assert_eq!(rods, ["half-1.0", "round-0.3"]);
    // its break stands at 39.9 mm; what is left must be less than what half a millimetre of it, or a diameter, makes
    let at = numbers(&best["to_mm"])[0];
    assert!((at - 39.9).abs() < 1.5, "{at}");
    let band = document["band"]["built_deg"].as_f64().expect("a band");
    assert!(
        best["distance_deg"].as_f64().expect("a distance") < band,
        "{best}"
    );
    for piece in document["band"]["pieces"].as_array().expect("pieces") {
        let rate = piece["rate_deg_per_mm"].as_f64().expect("a rate");
        let off = piece["tolerance_deg_per_mm"].as_f64().expect("a tolerance");
        assert!(rate > 0.1 && off > 0.005 && off < rate, "{piece}");
    }
    // the layout that is written is a design that makes this twist
    let layout = here.path().join("output/twist-v2-design/layout.toml");
    let solved = washout(
        here.path(),
        &["solve", layout.to_str().expect("a path"), "--json", "--quiet"],
    );
    assert_eq!(solved.code, Some(0), "{}", solved.err);
    let tip = solved.document()["tip"]["twist_deg"].as_f64().expect("a twist");
    let said = numbers(&document["band"]["twist_deg"]);
    assert!((tip - said[said.len() - 1]).abs() < 1e-3, "{tip} {said:?}");
}

#[test]
fn two_rods_that_do_equally_well_are_both_named() {
    // a second round of 0.301 mm makes the same wing within any tolerance
    let shelf = SHELF.replace("round-1.0,round,1.0", "thin,round,0.301");
    let (_here, said) = designed(&shelf, &["--like", &design("twist-v2")]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let document = said.document();
    let alike = document["equally_good"].as_u64().expect("a count") as usize;
    assert!(alike >= 2, "{alike}");
    let outer: Vec<&str> = document["layouts"].as_array().expect("layouts")[..alike]
        .iter()
        .filter_map(|row| row["rods"][1].as_str())
        .collect();
    assert!(
        outer.contains(&"thin") && outer.contains(&"round-0.3"),
        "{outer:?}"
    );
}

#[test]
fn the_most_lift_per_power_at_a_required_lift_is_no_less_than_that_of_the_layouts_it_beat() {
    let (_here, said) = designed(SHELF, &["--lift", "25"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let document = said.document();
    let rows = document["layouts"].as_array().expect("layouts");
    let per_power = |row: &Value| row["lift_per_power_n_per_w"].as_f64().expect("a ratio");
    assert!(
        rows[0]["is_feasible"] == true && rows[0]["lift_mn"].as_f64() >= Some(25.0),
        "{rows:?}"
    );
    for row in rows.iter().filter(|row| row["is_feasible"] == true) {
        assert!(per_power(row) <= per_power(&rows[0]) + 1e-12);
    }
    let (_here, said) = designed(SHELF, &["--lift", "500"]);
    assert_eq!(said.code, Some(2), "{}", said.out);
    assert!(
        said.err.contains("no layout of these rods lifts 500 mN"),
        "{}",
        said.err
    );
}

#[test]
fn an_answer_does_not_depend_on_threads() {
    let with = |threads: &str| {
        let (_here, said) = designed(SHELF, &["--lift", "25", "--threads", threads, "--pieces", "1"]);
        let mut answer: serde_json::Value = serde_json::from_str(&said.out).expect("a document");
        // it names its files, which stand in another folder each time
        let files = answer.as_object_mut().and_then(|answer| answer.remove("made_of"));
        assert!(files.is_some(), "{answer}");
        answer
    };
    assert_eq!(with("1"), with("3"));
}

#[test]
fn the_template_is_at_full_size_and_both_files_hold_the_same_lines() {
    let text = std::fs::read_to_string(design("twist-v2")).expect("a design");
    assert!(text.contains("length_mm = 70.0"));
    let loaded = Design::load(design("twist-v2").as_ref(), &[]).expect("a design");
    let planform = Planform::from_design(&loaded.design).expect("an outline");
    let template = Template::new(&loaded.design, &planform);
    // shoelace: the film has the area of the wing
    let ring = &template.film;
    let area: f64 = (0..ring.len())
        .map(|k| {
            let ([x0, y0], [x1, y1]) = (ring[k], ring[(k + 1) % ring.len()]);
            0.5 * (x0 * y1 - x1 * y0)
        })
        .sum();
    assert!(
        (area.abs() / (planform.area_m2() * 1e6) - 1.0).abs() < 1e-3,
        "{area}"
    );
    assert_eq!((template.spars.len(), template.rods.len()), (5, 2));
    let (svg, dxf) = (template.to_svg(), template.to_dxf());
    assert_eq!(svg.matches("<polygon").count(), 8);
    assert_eq!(dxf.matches("\nPOLYLINE\n").count(), 8);
    let width = svg
        .split("width=\"")
        .nth(1)
        .and_then(|rest| rest.split("mm").next());
    let view = svg
        .split("viewBox=\"0 0 ")
        .nth(1)
        .and_then(|rest| rest.split(' ').next());
    assert_eq!(width, view);
    // group codes and values in pairs, ended as R12 wants it
    let lines: Vec<&str> = dxf.lines().collect();
    assert_eq!(lines.len() % 2, 0);
    for code in lines.iter().step_by(2) {
        code.trim().parse::<u32>().expect("a group code");
    }
    assert_eq!(&lines[lines.len() - 2..], ["  0", "EOF"]);
    let largest_x = lines
        .chunks(2)
        .skip_while(|pair| pair[1] != "ENTITIES")
        .filter(|pair| pair[0] == " 10")
        .map(|pair| pair[1].parse::<f64>().expect("a place"))
        .fold(0.0, f64::max);
    assert!((largest_x - 70.0).abs() < 1e-9, "{largest_x}");
}

#[test]
fn bad_inputs_end_with_2_and_say_the_cure() {
    let foreign = SHELF.replace("carbon-rod", "glass");
    for (shelf, more, said) in [
        (SHELF, &[][..], "--profile CSV, --like DESIGN or --lift MN"),
        (SHELF, &["--lift", "-1"], "--lift"),
        (
            SHELF,
            &["--lift", "25", "--break-tolerance", "0"],
            "--break-tolerance",
        ),
        (SHELF, &["--lift", "25", "--tension", "nan"], "--tension"),
        (SHELF, &["--profile", "none.csv"], "no such file"),
        (foreign.as_str(), &["--lift", "25"], "glass"),
        ("name,shape,diameter_mm,material\n", &["--lift", "25"], "no rows"),
    ] {
        let (_here, done) = designed(shelf, more);
        assert_eq!(done.code, Some(2), "{more:?}: {}", done.err);
        assert!(done.err.contains(said), "{more:?}: {}", done.err);
    }
}
