//! Was the measurement worth it that a diagnosis asked for? It is made, and so is another of the list.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use super::truth::{set_size, truth_probability};
use super::{Blind, BlindError, Kind};
use crate::diagnose::{self, Diagnosis, Experiments, judged};
use crate::progress::Progress;
use crate::study::Campaign;
use crate::study::draws::Draws;
use crate::synthesize::{Answer, Recipe, synthesize};

/// A campaign with the measurement that its diagnosis asked for, beside the same with another.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Followed {
    /// What the diagnosis asked for.
    pub best: String,
    /// How far that was expected to set the rivals apart, sigma.
    pub expected_sigma: f64,
    /// Another experiment of the list, drawn at random.
    pub other: String,
    /// Names in the 95 % set: before, after the best, after the other.
    pub names: [usize; 3],
    /// Probability of the truth, likewise.
    pub truth: [f64; 3],
}

impl Followed {
    /// Whether the best left fewer names than the other, or as many and the truth more probable.
    pub fn is_better(&self) -> bool {
        let [_, best, other] = self.names;
        best < other || (best == other && self.truth[1] > self.truth[2])
    }
}

/// Measures what `said` asks for, and another experiment; none if it asks for nothing, or the list has no other.
///
/// # Errors
/// If one of the campaigns has no answer, or the user asked to stop.
pub fn follow(
    blind: &Blind,
    kind: Kind,
    answer: &Answer,
    said: &Diagnosis,
    progress: &Progress,
) -> Result<Option<Followed>, BlindError> {
    let Some(next) = &said.next_experiment else {
        return Ok(None);
    };
    let Some(best) = next
        .candidates
        .iter()
        .find(|own| Some(&own.name) == next.best.as_ref())
    else {
        return Ok(None);
    };
    let others: Vec<&str> = next
        .candidates
        .iter()
        .map(|own| own.name.as_str())
        .filter(|name| *name != best.name)
        .collect();
    let recipe = &answer.recipe;
    let draw = Draws::new(recipe.made.seed).uniform(10, 0);
    let Some(other) = others.get((draw * others.len() as f64) as usize) else {
        return Ok(None);
    };
    let mut names = [set_size(said), 0, 0];
    let mut truth = [truth_probability(kind, answer, said), 0.0, 0.0];
    for (place, name) in [(1, best.name.as_str()), (2, other)] {
        let said = measured_too(blind, recipe, name, progress)?;
        names[place] = set_size(&said);
        truth[place] = truth_probability(kind, answer, &said);
    }
    Ok(Some(Followed {
        best: best.name.clone(),
        expected_sigma: best.separation_sigma,
        other: (*other).to_string(),
        names,
        truth,
    }))
}

/// The diagnosis of the same wings with the experiment `name` in the campaign.
fn measured_too(
    blind: &Blind,
    recipe: &Recipe,
    name: &str,
    progress: &Progress,
) -> Result<Diagnosis, BlindError> {
    let mut study = blind.study.clone();
    let experiments = std::mem::take(&mut study.experiments);
    study
        .cases
        .extend(experiments.into_iter().filter(|case| case.name == name));
    let made = synthesize(&study, recipe, progress)?;
    let campaign = Campaign::new(&made.study, &blind.candidates, progress)?;
    let mut settings = blind.settings.clone();
    settings.start = Some(campaign.start());
    let (baseline, judgement) = judged(&campaign, &settings, None, progress)?;
    Ok(diagnose::report::report(
        &baseline,
        &judgement,
        Experiments::Unknown,
        progress,
    )?)
}
