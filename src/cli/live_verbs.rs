//! What `washout live` saves: by the commands that a user would give, run as they are.

use std::path::{Path, PathBuf};

use crate::export::file::write_new;
use crate::live::Refusal;
use crate::live::opened::Readings;
use crate::live::values::Step;
use crate::live::verbs::{Save, Saved, Verbs};
use crate::progress::Progress;

use super::{Console, Failure};

/// Names that are tried for a file that is not to replace another.
const MOST: usize = 1000;

/// Runs the words of a command line behind `washout`.
pub type Run = fn(words: &[String], console: &Console) -> Result<(), Failure>;

/// Saves by commands of this program.
#[derive(Debug)]
pub struct ByCommands(pub Run);

/// One command: its words behind `washout`, and what it writes.
struct Command {
    words: Vec<String>,
    writes: Vec<PathBuf>,
}

impl Verbs for ByCommands {
    fn commands(&self, save: &Save) -> Vec<String> {
        commands(save).iter().map(Command::shown).collect()
    }

    fn save(&self, save: &Save, progress: &Progress) -> Result<Saved, Refusal> {
        let mut saved = Saved::default();
        if let Save::Study {
            readings: Some(readings),
            path,
            ..
        } = save
            && !path.exists()
        {
            put(readings)?;
            saved.files.push(shown(&readings.table));
        }
        for command in commands(save) {
            let console = Console::keeping(progress.clone());
            (self.0)(&command.words, &console).map_err(Refusal::new)?;
            saved.commands.push(command.shown());
            for path in command.writes {
                let path = path.display().to_string();
                if !saved.files.contains(&path) {
                    saved.files.push(path);
                }
            }
        }
        Ok(saved)
    }
}

/// The commands that save it, in their order.
fn commands(save: &Save) -> Vec<Command> {
    match save {
        Save::Design { path, name, sets } => {
            let output = PathBuf::from("output").join(format!("{name}-live"));
            let mut words = vec!["solve".to_string(), shown(path)];
            words.extend(with_sets(sets));
            words.extend(["--report", "--output"].map(str::to_string));
            words.push(shown(&output));
            vec![Command {
                words,
                writes: vec![output],
            }]
        }
        Save::Study {
            path,
            name,
            steps,
            sets,
            readings,
        } => {
            let target = beside(path);
            let mut commands: Vec<Command> = Vec::new();
            let made = readings.filter(|_| !path.exists());
            commands.extend(made.map(|readings| init(path, name, readings)));
            for (place, step) in steps.iter().enumerate() {
                let from = if place == 0 { path } else { target.as_path() };
                let mut words = added(step, from);
                if place == 0 {
                    words.extend(["--output".to_string(), shown(&target)]);
                }
                let ladder = PathBuf::from("output").join(format!("{name}-ladder"));
                commands.push(Command {
                    words,
                    writes: vec![target.clone(), ladder],
                });
            }
            let study = if steps.is_empty() { path } else { target.as_path() };
            let output = PathBuf::from("output").join(format!("{name}-live"));
            let mut words = vec!["compare".to_string(), shown(study)];
            words.extend(with_sets(sets));
            words.extend(["--report", "--output"].map(str::to_string));
            words.push(shown(&output));
            commands.push(Command {
                words,
                writes: vec![output],
            });
            commands
        }
    }
}

/// The command that makes a study of a table.
fn init(path: &Path, name: &str, readings: &Readings) -> Command {
    let mut words: Vec<String> = ["init", name, "--study", "--design"].map(str::to_string).to_vec();
    words.push(shown(&readings.design));
    words.extend(["--readings".to_string(), shown(&readings.table)]);
    if let Some(folder) = path.parent().filter(|folder| !folder.as_os_str().is_empty()) {
        words.extend(["--output".to_string(), shown(folder)]);
    }
    let measured = path.with_file_name(format!("{name}-measured.csv"));
    Command {
        words,
        writes: vec![path.to_path_buf(), measured],
    }
}

/// Puts a table that was dropped on the page beside the design, where it may stand already.
fn put(readings: &Readings) -> Result<(), Refusal> {
    match std::fs::read(&readings.table) {
        Ok(stands) if *stands == *readings.bytes => Ok(()),
        _ => write_new(&readings.table, &readings.bytes).map_err(Refusal::new),
    }
}

/// An effect that joins the study in a file.
fn added(step: &Step, from: &Path) -> Vec<String> {
    let mut words = vec!["add".to_string(), step.effect().to_string()];
    match step {
        Step::Fitted { addition, sets } => {
            for number in &addition.numbers {
                words.extend(["--number".to_string(), number.clone()]);
            }
            if let Some(wing) = &addition.wing {
                words.extend(["--on".to_string(), wing.clone()]);
            }
            words.extend(with_sets(sets));
        }
        Step::Held { strength, .. } => words.extend(["--strength".to_string(), format!("{strength}")]),
    }
    words.extend(["--to".to_string(), shown(from)]);
    words
}

fn with_sets(sets: &[String]) -> impl Iterator<Item = String> {
    sets.iter().flat_map(|set| ["--set".to_string(), set.clone()])
}

/// A file beside a study that is not there yet: paths in it stay relative to it.
fn beside(study: &Path) -> PathBuf {
    let stem = study.file_stem().unwrap_or_default().to_string_lossy();
    let name = |number: usize| match number {
        1 => format!("{stem}-live.toml"),
        number => format!("{stem}-live-{number}.toml"),
    };
    let mut names = (1..MOST).map(|number| study.with_file_name(name(number)));
    names
        .find(|path| !path.exists())
        .unwrap_or_else(|| study.with_file_name(name(MOST)))
}

fn shown(path: &Path) -> String {
    path.display().to_string()
}

impl Command {
    /// As a shell takes it.
    fn shown(&self) -> String {
        let words = self.words.iter().map(|word| quoted(word));
        format!("washout {}", words.collect::<Vec<_>>().join(" "))
    }
}

/// A word as a shell takes it.
fn quoted(word: &str) -> String {
    let is_plain = |c: char| c.is_ascii_alphanumeric() || "-_=./:,+".contains(c);
    match !word.is_empty() && word.chars().all(is_plain) {
        true => word.to_string(),
        false => format!("'{}'", word.replace('\'', r"'\''")),
    }
}
