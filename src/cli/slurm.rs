//! A job array of Slurm for tasks that are independent of each other, and the job that puts their results together.
//!
//! Nothing of a scheduler is written here: `sbatch` takes the jobs, `squeue` says whether they are still there, and what is missing
//! after an array is submitted again.

use std::fmt::Write;
use std::path::Path;
use std::process::Command;
use std::thread::sleep;
use std::time::Duration;

use clap::Args;

use crate::export::ExportError;
use crate::export::file::write_over;

use super::job::Job;
use super::{Console, Failure};

/// Rounds of tasks that have no result: the first, and what it left.
const ROUNDS: u8 = 3;
/// How every script begins.
const HEAD: &str = "#!/bin/bash\n#SBATCH --job-name=";
/// Between two looks at the jobs.
const LOOK: Duration = Duration::from_secs(2);

/// What a scheduler is to be told.
#[derive(Debug, Clone, Args)]
pub struct Slurm {
    /// Run the tasks as a job array of Slurm, wait for them and put their results together
    #[arg(long)]
    pub slurm: bool,
    /// Partition of the cluster
    #[arg(long, value_name = "NAME", requires = "slurm", value_parser = partition_name)]
    pub partition: Option<String>,
    /// Longest time of a task, minutes
    #[arg(long, value_name = "MIN", requires = "slurm", default_value_t = 60, value_parser = clap::value_parser!(u32).range(1..=43_200))]
    pub minutes: u32,
    /// Cores of a task
    #[arg(long, value_name = "N", requires = "slurm", default_value_t = 1, value_parser = clap::value_parser!(u16).range(1..=1024))]
    pub cores: u16,
    /// Come back at once: the jobs go on, and the last one puts their results together
    #[arg(long, requires = "slurm")]
    pub no_wait: bool,
    /// Round of the merge that this job is
    #[arg(long, value_name = "N", hide = true)]
    pub merge_round: Option<u8>,
}

impl Slurm {
    /// Whether a scheduler has a part in it.
    pub fn is_wanted(&self) -> bool {
        self.slurm || self.merge_round.is_some()
    }

    /// Whether this process, once nothing is missing, puts the results together: not in a job that somebody waits for.
    pub fn puts_together(&self) -> bool {
        self.merge_round.is_none() || self.no_wait
    }

    /// Whether to come back as soon as the jobs are submitted.
    fn is_to_come_back(&self) -> bool {
        self.merge_round.is_some() || self.no_wait
    }
}

/// Submits the `missing` tasks of a work; unless this is a job itself or need not wait, waits until `left` says that none is missing.
///
/// # Errors
/// If the scheduler refuses a job, its jobs end with tasks missing, or the user asked to stop waiting.
pub fn run(
    options: &Slurm,
    job: &Job,
    missing: &[usize],
    left: &dyn Fn() -> Result<usize, Failure>,
    console: &Console,
) -> Result<(), Failure> {
    let round = options.merge_round.map_or(0, |round| round + 1);
    if round >= ROUNDS {
        return Err(Failure::Scheduler {
            command: "sbatch".to_string(),
            reason: format!(
                "{} tasks have no result after {ROUNDS} rounds; their logs are in {}",
                missing.len(),
                job.folder.join("slurm").display()
            ),
        });
    }
    let folder = std::path::absolute(&job.folder).map_err(ExportError::file("find", &job.folder))?;
    let total = missing.len();
    let last = submit(options, job, &folder, missing, round)?;
    let then = match options.no_wait {
        true => "puts their results together",
        false => "does again what fails",
    };
    console.note(format_args!("{total} tasks submitted; job {last} {then}"));
    if options.is_to_come_back() {
        return Ok(());
    }
    loop {
        sleep(LOOK);
        let open = left()?;
        console.progress().count(total - open.min(total), total, "tasks");
        if open == 0 {
            return Ok(());
        }
        if let Err(cancelled) = console.progress().check() {
            console.note("the jobs go on; the same command waits for them again");
            return Err(cancelled.into());
        }
        if !is_any_job_left(&folder)? && left()? > 0 {
            return Err(Failure::Scheduler {
                command: "squeue".to_string(),
                reason: format!(
                    "no job of this folder is left, but {open} tasks have no result; their logs are in {}",
                    folder.join("slurm").display()
                ),
            });
        }
    }
}

/// Name by which the jobs of a folder are known.
fn job_name(folder: &Path) -> String {
    let name = folder.file_name().unwrap_or_default().to_string_lossy();
    let plain = |letter: char| {
        if letter.is_ascii_alphanumeric() {
            letter
        } else {
            '-'
        }
    };
    format!("washout-{}", name.chars().map(plain).collect::<String>())
}

