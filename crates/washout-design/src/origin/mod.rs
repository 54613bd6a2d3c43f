//! Files that a result was made from, each known by what it holds.

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};
use sha2::{Digest, Sha256};

/// A file that was read.
#[derive(Debug, Clone, PartialEq, Eq, Hash, Serialize, Deserialize, JsonSchema)]
pub struct InputFile {
    /// Its path, as it was given or named.
    pub file: String,
    /// SHA-256 of what it held.
    pub sha256: String,
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
}
