//! Gives the crate the SHA-256 of the sources that it is built from, and that of what it is built into: the program above it, and the
//! versions of all dependencies. A crate from a registry stands alone, and is known by its version.

use std::path::Path;

const ABOVE: [&str; 2] = ["Cargo.lock", "src"];

fn main() -> std::io::Result<()> {
    let root = Path::new("../..");
    for part in ABOVE {
        println!("cargo::rerun-if-changed={}", root.join(part).display());
    }
    println!(
        "cargo::rustc-env=WASHOUT_ABOVE_SHA256={}",
        washout_sources::hash(root, &ABOVE)?
    );
    washout_sources::give()
}
