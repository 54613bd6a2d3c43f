//! Whether what was said is what was hidden.

use crate::diagnose::Diagnosis;
use crate::diagnose::hypothesis::Hypothesis;
use crate::synthesize::Answer;

use super::kind::Kind;

/// Whether two lists hold the same names.
pub fn same(said: &[String], truth: &[&str]) -> bool {
    let mut said: Vec<&str> = said.iter().map(String::as_str).collect();
    let mut truth = truth.to_vec();
    said.sort_unstable();
    truth.sort_unstable();
    said == truth
}

/// Whether a hypothesis is what was hidden.
pub fn is_truth(kind: Kind, answer: &Answer, hypothesis: &Hypothesis) -> bool {
    let is_novel = hypothesis.effects == ["novel"];
    let families: Vec<&str> = answer.acted.iter().map(|acted| acted.family.as_str()).collect();
    match kind {
        Kind::Novel => is_novel,
        _ => !is_novel && same(&hypothesis.families, &families),
    }
}

/// Probability that was given to what was hidden.
pub fn truth_probability(kind: Kind, answer: &Answer, said: &Diagnosis) -> f64 {
    let own = said.hypotheses.iter().filter(|own| is_truth(kind, answer, own));
    own.map(|hypothesis| hypothesis.probability).sum()
}

/// Hypotheses in the 95 % set.
pub fn set_size(said: &Diagnosis) -> usize {
    said.hypotheses
        .iter()
        .filter(|hypothesis| hypothesis.in_set)
        .count()
}

/// What the hypotheses in the 95 % set show: families, alone or two together, nothing, and novel.
pub fn names_in_set(said: &Diagnosis) -> usize {
    let set = said.hypotheses.iter().filter(|hypothesis| hypothesis.in_set);
    let mut names: Vec<&[String]> = set
        .map(|hypothesis| match &hypothesis.families[..] {
            [] => &hypothesis.effects[..],
            all => all,
        })
        .collect();
    names.sort_unstable();
    names.dedup();
    names.len()
}
