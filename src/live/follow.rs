//! The thread that follows what is moved: the shape from the last one at once, the shape from rest, what the mesh leaves, the ladder.

use std::collections::BTreeMap;
use std::sync::Arc;
use std::time::Instant;

use crate::add::stages;
use crate::compare::{ComparedStudy, StudyComparison};
use crate::progress::Progress;
use crate::wing::{Meshes, SolvedWing, WingError};

use super::desk::Desk;
use super::job::Job;
use super::ladder::Ladder;
use super::opened::{CaseWing, Opened, What};
use super::refusal::Refusal;
use super::shape::{Curve, Read, curve, drawn, read};
use super::stroke::stroke;

/// Difference of twist between the shape found from the last one and that from rest above which they are two shapes, deg.
const APART_DEG: f64 = 0.05;
/// Comparisons of whole studies that are kept.
const MOST: usize = 64;

/// What is known from earlier jobs.
#[derive(Default)]
struct Known {
    of: Option<Arc<Opened>>,
    /// The shape that was found last.
    last: Option<SolvedWing>,
    /// Each case as opened.
    first: BTreeMap<usize, (Arc<Read>, Curve)>,
    /// Studies compared, by their text and what changes them.
    compared: BTreeMap<(String, Vec<String>), StudyComparison>,
}

/// Solves what is moved, job by job, until the desk is closed.
pub fn follow(desk: &Desk) {
    let mut known = Known::default();
    while let Some((job, progress)) = desk.next() {
        if !known.of.as_ref().is_some_and(|of| Arc::ptr_eq(of, &job.opened)) {
            known = Known {
                of: Some(Arc::clone(&job.opened)),
                ..Known::default()
            };
        }
        // whoever asked to stop has posted a newer job, or closed the desk
        let _ = solve(desk, &job, &progress, &mut known);
    }
}

/// Nothing is left to be done, for somebody asked to stop.
struct Stopped;

fn solve(desk: &Desk, job: &Job, progress: &Progress, known: &mut Known) -> Result<(), Stopped> {
    let start = Instant::now();
    let wing = match &job.wing {
        Ok(wing) => wing,
        Err(refusal) => {
            refuse(desk, job, refusal.clone(), start);
            return Ok(());
        }
    };
    let followed = followed(desk, job, wing, progress, known, start);
    if !desk.goes_on() {
        return Err(Stopped);
    }
    let settled = match wing.model.solve(progress) {
        Ok(settled) => settled,
        Err(WingError::Interrupted(_)) => return Err(Stopped),
        Err(error) => {
            let mut refusal = Refusal::from(error);
            if followed.is_some() {
                refusal.message = format!(
                    "From rest no shape is found; the one that is drawn in grey was found from the shape before. {}",
                    refusal.message
                );
            }
            refuse(desk, job, refusal, start);
            return Ok(());
        }
    };
    let note = followed.as_ref().and_then(|followed| apart(followed, &settled));
    if let Err(refusal) = show(desk, job, wing, &settled, true, start) {
        refuse(desk, job, refusal, start);
        return Ok(());
    }
    note.into_iter().for_each(|note| remark(desk, job, &note));
    known.last = Some(settled.clone());
    beside_first(desk, job, progress, known)?;
    let settled = mesh_error(desk, job, settled, progress)?;
    ladder(desk, job, progress, known)?;
    motion(desk, job, wing, &settled, progress)
}

/// The shape from the last one, shown at once.
fn followed(
    desk: &Desk,
    job: &Job,
    wing: &CaseWing,
    progress: &Progress,
    known: &mut Known,
    start: Instant,
) -> Option<SolvedWing> {
    let nodes = wing.model.mesh.nodes.len();
    let is_alike = |last: &&SolvedWing| {
        last.model.design().name == wing.model.design().name && last.solution.mesh.nodes.len() == nodes
    };
    let last = known.last.as_ref().filter(is_alike)?;
    let found = match wing.model.follow(&last.solution, progress) {
        Ok(found) => found,
        Err(WingError::Interrupted(_)) => return None,
        Err(_) => {
            search(desk, job);
            return None;
        }
    };
    show(desk, job, wing, &found, false, start).ok()?;
    known.last = Some(found.clone());
    Some(found)
}

