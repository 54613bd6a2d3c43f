//! Bench loads: on the wing, and loading something.

use super::refusal::refuse;
use crate::input::design::Design;
use crate::input::document::Node;
use crate::input::error::{InputError, Number};
use crate::input::path::KeyPath;

pub(super) fn check(design: &Design, root: &Node) -> Result<(), InputError> {
    let length = design.planform.length_mm.value();
    for (number, load) in design.load.iter().enumerate() {
        let key = format!("load[{number}]");
        if load.at_mm.value() > length {
            let message = format!("is off the wing, which ends at length_mm = {}", Number(length));
            let cure = format!("Give a place between 0 and {} mm", Number(length));
            return refuse(
                root,
                &format!("{key}.at_mm"),
                message,
                &["planform.length_mm"],
                cure,
            );
        }
        let zero = |vector: &[f64; 3]| vector.iter().all(|part| *part == 0.0);
        // a mass of 0 that is written down is the first of a row of weights
        let is_written = KeyPath::parse(&format!("{key}.mass_kg")).is_ok_and(|path| root.at(&path).is_some());
        let loads_nothing = zero(&load.force_n) && zero(&load.moment_n_m) && load.mass_kg.value() == 0.0;
        if loads_nothing && !is_written {
            let cure = "Give force_n, moment_n_m or mass_kg, or delete the table";
            return refuse(root, &key, "loads nothing", &[], cure);
        }
    }
    Ok(())
}
