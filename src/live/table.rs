//! A table of readings that is dropped on the page: what is understood of it, and the study that it makes of the design.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use crate::export::sheet::{files, understood};
use crate::input::measurement::Measurement;
use crate::input::seen_from;
use crate::input::sheet::{DesignReadings, Sigmas};

use super::opened::{Opened, Readings};
use super::refusal::Refusal;

/// Endings of tables that can be read.
const ENDINGS: [&str; 6] = ["csv", "tsv", "txt", "xlsx", "xls", "ods"];
/// Rows that are shown before it is confirmed.
const SHOWN: usize = 200;

/// A table that was read, and not yet taken.
pub struct Table {
    readings: DesignReadings,
    bytes: Vec<u8>,
}

impl Table {
    /// Reads a table by its name and bytes, measured on the design that is open.
    ///
    /// # Errors
    /// If it is a study that is open, or the table is not understood: with its place and what to write.
    pub fn read(opened: &Opened, name: &str, bytes: Vec<u8>) -> Result<Table, Refusal> {
        let name = checked(name)?;
        let folder = tempfile::tempdir().map_err(Refusal::new)?;
        let path = folder.path().join(name);
        std::fs::write(&path, &bytes).map_err(Refusal::new)?;
        let read = DesignReadings::load(&path, &opened.path, &Sigmas::default());
        let mut readings = read.map_err(|error| {
            // the table has no place but its name
            let from = folder.path().display().to_string();
            let mut refusal = Refusal::new(&error);
            refusal.message = refusal.message.replace(&format!("{from}/"), "");
            refusal
        })?;
        let place = folder_of(&opened.path).join(name);
        readings.sheet.measurement.file = place.display().to_string();
        readings.table = place;
        Ok(Table { readings, bytes })
    }

    /// What is understood of it, in words.
    pub fn understood(&self) -> String {
        understood(&self.readings.sheet)
    }

    /// Its readings, cell by cell; the first row says what they are.
    pub fn rows(&self) -> Vec<Vec<String>> {
        let head = ["condition", "quantity", "unit", "r mm", "value", "sigma"];
        let mut rows = vec![head.map(str::to_string).to_vec()];
        let number = |value: f64| format!("{value}");
        for row in self.readings.sheet.measurement.rows.iter().take(SHOWN) {
            rows.push(vec![
                row.case.clone(),
                row.channel.name().to_string(),
                row.channel.unit().to_string(),
                row.r_mm.map_or(String::new(), number),
                number(row.value),
                number(row.sigma),
            ]);
        }
        rows
    }

    /// The study that it makes, as `washout init` would write it beside the design.
    ///
    /// # Errors
    /// If its readings cannot be put into words.
    pub fn study(&self) -> Result<(PathBuf, String, Readings), Refusal> {
        let (name, folder) = (self.readings.name(), folder_of(&self.readings.design));
        let text = files(&self.readings, &name, &folder).map_err(Refusal::new)?.study;
        let measured = Measurement {
            file: format!("{name}-measured.csv"),
            ..self.readings.sheet.measurement.clone()
        };
        let readings = Readings {
            measured,
            design: self.readings.design.clone(),
            table: self.readings.table.clone(),
            bytes: Arc::from(self.bytes.as_slice()),
        };
        Ok((folder.join(format!("{name}.toml")), text, readings))
    }
}

/// The folder of a file as it was named.
fn folder_of(file: &Path) -> PathBuf {
    file.parent().unwrap_or(Path::new("")).to_path_buf()
}

/// A plain name of a table.
fn checked(name: &str) -> Result<&str, Refusal> {
    let is_plain = |c: char| c.is_alphanumeric() || " ._-()".contains(c);
    let ending = name
        .rsplit_once('.')
        .map(|(_, ending)| ending.to_ascii_lowercase());
    let is_table = ending.is_some_and(|ending| ENDINGS.contains(&ending.as_str()));
    match !name.starts_with('.') && name.len() <= 200 && name.chars().all(is_plain) && is_table {
        true => Ok(name),
        false => Err(Refusal::new(format!(
            "{name}: drop a table whose name ends in {}",
            ENDINGS.join(", ")
        ))),
    }
}

/// A design or a study that is dropped: it must stand beside the file that is open, as it is.
///
/// # Errors
/// If it does not.
pub fn beside(opened: &Opened, name: &str, text: &str) -> Result<PathBuf, Refusal> {
    let is_plain = |c: char| c.is_alphanumeric() || " ._-()".contains(c);
    if !name.ends_with(".toml") || name.starts_with('.') || !name.chars().all(is_plain) {
        return Err(Refusal::new(format!(
            "{name}: drop a design or a study, a .toml file"
        )));
    }
    let path = folder_of(&opened.path).join(name);
    let stands = std::fs::read_to_string(&path).ok();
    match stands.is_some_and(|own| own == text) {
        true => Ok(path),
        false => Err(Refusal::new(format!(
            "{} does not stand there as it was dropped, and what it names is looked for beside it; put it there first, or open it by: \
             washout live PATH",
            seen_from(Path::new(""), &path).display()
        ))),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_leads_nowhere() {
        for name in [
            "../a.csv",
            "/etc/passwd.csv",
            "a\\b.csv",
            ".csv",
            "a.toml",
            "a",
            "",
            "a\n.csv",
        ] {
            assert!(checked(name).is_err(), "{name:?}");
        }
        assert_eq!(checked("Messung (2) für v1.xlsx"), Ok("Messung (2) für v1.xlsx"));
    }
}
