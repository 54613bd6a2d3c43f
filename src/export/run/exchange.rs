//! A hidden folder takes the place of another, and what a killed run left of that is found.
//!
//! Where the system can exchange two names in one step, a run stands under its name at every instant. Elsewhere the earlier run is
//! moved aside first; if the program is killed between both steps, the next run into that name puts it back.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};

use tempfile::TempDir;

use super::record::{NEW_RECORD, Record};

/// A new folder, not seen by `ls`, beside a place; removed when dropped.
pub fn hidden_folder(parent: &Path, place: &Path, kind: Kind) -> io::Result<TempDir> {
    let prefix = prefix(place, kind);
    let mut builder = tempfile::Builder::new();
    builder.prefix(&prefix);
    // as `mkdir` does it; the user's umask applies
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o777));
    builder.tempdir_in(parent)
}

/// What a hidden folder is.
#[derive(Debug, Clone, Copy, PartialEq, Eq)]
pub enum Kind {
    /// A run in the making; after an exchange the earlier run, on its way out.
    Partial,
    /// The earlier run, moved aside.
    Earlier,
}

fn prefix(place: &Path, kind: Kind) -> String {
    let name = place.file_name().unwrap_or_default().to_string_lossy();
    let kind = match kind {
        Kind::Partial => "partial",
        Kind::Earlier => "earlier",
    };
    format!(".{name}.{kind}-")
}

/// Puts a hidden folder in its place; gives what stood there, to be dropped once that will last.
///
/// # Errors
/// If the system refuses; then what stood there still stands.
pub fn put_in_place(hidden: TempDir, parent: &Path, place: &Path) -> io::Result<Option<TempDir>> {
    if !place.exists() {
        fs::rename(hidden.path(), place)?;
        // it has its name now and must outlive the guard
        let _ = hidden.keep();
        return Ok(None);
    }
    if exchange(hidden.path(), place).is_ok() {
        return Ok(Some(hidden));
    }
    let earlier = hidden_folder(parent, place, Kind::Earlier)?;
    // renaming onto an empty folder replaces it
    fs::rename(place, earlier.path())?;
    if let Err(error) = fs::rename(hidden.path(), place) {
        fs::rename(earlier.path(), place)?;
        return Err(error);
    }
    let _ = hidden.keep();
    Ok(Some(earlier))
}

/// Exchanges the names of two folders in one step.
#[cfg(any(target_os = "linux", target_vendor = "apple"))]
fn exchange(one: &Path, other: &Path) -> io::Result<()> {
    use rustix::fs::{CWD, RenameFlags, renameat_with};
    Ok(renameat_with(CWD, one, CWD, other, RenameFlags::EXCHANGE)?)
}

#[cfg(not(any(target_os = "linux", target_vendor = "apple")))]
fn exchange(_: &Path, _: &Path) -> io::Result<()> {
    Err(io::ErrorKind::Unsupported.into())
}

/// Puts back an earlier run that a killed one had moved aside, and removes what else it left; nobody else may be writing to that place.
pub fn tidy(parent: &Path, place: &Path) {
    for earlier in left(parent, place, Kind::Earlier) {
        if !place.exists() {
            // if it cannot be put back, it stays where it is
            let _ = fs::rename(&earlier, place);
        }
    }
    // only where a run stands now is an earlier one of no use
    let earlier = if place.exists() {
        left(parent, place, Kind::Earlier)
    } else {
        Vec::new()
    };
    for folder in left(parent, place, Kind::Partial).into_iter().chain(earlier) {
        let _ = fs::remove_dir_all(folder);
    }
}

