//! Imports run downwards: the order of the folders, and no cycle between files; and the documents name files that exist.
//!
//! Reads the `use` declarations of every file in `src`, except in tests. A name that a module only re-exports counts as an import
//! from the file that defines it.

use std::collections::{BTreeMap, BTreeSet};
use std::fs;
use std::path::{Path, PathBuf};
use syn::{Attribute, Item, UseTree, Visibility};

/// Folders and files right below `src`, from the bottom up: each may import from those before it.
const ORDER: [&str; 19] = [
    "bits",
    "text",
    "expression",
    "scene",
    "illumination",
    "geometry",
    "render",
    "picture",
    "animation",
    "figure",
    "analysis",
    "export",
    "link",
    "document",
    "lesson",
    "jobs",
    "class",
    "app",
    "cli",
];

/// Folders of the window, from the bottom up. The system and the page do the same for the window, each on its platform.
const ROOMS: [&str; 12] = [
    "widgets", "system", "page", "session", "engine", "controls", "course", "stored", "views",
    "picture", "shell", "start",
];

type ModulePath = Vec<String>;

struct Import {
    /// The local name in this file; empty for a glob.
    name: String,
    path: ModulePath,
    /// True if the import is a re-export.
    re_export: bool,
}

#[test]
fn no_file_imports_from_a_folder_above_its_own() {
    let modules = modules();
    let upwards = upwards(&edges(&modules), &[], &ORDER);
    let tops: BTreeSet<&str> = modules
        .keys()
        .filter_map(|path| path.first())
        .map(String::as_str)
        .collect();
    assert_eq!(
        tops,
        ORDER.into_iter().collect(),
        "the order above names every folder"
    );
    assert!(
        upwards.is_empty(),
        "{} imports run upwards:\n{}",
        upwards.len(),
        lines(&upwards)
    );
}

#[test]
fn no_file_of_the_window_imports_from_a_room_above_its_own() {
    let modules = modules();
    let upwards = upwards(&edges(&modules), &["app"], &ROOMS);
    let rooms: BTreeSet<&str> = modules
        .keys()
        .filter(|path| path[0] == "app")
        .filter_map(|path| path.get(1))
        .map(String::as_str)
        .collect();
    assert_eq!(
        rooms,
        ROOMS.into_iter().collect(),
        "the order above names every room"
    );
    assert!(
        upwards.is_empty(),
        "{} imports run upwards:\n{}",
        upwards.len(),
        lines(&upwards)
    );
}

/// Returns the imports from a folder of `order` into one after it; both are right below `within`.
fn upwards(
    edges: &BTreeMap<ModulePath, BTreeSet<ModulePath>>,
    within: &[&str],
    order: &[&str],
) -> BTreeSet<String> {
    let rank = |path: &ModulePath| {
        let mut inner = path.iter().map(String::as_str);
        let inside = inner.clone().take(within.len()).eq(within.iter().copied());
        let folder = inner.nth(within.len()).filter(|_| inside);
        folder.and_then(|folder| order.iter().position(|other| *other == folder))
    };
    let mut upwards = BTreeSet::new();
    for (from, imports) in edges {
        for to in imports {
            if let (Some(own), Some(other)) = (rank(from), rank(to))
                && other > own
            {
                upwards.insert(format!("{} imports {}", from.join("::"), to.join("::")));
            }
        }
    }
    upwards
}

#[test]
fn files_do_not_import_each_other_in_a_circle() {
    let edges = edges(&modules());
    let circles: BTreeSet<String> = circles(&edges)
        .into_iter()
        .map(|files| {
            files
                .iter()
                .map(|path| path.join("::"))
                .collect::<Vec<_>>()
                .join(" → ")
        })
        .collect();
    assert!(
        circles.is_empty(),
        "{} circles:\n{}",
        circles.len(),
        lines(&circles)
    );
}

fn lines(items: &BTreeSet<String>) -> String {
    items.iter().map(|item| format!("  {item}\n")).collect()
}

/// Returns the imports of every module that has a file of its own, by the module's path from the crate's root.
fn modules() -> BTreeMap<ModulePath, Vec<Import>> {
    let root = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let mut modules = BTreeMap::new();
    for file in sources("src") {
        let relative = file
            .strip_prefix(&root)
            .expect("below src")
            .with_extension("");
        let path: ModulePath = relative
            .iter()
            .map(|part| part.to_string_lossy().into_owned())
            .collect();
        if path != ["lib"] && path != ["main"] {
            let source = fs::read_to_string(&file).expect("a source");
            let source = syn::parse_file(&source)
                .unwrap_or_else(|error| panic!("{}: {error}", file.display()));
            let mut imports = Vec::new();
            collect(&source.items, &path, &mut imports);
            modules.insert(path, imports);
        }
    }
    modules
}

/// Lists the files of Rust in a folder of the project.
fn sources(folder: &str) -> Vec<PathBuf> {
    let mut folders = vec![Path::new(env!("CARGO_MANIFEST_DIR")).join(folder)];
    let mut sources = Vec::new();
    while let Some(folder) = folders.pop() {
        for entry in fs::read_dir(&folder).expect("a folder of sources") {
            let path = entry.expect("an entry").path();
            if path.is_dir() {
                folders.push(path);
            } else if path.extension().is_some_and(|ending| ending == "rs") {
                sources.push(path);
            }
        }
    }
    sources
}

