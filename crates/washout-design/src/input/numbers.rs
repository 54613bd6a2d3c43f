//! The numbers of a design that can be set: key, what it is, unit, and the values that are accepted.

use super::design::Design;
use super::keys::{self, Key, Kind};
use super::path::{KeyPath, Step};
use super::unit::unit_symbol;

/// A number of a design.
#[derive(Debug, Clone, PartialEq)]
pub struct DesignNumber {
    /// Dotted key, such as `rod[0].section.diameter_mm`.
    pub key: String,
    /// What it is, such as `flapping frequency`.
    pub words: String,
    /// Its unit; empty for a pure number.
    pub unit: &'static str,
    /// Its value.
    pub value: f64,
    /// Values that are accepted by themselves; others of the design may narrow them.
    pub allowed: [f64; 2],
    /// Whether only whole numbers are.
    pub is_whole: bool,
    /// The range that is thought possible, if the value is assumed.
    pub plausible: Option<[f64; 2]>,
}

impl Design {
    /// Every number of the design that has a range, in its order; those of effects have cards of their own and are left out.
    ///
    /// # Example
    /// ```
    /// # use washout_design as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use std::path::Path;
    /// # use washout::input::Design;
    /// let design = Design::load(Path::new("designs/twist-v2.toml"), &[])?.design;
    /// let numbers = design.numbers();
    /// let found = numbers.iter().find(|number| number.key == "flapping.half_amplitude_deg").unwrap();
    /// assert_eq!((found.value, found.unit, found.plausible), (34.5, "deg", Some([24.0, 45.0])));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn numbers(&self) -> Vec<DesignNumber> {
        let mut found = Vec::new();
        if let Ok(toml::Value::Table(root)) = toml::Value::try_from(self) {
            for (key, value) in root.iter().filter(|(key, _)| *key != "effects") {
                collect(value, &KeyPath::default().key(key), &mut found);
            }
        }
        found
    }
}

fn collect(value: &toml::Value, path: &KeyPath, found: &mut Vec<DesignNumber>) {
    match value {
        toml::Value::Table(table) => match assumed(table) {
            Some((value, range)) => found.extend(number(path, value, Some(range))),
            None => table
                .iter()
                .for_each(|(key, value)| collect(value, &path.key(key), found)),
        },
        toml::Value::Array(items) => {
            let each = items.iter().enumerate();
            each.for_each(|(index, value)| collect(value, &path.index(index), found));
        }
        value => found.extend(plain(value).and_then(|value| number(path, value, None))),
    }
}

fn number(path: &KeyPath, value: f64, plausible: Option<[f64; 2]>) -> Option<DesignNumber> {
    let (range, is_whole) = match keys::design().at(path)? {
        Kind::Quantity(range) | Kind::Number(range) => ((*range)?, false),
        Kind::Count(range) => ((*range)?, true),
        _ => return None,
    };
    let name = path.0.iter().rev().find_map(|step| match step {
        Step::Key(name) => Some(name.as_str()),
        Step::Index(_) => None,
    })?;
    let words = key_at(path).map_or(name, |key| key.words.as_str());
    Some(DesignNumber {
        key: path.to_string(),
        words: words.strip_prefix("the ").unwrap_or(words).to_string(),
        unit: unit_symbol(name).unwrap_or_default(),
        value,
        allowed: [range.low, range.high],
        is_whole,
        plausible,
    })
}

/// The key that a path ends with; none of an entry of a list.
fn key_at(path: &KeyPath) -> Option<&'static Key> {
    let (Step::Key(name), way) = path.0.split_last()? else {
        return None;
    };
    let named = |keys: &'static [Key]| keys.iter().find(|key| key.name == *name);
    match keys::design().at(&KeyPath(way.to_vec()))? {
        Kind::Table(keys) => named(keys),
        Kind::Tagged(_, variants) => variants.iter().find_map(|(_, keys)| named(keys)),
        _ => None,
    }
}

fn assumed(table: &toml::Table) -> Option<(f64, [f64; 2])> {
    let range = table.get("range")?.as_array()?;
    let end = |index: usize| plain(range.get(index)?);
    Some((plain(table.get("assumed")?)?, [end(0)?, end(1)?]))
}

fn plain(value: &toml::Value) -> Option<f64> {
    value.as_float().or(value.as_integer().map(|whole| whole as f64))
}

#[cfg(test)]
mod tests {
    use std::path::Path;

    use super::*;

    #[test]
    fn every_number_can_be_set_to_what_it_is_and_none_beyond_its_range() {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("designs/twist-v2.toml");
        let design = Design::load(&path, &[]).expect("a design").design;
        let numbers = design.numbers();
        assert!(numbers.len() > 40, "{}", numbers.len());
        for number in numbers {
            let mut other = design.clone();
            assert_eq!(design.get(&number.key), Some(number.value), "{}", number.key);
            other
                .set(&number.key, number.value)
                .unwrap_or_else(|error| panic!("{error}"));
            let beyond = number.allowed[1] + number.allowed[1].abs().max(1.0);
            assert!(other.set(&number.key, beyond).is_err(), "{}", number.key);
        }
    }

    #[test]
    fn numbers_say_what_they_are_in_the_words_of_the_schema() {
        let path = Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).join("designs/twist-v2.toml");
        let numbers = Design::load(&path, &[]).expect("a design").design.numbers();
        let words = |key: &str| {
            let found = numbers.iter().find(|number| number.key == key);
            found.map(|number| (number.words.clone(), number.unit))
        };
        assert_eq!(
            words("flapping.frequency_hz"),
            Some(("flapping frequency".into(), "Hz"))
        );
        assert_eq!(words("rod[1].section.diameter_mm").expect("a rod").1, "mm");
    }
}
