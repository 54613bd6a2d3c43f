//! Measurement files, written as they are read.

use crate::input::design::Instrument;
use crate::input::measurement::{Bound, COLUMNS, OPTIONAL_COLUMNS, Row, SigmaKind};

use super::ExportError;

/// The text of a measurement file: `comments` at its head, then the rows; values of rows that are yet to be measured stand
/// empty.
///
/// # Errors
/// If the table cannot be put into words.
pub fn measurement_csv(comments: &[String], rows: &[Row]) -> Result<String, ExportError> {
    let has_place = rows
        .iter()
        .any(|row| row.chord_fraction.is_some_and(|place| place != 0.0));
    let columns = COLUMNS
        .iter()
        .chain(OPTIONAL_COLUMNS.iter().filter(|_| has_place));
    let head: Vec<&str> = columns.copied().collect();
    let mut lines: Vec<Vec<String>> = Vec::new();
    for row in rows {
        let number = |number: Option<f64>| number.map_or(String::new(), |number| number.to_string());
        let mut line = vec![
            row.case.clone(),
            row.channel.name().to_string(),
            row.instrument.map_or("", Instrument::name).to_string(),
            row.channel.unit().to_string(),
            if row.channel.is_twist() { "washout" } else { "" }.to_string(),
            row.run.clone(),
            number(row.r_mm),
            number(row.r_to_mm),
            number((!row.is_planned).then_some(row.value)),
            row.sigma.to_string(),
            match row.sigma_kind {
                SigmaKind::Stated => "stated",
                SigmaKind::Repeats => "repeats",
                SigmaKind::Assumed => "assumed",
            }
            .to_string(),
            match row.bound {
                Bound::None => "none",
                Bound::Upper => "upper",
                Bound::Lower => "lower",
            }
            .to_string(),
        ];
        if has_place {
            line.push(number(row.chord_fraction));
        }
        lines.push(line);
    }
    let above: String = comments.iter().map(|comment| format!("# {comment}\n")).collect();
    let table = super::csv::table(&head, &lines)?;
    Ok(above + &String::from_utf8_lossy(&table))
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::measurement::Measurement;

    #[test]
    fn what_is_written_is_read_as_it_was() {
        let text = "# source: a bench\ncase,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound,\
                    chord_fraction\n\
                    \"a, b\",twist,camera,deg,nose_up,1,50,,-4.5,0.5,stated,lower,\n\
                    a,twist_rate,camera,deg/mm,washout,,0,48,,0.04,assumed,none,\n\
                    a,deflection,,mm,,,30,,1.25,0.1,repeats,none,0.5\n\
                    a,lift,,mN,,,,,25.125,0.05,assumed,none,\n";
        let read = Measurement::from_csv(text, "m.csv").unwrap();
        let written = measurement_csv(&read.comments, &read.rows).unwrap();
        assert_eq!(Measurement::from_csv(&written, "m.csv").unwrap(), read);
        assert!(read.rows[1].is_planned && !read.rows[0].is_planned);
    }
}
