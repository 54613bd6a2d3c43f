//! docs/reference/measurement.md: the columns of a measurement file and its channels.

use std::fmt::Write;

use serde_json::Value;

use super::key::description;
use crate::input::measurement::{CHANNELS, COLUMN_WORDS, Channel, OPTIONAL_COLUMNS};

const HEAD: &str = "\
# Measurement files

A CSV table with one row a number, each with its standard deviation; lines that begin with `#` are comments. From the types in
`crates/washout-design/src/input/measurement`; written by `washout schema --pages docs/reference`, and a test compares. The files in `measurements/` are
examples, each with its source, and `washout init NAME --study` writes one to start from.

## Columns

| column | | what it is |
|---|---|---|
";

const CHANNELS_HEAD: &str = "
## Channels

| channel | unit | place | what it is |
|---|---|---|---|
";

/// The page of measurement files.
pub fn measurement_page() -> String {
    let mut text = HEAD.to_string();
    for (column, words) in COLUMN_WORDS {
        let need = if OPTIONAL_COLUMNS.contains(&column) {
            "may be left out"
        } else {
            ""
        };
        let _ = writeln!(text, "| `{column}` | {need} | {words} |");
    }
    text.push_str(CHANNELS_HEAD);
    let schema = schemars::schema_for!(Channel).to_value();
    for (name, channel) in CHANNELS {
        let place = match () {
            () if channel == Channel::TwistRate => "`r_mm` to `r_to_mm`",
            () if channel.has_station() => "`r_mm`",
            () => "the whole wing",
        };
        let meaning = of_word(&schema, name);
        let _ = writeln!(text, "| `{name}` | {} | {place} | {meaning} |", channel.unit());
    }
    text
}

fn of_word(schema: &Value, word: &str) -> String {
    let variants = schema["oneOf"].as_array().into_iter().flatten();
    let mut own = variants.filter(|one| one["const"] == word);
    own.next().map(description).unwrap_or_default()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn every_column_and_channel_stands_with_its_words() {
        let page = measurement_page();
        for row in page.lines().filter(|line| line.starts_with("| `")) {
            let words = row
                .trim_end_matches(" |")
                .rsplit(" | ")
                .next()
                .unwrap_or_default();
            assert!(words.len() > 10, "{row}");
        }
        assert!(page.contains("| `twist_rate` | deg/mm | `r_mm` to `r_to_mm` | Mean twist rate"));
        assert!(page.contains("| `frequency` | Hz | the whole wing | Natural frequency"));
    }
}
