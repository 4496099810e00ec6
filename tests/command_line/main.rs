//! Tests the render example as its users call it: the files it writes, its output, and its errors.

mod dithering;
mod examples;
#[cfg(feature = "film")]
mod film;
mod output;
mod program;
mod window;

use std::collections::BTreeSet;
use std::fs;

use program::{Folder, Outcome};
use reflet::scenes;
use serde_json::{Value, json};

/// Returns the built-in scene `floor` as a scene file.
fn floor() -> Value {
    json!({
        "name": "floor",
        "camera": { "position": [-2, 0, 1], "target": [0, 0, 0], "up": [1, 0, 0.75], "fov": 75 },
        "materials": [
            { "name": "white", "color": [0.9, 0.9, 0.9], "ambient": 0.6, "diffuse": 0.9,
              "specular": 0.1, "shininess": 4, "mirror": 0.1 }
        ],
        "planes": [ { "center": [0, 0, -0.5], "normal": [0, 0, 1], "material": "white" } ]
    })
}

/// Returns the scene file `floor` with a change.
fn changed(change: impl FnOnce(&mut Value)) -> String {
    let mut scene = floor();
    change(&mut scene);
    scene.to_string()
}

/// Runs a call that must succeed, and returns its output.
fn printed(folder: &Folder, arguments: &str) -> String {
    let outcome = folder.render(arguments);
    assert_eq!((outcome.code, &*outcome.stderr), (0, ""), "{arguments}");
    outcome.stdout
}

/// Runs a call that must fail with one line on standard error, and returns this line.
fn refused(folder: &Folder, arguments: &str) -> String {
    let outcome = folder.render(arguments);
    let (code, stdout, stderr) = (outcome.code, outcome.stdout, outcome.stderr);
    assert_eq!((code, &*stdout), (2, ""), "{arguments}: {stderr}");
    let line = stderr.strip_suffix('\n').expect("the line is ended");
    assert!(!line.contains('\n'), "{arguments}: {stderr}");
    let words = line.strip_prefix("error: ");
    words.expect("it is an error").to_owned()
}

/// Splits a test case at its arrow into the call and the expected words.
fn call_and_words(case: &str) -> (&str, &str) {
    case.split_once(" => ").expect("there is an arrow")
}

fn line_of_json(folder: &Folder, arguments: &str) -> Value {
    let printed = printed(folder, arguments);
    assert_eq!(printed.lines().count(), 1, "{printed}");
    serde_json::from_str(&printed).expect("the line is JSON")
}

fn keys(object: &Value) -> BTreeSet<&str> {
    let fields = object.as_object().unwrap();
    fields.keys().map(String::as_str).collect()
}

#[test]
fn bare_command_writes_the_castle_and_says_where() {
    let folder = Folder::new("bare");
    let printed = printed(&folder, "");
    let start = "castle 320x320, 4 reflections, blinn-phong, fast: ";
    assert!(printed.starts_with(start), "{printed}");
    assert!(printed.ends_with("\nwritten to castle.png\n"), "{printed}");
    assert_eq!(folder.png("castle.png").dimensions(), (320, 320));
}

#[test]
fn picture_without_a_path_takes_a_free_name() {
    let folder = Folder::new("free_name");
    folder.write("floor.png", "kept");
    folder.write("floor-2.png", "kept");
    let printed = printed(&folder, "floor --size 3x2");
    assert!(printed.ends_with("written to floor-3.png\n"), "{printed}");
    assert_eq!(folder.files(), ["floor-2.png", "floor-3.png", "floor.png"]);
    assert_eq!(folder.read("floor.png"), b"kept");
}

/// A name cannot lead to another folder.
#[test]
fn picture_is_called_after_its_scene_in_safe_letters() {
    let folder = Folder::new("name");
    let names = [
        ("../a\nb", "___a_b.png"),
        ("", "scene.png"),
        ("  ", "scene-2.png"),
    ];
    for (name, file) in names {
        folder.write("it.json", changed(|it| it["name"] = name.into()));
        let printed = printed(&folder, "it.json --size 1x1");
        let end = format!("written to {file}\n");
        assert!(printed.ends_with(&end), "{name:?}: {printed}");
    }
    let files = ["___a_b.png", "it.json", "scene-2.png", "scene.png"];
    assert_eq!(folder.files(), files);
}