/// Hidden folders of a place that washout made: those with a record, and those in which the first one was still to be written.
fn left(parent: &Path, place: &Path, kind: Kind) -> Vec<PathBuf> {
    let prefix = prefix(place, kind);
    let entries = fs::read_dir(parent).into_iter().flatten().flatten();
    let is_left = |path: &PathBuf| {
        let name = path.file_name().unwrap_or_default().to_string_lossy();
        let is_folder = fs::symlink_metadata(path).is_ok_and(|entry| entry.is_dir());
        let is_new = || {
            let is_record =
                |entry: io::Result<fs::DirEntry>| entry.is_ok_and(|entry| entry.file_name() == NEW_RECORD);
            fs::read_dir(path).is_ok_and(|mut entries| entries.all(is_record))
        };
        name.starts_with(&prefix) && is_folder && (Record::read(path).is_some() || is_new())
    };
    let mut found: Vec<PathBuf> = entries.map(|entry| entry.path()).filter(is_left).collect();
    found.sort();
    found
}

#[cfg(test)]
mod tests {
    use std::sync::atomic::{AtomicBool, Ordering};

    use super::*;

    fn folder_with(path: &Path, text: &str) {
        fs::create_dir(path).expect("a folder");
        fs::write(path.join("file"), text).expect("written");
        let record = Record::of("solve").text().expect("a record");
        fs::write(path.join(super::super::record::RECORD), record).expect("written");
    }

    fn text(path: &Path) -> String {
        fs::read_to_string(path.join("file")).expect("a file")
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn names_are_exchanged_in_one_step() {
        let parent = tempfile::tempdir().expect("a folder");
        let [one, other] = ["one", "other"].map(|name| parent.path().join(name));
        folder_with(&one, "one");
        folder_with(&other, "other");
        if let Err(error) = exchange(&one, &other) {
            eprintln!("skipped: this disk cannot ({error})");
            return;
        }
        assert_eq!([text(&one), text(&other)], ["other", "one"]);
    }

    #[cfg(target_os = "linux")]
    #[test]
    fn while_a_run_takes_the_place_of_another_one_stands_there_at_every_instant() {
        let parent = tempfile::tempdir().expect("a folder");
        let [place, probe] = ["run", "probe"].map(|name| parent.path().join(name));
        folder_with(&place, "first");
        folder_with(&probe, "probe");
        if let Err(error) = exchange(&probe, &place) {
            eprintln!("skipped: this disk cannot ({error})");
            return;
        }
        let is_over = AtomicBool::new(false);
        let gaps = std::thread::scope(|scope| {
            let watcher = scope.spawn(|| {
                let mut gaps = 0;
                while !is_over.load(Ordering::Relaxed) {
                    gaps += u32::from(!place.exists());
                }
                gaps
            });
            let replaced: io::Result<()> = (0..2000).try_for_each(|_| {
                let hidden = hidden_folder(parent.path(), &place, Kind::Partial)?;
                put_in_place(hidden, parent.path(), &place).map(drop)
            });
            is_over.store(true, Ordering::Relaxed);
            replaced.expect("replaced");
            watcher.join().expect("watched")
        });
        assert_eq!(gaps, 0);
    }

    #[test]
    fn what_a_killed_run_left_is_put_back_or_removed_and_nothing_else() {
        let parent = tempfile::tempdir().expect("a folder");
        let path = |name: &str| parent.path().join(name);
        folder_with(&path(".run.earlier-a1"), "earlier");
        folder_with(&path(".run.partial-b2"), "partial");
        fs::create_dir(path(".run.partial-c3")).expect("a folder");
        fs::create_dir(path(".run.partial-d4")).expect("a folder");
        fs::write(path(".run.partial-d4").join(NEW_RECORD), "{\"note").expect("written");
        for others in [".run.partial-mine", ".runner.partial-d4"] {
            fs::create_dir(path(others)).expect("a folder");
            fs::write(path(others).join("file"), "mine").expect("written");
        }
        tidy(parent.path(), &path("run"));
        assert_eq!(text(&path("run")), "earlier");
        folder_with(&path(".run.earlier-e5"), "older");
        tidy(parent.path(), &path("run"));
        assert_eq!(text(&path("run")), "earlier");
        let mut names: Vec<String> = fs::read_dir(parent.path())
            .expect("readable")
            .map(|entry| entry.expect("entry").file_name().to_string_lossy().into_owned())
            .collect();
        names.sort();
        assert_eq!(names, [".run.partial-mine", ".runner.partial-d4", "run"]);
    }
}
