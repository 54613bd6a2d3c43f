//! Frames and marks that a page works on, shared by all who ask; saved as a video file and its marks.

use std::fs;
use std::io;
use std::path::{Path, PathBuf};
use std::sync::{Mutex, MutexGuard, PoisonError};

use serde::Serialize;

use super::images::Images;
use super::marks::Marks;
use super::told::Told;
use crate::export::file::{refuse_other, write_over};
use crate::export::marks::{marks_csv, video_toml};
use crate::export::video::{MeasureReport, is_measured};
use crate::input::video::{LoadedVideo, Video};
use crate::live::refusal::Refusal;
use crate::live::verbs::Saved;

/// What a file must be to be replaced.
const OURS: &str = "the file that this page read or wrote, unchanged since";

/// Frames with their marks.
#[derive(Debug)]
pub struct Marking {
    folder: PathBuf,
    images: Images,
    held: Mutex<Held>,
}

#[derive(Debug)]
struct Held {
    marks: Marks,
    revision: u64,
    saved: u64,
    /// Where the description stands, or is to stand.
    path: PathBuf,
    /// What the description and the marks held when they were last read or written here.
    on_disk: [Option<Vec<u8>>; 2],
}

/// All that the page shows.
#[derive(Debug, Clone, PartialEq, Serialize)]
pub struct MarkingState {
    /// Grows with each change.
    pub revision: u64,
    /// Whether something was changed since the files were written.
    pub is_dirty: bool,
    /// The folder.
    pub folder: String,
    /// The file that is written.
    pub file: String,
    /// Names of the frames, in their order.
    pub frames: Vec<String>,
    /// What was clicked.
    pub marks: Marks,
    /// What it gives.
    pub told: Told,
}

impl Marking {
    /// Opens a folder of images, with what was saved there before.
    ///
    /// # Errors
    /// If it has no image, or what was saved there cannot be read.
    pub fn open(folder: &Path) -> Result<Marking, Refusal> {
        let images = Images::of(folder)?;
        let found = Marks::load(folder, &images.names())?;
        let is_new = found.is_none();
        let (path, marks) = found.unwrap_or_else(|| {
            let marks = Marks::new(folder);
            (folder.join(format!("{}.toml", marks.video.name)), marks)
        });
        let on_disk = if is_new {
            [None, None]
        } else {
            [bytes_of(&path)?, bytes_of(&folder.join(&marks.video.marks))?]
        };
        Ok(Marking {
            folder: folder.to_path_buf(),
            images,
            held: Mutex::new(Held {
                marks,
                revision: 1,
                saved: 1,
                path,
                on_disk,
            }),
        })
    }

    /// The frames.
    pub fn images(&self) -> &Images {
        &self.images
    }

    /// Everything as it is.
    pub fn state(&self) -> MarkingState {
        let (marks, revision, saved, path) = {
            let held = self.held();
            (held.marks.clone(), held.revision, held.saved, held.path.clone())
        };
        let frames = self.images.names();
        MarkingState {
            revision,
            is_dirty: revision != saved,
            folder: self.folder.display().to_string(),
            file: path.display().to_string(),
            told: Told::of(&marks, &frames),
            frames,
            marks,
        }
    }

    /// Takes what a page holds now; `revision`: what it was made of.
    ///
    /// # Errors
    /// If another page changed it meanwhile, or it is no mark.
    pub fn change(&self, revision: u64, marks: Marks) -> Result<MarkingState, Refusal> {
        marks.check(&self.images.names())?;
        {
            let mut held = self.held();
            if held.revision != revision {
                let cure = "Load this page again";
                return Err(Refusal::new("The marks were changed in another window.").cured(cure));
            }
            // where they are written is not for a page to say
            let own = held.marks.video.marks.clone();
            held.marks = marks;
            held.marks.video.marks = own;
            held.revision += 1;
        }
        Ok(self.state())
    }

    /// Writes the description and the marks, also where points are still missing, and the measurement where none is; says the commands
    /// that do the same.
    ///
    /// # Errors
    /// If the description is not whole, somebody else changed the files, or they cannot be written.
    pub fn save(&self) -> Result<Saved, Refusal> {
        let mut held = self.held();
        let toml = video_toml(&held.marks.video);
        Video::read(&held.path.display().to_string(), &toml)?;
        let csv = marks_csv(&held.marks.clicks, &self.images.names());
        let places = [held.path.clone(), self.folder.join(&held.marks.video.marks)];
        let texts = [toml.into_bytes(), csv.into_bytes()];
        for (place, known) in places.iter().zip(&held.on_disk) {
            refuse_other(place, OURS, |bytes| known.as_deref() == Some(bytes)).map_err(Refusal::new)?;
        }
        // the marks first: a description never names marks that are not there
        for k in [1, 0] {
            let known = held.on_disk[k].clone();
            write_over(&places[k], &texts[k], OURS, |bytes| {
                known.as_deref() == Some(bytes)
            })
            .map_err(Refusal::new)?;
            held.on_disk[k] = Some(texts[k].clone());
        }
        held.saved = held.revision;
        let told = Told::of(&held.marks, &self.images.names());
        let measured = self.folder.join(format!("{}.csv", held.marks.video.name));
        let is_whole = told.report.is_some() && told.lacks.is_empty() && !told.is_assumed;
        let mut files = places.to_vec();
        if is_whole {
            // as the command does it, of the files as they stand
            let loaded = LoadedVideo::load(&places[0])?;
            let report = MeasureReport::new(&loaded, measured.display().to_string());
            let what = "a measurement that washout measure wrote";
            write_over(&measured, report.csv(&loaded).as_bytes(), what, is_measured).map_err(Refusal::new)?;
            files.push(measured.clone());
        }
        let shown = |path: &Path| path.display().to_string();
        // compare takes one frame at a time
        let is_loaded = |name: &String| {
            let mut clicks = held.marks.clicks.iter();
            held.marks.video.rest.as_ref() != Some(name) && clicks.any(|click| click.frame == *name)
        };
        let case = self.images.names().into_iter().find(is_loaded);
        let case = case.map_or(String::new(), |name| format!(" --case {name}"));
        let measured = quoted(&measured);
        Ok(Saved {
            files: files.iter().map(|path| shown(path)).collect(),
            commands: vec![
                format!(
                    "washout measure {} --force --output {measured}",
                    quoted(&places[0])
                ),
                format!("washout compare DESIGN --with {measured}{case}"),
            ],
        })
    }

    fn held(&self) -> MutexGuard<'_, Held> {
        self.held.lock().unwrap_or_else(PoisonError::into_inner)
    }
}

fn bytes_of(path: &Path) -> Result<Option<Vec<u8>>, Refusal> {
    match fs::read(path) {
        Ok(bytes) => Ok(Some(bytes)),
        Err(error) if error.kind() == io::ErrorKind::NotFound => Ok(None),
        Err(error) => Err(Refusal::new(format!("{}: {error}", path.display()))),
    }
}

/// As a shell takes it.
fn quoted(path: &Path) -> String {
    let text = path.display().to_string();
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "/._-".contains(c);
    match text.chars().all(is_plain) {
        true => text,
        false => format!("'{}'", text.replace('\'', "'\\''")),
    }
}
