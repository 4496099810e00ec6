//! The README says what the project does: its example is the example, its table the library's.

use std::fs;

use reflet::host::file;

fn read(path: &str) -> String {
    let path = format!("{}/{path}", env!("CARGO_MANIFEST_DIR"));
    fs::read_to_string(&path).unwrap_or_else(|error| panic!("{path}: {error}"))
}

#[test]
fn the_readmes_example_is_the_example() {
    let readme = read("README.md");
    let (_, rest) = readme
        .split_once("<!-- examples/harbour.rs -->\n```rust\n")
        .expect("a marker");
    let (block, _) = rest.split_once("```\n").expect("an end of the block");
    assert_eq!(block, read("examples/harbour.rs"));
}

#[test]
fn the_readmes_limits_are_the_librarys() {
    let table = |text: &str| -> Vec<String> {
        let rows = text
            .lines()
            .skip_while(|line| !line.ends_with("| what | range |"));
        let rows = rows.map(|line| line.trim_start_matches("//! ").to_owned());
        rows.take_while(|line| line.starts_with('|')).collect()
    };
    let limits = table(&read("README.md"));
    assert!(limits.len() > 5, "{limits:?}");
    assert_eq!(limits, table(&read("src/lib.rs")));
}

#[test]
fn the_readmes_limits_of_scene_files_are_the_librarys() {
    let readme = read("README.md");
    let rows = readme
        .lines()
        .skip_while(|&line| line != "| part | number |");
    let rows: Vec<_> = rows.take_while(|line| line.starts_with('|')).collect();
    let expected = [
        ("spheres", file::MAX_SPHERES),
        ("planes", file::MAX_PLANES),
        ("cylinders", file::MAX_CYLINDERS),
        ("lights", file::MAX_LIGHTS),
        ("materials", file::MAX_MATERIALS),
    ]
    .map(|(part, most)| format!("| {part} | {most} |"));
    assert_eq!(
        rows.get(2..),
        Some(&expected.each_ref().map(|it| it.as_str())[..])
    );
    let megabytes = file::MAX_BYTES / 1_000_000;
    let size = format!("\nThe file itself has at most {megabytes} MB.\n");
    assert!(readme.contains(&size), "{size}");
}
