//! docs/reference/design.md and docs/reference/video.md: every key of a design file and of a video file.

use super::tables::file_tables;
use crate::input::schema::{design_schema, video_schema};

const DESIGN: &str = "\
# Design files

Every key of a design, from the types in `crates/washout-design/src/input/design`; written by `washout schema --pages docs/reference`, and a test
compares. `washout schema` prints the same as a JSON schema, for editors. `washout init my-wing` writes a commented design to
start from.

Units are in the names of the keys. Unknown keys are refused. A *number* stands either as a fact or, where it is not known, as an
assumption with its range and a reason:

```toml
frequency_hz = 23.0
half_amplitude_deg = { assumed = 34.5, range = [24.0, 45.0], why = \"not stated\" }
```

Every output lists what was assumed, and `--uncertainty` says how far it moves the result. Any key can be changed for one run:
`--set flapping.frequency_hz=25`, `--set 'rod[0].section.diameter_mm=0.9'`.
";

const VIDEO: &str = "\
# Video files

Every key of the file that [`washout measure`](../from-video-to-twist.md) takes, from the types in `crates/washout-design/src/input/video`; written by
`washout schema --pages docs/reference`, and a test compares.
";

/// The page of design files.
pub fn design_page() -> String {
    format!("{DESIGN}{}", file_tables(&design_schema().to_value()))
}

/// The page of video files.
pub fn video_page() -> String {
    format!("{VIDEO}{}", file_tables(&video_schema().to_value()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_table_and_every_key_of_a_design_stands_with_its_words_and_range() {
        let page = design_page();
        for wanted in [
            "## `[flapping]`",
            "## `[[rod]]`",
            "## `[material.NAME]`",
            "| `frequency_hz` | number | needed | The flapping frequency. From 0.1 to 1000.0. E.g. `23.0`. |",
            "**`shape = \"half-round\"`**",
            "`thin-airfoil` (Linear lift with a given slope, no drag)",
        ] {
            assert!(page.contains(wanted), "{wanted}\n{page}");
        }
        let schema = design_schema().to_value();
        for (name, table) in schema["$defs"].as_object().into_iter().flatten() {
            for key in table["properties"]
                .as_object()
                .into_iter()
                .flat_map(|all| all.keys())
            {
                let known = page.contains(&format!("| `{key}` |")) || name == "Assumed";
                assert!(known, "{name}.{key}");
            }
        }
    }
}
