//! From files to a checked design.

use std::path::{Path, PathBuf};
use std::sync::Arc;

use super::air_table;
use super::check;
use super::checked::design_of;
use super::design::Design;
use super::document::{Node, NodeValue, Source};
use super::error::{InputError, Problem};
use super::file;
use super::form;
use super::keys;
use super::measurement::{Measurement, STATION_COLUMNS};
use super::named::{named_file, read_mesh};
use super::set::Setting;
use crate::origin::InputFile;

/// A design with all that its file refers to.
#[derive(Debug, Clone)]
pub struct Loaded {
    /// The design, checked, with its materials; `materials` itself is none, so that it stands alone.
    pub design: Design,
    /// The design file.
    pub path: PathBuf,
    /// The materials file, if one was named.
    pub materials_path: Option<PathBuf>,
    /// Name and bytes of the mesh file, if one was named.
    pub mesh_file: Option<(String, Arc<[u8]>)>,
    /// Rows alpha_deg, cl, cd of the table of coefficients, if one was named; α rises.
    pub air_table: Option<Vec<[f64; 3]>>,
    /// The rows of the measured case, if a measurement was named; their stations lie on the wing.
    pub measurement: Option<Measurement>,
    /// All these files, with what they held.
    pub files: Vec<InputFile>,
}

impl Loaded {
    /// A design that names no other files, under its name for a path.
    pub fn alone(design: Design) -> Loaded {
        Loaded {
            path: PathBuf::from(&design.name),
            design,
            materials_path: None,
            mesh_file: None,
            air_table: None,
            measurement: None,
            files: Vec::new(),
        }
    }

    /// All that a solved wing hangs on: what the files hold, not where they stand.
    pub fn content(&self) -> String {
        let mesh = self.mesh_file.as_ref().map(|(_, bytes)| bytes);
        format!("{}{:?}{mesh:?}", self.design.to_toml(), self.air_table)
    }
}

impl Design {
    /// A design that a run has resolved, with the mesh and the table that it names beside `path`, its file; what was
    /// measured is left out.
    pub fn resolved(self, path: &Path) -> Result<Loaded, InputError> {
        let mut files = Vec::new();
        let table = self.air.table.as_ref().map(|name| file::beside(path, name));
        let table = table.map(|path| read_air_table(&path, &mut files)).transpose()?;
        let mesh = self.mesh.file.as_ref().map(|name| file::beside(path, name));
        let mesh = mesh.map(|path| read_mesh(&path)).transpose()?;
        files.extend(mesh.iter().map(|(name, bytes)| InputFile::new(name, bytes)));
        Ok(Loaded {
            mesh_file: mesh,
            air_table: table,
            design: self,
            path: path.to_path_buf(),
            materials_path: None,
            measurement: None,
            files,
        })
    }

    /// Reads a design file with the files that it names, after `sets` (`key=value`) have changed it.
    ///
    /// # Example
    /// ```
    /// # use washout_design as washout;
    /// # std::env::set_current_dir(concat!(env!("CARGO_MANIFEST_DIR"), "/../..")).unwrap();
    /// # use std::path::Path;
    /// use washout::input::Design;
    ///
    /// let loaded = Design::load(Path::new("designs/twist-v2.toml"), &["flapping.frequency_hz=24".to_string()])?;
    /// assert_eq!(loaded.design.get("flapping.frequency_hz"), Some(24.0));
    /// # Ok::<(), Box<dyn std::error::Error>>(())
    /// ```
    pub fn load(path: &Path, sets: &[String]) -> Result<Loaded, InputError> {
        let settings = settings(sets)?;
        let (text, input) = file::read_input(path, "design file")?;
        Design::of_text(&text, path, &settings, input)
    }

    /// The same of a text instead of a file; files that it names are looked for as if it stood in the file `path`.
    pub fn load_text(text: &str, path: &Path, sets: &[String]) -> Result<Loaded, InputError> {
        let input = InputFile::new(file::shown(path), text.as_bytes());
        Design::of_text(text, path, &settings(sets)?, input)
    }

