//! Limits the lengths of files and functions.

use std::collections::BTreeSet;

use crate::{
    File, assert_none, files,
    length::{Lengths, test_modules},
};

/// Most lines of a file without its tests.
const LONGEST_FILE: usize = 300;

/// Most lines of a file with its tests, or of a file of tests.
const LONGEST_WITH_TESTS: usize = 500;

/// Most lines of code of a function.
const LONGEST_FUNCTION: usize = 50;

#[test]
fn no_file_is_too_long() {
    let library = library();
    let found = library
        .iter()
        .map(|(file, lengths)| (file.name.clone(), lengths.lines));
    assert_none(complaints(found, LONGEST_FILE));
}

#[test]
fn no_file_is_too_long_with_its_tests() {
    let found = files()
        .into_iter()
        .map(|file| (file.name, file.text.lines().count()));
    assert_none(complaints(found, LONGEST_WITH_TESTS));
}

#[test]
fn no_function_is_too_long() {
    let library = library();
    let found = library.iter().flat_map(|(file, lengths)| {
        let functions = lengths.functions.iter();
        functions.map(|it| (format!("{}: {}", file.name, it.name), it.code))
    });
    assert_none(complaints(found, LONGEST_FUNCTION));
}

/// Returns the library's files that are not only for tests, with their lengths.
fn library() -> Vec<(File, Lengths)> {
    let mut files = files();
    let tests: BTreeSet<_> = files.iter().flat_map(declared_for_tests).collect();
    files.retain(|file| (1..=file.module.len()).all(|end| !tests.contains(&file.module[..end])));
    let lengths: Vec<_> = files.iter().map(|file| Lengths::of(&file.text)).collect();
    files.into_iter().zip(lengths).collect()
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

/// Returns a message for each file or function that is longer than `longest`.
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

    const SOURCE: &str = "//! Words.

fn short() -> [u8; 2] { [1, 2] }
impl A {
    /// Words.
    fn long(of: impl Fn(u8) -> u8) {
        // Words.

        let text = \"{
            words\";
    }
    fn none(self);
}
#[cfg(test)]
pub(crate) mod apart;
type F = fn(u8);
#[cfg(test)]
mod tests {
    fn test() {}
}
";

    #[test]
    fn functions_are_counted_without_comments_and_blank_lines() {
        let functions = Lengths::of(SOURCE).functions.into_iter();
        let found: Vec<_> = functions.map(|it| (it.line, it.name, it.code)).collect();
        let expected = [(3, "short".to_owned(), 1), (6, "long".to_owned(), 4)];
        assert_eq!(found, expected);
    }

    #[test]
    fn tests_are_not_counted() {
        let lengths = Lengths::of(SOURCE);
        assert_eq!((lengths.lines, lengths.code), (16, 11));
        assert_eq!(test_modules(SOURCE), ["apart"]);
    }
}
