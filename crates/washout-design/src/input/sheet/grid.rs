//! The cells of a table: text with commas, semicolons or tabs, or the first sheet of a workbook that holds one.

use std::io::Cursor;
use std::path::Path;

use calamine::{Data, Reader};

use crate::input::error::{InputError, Place, Problem};
use crate::input::file;
use crate::input::table::line_of_row;
use crate::origin::InputFile;

/// Endings of workbooks.
const WORKBOOKS: [&str; 4] = ["xlsx", "xlsm", "xlsb", "ods"];

/// A table of texts.
#[derive(Debug)]
pub struct Grid {
    /// The file.
    pub input: InputFile,
    /// Lines before the head that are no part of the table.
    pub comments: Vec<String>,
    /// How it was read, in words.
    pub dialect: String,
    /// The names of the columns.
    pub head: Line,
    /// The lines below, each with as many cells as the head.
    pub lines: Vec<Line>,
}

/// One line of it.
#[derive(Debug)]
pub struct Line {
    /// Its number in the file, from 1.
    pub number: usize,
    /// Its cells, without spaces about them.
    pub cells: Vec<String>,
}

impl Line {
    fn is_blank(&self) -> bool {
        self.cells.iter().all(String::is_empty)
    }

    fn filled(&self) -> usize {
        self.cells.iter().filter(|cell| !cell.is_empty()).count()
    }
}

impl Grid {
    /// An error about one column of a line.
    pub fn fault(&self, line: usize, column: &str, value: &str, message: &str, cure: String) -> InputError {
        let place = Place {
            file: self.input.file.clone(),
            line: Some(line),
            column: None,
        };
        let problem = Problem::Conflict {
            message: message.to_string(),
            with: Vec::new(),
        };
        InputError::new(place, &format!("column \"{column}\""), value, problem, cure)
    }

    /// Reads a file.
    pub fn load(path: &Path) -> Result<Grid, InputError> {
        let name = file::shown(path);
        let ending = path
            .extension()
            .unwrap_or_default()
            .to_string_lossy()
            .to_lowercase();
        if ending == "toml" {
            let cure = "Name a table of readings (.csv, .tsv, .txt, .xlsx, .ods); a study goes without --with: washout \
                        diagnose STUDY";
            return Err(InputError::about_file(&name, "is no table of readings", cure));
        }
        if !WORKBOOKS.contains(&ending.as_str()) {
            let (text, input) = file::read_input(path, "table of readings")?;
            return Grid::of_text(&text, input);
        }
        let bytes = file::read_bytes(path, "table of readings")?;
        let input = InputFile::new(&name, &bytes);
        let broken = |error: calamine::Error| {
            let cure = "Open it in a spreadsheet program and save it again, or save it as CSV";
            InputError::about_file(&name, format!("is no workbook that can be read: {error}"), cure)
        };
        let mut book = calamine::open_workbook_auto_from_rs(Cursor::new(bytes)).map_err(broken)?;
        let sheets: Vec<_> = book
            .worksheets()
            .into_iter()
            .filter(|(_, range)| !range.is_empty())
            .collect();
        let tables = sheets.iter().map(|(sheet, range)| {
            let above = range.start().map_or(0, |(row, _)| row as usize);
            let lines = range.rows().enumerate().map(|(index, cells)| Line {
                number: above + index + 1,
                cells: cells.iter().map(words).collect(),
            });
            (sheet, lines.collect::<Vec<Line>>())
        });
        let mut tables: Vec<_> = tables.collect();
        // notes may stand before the readings; a table with a fault is not passed over
        let is_table = |lines: &[Line]| lines.iter().filter(|line| line.filled() > 1).count() > 1;
        let place = tables.iter().position(|(_, lines)| is_table(lines)).unwrap_or(0);
        if tables.is_empty() {
            let cure = "Put the readings into its first sheet";
            return Err(InputError::about_file(&name, "has no filled sheet", cure));
        }
        let (sheet, lines) = tables.swap_remove(place);
        let dialect = match sheets.len() {
            1 => format!("workbook, sheet \"{sheet}\""),
            count => format!("workbook, sheet \"{sheet}\", one of {count}; the others are not read"),
        };
        Grid::of_lines(lines, input, Vec::new(), dialect)
    }

    /// Reads a text.
    pub fn of_text(text: &str, input: InputFile) -> Result<Grid, InputError> {
        let is_comment = |line: &&str| line.trim_start().starts_with('#');
        let first = text
            .lines()
            .find(|line| !is_comment(line) && line.contains([',', ';', '\t']));
        let first = first.unwrap_or_default();
        let (separator, words) = match () {
            () if first.contains(';') => (b';', "semicolons"),
            () if first.contains('\t') => (b'\t', "tabs"),
            () => (b',', "commas"),
        };
        let mut reader = csv::ReaderBuilder::new()
            .comment(Some(b'#'))
            .trim(csv::Trim::All)
            .delimiter(separator)
            .has_headers(false)
            .flexible(true)
            .from_reader(text.as_bytes());
        let mut lines = Vec::new();
        for record in reader.records() {
            let record = record.map_err(|error| {
                let cure = "Save the table as CSV, with quotes around text that has a comma";
                InputError::about_file(&input.file, format!("is no table: {error}"), cure)
            })?;
            lines.push(Line {
                number: line_of_row(text, record.position()),
                cells: record.iter().map(str::to_string).collect(),
            });
        }
        let comments = text.lines().filter(is_comment);
        let comments = comments
            .map(|line| line.trim_start_matches([' ', '#']).to_string())
            .collect();
        Grid::of_lines(lines, input, comments, format!("text, separated by {words}"))
    }

    fn of_lines(
        lines: Vec<Line>,
        input: InputFile,
        mut comments: Vec<String>,
        dialect: String,
    ) -> Result<Grid, InputError> {
        let mut lines = lines.into_iter().filter(|line| !line.is_blank()).peekable();
        let is_title = |line: &Line, next: Option<&Line>| {
            line.filled() == 1 && next.is_some_and(|next| next.filled() > 1)
        };
        let mut head = lines.next();
        while let Some(title) = head.take_if(|line| is_title(line, lines.peek())) {
            comments.push(title.cells.concat());
            head = lines.next();
        }
        let lines: Vec<Line> = lines.collect();
        let Some(mut head) = head.filter(|_| !lines.is_empty()) else {
            let cure = "Give a line of names and one line for each station, e.g. \"r (mm), 18 Hz, 22 Hz\" above \
                        \"20, 5.1, 6.3\"";
            return Err(InputError::about_file(
                &input.file,
                "has a header but no rows",
                cure,
            ));
        };
        while head.cells.last().is_some_and(String::is_empty) {
            head.cells.pop();
        }
        let width = head.cells.len();
        let mut grid = Grid {
            input,
            comments,
            dialect,
            head,
            lines,
        };
        for line in &mut grid.lines {
            if line.cells.iter().skip(width).any(|cell| !cell.is_empty()) {
                let (number, given) = (line.number, line.cells.len());
                let cure = "Name every column; quote a name or a number that has a comma in it, or separate by semicolons";
                let message = format!("the row has {given} values, the header {width}");
                return Err(grid.fault(number, "", "", &message, cure.to_string()));
            }
            line.cells.resize(width, String::new());
        }
        Ok(grid)
    }
}

/// A cell of a workbook as it would stand in a text.
fn words(cell: &Data) -> String {
    match cell {
        Data::Empty => String::new(),
        other => other.to_string().trim().to_string(),
    }
}
