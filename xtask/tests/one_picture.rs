//! Tests that a frame is the same, to the bit, on the machine that runs the tests and on every core.

use std::thread;

use embedded_graphics::geometry::Size;
use frame_hash::FrameHash;
use reflet::host::painted;
use reflet::quality::{Draft, Exact, Fast, Fine, Quality as Exactness, Small};
use reflet::scenes;
use reflet::scenes::{BuiltIn, Visitor};
use xtask::measure::{CORES, Core, Quality, Scene, Size as Pixels, Task, count};

const SIDE: u32 = 64;

struct Hash(Quality);

impl Visitor for Hash {
    type Output = String;

    fn visit<S: BuiltIn>(self) -> String {
        match self.0 {
            Quality::DRAFT => hash::<S, Draft>(),
            Quality::FAST => hash::<S, Fast>(),
            Quality::FINE => hash::<S, Fine>(),
            Quality::SMALL => hash::<S, Small>(),
            Quality::EXACT => hash::<S, Exact>(),
            Quality::Float => unreachable!("floats are another matter"),
        }
    }
}

fn hash<S: BuiltIn, Q: Exactness>() -> String {
    let size = Size::new_equal(SIDE);
    let frame = S::frame(&S::CAMERA).reflections(4).quality::<Q>();
    let mut hash = FrameHash::NONE;
    let frame = frame.prepare(size);
    let picture = painted(&frame.on(S::INSTANCE).unwrap());
    picture.pixels.into_iter().for_each(|pixel| hash.add(pixel));
    format!("{:016x}", hash.value())
}

/// Checks that a core and this machine draw the same pictures of scenes, in some qualities.
fn are_the_same_pictures_as_here(core: &str, pictures: &[(&'static str, &[Quality])]) {
    let core = Core::find(core).expect("it is in the list");
    for (name, qualities) in pictures {
        for &quality in *qualities {
            let size = Pixels::new(SIDE, SIDE);
            let task = Task::new(core, Scene::BuiltIn(name), size, quality);
            let figures = count(&task).unwrap_or_else(|error| panic!("{error:#}"));
            let here = scenes::visit(name, Hash(quality)).expect("it is in the list");
            assert_eq!(figures.hash, here, "{} {name}, {quality:?}", core.name);
        }
    }
}

#[test]
fn every_core_draws_the_same_pictures() {
    let cores = ["m0", "m3", "m4f", "m33", "rv32"];
    let pictures = [
        ("castle", &[Quality::FAST][..]),
        ("mirror1", &[Quality::FINE]),
        ("columns", &[Quality::SMALL]),
        ("primitives", &[Quality::DRAFT]),
    ];
    // Each core has its own target, so their builds do not wait for each other.
    thread::scope(|scope| {
        for core in cores {
            scope.spawn(|| are_the_same_pictures_as_here(core, &pictures));
        }
    });
}

#[test]
#[ignore = "long: all scenes in all qualities, on every core"]
fn every_core_draws_every_scene_in_every_quality() {
    let qualities = [
        Quality::DRAFT,
        Quality::FAST,
        Quality::FINE,
        Quality::SMALL,
        Quality::EXACT,
    ];
    let pictures = scenes::NAMES.map(|name| (name, &qualities[..]));
    for core in CORES {
        are_the_same_pictures_as_here(core.name, &pictures);
    }
}
