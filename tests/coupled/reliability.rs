//! How many plausible wings have an answer, and what it takes.
//!
//! `cargo test --release --test coupled share_of_random -- --ignored --nocapture` prints each; `WASHOUT_RANDOM=FROM..TO` takes other seeds,
//! `WASHOUT_REFINE=1` the default mesh.

use std::env::var;
use std::sync::mpsc;
use std::time::{Duration, Instant};

use washout::coupling::{self, CouplingError, solution::Solution};
use washout::input::design::Accelerator;
use washout::input::{Design, Loaded};
use washout::progress::Progress;
use washout::wing::{SolvedWing, WingModel};

use crate::random_wing::random_wing;
use crate::support::Wing;

/// After which a solve is stopped, s.
const LIMIT_S: u64 = 20;

/// The wing of a seed solved, stopped after [`LIMIT_S`].
fn solved(seed: u64, refine: f64) -> Result<Solution, CouplingError> {
    let design = Design::from_toml(&random_wing(seed, refine), "random.toml").expect("a plausible design");
    let wing = Wing::of(design);
    let progress = Progress::quiet();
    std::thread::scope(|scope| {
        let (done, wait) = mpsc::channel::<()>();
        scope.spawn(|| {
            if wait.recv_timeout(Duration::from_secs(LIMIT_S)) == Err(mpsc::RecvTimeoutError::Timeout) {
                progress.cancel();
            }
            drop(wait);
        });
        let found = coupling::solve(&wing.design, &wing.mesh, None, &progress);
        drop(done);
        found
    })
}

/// Solves the wings of some seeds; prints each and gives how many have no answer.
fn failures(seeds: std::ops::Range<u64>, refine: f64) -> usize {
    let count = seeds.end - seeds.start;
    let mut steps = Vec::new();
    let start = Instant::now();
    for seed in seeds {
        let begun = Instant::now();
        let found = solved(seed, refine);
        let seconds = begun.elapsed().as_secs_f64();
        match found {
            Ok(solution) => {
                println!(
                    "{seed:4}: {seconds:5.2} s, {:4} steps",
                    solution.report.newton_steps
                );
                steps.push(solution.report.newton_steps);
            }
            Err(error) => {
                let told = error.to_string();
                println!(
                    "{seed:4}: {seconds:5.2} s, none: {}",
                    &told[..told.len().min(150)]
                );
            }
        }
    }
    steps.sort_unstable();
    println!(
        "{} of {count} solved, median {:?} steps, {:.1} s in all",
        steps.len(),
        steps.get(steps.len() / 2),
        start.elapsed().as_secs_f64()
    );
    count as usize - steps.len()
}

/// Neither Newton's method nor the fixed point settles on these; the fixed point is tried last.
#[test]
fn loose_wings_on_which_newtons_method_does_not_settle_come_to_rest_in_pseudo_time() {
    for seed in [4, 14] {
        assert_eq!(failures(seed..seed + 1, 0.3), 0, "seed {seed}");
    }
}

/// Let go of step by step, its tight film meets no equilibrium on the way.
#[test]
fn a_tight_film_that_cannot_be_let_go_of_step_by_step_is_let_go_of_at_once() {
    assert_eq!(failures(23..24, 0.3), 0);
}

/// Its fixed point takes 3,000 steps.
#[test]
fn a_wing_that_only_the_fixed_point_settles_is_given_the_steps_it_takes() {
    assert_eq!(failures(279..280, 0.3), 0);
}

/// What is said of a wing that has no answer is what the load would do to it.
#[test]
fn a_wing_without_an_answer_says_what_is_too_weak_for_the_load() {
    let told = |seed| solved(seed, 0.3).unwrap_err();
    let rods = told(29);
    assert!(
        matches!(rods, CouplingError::Overloaded(overload) if overload.is_rod),
        "{rods}"
    );
    let film = told(59);
    assert!(
        matches!(film, CouplingError::Overloaded(overload) if !overload.is_rod),
        "{film}"
    );
    assert!(
        film.is_not_converged() && film.to_string().contains("flies as a flag"),
        "{film}"
    );
    // Newton's method finds the flat film, which does not stay: that is known without a search for others
    assert!(matches!(told(5), CouplingError::Diverged { .. }));
}

