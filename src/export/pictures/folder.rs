//! The pictures of a folder that a verb wrote: those of a run are drawn from its files, all others stand in it.

use std::cell::RefCell;
use std::fs;
use std::path::Path;

use crate::export::ExportError;
use crate::export::file::input_file;
use crate::export::html::run;
use crate::export::html::still::still;
use crate::export::run::{SUMMARY, read_summary};
use crate::export::summary::RunSummary;
use crate::origin::InputFile;
use crate::plot::Figure;

use super::profile;
use super::write::sheets;

/// A picture by its name.
#[derive(Debug, Clone, PartialEq)]
pub struct Picture {
    /// What it is called, without ending.
    pub name: String,
    /// The picture, SVG.
    pub svg: String,
}

/// The pictures: of a run `wing`, `twist`, `air` and, where it was solved, `stroke`; of all others the SVG files, by name. With the
/// files that they are drawn from.
///
/// # Errors
/// If a file cannot be read or is not of a run, or a number is not finite.
pub fn pictures(folder: &Path) -> Result<(Vec<Picture>, Vec<InputFile>), ExportError> {
    match read_summary(folder) {
        Ok(summary) => of_run(folder, &summary),
        Err(ExportError::NoRun { .. } | ExportError::OtherRun { .. }) => standing(folder),
        Err(error) => Err(error),
    }
}

fn of_run(folder: &Path, summary: &RunSummary) -> Result<(Vec<Picture>, Vec<InputFile>), ExportError> {
    let files = RefCell::new(vec![input_file(&folder.join(SUMMARY))?]);
    let read = |name: &str| {
        let path = folder.join(name);
        let bytes = fs::read(&path).map_err(ExportError::file("read", &path))?;
        let file = InputFile::new(path.display().to_string(), &bytes);
        files.borrow_mut().push(file);
        Ok(bytes)
    };
    let (wing, strips) = run::drawn(summary, folder, &read)?;
    let mut pictures = vec![Picture {
        name: "wing".to_string(),
        svg: still(&wing),
    }];
    pictures.extend(drawn("twist", &profile::twist(summary))?);
    if !strips.is_empty() {
        pictures.extend(drawn("air", &profile::strips(&summary.name, &strips))?);
    }
    if summary.stroke.is_some() {
        pictures.extend(drawn("stroke", &profile::stroke(summary))?);
    }
    Ok((pictures, files.into_inner()))
}

/// The sheets of a figure.
fn drawn(name: &str, figure: &Figure) -> Result<Vec<Picture>, ExportError> {
    let sheets = sheets(figure).into_iter().enumerate();
    sheets
        .map(|(index, sheet)| {
            let name = match index {
                0 => name.to_string(),
                _ => format!("{name}-{}", index + 1),
            };
            Ok(Picture {
                name,
                svg: sheet.to_svg()?,
            })
        })
        .collect()
}

fn standing(folder: &Path) -> Result<(Vec<Picture>, Vec<InputFile>), ExportError> {
    let (mut pictures, mut files) = (Vec::new(), Vec::new());
    for entry in fs::read_dir(folder).map_err(ExportError::file("read", folder))? {
        let path = entry.map_err(ExportError::file("read", folder))?.path();
        if path.extension().is_none_or(|ending| ending != "svg") {
            continue;
        }
        let name = path
            .file_stem()
            .unwrap_or_default()
            .to_string_lossy()
            .into_owned();
        let svg = fs::read_to_string(&path).map_err(ExportError::file("read", &path))?;
        files.push(InputFile::new(path.display().to_string(), svg.as_bytes()));
        pictures.push(Picture { name, svg });
    }
    pictures.sort_by(|a, b| a.name.cmp(&b.name));
    files.sort_by(|a, b| a.file.cmp(&b.file));
    Ok((pictures, files))
}
