//! Tests that the schema of scene files accepts and refuses the same files as their parser, as far
//! as a schema can.

#![cfg(test)]

mod document;

use std::path::{Path, PathBuf};
use std::sync::LazyLock;
use std::{env, fs, iter};

use arbitrary::Unstructured;
use jsonschema::Validator;
use reflet::host::file::{FileError, Problem, SceneFile};
use reflet::{ErrorKind, Material, Number};
use serde_json::{Map, Value, json};

/// The parser's verdict on a file.
#[derive(Clone, Copy, Debug, PartialEq, Eq, PartialOrd, Ord)]
enum Verdict {
    Accepted,
    /// Refused because parts do not fit each other, which a schema cannot express.
    Meaning,
    /// Refused for a type, a key, a number of parts or the range of a number.
    Form,
}

fn repository() -> PathBuf {
    Path::new(env!("CARGO_MANIFEST_DIR")).join("../..")
}

fn schema() -> Value {
    let text = fs::read_to_string(repository().join("docs/scene.schema.json")).unwrap();
    serde_json::from_str(&text).unwrap()
}

static VALIDATOR: LazyLock<Validator> =
    LazyLock::new(|| jsonschema::draft202012::new(&schema()).unwrap());

/// Returns the parser's verdict. A file of several scenes gets the verdict of the worst one.
fn verdict(file: &Value) -> Verdict {
    match (SceneFile::parse(&file.to_string(), None), file) {
        (Err(error), Value::Array(scenes)) if is_undecided(&error) => {
            scenes.iter().map(verdict).max().expect("there are several")
        }
        (Err(error), _) => kind(&error),
        (Ok(scene), _) => match (scene.runtime(), scene.build()) {
            (Err(error), _) => kind(&error),
            (_, Ok(_)) => Verdict::Accepted,
            // Each part is well formed, so an error is about how the parts fit each other.
            (_, Err(_)) => Verdict::Meaning,
        },
    }
}

fn is_undecided(error: &FileError) -> bool {
    matches!(error.problem(), Problem::Undecided { .. })
}

fn kind(error: &FileError) -> Verdict {
    match error.problem() {
        Problem::UnknownMaterial { .. } | Problem::Repeated { .. } => Verdict::Meaning,
        // How thin a triangle is follows from all its corners.
        Problem::Scene(error) if error.kind() == ErrorKind::Corners => Verdict::Meaning,
        Problem::Camera(error) if matches!(error.kind(), ErrorKind::View | ErrorKind::Up) => {
            Verdict::Meaning
        }
        Problem::Json { .. }
        | Problem::Empty
        | Problem::TwoBackgrounds
        | Problem::Scene(_)
        | Problem::Camera(_) => Verdict::Form,
        problem => panic!("{problem}"),
    }
}

/// Returns the verdict on a file, and whether the schema takes it.
fn judged(file: &Value) -> (Verdict, bool) {
    (verdict(file), VALIDATOR.is_valid(file))
}

/// Checks that schema and parser agree, and returns the verdict. The parser must refuse what the schema
/// refuses, and the schema must refuse what the parser refuses for its form.
fn agreed(file: &Value, what: &str) -> Verdict {
    let (verdict, is_valid) = judged(file);
    let agree = match verdict {
        Verdict::Accepted => is_valid,
        Verdict::Meaning => true,
        Verdict::Form => !is_valid,
    };
    let words = "by the parser, valid by the schema";
    assert!(agree, "{what}: {verdict:?} {words}: {is_valid}: {file}");
    verdict
}

/// Returns a file with another value at a place.
fn with(file: &Value, place: &str, value: Value) -> Value {
    let mut file = file.clone();
    *file.pointer_mut(place).unwrap() = value;
    file
}

