//! One file, written whole or not at all.

use std::io::Write;
use std::path::Path;

use super::ExportError;
use crate::origin::InputFile;

/// A file, by what it holds.
///
/// # Errors
/// If it cannot be read.
pub fn input_file(path: &Path) -> Result<InputFile, ExportError> {
    let bytes = std::fs::read(path).map_err(ExportError::file("read", path))?;
    Ok(InputFile::new(path.display().to_string(), &bytes))
}

/// Writes a file beside its place and moves it there when it is complete; an old one is replaced.
///
/// # Errors
/// If it cannot be written; then what stood there still stands.
pub fn write_whole(path: &Path, bytes: &[u8]) -> Result<(), ExportError> {
    let folder = match path.parent() {
        Some(folder) if !folder.as_os_str().is_empty() => folder,
        _ => Path::new("."),
    };
    let mut builder = tempfile::Builder::new();
    #[cfg(unix)]
    {
        use std::os::unix::fs::PermissionsExt;
        // As any new file; the user's umask applies.
        builder.permissions(std::fs::Permissions::from_mode(0o666));
    }
    let mut file = builder
        .tempfile_in(folder)
        .map_err(ExportError::file("write", path))?;
    file.write_all(bytes).map_err(ExportError::file("write", path))?;
    let persisted = file.persist(path).map_err(|error| error.error);
    persisted.map_err(ExportError::file("write", path))?;
    Ok(())
}
