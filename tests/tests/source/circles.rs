//! Tests that the source files of a crate have no circular dependencies. Files with a circular dependency can only be
//! understood together. Code that two files need belongs in a separate file that uses neither of them.
//!
//! Test modules inside a file do not count. Uses of names from the `mod.rs` of an enclosing folder do not count either,
//! because a folder and its `mod.rs` form one unit. A name that a folder re-exports (`pub use`) is traced to the file
//! that defines it.

use dashpot_tests::library::root;
use std::collections::{BTreeMap, BTreeSet};
use std::path::{Path, PathBuf};
use syn::visit::{self, Visit};

/// Path of a module or an item in Rust code, from the crate's root, as its segments.
type Names = Vec<String>;

/// Names that one file of a crate uses, re-exports, or defines as macros.
#[derive(Default)]
struct Room {
    file: PathBuf,
    /// Paths that the file uses.
    uses: BTreeSet<Names>,
    /// Re-exported names and their origins.
    hands_on: BTreeMap<String, Names>,
    /// Modules that are re-exported whole.
    hands_on_all: Vec<Names>,
    /// Macros that the file defines for the crate.
    macros: BTreeSet<String>,
}

/// Visitor of a syntax tree that collects the names of a file whose module path is `here`.
struct Reader<'a> {
    here: &'a [String],
    room: Room,
}

fn is_of_tests(attributes: &[syn::Attribute]) -> bool {
    let is_test = |a: &syn::Attribute| a.meta.require_list().is_ok_and(|list| list.tokens.to_string() == "test");
    attributes.iter().any(|a| a.path().is_ident("cfg") && is_test(a) || a.path().is_ident("test"))
}

impl Reader<'_> {
    /// Resolves a path that the file uses to a path from the crate's root. A path of another crate becomes a path below
    /// the file's module. Returns `None` for an empty path.
    fn whole(&self, names: &[String]) -> Option<Names> {
        let mut at = self.here.to_vec();
        let mut rest = names;
        match rest.first()?.as_str() {
            "crate" => {
                at.clear();
                rest = &rest[1..];
            }
            "self" => rest = &rest[1..],
            "super" => {
                while rest.first().is_some_and(|n| n == "super") {
                    at.pop();
                    rest = &rest[1..];
                }
            }
            _ => {}
        }
        at.extend(rest.iter().cloned());
        Some(at)
    }

    fn tree(&mut self, tree: &syn::UseTree, before: &[String], public: bool) {
        let with = |name: &syn::Ident| [before, &[name.to_string()]].concat();
        match tree {
            syn::UseTree::Path(path) => self.tree(&path.tree, &with(&path.ident), public),
            syn::UseTree::Name(name) if name.ident == "self" => self.used(before, None, public),
            syn::UseTree::Name(name) => self.used(&with(&name.ident), Some(name.ident.to_string()), public),
            syn::UseTree::Rename(name) => self.used(&with(&name.ident), Some(name.rename.to_string()), public),
            syn::UseTree::Glob(_) => {
                if let Some(names) = self.whole(before) {
                    if public {
                        self.room.hands_on_all.push(names);
                    } else {
                        self.room.uses.insert(names);
                    }
                }
            }
            syn::UseTree::Group(group) => group.items.iter().for_each(|tree| self.tree(tree, before, public)),
        }
    }

    fn used(&mut self, names: &[String], as_name: Option<String>, public: bool) {
        let Some(whole) = self.whole(names) else { return };
        match as_name {
            Some(name) if public => drop(self.room.hands_on.insert(name, whole)),
            _ => drop(self.room.uses.insert(whole)),
        }
    }
}

