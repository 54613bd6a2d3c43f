//! What takes long to find and does not depend on what was measured, kept between runs in a folder under what it was made of. It is made anew
//! where it is lost or damaged; nobody is told.

use std::fs::{self, File};
use std::io::{self, Write};
use std::path::{Path, PathBuf};
use std::time::SystemTime;

use serde::Serialize;
use serde::de::DeserializeOwned;
use serde_json::Value;

use crate::origin::sha256;

/// Entries that are kept at most; those used longest ago go.
const MOST: usize = 128;
/// Variable that names another folder than the user's; empty: nothing is kept.
const FOLDER: &str = "WASHOUT_CACHE";

/// A folder of kept answers, or none.
#[derive(Debug, Clone, Default)]
pub struct Cache {
    folder: Option<PathBuf>,
}

impl Cache {
    /// Nothing is kept.
    pub fn none() -> Cache {
        Cache::default()
    }

    /// In this folder, which is made where there is none.
    pub fn in_folder(folder: impl Into<PathBuf>) -> Cache {
        Cache {
            folder: Some(folder.into()),
        }
    }

    /// In the folder that the environment names: `WASHOUT_CACHE`, or `washout` in `XDG_CACHE_HOME`, or `.cache/washout` in the home of the
    /// user; none if `WASHOUT_CACHE` is empty.
    pub fn of_user() -> Cache {
        let named = |variable: &str| std::env::var_os(variable);
        match (named(FOLDER), named("XDG_CACHE_HOME"), named("HOME")) {
            (Some(own), ..) if own.is_empty() => Cache::none(),
            (Some(own), ..) => Cache::in_folder(own),
            (None, Some(cache), _) if !cache.is_empty() => {
                Cache::in_folder(PathBuf::from(cache).join("washout"))
            }
            (None, _, Some(home)) => Cache::in_folder(PathBuf::from(home).join(".cache/washout")),
            _ => Cache::none(),
        }
    }

    /// What was kept under these words; none where it was lost, damaged, or is of another form.
    pub fn read<T: DeserializeOwned>(&self, made_of: &str) -> Option<T> {
        let file = self.file(made_of)?;
        let tree: Value = serde_json::from_slice(&fs::read(&file).ok()?).ok()?;
        // used just now
        let _ = File::options()
            .append(true)
            .open(&file)
            .and_then(|file| file.set_modified(SystemTime::now()));
        T::deserialize(&tree).ok()
    }

    /// Keeps it. To keep is a convenience: what cannot be written is made anew the next time.
    pub fn keep(&self, made_of: &str, kept: &impl Serialize) {
        if let Some(file) = self.file(made_of) {
            let _ = write(&file, kept);
        }
    }

    fn file(&self, made_of: &str) -> Option<PathBuf> {
        let folder = self.folder.as_ref()?;
        Some(folder.join(format!("{}.json", sha256(made_of.as_bytes()))))
    }
}

fn write(file: &Path, kept: &impl Serialize) -> io::Result<()> {
    let folder = file.parent().unwrap_or(file);
    fs::create_dir_all(folder)?;
    let mut whole = tempfile::NamedTempFile::new_in(folder)?;
    whole.write_all(&serde_json::to_vec(&serde_json::to_value(kept)?)?)?;
    whole.persist(file).map_err(|error| error.error)?;
    let mut all: Vec<(SystemTime, PathBuf)> = fs::read_dir(folder)?
        .filter_map(|entry| {
            let entry = entry.ok()?;
            Some((entry.metadata().ok()?.modified().ok()?, entry.path()))
        })
        .filter(|(_, path)| path.extension().is_some_and(|own| own == "json"))
        .collect();
    all.sort();
    let surplus = all.len().saturating_sub(MOST);
    for (_, path) in all.into_iter().take(surplus) {
        fs::remove_file(path)?;
    }
    Ok(())
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn what_is_kept_is_read_under_the_same_words_alone_and_the_oldest_go() {
        let folder = tempfile::tempdir().expect("a folder");
        let cache = Cache::in_folder(folder.path().join("within"));
        cache.keep("first", &[1.5, f64::MIN_POSITIVE]);
        assert_eq!(
            cache.read::<Vec<f64>>("first"),
            Some(vec![1.5, f64::MIN_POSITIVE])
        );
        assert_eq!(cache.read::<Vec<f64>>("second"), None);
        assert_eq!(cache.read::<String>("first"), None, "of another form");
        let old = cache.file("first").expect("a file");
        let file = File::options().append(true).open(&old).expect("the file");
        file.set_modified(SystemTime::UNIX_EPOCH).expect("its time");
        for index in 0..MOST {
            cache.keep(&index.to_string(), &index);
        }
        assert_eq!(cache.read::<Vec<f64>>("first"), None);
        assert_eq!(cache.read::<usize>("0"), Some(0));
    }

    #[test]
    fn a_damaged_entry_is_none() {
        let folder = tempfile::tempdir().expect("a folder");
        let cache = Cache::in_folder(folder.path());
        cache.keep("one", &1);
        fs::write(cache.file("one").expect("a file"), "{").expect("written");
        assert_eq!(cache.read::<i32>("one"), None);
        Cache::none().keep("one", &1);
        assert_eq!(Cache::none().read::<i32>("one"), None);
    }
}
