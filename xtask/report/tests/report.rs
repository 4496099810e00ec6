//! Tests the report of error against run time: makes it for one small scene, and checks the one in
//! the repository.

use std::collections::BTreeMap;
use std::fs;
use std::path::Path;
use std::process::{Command, Output, Stdio};

use reflet::scenes::NAMES;
use tempfile::TempDir;

/// A row of points.csv: values by the names of their columns.
type Row = BTreeMap<String, String>;

const REPORT: &str = concat!(env!("CARGO_MANIFEST_DIR"), "/../../docs/error-time");

/// Runs the command in a folder with arguments that are separated by spaces.
fn report(folder: &TempDir, arguments: &str) -> Output {
    Command::new(env!("CARGO_BIN_EXE_report"))
        .args(arguments.split_whitespace())
        .current_dir(folder)
        .stdin(Stdio::null())
        .output()
        .expect("the command runs")
}

fn rows(folder: &Path) -> Vec<Row> {
    let mut reader = csv::Reader::from_path(folder.join("points.csv")).expect("there is a table");
    let rows = reader.deserialize();
    rows.map(|row| row.expect("a row of the table")).collect()
}

fn number(row: &Row, column: &str) -> f64 {
    let text = &row[column];
    text.parse()
        .unwrap_or_else(|_| panic!("{column} of {row:?} is a number"))
}

/// Checks what must hold in every table, scene by scene.
fn assert_is_sound(rows: &[Row], scenes: &[&str]) {
    for scene in scenes {
        let fixed: Vec<&Row> = rows.iter().filter(|row| row["scene"] == *scene).collect();
        assert!(fixed.len() >= 6, "{scene}");
        assert_front_is_monotone(&fixed);
        // In the finest quality with all reflections, only rounding errors are left.
        let is_fine = |row: &&&Row| row["quality"] == "exact" && row["scale"] == "1";
        let finest = fixed.iter().filter(is_fine);
        let finest = finest.max_by_key(|row| row["reflections"].parse::<u8>().unwrap());
        let finest = finest.expect("exact is tried, too");
        assert!(number(finest, "within1") >= 0.98, "{finest:?}");
    }
}

/// Checks that on the front a higher cost never has a lower PSNR, and that no other point beats one
/// of the front.
fn assert_front_is_monotone(fixed: &[&Row]) {
    let cost = "instructions_per_pixel";
    let is_on_front = |row: &&&Row| row["on_front"] == "true";
    let mut front: Vec<_> = fixed.iter().filter(is_on_front).collect();
    assert!(!front.is_empty());
    front.sort_by(|a, b| {
        let by_cost = number(a, cost).total_cmp(&number(b, cost));
        by_cost.then(number(a, "psnr").total_cmp(&number(b, "psnr")))
    });
    for pair in front.windows(2) {
        let [one, next] = [pair[0], pair[1]].map(|row| number(row, "psnr"));
        assert!(one <= next, "{pair:?}");
    }
    for row in fixed {
        // The table's numbers are rounded.
        let beats = |point: &&Row| {
            number(row, cost) < number(point, cost) - 0.1
                && number(row, "psnr") > number(point, "psnr") + 0.001
        };
        let beaten = front.iter().find(|point| beats(point));
        assert_eq!(beaten, None, "{row:?}");
    }
}

#[test]
fn kept_report_is_sound() {
    let rows = rows(Path::new(REPORT));
    assert!(rows.iter().all(|row| row["size"] == "128x128"));
    assert_is_sound(&rows, &NAMES);
    let files = fs::read_dir(REPORT).expect("the folder can be read");
    let sizes = files.map(|entry| entry.unwrap().metadata().unwrap().len());
    let size: u64 = sizes.sum();
    assert!(size < 1_000_000, "{size}");
    assert_page_is_whole(Path::new(REPORT), &NAMES);
}

/// Checks that the page has the plot of every scene, and that every file it names exists.
fn assert_page_is_whole(folder: &Path, scenes: &[&str]) {
    let page = fs::read_to_string(folder.join("index.md")).unwrap();
    let links = page.split("](").skip(1);
    let links = links.map(|rest| rest.split(')').next().unwrap());
    let files: Vec<&str> = links.filter(|link| !link.starts_with('#')).collect();
    for file in &files {
        let bytes = fs::read(folder.join(file)).unwrap_or_else(|error| panic!("{file}: {error}"));
        assert!(bytes.starts_with(b"<svg"), "{file}");
    }
    for name in scenes {
        let file = format!("{name}-psnr.svg");
        assert!(files.contains(&file.as_str()), "{file}");
    }
    // The verdict and a plot come first, all other text after them.
    let place = |words: &str| page.find(words).unwrap_or_else(|| panic!("{words}"));
    assert!(place("**") < place(".svg)") && place(".svg)") < place("<details>"));
}

#[test]
#[ignore = "long: builds one more firmware"]
fn table_of_a_scene_has_the_columns_of_the_kept_one() {
    let folder = tempfile::tempdir().unwrap();
    let arguments = "corner1 --core m3 --size 16x16 --reflections 1 --out made";
    let output = report(&folder, arguments);
    let complaints = String::from_utf8_lossy(&output.stderr);
    assert_eq!(output.status.code(), Some(0), "{complaints}");
    let made = folder.path().join("made");
    let rows = rows(&made);
    assert_is_sound(&rows, &["corner1"]);
    let kept = self::rows(Path::new(REPORT));
    assert!(rows[0].keys().eq(kept[0].keys()));
    let front = fs::read_to_string(made.join("front.rs")).unwrap();
    let start = "pub const CORNER1: ParetoFront = ParetoFront::new(&[";
    assert!(front.contains(start), "{front}");
}

#[test]
fn wrong_arguments_are_named_in_one_line() {
    let folder = tempfile::tempdir().unwrap();
    let cases = [
        ("sandcastle", "sandcastle"),
        ("no.json", "no.json"),
        ("castle castle", "castle"),
        ("castle mirror1 --scene a", "--scene"),
        ("--core m9", "--core"),
        ("--size 0x5", "--size"),
        ("--size 2000x5", "1024"),
        ("--reflections 256", "--reflections"),
        ("corner1 --size 4x4 --out /dev/null/made", "--out"),
        ("--speed", "--speed"),
    ];
    for (arguments, name) in cases {
        let Output {
            status,
            stdout,
            stderr,
        } = report(&folder, arguments);
        let complaint = String::from_utf8_lossy(&stderr);
        assert_eq!((status.code(), stdout.len()), (Some(2), 0), "{arguments}");
        assert_eq!(complaint.lines().count(), 1, "{complaint}");
        assert!(complaint.contains(name), "{arguments}: {complaint}");
    }
    assert_eq!(fs::read_dir(&folder).unwrap().count(), 0);
}
