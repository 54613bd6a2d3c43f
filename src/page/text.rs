//! Aligned tables for people to read.

/// A table of text: a head, rows, numbers to the right and words to the left.
#[derive(Debug, Clone, Default)]
pub struct Table {
    rows: Vec<Vec<String>>,
    columns: usize,
}

impl Table {
    /// A table with these column heads.
    pub fn new<'a>(head: impl IntoIterator<Item = &'a str>) -> Self {
        let head: Vec<String> = head.into_iter().map(str::to_string).collect();
        Table {
            columns: head.len(),
            rows: vec![head],
        }
    }

    /// Adds a row; cells that are missing stay blank, cells beyond the head are left out.
    pub fn row(&mut self, cells: impl IntoIterator<Item = String>) {
        self.rows.push(cells.into_iter().take(self.columns).collect());
    }

    /// Whether there is no row besides the head.
    pub fn is_empty(&self) -> bool {
        self.rows.len() < 2
    }

    /// The lines, each indented by two spaces and ended by a line feed.
    ///
    /// A column is set to the right when each of its cells below the head is a number or blank.
    pub fn render(&self) -> String {
        let cell = |row: &'_ [String], column: usize| row.get(column).cloned().unwrap_or_default();
        let columns: Vec<(usize, bool)> = (0..self.columns)
            .map(|column| {
                let cells: Vec<String> = self.rows.iter().map(|row| cell(row, column)).collect();
                let width = cells.iter().map(|text| text.chars().count()).max().unwrap_or(0);
                let right = cells
                    .iter()
                    .skip(1)
                    .all(|text| text.is_empty() || is_number(text));
                (width, right)
            })
            .collect();
        let mut text = String::new();
        for row in &self.rows {
            let mut line = String::new();
            for (column, &(width, right)) in columns.iter().enumerate() {
                let cell = cell(row, column);
                let fill = " ".repeat(width - cell.chars().count());
                let (before, after) = if right {
                    (fill, String::new())
                } else {
                    (String::new(), fill)
                };
                line.push_str("  ");
                line.push_str(&before);
                line.push_str(&cell);
                line.push_str(&after);
            }
            text.push_str(line.trim_end());
            text.push('\n');
        }
        text
    }
}

/// A number with `decimals` digits after the point; zero never carries a sign.
pub fn number(value: f64, decimals: usize) -> String {
    let text = format!("{value:.decimals$}");
    let is_zero = text
        .trim_start_matches('-')
        .chars()
        .all(|digit| digit == '0' || digit == '.');
    if is_zero {
        text.trim_start_matches('-').to_string()
    } else {
        text
    }
}

/// A number with so many significant digits, in plain notation between 1e-4 and 1e6.
pub fn significant(value: f64, digits: usize) -> String {
    let magnitude = value.abs();
    if magnitude != 0.0 && !(1e-4..1e6).contains(&magnitude) {
        return format!("{value:.*e}", digits.saturating_sub(1));
    }
    let whole = if magnitude == 0.0 {
        1
    } else {
        magnitude.log10().floor() as i64 + 1
    };
    number(value, (digits as i64 - whole).max(0) as usize)
}

/// A sentence in lines of at most 100 characters, each indented by so many spaces.
pub fn wrapped(sentence: &str, indent: usize) -> String {
    let (mut text, mut width) = (String::new(), 0);
    for word in sentence.split_whitespace() {
        let length = word.chars().count();
        if width > 0 && width + 1 + length <= 100 {
            text.push(' ');
            width += 1 + length;
        } else {
            if width > 0 {
                text.push('\n');
            }
            text.push_str(&" ".repeat(indent));
            width = indent + length;
        }
        text.push_str(word);
    }
    text.push('\n');
    text
}

fn is_number(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_digit() || "+-−<>±".contains(first)) || text == "–"
}

/// A sentence with its first letter in upper case.
pub fn first_up(words: &str) -> String {
    let mut letters = words.chars();
    let first = letters
        .next()
        .map_or(String::new(), |letter| letter.to_uppercase().to_string());
    first + letters.as_str()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_stand_right_and_words_left() {
        let mut table = Table::new(["r_mm", "where"]);
        table.row(["2.0".into(), "base".into()]);
        table.row(["67.90".into(), "tip".into()]);
        assert_eq!(table.render(), "   r_mm  where\n    2.0  base\n  67.90  tip\n");
    }

    #[test]
    fn long_sentences_break_between_words_before_the_hundredth_character() {
        let text = wrapped(&"twenty characters on ".repeat(7), 2);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 2);
        assert!(
            lines
                .iter()
                .all(|line| line.starts_with("  ") && line.len() <= 100),
            "{text}"
        );
        assert_eq!(text.split_whitespace().count(), 21);
    }

    #[test]
    fn zero_carries_no_sign() {
        assert_eq!(number(-0.001, 2), "0.00");
        assert_eq!(number(-0.01, 2), "-0.01");
    }

    #[test]
    fn significant_digits_are_counted_from_the_first() {
        assert_eq!(significant(0.0123456, 3), "0.0123");
        assert_eq!(significant(1234.6, 3), "1235");
        assert_eq!(significant(0.0, 3), "0.00");
        assert_eq!(significant(2.5e-9, 3), "2.50e-9");
    }
}
