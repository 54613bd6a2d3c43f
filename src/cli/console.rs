//! Standard output and standard error: who gets which text.

use std::cell::RefCell;
use std::fmt;
use std::io::{self, IsTerminal, Write};
use std::path::Path;

use clap::Args;
use serde::Serialize;
use serde_json::Value;

use crate::export::ExportError;
use crate::export::json::{self, Document};
use crate::export::sheet::{understood, understood_briefly};
use crate::input::sheet::Sheet;
use crate::page::Page;
use crate::page::screen::ALL;
use crate::page::text::{WIDTH, hanging};
use crate::plot::Figure;
use crate::plot::terminal::sketch;
use crate::progress::Progress;

use super::{Failure, colour};

/// Options of every verb.
#[derive(Debug, Clone, Args)]
pub struct Common {
    /// Print one JSON document on standard output, and everything else on standard error
    #[arg(long, global = true)]
    pub json: bool,
    /// Print nothing but errors (and the JSON document, if asked for)
    #[arg(long, short, global = true)]
    pub quiet: bool,
    /// Print all that there is to say, not what fits on a screen
    #[arg(long, short, global = true)]
    pub verbose: bool,
    /// Threads to use; results do not depend on it [default: one per core]
    #[arg(long, global = true, value_name = "N", value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub threads: Option<u16>,
}

/// Where a verb prints.
#[derive(Debug)]
pub struct Console {
    json: bool,
    quiet: bool,
    verbose: bool,
    progress: Progress,
    /// Holds the document instead of standard output.
    kept: Option<RefCell<String>>,
}

impl Console {
    /// As the options say; from here on Ctrl-C cancels what runs.
    pub fn new(common: &Common) -> Self {
        let progress = if common.quiet {
            Progress::quiet()
        } else {
            Progress::shown()
        };
        progress.cancel_on_interrupt();
        Console {
            json: common.json,
            quiet: common.quiet,
            verbose: common.verbose,
            progress,
            kept: None,
        }
    }

    /// A console that prints nothing and keeps the document that a verb gives with `--json`: for programs that call verbs.
    pub fn keeping(progress: Progress) -> Self {
        Console {
            json: true,
            quiet: true,
            verbose: false,
            progress,
            kept: Some(RefCell::default()),
        }
    }

    /// The document kept, or the text for another program; empty where nothing was given, or it was printed.
    pub fn into_kept(self) -> String {
        self.kept.map(RefCell::into_inner).unwrap_or_default()
    }

    /// What long computations report to.
    pub fn progress(&self) -> &Progress {
        &self.progress
    }

    /// Prints a result: the page to people, the document to programs, never both.
    pub fn result(&self, page: &str, document: &impl Document) -> Result<(), Failure> {
        self.either(page, || json::document(document))
    }

    /// As [`Console::result`], for a list of names.
    pub fn names(&self, page: &str, names: &[impl AsRef<str>]) -> Result<(), Failure> {
        let names: Vec<&str> = names.iter().map(AsRef::as_ref).collect();
        self.either(page, || json::tree(&names))
    }

    fn either(
        &self,
        page: &str,
        document: impl FnOnce() -> Result<Value, ExportError>,
    ) -> Result<(), Failure> {
        match (self.json, self.quiet) {
            (true, _) => self.document(&document()?),
            (false, true) => Ok(()),
            (false, false) => {
                self.progress.finish();
                self.print(page.as_bytes())
            }
        }
    }

    /// Prints an answer and what is to be done after it; to people what fits on a screen, unless they asked for all.
    pub fn answer(&self, page: &Page, after: &str, document: &impl Document) -> Result<(), Failure> {
        self.answer_with(page, after, "", document)
    }

    /// The same with a [`Console::sketch`] below it.
    pub fn answer_with(
        &self,
        page: &Page,
        after: &str,
        sketch: &str,
        document: &impl Document,
    ) -> Result<(), Failure> {
        let text = match page.on_screen(after).filter(|_| !self.verbose) {
            Some(screen) => screen + sketch,
            None => format!("{}\n{after}{sketch}", page.text()),
        };
        match page.answer().filter(|_| colour::is_shown()) {
            Some(answer) => self.result(&colour::coloured(&text, &answer), document),
            None => self.result(&text, document),
        }
    }

    /// Prints a document for programs, whatever the options say.
    pub fn document(&self, document: &impl Serialize) -> Result<(), Failure> {
        self.progress.finish();
        let text = json::text(document)?;
        self.print((text + "\n").as_bytes())
    }

    /// Prints text that is meant for another program as it is, whatever the options say.
    pub fn text(&self, text: &[u8]) -> Result<(), Failure> {
        self.progress.finish();
        self.print(text)
    }

    /// Which files were written, as the last line of a page: their names where these have room, or all is asked for.
    pub fn listed(&self, folder: &Path, files: &[String]) -> String {
        let folder = folder.display();
        let named = format!("Files in {folder}: {}", files.join(" "));
        // with how to see all, as on a screen
        match self.verbose || named.chars().count() + 2 + ALL.len() <= WIDTH {
            true => hanging("", &named, 2),
            false => format!("{} files in {folder}\n", files.len()),
        }
    }

    /// A small picture for people at a terminal; nothing for a file, another program, or where nothing is printed.
    pub fn sketch(&self, figure: &Figure) -> String {
        if self.json || self.quiet || self.kept.is_some() || !io::stdout().is_terminal() {
            return String::new();
        }
        format!("\n{}", sketch(figure))
    }

    fn print(&self, text: &[u8]) -> Result<(), Failure> {
        match &self.kept {
            Some(kept) => {
                kept.borrow_mut().push_str(&String::from_utf8_lossy(text));
                Ok(())
            }
            None => print(text),
        }
    }

    /// Says on standard error what was understood of a table of readings, before anything is solved.
    pub fn understood(&self, sheet: &Sheet) {
        match self.verbose {
            true => self.note(understood(sheet)),
            false => self.note(understood_briefly(sheet)),
        }
    }

    /// Says something on standard error that is no result and no failure.
    pub fn note(&self, text: impl fmt::Display) {
        if !self.quiet {
            complain(&text);
        }
    }
}

/// Prints on standard output; a reader that has gone away is no failure.
fn print(text: &[u8]) -> Result<(), Failure> {
    let mut output = io::stdout().lock();
    match output.write_all(text).and_then(|()| output.flush()) {
        Err(error) if error.kind() != io::ErrorKind::BrokenPipe => Err(Failure::Output(error)),
        _ => Ok(()),
    }
}

/// Says what went wrong on standard error.
pub fn complain(text: &impl fmt::Display) {
    // Nobody is left to tell if standard error is closed.
    let _ = writeln!(io::stderr(), "washout: {text}");
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_keeping_console_keeps_the_document_and_not_the_page() {
        let console = Console::keeping(Progress::quiet());
        console.names("page\n", &["one", "two"]).expect("kept");
        assert_eq!(console.into_kept(), "[\n  \"one\",\n  \"two\"\n]\n");
    }
}
