//! The folder of a run: written whole or not at all.
//!
//! Files go into a hidden folder beside the target; [`RunFolder::commit`] syncs them and then swaps that
//! folder with an earlier run. Dropping the writer without commit removes what was written and leaves the
//! earlier run untouched.

use std::collections::BTreeSet;
use std::fs::{self, File};
use std::io::{self, Read, Write};
use std::path::{Path, PathBuf};

use serde::Serialize;
use serde::de::DeserializeOwned;
use tempfile::TempDir;

use super::ExportError;
use super::html::{GENERATOR, REPORT};
use super::summary::RunSummary;

/// Name of the file that lists the files of a run.
pub const SUMMARY: &str = "summary.json";

/// A run folder in the making.
#[derive(Debug)]
pub struct RunFolder {
    target: PathBuf,
    partial: TempDir,
    summary: &'static str,
    names: Vec<String>,
}

impl RunFolder {
    /// Prepares the folder `target`, so that what would prevent writing shows before any computing.
    ///
    /// An existing folder is accepted only if it is empty or holds nothing but an earlier run.
    pub fn create(target: &Path) -> Result<Self, ExportError> {
        RunFolder::listed_by(target, SUMMARY)
    }

    /// The same for a folder whose files are listed by the document `summary`.
    pub fn listed_by(target: &Path, summary: &'static str) -> Result<Self, ExportError> {
        refuse_foreign(target, summary)?;
        let parent = match target.parent() {
            Some(parent) if !parent.as_os_str().is_empty() => parent.to_path_buf(),
            _ => PathBuf::from("."),
        };
        fs::create_dir_all(&parent).map_err(ExportError::file("create", &parent))?;
        let partial = hidden_folder(&parent, target, "partial")
            .map_err(ExportError::file("create a folder in", &parent))?;
        Ok(RunFolder {
            target: target.to_path_buf(),
            partial,
            summary,
            names: Vec::new(),
        })
    }

    /// Adds one file; a table (`.csv`) as Parquet besides, where the feature `parquet` is on.
    pub fn add(&mut self, name: &str, bytes: &[u8]) -> Result<(), ExportError> {
        let path = self.partial.path().join(name);
        let write = || {
            let mut file = File::create(&path)?;
            file.write_all(bytes)?;
            file.sync_all()
        };
        // The user knows the target, not the hidden folder.
        write().map_err(ExportError::file("write", self.target.join(name)))?;
        self.names.push(name.to_string());
        #[cfg(feature = "parquet")]
        if let Some(table) = name.strip_suffix(".csv") {
            self.add(&format!("{table}.parquet"), &super::parquet::of_csv(bytes)?)?;
        }
        Ok(())
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
        T: Serialize + DeserializeOwned + PartialEq,
    {
        let text = to_json(document)?;
        self.add(self.summary, text.as_bytes())
    }

    /// Puts the folder in place of an earlier run; gives its path.
    pub fn commit(self) -> Result<PathBuf, ExportError> {
        let RunFolder {
            target,
            partial,
            summary,
            ..
        } = self;
        sync_folder(partial.path()).map_err(ExportError::file("write", &target))?;
        refuse_foreign(&target, summary)?;
        let parent = partial.path().parent().unwrap_or(Path::new(".")).to_path_buf();
        let earlier = if target.exists() {
            let earlier = hidden_folder(&parent, &target, "earlier")
                .map_err(ExportError::file("create a folder in", &parent))?;
            // Renaming onto an empty folder replaces it.
            fs::rename(&target, earlier.path()).map_err(ExportError::file("replace", &target))?;
            Some(earlier)
        } else {
            None
        };
        if let Err(error) = fs::rename(partial.path(), &target) {
            if let Some(earlier) = earlier {
                fs::rename(earlier.path(), &target).map_err(ExportError::file("restore", &target))?;
            }
            return Err(ExportError::file("create", &target)(error));
        }
        // The folder has its name now and must outlive the guard.
        let _ = partial.keep();
        sync_folder(&parent).map_err(ExportError::file("write", &parent))?;
        Ok(target)
    }
}

/// The text of a document, ended by a line feed; refuses what would not read back as it is.
fn to_json<T>(document: &T) -> Result<String, ExportError>
where
    T: Serialize + DeserializeOwned + PartialEq,
{
    let refuse = |reason: String| ExportError::Encoding {
        format: "JSON",
        reason,
    };
    let mut text = serde_json::to_string_pretty(document).map_err(|error| refuse(error.to_string()))?;
    // JSON writes a number that is not finite as null.
    let back: T = serde_json::from_str(&text)
        .map_err(|error| refuse(format!("a number that is not finite, or the like: {error}")))?;
    if back != *document {
        return Err(refuse("it holds a number that is not finite".to_string()));
    }
    text.push('\n');
    Ok(text)
}

/// Reads the summary of a run from its folder.
pub fn read_summary(folder: &Path) -> Result<RunSummary, ExportError> {
    let path = folder.join(SUMMARY);
    let text = fs::read_to_string(&path).map_err(|source| ExportError::NoRun {
        path: folder.to_path_buf(),
        source,
    })?;
    serde_json::from_str(&text).map_err(|error| ExportError::ForeignSummary {
        path,
        reason: error.to_string(),
    })
}

/// A folder of a name of its own beside the target, removed when dropped.
fn hidden_folder(parent: &Path, target: &Path, kind: &str) -> io::Result<TempDir> {
    let name = target.file_name().map(|name| name.to_string_lossy().into_owned());
    let prefix = format!(".{}.{kind}-", name.unwrap_or_default());
    let mut builder = tempfile::Builder::new();
    builder.prefix(&prefix);
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As `mkdir` does it; the user's umask applies.
        builder.permissions(fs::Permissions::from_mode(0o777));
    }
    builder.tempdir_in(parent)
}

