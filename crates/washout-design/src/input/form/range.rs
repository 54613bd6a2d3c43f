//! Whether a number lies in its range.

use crate::input::document::Node;
use crate::input::error::{InputError, Problem, Range};
use crate::input::keys::Key;
use crate::input::path::KeyPath;

pub fn in_range(
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
