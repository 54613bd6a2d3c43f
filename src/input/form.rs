//! The form of a file: every key known, every value of its kind and in its range.

use super::document::{Entry, Node, NodeValue};
use super::error::{InputError, Number, Problem, Range};
use super::keys::{Key, Kind};
use super::nearest::nearest;
use super::path::KeyPath;
use super::unit;

/// Checks the form of a whole file; the first fault in the order of the file is the error.
pub(crate) fn check(root: &Node, kind: &Kind) -> Result<(), InputError> {
    let form = Form { root: kind };
    match kind {
        Kind::Table(keys) => form.table(root, keys, &KeyPath::default(), ""),
        _ => Ok(()),
    }
}

struct Form<'k> {
    root: &'k Kind,
}

impl Form<'_> {
    fn table(&self, node: &Node, keys: &[Key], path: &KeyPath, variant: &str) -> Result<(), InputError> {
        let NodeValue::Table(entries) = &node.value else {
            return Ok(());
        };
        for entry in entries {
            match keys.iter().find(|key| key.name == entry.key) {
                Some(key) => self.value(&entry.node, &key.kind, key, &path.key(&key.name))?,
                None => return Err(self.unknown_key(entry, keys, path, variant)),
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
            (Kind::Quantity(range), NodeValue::Table(entries)) => assumed(node, entries, *range, key, path),
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
                    return is(&format!("a list of {length} values"));
                }
                let items = items.iter().enumerate();
                items
                    .map(|(index, item)| self.value(item, kind, key, &path.index(index)))
                    .collect()
            }
            (Kind::List(kind, length), _) => match (&**kind, length) {
                (Kind::Table(_), _) => is(&format!("a list of tables, written [[{}]]", key.name)),
                (_, Some(length)) => is(&format!("a list of {length} values in brackets")),
                _ => is("a list in brackets"),
            },
            (Kind::Table(keys), NodeValue::Table(_)) => self.table(node, keys, path, ""),
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
            words: format!("the {tag}, one of {}", words.join(", ")),
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
        self.table(node, &keys, path, word)
    }

    fn unknown_key(&self, entry: &Entry, keys: &[Key], path: &KeyPath, variant: &str) -> InputError {
        let full = path.key(&entry.key).to_string();
        let shown = entry.node.shown();
        let stem = unit::without_unit(&entry.key);
        let same_stem =
            |key: &&Key| unit::of_key(&key.name).is_some() && unit::without_unit(&key.name) == stem;
        if let Some(key) = keys.iter().find(same_stem) {
            let problem = Problem::WrongUnit {
                expected: key.name.clone(),
            };
            return InputError::new(entry.place(), &full, &shown, problem, key.cure());
        }
        let allowed: Vec<String> = keys.iter().map(|key| key.name.clone()).collect();
        let mut cure = String::new();
        let homes = self.root.homes(&entry.key);
        if let Some(near) = nearest(&entry.key, allowed.iter().map(String::as_str)) {
            cure.push_str(&format!("Did you mean {near}? "));
        } else if !homes.is_empty() {
            let homes: Vec<String> = homes.iter().take(3).map(|home| format!("[{home}]")).collect();
            cure.push_str(&format!("{} belongs in {}. ", entry.key, homes.join(" or ")));
        }
        let here = match (path.0.is_empty(), variant) {
            (true, _) => "at the top level".to_string(),
            (false, "") => format!("in {path}"),
            (false, variant) => format!("in {path} of shape {variant}"),
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
    cure.push_str(&key.cure());
    InputError::new(node.place(), &path.to_string(), &node.shown(), problem, cure)
}

fn in_range(
    node: &Node,
    number: f64,
    range: Option<Range>,
    key: &Key,
    path: &KeyPath,
) -> Result<(), InputError> {
    let problem = match range {
        _ if !number.is_finite() => Problem::NotFinite,
        Some(range) if !range.contains(number) => Problem::OutOfRange { range },
        _ => return Ok(()),
    };
    Err(InputError::new(
        node.place(),
        &path.to_string(),
        &node.shown(),
        problem,
        key.cure(),
    ))
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

/// `{ assumed = NUMBER, range = [LOW, HIGH], why = "..." }`.
fn assumed(
    node: &Node,
    entries: &[Entry],
    range: Option<Range>,
    key: &Key,
    path: &KeyPath,
) -> Result<(), InputError> {
    const KEYS: [&str; 3] = ["assumed", "range", "why"];
    let example = example_number(key);
    let pattern = format!(
        "Write an assumed value as {} = {{ assumed = {example}, range = [LOW, HIGH], why = \"...\" }}",
        key.name
    );
    let fail = |node: &Node, name: &str, problem: Problem, cure: &str| {
        let full = path.key(name).to_string();
        Err(InputError::new(node.place(), &full, &node.shown(), problem, cure))
    };
    if let Some(entry) = entries.iter().find(|entry| !KEYS.contains(&entry.key.as_str())) {
        let allowed = KEYS.map(str::to_string).to_vec();
        let full = path.key(&entry.key).to_string();
        let cure = format!("{pattern}; or state it as {} = {example}", key.name);
        let problem = Problem::UnknownKey { allowed };
        return Err(InputError::new(
            entry.place(),
            &full,
            &entry.node.shown(),
            problem,
            cure,
        ));
    }
    for name in ["assumed", "range"] {
        if node.get(name).is_none() {
            let full = path.key(name).to_string();
            return Err(InputError::new(
                node.place(),
                &full,
                "",
                Problem::Missing,
                pattern,
            ));
        }
    }
    let a_number = |node: &Node, name: &str| match node.number() {
        Some(number) => in_range(node, number, range, key, &path.key(name)).map(|()| number),
        None => {
            let expected = "a number".to_string();
            let found = node.kind().to_string();
            fail(node, name, Problem::WrongType { expected, found }, &pattern).map(|()| f64::NAN)
        }
    };
    let mut value = f64::NAN;
    let mut ends: Vec<f64> = Vec::new();
    for Entry { key: name, node, .. } in entries {
        match (name.as_str(), &node.value) {
            ("assumed", _) => value = a_number(node, name)?,
            ("range", NodeValue::List(items)) if items.len() == 2 => {
                ends = items
                    .iter()
                    .map(|item| a_number(item, name))
                    .collect::<Result<_, _>>()?;
            }
            ("range", _) => {
                let expected = "a list of two numbers, [LOW, HIGH]".to_string();
                let found = match &node.value {
                    NodeValue::List(items) => format!("a list of {}", items.len()),
                    _ => node.kind().to_string(),
                };
                return fail(node, name, Problem::WrongType { expected, found }, &pattern);
            }
            (_, NodeValue::Text(_)) => {}
            _ => {
                let expected = "text in quotes".to_string();
                let found = node.kind().to_string();
                return fail(node, name, Problem::WrongType { expected, found }, &pattern);
            }
        }
    }
    let [low, high] = ends[..] else {
        return Ok(());
    };
    let conflict = |message: String| Problem::Conflict {
        message,
        with: vec![path.key("assumed").to_string(), path.key("range").to_string()],
    };
    let (Some(value_node), Some(range_node)) = (node.get("assumed"), node.get("range")) else {
        return Ok(());
    };
    if low >= high {
        let message = "must rise from its lower to its upper end".to_string();
        let cure = format!(
            "Write range = [{}, {}]",
            Number(high.min(low)),
            Number(low.max(high))
        );
        let cure = if low == high {
            "A value without a range is stated, not assumed: write the number alone".into()
        } else {
            cure
        };
        return fail(range_node, "range", conflict(message), &cure);
    }
    if value < low || value > high {
        let message = format!("must lie in its own range {} … {}", Number(low), Number(high));
        return fail(
            value_node,
            "assumed",
            conflict(message),
            "Widen the range, or assume a value inside it",
        );
    }
    Ok(())
}

fn example_number(key: &Key) -> &str {
    key.example.as_deref().unwrap_or("1.0")
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
        NodeValue::Float(number) => in_range(node, *number, None, key, path),
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
