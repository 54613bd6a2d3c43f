//! What the command line does for a session: it says the commands that would do the same, and saves by them.

use std::path::Path;

use crate::progress::Progress;

use super::opened::Readings;
use super::refusal::Refusal;
use super::values::Step;

/// What is to be saved.
#[derive(Debug, Clone)]
pub enum Save<'a> {
    /// A design with what changes it.
    Design {
        /// Its file.
        path: &'a Path,
        /// Its name.
        name: &'a str,
        /// What changes it, `key=value`.
        sets: &'a [String],
    },
    /// A study.
    Study {
        /// The file that was opened.
        path: &'a Path,
        /// Its name.
        name: &'a str,
        /// What was added to it, one after the other.
        steps: &'a [Step],
        /// What changes all its designs besides, `key=value`.
        sets: &'a [String],
        /// The table that it was made of, if it stands in no file yet.
        readings: Option<&'a Readings>,
    },
}

/// What was written.
#[derive(Debug, Clone, PartialEq, Default, serde::Serialize)]
pub struct Saved {
    /// Files and folders.
    pub files: Vec<String>,
    /// The commands that do the same.
    pub commands: Vec<String>,
}

/// The verbs that a session asks.
pub trait Verbs: Send + Sync {
    /// The commands that would save it; nothing is written.
    fn commands(&self, save: &Save) -> Vec<String>;

    /// Saves.
    ///
    /// # Errors
    /// If something cannot be written.
    fn save(&self, save: &Save, progress: &Progress) -> Result<Saved, Refusal>;
}

/// Verbs of a program that saves nothing.
#[derive(Debug, Clone, Copy, Default)]
pub struct SavesNothing;

impl Verbs for SavesNothing {
    fn commands(&self, _save: &Save) -> Vec<String> {
        Vec::new()
    }

    fn save(&self, _save: &Save, _progress: &Progress) -> Result<Saved, Refusal> {
        Ok(Saved::default())
    }
}
