//! What a design must satisfy beyond its form: values that only make sense together.

use super::design::Design;
use super::document::Node;
use super::error::{InputError, Problem};
use super::path::KeyPath;

/// Checks a design; `root` is the tree it was read from.
pub(crate) fn check(design: &Design, root: &Node) -> Result<(), InputError> {
    let _ = (design, root);
    Ok(())
}

/// The version of the file format.
pub(crate) fn format_is_one(root: &Node) -> Result<(), InputError> {
    match root.get("format") {
        Some(node) if node.number() != Some(1.0) => {
            let problem = Problem::Conflict {
                message: "this program reads format 1".to_string(),
                with: Vec::new(),
            };
            let cure = "Write format = 1, or use the version of washout that the file was made for";
            Err(InputError::new(
                node.place(),
                "format",
                &node.shown(),
                problem,
                cure,
            ))
        }
        _ => Ok(()),
    }
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
