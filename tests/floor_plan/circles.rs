//! Circles inside a room: files that use each other, straight or around.
//!
//! A file uses another when a path of it (`super::`, `self::`, `crate::room::`) leads there; what a `mod.rs` hands on with `pub use` is
//! looked up where it stands. Tests inside a file do not count.

use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};

use syn::visit::{self, Visit};
use syn::{Item, ItemMod, ItemUse, UseTree, Visibility};

/// Names from the top of the crate down: `["coupling", "solution"]`.
type Place = Vec<String>;

/// The modules of a crate, and what each hands on.
struct Modules {
    files: BTreeMap<Place, PathBuf>,
    handed_on: BTreeMap<Place, Place>,
}

/// Files of a room that use each other, each circle once, its files in order.
pub fn circles(sources: &[(PathBuf, String)]) -> Vec<Vec<String>> {
    let parsed: Vec<(&Path, Place, syn::File)> = sources
        .iter()
        .map(|(path, source)| {
            let file = syn::parse_file(source).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
            (path.as_path(), place_of(path), file)
        })
        .collect();
    let mut modules = Modules {
        files: parsed
            .iter()
            .map(|(path, place, _)| (place.clone(), path.to_path_buf()))
            .collect(),
        handed_on: BTreeMap::new(),
    };
    for (_, place, file) in &parsed {
        for item in &file.items {
            if let Item::Use(ItemUse {
                vis: Visibility::Public(_) | Visibility::Restricted(_),
                tree,
                ..
            }) = item
            {
                for (name, target) in named(tree, &Place::new()) {
                    let own = [place.as_slice(), &[name]].concat();
                    if let Some(target) = modules.absolute(place, &target) {
                        modules.handed_on.insert(own, target);
                    }
                }
            }
        }
    }
    let mut uses: BTreeMap<&Path, BTreeSet<&Path>> = BTreeMap::new();
    for (path, place, file) in &parsed {
        let mut paths = Paths(Vec::new());
        paths.visit_file(file);
        let targets = paths
            .0
            .iter()
            .filter_map(|found| modules.file(&modules.absolute(place, found)?));
        let same_room =
            |target: &&Path| target != path && target.components().next() == path.components().next();
        uses.insert(path, targets.filter(same_room).collect());
    }
    let mut found = BTreeSet::new();
    for path in uses.keys() {
        let circle: Vec<String> = reached(&uses, path)
            .into_iter()
            .filter(|other| reached(&uses, other).contains(path))
            .map(|other| other.display().to_string())
            .collect();
        if !circle.is_empty() {
            found.insert(circle);
        }
    }
    found.into_iter().collect()
}

/// What a file uses, straight or around; itself only if it lies on a circle.
fn reached<'a>(uses: &BTreeMap<&'a Path, BTreeSet<&'a Path>>, from: &Path) -> BTreeSet<&'a Path> {
    let mut found = BTreeSet::new();
    let mut open: Vec<&Path> = uses.get(from).into_iter().flatten().copied().collect();
    while let Some(next) = open.pop() {
        if found.insert(next) {
            open.extend(uses.get(next).into_iter().flatten().copied());
        }
    }
    found
}

fn place_of(path: &Path) -> Place {
    let names = path.with_extension("");
    let mut place: Place = names
        .iter()
        .map(|name| name.to_string_lossy().into_owned())
        .collect();
    if matches!(place.last().map(String::as_str), Some("mod" | "lib" | "main")) {
        place.pop();
    }
    place
}

/// The paths of a `use`, each with the name that it has here.
fn named(tree: &UseTree, before: &Place) -> Vec<(String, Place)> {
    let with = |name: &syn::Ident| [before.as_slice(), &[name.to_string()]].concat();
    match tree {
        UseTree::Path(path) => named(&path.tree, &with(&path.ident)),
        UseTree::Name(name) if name.ident == "self" => {
            vec![(before.last().cloned().unwrap_or_default(), before.clone())]
        }
        UseTree::Name(name) => vec![(name.ident.to_string(), with(&name.ident))],
        UseTree::Rename(name) => vec![(name.rename.to_string(), with(&name.ident))],
        UseTree::Glob(_) => vec![(String::new(), before.clone())],
        UseTree::Group(group) => group.items.iter().flat_map(|tree| named(tree, before)).collect(),
    }
}

