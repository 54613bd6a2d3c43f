//! Wings as calibrated on a study, as designs of their own.

use crate::input::Design;

/// The file of a wing as calibrated on a study, and its text.
pub fn file(study: &str, design: &Design) -> (String, String) {
    let name = &design.name;
    let text = format!(
        "# {name} as calibrated on {study}, with the effects of that study. Set its operating point to solve it at another one.\n{}",
        design.to_toml()
    );
    (format!("calibrated-{name}.toml"), text)
}
