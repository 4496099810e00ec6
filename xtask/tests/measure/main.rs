//! `cargo xtask measure` and `cargo xtask scene`, as a user calls them.

use std::{collections::BTreeSet, fs, path::Path, process::Command};

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use serde_json::Value;
use xtask::measure::{
    CORES, Core, Figures, Quality, Scene, Size, Task, build_profile::BuildProfile, count, outcome,
    profiles, record, units, yardstick,
};

#[path = "../common/mod.rs"]
mod common;

use common::Done;

const SCENES: &str = r#"[
    {
        "name": "ball",
        "camera": { "position": [0, -5, 2], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 50 },
        "materials": [
            { "name": "gold", "color": [0.7, 0.6, 0], "ambient": 0.2, "diffuse": 0.4,
              "specular": 0.8, "shininess": 4, "mirror": 0.4 },
            { "name": "unused", "color": [1, 1, 1], "ambient": 1, "diffuse": 0,
              "specular": 0, "shininess": 1, "mirror": 0 }
        ],
        "lights": [ { "position": [3, -4, 6.125], "color": [1, 1, 1] } ],
        "spheres": [ { "center": [0, 0, 1], "radius": 1, "material": "gold" } ],
        "planes": [ { "center": [0, 0, 0], "normal": [0, 0, 1], "material": "gold" } ],
        "cylinders": [
            { "center": [2, 0, 1], "axis": [0, 0, 1], "radius": 0.5, "height": 2e-1,
              "material": "gold" }
        ],
        "discs": [ { "center": [2, 0, 1.1], "normal": [0, 0, 1], "radius": 0.5, "material": "gold" } ],
        "background": [0.25, 0.5, 1],
        "epsilon": 0.0005
    },
    {
        "name": "nothing",
        "camera": { "position": [0, -5, 2], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 50 }
    }
]"#;

fn in_folder<T>(call: impl FnOnce(&Path) -> T) -> T {
    let folder = tempfile::tempdir().unwrap();
    fs::write(folder.path().join("scenes.json"), SCENES).unwrap();
    fs::write(folder.path().join("broken.json"), "{\n").unwrap();
    call(folder.path())
}

fn xtask(arguments: &str) -> Done {
    in_folder(|folder| common::xtask(folder, arguments))
}

fn measured(arguments: &str) -> Value {
    let done = xtask(&format!("measure --json {arguments}"));
    assert_eq!((done.code, done.err.as_str()), (0, ""));
    assert_eq!(done.out.lines().count(), 1);
    serde_json::from_str(&done.out).unwrap()
}