/// Returns a scene file with one of everything.
fn still_life() -> Value {
    json!({
        "$schema": "docs/scene.schema.json",
        "name": "still life",
        "camera": { "position": [1, -5, 2], "target": [0, 0, 1], "up": [0, 0.5, 1], "fov": 40 },
        "materials": [ { "name": "clay", "color": [0.5, 0.25, 0.125], "ambient": 0.1,
                         "diffuse": 0.75, "specular": 0.5, "shininess": 1, "mirror": 0,
                         "checker": { "color": [0.5, 0.75, 1], "size": [1, 0, 2] } } ],
        "lights": [ { "position": [3, -4, 6], "color": [1, 0.5, 0.25], "range": 2.5 } ],
        "suns": [ { "direction": [3, -4, 5], "color": [0.25, 1, 0.5], "disc": 0.5 } ],
        "spheres": [ { "center": [0, 0, 1.5], "radius": 1.25, "material": "clay" } ],
        "planes": [ { "center": [0, 0, -1], "normal": [0, 0, 2], "material": "clay" } ],
        "cylinders": [ { "center": [2, 0, 1], "axis": [0, 0, 3], "radius": 0.5, "height": 2.5,
                         "material": "clay" } ],
        "discs": [ { "center": [2, 0, 3], "normal": [0, 0, 4], "radius": 0.75, "material": "clay" } ],
        "triangles": [ { "corners": [[4, 0, 1], [5, 0, 1], [4, 0, 2.5]], "material": "clay",
                         "normals": [[0, -1, 0], [0.5, -1, 0], [0, -1, 0.5]] } ],
        "sky": { "up": [0, 0, 5], "below": [0.125, 0.25, 0.375], "horizon": [0.5, 1, 2],
                 "above": [0.0625, 0, 1] },
        "epsilon": 0.0078125
    })
}

/// Returns [`still_life`] with a background of one colour.
fn plain_life() -> Value {
    let mut file = still_life();
    file.as_object_mut().unwrap().remove("sky");
    file["background"] = json!([0.125, 0.25, 0.375]);
    file["materials"][0]["checker"]["size"] = json!(0.5);
    file
}

#[test]
fn schema_is_one_of_its_draft() {
    let schema = schema();
    assert_eq!(
        schema["$schema"],
        "https://json-schema.org/draft/2020-12/schema"
    );
    assert!(jsonschema::draft202012::meta::is_valid(&schema));
}

#[test]
fn defaults_of_a_material_are_those_of_the_library() {
    let fields = &schema()["$defs"]["material"]["properties"];
    let keys = ["ambient", "diffuse", "specular", "shininess", "mirror"];
    let given = keys.map(|key| fields[key]["default"].as_f64().expect(key));
    let plain = Material::new([0.0; 3]).described_coefficients();
    assert_eq!(given, plain.map(Number::to_f64));
}

#[test]
fn every_number_is_judged_alike_at_its_edges() {
    for (whole, expected) in [(still_life(), 94), (plain_life(), 83)] {
        assert_eq!(verdict(&whole), Verdict::Accepted);
        let mut numbers = document::places(&whole);
        numbers.retain(|it| whole.pointer(it).unwrap().is_number());
        assert_eq!(numbers.len(), expected);
        for place in numbers {
            for edge in document::EDGES {
                agreed(&with(&whole, &place, json!(edge)), &place);
            }
        }
    }
}

#[test]
fn sky_and_background_together_are_refused_by_both() {
    let mut file = still_life();
    file["background"] = json!([0, 0, 0]);
    assert_eq!(judged(&file), (Verdict::Form, false));
    file["sky"] = Value::Null;
    assert_eq!(judged(&file), (Verdict::Accepted, true));
}

#[test]
fn largest_scene_is_taken_by_both() {
    const MOST: i32 = 1 << 30;
    let mut file = still_life();
    for list in ["lights", "planes", "cylinders", "discs", "triangles"] {
        file[list] = json!([]);
    }
    // No cell but the largest would be told apart.
    file["materials"][0]["checker"] = Value::Null;
    let sphere = |x| json!({ "center": [x, 0, 0], "radius": MOST, "material": "clay" });
    file["spheres"] = json!([sphere(-MOST), sphere(MOST)]);
    file["epsilon"] = json!(MOST);
    assert_eq!(judged(&file), (Verdict::Accepted, true));
}

#[test]
fn every_key_is_judged_alike_where_it_is_missing_or_unknown() {
    let whole = still_life();
    for place in document::places(&whole) {
        let Value::Object(fields) = whole.pointer(&place).unwrap() else {
            continue;
        };
        let changed = |change: &dyn Fn(&mut Map<String, Value>)| {
            let mut fields = fields.clone();
            change(&mut fields);
            agreed(&with(&whole, &place, fields.into()), &place)
        };
        for key in fields.keys() {
            changed(&|fields| drop(fields.remove(key)));
        }
        let extended = changed(&|fields| drop(fields.insert("unknown".to_owned(), Value::Null)));
        assert_eq!(extended, Verdict::Form, "{place}");
    }
}

