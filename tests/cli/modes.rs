//! `washout modes`.

use std::f64::consts::PI;

use crate::{Said, below, conforms, design, entries, folder, schema, washout};

const STEEL: &str = "[material.steel]\ne_gpa = 200.0\npoisson = 0.3\ndensity_kg_m3 = 7800.0\n";

/// Runs `washout modes` on a design of this text.
fn modes(text: &str, more: &[&str]) -> Said {
    let here = folder();
    let file = below(here.path(), "w.toml");
    std::fs::write(&file, format!("format = 1\nname = \"w\"\n{text}{STEEL}")).expect("a design");
    washout(
        here.path(),
        &[&["modes", &file, "--json", "--quiet"], more].concat(),
    )
}

fn column(said: &Said, key: &str) -> Vec<f64> {
    let document = said.document();
    let rows = document["modes"].as_array().expect("modes").iter();
    rows.map(|row| row[key].as_f64().expect(key)).collect()
}

const ROD: &str = "[planform]\nlength_mm = 100.0\nmean_chord_mm = 20.5\nr2_hat = 0.54\n\
                   [[rod]]\nfrom_mm = 0.0\nto_mm = 99.0\nmaterial = \"steel\"\n\
                   section = { shape = \"rectangle\", width_mm = 2.0, thickness_mm = 1.0 }\n";

#[test]
fn a_cantilevered_rod_has_the_closed_forms_and_bends_the_way_they_say() {
    let said = modes(ROD, &["--count", "4"]);
    let found = column(&said, "frequency_hz");
    // f = (βL)²/(2π L²) √(E h²/(12 ρ)), h the depth: 1 mm for flapping, 2 mm in the plane
    let exact = |beta_l: f64, depth_m: f64| {
        let speed = (200e9 / 7800.0 / 12.0_f64).sqrt() * depth_m;
        beta_l * beta_l / (2.0 * PI * 0.099 * 0.099) * speed
    };
    let [first, second] = [1.875_104_07, 4.694_091_13];
    let exact = [
        exact(first, 1e-3),
        exact(first, 2e-3),
        exact(second, 1e-3),
        exact(second, 2e-3),
    ];
    for (found, exact) in found.iter().zip(exact) {
        // shear and rotary inertia, left out of the closed form, take up to (βL)²(h/L)² of it
        assert!((found / exact - 1.0).abs() < 5e-3, "{found} {exact}");
    }
    let (flap, edge) = (column(&said, "flap_share"), column(&said, "edge_share"));
    assert!(
        flap[0] > 0.999 && edge[1] > 0.999 && flap[2] > 0.999 && edge[3] > 0.999,
        "{flap:?} {edge:?}"
    );
}

#[test]
fn a_clamped_plate_has_its_ritz_frequencies_and_its_second_mode_twists() {
    // a wire stands for the rod that every wing has; it adds 1e-4 of the mass and less of the stiffness
    let plate = "[planform]\nlength_mm = 40.0\noutline = [[0.0, 40.0], [40.0, 40.0]]\nbase_closure = 0.0\ntip_cut = 1.0\n\
                 [root]\nchord = \"clamped\"\n\
                 [[rod]]\nfrom_mm = 0.0\nto_mm = 40.0\nmaterial = \"steel\"\n\
                 section = { shape = \"round\", diameter_mm = 0.02 }\n\
                 [film]\nmaterial = \"steel\"\nthickness_mm = 0.1\ncompression = \"carries\"\n";
    let said = modes(plate, &["--count", "4"]);
    let found = column(&said, "frequency_hz");
    // λ = ω a² √(ρ t/D) of a square plate, ν = 0.3: the Ritz solution of verify::cases::cantilever_plate_frequencies
    let speed = (200e9 / 7800.0 / 12.0 / 0.91_f64).sqrt() * 1e-4;
    for (found, lambda) in found.iter().zip([3.4710, 8.5065, 21.285, 27.199]) {
        let exact = lambda * speed / (2.0 * PI * 0.04 * 0.04);
        assert!((found / exact - 1.0).abs() < 0.015, "{found} {exact}");
    }
    let twist = column(&said, "twist_share");
    assert!(twist[1] > 0.4 && twist[0] < 0.1, "{twist:?}");
}

#[test]
fn in_flight_they_are_the_frequencies_of_solve_with_and_without_air() {
    let here = folder();
    let design = design("twist-v2.toml");
    let solved = washout(here.path(), &["solve", &design, "--json", "--quiet"]).document();
    for (air, key) in [
        (&[][..], "natural_frequencies_hz"),
        (&["--with-air"][..], "natural_frequencies_in_air_hz"),
    ] {
        let said = washout(
            here.path(),
            &[&["modes", &design, "--loaded", "--json"], air].concat(),
        );
        assert_eq!(said.code, Some(0), "{}", said.err);
        conforms(&said.document(), &schema(&["--output", "modes"]));
        let found: washout::export::modes::ModesSummary =
            serde_json::from_value(said.document()).expect("modes");
        assert_eq!(found.page().astray(&said.document()), Vec::<String>::new());
        let expected = solved["engineering"][key].as_array().expect("frequencies").iter();
        let expected: Vec<f64> = expected.map(|hz| hz.as_f64().expect("a number")).collect();
        assert_eq!(column(&said, "frequency_hz"), expected);
        let ratio = column(&said, "flapping_ratio");
        assert!((ratio[0] * 23.0 / expected[0] - 1.0).abs() < 1e-12);
    }
}

#[test]
fn the_files_are_those_that_the_document_lists_and_a_refused_design_leaves_none() {
    let here = folder();
    let design = design("rigid.toml");
    let said = washout(
        here.path(),
        &["modes", &design, "--count", "2", "--json", "--quiet"],
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    let target = here.path().join("output/rigid-modes");
    assert_eq!(
        entries(&target),
        ["mode-01.vtu", "mode-02.vtu", "modes.pvd", "summary.json"]
    );
    let warnings = said.document()["warnings"].to_string();
    assert!(warnings.contains("--loaded"), "{warnings}");
    let said = washout(
        here.path(),
        &[
            "modes",
            &design,
            "--set",
            "planform.length_mm=-1",
            "--output",
            "b",
        ],
    );
    assert_eq!((said.code, said.out.as_str()), (Some(2), ""));
    assert_eq!(entries(here.path()), ["output"]);
}