/// Submits the array and the job that follows it; gives that job's number.
fn submit(
    options: &Slurm,
    job: &Job,
    folder: &Path,
    missing: &[usize],
    round: u8,
) -> Result<String, Failure> {
    let logs = folder.join("slurm");
    if logs.display().to_string().contains(char::is_control) {
        return Err(Failure::Option {
            option: "--output",
            reason: "names a folder with a line feed or the like in it; jobs of Slurm take no such name"
                .to_string(),
        });
    }
    std::fs::create_dir_all(&logs).map_err(ExportError::file("create", &logs))?;
    let program = std::env::current_exe().map_err(ExportError::file("find", Path::new("washout")))?;
    let cores = options.cores;
    let words: Vec<String> = job.words.iter().map(|word| quoted_word(word)).collect();
    let from = job
        .from
        .as_ref()
        .map(|from| format!("cd {} || exit 1\n", quoted(from)));
    let command = format!(
        "{}exec {} --quiet --threads {cores} {}",
        from.unwrap_or_default(),
        quoted(&program),
        words.join(" ")
    );
    let mut head = format!(
        "{HEAD}{}\n#SBATCH --cpus-per-task={cores}\n#SBATCH --time={}\n#SBATCH --requeue\n",
        job_name(folder),
        options.minutes
    );
    if let Some(partition) = &options.partition {
        let _ = writeln!(head, "#SBATCH --partition={partition}");
    }
    let array = format!(
        "{head}#SBATCH --array={}\n#SBATCH --output={}\n{command} --task \"$SLURM_ARRAY_TASK_ID\"\n",
        ranges(missing),
        log_pattern(&logs, "task-%a-%A.log"),
    );
    let mut more = format!(" --minutes {} --cores {cores}", options.minutes);
    if let Some(partition) = &options.partition {
        let _ = write!(more, " --partition {}", quoted_word(partition));
    }
    if options.no_wait {
        more += " --no-wait";
    }
    let merge = format!(
        "{head}#SBATCH --output={}\n{command} --slurm --merge-round {round}{more}\n",
        log_pattern(&logs, "merge-%j.log"),
    );
    let (array_file, merge_file) = (logs.join("array.sh"), logs.join("merge.sh"));
    for (file, script) in [(&array_file, &array), (&merge_file, &merge)] {
        let is_own = |bytes: &[u8]| bytes.starts_with(HEAD.as_bytes());
        write_over(file, script.as_bytes(), "a script of washout", is_own)?;
    }
    let first = sbatch(&[], &array_file)?;
    sbatch(&[format!("--dependency=afterany:{first}")], &merge_file)
}

fn sbatch(options: &[String], script: &Path) -> Result<String, Failure> {
    let output = Command::new("sbatch")
        .arg("--parsable")
        .args(options)
        .arg(script)
        .output();
    let output = output.map_err(|error| Failure::Scheduler {
        command: "sbatch".to_string(),
        reason: format!("{error}; --slurm needs Slurm's commands on this machine"),
    })?;
    if !output.status.success() {
        return Err(Failure::Scheduler {
            command: format!("sbatch {}", script.display()),
            reason: String::from_utf8_lossy(&output.stderr).trim().to_string(),
        });
    }
    let said = String::from_utf8_lossy(&output.stdout);
    Ok(said.trim().split(';').next().unwrap_or_default().to_string())
}

fn is_any_job_left(folder: &Path) -> Result<bool, Failure> {
    let name = job_name(folder);
    let output = Command::new("squeue")
        .args(["--noheader", "--name", &name])
        .output();
    let output = output.map_err(|error| Failure::Scheduler {
        command: "squeue".to_string(),
        reason: error.to_string(),
    })?;
    // a controller that does not answer for a moment is no end of the jobs
    Ok(!output.status.success() || !String::from_utf8_lossy(&output.stdout).trim().is_empty())
}

/// The file of a log as sbatch takes it: a % of its own is a %% there.
fn log_pattern(folder: &Path, name: &str) -> String {
    let folder = folder.display().to_string().replace('%', "%%");
    quoted_word(&format!("{folder}/{name}"))
}

/// A name of a partition, or some with commas between: it stands in a script as it is.
fn partition_name(text: &str) -> Result<String, String> {
    let is_plain = |letter: char| letter.is_ascii_alphanumeric() || "_-.+,".contains(letter);
    match !text.is_empty() && text.chars().all(is_plain) {
        true => Ok(text.to_string()),
        false => Err("give letters, digits and _ - . + only, with commas between several".to_string()),
    }
}

fn quoted(path: &Path) -> String {
    quoted_word(&path.display().to_string())
}

/// One word of the shell.
fn quoted_word(word: &str) -> String {
    format!("'{}'", word.replace('\'', "'\\''"))
}

/// `0,3-7` for 0, 3, 4, 5, 6, 7.
fn ranges(numbers: &[usize]) -> String {
    let mut parts: Vec<(usize, usize)> = Vec::new();
    for &number in numbers {
        match parts.last_mut() {
            Some((_, end)) if *end + 1 == number => *end = number,
            _ => parts.push((number, number)),
        }
    }
    let shown = parts.iter().map(|(start, end)| match start == end {
        true => start.to_string(),
        false => format!("{start}-{end}"),
    });
    shown.collect::<Vec<_>>().join(",")
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn numbers_that_follow_each_other_are_a_range() {
        assert_eq!(ranges(&[0, 3, 4, 5, 9, 10, 12]), "0,3-5,9-10,12");
        assert_eq!(ranges(&[]), "");
    }

    #[test]
    fn a_partition_is_a_plain_name_and_a_percent_of_a_folder_stays_one() {
        assert_eq!(
            partition_name("night,gpu-2_a.b").as_deref(),
            Ok("night,gpu-2_a.b")
        );
        for wrong in ["", "night\ntouch x", "a b", "$(id)", "a;b"] {
            assert!(partition_name(wrong).is_err(), "{wrong:?}");
        }
        let pattern = log_pattern(Path::new("/tmp/a%j b/slurm"), "task-%a-%A.log");
        assert_eq!(pattern, "'/tmp/a%%j b/slurm/task-%a-%A.log'");
    }

    #[test]
    fn a_path_with_spaces_and_quotes_is_one_word_of_the_shell() {
        assert_eq!(quoted(Path::new("/a b/it's")), "'/a b/it'\\''s'");
    }
}
