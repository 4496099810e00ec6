//! `cargo xtask count`: what the limits of the repository count, with the rule beside each figure.

use std::collections::BTreeSet;
use std::fs;
use std::path::Path;

use anyhow::{Context, Result};

use crate::{command::Program, print, root};

pub fn run() -> Result<()> {
    let [readme, docs] = [&["README.md"][..], &["docs/*.md", "docs/error-time/*.md"]];
    let figures = [
        (
            code_of_library()?,
            "lines of code in src: neither blank nor beginning with //, without tests",
        ),
        (
            rust_outside()?,
            "lines of Rust outside of src: all lines of all files that git tracks",
        ),
        (
            words_of(readme)?,
            "words of README.md, without bars and rules of tables",
        ),
        (
            words_of(docs)?,
            "words of the pages in docs, without docs/internals, bars and rules of tables",
        ),
        (
            packages_of_first_command()?,
            "packages that `cargo run --release --example render` compiles, this one included",
        ),
    ];
    let lines = figures.map(|(count, rule)| format!("{count:>6}  {rule}\n"));
    print(lines.concat())
}

/// Returns the paths of the files that git tracks and that match a pattern.
fn tracked(pattern: &str) -> Result<Vec<String>> {
    let git = Program::new("git").args(["ls-files", pattern]);
    let files = git.in_folder(root()).read()?;
    Ok(files.lines().map(str::to_owned).collect())
}

fn text(file: &str) -> Result<String> {
    fs::read_to_string(root().join(file)).with_context(|| format!("cannot read {file}"))
}

fn code_of_library() -> Result<usize> {
    let files = library()?.into_iter();
    Ok(files.map(|(_, text)| lines_of_code(&text)).sum())
}

/// Returns the files of the library that are not only for tests: paths and texts.
fn library() -> Result<Vec<(String, String)>> {
    let files = tracked("src/*.rs")?.into_iter();
    let files = files.map(|file| text(&file).map(|text| (file, text)));
    let mut files = files.collect::<Result<Vec<_>>>()?;
    let tests = files
        .iter()
        .flat_map(|(file, text)| test_modules(file, text));
    let tests: BTreeSet<String> = tests.collect();
    files.retain(|(file, _)| {
        let module = Path::new(file.trim_end_matches(".rs"));
        !tests.iter().any(|test| module.starts_with(test))
    });
    Ok(files)
}

/// Returns the paths, without `.rs`, of the test modules that a file declares in files of their own.
fn test_modules(file: &str, text: &str) -> Vec<String> {
    let path = Path::new(file);
    let is_root = path.ends_with("mod.rs") || path.ends_with("lib.rs");
    let folder = if is_root {
        path.parent().unwrap_or(path).to_owned()
    } else {
        path.with_extension("")
    };
    let mut lines = text.lines().map(str::trim);
    let mut modules = Vec::new();
    while let Some(line) = lines.next() {
        if is_test_mark(line)
            && let Some(name) = lines.next().and_then(declared_module)
        {
            modules.push(folder.join(name).display().to_string());
        }
    }
    modules
}

fn is_test_mark(line: &str) -> bool {
    line.starts_with("#[cfg(test)]")
}

/// Returns the name of a module that a line declares without a body.
fn declared_module(line: &str) -> Option<&str> {
    line.strip_suffix(';')?.split("mod ").nth(1)
}

/// Returns the lines of a file without what is marked for tests, and the number of lines that declare test modules in
/// other files. A test module in the file itself ends with the first brace that stands below its beginning, as rustfmt
/// puts it.
fn without_tests(text: &str) -> (Vec<&str>, usize) {
    let mut lines = text.lines();
    let (mut others, mut declaring) = (Vec::new(), 0);
    while let Some(line) = lines.next() {
        if !is_test_mark(line.trim()) {
            others.push(line);
        } else if lines.next().is_some_and(|next| next.ends_with('{')) {
            let indent = line.len() - line.trim_start().len();
            let end = format!("{}}}", " ".repeat(indent));
            lines.find(|line| *line == end);
        } else {
            declaring += 2;
        }
    }
    (others, declaring)
}