    fn of_text(
        text: &str,
        path: &Path,
        settings: &[Setting],
        input: InputFile,
    ) -> Result<Loaded, InputError> {
        let mut files = vec![input];
        let mut root = Node::parse_file(&file::shown(path), text)?;
        if root.get("case").is_some() {
            return Err(InputError::about_file(
                &file::shown(path),
                "is a study, not a design",
                "`washout compare`, `diagnose` and `report` take studies; give this command a design, such as one that the study names",
            ));
        }
        for setting in settings.iter().filter(|setting| setting.is_for("materials")) {
            setting.apply(&mut root)?;
        }
        let materials_path = merge_materials(&mut root, path, &mut files)?;
        for setting in settings.iter().filter(|setting| !setting.is_for("materials")) {
            setting.apply(&mut root)?;
        }
        let mut design = design_of(&root)?;
        design.materials = None;
        let mesh_file = named_file(&root, path, "mesh.file")?;
        let mesh_file = mesh_file.map(|path| read_mesh(&path)).transpose()?;
        files.extend(mesh_file.iter().map(|(name, bytes)| InputFile::new(name, bytes)));
        let air_table = match named_file(&root, path, "air.table")? {
            Some(path) => Some(read_air_table(&path, &mut files)?),
            None => None,
        };
        let measurement = match named_file(&root, path, "measured.file")? {
            Some(path) => Some(measured_case(&root, &design, &path)?),
            None => None,
        };
        files.extend(measurement.iter().filter_map(|rows| rows.input.clone()));
        Ok(Loaded {
            design,
            path: path.to_path_buf(),
            materials_path,
            mesh_file,
            air_table,
            measurement,
            files,
        })
    }

    /// Reads a design from its text; no file is opened, so materials must stand in the text.
    pub fn from_toml(text: &str, file_name: &str) -> Result<Design, InputError> {
        let root = Node::parse_file(file_name, text)?;
        if let Some(node) = root.get("materials") {
            let message = "cannot be followed, because the design is not read from a file".to_string();
            let problem = Problem::Conflict {
                message,
                with: vec!["material".to_string()],
            };
            let cure = "Write the materials into the design, as tables [material.NAME]";
            return Err(InputError::new(
                node.place(),
                "materials",
                &node.shown(),
                problem,
                cure,
            ));
        }
        design_of(&root)
    }

    /// The design as TOML; [`Design::from_toml`] reads it back to the same design.
    pub fn to_toml(&self) -> String {
        let mut plain = serde_json::to_value(self).unwrap_or_default();
        drop_empty(&mut plain);
        toml::to_string(&plain).unwrap_or_default()
    }
}

/// Takes out what is not given, which TOML has no word for.
fn drop_empty(value: &mut serde_json::Value) {
    if let Some(table) = value.as_object_mut() {
        table.retain(|_, item| !item.is_null());
        table.values_mut().for_each(drop_empty);
    }
    if let Some(list) = value.as_array_mut() {
        list.iter_mut().for_each(drop_empty);
    }
}

fn read_air_table(path: &Path, files: &mut Vec<InputFile>) -> Result<Vec<[f64; 3]>, InputError> {
    let (text, input) = file::read_input(path, "table of coefficients")?;
    files.push(input);
    air_table::parse(&file::shown(path), &text)
}

fn settings(sets: &[String]) -> Result<Vec<Setting>, InputError> {
    sets.iter().map(|text| Setting::parse(text)).collect()
}

/// Joins the tables of the materials file, if one is named, to those of the design.
fn merge_materials(
    root: &mut Node,
    design_path: &Path,
    files: &mut Vec<InputFile>,
) -> Result<Option<PathBuf>, InputError> {
    let Some(path) = named_file(root, design_path, "materials")? else {
        return Ok(None);
    };
    let Some(named) = root.get("materials").cloned() else {
        return Ok(None);
    };
    if same_file(&path, design_path) {
        let message = "is the design file itself";
        return Err(circle(&named, message, "Name another file, or leave the key out"));
    }
    let tree = read_materials(&path, files)?;
    if root.get("material").is_none() {
        root.put(
            "material",
            Node::new(&Source::other("material"), NodeValue::Table(Vec::new())),
        );
    }
    if let (
        Some(own),
        Some(Node {
            value: NodeValue::Table(entries),
            ..
        }),
    ) = (
        root.child_mut(&super::path::Step::Key("material".to_string())),
        tree.get("material"),
    ) {
        for entry in entries {
            if own.get(&entry.key).is_none() {
                own.add(entry.clone());
            }
        }
    }
    Ok(Some(path))
}

fn read_materials(path: &Path, files: &mut Vec<InputFile>) -> Result<Node, InputError> {
    let (text, input) = file::read_input(path, "materials file")?;
    files.push(input);
    let tree = Node::parse_file(&file::shown(path), &text)?;
    if let Some(node) = tree.get("materials") {
        let message = "a materials file cannot name another one";
        let cure = "Write all materials into one file, as tables [material.NAME]";
        return Err(circle(node, message, cure));
    }
    check::format_is_one(&tree)?;
    form::check(&tree, keys::materials())?;
    Ok(tree)
}

/// An error about a name of a materials file that leads back or on.
fn circle(node: &Node, message: &str, cure: &str) -> InputError {
    let problem = Problem::Conflict {
        message: message.to_string(),
        with: Vec::new(),
    };
    InputError::new(node.place(), "materials", &node.shown(), problem, cure)
}

