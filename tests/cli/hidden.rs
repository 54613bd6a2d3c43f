//! Campaigns tried before they are measured: planned, made with a hidden effect, told apart by one more experiment.

use std::fs;
use std::path::Path;

use crate::{Said, washout};

/// A rod on the bench under three torques; `stations` at which its twist is to be read, sigma 0.01 deg; values yet to come.
pub fn campaign(folder: &Path, stations: &[u32]) {
    fs::write(
        folder.join("rod.toml"),
        "format = 1\nname = 'rod'\n[planform]\nlength_mm = 100.0\noutline = [[0.0, 20.0], [100.0, 20.0]]\ntip_cut = 1.0\n\
         [ribs]\nbays = 10\n[[rod]]\nfrom_mm = 0.0\nto_mm = 100.0\nmaterial = 'steel'\n\
         section = { shape = 'round', diameter_mm = 1.0 }\n\
         [material.steel]\ne_gpa = 200.0\ng_gpa = 80.0\npoisson = 0.25\ndensity_kg_m3 = 8000.0\n\
         [[load]]\nat_mm = 100.0\nmoment_n_m = [0.001, 0.0, 0.0]\n",
    )
    .unwrap();
    let rows = |case: &str, stations: &[u32]| -> String {
        let row =
            |r_mm: &u32| format!("{case},twist,chord_rotation,deg,washout,,{r_mm},,,0.01,stated,none\n");
        stations.iter().map(row).collect()
    };
    let head = "case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n";
    let cases: String = (1..=3)
        .map(|moment| rows(&format!("m-{moment}"), stations))
        .collect();
    fs::write(folder.join("m.csv"), format!("{head}{cases}")).unwrap();
    let next = format!(
        "{head}{}{}",
        rows("tip-again", &[100]),
        rows("near-the-root", &[10, 20])
    );
    fs::write(folder.join("next.csv"), next).unwrap();
    let experiment = |name: &str| {
        format!(
            "[[experiment]]\ndesign = 'rod.toml'\nset = ['load[0].moment_n_m=[0.003, 0, 0]']\nmeasurement = 'next.csv'\n\
             measured = '{name}'\n"
        )
    };
    let study = format!(
        "# a plan\nformat = 1\nname = 'bench'\ncandidates = ['rod-shear-modulus', 'root-flexure']\n[[case]]\n\
         design = 'rod.toml'\nset = ['load[0].moment_n_m=[{{moment*0.001}}, 0, 0]']\nmeasurement = 'm.csv'\n\
         measured = 'm-{{moment}}'\n{}{}",
        experiment("tip-again"),
        experiment("near-the-root")
    );
    fs::write(folder.join("study.toml"), study).unwrap();
}

pub fn json(said: &Said) -> serde_json::Value {
    assert_eq!(said.code, Some(0), "{}", said.err);
    serde_json::from_str(&said.out).unwrap()
}

/// Stations that tell effects apart.
pub const MANY: [u32; 10] = [10, 20, 30, 40, 50, 60, 70, 80, 90, 100];

#[test]
fn a_campaign_without_values_can_be_judged_but_not_compared() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), &MANY);
    let refused = washout(folder.path(), &["compare", "study.toml"]);
    assert_eq!(refused.code, Some(2), "{}", refused.out);
    assert!(
        refused.err.contains("m.csv:2: value") && refused.err.contains("--plan"),
        "{}",
        refused.err
    );
    let plan = json(&washout(
        folder.path(),
        &["diagnose", "study.toml", "--plan", "--json"],
    ));
    assert_eq!(plan["numbers"], 30);
    let effect = |name: &str| {
        plan["effects"]
            .as_array()
            .unwrap()
            .iter()
            .find(|e| e["effect"] == name)
            .unwrap()
            .clone()
    };
    // twist 0.73 deg at 1 mN m: 0.35 of it is 0.26 deg, 26 sigma at the tip alone
    let detectability = effect("rod-shear-modulus")["detectability"].as_f64().unwrap();
    assert!(detectability > 26.0, "{detectability}");
    assert!(
        effect("root-flexure")["confused_with"]
            .as_array()
            .unwrap()
            .is_empty()
    );
}

