//! Gives the crate the SHA-256 of the sources that it is built from, and that of the versions of its dependencies.

use std::path::Path;

fn main() -> std::io::Result<()> {
    println!("cargo::rerun-if-changed=../../Cargo.lock");
    let versions = washout_sources::hash(Path::new("../.."), &["Cargo.lock"])?;
    println!("cargo::rustc-env=WASHOUT_DEPENDENCIES_SHA256={versions}");
    washout_sources::give()
}
