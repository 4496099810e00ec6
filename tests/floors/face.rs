//! Counts the names in the crate's root, and finds public items whose types cannot be named. Never
//! knows floors.

use crate::{ROOF, files, source::tokens};

/// Most names in the crate's root: items, modules and macros, with hidden ones and those behind a
/// feature.
const MOST_NAMES: usize = 30;

#[test]
fn root_of_the_crate_has_few_names() {
    let mut names = Vec::new();
    for file in files() {
        if file.module == [ROOF] {
            names.extend(public_names(&file.text));
        }
        names.extend(exported_macros(&file.text));
    }
    names.sort();
    println!("{} names: {}", names.len(), names.join(", "));
    assert!(names.len() <= MOST_NAMES, "{}: {names:?}", names.len());
    for known in ["Scene", "display", "scene"] {
        assert!(names.iter().any(|name| name == known), "{known}");
    }
}

#[test]
fn no_public_item_has_a_private_type() {
    let found = files().into_iter().filter(|file| {
        let lints = ["private_interfaces", "private_bounds"];
        words(&file.text).iter().any(|it| lints.contains(it))
    });
    let found: Vec<_> = found.map(|file| file.name).collect();
    assert!(found.is_empty(), "{found:?}");
}

fn words(source: &str) -> Vec<&str> {
    tokens(source).into_iter().map(|(_, token)| token).collect()
}

/// Returns the names that a file's own level makes public: its `pub use` and all other `pub` items.
fn public_names(source: &str) -> Vec<String> {
    let tokens = words(source);
    let (mut names, mut depth) = (Vec::new(), 0);
    for (at, token) in tokens.iter().enumerate() {
        match *token {
            "{" => depth += 1,
            "}" => depth -= 1,
            "pub" if depth == 0 => match &tokens[at + 1..] {
                ["use", path @ ..] => names.extend(used_names(path)),
                ["(", ..] => {}
                [keyword, name, ..] => {
                    let is_qualifier =
                        ["const", "unsafe", "async"].contains(keyword) && *name == "fn";
                    let name = if is_qualifier { tokens[at + 3] } else { name };
                    names.push(name.to_owned());
                }
                _ => {}
            },
            _ => {}
        }
    }
    names
}

/// Returns the last names of the paths of a `use`, up to its semicolon.
fn used_names(path: &[&str]) -> Vec<String> {
    let end = path.iter().position(|token| *token == ";");
    let path = &path[..end.unwrap_or(path.len())];
    let is_last = |at: &usize| {
        let next = path.get(at + 1);
        !["{", "}", ",", "::", "as"].contains(&path[*at]) && !matches!(next, Some(&("::" | "as")))
    };
    let last = (0..path.len()).filter(is_last);
    last.map(|at| path[at].to_owned()).collect()
}

/// Returns the names of the macros that a file puts into the crate's root.
fn exported_macros(source: &str) -> Vec<String> {
    let tokens = words(source);
    let marks = (0..tokens.len()).filter(|at| tokens[*at] == "macro_export");
    let declared = marks.filter_map(|at| {
        let mut after = tokens[at..].windows(3);
        after.find(|it| it[..2] == ["macro_rules", "!"])
    });
    declared.map(|it| it[2].to_owned()).collect()
}

mod the_rules {
    use super::*;

    #[test]
    fn every_public_name_of_the_root_is_counted() {
        let source = "mod a; pub(crate) mod b; pub mod c; pub use a::{d, e::F as G, h::{i, J}};
            #[doc(hidden)] pub mod k { pub use crate::l; } pub use m; pub const fn n() {}
            #[cfg(feature = \"o\")] pub struct P; pub const Q: u8 = 1;";
        let expected = ["c", "d", "G", "i", "J", "k", "m", "n", "P", "Q"];
        assert_eq!(public_names(source), expected);
    }

    #[test]
    fn only_exported_macros_are_counted() {
        let source = "macro_rules! a { () => {} } #[doc(hidden)] #[macro_export] macro_rules! b { () => {} }";
        assert_eq!(exported_macros(source), ["b"]);
    }
}
