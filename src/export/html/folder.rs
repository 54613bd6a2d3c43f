//! The report of any folder that has none of its own kind: what the verb said, its pictures, its tables, every number.

use crate::export::ExportError;
use crate::export::run::RunFolder;
use crate::page::Page as Answer;

use super::REPORT;
use super::document::{Document, Shown};
use super::inputs::all_numbers;
use super::page::Page;
use super::table::{HtmlTable, folded, paragraph};

/// Rows above which a table is folded.
const LONG: usize = 12;
/// Rows above which a table stays in its own file.
const TOO_LONG: usize = 1000;

/// What stands in the report of a folder.
#[derive(Debug)]
pub struct Contents<'a> {
    /// Its title.
    pub title: &'a str,
    /// What the verb says; none where that is not known.
    pub answer: Option<&'a Answer>,
    /// The document that lists the files.
    pub document: Document,
    /// The files of the folder; SVG and CSV among them are shown.
    pub files: &'a [String],
}

/// The report; `read` gives a file by its name.
///
/// # Errors
/// If a file cannot be read.
pub fn page(
    contents: Contents,
    read: &dyn Fn(&str) -> Result<Vec<u8>, ExportError>,
) -> Result<Page, ExportError> {
    let mut page = Page {
        title: contents.title.to_string(),
        ..Page::default()
    };
    let of_kind = |ending: &'static str| contents.files.iter().filter(move |file| file.ends_with(ending));
    let mut pictures = String::new();
    for file in of_kind(".svg") {
        let svg = String::from_utf8_lossy(&read(file)?).into_owned();
        // the head of an XML file has no place inside another
        let start = svg.find("<svg").unwrap_or(0);
        pictures.push_str(&format!(
            "<div class=\"picture\">{}</div>\n",
            svg[start..].trim_end()
        ));
    }
    let mut tables = String::new();
    for file in of_kind(".csv") {
        tables.push_str(&table(file, &read(file)?));
    }
    let data = all_numbers(&contents.document);
    match contents.answer {
        Some(answer) => {
            page.lead.push_str(&paragraph(&answer.title));
            page.add(answer, contents.document)?;
        }
        None => page.documents.push(contents.document),
    }
    page.section("pictures", "Pictures", pictures);
    page.section("tables", "Tables", tables);
    page.section("data", "Data", data);
    Ok(page)
}

/// Adds the report of what was added to a folder so far; `document` lists it among its files already.
///
/// # Errors
/// If a file cannot be read back, or the report not be written.
pub fn add(folder: &mut RunFolder, answer: &Answer, document: Document) -> Result<(), ExportError> {
    let (files, title) = (folder.listed(), title_of(folder.target()));
    let contents = Contents {
        title: &title,
        answer: Some(answer),
        document,
        files: &files,
    };
    let html = page(contents, &|name| folder.read(name))?.html();
    folder.add(REPORT, html.as_bytes())
}

/// What the report of a folder is called: as the folder.
pub fn title_of(folder: &std::path::Path) -> String {
    let name = folder.file_name().unwrap_or(folder.as_os_str());
    name.to_string_lossy().into_owned()
}

/// The rows of a CSV file under its name.
fn table(file: &str, bytes: &[u8]) -> String {
    let mut reader = csv::ReaderBuilder::new().flexible(true).from_reader(bytes);
    let head = reader.headers().cloned().unwrap_or_default();
    let head: Vec<&str> = head.iter().collect();
    let mut table = HtmlTable::new(&head);
    for record in reader.records().flatten() {
        let cells = record.iter().map(|cell| Shown {
            is_number: cell.parse::<f64>().is_ok(),
            ..Shown::text(cell)
        });
        table.row(cells.collect());
    }
    match table.len() {
        0 => String::new(),
        rows if rows > TOO_LONG => paragraph(&format!(
            "{file}: {rows} rows, too many for a page; they stand in the file."
        )),
        rows if rows > LONG => folded(&format!("{file} ({rows} rows)"), &table.html()),
        _ => table.caption(file).html(),
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::page::Part;

    #[test]
    fn pictures_stand_in_the_page_and_tables_keep_their_numbers() {
        let document = Document::of("summary", serde_json::json!({"lift_mn": 12.5}));
        let files = ["span.csv", "span.svg", "wing.vtu"].map(str::to_string);
        let answer = Answer {
            lead: vec![Part::Text("rigid <12.5> mN".to_string())],
            ..Answer::default()
        };
        let contents = Contents {
            title: "lift",
            answer: Some(&answer),
            document,
            files: &files,
        };
        let read = |name: &str| {
            Ok(match name {
                "span.csv" => b"r_mm,wing\n1.5,a\n2.5,b<\n".to_vec(),
                "span.svg" => b"<?xml version=\"1.0\"?>\n<svg id=\"x\"></svg>\n".to_vec(),
                other => unreachable!("{other} is not to be read"),
            })
        };
        let html = page(contents, &read).expect("page").html();
        for part in [
            "rigid &lt;12.5&gt; mN",
            "<div class=\"picture\"><svg id=\"x\"></svg></div>",
            "<td class=\"n\">1.5</td><td>a</td>",
            "<td>b&lt;</td>",
            "data-of=\"/lift_mn\"",
        ] {
            assert!(html.contains(part), "{part} in {html}");
        }
        assert!(!html.contains("<?xml"));
    }
}