#[test]
fn documents_name_files_that_exist() {
    let sources = [sources("src"), sources("tests")].concat();
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("docs");
    let mut count = 0;
    for entry in fs::read_dir(folder).expect("the documents") {
        let document = entry.expect("an entry").path();
        if document.extension().is_none_or(|ending| ending != "md") {
            continue;
        }
        let text = fs::read_to_string(&document).expect("a document");
        let words = text.split('`').skip(1).step_by(2);
        for name in
            words.filter(|words| words.ends_with(".rs") && !words.contains(char::is_whitespace))
        {
            let exists = sources.iter().any(|source| source.ends_with(name));
            assert!(exists, "{}: {name}", document.display());
            count += 1;
        }
    }
    assert!(count > 100, "{count} names of files");
}

/// Collects the imports of these items and of the modules within them, except tests.
fn collect(items: &[Item], module: &ModulePath, imports: &mut Vec<Import>) {
    for item in items {
        match item {
            Item::Use(item) if !is_test(&item.attrs) => {
                let re_export = !matches!(item.vis, Visibility::Inherited);
                flatten(&item.tree, Vec::new(), &mut |name, path| {
                    imports.push(Import {
                        name,
                        path: absolute(path, module),
                        re_export,
                    });
                });
            }
            Item::Mod(inner) if !is_test(&inner.attrs) => {
                let content = inner.content.as_ref().map_or(&[][..], |(_, items)| items);
                let path = [module.as_slice(), &[inner.ident.to_string()]].concat();
                collect(content, &path, imports);
            }
            _ => {}
        }
    }
}

fn is_test(attributes: &[Attribute]) -> bool {
    attributes.iter().any(|attribute| {
        attribute.path().is_ident("cfg")
            && attribute
                .parse_args::<syn::Path>()
                .is_ok_and(|path| path.is_ident("test"))
    })
}

/// Calls `found` with the name and the path of each leaf of a `use` tree; a glob has no name.
fn flatten(tree: &UseTree, mut prefix: Vec<String>, found: &mut impl FnMut(String, Vec<String>)) {
    match tree {
        UseTree::Path(path) => {
            prefix.push(path.ident.to_string());
            flatten(&path.tree, prefix, found);
        }
        UseTree::Group(group) => group
            .items
            .iter()
            .for_each(|tree| flatten(tree, prefix.clone(), found)),
        UseTree::Glob(_) => found(String::new(), prefix),
        UseTree::Name(name) => {
            let name = name.ident.to_string();
            let leaf = if name == "self" {
                prefix.last().cloned().unwrap_or_default()
            } else {
                name.clone()
            };
            if name != "self" {
                prefix.push(name);
            }
            found(leaf, prefix);
        }
        UseTree::Rename(rename) => {
            prefix.push(rename.ident.to_string());
            found(rename.rename.to_string(), prefix);
        }
    }
}

/// Returns the path from the crate's root. A path into another crate comes out as that of a child module, which does not exist.
fn absolute(path: Vec<String>, module: &ModulePath) -> ModulePath {
    let ups = path.iter().take_while(|part| *part == "super").count();
    match path.first().map(String::as_str) {
        Some("crate" | "shading_lab") => path[1..].to_vec(),
        Some("self") => [module, &path[1..]].concat(),
        _ => [&module[..module.len() - ups], &path[ups..]].concat(),
    }
}

/// Returns the files that each file imports from.
fn edges(
    modules: &BTreeMap<ModulePath, Vec<Import>>,
) -> BTreeMap<ModulePath, BTreeSet<ModulePath>> {
    let targets = |path: &ModulePath, imports: &[Import]| {
        let files = imports
            .iter()
            .filter(|import| !import.re_export)
            .filter_map(|import| defining_file(&import.path, modules, 0));
        files.filter(|file| file != path).collect()
    };
    modules
        .iter()
        .map(|(path, imports)| (path.clone(), targets(path, imports)))
        .collect()
}

/// Returns the file that defines the target of a path, through re-exports.
fn defining_file(
    path: &[String],
    modules: &BTreeMap<ModulePath, Vec<Import>>,
    depth: u32,
) -> Option<ModulePath> {
    assert!(
        depth < 20,
        "the re-exports of {} run in a circle",
        path.join("::")
    );
    let known = (1..=path.len())
        .rev()
        .find(|length| modules.contains_key(&path[..*length]))?;
    let (module, rest) = path.split_at(known);
    let Some(name) = rest.first() else {
        return Some(module.to_vec());
    };
    let imports = &modules[module];
    let named = imports
        .iter()
        .find(|import| import.name == *name && import.path != path);
    named
        .and_then(|import| {
            let through = [&import.path, &rest[1..]].concat();
            defining_file(&through, modules, depth + 1)
        })
        .or_else(|| Some(module.to_vec()))
}

/// Returns the import cycles: strongly connected components with more than one member (Tarjan 1972).
fn circles(edges: &BTreeMap<ModulePath, BTreeSet<ModulePath>>) -> Vec<Vec<ModulePath>> {
    let reach = |from: &ModulePath| {
        let (mut seen, mut open) = (BTreeSet::new(), vec![from.clone()]);
        while let Some(path) = open.pop() {
            for next in edges.get(&path).into_iter().flatten() {
                if seen.insert(next.clone()) {
                    open.push(next.clone());
                }
            }
        }
        seen
    };
    let reached: BTreeMap<_, _> = edges.keys().map(|path| (path, reach(path))).collect();
    let mut circles: Vec<Vec<ModulePath>> = Vec::new();
    for (path, own) in &reached {
        if own.contains(*path) && !circles.iter().flatten().any(|known| known == *path) {
            let members = own.iter().filter(|other| reached[*other].contains(*path));
            circles.push(members.cloned().collect());
        }
    }
    circles
}