/// θ = T/GJ (r + 1.640 s (r − from)) outboard of the split; half split from 53 mm on, which is no place that is looked at first.
#[test]
fn a_rod_that_is_split_from_somewhere_on_is_named_with_the_place() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), &MANY);
    let gj = 80e9 * std::f64::consts::PI / 32.0 * 1e-12;
    let mut rows =
        String::from("case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n");
    for moment in 1..=3 {
        for (index, r_mm) in MANY.into_iter().enumerate() {
            let r_m = 1e-3 * f64::from(r_mm);
            let split_m = (r_m - 0.053).max(0.0);
            let twist = 1e-3 * f64::from(moment) / gj * (r_m + 1.640 * 0.5 * split_m);
            // up and down by the sigma or half of it, in no order that the model has
            let scatter = [0.01, -0.005, -0.01, 0.005][(7 * index + 3 * moment as usize) % 4];
            let twist = twist.to_degrees() + scatter;
            rows += &format!(
                "m-{moment},twist,chord_rotation,deg,washout,,{r_mm},,{twist:.5},0.01,stated,none\n"
            );
        }
    }
    fs::write(folder.path().join("m.csv"), rows).unwrap();
    let study = fs::read_to_string(folder.path().join("study.toml")).unwrap();
    let study = study.replace("'root-flexure']", "'root-flexure', 'rod-split']");
    fs::write(folder.path().join("study.toml"), study).unwrap();
    let said = json(&washout(folder.path(), &["diagnose", "study.toml", "--json"]));
    assert_eq!(said["verdict"], "effect", "{}", said["sentence"]);
    let strength = &said["hypotheses"][0]["strengths"][0];
    assert_eq!(strength["effect"], "rod-split");
    let number = |value: &serde_json::Value| value.as_f64().unwrap();
    let place = &strength["place"];
    assert_eq!(place["parameter"], "from");
    let (from, error) = (number(&place["value"]), number(&place["standard_error"]));
    assert!((from - 0.53).abs() < 3.0 * error && error < 0.02, "{place}");
    assert!(
        (number(&strength["value"]) - 0.5).abs() < 3.0 * number(&strength["standard_error"]),
        "{strength}"
    );
    // joined to the model where it was found, it leaves nothing
    let add = [
        "add",
        "rod-split",
        "--to",
        "study.toml",
        "--number",
        "from=0.53",
        "--output",
        "with.toml",
    ];
    let added = json(&washout(folder.path(), &[&add[..], &["--json"]].concat()));
    let [before, now] = [1, 2].map(|rung| &added["ladder"][rung]["groups"][0]);
    assert!(number(&now["rmse"]) < 0.1 * number(&before["rmse"]), "{added}");
    let chi = "chi_square_per_number";
    assert!(number(&before[chi]) > 100.0 && number(&now[chi]) < 1.5, "{added}");
    let after = json(&washout(folder.path(), &["diagnose", "with.toml", "--json"]));
    assert_eq!(after["verdict"], "nothing", "{}", after["sentence"]);
}

#[test]
fn what_was_hidden_is_found_and_data_of_the_same_making_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), &MANY);
    let run = |arguments: &[&str]| washout(folder.path(), arguments);
    let hide = [
        "synthesize",
        "study.toml",
        "--effect",
        "root-flexure=0.2",
        "--seed",
        "7",
        "--output",
        "try",
    ];
    let made = json(&run(&[&hide[..], &["--json"]].concat()));
    assert_eq!(made["numbers"], 30);
    let answer: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("try/answer.json")).unwrap()).unwrap();
    assert_eq!(answer["acted"][0]["asked"], "root-flexure");
    // of a soft root there is no other formula, and that is said
    assert_eq!(answer["acted"][0]["is_other"], false);
    assert_eq!(made["same_formula"][0], "root-flexure");
    let recipe = &answer["recipe"]["made"];
    assert!(
        recipe["mesh"] != 1.0 && recipe["seed"] != 1 && recipe["formulas"] == "other",
        "{recipe}"
    );
    let text = fs::read_to_string(folder.path().join("try/study.toml")).unwrap();
    assert!(
        text.starts_with("# a plan") && !text.contains("root-flexure="),
        "{text}"
    );

    let said = json(&run(&["diagnose", "try/study.toml", "--json"]));
    assert_eq!(said["hypotheses"][0]["effects"][0], "root-flexure", "{said}");
    let strength = said["hypotheses"][0]["strength"].as_f64().unwrap();
    assert!((strength - 0.2).abs() < 0.02, "{strength}");

    json(&run(&[&hide[..], &["--json", "--same-formulas"]].concat()));
    let refused = run(&["diagnose", "try/study.toml"]);
    assert_eq!(refused.code, Some(2), "{}", refused.out);
    assert!(
        refused.err.contains("the same formulas") && refused.err.contains("--own-data"),
        "{}",
        refused.err
    );
    json(&run(&["diagnose", "try/study.toml", "--own-data", "--json"]));
}

