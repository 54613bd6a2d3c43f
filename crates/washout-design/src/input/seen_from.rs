//! Paths that stand in one file and were given from elsewhere.

use std::path::{Component, Path, PathBuf};

/// A path that means the same seen from the folder of the design as `file` does seen from here.
pub fn seen_from(design: &Path, file: &Path) -> PathBuf {
    let folder = design.parent().unwrap_or(Path::new(""));
    let plain = |path: &Path| path.components().all(|part| matches!(part, Component::Normal(_)));
    if plain(folder) && file.is_relative() {
        let up: PathBuf = folder.components().map(|_| Component::ParentDir).collect();
        up.join(file)
    } else {
        std::path::absolute(file).unwrap_or_else(|_| file.to_path_buf())
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    #[test]
    fn a_mesh_file_is_found_from_the_folder_of_the_design() {
        let seen = |design: &str, file: &str| seen_from(Path::new(design), Path::new(file));
        assert_eq!(seen("wing.toml", "wing.msh"), Path::new("wing.msh"));
        assert_eq!(
            seen("designs/a/wing.toml", "meshes/wing.msh"),
            Path::new("../../meshes/wing.msh")
        );
        assert_eq!(
            seen("designs/wing.toml", "/meshes/wing.msh"),
            Path::new("/meshes/wing.msh")
        );
        assert!(seen("../wing.toml", "wing.msh").is_absolute());
    }
}
