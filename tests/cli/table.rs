//! From a table of readings to an answer, as a user at a terminal sees it.

use std::fs;

/// Readings of the wing of `washout init`, with something hidden.
const SHEET: &str = "r (mm);16 Hz;18 Hz;22 Hz\n15;7,20;8,30;10,53\n28;9,50;11,02;14,38\n40;9,68;11,50;14,56\n51;16,34;17,91;21,69\n\
                     62;16,28;18,29;21,43\n";

use crate::{folder, washout};

/// Table to answer in fifteen lines of 80.
#[test]
fn a_diagnosis_of_a_table_fits_on_a_screen_and_asks_for_the_root_edge_otherwise() {
    let here = folder();
    let sheet = here.path().join("sheet.csv");
    fs::write(&sheet, SHEET).expect("written");
    let said = washout(here.path(), &["init", "wing"]);
    assert_eq!(said.code, Some(0), "{}", said.err);
    let said = washout(
        here.path(),
        &[
            "diagnose",
            "wing.toml",
            "--with",
            "sheet.csv",
            "--sigma",
            "0.25",
            "--set",
            "mesh.refine=0.5",
            "--effect",
            "root-flexure",
            "--effect",
            "stop-backlash",
        ],
    );
    assert_eq!(said.code, Some(0), "{}", said.err);
    assert!(
        said.out
            .lines()
            .filter(|line| !line.starts_with("  washout"))
            .all(|line| line.chars().count() <= 80),
        "{}",
        said.out
    );
    assert!(said.out.lines().count() <= 15, "{}", said.out);
    let kept =
        fs::read_to_string(here.path().join("output/wing-sheet-diagnosis/diagnosis.json")).expect("kept");
    assert!(
        kept.contains("The root edge of the film is taken as free. Were it clamped,"),
        "{kept}"
    );
}