#[test]
fn effects_that_have_a_rival_are_hidden_by_it_and_two_of_them_do_not_displace_each_other() {
    let folder = tempfile::tempdir().unwrap();
    let study = concat!(env!("CARGO_MANIFEST_DIR"), "/studies/three-rods.toml");
    let hidden = [
        "coefficient-scale=-0.2",
        "skin-torsion=0.2",
        "tip-loss-prandtl=0.5",
        "spar-stiffness=0.3",
        "rod-ends-early=0.3",
    ];
    let effects: Vec<&str> = hidden.iter().flat_map(|effect| ["--effect", effect]).collect();
    let made = json(&washout(
        folder.path(),
        &[&["synthesize", study, "--output", "try", "--json"][..], &effects].concat(),
    ));
    assert_eq!(made["same_formula"].as_array().map(Vec::len), Some(0), "{made}");
    let answer: serde_json::Value =
        serde_json::from_str(&fs::read_to_string(folder.path().join("try/answer.json")).unwrap()).unwrap();
    let acted = answer["acted"].as_array().unwrap();
    assert_eq!(acted.len(), hidden.len());
    for acted in acted {
        assert!(
            acted["is_other"] == true && acted["formula"] != acted["asked"],
            "{acted}"
        );
    }
    // what all of them do is not what any one does
    let read = |name: &str, effects: &[&str]| {
        let made = [
            &[
                "synthesize",
                study,
                "--output",
                name,
                "--background",
                "0",
                "--noise",
                "0",
            ][..],
            effects,
        ];
        let said = washout(folder.path(), &made.concat());
        assert_eq!(said.code, Some(0), "{}", said.err);
        let written = fs::read_dir(folder.path().join(name)).unwrap();
        let csv = written
            .map(|file| file.unwrap().path())
            .find(|file| file.extension().is_some_and(|end| end == "csv"));
        fs::read_to_string(csv.unwrap()).unwrap()
    };
    let both = read(
        "both",
        &[
            "--effect",
            "skin-torsion=0.2",
            "--effect",
            "coefficient-scale=-0.2",
        ],
    );
    for (name, one) in [("skin", "skin-torsion=0.2"), ("air", "coefficient-scale=-0.2")] {
        assert_ne!(both, read(name, &["--effect", one]), "{one}");
    }
}

#[test]
fn bad_recipes_are_refused_with_their_cure() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), &MANY);
    for (arguments, words) in [
        (["--output", "."], "belongs to the study"),
        (["--effect", "root-flexure"], "NAME=STRENGTH"),
        (["--effect", "root-flexture=0.2"], "there is no such effect"),
        (["--effect", "root-flexure=-1"], "outside 0 to 1000"),
        (["--effect", "tip-loss-prandtl=0.5"], "acts on none"),
        (["--background", "2"], "outside 0 to 0.2"),
    ] {
        let said = washout(
            folder.path(),
            &[&["synthesize", "study.toml"][..], &arguments].concat(),
        );
        assert_eq!(said.code, Some(2), "{arguments:?}: {}", said.out);
        assert!(said.err.contains(words), "{arguments:?}: {}", said.err);
        assert!(!folder.path().join("output").exists(), "{arguments:?}");
    }
}