#[test]
fn png_and_raw_are_the_same_picture_of_the_size_asked_for() {
    let folder = Folder::new("formats");
    let printed = printed(&folder, "mirror1 --size 21x13 --out a.png --raw a.rgb");
    let end = "\nwritten to a.png\nwritten to a.rgb\n";
    assert!(printed.ends_with(end), "{printed}");
    let raw = folder.read("a.rgb");
    assert_eq!(raw.len(), 21 * 13 * 3);
    let image = folder.png("a.png");
    assert_eq!((image.dimensions(), image.into_raw()), ((21, 13), raw));
    assert_eq!(folder.files(), ["a.png", "a.rgb"]);
}

#[test]
fn file_that_is_named_is_written_over() {
    let folder = Folder::new("written_over");
    for option in ["--out", "--raw"] {
        let call = |scene| printed(&folder, &format!("{scene} --size 4x4 {option} picture"));
        call("mirror1");
        let first = folder.read("picture");
        call("floor");
        let second = folder.read("picture");
        call("mirror1");
        assert!(first != second, "{option}");
        assert!(folder.read("picture") == first, "{option}");
    }
    assert_eq!(folder.files(), ["picture"]);
}

#[test]
fn what_is_no_picture_is_not_written_over() {
    let folder = Folder::new("kept");
    fs::create_dir(folder.path("folder")).unwrap();
    for option in ["--out", "--raw"] {
        let call = |path| refused(&folder, &format!("floor --size 2x2 {option} {path}"));
        let is_folder = "folder cannot be written: it is a folder";
        assert_eq!(call("folder"), is_folder);
        let missing = "no/such/folder/a cannot be written: there is no folder no/such/folder";
        assert_eq!(call("no/such/folder/a"), missing);
    }
    let both = refused(&folder, "floor --size 2x2 --out a --raw a");
    assert_eq!(both, "--out and --raw name the same file");
    let scene = changed(|_| ());
    folder.write("it.json", &scene);
    let own = refused(&folder, "it.json --size 2x2 --raw ./it.json");
    assert_eq!(own, "it.json is the scene file: it is not written over");
    assert_eq!(folder.read("it.json"), scene.as_bytes());
    assert_eq!(folder.files(), ["folder", "it.json"]);
}

#[test]
fn json_has_the_promised_keys() {
    let folder = Folder::new("json");
    let call = "castle --size 8x6 --reflections 2 --shading phong --quality small --json";
    let mut plain = line_of_json(&folder, call);
    assert!(plain["seconds"].take().as_f64().unwrap() > 0.0);
    let expected = json!({
        "scene": "castle", "size": "8x6", "reflections": 2, "shading": "phong",
        "quality": "small", "seconds": null
    });
    assert_eq!(plain, expected);

    let checked = line_of_json(&folder, &format!("{call} --check"));
    let mut all = keys(&plain);
    all.extend(["max", "psnr", "same", "within1", "within8"]);
    assert_eq!(keys(&checked), all);
    for share in ["same", "within1", "within8"] {
        let value = checked[share].as_f64().unwrap();
        assert!((0.0..=1.0).contains(&value), "{share} {value}");
    }
    assert!(folder.files().is_empty(), "no picture was asked for");
}

#[test]
fn equal_pictures_have_no_psnr_in_json() {
    let folder = Folder::new("equal");
    let line = line_of_json(&folder, "empty --size 5x5 --check --json");
    let found = json!([line["psnr"], line["max"], line["same"]]);
    assert_eq!(found, json!([null, 0, 1.0]));
    let words = printed(&folder, "empty --size 5x5 --check");
    let expected = "against double precision: same 100.000 %, within 1 100.000 %, \
                    within 8 100.000 %, PSNR inf dB, largest difference 0\n";
    assert!(words.ends_with(expected), "{words}");
    for call in ["--samples 9", "--smooth"] {
        let words = printed(&folder, &format!("empty --size 5x5 --check {call}"));
        let expected = "against double precision, 9 x 9 samples a pixel: same 100.000 %";
        assert!(words.contains(expected), "{words}");
    }
}

#[test]
fn needs_say_what_the_shading_leaves_out() {
    let folder = Folder::new("needs");
    let is_needed = |shading: &str, name: &str| {
        let line = line_of_json(
            &folder,
            &format!("castle --needs --json --shading {shading}"),
        );
        let mut needs = line["needs"].as_array().unwrap().iter();
        needs.find(|need| need["name"] == name).unwrap()["is_needed"] == true
    };
    for name in ["shadows", "highlights", "mirrors", "near_lights"] {
        assert!(
            is_needed("phong", name) && !is_needed("normals", name),
            "{name}"
        );
    }
    assert!(is_needed("normals", "spheres"));
}

