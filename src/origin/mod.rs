//! What a result was made of: the program and the files that it read, each known by what it holds.

mod program;

pub use program::{program_sha256, with_code_of_its_own};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// What a result was made of.
#[derive(Debug, Clone, PartialEq, Eq, Default, Serialize, Deserialize, JsonSchema)]
pub struct MadeOf {
    /// Version of the program.
    pub washout_version: String,
    /// SHA-256 of the program: of its sources and the versions of its dependencies. Programs that add effects in Rust: of that and
    /// of the executable.
    pub program_sha256: String,
    /// Every file that was read.
    pub files: Vec<InputFile>,
}

/// A file that was read.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
pub struct InputFile {
    /// Its path, as it was given or named.
    pub file: String,
    /// SHA-256 of what it held.
    pub sha256: String,
}

impl MadeOf {
    /// This program and these files, each once.
    pub fn files<'a>(files: impl IntoIterator<Item = &'a InputFile>) -> MadeOf {
        let mut once: Vec<InputFile> = Vec::new();
        for file in files {
            if !once.contains(file) {
                once.push(file.clone());
            }
        }
        MadeOf {
            washout_version: env!("CARGO_PKG_VERSION").to_string(),
            program_sha256: program_sha256().to_string(),
            files: once,
        }
    }
}

impl InputFile {
    /// A file that holds these bytes.
    pub fn new(file: impl Into<String>, bytes: &[u8]) -> InputFile {
        InputFile {
            file: file.into(),
            sha256: sha256(bytes),
        }
    }
}

/// SHA-256 in hexadecimal digits, as `sha256sum` prints it.
pub fn sha256(bytes: &[u8]) -> String {
    let digest = Sha256::digest(bytes);
    digest.iter().map(|byte| format!("{byte:02x}")).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_file_is_known_by_what_it_holds_as_others_know_it() {
        // FIPS 180-4, the example of one block
        let known = "ba7816bf8f01cfea414140de5dae2223b00361a396177a9cb410ff61f20015ad";
        assert_eq!(InputFile::new("a.csv", b"abc").sha256, known);
    }

    #[test]
    fn each_file_is_told_once() {
        let [one, other] = ["a", "b"].map(|bytes| InputFile::new("a.csv", bytes.as_bytes()));
        let made = MadeOf::files([&one, &other, &one]);
        assert_eq!(made.files, [one, other]);
        assert_eq!(made.program_sha256.len(), 64);
    }
}
