//! docs/reference/outputs.md: every JSON document that a verb prints.

use std::fmt::Write;

use serde_json::Value;

use super::key::{description, is_word, kind, words};
use super::tables::anchor;
use crate::input::schema::design_schema;

const HEAD: &str = "\
# Outputs

What a verb prints with `--json`, and writes as `summary.json` (`solve`, `lift`, `pareto`, `design`, `modes`, `sweep`),
`comparison.json`, `diagnosis.json`, `ladder.json`, `answer.json` or `verify.json`. From the types that are written; by `washout
schema --pages docs/reference`, and a test compares. `washout schema --output VERB` prints each as a JSON schema.

Units are in the names of the keys. A key whose kind ends with *or null* may be null or missing. Tables that several documents
share stand where they come first.
";

/// A document: what prints it, in words, and its schema.
#[derive(Debug)]
pub struct Document {
    /// E.g. `` `washout solve --json`, and `summary.json` ``.
    pub printed_by: String,
    /// The JSON schema.
    pub schema: Value,
}

/// The page over all these documents.
pub fn outputs_page(documents: &[Document]) -> String {
    let design = design_schema().to_value();
    let mut known: Vec<(String, Value, String)> = Vec::new();
    let mut text = HEAD.to_string();
    for document in documents {
        let schema = &document.schema;
        let mut fresh: Vec<(&String, String)> = Vec::new();
        for (name, table) in schema["$defs"].as_object().into_iter().flatten() {
            let is_of_designs = name == "Design" || design["$defs"].get(name).is_some();
            let is_known = known
                .iter()
                .any(|(other, same, _)| other == name && same == table);
            if is_of_designs || is_word(table) || is_known {
                continue;
            }
            let title = match known.iter().any(|(other, ..)| other == name) {
                false => name.clone(),
                true => format!("{name} of {}", schema["title"].as_str().unwrap_or_default()),
            };
            known.push((name.clone(), table.clone(), title.clone()));
            fresh.push((name, title));
        }
        let link = |name: &str| {
            let table = &schema["$defs"][name];
            let title = known
                .iter()
                .find(|(other, same, _)| other == name && same == table);
            match title {
                Some((_, _, title)) => format!("[{name}](#{})", anchor(title)),
                None => "[as in designs](design.md)".to_string(),
            }
        };
        let _ = write!(text, "\n## {}\n\n{}\n", document.printed_by, description(schema));
        if schema["items"].is_object() {
            let _ = write!(text, "\nA {}.\n", kind(schema, schema, &link));
        }
        text.push_str(&rows(schema, schema, &link));
        for (name, title) in fresh {
            let table = &schema["$defs"][name.as_str()];
            let _ = write!(text, "\n### {title}\n\n{}\n", description(table));
            text.push_str(&rows(table, schema, &link));
        }
    }
    text
}

/// The keys of a table; where it has several forms, those of each.
fn rows(table: &Value, schema: &Value, link: &dyn Fn(&str) -> String) -> String {
    let mut text = String::new();
    let forms = table["oneOf"].as_array().into_iter().flatten();
    for form in forms.clone().filter(|form| form["const"].is_string()) {
        let _ = write!(text, "\n- `{}`: {}", form["const"], description(form));
    }
    if !text.is_empty() {
        text.push('\n');
    }
    for form in std::iter::once(table).chain(forms) {
        let Some(keys) = form["properties"].as_object().filter(|keys| !keys.is_empty()) else {
            continue;
        };
        if form != table {
            let _ = write!(text, "\n{}\n", description(form));
        }
        text.push_str("\n| key | kind | what it is |\n|---|---|---|\n");
        let needed = form["required"].as_array();
        for (key, property) in keys {
            let is_needed = needed.is_some_and(|names| names.iter().any(|name| name == key));
            let (kind, what) = match property["const"].as_str() {
                Some(word) => (format!("`\"{word}\"`"), "Which of the forms this is.".to_string()),
                None => (kind(property, schema, link), words(property, schema)),
            };
            let missing = if is_needed || kind.ends_with("or null") {
                ""
            } else {
                " or null"
            };
            let _ = writeln!(text, "| `{key}` | {kind}{missing} | {what} |");
        }
    }
    text
}
