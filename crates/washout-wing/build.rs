//! Gives the crate the SHA-256 of the sources that it is built from.

fn main() -> std::io::Result<()> {
    washout_sources::give()
}