#[test]
#[ignore = "minutes"]
fn share_of_random_wings_that_have_an_answer() {
    let seeds = var("WASHOUT_RANDOM").unwrap_or_default();
    let seeds = (seeds.split_once("..")).and_then(|(from, to)| Some(from.parse().ok()?..to.parse().ok()?));
    let seeds = seeds.unwrap_or(0..100);
    let refine = var("WASHOUT_REFINE").map_or(0.3, |refine| refine.parse().expect("a number"));
    let failures = failures(seeds.clone(), refine);
    // 95 of the first 100 have one, 283 of the first 300
    assert!(failures as u64 * 8 <= seeds.end - seeds.start);
}

/// The wing of a seed with some options, solved; none where it has no answer.
fn solved_with(seed: u64, refine: f64, change: &dyn Fn(&mut Design)) -> Option<SolvedWing> {
    let mut design =
        Design::from_toml(&random_wing(seed, refine), "random.toml").expect("a plausible design");
    change(&mut design);
    let model = WingModel::new(Loaded::alone(design)).expect("a wing");
    model.solve(&Progress::quiet()).ok()
}

/// A change of a design, with its name.
type Change = (&'static str, fn(&mut Design));

/// Changes of the solver that should move nothing.
const OPTIONS: [Change; 4] = [
    ("aitken", |design| {
        design.coupling.accelerator = Accelerator::Aitken
    }),
    ("10 increments", |design| design.structure.load_increments = 10),
    ("drilling / 10", |design| design.structure.drilling_factor = 0.1),
    ("drilling x 10", |design| design.structure.drilling_factor = 10.0),
];

/// How many wings rest in another shape with other options of the solver; each of them says so, and none that does not.
fn moved(seeds: std::ops::Range<u64>, refine: f64) -> usize {
    let quiet = Progress::quiet();
    let twists = |wing: &SolvedWing| {
        let readings = wing.profile().expect("a profile").readings;
        readings
            .iter()
            .map(|reading| reading.twist_rad.to_degrees())
            .collect::<Vec<f64>>()
    };
    let mut count = 0;
    for seed in seeds {
        let Some(usual) = solved_with(seed, refine, &|_| ()) else {
            continue;
        };
        let own = twists(&usual);
        let most = own.iter().fold(0.0, |most: f64, twist| most.max(twist.abs()));
        let others = usual.other_equilibria(&quiet).expect("looked for");
        for (name, change) in OPTIONS {
            let Some(found) = solved_with(seed, refine, &change) else {
                continue;
            };
            let off = twists(&found)
                .iter()
                .zip(&own)
                .fold(0.0, |off: f64, (a, b)| off.max((a - b).abs()));
            let said = found.with_usual_options(&quiet).expect("looked for");
            let limit = if name.starts_with("drilling") {
                1e-3 * most
            } else {
                1e-4
            };
            if off > limit.max(1e-5) {
                println!(
                    "{seed:4}: {name} moves {off:.1e} of {most:.2} deg: {}",
                    others.len()
                );
                count += 1;
                let told = said.expect("a word").words();
                assert!(told.contains("another equilibrium"), "{told}");
                assert!(!others.is_empty(), "seed {seed}: {name}");
            } else {
                assert_eq!(
                    said.filter(|other| other.largest_difference_deg > 2.0 * limit),
                    None,
                    "{seed}"
                );
            }
        }
    }
    count
}

/// Slack and buckled films come to rest in more shapes than one: which it is depends on the way there, and a run says so.
#[test]
fn what_other_options_of_the_solver_move_says_that_it_has_another_equilibrium() {
    assert_eq!(moved(2..3, 0.3), 2);
    assert_eq!(moved(3..4, 0.3), 0);
}

#[test]
#[ignore = "minutes"]
fn share_of_random_wings_with_other_equilibria() {
    let seeds = var("WASHOUT_RANDOM").unwrap_or_default();
    let seeds = (seeds.split_once("..")).and_then(|(from, to)| Some(from.parse().ok()?..to.parse().ok()?));
    let refine = var("WASHOUT_REFINE").map_or(0.3, |refine| refine.parse().expect("a number"));
    println!("{} moved", moved(seeds.unwrap_or(0..131), refine));
}
