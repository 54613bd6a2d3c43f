//! Studies that are shipped: derivatives against differences, and what comes out, as it comes out.

use std::path::Path;

use washout::compare::StudyComparison;
use washout::compare::study::compare_study;
use washout::export::json;
use washout::export::study::page;
use washout::input::measurement::Channel;
use washout::input::study::LoadedStudy;
use washout::progress::Progress;
use washout::study::{Campaign, Forward, Unknown, UnknownKind};

fn load(name: &str) -> LoadedStudy {
    let path = Path::new(env!("CARGO_MANIFEST_DIR"))
        .join("studies")
        .join(format!("{name}.toml"));
    LoadedStudy::load(&path, &[]).unwrap_or_else(|error| panic!("{error}"))
}

fn compared(name: &str) -> StudyComparison {
    let study = load(name);
    let campaign = Campaign::new(&study, &[], &Progress::quiet()).unwrap();
    compare_study(&campaign, &study.study.title).unwrap()
}

/// Root mean square errors (as stated, calibrated) of a channel of a wing, fitted or held out.
fn rmse(comparison: &StudyComparison, wing: &str, channel: Channel, is_held_out: bool) -> [f64; 2] {
    let mut groups = comparison.groups.iter();
    let found = groups.find(|g| g.wing == wing && g.channel == channel && g.is_held_out == is_held_out);
    found.unwrap_or_else(|| panic!("no {wing}")).rmse
}

fn every_number_of_its_page_stands_in_its_document(comparison: &StudyComparison) {
    let page = page(comparison);
    let mut document = json::tree(comparison).unwrap();
    assert_eq!(page.astray(&document), Vec::<String>::new());
    document["rows"][0]["measured"] = 0.123.into();
    document["chi_square_per_row"][1] = 0.123.into();
    // the first stands on the page and on a screen
    let astray = page.astray(&document);
    let of_all = "/chi_square_per_row/1";
    assert_eq!(astray, [of_all, of_all, "/rows/0/measured"]);
    let text = page.text();
    let [words, rows] =
        ["Model against measurement\n", "Every measured number\n"].map(|part| text.find(part));
    assert!(words.is_some() && words < rows, "the words stand first:\n{text}");
}

fn near(found: f64, expected: f64) {
    assert!((found / expected - 1.0).abs() < 0.02, "{found}, was {expected}");
}

#[test]
fn every_study_that_is_shipped_loads() {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("studies");
    let mut count = 0;
    for entry in std::fs::read_dir(folder).unwrap() {
        let path = entry.unwrap().path();
        // a campaign may still be a plan
        LoadedStudy::load_planned(&path, &[]).unwrap_or_else(|error| panic!("{error}"));
        count += 1;
    }
    assert!(count >= 6, "{count}");
}

#[test]
fn derivatives_of_a_study_are_those_of_cases_solved_again() {
    let mut study = load("tang-dowell-wind");
    study.cases.retain(|case| case.name.starts_with("aero-2.2-3"));
    let campaign = Campaign::new(&study, &["centre-of-pressure-shift"], &Progress::quiet()).unwrap();
    let at = campaign.start();
    let linear = campaign.linearize(&at, &|_| true).unwrap();
    let unnamed = |unknown: &&Unknown| matches!(unknown.kind, UnknownKind::Unnamed { .. });
    let unnamed = campaign.unknowns().iter().filter(unnamed);
    assert_eq!((campaign.unknowns().len(), unnamed.count()), (12, 6));
    for (k, unknown) in campaign.unknowns().iter().enumerate() {
        let step = 1e-2 * unknown.sigma;
        let moved = |share: f64| {
            let mut at = at.clone();
            at[k] += share * step;
            campaign.predict(&at).unwrap()
        };
        let slope = (moved(1.0) - moved(-1.0)) / (2.0 * step);
        // a wing whose air law knows no drag has no derivative by it, on either way
        let scale = slope.amax().max(f64::MIN_POSITIVE);
        let error = (&slope - linear.jacobian.column(k)).amax() / scale;
        println!("{}: {error:.1e}", unknown.name);
        assert!(error < 1e-4, "{}: {error}", unknown.name);
    }
}

