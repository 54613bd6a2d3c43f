//! The checks of the floor plan, and tests that each of them can fail.

use std::fmt;
use std::path::{Path, PathBuf};

use crate::ROOMS;

/// Lines that a file may have.
const LONGEST_FILE: usize = 450;

/// Lines that `main.rs` may have.
const LONGEST_MAIN: usize = 100;

/// What is wrong with a file.
#[derive(Debug, PartialEq)]
pub enum Fault {
    /// A room uses a room that it may not know.
    ForbiddenImport {
        line: usize,
        room: String,
        target: String,
    },
    /// A file lies in a room that the plan does not have.
    UnknownRoom { room: String },
    /// The first line does not say what the file is.
    NoHead,
    /// Too long to be one thing.
    TooLong { lines: usize, allowed: usize },
    /// An import takes everything in.
    Glob { line: usize },
    /// A file that no `mod` names: it compiles silently without it.
    Orphan,
    /// An effect that `effects::ALL` does not list.
    EffectNotListed { effect: String },
}

impl fmt::Display for Fault {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Fault::ForbiddenImport { line, room, target } => {
                write!(formatter, "line {line}: room '{room}' may not import '{target}'")
            }
            Fault::UnknownRoom { room } => write!(formatter, "room '{room}' is not in the floor plan"),
            Fault::NoHead => write!(formatter, "the first line must be `//! what this file is`"),
            Fault::TooLong { lines, allowed } => write!(formatter, "{lines} lines, at most {allowed}"),
            Fault::Glob { line } => write!(formatter, "line {line}: a glob import"),
            Fault::Orphan => write!(formatter, "no `mod` names this file"),
            Fault::EffectNotListed { effect } => {
                write!(formatter, "effect '{effect}' is not in effects::ALL")
            }
        }
    }
}

/// The faults of one source file; `path` is relative to the `src` of its crate.
pub fn faults(path: &Path, source: &str) -> Vec<Fault> {
    let mut faults = Vec::new();
    let head = source.lines().next().unwrap_or_default();
    if head.strip_prefix("//!").is_none_or(|text| text.trim().is_empty()) {
        faults.push(Fault::NoHead);
    }
    let lines = source.lines().count();
    let allowed = if path == Path::new("main.rs") {
        LONGEST_MAIN
    } else {
        LONGEST_FILE
    };
    if lines > allowed {
        faults.push(Fault::TooLong { lines, allowed });
    }
    let code = blank_comments_and_texts(source);
    for (index, line) in code.lines().enumerate() {
        let line_text = line.trim();
        let in_use = line_text.starts_with("use ") || line_text.starts_with("pub use ");
        if in_use && line_text.contains("::*") && line_text != "use super::*;" {
            faults.push(Fault::Glob { line: index + 1 });
        }
    }
    let Some(room) = room_of(path) else { return faults };
    let Some((_, allowed)) = ROOMS.iter().find(|(name, _)| *name == room) else {
        faults.push(Fault::UnknownRoom { room });
        return faults;
    };
    for (line, target) in rooms_named(&code) {
        let is_room = ROOMS.iter().any(|(name, _)| *name == target);
        if is_room && target != room && !allowed.contains(&target.as_str()) {
            let room = room.clone();
            faults.push(Fault::ForbiddenImport { line, room, target });
        }
    }
    faults
}

/// The room that a file belongs to; none for `lib.rs` and `main.rs`.
pub fn room_of(path: &Path) -> Option<String> {
    let first = path.components().next()?.as_os_str().to_str()?;
    let name = first.strip_suffix(".rs").unwrap_or(first);
    (name != "lib" && name != "main").then(|| name.to_string())
}

/// What leads to a room: the crate itself, or one below by its own name.
const LEADS: [&str; 4] = ["crate::", "washout_design::", "washout_wing::", "washout_study::"];

