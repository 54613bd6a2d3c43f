//! Assumed values: a number inside its own range, both inside the allowed one.

use super::range::in_range;
use crate::input::document::{Entry, Node, NodeValue};
use crate::input::error::{InputError, Number, Problem, Range};
use crate::input::keys::Key;
use crate::input::path::KeyPath;

/// `{ assumed = NUMBER, range = [LOW, HIGH], why = "..." }`.
pub(super) fn check(
    node: &Node,
    entries: &[Entry],
    range: Option<Range>,
    key: &Key,
    path: &KeyPath,
) -> Result<(), InputError> {
    const KEYS: [&str; 3] = ["assumed", "range", "why"];
    let example = key.example.as_deref().unwrap_or("1.0");
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
        let cure = match low == high {
            true => "A value without a range is stated, not assumed: write the number alone".to_string(),
            false => format!("Write range = [{high:?}, {low:?}]"),
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
