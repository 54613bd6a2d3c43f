//! A video that is cut into frames by ffmpeg, if there is one.

use std::fs;
use std::io::{self, Read, Seek};
use std::path::{Path, PathBuf};
use std::process::{Command, Stdio};
use std::thread::sleep;
use std::time::Duration;

use crate::live::refusal::Refusal;
use crate::progress::Progress;

/// Frames that are cut at most.
const MOST: usize = 2000;
/// Endings of videos.
const VIDEOS: [&str; 9] = ["mp4", "mov", "avi", "mkv", "webm", "m4v", "mpg", "mpeg", "mts"];
/// How often it is looked whether it is done, or to be stopped.
const LOOK: Duration = Duration::from_millis(50);

/// Whether a file is a video, by its ending.
pub fn is_video(path: &Path) -> bool {
    let ending = path.extension().unwrap_or_default().to_string_lossy();
    VIDEOS.contains(&ending.to_ascii_lowercase().as_str())
}

/// The frames of a video.
#[derive(Debug, Clone, PartialEq)]
pub struct Frames {
    /// Their folder.
    pub folder: PathBuf,
    /// What is to be known of them.
    pub note: String,
}

/// Cuts a video into the folder `NAME-frames` beside it, unless that stands there already.
///
/// # Errors
/// If there is no ffmpeg, it cannot cut the file, or it is stopped; then there is no folder.
pub fn cut(video: &Path, progress: &Progress) -> Result<Frames, Refusal> {
    let name = video.file_stem().unwrap_or_default().to_string_lossy();
    let folder = video.with_file_name(format!("{name}-frames"));
    if folder.is_dir() {
        let note = format!(
            "the frames of {} were cut before; remove the folder to cut the video again",
            folder.display()
        );
        return Ok(Frames { folder, note });
    }
    let beside = match video.parent() {
        Some(parent) if parent != Path::new("") => parent,
        _ => Path::new("."),
    };
    let fault = |error: io::Error| Refusal::new(format!("{}: {error}", beside.display()));
    let partial = tempfile::tempdir_in(beside).map_err(fault)?;
    run(video, partial.path(), progress)?;
    let count = fs::read_dir(partial.path()).map_err(fault)?.count();
    if count == 0 {
        return Err(Refusal::new(format!(
            "{}: ffmpeg found no frame in it",
            video.display()
        )));
    }
    let partial = partial.keep();
    if let Err(error) = fs::rename(&partial, &folder) {
        // what was cut is of no use at another place
        let _ = fs::remove_dir_all(&partial);
        return Err(Refusal::new(format!("{}: {error}", folder.display())));
    }
    let rest = match count {
        MOST => "; what comes after them in the video is left out",
        _ => "",
    };
    let note = format!("{count} frames cut into {}{rest}", folder.display());
    Ok(Frames { folder, note })
}

fn run(video: &Path, folder: &Path, progress: &Progress) -> Result<(), Refusal> {
    // the file itself, whatever its name looks like, and nothing that it refers to elsewhere
    let mut input = std::ffi::OsString::from("file:");
    input.push(video);
    let fault = |error: io::Error| Refusal::new(format!("ffmpeg: {error}"));
    let mut said = tempfile::tempfile().map_err(fault)?;
    let mut child = Command::new("ffmpeg")
        .args([
            "-nostdin",
            "-loglevel",
            "error",
            "-protocol_whitelist",
            "file",
            "-i",
        ])
        .arg(input)
        .args(["-an", "-vsync", "passthrough", "-frames:v", &MOST.to_string()])
        .arg(folder.join("frame-%05d.png"))
        .stdin(Stdio::null())
        .stdout(Stdio::null())
        .stderr(said.try_clone().map_err(fault)?)
        .spawn()
        .map_err(|error| missing(video, &error))?;
    progress.say("cutting the video into frames");
    let status = loop {
        match child.try_wait().map_err(fault)? {
            Some(status) => break status,
            None if progress.is_cancelled() => {
                let _ = child.kill();
                let _ = child.wait();
                return Err(Refusal::new("stopped"));
            }
            None => sleep(LOOK),
        }
    };
    if status.success() {
        return Ok(());
    }
    let mut text = Vec::new();
    said.rewind().map_err(fault)?;
    said.read_to_end(&mut text).map_err(fault)?;
    let text = String::from_utf8_lossy(&text);
    let last = text.lines().last().unwrap_or("it does not say why");
    let message = format!("{}: ffmpeg cannot cut it: {last}", video.display());
    Err(Refusal::new(message))
}

fn missing(video: &Path, error: &io::Error) -> Refusal {
    let cure = "Install ffmpeg, or cut the video into PNG or JPEG files and name their folder";
    Refusal::new(format!(
        "{}: is a video, and ffmpeg cannot be started ({error})",
        video.display()
    ))
    .cured(cure)
}
