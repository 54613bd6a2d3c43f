//! Tables of a page: columns that know their unit and where their numbers come from.

use super::text::{number, significant};

/// What stands for a number of a list that is not known.
pub const UNKNOWN: &str = "–";

/// How many digits are shown.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Digits {
    /// So many after the point.
    After(usize),
    /// So many from the first that is not zero.
    Significant(usize),
    /// As many as tell it from every other number.
    All,
}

impl Digits {
    /// The number as text.
    pub fn show(self, value: f64) -> String {
        match self {
            Digits::After(digits) => number(value, digits),
            Digits::Significant(digits) => significant(value, digits),
            Digits::All => value.to_string(),
        }
    }
}

/// A column.
#[derive(Debug, Clone, PartialEq)]
pub struct Column {
    /// Where its numbers stand below the row in the document, a JSON pointer without its first stroke; `*` stands for the place in a
    /// list. With `{}` in it, where they stand below the table, `{}` for the key of the row. Empty for words.
    pub key: &'static str,
    /// What it is called.
    pub label: &'static str,
    /// Unit; empty for none.
    pub unit: &'static str,
    /// Digits that are shown.
    pub digits: Digits,
    /// Whether its numbers are shares of one, which a page draws as bars besides.
    pub is_share: bool,
}

/// What stands in a column of a row.
#[derive(Debug, Clone, PartialEq)]
pub enum Cell {
    /// Words; may be empty.
    Words(String),
    /// A number, or those of a list; of which any may not be known.
    Numbers(Vec<Option<f64>>),
    /// A number that may be a bound: the sign before it (`<`, `>` or nothing), and the number.
    Bounded(&'static str, f64),
}

/// A row.
#[derive(Debug, Clone, PartialEq)]
pub struct Row {
    /// Its place in the list of the document, or its name where the rows are entries of a table.
    pub key: String,
    /// What stands in it, one for each column.
    pub cells: Vec<Cell>,
}

/// A table.
#[derive(Debug, Clone, PartialEq)]
pub struct Table {
    /// What the columns mean, or what is compared; may be empty.
    pub caption: String,
    /// What its rows are called where it is folded.
    pub title: &'static str,
    /// Where the list of its rows stands in the document: a JSON pointer.
    pub place: String,
    /// Columns.
    pub columns: Vec<Column>,
    /// Rows.
    pub rows: Vec<Row>,
    /// Rows that text shows; how many more there are is said.
    pub most_in_text: usize,
    /// Whether its rows go along something, so that text shows the first and the last of more than it has room for, and those evenly between.
    pub is_along: bool,
    /// Rows up to which it lies open in HTML.
    pub most_open: usize,
}

/// A table in the making: what its rows are made of.
#[derive(Debug)]
pub struct Rows<'a, T> {
    rows: Vec<(&'a T, Row)>,
    table: Table,
}

impl<'a, T> Rows<'a, T> {
    /// A table with a row for each of a list; `place` is where the document has the list.
    pub fn of(place: &str, list: &'a [T]) -> Self {
        Rows::keyed(place, list.iter().enumerate())
    }

    /// A table with a row for each of these entries, by their keys below `place`.
    pub fn keyed<K: ToString>(place: &str, entries: impl IntoIterator<Item = (K, &'a T)>) -> Self {
        let empty = |key: K| Row {
            key: key.to_string(),
            cells: Vec::new(),
        };
        Rows {
            rows: entries
                .into_iter()
                .map(|(key, item)| (item, empty(key)))
                .collect(),
            table: Table {
                caption: String::new(),
                title: "All rows",
                place: place.to_string(),
                columns: Vec::new(),
                rows: Vec::new(),
                most_in_text: usize::MAX,
                is_along: false,
                most_open: usize::MAX,
            },
        }
    }

    /// With the rows in another order, the largest first.
    pub fn by(mut self, size: impl Fn(&T) -> f64) -> Self {
        self.rows.sort_by(|(a, _), (b, _)| size(b).total_cmp(&size(a)));
        self
    }

    /// With a column of words.
    pub fn words<S: Into<String>>(mut self, label: &'static str, of: impl Fn(&'a T) -> S) -> Self {
        self.add(["", label, ""], Digits::After(0), |row| {
            Cell::Words(of(row).into())
        });
        self
    }

    /// With a column of yes and no.
    pub fn yes_or_no(self, label: &'static str, of: impl Fn(&'a T) -> bool) -> Self {
        self.words(label, |row| if of(row) { "yes" } else { "no" })
    }