/// Every `crate::NAME` and every first name in `crate::{NAME…, NAME…}`, with its line; likewise after the names of the crates.
fn rooms_named(code: &str) -> Vec<(usize, String)> {
    let mut found = Vec::new();
    let lead = |text: &str| -> String {
        let text = text.trim_start();
        text.chars()
            .take_while(|c| c.is_alphanumeric() || *c == '_')
            .collect()
    };
    for (start, crate_name) in LEADS.iter().flat_map(|lead| code.match_indices(lead)) {
        let word_before = code[..start].chars().next_back();
        if word_before.is_some_and(|c| c.is_alphanumeric() || c == '_' || c == '$') {
            continue;
        }
        let line = code[..start].lines().count().max(1);
        let rest = &code[start + crate_name.len()..];
        let Some(group) = rest.trim_start().strip_prefix('{') else {
            found.push((line, lead(rest)));
            continue;
        };
        let mut depth = 0;
        let mut item = 0;
        for (at, c) in group.char_indices() {
            match c {
                '{' => depth += 1,
                '}' if depth == 0 => {
                    found.push((line, lead(&group[item..at])));
                    break;
                }
                '}' => depth -= 1,
                ',' if depth == 0 => {
                    found.push((line, lead(&group[item..at])));
                    item = at + 1;
                }
                _ => {}
            }
        }
    }
    found
}

/// The source with comments and string literals blanked, lines kept.
fn blank_comments_and_texts(source: &str) -> String {
    let mut code = String::with_capacity(source.len());
    let mut rest = source;
    while let Some(c) = rest.chars().next() {
        let skipped = if rest.starts_with("//") {
            rest.find('\n').unwrap_or(rest.len())
        } else if rest.starts_with("/*") {
            rest.find("*/").map_or(rest.len(), |end| end + 2)
        } else if let Some(hashes) = raw_string_hashes(rest) {
            let close = format!("\"{}", "#".repeat(hashes));
            let open = hashes + 2;
            rest[open..]
                .find(&close)
                .map_or(rest.len(), |end| open + end + close.len())
        } else if c == '"' {
            string_end(rest)
        } else if rest.starts_with("'\"'") {
            3
        } else if rest.starts_with("'\\\"'") {
            4
        } else {
            0
        };
        if skipped == 0 {
            code.push(c);
            rest = &rest[c.len_utf8()..];
        } else {
            code.extend(
                rest[..skipped]
                    .chars()
                    .map(|c| if c == '\n' { '\n' } else { ' ' }),
            );
            rest = &rest[skipped..];
        }
    }
    code
}

/// Number of `#` in the head of a raw string such as `r#"`.
fn raw_string_hashes(text: &str) -> Option<usize> {
    let rest = text.strip_prefix('r')?;
    let hashes = rest.chars().take_while(|&c| c == '#').count();
    rest[hashes..].starts_with('"').then_some(hashes)
}

/// Length of the string literal at the start of `text`.
fn string_end(text: &str) -> usize {
    let mut escaped = false;
    for (at, c) in text.char_indices().skip(1) {
        match c {
            _ if escaped => escaped = false,
            '\\' => escaped = true,
            '"' => return at + 1,
            _ => {}
        }
    }
    text.len()
}

/// Whether some `mod` in the file above names this one.
pub fn is_named(path: &Path, sources: &[(PathBuf, String)]) -> bool {
    let stem = path
        .file_stem()
        .and_then(|stem| stem.to_str())
        .unwrap_or_default();
    let folder = path.parent().unwrap_or(Path::new(""));
    if folder == Path::new("") && (stem == "lib" || stem == "main") {
        return true;
    }
    let (name, owner_folder) = if stem == "mod" {
        let name = folder
            .file_name()
            .and_then(|name| name.to_str())
            .unwrap_or_default();
        (name, folder.parent().unwrap_or(Path::new("")))
    } else {
        (stem, folder)
    };
    let owners = [
        owner_folder.join("mod.rs"),
        owner_folder.with_extension("rs"),
        owner_folder.join("lib.rs"),
    ];
    let declared = format!("mod {name};");
    let is_owner = |path: &PathBuf| owners.contains(path);
    sources
        .iter()
        .any(|(path, source)| is_owner(path) && blank_comments_and_texts(source).contains(&declared))
}

/// The effect files that the text of `effects/mod.rs` does not list in `ALL`.
pub fn effects_not_listed(effects: &[&str], module: &str) -> Vec<Fault> {
    let code = blank_comments_and_texts(module);
    let all = code.find("ALL").map_or("", |at| &code[at..]);
    let list = all.find('=').map_or("", |at| &all[at..]);
    let list = &list[..list.find(';').unwrap_or(list.len())];
    effects
        .iter()
        .filter(|effect| !list.contains(&format!("{effect}::")))
        .map(|effect| Fault::EffectNotListed {
            effect: effect.to_string(),
        })
        .collect()
}

mod tests {
    use super::*;

