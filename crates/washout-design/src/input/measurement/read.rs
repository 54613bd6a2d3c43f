//! Reads measurement files.

use std::collections::HashMap;
use std::path::Path;

use super::row::{identity, read_row};
use super::{COLUMNS, Made, Measurement, OPTIONAL_COLUMNS, Row, STATION_COLUMNS, refuse_planned};
use crate::input::design::Design;
use crate::input::error::InputError;
use crate::input::file;
use crate::input::table::Table;

impl Measurement {
    /// Whether a file has the header of a measurement file; a table of readings of another form is a sheet.
    pub fn is_file(path: &Path) -> bool {
        let Ok(text) = file::read_text(path, "measurement file") else {
            return false;
        };
        let is_said = |line: &&str| !line.trim().is_empty() && !line.trim_start().starts_with('#');
        let head = text.lines().find(is_said).unwrap_or_default();
        head.split(',').any(|column| column.trim() == "channel")
    }

    /// Reads a measurement file with all its cases.
    ///
    /// # Example
    /// ```
    /// # use washout_design as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use std::path::Path;
    /// use washout::input::measurement::Measurement;
    ///
    /// let measurement = Measurement::load(Path::new("measurements/three-rods.csv"))?;
    /// assert!(measurement.cases().len() > 1);
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn load(path: &Path) -> Result<Measurement, InputError> {
        let (text, input) = file::read_input(path, "measurement file")?;
        let measurement = Measurement::from_csv(&text, &file::shown(path))?;
        Ok(Measurement {
            input: Some(input),
            ..measurement
        })
    }

    /// Reads the rows that belong to a design: of the case it names under `measured`, of the case with its
    /// name, or of the only case; their stations must lie on the wing.
    pub fn load_for(path: &Path, design: &Design) -> Result<Measurement, InputError> {
        let all = Measurement::load(path)?;
        let cases = all.cases();
        let named = design.measured.as_ref().map(|measured| measured.case.as_str());
        let wanted = named
            .into_iter()
            .chain([design.name.as_str()])
            .find(|name| cases.contains(name));
        let case = match (wanted, &cases[..]) {
            (Some(case), _) => case.to_string(),
            (None, [only]) => only.to_string(),
            (None, _) => {
                let message = format!(
                    "has no case for the design {}, only {}",
                    design.name,
                    cases.join(", ")
                );
                let cure = "Name the case in the design: [measured] case = \"...\"";
                return Err(InputError::about_file(&all.file, message, cure));
            }
        };
        let rows = all.case(&case);
        rows.check_stations(design, STATION_COLUMNS)?;
        refuse_planned(&all.file, &rows.rows)?;
        Ok(rows)
    }

    /// Reads a measurement from its text.
    pub fn from_csv(text: &str, file_name: &str) -> Result<Measurement, InputError> {
        let table = Table::parse(file_name, text, &COLUMNS, &OPTIONAL_COLUMNS);
        // a column that every measurement file has, and no other table
        let is_own = text.contains("instrument");
        let table = table.map_err(|error| if is_own { error } else { other_form(error) })?;
        let mut rows: Vec<Row> = Vec::new();
        let mut seen = HashMap::new();
        for record in &table.records {
            let row = read_row(record)?;
            if let Some(first) = seen.insert(identity(&row), row.line) {
                let message = format!("repeats the row on line {first}");
                let cure = "Delete one of them, or tell repeats apart in the column run";
                return Err(record.conflict(
                    "case",
                    message,
                    &["channel", "instrument", "run", "r_mm"],
                    cure,
                ));
            }
            rows.push(row);
        }
        Ok(Measurement {
            file: file_name.to_string(),
            input: None,
            comments: table.comments,
            made: Made::of_file(text, file_name)?,
            rows,
        })
    }
}

/// Says of a head that is not that of a measurement file which commands take tables of other forms.
fn other_form(error: InputError) -> InputError {
    if !error.key.starts_with("column") {
        return error;
    }
    let cure = format!(
        "{}. Tables of other forms: `washout diagnose DESIGN --with TABLE`, `washout init NAME --study --design DESIGN \
         --readings TABLE`",
        error.cure
    );
    InputError::new(
        error.place.clone(),
        &error.key,
        &error.value,
        error.problem.clone(),
        cure,
    )
}
