//! The folder of a run: written whole or not at all, and only in place of what washout wrote.
//!
//! Files go into a hidden folder beside the target; [`RunFolder::commit`] syncs them and then exchanges that
//! folder with an earlier run. Dropping the writer without commit removes what was written and leaves the
//! earlier run untouched; what a killed one leaves is found by the next run into that name.

mod exchange;

mod record;

pub use record::{Since, since_written, write_member};

use std::fs::{self, File};
use std::io::Write;
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;
use tempfile::TempDir;

use super::file::sync_folder;
use super::html::REPORT;
use super::json::Document;
use super::lock::Lock;
use super::summary::RunSummary;
use super::{ExportError, json, place};
use exchange::{Kind, hidden_folder, put_in_place, tidy};
use record::{NEW_RECORD, RECORD, Record, refuse_foreign};

/// Name of the file that lists the files of a run.
pub const SUMMARY: &str = "summary.json";

/// What the summary and the record of a solved wing say it is.
pub const SOLVED: &str = "solve";

/// A run folder in the making.
#[derive(Debug)]
pub struct RunFolder {
    /// As the user named it.
    target: PathBuf,
    /// Where that is.
    place: PathBuf,
    partial: TempDir,
    verb: &'static str,
    summary: &'static str,
    names: Vec<String>,
    record: Record,
    /// Let go last, when nothing hidden is left.
    _lock: Lock,
}

impl RunFolder {
    /// Prepares the folder `target` of a verb, so that what would prevent writing shows before any computing.
    ///
    /// An existing folder is accepted only if it is empty, or holds nothing but what this verb wrote there earlier.
    pub fn create(target: &Path, verb: &'static str) -> Result<Self, ExportError> {
        RunFolder::listed_by(target, verb, SUMMARY)
    }

    /// The same for a folder whose files are listed by the document `summary`.
    pub fn listed_by(target: &Path, verb: &'static str, summary: &'static str) -> Result<Self, ExportError> {
        let place = place::of_folder(target)?;
        let parent = parent_of(&place);
        fs::create_dir_all(&parent).map_err(ExportError::file("create", &parent))?;
        let lock = Lock::on(&place)?;
        tidy(&parent, &place);
        refuse_foreign(&place, verb)?;
        let partial = hidden_folder(&parent, &place, Kind::Partial)
            .map_err(ExportError::file("create a folder in", &parent))?;
        let folder = RunFolder {
            target: target.to_path_buf(),
            place,
            partial,
            verb,
            summary,
            names: Vec::new(),
            record: Record::of(verb),
            _lock: lock,
        };
        // by which it is known, should this program be killed
        folder.put_record()?;
        Ok(folder)
    }

    /// Refuses a folder that [`RunFolder::create`] would refuse, for a verb that writes it much later.
    pub fn refuse(target: &Path, verb: &str) -> Result<(), ExportError> {
        refuse_foreign(&place::of_folder(target)?, verb)
    }

    /// Adds one file; a table (`.csv`) as Parquet besides, where the feature `parquet` is on.
    pub fn add(&mut self, name: &str, bytes: &[u8]) -> Result<(), ExportError> {
        self.put(name, bytes)?;
        self.names.push(name.to_string());
        self.record.note(name, bytes);
        #[cfg(feature = "parquet")]
        if let Some(table) = name.strip_suffix(".csv") {
            self.add(&format!("{table}.parquet"), &super::parquet::of_csv(bytes)?)?;
        }
        Ok(())
    }

    fn put(&self, name: &str, bytes: &[u8]) -> Result<(), ExportError> {
        let path = self.partial.path().join(name);
        let write = || {
            let mut file = File::create(&path)?;
            file.write_all(bytes)?;
            file.sync_all()
        };
        // The user knows the target, not the hidden folder.
        write().map_err(ExportError::file("write", self.target.join(name)))
    }

