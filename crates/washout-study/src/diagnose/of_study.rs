//! A study, diagnosed: its campaign made ready, what it lacks, and what to measure next.

use serde::{Deserialize, Serialize};

use crate::effects::stands_for;
use crate::input::measurement::InCommon;
use crate::input::sheet::DesignReadings;
use crate::input::study::LoadedStudy;
use crate::program::program_sha256;
use crate::progress::Progress;
use crate::study::case::PreparedCase;
use crate::study::{Campaign, Forward, Proposals, Work};

use super::cache::Cache;
use super::candidates::Candidates;
use super::diagnose_among;
use super::error::DiagnoseError;
use super::next::Experiments;
use super::plan::{Plan, plan};
use super::prepared::Prepared;
use super::root_edge::RootEdge;
use super::settings::Settings;
use super::verdict::Diagnosis;

/// How a note begins of rows that had no part in a diagnosis.
pub const NOT_COMPARED: &str = "Not compared";

/// A study diagnosed.
#[derive(Debug)]
pub struct StudyDiagnosis {
    /// The campaign that it was diagnosed by.
    pub campaign: Campaign,
    /// What it lacks.
    pub diagnosis: Diagnosis,
    /// What that took.
    pub work: Work,
}

/// What is kept of an answer, for the same question asked again.
#[derive(Serialize, Deserialize)]
struct Kept {
    diagnosis: Diagnosis,
    work: Work,
}

impl StudyDiagnosis {
    /// What the measurements of a study say, and what to measure next: of its experiments, or of what any study can add. Asked again, it
    /// is what `cache` kept.
    ///
    /// # Errors
    /// As [`super::diagnose`].
    ///
    /// # Example
    /// ```
    /// # use washout_study as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use std::path::Path;
    /// use washout::diagnose::{Cache, Candidates, Settings, StudyDiagnosis};
    /// use washout::{input::study::LoadedStudy, progress::Progress};
    ///
    /// let study = LoadedStudy::load(Path::new("studies/minguet.toml"), &[])?;
    /// let tried = Candidates::new(&study, &["root-flexure".to_string(), "rod-creep".to_string()])?;
    /// let quiet = Progress::quiet();
    /// let found = StudyDiagnosis::new(&study, &tried, Settings::default(), &Cache::none(), &quiet)?;
    /// println!("{}", found.diagnosis.sentence);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn new(
        study: &LoadedStudy,
        candidates: &Candidates,
        settings: Settings,
        cache: &Cache,
        progress: &Progress,
    ) -> Result<StudyDiagnosis, DiagnoseError> {
        let names = candidates.names();
        let asked = (study, &names, &candidates.left_out, &settings);
        let asked = format!("{}{asked:?}", program_sha256());
        let Prepared {
            campaign,
            settings,
            table,
            beside,
            note,
        } = Prepared::new(study, &names, settings, cache, progress)?;
        if let Some(Kept { diagnosis, work }) = cache.read(&asked) {
            return Ok(StudyDiagnosis {
                campaign,
                diagnosis,
                work,
            });
        }
        let listed = Campaign::of_experiments(study, &names, progress)?;
        let proposals = Proposals::new(study, &names);
        let experiments = match &listed {
            Some(listed) => Experiments::Listed(listed),
            None => Experiments::Proposed(&proposals),
        };
        let mut diagnosis = diagnose_among(&campaign, experiments, Some(&table), &settings, progress)?;
        say_what_strengths_stand_for(&mut diagnosis, &campaign);
        let on = study.study.candidates_on.as_ref().map(|wings| {
            format!(
                "Effects were tried on {} alone; the other wings are held to be as modelled.",
                wings.join(", ")
            )
        });
        let not_compared = campaign.not_compared().into_iter();
        // what had no part in it comes first
        let not_compared = not_compared.map(|row| format!("{NOT_COMPARED}: {row}"));
        diagnosis.notes.splice(0..0, not_compared);
        let left_out = candidates.left_out.iter().cloned();
        diagnosis.notes.extend(on.into_iter().chain(left_out).chain(note));
        let mut work = campaign.work();
        work += beside;
        let kept = Kept { diagnosis, work };
        cache.keep(&asked, &kept);
        Ok(StudyDiagnosis {
            campaign,
            diagnosis: kept.diagnosis,
            work,
        })
    }

    /// The same of a study that was made of a table, with what changes its design: what looks wrong in the table is said first; what is
    /// assumed of it last, and what the root edge of the film held otherwise would make.
    ///
    /// # Errors
    /// If the study of the table cannot be read, or the user asked to stop.
    pub fn of_table(
        mut self,
        table: &DesignReadings,
        sets: &[String],
        progress: &Progress,
    ) -> Result<StudyDiagnosis, DiagnoseError> {
        let Diagnosis {
            sentence,
            notes,
            next_experiment,
            ..
        } = &mut self.diagnosis;
        if let Some(next) = next_experiment {
            next.for_table(&table.sheet.measurement.file);
        }
        if let Some(doubts) = table.doubts() {
            *sentence = format!("{doubts} {sentence}");
        }
        notes.extend(table.assumed());
        match RootEdge::of_table(table, sets, progress)? {
            Some(edge) if edge.is_otherwise_nearer() => notes.insert(0, edge.words()),
            edge => notes.extend(edge.map(|edge| edge.words())),
        }
        Ok(self)
    }
}

