//! The record of a folder: which files washout wrote there, so that a later run replaces and removes these and no others.
//!
//! It is not believed blindly. Only what stands in the folder under a plain name, is a plain file and still holds what was written
//! is known as washout's.

use std::collections::BTreeMap;
use std::fs;
use std::io;
use std::path::Path;

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::export::file::{left_of, write_over, write_own};
use crate::export::html::REPORT;
use crate::export::lock::Lock;
use crate::export::{ExportError, json};
use crate::origin::sha256;

/// Name of the record in its folder.
pub const RECORD: &str = ".washout.json";

/// The same while it is written.
pub const NEW_RECORD: &str = ".washout.json.new";

/// The verb whose folders go with the run in which they stand: they can be had again from it in a moment.
const DECK: &str = "export";

const FORMAT: u32 = 1;
const NOTE: &str =
    "The files of this folder that washout wrote, with their SHA-256: it replaces and removes no others.";

/// What a verb wrote in a folder.
#[derive(Debug, Clone, PartialEq, Eq, Serialize, Deserialize)]
pub struct Record {
    note: String,
    format: u32,
    verb: String,
    files: BTreeMap<String, String>,
}

impl Record {
    /// Of nothing yet.
    pub fn of(verb: &str) -> Record {
        Record {
            note: NOTE.to_string(),
            format: FORMAT,
            verb: verb.to_string(),
            files: BTreeMap::new(),
        }
    }

    /// That of a folder; none where there is none that can be read.
    pub fn read(folder: &Path) -> Option<Record> {
        let text = fs::read(folder.join(RECORD)).ok()?;
        let record: Record = json::read(&text).ok()?;
        (record.format == FORMAT).then_some(record)
    }

    /// Notes a file.
    pub fn note(&mut self, name: &str, bytes: &[u8]) {
        self.files.insert(name.to_string(), sha256(bytes));
    }

    /// Whether a file of this name held these bytes when it was noted.
    pub fn knows(&self, name: &str, bytes: &[u8]) -> bool {
        self.files.get(name).is_some_and(|known| *known == sha256(bytes))
    }

    /// As it stands in its file.
    pub fn text(&self) -> Result<String, ExportError> {
        Ok(json::text(self)? + "\n")
    }
}

/// What became of a file since it was noted.
#[derive(Debug, Clone, Copy, PartialEq, Eq, Serialize, Deserialize, JsonSchema)]
#[serde(rename_all = "kebab-case")]
pub enum Since {
    /// It holds the same.
    Unchanged,
    /// It holds something else.
    Changed,
    /// It is not there, or cannot be read.
    Missing,
}

impl Since {
    /// Of the file at this path, which held bytes of this SHA-256.
    pub fn noted(path: &Path, known: &str) -> Since {
        match fs::read(path) {
            Ok(bytes) if sha256(&bytes) == known => Since::Unchanged,
            Ok(_) => Since::Changed,
            Err(_) => Since::Missing,
        }
    }
}

/// The verb that wrote a folder, and what became of each file that it noted there; none without a record.
pub fn since_written(folder: &Path) -> Option<(String, Vec<(String, Since)>)> {
    let record = Record::read(folder)?;
    let files = record.files.iter();
    let files = files.map(|(name, known)| (name.clone(), Since::noted(&folder.join(name), known)));
    Some((record.verb.clone(), files.collect()))
}

/// Refuses a folder that may not be replaced by what `verb` writes: one that holds anything that this verb did not write there, or
/// that was changed since. An empty one, or none, may.
pub fn refuse_foreign(folder: &Path, verb: &str) -> Result<(), ExportError> {
    let names = names_in(folder)?;
    let record = Record::read(folder);
    if let Some(record) = &record
        && record.verb != verb
    {
        return Err(ExportError::OtherVerb {
            path: folder.to_path_buf(),
            verb: record.verb.clone(),
        });
    }
    for name in names {
        refuse_entry(folder, &name, record.as_ref())?;
    }
    Ok(())
}

/// Refuses an entry of a folder with this record that is not as washout wrote it.
fn refuse_entry(folder: &Path, entry: &str, record: Option<&Record>) -> Result<(), ExportError> {
    let at = folder.join(entry);
    if is_left_over(&at, entry, record) {
        return Ok(());
    }
    let (path, entry) = (folder.to_path_buf(), entry.to_string());
    let Some(record) = record else {
        return Err(ExportError::NoRecord { path, entry });
    };
    let is_file = match fs::symlink_metadata(&at) {
        Ok(kind) if kind.is_dir() && Record::read(&at).is_some() => return refuse_foreign(&at, DECK),
        Ok(kind) => kind.is_file(),
        Err(_) => false,
    };
    if is_file && entry == RECORD {
        return Ok(());
    }
    if !is_file || !record.files.contains_key(&entry) {
        return Err(ExportError::ForeignEntry { path, entry });
    }
    let bytes = fs::read(&at).map_err(ExportError::file("read", &at))?;
    match record.knows(&entry, &bytes) {
        true => Ok(()),
        false => Err(ExportError::ChangedEntry { path, entry }),
    }
}

/// Whether an entry is what a killed washout left: a lock that nobody has, a folder in the making, or a file of the record.
fn is_left_over(path: &Path, name: &str, record: Option<&Record>) -> bool {
    let is_folder = || name.contains(".partial-") && Record::read(path).is_some();
    let is_lock = || name.ends_with(".lock") && Lock::is_left(path);
    let is_file = || {
        let files = record.into_iter().flat_map(|record| record.files.keys());
        let mut places = files.map(String::as_str).chain([RECORD]);
        places.any(|file| left_of(&path.with_file_name(file), path).is_some())
    };
    name.starts_with('.') && (is_folder() || is_lock() || is_file())
}

/// Writes a file as [`write_over`] does. One that belongs to what washout wrote in its folder goes on belonging to it, and the
/// report of a run belongs to the run.
///
/// # Errors
/// As [`write_over`].
pub fn write_member(
    path: &Path,
    bytes: &[u8],
    what: &'static str,
    is_own: impl Fn(&[u8]) -> bool,
) -> Result<(), ExportError> {
    let earlier = fs::read(path).ok();
    write_over(path, bytes, what, is_own)?;
    let (Some(folder), Some(name)) = (path.parent(), path.file_name()) else {
        return Ok(());
    };
    if Record::read(folder).is_none() {
        return Ok(());
    }
    // two at once may add to one record
    let _lock = Lock::when_free(&folder.join(RECORD))?;
    let (Some(mut record), name) = (Record::read(folder), name.to_string_lossy()) else {
        return Ok(());
    };
    let belongs = earlier.is_some_and(|earlier| record.knows(&name, &earlier));
    if belongs || name == REPORT {
        record.note(&name, bytes);
        write_own(&folder.join(RECORD), record.text()?.as_bytes())?;
    }
    Ok(())
}

/// Names of the entries of a folder, sorted; none where there is no folder.
fn names_in(folder: &Path) -> Result<Vec<String>, ExportError> {
    let entries = match fs::read_dir(folder) {
        Ok(entries) => entries,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(Vec::new()),
        Err(error) => return Err(ExportError::file("replace", folder)(error)),
    };
    let mut names = Vec::new();
    for entry in entries {
        let entry = entry.map_err(ExportError::file("read", folder))?;
        names.push(entry.file_name().to_string_lossy().into_owned());
    }
    names.sort();
    Ok(names)
}
