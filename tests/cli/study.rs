//! Studies: compared, diagnosed, an effect added and taken out again.

use std::fs;
use std::path::Path;

use crate::hidden::{MANY, campaign, json};
use crate::washout;

/// A cantilever whose torsional stiffness was 20 % lower than its design says: 1 mN·m to 3 mN·m at the tip, ten readings.
fn bench(folder: &Path) {
    fs::write(
        folder.join("rod.toml"),
        "format = 1\nname = 'rod'\n[planform]\nlength_mm = 100.0\noutline = [[0.0, 20.0], [100.0, 20.0]]\ntip_cut = 1.0\n\
         [ribs]\nbays = 10\n[[rod]]\nfrom_mm = 0.0\nto_mm = 100.0\nmaterial = 'steel'\n\
         section = { shape = 'round', diameter_mm = 1.0 }\n\
         [material.steel]\ne_gpa = 200.0\ng_gpa = 80.0\npoisson = 0.25\ndensity_kg_m3 = 8000.0\n\
         [[load]]\nat_mm = 100.0\nmoment_n_m = [0.001, 0.0, 0.0]\n",
    )
    .unwrap();
    let mut rows =
        String::from("case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n");
    let per_mn_m = 0.001 * 0.1 / (80e9 * std::f64::consts::PI / 32.0 * 1e-12);
    let scatter = [0.6, -0.9, 0.2, -0.3, 1.1, -0.5, 0.4, -1.2, 0.1, 0.8];
    for moment in 1..=3 {
        for (place, noise) in scatter.iter().enumerate() {
            let r_mm = 10.0 * (place + 1) as f64;
            let twist = 1.25 * f64::from(moment) * per_mn_m.to_degrees() * r_mm / 100.0
                + 0.004 * noise * f64::from(4 - moment);
            rows.push_str(&format!(
                "m-{moment},twist,chord_rotation,deg,washout,,{r_mm},,{twist:.5},0.01,stated,none\n"
            ));
        }
    }
    fs::write(folder.join("m.csv"), rows).unwrap();
    fs::write(
        folder.join("study.toml"),
        "# my bench\nformat = 1\nname = 'bench'\n[[case]]\ndesign = 'rod.toml'\nset = ['load[0].moment_n_m=[{moment*0.001}, 0, 0]']\n\
         measurement = 'm.csv'\nmeasured = 'm-{moment}'\nheld_out = ['m-2']\n\
         [[ruler]]\nkind = 'offset'\nchannel = 'twist'\nsigma = 0.01\n",
    )
    .unwrap();
}

