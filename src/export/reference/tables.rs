//! The tables of a TOML file as Markdown: every table under the name that it has in the file, from the schema of the file.

use std::collections::VecDeque;
use std::fmt::Write;

use serde_json::Value;

use super::key::{default, description, is_word, kind, reference, words};

/// Definitions that the head of a page explains.
const EXPLAINED: [&str; 2] = ["Quantity", "Assumed"];

/// Every table of a file with its keys.
pub fn file_tables(schema: &Value) -> String {
    let titles = titles(schema);
    let link = |name: &str| match titles.iter().find(|(known, _)| known == name) {
        Some((_, title)) => format!("[table](#{})", anchor(title)),
        None => "table".to_string(),
    };
    let mut text = section("The file", schema, schema, &link);
    for (name, title) in &titles {
        text.push_str(&section(title, &schema["$defs"][name.as_str()], schema, &link));
    }
    text
}

/// The definitions in the order of the file, each with its heading.
fn titles(schema: &Value) -> Vec<(String, String)> {
    let mut found: Vec<(String, String)> = Vec::new();
    let mut waiting: VecDeque<(Option<String>, &Value)> = VecDeque::from([(None, schema)]);
    while let Some((parent, table)) = waiting.pop_front() {
        for (key, property) in properties(table) {
            for (name, form) in tables_in(property, schema) {
                if EXPLAINED.contains(&name) || found.iter().any(|(known, _)| known == name) {
                    continue;
                }
                let title = match (&parent, form) {
                    (None, Form::Single) => format!("`[{key}]`"),
                    (None, Form::List) => format!("`[[{key}]]`"),
                    (None, Form::Named) => format!("`[{key}.NAME]`"),
                    (Some(parent), _) => format!("`{key}` of {parent}"),
                };
                found.push((name.to_string(), title.clone()));
                waiting.push_back((Some(title), &schema["$defs"][name]));
            }
        }
    }
    found
}

#[derive(Clone, Copy)]
enum Form {
    Single,
    List,
    Named,
}

/// The keys of a table, or of all forms that it may have.
fn properties(table: &Value) -> Vec<(&String, &Value)> {
    let forms = table["oneOf"].as_array().into_iter().flatten();
    let all = std::iter::once(table).chain(forms);
    all.filter_map(|one| one["properties"].as_object())
        .flatten()
        .collect()
}

/// The tables that a key may hold.
fn tables_in<'a>(property: &'a Value, schema: &Value) -> Vec<(&'a str, Form)> {
    if let Some(name) = reference(property) {
        let is_table = !is_word(&schema["$defs"][name]);
        return is_table.then_some((name, Form::Single)).into_iter().collect();
    }
    let inner = |value: &'a Value, form: Form| -> Vec<(&'a str, Form)> {
        let tables = tables_in(value, schema).into_iter();
        tables.map(|(name, _)| (name, form)).collect()
    };
    let either = property["anyOf"].as_array().into_iter().flatten();
    let mut tables: Vec<(&str, Form)> = either.flat_map(|one| tables_in(one, schema)).collect();
    for (key, form) in [("items", Form::List), ("additionalProperties", Form::Named)] {
        if property[key].is_object() {
            tables.extend(inner(&property[key], form));
        }
    }
    tables
}

fn section(title: &str, table: &Value, schema: &Value, link: &dyn Fn(&str) -> String) -> String {
    let mut text = format!("\n## {title}\n\n{}\n", description(table));
    if table["properties"].is_object() {
        text.push_str(&rows(table, schema, link));
    }
    for form in table["oneOf"].as_array().into_iter().flatten() {
        let word = properties(form)
            .into_iter()
            .find_map(|(key, value)| Some((key, value["const"].as_str()?)));
        if let Some((key, word)) = word {
            let _ = write!(text, "\n**`{key} = \"{word}\"`**: {}\n", description(form));
            text.push_str(&rows(form, schema, link));
        }
    }
    text
}

fn rows(table: &Value, schema: &Value, link: &dyn Fn(&str) -> String) -> String {
    let mut text = String::from("\n| key | kind | default | what it is |\n|---|---|---|---|\n");
    for (key, property) in properties(table) {
        if property["const"].is_string() {
            continue;
        }
        let (kind, default) = (kind(property, schema, link), default(key, table));
        let kind = kind.trim_end_matches(" or null");
        let _ = writeln!(
            text,
            "| `{key}` | {kind} | {default} | {} |",
            words(property, schema)
        );
    }
    text
}

/// The anchor that a heading gets.
pub fn anchor(title: &str) -> String {
    let letters = title.to_lowercase();
    let kept = letters.chars().filter_map(|letter| match letter {
        ' ' => Some('-'),
        letter if letter.is_alphanumeric() || letter == '_' || letter == '-' => Some(letter),
        _ => None,
    });
    kept.collect()
}
