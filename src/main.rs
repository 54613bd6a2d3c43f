//! The `washout` program.

use std::process::ExitCode;

fn main() -> ExitCode {
    washout::cli::main()
}
