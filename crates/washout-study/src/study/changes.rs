//! What values of the unknowns change in a design, key by key: what somebody would write who did the same by hand.

use super::campaign::Campaign;
use crate::input::effect_key;

impl Campaign {
    /// What these values of the unknowns change in the design of a case: dotted key, number. Of an effect that acts then, all its numbers.
    pub fn changes_at(&self, case: usize, at: &[f64]) -> Vec<(String, f64)> {
        let design = &self.cases[case].design;
        let mut found: Vec<(String, f64)> = Vec::new();
        let mut add = |key: String, number: f64| match found.iter_mut().find(|own| own.0 == key) {
            Some(own) => own.1 = number,
            None => found.push((key, number)),
        };
        for ((target, &value), start) in self.targets.targets.iter().zip(at).zip(&self.targets.start) {
            let is_moved = value.to_bits() != start.to_bits();
            for (key, number) in target.sets(case, value, at).into_iter().filter(|_| is_moved) {
                let effect = effect_key(&key);
                let table = effect.and_then(|(name, _)| Some((name, design.effects.get(name)?)));
                for (name, (other, own)) in table
                    .into_iter()
                    .flat_map(|(name, table)| table.iter().map(move |own| (name, own)))
                {
                    if let Some(own) = own.as_float() {
                        add(format!("effects.{name}.{other}"), own);
                    }
                }
                add(key, number);
            }
        }
        found
    }
}
