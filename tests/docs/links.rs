//! Every link between pages, to files and to headings leads somewhere, and every page stands in the book.

use std::path::{Component, Path, PathBuf};

use crate::{all_pages, root, text_of};

#[test]
fn every_link_and_picture_leads_somewhere() {
    let mut followed = 0;
    for page in all_pages() {
        for target in targets(&text_of(&page)) {
            if target.contains("://") {
                continue;
            }
            followed += 1;
            let (file, heading) = target.split_once('#').unwrap_or((target.as_str(), ""));
            let path = if file.is_empty() {
                PathBuf::from(&page)
            } else {
                joined(&page, file)
            };
            // the Python package stands beside the crate, not in it
            if path.starts_with("python") && !root().join("python").exists() {
                continue;
            }
            assert!(root().join(&path).exists(), "{page}: there is no {target}");
            if !heading.is_empty() {
                let text = text_of(path.to_str().expect("UTF-8"));
                assert!(
                    anchors(&text).iter().any(|anchor| anchor == heading),
                    "{page}: {target} has no such heading"
                );
            }
        }
    }
    assert!(followed > 100, "{followed} links");
}

#[test]
fn every_page_stands_once_in_the_book() {
    let summary = text_of("docs/SUMMARY.md");
    for page in all_pages() {
        let Some(name) = page.strip_prefix("docs/").filter(|name| *name != "SUMMARY.md") else {
            continue;
        };
        let count = summary.matches(&format!("]({name})")).count();
        assert_eq!(count, 1, "{name} in docs/SUMMARY.md");
    }
}

/// Where the links of a page lead, code left out.
fn targets(text: &str) -> Vec<String> {
    let mut found = Vec::new();
    let mut is_inside = false;
    for line in text.lines() {
        is_inside ^= line.starts_with("```");
        if is_inside {
            continue;
        }
        let prose: String = line.split('`').step_by(2).collect::<Vec<_>>().join("code");
        for part in prose.split("](").skip(1) {
            found.push(part.split(')').next().unwrap_or_default().to_string());
        }
    }
    found
}

/// A link from a page, as a path from the repository.
fn joined(page: &str, link: &str) -> PathBuf {
    let mut path = PathBuf::new();
    let whole = Path::new(page).parent().expect("a folder").join(link);
    for part in whole.components() {
        match part {
            Component::ParentDir => {
                path.pop();
            }
            part => path.push(part),
        }
    }
    path
}

/// The anchors of the headings of a page.
fn anchors(text: &str) -> Vec<String> {
    let mut is_inside = false;
    let headings = text.lines().filter(|line| {
        is_inside ^= line.starts_with("```");
        !is_inside && line.starts_with('#')
    });
    headings
        .map(|line| {
            let title = line.trim_start_matches('#').trim().to_lowercase();
            let kept = title.chars().filter_map(|letter| match letter {
                ' ' => Some('-'),
                letter if letter.is_alphanumeric() || letter == '_' || letter == '-' => Some(letter),
                _ => None,
            });
            kept.collect()
        })
        .collect()
}

#[test]
fn links_and_anchors_are_found() {
    assert_eq!(
        targets("a [b](c.md#d) ![e](f.svg)\n```\n[g](h)\n```\n`[i](j)`"),
        ["c.md#d", "f.svg"]
    );
    assert_eq!(anchors("# A b\n```\n# no\n```\n## `[c.d]`, e"), ["a-b", "cd-e"]);
    assert_eq!(
        joined("docs/reference/x.md", "../lift.md"),
        Path::new("docs/lift.md")
    );
}