#[test]
fn reference_is_named_where_it_is_all_that_is_rendered() {
    let folder = Folder::new("reference");
    let call = "columns --size 9x9 --reference --json";
    let alone = line_of_json(&folder, &format!("{call} --raw exact"));
    assert_eq!(alone["quality"], "reference");
    let both = line_of_json(&folder, &format!("{call} --check --raw both"));
    assert_eq!(both["quality"], "fast");
    assert!(both["max"].is_u64());
    let exact = folder.read("exact");
    assert_eq!(exact, folder.read("both"));
    assert_eq!(exact.len(), 9 * 9 * 3);
}

#[test]
fn scene_file_is_drawn_like_the_same_constants() {
    let folder = Folder::new("file");
    let other = changed(|it| {
        it["name"] = "other".into();
        it["camera"]["fov"] = 20.into();
    });
    folder.write("one.json", floor().to_string());
    folder.write("two.json", format!("[{other}, {}]", floor()));
    let drawn = |name, call| {
        printed(&folder, &format!("{call} --size 16x12 --raw {name}"));
        folder.read(name)
    };
    let constant = drawn("constant", "floor");
    assert_eq!(constant, drawn("one", "one.json"));
    assert_eq!(constant, drawn("two", "two.json --scene floor"));
    assert_ne!(constant, drawn("other", "two.json --scene other"));
}

#[test]
fn file_without_a_name_is_called_after_the_file() {
    let folder = Folder::new("nameless");
    let scene = changed(|it| drop(it.as_object_mut().unwrap().remove("name")));
    folder.write("my floor.json", scene);
    let outcome = folder.run(&["my floor.json", "--size", "2x2"]);
    assert_eq!(outcome.code, 0, "{}", outcome.stderr);
    assert_eq!(folder.files(), ["my floor.json", "my floor.png"]);
}

#[test]
fn every_scene_shading_and_quality_renders() {
    let folder = Folder::new("all");
    for scene in scenes::NAMES {
        for shading in ["blinn-phong", "phong", "normals"] {
            for quality in ["fast", "small", "exact"] {
                let call = format!("{scene} --size 4x3 --shading {shading} --quality {quality}");
                let line = line_of_json(&folder, &format!("{call} --json"));
                assert_eq!(line["scene"], scene);
            }
        }
    }
}

#[test]
fn shadings_and_reflections_reach_the_picture() {
    let folder = Folder::new("settings");
    let calls = [
        "--shading blinn-phong",
        "--shading phong",
        "--shading normals",
        "--reflections 0",
        "--reflections 1",
    ];
    let mut pictures = Vec::new();
    for (number, call) in calls.into_iter().enumerate() {
        let call = format!("mirror1 --size 40x40 --raw {number} {call}");
        printed(&folder, &call);
        let picture = folder.read(&number.to_string());
        assert!(!pictures.contains(&picture), "{call}");
        pictures.push(picture);
    }
}

#[test]
fn wrong_arguments_are_named_in_one_line() {
    let folder = Folder::new("arguments");
    for size in ["0x5", "5x0", "65536x1", "5", "x", "5x5x5", "+5x5"] {
        let line = refused(&folder, &format!("--size {size}"));
        let sizes = "not a width and a height from 1 to 65535, such as 320x240";
        let expected = format!("invalid value '{size}' for '--size <WxH>': {sizes}");
        assert!(line.contains(&expected), "{size}: {line}");
    }
    for case in [
        "--reflections 256 => 256 is not in 0..=255",
        "--reflections -1 => -1 is not in 0..=255",
        "--reflections many => invalid digit found in string",
        "--shading gouraud => possible values: blinn-phong, phong, normals",
        "--quality best => possible values: fast, small, exact",
        "--dither rgb888 => possible values: rgb565, gray4, gray2, binary",
        "--out => a value is required for '--out <F.png>'",
        "--json --json => cannot be used multiple times",
        "--samples 4 => the following required arguments were not provided:; <--reference|--check>",
        "--needs --size 9x9 => cannot be used with '--size <WxH>'",
        "--bogus => unexpected argument '--bogus' found",
        "castle floor => unexpected argument 'floor' found",
        "sandcastle => there is no built-in scene sandcastle, only castle, ",
        "castle --scene floor => --scene chooses from a file, and castle is built in",
    ] {
        let (call, expected) = call_and_words(case);
        let line = refused(&folder, call);
        assert!(line.contains(expected), "{call}: {line}");
    }
    assert!(folder.files().is_empty());
}

