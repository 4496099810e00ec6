//! Measures the lengths of files and functions without their tests. Never knows which length is
//! allowed.

use std::{collections::BTreeSet, ops::RangeInclusive};

use crate::source::{lines_of_code, tokens};

/// Lengths of a file and its functions, without its tests.
pub struct Lengths {
    /// Number of lines of a file.
    pub lines: usize,
    /// Number of lines that are neither blank nor a comment.
    pub code: usize,
    /// The functions that have a body.
    pub functions: Vec<Function>,
}

/// A function. `code` counts its lines from `fn` to the last brace that are neither blank nor a
/// comment.
pub struct Function {
    pub line: usize,
    pub name: String,
    pub code: usize,
}

impl Lengths {
    pub fn of(source: &str) -> Self {
        let tokens = tokens(source);
        let tests = tests(&tokens);
        let is_test = |line: &usize| tests.iter().any(|it| it.contains(line));
        let mut code = lines_of_code(source);
        code.retain(|line| !is_test(line));
        let mut functions = functions(&tokens, &code);
        functions.retain(|function| !is_test(&function.line));
        Self {
            lines: (1..=source.lines().count())
                .filter(|it| !is_test(it))
                .count(),
            code: code.len(),
            functions,
        }
    }
}

/// Returns the names of the test-only modules that a file declares without a body.
pub fn test_modules(source: &str) -> Vec<String> {
    let tokens = tokens(source);
    let declared = declared_for_tests(&tokens).filter(|(_, _, opens)| !opens);
    declared
        .map(|(_, name, _)| tokens[name].1.to_owned())
        .collect()
}

/// Returns the line ranges of the test-only modules that are in the file itself.
fn tests(tokens: &[(usize, &str)]) -> Vec<RangeInclusive<usize>> {
    let opened = declared_for_tests(tokens).filter(|(_, _, opens)| *opens);
    opened
        .map(|(start, name, _)| tokens[start].0..=tokens[closing(tokens, name + 1)].0)
        .collect()
}

/// Finds each `#[cfg(test)] mod name`: the token at which it starts, the token of the name, and
/// whether `{` follows.
fn declared_for_tests(tokens: &[(usize, &str)]) -> impl Iterator<Item = (usize, usize, bool)> {
    const MARK: [&str; 7] = ["#", "[", "cfg", "(", "test", ")", "]"];
    let starts = (0..tokens.len()).filter(|start| {
        let marked = tokens[*start..].iter().map(|token| token.1);
        marked.take(MARK.len()).eq(MARK)
    });
    starts.filter_map(|start| {
        let declared = &tokens[start + MARK.len()..];
        let visibility = ["pub", "(", "crate", "super", ")"];
        let skipped = declared.iter().take_while(|it| visibility.contains(&it.1));
        let at = start + MARK.len() + skipped.count();
        let is_module = tokens.get(at).is_some_and(|it| it.1 == "mod");
        is_module.then(|| (start, at + 1, tokens[at + 2].1 == "{"))
    })
}

/// Returns the functions with a body. The lines of a nested function also count for the outer one.
fn functions(tokens: &[(usize, &str)], code: &BTreeSet<usize>) -> Vec<Function> {
    let starts = (0..tokens.len()).filter(|at| tokens[*at].1 == "fn");
    starts
        .filter_map(|start| {
            let (line, (_, name)) = (tokens[start].0, tokens.get(start + 1)?);
            let opening = opening(tokens, start + 2).filter(|_| *name != "(")?;
            let end = tokens[closing(tokens, opening)].0;
            Some(Function {
                line,
                name: (*name).to_owned(),
                code: code.range(line..=end).count(),
            })
        })
        .collect()
}

/// Returns the token of the brace that opens a function's body, or `None` if it has none.
fn opening(tokens: &[(usize, &str)], from: usize) -> Option<usize> {
    let mut depth = 0_usize;
    for (at, (_, token)) in tokens.iter().enumerate().skip(from) {
        match *token {
            "(" | "[" => depth += 1,
            ")" | "]" if depth == 0 => return None,
            ")" | "]" => depth -= 1,
            "{" if depth == 0 => return Some(at),
            ";" if depth == 0 => return None,
            _ => {}
        }
    }
    None
}

/// Returns the token of the brace that closes an opening brace.
fn closing(tokens: &[(usize, &str)], opening: usize) -> usize {
    let mut depth = 0_usize;
    for (at, (_, token)) in tokens.iter().enumerate().skip(opening) {
        match *token {
            "{" => depth += 1,
            "}" if depth == 1 => return at,
            "}" => depth -= 1,
            _ => {}
        }
    }
    tokens.len() - 1
}
