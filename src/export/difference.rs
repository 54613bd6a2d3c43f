//! Two runs side by side: which inputs differ, and what that did to the results.

use std::collections::BTreeSet;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use serde_json::Value;

use super::summary::{ProfileRow, RunSummary};
use super::{ExportError, json};
use crate::page::text::{Table, number, significant};

/// What differs between two runs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct Difference {
    /// Names of the two wings.
    pub names: [String; 2],
    /// Versions of the program that wrote the runs.
    pub washout_versions: [String; 2],
    /// Inputs that differ.
    pub inputs: Vec<InputDifference>,
    /// Results that both runs have.
    pub results: Vec<ResultDifference>,
    /// Twist at the stations of the first run that the second one covers, interpolated between its stations.
    pub twist: Vec<TwistDifference>,
}

/// An input that differs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct InputDifference {
    /// Dotted path in the design.
    pub key: String,
    /// What stands in the first run; absent where the key is.
    pub first: Option<Value>,
    /// What stands in the second run.
    pub second: Option<Value>,
}

/// A result of both runs.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct ResultDifference {
    /// Name with unit.
    pub name: String,
    /// First run.
    pub first: f64,
    /// Second run.
    pub second: f64,
    /// Second minus first.
    pub change: f64,
}

/// Twist of both runs at one station.
#[derive(Debug, Clone, PartialEq, Serialize, Deserialize, JsonSchema)]
pub struct TwistDifference {
    /// Place along the span.
    pub r_mm: f64,
    /// First run.
    pub first_deg: f64,
    /// Second run.
    pub second_deg: f64,
    /// Second minus first.
    pub change_deg: f64,
}

/// Compares two runs.
pub fn difference(first: &RunSummary, second: &RunSummary) -> Result<Difference, ExportError> {
    let results = results(first).into_iter().filter_map(|(name, value)| {
        let other = results(second).into_iter().find(|(known, _)| *known == name)?.1;
        Some(ResultDifference {
            name: name.to_string(),
            first: value,
            second: other,
            change: other - value,
        })
    });
    let twist = first.profile.iter().filter_map(|row| {
        let second_deg = twist_at(&second.profile, row.r_mm)?;
        Some(TwistDifference {
            r_mm: row.r_mm,
            first_deg: row.twist_deg,
            second_deg,
            change_deg: second_deg - row.twist_deg,
        })
    });
    Ok(Difference {
        names: [first.name.clone(), second.name.clone()],
        washout_versions: [first, second].map(|run| run.made_of.washout_version.clone()),
        inputs: inputs(first, second)?,
        results: results.collect(),
        twist: twist.collect(),
    })
}

impl Difference {
    /// As a page of text.
    pub fn page(&self) -> String {
        let [first, second] = &self.names;
        let mut sections = vec![format!("{first} → {second}\n")];
        let [old, new] = &self.washout_versions;
        if old != new {
            sections.push(format!("Written by washout {old} and {new}\n"));
        }
        if self.inputs.is_empty() {
            sections.push("No input differs\n".to_string());
        } else {
            let mut table = Table::new(["input", "first", "second"]);
            for input in &self.inputs {
                table.row([input.key.clone(), shown(&input.first), shown(&input.second)]);
            }
            sections.push(format!("Inputs that differ\n{}", table.render()));
        }
        let mut table = Table::new(["result", "first", "second", "change"]);
        for result in &self.results {
            let change = significant(result.change, 3);
            let [first, second] = [result.first, result.second].map(|value| significant(value, 5));
            table.row([result.name.clone(), first, second, change]);
        }
        sections.push(format!("Results\n{}", table.render()));
        let mut table = Table::new(["r_mm", "first_deg", "second_deg", "change_deg"]);
        for row in &self.twist {
            let angles = [row.first_deg, row.second_deg, row.change_deg].map(|angle| number(angle, 3));
            let [first, second, change] = angles;
            table.row([number(row.r_mm, 2), first, second, change]);
        }
        if !table.is_empty() {
            sections.push(format!("Twist\n{}", table.render()));
        }
        sections.join("\n")
    }
}

fn shown(value: &Option<Value>) -> String {
    match value {
        None => "absent".to_string(),
        Some(Value::String(text)) => text.clone(),
        Some(Value::Object(assumed)) => match (assumed.get("assumed"), assumed.get("range")) {
            (Some(value), Some(range)) => format!("{value} assumed in {range}"),
            _ => Value::Object(assumed.clone()).to_string(),
        },
        Some(value) => value.to_string(),
    }
}