#[test]
fn argument_of_two_lines_is_refused_in_one() {
    let folder = Folder::new("lines");
    for argument in ["two lines", "two lines.json", "--two lines", "--size=1 2"] {
        let Outcome { code, stderr, .. } = folder.run(&[&argument.replace(' ', "\n")]);
        assert_eq!((code, stderr.lines().count()), (2, 1), "{stderr}");
    }
}

#[test]
fn wrong_files_are_named_in_one_line() {
    let folder = Folder::new("files");
    let sphere = json!({ "center": [0, 0, 0], "radius": 0, "material": "white" });
    let small = changed(|it| it["spheres"] = json!([sphere]));
    let unknown = changed(|it| it["planes"][0]["material"] = "black".into());
    let closed = changed(|it| it["camera"]["fov"] = 0.into());
    folder.write("broken.json", "{\n  \"camera\": ]\n}");
    folder.write("empty.json", "[]");
    folder.write("small.json", &small);
    folder.write("unknown.json", unknown);
    folder.write("closed.json", closed);
    folder.write("two.json", format!("[{}, {small}]", floor()));
    folder.write("bytes.json", b"\xff\xfe\x00");
    fs::create_dir(folder.path("folder.json")).unwrap();
    for case in [
        "missing.json => ",
        "folder.json => ",
        "bytes.json => ",
        "broken.json => line 2, column 13: camera: a value is missing here",
        "empty.json => there is no scene in the file",
        "small.json => scene floor: spheres[0]: radius must be greater than 0",
        "unknown.json => scene floor: planes[0].material: there is no material black",
        "closed.json => scene floor: camera: fov must be between 0.001 and 179.999 degrees",
        "two.json => choose one of the scenes floor, floor (--scene NAME)",
        "two.json --scene floor => scene 1 has the name floor of scene 0",
        "two.json --scene roof => there is no scene roof, only floor, floor",
    ] {
        let (call, words) = call_and_words(case);
        let file = call.split(' ').next().unwrap();
        let line = refused(&folder, call);
        let start = format!("{file}: {words}");
        assert!(line.starts_with(&start), "{call}: {line}");
    }
    assert_eq!(folder.files().len(), 8, "nothing was written");
}

#[cfg(target_os = "linux")]
#[test]
fn picture_beyond_the_memory_is_refused() {
    let folder = Folder::new("memory");
    let outcome = folder.render_in_4_gigabytes("--size 65535x65535 --json");
    let words = "error: --size 65535x65535 needs 52 GB of memory\n";
    assert_eq!((outcome.code, &*outcome.stderr), (2, words));
}

#[test]
fn help_names_every_scene_and_option() {
    let folder = Folder::new("help");
    let help = printed(&folder, "--help");
    for name in scenes::NAMES {
        assert!(help.contains(name), "{name}");
    }
    let options = "scene size reflections shading quality dither out raw reference check needs json window version orbit gif frames watch";
    for option in options.split(' ') {
        assert!(help.contains(&format!("--{option}")), "{option}");
    }
}

#[test]
fn reader_that_leaves_early_is_no_error() {
    let folder = Folder::new("pipe");
    let json = "floor --size 2x2 --json";
    for call in [json, "floor --needs", "--help", "--version"] {
        let outcome = folder.render_unread(call);
        assert_eq!((outcome.code, outcome.stderr.as_str()), (0, ""), "{call}");
    }
}

#[cfg(unix)]
#[test]
fn device_may_be_written_to() {
    let folder = Folder::new("device");
    printed(&folder, "floor --size 2x2 --out /dev/null --raw /dev/zero");
}

#[cfg(target_os = "linux")]
#[test]
fn disk_that_is_full_is_named() {
    let folder = Folder::new("full");
    let line = refused(&folder, "floor --size 2x2 --raw /dev/full");
    let expected = "/dev/full cannot be written: No space left";
    assert!(line.starts_with(expected), "{line}");
}

#[test]
fn option_without_its_feature_names_it() {
    let folder = Folder::new("features");
    for (option, feature, is_on) in [
        ("--orbit 4 --gif a.gif", "film", cfg!(feature = "film")),
        ("--window", "window", cfg!(feature = "window")),
    ] {
        if !is_on {
            let line = refused(&folder, option);
            let option = option.split(' ').next().unwrap();
            let expected = format!("{option} needs the feature `{feature}`: cargo run ");
            assert!(line.starts_with(&expected), "{line}");
        }
    }
}
