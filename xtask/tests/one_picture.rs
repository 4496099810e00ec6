//! Tests that a frame is the same, to the bit, on the machine that runs the tests and on every core.
//! On the cores the scenes are constants, here they are filled at run time.

use std::thread;

use command_line::{Quality, Settings, Source};
use frame_hash::FrameHash;
use reflet::scenes;
use xtask::measure::{CORES, Core, Scene, Size};
use xtask::sweep::{Count, Setting, Sweep};

const SIDE: u32 = 64;

/// Returns the hash of a picture that is drawn here.
fn hash(name: &str, quality: Quality) -> u64 {
    let source = Source::built_in(name).unwrap();
    let settings = Settings::blinn_phong(quality, 4);
    FrameHash::of(source.drawn(Size::new_equal(SIDE), settings).pixels)
}

/// Checks that a core and this machine draw the same pictures.
fn are_the_same_pictures_as_here(core: &str, pictures: &[(&'static str, Quality)]) {
    let core = Core::find(core).expect("it is in the list");
    let scenes = pictures.iter().map(|&(name, quality)| {
        let setting = Setting {
            quality,
            reflections: 4,
            scale: 1,
        };
        (Scene::BuiltIn(name), vec![setting])
    });
    let sweep = Sweep {
        core,
        size: Size::new_equal(SIDE),
        scenes: scenes.collect(),
    };
    let mut pictures = pictures.iter();
    let compare = |there: Count| {
        let &(name, quality) = pictures.next().expect("a picture for each count");
        let here = hash(name, quality);
        assert_eq!(there.hash, here, "{} {name}, {quality:?}", core.name);
    };
    let swept = sweep.run(compare);
    swept.unwrap_or_else(|error| panic!("{error:#}"));
    assert_eq!(pictures.next(), None);
}

/// Pictures of an M4F and an M33 are compared by xtask/tests/boards: the Black Pill's and the Pico 2's. Those
/// of an M3 are the kept ones, which xtask/tests/measure draws again.
#[test]
fn every_core_draws_the_same_pictures() {
    let pictures = [
        ("castle", Quality::Fast),
        ("mirror1", Quality::Fast),
        ("columns", Quality::Small),
        ("primitives", Quality::Fast),
        ("shading_lights", Quality::Exact),
    ];
    // A core is emulated while the firmware for the next one is built.
    thread::scope(|scope| {
        for core in ["m0", "rv32"] {
            scope.spawn(|| are_the_same_pictures_as_here(core, &pictures));
        }
    });
}

#[test]
#[ignore = "long: all scenes in all qualities, on every core"]
fn every_core_draws_every_scene_in_every_quality() {
    let qualities = [Quality::Fast, Quality::Small, Quality::Exact];
    for core in CORES {
        for name in scenes::NAMES {
            are_the_same_pictures_as_here(core.name, &qualities.map(|quality| (name, quality)));
        }
    }
}
