//! `washout man`: a manual page for every verb, made from the command line's own definition.

use std::path::PathBuf;

use clap::{Args, Command};
use clap_mangen::Man as Page;

use crate::export::ExportError;
use crate::export::file::write_over;

use super::{Console, Failure};

/// Arguments of `washout man`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout man ~/.local/share/man/man1           then: man washout-solve
  washout man pages && man pages/washout.1")]
pub struct Man {
    /// Folder to write into; it is made if there is none
    #[arg(value_name = "DIR")]
    pub output: PathBuf,
}

impl Man {
    /// Writes washout.1 and washout-VERB.1 for the whole command line.
    pub fn run(&self, mut whole: Command, console: &Console) -> Result<(), Failure> {
        std::fs::create_dir_all(&self.output).map_err(ExportError::file("create", &self.output))?;
        whole.build();
        let verbs: Vec<Command> = whole.get_subcommands().cloned().collect();
        let verbs = verbs.into_iter().filter(|verb| verb.get_name() != "help");
        // a verb that was built calls itself by both names in its page
        let named = verbs.map(|verb| (format!("washout-{}", verb.get_name()), verb));
        let mut written = Vec::new();
        for (name, command) in [("washout".to_string(), whole.clone())].into_iter().chain(named) {
            let path = self.output.join(format!("{name}.1"));
            let mut page = Vec::new();
            Page::new(command).render(&mut page).map_err(Failure::Output)?;
            let title = format!(".TH {name} 1 ");
            let is_own = |bytes: &[u8]| String::from_utf8_lossy(bytes).contains(&title);
            write_over(&path, &page, "a page of washout man", is_own)?;
            written.push(path.display().to_string());
        }
        console.names(&(written.join("\n") + "\n"), &written)
    }
}
