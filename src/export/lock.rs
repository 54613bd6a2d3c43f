//! One washout at a time changes what stands under a name.

use std::fs::{self, File, TryLockError};
use std::io;
use std::path::{Path, PathBuf};

use super::ExportError;

/// A lock on a name: a hidden file beside it, `.NAME.lock`. It is let go when dropped, and by the system when the program is killed.
#[derive(Debug)]
pub struct Lock {
    file: File,
    path: PathBuf,
}

impl Lock {
    /// Takes the lock on a place; where the disk knows no locks, there is nothing to take.
    ///
    /// # Errors
    /// If another washout has it, or the file cannot be written.
    pub fn on(place: &Path) -> Result<Lock, ExportError> {
        Lock::taken(place, |file| match file.try_lock() {
            Err(TryLockError::WouldBlock) => Err(ExportError::InUse {
                path: place.to_path_buf(),
            }),
            Err(TryLockError::Error(_)) => Ok(false),
            Ok(()) => Ok(true),
        })
    }

    /// The same for a moment's work: waits for whoever has it.
    ///
    /// # Errors
    /// If the file cannot be written.
    pub fn when_free(place: &Path) -> Result<Lock, ExportError> {
        Lock::taken(place, |file| Ok(file.lock().is_ok()))
    }

    /// Takes it by `take`, which says whether the disk knows locks.
    fn taken(place: &Path, take: impl Fn(&File) -> Result<bool, ExportError>) -> Result<Lock, ExportError> {
        let name = place.file_name().unwrap_or_default().to_string_lossy();
        let path = place.with_file_name(format!(".{name}.lock"));
        let fault = |error: io::Error| ExportError::file("write", place)(error);
        loop {
            let options = File::options().write(true).create(true).truncate(false).clone();
            let file = options.open(&path).map_err(fault)?;
            // whoever had it may have removed it meanwhile
            if !take(&file)? || is_at(&file, &path) {
                return Ok(Lock { file, path });
            }
        }
    }

    /// Whether a file is a lock that a killed program left.
    pub fn is_left(path: &Path) -> bool {
        let is_empty = fs::symlink_metadata(path).is_ok_and(|entry| entry.is_file() && entry.len() == 0);
        is_empty && File::open(path).is_ok_and(|file| file.try_lock().is_ok())
    }
}

impl Drop for Lock {
    fn drop(&mut self) {
        // while it is still held: whoever waits for it sees that it is gone
        let _ = fs::remove_file(&self.path);
        let _ = self.file.unlock();
    }
}

#[cfg(unix)]
fn is_at(file: &File, path: &Path) -> bool {
    use std::os::unix::fs::MetadataExt;
    match (file.metadata(), fs::metadata(path)) {
        (Ok(own), Ok(there)) => (own.dev(), own.ino()) == (there.dev(), there.ino()),
        _ => false,
    }
}

#[cfg(not(unix))]
fn is_at(_: &File, path: &Path) -> bool {
    path.exists()
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_name_is_locked_for_one_until_it_is_let_go() {
        let folder = tempfile::tempdir().expect("a folder");
        let place = folder.path().join("run");
        let first = Lock::on(&place).expect("free");
        let error = Lock::on(&place).expect_err("taken").to_string();
        assert!(
            error.contains("another washout") && error.contains("run"),
            "{error}"
        );
        Lock::on(&folder.path().join("other")).expect("another name");
        assert!(!Lock::is_left(&first.path));
        drop(first);
        fs::write(folder.path().join(".run.lock"), "").expect("written");
        assert!(Lock::is_left(&folder.path().join(".run.lock")));
        Lock::on(&place).expect("free again");
        assert_eq!(fs::read_dir(folder.path()).expect("readable").count(), 0);
    }

    #[test]
    fn of_many_at_once_one_at_a_time_has_it() {
        let folder = tempfile::tempdir().expect("a folder");
        let (place, count) = (folder.path().join("run"), folder.path().join("count"));
        fs::write(&count, "0").expect("written");
        let add = || {
            let mut done = 0;
            while done < 50 {
                let lock = match done % 2 {
                    0 => Lock::on(&place),
                    _ => Lock::when_free(&place),
                };
                let Ok(_lock) = lock else { continue };
                let read: u32 = fs::read_to_string(&count)
                    .expect("read")
                    .parse()
                    .expect("a number");
                fs::write(&count, (read + 1).to_string()).expect("written");
                done += 1;
            }
        };
        std::thread::scope(|scope| {
            for _ in 0..4 {
                scope.spawn(add);
            }
        });
        assert_eq!(fs::read_to_string(&count).expect("read"), "200");
    }
}
