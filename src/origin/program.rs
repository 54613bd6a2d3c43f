//! What this program is known by.
//!
//! The hash of its sources is taken when it is built: it costs nothing at run time, is the same on every machine, and also
//! tells the Python package, whose process is Python's. Code that another program adds stands in that program's executable.

use std::path::PathBuf;
use std::sync::OnceLock;
use std::sync::atomic::{AtomicBool, Ordering};
use std::{env, fs, io};

use super::sha256;

const SOURCES: &str = env!("WASHOUT_SOURCES_SHA256");

static HAS_OWN_CODE: AtomicBool = AtomicBool::new(false);
static SHA256: OnceLock<String> = OnceLock::new();

/// SHA-256 of the program, 64 hexadecimal digits.
pub fn program_sha256() -> &'static str {
    SHA256.get_or_init(|| match HAS_OWN_CODE.load(Ordering::Relaxed) {
        true => of_executable().unwrap_or_else(|_| SOURCES.to_string()),
        false => SOURCES.to_string(),
    })
}

/// Says that this program computes with code that is not washout's, so that it is known by its executable too; to be said before
/// anything is computed.
pub fn with_code_of_its_own() {
    HAS_OWN_CODE.store(true, Ordering::Relaxed);
}

fn of_executable() -> io::Result<String> {
    // what runs, even where another was put in its place meanwhile
    let path = match cfg!(target_os = "linux") {
        true => PathBuf::from("/proc/self/exe"),
        false => env::current_exe()?,
    };
    Ok(sha256(&[SOURCES.as_bytes(), fs::read(path)?.as_slice()].concat()))
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn an_executable_is_known_by_more_than_the_sources_of_washout() {
        let found = of_executable().expect("this test runs");
        assert_eq!(found.len(), SOURCES.len());
        assert_ne!(found, SOURCES);
    }
}
