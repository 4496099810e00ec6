//! Checks rules that the compiler does not check: a file names only its own floor and those below,
//! only the top floor names embedded-graphics, and the crate's root has few names.

mod face;
mod source;

use std::{
    fs,
    path::{Path, PathBuf},
};

use source::{paths, tokens};

/// The modules of each floor, from the lowest up. Modules on the same floor may name each other.
const FLOORS: [&[&str]; 9] = [
    &["number", "error", "error_kind", "kinds"],
    &["vector", "ray", "grid", "color"],
    &[
        "background",
        "checker",
        "material",
        "qualities",
        "light",
        "shape",
        "camera",
    ],
    &["scene"],
    &["shade"],
    &["accel"],
    &["trace"],
    &["render"],
    &["display"],
];

/// Modules beside the stack: they use it, and no module of the stack names them.
const BESIDE: [&str; 2] = ["host", "scenes"];

/// The only module of the stack that draws on a display.
const DRAWS: &str = "display";

/// The files that may use wrapping arithmetic.
const WRAP: [&[&str]; 3] = [
    &["number", "narrow"],
    &["number", "product"],
    &["number", "sweep"],
];

/// The crate's root file, which may name every module.
const ROOF: &str = "lib";

#[test]
fn no_file_names_a_floor_above_its_own() {
    assert_kept(upward_names);
}

#[test]
fn only_the_top_floor_names_embedded_graphics() {
    assert_kept(displays_named);
}

#[test]
fn first_line_of_a_file_tells_its_floor_truly() {
    assert_kept(floor_misnamed);
}

#[test]
fn nothing_wraps_unseen() {
    assert_kept(wraps);
}

/// What a file does against one rule: line numbers and messages.
type Complaints = Vec<(usize, String)>;

/// Checks that all files keep a rule.
fn assert_kept(rule: impl Fn(&[String], &str) -> Complaints) {
    let found = files().into_iter().flat_map(|file| {
        let complaints = rule(&file.module, &file.text).into_iter();
        complaints.map(move |(line, words)| format!("src/{}:{line}: {words}", file.name))
    });
    assert_none(found.collect());
}

fn assert_none(complaints: Vec<String>) {
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

/// A source file of the library.
struct File {
    /// Path of the file below `src`.
    name: String,
    module: Vec<String>,
    text: String,
}

fn files() -> Vec<File> {
    let source = Path::new(env!("CARGO_MANIFEST_DIR")).join("src");
    let files = files_below(&source).into_iter().map(|path| {
        let below = path.strip_prefix(&source).unwrap();
        let names: Vec<_> = below.iter().map(|it| it.to_string_lossy()).collect();
        let name = names.join("/");
        File {
            module: module_of(&name),
            text: fs::read_to_string(&path).unwrap(),
            name,
        }
    });
    files.collect()
}

/// Returns the Rust files of a folder and of those inside it.
fn files_below(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).unwrap();
    let paths = entries.map(|entry| entry.unwrap().path());
    let mut files: Vec<_> = paths
        .flat_map(|it| if it.is_dir() { files_below(&it) } else { vec![it] })
        .collect();
    files.retain(|file| file.extension().is_some_and(|it| it == "rs"));
    files.sort();
    files
}

/// Returns the module path of a file: `[shape, sphere]` for `shape/sphere.rs`, `[shape]` for
/// `shape/mod.rs`.
fn module_of(file: &str) -> Vec<String> {
    let file = file.trim_end_matches(".rs").trim_end_matches("/mod");
    file.split('/').map(str::to_owned).collect()
}

fn floor_of(room: &str) -> Option<usize> {
    FLOORS.iter().position(|rooms| rooms.contains(&room))
}

fn upward_names(module: &[String], source: &str) -> Complaints {
    let own = module[0].as_str();
    if own == ROOF || BESIDE.contains(&own) {
        return Vec::new();
    }
    let Some(floor) = floor_of(own) else {
        return vec![(1, format!("the room `{own}` has no floor yet"))];
    };
    let wrong = |room: &str| match floor_of(room) {
        _ if room == own => None,
        _ if BESIDE.contains(&room) => Some("stands beside the stack".to_owned()),
        None => Some("is no room: name the room, not what the roof re-exports".to_owned()),
        Some(other) if other > floor => Some(format!("is on floor {other}, this is {floor}")),
        Some(_) => None,
    };
    paths(module, source)
        .into_iter()
        .filter_map(|(line, room)| Some((line, format!("`{room}` {}", wrong(&room)?))))
        .collect()
}

fn displays_named(module: &[String], source: &str) -> Complaints {
    let own = module[0].as_str();
    if own == DRAWS || BESIDE.contains(&own) {
        return Vec::new();
    }
    tokens(source)
        .into_iter()
        .filter(|(_, token)| token.starts_with("embedded_graphics"))
        .map(|(line, token)| (line, format!("`{token}` is for `{DRAWS}` alone")))
        .collect()
}