/// Counts the lines that are neither blank nor a comment, without tests.
fn lines_of_code(text: &str) -> usize {
    let (lines, _) = without_tests(text);
    let lines = lines.into_iter().map(str::trim);
    lines
        .filter(|it| !it.is_empty() && !it.starts_with("//"))
        .count()
}

fn rust_outside() -> Result<usize> {
    let files = tracked("*.rs")?.into_iter();
    let outside = files.filter(|file| !file.starts_with("src/"));
    outside.map(|file| Ok(text(&file)?.lines().count())).sum()
}

fn words_of(patterns: &[&str]) -> Result<usize> {
    let pages = patterns.iter().map(|pattern| tracked(pattern));
    let pages = pages.collect::<Result<Vec<_>>>()?.concat();
    let is_for_users = |page: &&String| !page.starts_with("docs/internals/");
    let user = pages.iter().filter(is_for_users);
    user.map(|page| Ok(words(&text(page)?))).sum()
}

fn words(text: &str) -> usize {
    let words = text.split(|c: char| c.is_whitespace() || c == '|');
    let is_word = |word: &&str| word.chars().any(|c| !matches!(c, '-' | ':'));
    words.filter(is_word).count()
}

/// Returns the number of packages that the first command of README compiles.
fn packages_of_first_command() -> Result<usize> {
    let tree = Program::new("cargo")
        .args(["tree", "--package", "reflet", "--prefix", "none"])
        .args(["--locked", "--edges", "normal,build,dev"])
        .args(["--format", "{p}"]);
    let packages = tree.in_folder(root()).read()?;
    let name = |line: &str| line.split(' ').take(2).collect::<Vec<_>>().join(" ");
    Ok(packages.lines().map(name).collect::<BTreeSet<_>>().len())
}

#[cfg(test)]
mod tests {
    use super::*;

    const MOST_CODE: usize = 20_263;
    const MOST_OUTSIDE: usize = 37_591;

    /// Most lines of a file of the library without its tests.
    const LONGEST_FILE: usize = 300;

    /// Most lines of one with its tests, or of a file of tests.
    const LONGEST_WITH_TESTS: usize = 500;

    /// Most packages that a newcomer's first command compiles.
    const MOST_PACKAGES: usize = 62;

    #[test]
    fn library_tools_and_first_command_are_no_larger_than_they_were() {
        let code = code_of_library().unwrap();
        assert!(code <= MOST_CODE, "{code} lines of code in src");
        let outside = rust_outside().unwrap();
        assert!(outside <= MOST_OUTSIDE, "{outside} lines outside of src");
        let packages = packages_of_first_command().unwrap();
        assert!(packages <= MOST_PACKAGES, "{packages} packages");
    }

    #[test]
    fn no_file_of_the_library_is_too_long() {
        for (file, text) in library().unwrap() {
            let (lines, declaring) = without_tests(&text);
            let length = lines.len() + declaring;
            assert!(length <= LONGEST_FILE, "{file}: {length} lines");
        }
        for file in tracked("src/*.rs").unwrap() {
            let length = text(&file).unwrap().lines().count();
            assert!(
                length <= LONGEST_WITH_TESTS,
                "{file}: {length} lines with tests"
            );
        }
    }

    #[test]
    fn tests_comments_and_blank_lines_are_no_code() {
        let text = "//! Words.\n\nfn short() {\n    // Words.\n    a();\n}\n#[cfg(test)]\nmod tests {\n    \
                    fn b() {\n    }\n}\nconst C: u8 = 1;\n#[cfg(test)]\npub(crate) mod apart;\n";
        assert_eq!(lines_of_code(text), 4);
        assert_eq!((without_tests(text).0.len(), without_tests(text).1), (7, 2));
        assert_eq!(test_modules("src/a/mod.rs", text), ["src/a/apart"]);
        assert_eq!(test_modules("src/a.rs", text), ["src/a/apart"]);
        assert_eq!(test_modules("src/lib.rs", text), ["src/apart"]);
    }

    #[test]
    fn bars_and_rules_of_tables_are_no_words() {
        assert_eq!(words("| a | b-c |\n|---|--:|\n| 1 | - |\n"), 3);
    }
}