    /// With a column of numbers: its key, label and unit.
    pub fn number<N: Into<Option<f64>>>(
        mut self,
        head: [&'static str; 3],
        digits: Digits,
        of: impl Fn(&'a T) -> N,
    ) -> Self {
        self.add(head, digits, |row| Cell::Numbers(vec![of(row).into()]));
        self
    }

    /// With a column of shares of one.
    pub fn share(mut self, head: [&'static str; 3], digits: Digits, of: impl Fn(&'a T) -> f64) -> Self {
        self = self.number(head, digits, of);
        if let Some(column) = self.table.columns.last_mut() {
            column.is_share = true;
        }
        self
    }

    /// With a column of lists of numbers.
    pub fn numbers(
        mut self,
        head: [&'static str; 3],
        digits: Digits,
        of: impl Fn(&'a T) -> Vec<Option<f64>>,
    ) -> Self {
        self.add(head, digits, |row| Cell::Numbers(of(row)));
        self
    }

    /// With a column of numbers of which any may be a bound, with its sign.
    pub fn bounded(
        mut self,
        head: [&'static str; 3],
        digits: Digits,
        of: impl Fn(&'a T) -> (&'static str, f64),
    ) -> Self {
        self.add(head, digits, |row| {
            let (sign, value) = of(row);
            Cell::Bounded(sign, value)
        });
        self
    }

    /// With a caption.
    pub fn caption(mut self, text: &str) -> Self {
        self.table.caption = text.to_string();
        self
    }

    /// Text shows so many rows.
    pub fn most_in_text(mut self, rows: usize) -> Self {
        self.table.most_in_text = rows;
        self
    }

    /// Its rows go along the span, or along something else.
    pub fn along(mut self) -> Self {
        self.table.is_along = true;
        self
    }

    /// Folded under a title where there are more rows than so many.
    pub fn folded(mut self, above: usize, title: &'static str) -> Self {
        (self.table.most_open, self.table.title) = (above, title);
        self
    }

    /// The table. A column in which nothing stands is left out.
    pub fn table(mut self) -> Table {
        let stands = |column: usize| self.rows.iter().any(|(_, row)| !row.cells[column].is_blank());
        let kept: Vec<bool> = (0..self.table.columns.len()).map(stands).collect();
        self.table.rows = self.rows.into_iter().map(|(_, row)| row).collect();
        self.table.keep(&kept);
        self.table
    }

    fn add(&mut self, [key, label, unit]: [&'static str; 3], digits: Digits, of: impl Fn(&'a T) -> Cell) {
        self.table.columns.push(Column {
            key,
            label,
            unit,
            digits,
            is_share: false,
        });
        for (item, row) in &mut self.rows {
            row.cells.push(of(item));
        }
    }
}

impl Cell {
    /// Whether nothing stands there.
    pub fn is_blank(&self) -> bool {
        match self {
            Cell::Words(words) => words.is_empty(),
            Cell::Numbers(numbers) => numbers.iter().all(Option::is_none),
            Cell::Bounded(..) => false,
        }
    }
}

impl Column {
    /// Label with unit.
    pub fn head(&self) -> String {
        match self.unit {
            "" => self.label.to_string(),
            unit => format!("{} ({unit})", self.label),
        }
    }
}

impl Table {
    /// Where the document has a number: the one at `item` of the list in a column of a row.
    pub fn place_of(&self, row: &Row, column: &Column, item: usize) -> String {
        let key = column.key.replace('*', &item.to_string());
        match key.contains("{}") {
            true => format!("{}/{}", self.place, key.replace("{}", &row.key)),
            false => format!("{}/{}/{key}", self.place, row.key),
        }
    }

    /// The same without the columns of these keys or, where they hold words, labels.
    pub fn without(mut self, names: &[&str]) -> Table {
        let name = |column: &Column| match column.key {
            "" => column.label,
            key => key,
        };
        let kept: Vec<bool> = self
            .columns
            .iter()
            .map(|column| !names.contains(&name(column)))
            .collect();
        self.keep(&kept);
        self
    }

    /// The rows that text shows.
    pub fn rows_in_text(&self) -> Vec<&Row> {
        let (count, most) = (self.rows.len(), self.most_in_text);
        match self.is_along && most > 1 && count > most {
            true => (0..most)
                .map(|place| &self.rows[place * (count - 1) / (most - 1)])
                .collect(),
            false => self.rows.iter().take(most).collect(),
        }
    }

    /// Leaves out the columns that are not kept.
    fn keep(&mut self, kept: &[bool]) {
        let mut keep = kept.iter();
        self.columns.retain(|_| keep.next() == Some(&true));
        for row in &mut self.rows {
            let mut keep = kept.iter();
            row.cells.retain(|_| keep.next() == Some(&true));
        }
    }

    /// All numbers in it, with where each stands.
    pub(super) fn numbers(&self) -> Vec<(String, f64)> {
        let mut all = Vec::new();
        for row in &self.rows {
            for (column, cell) in self.columns.iter().zip(&row.cells) {
                let numbers: &[Option<f64>] = match cell {
                    Cell::Words(_) => &[],
                    Cell::Numbers(numbers) => numbers,
                    Cell::Bounded(_, value) => &[Some(*value)],
                };
                let known = numbers.iter().enumerate();
                let known = known.filter_map(|(item, value)| Some((item, (*value)?)));
                all.extend(known.map(|(item, value)| (self.place_of(row, column, item), value)));
            }
        }
        all
    }
}