#[test]
fn what_one_campaign_cannot_tell_apart_the_experiment_that_it_names_does() {
    let folder = tempfile::tempdir().unwrap();
    // twist at the tip alone: a soft rod and a soft root are one
    campaign(folder.path(), &[98, 99, 100]);
    let run = |arguments: &[&str]| washout(folder.path(), arguments);
    let hide = |output: &str| {
        let arguments = [
            "synthesize",
            "study.toml",
            "--effect",
            "root-flexure=0.2",
            "--seed",
            "7",
            "--output",
            output,
            "--json",
        ];
        json(&run(&arguments))
    };
    hide("first");
    let said = json(&run(&["diagnose", "first/study.toml", "--json"]));
    let in_set: Vec<&str> = said["hypotheses"]
        .as_array()
        .unwrap()
        .iter()
        .filter(|h| h["in_set"] == true)
        .filter_map(|h| h["effects"][0].as_str())
        .collect();
    assert!(
        in_set.contains(&"root-flexure") && in_set.contains(&"rod-shear-modulus"),
        "{said}"
    );
    assert_eq!(
        said["next_experiment"]["candidates"][0]["name"], "near-the-root",
        "{}",
        said["next_experiment"]
    );

    // without a list it names the cheapest reading that decides, and looks at none that is dearer
    let study = folder.path().join("first/study.toml");
    let text = fs::read_to_string(&study).unwrap();
    let (cases, _) = text.split_once("[[experiment]]").unwrap();
    fs::write(&study, cases).unwrap();
    let said = json(&run(&["diagnose", "first/study.toml", "--json"]));
    let next = &said["next_experiment"];
    assert_eq!(next["best"], "twist at 49 mm in case m-3", "{next}");
    assert_eq!(next["candidates"].as_array().map(Vec::len), Some(1), "{next}");
    let sentence = next["sentence"].as_str().unwrap();
    assert!(
        sentence.starts_with("Measure twist at 49 mm in case m-3 next: "),
        "{sentence}"
    );
    let shown = run(&["diagnose", "first/study.toml", "--report"]);
    let page = fs::read_to_string(folder.path().join("output/bench-diagnosis/report.html")).unwrap();
    for text in [&shown.out, &page] {
        assert!(text.contains("twist at 49 mm in case m-3"), "{text}");
    }

    // an experiment that is listed is made, and decides
    campaign(folder.path(), &[10, 20, 98, 99, 100]);
    hide("second");
    let said = json(&run(&["diagnose", "second/study.toml", "--json"]));
    let first = &said["hypotheses"][0];
    assert!(
        first["effects"][0] == "root-flexure" && first["probability"].as_f64().unwrap() > 0.9,
        "{said}"
    );
}

#[test]
fn a_blind_run_goes_on_where_it_stopped_and_gives_the_same_scoreboard() {
    let folder = tempfile::tempdir().unwrap();
    campaign(folder.path(), &MANY);
    let text = fs::read_to_string(folder.path().join("study.toml")).unwrap();
    let text = text.replace(
        "['rod-shear-modulus', 'root-flexure']",
        "['rod-shear-modulus', 'root-flexure', 'skin-torsion']",
    );
    fs::write(folder.path().join("study.toml"), text).unwrap();
    let run = |count: &str, threads: &str| {
        let arguments = [
            "blind",
            count,
            "--study",
            "study.toml",
            "--output",
            "blind",
            "--json",
            "--threads",
            threads,
        ];
        let mut board = json(&washout(folder.path(), &arguments));
        board.as_object_mut().unwrap().remove("median_seconds");
        board
    };
    let whole = run("9", "2");
    assert_eq!(whole["cases"], 9);
    let alarms = whole["rows"]
        .as_array()
        .unwrap()
        .iter()
        .find(|row| row["what"] == "false alarms, all of these")
        .unwrap();
    assert_eq!(alarms["hits"], 0, "{whole}");
    for gone in ["single-1.json", "twin-9.json"] {
        fs::remove_file(folder.path().join("blind-tasks/cases").join(gone)).unwrap();
    }
    assert_eq!(run("9", "1"), whole);
    let other = [
        "blind",
        "2",
        "--study",
        "study.toml",
        "--output",
        "blind",
        "--effect",
        "root-flexure",
    ];
    let refused = washout(folder.path(), &other);
    assert_eq!(refused.code, Some(2), "{}", refused.out);
    assert!(refused.err.contains("holds cases of another"), "{}", refused.err);
    assert_eq!(
        washout(folder.path(), &["blind", "0", "--study", "study.toml"]).code,
        Some(2)
    );
    let page = fs::read_to_string(folder.path().join("blind/scoreboard.md")).unwrap();
    assert!(
        page.contains("| single | 1 |") && page.contains("development benchmark"),
        "{page}"
    );
}

