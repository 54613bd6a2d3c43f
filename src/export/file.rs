//! One file, written whole or not at all, and never over one that is not washout's.

use std::fs::{self, File, Permissions};
use std::io::{self, Write};
use std::path::Path;

use tempfile::NamedTempFile;

use super::ExportError;
use super::place;
use crate::origin::InputFile;

/// Writes a file where none stands.
///
/// # Errors
/// If one stands there, or it cannot be written.
pub fn write_new(path: &Path, bytes: &[u8]) -> Result<(), ExportError> {
    refuse_any(path)?;
    clear_left(&place::of_file(path)?);
    put(path, bytes, false)
}

/// Refuses what [`write_new`] would refuse, before anything is computed.
///
/// # Errors
/// If something stands there.
pub fn refuse_any(path: &Path) -> Result<(), ExportError> {
    refuse_other(path, "", |_| false)
}

/// Writes a file, over an earlier one only if `is_own` says so of what that holds. `what` it must be, with its article.
///
/// # Errors
/// If something else stands there, or it cannot be written; then what stood there still stands.
pub fn write_over(
    path: &Path,
    bytes: &[u8],
    what: &'static str,
    is_own: impl Fn(&[u8]) -> bool,
) -> Result<(), ExportError> {
    refuse_other(path, what, is_own)?;
    clear_left(&place::of_file(path)?);
    put(path, bytes, true)
}

/// Writes a page of documentation, over an earlier one only if that begins with the same line.
///
/// # Errors
/// If something else stands there, or it cannot be written.
pub fn write_page(path: &Path, page: &str) -> Result<(), ExportError> {
    refuse_page(path, page)?;
    put(path, page.as_bytes(), true)
}

/// Refuses what [`write_page`] would refuse of a page that begins like this, before anything is computed.
///
/// # Errors
/// If something else stands there.
pub fn refuse_page(path: &Path, start: &str) -> Result<(), ExportError> {
    let head = start.lines().next();
    let is_own = |bytes: &[u8]| String::from_utf8_lossy(bytes).lines().next() == head;
    refuse_other(path, "such a page of documentation", is_own)
}

/// Refuses what [`write_over`] would refuse, before anything is computed.
///
/// # Errors
/// If something else stands there.
pub fn refuse_other(
    path: &Path,
    what: &'static str,
    is_own: impl Fn(&[u8]) -> bool,
) -> Result<(), ExportError> {
    let place = place::of_file(path)?;
    match fs::read(place) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(()),
        Err(error) => Err(ExportError::file("read", path)(error)),
        Ok(earlier) if is_own(&earlier) => Ok(()),
        Ok(_) => Err(ExportError::Exists {
            path: path.to_path_buf(),
            unless: what,
        }),
    }
}

/// Writes a file of a folder that is washout's alone, over an earlier one.
///
/// # Errors
/// If it cannot be written; then what stood there still stands.
pub(super) fn write_own(path: &Path, bytes: &[u8]) -> Result<(), ExportError> {
    clear_left(&place::of_file(path)?);
    put(path, bytes, true)
}

/// A file, by what it holds.
///
/// # Errors
/// If it cannot be read.
pub fn input_file(path: &Path) -> Result<InputFile, ExportError> {
    let bytes = fs::read(path).map_err(ExportError::file("read", path))?;
    Ok(InputFile::new(path.display().to_string(), &bytes))
}

/// Makes what was written in a folder outlast a loss of power.
pub(super) fn sync_folder(path: &Path) -> io::Result<()> {
    if cfg!(unix) {
        File::open(path)?.sync_all()
    } else {
        Ok(())
    }
}

/// Writes a file beside its place and moves it there when it is complete.
fn put(path: &Path, bytes: &[u8], is_over: bool) -> Result<(), ExportError> {
    let fault = |error: io::Error| ExportError::file("write", path)(error);
    let place = place::of_file(path)?;
    let folder = folder_of(&place);
    let mut file = partial(folder, &partial_prefix(&place)).map_err(fault)?;
    let earlier: Option<Permissions> = fs::metadata(&place).ok().map(|entry| entry.permissions());
    let mut write = || {
        file.write_all(bytes)?;
        if let Some(permissions) = earlier.clone() {
            file.as_file().set_permissions(permissions)?;
        }
        file.as_file().sync_all()
    };
    write().map_err(fault)?;
    let persisted = match is_over {
        true => file.persist(&place),
        false => file.persist_noclobber(&place),
    };
    persisted.map_err(|error| fault(error.error))?;
    sync_folder(folder).map_err(fault)
}

