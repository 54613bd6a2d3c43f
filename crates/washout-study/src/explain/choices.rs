//! Words and alternatives: which of them are otherwise, and the study as it is then.

use crate::input::InputError;
use crate::input::study::{Alternative, LoadedStudy};

/// Words and alternatives that are otherwise at once, at most.
const MOST: usize = 2;

/// A study with some of its words and alternatives otherwise.
#[derive(Debug, Clone)]
pub struct Choice {
    /// What is otherwise.
    pub flipped: Vec<Alternative>,
    /// The study then.
    pub study: LoadedStudy,
}

/// The study as it stands, then with one and with two of its words and alternatives otherwise, in the order of the study; `sets`: what
/// changes every design. Two words for one key are never chosen at once.
///
/// # Errors
/// If a study cannot be read with one of them.
pub fn choices(study: &LoadedStudy, sets: &[String]) -> Result<Vec<Choice>, InputError> {
    let mut all: Vec<Alternative> = study.study.alternative.clone();
    all.extend(study.other_words());
    let mut found = vec![Choice {
        flipped: Vec::new(),
        study: study.clone(),
    }];
    for flipped in subsets(all.len(), MOST) {
        let flipped: Vec<&Alternative> = flipped.iter().map(|&index| &all[index]).collect();
        if is_contradiction(&flipped) {
            continue;
        }
        found.push(Choice {
            study: study.with_alternatives(&flipped, sets)?,
            flipped: flipped.into_iter().cloned().collect(),
        });
    }
    Ok(found)
}

/// Whether two of them change one key.
fn is_contradiction(flipped: &[&Alternative]) -> bool {
    let key = |set: &String| set.split('=').next().unwrap_or_default().trim().to_string();
    let mut keys: Vec<String> = flipped.iter().flat_map(|own| own.set.iter().map(key)).collect();
    let count = keys.len();
    keys.sort();
    keys.dedup();
    keys.len() < count
}

/// The subsets of `count` things with one to `most` of them, small ones first.
fn subsets(count: usize, most: usize) -> Vec<Vec<usize>> {
    let mut found: Vec<Vec<usize>> = Vec::new();
    let mut last: Vec<Vec<usize>> = vec![Vec::new()];
    for _ in 0..most {
        let grown = last.iter().flat_map(|own: &Vec<usize>| {
            let from = own.last().map_or(0, |last| last + 1);
            (from..count).map(move |next| own.iter().copied().chain([next]).collect::<Vec<usize>>())
        });
        last = grown.collect();
        found.extend(last.iter().cloned());
    }
    found
}

#[cfg(test)]
mod tests {
    use super::{choices, subsets};
    use crate::input::study::LoadedStudy;
    use std::path::Path;

    #[test]
    fn subsets_are_all_there_small_ones_first() {
        assert_eq!(
            subsets(3, 2),
            [vec![0], vec![1], vec![2], vec![0, 1], vec![0, 2], vec![1, 2]]
        );
        assert!(subsets(0, 2).is_empty());
    }

    #[test]
    fn each_word_acts_on_the_designs_that_assume_it_and_each_statement_on_the_readings() {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("studies/paper-twist.toml");
        let study = LoadedStudy::load(&path, &[]).unwrap();
        let all = choices(&study, &[]).unwrap();
        let name = |flipped: &[&str]| {
            let is_it = |own: &&super::Choice| {
                own.flipped
                    .iter()
                    .map(|own| own.name.as_str())
                    .collect::<Vec<_>>()
                    == flipped
            };
            all.iter().find(is_it).unwrap_or_else(|| panic!("{flipped:?}"))
        };
        assert_eq!(all.len(), 1 + 5 + 10);
        let across = &name(&["rod[0].section.flat = across"]).study.cases;
        let text = |index: usize| toml::to_string(&across[index].loaded.design).unwrap();
        assert!(!text(0).contains("across") && text(1).contains("across") && text(2).contains("across"));
        let both = &name(&["as-restated", "v1-and-v2-exchanged"]).study.cases;
        let of = |wing: &str| both.iter().find(|case| case.name == wing).unwrap();
        assert_eq!(of("twist-v1").loaded.design.name, "twist-v2");
        assert_eq!(of("twist-v1").rows[1].value, 1.27);
        assert_eq!(
            of("twist-v1")
                .loaded
                .design
                .flapping
                .as_ref()
                .unwrap()
                .frequency_hz
                .value(),
            22.0
        );
        assert_eq!(of("take-off").loaded.design.name, "twist-v1");
    }
}
