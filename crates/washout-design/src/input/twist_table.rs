//! A twist profile as a CSV table: what a person measured, drew or took from another program.

use std::path::Path;

use super::error::{InputError, Range};
use super::file;
use super::table::{Record, Table};
use crate::origin::InputFile;

/// Twist along the span, at one phase of the stroke or at several.
#[derive(Debug, Clone, PartialEq)]
pub struct TwistTable {
    /// File that it came from, as the user named it.
    pub file: String,
    /// What the file is known by; none of a text.
    pub input: Option<InputFile>,
    /// Comment lines at the head of the file, without `#`.
    pub comments: Vec<String>,
    /// Profiles with the phase (deg, 0 is mid-stroke) at which each holds; a single one without phase is that of mid-stroke.
    pub profiles: Vec<(Option<f64>, Vec<[f64; 2]>)>,
}

impl TwistTable {
    /// Reads a table with the columns `r_mm` and `twist_deg` (washout), and `phase_deg` where it holds more than mid-stroke;
    /// rows by rising phase, and by rising r within one phase.
    ///
    /// # Errors
    /// If the file cannot be read, or a row is no number or out of order.
    pub fn load(path: &Path) -> Result<TwistTable, InputError> {
        let (text, input) = file::read_input(path, "twist profile")?;
        let table = TwistTable::from_csv(&file::shown(path), &text)?;
        Ok(TwistTable {
            input: Some(input),
            ..table
        })
    }

    /// The same from text.
    ///
    /// # Errors
    /// As [`TwistTable::load`].
    pub fn from_csv(file: &str, text: &str) -> Result<TwistTable, InputError> {
        let table = Table::parse(file, text, &["r_mm", "twist_deg"], &["phase_deg"])?;
        let mut profiles: Vec<(Option<f64>, Vec<[f64; 2]>)> = Vec::new();
        for record in &table.records {
            let ([r_mm, twist_deg], phase_deg) = read(record)?;
            match profiles.last_mut() {
                Some((phase, points)) if *phase == phase_deg => {
                    if points.last().is_some_and(|[last, _]| *last >= r_mm) {
                        let cure = "Sort the rows by r_mm, one row per station";
                        return Err(record.conflict(
                            "r_mm",
                            "must be larger than in the row before",
                            &[],
                            cure,
                        ));
                    }
                    points.push([r_mm, twist_deg]);
                }
                last => {
                    let is_out_of_order = match (last, phase_deg) {
                        (None, _) => false,
                        (Some((Some(before), _)), Some(now)) => *before >= now,
                        (Some(_), _) => true,
                    };
                    if is_out_of_order {
                        let cure = "Sort the rows by phase_deg, and give it in all rows or in none";
                        return Err(record.conflict(
                            "phase_deg",
                            "must not be below that of the row before",
                            &[],
                            cure,
                        ));
                    }
                    profiles.push((phase_deg, vec![[r_mm, twist_deg]]));
                }
            }
        }
        Ok(TwistTable {
            file: file.to_string(),
            input: None,
            comments: table.comments,
            profiles,
        })
    }
}

/// Station (mm) and twist (deg) of a row, and its phase (deg), if it has one.
fn read(record: &Record) -> Result<([f64; 2], Option<f64>), InputError> {
    let within = |low: f64, high: f64, unit: &'static str| Range {
        low,
        high,
        open: false,
        unit,
    };
    let r_mm = record.number_in("r_mm", within(0.0, 1e5, "mm"), "Give mm from the wing base")?;
    let twist_deg = record.number_in(
        "twist_deg",
        within(-180.0, 180.0, "deg"),
        "Give the washout in degrees",
    )?;
    let phase_deg = match record.text("phase_deg") {
        "" => None,
        _ => Some(record.number_in(
            "phase_deg",
            within(-90.0, 90.0, "deg"),
            "Give the stroke phase in degrees; 0 is mid-stroke",
        )?),
    };
    Ok(([r_mm, twist_deg], phase_deg))
}

#[cfg(test)]
mod tests {
    use super::TwistTable;

    #[test]
    fn a_profile_reads_in_millimetres_and_degrees_with_and_without_phases() {
        let plain =
            TwistTable::from_csv("p.csv", "# drawn\nr_mm,twist_deg\n0,0\n70,35.5\n").expect("a profile");
        assert_eq!(plain.profiles, [(None, vec![[0.0, 0.0], [70.0, 35.5]])]);
        assert_eq!(plain.comments, ["drawn"]);
        let phased = "phase_deg,r_mm,twist_deg\n0,0,0\n0,70,30\n45,0,0\n45,70,12\n";
        let phased = TwistTable::from_csv("p.csv", phased).expect("profiles");
        assert_eq!(phased.profiles.len(), 2);
        assert_eq!(phased.profiles[1], (Some(45.0), vec![[0.0, 0.0], [70.0, 12.0]]));
    }

    #[test]
    fn rows_out_of_order_and_no_numbers_are_refused_with_their_line() {
        for (text, said) in [
            ("r_mm,twist_deg\n0,0\n0,1\n", "p.csv:3: r_mm = 0: must be larger"),
            ("r_mm,twist_deg\n0,x\n", "p.csv:2: twist_deg"),
            ("r_mm,twist_deg\n0,nan\n", "p.csv:2: twist_deg"),
            (
                "r_mm,twist_deg,phase_deg\n0,0,40\n0,1,10\n",
                "p.csv:3: phase_deg = 10",
            ),
            ("r_mm,twist_deg,phase_deg\n0,0,40\n0,1,\n", "p.csv:3: phase_deg"),
            ("r_mm\n0\n", "p.csv:1"),
        ] {
            let error = TwistTable::from_csv("p.csv", text).expect_err(text).to_string();
            assert!(error.starts_with(said), "{error}");
        }
    }
}
