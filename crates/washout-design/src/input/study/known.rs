//! Names in a study that must be those of something in its cases: designs, runs, inputs.

use serde_json::Value;

use super::Study;
use crate::input::check::refuse;
use crate::input::design::Design;
use crate::input::document::Node;
use crate::input::error::InputError;
use crate::input::measurement::Row;
use crate::input::nearest::nearest;

/// Refuses rulers of which no run is that of a reading of their channel; some may belong to cases that were taken out.
pub(super) fn known_runs<'a>(
    study: &Study,
    root: &Node,
    rows: impl Iterator<Item = &'a Row> + Clone,
) -> Result<(), InputError> {
    for (k, ruler) in study.ruler.iter().enumerate() {
        let mut known: Vec<&str> = rows
            .clone()
            .filter(|row| row.channel == ruler.channel)
            .map(|row| row.run.as_str())
            .collect();
        known.sort_unstable();
        known.dedup();
        let runs = ruler.runs.as_deref().unwrap_or_default();
        if !runs.is_empty() && !runs.iter().any(|run| known.contains(&run.as_str())) {
            let key = format!("ruler[{k}].runs");
            let message = format!("no reading of {} has such a run", ruler.channel.name());
            let cure = match known.iter().all(|own| own.is_empty()) {
                true => "Its readings name no runs: leave this out".to_string(),
                false => format!("The runs are {}", known.join(", ")),
            };
            return refuse(root, &key, message, &["channel"], cure);
        }
    }
    Ok(())
}

/// Refuses names of designs that no case has.
pub(super) fn known_designs(study: &Study, root: &Node, of_cases: &[&Design]) -> Result<(), InputError> {
    let named = study
        .uncertain
        .iter()
        .enumerate()
        .map(|(k, u)| (format!("uncertain[{k}].designs"), &u.designs));
    let effects = study
        .effect
        .iter()
        .enumerate()
        .map(|(k, e)| (format!("effect[{k}].designs"), &e.designs));
    let candidates = [("candidates_on".to_string(), &study.candidates_on)];
    for (key, designs) in named.chain(effects).chain(candidates) {
        for name in designs.iter().flatten() {
            if !of_cases.iter().any(|design| design.name == *name) {
                let mut known: Vec<&str> = of_cases.iter().map(|design| design.name.as_str()).collect();
                known.dedup();
                let cure = format!("The cases have the designs {}", known.join(", "));
                return refuse(
                    root,
                    &key,
                    format!("no case has a design {name}"),
                    &["case"],
                    cure,
                );
            }
        }
    }
    Ok(())
}

/// Refuses uncertain inputs that are a number of no design. Numbers of effects are left to those who know them: a study adds some.
pub(super) fn known_inputs(study: &Study, root: &Node, of_cases: &[&Design]) -> Result<(), InputError> {
    for (index, uncertain) in study.uncertain.iter().enumerate() {
        let is_meant = |design: &&&Design| {
            let designs = uncertain.designs.as_ref();
            designs.is_none_or(|designs| designs.contains(&design.name))
        };
        let mut meant = of_cases.iter().filter(is_meant);
        let is_known = meant.any(|design| design.get(&uncertain.key).is_some());
        if is_known || uncertain.key.starts_with("effects.") {
            continue;
        }
        let meant = of_cases.iter().filter(is_meant);
        let known: Vec<String> = meant.flat_map(|design| keys_of_numbers(design)).collect();
        let cure = match nearest(&uncertain.key, known.iter().map(String::as_str)) {
            Some(near) => format!("Did you mean {near}?"),
            None => "Give the dotted key of a number, such as material.carbon-rod.g_gpa".to_string(),
        };
        let key = format!("uncertain[{index}].key");
        return refuse(
            root,
            &key,
            "no design of the study has a number there",
            &["case"],
            cure,
        );
    }
    Ok(())
}

/// Dotted keys of all numbers of a design.
fn keys_of_numbers(design: &Design) -> Vec<String> {
    let mut keys = Vec::new();
    let tree = serde_json::to_value(design).unwrap_or_default();
    collect_keys("", &tree, &mut keys);
    keys
}

fn collect_keys(at: &str, value: &Value, keys: &mut Vec<String>) {
    match value {
        Value::Number(_) => keys.push(at.to_string()),
        Value::Object(table) if table.contains_key("assumed") => keys.push(at.to_string()),
        Value::Object(table) => {
            for (key, value) in table {
                let below = if at.is_empty() {
                    key.clone()
                } else {
                    format!("{at}.{key}")
                };
                collect_keys(&below, value, keys);
            }
        }
        Value::Array(list) => {
            for (index, value) in list.iter().enumerate() {
                collect_keys(&format!("{at}[{index}]"), value, keys);
            }
        }
        _ => {}
    }
}
