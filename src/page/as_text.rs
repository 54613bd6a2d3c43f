//! A page as text for a terminal.

use super::table::UNKNOWN;
use super::text::{self, WIDTH, hanging, wrapped};
use super::{Cell, Fact, Page, Part, Row, Section, Table};

/// Spaces before what stands in a section.
const INDENT: usize = 2;

/// Lines of a screen: a page with more has its answer at its end once more.
const LONG: usize = 30;
/// Spaces before what a line of names and words says.
const NAMED: usize = 12;

impl Page {
    /// All of the page as text; figures are left out. Where it is longer than a screen, the answer stands at the end once more.
    pub fn text(&self) -> String {
        let mut blocks = vec![self.head()];
        blocks.extend(self.sections.iter().filter_map(Section::text));
        let text = blocks.join("\n");
        match self.answer() {
            Some(answer) if text.lines().count() > LONG => format!("{text}\n{answer}"),
            _ => text,
        }
    }

    /// The answer as it stands in its texts.
    pub fn answer(&self) -> Option<String> {
        let is_answer = |part: &&Part| matches!(part, Part::Headline(_) | Part::Sentence(_));
        Some(self.lead.iter().find(is_answer)?.text(0))
    }

    fn head(&self) -> String {
        let lead: String = self.lead.iter().map(|part| part.text(0)).collect();
        match lead.as_str() {
            "" => format!("{}\n", self.title),
            lead => format!("{}\n\n{lead}", self.title),
        }
    }
}

impl Section {
    fn text(&self) -> Option<String> {
        let parts: String = self.parts.iter().map(|part| part.text(INDENT)).collect();
        (!parts.is_empty()).then(|| format!("{}\n{parts}", self.title))
    }
}

impl Part {
    pub(super) fn text(&self, indent: usize) -> String {
        let all = |lines: &[String]| lines.iter().map(|line| wrapped(line, indent)).collect();
        match self {
            Part::Headline(facts) => headline(facts, indent),
            Part::Sentence(words) | Part::Text(words) | Part::Subtitle(words) => wrapped(words, indent),
            Part::List(lines) => all(lines),
            Part::Notes(lines) => lines
                .iter()
                .map(|line| wrapped(&format!("Note: {line}"), indent))
                .collect(),
            Part::Named(lines) => lines
                .iter()
                .map(|line| match line.name.chars().count() < NAMED {
                    true => {
                        let name = format!("{:indent$}{:<NAMED$}", "", line.name);
                        hanging(&name, &line.text(), indent + NAMED)
                    }
                    false => {
                        let words = format!("{} {}", line.name, line.text());
                        hanging(&" ".repeat(indent), &words, indent + NAMED)
                    }
                })
                .collect(),
            Part::Code(code) => code.lines().map(|line| format!("  {line}\n")).collect(),
            Part::Table(table) => table.text(indent),
            Part::Figure(_) | Part::Folded(..) => String::new(),
        }
    }
}

/// Facts, two in a line where both fit.
fn headline(facts: &[Fact], indent: usize) -> String {
    let half = (WIDTH - indent) / 2;
    let (mut lines, mut open): (Vec<String>, bool) = (Vec::new(), false);
    for fact in facts.iter().filter_map(Fact::text) {
        let length = fact.chars().count();
        match lines.last_mut().filter(|_| open && length <= half) {
            Some(line) => {
                let fill = half.saturating_sub(line.chars().count());
                line.push_str(&" ".repeat(fill));
                line.push_str(&fact);
                open = false;
            }
            None => {
                open = length < half - 1;
                lines.push(fact);
            }
        }
    }
    let line = |line: &String| format!("{:indent$}{line}\n", "");
    lines.iter().map(line).collect()
}

impl Fact {
    fn text(&self) -> Option<String> {
        let number = self.digits.show(self.value?);
        let text = format!("{}: {number} {}", self.label, self.unit);
        Some(text.trim_end().to_string())
    }
}

impl Table {
    /// The table as text, its caption above.
    pub fn text(&self, indent: usize) -> String {
        if self.rows.is_empty() {
            return String::new();
        }
        let heads: Vec<String> = self.columns.iter().map(|column| column.head()).collect();
        let mut table = text::Table::new(heads.iter().map(String::as_str));
        for row in self.rows_in_text() {
            table.row(self.cells(row));
        }
        let caption = match self.caption.as_str() {
            "" => String::new(),
            caption => wrapped(caption, indent),
        };
        let more = match self.rows.len().saturating_sub(self.most_in_text) {
            0 => String::new(),
            more => format!("  … and {more} more (--json)\n"),
        };
        caption + &table.render() + &more
    }

    fn cells<'a>(&'a self, row: &'a Row) -> impl Iterator<Item = String> + 'a {
        let cells = self.columns.iter().zip(&row.cells);
        cells.map(|(column, cell)| match cell {
            Cell::Words(words) => words.clone(),
            Cell::Bounded(sign, value) => format!("{sign}{}", column.digits.show(*value)),
            cell if cell.is_blank() => String::new(),
            Cell::Numbers(numbers) => {
                let shown = numbers
                    .iter()
                    .map(|value| value.map_or(UNKNOWN.to_string(), |value| column.digits.show(value)));
                shown.collect::<Vec<_>>().join(" / ")
            }
        })
    }
}
