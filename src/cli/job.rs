//! How the tasks of a work are started by themselves.

use std::path::{Path, PathBuf};

use super::Failure;

/// How the tasks of a work are started by themselves.
#[derive(Debug, Clone)]
pub struct Job {
    /// Folder of the results; scripts and logs go to `slurm` in it.
    pub folder: PathBuf,
    /// Words after the program, to which `--task N` is added.
    pub words: Vec<String>,
    /// Where they are said; none: anywhere.
    pub from: Option<PathBuf>,
    /// How the user goes on after an interruption.
    pub again: String,
}

impl Job {
    /// Tasks that are started by the command line of this process, from where it was said.
    ///
    /// # Errors
    /// If that place is gone.
    pub fn as_said(folder: &Path) -> Result<Job, Failure> {
        let from = std::env::current_dir();
        let from = from.map_err(crate::export::ExportError::file("find", Path::new(".")))?;
        let said = std::env::args_os().skip(1);
        Ok(Job {
            folder: folder.to_path_buf(),
            words: without_options(said.map(|word| word.to_string_lossy().into_owned())),
            from: Some(from),
            again: "the same command".to_string(),
        })
    }
}

/// The words of a command line without those that say how it is run: what a task of it is started by.
fn without_options(words: impl IntoIterator<Item = String>) -> Vec<String> {
    const ALONE: [&str; 6] = ["--slurm", "--no-wait", "--quiet", "-q", "--json", "--"];
    const WITH_VALUE: [&str; 6] = [
        "--partition",
        "--minutes",
        "--cores",
        "--merge-round",
        "--task",
        "--threads",
    ];
    let mut kept = Vec::new();
    let mut words = words.into_iter();
    while let Some(word) = words.next() {
        let name = word.split('=').next().unwrap_or_default();
        if WITH_VALUE.contains(&name) {
            if name == word {
                words.next();
            }
        } else if !ALONE.contains(&word.as_str()) {
            kept.push(word);
        }
    }
    kept
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_task_is_started_by_the_words_that_were_said_without_those_on_how_to_run_it() {
        let said =
            "blind 12 --slurm --partition=night --minutes 30 --set a=1 --threads 4 -q --output x --no-wait";
        let kept = without_options(said.split(' ').map(str::to_string));
        assert_eq!(kept.join(" "), "blind 12 --set a=1 --output x");
    }
}