impl<'ast> Visit<'ast> for Reader<'_> {
    fn visit_item(&mut self, item: &'ast syn::Item) {
        let attributes = match item {
            syn::Item::Mod(item) => &item.attrs,
            syn::Item::Fn(item) => &item.attrs,
            syn::Item::Use(item) => &item.attrs,
            syn::Item::Impl(item) => &item.attrs,
            _ => return visit::visit_item(self, item),
        };
        if !is_of_tests(attributes) {
            visit::visit_item(self, item);
        }
    }

    fn visit_item_use(&mut self, item: &'ast syn::ItemUse) {
        self.tree(&item.tree, &[], !matches!(item.vis, syn::Visibility::Inherited));
    }

    fn visit_item_macro(&mut self, item: &'ast syn::ItemMacro) {
        if let Some(name) = &item.ident {
            self.room.macros.insert(name.to_string());
        }
    }

    fn visit_path(&mut self, path: &'ast syn::Path) {
        let names: Names = path.segments.iter().map(|s| s.ident.to_string()).collect();
        if names.len() > 1 || names.first().is_some_and(|n| n == "crate") {
            self.used(&names, None, false);
        }
        visit::visit_path(self, path);
    }
}

/// Reads all files of a crate. The keys are the module paths of the files.
fn rooms(folder: &Path) -> BTreeMap<Names, Room> {
    fn collect(folder: &Path, at: &[String], rooms: &mut BTreeMap<Names, Room>) {
        let mut entries: Vec<PathBuf> = std::fs::read_dir(folder).unwrap().map(|e| e.unwrap().path()).collect();
        entries.sort();
        for path in entries {
            let name = path.file_stem().unwrap().to_str().unwrap().to_owned();
            if path.is_dir() {
                collect(&path, &[at, &[name]].concat(), rooms);
            } else if path.extension().is_some_and(|e| e == "rs") {
                let here = match name.as_str() {
                    "lib" | "main" | "mod" => at.to_vec(),
                    _ => [at, &[name]].concat(),
                };
                let text = std::fs::read_to_string(&path).unwrap();
                let file = syn::parse_file(&text).unwrap_or_else(|error| panic!("{}: {error}", path.display()));
                let mut reader = Reader { here: &here, room: Room { file: path, ..Room::default() } };
                reader.visit_file(&file);
                let room = reader.room;
                // If a crate has both `lib.rs` and `main.rs`, the library takes precedence.
                rooms.entry(here).or_insert(room);
            }
        }
    }
    let mut found = BTreeMap::new();
    collect(folder, &[], &mut found);
    found
}

/// Finds the file that defines a path: the file of the deepest module on the path, or the origin of a re-export.
/// Follows at most `hops` re-exports. Returns `None` for a name of another crate.
fn made_in<'a>(rooms: &'a BTreeMap<Names, Room>, names: &[String], hops: usize) -> Option<&'a Names> {
    let depth = (0..=names.len()).rev().find(|n| rooms.contains_key(&names[..*n]))?;
    let (place, room) = rooms.get_key_value(&names[..depth])?;
    let Some(next) = names.get(depth).filter(|_| hops > 0) else { return Some(place) };
    if let Some(from) = room.hands_on.get(next) {
        let from = [from, &names[depth + 1..]].concat();
        return made_in(rooms, &from, hops - 1).or(Some(place));
    }
    for all in &room.hands_on_all {
        let from = [all, &names[depth..]].concat();
        if let Some(there) = made_in(rooms, &from, hops - 1).filter(|there| *there != all) {
            return Some(there);
        }
    }
    if depth == 0 {
        // The path begins with a macro of the crate, or with the name of another crate.
        return rooms.iter().find(|(_, room)| room.macros.contains(next)).map(|(place, _)| place);
    }
    Some(place)
}

/// Finds the sets of files whose dependencies form a circle.
fn circles(rooms: &BTreeMap<Names, Room>) -> Vec<BTreeSet<Names>> {
    let arrows: BTreeMap<&Names, BTreeSet<&Names>> = rooms
        .iter()
        .map(|(here, room)| {
            let to = room.uses.iter().filter_map(|names| made_in(rooms, names, 8));
            (here, to.filter(|to| !here.starts_with(to)).collect())
        })
        .collect();
    let reach = |from: &Names| {
        let (mut seen, mut next) = (BTreeSet::new(), vec![from.clone()]);
        while let Some(at) = next.pop() {
            for to in arrows.get(&at).into_iter().flatten() {
                if seen.insert((*to).clone()) {
                    next.push((*to).clone());
                }
            }
        }
        seen
    };
    let reached: BTreeMap<&Names, BTreeSet<Names>> = rooms.keys().map(|name| (name, reach(name))).collect();
    let mut found: Vec<BTreeSet<Names>> = Vec::new();
    for (name, all) in &reached {
        if all.contains(*name) && !found.iter().any(|circle| circle.contains(*name)) {
            found.push(all.iter().filter(|other| reached[other].contains(*name)).cloned().collect());
        }
    }
    found
}

