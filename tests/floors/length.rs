//! Measures the lengths of files without their tests. Never knows which length is allowed.

use std::ops::RangeInclusive;

use crate::source::tokens;

/// Returns the number of lines of a file without its tests.
pub fn length(source: &str) -> usize {
    let tests = tests(&tokens(source));
    let is_test = |line: &usize| tests.iter().any(|it| it.contains(line));
    let lines = 1..=source.lines().count();
    lines.filter(|line| !is_test(line)).count()
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
