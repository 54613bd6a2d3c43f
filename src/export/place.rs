//! Where an output goes: links followed, and known to be plain before anything is computed.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

use super::ExportError;

/// The place of a file: nothing stands there, or a plain file.
///
/// # Errors
/// If something else stands there.
pub fn of_file(path: &Path) -> Result<PathBuf, ExportError> {
    let place = resolved(path)?;
    match fs::symlink_metadata(&place) {
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(place),
        Err(error) => Err(ExportError::file("write", path)(error)),
        Ok(entry) if entry.is_file() => Ok(place),
        Ok(entry) => Err(not_plain(
            path,
            match entry.is_dir() {
                true => "is a folder, not a file",
                false => "is a device or the like, not a file",
            },
        )),
    }
}

/// The place of a folder that is to be replaced as a whole: nothing stands there, or what can be moved.
///
/// # Errors
/// If it cannot be moved.
pub fn of_folder(path: &Path) -> Result<PathBuf, ExportError> {
    let place = resolved(path)?;
    if !place.is_dir() {
        return Ok(place);
    }
    let fault = |error: io::Error| ExportError::file("find", path)(error);
    let whole = place.canonicalize().map_err(fault)?;
    let here = env::current_dir().and_then(|here| here.canonicalize());
    if here.is_ok_and(|here| here.starts_with(&whole)) {
        return Err(not_plain(path, "is the folder that you are in, or one above it"));
    }
    match whole.parent() {
        Some(parent) if is_other_disk(parent, &whole).map_err(fault)? => Err(not_plain(
            path,
            "is where another disk begins, which cannot be moved; name a folder inside it",
        )),
        _ => Ok(place),
    }
}

/// A path without links and `.` at its end.
fn resolved(path: &Path) -> Result<PathBuf, ExportError> {
    let plain: PathBuf = path.components().collect();
    let is_link = fs::symlink_metadata(&plain).is_ok_and(|entry| entry.is_symlink());
    if plain.file_name().is_some() && !is_link {
        return Ok(plain);
    }
    match plain.canonicalize() {
        Ok(place) => Ok(place),
        Err(error) if is_link && error.kind() == io::ErrorKind::NotFound => {
            Err(not_plain(path, "is a link to something that is not there"))
        }
        Err(error) => Err(ExportError::file("find", path)(error)),
    }
}

fn not_plain(path: &Path, what: &'static str) -> ExportError {
    ExportError::NotPlain {
        path: path.to_path_buf(),
        what,
    }
}

#[cfg(unix)]
fn is_other_disk(parent: &Path, folder: &Path) -> io::Result<bool> {
    use std::os::unix::fs::MetadataExt;
    Ok(fs::metadata(parent)?.dev() != fs::metadata(folder)?.dev())
}

#[cfg(not(unix))]
fn is_other_disk(_: &Path, _: &Path) -> io::Result<bool> {
    Ok(false)
}