/// Says of every strength what it is on the first wing that has its effect.
fn say_what_strengths_stand_for(diagnosis: &mut Diagnosis, campaign: &Campaign) {
    let all = diagnosis.hypotheses.iter_mut();
    for strength in all.flat_map(|own| &mut own.strengths) {
        let place = strength.place.iter();
        let place = place.map(|place| (place.parameter.as_str(), place.value));
        let numbers = place.chain([("strength", strength.value)]);
        let on = |case: &PreparedCase| {
            let mut design = case.design.clone();
            for (name, value) in numbers.clone() {
                let key = format!("effects.{}.{name}", strength.effect);
                design.set(&key, value).ok()?;
            }
            stands_for(&design, &strength.effect)
        };
        strength.stands_for = campaign.cases().iter().find_map(on);
    }
}

/// What the campaign of a study could see and tell apart, whose measurements may still be missing.
///
/// # Errors
/// As [`plan()`].
pub fn plan_study(
    study: &LoadedStudy,
    candidates: &Candidates,
    settings: Settings,
    cache: &Cache,
    progress: &Progress,
) -> Result<Plan, DiagnoseError> {
    let prepared = Prepared::new(study, &candidates.names(), settings, cache, progress)?;
    plan(
        &prepared.campaign,
        Some(&prepared.table),
        &prepared.settings,
        progress,
    )
}

/// Refuses measurements that were made with what a diagnosis with this seed itself uses: they prove nothing.
///
/// # Errors
/// [`DiagnoseError::OwnData`].
pub fn refuse_own_data(study: &LoadedStudy, seed: u64) -> Result<(), DiagnoseError> {
    let mut files: Vec<(&str, Vec<InCommon>)> = Vec::new();
    for case in &study.cases {
        let shared = case.made.map_or(Vec::new(), |made| made.in_common(seed));
        let file = case.measurement.as_str();
        if !shared.is_empty() && !files.iter().any(|(known, _)| *known == file) {
            files.push((file, shared));
        }
    }
    if files.is_empty() {
        return Ok(());
    }
    let made = files.iter().map(|(file, shared)| {
        let what: Vec<&str> = shared.iter().map(|shared| shared.what.as_str()).collect();
        format!("{file} was made by washout synthesize with {}", and(&what))
    });
    let made = made.collect::<Vec<_>>().join(", and ");
    let mut without: Vec<&str> = Vec::new();
    for shared in files.iter().flat_map(|(_, shared)| shared) {
        if !without.contains(&shared.without.as_str()) {
            without.push(&shared.without);
        }
    }
    Err(DiagnoseError::OwnData {
        study: study.path.clone(),
        made,
        without: and(&without),
    })
}

/// Words in one sentence.
fn and(words: &[&str]) -> String {
    match words {
        [rest @ .., last] if !rest.is_empty() => format!("{} and {last}", rest.join(", ")),
        _ => words.concat(),
    }
}
