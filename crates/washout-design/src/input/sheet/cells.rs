//! The cells of a table as words, choices and numbers, with what is assumed where they are empty.

use super::grid::{Grid, Line};
use super::header::{Column, Role};
use crate::input::error::InputError;
use crate::input::nearest;

/// What reading gives.
pub type Checked<T> = Result<T, InputError>;

/// The cells of a table.
pub struct Cells<'a> {
    pub grid: &'a Grid,
    pub columns: &'a [Column],
    /// Name and value of what is assumed, each once.
    pub assumed: Vec<[String; 2]>,
    /// Where the first decimal comma and the first decimal point stand, and how many there are of each.
    marks: [Option<(usize, String, String)>; 2],
    counts: [usize; 2],
}

impl<'a> Cells<'a> {
    pub fn new(grid: &'a Grid, columns: &'a [Column]) -> Cells<'a> {
        Cells {
            grid,
            columns,
            assumed: Vec::new(),
            marks: [None, None],
            counts: [0, 0],
        }
    }

    /// A cell that cannot be what it is.
    pub fn refuse(&self, line: &Line, column: &Column, message: &str, cure: impl Into<String>) -> InputError {
        let cell = &line.cells[column.place];
        self.grid
            .fault(line.number, self.head(column), cell, message, cure.into())
    }

    /// Numbers with decimal comma beside numbers with decimal point.
    pub fn marks_differ(&self) -> Checked<()> {
        let [Some(comma), Some(point)] = &self.marks else {
            return Ok(());
        };
        // the rarer is the slip
        let commas = ("comma", comma, self.counts[0]);
        let points = ("point", point, self.counts[1]);
        let (few, many) = match self.counts[0] <= self.counts[1] {
            true => (commas, points),
            false => (points, commas),
        };
        let cure = format!(
            "Write all numbers alike, without marks for thousands; in a workbook make the cell a number, not text. With a decimal {}: \
             {}, first on line {}",
            many.0, many.2, many.1.0
        );
        let (line, column, value) = few.1;
        Err(self
            .grid
            .fault(*line, column, value, &format!("has a decimal {}", few.0), cure))
    }

    pub fn head(&self, column: &Column) -> &str {
        &self.grid.head.cells[column.place]
    }

    /// The cell of a column of a measurement file and that column, if the table has it and it is filled.
    pub fn word<'l>(&self, line: &'l Line, name: &str) -> Option<(&'l str, &'a Column)> {
        let column = self
            .columns
            .iter()
            .find(|column| column.role == Role::Word(known(name)))?;
        let cell = line.cells[column.place].as_str();
        (!cell.is_empty()).then_some((cell, column))
    }

    /// One of some words, or what is assumed.
    pub fn choice<T: Copy>(
        &mut self,
        line: &Line,
        name: &str,
        words: &[(&str, T)],
        usual: (T, &str),
    ) -> Checked<T> {
        let Some((cell, column)) = self.word(line, name) else {
            self.assume(name, usual.1);
            return Ok(usual.0);
        };
        let plain = cell.to_lowercase().replace([' ', '-'], "_");
        if let Some((_, value)) = words.iter().find(|(word, _)| *word == plain) {
            return Ok(*value);
        }
        let all: Vec<&str> = words.iter().map(|(word, _)| *word).collect();
        let near = nearest(&plain, all.iter().copied());
        let near = near.map_or(String::new(), |near| format!("Did you mean {near}? "));
        let cure = format!("{near}The words are {}", all.join(", "));
        Err(self.refuse(line, column, "is not known", cure))
    }

    pub fn assume(&mut self, name: &str, value: &str) {
        let pair = [name.to_string(), value.to_string()];
        if !value.is_empty() && !self.assumed.contains(&pair) {
            self.assumed.push(pair);
        }
    }

    /// A number, times the factor of its column; none if the cell is empty.
    pub fn number(&mut self, line: &Line, column: &Column) -> Checked<Option<f64>> {
        let cell = line.cells[column.place].as_str();
        if cell.is_empty() {
            return Ok(None);
        }
        let plain = cell.replace('−', "-");
        let (mark, text) = match (plain.contains('.'), plain.matches(',').count()) {
            (true, 0) => (Some(1), plain),
            (false, 1) => (Some(0), plain.replace(',', ".")),
            _ => (None, plain),
        };
        if let Some(mark) = mark {
            let place = (line.number, self.head(column).to_string(), cell.to_string());
            self.marks[mark].get_or_insert(place);
            self.counts[mark] += 1;
        }
        match text.parse::<f64>() {
            Ok(number) if number.is_finite() => Ok(Some(number * column.factor)),
            _ => {
                let cure =
                    "Give a number such as 12.4 or 12,4, and leave the cell empty where there is no reading";
                Err(self.refuse(line, column, "is no number", cure))
            }
        }
    }

    pub fn number_of(&mut self, line: &Line, is: impl Fn(&Role) -> bool) -> Checked<Option<f64>> {
        match self.columns.iter().find(|column| is(&column.role)) {
            Some(column) => self.number(line, column),
            None => Ok(None),
        }
    }
}

/// The name of a column of measurement files, as it stands in the roles.
fn known(name: &str) -> &'static str {
    let columns = crate::input::measurement::COLUMNS.iter();
    let mut columns = columns.chain(&crate::input::measurement::OPTIONAL_COLUMNS);
    columns
        .find(|column| **column == name)
        .copied()
        .unwrap_or_default()
}
