//! Files that a design names: where they stand, and what they hold.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::design::Design;
use super::document::Node;
use super::error::{InputError, Problem};
use super::file;
use super::path::KeyPath;
use super::set::Setting;
use crate::origin::InputFile;

/// Keys of a design that name a file.
const KEYS: [&str; 4] = ["materials", "mesh.file", "air.table", "measured.file"];

impl Design {
    /// The files that a design names once `sets` have changed it, with what they hold, as far as they can be read; whatever else
    /// is right or wrong with it.
    pub fn named_files(path: &Path, sets: &[String]) -> Vec<InputFile> {
        let root = file::read_text(path, "design file").and_then(|text| Node::parse_file("", &text));
        let Ok(mut root) = root else {
            return Vec::new();
        };
        for setting in sets.iter().filter_map(|set| Setting::parse(set).ok()) {
            // one that is refused names nothing
            let _ = setting.apply(&mut root);
        }
        let name = |key: &&str| root.at(&KeyPath::parse(key).unwrap_or_default())?.text();
        let read = |name: &str| {
            let path = file::beside(path, name);
            let bytes = path.is_file().then(|| std::fs::read(&path).ok())??;
            Some(InputFile::new(file::shown(&path), &bytes))
        };
        KEYS.iter().filter_map(name).filter_map(read).collect()
    }
}

/// The path of the file that a key names, relative to the design; it must exist.
pub(super) fn named_file(root: &Node, design_path: &Path, key: &str) -> Result<Option<PathBuf>, InputError> {
    let path = KeyPath::parse(key).unwrap_or_default();
    let Some(node) = root.at(&path) else {
        return Ok(None);
    };
    let Some(name) = node.text() else {
        return Ok(None);
    };
    let target = file::beside(design_path, name);
    if name.is_empty() || !target.is_file() {
        let message = if target.is_dir() {
            "is a folder, not a file"
        } else {
            "no such file"
        };
        let problem = Problem::File {
            message: message.to_string(),
        };
        let cure = format!(
            "Looked for {}; paths are relative to the design file",
            file::shown(&target)
        );
        return Err(InputError::new(node.place(), key, &node.shown(), problem, cure));
    }
    Ok(Some(target))
}

/// Name and bytes of a mesh file.
pub(super) fn read_mesh(path: &Path) -> Result<(String, Arc<[u8]>), InputError> {
    let name = file::shown(path);
    if path.exists() && !path.is_file() {
        let cure = "Name a mesh file; a mesh that a program writes goes into a file first";
        return Err(InputError::about_file(
            &name,
            "is a folder, a pipe or a device",
            cure,
        ));
    }
    match std::fs::read(path) {
        Ok(bytes) => Ok((name, bytes.into())),
        Err(error) => {
            let message = format!("cannot be read: {error}");
            Err(InputError::about_file(
                &name,
                message,
                "Check the file and its permissions",
            ))
        }
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn files_are_named_by_what_is_set_even_where_the_design_is_refused() {
        let folder = tempfile::tempdir().unwrap();
        let path = folder.path().join("wing.toml");
        std::fs::write(&path, "mesh.file = 'wing.msh'\nair.table = 'lost.csv'\n").unwrap();
        std::fs::write(folder.path().join("wing.msh"), "mesh").unwrap();
        std::fs::write(folder.path().join("air.csv"), "air").unwrap();
        let named = |sets: &[&str]| -> Vec<String> {
            let sets: Vec<String> = sets.iter().map(|set| set.to_string()).collect();
            let files = Design::named_files(&path, &sets).into_iter();
            files.map(|file| file.sha256).collect()
        };
        let [mesh, air] = ["mesh", "air"].map(|text| crate::origin::sha256(text.as_bytes()));
        assert_eq!(named(&[]), std::slice::from_ref(&mesh));
        assert_eq!(
            named(&["no.such=1", "air={coefficients=\"table\", table=\"air.csv\"}"]),
            [mesh, air]
        );
    }
}
