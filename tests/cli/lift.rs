//! `washout lift`, `pareto`, `design`: one after the other, as somebody who wants a better wing would.

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