#[test]
fn a_rod_softer_than_stated_is_found_and_added_and_the_error_falls_where_it_was_not_fitted() {
    let folder = tempfile::tempdir().unwrap();
    bench(folder.path());
    let run = |arguments: &[&str]| washout(folder.path(), arguments);

    let compared = run(&["compare", "study.toml"]);
    assert_eq!(compared.code, Some(0), "{}", compared.err);
    assert!(compared.out.contains("offset of twist"), "{}", compared.out);

    let few = [
        "--effect",
        "rod-shear-modulus",
        "--effect",
        "centre-of-pressure-shift",
    ];
    let mut arguments = vec!["diagnose", "study.toml", "--json"];
    arguments.extend(few);
    let said = run(&arguments);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let diagnosis: serde_json::Value = serde_json::from_str(&said.out).unwrap();
    assert_eq!(
        diagnosis["hypotheses"][0]["effects"][0], "rod-shear-modulus",
        "{}",
        said.out
    );
    let strength = diagnosis["hypotheses"][0]["strength"].as_f64().unwrap();
    assert!((strength - 0.25).abs() < 0.03, "{strength}");

    // σ is 0.01 deg everywhere, so that a root mean square in deg and one in σ are one number
    let groups = diagnosis["misfit"]["by_condition"].as_array().unwrap();
    let of = |group: &serde_json::Value, key: &str| group[key].as_f64().unwrap();
    assert!(!groups.is_empty());
    let shares: f64 = groups.iter().map(|group| of(group, "share")).sum();
    assert!((shares - 1.0).abs() < 1e-9, "{shares}");
    let sigma = of(&groups[0], "rms") / of(&groups[0], "rms_sigma");
    for group in groups {
        let (rms, mean) = (of(group, "rms"), of(group, "mean_error"));
        assert!(rms >= mean.abs() * (1.0 - 1e-12), "{group}");
        assert!(
            (rms / of(group, "rms_sigma") / sigma - 1.0).abs() < 1e-9,
            "{group}"
        );
    }

    let added = run(&["add", "rod-shear-modulus", "--to", "study.toml"]);
    assert_eq!(added.code, Some(0), "{}", added.err);
    let text = fs::read_to_string(folder.path().join("study.toml")).unwrap();
    assert!(
        text.starts_with("# my bench") && text.contains("name = \"rod-shear-modulus\""),
        "{text}"
    );
    let report = run(&["compare", "study.toml", "--json"]);
    let report: serde_json::Value = serde_json::from_str(&report.out).unwrap();
    let held_out = report["groups"]
        .as_array()
        .unwrap()
        .iter()
        .find(|g| g["is_held_out"] == true)
        .unwrap();
    assert!(held_out["rmse"][1].as_f64().unwrap() < 0.02, "{held_out}");

    let left = report["chi_square_per_row"][1].as_f64().unwrap();
    assert!(left < 2.0, "{left}");

    // the wing as calibrated gives what the study says of it, but for the error of the instrument
    let solved = json(&run(&[
        "solve",
        "output/bench-compare/calibrated-rod.toml",
        "--json",
    ]));
    let rows = report["rows"].as_array().unwrap();
    let tip = rows
        .iter()
        .find(|row| row["case"] == "m-1" && row["r_mm"] == 100.0)
        .unwrap();
    let is_offset = |own: &&serde_json::Value| own["unknown"]["name"].as_str().unwrap().starts_with("offset");
    let unknowns = report["unknowns"].as_array().unwrap();
    let offset = unknowns.iter().find(is_offset).unwrap()["value"]
        .as_f64()
        .unwrap();
    let of = |value: &serde_json::Value| value.as_f64().unwrap();
    // a uniform rod under a torque at its tip twists in proportion to the distance from its base
    let alone = of(&solved["tip"]["twist_deg"]) * 100.0 / of(&solved["tip"]["r_mm"]);
    let of_study = of(&tip["after"]);
    assert!(
        (alone + offset - of_study).abs() < 1e-4 * of_study,
        "{alone} + {offset}, {of_study}"
    );

    let listed = |target: &str| crate::entries(&folder.path().join("output").join(target));
    assert_eq!(
        listed("bench-compare"),
        [
            "calibrated-rod.toml",
            "compared.csv",
            "compared.svg",
            "comparison.json",
            "residuals-in-sigma.svg",
            "residuals.csv",
            "residuals.svg"
        ]
    );
    assert_eq!(
        listed("bench-diagnosis"),
        [
            "added-variables.csv",
            "added-variables.svg",
            "diagnosis.json",
            "ladder.csv",
            "ladder.svg",
            "misfit-by-station.csv",
            "misfit-by-station.svg",
            "residuals-in-sigma.svg"
        ]
    );
    assert_eq!(
        listed("bench-ladder"),
        ["calibrated-rod.toml", "ladder.csv", "ladder.json", "ladder.svg"]
    );
    let ladder = fs::read_to_string(folder.path().join("output/bench-ladder/ladder.csv")).unwrap();
    assert!(
        ladder.contains("rod,twist,root_mean_square,deg,+ rod-shear-modulus,held out,0.0"),
        "{ladder}"
    );
    assert!(
        added.out.contains("4 files in output/bench-ladder"),
        "{}",
        added.out
    );
    let kept = fs::read_to_string(folder.path().join("output/bench-diagnosis/diagnosis.json")).unwrap();
    assert_eq!(
        serde_json::from_str::<serde_json::Value>(&kept).unwrap(),
        diagnosis
    );

    // GJ / (1 + s): the rod alone turns by 1 + s as far, at any torque
    let ladder = fs::read_to_string(folder.path().join("output/bench-ladder/ladder.json")).unwrap();
    let ladder: serde_json::Value = serde_json::from_str(&ladder).unwrap();
    let on_bench = |key: &str| ladder["on_bench"][key].as_f64().unwrap();
    let ratio = on_bench("with_effect_deg") / on_bench("without_deg");
    let softer = 1.0 + ladder["strength"][0].as_f64().unwrap();
    assert!((ratio - softer).abs() < 1e-4, "{ratio}, {softer}");
    for words in [
        "Strength: ",
        "goes from ",
        " where it was held out",
        "On a bench, the still wing rod",
        "washout solve output/bench-ladder/calibrated-rod.toml",
    ] {
        assert!(
            added.out.replace('\n', " ").contains(words),
            "{words}: {}",
            added.out
        );
    }

    let removed = run(&["add", "rod-shear-modulus", "--to", "study.toml", "--remove"]);
    assert_eq!(removed.code, Some(0), "{}", removed.err);
    let text = fs::read_to_string(folder.path().join("study.toml")).unwrap();
    assert!(!text.contains("rod-shear-modulus"), "{text}");
}

