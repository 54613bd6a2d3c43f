//! `washout init`: a commented design file to start from.

use std::fs::OpenOptions;
use std::io::{self, Write};
use std::path::PathBuf;

use clap::Args;
use schemars::JsonSchema;
use serde::Serialize;

use crate::export::ExportError;

use super::{Console, Failure};

const TEMPLATE: &str = include_str!("init_design.toml");

/// Arguments of `washout init`.
#[derive(Debug, Args)]
#[command(after_help = "Examples:
  washout init my-wing                          writes my-wing.toml here
  washout init my-wing --output designs         writes designs/my-wing.toml
  washout solve my-wing.toml                    solves it")]
pub struct Init {
    /// Name of the wing: letters, digits, '-' and '_'
    pub name: String,
    /// Folder to write into [default: this one]
    #[arg(long, short, value_name = "DIR")]
    pub output: Option<PathBuf>,
}

/// What `washout init` wrote.
#[derive(Debug, Clone, PartialEq, Serialize, JsonSchema)]
pub struct InitReport {
    /// The design file.
    pub file: String,
}

impl Init {
    /// Writes the file; an existing one is never touched.
    pub fn run(&self, console: &Console) -> Result<(), Failure> {
        let folder = self.output.clone().unwrap_or_default();
        let path = folder.join(format!("{}.toml", checked(&self.name)?));
        let write = || {
            let mut file = OpenOptions::new().write(true).create_new(true).open(&path)?;
            file.write_all(design(&self.name).as_bytes())
        };
        match write() {
            Ok(()) => {}
            Err(error) if error.kind() == io::ErrorKind::AlreadyExists => {
                return Err(Failure::Exists { path });
            }
            Err(error) => return Err(ExportError::file("write", &path)(error).into()),
        }
        let file = path.display().to_string();
        let page = format!("{file} written; solve it with: washout solve {file}\n");
        console.result(&page, &InitReport { file })
    }
}

/// The text of a design with this name.
fn design(name: &str) -> String {
    TEMPLATE.replace("NAME", name)
}

fn checked(name: &str) -> Result<&str, Failure> {
    let allowed = |c: char| c.is_ascii_alphanumeric() || c == '-' || c == '_';
    if name.starts_with(|c: char| c.is_ascii_alphanumeric()) && name.chars().all(allowed) {
        Ok(name)
    } else {
        Err(Failure::Name {
            name: name.to_string(),
        })
    }
}

#[cfg(test)]
mod tests {
    use super::*;
    use crate::input::Design;

    #[test]
    fn the_template_is_a_design_without_faults() {
        let found = Design::from_toml(&design("first-wing"), "first-wing.toml");
        let found = found.unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(found.name, "first-wing");
        assert_eq!(found.assumptions().len(), 2);
    }

    #[test]
    fn a_name_with_a_path_or_a_space_is_refused() {
        for name in ["", "../wing", "my wing", "-x", "flügel", "a.toml"] {
            assert!(checked(name).is_err(), "{name:?}");
        }
        assert_eq!(checked("twist-v2_b").expect("a name"), "twist-v2_b");
    }
}
