//! What a diagnosis says of other people's measurements: the figures of docs/real-data.md, pleasing or not.

use std::path::Path;

use serde_json::Value;

use crate::washout;

fn diagnosed(study: &str, effects: &[&str]) -> Value {
    let folder = tempfile::tempdir().unwrap();
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("studies").join(study);
    let mut arguments = vec![
        "diagnose".to_string(),
        path.display().to_string(),
        "--json".to_string(),
    ];
    for effect in effects {
        arguments.extend(["--effect".to_string(), effect.to_string()]);
    }
    let arguments: Vec<&str> = arguments.iter().map(String::as_str).collect();
    let said = washout(folder.path(), &arguments);
    assert_eq!(said.code, Some(0), "{}", said.err);
    serde_json::from_str(&said.out).unwrap()
}

fn number(value: &Value) -> f64 {
    value.as_f64().unwrap_or_else(|| panic!("no number: {value}"))
}

fn hypothesis<'a>(said: &'a Value, effects: &[&str]) -> &'a Value {
    let all = said["hypotheses"].as_array().unwrap().iter();
    let mut found = all.filter(|h| h["effects"] == serde_json::json!(effects));
    found
        .next()
        .unwrap_or_else(|| panic!("{effects:?}: {}", said["hypotheses"]))
}

fn rows(said: &Value) -> &Vec<Value> {
    said["effects"].as_array().unwrap()
}

/// Root mean square held-out error of the deflections: calibrated, and with the best known explanation, mm.
fn held_out_deflections(said: &Value) -> [f64; 2] {
    held_out(said, "deflection")
}

/// That of a channel, in its unit.
fn held_out(said: &Value, channel: &str) -> [f64; 2] {
    let of = |which: &str| {
        let (mut sum, mut count) = (0.0, 0.0);
        for row in said["predictions"].as_array().unwrap() {
            if row["channel"] == channel {
                sum += (number(&row["measured"]) - number(&row[which])).powi(2);
                count += 1.0;
            }
        }
        f64::sqrt(sum / count)
    };
    [of("calibrated"), of("explained")]
}

/// With the two skins that only add stiffness, that which adds it in bending is named: 1.22 ± 0.03. The slopes of the readings
/// differ by 1.09 to 1.24 and the beams of the literature by 1.12 in bending; in torsion by 0.85 to 1.20 and by 1.10.
#[test]
fn the_skin_of_the_pre_pazy_wing_adds_bending_stiffness_and_its_torsion_is_undecided() {
    let said = diagnosed("pre-pazy-skin.toml", &["skin-bending", "skin-torsion"]);
    println!("{}", said["sentence"]);
    assert_eq!(said["verdict"], "effect", "{}", said["sentence"]);
    let bending = hypothesis(&said, &["skin-bending"]);
    let (strength, error) = (number(&bending["strength"]), number(&bending["standard_error"]));
    assert!(number(&bending["probability"]) > 0.95);
    assert!(
        (strength - 0.216).abs() < 0.01 && (0.02..0.05).contains(&error),
        "{strength} ± {error}"
    );
    assert!(strength - 2.0 * error < 0.16 && strength + error < 0.26);
    let torsion = rows(&said)
        .iter()
        .find(|row| row["effect"] == "skin-torsion")
        .unwrap();
    assert_eq!(torsion["sight"], "undecidable");
    // stiffness alone does not hold at the larger loads that were held out: 13 mm wrong, 5 calibrated, and it says so
    let [calibrated, explained] = held_out_deflections(&said);
    println!("held out {calibrated} mm, {explained} mm");
    assert!(
        said["notes"].to_string().contains("is met worse"),
        "{}",
        said["notes"]
    );
}

/// With every effect tried it is a skin that gives way. Held-out deflections are wrong by 3.5 mm with it and by 4.3 without, where the scatter
/// is 1.7: with an error of formulation of 1 to 2 % in the fit the pull on the rod's stiffness (4 sigma) takes up some of what the skin does
/// there. With scatter alone in the fit they had fallen from 6.0 to 2.3 mm.
#[test]
#[ignore = "every effect: a minute of one core; among the effects of skins the test below"]
fn with_every_effect_tried_the_skin_of_the_pre_pazy_wing_gives_way() {
    let said = diagnosed("pre-pazy-skin.toml", &[]);
    println!("{}", said["sentence"]);
    assert_eq!(said["verdict"], "effect", "{}", said["sentence"]);
    let found = hypothesis(&said, &["skin-yielding"]);
    let (strength, error) = (number(&found["strength"]), number(&found["standard_error"]));
    assert!(
        (strength - 0.222).abs() < 0.01 && (0.02..0.04).contains(&error),
        "{strength} ± {error}"
    );
    let place = &found["strengths"][0]["place"];
    assert!(
        (number(&place["value"]) - 0.74).abs() < 0.05 && place["unit"] == "rad",
        "{place}"
    );
    let [calibrated, explained] = held_out_deflections(&said);
    println!("held out {calibrated} mm, {explained} mm");
    assert!(
        explained < 0.9 * calibrated && explained < 2.5 * 1.7,
        "{calibrated} {explained}"
    );
}

/// The wing without skin tells nothing else of it, and misses some twists itself, which no effect on the other wing explains.
#[test]
fn what_the_skinned_wing_has_and_the_bare_one_has_not_is_a_skin_that_gives_way() {
    let said = diagnosed(
        "pre-pazy-both.toml",
        &["skin-bending", "skin-torsion", "skin-yielding"],
    );
    let rows = rows(&said);
    let row = |name: &str| rows.iter().find(|row| row["effect"] == name).unwrap();
    let found = row("skin-yielding");
    assert!((number(&found["refitted"]) - 0.204).abs() < 0.01, "{found}");
    // 4.7: odds of a hundred, with the formulas of both known to 14 % at worst
    assert!(number(&found["ln_evidence"]) > 4.5 + number(&row("skin-bending")["ln_evidence"]));
    let [calibrated, explained] = held_out_deflections(&said);
    assert!(explained < 0.5 * calibrated, "{calibrated} {explained}");
    let notes = said["notes"].to_string();
    assert!(notes.contains("tried on pre-pazy-skinned alone"), "{notes}");
}

