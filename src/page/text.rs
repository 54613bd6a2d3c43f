//! Aligned tables for people to read.

/// Characters in a line.
pub const WIDTH: usize = 80;
/// Spaces before each column.
const GAP: usize = 2;
/// Columns of words are not made narrower than this.
const LEAST: usize = 14;

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
    /// A column is set to the right when each of its cells below the head is a number or blank. A table wider than [`WIDTH`] breaks its
    /// heads, then its words; what is too wide still goes below, beside the first column once more.
    pub fn render(&self) -> String {
        let mut columns: Vec<Column> = (0..self.columns).map(|column| self.column(column)).collect();
        let width = |columns: &[Column]| columns.iter().map(|column| column.width + GAP).sum::<usize>();
        if width(&columns) > WIDTH {
            columns.iter_mut().for_each(Column::break_head);
        }
        while width(&columns) > WIDTH {
            let breakable = columns.iter_mut().filter(|column| column.may_break());
            let Some(widest) = breakable.max_by_key(|column| column.width) else {
                break;
            };
            let most = widest.width - 1;
            widest.break_at(most);
        }
        let mut text = String::new();
        let mut rest = &columns[..];
        while !rest.is_empty() {
            let mut count = rest.len();
            let first = &columns[..usize::from(rest.len() < columns.len())];
            while count > 1 && width(first) + width(&rest[..count]) > WIDTH {
                count -= 1;
            }
            let shown: Vec<&Column> = first.iter().chain(&rest[..count]).collect();
            text += &aligned(&shown);
            rest = &rest[count..];
        }
        text
    }

    fn column(&self, column: usize) -> Column {
        let cell = |row: &Vec<String>| vec![row.get(column).cloned().unwrap_or_default()];
        let cells: Vec<Vec<String>> = self.rows.iter().map(cell).collect();
        let is_right = cells[1..]
            .iter()
            .flatten()
            .all(|text| text.is_empty() || is_number(text));
        let mut column = Column {
            width: 0,
            is_right,
            cells,
        };
        column.measure();
        column
    }
}

/// A column of a table being laid out.
struct Column {
    width: usize,
    is_right: bool,
    /// Lines of each cell, the head first.
    cells: Vec<Vec<String>>,
}

impl Column {
    fn measure(&mut self) {
        let lines = self.cells.iter().flatten();
        self.width = lines.map(|line| line.chars().count()).max().unwrap_or(0);
    }

    /// Breaks the head into lines as wide as the widest cell below, or its longest word.
    fn break_head(&mut self) {
        let widest = |text: &str| text.chars().count();
        let below = self.cells[1..].iter().flatten().map(|line| widest(line)).max();
        let word = self.cells[0][0].split_whitespace().map(widest).max();
        let most = below.unwrap_or(0).max(word.unwrap_or(0));
        self.cells[0] = broken(&self.cells[0][0], most);
        self.measure();
    }

    fn may_break(&self) -> bool {
        !self.is_right
            && self.width > LEAST
            && self
                .cells
                .iter()
                .flatten()
                .any(|line| line.chars().count() == self.width && line.trim().contains(' '))
    }

    fn break_at(&mut self, most: usize) {
        for cell in &mut self.cells {
            *cell = broken(&cell.join(" "), most);
        }
        self.measure();
    }
}

/// Columns side by side.
fn aligned(columns: &[&Column]) -> String {
    let mut text = String::new();
    let rows = columns.first().map_or(0, |column| column.cells.len());
    for row in 0..rows {
        let height = columns
            .iter()
            .map(|column| column.cells[row].len())
            .max()
            .unwrap_or(0);
        for line in 0..height {
            let mut whole = String::new();
            for column in columns {
                let words = column.cells[row].get(line).map_or("", String::as_str);
                let fill = " ".repeat(column.width - words.chars().count());
                let [before, after] = match column.is_right {
                    true => [fill.as_str(), ""],
                    false => ["", fill.as_str()],
                };
                whole += &format!("{:GAP$}{before}{words}{after}", "");
            }
            text.push_str(whole.trim_end());
            text.push('\n');
        }
    }
    text
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

/// A sentence in lines of at most [`WIDTH`] characters, each indented by so many spaces.
pub fn wrapped(sentence: &str, indent: usize) -> String {
    hanging(&" ".repeat(indent), sentence, indent)
}

/// A sentence behind a beginning, in lines of at most [`WIDTH`] characters; lines after the first are indented by so many spaces.
pub fn hanging(beginning: &str, sentence: &str, indent: usize) -> String {
    let lines = broken(sentence, WIDTH.saturating_sub(indent));
    let text = format!("{beginning}{}", lines.join(&format!("\n{:indent$}", "")));
    text.trim_end().to_string() + "\n"
}

/// Words in lines of at most so many characters; a word that is longer stands alone. No words are one empty line.
fn broken(sentence: &str, most: usize) -> Vec<String> {
    let mut lines = vec![String::new()];
    for word in sentence.split_whitespace() {
        let last = lines.len() - 1;
        let line = &mut lines[last];
        if line.is_empty() {
            line.push_str(word);
        } else if line.chars().count() + 1 + word.chars().count() <= most {
            line.push(' ');
            line.push_str(word);
        } else {
            lines.push(word.to_string());
        }
    }
    lines
}

fn is_number(text: &str) -> bool {
    text.starts_with(|first: char| first.is_ascii_digit() || "+-−<>±".contains(first)) || text == "–"
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
    fn long_sentences_break_between_words_before_the_eightieth_character() {
        let text = wrapped(&"twenty characters on ".repeat(7), 2);
        let lines: Vec<&str> = text.lines().collect();
        assert_eq!(lines.len(), 2);
        assert!(
            lines
                .iter()
                .all(|line| line.starts_with("  ") && line.len() <= 80),
            "{text}"
        );
        assert_eq!(text.split_whitespace().count(), 21);
    }

    #[test]
    fn a_table_that_is_too_wide_breaks_its_heads_then_its_words_then_goes_below_beside_its_first_column() {
        let rendered = |heads: &[&str], cells: &[&str]| {
            let mut table = Table::new(heads.iter().copied());
            table.row(cells.iter().map(|cell| cell.to_string()));
            let text = table.render();
            assert!(text.lines().all(|line| line.chars().count() <= WIDTH), "{text}");
            text
        };
        let long = "lift per power in newtons per watt";
        let heads = rendered(&["wing", long, long, long], &["a", "1.0", "2.0", "3.0"]);
        assert_eq!(heads.lines().count(), 8, "{heads}");
        let words = "a reason that is told at some length, ".repeat(4);
        let broken = rendered(&["key", "why"], &["a", words.trim()]);
        assert_eq!(broken.lines().count(), 4, "{broken}");
        let wide = [
            "x",
            "1234567890123456789012345",
            "1234567890123456789012345",
            "1234567890123456789012345",
        ];
        let below = rendered(&["wing", "a", "b", "c"], &wide);
        assert_eq!(below.matches("wing").count(), 2, "{below}");
        assert_eq!(below.matches("12345678901234567890").count(), 3, "{below}");
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
