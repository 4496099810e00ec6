//! Tests that a firmware contains only what its scene needs, and that no scene has outgrown its
//! budget.

use std::{collections::BTreeSet, thread};

use reflet::{needs::Needs, scenes};
use serde_json::{Value, json};
use xtask::measure::{
    Core, Quality, Scene, Shading, Size, Task, count, weigh, weight, with_program,
};
use xtask::profile::names::Names;
use xtask::{board, root, size, toolchain};

mod common;

/// Returns a scene with one of everything; the tests remove parts of it.
fn scene() -> Value {
    json!({
        "name": "all",
        "camera": { "position": [0, -5, 2], "target": [0, 0, 1], "up": [0, 0, 1], "fov": 50 },
        "materials": [
            { "name": "gold", "color": [0.7, 0.6, 0], "ambient": 0.2, "diffuse": 0.4,
              "specular": 0.8, "shininess": 2.5, "mirror": 0.4 },
            { "name": "chalk", "color": [0.9, 0.9, 0.8], "ambient": 0.2, "diffuse": 0.8,
              "specular": 0.1, "shininess": 2.5, "mirror": 0.4 }
        ],
        "lights": [ { "position": [3, -4, 6.125], "color": [1, 1, 1] } ],
        "spheres": [ { "center": [0, 0, 1], "radius": 1, "material": "gold" } ],
        "planes": [ { "center": [0, 0, 0], "normal": [0, 0, 1], "material": "chalk" } ],
        "cylinders": [
            { "center": [2, 0, 1], "axis": [0, 0, 1], "radius": 0.5, "height": 2,
              "material": "gold" }
        ]
    })
}

/// Returns the scene with another value for one key of every material.
fn with_material(mut scene: Value, key: &str, value: &Value) -> Value {
    for material in scene["materials"].as_array_mut().unwrap() {
        material[key] = value.clone();
    }
    scene
}

fn without(mut scene: Value, list: &str) -> Value {
    scene[list] = json!([]);
    scene
}

fn task(scene: Scene, quality: Quality, shading: Shading) -> Task {
    // Measured like the stored figures, so that both use the same firmware images.
    let mut task = Task::new(Core::M3, scene, Size::new(64, 64), quality);
    task.settings.shading = shading;
    task
}

/// Returns the contents of a scene's firmware: the names of its functions, inlined ones too, and its
/// size in flash.
fn linked(scene: &Value, quality: Quality, shading: Shading) -> (BTreeSet<String>, u64) {
    let scene = Scene::parse(&scene.to_string()).unwrap();
    with_program(&task(scene, quality, shading), |program| {
        Ok((Names::read(program)?.all()?, weigh(program)?.flash))
    })
    .unwrap()
}

#[test]
fn code_for_what_a_scene_has_not_is_not_in_its_firmware() {
    let (fast, phong) = (Quality::FAST, Shading::BlinnPhong);
    let all = linked(&scene(), fast, phong);
    // A coefficient of all materials, lists that the scene lacks, and names that no function has then.
    let lacking = "
specular 0 spheres => shape::sphere:: half_way_square
shininess 3 planes => shape::plane:: fractional_power
shininess 4 cylinders => shape::cylinder:: highlight::power_of
mirror 0 lights => shade::sent_on Surface::reflect
mirror 1 => lit_color
mirror 0.4 spheres cylinders => occluded";
    let has = |names: &BTreeSet<String>, part: &str| names.iter().any(|name| name.contains(part));
    for line in lacking.trim().lines() {
        let (scene_lacks, parts) = line.split_once(" => ").unwrap();
        let mut words = scene_lacks.split(' ');
        let (key, value) = (words.next().unwrap(), words.next().unwrap());
        let value = value.parse::<f64>().unwrap().into();
        let scene = with_material(words.fold(scene(), without), key, &value);
        let (names, flash) = linked(&scene, fast, phong);
        for part in parts.split_whitespace() {
            assert!(has(&all.0, part), "{part} is not found where it is needed");
            let left: Vec<_> = names.iter().filter(|name| name.contains(part)).collect();
            assert!(left.is_empty(), "{part}: {left:?}");
        }
        assert!(flash < all.1, "{parts}: {flash} bytes, not below {}", all.1);
    }

    // No light of the scene falls off.
    let mut fading = scene();
    fading["lights"][0]["range"] = 2.5.into();
    let (fading, _) = linked(&fading, fast, phong);
    assert!(has(&fading, "light::falloff") && !has(&all.0, "light::falloff"));

    // Shadings and qualities that the scene does not use.
    assert!(!has(&all.0, "color::halved") && has(&all.0, "Colors<W,K,Q,M>::follow"));
    let (normals, flash) = linked(&scene(), fast, Shading::Normals);
    assert!(has(&normals, "color::halved") && !has(&normals, "lit_color"));
    assert!(flash < all.1);
    let (small, flash) = linked(&scene(), Quality::SMALL, phong);
    let left_out = "Colors<W,K,Q,M>::follow accel::active_list accel::screen_ SphereFromPoint";
    for part in left_out.split(' ') {
        assert!(has(&all.0, part) && !has(&small, part), "{part}");
    }
    assert!(flash < all.1);
}

#[test]
fn empty_scene_has_nothing_but_the_loop_that_writes_the_background() {
    let scene = Scene::BuiltIn("empty");
    let rooms = "shape:: shade::lit camera:: root:: interpolate::Colors Tracer";
    for quality in [Quality::FAST, Quality::SMALL] {
        let task = task(scene.clone(), quality, Shading::BlinnPhong);
        let names = with_program(&task, |program| Names::read(program)?.all()).unwrap();
        for room in rooms.split(' ') {
            let left: Vec<_> = names.iter().filter(|name| name.contains(room)).collect();
            assert!(left.is_empty(), "{left:?}");
        }
        let flash = weight(&task).unwrap().flash;
        // Two thirds of this are the firmware's own loop over the pixels, which the compiler
        // unrolls.
        assert!(flash < 1536, "{flash} bytes");
    }
}

