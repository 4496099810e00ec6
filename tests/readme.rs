//! Tests the README and the pages for users: examples and tables are the library's, figures are the
//! measured ones, and links lead to files of the package.

use std::fs;
use std::path::Path;
use std::process::Command;

use reflet::host::file;
use serde_json::Value;

fn root() -> &'static Path {
    Path::new(env!("CARGO_MANIFEST_DIR"))
}

fn read(path: &str) -> String {
    fs::read_to_string(root().join(path)).unwrap_or_else(|error| panic!("{path}: {error}"))
}

#[test]
fn the_readmes_examples_are_the_files() {
    let readme = read("README.md");
    for (file, language) in [
        ("examples/harbour.rs", "rust"),
        ("examples/scenes/harbour.json", "json"),
    ] {
        let marker = format!("<!-- {file} -->\n```{language}\n");
        let (_, rest) = readme.split_once(&marker).expect("a marker");
        let (block, _) = rest.split_once("```\n").expect("an end of the block");
        assert_eq!(block, read(file));
    }
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
fn figures_of_the_qualities_are_the_measured_ones() {
    const COLUMNS: &str = "| quality | flash | instructions a pixel | pixels equal to double precision \
                           | within one level |";
    let (sizes, errors) = (measured("qualities.jsonl"), measured("accuracy.jsonl"));
    let mut expected = vec![COLUMNS.to_owned(), "|---|--:|--:|--:|--:|".to_owned()];
    for name in ["Fast", "Small", "Exact"] {
        let quality = name.to_lowercase();
        let row = |rows: &[Value], key: &str, value: &str| {
            let mut rows = rows.iter().filter(|row| row["quality"] == *quality);
            let found = rows.find(|row| row["scene"] == "castle" && row[key] == value);
            found.expect("a row").clone()
        };
        let size = row(&sizes, "size", "64x64");
        let error = row(&errors, "shading", "blinn-phong");
        let number = |row: &Value, key: &str| row[key].as_f64().unwrap();
        expected.push(format!(
            "| `{name}` | {} | {:.0} | {:.3} % | {:.3} % |",
            size["flash"],
            number(&size, "instructions_per_pixel"),
            number(&error, "same"),
            number(&error, "within1"),
        ));
    }
    assert_eq!(table(&read("README.md"), COLUMNS), expected);
}

#[test]
fn claims_about_accuracy_are_the_measured_ones() {
    let errors = measured("accuracy.jsonl");
    let worst = |key: &str, qualities: &[&str]| {
        let is_meant = |row: &&Value| qualities.iter().any(|name| row["quality"] == *name);
        let shares = errors.iter().filter(is_meant);
        let shares = shares.map(|row| row[key].as_f64().unwrap());
        shares.fold(100.0, f64::min)
    };
    let readme = read("README.md").replace("\n  ", " ");
    let within1 = worst("within1", &["fast", "small", "exact"]);
    let same = worst("same", &["exact"]);
    for claim in [
        format!("at least {within1:.3} % of the pixels are within one level"),
        format!("In `Exact`, at least {same:.3} % are equal to it."),
    ] {
        assert!(readme.contains(&claim), "{claim}");
    }
}

#[test]
fn limits_of_scene_files_are_the_librarys() {
    let page = read("docs/files.md");
    for (part, most) in [
        ("spheres", file::MAX_SPHERES),
        ("planes", file::MAX_PLANES),
        ("cylinders", file::MAX_CYLINDERS),
        ("discs", file::MAX_DISCS),
        ("triangles", file::MAX_TRIANGLES),
        ("lights", file::MAX_LIGHTS),
        ("suns", file::MAX_SUNS),
        ("materials", file::MAX_MATERIALS),
    ] {
        let row = format!("| `{part}` | empty | at most {most} {part} |");
        assert!(page.contains(&row), "{row}");
    }
    let megabytes = file::MAX_BYTES / 1_000_000;
    let size = format!("\nThe file itself has at most {megabytes} MB.\n");
    assert!(page.contains(&size), "{size}");
}

#[test]
fn every_key_of_the_schema_is_on_the_page_of_scene_files() {
    let page = read("docs/files.md");
    let schema: Value = serde_json::from_str(&read("docs/scene.schema.json")).unwrap();
    let definitions = schema["$defs"].as_object().unwrap().values();
    let objects = definitions.filter_map(|it| it["properties"].as_object());
    let keys: Vec<&String> = objects.flat_map(|it| it.keys()).collect();
    assert!(keys.len() > 30, "{keys:?}");
    for key in keys {
        assert!(page.contains(&format!("`{key}`")), "{key}");
    }
}

/// Returns the targets of the links of a text that lead to files.
fn links(text: &str) -> Vec<&str> {
    let targets = text.split("](").skip(1);
    let targets = targets.filter_map(|rest| rest.split([')', '#']).next());
    targets
        .filter(|target| !target.is_empty() && !target.contains("://"))
        .collect()
}

/// Returns the patterns of `include` in a Cargo.toml, without the slash at their beginning.
fn included(manifest: &str) -> Vec<&str> {
    let (_, rest) = manifest.split_once("\ninclude = [").expect("a list");
    let (list, _) = rest.split_once(']').expect("an end of the list");
    let quoted = list.split('"').skip(1).step_by(2);
    quoted
        .map(|pattern| pattern.trim_start_matches('/'))
        .collect()
}

/// Tests whether a pattern names a file, or a folder that the file is in. `*` stands for any
/// characters except slashes.
fn covers(pattern: &str, path: &str) -> bool {
    let part_covers = |pattern: &str, part: &str| match pattern.split_once('*') {
        None => pattern == part,
        Some((start, end)) => {
            part.len() >= start.len() + end.len() && part.starts_with(start) && part.ends_with(end)
        }
    };
    let (mut parts, mut wanted) = (path.split('/'), pattern.split('/'));
    wanted.all(|wanted| parts.next().is_some_and(|part| part_covers(wanted, part)))
}

#[test]
fn every_link_of_the_readme_leads_to_a_file_of_the_package() {
    let (readme, manifest) = (read("README.md"), read("Cargo.toml"));
    let (links, patterns) = (links(&readme), included(&manifest));
    assert!(links.len() > 10 && patterns.len() > 5, "{links:?}");
    for link in links {
        assert!(root().join(link).is_file(), "{link} is no file");
        let is_covered = patterns.iter().any(|pattern| covers(pattern, link));
        assert!(is_covered, "{link} is not in `include`");
        // Cargo leaves out every folder that is a package of its own.
        let folders = Path::new(link).ancestors().skip(1);
        let mut folders = folders.filter(|folder| !folder.as_os_str().is_empty());
        let is_apart = folders.any(|folder| root().join(folder).join("Cargo.toml").exists());
        assert!(!is_apart, "{link} is in a package of its own");
    }
}

#[test]
fn package_with_its_film_is_small() {
    let folder = Path::new(env!("CARGO_TARGET_TMPDIR")).join("package");
    let package = Command::new(env!("CARGO"))
        .current_dir(root())
        .args(["package", "--package", "reflet", "--allow-dirty"])
        .args(["--no-verify", "--offline", "--target-dir"])
        .arg(&folder)
        .output()
        .expect("cargo runs");
    let words = String::from_utf8_lossy(&package.stderr);
    assert!(package.status.success(), "{words}");
    let name = format!("package/reflet-{}.crate", env!("CARGO_PKG_VERSION"));
    let bytes = |path: &Path| fs::metadata(path).unwrap().len();
    let package = bytes(&folder.join(name));
    assert!(package <= 450_000, "the package has {package} bytes");
    let film = bytes(&root().join("docs/bounce.gif"));
    assert!(film <= 150_000, "the film has {film} bytes");
}

#[test]
fn links_of_all_pages_for_users_lead_to_files() {
    for folder in ["", "error-time", "internals"] {
        let folder = root().join("docs").join(folder);
        for entry in fs::read_dir(&folder).unwrap() {
            let page = entry.unwrap().path();
            if page.extension().is_some_and(|it| it == "md") {
                for link in links(&fs::read_to_string(&page).unwrap()) {
                    assert!(folder.join(link).exists(), "{}: {link}", page.display());
                }
            }
        }
    }
}

#[test]
fn pattern_covers_files_in_its_folder_only() {
    assert!(covers("docs/*.md", "docs/a.md") && !covers("docs/*.md", "docs/b/a.md"));
    assert!(covers("src", "src/a/b.rs") && !covers("src", "srcs/a.rs"));
    assert!(covers("LICENSE-*", "LICENSE-MIT") && !covers("a/b.md", "a"));
    let text = "[a](b.md#c) [d](https://e) ![f](g.png) [h](#i)";
    assert_eq!(links(text), ["b.md", "g.png"]);
}
