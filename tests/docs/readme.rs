//! The README shows what the program prints: its blocks and its table of the three wings are computed again here.

use std::path::Path;
use std::process::Command;

use crate::text::{Shown, disagreement};
use crate::workshop::workshop;

/// Commands whose output the README shows, after `<!-- washout … -->`.
const MARK: &str = "<!-- washout ";

/// The table of the three wings.
const TABLE: &str = "<!-- three wings -->";

const WINGS: [&str; 3] = ["rigid", "twist-v1", "twist-v2"];

fn readme() -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("README.md");
    std::fs::read_to_string(path).expect("a README")
}

fn washout(folder: &Path, arguments: &[&str]) -> String {
    let output = Command::new(env!("CARGO_BIN_EXE_washout"))
        .current_dir(folder)
        .args(arguments)
        .output()
        .expect("the program starts");
    let error = String::from_utf8_lossy(&output.stderr).into_owned();
    assert!(output.status.success(), "{arguments:?}: {error}");
    String::from_utf8(output.stdout).expect("UTF-8")
}

#[test]
fn every_shown_output_is_what_the_command_prints() {
    let (readme, here) = (readme(), workshop());
    let blocks: Vec<Shown> = Shown::after(&readme, MARK);
    assert!(!blocks.is_empty(), "the README shows no output after {MARK}");
    for block in blocks {
        let arguments: Vec<&str> = block.command.split_whitespace().collect();
        let printed = washout(here.path(), &arguments);
        if let Some(difference) = disagreement(&block.text, &printed) {
            panic!("README, output of washout {}: {difference}", block.command);
        }
    }
}

#[test]
fn it_is_read_in_a_minute() {
    let size = readme().len();
    assert!(size <= 8000, "{size} bytes");
}

#[test]
fn the_table_of_the_three_wings_is_what_compare_finds() {
    let (readme, here) = (readme(), workshop());
    let rows: Vec<String> = WINGS.map(|wing| row(here.path(), wing)).to_vec();
    let after = readme.split_once(TABLE).expect("the table").1.trim_start();
    let shown: Vec<&str> = after.lines().skip(2).take(3).collect();
    for (row, shown) in rows.iter().zip(shown) {
        if let Some(difference) = disagreement(shown, row) {
            panic!(
                "README, three wings: {difference}\nthe rows are now\n{}",
                rows.join("\n")
            );
        }
    }
}

/// wing | last spar end, modelled | tip, measured | tip, modelled | stages, measured | modelled | RMS along the span
fn row(folder: &Path, wing: &str) -> String {
    let design = format!("designs/{wing}.toml");
    let document: serde_json::Value =
        serde_json::from_str(&washout(folder, &["compare", &design, "--json"])).expect("a document");
    let comparison = &document["comparison"];
    let number = |value: &serde_json::Value| value.as_f64().expect("a number");
    let span = &comparison["span"][0];
    let tip = span["stations"]
        .as_array()
        .and_then(|all| all.last())
        .expect("a tip");
    let bound = if tip["bound"] == "upper" { "< " } else { "" };
    let rates: Vec<[f64; 2]> = comparison["rows"]
        .as_array()
        .expect("rows")
        .iter()
        .filter(|row| row["channel"] == "twist_rate")
        .map(|row| [number(&row["measured"]), number(&row["modelled"])])
        .collect();
    let stages = |which: usize| {
        let all: Vec<String> = rates.iter().map(|rate| format!("{:.2}", rate[which])).collect();
        if all.is_empty() {
            "–".to_string()
        } else {
            all.join(", then ")
        }
    };
    format!(
        "| {wing} | {bound}{:.1}° | {:.1}° | {} | {} | {:.1}° |",
        number(&tip["measured_deg"]),
        number(&tip["modelled_deg"]),
        stages(0),
        stages(1),
        number(&span["rmse_along_span_deg"]),
    )
}
