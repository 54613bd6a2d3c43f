//! The allowed keys with kind, range, words and example, read from the schema of the types.

use std::sync::OnceLock;

use serde_json::Value;

use super::error::Range;
use super::path::{KeyPath, Step};
use super::{schema, unit};

/// What may stand at a place of a file.
#[derive(Debug, Clone, PartialEq)]
pub(crate) enum Kind {
    /// A number, or an assumed value with its range.
    Quantity(Option<Range>),
    /// A number.
    Number(Option<Range>),
    /// A whole number.
    Count(Option<Range>),
    /// Any text.
    Text,
    /// One of some words.
    Choice(Vec<String>),
    /// A list, of a fixed length if there is one.
    List(Box<Kind>, Option<usize>),
    /// A table with these keys.
    Table(Vec<Key>),
    /// A table whose key (first) says which of the sets of keys it has.
    Tagged(String, Vec<(String, Vec<Key>)>),
    /// A table with names of the user's own.
    Named(Box<Kind>),
    /// Anything.
    Free,
}

/// One allowed key.
#[derive(Debug, Clone, PartialEq)]
pub(crate) struct Key {
    /// Its name, unit included.
    pub name: String,
    /// What it holds.
    pub kind: Kind,
    /// Whether it must stand.
    pub required: bool,
    /// First sentence of its description, made to follow "Give ".
    pub words: String,
    /// An example, as TOML.
    pub example: Option<String>,
}

/// What may stand in a design file.
pub(crate) fn design() -> &'static Kind {
    static KIND: OnceLock<Kind> = OnceLock::new();
    KIND.get_or_init(|| kind_of_root(schema::design_schema().as_value()))
}

/// What may stand in a study file.
pub(crate) fn study() -> &'static Kind {
    static KIND: OnceLock<Kind> = OnceLock::new();
    KIND.get_or_init(|| kind_of_root(schema::study_schema().as_value()))
}

/// What may stand in a video file.
pub(crate) fn video() -> &'static Kind {
    static KIND: OnceLock<Kind> = OnceLock::new();
    KIND.get_or_init(|| kind_of_root(schema::video_schema().as_value()))
}

/// What may stand in a materials file.
pub(crate) fn materials() -> &'static Kind {
    static KIND: OnceLock<Kind> = OnceLock::new();
    KIND.get_or_init(|| kind_of_root(schema::materials_schema().as_value()))
}

impl Kind {
    /// What may stand at a path; none where no key leads.
    pub fn at(&self, path: &KeyPath) -> Option<&Kind> {
        let mut kind = self;
        for step in &path.0 {
            kind = match (kind, step) {
                (Kind::Table(keys), Step::Key(name)) => &keys.iter().find(|key| key.name == *name)?.kind,
                (Kind::Tagged(_, variants), Step::Key(name)) => {
                    let keys = variants.iter().flat_map(|(_, keys)| keys);
                    &keys.into_iter().find(|key| key.name == *name)?.kind
                }
                (Kind::Named(kind), Step::Key(_)) => kind,
                (Kind::List(kind, _), Step::Index(_)) => kind,
                (Kind::Free, _) => kind,
                _ => return None,
            };
        }
        Some(kind)
    }

    /// The tables, as dotted paths, in which a key of this name may stand.
    pub fn homes(&self, name: &str) -> Vec<String> {
        let mut homes = Vec::new();
        self.collect_homes(name, "", &mut homes);
        homes
    }

    fn collect_homes(&self, name: &str, path: &str, homes: &mut Vec<String>) {
        let mut visit = |keys: &[Key]| {
            if keys.iter().any(|key| key.name == name)
                && !path.is_empty()
                && !homes.iter().any(|home| home == path)
            {
                homes.push(path.to_string());
            }
            for key in keys {
                let below = if path.is_empty() {
                    key.name.clone()
                } else {
                    format!("{path}.{}", key.name)
                };
                key.kind.collect_homes(name, &below, homes);
            }
        };
        match self {
            Kind::Table(keys) => visit(keys),
            Kind::Tagged(_, variants) => variants.iter().for_each(|(_, keys)| visit(keys)),
            Kind::List(kind, _) => kind.collect_homes(name, path, homes),
            Kind::Named(kind) => kind.collect_homes(name, &format!("{path}.NAME"), homes),
            _ => {}
        }
    }
}