#[test]
fn json_has_these_keys_and_the_defaults() {
    let figures = measured("");
    let keys = figures.as_object().unwrap().keys().map(String::as_str);
    let expected = "core scene size reflections shading quality instructions_per_pixel \
                    prepare_instructions worst_row_instructions worst_row flash ram stack hash \
                    cycles_per_pixel";
    assert_eq!(keys.collect::<BTreeSet<_>>(), expected.split(' ').collect());
    let settings = ["core", "scene", "size", "reflections", "shading", "quality"];
    let settings = settings.map(|key| figures[key].to_string()).join(" ");
    assert_eq!(settings, r#""m3" "castle" "64x64" 4 "blinn-phong" "fast""#);
    let number = |key: &str| figures[key].as_f64().unwrap();
    let (instructions, cycles) = (number("instructions_per_pixel"), number("cycles_per_pixel"));
    assert!(instructions > 10.0);
    assert!((1.2..2.5).contains(&(cycles / instructions)));
    assert_eq!(figures["hash"].as_str().unwrap().len(), 16);
}

/// On each kind of clock: the timers of two boards, and the core's own count.
#[test]
fn worst_row_is_at_least_the_mean_and_at_most_the_frame() {
    for core in ["m3", "m33", "rv32"] {
        let core = Core::find(core).unwrap();
        let size = Size::new(64, 64);
        // Small firmware: the clocks are what is tested.
        let task = Task::new(core, Scene::BuiltIn("floor"), size, Quality::FAST);
        let outcome = outcome(&task).unwrap();
        let (worst_row, worst) = outcome.worst_row;
        assert!(worst_row < 64 && worst <= outcome.halves[worst_row as usize % 2]);
        let drawing = outcome.drawing();
        assert!(64 * worst >= drawing && worst <= drawing, "{outcome:?}");
    }
}

#[test]
fn only_row_of_a_frame_is_the_worst_one() {
    let figures = measured("floor --size 64x1");
    let count = |key: &str| figures[key].as_f64().unwrap();
    assert_eq!(figures["worst_row"], 0);
    let frame = count("prepare_instructions") + count("worst_row_instructions");
    // Which is rounded to a tenth.
    assert!((frame / 64.0 - count("instructions_per_pixel")).abs() < 0.051);
}

#[test]
fn same_measurement_comes_to_the_same_figures() {
    let settings = "mirror1 --size 17x9 --reflections 7 --shading phong --quality exact";
    let figures = measured(settings);
    assert_eq!(figures, measured(settings));
    assert_eq!(figures["reflections"], 7);
    assert_eq!(figures["shading"], "phong");
    assert_eq!(figures["quality"], "exact");
}

#[test]
fn table_names_what_it_shows() {
    let done = xtask("measure empty --size 8x8 --shading normals");
    let [head, row] = [0, 1].map(|line| done.out.lines().nth(line).unwrap());
    assert!(head.starts_with("core  scene  size"), "{head}");
    assert!(row.starts_with("m3    empty  8x8"), "{row}");
}

#[test]
fn scene_of_a_file_is_measured() {
    let figures = measured("scenes.json --scene ball --size 16x16");
    assert_eq!(figures["scene"], "ball");
    // A scene with all kinds of shapes takes more than the empty one.
    let nothing = measured("scenes.json --scene nothing --size 16x16");
    let instructions = |figures: &Value| figures["instructions_per_pixel"].as_f64().unwrap();
    assert!(instructions(&figures) > 2.0 * instructions(&nothing));
    assert_ne!(figures["hash"], nothing["hash"]);
}

#[test]
#[ignore = "long: compiles all that a further core needs"]
fn float_port_is_measured_by_the_same_command() {
    let figures = measured("--core m4f mirror1 --size 16x16 --quality float");
    assert_eq!(figures["quality"], "float");
    let per_pixel = figures["instructions_per_pixel"].as_f64().unwrap();
    // With roots in software it would be far above.
    assert!((500.0..3000.0).contains(&per_pixel), "{per_pixel}");
}

#[test]
fn scene_file_becomes_source_that_rustfmt_leaves_alone() {
    let done = xtask("scene scenes.json --scene ball");
    assert_eq!((done.code, done.err.as_str()), (0, ""));
    let expected = Path::new(env!("CARGO_MANIFEST_DIR")).join("tests/measure/ball.rs");
    assert_eq!(done.out, fs::read_to_string(&expected).unwrap());
    let rustfmt = Command::new("rustfmt")
        .args(["--edition", "2024", "--check"])
        .arg(expected)
        .status();
    assert!(rustfmt.unwrap().success());
}

/// What the command made of the file above: that it is here means that it compiles.
mod ball;

#[test]
fn source_describes_the_scene_of_the_file() {
    use reflet::host::file::SceneFile;

    let file = SceneFile::parse(SCENES, Some("ball")).unwrap();
    let (scene, camera) = file.runtime().unwrap();
    assert_eq!(camera, ball::CAMERA);
    let described = ball::Ball::with_description(|scene| scene.camera);
    assert_eq!(described, Some(camera));
    let size = Size::new(40, 30);
    let (mut one, mut other) = ([Rgb888::BLACK; 40], [Rgb888::BLACK; 40]);
    let scene = Box::new(scene.build().unwrap());
    let fixed = ball::Ball::frame(&camera).prepare(size);
    let fixed = fixed.on(&ball::Ball).unwrap();
    let filled = scene.frame(&camera).prepare(size);
    let filled = filled.on(&scene).unwrap();
    for y in 0..30 {
        fixed.row(y, 0, &mut one);
        filled.row(y, 0, &mut other);
        assert_eq!(one, other, "row {y}");
    }
}

#[test]
fn mistakes_are_one_line_and_exit_code_2() {
    let mistakes = "
measure --core m5 => invalid value 'm5' for '--core <CORE>'
measure --size 0x3 => not a width and a height from 1 to 65535
measure --size 3 => not a width and a height from 1 to 65535
measure --reflections 256 => 256 is not in 0..=255
measure --reflections -1 => -1 is not in 0..=255
measure --shading flat => invalid value 'flat' for '--shading <SHADING>'
measure --quality best => invalid value 'best' for '--quality <QUALITY>'
measure sandcastle => there is no built-in scene sandcastle, only castle,
measure castle --scene ball => --scene chooses from a file
measure missing.json => missing.json: No such file or directory
measure broken.json => broken.json: line 2, column 0: the file ends too early
measure scenes.json => scenes.json: choose one of the scenes ball, nothing (--scene NAME)
measure --all castle => cannot be used with
measure --profiles --core m3 => cannot be used with
measure --units --quality exact => cannot be used with
measure --everything => unexpected argument '--everything' found
scene => the following required arguments were not provided
scene missing.json => missing.json: No such file or directory
scene scenes.json => scenes.json: choose one of the scenes ball, nothing (--scene NAME)
scene scenes.json --name ball => unexpected argument '--name' found
board sandcastle => invalid value 'sandcastle' for '[SCENE]'
pico --screenshot a.jpg => a.jpg: pictures are written as PNG only: name it
size --scene castle => unexpected argument '--scene' found
scene scenes.json --scene x => scenes.json: there is no scene x, only ball, nothing
dance => unrecognized subcommand 'dance'";
    in_folder(|folder| common::assert_mistakes(folder, mistakes));
}

#[test]
fn kept_figures_of_the_default_quality_are_within_2_percent() {
    let tasks = record::tasks(Core::M3);
    assert_are_kept(record::read(Core::M3), &tasks, |task| {
        task.settings.quality == Quality::FAST
    });
}

#[test]
#[ignore = "long: all figures of docs/measured, on every core"]
fn kept_figures_of_all_cores_are_within_2_percent() {
    for core in &CORES {
        assert_are_kept(record::read(core), &record::tasks(core), |_| true);
    }
}

#[test]
fn kept_figures_beside_published_ones_are_within_2_percent() {
    assert_yardsticks_are_kept(|task| {
        task.core == Core::M3 && ["four_spheres", "pybadge0"].contains(&task.scene.name())
    });
}

#[test]
#[ignore = "long: every scene after a published ray tracer, on two cores"]
fn all_kept_figures_beside_published_ones_are_within_2_percent() {
    assert_yardsticks_are_kept(|_| true);
}

fn assert_yardsticks_are_kept(is_meant: impl Fn(&Task) -> bool) {
    assert_are_kept(yardstick::read(), &yardstick::tasks().unwrap(), is_meant);
}

#[test]
fn kept_costs_of_units_are_within_2_percent() {
    let (kept, found) = (units::read().unwrap(), units::measured(Core::M3).unwrap());
    assert_eq!(kept.len(), found.len());
    for (kept, found) in kept.iter().zip(&found) {
        let is_close = (found.instructions - kept.instructions).abs() <= 0.02 * kept.instructions;
        assert!(
            found.unit == kept.unit && is_close,
            "`cargo xtask measure --units --core m3` has to be run again: {found:?}, kept {kept:?}"
        );
    }
}

#[test]
fn kept_figures_of_the_recommended_profile_are_within_2_percent() {
    assert_profiles_are_kept(|task| task.profile == BuildProfile::RECOMMENDED);
}

#[test]
#[ignore = "long: every build profile"]
fn kept_figures_of_all_profiles_are_within_2_percent() {
    assert_profiles_are_kept(|_| true);
}

/// Measures again the profiles that are meant, and compares them with what the repository keeps.
fn assert_profiles_are_kept(is_meant: impl Fn(&Task) -> bool) {
    let (tasks, rows) = (profiles::tasks(), profiles::read().unwrap());
    let names = rows.iter().map(|row| &*row.profile);
    assert!(names.eq(tasks.iter().map(|task| task.profile.name)));
    let kept = rows.into_iter().map(|row| row.figures).collect();
    assert_are_kept(Ok(kept), &tasks, is_meant);
}

/// Measures again what `is_meant`, and compares it with what the repository keeps.
fn assert_are_kept(
    kept: anyhow::Result<Vec<Figures>>,
    tasks: &[Task],
    is_meant: impl Fn(&Task) -> bool,
) {
    let kept = kept.unwrap_or_else(|error| panic!("{error:#}"));
    assert_eq!(kept.len(), tasks.len());
    let mut off = String::new();
    for (task, kept) in tasks.iter().zip(&kept).filter(|(task, _)| is_meant(task)) {
        let found = count(task).unwrap_or_else(|error| panic!("{error:#}"));
        if !is_within_2_percent(kept, &found) {
            let [kept, found] = [kept, &found].map(|figures| figures.json().unwrap());
            off += &format!("\nkept  {kept}\nfound {found}");
        }
    }
    assert!(
        off.is_empty(),
        "the command that wrote these figures has to be run again and what it writes committed:{off}"
    );
}

/// Counts may be 2 % off; settings and pictures have to be the same. The estimate of cycles follows
/// from the counts.
fn is_within_2_percent(kept: &Figures, found: &Figures) -> bool {
    let counts = |figures: &Figures| {
        [
            figures.instructions_per_pixel,
            figures.worst_row_instructions as f64,
            figures.flash as f64,
            figures.ram as f64,
            figures.stack as f64,
        ]
    };
    let rest = |figures: &Figures| Figures {
        instructions_per_pixel: 0.0,
        prepare_instructions: 0,
        worst_row_instructions: 0,
        // Of rows that take nearly the same, another one may be the worst.
        worst_row: 0,
        flash: 0,
        ram: 0,
        stack: 0,
        cycles_per_pixel: None,
        ..figures.clone()
    };
    let mut pairs = counts(kept).into_iter().zip(counts(found));
    rest(kept) == rest(found) && pairs.all(|(kept, found)| (kept - found).abs() <= 0.02 * found)
}

#[test]
fn castle_240_pixels_wide_needs_at_most_9_kib_on_m0() {
    // The size for which frames a second are estimated, too: one firmware serves both.
    let figures = measured("--core m0 --size 240x240");
    let bytes = |key: &str| figures[key].as_u64().unwrap();
    // And a row of three bytes a pixel, though a display that takes pixels as they come needs none.
    let ram = bytes("ram") + bytes("stack") + 3 * 240;
    assert!(ram <= 9 * 1024, "{ram} bytes");
}
