//! Files that cannot be what they should be, and files that refer to such files.

use std::fs;
use std::path::Path;

use washout::input::Design;

use crate::bad_designs::WING;

const CARBON: &str = "[material.carbon]\ne_gpa = 134.0\ng_gpa = 4.0\ndensity_kg_m3 = 1500.0\n";
const HEAD: &str = "case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n";

/// The message with which `wing.toml` is refused in a folder with these files; `DIR` stands for the folder.
fn message(files: &[(&str, &[u8])]) -> String {
    let folder = tempfile::tempdir().expect("a temporary folder");
    for (name, bytes) in files {
        fs::write(folder.path().join(name), bytes).expect("a file is written");
    }
    match Design::load(&folder.path().join("wing.toml"), &[]) {
        Ok(_) => "(accepted)".to_string(),
        Err(error) => error
            .to_string()
            .replace(&folder.path().display().to_string(), "DIR"),
    }
}

/// The wing with a line at its top and a table at its end.
fn wing_with(line: &str, table: &str) -> Vec<u8> {
    format!("{line}\n{WING}\n{table}\n").into_bytes()
}

/// Asserts the message of the wing with a line at its top, a table at its end, and one more file.
fn assert_refused(line: &str, table: &str, file: (&str, &str), expected: &str) {
    let wing = wing_with(line, table);
    let found = message(&[("wing.toml", &wing), (file.0, file.1.as_bytes())]);
    assert_eq!(found, expected);
}

const NONE: (&str, &str) = ("other.txt", "nothing");

#[test]
fn a_design_that_does_not_exist() {
    assert_eq!(
        message(&[]),
        "DIR/wing.toml: no such file.\n  \
         Check the path of the design file"
    );
}

#[test]
fn a_folder_instead_of_a_design() {
    let folder = tempfile::tempdir().expect("a temporary folder");
    let found = Design::load(folder.path(), &[])
        .map(|_| ())
        .unwrap_err()
        .to_string();
    let expected = "DIR: is a folder.\n  Name a design file inside it";
    assert_eq!(
        found.replace(&folder.path().display().to_string(), "DIR"),
        expected
    );
}

#[test]
fn an_empty_design() {
    assert_eq!(
        message(&[("wing.toml", b" \n\n")]),
        "DIR/wing.toml: is empty.\n  \
         `washout init NAME` writes a design to start from"
    );
}

#[test]
fn a_huge_design() {
    let huge = vec![b'#'; 4 * 1024 * 1024 + 1];
    assert_eq!(
        message(&[("wing.toml", &huge)]),
        "DIR/wing.toml: is larger than 4 MB.\n  \
         A design file is a few kB of text; check the path"
    );
}

#[test]
fn a_binary_design() {
    assert_eq!(
        message(&[("wing.toml", b"\x7fELF\x02\x01\x01\x00\x00")]),
        "DIR/wing.toml: is a binary file.\n  \
         A design file is plain text; check the path"
    );
}

#[test]
fn a_design_in_another_encoding() {
    assert_eq!(
        message(&[("wing.toml", b"format = 1\nname = \"fl\xfcgel\"\n")]),
        "DIR/wing.toml:2:11: is not UTF-8: byte 0xfc.\n  \
         Save the file as UTF-8 text"
    );
}

#[test]
fn a_byte_order_mark_is_no_fault() {
    let text = format!("\u{feff}{WING}");
    assert_eq!(message(&[("wing.toml", text.as_bytes())]), "(accepted)");
}

#[test]
fn windows_line_ends_are_no_fault() {
    let text = WING.replace('\n', "\r\n");
    assert_eq!(message(&[("wing.toml", text.as_bytes())]), "(accepted)");
}

#[test]
fn materials_that_do_not_exist() {
    assert_refused(
        "materials = \"none.toml\"",
        "",
        NONE,
        "DIR/wing.toml:1:13: materials = \"none.toml\": no such file.\n  \
         Looked for DIR/none.toml; paths are relative to the design file",
    );
}

#[test]
fn materials_that_are_the_design_itself() {
    assert_refused(
        "materials = \"./wing.toml\"",
        "",
        NONE,
        "DIR/wing.toml:1:13: materials = \"./wing.toml\": is the design file itself.\n  \
         Name another file, or leave the key out",
    );
}

#[test]
fn materials_that_name_materials() {
    let text = format!("format = 1\nmaterials = \"wing.toml\"\n{CARBON}");
    assert_refused(
        "materials = \"m.toml\"",
        "",
        ("m.toml", &text),
        "DIR/m.toml:2:13: materials = \"wing.toml\": a materials file cannot name another one.\n  \
         Write all materials into one file, as tables [material.NAME]",
    );
}

#[test]
fn materials_of_another_format() {
    let text = format!("format = 3\n{CARBON}");
    assert_refused(
        "materials = \"m.toml\"",
        "",
        ("m.toml", &text),
        "DIR/m.toml:1:10: format = 3: this program reads format 1.\n  \
         Write format = 1, or use the version of washout that the file was made for",
    );
}

#[test]
fn materials_without_materials() {
    assert_refused(
        "materials = \"m.toml\"",
        "",
        ("m.toml", "format = 1\n"),
        "DIR/m.toml: material is missing.\n  \
         Give the materials by name, one `[material.NAME]` table each",
    );
}

