//! What a crate of washout is known by: the SHA-256 of the sources that it is built from. For build scripts.

use std::path::{Path, PathBuf};
use std::{env, fs, io};

use sha2::{Digest, Sha256};

/// Gives the crate that is built the hash of its folder `src` as `WASHOUT_SOURCES_SHA256`, and builds it anew when that changes.
///
/// # Errors
/// If a file cannot be read.
pub fn give() -> io::Result<()> {
    println!("cargo::rerun-if-changed=src");
    println!("cargo::rerun-if-changed=build.rs");
    let root = PathBuf::from(env::var_os("CARGO_MANIFEST_DIR").unwrap_or_default());
    println!(
        "cargo::rustc-env=WASHOUT_SOURCES_SHA256={}",
        hash(&root, &["src"])?
    );
    Ok(())
}

/// SHA-256 of all files of these `parts` (files or folders, relative to `root`), with their names, in hexadecimal digits; a part
/// that is not there counts as empty.
///
/// # Errors
/// If a file cannot be read.
pub fn hash(root: &Path, parts: &[&str]) -> io::Result<String> {
    let mut files = Vec::new();
    for part in parts {
        collect(&root.join(part), &mut files)?;
    }
    files.sort();
    let mut hash = Sha256::new();
    for file in files {
        let name = file.strip_prefix(root).unwrap_or(&file);
        let name = name.to_string_lossy().replace('\\', "/");
        let bytes = fs::read(&file)?;
        // with their lengths, so that no two trees read the same
        for part in [name.as_bytes(), &bytes] {
            hash.update((part.len() as u64).to_le_bytes());
            hash.update(part);
        }
    }
    let digest = hash.finalize();
    Ok(digest.iter().map(|byte| format!("{byte:02x}")).collect())
}

fn collect(path: &Path, files: &mut Vec<PathBuf>) -> io::Result<()> {
    if path.is_dir() {
        for entry in fs::read_dir(path)? {
            collect(&entry?.path(), files)?;
        }
    } else if path.is_file() {
        files.push(path.to_path_buf());
    }
    Ok(())
}