#[test]
fn an_effect_that_the_design_states_is_part_of_the_model_and_not_tried() {
    let folder = tempfile::tempdir().unwrap();
    bench(folder.path());
    let design = folder.path().join("rod.toml");
    let text = fs::read_to_string(&design).unwrap() + "[effects.rod-shear-modulus]\nstrength = 0.25\n";
    fs::write(&design, text).unwrap();
    let run = |arguments: &[&str]| washout(folder.path(), arguments);
    let tried = ["rod-shear-modulus", "root-flexure"]
        .map(|effect| ["--effect", effect])
        .concat();
    let found = json(&run(
        &[&["diagnose", "study.toml", "--json"], tried.as_slice()].concat()
    ));
    assert_eq!(found["verdict"], "nothing", "{found}");
    let notes = found["notes"].to_string();
    let wanted =
        "rod-shear-modulus is not tried: it stands in the design already ([effects.rod-shear-modulus])";
    assert!(notes.contains(wanted), "{notes}");
    // and one that stands in the study as well is refused, not written over
    let both = run(&["add", "rod-shear-modulus", "--to", "study.toml"]);
    assert_eq!(both.code, Some(2), "{}", both.out);
    let words = both.err.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(
        words.contains("stands in the study ([[effect]]) and in the design"),
        "{words}"
    );
}

#[test]
fn options_that_belong_to_a_design_and_unknown_effects_are_refused() {
    let folder = tempfile::tempdir().unwrap();
    bench(folder.path());
    let run = |arguments: &[&str]| washout(folder.path(), arguments);
    let said = run(&["compare", "study.toml", "--with", "m.csv"]);
    assert_eq!(said.code, Some(2));
    assert!(said.err.contains("--with: belongs to a design"), "{}", said.err);
    let said = run(&["add", "magic", "--to", "study.toml"]);
    assert_eq!(said.code, Some(2));
    assert!(said.err.contains("there is no effect magic"), "{}", said.err);
    let said = run(&["diagnose", "study.toml", "--effect", "magic"]);
    assert_eq!(said.code, Some(2));
    assert!(said.err.contains("there is no effect magic"), "{}", said.err);
}

#[test]
fn a_candidate_that_cannot_join_beside_one_that_can_is_said_to_be_left_out() {
    let folder = tempfile::tempdir().unwrap();
    bench(folder.path());
    let few = ["--effect", "rod-shear-modulus", "--effect", "large-rotation"];
    let arguments = [&["diagnose", "study.toml", "--json"][..], &few].concat();
    let said = washout(folder.path(), &arguments);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let why = "large-rotation is not tried: it cannot join the model: ";
    assert!(said.err.contains(why), "{}", said.err);
    let notes = said.document()["notes"].to_string();
    assert!(notes.contains(why), "{notes}");
}

