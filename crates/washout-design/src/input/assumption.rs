//! Which inputs of a design are assumed.

use super::design::Design;
use super::path::KeyPath;

/// One assumed number of a design.
#[derive(Debug, Clone, PartialEq)]
pub struct Assumption {
    /// Dotted path, such as `rod[0].section.diameter_mm`; its last part carries the unit.
    pub key: String,
    /// The value that is used.
    pub value: f64,
    /// Lower and upper end of the plausible range.
    pub range: [f64; 2],
    /// Why it is assumed.
    pub why: String,
}

/// One assumed choice among words.
#[derive(Debug, Clone, PartialEq)]
pub struct Choice {
    /// Dotted path, such as `root.chord`.
    pub key: String,
    /// The word that is used.
    pub value: String,
    /// Why it is assumed.
    pub why: String,
}

impl Design {
    /// All assumed numbers, in the order of the design.
    pub fn assumptions(&self) -> Vec<Assumption> {
        let mut found = Vec::new();
        if let Ok(value) = toml::Value::try_from(self) {
            collect(&value, &KeyPath::default(), &mut found);
        }
        found
    }

    /// All assumed choices, as listed under `assumed_choice`, with the words that are used.
    pub fn assumed_choices(&self) -> Vec<Choice> {
        let value = toml::Value::try_from(self).ok();
        let choices = self.assumed_choice.iter().map(|choice| Choice {
            key: choice.key.clone(),
            value: value
                .as_ref()
                .and_then(|value| word_at(value, &choice.key))
                .unwrap_or_default(),
            why: choice.why.clone(),
        });
        choices.collect()
    }
}

/// The word or yes/no that stands at a dotted path.
pub(crate) fn word_at(value: &toml::Value, key: &str) -> Option<String> {
    use super::path::Step;
    let path = KeyPath::parse(key).ok()?;
    let found = path.0.iter().try_fold(value, |value, step| match step {
        Step::Key(key) => value.get(key.as_str()),
        Step::Index(index) => value.get(*index),
    })?;
    found.as_str().map(str::to_string)
}

fn collect(value: &toml::Value, path: &KeyPath, found: &mut Vec<Assumption>) {
    match value {
        toml::Value::Table(table) => {
            if let Some(assumption) = read(table, path) {
                found.push(assumption);
                return;
            }
            for (key, value) in table {
                collect(value, &path.key(key), found);
            }
        }
        toml::Value::Array(items) => {
            for (index, item) in items.iter().enumerate() {
                collect(item, &path.index(index), found);
            }
        }
        _ => {}
    }
}

fn read(table: &toml::Table, path: &KeyPath) -> Option<Assumption> {
    let number = |value: &toml::Value| value.as_float().or(value.as_integer().map(|whole| whole as f64));
    let range = table.get("range")?.as_array()?;
    Some(Assumption {
        key: path.to_string(),
        value: number(table.get("assumed")?)?,
        range: [number(range.first()?)?, number(range.get(1)?)?],
        why: table
            .get("why")
            .and_then(toml::Value::as_str)
            .unwrap_or_default()
            .to_string(),
    })
}
