//! What a design must satisfy beyond its form: values that only make sense together.

mod layout;

mod loads;

mod planform;

mod reading;

mod section;

use std::path::Path;

use super::design::Design;
use super::document::Node;
use super::error::{InputError, Problem};
use super::file::{read_text, shown};
use super::nearest::nearest;
use super::path::KeyPath;

/// Checks a design; `root` is the tree it was read from.
pub(crate) fn check(design: &Design, root: &Node) -> Result<(), InputError> {
    name(design, root)?;
    planform::check(&design.planform, design.mesh.file.is_some(), root)?;
    flow(design, root)?;
    section::check_materials(design, root)?;
    layout::check_rod(design, root)?;
    layout::check_spars(design, root)?;
    layout::check_ribs(design, root)?;
    if let Some(film) = &design.film {
        material_is_known(design, root, &film.material, "film.material")?;
    }
    loads::check(design, root)?;
    reading::check(design, root)
}

/// The name becomes a folder.
fn name(design: &Design, root: &Node) -> Result<(), InputError> {
    let name = &design.name;
    let allowed = |c: char| c.is_ascii_alphanumeric() || "_-.".contains(c);
    let cure = "Use letters, digits, - and _, e.g. name = \"my-wing\"";
    if name.is_empty() {
        return refuse(root, "name", "must not be empty", &[], cure);
    }
    if name.starts_with('.') || !name.chars().all(allowed) {
        let message = "must be usable as the name of a folder";
        return refuse(root, "name", message, &[], cure);
    }
    if name.len() > 64 {
        return refuse(root, "name", "must have at most 64 characters", &[], cure);
    }
    Ok(())
}

/// Flapping or a stream, not both; judged before what either lacks.
pub(crate) fn one_flow(root: &Node) -> Result<(), InputError> {
    if root.get("flapping").is_some() && root.get("steady").is_some() {
        let message = "cannot stand together with flapping";
        let cure = "Keep [flapping] or [steady]; delete both for bench loads only";
        return refuse(root, "steady", message, &["flapping"], cure);
    }
    Ok(())
}

fn flow(design: &Design, root: &Node) -> Result<(), InputError> {
    if design.air.coefficients == super::design::Coefficients::Table && design.air.table.is_none() {
        let message = "needs air.table";
        let cure =
            "Give table = \"coefficients.csv\" with the columns alpha_deg, cl, cd, or name another set";
        return refuse(root, "air.coefficients", message, &["air.table"], cure);
    }
    Ok(())
}

/// Refuses the name of a material that is not defined.
fn material_is_known(design: &Design, root: &Node, name: &str, key: &str) -> Result<(), InputError> {
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

/// The refusal of the value at `key` of a TOML file on disk, with its place; that of the file, if it cannot be read any more.
pub(crate) fn refused_in(path: &Path, what: &str, key: &str, message: &str, cure: &str) -> InputError {
    let root = read_text(path, what).and_then(|text| Node::parse_file(&shown(path), &text));
    match root.and_then(|root| refuse::<()>(&root, key, message, &[], cure)) {
        Err(refusal) => refusal,
        Ok(()) => InputError::about_file(&shown(path), message, cure),
    }
}

/// Without the last digits that arithmetic leaves behind, for messages.
fn round(value: f64) -> f64 {
    (value * 1e6).round() / 1e6
}