/// Two rods alike under three torques each, one of them split from half its length on.
#[test]
fn damage_on_one_wing_is_found_on_that_wing_and_added_there() {
    let here = tempfile::tempdir().unwrap();
    campaign(here.path(), &MANY);
    let rows = fs::read_to_string(here.path().join("m.csv")).unwrap();
    let others: String = rows
        .lines()
        .filter_map(|row| row.strip_prefix("m-"))
        .map(|row| format!("n-{row}\n"))
        .collect();
    fs::write(here.path().join("m.csv"), rows + &others).unwrap();
    let case = |name: &str, letter: char| {
        format!(
            "[[case]]\ndesign = 'rod.toml'\nset = ['name=\"{name}\"', 'load[0].moment_n_m=[{{m*0.001}}, 0, 0]']\n\
             measurement = 'm.csv'\nmeasured = '{letter}-{{m}}'\n"
        )
    };
    let study = format!(
        "format = 1\nname = 'two'\ncandidates = ['rod-shear-modulus', 'root-flexure', 'rod-split']\n{}{}",
        case("rod", 'm'),
        case("other", 'n')
    );
    fs::write(here.path().join("two.toml"), study).unwrap();
    let hide = [
        "synthesize",
        "two.toml",
        "--effect",
        "rod-split@other=0.5",
        "--seed",
        "5",
        "--output",
        "try",
    ];
    assert_eq!(washout(here.path(), &hide).code, Some(0));
    let diagnose = |output: &str| {
        let arguments = ["diagnose", "try/two.toml", "--output", output, "--json"];
        json(&washout(here.path(), &arguments))
    };
    let said = diagnose("first");
    assert_eq!(said["verdict"], "effect", "{}", said["sentence"]);
    let place = &said["hypotheses"][0]["strengths"][0]["place"];
    assert_eq!(place["wing"], "other", "{place}");
    assert!(
        said["sentence"].as_str().unwrap().contains("on other"),
        "{}",
        said["sentence"]
    );
    let from = format!("from={}", place["value"]);
    let add = [
        "add",
        "rod-split",
        "--number",
        &from,
        "--on",
        "other",
        "--to",
        "try/two.toml",
        "--json",
    ];
    let added = json(&washout(here.path(), &add));
    assert!(
        (added["strength"][0].as_f64().unwrap() - 0.5).abs() < 0.1,
        "{}",
        added["strength"]
    );
    let said = diagnose("second");
    assert_eq!(said["verdict"], "nothing", "{}", said["sentence"]);
    // given again for the other rod, it moves there
    let moved = [
        "add",
        "rod-split",
        "--on",
        "rod",
        "--to",
        "try/two.toml",
        "--json",
    ];
    assert_eq!(washout(here.path(), &moved).code, Some(0));
    let text = fs::read_to_string(here.path().join("try/two.toml")).unwrap();
    assert!(
        text.contains("designs = [\"rod\"]") && text.contains("from = "),
        "{text}"
    );
    let nowhere = [
        "synthesize",
        "two.toml",
        "--effect",
        "rod-split@none=0.5",
        "--output",
        "no",
    ];
    let said = washout(here.path(), &nowhere);
    assert_eq!(said.code, Some(2), "{}", said.err);
    assert!(
        said.err.contains("no wing none") && said.err.contains("rod, other"),
        "{}",
        said.err
    );
}