/// Written after Wing 1 and found on Wing 2: the skin gives way, by about as much and at about the same bend (0.22 ± 0.03 until 0.70 ± 0.15 rad).
#[test]
fn the_skin_of_the_pazy_wing_gives_way_as_that_of_the_pre_pazy_wing_does() {
    let said = diagnosed("pazy-skin-bare.toml", &["skin-yielding", "skin-bending"]);
    println!("{}", said["sentence"]);
    let all = said["hypotheses"].as_array().unwrap().iter();
    let with_it = all.filter(|own| own["effects"].to_string().contains("skin-yielding"));
    let probability: f64 = with_it.map(|own| number(&own["probability"])).sum();
    assert!(probability > 0.8, "{probability}");
    let [calibrated, explained] = held_out_deflections(&said);
    println!("held out {calibrated} mm, {explained} mm");
    assert!(explained < 0.8 * calibrated, "{calibrated} {explained}");
}

/// Written after robot a and found on robot c, whose hinges are others: they stiffen from some 35 deg on.
#[test]
fn the_hinges_of_a_flapping_robot_stiffen_as_they_turn() {
    let said = diagnosed(
        "robobee-c.toml",
        &["root-stiffening", "centre-of-pressure-shift", "stop-backlash"],
    );
    println!("{}", said["sentence"]);
    let all = said["hypotheses"].as_array().unwrap().iter();
    let with_it = all.filter(|own| own["effects"].to_string().contains("root-stiffening"));
    let probability: f64 = with_it.map(|own| number(&own["probability"])).sum();
    assert!(probability > 0.8, "{probability}");
    let [calibrated, explained] = held_out(&said, "twist");
    println!("held out {calibrated} deg, {explained} deg");
    assert!(explained < 0.5 * calibrated, "{calibrated} {explained}");
}

/// One reading shows large rotation, and might be a slip; but it lies where an effect says that has nothing to be fitted.
#[test]
fn tang_and_dowell_without_large_rotation_lack_it_though_one_reading_shows_it() {
    for effects in [&[][..], &["large-rotation", "tip-mass"]] {
        let said = diagnosed("tang-dowell-linear.toml", effects);
        println!("{}", said["sentence"]);
        assert_eq!(said["verdict"], "effect", "{}", said["sentence"]);
        let found = hypothesis(&said, &["large-rotation"]);
        assert_eq!(found["strengths"][0]["at_end"], false, "all of it is no end");
        assert!(
            number(&found["strength"]) == 1.0 && number(&found["standard_error"]) == 0.0,
            "{found}"
        );
        let all = said["hypotheses"].as_array().unwrap().iter();
        let with_it = all.filter(|own| own["effects"].to_string().contains("\"large-rotation\""));
        let probability: f64 = with_it.map(|own| number(&own["probability"])).sum();
        assert!(probability > 0.99, "{probability}");
        let groups = said["misfit"]["by_condition"].as_array().unwrap().iter();
        let worst = groups
            .max_by(|a, b| number(&a["share"]).total_cmp(&number(&b["share"])))
            .unwrap();
        assert!(
            worst["condition"] == "gravity-45" && worst["channel"] == "twist",
            "{worst}"
        );
        assert!(number(&worst["share"]) > 0.7, "{worst}");
    }
}

/// Without the effect that has nothing to be fitted the reading may be a slip, and nothing is named.
#[test]
#[ignore = "three effects on 45 cases: three quarters of a minute"]
fn one_reading_far_off_names_no_effect_whose_strength_is_fitted_to_it() {
    let said = diagnosed(
        "tang-dowell-linear.toml",
        &["tip-mass", "bend-twist-coupling", "stop-backlash"],
    );
    println!("{}", said["sentence"]);
    assert!(said["verdict"] != "effect", "{}", said["sentence"]);
}

/// The same reading anywhere but where large rotation says (0.13°): a slip, as far as these data go.
#[test]
#[ignore = "three diagnoses of 45 cases: a minute and a half"]
fn the_one_reading_elsewhere_names_nothing() {
    for value in ["-0.12", "0.05", "0.30"] {
        elsewhere(value);
    }
}

fn elsewhere(value: &str) {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    let folder = tempfile::tempdir().unwrap();
    let text = |path: &str| std::fs::read_to_string(root.join(path)).unwrap();
    let shipped = format!("\"{}/", root.display());
    let study = text("studies/tang-dowell-linear.toml")
        .replace("\"../measurements/tang-dowell.csv\"", "\"moved.csv\"");
    std::fs::write(folder.path().join("s.toml"), study.replace("\"../", &shipped)).unwrap();
    let moved = text("measurements/tang-dowell.csv").replace("0.12005", value);
    std::fs::write(folder.path().join("moved.csv"), moved).unwrap();
    let effects = ["--effect", "large-rotation", "--effect", "tip-mass"];
    let said = washout(
        folder.path(),
        &[&["diagnose", "s.toml", "--json"], &effects[..]].concat(),
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    let said: Value = serde_json::from_str(&said.out).unwrap();
    println!("{value}: {}", said["sentence"]);
    assert!(said["verdict"] != "effect", "{value}: {}", said["sentence"]);
}
