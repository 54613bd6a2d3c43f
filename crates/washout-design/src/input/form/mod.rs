//! The form of a file: every key known, every value of its kind and in its range.

mod assumed;

mod range;

use range::in_range;

use super::document::{Entry, Node, NodeValue};
use super::error::{InputError, Problem};
use super::keys::{Key, Kind};
use super::nearest::nearest;
use super::path::KeyPath;
use super::unit;

/// Checks the form of a whole file; the first fault in the order of the file is the error.
pub(crate) fn check(root: &Node, kind: &Kind) -> Result<(), InputError> {
    let form = Form { root: kind };
    match kind {
        Kind::Table(keys) => form.table(root, keys, &KeyPath::default(), None),
        _ => Ok(()),
    }
}

struct Form<'k> {
    root: &'k Kind,
}

/// The shape that a table has, and all that it could have.
#[derive(Clone, Copy)]
struct Shape<'k> {
    word: &'k str,
    variants: &'k [(String, Vec<Key>)],
}

impl Form<'_> {
    fn table(
        &self,
        node: &Node,
        keys: &[Key],
        path: &KeyPath,
        shape: Option<Shape>,
    ) -> Result<(), InputError> {
        let NodeValue::Table(entries) = &node.value else {
            return Ok(());
        };
        for entry in entries {
            match keys.iter().find(|key| key.name == entry.key) {
                Some(key) => self.value(&entry.node, &key.kind, key, &path.key(&key.name))?,
                None => return Err(self.unknown_key(entry, keys, path, shape)),
            }
        }
        match keys
            .iter()
            .find(|key| key.required && node.get(&key.name).is_none())
        {
            Some(key) => Err(missing(node, key, path)),
            None => Ok(()),
        }
    }

    fn value(&self, node: &Node, kind: &Kind, key: &Key, path: &KeyPath) -> Result<(), InputError> {
        let is = |expected: &str| -> Result<(), InputError> { Err(wrong_type(node, expected, key, path)) };
        match (kind, &node.value) {
            (Kind::Quantity(range), NodeValue::Table(entries)) => {
                assumed::check(node, entries, *range, key, path)
            }
            (Kind::Quantity(range) | Kind::Number(range), _) => match node.number() {
                Some(number) => in_range(node, number, *range, key, path),
                None => is("a number"),
            },
            (Kind::Count(range), NodeValue::Integer(number)) => {
                in_range(node, *number as f64, *range, key, path)
            }
            (Kind::Count(_), _) => is("a whole number"),
            (Kind::Text, NodeValue::Text(_)) => Ok(()),
            (Kind::Text, _) => is("text in quotes"),
            (Kind::Choice(words), NodeValue::Text(word)) => one_of(node, word, words, key, path),
            (Kind::Choice(words), _) => is(&format!("one of the words {}", words.join(", "))),
            (Kind::List(kind, length), NodeValue::List(items)) => {
                if let Some(length) = length
                    && items.len() != *length
                {
                    let expected = format!("a list of {length} values");
                    let found = format!("a list of {}", items.len());
                    let problem = Problem::WrongType { expected, found };
                    return Err(InputError::new(
                        node.place(),
                        &path.to_string(),
                        &node.shown(),
                        problem,
                        key.cure(),
                    ));
                }
                let mut items = items.iter().enumerate();
                items.try_for_each(|(index, item)| self.value(item, kind, key, &path.index(index)))
            }
            (Kind::List(kind, length), _) => match (&**kind, length) {
                (Kind::Table(_), _) => is(&format!("a list of tables, written [[{}]]", key.name)),
                (_, Some(length)) => is(&format!("a list of {length} values in brackets")),
                _ => is("a list in brackets"),
            },
            (Kind::Table(keys), NodeValue::Table(_)) => self.table(node, keys, path, None),
            (Kind::Tagged(tag, variants), NodeValue::Table(_)) => self.tagged(node, tag, variants, path),
            (Kind::Named(kind), NodeValue::Table(entries)) => {
                let mut entries = entries.iter();
                entries.try_for_each(|entry| {
                    check_name(entry, path)?;
                    self.value(&entry.node, kind, key, &path.key(&entry.key))
                })
            }
            (Kind::Table(_) | Kind::Tagged(..) | Kind::Named(_), _) => is("a table"),
            (Kind::Free, _) => free(node, key, path),
        }
    }

    fn tagged(
        &self,
        node: &Node,
        tag: &str,
        variants: &[(String, Vec<Key>)],
        path: &KeyPath,
    ) -> Result<(), InputError> {
        let words: Vec<String> = variants.iter().map(|(word, _)| word.clone()).collect();
        let key = Key {
            name: tag.to_string(),
            kind: Kind::Choice(words.clone()),
            required: true,
            words: format!("the {tag}"),
            example: words.first().map(|word| format!("\"{word}\"")),
        };
        let Some(word_node) = node.get(tag) else {
            return Err(missing(node, &key, path));
        };
        self.value(word_node, &key.kind, &key, &path.key(tag))?;
        let word = word_node.text().unwrap_or_default();
        let Some((word, keys)) = variants.iter().find(|(name, _)| name == word) else {
            return Ok(());
        };
        let mut keys = keys.clone();
        keys.insert(
            0,
            Key {
                required: false,
                ..key
            },
        );
        self.table(node, &keys, path, Some(Shape { word, variants }))
    }

    fn unknown_key(&self, entry: &Entry, keys: &[Key], path: &KeyPath, shape: Option<Shape>) -> InputError {
        let full = path.key(&entry.key).to_string();
        let shown = entry.node.shown();
        let stem = unit::without_unit(&entry.key);
        let same_stem =
            |key: &&Key| unit::of_key(&key.name).is_some() && unit::without_unit(&key.name) == stem;
        if let Some(key) = keys.iter().find(same_stem) {
            let problem = Problem::WrongUnit {
                absent: stem == entry.key,
                expected: key.name.clone(),
            };
            return InputError::new(entry.place(), &full, &shown, problem, key.cure());
        }
        let allowed: Vec<String> = keys.iter().map(|key| key.name.clone()).collect();
        let mut cure = String::new();
        let shapes = shape.iter().flat_map(|shape| shape.variants.iter());
        let shapes: Vec<&str> = shapes
            .filter(|(_, keys)| keys.iter().any(|key| key.name == entry.key))
            .map(|(word, _)| word.as_str())
            .collect();
        let homes = self.root.homes(&entry.key);
        if !shapes.is_empty() {
            cure.push_str(&format!(
                "{} belongs to the shape {}. ",
                entry.key,
                shapes.join(" or ")
            ));
        } else if let Some(near) = nearest(&entry.key, allowed.iter().map(String::as_str)) {
            cure.push_str(&format!("Did you mean {near}? "));
        } else if !homes.is_empty() {
            let homes: Vec<String> = homes.iter().take(3).map(|home| format!("[{home}]")).collect();
            cure.push_str(&format!("{} belongs in {}. ", entry.key, homes.join(" or ")));
        }
        let here = match (path.0.is_empty(), shape) {
            (true, _) => "at the top level".to_string(),
            (false, None) => format!("in {path}"),
            (false, Some(shape)) => format!("in {path} of shape {}", shape.word),
        };
        cure.push_str(&format!("Allowed {here}: {}", allowed.join(", ")));
        InputError::new(
            entry.place(),
            &full,
            &shown,
            Problem::UnknownKey { allowed },
            cure,
        )
    }
}

