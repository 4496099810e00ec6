//! What a page gets for what it asks, for the built-in scenes.

use reflet::host::reference::{Camera, Scene};
use reflet::scenes::{self, BuiltIn, Visitor};
use serde_json::{Value, json};

use super::*;

#[path = "../../command_line/src/scene_file.rs"]
mod scene_file;

/// The settings of the measured pictures: 64x64, 4 reflections, Blinn-Phong, `Fast`.
const MEASURED: Settings = Settings {
    width: 64,
    height: 64,
    reflections: 4,
    quality: 0,
    shading: 0,
    smooth: 1,
    display: 0,
};

const EXACT: Settings = Settings {
    quality: 1,
    ..MEASURED
};

struct AsFile;

impl Visitor for AsFile {
    type Output = String;

    fn visit<S: BuiltIn>(self) -> String {
        let scene = S::with_description(|description| Scene::from(&description));
        let materials = scene_file::materials("", &scene);
        scene_file::text(S::NAME, &materials, &scene, &Camera::from(&S::CAMERA))
    }
}

fn text(name: &str) -> String {
    scenes::visit(name, AsFile).unwrap()
}

fn file(name: &str) -> Value {
    serde_json::from_str(&text(name)).unwrap()
}

fn parsed(answer: &Answer) -> Value {
    serde_json::from_str(answer.as_ref().unwrap()).unwrap()
}

fn refused(answer: &Answer) -> Value {
    serde_json::from_str(answer.as_ref().unwrap_err()).unwrap()
}

fn opened(name: &str) -> Playground {
    let mut playground = Playground::default();
    parsed(&playground.open(&text(name), -1));
    playground
}

/// Draws a frame, and returns its pixels and what it tells.
fn drawn(playground: &mut Playground, settings: Settings) -> (Vec<u8>, Value) {
    assert_eq!(playground.frame(settings).unwrap(), "");
    let rows = (0..settings.height).flat_map(|y| playground.row(y).to_vec());
    let pixels = rows.collect();
    (pixels, parsed(&playground.finish()))
}

#[test]
fn open_scene_tells_what_it_has_and_needs() {
    let mut playground = Playground::default();
    let facts = parsed(&playground.open(&text("castle"), -1));
    assert_eq!(facts["name"], "castle");
    assert_eq!(facts["names"], json!(["castle"]));
    assert_eq!((&facts["planes"], &facts["lights"]), (&json!(2), &json!(1)));
    let has = |list: &str, word: &str| facts[list].as_array().unwrap().contains(&json!(word));
    let is_divided = has("needs", "spheres") && has("left_out", "discs");
    assert!(is_divided, "{facts}");
    assert_eq!(facts["camera"], parsed(&playground.camera()));
}

