//! A study made ready for a diagnosis: meshed, corrected for its mesh, and how it answers to every effect.

use std::collections::BTreeMap;

use nalgebra::DMatrix;
use serde::{Deserialize, Serialize};

use crate::input::study::LoadedStudy;
use crate::origin::sha256;
use crate::program::program_sha256;
use crate::progress::Progress;
use crate::study::{Campaign, Forward, MeshLeaves, OnCoarserMesh, Work};

use super::cache::Cache;
use super::columns;
use super::data::Data;
use super::error::DiagnoseError;
use super::responses::{Response, Responses};
use super::screening::effect_of;
use super::settings::Settings;
use super::table::Table;

/// A campaign on the coarser of two meshes, corrected by the finer one, its table, and what that took less what the campaign counts itself.
#[derive(Debug)]
pub struct Prepared {
    /// The campaign.
    pub campaign: Campaign,
    /// The settings, with what the study states of its model.
    pub settings: Settings,
    /// How the campaign answers to every effect.
    pub table: Table,
    /// What the table took, the campaign's own count of it left out.
    pub beside: Work,
    /// What must be said of the meshes.
    pub note: Option<String>,
}

/// What is kept of a campaign, whatever effects are tried with it.
#[derive(Serialize, Deserialize)]
struct Kept {
    mesh: MeshLeaves,
    #[serde(with = "columns")]
    moment: DMatrix<f64>,
    /// How it answers to each effect, by what that was made of.
    answers: BTreeMap<String, Answer>,
    screening: Work,
    work: Work,
}

/// How a campaign answers to one unknown.
#[derive(Clone, Serialize, Deserialize)]
struct Answer {
    slopes: Vec<f64>,
    response: Response,
}

impl Prepared {
    /// Reads a study, corrects it for its mesh and finds how it answers; what an earlier run found is taken from there, effect by
    /// effect.
    ///
    /// # Errors
    /// As [`Campaign::new`] and [`Table::new`].
    pub fn new(
        study: &LoadedStudy,
        candidates: &[&str],
        settings: Settings,
        cache: &Cache,
        progress: &Progress,
    ) -> Result<Prepared, DiagnoseError> {
        settings.check()?;
        let meshed = OnCoarserMesh::new(study, candidates, progress)?;
        let settings = Settings {
            discrepancy: meshed.campaign.discrepancy,
            start: Some(meshed.campaign.start()),
            ..settings
        };
        let made_of = format!(
            "{}{}{:?}",
            program_sha256(),
            meshed.campaign.made_of_without_tried(),
            (settings.stations, settings.switch_step)
        );
        let missing = Data::new(&meshed.campaign, &meshed.campaign.start())?.missing;
        let own = |&unknown: &usize| sha256(meshed.campaign.unknown_made_of(unknown).as_bytes());
        let names: Vec<String> = missing.iter().map(own).collect();
        let rows = meshed.campaign.observables().len();
        let kept = cache.read(&made_of).filter(|kept: &Kept| kept.is_of(rows));
        if let Some(kept) = &kept
            && names.iter().all(|name| kept.answers.contains_key(name))
        {
            return Ok(Prepared {
                table: kept.table(&names),
                campaign: meshed.campaign.with_mesh(&kept.mesh),
                settings,
                beside: kept.work,
                note: kept.mesh.note.clone(),
            });
        }
        let mesh = match &kept {
            Some(kept) => kept.mesh.clone(),
            None => meshed.leaves(candidates, progress)?,
        };
        let campaign = meshed.campaign.with_mesh(&mesh);
        let before = campaign.work();
        // what sits on one wing is taken from what sits on all: an effect is known whole, or not at all
        let is_known = |k: usize| {
            kept.as_ref()
                .is_some_and(|kept| kept.answers.contains_key(&names[k]))
        };
        let effect = |k: usize| effect_of(&campaign.unknowns()[missing[k]]).map(|own| own.0);
        let lacks = |k: usize| (0..missing.len()).any(|other| effect(other) == effect(k) && !is_known(other));
        let lacking: Vec<usize> = (0..missing.len()).filter(|&k| lacks(k)).collect();
        let wanted = |unknown: usize| lacking.iter().any(|&k| missing[k] == unknown);
        let made = Table::of_those(&campaign, &settings, &wanted, progress)?;
        let mut kept = kept.unwrap_or_else(|| Kept::of(mesh, &made));
        let mut beside = kept.work;
        beside += made.work - (campaign.work() - before);
        kept.add(lacking.iter().map(|&k| names[k].clone()), &made);
        cache.keep(&made_of, &kept);
        Ok(Prepared {
            campaign,
            settings,
            table: kept.table(&names),
            beside,
            note: kept.mesh.note,
        })
    }
}

