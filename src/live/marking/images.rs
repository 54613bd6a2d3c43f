//! The frames of a folder: its images, in the order of their names.

use std::fs;
use std::path::{Path, PathBuf};

use crate::live::refusal::Refusal;

/// Images that a folder may have.
const MOST: usize = 5000;
/// Size of the largest image, bytes.
const LARGEST: u64 = 64 * 1024 * 1024;
/// Kinds of images: endings of the file, what a browser calls it, and how its bytes begin.
const KINDS: [(&[&str], &str, &[u8]); 2] = [
    (&["png"], "image/png", b"\x89PNG\r\n\x1a\n"),
    (&["jpg", "jpeg"], "image/jpeg", b"\xff\xd8\xff"),
];

/// Endings of images that no page shows, or not everywhere.
const OTHERS: [&str; 10] = [
    "bmp", "cr2", "dng", "gif", "heic", "nef", "ppm", "tif", "tiff", "webp",
];

/// One image.
#[derive(Debug, Clone, PartialEq)]
struct Image {
    /// Name of the frame.
    name: String,
    path: PathBuf,
    kind: usize,
}

/// The images of a folder.
#[derive(Debug, Clone, PartialEq)]
pub struct Images {
    shown: Vec<Image>,
    /// Files of images that are left out for their kind.
    left_out: Vec<String>,
}

impl Images {
    /// Finds them; other files are left alone. `frame-2` comes before `frame-10`.
    ///
    /// # Errors
    /// If the folder cannot be read, has no image or too many, or two images have the same name.
    pub fn of(folder: &Path) -> Result<Images, Refusal> {
        let fault = |error| Refusal::new(format!("{}: cannot be read: {error}", folder.display()));
        let (mut found, mut left_out) = (Vec::new(), Vec::new());
        for entry in fs::read_dir(folder).map_err(fault)? {
            let path = entry.map_err(fault)?.path();
            let Some(kind) = kind_of(&path).filter(|_| path.is_file()) else {
                if ending(&path).is_some_and(|own| OTHERS.contains(&own.as_str())) {
                    left_out.push(
                        path.file_name()
                            .unwrap_or_default()
                            .to_string_lossy()
                            .into_owned(),
                    );
                }
                continue;
            };
            let name = frame_name(&path);
            found.push(Image { name, path, kind });
        }
        left_out.sort();
        if found.is_empty() {
            let message = format!("{}: has no image (.png, .jpg, .jpeg)", folder.display());
            let cure = match left_out.is_empty() {
                true => {
                    "Name the folder with the frames of the video, or the video itself where ffmpeg is installed"
                }
                false => "Save its images as PNG or JPEG",
            };
            return Err(Refusal::new(message).cured(cure));
        }
        if found.len() > MOST {
            let message = format!("{}: has {} images, at most {MOST}", folder.display(), found.len());
            let cure = "Keep one frame in ten: twist is read at a few instants";
            return Err(Refusal::new(message).cured(cure));
        }
        found.sort_by(|a, b| alphanumeric_sort::compare_str(&a.name, &b.name).then(a.path.cmp(&b.path)));
        if let Some(pair) = found.windows(2).find(|pair| pair[0].name == pair[1].name) {
            let [a, b] = [&pair[0], &pair[1]].map(|image| image.path.display());
            let cure =
                "Rename one of them; the frame is named after its file, by letters, digits, -, _ and .";
            return Err(
                Refusal::new(format!("{a} and {b} would be the same frame {}", pair[0].name)).cured(cure),
            );
        }
        Ok(Images {
            shown: found,
            left_out,
        })
    }

    /// Files of images that are left out, for they are neither PNG nor JPEG.
    pub fn left_out(&self) -> &[String] {
        &self.left_out
    }

    /// Names of the frames.
    pub fn names(&self) -> Vec<String> {
        self.shown.iter().map(|image| image.name.clone()).collect()
    }

    /// One image: what a browser calls its kind, and its bytes.
    ///
    /// # Errors
    /// If there is no such frame, or the file is none any more.
    pub fn read(&self, index: usize) -> Result<(&'static str, Vec<u8>), Refusal> {
        let image = (self.shown.get(index)).ok_or_else(|| Refusal::new("there is no such frame"))?;
        let shown = image.path.display();
        let fault = |error| Refusal::new(format!("{shown}: cannot be read: {error}"));
        let size = fs::metadata(&image.path).map_err(fault)?.len();
        if size > LARGEST {
            let most = LARGEST / 1024 / 1024;
            return Err(Refusal::new(format!("{shown}: is larger than {most} MiB")));
        }
        let bytes = fs::read(&image.path).map_err(fault)?;
        let (_, kind, start) = KINDS[image.kind];
        match bytes.starts_with(start) {
            true => Ok((kind, bytes)),
            false => Err(Refusal::new(format!("{shown}: is no {kind}"))),
        }
    }
}

fn ending(path: &Path) -> Option<String> {
    Some(path.extension()?.to_str()?.to_ascii_lowercase())
}

fn kind_of(path: &Path) -> Option<usize> {
    let ending = ending(path)?;
    KINDS
        .iter()
        .position(|(endings, _, _)| endings.contains(&ending.as_str()))
}

/// The name of a file without its ending, of the characters that a frame may have.
pub fn frame_name(path: &Path) -> String {
    let stem = path.file_stem().unwrap_or_default().to_string_lossy();
    let kept = |c: char| {
        if c.is_ascii_alphanumeric() || "_-.".contains(c) {
            c
        } else {
            '-'
        }
    };
    stem.chars().map(kept).collect()
}

#[cfg(test)]
mod tests {
    use super::*;

    fn folder(files: &[(&str, &[u8])]) -> tempfile::TempDir {
        let folder = tempfile::tempdir().expect("a folder");
        for (name, bytes) in files {
            fs::write(folder.path().join(name), bytes).expect("written");
        }
        folder
    }

    #[test]
    fn frames_come_in_the_order_of_their_numbers_and_other_files_are_left_alone() {
        let png = KINDS[0].2;
        let folder = folder(&[
            ("f-10.png", png),
            ("f-9.png", png),
            ("f 1.JPG", b"\xff\xd8\xff\xe0"),
            ("notes.txt", b"x"),
            ("f-11.TIF", b"II*"),
        ]);
        let images = Images::of(folder.path()).expect("images");
        assert_eq!(images.left_out(), ["f-11.TIF"]);
        assert_eq!(images.names(), ["f-1", "f-9", "f-10"]);
        assert_eq!(images.read(0).expect("a picture").0, "image/jpeg");
        assert!(images.read(3).is_err());
    }

    #[test]
    fn what_is_no_image_or_no_frame_of_its_own_is_refused_with_its_cure() {
        let empty = Images::of(folder(&[("a.txt", b"")]).path()).expect_err("no image");
        assert!(empty.message.contains("has no image"), "{empty}");
        let png = KINDS[0].2;
        let twice = folder(&[("a.png", png), ("a.jpg", b"\xff\xd8\xff")]);
        let twice = Images::of(twice.path()).expect_err("the same name");
        assert!(twice.message.contains("the same frame a"), "{twice}");
        let broken = folder(&[("a.png", b"<script>")]);
        let images = Images::of(broken.path()).expect("a name");
        assert!(
            images
                .read(0)
                .expect_err("no picture")
                .message
                .contains("is no image/png")
        );
    }
}
