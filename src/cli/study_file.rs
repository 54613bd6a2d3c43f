//! A study file that is to be written anew: as it was read, and over nothing else.

use std::fs;
use std::path::{Path, PathBuf};

use crate::export::file::{refuse_any, write_new};
use crate::export::lock::Lock;
use crate::export::place;
use crate::export::run::write_member;

use super::Failure;

/// A study as it was read, and where it goes with a change.
#[derive(Debug)]
pub struct StudyFile {
    /// Where it goes.
    pub target: PathBuf,
    /// As it was read.
    pub text: String,
    from: PathBuf,
    _lock: Lock,
}

impl StudyFile {
    /// Reads a study that goes back to its place, or to `output`, where no other file may stand. Until it is dropped no other
    /// washout changes it.
    ///
    /// # Errors
    /// If it cannot be read, another file stands where it goes, or another washout is changing it.
    pub fn read(from: &Path, output: Option<&PathBuf>) -> Result<StudyFile, Failure> {
        let target = output.map_or(from, PathBuf::as_path);
        let lock = Lock::on(&place::of_file(target)?)?;
        let study = StudyFile {
            target: target.to_path_buf(),
            text: text_of(from)?,
            from: from.to_path_buf(),
            _lock: lock,
        };
        if !study.goes_back() {
            refuse_any(&study.target)?;
        }
        Ok(study)
    }

    /// Writes it with a change, over itself only if it still is as it was read.
    ///
    /// # Errors
    /// If it is not, or it cannot be written.
    pub fn write(&self, text: &str) -> Result<(), Failure> {
        if !self.goes_back() {
            return Ok(write_new(&self.target, text.as_bytes())?);
        }
        if text_of(&self.from)? != self.text {
            return Err(Failure::Option {
                option: "--to",
                reason: format!(
                    "{} was changed while the effect was fitted, and stays as it is now; give the same command again",
                    self.from.display()
                ),
            });
        }
        let is_read = |bytes: &[u8]| bytes == self.text.as_bytes();
        write_member(&self.target, text.as_bytes(), "as it was read", is_read)?;
        Ok(())
    }

    fn goes_back(&self) -> bool {
        let whole = |path: &Path| path.canonicalize().ok();
        whole(&self.target).is_some_and(|target| Some(target) == whole(&self.from))
    }
}

fn text_of(path: &Path) -> Result<String, Failure> {
    fs::read_to_string(path).map_err(|error| Failure::Option {
        option: "--to",
        reason: format!("{}: {error}", path.display()),
    })
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_study_that_somebody_changed_meanwhile_is_not_written_over() {
        let folder = tempfile::tempdir().expect("a folder");
        let path = folder.path().join("study.toml");
        fs::write(&path, "read").expect("written");
        let study = StudyFile::read(&path, None).expect("a study");
        fs::write(&path, "edited").expect("written");
        let error = study.write("with an effect").expect_err("changed").to_string();
        assert!(error.contains("changed while"), "{error}");
        assert_eq!(fs::read_to_string(&path).expect("file"), "edited");
        drop(study);
        let study = StudyFile::read(&path, Some(&folder.path().join("./study.toml"))).expect("a study");
        let error = StudyFile::read(&path, None).expect_err("in use").to_string();
        assert!(error.contains("another washout"), "{error}");
        study.write("with an effect").expect("written over itself");
        assert!(StudyFile::read(&path, Some(&folder.path().join("other.toml"))).is_ok());
        fs::write(folder.path().join("other.toml"), "mine").expect("written");
        let error = StudyFile::read(&path, Some(&folder.path().join("other.toml"))).expect_err("a file");
        assert!(error.to_string().contains("exists already"), "{error}");
    }
}
