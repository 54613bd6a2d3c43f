//! `washout completions`: what a shell needs to complete verbs and options, made from the command line's own definition.

use clap::{Args, Command};
use clap_complete::{Shell, generate};

use super::{Console, Failure};

/// Arguments of `washout completions`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout completions bash > ~/.local/share/bash-completion/completions/washout
  # with fpath+=~/.zfunc before compinit
  washout completions zsh > ~/.zfunc/_washout
  washout completions fish > ~/.config/fish/completions/washout.fish")]
pub struct Completions {
    /// The shell
    pub shell: Shell,
}

impl Completions {
    /// Prints the script for the whole command line.
    pub fn run(&self, mut whole: Command, console: &Console) -> Result<(), Failure> {
        let mut script = Vec::new();
        generate(self.shell, &mut whole, "washout", &mut script);
        console.text(&script)
    }
}
