//! Tests the README: its example is the real one, its tables are the library's, and their figures
//! are the measured ones.

use std::fs;

use reflet::host::file;
use serde_json::Value;

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

/// Returns the table with these columns in a text. Removes the `//!` and `///` of documentation lines.
fn table(text: &str, columns: &str) -> Vec<String> {
    let lines = text
        .lines()
        .map(|line| line.trim_start_matches("//! ").trim_start_matches("/// "));
    let rows = lines.skip_while(|line| *line != columns);
    let rows = rows.take_while(|line| line.starts_with('|'));
    rows.map(str::to_owned).collect()
}

/// Returns the measured figures of a file in `docs/measured`, one for each line.
fn measured(file: &str) -> Vec<Value> {
    let lines = read(&format!("docs/measured/{file}"));
    let rows = lines
        .lines()
        .map(|line| serde_json::from_str(line).unwrap());
    rows.collect()
}

#[test]
fn the_readmes_limits_are_the_librarys() {
    let columns = "| what | range |";
    let limits = table(&read("README.md"), columns);
    assert!(limits.len() > 5, "{limits:?}");
    assert_eq!(limits, table(&read("src/lib.rs"), columns));
}

#[test]
fn figures_of_moving_scenes_are_the_measured_ones() {
    const COLUMNS: &str = "| core | scene | move | preparation | flash |";
    let mut expected = vec![COLUMNS.to_owned(), "|---|---|--:|--:|--:|".to_owned()];
    expected.extend(measured("moving.jsonl").iter().map(|row| {
        let number = |key: &str| row[key].as_f64().unwrap();
        let percent = 100.0 * number("flash") / number("constant_flash");
        assert!(percent <= 115.0, "{row}");
        format!(
            "| {} | {} | {} | {} | {percent:.1} % |",
            row["core"].as_str().unwrap(),
            row["scene"].as_str().unwrap(),
            row["move_instructions"],
            row["prepare_instructions"]
        )
    }));
    assert!(expected.len() > 7, "{expected:?}");
    assert_eq!(table(&read("src/accel/motion.rs"), COLUMNS), expected);
}

#[test]
fn figures_of_the_build_profiles_are_the_measured_ones() {
    const COLUMNS: &str =
        "| profile | castle flash | castle instr/pixel | corner1 flash | corner1 instr/pixel |";
    let mut expected = vec![COLUMNS.to_owned(), "|---|--:|--:|--:|--:|".to_owned()];
    for scenes in measured("profiles.jsonl").chunks(2) {
        let figures = scenes
            .iter()
            .zip(["castle", "corner1"])
            .map(|(row, scene)| {
                assert_eq!(
                    (&row["scene"], &row["profile"]),
                    (&scene.into(), &scenes[0]["profile"])
                );
                let instructions = row["instructions_per_pixel"].as_f64().unwrap();
                format!(" {} | {instructions:.0} |", row["flash"])
            });
        let profile = scenes[0]["profile"].as_str().unwrap();
        expected.push(format!("| {profile} |{}", figures.collect::<String>()));
    }
    assert!(expected.len() > 4, "{expected:?}");
    for file in ["README.md", "src/lib.rs"] {
        assert_eq!(table(&read(file), COLUMNS), expected, "{file}");
    }
}

#[test]
fn the_readmes_limits_of_scene_files_are_the_librarys() {
    let readme = read("README.md");
    let rows = table(&readme, "| part | number |");
    let expected = [
        ("spheres", file::MAX_SPHERES),
        ("planes", file::MAX_PLANES),
        ("cylinders", file::MAX_CYLINDERS),
        ("discs", file::MAX_DISCS),
        ("lights", file::MAX_LIGHTS),
        ("materials", file::MAX_MATERIALS),
    ]
    .map(|(part, most)| format!("| {part} | {most} |"));
    assert_eq!(rows.get(2..), Some(&expected[..]));
    let megabytes = file::MAX_BYTES / 1_000_000;
    let size = format!("\nThe file itself has at most {megabytes} MB.\n");
    assert!(readme.contains(&size), "{size}");
}

/// Returns the number that follows `beginning` in the first line that starts with it.
fn number_after<'a>(text: &'a str, beginning: &str) -> &'a str {
    let rest = text
        .lines()
        .find_map(|line| line.strip_prefix(beginning))
        .unwrap_or_else(|| panic!("no line begins with {beginning:?}"));
    rest.split(|it: char| !it.is_ascii_digit()).next().unwrap()
}

#[test]
fn the_readmes_counts_of_pictures_as_near_as_single_precision_are_the_measured_ones() {
    let page = read("docs/accuracy.md");
    let all = number_after(&page, "Pictures of ");
    let exact = number_after(&page, "- `exact`: ");
    let fast = number_after(&page, "- `fast`: ");
    let readme = read("README.md").replace("\n  ", " ");
    for claim in [
        format!("Of {all} pictures of the built-in scenes, the quality `Exact` has"),
        format!(
            "or on 99.99 %, in {exact}; the default `Fast`, which interpolates most pixels, in {fast}."
        ),
    ] {
        assert!(readme.contains(&claim), "{claim}");
    }
}
