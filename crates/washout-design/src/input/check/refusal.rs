//! How a design is refused.

use std::path::Path;

use crate::input::design::Design;
use crate::input::document::{Node, Source};
use crate::input::error::{InputError, Place, Problem};
use crate::input::file::{read_text, shown};
use crate::input::nearest::nearest;
use crate::input::path::KeyPath;

/// Refuses the name of a material that is not defined.
pub fn material_is_known(design: &Design, root: &Node, name: &str, key: &str) -> Result<(), InputError> {
    if design.material.contains_key(name) {
        return Ok(());
    }
    let known = design.material.keys().map(String::as_str);
    let mut cure = match nearest(name, known.clone()) {
        Some(near) => format!("Did you mean \"{near}\"? "),
        None => String::new(),
    };
    cure.push_str(&match design.material.is_empty() {
        true => format!(
            "No material is defined; add a table [material.{name}], or name a file: materials = \"...\""
        ),
        false => format!(
            "Defined are {}; add a table [material.{name}]",
            known.collect::<Vec<_>>().join(", ")
        ),
    });
    refuse(root, key, "there is no such material", &["material"], cure)
}

/// Refuses the value at `key`, with its place; at the nearest table above where the key does not stand.
pub(crate) fn refuse<T>(
    root: &Node,
    key: &str,
    message: impl Into<String>,
    with: &[&str],
    cure: impl Into<String>,
) -> Result<T, InputError> {
    let path = KeyPath::parse(key).unwrap_or_default();
    let mut above = path.clone();
    while root.at(&above).is_none() && above.0.pop().is_some() {}
    let place = match root.at(&above) {
        Some(node) if !above.0.is_empty() => node.place(),
        _ => root.file(),
    };
    let shown = root.at(&path).map(Node::shown).unwrap_or_default();
    let problem = Problem::Conflict {
        message: message.into(),
        with: with.iter().map(|key| key.to_string()).collect(),
    };
    Err(InputError::new(place, key, &shown, problem, cure))
}

/// The refusal of the value at `key` of a TOML file on disk, with its place; that of the file, if it cannot be read any more. The cure is
/// given as a sentence.
pub fn refused_in(path: &Path, what: &str, key: &str, message: &str, cure: &str) -> InputError {
    let cure = &first_up(cure);
    let root = read_text(path, what).and_then(|text| Node::parse_file(&shown(path), &text));
    match root.and_then(|root| refuse::<()>(&root, key, message, &[], cure)) {
        Err(refusal) => refusal,
        Ok(()) => InputError::about_file(&shown(path), message, cure),
    }
}

/// Where the value at `key` of a TOML file on disk stands; the file alone, where it cannot be read any more or has another value there,
/// as after `--set`.
pub fn place_in(path: &Path, key: &str, value: Option<&toml::Value>) -> Place {
    let root = read_text(path, "design file").and_then(|text| Node::parse_file(&shown(path), &text));
    let found = root.ok().and_then(|root| {
        let node = root.at(&KeyPath::parse(key).ok()?)?;
        let shown = |value: &toml::Value| Node::from_value(&Source::other("value"), value).shown();
        let same = value.is_none_or(|value| is_same_value(&node.shown(), &shown(value)));
        same.then(|| node.place())
    });
    found.unwrap_or_else(|| Place::file(&shown(path)))
}

/// A sentence with its first letter in upper case.
fn first_up(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters
        .next()
        .map_or(String::new(), |letter| letter.to_uppercase().to_string());
    first + letters.as_str()
}

/// Whether two ways to write a value mean the same: 0.30 and 0.3, 'x' and "x".
fn is_same_value(one: &str, other: &str) -> bool {
    let plain = |text: &str| text.trim_matches(['\'', '"']).to_string();
    match (one.parse::<f64>(), other.parse::<f64>()) {
        (Ok(one), Ok(other)) => one == other,
        _ => plain(one) == plain(other),
    }
}

/// Without the last digits that arithmetic leaves behind, for messages.
pub fn round(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}