#[test]
fn refused_file_names_the_line_and_the_old_scene_stays() {
    let mut playground = opened("floor");
    let camera =
        r#""camera": {"position": [0, -5, 2], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 50}"#;
    let gold = r#""materials": [{"name": "gold", "color": [1, 1, 0]}]"#;
    let ball = |radius: i32, material: &str| {
        format!(r#"{{"center": [0, 0, 0], "radius": {radius}, "material": "{material}"}}"#)
    };
    let (good, small, plain) = (ball(1, "gold"), ball(0, "gold"), ball(1, "tin"));
    let cases = [
        ("{\n  \"camera\": 3\n}".to_owned(), 2, 13),
        (format!("{{{camera},\n{gold},\n\"spheres\": [{good},\n {small}]}}"), 4, 2),
        (format!("{{{camera},\n{gold},\n\"spheres\": [\n{plain}]}}"), 4, 1),
        (format!("[{{\"name\": \"a\", {camera}}},\n{{\"name\": \"b\",\n{camera}, {gold},\n\"spheres\": [{plain}]}}]"), 4, 13),
        (format!("{{{camera},\n\"epsilon\": -1}}"), 2, 12),
        ("{\n\"camera\": {\"position\": [0, 0, 0], \"target\": [0, 0, 0], \"up\": [0, 0, 1], \"fov\": 50}}".to_owned(), 2, 11),
    ];
    for (text, line, column) in cases {
        let refusal = refused(&playground.open(&text, -1));
        let place = [&refusal["line"], &refusal["column"]];
        assert_eq!(json!(place), json!([line, column]), "{refusal}");
        let message = refusal["error"].as_str().unwrap();
        assert!(!message.contains('\n'), "{message}");
    }
    assert_eq!(drawn(&mut playground, EXACT).0.len(), 64 * 64 * 4);
}

#[test]
fn scene_of_an_array_is_chosen_by_its_index() {
    let text = json!([file("floor"), file("castle")]).to_string();
    let mut playground = Playground::default();
    for (index, name) in [(-1, "floor"), (0, "floor"), (1, "castle")] {
        let facts = parsed(&playground.open(&text, index));
        assert_eq!(facts["name"], name);
        assert_eq!(facts["names"], json!(["floor", "castle"]));
    }
    let refusal = refused(&playground.open(&text, 2));
    assert_eq!(refusal["error"], "there is no scene 2: the file has 2");
    assert_eq!(refused(&playground.open("[]", -1))["line"], Value::Null);
}

#[test]
fn view_orbits_from_the_camera_of_the_file_and_comes_back() {
    let mut playground = opened("castle");
    let start = parsed(&playground.camera());
    let (before, _) = drawn(&mut playground, MEASURED);
    assert_eq!(playground.set_view(30_000, 5_000, 500).unwrap(), "");
    let turned = parsed(&playground.camera());
    assert_eq!(turned["target"], start["target"]);
    let half = start["fov"].as_f64().map(|it| it / 2.0);
    assert_eq!(turned["fov"].as_f64(), half);
    assert_ne!(drawn(&mut playground, MEASURED).0, before);
    for zoom in [0, u32::MAX] {
        assert_eq!(playground.set_view(0, 0, zoom).unwrap(), "");
    }
    assert_eq!(playground.set_view(0, 0, 1000).unwrap(), "");
    assert_eq!(parsed(&playground.camera()), start);
    assert_eq!(drawn(&mut playground, MEASURED).0, before);
}

#[test]
fn view_that_the_library_refuses_changes_nothing() {
    let mut level = file("floor");
    level["camera"]["position"] = json!([0, -5, 0]);
    level["camera"]["target"] = json!([0, 0, 0]);
    let mut playground = Playground::default();
    parsed(&playground.open(&level.to_string(), -1));
    let start = parsed(&playground.camera());
    refused(&playground.set_view(0, 90_000, 1000));
    assert_eq!(parsed(&playground.camera()), start);
}

#[test]
fn frame_without_a_scene_or_out_of_range_is_refused() {
    let mut empty = Playground::default();
    refused(&empty.frame(MEASURED));
    refused(&empty.path(0, 0));
    refused(&empty.rust());
    assert!(empty.row(0).is_empty());
    let mut playground = opened("floor");
    let wrong: [fn(&mut Settings); 5] = [
        |it| it.width = 0,
        |it| it.height = 5000,
        |it| it.reflections = 256,
        |it| it.smooth = 5,
        |it| it.display = 6,
    ];
    let refusals = wrong.map(|change| {
        let mut settings = MEASURED;
        change(&mut settings);
        refused(&playground.frame(settings))
    });
    let reason = "width must be 1 to 4096, not 0";
    assert_eq!(refusals[0]["error"], reason);
}

#[test]
fn smooth_picture_has_averages_and_no_hash() {
    let mut playground = opened("shading_lights");
    let large = Settings {
        width: 128,
        height: 128,
        ..MEASURED
    };
    let (samples, _) = drawn(&mut playground, large);
    let smooth = Settings {
        smooth: 2,
        ..MEASURED
    };
    let (pixels, told) = drawn(&mut playground, smooth);
    assert_eq!(told["hash"], Value::Null);
    let sample = |x: usize, y: usize| u32::from(samples[(y * 128 + x) * 4]);
    for (index, pixel) in pixels.chunks(4).enumerate() {
        let (x, y) = (index % 64 * 2, index / 64 * 2);
        let sum = sample(x, y) + sample(x + 1, y) + sample(x, y + 1) + sample(x + 1, y + 1);
        assert_eq!((u32::from(pixel[0]), pixel[3]), ((sum + 2) / 4, 255));
    }
}

#[test]
fn hash_waits_for_the_last_row() {
    let mut playground = opened("floor");
    assert_eq!(playground.frame(MEASURED).unwrap(), "");
    for y in (1..64).rev() {
        playground.row(y);
    }
    assert_eq!(parsed(&playground.finish())["hash"], Value::Null);
    playground.row(0);
    let upwards = parsed(&playground.finish());
    let (_, downwards) = drawn(&mut playground, MEASURED);
    assert_eq!(upwards["hash"], downwards["hash"], "in whatever order");
}

#[test]
fn path_of_a_pixel_adds_up_to_what_exact_draws() {
    for name in scenes::NAMES {
        for shading in [0, 1] {
            let mut playground = opened(name);
            let (pixels, _) = drawn(&mut playground, Settings { shading, ..EXACT });
            let columns = (0..64).step_by(7);
            for (x, y) in columns.flat_map(|x| (0..64).step_by(5).map(move |y| (x, y))) {
                let path = parsed(&playground.path(x, y));
                let at = ((y * 64 + x) * 4) as usize;
                assert_eq!(path["pixel"], json!(pixels[at..at + 3]), "{name} {x} {y}");
                let level = |sum: &Value| (sum.as_f64().unwrap() * 255.0).round().min(255.0);
                let levels: Vec<_> = path["sum"].as_array().unwrap().iter().map(level).collect();
                let pixel = pixels[at..at + 3].iter().map(|it| f64::from(*it));
                assert_eq!(levels, pixel.collect::<Vec<_>>());
            }
            refused(&playground.path(64, 0));
        }
    }
}

#[test]
fn first_hit_of_a_path_is_seen_at_its_pixel() {
    let mut playground = opened("castle");
    drawn(&mut playground, MEASURED);
    let path = parsed(&playground.path(20, 40));
    let seen = path["steps"][0]["seen"].as_array().unwrap();
    let [x, y] = [0, 1].map(|axis| seen[axis].as_f64().unwrap());
    assert!((x - 20.5).abs() < 0.1 && (y - 40.5).abs() < 0.1, "{x} {y}");
}

#[test]
fn runs_of_a_row_cover_it_and_differ_from_their_neighbours() {
    let mut playground = opened("castle");
    drawn(&mut playground, MEASURED);
    for y in [10, 32, 60] {
        let row = parsed(&playground.row_paths(y));
        let runs = row["runs"].as_array().unwrap();
        let ends = |run: &Value| [&run["from"], &run["to"]].map(|it| it.as_u64().unwrap());
        assert_eq!((ends(&runs[0])[0], ends(&runs[runs.len() - 1])[1]), (0, 63));
        for pair in runs.windows(2) {
            assert_eq!(ends(&pair[0])[1] + 1, ends(&pair[1])[0]);
            let paths = [&pair[0], &pair[1]].map(|it| (&it["levels"], &it["missed"]));
            assert_ne!(paths[0], paths[1]);
        }
    }
    assert_eq!(parsed(&playground.row_paths(64)), json!({ "runs": [] }));
}

#[test]
fn error_is_below_its_bound_and_falls_with_more_reflections() {
    let playground = opened("mirror2");
    let error = |reflections| parsed(&playground.error_at(32, 32, reflections));
    let number = |error: &Value, key: &str| error[key].as_f64().unwrap();
    let errors = [0, 2, 8].map(error);
    for error in &errors {
        // Both pictures are rounded.
        let most = number(error, "bound") + 1.0;
        assert!(number(error, "largest") <= most, "{error}");
    }
    assert!(number(&errors[0], "mean") > number(&errors[1], "mean"));
    assert!(number(&errors[1], "mean") > number(&errors[2], "mean"));
    assert!(number(&errors[0], "rays") < number(&errors[2], "rays"));
}

#[test]
fn rust_source_has_every_part_and_the_camera_of_the_view() {
    for name in scenes::NAMES {
        let mut playground = opened(name);
        let source = playground.rust().unwrap();
        let lines = || source.lines().map(str::trim_start);
        let count = |start: &str| lines().filter(|it| it.starts_with(start)).count();
        let file = file(name);
        for (list, part) in [
            ("spheres", "sphere("),
            ("planes", "plane("),
            ("cylinders", "cylinder("),
            ("lights", "light("),
        ] {
            let expected = file[list].as_array().map_or(0, Vec::len);
            assert_eq!(count(part), expected, "{name}: {list}");
        }
        assert_eq!(playground.set_view(10_000, 0, 1000).unwrap(), "");
        let turned = parsed(&playground.camera());
        let position = turned["position"].as_array().unwrap();
        let [x, y, z] = [0, 1, 2].map(|axis| position[axis].as_f64().unwrap());
        let look = format!("Camera::look_at([{x:?}, {y:?}, {z:?}]");
        assert!(playground.rust().unwrap().contains(&look), "{look}");
    }
}
