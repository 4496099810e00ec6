//! The example `serial` keeps its picture, and names the line and what is wrong with it.

#[path = "../examples/serial/main.rs"]
mod serial;

use serial::lines::read;

#[test]
fn example_keeps_its_picture() {
    serial::main();
}

/// Each line is a case: the lines of a scene with slashes between them, an arrow, the number of the wrong
/// line, and what is wrong with it. M is a material.
const CASES: &str = "
sphere 0 0 1 1 0/end => 1: expected material
M/sphere 0 0 1 1 0.5/end => 2: expected material
M/sphere 0 0 1 0/end => 2: expected material
M/sphere 0 0 1 1 0 0 0 0 0/end => 2: expected material
M//end => 2: expected material
ball 0 0 1 1 0/end => 1: expected material
light 0 0 1,5 1 1 1/end => 1: number: text must be decimal digits
light 0 0 1e300 1 1 1/nonsense/end => 1: coordinates and sizes
material 1 1 1 0.2 0.8 0 1 1.1/end => 1: mirror must be within
M/M/M/M/M/end => 5: too many materials
material 9 9 9 9 9 9 1 0/light 0 0 9 9 9 9/end => 3: color * (ambient
M/sphere 0 0 1 1 0 => 0: expected material";

#[test]
fn first_wrong_line_is_named() {
    for case in CASES.lines().skip(1) {
        let (lines, expected) = case.split_once(" => ").expect("an arrow");
        let (line, words) = expected.split_once(": ").expect("a line");
        let lines = lines.replace('M', "material 1 1 1 0.2 0.8 0 1 0");
        let error = read(lines.replace('/', "\n").lines()).expect_err(case);
        assert_eq!(error.0.to_string(), line, "{case}");
        let said = error.1.to_string();
        assert!(said.contains(words), "{case}: {said}");
    }
}
