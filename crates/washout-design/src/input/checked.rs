//! From the tree of a file to a design that is checked.

use serde::Deserialize;

use super::check;
use super::design::Design;
use super::document::Node;
use super::error::{InputError, Problem};
use super::form;
use super::keys;
use super::quantity::Quantity;

/// The checked design of a tree.
pub(crate) fn design_of(root: &Node) -> Result<Design, InputError> {
    check::format_is_one(root)?;
    check::one_flow(root)?;
    form::check(root, keys::design())?;
    let mut design = Design::deserialize(&root.to_json()).map_err(|error| {
        let message = format!("cannot be read: {error}");
        InputError::new(root.file(), "", "", Problem::Syntax { message }, "")
    })?;
    let cut = root.get("planform").and_then(|planform| planform.get("tip_cut"));
    if cut.is_none() && design.planform.has_tip_chord() {
        design.planform.tip_cut = Quantity::Stated(1.0);
    }
    check::check(&design, root)?;
    Ok(design)
}