/// Lists the source folders (`src/<crate>/src`) of all crates.
fn crates() -> Vec<PathBuf> {
    let mut crates: Vec<_> = std::fs::read_dir(root().join("src")).unwrap().map(|e| e.unwrap().path()).collect();
    crates.sort();
    crates.iter().map(|path| path.join("src")).filter(|path| path.is_dir()).collect()
}

/// Merges the files of each top-level folder of a crate to one unit, and omits the crate's root file.
fn folders(rooms: &BTreeMap<Names, Room>) -> BTreeMap<Names, Room> {
    let mut found: BTreeMap<Names, Room> = BTreeMap::new();
    for (name, room) in rooms.iter().filter(|(name, _)| !name.is_empty()) {
        let made = room.uses.iter().filter_map(|names| made_in(rooms, names, 8));
        let uses = made.filter(|to| !to.is_empty()).map(|to| to[..1].to_vec());
        let whole =
            found.entry(name[..1].to_vec()).or_insert_with(|| Room { file: room.file.clone(), ..Room::default() });
        whole.uses.extend(uses);
    }
    found
}

/// Crates with circular dependencies between folders. The test also fails if a listed crate no longer has circular
/// dependencies.
const WITH_CIRCLES: &[&str] = &["core", "identification", "report", "rig"];

#[test]
fn no_two_folders_of_a_crate_use_each_other() {
    let mut told = String::new();
    for folder in crates() {
        let name = folder.parent().unwrap().file_name().unwrap().to_str().unwrap().to_owned();
        let circles = circles(&folders(&rooms(&folder)));
        if WITH_CIRCLES.contains(&name.as_str()) {
            assert!(!circles.is_empty(), "{name} has no circle any more");
        } else {
            for circle in circles {
                let names: Vec<String> = circle.iter().map(|name| name.join("::")).collect();
                told += &format!("{name}: in a circle: {}\n", names.join(", "));
            }
        }
    }
    assert!(told.is_empty(), "{told}");
}

#[test]
fn no_two_files_of_a_crate_use_each_other() {
    let mut told = String::new();
    for folder in crates() {
        let rooms = rooms(&folder);
        for circle in circles(&rooms) {
            told += &format!("{}: in a circle:\n", folder.strip_prefix(root()).unwrap().display());
            for name in &circle {
                let room = &rooms[name];
                let to: BTreeSet<String> = room
                    .uses
                    .iter()
                    .filter(|names| {
                        made_in(&rooms, names, 8).is_some_and(|to| !name.starts_with(to) && circle.contains(to))
                    })
                    .map(|names| names.join("::"))
                    .collect();
                let file = room.file.strip_prefix(&folder).unwrap().display();
                told += &format!("  {file} uses {}\n", to.into_iter().collect::<Vec<_>>().join(", "));
            }
        }
    }
    assert!(told.is_empty(), "{told}");
}

#[test]
fn a_circle_is_found_where_there_is_one() {
    let folder = tempfile::tempdir().unwrap();
    let write = |name: &str, text: &str| std::fs::write(folder.path().join(name), text).unwrap();
    write("lib.rs", "mod a; mod b; mod c; pub use b::Thing;");
    write("a.rs", "use crate::Thing; pub fn of(_: &Thing) {}");
    write("b.rs", "pub struct Thing; #[cfg(test)] mod tests { use crate::a::of; }");
    write("c.rs", "use crate::a::of; pub fn c() { crate::b::other() }");
    assert!(circles(&rooms(folder.path())).is_empty());
    write("b.rs", "pub struct Thing; pub fn other() { super::c::c() }");
    let found = circles(&rooms(folder.path()));
    let names = ["a", "b", "c"].map(|name| vec![name.to_owned()]);
    assert_eq!(found, [BTreeSet::from(names)]);
}
