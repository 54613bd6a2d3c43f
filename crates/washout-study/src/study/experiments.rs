//! What could be measured next, as conditions of the model of a study.

use super::campaign::Campaign;
use super::case::PreparedCase;
use super::error::StudyError;
use crate::input::study::{LoadedCase, LoadedStudy};
use crate::progress::Progress;

impl Campaign {
    /// The experiments of a study that could be made next, as conditions of a model with the same unknowns; none if it lists
    /// none.
    ///
    /// # Errors
    /// As [`Campaign::new`].
    pub fn of_experiments(
        study: &LoadedStudy,
        candidates: &[&str],
        progress: &Progress,
    ) -> Result<Option<Campaign>, StudyError> {
        if study.experiments.is_empty() {
            return Ok(None);
        }
        Campaign::of_others(study, &study.experiments, candidates, progress).map(Some)
    }

    /// Other cases than those of the study, as conditions of a model with the same unknowns, as far as they act there. What all wings of
    /// the study have in common, these have too.
    ///
    /// # Errors
    /// As [`Campaign::new`].
    pub(super) fn of_others(
        study: &LoadedStudy,
        others: &[LoadedCase],
        candidates: &[&str],
        progress: &Progress,
    ) -> Result<Campaign, StudyError> {
        let cases = others.iter();
        let cases = cases.map(|case| PreparedCase::new(case, study, candidates));
        let cases: Vec<PreparedCase> = cases.collect::<Result<_, _>>()?;
        let mut own = study.clone();
        own.unused.clear();
        let designs = || cases.iter().map(|case| &case.design);
        own.study.uncertain.retain(|uncertain| {
            let concerns = |name: &String| {
                let named = uncertain.designs.as_ref();
                named.is_none_or(|named| named.contains(name))
            };
            designs().any(|design| concerns(&design.name) && design.get(&uncertain.key).is_some())
        });
        own.study
            .effect
            .retain(|effect| designs().any(|design| design.effects.contains_key(&effect.name)));
        Campaign::of_prepared(&own, cases, candidates, progress)
    }
}
