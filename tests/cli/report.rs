//! `washout report`, and `--report` of the verbs that solve.

use std::fs;

use crate::{below, conforms, design, entries, folder, schema, washout};

/// The document in an element of data of a page.
fn embedded(page: &str, id: &str) -> serde_json::Value {
    let rest = page.split(&format!("id=\"{id}\">")).nth(1).expect("an element");
    serde_json::from_str(rest.split("</script>").next().expect("its end")).expect("JSON")
}

#[test]
fn a_run_is_reported_in_one_file_with_its_summary_and_reported_again_to_the_same_bytes() {
    let here = folder();
    let run = |arguments: &[&str]| washout(here.path(), arguments);
    let wing = design("twist-v2.toml");
    let said = run(&["solve", &wing, "--report", "--json"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let target = here.path().join("output/twist-v2");
    assert!(entries(&target).contains(&"report.html".to_string()));
    let page = fs::read_to_string(target.join("report.html")).expect("a report");
    assert_eq!(embedded(&page, "summary"), said.document());
    for outside in ["src=", "href=\"http", "@import", "url("] {
        assert!(!page.contains(outside), "{outside}");
    }
    for words in [
        "<canvas id=\"wing-canvas\"",
        "◆",
        "data-of=\"/tip/twist_deg\">20.58<",
    ] {
        assert!(page.contains(words), "{words}");
    }

    let made = run(&["report", "output/twist-v2", "--json"]);
    assert_eq!(made.code, Some(0), "{}", made.err);
    conforms(&made.document(), &schema(&["--output", "report"]));
    let again = fs::read_to_string(target.join("report.html")).expect("a report");
    assert!(again == page, "another page from the same run");

    // A report goes with its run, a page of the user does not.
    assert_eq!(run(&["solve", &wing, "--quiet"]).code, Some(0));
    assert!(!target.join("report.html").exists());
    fs::write(here.path().join("mine.html"), "mine").expect("a file");
    let refused = run(&["report", "output/twist-v2", "--output", "mine.html"]);
    assert_eq!(refused.code, Some(2));
    assert_eq!(
        refused.err,
        "washout: mine.html exists already and is not a report of washout; give another name, or move it away\n"
    );
    assert_eq!(
        fs::read_to_string(here.path().join("mine.html")).expect("a file"),
        "mine"
    );
}

#[test]
fn the_stroke_and_the_measured_twist_are_in_the_report_and_the_rod_stays_clamped_in_its_frame() {
    let here = folder();
    let v2 = design("twist-v2.toml");
    let told = [
        "solve", &v2, "--refine", "0.5", "--stroke", "8", "--report", "--json",
    ];
    let said = washout(here.path(), &told);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let page = fs::read_to_string(here.path().join("output/twist-v2/report.html")).expect("a report");
    let wing = embedded(&page, "wing-data")["wings"][0].clone();
    let list = |value: &serde_json::Value| value.as_array().expect("a list").clone();
    let rest = list(&wing["rest"]);
    let base = (0..rest.len() / 3).find(|&node| rest[3 * node] == 0 && rest[3 * node + 1] == 0);
    let base = base.expect("a node at the base of the rod");
    let stroke = list(&wing["stroke"]);
    assert_eq!(stroke.len(), 8);
    for (row, phase) in stroke.iter().enumerate() {
        assert_eq!(phase["row"], row);
        let moved = list(&phase["moved"]);
        assert_eq!(moved.len(), rest.len());
        // a pose that is not that of the file would leave millimetres here
        for own in &moved[3 * base..3 * base + 3] {
            assert!(
                own.as_f64().expect("a number").abs() <= 2.0,
                "phase {row}: {own} um"
            );
        }
        let twist = list(&phase["twist"]);
        assert_eq!(3 * twist.len(), rest.len());
    }
    let stations = list(&wing["measured"][0]["stations"]);
    assert_eq!(stations[0], serde_json::json!([0.0, 0.0]));
    let last = list(stations.last().expect("a station"));
    let span = &said.document()["measured"]["span"][0]["stations"];
    let outermost = list(span).last().cloned().expect("a station");
    for (shown, own) in last.iter().zip([&outermost["r_mm"], &outermost["measured_deg"]]) {
        let [shown, own] = [shown, own].map(|number| number.as_f64().expect("a number"));
        assert!((shown - own).abs() < 1e-3, "{shown} {own}");
    }

    let summary = here.path().join("output/twist-v2/summary.json");
    let text = fs::read_to_string(&summary).expect("a summary");
    let strange = text.replacen("\"file\": \"wing-phase-003.vtu\"", "\"file\": \"../wing.vtu\"", 1);
    assert!(strange != text);
    fs::write(&summary, strange).expect("written");
    let refused = washout(here.path(), &["report", "output/twist-v2"]);
    assert_eq!(refused.code, Some(2), "{}", refused.err);
    assert!(
        refused.err.contains("no file of the run: ../wing.vtu"),
        "{}",
        refused.err
    );
}

#[test]
fn every_number_of_the_page_of_a_run_and_of_a_comparison_stands_in_its_document() {
    let here = folder();
    let v2 = design("twist-v2.toml");
    let run = |arguments: &[&str]| washout(here.path(), arguments).document();
    let solved = run(&[
        "solve",
        &v2,
        "--refine",
        "0.5",
        "--stroke",
        "8",
        "--uncertainty",
        "16",
        "--json",
    ]);
    let summary = serde_json::from_value(solved.clone()).expect("a summary");
    assert_eq!(
        washout::export::report::page(&summary, &[]).astray(&solved),
        Vec::<String>::new()
    );
    let compared = run(&["compare", &v2, "--refine", "0.5", "--json"]);
    let found = serde_json::from_value(compared["comparison"].clone()).expect("a comparison");
    assert_eq!(
        washout::export::comparison::page(&found).astray(&compared),
        Vec::<String>::new()
    );
    let elsewhere = &compared["comparison"];
    assert!(
        !washout::export::comparison::page(&found)
            .astray(elsewhere)
            .is_empty()
    );
}

#[test]
fn every_verb_that_writes_a_folder_reports_it_in_words_pictures_tables_and_numbers() {
    let here = folder();
    let (rigid, v2) = (design("rigid.toml"), design("twist-v2.toml"));
    let verbs: [(&[&str], &str, &str, &[&str]); 4] = [
        (
            &["lift", &rigid, &v2, "--twist", "measured"],
            "output/lift",
            "summary",
            &["<svg", "span.csv", "data-of=\"/wings/0/"],
        ),
        (
            &["modes", &v2, "--refine", "0.4", "--count", "2"],
            "output/twist-v2-modes",
            "summary",
            &["Natural modes about", "data-of=\"/modes/0/frequency_hz\""],
        ),
        (
            &["verify", "--short", "elastica"],
            "output/verify",
            "verify",
            &["elastica", "verify.csv"],
        ),
        (
            &[
                "sweep",
                &v2,
                "--set",
                "mesh.refine=0.3",
                "--vary",
                "flapping.frequency_hz=20..24:3",
            ],
            "output/twist-v2-sweep",
            "summary",
            &["<svg", "sweep.csv", "3 cases"],
        ),
    ];
    for (arguments, target, id, parts) in verbs {
        let said = washout(here.path(), &[arguments, &["--report", "--json"]].concat());
        assert_eq!(said.code, Some(0), "{arguments:?}: {}", said.err);
        let target_path = here.path().join(target);
        let page = fs::read_to_string(target_path.join("report.html")).expect("a report");
        assert_eq!(embedded(&page, id), said.document(), "{arguments:?}");
        for part in parts {
            assert!(
                page.contains(part),
                "{part} is not in the report of {arguments:?}"
            );
        }
        let again = washout(here.path(), &["report", target, "--json"]);
        assert_eq!(again.code, Some(0), "{arguments:?}: {}", again.err);
        let page_again = fs::read_to_string(target_path.join("report.html")).expect("a report");
        // what a sweep says rests on its rows, which its document does not hold
        assert_eq!(page_again == page, !target.ends_with("sweep"), "{arguments:?}");
    }
}

#[test]
fn what_cannot_be_reported_ends_with_2_and_says_what_to_give() {
    let here = folder();
    let refused = |arguments: &[&str], words: &str| {
        let said = washout(here.path(), arguments);
        assert_eq!((said.code, said.out.as_str()), (Some(2), ""), "{arguments:?}");
        assert!(said.err.contains(words), "{words:?} is not in\n{}", said.err);
    };
    refused(&["report", &design("rigid.toml")], "rigid.toml --report");
    refused(&["report", &below(here.path(), "")], "no run");
    refused(&["report", "nowhere"], "nowhere");
    refused(
        &["report", &below(here.path(), ""), "--diagnose"],
        "belongs to a study",
    );
    assert!(entries(here.path()).is_empty());
}
