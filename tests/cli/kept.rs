//! How a campaign answers, and what was answered to a question, is kept between diagnoses, under what it was made of.

use std::fs;
use std::path::{Path, PathBuf};

use serde_json::Value;

use crate::{folder, program};

const ROD: &str = "format = 1\nname = 'rod'\n[planform]\nlength_mm = 100.0\noutline = [[0.0, 20.0], [100.0, 20.0]]\ntip_cut = 1.0\n\
                   [ribs]\nbays = 10\n[[rod]]\nfrom_mm = 0.0\nto_mm = 100.0\nmaterial = 'steel'\n\
                   section = { shape = 'round', diameter_mm = 1.0 }\n\
                   [material.steel]\ne_gpa = 200.0\ng_gpa = 80.0\npoisson = 0.25\ndensity_kg_m3 = 8000.0\n\
                   [[load]]\nat_mm = 100.0\nmoment_n_m = [0.01, 0.0, 0.0]\n";

/// The study in `folder` diagnosed, with tables kept in `kept` there.
fn diagnosed(folder: &Path) -> Value {
    let said = program(folder)
        .args(["diagnose", "study.toml", "--json", "--quiet"])
        .env("WASHOUT_CACHE", folder.join("kept"))
        .output()
        .expect("the program starts");
    assert_eq!(
        said.status.code(),
        Some(0),
        "{}",
        String::from_utf8_lossy(&said.stderr)
    );
    let mut said: Value = serde_json::from_slice(&said.stdout).expect("JSON");
    // which files it was made of is another question
    said.as_object_mut().expect("an object").remove("made_of");
    said
}

fn write_readings(folder: &Path, softer: f64) {
    let mut rows =
        "case,channel,instrument,unit,sign,run,r_mm,r_to_mm,value,sigma,sigma_kind,bound\n".to_string();
    for r_mm in (10..=100).step_by(10) {
        // 0.01 N m on a rod of GJ = 80 GPa π d⁴ / 32
        let twist = softer * 7.2952 * f64::from(r_mm) / 1e2;
        rows += &format!("m,twist,chord_rotation,deg,washout,,{r_mm},,{twist:.4},0.05,stated,none\n");
    }
    fs::write(folder.join("m.csv"), rows).expect("written");
}

fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder.join("kept")).expect("a folder");
    entries.map(|entry| entry.expect("an entry").path()).collect()
}

#[test]
fn what_is_kept_changes_no_number_serves_other_readings_and_is_made_anew_where_damaged_or_of_another_wing() {
    let folder = folder();
    let folder = folder.path();
    fs::write(folder.join("rod.toml"), ROD).expect("written");
    let study = "format = 1\nname = 's'\ncandidates = ['rod-shear-modulus', 'root-flexure', 'rod-split']\n\
                 [[case]]\ndesign = 'rod.toml'\nmeasurement = 'm.csv'\nmeasured = 'm'\n";
    fs::write(folder.join("study.toml"), study).expect("written");
    write_readings(folder, 1.0);
    let first = diagnosed(folder);
    let kept = files(folder);
    assert_eq!(
        kept.len(),
        2,
        "how the campaign answers, and the answer to this question"
    );
    assert_eq!(diagnosed(folder), first);
    let whole: Vec<Vec<u8>> = kept.iter().map(|file| fs::read(file).expect("read")).collect();
    for (file, whole) in kept.iter().zip(&whole) {
        fs::write(file, &whole[..whole.len() / 2]).expect("written");
        assert_eq!(diagnosed(folder), first);
        assert_eq!(&fs::read(file).expect("read"), whole);
    }
    write_readings(folder, 1.3);
    assert_ne!(diagnosed(folder)["p_nothing"], first["p_nothing"]);
    assert_eq!(files(folder).len(), 3, "another answer by the same campaign");
    fs::write(
        folder.join("rod.toml"),
        ROD.replace("g_gpa = 80.0", "g_gpa = 60.0"),
    )
    .expect("written");
    diagnosed(folder);
    assert_eq!(files(folder).len(), 5);
}
