//! The `washout` program: parse, call one verb, report how it ended by the exit code.

use std::process::ExitCode;

use clap::Parser;
use washout::cli::{self, Arguments};

fn main() -> ExitCode {
    let arguments = match Arguments::try_parse() {
        Ok(arguments) => arguments,
        Err(error) => {
            // Nobody is left to tell if even this cannot be printed.
            let _ = error.print();
            return ExitCode::from(error.exit_code() as u8);
        }
    };
    match cli::run(&arguments) {
        Ok(()) => ExitCode::SUCCESS,
        Err(failure) => {
            cli::console::complain(&failure);
            ExitCode::from(failure.exit_code())
        }
    }
}
