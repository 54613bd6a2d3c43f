//! What a JSON schema says of a key, in words for the tables of the reference.

use std::fmt::Write;

use serde_json::Value;

/// Words that are listed with what each means; of more than these only the words stand.
const EXPLAINED_WORDS: usize = 6;

/// What a definition is named for that is a number, or an assumed one.
const QUANTITY: &str = "Quantity";

/// Description, words, range and example of a key.
pub fn words(property: &Value, schema: &Value) -> String {
    let mut text = description(property);
    let choices = choices(property, schema);
    if !choices.is_empty() {
        let _ = write!(text, " One of {}.", choices.join(", "));
    }
    if let (Some(low), Some(high)) = (bound(property, "minimum"), bound(property, "maximum")) {
        let _ = write!(text, " From {low} to {high}.");
    }
    if let Some(example) = property["examples"].get(0) {
        let _ = write!(text, " E.g. `{}`.", shown(example));
    }
    text.replace('|', "\\|")
}

/// The description of a key or table, on one line; links into the code become plain code.
pub fn description(value: &Value) -> String {
    let text = value["description"].as_str().unwrap_or_default();
    text.split_whitespace()
        .collect::<Vec<_>>()
        .join(" ")
        .replace("[`", "`")
        .replace("`]", "`")
}

/// `needed`, or the value where the key is left out.
pub fn default(key: &str, table: &Value) -> String {
    let required = table["required"].as_array().into_iter().flatten();
    let mut required = required.filter_map(Value::as_str);
    match (
        required.any(|name| name == key),
        &table["properties"][key]["default"],
    ) {
        (true, _) => "needed".to_string(),
        (false, Value::Number(number)) => number.to_string(),
        (false, Value::String(word)) => format!("\"{word}\""),
        (false, Value::Array(items)) if !items.is_empty() => shown(&Value::Array(items.clone())),
        (false, _) => String::new(),
    }
}

/// What kind of value a key has: `number`, `list of text`, …; tables by `link` of their definition's name.
pub fn kind(property: &Value, schema: &Value, link: &dyn Fn(&str) -> String) -> String {
    if let Some(name) = reference(property) {
        let defined = &schema["$defs"][name];
        return match () {
            () if name == QUANTITY => "number".to_string(),
            () if is_word(defined) => "word".to_string(),
            () => link(name),
        };
    }
    if let Some(either) = property["anyOf"].as_array() {
        let kinds: Vec<String> = either.iter().map(|one| kind(one, schema, link)).collect();
        return kinds.join(" or ");
    }
    let plain = |word: &str| {
        match word {
            "string" => "text",
            "boolean" => "true or false",
            "integer" => "whole number",
            "object" => "table",
            "array" => "list",
            other => other,
        }
        .to_string()
    };
    match &property["type"] {
        Value::String(word) if word == "array" => {
            let items = kind(&property["items"], schema, link);
            match (property["minItems"].as_u64(), property["maxItems"].as_u64()) {
                (Some(least), Some(most)) if least == most => format!("{least} × {items}"),
                _ => format!("list of {items}"),
            }
        }
        Value::String(word) if word == "object" && property["additionalProperties"].is_object() => {
            let inner = &property["additionalProperties"];
            format!("named {}", kind(inner, schema, link))
        }
        Value::String(word) => plain(word),
        Value::Array(either) => {
            let words: Vec<String> = either.iter().filter_map(Value::as_str).map(plain).collect();
            words.join(" or ")
        }
        _ => "anything".to_string(),
    }
}

/// The definition that a value names.
pub fn reference(value: &Value) -> Option<&str> {
    value["$ref"].as_str()?.rsplit('/').next()
}

/// Whether a definition is one of several words.
pub fn is_word(defined: &Value) -> bool {
    let variants = defined["oneOf"].as_array();
    defined["enum"].is_array() || variants.is_some_and(|all| all.iter().all(|one| one["const"].is_string()))
}

/// A value as TOML has it.
pub fn shown(value: &Value) -> String {
    match value {
        Value::Object(entries) => {
            let entries: Vec<String> = entries
                .iter()
                .map(|(key, value)| format!("{key} = {}", shown(value)))
                .collect();
            format!("{{ {} }}", entries.join(", "))
        }
        Value::Array(items) => {
            let items: Vec<String> = items.iter().map(shown).collect();
            format!("[{}]", items.join(", "))
        }
        other => other.to_string(),
    }
}

fn bound(property: &Value, name: &str) -> Option<String> {
    let own = property.get(name).or_else(|| property["items"].get(name))?;
    Some(own.to_string())
}

/// The words that a key may have, itself or in its list; few of them with what each means.
fn choices(value: &Value, schema: &Value) -> Vec<String> {
    match value {
        Value::Object(entries) => {
            if let Some(name) = reference(value) {
                let defined = &schema["$defs"][name];
                return if is_word(defined) {
                    listed(defined)
                } else {
                    Vec::new()
                };
            }
            let inside = ["items", "anyOf"].into_iter().filter_map(|key| entries.get(key));
            inside.flat_map(|inner| choices(inner, schema)).collect()
        }
        Value::Array(items) => items.iter().flat_map(|inner| choices(inner, schema)).collect(),
        _ => Vec::new(),
    }
}

fn listed(defined: &Value) -> Vec<String> {
    let named = defined["enum"].as_array().into_iter().flatten();
    let plain = named.filter_map(Value::as_str).map(|word| format!("`{word}`"));
    let variants: Vec<&Value> = defined["oneOf"].as_array().into_iter().flatten().collect();
    let explained = variants.iter().filter_map(|one| {
        let word = one["const"].as_str()?;
        let meaning = description(one);
        let meaning = meaning.trim_end_matches('.');
        Some(match variants.len() <= EXPLAINED_WORDS && !meaning.is_empty() {
            true => format!("`{word}` ({meaning})"),
            false => format!("`{word}`"),
        })
    });
    plain.chain(explained).collect()
}
