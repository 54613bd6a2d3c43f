//! What can go wrong when results become files.

use std::io;
use std::path::PathBuf;

#[cfg(feature = "cli")]
use crate::plot::PlotError;

/// Why a result could not be written.
#[derive(Debug, thiserror::Error)]
pub enum ExportError {
    /// The file system refused.
    #[error("cannot {action} {}: {source}; {}", path.display(), cure(source))]
    File {
        /// What was tried: "create", "write", ….
        action: &'static str,
        /// The file or folder.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A folder holds something that washout did not write there; replacing would delete it.
    #[error(
        "{} holds '{entry}', which washout did not write there; \
         move it away, or give another folder with --output",
        path.display()
    )]
    ForeignEntry {
        /// The folder that was to be replaced.
        path: PathBuf,
        /// The first entry that is not known.
        entry: String,
    },
    /// A folder without a record holds something; replacing would delete it.
    #[error(
        "{} holds '{entry}', and no record that washout wrote it (.washout.json; the first versions kept none); \
         move it away, or give another folder with --output",
        path.display()
    )]
    NoRecord {
        /// The folder that was to be replaced.
        path: PathBuf,
        /// The first entry.
        entry: String,
    },
    /// A file of the folder is not what washout wrote any more; replacing would lose the change.
    #[error(
        "{} holds '{entry}', which was changed since washout wrote it; \
         move it away, or give another folder with --output",
        path.display()
    )]
    ChangedEntry {
        /// The folder that was to be replaced.
        path: PathBuf,
        /// The first file that was changed.
        entry: String,
    },
    /// The folder holds what another verb wrote.
    #[error(
        "{} holds what washout {verb} wrote; move it away, or give another folder with --output",
        path.display()
    )]
    OtherVerb {
        /// The folder that was to be replaced.
        path: PathBuf,
        /// The verb.
        verb: String,
    },
    /// A file stands where one is to be written.
    #[error(
        "{} exists already{}; give another name, or move it away",
        path.display(),
        match *unless {
            "" => String::new(),
            what => format!(" and is not {what}"),
        }
    )]
    Exists {
        /// The file.
        path: PathBuf,
        /// What it would have to be to be written over; empty if nothing is.
        unless: &'static str,
    },
    /// Another process is writing there.
    #[error(
        "another washout is writing {}; wait until it is done, or give another place with --output",
        path.display()
    )]
    InUse {
        /// The file or folder.
        path: PathBuf,
    },
    /// What stands where an output is to be written is nothing that can be replaced.
    #[error("{} {what}; give another place with --output", path.display())]
    NotPlain {
        /// What was given.
        path: PathBuf,
        /// What it is.
        what: &'static str,
    },
    /// A folder that was named as a run is none.
    #[error("{} is not the folder of a run: no readable summary.json in it ({source}); give the folder that `washout solve` wrote", path.display())]
    NoRun {
        /// The folder.
        path: PathBuf,
        /// What the system said.
        source: io::Error,
    },
    /// A folder without the record that every run has.
    #[error("{} is not the folder of a run: it has no record .washout.json of what was written there; give the folder that a verb of washout wrote", path.display())]
    Unrecorded {
        /// The folder.
        path: PathBuf,
    },
    /// A file that stands where the plan of a sweep should.
    #[error("{} is not the plan of a sweep ({reason}); move it away, or give another folder with --output", path.display())]
    NoPlan {
        /// The file.
        path: PathBuf,
        /// What does not fit.
        reason: String,
    },
    /// A summary that this version does not understand.
    #[error("{} was not written by this version of washout ({reason}); solve that design again", path.display())]
    ForeignSummary {
        /// The file.
        path: PathBuf,
        /// What does not fit.
        reason: String,
    },
    /// A document of another verb where that of a solved wing is wanted.
    #[error("{} is of a run of `washout {kind}`; here belongs a run that washout solve wrote", path.display())]
    OtherRun {
        /// The file.
        path: PathBuf,
        /// What it says it is.
        kind: String,
    },
    /// A picture cannot be drawn.
    #[cfg(feature = "cli")]
    #[error(transparent)]
    Picture(#[from] PlotError),
    /// A part of the wing that another program cannot model.
    #[error("{what} has no counterpart there; {cure}")]
    NoCounterpart {
        /// The part.
        what: &'static str,
        /// What to do.
        cure: &'static str,
    },
    /// An array does not fit the grid that it belongs to.
    #[error("array '{name}' has {found} values, the grid needs {expected}; please report this as a bug")]
    ArrayLength {
        /// Name of the array.
        name: String,
        /// Values that the grid needs.
        expected: usize,
        /// Values that it has.
        found: usize,
    },
    /// An array cannot be written under its name.
    #[error("array name '{name}' is empty, repeated or has white space; please report this as a bug")]
    ArrayName {
        /// The name.
        name: String,
    },
    /// A cell names a point that is not there.
    #[error("cell {cell} names point {point}, but there are {points}; please report this as a bug")]
    CellPoint {
        /// Index of the cell, triangles first.
        cell: usize,
        /// The point it names.
        point: usize,
        /// Number of points.
        points: usize,
    },
    /// A value that is not a finite number; no file may hold one.
    #[error("'{name}' would hold {value} at entry {index}; please report this as a bug")]
    NotFinite {
        /// Name of the array or field.
        name: String,
        /// Index in it.
        index: usize,
        /// NaN or an infinity.
        value: f64,
    },
    /// The encoder of a format refused.
    #[error("cannot encode {format}: {reason}; please report this as a bug")]
    Encoding {
        /// Format.
        format: &'static str,
        /// What it said.
        reason: String,
    },
}

impl ExportError {
    /// Whether what was asked for is at fault: a folder that is no run, or an output in whose place something stands.
    pub fn is_of_input(&self) -> bool {
        #[cfg(feature = "cli")]
        if matches!(self, ExportError::Picture(PlotError::TooLarge { .. })) {
            return true;
        }
        matches!(
            self,
            ExportError::NoRun { .. }
                | ExportError::Unrecorded { .. }
                | ExportError::NoPlan { .. }
                | ExportError::ForeignSummary { .. }
                | ExportError::OtherRun { .. }
                | ExportError::NoCounterpart { .. }
                | ExportError::ForeignEntry { .. }
                | ExportError::NoRecord { .. }
                | ExportError::ChangedEntry { .. }
                | ExportError::OtherVerb { .. }
                | ExportError::Exists { .. }
                | ExportError::NotPlain { .. }
        )
    }

    /// For `map_err`: an error of the file system with what was tried and where.
    pub fn file(action: &'static str, path: impl Into<PathBuf>) -> impl FnOnce(io::Error) -> ExportError {
        let path = path.into();
        move |source| ExportError::File { action, path, source }
    }
}

/// What the user can do about an error of the file system.
fn cure(error: &io::Error) -> &'static str {
    match error.kind() {
        io::ErrorKind::StorageFull | io::ErrorKind::QuotaExceeded => {
            "free some space there, or give a folder on another disk with --output"
        }
        io::ErrorKind::PermissionDenied | io::ErrorKind::ReadOnlyFilesystem => {
            "allow writing there, or give a folder that you may write to with --output"
        }
        io::ErrorKind::NotADirectory | io::ErrorKind::AlreadyExists => {
            "a part of that path is a file; give another folder with --output"
        }
        _ => "give another folder with --output",
    }
}