impl Key {
    /// What to do about a bad value: "Give the flapping frequency in hertz, e.g. frequency_hz = 23.0".
    pub fn cure(&self) -> String {
        let mut cure = format!("Give {}", self.words);
        if let Some(unit) = unit::of_key(&self.name) {
            cure.push_str(&format!(" in {}", unit.name));
        }
        if let Some(example) = &self.example {
            cure.push_str(&format!(", e.g. {} = {example}", self.name));
        }
        cure
    }
}

fn kind_of_root(schema: &Value) -> Kind {
    Kind::Table(keys_of(schema, schema))
}

fn keys_of(root: &Value, table: &Value) -> Vec<Key> {
    let required: Vec<&str> = strings(table.get("required"));
    let properties = table.get("properties").and_then(Value::as_object);
    let properties = properties.into_iter().flatten();
    properties
        .map(|(name, property)| Key {
            name: name.clone(),
            kind: kind_of(root, property, range_of(name, property)),
            required: required.contains(&name.as_str()),
            words: words_of(property),
            example: property.pointer("/examples/0").map(toml_text),
        })
        .collect()
}

fn kind_of(root: &Value, schema: &Value, range: Option<Range>) -> Kind {
    if let Some(reference) = schema.get("$ref").and_then(Value::as_str) {
        return match reference.strip_prefix("#/$defs/") {
            Some("Quantity") => Kind::Quantity(range),
            Some(name) => kind_of(root, &root["$defs"][name], range),
            None => Kind::Free,
        };
    }
    if let Some(options) = schema.get("anyOf").and_then(Value::as_array) {
        let some = options
            .iter()
            .find(|option| option.get("type") != Some(&Value::from("null")));
        return some.map_or(Kind::Free, |option| kind_of(root, option, range));
    }
    if let Some(variants) = schema.get("oneOf").and_then(Value::as_array) {
        return choice_of(root, variants);
    }
    let kinds = schema.get("type").map(|kind| match kind {
        Value::Array(_) => strings(Some(kind)),
        _ => kind.as_str().into_iter().collect(),
    });
    match kinds.unwrap_or_default().first() {
        Some(&"string") => match strings(schema.get("enum")) {
            words if words.is_empty() => Kind::Text,
            words => Kind::Choice(words.into_iter().map(str::to_string).collect()),
        },
        Some(&"integer") => Kind::Count(range),
        Some(&"number") => Kind::Number(range),
        Some(&"array") => {
            let length = schema
                .get("maxItems")
                .and_then(Value::as_u64)
                .map(|length| length as usize);
            let range = schema
                .get("items")
                .and_then(|items| range_with_unit(items, range))
                .or(range);
            Kind::List(Box::new(kind_of(root, &schema["items"], range)), length)
        }
        Some(&"object") if schema.get("properties").is_some() => Kind::Table(keys_of(root, schema)),
        Some(&"object") => match schema.get("additionalProperties") {
            Some(inner @ Value::Object(_)) => Kind::Named(Box::new(kind_of(root, inner, None))),
            _ => Kind::Named(Box::new(Kind::Free)),
        },
        _ => Kind::Free,
    }
}

fn choice_of(root: &Value, variants: &[Value]) -> Kind {
    let words = variants
        .iter()
        .filter_map(|variant| variant.get("const").and_then(Value::as_str));
    let words: Vec<String> = words.map(str::to_string).collect();
    if words.len() == variants.len() {
        return Kind::Choice(words);
    }
    let tagged = variants.iter().filter_map(|variant| {
        let properties = variant.get("properties")?.as_object()?;
        let (tag, word) = properties
            .iter()
            .find_map(|(name, property)| Some((name, property.get("const")?.as_str()?)))?;
        let keys = keys_of(root, variant);
        Some((
            tag.clone(),
            (
                word.to_string(),
                keys.into_iter().filter(|key| key.name != *tag).collect(),
            ),
        ))
    });
    let (tags, variants): (Vec<String>, Vec<_>) = tagged.unzip();
    match tags.into_iter().next() {
        Some(tag) => Kind::Tagged(tag, variants),
        None => Kind::Free,
    }
}

fn range_of(name: &str, property: &Value) -> Option<Range> {
    let symbol = unit::of_key(name).map_or("", |unit| unit.symbol);
    let seed = Range {
        low: f64::NEG_INFINITY,
        high: f64::INFINITY,
        open: false,
        unit: symbol,
    };
    range_with_unit(property, Some(seed)).or_else(|| range_with_unit(property.get("items")?, Some(seed)))
}

