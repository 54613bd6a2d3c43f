//! A design on the command line.

use std::path::{Path, PathBuf};

use clap::Args;

use crate::effects::{instead_of, named};
use crate::input::{Design, Loaded, seen_from};
use crate::wing::WingModel;

use super::memory::refuse_beyond;
use super::{Console, Failure};

/// A design file and what the command line changes in it.
#[derive(Debug, Clone, Args)]
pub struct DesignArguments {
    /// Design file
    pub design: PathBuf,
    /// Set a key of the design, e.g. flapping.frequency_hz=23; can be given many times
    #[arg(long, value_name = "KEY=VALUE")]
    pub set: Vec<String>,
    /// Switch an effect on, e.g. root-flexure=0.2; can be given many times
    #[arg(long, value_name = "NAME=STRENGTH")]
    pub effect: Vec<String>,
    /// Refine the mesh by this factor in both directions
    #[arg(long, value_name = "FACTOR", allow_negative_numbers = true)]
    pub refine: Option<f64>,
    /// Use this Gmsh mesh instead of making one
    #[arg(long, value_name = "FILE")]
    pub mesh: Option<PathBuf>,
    /// Solve a mesh that takes up to this, GB [default: what is free]
    #[arg(long, value_name = "GB", value_parser = gigabytes)]
    pub memory: Option<f64>,
}

impl DesignArguments {
    /// Reads the design and meshes the wing.
    pub fn meshed(&self, console: &Console) -> Result<WingModel, Failure> {
        let loaded = self.load(&[])?;
        console.progress().say(format!("meshing {}", loaded.design.name));
        Ok(WingModel::new(loaded)?)
    }

    /// The same, to be solved: refused where that takes more memory than there is.
    pub fn wing(&self, console: &Console) -> Result<WingModel, Failure> {
        let wing = self.meshed(console)?;
        refuse_beyond(&self.design, wing.mesh.nodes.len(), self.memory)?;
        Ok(wing)
    }

    /// A design file on its own terms.
    pub fn of_file(file: &Path, set: &[String], refine: Option<f64>) -> DesignArguments {
        DesignArguments {
            design: file.to_path_buf(),
            set: set.to_vec(),
            effect: Vec::new(),
            refine,
            mesh: None,
            memory: None,
        }
    }

    /// Reads the design with the changes of the command line, and `more` besides.
    pub fn load(&self, more: &[String]) -> Result<Loaded, Failure> {
        let mut sets = self.set.clone();
        sets.extend_from_slice(more);
        for effect in &self.effect {
            sets.push(strength(effect)?);
        }
        sets.extend(self.refine.map(|factor| format!("mesh.refine={factor}")));
        if let Some(file) = &self.mesh {
            is_there("--mesh", file)?;
            sets.push(format!("mesh.file={}", seen_from(&self.design, file).display()));
        }
        Ok(Design::load(&self.design, &sets)?)
    }
}

/// A size of memory, GB.
fn gigabytes(text: &str) -> Result<f64, String> {
    match text.parse::<f64>() {
        Ok(number) if number > 0.0 && number.is_finite() => Ok(number),
        _ => Err("give a number above 0, in GB".to_string()),
    }
}

/// `NAME=STRENGTH` as a key of the design.
fn strength(effect: &str) -> Result<String, Failure> {
    let refuse = |reason: String| {
        Err(Failure::Option {
            option: "--effect",
            reason,
        })
    };
    let Some((name, strength)) = effect.split_once('=') else {
        return refuse(format!(
            "{effect}: give its strength, e.g. --effect {effect}=0.2 (washout effects {effect})"
        ));
    };
    let (name, strength) = (name.trim(), strength.trim());
    if named(name).is_none() {
        return refuse(format!("there is no effect {name}; {}", instead_of(name)));
    }
    match strength.parse::<f64>() {
        Ok(number) if number.is_finite() => Ok(format!("effects.{name}.strength={number:?}")),
        _ => refuse(format!(
            "{name} = {strength}: its strength must be a number (washout effects {name})"
        )),
    }
}

/// Refuses a file of the command line that does not exist.
pub(super) fn is_there(option: &'static str, file: &Path) -> Result<(), Failure> {
    match file.exists() {
        true => Ok(()),
        false => Err(Failure::Option {
            option,
            reason: format!("{}: no such file", file.display()),
        }),
    }
}
