//! Keeps the house in order: imports follow the flow of data, every file says what it is, no file grows wild.

use std::fs;
use std::path::{Path, PathBuf};

mod check;
mod circles;

use check::{Fault, effects_not_listed, faults, is_named, room_of};
use circles::circles;

/// The crates, from the ground up: the folders that hold rooms.
const CRATES: &[&str] = &[
    "crates/washout-design/src",
    "crates/washout-wing/src",
    "crates/washout-study/src",
    "src",
];

/// Each room and the rooms that it may import. The order is the way the data flows.
const ROOMS: &[(&str, &[&str])] = &[
    ("progress", &[]),
    ("origin", &[]),
    ("input", &["progress", "origin"]),
    ("geometry", &["progress", "input"]),
    ("mesh", &["progress", "input", "geometry"]),
    ("structure", &["progress", "input", "geometry", "mesh"]),
    ("aero", &["progress", "input", "geometry"]),
    (
        "effects",
        &[
            "progress",
            "origin",
            "input",
            "geometry",
            "mesh",
            "structure",
            "aero",
        ],
    ),
    (
        "coupling",
        &[
            "progress",
            "input",
            "geometry",
            "mesh",
            "structure",
            "aero",
            "effects",
        ],
    ),
    (
        "observation",
        &[
            "progress",
            "input",
            "geometry",
            "mesh",
            "structure",
            "effects",
            "coupling",
        ],
    ),
    (
        "lift",
        &["progress", "input", "geometry", "aero", "coupling", "observation"],
    ),
    (
        "wing",
        &[
            "progress",
            "origin",
            "input",
            "geometry",
            "mesh",
            "structure",
            "aero",
            "effects",
            "coupling",
            "observation",
            "lift",
        ],
    ),
    ("program", &["origin", "effects"]),
    ("task", &["origin", "program"]),
    (
        "verify",
        &[
            "progress",
            "input",
            "geometry",
            "mesh",
            "structure",
            "aero",
            "effects",
            "coupling",
            "observation",
            "wing",
        ],
    ),
    (
        "study",
        &[
            "progress",
            "origin",
            "input",
            "geometry",
            "mesh",
            "structure",
            "aero",
            "effects",
            "coupling",
            "observation",
            "lift",
        ],
    ),
    (
        "explore",
        &[
            "progress",
            "input",
            "geometry",
            "mesh",
            "aero",
            "effects",
            "coupling",
            "observation",
            "lift",
            "wing",
            "study",
        ],
    ),
    ("synthesize", &["progress", "input", "effects", "study"]),
    (
        "compare",
        &[
            "progress",
            "origin",
            "input",
            "lift",
            "observation",
            "wing",
            "study",
            "program",
        ],
    ),
    (
        "solve",
        &[
            "progress",
            "input",
            "coupling",
            "observation",
            "wing",
            "study",
            "compare",
        ],
    ),
    (
        "sweep",
        &[
            "progress",
            "origin",
            "task",
            "input",
            "coupling",
            "observation",
            "wing",
            "study",
            "compare",
            "program",
        ],
    ),
    (
        "diagnose",
        &[
            "progress",
            "origin",
            "input",
            "effects",
            "coupling",
            "observation",
            "study",
            "compare",
            "program",
        ],
    ),
    (
        "explain",
        &["progress", "origin", "input", "study", "diagnose", "program"],
    ),
    ("plot", &[]),
    ("page", &["plot"]),
    (
        "add",
        &[
            "progress", "origin", "input", "effects", "wing", "study", "compare", "page", "program",
        ],
    ),
    (
        "blind",
        &["progress", "input", "effects", "study", "synthesize", "diagnose"],
    ),
    (
        "export",
        &[
            "progress",
            "origin",
            "task",
            "input",
            "geometry",
            "mesh",
            "structure",
            "aero",
            "effects",
            "coupling",
            "observation",
            "lift",
            "wing",
            "verify",
            "study",
            "explore",
            "synthesize",
            "compare",
            "solve",
            "sweep",
            "diagnose",
            "explain",
            "plot",
            "page",
            "add",
            "blind",
            "program",
        ],
    ),
    (
        "live",
        &[
            "progress",
            "input",
            "lift",
            "observation",
            "effects",
            "wing",
            "study",
            "compare",
            "diagnose",
            "page",
            "add",
            "export",
        ],
    ),
    (
        "cli",
        &[
            "progress",
            "origin",
            "task",
            "input",
            "geometry",
            "mesh",
            "structure",
            "aero",
            "effects",
            "coupling",
            "observation",
            "lift",
            "wing",
            "verify",
            "study",
            "explore",
            "synthesize",
            "compare",
            "solve",
            "sweep",
            "diagnose",
            "explain",
            "plot",
            "page",
            "add",
            "blind",
            "export",
            "live",
            "program",
        ],
    ),
];

