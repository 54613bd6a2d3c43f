//! The end of a verb that writes a folder.

use std::path::PathBuf;

use serde::de::DeserializeOwned;

use crate::export::html::Document;
use crate::export::html::folder::add as add_report;
use crate::export::json;
use crate::export::run::RunFolder;
use crate::page::Page;

use super::{Console, Failure};

/// Ends the folder of a verb: its report where what the verb says is given for one, its document, and then it stands in its place.
///
/// # Errors
/// If it cannot be written, or the user asked to stop.
pub fn finished<T>(
    mut folder: RunFolder,
    answer: Option<&Page>,
    document: &T,
    console: &Console,
) -> Result<PathBuf, Failure>
where
    T: json::Document + DeserializeOwned + PartialEq,
{
    if let Some(answer) = answer {
        add_report(&mut folder, answer, Document::new(answer.kind, document)?)?;
    }
    folder.add_summary(document)?;
    console.progress().check()?;
    Ok(folder.commit()?)
}
