//! Every published case on its three meshes.

use std::sync::LazyLock;

use washout::export::verification::VerifyReport;
use washout::progress::Progress;
use washout::verify::{ALL, Extent, run};

/// Cases that the elements of today miss; each leaves this list when it passes.
const MISSED: &[&str] = &[];

/// What `washout verify` finds, found once for all tests.
pub static FOUND: LazyLock<VerifyReport> = LazyLock::new(|| {
    let outcomes = run(ALL, Extent::Full, &Progress::quiet()).expect("nobody stops it");
    VerifyReport::new(&outcomes, Extent::Full)
});

#[test]
fn every_case_passes_but_those_that_are_known_to_be_missed() {
    println!("{}", FOUND.page().text());
    let mut failing = FOUND.failing();
    failing.sort();
    assert_eq!(failing, MISSED, "\n{}", FOUND.page().text());
}

#[test]
fn every_case_that_passes_is_within_its_limit_on_the_one_mesh_of_the_short_version() {
    for case in FOUND.cases().filter(|case| case.passed) {
        let short = ALL
            .iter()
            .find(|known| known.name == case.name)
            .expect("a case")
            .short;
        for quantity in case
            .quantities
            .iter()
            .filter(|quantity| quantity.verdict == "pass")
        {
            let error = case.error_at(quantity, short.word()).expect("an error");
            assert!(
                error <= quantity.tolerance,
                "{}, {}: {error}",
                case.name,
                quantity.name
            );
        }
    }
}