fn show(
    desk: &Desk,
    job: &Job,
    wing: &CaseWing,
    solved: &SolvedWing,
    settled: bool,
    start: Instant,
) -> Result<(), Refusal> {
    let measured = wing.measured.as_ref();
    let read = Arc::new(read(solved, measured)?);
    let not_compared = read.not_compared();
    let drawn = drawn(&wing.name, solved, measured, None)?;
    desk.show(job.revision, |shown| {
        let about = &mut shown.about;
        about.case = job.case;
        (about.solved, about.settled) = (true, settled);
        (about.refusal, about.note) = (None, not_compared);
        (about.mesh_error_deg, about.stroke_phases) = (None, None);
        about.seconds = start.elapsed().as_secs_f64();
        shown.read = Some(read);
        shown.wing = Some(drawn.into());
    });
    Ok(())
}

/// Says something more of the shape that is shown.
fn remark(desk: &Desk, job: &Job, words: &str) {
    desk.show(job.revision, |shown| {
        let note = shown.about.note.take();
        shown.about.note = Some(note.map_or(words.to_string(), |note| format!("{note} {words}")));
    });
}

/// Nothing was found from the last shape, which stays: how long it takes from rest is not known.
fn search(desk: &Desk, job: &Job) {
    desk.show(job.revision, |shown| {
        let about = &mut shown.about;
        (about.solved, about.settled) = (false, false);
        (about.refusal, about.note) = (None, None);
        about.mesh_error_deg = None;
    });
}

/// The last shape stays, and it is said that it is not of this state.
fn refuse(desk: &Desk, job: &Job, refusal: Refusal, start: Instant) {
    desk.show(job.revision, |shown| {
        let about = &mut shown.about;
        (about.solved, about.settled) = (false, true);
        about.refusal = Some(refusal);
        about.note = None;
        about.mesh_error_deg = None;
        about.seconds = start.elapsed().as_secs_f64();
    });
}

/// That a wing can rest in two shapes, if these are two.
fn apart(followed: &SolvedWing, settled: &SolvedWing) -> Option<String> {
    let [followed, settled] = [curve("", followed), curve("", settled)].map(Result::ok);
    let (followed, settled) = (followed?, settled?);
    let pairs = followed.twist_deg.iter().zip(&settled.twist_deg);
    let largest = pairs.map(|(a, b)| (a - b).abs()).fold(0.0, f64::max);
    let tips = followed.twist_deg.last().zip(settled.twist_deg.last())?;
    (largest > APART_DEG).then(|| {
        format!(
            "This wing can rest in two shapes. Shown is the one that it reaches from rest ({:.2} deg at the tip); from the shape before it \
             came to {:.2} deg.",
            tips.1, tips.0
        )
    })
}

/// The wing as opened beside what is shown, once something was moved.
fn beside_first(desk: &Desk, job: &Job, progress: &Progress, known: &mut Known) -> Result<(), Stopped> {
    if !known.first.contains_key(&job.case)
        && let Ok(first) = &job.first
    {
        let solved = match first.model.solve(progress) {
            Ok(solved) => solved,
            Err(WingError::Interrupted(_)) => return Err(Stopped),
            Err(error) => {
                remark(
                    desk,
                    job,
                    &format!(
                        "As it was opened this wing has no shape, so nothing is held against that: {error}."
                    ),
                );
                return Ok(());
            }
        };
        if let (Ok(read), Ok(curve)) = (
            read(&solved, first.measured.as_ref()),
            curve("as opened", &solved),
        ) {
            known.first.insert(job.case, (Arc::new(read), curve));
        }
    }
    let Some((first, curve)) = known.first.get(&job.case) else {
        return Ok(());
    };
    desk.show(job.revision, |shown| {
        if let Some(read) = &mut shown.read {
            let read = Arc::make_mut(read);
            read.twist.other = Some(curve.clone());
            for number in &mut read.numbers {
                let own = first.numbers.iter().find(|own| own.key == number.key);
                number.original = own.map(|own| own.value);
            }
        }
    });
    Ok(())
}

/// What the mesh leaves; gives the wing back.
fn mesh_error(desk: &Desk, job: &Job, wing: SolvedWing, progress: &Progress) -> Result<SolvedWing, Stopped> {
    let meshes = Meshes::of_solved(wing, &progress.unseen()).map_err(|_| Stopped)?;
    let (found, unknown) = match meshes.error() {
        Ok(error) => (error.largest_twist_deg, error.unknown_because),
        Err(error) => (None, Some(error.to_string())),
    };
    desk.show(job.revision, |shown| shown.about.mesh_error_deg = found);
    unknown.into_iter().for_each(|reason| {
        remark(
            desk,
            job,
            &format!("What the mesh leaves is not known: {reason}."),
        )
    });
    Ok(meshes.wing)
}

