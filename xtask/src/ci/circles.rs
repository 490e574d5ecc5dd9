//! Files of a crate that import each other in a circle: none can be read, moved or changed without the others.

use super::listed::listed;
use super::{Outcome, finish};
use crate::error::Failure;
use std::collections::{BTreeMap, BTreeSet};
use tribodyn_paper::{PaperError, files};

/// A module: its crate's folder, and its path in the crate.
type Module = (String, Vec<String>);
/// For each file those that it imports from.
type Imports = BTreeMap<String, BTreeSet<String>>;

pub fn check() -> Result<Outcome, Failure> {
    let mut sources = BTreeMap::new();
    for name in listed()?.into_iter().filter(|name| name.ends_with(".rs") && name.contains("/src/")) {
        let path = files::root().join(&name);
        if path.exists() {
            let text = std::fs::read_to_string(&path).map_err(|source| PaperError::Read { path, source })?;
            sources.insert(name, text);
        }
    }
    let findings = circles(&imports(&sources))
        .into_iter()
        .map(|circle| format!("{} files import each other in a circle: {}", circle.len(), circle.join(", ")));
    finish("circles", findings.collect())
}

/// The module that a file holds.
fn module(name: &str) -> Option<Module> {
    let (folder, path) = name.strip_suffix(".rs")?.split_once("/src/")?;
    let mut parts: Vec<String> = path.split('/').map(str::to_owned).collect();
    if parts.last().is_some_and(|last| ["lib", "main", "mod"].contains(&last.as_str())) {
        parts.pop();
    }
    Some((folder.to_owned(), parts))
}

/// Imports by `use crate::…` and `use super::…`, tests inside a file left out.
fn imports(sources: &BTreeMap<String, String>) -> Imports {
    let by_module: BTreeMap<Module, &String> = sources.keys().filter_map(|name| Some((module(name)?, name))).collect();
    let mut found = Imports::new();
    for (name, text) in sources {
        let Some((folder, own)) = module(name) else { continue };
        let text = text.split("#[cfg(test)]\nmod tests {").next().unwrap_or_default();
        let targets = used(text).into_iter().filter_map(|path| {
            let mut parts = path.split("::").map(str::to_owned).peekable();
            let mut place = own.clone();
            if parts.next_if(|part| part == "crate").is_some() {
                place.clear();
            }
            while parts.next_if(|part| part == "super").is_some() {
                place.pop();
            }
            place.extend(parts);
            // The path ends with items; the longest part of it that is a file is the module.
            (0..=place.len()).rev().find_map(|length| by_module.get(&(folder.clone(), place[..length].to_vec())))
        });
        let others = targets.filter(|target| *target != &name).map(|target| (*target).clone());
        found.insert(name.clone(), others.collect());
    }
    found
}

/// Paths of the `use` items that begin with `crate` or `super`, braces written out.
fn used(text: &str) -> Vec<String> {
    let mut paths = Vec::new();
    let mut rest = text;
    while let Some(at) = rest.find("use ") {
        let line = rest[..at].rsplit('\n').next().unwrap_or_default().trim_start();
        rest = &rest[at + 4..];
        let item = rest.split(';').next().unwrap_or_default();
        let begins = line.is_empty() || line.starts_with("pub");
        if begins && (item.starts_with("crate") || item.starts_with("super")) {
            let flat: String = item.split_whitespace().collect::<Vec<_>>().join(" ");
            written_out("", &flat, &mut paths);
        }
    }
    paths
}

fn written_out(before: &str, item: &str, paths: &mut Vec<String>) {
    let Some((start, inside)) = item.split_once('{') else {
        let name = item.split(" as ").next().unwrap_or_default().trim();
        return paths.push(format!("{before}{name}"));
    };
    let inside = inside.rsplit_once('}').map_or(inside, |(inside, _)| inside);
    let before = format!("{before}{}", start.trim());
    let (mut depth, mut from) = (0usize, 0);
    let ends = inside.char_indices().chain([(inside.len(), ',')]);
    for (at, letter) in ends {
        match letter {
            '{' => depth += 1,
            '}' => depth -= 1,
            ',' if depth == 0 => {
                let part = inside[from..at].trim();
                if !part.is_empty() {
                    written_out(&before, part, paths);
                }
                from = (at + 1).min(inside.len());
            }
            _ => {}
        }
    }
}

/// Groups of files each of which reaches all others of its group.
fn circles(imports: &Imports) -> Vec<Vec<String>> {
    let reached: BTreeMap<&String, BTreeSet<&String>> =
        imports.keys().map(|file| (file, reach(imports, file))).collect();
    let mut left: BTreeSet<&String> = imports.keys().collect();
    let mut found = Vec::new();
    while let Some(file) = left.pop_first() {
        let mutual = |other: &&String| reached[file].contains(*other) && reached[*other].contains(file);
        let group: Vec<&String> = imports.keys().filter(mutual).collect();
        if group.len() > 1 {
            left.retain(|file| !group.contains(file));
            found.push(group.into_iter().cloned().collect());
        }
    }
    found
}

fn reach<'a>(imports: &'a Imports, from: &String) -> BTreeSet<&'a String> {
    let mut seen = BTreeSet::new();
    let mut open: Vec<&String> = imports[from].iter().collect();
    while let Some(file) = open.pop() {
        if seen.insert(file) {
            open.extend(imports.get(file).into_iter().flatten());
        }
    }
    seen
}

#[cfg(test)]
mod tests {
    use super::*;

    fn house(rooms: &[(&str, &str)]) -> Vec<Vec<String>> {
        let sources = rooms.iter().map(|(name, text)| (format!("crates/a/src/{name}"), (*text).to_owned()));
        circles(&imports(&sources.collect()))
    }

    #[test]
    fn identity_a_circle_is_found_through_braces_and_folders() {
        let rooms = [
            ("lib.rs", "mod b;\nmod c;\n"),
            ("b.rs", "use crate::{\n    c::{self, d::Thing},\n    other::Name as Else,\n};\n"),
            ("c/mod.rs", "pub use super::e::E;\n"),
            ("c/d.rs", "use super::super::e::E;\n"),
            ("e.rs", "use crate::b::B;\n"),
        ];
        let found = house(&rooms);
        assert_eq!(found, [["b.rs", "c/d.rs", "c/mod.rs", "e.rs"].map(|name| format!("crates/a/src/{name}")).to_vec()]);
    }

    #[test]
    fn limit_a_tree_has_none_and_tests_do_not_count() {
        let rooms = [
            ("b.rs", "use crate::c::C;\n// use crate::b::B;\n"),
            ("c.rs", "fn f() {}\n#[cfg(test)]\nmod tests {\n    use crate::b::B;\n}\n"),
        ];
        assert!(house(&rooms).is_empty());
    }
}