/// The rows of the case that the design names.
fn measured_case(root: &Node, design: &Design, path: &Path) -> Result<Measurement, InputError> {
    let all = Measurement::load(path)?;
    let case = design
        .measured
        .as_ref()
        .map_or("", |measured| measured.case.as_str());
    let rows = all.case(case);
    if rows.rows.is_empty() {
        let allowed = all.cases().into_iter().map(str::to_string).collect();
        let node = root
            .at(&super::path::KeyPath::parse("measured.case").unwrap_or_default())
            .unwrap_or(root);
        let cure = format!("These are the cases of {}", all.file);
        let problem = Problem::UnknownValue { allowed };
        return Err(InputError::new(
            node.place(),
            "measured.case",
            &node.shown(),
            problem,
            cure,
        ));
    }
    rows.check_stations(design, STATION_COLUMNS)?;
    Ok(rows)
}

fn same_file(a: &Path, b: &Path) -> bool {
    match (a.canonicalize(), b.canonicalize()) {
        (Ok(a), Ok(b)) => a == b,
        _ => false,
    }
}

#[cfg(test)]
mod tests {
    use super::*;

    fn shipped(name: &str) -> PathBuf {
        Path::new(concat!(env!("CARGO_MANIFEST_DIR"), "/../.."))
            .join("designs")
            .join(name)
    }

    #[test]
    fn the_three_wings_load_with_their_materials() {
        for name in ["rigid.toml", "twist-v1.toml", "twist-v2.toml"] {
            let loaded = Design::load(&shipped(name), &[]).unwrap_or_else(|error| panic!("{error}"));
            assert_eq!(loaded.design.material.len(), 3, "{name}");
            assert_eq!(loaded.design.planform.length_mm.value(), 70.0, "{name}");
        }
    }

    #[test]
    fn a_text_is_read_as_the_file_that_it_stands_for() {
        let path = shipped("twist-v2.toml");
        let text = std::fs::read_to_string(&path).unwrap();
        let sets = ["flapping.frequency_hz=25".to_string()];
        let of_file = Design::load(&path, &sets).unwrap();
        let of_text = Design::load_text(&text, &path, &sets).unwrap();
        assert_eq!(of_text.design, of_file.design);
        assert_eq!(of_text.materials_path, of_file.materials_path);
        let error = Design::load_text(&text, Path::new("elsewhere/wing.toml"), &sets).unwrap_err();
        assert!(error.to_string().contains("elsewhere"), "{error}");
    }

    #[test]
    fn a_loaded_design_stands_alone_as_text() {
        let loaded = Design::load(&shipped("twist-v2.toml"), &[]).unwrap();
        let again =
            Design::from_toml(&loaded.design.to_toml(), "again").unwrap_or_else(|error| panic!("{error}"));
        assert_eq!(again, loaded.design);
    }

    #[test]
    fn settings_change_the_design_before_it_is_checked() {
        let sets = [
            "rod[1].section.diameter_mm=0.8",
            "structure.kinematics=linear",
            "material.carbon-rod.g_gpa=5",
        ];
        let loaded = Design::load(&shipped("twist-v2.toml"), &sets.map(str::to_string)).unwrap();
        assert_eq!(loaded.design.get("rod[1].section.diameter_mm"), Some(0.8));
        assert_eq!(loaded.design.material["carbon-rod"].g_gpa, Some(5.0.into()));
        assert_eq!(
            loaded.design.structure.kinematics,
            crate::input::design::Kinematics::Linear
        );
    }

    #[test]
    fn setting_keeps_the_range_of_an_assumption() {
        let mut design = Design::load(&shipped("rigid.toml"), &[]).unwrap().design;
        let key = "flapping.half_amplitude_deg";
        design.set(key, 30.0).unwrap();
        let found = design
            .assumptions()
            .into_iter()
            .find(|assumption| assumption.key == key)
            .unwrap();
        assert_eq!((found.value, found.range), (30.0, [24.0, 45.0]));
        design.set(key, 50.0).unwrap();
        assert_eq!(design.get(key), Some(50.0));
        assert!(
            design
                .assumptions()
                .iter()
                .all(|assumption| assumption.key != key)
        );
    }

    #[test]
    fn a_refused_setting_leaves_the_design_as_it_was() {
        let mut design = Design::load(&shipped("rigid.toml"), &[]).unwrap().design;
        let before = design.clone();
        let error = design.set("flapping.frequency_hz", -3.0).unwrap_err();
        assert!(
            error
                .to_string()
                .starts_with("set: flapping.frequency_hz = -3: must lie in 0.1 … 1000 Hz"),
            "{error}"
        );
        assert_eq!(design, before);
    }
}