/// Finds the names of wrapping functions, up to the tests of a file.
fn wraps(module: &[String], source: &str) -> Complaints {
    let is_test = module.iter().any(|name| name == "tests");
    if is_test || WRAP.iter().any(|it| *it == module) || BESIDE.contains(&module[0].as_str()) {
        return Vec::new();
    }
    let tokens = tokens(source);
    let tests = tokens
        .windows(3)
        .position(|it| matches!(it, [(_, "mod"), (_, "tests"), (_, "{")]));
    tokens[..tests.unwrap_or(tokens.len())]
        .iter()
        .filter(|(_, token)| token.starts_with("wrapping_") || token.starts_with("overflowing_"))
        .map(|(line, token)| (*line, format!("`{token}`: name it in `number::narrow`")))
        .collect()
}

fn floor_misnamed(module: &[String], source: &str) -> Complaints {
    let told = source
        .strip_prefix("//! Floor ")
        .and_then(|rest| rest.split(':').next());
    let is = floor_of(&module[0]).map_or("none".to_owned(), |floor| floor.to_string());
    match told {
        Some(told) if told != is => vec![(1, format!("says floor {told}, stands on {is}"))],
        _ => Vec::new(),
    }
}

mod the_rules {
    use super::*;

    fn upward(module: &[&str], source: &str) -> Vec<String> {
        let module: Vec<String> = module.iter().map(|name| (*name).to_owned()).collect();
        let complaints = upward_names(&module, source).into_iter();
        complaints
            .map(|(line, words)| format!("{line}: {words}"))
            .collect()
    }

    #[test]
    fn name_of_an_upper_floor_is_found() {
        let source = "use core::fmt;\nuse crate::trace::Path;";
        let complaint = "2: `trace` is on floor 6, this is 4";
        assert_eq!(upward(&["shade"], source), [complaint]);
        assert_eq!(upward(&["trace"], source), [""; 0]);
        assert_eq!(upward(&["render"], source), [""; 0]);
    }

    #[test]
    fn name_inside_a_tree_is_found() {
        let source = "pub use crate::{number::{self, Unit as U}, scene::{Scene, *}, ray::Ray};";
        let complaint = "1: `scene` is on floor 3, this is 2";
        assert_eq!(upward(&["shape", "sphere"], source), [complaint; 2]);
    }

    #[test]
    fn name_inside_code_is_found() {
        let source =
            "fn f(x: &'static str) -> crate::render::FrameBuilder<crate::scene::Scene> { }";
        let complaints = [
            "1: `render` is on floor 7, this is 6",
            "1: `host` stands beside the stack",
        ];
        let source = format!("{source} const C: char = '\\''; fn g() {{ crate::host::f() }}");
        assert_eq!(upward(&["trace"], &source), complaints);
    }

    #[test]
    fn relative_name_is_followed() {
        let upper = "use super::super::scene::Scene;";
        assert_eq!(upward(&["shape", "plane"], upper).len(), 1);
        let tests = "mod tests { use super::*; use super::super::scene::Scene; } use super::ray;";
        assert_eq!(
            upward(&["camera"], tests),
            ["1: `scene` is on floor 3, this is 2"]
        );
    }

    #[test]
    fn name_that_the_roof_re_exports_is_no_way_around() {
        let complaints = upward(&["number"], "use crate::Scene;");
        assert!(complaints[0].starts_with("1: `Scene` is no room"));
    }

    #[test]
    fn exported_macro_may_name_what_the_roof_re_exports() {
        let body = "macro_rules! m { () => { $crate::Scene } }";
        assert_eq!(
            upward(&["scene"], &format!("#[macro_export] {body}")),
            [""; 0]
        );
        assert_eq!(upward(&["scene"], body).len(), 1);
        let inner = "#[macro_export] macro_rules! m { () => {} } use crate::render::Rows;";
        assert_eq!(upward(&["scene"], inner).len(), 1);
    }

    #[test]
    fn comments_and_texts_name_nothing() {
        let source = "//! [`crate::render`]\n/* crate::trace::x */ const A: &str = \"crate::host::x \\\" \
             crate::scene::y\"; const B: &str = r#\"crate::\"scene::z\"#;";
        assert_eq!(upward(&["number"], source), [""; 0]);
    }

    #[test]
    fn display_below_the_top_floor_is_found() {
        let source = "use embedded_graphics::prelude::*;";
        assert_eq!(displays_named(&["shade".to_owned()], source).len(), 1);
        assert_eq!(displays_named(&["display".to_owned()], source), []);
    }

    #[test]
    fn sum_that_wraps_is_found() {
        let (ray, sum) = (["ray".to_owned()], "fn f() { 1_u32.wrapping_add(2); }");
        let complaint = (1, "`wrapping_add`: name it in `number::narrow`".to_owned());
        assert_eq!(wraps(&ray, sum), [complaint]);
        assert_eq!(wraps(&ray, &format!("mod tests {{ {sum} }}")), []);
        assert_eq!(wraps(&["host".to_owned()], sum), []);
    }

    #[test]
    fn floor_told_wrongly_is_found() {
        let module = ["color".to_owned()];
        assert_eq!(floor_misnamed(&module, "//! Floor 1: colours."), []);
        assert_eq!(floor_misnamed(&module, "//! Floor 2: colours.").len(), 1);
    }
}
