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
    let files = tracked("src/*.rs")?;
    let texts = files.iter().map(|file| text(file));
    let texts = texts.collect::<Result<Vec<_>>>()?;
    let pairs = || files.iter().zip(&texts);
    let tests: BTreeSet<String> = pairs()
        .flat_map(|(file, text)| test_modules(file, text))
        .collect();
    let is_test = |file: &str| {
        let module = file.trim_end_matches(".rs");
        let is_in = |test: &String| Path::new(module).starts_with(test);
        tests.iter().any(is_in)
    };
    let counted = pairs().filter(|(file, _)| !is_test(file));
    Ok(counted.map(|(_, text)| lines_of_code(text)).sum())
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

/// Counts the lines that are neither blank nor a comment, without test modules in the file itself. Such
/// a module ends with the first brace that stands below its beginning, as rustfmt puts it.
fn lines_of_code(text: &str) -> usize {
    let mut lines = text.lines();
    let mut count = 0;
    while let Some(line) = lines.next() {
        let trimmed = line.trim();
        if is_test_mark(trimmed) {
            let indent = line.len() - line.trim_start().len();
            let end = format!("{}}}", " ".repeat(indent));
            if lines.next().is_some_and(|next| next.ends_with('{')) {
                lines.find(|line| *line == end);
            }
            continue;
        }
        count += usize::from(!trimmed.is_empty() && !trimmed.starts_with("//"));
    }
    count
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

    const MOST_CODE: usize = 19_294;
    const MOST_OUTSIDE: usize = 37_021;

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
    fn tests_comments_and_blank_lines_are_no_code() {
        let text = "//! Words.\n\nfn short() {\n    // Words.\n    a();\n}\n#[cfg(test)]\nmod tests {\n    \
                    fn b() {\n    }\n}\nconst C: u8 = 1;\n#[cfg(test)]\npub(crate) mod apart;\n";
        assert_eq!(lines_of_code(text), 4);
        assert_eq!(test_modules("src/a/mod.rs", text), ["src/a/apart"]);
        assert_eq!(test_modules("src/a.rs", text), ["src/a/apart"]);
        assert_eq!(test_modules("src/lib.rs", text), ["src/apart"]);
    }

    #[test]
    fn bars_and_rules_of_tables_are_no_words() {
        assert_eq!(words("| a | b-c |\n|---|--:|\n| 1 | - |\n"), 3);
    }
}