/// Files of the `effects` room that are not effects.
const NOT_EFFECTS: &[&str] = &[
    "mod", "bind", "effect", "error", "card", "seam", "custom", "library",
];

/// The sources of all crates, each with its path in its crate: names of rooms are those of all.
fn sources() -> Vec<(PathBuf, String)> {
    CRATES.iter().flat_map(|folder| sources_of(folder)).collect()
}

fn sources_of(folder: &str) -> Vec<(PathBuf, String)> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join(folder);
    let mut folders = vec![root.clone()];
    let mut found = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("readable folder") {
            let path = entry.expect("entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|extension| extension == "rs") {
                let source = fs::read_to_string(&path).expect("UTF-8 source");
                found.push((path.strip_prefix(&root).expect("below src").to_path_buf(), source));
            }
        }
    }
    found.sort();
    found
}

#[test]
fn the_house_is_in_order() {
    let mut report = Vec::new();
    for folder in CRATES {
        let sources = sources_of(folder);
        for (path, source) in &sources {
            let mut found = faults(path, source);
            if !is_named(path, &sources) {
                found.push(Fault::Orphan);
            }
            report.extend(
                found
                    .iter()
                    .map(|fault| format!("{folder}/{}: {fault}", path.display())),
            );
        }
    }
    assert!(report.is_empty(), "\n{}", report.join("\n"));
}

#[test]
fn no_files_of_a_room_use_each_other() {
    let found: Vec<_> = CRATES
        .iter()
        .flat_map(|folder| circles(&sources_of(folder)))
        .collect();
    assert!(
        found.is_empty(),
        "files that use each other, straight or around: {found:#?}"
    );
}

#[test]
fn every_room_of_the_plan_exists() {
    let rooms: Vec<String> = sources().iter().filter_map(|(path, _)| room_of(path)).collect();
    for (room, _) in ROOMS {
        assert!(
            rooms.iter().any(|found| found == room),
            "room '{room}' is in no crate"
        );
    }
}

#[test]
fn every_effect_stands_in_all() {
    let sources = sources();
    let in_room = |path: &Path| path.parent() == Some(Path::new("effects"));
    let stems: Vec<&str> = sources
        .iter()
        .filter(|(path, _)| in_room(path))
        .filter_map(|(path, _)| path.file_stem()?.to_str())
        .filter(|stem| !NOT_EFFECTS.contains(stem))
        .collect();
    let module = sources
        .iter()
        .find(|(path, _)| path == Path::new("effects/mod.rs"));
    let found = effects_not_listed(&stems, &module.expect("effects/mod.rs").1);
    assert!(found.is_empty(), "{found:?}");
}

#[test]
fn the_plan_itself_flows_one_way() {
    for (index, (room, allowed)) in ROOMS.iter().enumerate() {
        for target in *allowed {
            let place = ROOMS.iter().position(|(name, _)| name == target);
            assert!(
                place.is_some_and(|place| place < index),
                "'{room}' imports '{target}'"
            );
        }
    }
    let may = |room: &str, target: &str| {
        let (_, allowed) = ROOMS.iter().find(|(name, _)| *name == room).expect("a room");
        allowed.contains(&target)
    };
    assert!(!may("aero", "structure") && !may("structure", "aero") && !may("aero", "mesh"));
}
