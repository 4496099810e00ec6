//! Limits the lengths of files. Clippy limits those of functions.

use std::collections::BTreeSet;

use crate::{
    File, assert_none, files,
    length::{length, test_modules},
};

/// Most lines of a file without its tests.
const LONGEST_FILE: usize = 300;

/// Most lines of a file with its tests, or of a file of tests.
const LONGEST_WITH_TESTS: usize = 500;

#[test]
fn no_file_is_too_long() {
    let found = library().into_iter();
    let found = found.map(|file| (file.name, length(&file.text)));
    assert_none(complaints(found, LONGEST_FILE));
}

#[test]
fn no_file_is_too_long_with_its_tests() {
    let found = files()
        .into_iter()
        .map(|file| (file.name, file.text.lines().count()));
    assert_none(complaints(found, LONGEST_WITH_TESTS));
}

/// Returns the library's files that are not only for tests.
fn library() -> Vec<File> {
    let mut files = files();
    let tests: BTreeSet<_> = files.iter().flat_map(declared_for_tests).collect();
    files.retain(|file| (1..=file.module.len()).all(|end| !tests.contains(&file.module[..end])));
    files
}

/// Returns the module paths of the test-only modules that a file declares in files of their own.
fn declared_for_tests(file: &File) -> Vec<Vec<String>> {
    // Modules that `lib.rs` declares are at the top level, not inside a module `lib`.
    let parent = match file.name.as_str() {
        "lib.rs" => &[],
        _ => file.module.as_slice(),
    };
    let names = test_modules(&file.text).into_iter();
    names.map(|name| [parent, &[name]].concat()).collect()
}

/// Returns a message for each file that is longer than `longest`.
fn complaints(found: impl Iterator<Item = (String, usize)>, longest: usize) -> Vec<String> {
    found
        .filter(|(_, lines)| *lines > longest)
        .map(|(name, lines)| format!("{name}: {lines} lines, {longest} at most"))
        .collect()
}

mod the_rules {
    use super::*;

    #[test]
    fn length_above_the_bar_is_found() {
        let found = [("a".to_owned(), 5), ("b".to_owned(), 6)];
        let complaint = "b: 6 lines, 5 at most";
        assert_eq!(complaints(found.into_iter(), 5), [complaint]);
    }

    #[test]
    fn tests_are_not_counted() {
        let source = "//! Words.\n#[cfg(test)]\npub(crate) mod apart;\ntype F = fn(u8);\n#[cfg(test)]\nmod tests {\n    fn test() {}\n}\n";
        assert_eq!(length(source), 4);
        assert_eq!(test_modules(source), ["apart"]);
    }
}
