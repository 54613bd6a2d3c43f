//! The JSON schema of design, study and materials files, generated from their types.

use std::collections::BTreeMap;

use schemars::{JsonSchema, Schema};
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::design::{Design, Material};
use super::study::Study;
use super::video::Video;

/// The JSON schema (draft 2020-12) of a design file; keys, ranges, examples, words and defaults.
///
/// Ranges of [`super::quantity::Quantity`] bind the number itself; of lists, each of their items.
pub fn design_schema() -> Schema {
    let mut schema = schemars::schema_for!(Design);
    schema
        .as_object_mut()
        .into_iter()
        .flat_map(|object| object.values_mut())
        .for_each(push_ranges_into_lists);
    schema
}

/// The JSON schema of a study file.
pub fn study_schema() -> Schema {
    let mut schema = schemars::schema_for!(Study);
    (schema.as_object_mut().into_iter())
        .flat_map(|object| object.values_mut())
        .for_each(push_ranges_into_lists);
    schema
}

/// The JSON schema of a video file.
pub fn video_schema() -> Schema {
    schemars::schema_for!(Video)
}

/// The JSON schema of a materials file.
pub fn materials_schema() -> Schema {
    schemars::schema_for!(MaterialsFile)
}

/// A file of materials, shared by designs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
#[serde(deny_unknown_fields)]
struct MaterialsFile {
    /// The version of the file format.
    #[schemars(extend("examples" = [1]))]
    format: u32,
    /// The materials by name, one `[material.NAME]` table each.
    material: BTreeMap<String, Material>,
}

/// A range given for a list means its items: JSON schema wants it there.
fn push_ranges_into_lists(value: &mut Value) {
    match value {
        Value::Object(object) => {
            if object
                .get("items")
                .is_some_and(|items| items.get("type") == Some(&Value::from("number")))
            {
                for bound in ["minimum", "maximum"] {
                    if let Some(limit) = object.shift_remove(bound)
                        && let Some(items) = object.get_mut("items").and_then(Value::as_object_mut)
                    {
                        items.insert(bound.to_string(), limit);
                    }
                }
            }
            object.values_mut().for_each(push_ranges_into_lists);
        }
        Value::Array(items) => items.iter_mut().for_each(push_ranges_into_lists),
        _ => {}
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn ranges_of_lists_bind_their_items() {
        let schema = design_schema().to_value();
        let force = &schema["$defs"]["BenchLoad"]["properties"]["force_n"];
        assert_eq!(force["items"]["maximum"], 1e6);
        assert_eq!(force.get("maximum"), None);
    }
}
