//! The pictures of the documentation are what `washout compare` draws today.

use std::path::Path;

use washout::compare::study::compare_study;
use washout::export::pictures::compared::figure;
use washout::export::pictures::panels::Compared;
use washout::input::study::LoadedStudy;
use washout::progress::Progress;
use washout::study::Campaign;

/// Tenths of a pixel by which a mark may move from machine to machine.
const ALLOWED: f64 = 5.0;

/// Studies that are solved in seconds; that of the paper's wings, which takes a minute, is left to the eye.
const STUDIES: [&str; 11] = [
    "tang-dowell-gravity",
    "tang-dowell-wind",
    "pre-pazy",
    "pre-pazy-skin",
    "pre-pazy-wind",
    "pre-pazy-wind-yielding",
    "pazy",
    "pazy-skin-bare",
    "pazy-wind-lifting-line",
    "minguet",
    "robobee",
];

/// Words and numbers of a text, apart.
fn parts(text: &str) -> (String, Vec<f64>) {
    let (mut words, mut numbers, mut digits) = (String::new(), Vec::new(), String::new());
    for c in text.chars().chain(['\n']) {
        if c.is_ascii_digit() || c == '.' {
            digits.push(c);
            continue;
        }
        if let Ok(number) = digits.parse() {
            numbers.push(number);
            words.push('0');
        }
        digits.clear();
        words.push(c);
    }
    (words, numbers)
}

#[test]
fn the_pictures_of_the_documentation_are_what_compare_draws() {
    let root = Path::new(env!("CARGO_MANIFEST_DIR"));
    for name in STUDIES {
        let study = LoadedStudy::load(&root.join(format!("studies/{name}.toml")), &[]).unwrap();
        let campaign = Campaign::new(&study, &[], &Progress::quiet()).unwrap();
        let comparison = compare_study(&campaign, &study.study.title).unwrap();
        let drawn = figure(&Compared::of_study(&comparison)).to_svg().unwrap();
        let kept = std::fs::read_to_string(root.join(format!("docs/pictures/{name}.svg"))).unwrap();
        let ((words, numbers), (words_kept, numbers_kept)) = (parts(&drawn), parts(&kept));
        let cure = format!(
            "docs/pictures/{name}.svg is old: washout compare studies/{name}.toml, then take compared.svg of its folder"
        );
        assert!(
            words == words_kept && numbers.len() == numbers_kept.len(),
            "{cure}"
        );
        let moved = numbers
            .iter()
            .zip(&numbers_kept)
            .map(|(a, b)| (a - b).abs())
            .fold(0.0, f64::max);
        assert!(moved <= ALLOWED, "{cure} ({moved} tenths of a pixel)");
        assert!(kept.len() < 100_000, "{} bytes", kept.len());
    }
}

#[test]
fn every_picture_of_the_documentation_is_shown_on_a_page_and_every_page_finds_its_own() {
    let docs = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let names = |folder: &Path, ending: &str| -> Vec<String> {
        let entries = std::fs::read_dir(folder).unwrap();
        let names = entries.map(|entry| entry.unwrap().file_name().into_string().unwrap());
        names.filter(|name| name.ends_with(ending)).collect()
    };
    let pages: String = names(&docs, ".md")
        .iter()
        .map(|page| std::fs::read_to_string(docs.join(page)).unwrap())
        .collect();
    let readme = std::fs::read_to_string(docs.with_file_name("README.md")).unwrap();
    let pictures = [
        names(&docs.join("pictures"), ".svg"),
        names(&docs.join("pictures"), ".png"),
    ]
    .concat();
    assert!(pictures.len() > STUDIES.len());
    for picture in &pictures {
        let is_shown = pages.contains(&format!("](pictures/{picture})"))
            || readme.contains(&format!("](docs/pictures/{picture})"));
        assert!(is_shown, "{picture} stands on no page");
    }
    for shown in pages.split("](pictures/").skip(1) {
        let name = shown.split(')').next().unwrap_or_default();
        assert!(
            pictures.iter().any(|picture| picture == name),
            "there is no docs/pictures/{name}"
        );
    }
}
