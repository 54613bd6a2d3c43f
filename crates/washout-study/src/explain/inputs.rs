//! Numbers that the designs assume, as uncertain inputs of the study.

use crate::input::Assumption;
use crate::input::study::{LoadedStudy, Uncertain};

/// How keys of parts begin: what is assumed of them is a number of each wing.
const PARTS: [&str; 3] = ["rod[", "spar[", "rib["];

/// The study with every number that its designs assume as an uncertain input, unless it says of one itself how uncertain it is. What all
/// designs assume alike is one number; places and sections of parts are numbers of each.
pub fn widened(study: &LoadedStudy) -> LoadedStudy {
    let mut wide = study.clone();
    let mut seen: Vec<&str> = Vec::new();
    let mut found: Vec<(Assumption, Vec<String>)> = Vec::new();
    for design in study.cases.iter().map(|case| &case.loaded.design) {
        if seen.contains(&design.name.as_str()) {
            continue;
        }
        seen.push(&design.name);
        let said = |assumption: &Assumption| {
            study.study.uncertain.iter().any(|uncertain| {
                let designs = uncertain.designs.as_ref();
                uncertain.key == assumption.key && designs.is_none_or(|own| own.contains(&design.name))
            })
        };
        for assumption in design.assumptions().into_iter().filter(|own| !said(own)) {
            let [low, high] = assumption.range;
            if low >= high || !(low..=high).contains(&assumption.value) {
                continue;
            }
            let is_part = PARTS.iter().any(|part| assumption.key.starts_with(part));
            let is_alike = |other: &&mut (Assumption, Vec<String>)| {
                !is_part
                    && other.0.key == assumption.key
                    && (other.0.value, other.0.range) == (assumption.value, assumption.range)
            };
            match found.iter_mut().find(is_alike) {
                Some((_, designs)) => designs.push(design.name.clone()),
                None => found.push((assumption, vec![design.name.clone()])),
            }
        }
    }
    wide.study
        .uncertain
        .extend(found.into_iter().map(|(assumption, designs)| Uncertain {
            key: assumption.key,
            mean: Some(assumption.value),
            sigma: None,
            range: Some(assumption.range),
            designs: Some(designs),
            why: assumption.why,
        }));
    wide
}

#[cfg(test)]
mod tests {
    use super::widened;
    use crate::input::study::LoadedStudy;
    use std::path::Path;

    #[test]
    fn what_wings_assume_alike_is_one_number_and_places_of_spars_are_numbers_of_each() {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("studies/paper-v1.toml");
        let study = LoadedStudy::load(&path, &[]).unwrap();
        let wide = widened(&study).study.uncertain;
        let of = |key: &str| wide.iter().filter(|own| own.key == key).collect::<Vec<_>>();
        assert_eq!(of("air.density_kg_m3").len(), 1);
        assert_eq!(of("air.density_kg_m3")[0].designs.as_ref().unwrap().len(), 3);
        assert_eq!(of("spar[1].at_mm").len(), 3);
        assert_eq!(of("spar[4].at_mm").len(), 2);
        // the study has said it itself
        assert_eq!(of("flapping.half_amplitude_deg").len(), 1);
        assert_eq!(of("flapping.half_amplitude_deg")[0].sigma, None);
    }
}
