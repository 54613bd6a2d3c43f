//! A table of readings in words: what was understood of it, and the study that it makes.

use std::path::Path;

use super::ExportError;
use super::measurement::measurement_csv;
use crate::input::measurement::{Channel, Row};
use crate::input::seen_from;
use crate::input::sheet::study::Names;
use crate::input::sheet::{DesignReadings, Sheet};
use crate::page::text::{Table, significant, wrapped};

/// The files of a study that was made of a table.
pub struct Files {
    /// The study.
    pub study: String,
    /// Its measurement file.
    pub readings: String,
}

/// What is said of a table without doubts.
const WELL: &str = "Nothing in the table looks wrong.\n";

/// What was understood, what is assumed and what looks wrong, before anything is solved.
pub fn understood(sheet: &Sheet) -> String {
    let mut text = format!("What {} says\n", sheet.measurement.file);
    let pairs = |heads: [&'static str; 2], rows: &[[String; 2]]| {
        let mut table = Table::new(heads);
        rows.iter().for_each(|row| table.row(row.clone()));
        table.render()
    };
    text += &pairs(["column", "is"], &sheet.understood);
    text += &format!("\n{}", conditions(sheet));
    if !sheet.assumed.is_empty() {
        text += "\nNot in the table, so taken to be\n";
        text += &pairs(["what", "is"], &sheet.assumed);
    }
    if sheet.doubts.is_empty() {
        text += &format!("\n{WELL}");
    }
    for doubt in &sheet.doubts {
        text += &format!("\n{}", wrapped(&format!("Check: {doubt}"), 0));
    }
    text
}

/// The same in a few lines where nothing looks wrong: its conditions, and what it says nothing of.
pub fn understood_briefly(sheet: &Sheet) -> String {
    if !sheet.doubts.is_empty() {
        return understood(sheet);
    }
    let kind = sheet.understood.iter().find(|[what, _]| what == "file");
    let kind = kind.map_or(String::new(), |[_, is]| format!(" ({is})"));
    let mut text = format!(
        "What {} says{kind}\n{}",
        sheet.measurement.file,
        conditions(sheet)
    );
    if !sheet.assumed.is_empty() {
        let taken: Vec<String> = sheet
            .assumed
            .iter()
            .map(|[what, is]| format!("{what}: {is}"))
            .collect();
        let taken = format!("Not in it, so taken to be: {}.", taken.join("; "));
        text += &wrapped(&taken, 0);
    }
    text + WELL
}

/// Its conditions, a line each.
fn conditions(sheet: &Sheet) -> String {
    let mut cases = Table::new(["condition", "sets", "readings", "stations mm", "values"]);
    for family in &sheet.families {
        for case in &family.cases {
            let rows = sheet.measurement.rows.iter().filter(|row| row.case == *case);
            let rows: Vec<_> = rows.collect();
            cases.row([
                case.clone(),
                family
                    .set
                    .iter()
                    .filter_map(|set| Some(set.split_once('=')?.0))
                    .collect::<Vec<_>>()
                    .join(", "),
                rows.len().to_string(),
                ends(rows.iter().filter_map(|row| row.r_mm)),
                values(&rows),
            ]);
        }
    }
    cases.render()
}

/// The smallest and the largest of some numbers.
fn ends(values: impl Iterator<Item = f64>) -> String {
    let ends = values.fold(None, |ends: Option<[f64; 2]>, value| {
        let [least, most] = ends.unwrap_or([value, value]);
        Some([least.min(value), most.max(value)])
    });
    ends.map_or(String::new(), |[least, most]| {
        format!("{} … {}", significant(least, 4), significant(most, 4))
    })
}

/// The same of each channel, with its unit.
fn values(rows: &[&Row]) -> String {
    let mut channels: Vec<Channel> = Vec::new();
    for row in rows {
        if !channels.contains(&row.channel) {
            channels.push(row.channel);
        }
    }
    let of = |channel: &Channel| {
        let own = rows.iter().filter(|row| row.channel == *channel);
        format!("{} {}", ends(own.map(|row| row.value)), channel.unit())
    };
    channels.iter().map(of).collect::<Vec<_>>().join("; ")
}

/// The texts of the study and of its measurement file, for a study of this name in this folder.
///
/// # Errors
/// If the readings cannot be put into words.
pub fn files(of: &DesignReadings, name: &str, folder: &Path) -> Result<Files, ExportError> {
    let study = of.text(Names {
        study: name,
        design: &seen_from(&folder.join(name), &of.design).display().to_string(),
        readings: &format!("{name}-measured.csv"),
    });
    let table = &of.sheet.measurement;
    let mut comments = vec![format!("source: {}", table.file)];
    comments.extend(table.comments.iter().cloned());
    let readings = measurement_csv(&comments, &table.rows)?;
    Ok(Files { study, readings })
}

/// The command that writes the study.
pub fn to_keep(of: &DesignReadings) -> String {
    let sigma = of.sigma.to_string();
    let sigma = match sigma.contains(' ') {
        _ if sigma.is_empty() => sigma,
        true => format!(" --sigma \"{sigma}\""),
        false => format!(" --sigma {sigma}"),
    };
    let held: Vec<String> = of
        .held_out
        .iter()
        .map(|case| format!(" --hold-out {case}"))
        .collect();
    format!(
        "washout init {} --study --design {} --readings {}{sigma}{}",
        of.name(),
        of.design.display(),
        of.table.display(),
        held.concat()
    )
}
