//! docs/how-far-to-trust-washout.md says what the cases give now.

use std::path::Path;

use washout::compare::StudyComparison;
use washout::compare::study::compare_study;
use washout::export::trust::trust_page;
use washout::input::study::LoadedStudy;
use washout::progress::Progress;
use washout::study::Campaign;

use crate::cases::FOUND;

/// The studies of the page; the paper's wings take minutes and stand in the README.
const STUDIES: [&str; 15] = [
    "tang-dowell-gravity",
    "tang-dowell-wind",
    "pre-pazy",
    "pre-pazy-skin",
    "pre-pazy-wind",
    "pre-pazy-wind-yielding",
    "pazy",
    "pazy-skin",
    "pazy-skin-bare",
    "pazy-wind",
    "pazy-wind-lifting-line",
    "minguet",
    "robobee",
    "robobee-b",
    "robobee-c",
];

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn compared(name: &str) -> StudyComparison {
    let study = LoadedStudy::load(&root().join(format!("studies/{name}.toml")), &[]).expect("a study");
    let campaign = Campaign::new(&study, &[], &Progress::quiet()).expect("a campaign");
    compare_study(&campaign, &study.study.title).expect("a comparison")
}

/// Words must be the same; numbers, of which two digits count, may differ by one in the second.
fn near(shown: &str, found: &str) -> bool {
    let (Ok(a), Ok(b)) = (shown.parse::<f64>(), found.parse::<f64>()) else {
        return shown == found;
    };
    (a - b).abs() <= 0.12 * b.abs()
}

#[test]
fn the_page_of_documentation_says_what_the_cases_give_now() {
    let path = root().join("docs/how-far-to-trust-washout.md");
    let page = std::fs::read_to_string(path).expect("the page");
    let now = trust_page(&FOUND, &STUDIES.map(compared));
    let studies = STUDIES.map(|name| format!(" --study studies/{name}.toml"));
    let renew = format!(
        "run `washout verify --page docs/how-far-to-trust-washout.md{}`",
        studies.concat()
    );
    assert_eq!(page.lines().count(), now.lines().count(), "{renew}");
    for (shown, found) in page.lines().zip(now.lines()) {
        let (before, after) = (shown.split_whitespace(), found.split_whitespace());
        let same = before.clone().count() == after.clone().count()
            && before.zip(after).all(|(before, after)| near(before, after));
        assert!(same, "{shown}\nis now\n{found}\n{renew}");
    }
}

#[test]
fn the_page_of_studies_says_what_the_schema_and_the_example_say() {
    let page = std::fs::read_to_string(root().join("docs/studies.md")).expect("the page");
    assert!(
        page == washout::export::studies::studies_page(),
        "docs/studies.md differs from the schema; run `washout schema --study --page docs/studies.md`"
    );
}