#[test]
fn a_fault_in_the_materials_is_placed_there() {
    let text = format!("format = 1\n{CARBON}colour = \"black\"\n");
    assert_refused(
        "materials = \"m.toml\"",
        "",
        ("m.toml", &text),
        "DIR/m.toml:6:1: material.carbon.colour = \"black\": unknown key.\n  \
         Allowed in material.carbon: e_gpa, e2_gpa, g_gpa, poisson, density_kg_m3, strength_mpa, source",
    );
}

#[test]
fn a_material_beyond_its_form_is_placed_in_its_file() {
    let text = "format = 1\n[material.ply]\ne_gpa = 100.0\ne2_gpa = 5.0\ndensity_kg_m3 = 1500.0\n";
    assert_refused(
        "materials = \"m.toml\"",
        "",
        ("m.toml", text),
        "DIR/m.toml:2:1: material.ply.g_gpa is needed where e2_gpa makes the material orthotropic.\n  \
         Give the shear modulus in gigapascals, e.g. g_gpa = 4.5, or leave e2_gpa out",
    );
}

#[test]
fn the_designs_own_material_counts() {
    let text = format!("format = 1\n{CARBON}").replace("134.0", "1.0");
    let wing = wing_with("materials = \"m.toml\"", "");
    let folder = tempfile::tempdir().expect("a temporary folder");
    fs::write(folder.path().join("wing.toml"), wing).expect("a file is written");
    fs::write(folder.path().join("m.toml"), text).expect("a file is written");
    let loaded =
        Design::load(&folder.path().join("wing.toml"), &[]).unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(loaded.design.material["carbon"].e_gpa, 134.0.into());
    assert_eq!(
        loaded.materials_path.as_deref().and_then(Path::file_name),
        Some("m.toml".as_ref())
    );
}

#[test]
fn coefficients_that_do_not_exist() {
    assert_refused(
        "",
        "[air]\ncoefficients = \"table\"\ntable = \"c.csv\"",
        NONE,
        "DIR/wing.toml:59:9: air.table = \"c.csv\": no such file.\n  \
         Looked for DIR/c.csv; paths are relative to the design file",
    );
}

#[test]
fn coefficients_with_a_word() {
    let table = "[air]\ncoefficients = \"table\"\ntable = \"c.csv\"";
    assert_refused(
        "",
        table,
        ("c.csv", "alpha_deg,cl,cd\n0,0,0\n5,much,0\n"),
        "DIR/c.csv:3: cl = much: must be a number, not text.\n  \
         Give the lift coefficient",
    );
}

#[test]
fn coefficients_without_a_column() {
    let table = "[air]\ncoefficients = \"table\"\ntable = \"c.csv\"";
    assert_refused(
        "",
        table,
        ("c.csv", "alpha_deg,cl\n0,0\n5,0.4\n"),
        "DIR/c.csv:1: column cd is missing.\n  \
         The columns are alpha_deg,cl,cd",
    );
}

#[test]
fn coefficients_in_radians_of_two_turns() {
    let table = "[air]\ncoefficients = \"table\"\ntable = \"c.csv\"";
    assert_refused(
        "",
        table,
        ("c.csv", "alpha_deg,cl,cd\n0,0,0\n720,0,0\n"),
        "DIR/c.csv:3: alpha_deg = 720: must lie in -180 … 180 deg.\n  \
         Give the angle of attack in degrees",
    );
}

#[test]
fn a_mesh_that_does_not_exist() {
    assert_refused(
        "",
        "[mesh]\nfile = \"wing.msh\"",
        NONE,
        "DIR/wing.toml:58:8: mesh.file = \"wing.msh\": no such file.\n  \
         Looked for DIR/wing.msh; paths are relative to the design file",
    );
}

#[test]
fn a_measurement_that_does_not_exist() {
    assert_refused(
        "",
        "[measured]\nfile = \"m.csv\"\ncase = \"wing\"",
        NONE,
        "DIR/wing.toml:58:8: measured.file = \"m.csv\": no such file.\n  \
         Looked for DIR/m.csv; paths are relative to the design file",
    );
}

#[test]
fn a_measurement_without_the_case() {
    let text = format!("{HEAD}rigid,lift_ratio,,1,,,,,1.0,0.1,assumed,none\n");
    assert_refused(
        "",
        "[measured]\nfile = \"m.csv\"\ncase = \"wing\"",
        ("m.csv", &text),
        "DIR/wing.toml:59:8: measured.case = \"wing\": must be rigid.\n  \
         These are the cases of DIR/m.csv",
    );
}

#[test]
fn a_measured_station_off_the_wing() {
    let text = format!("{HEAD}wing,twist,camera,deg,washout,,75,,10,1,stated,none\n");
    assert_refused(
        "",
        "[measured]\nfile = \"m.csv\"\ncase = \"wing\"",
        ("m.csv", &text),
        "DIR/m.csv:2: r_mm = 75: must lie in 0 … 70 mm.\n  \
         Give the station from the wing base; wing is 70 mm long (planform.length_mm)",
    );
}

#[test]
fn a_measured_interval_that_ends_off_the_wing() {
    let text = format!("{HEAD}wing,twist_rate,camera,deg/mm,washout,,60,75,1,1,stated,none\n");
    assert_refused(
        "",
        "[measured]\nfile = \"m.csv\"\ncase = \"wing\"",
        ("m.csv", &text),
        "DIR/m.csv:2: r_to_mm = 75: must lie in 0 … 70 mm.\n  \
         Give the station from the wing base; wing is 70 mm long (planform.length_mm)",
    );
}