impl Kept {
    /// Of a campaign of which nothing is known but what its mesh leaves, and how it answers to a moment.
    fn of(mesh: MeshLeaves, made: &Table) -> Kept {
        Kept {
            mesh,
            moment: made.moment.clone(),
            answers: BTreeMap::new(),
            screening: Work::default(),
            work: Work::default(),
        }
    }

    /// Adds the effects of a table, in its order, and what they took.
    fn add(&mut self, names: impl Iterator<Item = String>, made: &Table) {
        let columns = made.slopes.column_iter().zip(&made.responses.each);
        let answers = columns.map(|(slopes, response)| Answer {
            slopes: slopes.iter().copied().collect(),
            response: response.clone(),
        });
        self.answers.extend(names.zip(answers));
        self.screening += made.screening;
        self.work += made.work;
    }

    /// The table of the effects of these names. What it took is what all that is kept took.
    fn table(&self, names: &[String]) -> Table {
        let answers: Vec<&Answer> = names.iter().map(|name| &self.answers[name]).collect();
        let slopes: Vec<f64> = answers
            .iter()
            .flat_map(|own| own.slopes.iter().copied())
            .collect();
        Table {
            slopes: DMatrix::from_vec(self.moment.nrows(), answers.len(), slopes),
            moment: self.moment.clone(),
            responses: Responses {
                each: answers.iter().map(|own| own.response.clone()).collect(),
            },
            screening: self.screening,
            work: self.work,
        }
    }

    /// Whether it is of so many rows.
    fn is_of(&self, rows: usize) -> bool {
        let mesh = self.mesh.error.as_ref();
        let is_own = |own: &Answer| own.slopes.len() == rows && own.response.is_of(rows);
        mesh.is_none_or(|mesh| mesh.correction.len() == rows && mesh.deviation.len() == rows)
            && self.moment.nrows() == rows
            && self.answers.values().all(is_own)
    }
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;
    use crate::diagnose::Candidates;

    fn prepared(study: &LoadedStudy, effects: &[&str], cache: &Cache) -> Prepared {
        let effects: Vec<String> = effects.iter().map(|name| name.to_string()).collect();
        let tried = Candidates::new(study, &effects).expect("effects that can act");
        let quiet = Progress::quiet();
        Prepared::new(study, &tried.names(), Settings::default(), cache, &quiet).expect("answers")
    }

    #[test]
    fn answers_that_were_kept_are_those_of_a_question_of_its_own() {
        let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("../../tests/foreign/c005.toml");
        let study = LoadedStudy::load(&path, &[]).expect("a study");
        let folder = tempfile::tempdir().expect("a folder");
        let cache = Cache::in_folder(folder.path());
        // one with a derivative at none, and one at places along the span
        let first = prepared(&study, &["root-flexure", "rod-split"], &cache);
        let solved_first = first.campaign.work().solves;
        let other = ["lift-gain-linear", "rod-split"];
        let with_one_more = prepared(&study, &other, &cache);
        let alone = prepared(&study, &other, &Cache::none());
        assert_eq!(with_one_more.table.slopes, alone.table.slopes);
        assert_eq!(with_one_more.table.moment, alone.table.moment);
        assert_eq!(with_one_more.table.responses, alone.table.responses);
        // all is known: only the cases as they stand are solved
        let known = prepared(&study, &["root-flexure", "lift-gain-linear"], &cache);
        let cases = known.campaign.conditions().len();
        let of_known = known.campaign.work().solves;
        assert_eq!(of_known, cases, "of {solved_first} at first");
        assert!(with_one_more.campaign.work().solves < alone.campaign.work().solves);
    }
}
