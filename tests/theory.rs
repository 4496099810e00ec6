//! Tests that `docs/internals/theory.md` names a test for each of its statements, and only tests that exist.

use std::fs;

fn read(path: &str) -> String {
    let path = format!("{}/{path}", env!("CARGO_MANIFEST_DIR"));
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

/// Returns the file and the function of each reference `path/to/file.rs::function` in a text.
fn marks(text: &str) -> Vec<(&str, &str)> {
    let quoted = text.split('`').skip(1).step_by(2);
    quoted.filter_map(|it| it.split_once(".rs::")).collect()
}

/// Tests whether a source has a test of this name.
fn has_test(source: &str, name: &str) -> bool {
    let lines: Vec<&str> = source.lines().map(str::trim).collect();
    let head = format!("fn {name}() {{");
    lines
        .windows(2)
        .any(|pair| pair == ["#[test]", head.as_str()])
}

#[test]
fn every_test_that_the_page_names_exists() {
    let page = read("docs/internals/theory.md");
    let missing = marks(&page).into_iter().filter(|(file, name)| {
        let source = read(&format!("{file}.rs"));
        !has_test(&source, name)
    });
    let missing: Vec<_> = missing.collect();
    assert!(missing.is_empty(), "{missing:?}");
}

#[test]
fn every_statement_names_its_test() {
    let page = read("docs/internals/theory.md");
    let statements: Vec<&str> = page.split("\n**Statement ").skip(1).collect();
    assert!(statements.len() >= 8, "{} statements", statements.len());
    for (index, statement) in statements.iter().enumerate() {
        let number = format!("{}:", index + 1);
        assert!(statement.starts_with(&number), "not {number} {statement}");
        assert!(!marks(statement).is_empty(), "no test: {statement}");
    }
}

#[test]
fn test_that_is_gone_is_found() {
    let source = "    #[test]\n    fn here() {\n    }\n\nfn helper() {\n}\n";
    assert!(has_test(source, "here"));
    assert!(!has_test(source, "helper") && !has_test(source, "gone"));
    let marks = marks("x `a/b.rs::c` y `d` z `e.rs::f`");
    assert_eq!(marks, [("a/b", "c"), ("e", "f")]);
}
