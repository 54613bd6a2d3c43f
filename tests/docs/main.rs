//! What README and docs show is what the program does: every command is run, every output compared, every link followed.

mod links;

mod page;

mod pages;

mod readme;

mod reference;

mod sentences;

mod text;

mod workshop;

use std::path::Path;

/// The repository.
fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

/// Every page of the book, as a path from the repository, in the order of the alphabet; README and changelog first.
fn all_pages() -> Vec<String> {
    let mut pages = ["README.md", "CONTRIBUTING.md", "CHANGELOG.md"]
        .map(str::to_string)
        .to_vec();
    for folder in ["docs", "docs/reference"] {
        let entries = std::fs::read_dir(root().join(folder)).expect("a folder");
        let names = entries.map(|entry| entry.expect("an entry").file_name().into_string().expect("UTF-8"));
        let mut names: Vec<String> = names.filter(|name| name.ends_with(".md")).collect();
        names.sort();
        pages.extend(names.into_iter().map(|name| format!("{folder}/{name}")));
    }
    pages
}

/// The text of a page.
fn text_of(page: &str) -> String {
    std::fs::read_to_string(root().join(page)).unwrap_or_else(|error| panic!("{page}: {error}"))
}