/// A file in the making, locked as long as it is.
fn partial(folder: &Path, prefix: &str) -> io::Result<NamedTempFile> {
    let mut builder = tempfile::Builder::new();
    builder.prefix(prefix);
    // as any new file, the user's umask applies; one that takes the place of another keeps its permissions
    #[cfg(unix)]
    builder.permissions(std::os::unix::fs::PermissionsExt::from_mode(0o666));
    loop {
        let file = builder.tempfile_in(folder)?;
        // where the disk knows no locks, none is taken by those who clear either
        let _ = file.as_file().lock();
        // before it was locked, it may have been taken for one that was left
        if file.path().exists() {
            return Ok(file);
        }
    }
}

/// How the names of files in the making of this one begin.
fn partial_prefix(place: &Path) -> String {
    format!(
        ".{}.partial-",
        place.file_name().unwrap_or_default().to_string_lossy()
    )
}

/// What a killed program left of a file in the making, if `path` is that of the one at `place`; locked against who would write it.
pub(super) fn left_of(place: &Path, path: &Path) -> Option<File> {
    let name = path.file_name()?.to_string_lossy();
    let random = name.strip_prefix(&partial_prefix(place))?;
    let is_file = fs::symlink_metadata(path).ok()?.is_file();
    let file = File::open(path).ok()?;
    (random.len() == 6 && is_file && file.try_lock().is_ok()).then_some(file)
}

/// Removes what killed programs left of a file in the making.
fn clear_left(place: &Path) {
    for entry in fs::read_dir(folder_of(place)).into_iter().flatten().flatten() {
        if let Some(_locked) = left_of(place, &entry.path()) {
            let _ = fs::remove_file(entry.path());
        }
    }
}

fn folder_of(place: &Path) -> &Path {
    match place.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_that_is_not_known_is_never_written_over() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("page.md");
        let is_page = |bytes: &[u8]| bytes.starts_with(b"# Page");
        write_over(&path, b"# Page", "a page", is_page).expect("new");
        write_over(&path, b"mine", "a page", is_page).expect("over a page");
        let error = write_over(&path, b"# Page", "a page", is_page).expect_err("not a page");
        assert!(error.to_string().contains("is not a page"), "{error}");
        let error = write_new(&path, b"new").expect_err("exists");
        assert!(error.to_string().contains("exists already"), "{error}");
        assert_eq!(fs::read(&path).expect("file"), b"mine");
        assert_eq!(fs::read_dir(folder.path()).expect("folder").count(), 1);
    }

    #[test]
    fn what_a_killed_program_left_of_a_file_is_removed_and_nothing_else() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        let mine = [".page.md.partial-of-mine", ".other.md.partial-Ab12Cd"];
        for name in mine.into_iter().chain([".page.md.partial-Ab12Cd"]) {
            fs::write(path(name), "half").expect("written");
        }
        let writing = partial(folder.path(), ".page.md.partial-").expect("a file");
        write_new(&path("page.md"), b"# Page").expect("new");
        assert!(writing.path().exists(), "it is being written");
        drop(writing);
        write_over(&path("page.md"), b"# Page", "", |_| true).expect("over it");
        let entries = fs::read_dir(folder.path()).expect("folder");
        let mut names: Vec<_> = entries.map(|entry| entry.expect("entry").file_name()).collect();
        names.sort();
        assert_eq!(names, [mine[1], mine[0], "page.md"]);
    }

    #[cfg(unix)]
    #[test]
    fn a_link_is_followed_and_what_is_no_file_is_refused() {
        use std::os::unix::fs::{PermissionsExt, symlink};
        let folder = tempfile::tempdir().expect("a folder");
        let path = |name: &str| folder.path().join(name);
        fs::write(path("file"), "old").expect("written");
        fs::set_permissions(path("file"), Permissions::from_mode(0o640)).expect("set");
        symlink("file", path("link")).expect("a link");
        symlink("nothing", path("dangling")).expect("a link");
        write_over(&path("link"), b"new", "", |_| true).expect("written");
        assert!(path("link").is_symlink());
        assert_eq!(fs::read(path("file")).expect("file"), b"new");
        let mode = fs::metadata(path("file")).expect("file").permissions().mode();
        assert_eq!(mode & 0o777, 0o640);
        for (name, words) in [("dangling", "not there"), (".", "a folder")] {
            let error = write_over(&path(name), b"new", "", |_| true).expect_err(name);
            assert!(error.to_string().contains(words), "{error}");
        }
        let error = write_over(Path::new("/dev/null"), b"new", "", |_| true).expect_err("a device");
        assert!(error.to_string().contains("a device"), "{error}");
    }
}
