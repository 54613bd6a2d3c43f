//! Every input of a design with those marked that are assumed, and every number of a document.

use serde_json::Value;

use crate::input::assumption::Assumption;

use super::document::{Document, Shown};
use super::table::{HtmlTable, folded};

/// Every input of the design at a place of a document, those marked that are assumed.
pub fn inputs(document: &Document, design: &str) -> String {
    let mut all = HtmlTable::new(&["input", "value", "", "why"]);
    let value = document.value.pointer(design).unwrap_or(&Value::Null);
    each(value, String::new(), design, &mut |key, place, value| {
        let Some(entries) = value
            .as_object()
            .filter(|entries| entries.contains_key("assumed"))
        else {
            all.row(vec![Shown::text(key), shown(document, place, value)]);
            return;
        };
        let chosen = shown(document, &format!("{place}/assumed"), &entries["assumed"]);
        let why = Shown::text(entries.get("why").and_then(Value::as_str).unwrap_or_default());
        all.marked(
            "assumed",
            vec![Shown::text(key), chosen, Shown::text("assumed"), why],
        );
    });
    format!(
        "<p>Marked ◆: assumed, not known.</p>\n{}",
        all.folded(0, "All inputs")
    )
}

/// What is assumed in the designs of a study.
pub fn assumptions(designs: &[(String, Vec<Assumption>)]) -> String {
    let mut table = HtmlTable::new(&["design", "assumed input", "value", "from", "to", "why"]);
    for (design, assumed) in designs {
        for input in assumed {
            let [value, low, high] = [input.value, input.range[0], input.range[1]].map(|number| Shown {
                html: number.to_string(),
                is_number: true,
            });
            table.row(vec![
                Shown::text(design),
                Shown::text(&input.key),
                value,
                low,
                high,
                Shown::text(&input.why),
            ]);
        }
    }
    table.folded(30, "Assumed inputs of the designs")
}

/// Every number of a document, folded.
pub fn all_numbers(document: &Document) -> String {
    let mut table = HtmlTable::new(&["place", "value"]);
    each(&document.value, String::new(), "", &mut |key, place, value| {
        let is_assumed = value.as_object().is_some();
        if !is_assumed {
            table.row(vec![Shown::text(key), shown(document, place, value)]);
        }
    });
    folded(
        &format!("Everything in {}.json ({} entries)", document.id, table.len()),
        &table.html(),
    )
}

/// Visits every value that is no table, every list of plain values and every assumed input, with its dotted key and its place.
fn each(value: &Value, key: String, place: &str, visit: &mut dyn FnMut(&str, &str, &Value)) {
    let is_plain = |value: &Value| !value.is_object() && !value.is_array();
    match value {
        Value::Null => {}
        Value::Object(entries) if !entries.contains_key("assumed") => {
            for (name, value) in entries {
                let key = if key.is_empty() {
                    name.clone()
                } else {
                    format!("{key}.{name}")
                };
                let place = format!("{place}/{}", name.replace('~', "~0").replace('/', "~1"));
                each(value, key, &place, visit);
            }
        }
        Value::Array(items) if !items.iter().all(is_plain) => {
            for (index, value) in items.iter().enumerate() {
                each(
                    value,
                    format!("{key}[{index}]"),
                    &format!("{place}/{index}"),
                    visit,
                );
            }
        }
        value => visit(&key, place, value),
    }
}

/// A value as it stands: a number with its place, a list entry by entry.
fn shown(document: &Document, place: &str, value: &Value) -> Shown {
    match value {
        Value::Number(_) => document.exact(place),
        Value::String(text) => Shown::text(text),
        Value::Array(items) => {
            let entries = items.iter().enumerate();
            let entries =
                entries.map(|(index, item)| shown(document, &format!("{place}/{index}"), item).html);
            Shown {
                html: entries.collect::<Vec<_>>().join(", "),
                is_number: false,
            }
        }
        other => Shown::text(other.to_string()),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use serde_json::json;

    #[test]
    fn assumed_inputs_are_marked_with_value_and_reason() {
        let design = json!({
            "name": "w<i>",
            "air": {"density_kg_m3": {"assumed": 1.2, "range": [1.15, 1.23], "why": "room & air"}},
            "rod": [{"from_mm": 0.0, "section": {"diameter_mm": 1.0}}],
            "outline": [[0.0, 20.0], [70.0, 10.0]],
        });
        let document = Document::of("summary", json!({ "design": design }));
        let html = inputs(&document, "/design");
        for words in [
            "◆",
            "air.density_kg_m3",
            "data-of=\"/design/air/density_kg_m3/assumed\">1.2<",
            "room &amp; air",
            "rod[0].section.diameter_mm",
            "data-of=\"/design/outline/1/0\">70.0<",
            "w&lt;i&gt;",
        ] {
            assert!(html.contains(words), "{words:?} is not in\n{html}");
        }
    }

    #[test]
    fn every_number_of_a_document_appears() {
        let document = Document::of(
            "summary",
            json!({"a": {"b": [1.5, 2.5]}, "c": [{"d": -3}], "e": null}),
        );
        let html = all_numbers(&document);
        for number in [">1.5<", ">2.5<", ">-3<"] {
            assert!(html.contains(number), "{html}");
        }
    }
}