impl Modules {
    /// A path as it stands in the module `at`, from the top of the crate; none for a path out of it.
    fn absolute(&self, at: &Place, path: &Place) -> Option<Place> {
        let mut base = at.clone();
        let mut rest = path.as_slice();
        match rest.first()?.as_str() {
            "crate" => base.clear(),
            "self" => {}
            "super" => {
                while rest.first().is_some_and(|name| name == "super") {
                    base.pop();
                    rest = &rest[1..];
                }
                return Some([base.as_slice(), rest].concat());
            }
            // a module below this one
            name if self
                .files
                .contains_key(&[at.as_slice(), &[name.to_string()]].concat()) =>
            {
                return Some([at.as_slice(), rest].concat());
            }
            _ => return None,
        }
        Some([base.as_slice(), &rest[1..]].concat())
    }

    /// The file in which what stands at a place is written.
    fn file(&self, place: &Place) -> Option<&Path> {
        let mut place = place.clone();
        // what is handed on may be handed on again
        for _ in 0..8 {
            let known = (1..=place.len())
                .rev()
                .find(|&n| self.handed_on.contains_key(&place[..n]));
            let Some(n) = known else { break };
            place = [self.handed_on[&place[..n]].as_slice(), &place[n..]].concat();
        }
        let module = (1..=place.len())
            .rev()
            .find(|&n| self.files.contains_key(&place[..n]))?;
        self.files.get(&place[..module]).map(PathBuf::as_path)
    }
}

/// All paths of a file, but those that it only hands on and those of its tests.
struct Paths(Vec<Place>);

impl<'ast> Visit<'ast> for Paths {
    fn visit_item_use(&mut self, item: &'ast ItemUse) {
        if matches!(item.vis, Visibility::Inherited) {
            self.0
                .extend(named(&item.tree, &Place::new()).into_iter().map(|(_, path)| path));
        }
    }

    fn visit_item_mod(&mut self, item: &'ast ItemMod) {
        if !is_test(&item.attrs) {
            visit::visit_item_mod(self, item);
        }
    }

    // `pub(super)` uses nothing
    fn visit_visibility(&mut self, _: &'ast Visibility) {}

    fn visit_path(&mut self, path: &'ast syn::Path) {
        // a name alone is that of a value, or what a `use` brought
        if path.segments.len() > 1 {
            let names = path.segments.iter().map(|segment| segment.ident.to_string());
            self.0.push(names.collect());
        }
        visit::visit_path(self, path);
    }
}

fn is_test(attributes: &[syn::Attribute]) -> bool {
    attributes.iter().any(|own| {
        own.path().is_ident("cfg")
            && own
                .parse_args::<syn::Path>()
                .is_ok_and(|path| path.is_ident("test"))
    })
}

mod tests {
    use super::*;

    fn found(files: &[(&str, &str)]) -> Vec<Vec<String>> {
        let sources = files
            .iter()
            .map(|(path, text)| (PathBuf::from(path), text.to_string()));
        circles(&sources.collect::<Vec<_>>())
    }

    #[test]
    fn two_files_that_use_each_other_are_found_and_one_way_is_not() {
        let (head, a) = (
            ("aero/mod.rs", "pub mod a;\npub mod b;"),
            ("aero/a.rs", "use super::b::B;\npub struct A(B);"),
        );
        assert_eq!(
            found(&[head, a, ("aero/b.rs", "pub struct B;")]),
            Vec::<Vec<String>>::new()
        );
        let back = ("aero/b.rs", "pub struct B;\nfn back(a: &crate::aero::a::A) {}");
        assert_eq!(found(&[head, a, back]), [["aero/a.rs", "aero/b.rs"]]);
    }

    #[test]
    fn what_is_handed_on_is_looked_up_where_it_stands() {
        let head = ("aero/mod.rs", "pub mod a;\npub mod b;\npub use a::A;");
        let (a, b) = (
            ("aero/a.rs", "use super::b::B;\npub struct A(B);"),
            ("aero/b.rs", "use super::A;\npub struct B;"),
        );
        assert_eq!(found(&[head, a, b]), [["aero/a.rs", "aero/b.rs"]]);
        // to hand on is not to use
        assert_eq!(
            found(&[head, a, ("aero/b.rs", "pub struct B;")]),
            Vec::<Vec<String>>::new()
        );
    }

    #[test]
    fn a_head_that_holds_what_its_files_use_and_uses_them_is_a_circle_and_tests_do_not_count() {
        let head = ("aero/mod.rs", "pub mod a;\npub struct S;\nfn f() { a::g() }");
        assert_eq!(
            found(&[head, ("aero/a.rs", "use super::S;\npub fn g() {}")]),
            [["aero/a.rs", "aero/mod.rs"]]
        );
        let tested = (
            "aero/a.rs",
            "pub fn g() {}\n#[cfg(test)]\nmod tests { use super::super::S; }",
        );
        assert_eq!(found(&[head, tested]), Vec::<Vec<String>>::new());
    }
}
