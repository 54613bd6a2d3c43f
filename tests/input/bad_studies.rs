//! Study files that must be refused, each with its whole message.

use std::path::Path;

use washout::input::study::LoadedStudy;

const CASE: &str =
    "[[case]]\ndesign = 'designs/twist-v2.toml'\nmeasurement = 'measurements/colmenares-as-stated.csv'\n";

fn refused(text: &str) -> String {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("s.toml");
    let error = LoadedStudy::from_text(&path, text, &[]).unwrap_err().to_string();
    error.replace(&format!("{}/", env!("CARGO_MANIFEST_DIR")), "")
}

fn study(rest: &str) -> String {
    format!("format = 1\nname = 'paper'\n{rest}")
}

#[test]
fn a_sound_study_is_read() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("s.toml");
    let loaded = LoadedStudy::from_text(&path, &study(&format!("{CASE}measured = 'twist-v2'\n")), &[]);
    let loaded = loaded.unwrap_or_else(|error| panic!("{error}"));
    assert_eq!(
        (loaded.cases.len(), loaded.cases[0].name.as_str()),
        (1, "twist-v2")
    );
}

#[test]
fn bad_studies_are_refused_with_place_value_and_cure() {
    let cases: &[(&str, &str)] = &[
        (
            "[[case]]\ndesign = 'nope.toml'\nmeasurement = 'm.csv'\nmeasured = 'x'\n",
            "s.toml:4:10: case[0].design = 'nope.toml': no such file.\n  Looked for nope.toml; paths are relative to the study",
        ),
        (
            "case = []\n",
            "s.toml:3:8: case = []: there is no case.\n  Add a table [[case]]",
        ),
        (
            &format!("{CASE}measured = 'twist-v3'\n"),
            "s.toml:6:12: case[0].measured = 'twist-v3': no measured case has this name.\n  \
             These are the cases of measurements/colmenares-as-stated.csv: rigid, twist-v1, twist-v2",
        ),
        (
            &format!("{CASE}measured = 'twist-v{{x'\n"),
            "s.toml:6:12: case[0].measured = 'twist-v{x': a brace is opened and never closed.\n  \
             Write e.g. measured = \"bending-{mass}\"",
        ),
        (
            &format!("{CASE}measured = 'twist-v2'\nset = ['flapping.frequency_hz={{f}}']\n"),
            "s.toml:7:7: case[0].set = ['flapping.frequency_hz={f}']: there is no number {f} in measured.\n  \
             Write e.g. set = [\"load[0].mass_kg={mass}\"] with measured = \"bending-{mass}\"",
        ),
        (
            &format!("{CASE}measured = 'twist-v2'\nheld_out = ['rigid']\n"),
            "s.toml:7:12: case[0].held_out = ['rigid']: rigid is none of these cases.\n  \
             Name cases of the form twist-v2",
        ),
        (
            &format!("{CASE}measured = 'twist-v2'\n[[uncertain]]\nkey = 'a.b'\nrange = [3.0, 2.0]\n"),
            "s.toml:9:9: uncertain[0].range = [3.0, 2.0]: is no range around the mean.\n  \
             Give the lower end first, and the mean between both",
        ),
        (
            &format!("{CASE}measured = 'twist-v2'\n[[uncertain]]\nkey = 'a.b'\ndesigns = ['v9']\n"),
            "s.toml:9:11: uncertain[0].designs = ['v9']: no case has a design v9.\n  \
             The cases have the designs twist-v2",
        ),
        (
            &format!(
                "{CASE}measured = 'twist-v2'\n[[uncertain]]\nkey = 'material.carbon-rod.g_gap'\nsigma = 1.0\n"
            ),
            "s.toml:8:7: uncertain[0].key = 'material.carbon-rod.g_gap': no design of the study has a number there.\n  \
             Did you mean material.carbon-rod.g_gpa?",
        ),
        (
            &format!("{CASE}measured = 'twist-v2'\n[[uncertain]]\nkey = 'nothing'\nsigma = 1.0\n"),
            "s.toml:8:7: uncertain[0].key = 'nothing': no design of the study has a number there.\n  \
             Give the dotted key of a number, such as material.carbon-rod.g_gpa",
        ),
        (
            &format!(
                "{CASE}measured = 'twist-v2'\n[[ruler]]\nkind = 'offset'\nchannel = 'twist'\nsigma = 0.3\nruns = ['v9']\n"
            ),
            "s.toml:11:8: ruler[0].runs = ['v9']: no reading of twist has such a run.\n  Its readings name no runs: leave this out",
        ),
        (
            &format!("{CASE}measured = 'twist-v2'\nmesured = 1\n"),
            "s.toml:7:1: case[0].mesured = 1: unknown key.\n  Did you mean measured? Allowed in case[0]: design, set, measurement, \
             measured, channels, reference, use, held_out",
        ),
        (
            &format!(
                "{CASE}measured = 'twist-v2'\n[[ruler]]\nkind = 'offset'\nchannel = 'twist'\nsigma = 0.0\n"
            ),
            "",
        ),
    ];
    for (text, expected) in cases {
        let found = refused(&study(text));
        if expected.is_empty() {
            assert!(
                found.starts_with("s.toml:10:9: ruler[0].sigma = 0.0: must"),
                "{found}"
            );
        } else {
            assert_eq!(found, *expected);
        }
    }
}

#[test]
fn the_earlier_name_of_the_discrepancy_is_read_on_but_not_beside_the_new_one() {
    let path = Path::new(env!("CARGO_MANIFEST_DIR")).join("studies/tang-dowell-wind.toml");
    let text = std::fs::read_to_string(&path).unwrap();
    let with = |lines: &str| {
        let text = text.replacen("format = 1\n", &format!("format = 1\n{lines}"), 1);
        LoadedStudy::from_text(&path, &text, &[])
    };
    for key in ["slop", "discrepancy"] {
        assert_eq!(with(&format!("{key} = 0.02\n")).unwrap().study.discrepancy, 0.02);
    }
    assert!(with("slop = 0.02\ndiscrepancy = 0.02\n").is_err());
}
