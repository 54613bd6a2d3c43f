//! Parts of a long work, each in a file of its own that is written whole and known by its number and its key.

use std::io::ErrorKind;
use std::path::{Path, PathBuf};

use serde::de::DeserializeOwned;
use serde::{Deserialize, Serialize};

use super::file::write_own;
use super::{ExportError, json};

/// A part as its file holds it.
#[derive(Debug, Serialize, Deserialize)]
struct Part<T> {
    key: String,
    result: T,
}

/// The result of a part; none if it was not done, or is of something else.
///
/// # Errors
/// If its file is there but cannot be read.
pub fn read_part<T: DeserializeOwned>(
    folder: &Path,
    number: usize,
    key: &str,
) -> Result<Option<T>, ExportError> {
    let part: Option<Part<T>> = read_json(&part_file(folder, number, key))?;
    Ok(part.filter(|part| part.key == key).map(|part| part.result))
}

/// Keeps the result of a part.
///
/// # Errors
/// If it cannot be written.
pub fn write_part(
    folder: &Path,
    number: usize,
    key: &str,
    result: &impl Serialize,
) -> Result<(), ExportError> {
    std::fs::create_dir_all(folder).map_err(ExportError::file("create", folder))?;
    let key = key.to_string();
    write_json(&part_file(folder, number, &key), &Part { key, result })
}

fn part_file(folder: &Path, number: usize, key: &str) -> PathBuf {
    folder.join(format!("{number:06}-{key}.json"))
}

/// What a file of JSON holds; none if it is not there or holds something else.
///
/// # Errors
/// If it is there but cannot be read.
pub fn read_json<T: DeserializeOwned>(path: &Path) -> Result<Option<T>, ExportError> {
    match std::fs::read_to_string(path) {
        Ok(text) => Ok(json::read(text.as_bytes()).ok()),
        Err(error) if error.kind() == ErrorKind::NotFound => Ok(None),
        Err(error) => Err(ExportError::file("read", path)(error)),
    }
}

/// Writes a file of JSON in a folder of parts.
///
/// # Errors
/// If it cannot be written.
pub fn write_json(path: &Path, value: &impl Serialize) -> Result<(), ExportError> {
    write_own(path, json::text(value)?.as_bytes())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_part_reads_back_bit_for_bit_and_half_a_file_or_another_key_is_none() {
        let folder = tempfile::tempdir().expect("a folder");
        let numbers = vec![0.1 + 0.2, -0.0, 5e-324, 1.0 / 3.0];
        let here = folder.path().join("parts");
        assert_eq!(read_part::<Vec<f64>>(&here, 3, "ab").expect("readable"), None);
        write_part(&here, 3, "ab", &numbers).expect("written");
        let back: Vec<f64> = read_part(&here, 3, "ab").expect("readable").expect("a part");
        let bits = |numbers: &[f64]| numbers.iter().map(|x| x.to_bits()).collect::<Vec<_>>();
        assert_eq!(bits(&back), bits(&numbers));
        assert_eq!(read_part::<Vec<f64>>(&here, 3, "ac").expect("readable"), None);
        std::fs::rename(part_file(&here, 3, "ab"), part_file(&here, 3, "ac")).expect("moved");
        assert_eq!(read_part::<Vec<f64>>(&here, 3, "ac").expect("readable"), None);
        std::fs::write(part_file(&here, 3, "ab"), "{\"key\": \"a").expect("written");
        assert_eq!(read_part::<Vec<f64>>(&here, 3, "ab").expect("readable"), None);
    }
}