#[test]
fn a_study_and_its_diagnosis_are_reported_with_every_wing_before_and_after() {
    let folder = tempfile::tempdir().unwrap();
    bench(folder.path());
    let run = |arguments: &[&str]| washout(folder.path(), arguments);
    let few = ["--effect", "rod-shear-modulus"];
    let said = run(&[&["diagnose", "study.toml", "--report", "--json"][..], &few].concat());
    assert_eq!(said.code, Some(0), "{}", said.err);
    let read = |name: &str| fs::read_to_string(folder.path().join(name)).unwrap();
    let page = read("output/bench-diagnosis/report.html");
    let embedded = |page: &str, id: &str| -> serde_json::Value {
        let rest = page.split(&format!("id=\"{id}\">")).nth(1).unwrap();
        serde_json::from_str(rest.split("</script>").next().unwrap()).unwrap()
    };
    assert_eq!(embedded(&page, "diagnosis"), said.document());
    let names = |page: &str| -> Vec<String> {
        let wings = embedded(page, "wing-data")["wings"].as_array().unwrap().clone();
        wings
            .iter()
            .map(|wing| wing["name"].as_str().unwrap().to_string())
            .collect()
    };
    assert_eq!(
        names(&page),
        [
            "m-1, with rod-shear-modulus",
            "m-2, with rod-shear-modulus",
            "m-3, with rod-shear-modulus",
            "m-1, uncalibrated",
            "m-2, uncalibrated",
            "m-3, uncalibrated",
        ]
    );
    assert!(page.contains("<details><summary>rod-shear-modulus against the residual</summary>"));
    let drawn = page.split("<figure>").nth(1).expect("an effect at work");
    assert!(
        drawn.contains("<strong>rod-shear-modulus</strong> ")
            && drawn.contains("It changes the elements of the rod from 0.00 to "),
        "{drawn}"
    );

    assert_eq!(run(&["compare", "study.toml", "--quiet"]).code, Some(0));
    let said = run(&["report", "output/bench-compare", "--quiet"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let of_folder = read("output/bench-compare/report.html");
    assert_eq!(run(&["report", "study.toml"]).code, Some(0));
    let of_study = read("output/bench-report.html");
    let rows = |page: &str| embedded(page, "comparison")["rows"].clone();
    assert_eq!(rows(&of_folder), rows(&of_study));
    // The ruler alone is uncertain, which turns no wing.
    assert_eq!(names(&of_study).len(), 6);
}

#[test]
fn rows_of_a_misspelt_condition_are_named_with_what_was_meant() {
    let here = tempfile::tempdir().unwrap();
    campaign(here.path(), &MANY);
    let hide = ["synthesize", "study.toml", "--seed", "3", "--output", "made"];
    json(&washout(here.path(), &[&hide[..], &["--json"]].concat()));
    let file = here.path().join("made/m.csv");
    let text = fs::read_to_string(&file).unwrap();
    fs::write(&file, text.replace("m-2,", "m_2,")).unwrap();
    let lines: Vec<usize> = (text.lines().enumerate())
        .filter(|(_, line)| line.starts_with("m-2,"))
        .map(|(index, _)| index + 1)
        .collect();
    let told = format!(
        "made/m.csv, lines {}–{}, m_2: no case of the study has this condition; did you mean m-{{moment}}?",
        lines[0],
        lines[lines.len() - 1]
    );
    let run = |verb: &str| washout(here.path(), &[verb, "made/study.toml"]);
    let page = run("compare");
    let plain = |text: &str| text.split_whitespace().collect::<Vec<_>>().join(" ");
    assert!(plain(&page.out).contains(&told), "{told}\n{}", page.out);
    let page = run("diagnose");
    assert!(plain(&page.out).contains(&told), "{told}\n{}", page.out);
    let document = |verb: &str| json(&washout(here.path(), &[verb, "made/study.toml", "--json"]));
    assert_eq!(document("compare")["not_compared"], serde_json::json!([told]));
    let notes = document("diagnose")["notes"].clone();
    assert!(notes.to_string().contains(&told), "{notes}");
}

/// The load of one case is a twentieth of what its readings were taken under: a slip of its unit.
#[test]
fn the_one_case_that_misses_by_far_more_than_all_others_is_asked_for_first() {
    let here = tempfile::tempdir().unwrap();
    campaign(here.path(), &MANY);
    let hide = ["synthesize", "study.toml", "--seed", "3", "--output", "made"];
    json(&washout(here.path(), &[&hide[..], &["--json"]].concat()));
    let ask = || washout(here.path(), &["diagnose", "made/study.toml"]).out;
    assert!(!ask().starts_with("Check"), "{}", ask());
    let file = here.path().join("made/m.csv");
    let text = fs::read_to_string(&file).unwrap();
    let slipped = text.lines().map(|line| {
        let mut cells: Vec<String> = line.split(',').map(str::to_string).collect();
        if cells[0] == "m-1" {
            cells[8] = (20.0 * cells[8].parse::<f64>().unwrap()).to_string();
        }
        cells.join(",") + "\n"
    });
    fs::write(&file, slipped.collect::<String>()).unwrap();
    let said = ask();
    assert!(
        said.starts_with("Check the case m-1 first: it misses by "),
        "{said}"
    );
    assert!(!said.contains("washout add"), "nothing is built on it: {said}");
    let document = json(&washout(here.path(), &["diagnose", "made/study.toml", "--json"]));
    assert_eq!(document["check_first"], "m-1");
}