fn sync_folder(path: &Path) -> io::Result<()> {
    if cfg!(unix) {
        File::open(path)?.sync_all()
    } else {
        Ok(())
    }
}

/// Refuses a target that holds files that no run wrote.
fn refuse_foreign(target: &Path, summary: &str) -> Result<(), ExportError> {
    let entries = match fs::read_dir(target) {
        Ok(entries) => entries,
        Err(error) if error.kind() == io::ErrorKind::NotFound => return Ok(()),
        Err(error) => return Err(ExportError::file("replace", target)(error)),
    };
    let mut found = BTreeSet::new();
    for entry in entries {
        let entry = entry.map_err(ExportError::file("read", target))?;
        found.insert(entry.file_name().to_string_lossy().into_owned());
    }
    let known = files_of_run(target, summary);
    let foreign = |name: &String| {
        let path = target.join(name);
        let is_ours = name == REPORT && is_report(&path);
        !known.contains(name) && !is_run(&path) && !is_ours
    };
    match found.into_iter().find(foreign) {
        None => Ok(()),
        Some(entry) => Err(ExportError::ForeignEntry {
            path: target.to_path_buf(),
            entry,
        }),
    }
}

/// Whether a folder holds a run and nothing else, such as the deck that `washout export` puts beside the files of a run.
fn is_run(folder: &Path) -> bool {
    folder.join(SUMMARY).is_file() && refuse_foreign(folder, SUMMARY).is_ok()
}

/// Whether a file is a report that washout wrote.
pub fn is_report(path: &Path) -> bool {
    let mut head = Vec::new();
    let read = File::open(path).and_then(|file| file.take(1024).read_to_end(&mut head));
    read.is_ok() && String::from_utf8_lossy(&head).contains(GENERATOR)
}

/// The files that a run lists in its summary; none if there is no readable summary.
fn files_of_run(folder: &Path, summary: &str) -> BTreeSet<String> {
    let text = fs::read_to_string(folder.join(summary)).unwrap_or_default();
    let summary: serde_json::Value = serde_json::from_str(&text).unwrap_or_default();
    let names = summary["files"].as_array().into_iter().flatten();
    names
        .filter_map(|name| name.as_str().map(str::to_string))
        .collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn write_run(target: &Path, text: &str) -> Result<PathBuf, ExportError> {
        let mut run = RunFolder::create(target)?;
        run.add("profile.csv", text.as_bytes())?;
        run.add(SUMMARY, br#"{"files":["profile.csv","summary.json"]}"#)?;
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
        let mut run = RunFolder::create(&target).expect("prepared");
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
        assert_eq!(entries(&target), ["notes.txt", "profile.csv", "summary.json"]);
    }

    #[test]
    fn a_report_beside_a_run_goes_with_it_but_not_a_page_of_the_user() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        write_run(&target, "first").expect("written");
        let page = super::super::html::Page::default().html();
        fs::write(target.join(REPORT), page).expect("file");
        write_run(&target, "second").expect("replaced");
        fs::write(target.join(REPORT), "<p>mine</p>").expect("file");
        let error = write_run(&target, "third").expect_err("foreign file");
        assert!(error.to_string().contains("'report.html'"), "{error}");
    }

    #[test]
    fn a_run_in_the_folder_of_a_run_is_replaced_with_it_but_not_with_files_of_the_user() {
        let parent = tempfile::tempdir().expect("folder");
        let target = parent.path().join("run");
        write_run(&target, "first").expect("written");
        write_run(&target.join("deck"), "deck").expect("written");
        write_run(&target, "second").expect("replaced");
        assert_eq!(entries(&target), ["profile.csv", "summary.json"]);
        write_run(&target.join("deck"), "deck").expect("written");
        fs::write(target.join("deck/notes.txt"), "mine").expect("file");
        assert!(write_run(&target, "third").is_err());
        assert_eq!(
            entries(&target.join("deck")),
            ["notes.txt", "profile.csv", "summary.json"]
        );
    }

    #[test]
    fn a_document_with_a_number_that_is_not_finite_is_refused() {
        assert!(to_json(&[1.0, f64::NAN].to_vec()).is_err());
        assert!(to_json(&vec![Some(f64::INFINITY)]).is_err());
        assert_eq!(
            to_json(&vec![Some(0.1), None]).expect("finite"),
            "[\n  0.1,\n  null\n]\n"
        );
    }

    #[test]
    fn a_target_below_a_file_is_refused_with_its_path() {
        let parent = tempfile::tempdir().expect("folder");
        let file = parent.path().join("file");
        fs::write(&file, "").expect("file");
        for target in [file.clone(), file.join("run")] {
            let error = RunFolder::create(&target).expect_err("not a folder").to_string();
            assert!(error.contains("file") && error.contains("--output"), "{error}");
        }
    }
}
