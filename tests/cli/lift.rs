//! `washout lift`, `pareto`, `design`: one after the other, as somebody who wants a better wing would.

use washout::export::layouts::LayoutSummary;
use washout::export::lift::LiftSummary;
use washout::export::pareto::ParetoSummary;

use crate::{below, conforms, design, entries, folder, schema, washout};

#[test]
fn from_wings_to_the_best_profile_to_the_rod_that_makes_it() {
    let here = folder();
    let wings = ["rigid.toml", "twist-v1.toml", "twist-v2.toml"].map(design);
    let [rigid, v1, v2] = [&wings[0], &wings[1], &wings[2]].map(String::as_str);

    let lift = washout(
        here.path(),
        &["lift", rigid, v1, v2, "--twist", "measured", "--json"],
    );
    assert_eq!(lift.code, Some(0), "{}", lift.err);
    conforms(&lift.document(), &schema(&["--output", "lift"]));
    let flown: LiftSummary = serde_json::from_value(lift.document()).expect("wings");
    assert_eq!(flown.page().astray(&lift.document()), Vec::<String>::new());
    assert!(!flown.page().astray(&serde_json::Value::Null).is_empty());
    assert_eq!(
        entries(&here.path().join("output/lift")),
        [
            "lift.csv",
            "ratios.csv",
            "span.csv",
            "span.svg",
            "stroke.csv",
            "stroke.svg",
            "summary.json"
        ]
    );

    let search = [
        "--population",
        "40",
        "--generations",
        "30",
        "--rates",
        "0.001,0.83",
    ];
    let front = [&["pareto", rigid, v1, v2, "--json"], &search[..]].concat();
    let front = washout(here.path(), &front);
    assert_eq!(front.code, Some(0), "{}", front.err);
    conforms(&front.document(), &schema(&["--output", "pareto"]));
    let found: ParetoSummary = serde_json::from_value(front.document()).expect("a front");
    assert_eq!(found.page().astray(&front.document()), Vec::<String>::new());

    let wanted = below(here.path(), "output/rigid-pareto/highest-lift.csv");
    let stock = design("stock.csv");
    let rods = [
        &["design", v2, "--stock", &stock, "--profile", &wanted, "--json"][..],
        &["--pieces", "1", "--set", "mesh.refine=0.3", "--first-look", "1"],
    ];
    let rods = washout(here.path(), &rods.concat());
    assert_eq!(rods.code, Some(0), "{}", rods.err);
    let document = rods.document();
    conforms(&document, &schema(&["--output", "design"]));
    let found: LayoutSummary = serde_json::from_value(document.clone()).expect("layouts");
    assert_eq!(found.page().astray(&document), Vec::<String>::new());
    assert_eq!(
        entries(&here.path().join("output/twist-v2-design")),
        [
            "layout.toml",
            "layouts.csv",
            "profile.csv",
            "profile.svg",
            "summary.json",
            "template.dxf",
            "template.svg"
        ]
    );
    // a uniform rod twists all along, the wanted profile at the base only: the page must say that none makes it
    let said = document["warnings"][0].as_str().expect("a warning");
    assert!(
        said.contains("no layout of these rods makes that twist"),
        "{said}"
    );
}

#[test]
fn what_the_twist_of_solved_phases_or_of_a_profile_cannot_say_is_refused_or_said() {
    let here = folder();
    let (rigid, v2) = (design("rigid.toml"), design("twist-v2.toml"));
    let said = washout(here.path(), &["lift", &v2, "--with", "rotational-lift"]);
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(said.err.contains("--twist ramp"), "{}", said.err);
    let write = |name: &str, text: &str| std::fs::write(here.path().join(name), text).unwrap();
    write("half.csv", "r_mm,twist_deg\n0,0\n35,15\n");
    let said = washout(here.path(), &["lift", &rigid, "half.csv", "--twist", "measured"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    assert!(said.out.contains("covers 0.0 to 35.0 mm"), "{}", said.out);
    assert!(said.out.contains("a bound is measured"), "{}", said.out);
    write("metres.csv", "r_mm,twist_deg\n0,0\n7000,15\n");
    let said = washout(here.path(), &["lift", &rigid, "metres.csv", "--twist", "flat"]);
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(
        said.err.contains("7000") && said.err.contains("70 mm long"),
        "{}",
        said.err
    );
    write(
        "phases.csv",
        "phase_deg,r_mm,twist_deg\n0,0,0\n0,70,20\n45,0,0\n45,70,10\n",
    );
    let stock = design("stock.csv");
    let said = washout(
        here.path(),
        &["design", &v2, "--stock", &stock, "--profile", "phases.csv"],
    );
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(said.err.contains("2 phases"), "{}", said.err);
}

#[test]
fn a_lift_that_no_layout_reaches_is_an_error_and_nothing_is_written() {
    let here = folder();
    std::fs::write(
        here.path().join("one.csv"),
        "name,shape,diameter_mm,material\nthin,round,0.5,carbon-rod\n",
    )
    .unwrap();
    let v2 = design("twist-v2.toml");
    let said = washout(
        here.path(),
        &[
            "design",
            &v2,
            "--stock",
            "one.csv",
            "--pieces",
            "1",
            "--lift",
            "900",
            "--set",
            "mesh.refine=0.4",
            "--output",
            "none",
        ],
    );
    assert!(said.code.is_some_and(|code| code != 0), "{}", said.out);
    assert!(
        said.err.contains("900") && said.err.contains("the most is"),
        "{}",
        said.err
    );
    assert!(!here.path().join("none").exists());
}
