//! Reading text files, with a sentence for everything that can be wrong with one.

use std::fs::File;
use std::io::{ErrorKind, Read};
use std::path::{Component, Path, PathBuf};
use std::string::FromUtf8Error;

use super::document::Source;
use super::error::{InputError, Problem};
use crate::origin::InputFile;

/// Largest text file that is read, in bytes.
const LARGEST: u64 = 4 * 1024 * 1024;

/// Reads a text file; `what` names it, such as "design file".
pub(crate) fn read_text(path: &Path, what: &str) -> Result<String, InputError> {
    Ok(read_input(path, what)?.0)
}

/// Endings of tables, which are no designs and no studies.
const TABLES: [&str; 7] = ["csv", "tsv", "xlsx", "xlsm", "xlsb", "xls", "ods"];

/// The same with what it is known by.
pub(crate) fn read_input(path: &Path, what: &str) -> Result<(String, InputFile), InputError> {
    let name = shown(path);
    let fail = |message: String, cure: String| Err(InputError::about_file(&name, message, cure));
    let ending = path
        .extension()
        .unwrap_or_default()
        .to_string_lossy()
        .to_lowercase();
    let wants_toml = ["study file", "design file", "design or study"].contains(&what);
    if wants_toml && TABLES.contains(&ending.as_str()) && path.is_file() {
        return fail(
            format!("is a table, not a {what}"),
            format!(
                "A table of readings goes behind --with, after its design: `washout diagnose DESIGN --with {name}`; \
                 `washout init NAME --study --design DESIGN --readings {name}` makes a study of it"
            ),
        );
    }
    let bytes = read_bytes(path, what)?;
    if bytes.iter().all(u8::is_ascii_whitespace) {
        return fail(
            "is empty".into(),
            match what {
                "study file" => {
                    "`washout init NAME --study` writes a study with its design and readings to start from"
                        .into()
                }
                "design file" | "design or study" => {
                    "`washout init NAME` writes a design to start from".into()
                }
                _ => format!("Name a {what} with content"),
            },
        );
    }
    if bytes.contains(&0) {
        return fail(
            "is a binary file".into(),
            format!("A {what} is plain text; check the path"),
        );
    }
    let input = InputFile::new(&name, &bytes);
    match String::from_utf8(bytes) {
        Ok(text) => Ok(match text.strip_prefix('\u{feff}') {
            Some(rest) => (rest.to_string(), input),
            None => (text, input),
        }),
        Err(error) => Err(no_utf8(&name, error)),
    }
}

fn no_utf8(name: &str, error: FromUtf8Error) -> InputError {
    let start = error.utf8_error().valid_up_to();
    let bytes = error.into_bytes();
    let good = String::from_utf8_lossy(&bytes[..start]).into_owned();
    let place = Source::file(name, &good).place(start);
    let byte = bytes.get(start).copied().unwrap_or_default();
    let message = format!("is not UTF-8: byte 0x{byte:02x}");
    InputError::new(
        place,
        "",
        "",
        Problem::File { message },
        "Save the file as UTF-8 text",
    )
}

/// Reads a file whole, whatever it holds.
pub(crate) fn read_bytes(path: &Path, what: &str) -> Result<Vec<u8>, InputError> {
    let name = shown(path);
    let fail = |message: String, cure: String| Err(InputError::about_file(&name, message, cure));
    if path.is_dir() {
        return fail("is a folder".into(), format!("Name a {what} inside it"));
    }
    // whoever should write into a pipe may never come, and a device has no end
    if path.exists() && !path.is_file() {
        return fail(
            "is a pipe or a device".into(),
            format!("Write the {what} into a file first, and name that"),
        );
    }
    let mut bytes = Vec::new();
    let read = File::open(path).and_then(|file| file.take(LARGEST + 1).read_to_end(&mut bytes));
    if let Err(error) = read {
        return match error.kind() {
            ErrorKind::NotFound => fail("no such file".into(), format!("Check the path of the {what}")),
            ErrorKind::PermissionDenied => {
                fail("may not be read".into(), "Check the file's permissions".into())
            }
            _ => fail(
                format!("cannot be read: {error}"),
                "Check the file and its disk".into(),
            ),
        };
    }
    if bytes.len() as u64 > LARGEST {
        return fail(
            "is larger than 4 MB".into(),
            format!("A {what} is a few kB of text; check the path"),
        );
    }
    Ok(bytes)
}

/// A path as it is shown to the user: `a/../b` becomes `b`.
pub(crate) fn shown(path: &Path) -> String {
    let mut parts: Vec<Component> = Vec::new();
    for part in path.components() {
        match (part, parts.last()) {
            (Component::ParentDir, Some(Component::Normal(_))) => {
                parts.pop();
            }
            (Component::CurDir, _) => {}
            _ => parts.push(part),
        }
    }
    parts.iter().collect::<PathBuf>().display().to_string()
}

/// The path of a file that is named relative to another.
pub(crate) fn beside(file: &Path, name: &str) -> PathBuf {
    file.parent().unwrap_or(Path::new("")).join(name)
}

#[cfg(test)]
mod tests {
    use super::*;

    #[cfg(unix)]
    #[test]
    fn a_pipe_or_a_device_is_refused_before_anybody_waits_for_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let pipe = folder.path().join("pipe.toml");
        let made = std::process::Command::new("mkfifo").arg(&pipe).status();
        assert!(made.is_ok_and(|status| status.success()));
        for path in [pipe.as_path(), Path::new("/dev/zero")] {
            let told = read_text(path, "design file").expect_err("no file").to_string();
            assert!(told.contains("is a pipe or a device"), "{told}");
        }
    }

    #[test]
    fn shown_paths_have_no_detours() {
        assert_eq!(
            shown(Path::new("designs/../measurements/a.csv")),
            "measurements/a.csv"
        );
        assert_eq!(shown(Path::new("./a.toml")), "a.toml");
        assert_eq!(shown(Path::new("../a.toml")), "../a.toml");
    }
}
