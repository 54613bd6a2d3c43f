//! The program as its user meets it: words, exit codes, documents, files.

mod alike;

mod at_once;

mod bench;

mod check;

mod compare;

mod divergence;

mod explain;

mod export;
mod foreign;

mod help;

mod hidden;

mod init;

mod interrupt;
mod kept;

mod ladder;

mod lift;

mod live;

mod measure;

mod mesh;

mod modes;

mod modest;

mod not_finite;

mod one_wing;

mod overlooked;

mod real_data;

mod plot;

mod refused_effects;

mod replaced;

mod report;

mod schema;

mod shell;

mod solve;

mod study;

mod sweep;

mod table;

mod tasks;

mod verify;

mod writing;

use std::path::{Path, PathBuf};
use std::process::Command;

/// What the program said and how it ended.
pub struct Said {
    /// Exit code; none if a signal ended it.
    pub code: Option<i32>,
    /// Standard output.
    pub out: String,
    /// Standard error.
    pub err: String,
}

/// The program, in a folder.
pub fn program(folder: &Path) -> Command {
    let mut command = Command::new(env!("CARGO_BIN_EXE_washout"));
    command.current_dir(folder);
    command.env("WASHOUT_CACHE", concat!(env!("CARGO_TARGET_TMPDIR"), "/cache"));
    command
}

/// Runs the program in a folder.
pub fn washout(folder: &Path, arguments: &[&str]) -> Said {
    let output = program(folder)
        .args(arguments)
        .output()
        .expect("the program starts");
    let text = |bytes: Vec<u8>| String::from_utf8(bytes).expect("UTF-8");
    Said {
        code: output.status.code(),
        out: text(output.stdout),
        err: text(output.stderr),
    }
}

impl Said {
    /// The one JSON document on standard output.
    pub fn document(&self) -> serde_json::Value {
        serde_json::from_str(&self.out).unwrap_or_else(|error| panic!("{error}\n{}\n{}", self.out, self.err))
    }
}

/// An empty folder that goes away.
pub fn folder() -> tempfile::TempDir {
    tempfile::tempdir().expect("a folder")
}

/// A shipped design.
pub fn design(name: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("designs").join(name);
    path.to_str().expect("UTF-8 path").to_string()
}

/// Names in a folder, sorted; without the record of what washout wrote there.
pub fn entries(folder: &Path) -> Vec<String> {
    let entries = std::fs::read_dir(folder).expect("a readable folder");
    let mut names: Vec<String> = entries
        .map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8"))
        .collect();
    names.retain(|name| name != ".washout.json");
    names.sort();
    names
}

/// Bytes of every file in a folder.
pub fn contents(folder: &Path) -> Vec<(String, Vec<u8>)> {
    let read = |name: String| {
        let bytes = std::fs::read(folder.join(&name)).expect("a readable file");
        (name, bytes)
    };
    entries(folder).into_iter().map(read).collect()
}

/// The document that `washout schema` prints with these arguments.
pub fn schema(arguments: &[&str]) -> serde_json::Value {
    let said = washout(&std::env::temp_dir(), &[&["schema"], arguments].concat());
    assert_eq!(said.code, Some(0), "{}", said.err);
    said.document()
}

/// Fails unless a document conforms to a schema.
pub fn conforms(document: &serde_json::Value, schema: &serde_json::Value) {
    let validator = jsonschema::validator_for(schema).expect("a schema");
    let errors: Vec<String> = validator
        .iter_errors(document)
        .map(|error| format!("{}: {error}", error.instance_path()))
        .collect();
    assert!(errors.is_empty(), "{}", errors.join("\n"));
}

/// A path below a folder as text.
pub fn below(folder: &Path, name: &str) -> String {
    let path: PathBuf = folder.join(name);
    path.to_str().expect("UTF-8 path").to_string()
}
