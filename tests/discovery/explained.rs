//! Few numbers with a hidden pair: which sets of changes `explain` tells first.

use std::path::Path;
use std::sync::OnceLock;

use nalgebra::DVector;
use washout::explain::report::{ChangeMade, ExplainedSet, Status};
use washout::explain::{Answers, Choice, Explanation, Model, Prepared, Settings, choices, explain};
use washout::input::measurement::Measurement;
use washout::input::study::LoadedStudy;
use washout::progress::Progress;
use washout::study::draws::Draws;
use washout::study::{Forward, Unknown, UnknownKind};

/// Five numbers of two wings that share their rods and their stroke.
const READINGS: &str = "\
case,channel,instrument,unit,sign,run,r_mm,r_to_mm,chord_fraction,value,sigma,sigma_kind,bound
one,twist,camera,deg,washout,,35,,,0,0.2,stated,none
one,twist,camera,deg,washout,,67.2,,,0,0.2,stated,none
one,deflection,,mm,,,67.2,,0,0,0.03,stated,none
two,twist,camera,deg,washout,,67.2,,,0,0.2,stated,none
one,lift,,mN,,,,,,0,0.15,stated,none
";

/// What may be hidden: effects, and besides these what designs assume and one word that may be another.
const EFFECTS: [&str; 8] = [
    "root-flexure",
    "rod-torsion-loss",
    "rod-bending-loss",
    "coefficient-scale",
    "tip-loss-prandtl",
    "camera-tilt",
    "spar-stiffness",
    "centre-of-pressure-shift",
];

fn study() -> LoadedStudy {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("studies/two-wings.toml");
    let case = |design: &str, name: &str| {
        format!(
            "[[case]]\ndesign = '../designs/{design}.toml'\nset = ['mesh.refine=0.5']\nmeasurement = 'five.csv'\nmeasured = '{name}'\n"
        )
    };
    let text = format!(
        "format = 1\nname = 'two-wings'\n{}{}",
        case("twist-v1", "one"),
        case("twist-v2", "two")
    );
    let readings = Measurement::from_csv(READINGS, "five.csv").expect("readings");
    LoadedStudy::with_readings(&path, &text, &[], &readings).expect("a study")
}

/// The study in each choice of its words; they need not be read from its file again.
fn prepared() -> &'static [(Choice, Model, Answers)] {
    static ALL: OnceLock<Vec<(Choice, Model, Answers)>> = OnceLock::new();
    ALL.get_or_init(|| {
        let quiet = Progress::quiet();
        let choice = Choice {
            flipped: Vec::new(),
            study: study(),
        };
        let model = Model::new(&choice.study, &EFFECTS, &quiet).expect("a model");
        let answers = Answers::new(&model, &quiet).expect("answers");
        vec![(choice, model, answers)]
    })
}

/// A hidden change: the unknown, and its value.
struct Hidden {
    unknown: usize,
    value: f64,
}

/// Two different things of those that the readings can see, each at 0.4 to 1 of the way to an end of what is plausible.
fn hidden_pair(model: &Model, draws: &Draws) -> Vec<Hidden> {
    let start = model.start();
    let stated = model.predict(&start).expect("as it stands");
    let mut found: Vec<Hidden> = Vec::new();
    for index in 0..1000 {
        let unknowns = model.unknowns();
        let unknown = ((unknowns.len() as f64) * draws.uniform(1, index)) as usize;
        let own = &unknowns[unknown];
        if !is_change(own)
            || is_on_one_wing(unknowns, own)
            || found
                .iter()
                .any(|other| names_alike(&unknowns[other.unknown], own))
        {
            continue;
        }
        let end = own.range[usize::from(draws.uniform(2, index) < 0.5)];
        let share = 0.4 + 0.6 * draws.uniform(3, index);
        let value = start[unknown] + share * (end - start[unknown]);
        let mut there = start.clone();
        there[unknown] = value;
        let Ok(moved) = model.predict(&there) else {
            continue;
        };
        // what cannot be seen is not hidden there
        let seen = (moved - &stated).component_div(&sigmas(model)).norm();
        if value != start[unknown] && seen > 10.0 {
            found.push(Hidden { unknown, value });
        }
        if found.len() == 2 {
            return found;
        }
    }
    panic!("no pair that can be seen");
}

fn is_change(unknown: &Unknown) -> bool {
    matches!(unknown.kind, UnknownKind::Input | UnknownKind::Effect { .. })
}

fn is_on_one_wing(unknowns: &[Unknown], own: &Unknown) -> bool {
    unknowns
        .iter()
        .any(|other| matches!(&other.kind, UnknownKind::Place { of, wing: Some(_), .. } if *of == own.name))
}

fn names_alike(a: &Unknown, b: &Unknown) -> bool {
    match (&a.kind, &b.kind) {
        (UnknownKind::Effect { family: a, .. }, UnknownKind::Effect { family: b, .. }) => a == b,
        _ => a.name == b.name,
    }
}

fn sigmas(model: &Model) -> DVector<f64> {
    let observables = model.observables();
    DVector::from_iterator(observables.len(), observables.iter().map(|own| own.sigma))
}