fn missing(table: &Node, key: &Key, path: &KeyPath) -> InputError {
    let place = if path.0.is_empty() {
        table.file()
    } else {
        table.place()
    };
    let full = path.key(&key.name).to_string();
    let needed = |keys: &[Key]| {
        let needed = keys
            .iter()
            .filter(|key| key.required)
            .map(|key| key.name.as_str());
        needed.collect::<Vec<_>>().join(" and ")
    };
    let cure = match &key.kind {
        Kind::Choice(words) => format!("{}; allowed are {}", key.cure(), words.join(", ")),
        Kind::Table(keys) => format!("Give {}: a table [{full}] with {}", key.words, needed(keys)),
        Kind::List(kind, _) => match &**kind {
            Kind::Table(keys) => format!("Give {}, with {}", key.words, needed(keys)),
            _ => key.cure(),
        },
        _ => key.cure(),
    };
    InputError::new(place, &full, "", Problem::Missing, cure)
}

fn wrong_type(node: &Node, expected: &str, key: &Key, path: &KeyPath) -> InputError {
    let problem = Problem::WrongType {
        expected: expected.to_string(),
        found: node.kind().to_string(),
    };
    let number = matches!(key.kind, Kind::Quantity(_) | Kind::Number(_) | Kind::Count(_));
    let starts_as_number = node.text().is_some_and(|text| {
        let digits: String = text
            .trim()
            .chars()
            .take_while(|c| c.is_ascii_digit() || "+-.".contains(*c))
            .collect();
        digits.parse::<f64>().is_ok()
    });
    let mut cure = String::new();
    if number && starts_as_number {
        cure.push_str("Write the number without quotes and without unit. ");
    }
    if matches!(key.kind, Kind::Quantity(_)) && node.length() == Some(2) {
        cure.push_str(&format!(
            "A range is written {} = {{ assumed = NUMBER, range = {}, why = \"...\" }}. ",
            key.name,
            node.shown()
        ));
    }
    cure.push_str(&key.cure());
    InputError::new(node.place(), &path.to_string(), &node.shown(), problem, cure)
}