fn results(run: &RunSummary) -> Vec<(&'static str, f64)> {
    let tip = &run.tip;
    let solved = run.lift.as_ref().map(|lift| &lift.solved);
    let mean = run.lift.as_ref().and_then(|lift| lift.stroke_mean.as_ref());
    let engineering = &run.engineering;
    let rows = [
        ("tip twist_deg", tip.twist_deg),
        (
            "tip displacement_mm",
            Some(tip.displacement_mm.iter().map(|u| u * u).sum::<f64>().sqrt()),
        ),
        ("lift_mn", solved.map(|row| row.lift_mn)),
        ("drag_mn", solved.map(|row| row.drag_mn)),
        ("power_mw", solved.map(|row| row.power_mw)),
        ("stroke mean lift_mn", mean.map(|row| row.lift_mn)),
        ("stroke mean drag_mn", mean.map(|row| row.drag_mn)),
        ("stroke mean power_mw", mean.map(|row| row.power_mw)),
        ("mass_mg", engineering.mass_mg),
        (
            "lowest natural frequency_hz",
            engineering.natural_frequencies_hz.first().copied(),
        ),
    ];
    rows.into_iter()
        .filter_map(|(name, value)| Some((name, value?)))
        .collect()
}

/// Linear between the stations; none beyond them.
fn twist_at(profile: &[ProfileRow], r_mm: f64) -> Option<f64> {
    if let Some(row) = profile.iter().find(|row| row.r_mm == r_mm) {
        return Some(row.twist_deg);
    }
    let pair = profile
        .windows(2)
        .find(|pair| pair[0].r_mm < r_mm && r_mm < pair[1].r_mm)?;
    let share = (r_mm - pair[0].r_mm) / (pair[1].r_mm - pair[0].r_mm);
    Some(pair[0].twist_deg + share * (pair[1].twist_deg - pair[0].twist_deg))
}

fn inputs(first: &RunSummary, second: &RunSummary) -> Result<Vec<InputDifference>, ExportError> {
    let flat = |run: &RunSummary| -> Result<Vec<(String, Value)>, ExportError> {
        let value = json::tree(&run.design)?;
        let mut leaves = Vec::new();
        flatten("", value, &mut leaves);
        Ok(leaves)
    };
    let (first, second) = (flat(first)?, flat(second)?);
    let find = |leaves: &[(String, Value)], key: &str| {
        let found = leaves.iter().find(|(known, _)| known == key);
        found.map(|(_, value)| value.clone())
    };
    let mut seen = BTreeSet::new();
    let keys = first
        .iter()
        .chain(&second)
        .map(|(key, _)| key)
        .filter(|key| seen.insert(*key));
    let differences = keys.filter_map(|key| {
        let (first, second) = (find(&first, key), find(&second, key));
        let key = key.clone();
        (first != second).then_some(InputDifference { key, first, second })
    });
    Ok(differences.collect())
}

/// The leaves of a document with their dotted paths, such as `rod[0].section.diameter_mm`.
fn flatten(path: &str, value: Value, leaves: &mut Vec<(String, Value)>) {
    match value {
        // An assumed number is one value; why it is assumed changes no result.
        Value::Object(mut entries) if entries.contains_key("assumed") => {
            entries.remove("why");
            leaves.push((path.to_string(), Value::Object(entries)));
        }
        Value::Object(entries) if !entries.is_empty() => {
            for (key, value) in entries {
                let path = if path.is_empty() {
                    key
                } else {
                    format!("{path}.{key}")
                };
                flatten(&path, value, leaves);
            }
        }
        // Short lists of numbers, such as ranges and vectors, are one value to a reader.
        Value::Array(items) if items.iter().any(Value::is_object) => {
            for (index, value) in items.into_iter().enumerate() {
                flatten(&format!("{path}[{index}]"), value, leaves);
            }
        }
        leaf => leaves.push((path.to_string(), leaf)),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn row(r_mm: f64, twist_deg: f64) -> ProfileRow {
        ProfileRow {
            place: "station".to_string(),
            r_mm,
            chord_mm: 20.0,
            twist_deg,
            sigma_deg: None,
            bound: crate::input::measurement::Bound::None,
            alpha_deg: None,
            le_deflection_mm: 0.0,
            le_sweep_mm: 0.0,
        }
    }

    #[test]
    fn twist_is_read_between_stations_and_never_beyond() {
        let profile = [row(10.0, 1.0), row(20.0, 3.0)];
        assert_eq!(twist_at(&profile, 15.0), Some(2.0));
        assert_eq!(twist_at(&profile, 20.0), Some(3.0));
        assert_eq!(twist_at(&profile, 20.5), None);
        assert_eq!(twist_at(&[], 20.5), None);
    }

    #[test]
    fn leaves_carry_the_dotted_path_of_the_design() {
        let value = serde_json::json!({
            "rod": [{"section": {"diameter_mm": {"assumed": 1.0, "range": [0.9, 1.1], "why": "so"}}}],
            "force_n": [0.0, 1.0],
        });
        let mut leaves = Vec::new();
        flatten("", value, &mut leaves);
        let paths: Vec<_> = leaves.iter().map(|(path, _)| path.as_str()).collect();
        assert_eq!(paths, ["rod[0].section.diameter_mm", "force_n"]);
        assert_eq!(shown(&Some(leaves[0].1.clone())), "1.0 assumed in [0.9,1.1]");
    }
}
