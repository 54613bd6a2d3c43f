//! From a move on the page of `washout live` to the new curve: 200 random moves of one input each, on the half mesh and on the default one.
//!
//! `RAYON_NUM_THREADS=1 cargo bench --bench live`; a name behind `--` measures that design alone. Minutes: after each move the shape
//! from rest is waited for, at most [`LONGEST`] where there is none.

use std::collections::BTreeMap;
use std::path::Path;
use std::sync::Arc;
use std::time::{Duration, Instant};

use washout::live::follow::follow;
use washout::live::verbs::SavesNothing;
use washout::live::{Desk, Session};

const MOVES: usize = 200;
/// Wait for a shape; without one by then, the move counts as that long, and is taken back.
const LONGEST: Duration = Duration::from_secs(15);

fn main() {
    fastrand::seed(20);
    println!(
        "{:10} {:>6} {:>9} {:>9} {:>9} {:>9}  refused",
        "design", "refine", "median s", "90 % s", "most s", "rest s"
    );
    let asked: Vec<String> = std::env::args()
        .skip(1)
        .filter(|own| !own.starts_with('-'))
        .collect();
    let is_asked = |design: &str| asked.is_empty() || asked.iter().any(|own| own == design);
    for design in ["twist-v1", "twist-v2"].into_iter().filter(|own| is_asked(own)) {
        for refine in [0.5, 1.0] {
            measure(design, refine);
        }
    }
}

fn measure(design: &str, refine: f64) {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join(format!("designs/{design}.toml"));
    let session = Session::open(&path, &[format!("mesh.refine={refine}")], Arc::new(SavesNothing));
    let desk = Desk::new(session.expect("a design"));
    let thread = desk.start(follow).expect("a thread");
    wait(&desk, 1, true);
    let inputs = desk.state().inputs;
    let (mut followed, mut settled, mut refused) = (Vec::new(), Vec::new(), 0);
    while followed.len() < MOVES {
        let input = &inputs[fastrand::usize(0..inputs.len())];
        let value = input.low + (input.high - input.low) * fastrand::f64();
        let moves = BTreeMap::from([(input.key.clone(), value)]);
        let start = Instant::now();
        let Ok(state) = desk.change(|session| session.set(&moves, false)) else {
            refused += 1;
            continue;
        };
        let found = wait(&desk, state.revision, false);
        followed.push(start.elapsed().as_secs_f64());
        let is_settled = wait(&desk, state.revision, true);
        settled.push(start.elapsed().as_secs_f64());
        if !(found && is_settled) {
            refused += 1;
            desk.change(|session| session.undo()).expect("a step");
        }
    }
    desk.close();
    thread.join().expect("no panic");
    followed.sort_by(f64::total_cmp);
    settled.sort_by(f64::total_cmp);
    let at = |share: f64| followed[(share * (MOVES - 1) as f64) as usize];
    println!(
        "{design:10} {refine:6} {:9.3} {:9.3} {:9.3} {:9.3}  {refused}",
        at(0.5),
        at(0.9),
        at(1.0),
        settled[MOVES / 2]
    );
}

/// Waits for the shape of a revision, or for the one from rest; whether there is one.
fn wait(desk: &Desk, revision: u64, is_settled: bool) -> bool {
    let (until, mut after) = (Instant::now() + LONGEST, 0);
    while Instant::now() < until {
        let _ = desk.shape(Some(after), until.saturating_duration_since(Instant::now()));
        let about = desk.shown().about;
        after = about.shape_revision;
        if about.revision == revision && (about.settled || about.solved && !is_settled) {
            return about.solved;
        }
    }
    false
}