#[test]
fn every_list_is_judged_alike_at_its_most() {
    for (list, most) in document::LISTS {
        for (count, expected) in [(most, true), (most + 1, false)] {
            let mut file = still_life();
            document::fill(&mut file, list, count);
            assert_eq!(VALIDATOR.is_valid(&file), expected, "{count} {list}");
            agreed(&file, &format!("{count} {list}"));
        }
    }
}

#[test]
fn zero_directions_are_refused_by_both() {
    for place in [
        "/camera/up",
        "/planes/0/normal",
        "/cylinders/0/axis",
        "/discs/0/normal",
        "/triangles/0/normals/1",
        "/sky/up",
        "/suns/0/direction",
        "/materials/0/checker/size",
    ] {
        let (verdict, is_valid) = judged(&with(&still_life(), place, json!([0, 0.0, -0.0])));
        assert!(verdict != Verdict::Accepted && !is_valid, "{place}");
    }
}

#[test]
fn random_files_are_judged_alike() {
    const CASES: u64 = 4000;
    let scenes = [still_life(), plain_life()];
    let mut counts = [0; 3];
    for seed in 0..CASES {
        let bytes = random_bytes(seed);
        let file = document::file(&mut Unstructured::new(&bytes), &scenes).unwrap();
        counts[agreed(&file, &format!("seed {seed}")) as usize] += 1;
    }
    println!("accepted, refused for their meaning, for their form: {counts:?}");
    assert!(counts.iter().all(|&it| it > CASES / 40), "{counts:?}");
}

/// Returns as many bytes as a file needs, by the generator SplitMix64.
fn random_bytes(seed: u64) -> Vec<u8> {
    let mut state = seed << 32;
    let next = || {
        state = state.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (state ^ (state >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        (mixed ^ (mixed >> 31)).to_le_bytes()
    };
    iter::repeat_with(next).take(256).flatten().collect()
}

/// In two ways the parser accepts more than the schema; no file should use them.
#[test]
fn parser_alone_takes_objects_as_arrays_and_numbers_that_round_to_zero() {
    let lax = [
        ("/lights/0", json!([[3, -4, 6], [1, 1, 1], null])),
        ("/materials/0/mirror", json!(-1e-30)),
    ];
    for (place, value) in lax {
        let file = with(&still_life(), place, value);
        assert_eq!(judged(&file), (Verdict::Accepted, false), "{place}");
    }
}

/// Checks the scenes in the folder `REFLET_COURSE` and next to it, or else next to the repository;
/// the files of the repository; and the example in the library's documentation.
#[test]
fn every_sample_is_valid() {
    let course = env::var_os("REFLET_COURSE")
        .map_or_else(|| repository().join("../shared/course"), PathBuf::from);
    let folders = [
        course.join("../hard"),
        course,
        repository().join("docs"),
        repository().join("examples/scenes"),
        repository().join("examples/yardstick"),
    ];
    for folder in folders.iter().filter(|folder| !folder.is_dir()) {
        println!("skipped: there is no folder {}", folder.display());
    }
    let files = folders.iter().flat_map(|folder| files(folder));
    let texts = files.map(|file| fs::read_to_string(file).unwrap());
    let mut samples = 0;
    for text in texts.chain([documented()]) {
        let file: Value = serde_json::from_str(&text).unwrap();
        let errors = VALIDATOR.iter_errors(&file).map(|it| it.to_string());
        let errors: Vec<_> = errors.collect();
        assert!(errors.is_empty(), "{errors:?}");
        assert_eq!(verdict(&file), Verdict::Accepted, "{text}");
        samples += 1;
    }
    println!("{samples} samples");
}

/// Returns the scene files of a folder, or none if the folder does not exist.
fn files(folder: &Path) -> Vec<PathBuf> {
    let entries = fs::read_dir(folder).into_iter().flatten();
    let paths = entries.map(|entry| entry.unwrap().path());
    let is_scene = |path: &PathBuf| {
        let name = path.to_string_lossy();
        name.ends_with(".json") && !name.ends_with(".schema.json")
    };
    paths.filter(is_scene).collect()
}

/// Returns the scene file in the library's documentation.
fn documented() -> String {
    let source = fs::read_to_string(repository().join("src/host/file/mod.rs")).unwrap();
    let lines = source.lines().skip_while(|line| !line.ends_with("```json"));
    let lines = lines.skip(1).take_while(|line| !line.ends_with("```"));
    lines.map(|line| line.trim_start_matches("//!")).collect()
}