/// Leaving code out costs no instructions: a scene takes at most 1 % more than with everything
/// linked, and in fact takes fewer.
#[test]
fn scenes_are_not_slower_than_with_everything_linked() {
    are_not_slower_than_with_everything(&["castle", "floor"]);
}

#[test]
#[ignore = "long: the same of all scenes"]
fn no_scene_is_slower_than_with_everything_linked() {
    are_not_slower_than_with_everything(&scenes::NAMES);
}

fn are_not_slower_than_with_everything(names: &[&'static str]) {
    for name in names {
        let mut task = task(Scene::BuiltIn(name), Quality::FAST, Shading::BlinnPhong);
        let own = count(&task).unwrap();
        task.settings.is_whole = true;
        let whole = count(&task).unwrap();
        assert_eq!(own.hash, whole.hash, "{name}");
        let [own, whole] = [own, whole].map(|it| it.instructions_per_pixel);
        let most = 1.01 * whole;
        assert!(own <= most, "{name}: {own}, with everything {whole}");
    }
}

/// Largest flash of some scenes on thumbv7m, whatever the budget says: scene, quality, reflections
/// and bytes.
const LIMITS: [(&str, Quality, u8, u64); 5] = [
    ("floor", Quality::FAST, 4, 12 * 1024),
    ("corner1", Quality::SMALL, 4, 7 * 1024 + 512),
    ("shading_lights", Quality::SMALL, 0, 9 * 1024 + 256),
    ("castle", Quality::FAST, 4, 53 * 1024),
    // Of these, 1 KB are lists that halve its instructions.
    ("castle", Quality::SMALL, 4, 15 * 1024),
];

#[test]
fn no_scene_has_grown_beyond_its_budget() {
    let (tasks, kept) = (size::tasks(), size::kept().unwrap());
    let mut pairs = tasks.iter().zip(&kept);
    let is_complete = tasks.len() == kept.len() && pairs.all(|(task, kept)| kept.are_of(task));
    assert!(is_complete, "`cargo xtask size` has to be run again");
    for (scene, quality, reflections, most) in LIMITS {
        let mut task = task(Scene::BuiltIn(scene), quality, Shading::BlinnPhong);
        task.settings.reflections = reflections;
        let flash = weight(&task).unwrap().flash;
        let words = format!("{scene} {quality:?}: {flash} bytes, not {most}");
        assert!(flash <= most, "{words}");
    }
    // The larger code is measured where its instructions are counted.
    assert_have_not_grown(|task| {
        let settings = task.settings;
        let is_small = settings.reflections == 4 && settings.quality == Quality::SMALL;
        task.core.name == "m3" && is_small
    });
}

#[test]
#[ignore = "long: every scene, quality and target of docs/sizes.md"]
fn nothing_has_grown_beyond_its_budget() {
    assert_have_not_grown(|_| true);
}

/// Measures the tasks for which `is_meant` holds again, each target in its own thread.
fn assert_have_not_grown(is_meant: impl Fn(&Task) -> bool + Sync) {
    let (tasks, kept) = (size::tasks(), size::kept().unwrap());
    let of_target = |target: &str| {
        let pairs = tasks.iter().zip(&kept);
        let pairs = pairs.filter(|(task, _)| task.core.target == target && is_meant(task));
        let excesses = pairs.filter_map(|(task, kept)| kept.excess(task).unwrap());
        excesses.collect::<Vec<_>>()
    };
    let grown = thread::scope(|scope| {
        let of_target = &of_target;
        let threads =
            [toolchain::M0, toolchain::M3].map(|target| scope.spawn(move || of_target(target)));
        threads.map(|thread| thread.join().unwrap()).concat()
    });
    assert!(
        grown.is_empty(),
        "say why in the commit, and run `cargo xtask size`:\n{}",
        grown.join("\n")
    );
}

#[test]
fn whole_firmware_of_the_castle_is_below_68_kib() {
    let program = board::build_example(size::BOARD).unwrap();
    let weight = weigh(&program).unwrap();
    assert!(weight.flash <= 68 * 1024, "{} bytes", weight.flash);
    // This firmware does not dither. xtask/no_panic shows that these names are found in a firmware
    // that does.
    let names = Names::read(&program).unwrap().all().unwrap();
    let has = |part| names.iter().any(|name| name.contains(part));
    assert!(has("render::prepared::Rows") && !has("display::dither::"));
}

#[test]
fn command_prints_lines_of_json_with_these_keys() {
    let arguments = "size --json empty --target thumbv7m-none-eabi";
    let done = common::xtask(&root(), arguments);
    assert_eq!(done.code, 0, "{}", done.err);
    let lines = done.out.lines().map(serde_json::from_str);
    let lines: Vec<Value> = lines.map(Result::unwrap).collect();
    assert_eq!(lines.len(), size::QUALITIES.len());
    for line in lines {
        let keys = line.as_object().unwrap().keys().map(String::as_str);
        let expected = "target scene quality reflections code constants flash ram stack left_out";
        assert_eq!(keys.collect::<BTreeSet<_>>(), expected.split(' ').collect());
        let left_out = line["left_out"].as_array().unwrap();
        assert_eq!(left_out.len(), Needs::ALL.list().len());
        let bytes = |key: &str| line[key].as_u64().unwrap();
        assert_eq!(bytes("code") + bytes("constants"), bytes("flash"));
    }
}
