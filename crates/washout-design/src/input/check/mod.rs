//! What a design must satisfy beyond its form: values that only make sense together.

mod layout;

mod loads;

mod planform;

mod reading;

mod refusal;

mod section;

use refusal::material_is_known;
pub(crate) use refusal::refuse;
pub use refusal::{place_in, refused_in};

use super::design::Design;
use super::document::Node;
use super::error::{InputError, Problem};

/// Checks a design; `root` is the tree it was read from.
pub(crate) fn check(design: &Design, root: &Node) -> Result<(), InputError> {
    name(design, root)?;
    planform::check(&design.planform, design.mesh.file.is_some(), root)?;
    flow(design, root)?;
    section::check_materials(design, root)?;
    layout::check_rod(design, root)?;
    layout::check_spars(design, root)?;
    layout::check_ribs(design, root)?;
    layout::check_film(design, root)?;
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