/// The wing over its stroke.
fn motion(
    desk: &Desk,
    job: &Job,
    wing: &CaseWing,
    solved: &SolvedWing,
    progress: &Progress,
) -> Result<(), Stopped> {
    let (stroke, phases) = match stroke(solved, progress) {
        Ok(Some(moving)) => moving,
        Ok(None) => return Ok(()),
        Err(WingError::Interrupted(_)) => return Err(Stopped),
        Err(error) => {
            remark(desk, job, &format!("The stroke cannot be played: {error}."));
            return Ok(());
        }
    };
    if let Ok(drawn) = drawn(&wing.name, solved, wing.measured.as_ref(), Some(stroke)) {
        desk.show(job.revision, |shown| {
            shown.about.stroke_phases = Some(phases);
            shown.wing = Some(drawn.into());
        });
    }
    Ok(())
}

/// The ladder of what was measured.
fn ladder(desk: &Desk, job: &Job, progress: &Progress, known: &mut Known) -> Result<(), Stopped> {
    if !job.opened.is_measured() {
        return Ok(());
    }
    let ladder = match &job.opened.what {
        What::Design(_) => {
            let Some((first, _)) = known.first.get(&job.case) else {
                return Ok(());
            };
            let now = desk.shown().read.filter(|_| !job.values.sets().is_empty());
            Ladder::of_design(first, now.as_deref())
        }
        What::Study(_) => {
            let is_moved = job.values.is_set_by_hand();
            Ladder::of_study(&steps(desk, job, progress, known)?, is_moved)
        }
    };
    desk.climb(job.revision, ladder);
    Ok(())
}

/// The study calibrated without any effect that was added, and with one after the other.
fn steps(
    desk: &Desk,
    job: &Job,
    progress: &Progress,
    known: &mut Known,
) -> Result<Vec<(String, StudyComparison)>, Stopped> {
    let mut found = Vec::new();
    let Some(study) = &job.values.study else {
        return Ok(found);
    };
    let ends = |name: &str, reason: String| {
        remark(
            desk,
            job,
            &format!("The error step by step ends before \"{name}\": {reason}."),
        );
    };
    let stages = match stages(&study.loaded, &study.text) {
        Ok(stages) => stages,
        Err(error) => {
            ends("calibrated", error.to_string());
            return Ok(found);
        }
    };
    let sets = job.opened.sets(&job.values);
    for (name, text) in stages {
        let key = (text, sets.clone());
        if let Some(compared) = known.compared.get(&key) {
            found.push((name, compared.clone()));
            continue;
        }
        let loaded = match job.opened.read(&key.0, &sets) {
            Ok(loaded) => loaded,
            Err(error) => {
                ends(&name, error.to_string());
                break;
            }
        };
        let compared = ComparedStudy::new(&loaded, progress);
        progress.check().map_err(|_| Stopped)?;
        let compared = match compared {
            Ok(compared) => compared.comparison,
            Err(error) => {
                ends(&name, error.to_string());
                break;
            }
        };
        if known.compared.len() >= MOST {
            known.compared.clear();
        }
        known.compared.insert(key, compared.clone());
        found.push((name, compared));
    }
    Ok(found)
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::wing::WingModel;

    #[test]
    fn two_shapes_of_one_wing_are_told_and_rounding_is_not() {
        let solved = |amplitude_deg: f64| {
            let path = concat!(env!("CARGO_MANIFEST_DIR"), "/designs/twist-v1.toml");
            let sets = [
                "mesh.refine=0.3".to_string(),
                format!("flapping.half_amplitude_deg={amplitude_deg}"),
            ];
            let wing = WingModel::open(path, &[&sets[0], &sets[1]]).expect("a wing");
            wing.solve(&Progress::quiet()).expect("a shape")
        };
        let (own, near, other) = (solved(34.5), solved(34.5001), solved(40.0));
        assert_eq!(apart(&near, &own), None);
        let note = apart(&other, &own).expect("two shapes");
        let tip = |wing: &SolvedWing| {
            format!(
                "{:.2} deg",
                curve("", wing).expect("a curve").twist_deg.last().expect("a tip")
            )
        };
        assert!(note.contains(&tip(&own)) && note.contains(&tip(&other)), "{note}");
    }
}
