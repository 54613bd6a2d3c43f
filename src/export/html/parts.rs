//! A page of an answer, laid out as sections of HTML.

use crate::export::ExportError;
use crate::page::table::UNKNOWN;
use crate::page::{Cell, Column, Line, Page as Answer, Part, Piece, Row, Table};
use crate::plot::pen::escaped;

use super::document::{Document, Shown};
use super::page::{Page, headline, mind};
use super::picture::picture;
use super::table::{HtmlTable, folded, list, paragraph};

impl Page {
    /// Adds what an answer says: its lead, its sections and the document that its numbers come from.
    ///
    /// # Errors
    /// If a number in a figure is not finite.
    pub fn add(&mut self, answer: &Answer, document: Document) -> Result<(), ExportError> {
        self.lead.push_str(&html(&answer.lead, &document)?);
        for section in &answer.sections {
            self.section(section.id, section.title, html(&section.parts, &document)?);
        }
        self.documents.push(document);
        Ok(())
    }
}

/// Parts of an answer as HTML; their numbers come from the document.
///
/// # Errors
/// If a number in a figure is not finite.
pub fn html(parts: &[Part], document: &Document) -> Result<String, ExportError> {
    parts.iter().map(|part| part_html(part, document)).collect()
}

fn part_html(part: &Part, document: &Document) -> Result<String, ExportError> {
    Ok(match part {
        Part::Headline(facts) => {
            let shown = facts.iter().filter(|fact| fact.value.is_some());
            let shown = shown.map(|fact| (fact.label, document.number(&fact.place, fact.digits), fact.unit));
            headline(&shown.collect::<Vec<_>>())
        }
        Part::Sentence(words) => format!("<p class=\"sentence\">{}</p>\n", escaped(words)),
        Part::Text(words) => paragraph(words),
        Part::List(lines) => list(lines),
        Part::Notes(lines) => mind(lines),
        Part::Named(lines) => named(lines, document),
        Part::Subtitle(words) => format!("<h3>{}</h3>\n", escaped(words)),
        Part::Code(code) => format!("<pre>{}</pre>\n", escaped(code)),
        Part::Table(table) => table_html(table, document),
        Part::Figure(figure) => picture(figure)?,
        Part::Folded(title, figure) => folded(title, &picture(figure)?),
    })
}

fn named(lines: &[Line], document: &Document) -> String {
    let mut table = HtmlTable::new(&["", "what"]);
    for line in lines {
        let piece = |piece: &Piece| match piece {
            Piece::Words(words) => escaped(words),
            Piece::Number(place, _, digits) => document.number(place, *digits).html,
        };
        let html = line.pieces.iter().map(piece).collect();
        let what = Shown {
            html,
            is_number: false,
        };
        table.row(vec![Shown::text(line.name), what]);
    }
    table.html()
}

fn table_html(table: &Table, document: &Document) -> String {
    let heads: Vec<String> = table.columns.iter().map(Column::head).collect();
    let heads: Vec<&str> = heads.iter().map(String::as_str).collect();
    let mut html = HtmlTable::new(&heads).caption(&table.caption);
    for row in &table.rows {
        let cells = table.columns.iter().zip(&row.cells);
        html.row(
            cells
                .map(|(column, cell)| shown(table, row, column, cell, document))
                .collect(),
        );
    }
    html.folded(table.most_open, table.title)
}

fn shown(table: &Table, row: &Row, column: &Column, cell: &Cell, document: &Document) -> Shown {
    match cell {
        Cell::Words(words) => Shown::text(words),
        Cell::Bounded(sign, _) => document
            .number(&table.place_of(row, column, 0), column.digits)
            .after(sign),
        cell if cell.is_blank() => Shown::default(),
        Cell::Numbers(numbers) => {
            let place = |item| table.place_of(row, column, item);
            let shown = |(item, value): (usize, &Option<f64>)| match value {
                Some(_) => document.number(&place(item), column.digits).html,
                None => UNKNOWN.to_string(),
            };
            let shown: Vec<String> = numbers.iter().enumerate().map(shown).collect();
            let shares = numbers.iter().flatten().filter(|_| column.is_share);
            Shown {
                html: shown.join(" / ") + &shares.map(|share| bar(*share)).collect::<String>(),
                is_number: true,
            }
        }
    }
}

/// A share of one as a bar below its number.
fn bar(share: f64) -> String {
    let percent = 100.0 * share.clamp(0.0, 1.0);
    format!(
        "<svg class=\"share\" viewBox=\"0 0 100 4\" preserveAspectRatio=\"none\" aria-hidden=\"true\"><rect \
         width=\"{percent:.1}\" height=\"4\"/></svg>"
    )
}
