//! Runs cases: every mesh of every case is a job, and as many jobs run at a time as there are threads.

use std::collections::BTreeMap;
use std::sync::Mutex;
use std::sync::atomic::{AtomicUsize, Ordering};
use std::time::Instant;

use crate::progress::{Cancelled, Progress};

use super::VerifyError;
use super::case::{Answer, Case, Level};
use super::judge::{Meshed, Outcome};

/// How much of each case is run.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Extent {
    /// All three meshes.
    Full,
    /// The coarsest mesh that is within tolerance, alone: no order is observed.
    Short,
}

impl Extent {
    fn levels(self, case: &Case) -> Vec<Level> {
        match self {
            Extent::Full => Level::ALL.to_vec(),
            Extent::Short => vec![case.short],
        }
    }
}

type Answered = Result<(Meshed, Answer), VerifyError>;

/// Runs cases and judges them; outcomes in the order of `cases`, and the same for any number of threads.
///
/// # Errors
/// If the user asks to stop.
///
/// # Example
/// ```
/// use washout::progress::Progress;
/// use washout::verify::{Extent, named, run};
///
/// let case = named("euler-column").expect("a case of this name");
/// let outcomes = run(&[case], Extent::Short, &Progress::quiet()).expect("not interrupted");
/// assert!(outcomes.iter().all(|outcome| outcome.failure.is_none()));
/// ```
pub fn run(cases: &[&'static Case], extent: Extent, progress: &Progress) -> Result<Vec<Outcome>, Cancelled> {
    let mut jobs: Vec<(usize, Level)> = (cases.iter().enumerate())
        .flat_map(|(at, case)| extent.levels(case).into_iter().map(move |level| (at, level)))
        .collect();
    // the fine meshes first: no thread is left alone with a long one
    jobs.sort_by_key(|&(at, level)| (std::cmp::Reverse(level), at));
    let (next, done) = (AtomicUsize::new(0), AtomicUsize::new(0));
    let found = Mutex::new(BTreeMap::<(usize, Level), Answered>::new());
    let worker = || {
        while let Some(&(at, level)) = jobs.get(next.fetch_add(1, Ordering::Relaxed)) {
            if progress.is_cancelled() {
                return;
            }
            let answered = answer(cases[at], level, progress);
            let done = done.fetch_add(1, Ordering::Relaxed) + 1;
            progress.say(format_args!(
                "{done} of {} meshes; last: {}, {}",
                jobs.len(),
                cases[at].name,
                level.word()
            ));
            if let Ok(mut found) = found.lock() {
                found.insert((at, level), answered);
            }
        }
    };
    std::thread::scope(|scope| {
        for _ in 0..rayon::current_num_threads().min(jobs.len()) {
            scope.spawn(|| alone(worker));
        }
    });
    progress.check()?;
    let mut found = found.into_inner().unwrap_or_default();
    let outcomes = cases.iter().enumerate().map(|(at, &case)| {
        let levels = extent.levels(case).into_iter();
        outcome(
            case,
            levels.filter_map(|level| found.remove(&(at, level))).collect(),
        )
    });
    Ok(outcomes.collect())
}

/// Runs with one thread to itself, so that jobs neither wait for nor count the work of others.
fn alone(work: impl FnOnce() + Send) {
    match rayon::ThreadPoolBuilder::new().num_threads(1).build() {
        Ok(pool) => pool.install(work),
        Err(_) => work(),
    }
}

fn answer(case: &Case, level: Level, progress: &Progress) -> Answered {
    let start = Instant::now();
    let answer = (case.run)(level, &progress.unseen())?;
    let meshed = Meshed {
        level,
        mesh: answer.mesh.clone(),
        time_s: start.elapsed().as_secs_f64(),
    };
    Ok((meshed, answer))
}

fn outcome(case: &'static Case, answered: Vec<Answered>) -> Outcome {
    let mut answers = Vec::new();
    let mut failure = None;
    for answered in answered {
        match answered {
            Ok(answer) => answers.push(answer),
            Err(error) => failure = failure.or(Some(error.to_string())),
        }
    }
    let mut outcome = Outcome::new(case, answers);
    if failure.is_some() {
        outcome.judged.clear();
        outcome.failure = failure;
    }
    outcome
}

#[cfg(test)]
mod tests {
    use super::super::case::{Kind, Quantity};
    use super::*;

    const SQUARE: Quantity = Quantity {
        reference: || vec![1.0],
        tolerance: 0.1,
        ..Quantity::BLANK
    };
    static GOOD: Case = Case {
        name: "good",
        title: "",
        kind: Kind::Verification,
        quantities: &[SQUARE],
        short: Level::Middle,
        run: |level, _| Ok(Answer::new("", [1.0 + 0.01 / level.times(1) as f64])),
    };
    static BAD: Case = Case {
        name: "bad",
        run: |_, _| Err(VerifyError::Missing { what: "answer" }),
        ..GOOD
    };

    #[test]
    fn outcomes_come_in_the_order_of_the_cases_and_an_error_is_the_failure_of_one() {
        let found = run(&[&BAD, &GOOD], Extent::Full, &Progress::quiet()).unwrap();
        assert!(!found[0].passes() && found[0].failure.is_some());
        assert!(found[1].passes());
        assert_eq!(found[1].meshes.len(), 3);
        assert_eq!(found[1].judged[0].errors.len(), 3);
    }

    #[test]
    fn the_short_version_runs_one_mesh() {
        let found = run(&[&GOOD], Extent::Short, &Progress::quiet()).unwrap();
        assert_eq!(found[0].meshes[0].level, Level::Middle);
        assert_eq!(found[0].meshes.len(), 1);
    }

    #[test]
    fn who_asks_to_stop_gets_no_outcome() {
        let progress = Progress::quiet();
        progress.cancel();
        assert!(run(&[&GOOD], Extent::Full, &progress).is_err());
    }
}
