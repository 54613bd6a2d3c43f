//! A folder in which the commands of the documentation find what they name.

use std::path::Path;
use std::process::Command;

use crate::root;

/// Rooms of the repository that commands read.
const ROOMS: [&str; 5] = ["designs", "measurements", "studies", "examples", "meshes"];

/// What a command said.
pub struct Said {
    pub code: Option<i32>,
    pub out: String,
    pub err: String,
}

/// A fresh folder with copies of the rooms.
pub fn workshop() -> tempfile::TempDir {
    let folder = tempfile::tempdir().expect("a folder");
    for room in ROOMS {
        copy(&root().join(room), &folder.path().join(room));
    }
    folder
}

fn copy(from: &Path, to: &Path) {
    std::fs::create_dir(to).expect("a folder");
    for entry in std::fs::read_dir(from).expect("a folder") {
        let entry = entry.expect("an entry");
        let target = to.join(entry.file_name());
        if entry.path().is_dir() {
            copy(&entry.path(), &target);
        } else {
            std::fs::copy(entry.path(), target).expect("a copy");
        }
    }
}

/// Runs a line of a page in the folder, by the shell, with the program that was just built as `washout`.
///
/// `cargo run --release -- …` is that program too, `cargo run --release --example NAME -- …` the example that was built with it.
pub fn run(folder: &Path, line: &str) -> Said {
    let built = Path::new(env!("CARGO_BIN_EXE_washout"))
        .parent()
        .expect("a folder");
    let line = line.replace("cargo run --release -- ", "washout ");
    let line = match line.strip_prefix("cargo run --release --example ") {
        None => line,
        Some(rest) => {
            let (name, arguments) = rest.split_once(" -- ").unwrap_or((rest, ""));
            let example = built.join("examples").join(name);
            assert!(
                example.is_file(),
                "{} is not built: cargo test builds it, cargo test --test docs does not (cargo build --examples)",
                example.display()
            );
            format!("'{}' {arguments}", example.display())
        }
    };
    let path = std::env::var("PATH").unwrap_or_default();
    let output = Command::new("sh")
        .args(["-c", &line])
        .current_dir(folder)
        .env("PATH", format!("{}:{path}", built.display()))
        .output()
        .expect("a shell");
    Said {
        code: output.status.code(),
        out: String::from_utf8(output.stdout).expect("UTF-8"),
        err: String::from_utf8_lossy(&output.stderr).into_owned(),
    }
}