/// The explanation of readings with these changes and their scatter.
fn explained(hidden: &[Hidden], draws: &Draws, settings: &Settings) -> Option<Explanation> {
    let (choice, model, answers) = &prepared()[0];
    let mut at = model.start();
    for own in hidden {
        at[own.unknown] = own.value;
    }
    let truth = model.predict(&at).ok()?;
    let noise = DVector::from_fn(truth.len(), |row, _| draws.normal(4, row as u64));
    let model = model.with_values(&(truth + noise.component_mul(&sigmas(model))));
    let prepared = [Prepared {
        choice: choice.clone(),
        model,
        answers: answers.clone(),
    }];
    Some(explain(&prepared, &EFFECTS, settings, &Progress::quiet()).expect("an explanation"))
}

fn settings() -> Settings {
    Settings {
        most_changes: 3,
        solved: 60,
        fitted: 20,
        grown: 20,
        predicts: false,
        ..Settings::default()
    }
}

/// Whether a set is of just these changes, effects by their families.
fn is_of(set: &ExplainedSet, hidden: &[Hidden], unknowns: &[Unknown]) -> bool {
    let is_it = |made: &ChangeMade, own: &Hidden| match &unknowns[own.unknown].kind {
        UnknownKind::Effect { family, .. } => {
            let card = washout::effects::named(&made.name).map(|effect| effect.card().family == family);
            made.is_effect && card == Some(true)
        }
        _ => made.unknown == unknowns[own.unknown].name,
    };
    set.changes.len() == hidden.len()
        && set.otherwise.is_empty()
        && hidden
            .iter()
            .all(|own| set.changes.iter().any(|made| is_it(made, own)))
}

/// In how many of some draws the truth is among the first three sets. Where one change alone reaches all readings, nobody can say that
/// there are two: that is printed.
fn hits(seeds: std::ops::Range<u64>) -> usize {
    let model = &prepared()[0].1;
    let mut hits = 0;
    for seed in seeds {
        let draws = Draws::new(seed);
        let hidden = hidden_pair(model, &draws);
        let Some(found) = explained(&hidden, &draws, &settings()) else {
            println!("{seed}: no equilibrium with both");
            continue;
        };
        let rank = found
            .sets
            .iter()
            .position(|set| is_of(set, &hidden, model.unknowns()));
        let names: Vec<String> = hidden
            .iter()
            .map(|own| format!("{} = {:.3}", model.unknowns()[own.unknown].name, own.value))
            .collect();
        println!("{seed}: {} is at {rank:?}", names.join(" + "));
        for set in found.sets.iter().take(4) {
            println!(
                "      {:?} {:.1} {:.1}σ {}",
                set.status, set.cost, set.worst_sigma, set.name
            );
        }
        let is_one = |set: &ExplainedSet| set.status == Status::Reaches && set.changes.len() < 2;
        if found.sets.iter().any(is_one) {
            println!("      one change is enough");
        }
        hits += usize::from(rank.is_some_and(|rank| rank < 3));
    }
    hits
}

/// In how many of some draws with nothing hidden the empty set comes first.
fn quiet(seeds: std::ops::Range<u64>) -> usize {
    let is_quiet = |seed: u64| {
        let found = explained(&[], &Draws::new(seed), &settings()).expect("as it stands");
        println!("{seed}: {}", found.sets[0].name);
        found.sets[0].name == "nothing"
    };
    seeds.filter(|seed| is_quiet(*seed)).count()
}

#[test]
fn a_hidden_pair_is_among_the_first_three_sets_and_nothing_is_told_of_nothing() {
    assert_eq!(hits(100..101), 1);
    assert_eq!(quiet(200..201), 1);
}

#[test]
#[ignore = "an hour: 20 draws with a hidden pair; the aim is 15"]
fn of_twenty_hidden_pairs_fifteen_are_among_the_first_three_sets() {
    let pairs = hits(100..120);
    println!("{pairs} of 20");
    assert!(pairs >= 15, "{pairs}");
}

#[test]
#[ignore = "an hour: 20 draws with nothing hidden"]
fn of_twenty_draws_with_nothing_hidden_eighteen_have_the_empty_set_first() {
    let nothing = quiet(200..220);
    println!("{nothing} of 20");
    assert!(nothing >= 18, "{nothing}");
}

#[test]
fn sets_are_the_same_for_any_number_of_threads() {
    let draws = Draws::new(100);
    let hidden = hidden_pair(&prepared()[0].1, &draws);
    let on = |threads: usize| {
        let pool = rayon::ThreadPoolBuilder::new()
            .num_threads(threads)
            .build()
            .unwrap();
        let few = Settings {
            most_changes: 2,
            solved: 12,
            fitted: 4,
            ..settings()
        };
        pool.install(|| explained(&hidden, &draws, &few).unwrap())
    };
    assert_eq!(on(1), on(3));
}

#[test]
fn other_words_of_a_design_are_choices_of_the_study() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("studies/paper-v1.toml");
    let study = LoadedStudy::load(&path, &[]).expect("a study");
    let names: Vec<String> = choices(&study, &[])
        .expect("choices")
        .into_iter()
        .filter(|own| own.flipped.len() == 1)
        .map(|own| own.flipped[0].name.clone())
        .collect();
    assert_eq!(
        names,
        [
            "root.chord = clamped",
            "observation.camera_axis = flapping-axis",
            "rod[0].section.flat = across"
        ]
    );
}
