//! The example `serial` keeps its picture, and names the line and what is wrong with it.

#[path = "../examples/serial/main.rs"]
mod serial;

use serial::lines::read;

#[test]
fn example_keeps_its_picture() {
    serial::main();
}

#[track_caller]
fn assert_refused(lines: &str, line: u32, words: &str) {
    let error = read(lines.lines()).expect_err("the scene is refused");
    assert_eq!(error.0, line, "{lines}");
    let said = error.1.to_string();
    assert!(said.contains(words), "{lines}: {said}");
}

#[test]
fn first_wrong_line_is_named() {
    const MATERIAL: &str = "material 1 1 1 0.2 0.8 0 1 0";
    for (lines, line, words) in [
        ("sphere 0 0 1 1 0\nend", 1, "expected material"),
        ("MATERIAL\nsphere 0 0 1 1 0.5\nend", 2, "expected material"),
        ("MATERIAL\nsphere 0 0 1 0\nend", 2, "expected material"),
        (
            "MATERIAL\nsphere 0 0 1 1 0 0 0 0 0\nend",
            2,
            "expected material",
        ),
        ("MATERIAL\n\nend", 2, "expected material"),
        ("ball 0 0 1 1 0\nend", 1, "expected material"),
        (
            "light 0 0 1,5 1 1 1\nend",
            1,
            "number: text must be decimal digits",
        ),
        (
            "light 0 0 1e300 1 1 1\nnonsense\nend",
            1,
            "coordinates and sizes",
        ),
        (
            "material 1 1 1 0.2 0.8 0 1 1.1\nend",
            1,
            "mirror must be within",
        ),
        (
            "MATERIAL\nMATERIAL\nMATERIAL\nMATERIAL\nMATERIAL\nend",
            5,
            "too many materials",
        ),
        (
            "material 9 9 9 9 9 9 1 0\nlight 0 0 9 9 9 9\nend",
            3,
            "color * (ambient",
        ),
        ("MATERIAL\nsphere 0 0 1 1 0", 0, "expected material"),
    ] {
        assert_refused(&lines.replace("MATERIAL", MATERIAL), line, words);
    }
}
