//! A page as text for a terminal.

use super::table::UNKNOWN;
use super::text::{self, wrapped};
use super::{Cell, Fact, Page, Part, Row, Section, Table};

/// Spaces before what stands in a section.
const INDENT: usize = 2;

impl Page {
    /// The page as text; figures are left out.
    pub fn text(&self) -> String {
        let lead: String = self.lead.iter().map(|part| part.text(0)).collect();
        let mut blocks = vec![format!("{}\n\n{lead}", self.title)];
        blocks.extend(self.sections.iter().filter_map(Section::text));
        blocks.join("\n")
    }
}

impl Section {
    fn text(&self) -> Option<String> {
        let parts: String = self.parts.iter().map(|part| part.text(INDENT)).collect();
        (!parts.is_empty()).then(|| format!("{}\n{parts}", self.title))
    }
}

impl Part {
    fn text(&self, indent: usize) -> String {
        let all = |lines: &[String]| lines.iter().map(|line| wrapped(line, indent)).collect();
        match self {
            Part::Headline(facts) => facts.iter().filter_map(|fact| fact.text(indent)).collect(),
            Part::Sentence(words) | Part::Text(words) | Part::Subtitle(words) => wrapped(words, indent),
            Part::List(lines) => all(lines),
            Part::Notes(lines) => lines
                .iter()
                .map(|line| wrapped(&format!("Note: {line}"), indent))
                .collect(),
            Part::Named(entries) => {
                let line = |(name, words): &(&str, String)| format!("{:indent$}{name:<12}{words}\n", "");
                entries.iter().map(line).collect()
            }
            Part::Code(code) => code.lines().map(|line| format!("  {line}\n")).collect(),
            Part::Table(table) => table.text(indent),
            Part::Figure(_) | Part::Folded(..) => String::new(),
        }
    }
}

impl Fact {
    fn text(&self, indent: usize) -> Option<String> {
        let number = self.digits.show(self.value?);
        Some(wrapped(
            &format!("{}: {number} {}", self.label, self.unit),
            indent,
        ))
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
        for row in self.rows.iter().take(self.most_in_text) {
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
