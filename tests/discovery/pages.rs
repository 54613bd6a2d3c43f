//! What a diagnosis says to people: every number of the page stands in the document, there where the page says.

use washout::diagnose::{Diagnosis, Verdict};
use washout::export::diagnosis::page;
use washout::export::json;
use washout::page::{Cell, Part};

use crate::lessons::{said, study};
use crate::truth::Hidden;

fn numbers(found: &Diagnosis) -> usize {
    let page = page("toy", found);
    let document = json::tree(found).expect("a document");
    assert_eq!(page.astray(&document), Vec::<String>::new());
    let parts = page.sections.iter().flat_map(|section| &section.parts);
    let cells = parts.flat_map(|part| match part {
        Part::Table(table) => table.rows.iter().flat_map(|row| row.cells.clone()).collect(),
        _ => Vec::new(),
    });
    let counts = cells.map(|cell| match cell {
        Cell::Numbers(numbers) => numbers.iter().flatten().count(),
        Cell::Bounded(..) => 1,
        Cell::Words(_) => 0,
    });
    counts.sum()
}

#[test]
fn every_number_of_a_page_stands_in_the_document_where_the_page_says() {
    let known = said(&study(vec![Hidden::Known("root_compliance", 110.0)], 2));
    assert_eq!(known.verdict, Verdict::Set);
    assert!(numbers(&known) > 100);
    let novel = said(&study(vec![Hidden::Bump(0.4, 1e-2, [1.0, 0.0])], 3));
    assert_eq!(novel.verdict, Verdict::Novel);
    assert!(numbers(&novel) > 100);
    let text = page("toy", &novel).text();
    assert!(text.contains("What is missing, along the span\n"), "{text}");
}

#[test]
fn a_number_that_the_document_does_not_have_is_astray() {
    let found = said(&study(Vec::new(), 2));
    let mut document = json::tree(&found).expect("a document");
    document["p_nothing"] = 0.123.into();
    // it stands among what fits on a screen, and in its section
    assert_eq!(page("toy", &found).astray(&document), ["/p_nothing"; 2]);
}