    /// Writes the record beside the one that stands there, and renames it: at no instant does the folder hold files and half a record.
    fn put_record(&self) -> Result<(), ExportError> {
        self.put(NEW_RECORD, self.record.text()?.as_bytes())?;
        let [new, record] = [NEW_RECORD, RECORD].map(|name| self.partial.path().join(name));
        fs::rename(new, record).map_err(ExportError::file("write", self.target.join(RECORD)))
    }

    /// Where the folder will stand.
    pub fn target(&self) -> &Path {
        &self.target
    }

    /// What was added under a name.
    ///
    /// # Errors
    /// If nothing was, or it cannot be read back.
    pub fn read(&self, name: &str) -> Result<Vec<u8>, ExportError> {
        let path = self.partial.path().join(name);
        fs::read(path).map_err(ExportError::file("read", self.target.join(name)))
    }

    /// Names of all files of the folder, the summary among them, as its `files` must list them.
    pub fn listed(&self) -> Vec<String> {
        self.listed_with(false)
    }

    /// The same with the report, if one is still to be added.
    pub fn listed_with(&self, report: bool) -> Vec<String> {
        let report = report.then(|| REPORT.to_string());
        let names = self.names.iter().cloned().chain(report);
        names.chain([self.summary.to_string()]).collect()
    }

    /// Adds the summary (`summary.json`), the last file; its `files` are what [`RunFolder::listed`] says.
    ///
    /// Refuses a document that would not read back as it is, above all numbers that are not finite.
    pub fn add_summary<T>(&mut self, document: &T) -> Result<(), ExportError>
    where
        T: Document + DeserializeOwned + PartialEq,
    {
        let text = to_json(document)?;
        self.add(self.summary, text.as_bytes())
    }

    /// Puts the folder in place of an earlier run; gives its path.
    pub fn commit(self) -> Result<PathBuf, ExportError> {
        self.put_record()?;
        let RunFolder {
            target,
            place,
            partial,
            verb,
            ..
        } = self;
        sync_folder(partial.path()).map_err(ExportError::file("write", &target))?;
        refuse_foreign(&place, verb)?;
        let parent = parent_of(&place);
        let earlier = put_in_place(partial, &parent, &place);
        let earlier = earlier.map_err(ExportError::file("replace", &target))?;
        sync_folder(&parent).map_err(ExportError::file("write", &parent))?;
        drop(earlier);
        Ok(target)
    }
}

fn parent_of(place: &Path) -> PathBuf {
    match place.parent() {
        Some(parent) if !parent.as_os_str().is_empty() => parent.to_path_buf(),
        _ => PathBuf::from("."),
    }
}

/// The text of a document, ended by a line feed; refuses what would not read back as it is.
fn to_json<T>(document: &T) -> Result<String, ExportError>
where
    T: Document + DeserializeOwned + PartialEq,
{
    let refuse = |reason: String| ExportError::Encoding {
        format: "JSON",
        reason,
    };
    let mut text = json::text(&json::document(document)?)?;
    // JSON writes a number that is not finite as null.
    let back: T = json::read(text.as_bytes())
        .map_err(|error| refuse(format!("a number that is not finite, or the like: {error}")))?;
    if back != *document {
        return Err(refuse("it holds a number that is not finite".to_string()));
    }
    text.push('\n');
    Ok(text)
}

/// Reads the summary of a solved wing from the folder of its run.
///
/// # Errors
/// If there is none, or it is of another verb or version.
pub fn read_summary(folder: &Path) -> Result<RunSummary, ExportError> {
    let path = folder.join(SUMMARY);
    let text = fs::read_to_string(&path).map_err(|source| ExportError::NoRun {
        path: folder.to_path_buf(),
        source,
    })?;
    let foreign = |error: serde_json::Error| ExportError::ForeignSummary {
        path: path.clone(),
        reason: error.to_string(),
    };
    let document = json::read(text.as_bytes()).map_err(foreign)?;
    match json::kind(&document) {
        Some(kind) if kind != SOLVED => Err(ExportError::OtherRun {
            path,
            kind: kind.to_string(),
        }),
        _ => json::of(&document).map_err(foreign),
    }
}

