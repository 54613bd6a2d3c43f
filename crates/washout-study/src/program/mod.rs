//! What a result was made of: the program that computed it, and the files that it read.
//!
//! The hash of the sources is taken when they are built: it costs nothing at run time, is the same on every machine, and also
//! tells the Python package, whose process is Python's. Code that another program adds stands in that program's executable.

use std::path::PathBuf;
use std::sync::OnceLock;
use std::{env, fs, io};

use schemars::JsonSchema;
use serde::{Deserialize, Serialize};

use crate::effects::others_are_registered;
use crate::origin::{InputFile, sha256};

/// The crates from the ground up, the program above them with the versions of all dependencies, and the version of all these.
const SOURCES: [&str; 5] = [
    washout_design::SOURCES_SHA256,
    washout_wing::SOURCES_SHA256,
    crate::SOURCES_SHA256,
    env!("WASHOUT_ABOVE_SHA256"),
    env!("CARGO_PKG_VERSION"),
];

static SHA256: OnceLock<String> = OnceLock::new();

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

/// SHA-256 of the program, 64 hexadecimal digits. To be asked after effects of a program's own are registered.
pub fn program_sha256() -> &'static str {
    SHA256.get_or_init(|| match others_are_registered() {
        true => of_executable().unwrap_or_else(|_| of_sources()),
        false => of_sources(),
    })
}

fn of_sources() -> String {
    sha256(SOURCES.concat().as_bytes())
}

fn of_executable() -> io::Result<String> {
    // what runs, even where another was put in its place meanwhile
    let path = match cfg!(target_os = "linux") {
        true => PathBuf::from("/proc/self/exe"),
        false => env::current_exe()?,
    };
    Ok(sha256(
        &[of_sources().as_bytes(), fs::read(path)?.as_slice()].concat(),
    ))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_executable_is_known_by_more_than_the_sources_of_washout() {
        let found = of_executable().expect("this test runs");
        assert_eq!(found.len(), 64);
        assert_ne!(found, of_sources());
    }

    #[test]
    fn each_file_is_told_once() {
        let [one, other] = ["a", "b"].map(|bytes| InputFile::new("a.csv", bytes.as_bytes()));
        let made = MadeOf::files([&one, &other, &one]);
        assert_eq!(made.files, [one, other]);
        assert_eq!(made.program_sha256.len(), 64);
    }
}
