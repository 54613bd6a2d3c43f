//! What a person reads: a page of sentences, tables and figures, built once from an answer and laid out as text or HTML.

pub mod table;

pub mod text;

pub mod as_text;

pub mod screen;

use serde_json::Value;

use crate::plot::Figure;

pub use table::{Cell, Column, Digits, Row, Rows, Table};

/// An answer for people.
#[derive(Debug, Clone, Default)]
pub struct Page {
    /// What it is about: the name of a wing or study.
    pub title: String,
    /// What kind of document its numbers come from, which is also where they stand in a report: `diagnosis`.
    pub kind: &'static str,
    /// What stands above all sections.
    pub lead: Vec<Part>,
    /// What a terminal shows instead, unless all is asked for; of tables, lists and notes what has room. Empty where the page is short.
    pub brief: Vec<Part>,
    /// The sections, in order.
    pub sections: Vec<Section>,
}

/// A part of a page under a title of its own.
#[derive(Debug, Clone)]
pub struct Section {
    /// Where links lead to.
    pub id: &'static str,
    /// Its title.
    pub title: &'static str,
    /// What stands in it; where there is nothing, it is left out.
    pub parts: Vec<Part>,
}

/// Something that stands in a section.
#[derive(Debug, Clone)]
pub enum Part {
    /// The numbers above all, with their names; those that there are not are left out.
    Headline(Vec<Fact>),
    /// The answer in words.
    Sentence(String),
    /// A paragraph.
    Text(String),
    /// Lines of a list.
    List(Vec<String>),
    /// What a reader must keep in mind.
    Notes(Vec<String>),
    /// Names, and what each is in words and numbers.
    Named(Vec<Line>),
    /// A title within the section.
    Subtitle(String),
    /// Text of a file, as it is.
    Code(String),
    /// A table.
    Table(Table),
    /// A figure; not shown in text.
    Figure(Figure),
    /// A figure under a line that opens it; not shown in text.
    Folded(String, Figure),
}

/// A name and what it is, in words and numbers.
#[derive(Debug, Clone, Default)]
pub struct Line {
    /// The name; empty for one more line of the name before.
    pub name: &'static str,
    /// What it is.
    pub pieces: Vec<Piece>,
}

/// Words, or a number between words.
#[derive(Debug, Clone)]
pub enum Piece {
    /// Words, with the spaces around them.
    Words(String),
    /// A number: where it stands in the document (JSON pointer), its value, its digits.
    Number(String, f64, Digits),
}

impl Line {
    /// A line in which nothing stands yet.
    pub fn new(name: &'static str) -> Self {
        Line {
            name,
            pieces: Vec::new(),
        }
    }

    /// With words.
    pub fn words(mut self, words: impl Into<String>) -> Self {
        self.pieces.push(Piece::Words(words.into()));
        self
    }

    /// With a number.
    pub fn number(mut self, place: &str, value: f64, digits: Digits) -> Self {
        self.pieces.push(Piece::Number(place.to_string(), value, digits));
        self
    }

    /// What it is, as text.
    pub fn text(&self) -> String {
        let text = |piece: &Piece| match piece {
            Piece::Words(words) => words.clone(),
            Piece::Number(_, value, digits) => digits.show(*value),
        };
        self.pieces.iter().map(text).collect()
    }
}

/// A number with its name.
#[derive(Debug, Clone)]
pub struct Fact {
    /// Where it stands in the document: a JSON pointer.
    pub place: String,
    /// Its name.
    pub label: &'static str,
    /// The number; none if there is none.
    pub value: Option<f64>,
    /// Unit; empty for none.
    pub unit: &'static str,
    /// Digits that are shown.
    pub digits: Digits,
}

impl Page {
    /// Adds a section.
    pub fn section(&mut self, id: &'static str, title: &'static str, parts: Vec<Part>) {
        self.sections.push(Section { id, title, parts });
    }

    /// Numbers of the page that the document does not have where they are said to stand; a page without fault gives none.
    pub fn astray(&self, document: &Value) -> Vec<String> {
        let differs = |(place, value): &(String, f64)| {
            let found = document.pointer(place).and_then(Value::as_f64);
            found.map(f64::to_bits) != Some(value.to_bits())
        };
        let sections = self.sections.iter().flat_map(|section| &section.parts);
        let numbers = self
            .lead
            .iter()
            .chain(&self.brief)
            .chain(sections)
            .flat_map(Part::numbers);
        numbers.filter(differs).map(|(place, _)| place).collect()
    }
}

impl Part {
    /// All numbers in it, with where each stands.
    fn numbers(&self) -> Vec<(String, f64)> {
        match self {
            Part::Headline(facts) => {
                let known = |fact: &Fact| Some((fact.place.clone(), fact.value?));
                facts.iter().filter_map(known).collect()
            }
            Part::Table(table) => table.numbers(),
            Part::Named(lines) => {
                let pieces = lines.iter().flat_map(|line| &line.pieces);
                let number = |piece: &Piece| match piece {
                    Piece::Words(_) => None,
                    Piece::Number(place, value, _) => Some((place.clone(), *value)),
                };
                pieces.filter_map(number).collect()
            }
            _ => Vec::new(),
        }
    }
}