#[cfg(test)]
mod tests {
    use serde::Serialize;

    use super::*;

    fn write_run(target: &Path, text: &str) -> Result<PathBuf, ExportError> {
        let mut run = RunFolder::create(target, "solve")?;
        run.add("profile.csv", text.as_bytes())?;
        run.add(SUMMARY, b"{}")?;
        run.commit()
    }

    fn entries(folder: &Path) -> Vec<String> {
        let entries = fs::read_dir(folder).expect("readable");
        let mut names: Vec<_> = entries
            .map(|entry| entry.expect("entry").file_name().into_string().expect("UTF-8"))
            .collect();
        names.sort();
        names
    }

    #[test]
    fn a_run_replaces_an_earlier_run_and_leaves_nothing_beside_it() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        write_run(&target, "first").expect("written");
        write_run(&target, "second").expect("replaced");
        assert_eq!(
            fs::read_to_string(target.join("profile.csv")).expect("file"),
            "second"
        );
        assert_eq!(entries(parent.path()), ["run"]);
    }

    #[test]
    fn a_run_that_is_dropped_leaves_the_earlier_one() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        write_run(&target, "first").expect("written");
        let mut run = RunFolder::create(&target, "solve").expect("prepared");
        run.add("profile.csv", b"half").expect("added");
        drop(run);
        assert_eq!(
            fs::read_to_string(target.join("profile.csv")).expect("file"),
            "first"
        );
        assert_eq!(entries(parent.path()), ["run"]);
    }

    #[test]
    fn a_folder_with_files_of_the_user_is_never_replaced() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        write_run(&target, "first").expect("written");
        fs::write(target.join("notes.txt"), "mine").expect("file");
        let error = write_run(&target, "second").expect_err("foreign file");
        assert!(error.to_string().contains("'notes.txt'"), "{error}");
        assert_eq!(
            entries(&target),
            [RECORD, "notes.txt", "profile.csv", "summary.json"]
        );
    }

    #[test]
    fn a_file_that_was_changed_since_is_never_replaced() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        write_run(&target, "first").expect("written");
        fs::write(target.join("profile.csv"), "mine").expect("file");
        let error = write_run(&target, "second").expect_err("changed").to_string();
        assert!(
            error.contains("'profile.csv'") && error.contains("changed"),
            "{error}"
        );
        fs::remove_file(target.join("profile.csv")).expect("removed");
        write_run(&target, "second").expect("what is lost is nobody's");
    }

    #[test]
    fn a_run_of_another_verb_is_never_replaced() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        write_run(&target, "first").expect("written");
        let error = RunFolder::create(&target, "mesh").expect_err("another verb");
        assert!(error.to_string().contains("washout solve"), "{error}");
    }

    #[test]
    fn a_list_of_files_that_washout_did_not_write_deletes_none_of_them() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        fs::create_dir(&target).expect("folder");
        fs::write(target.join("thesis.docx"), "mine").expect("file");
        let names = ["thesis.docx", "../thesis.docx", SUMMARY];
        fs::write(target.join(SUMMARY), format!("{{\"files\": {names:?}}}")).expect("file");
        assert!(write_run(&target, "run").is_err());
        // even the record of another folder
        write_run(&parent.path().join("other"), "run").expect("written");
        fs::copy(parent.path().join("other").join(RECORD), target.join(RECORD)).expect("copied");
        let error = write_run(&target, "run").expect_err("not recorded").to_string();
        assert!(error.contains("'summary.json'"), "{error}");
        assert_eq!(entries(&target), [RECORD, SUMMARY, "thesis.docx"]);
    }

    #[test]
    fn a_report_beside_a_run_goes_with_it_but_not_a_page_of_the_user() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        write_run(&target, "first").expect("written");
        let page = |bytes: &[u8]| bytes.starts_with(b"page");
        write_member(&target.join(REPORT), b"page", "a page", page).expect("file");
        write_run(&target, "second").expect("replaced");
        fs::write(target.join(REPORT), "<p>mine</p>").expect("file");
        let error = write_run(&target, "third").expect_err("foreign file");
        assert!(error.to_string().contains("'report.html'"), "{error}");
    }

    #[test]
    fn a_deck_in_the_folder_of_a_run_is_replaced_with_it_but_nothing_else_there() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        let write_deck = || {
            let mut deck = RunFolder::create(&target.join("deck"), "export")?;
            deck.add("wing.inp", b"deck")?;
            deck.commit()
        };
        write_run(&target, "first").expect("written");
        write_deck().expect("written");
        write_run(&target, "second").expect("replaced");
        assert_eq!(entries(&target), [RECORD, "profile.csv", "summary.json"]);
        write_deck().expect("written");
        fs::write(target.join("deck/notes.txt"), "mine").expect("file");
        let error = write_run(&target, "third").expect_err("a file of the user");
        assert!(error.to_string().contains("'notes.txt'"), "{error}");
        assert_eq!(entries(&target.join("deck")), [RECORD, "notes.txt", "wing.inp"]);
        fs::remove_dir_all(target.join("deck")).expect("removed");
        write_run(&target.join("other"), "other").expect("written");
        let error = write_run(&target, "third").expect_err("another run");
        assert!(error.to_string().contains("washout solve"), "{error}");
    }

    #[test]
    fn what_a_killed_run_left_in_the_folder_of_a_run_goes_with_it() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        write_run(&target, "first").expect("written");
        let deck = RunFolder::create(&target.join("deck"), "export").expect("begun");
        assert!(write_run(&target, "second").is_err(), "it is in use");
        let RunFolder {
            partial, _lock: lock, ..
        } = deck;
        let _ = partial.keep();
        drop(lock);
        fs::write(target.join(".deck.lock"), "").expect("written");
        write_run(&target, "second").expect("replaced");
        assert_eq!(entries(&target), [RECORD, "profile.csv", "summary.json"]);
    }

    #[test]
    fn a_file_of_a_set_that_washout_writes_anew_stays_in_it() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        write_run(&target, "first").expect("written");
        write_member(&target.join("profile.csv"), b"added", "", |_| true).expect("written");
        write_run(&target, "second").expect("replaced");
        write_member(&target.join("other.csv"), b"other", "", |_| true).expect("written");
        assert!(write_run(&target, "third").is_err(), "one that was not in it");
    }

    #[test]
    fn a_document_with_a_number_that_is_not_finite_is_refused_and_a_finite_one_says_what_it_is() {
        #[derive(Serialize, serde::Deserialize, PartialEq)]
        struct Numbers {
            values: Vec<Option<f64>>,
        }
        impl Document for Numbers {
            const KIND: &'static str = "numbers";
        }
        let text = |values: &[Option<f64>]| {
            to_json(&Numbers {
                values: values.to_vec(),
            })
        };
        assert!(text(&[Some(1.0), Some(f64::NAN)]).is_err());
        assert!(text(&[Some(f64::INFINITY)]).is_err());
        assert_eq!(
            text(&[Some(0.1), None]).expect("finite"),
            "{\n  \"kind\": \"numbers\",\n  \"format\": 1,\n  \"values\": [\n    0.1,\n    null\n  ]\n}\n"
        );
    }

    #[test]
    fn a_target_below_a_file_is_refused_with_its_path() {
        let parent = tempfile::tempdir().expect("folder");
        let file = parent.path().join("file");
        fs::write(&file, "").expect("file");
        for target in [file.clone(), file.join("run")] {
            let error = RunFolder::create(&target, "solve")
                .expect_err("not a folder")
                .to_string();
            assert!(error.contains("file") && error.contains("--output"), "{error}");
        }
    }
}