fn one_of(node: &Node, word: &str, words: &[String], key: &Key, path: &KeyPath) -> Result<(), InputError> {
    if words.iter().any(|allowed| allowed == word) {
        return Ok(());
    }
    let mut cure = String::new();
    if let Some(near) = nearest(word, words.iter().map(String::as_str)) {
        cure.push_str(&format!("Did you mean \"{near}\"? "));
    }
    cure.push_str(&key.cure());
    let problem = Problem::UnknownValue {
        allowed: words.to_vec(),
    };
    Err(InputError::new(
        node.place(),
        &path.to_string(),
        &node.shown(),
        problem,
        cure,
    ))
}

fn check_name(entry: &Entry, path: &KeyPath) -> Result<(), InputError> {
    let allowed = |c: char| c.is_ascii_alphanumeric() || c == '_' || c == '-';
    if !entry.key.is_empty() && entry.key.chars().all(allowed) {
        return Ok(());
    }
    let full = format!("{path}.\"{}\"", entry.key);
    let problem = Problem::Syntax {
        message: "a name must consist of letters, digits, _ and -".to_string(),
    };
    let cure = format!("Rename it, e.g. [{path}.my-name]");
    Err(InputError::new(entry.place(), &full, "", problem, cure))
}

/// Raw tables may hold anything but dates and numbers that are none.
fn free(node: &Node, key: &Key, path: &KeyPath) -> Result<(), InputError> {
    match &node.value {
        NodeValue::Float(number) if !number.is_finite() => {
            let cure = "Give a number that is neither nan nor infinite";
            Err(InputError::new(
                node.place(),
                &path.to_string(),
                &node.shown(),
                Problem::NotFinite,
                cure,
            ))
        }
        NodeValue::Date => Err(wrong_type(node, "a number, text, list or table", key, path)),
        NodeValue::List(items) => {
            let mut items = items.iter().enumerate();
            items.try_for_each(|(index, item)| free(item, key, &path.index(index)))
        }
        NodeValue::Table(entries) => entries.iter().try_for_each(|entry| {
            check_name(entry, path)?;
            free(&entry.node, key, &path.key(&entry.key))
        }),
        _ => Ok(()),
    }
}
