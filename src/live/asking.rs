//! Questions that take long: what is missing, and an effect that joins. Each works beside the thread that follows what is moved.

use std::path::Path;
use std::sync::Arc;

use crate::add::{Joining, with_sets};
use crate::diagnose::of_study::refuse_own_data;
use crate::diagnose::{Cache, Candidates, Settings, StudyDiagnosis};
use crate::input::Design;
use crate::input::study::LoadedStudy;
use crate::progress::Progress;

use super::desk::Desk;
use super::found::Found;
use super::opened::What;
use super::refusal::Refusal;
use super::session::Session;
use super::state::State;
use super::values::{Addition, Step, StudyText};
use super::verbs::Saved;

/// Starts to ask what is missing; nothing is done while an earlier question is worked on.
///
/// # Errors
/// If nothing was measured, or there can be no thread more.
pub fn ask(desk: &Arc<Desk>) -> Result<(), Refusal> {
    let session = desk.session();
    let study = study_of(&session)?;
    let teller = Arc::downgrade(desk);
    let progress = Progress::told(move |line| {
        if let Some(desk) = teller.upgrade() {
            desk.ask(|question| question.say(line));
        }
    });
    let revision = session.revision();
    if !desk.ask(|question| question.begin(revision, progress.clone())) {
        return Ok(());
    }
    let case = session.case();
    let started = desk.start(move |desk| {
        let found = diagnosed(&study, &progress).map(|found| Found::new(found, &study, case));
        let found = match progress.is_cancelled() {
            true => Err(Refusal::new("stopped")),
            false => found,
        };
        desk.ask(|question| question.end(found));
    });
    started.map(drop).map_err(|error| {
        let refusal = Refusal::new(error);
        desk.ask(|question| question.end(Err(refusal.clone())));
        refusal
    })
}

/// What the model of a study lacks, as `washout diagnose` says it.
fn diagnosed(study: &LoadedStudy, progress: &Progress) -> Result<StudyDiagnosis, Refusal> {
    let settings = Settings::default();
    refuse_own_data(study, settings.seed).map_err(Refusal::new)?;
    let effects = Candidates::new(study, &[]).map_err(Refusal::new)?;
    StudyDiagnosis::new(study, &effects, settings, &Cache::of_user(), progress).map_err(Refusal::new)
}

/// The study of a session as it stands.
///
/// # Errors
/// If nothing was measured.
pub fn study_of(session: &Session) -> Result<LoadedStudy, Refusal> {
    let opened = session.opened();
    let sets = opened.sets(session.values());
    match (&opened.what, &session.values().study) {
        (What::Study(_), Some(study)) => Ok(opened.read(&study.text, &sets)?),
        (What::Study(study), None) => Ok((**study).clone()),
        (What::Design(loaded), _) => {
            let text = of_measured(&opened.path, &loaded.design)
                .ok_or_else(|| Refusal::new("nothing was measured"))?;
            let path = opened.path.with_extension("measured.toml");
            Ok(LoadedStudy::from_text(&path, &text, &sets)?)
        }
    }
}

/// Takes a hypothesis of the last answer into the model: of a study fitted as `washout add` fits it, of a design with the strengths that
/// were found.
///
/// # Errors
/// If there is no answer, the fit fails, or something was moved meanwhile.
pub fn add(desk: &Desk, hypothesis: usize) -> Result<State, Refusal> {
    let found = desk.ask(|question| question.found());
    let found = found.ok_or_else(|| Refusal::new("nothing was asked yet: ask what is missing first"))?;
    let additions = found.additions(hypothesis)?;
    let names: Vec<&str> = additions
        .iter()
        .map(|addition| addition.effect.as_str())
        .collect();
    let words = format!("+ {}", names.join(" + ").replace('-', " "));
    let session = desk.session();
    let Some(study) = session.values().study.clone() else {
        return desk.change(|session| session.joined(&words, &additions));
    };
    let progress = Progress::quiet();
    if !desk.ask(|question| question.work(progress.clone())) {
        return Err(Refusal::new("an effect is being fitted already"));
    }
    let with = fitted(&session, &study, additions, &progress);
    desk.ask(|question| question.rest());
    let with = with?;
    let revision = session.revision();
    desk.change(|session| {
        if session.revision() != revision {
            return Err(Refusal::new(
                "something was moved while the effect was fitted; add it once more",
            ));
        }
        session.added(&words, with)
    })
}

/// The study with effects fitted one after the other.
fn fitted(
    session: &Session,
    study: &StudyText,
    additions: Vec<Addition>,
    progress: &Progress,
) -> Result<StudyText, Refusal> {
    let opened = session.opened();
    let (mut text, mut steps) = (study.text.clone(), study.steps.clone());
    let mut sets = opened.sets(session.values());
    for addition in additions {
        text = with_sets(&text, &sets).map_err(Refusal::new)?;
        let loaded = opened.read(&text, &[])?;
        let joining = Joining {
            effect: addition.effect.clone(),
            numbers: addition.numbers.clone(),
            on: addition.wing.iter().cloned().collect(),
            ..Joining::default()
        };
        text = joining
            .fitted(&loaded, &text, progress)
            .map_err(Refusal::new)?
            .text;
        // what was moved stands in the text from here on
        let sets = std::mem::take(&mut sets);
        steps.push(Step::Fitted { addition, sets });
    }
    Ok(opened.study(text, steps)?)
}

/// The text of a study of one case: a design, and what it says was measured; what it assumes is uncertain.
fn of_measured(path: &Path, design: &Design) -> Option<String> {
    let measured = design.measured.as_ref()?;
    let text = |words: &str| toml::Value::from(words).to_string();
    let file = path.file_name()?.to_string_lossy();
    let mut study = format!(
        "format = 1\nname = {}\n\n[[case]]\ndesign = {}\nmeasurement = {}\nmeasured = {}\n",
        text(&design.name),
        text(&file),
        text(&measured.file),
        text(&measured.case)
    );
    for assumed in design.assumptions() {
        study += &format!("\n[[uncertain]]\nkey = {}\n", text(&assumed.key));
    }
    Some(study)
}

/// Saves what stands.
///
/// # Errors
/// If the file that was opened was changed since, or something cannot be written.
pub fn save(desk: &Desk) -> Result<Saved, Refusal> {
    let session = desk.session();
    session.opened().refuse_changed()?;
    let verbs = Arc::clone(session.verbs());
    let saved = session.saving(|save| verbs.save(save, &Progress::quiet()))?;
    let values = session.values().clone();
    desk.change(|session| {
        session.is_saved(values);
        Ok(())
    })?;
    Ok(saved)
}