#[test]
fn a_study_that_a_case_refuses_says_and_counts_the_same_on_any_number_of_threads() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/foreign/c005.toml");
    let study = LoadedStudy::load(&path, &["mesh.refine=0.3".to_string()]).unwrap();
    let refused = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new().num_threads(threads);
        pool.build().unwrap().install(|| {
            let campaign = Campaign::new(&study, &["rotational-damping"], &Progress::quiet()).unwrap();
            let mut at = campaign.start();
            let (_, left) = campaign.linearize_from(None, &at, &|_| false).unwrap();
            let is_strength = |unknown: &Unknown| unknown.name == "effects.rotational-damping.strength";
            at[campaign.unknowns().iter().position(is_strength).unwrap()] = 1.5;
            let left = left.map(|left| left.roughly());
            let before = campaign.work();
            let refusal = campaign
                .linearize_from(left.as_ref(), &at, &|_| false)
                .unwrap_err();
            (refusal.to_string(), campaign.work() - before)
        })
    };
    let alone = refused(1);
    println!("{alone:?}");
    for threads in [2, 3, 4] {
        assert_eq!(refused(threads), alone, "{threads} threads");
    }
}

/// The wing sags and twists as its stated stiffness and mass say: at 45 deg, held out, by −40.4 mm and 0.136 deg.
#[test]
fn tang_and_dowells_wing_under_its_own_weight_agrees_within_the_uncertainty_but_for_a_little_twist() {
    let comparison = compared("tang-dowell-gravity");
    for group in &comparison.groups {
        assert!(group.explained.is_some_and(|share| share > 0.4), "{group:?}");
    }
    every_number_of_its_page_stands_in_its_document(&comparison);
    let [stated, calibrated] = rmse(&comparison, "tang-dowell", Channel::Twist, true);
    near(stated, 0.0178);
    near(calibrated, 0.0160);
    let [stated, _] = rmse(&comparison, "tang-dowell", Channel::Deflection, true);
    near(stated, 0.373);
}

#[test]
fn a_moment_along_the_span_twists_the_wing_as_its_torsional_stiffness_says() {
    let study = load("tang-dowell-gravity");
    let campaign = Campaign::new(&study, &[], &Progress::quiet()).unwrap();
    let stations = 9;
    let response = campaign.moment_response(&campaign.start(), stations).unwrap();
    let row = campaign
        .observables()
        .iter()
        .position(|o| o.channel == Channel::Twist && campaign.conditions()[o.condition].name == "gravity-90")
        .unwrap();
    // a uniform moment per length m twists the tip by m L²/(2 GJ)
    let total: f64 = (0..stations).map(|k| response[(row, k)]).sum();
    let expected = (0.4508_f64.powi(2) / (2.0 * 0.9539)).to_degrees();
    assert!((total / expected - 1.0).abs() < 0.01, "{total} {expected}");
}

/// Fitted at 5 deg the wing with skin is met within a few mm; predicted at 7 deg it falls short by 7 mm on the mean, and by
/// 2 to 4 σ at three of the speeds: the two angles disagree in a model that is linear in them.
#[test]
fn the_skinned_pre_pazy_wing_in_the_wind_is_met_at_5_deg_and_less_well_at_7_deg() {
    let comparison = compared("pre-pazy-wind");
    let [stated, calibrated] = rmse(&comparison, "pre-pazy-skin", Channel::Deflection, false);
    near(stated, 15.05);
    near(calibrated, 2.132);
    let [stated, predicted] = rmse(&comparison, "pre-pazy-skin", Channel::Deflection, true);
    near(stated, 10.79);
    near(predicted, 9.564);
}

/// With the skin of the bench, which gives way, no number of it from the wind: predicted at 7 deg within the readings' own σ of 4.8 mm.
#[test]
fn the_skin_that_gives_way_on_the_bench_predicts_the_wing_in_the_wind() {
    let comparison = compared("pre-pazy-wind-yielding");
    let [stated, calibrated] = rmse(&comparison, "pre-pazy", Channel::Deflection, false);
    near(stated, 21.52);
    near(calibrated, 4.541);
    let [stated, predicted] = rmse(&comparison, "pre-pazy", Channel::Deflection, true);
    near(stated, 20.55);
    near(predicted, 4.501);
}

/// With the lifting line of the wing on its wall besides, as stated and without any number from the wind: within 4.8 mm at 7 deg, σ of the readings.
#[test]
fn the_lifting_line_predicts_the_wing_in_the_wind_without_a_number_from_the_wind() {
    let comparison = compared("pre-pazy-wind-lifting-line");
    let [stated, calibrated] = rmse(&comparison, "pre-pazy", Channel::Deflection, false);
    near(stated, 7.762);
    near(calibrated, 4.607);
    let [stated, predicted] = rmse(&comparison, "pre-pazy", Channel::Deflection, true);
    near(stated, 4.791);
    near(predicted, 3.833);
}