fn range_with_unit(schema: &Value, seed: Option<Range>) -> Option<Range> {
    let bound = |name: &str| schema.get(name).and_then(Value::as_f64);
    let unit = seed.map_or("", |range| range.unit);
    let closed = bound("minimum").zip(bound("maximum")).map(|ends| (ends, false));
    let open = bound("exclusiveMinimum")
        .zip(bound("exclusiveMaximum"))
        .map(|ends| (ends, true));
    let ((low, high), open) = closed.or(open)?;
    Some(Range {
        low,
        high,
        open,
        unit,
    })
}

fn words_of(property: &Value) -> String {
    let text = property
        .get("description")
        .and_then(Value::as_str)
        .unwrap_or_default();
    let first = text.split("\n\n").next().unwrap_or_default().replace('\n', " ");
    let first = first.split("; ").next().unwrap_or_default().trim_end_matches('.');
    let mut letters = first.chars();
    letters.next().map_or(String::new(), |letter| {
        letter.to_lowercase().chain(letters).collect()
    })
}

fn strings(list: Option<&Value>) -> Vec<&str> {
    let items = list.and_then(Value::as_array).into_iter().flatten();
    items.filter_map(Value::as_str).collect()
}

/// A JSON value as TOML on one line.
fn toml_text(value: &Value) -> String {
    match value {
        Value::Array(items) => {
            let items: Vec<String> = items.iter().map(toml_text).collect();
            format!("[{}]", items.join(", "))
        }
        Value::Object(object) => {
            let items: Vec<String> = object
                .iter()
                .map(|(key, item)| format!("{key} = {}", toml_text(item)))
                .collect();
            format!("{{ {} }}", items.join(", "))
        }
        other => other.to_string(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn every_key(kind: &Kind, path: &str, visit: &mut dyn FnMut(&str, &Key)) {
        let mut each = |keys: &[Key]| {
            for key in keys {
                let path = format!("{path}.{}", key.name);
                visit(&path, key);
                every_key(&key.kind, &path, visit);
            }
        };
        match kind {
            Kind::Table(keys) => each(keys),
            Kind::Tagged(_, variants) => variants.iter().for_each(|(_, keys)| each(keys)),
            Kind::List(kind, _) | Kind::Named(kind) => every_key(kind, path, visit),
            _ => {}
        }
    }

    #[test]
    fn every_number_has_a_range_and_every_value_an_example() {
        let mut count = 0;
        every_key(design(), "", &mut |path, key| {
            count += 1;
            let ranged = match &key.kind {
                Kind::Quantity(range) | Kind::Number(range) | Kind::Count(range) => {
                    range.is_some() || path == ".format"
                }
                Kind::List(item, _) => !matches!(**item, Kind::Number(None)),
                _ => true,
            };
            assert!(ranged, "{path} has no range");
            let table = match &key.kind {
                Kind::Table(_) | Kind::Named(_) => true,
                Kind::List(item, _) => matches!(**item, Kind::Table(_)),
                _ => false,
            };
            assert!(table || key.example.is_some(), "{path} has no example");
            assert!(!matches!(key.kind, Kind::Free), "{path} was not understood");
            let first = key.words.split(' ').next().unwrap();
            assert!(
                ["the", "how", "where", "why"].contains(&first),
                "{path}: \"Give {}\"",
                key.words
            );
        });
        assert!(count > 90, "only {count} keys");
    }

    #[test]
    fn the_cure_names_quantity_unit_and_example() {
        let Some(Kind::Table(keys)) = design().at(&KeyPath::parse("flapping").unwrap()) else {
            panic!("flapping is no table");
        };
        let key = keys.iter().find(|key| key.name == "frequency_hz").unwrap();
        assert_eq!(
            key.cure(),
            "Give the flapping frequency in hertz, e.g. frequency_hz = 23.0"
        );
        assert!(key.required);
    }

    #[test]
    fn paths_lead_through_lists_names_and_variants() {
        let at = |path: &str| design().at(&KeyPath::parse(path).unwrap());
        assert!(matches!(
            at("rod[0].section.diameter_mm"),
            Some(Kind::Quantity(Some(_)))
        ));
        assert!(matches!(
            at("material.steel.e_gpa"),
            Some(Kind::Quantity(Some(_)))
        ));
        assert!(matches!(at("load[3].force_n[2]"), Some(Kind::Number(Some(_)))));
        assert!(matches!(at("structure.kinematics"), Some(Kind::Choice(_))));
        assert!(at("rod.section").is_none());
    }

    #[test]
    fn a_key_knows_its_homes() {
        assert_eq!(design().homes("frequency_hz"), ["flapping"]);
        assert_eq!(design().homes("e_gpa"), ["material.NAME"]);
    }
}