    fn in_aero(body: &str) -> Vec<Fault> {
        faults(Path::new("aero/strip.rs"), &format!("//! A strip.\n{body}\n"))
    }

    fn forbidden(line: usize, target: &str) -> Fault {
        let (room, target) = ("aero".to_string(), target.to_string());
        Fault::ForbiddenImport { line, room, target }
    }

    #[test]
    fn an_import_against_the_flow_is_found_in_every_form() {
        assert_eq!(
            in_aero("use crate::structure::state::State;"),
            [forbidden(2, "structure")]
        );
        assert_eq!(
            in_aero("use crate::{input::Design, mesh::{Mesh}};"),
            [forbidden(2, "mesh")]
        );
        assert_eq!(
            in_aero("use crate::{\n    input,\n    coupling,\n};"),
            [forbidden(2, "coupling")]
        );
        assert_eq!(
            in_aero("use washout_wing::structure::state::State;"),
            [forbidden(2, "structure")]
        );
        assert_eq!(in_aero("fn f(x: &crate::cli::Solve) {}"), [forbidden(2, "cli")]);
        assert_eq!(in_aero("pub(in crate::lift) fn f() {}"), [forbidden(2, "lift")]);
    }

    #[test]
    fn imports_with_the_flow_and_mere_words_pass() {
        assert_eq!(
            in_aero("use crate::input::design::Design;\nuse crate::aero::flow::Flow;"),
            []
        );
        assert_eq!(
            in_aero("// crate::mesh\n/* crate::mesh */ const A: &str = \"\\\"crate::mesh\";"),
            []
        );
        assert_eq!(
            in_aero("const A: &str = r#\"crate::mesh \" \"#; const B: char = '\"';"),
            []
        );
    }

    #[test]
    fn an_import_after_a_quote_character_is_still_found() {
        assert_eq!(
            in_aero("const B: char = '\"';\nuse crate::mesh::Mesh;"),
            [forbidden(3, "mesh")]
        );
    }

    #[test]
    fn a_file_without_a_head_is_found() {
        assert_eq!(faults(Path::new("aero/a.rs"), "use std::fmt;\n"), [Fault::NoHead]);
        assert_eq!(faults(Path::new("aero/a.rs"), "//!\n"), [Fault::NoHead]);
        assert_eq!(faults(Path::new("aero/a.rs"), ""), [Fault::NoHead]);
    }

    #[test]
    fn a_file_that_is_too_long_is_found() {
        let long = |lines: usize| format!("//! Long.\n{}", "\n".repeat(lines - 1));
        assert_eq!(faults(Path::new("aero/a.rs"), &long(450)), []);
        assert_eq!(
            faults(Path::new("aero/a.rs"), &long(451)),
            [Fault::TooLong {
                lines: 451,
                allowed: 450
            }]
        );
        assert_eq!(
            faults(Path::new("main.rs"), &long(101)),
            [Fault::TooLong {
                lines: 101,
                allowed: 100
            }]
        );
    }

    #[test]
    fn a_glob_and_a_room_outside_the_plan_are_found() {
        assert_eq!(in_aero("use std::fmt::*;"), [Fault::Glob { line: 2 }]);
        assert_eq!(in_aero("mod tests {\n    use super::*;\n}"), []);
        assert_eq!(
            faults(Path::new("util/a.rs"), "//! Odds and ends.\n"),
            [Fault::UnknownRoom {
                room: "util".to_string()
            }]
        );
    }

    #[test]
    fn a_file_that_no_mod_names_is_found() {
        let sources = vec![
            (PathBuf::from("lib.rs"), "pub mod aero;".to_string()),
            (
                PathBuf::from("aero/mod.rs"),
                "pub mod flow; // mod strip;".to_string(),
            ),
        ];
        assert!(is_named(Path::new("aero/mod.rs"), &sources));
        assert!(is_named(Path::new("aero/flow.rs"), &sources));
        assert!(!is_named(Path::new("aero/strip.rs"), &sources));
        assert!(!is_named(Path::new("lift/mod.rs"), &sources));
    }

    #[test]
    fn an_effect_outside_all_is_found() {
        let module = "pub mod inflow; pub mod tip_loss; pub const ALL: &[&Effect] = &[&inflow::EFFECT];";
        let fault = Fault::EffectNotListed {
            effect: "tip_loss".to_string(),
        };
        assert_eq!(effects_not_listed(&["inflow", "tip_loss"], module), [fault]);
    }
}
