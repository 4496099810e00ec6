//! A frame is the same, to the bit, on the machine that runs the tests and on every core.

use embedded_graphics::geometry::Size;
use frame_hash::FrameHash;
use reflet::{
    Exact, Fast, Fine, Quality as Exactness, Small,
    host::painted,
    scenes::{self, BuiltIn, Visitor},
};
use xtask::measure::{
    cores::Core,
    count,
    scene::Scene,
    task::{Quality, Size as Pixels, Task},
};

const SIDE: u32 = 64;

/// The hash of a scene's frame, drawn here.
struct Hash(Quality);

impl Visitor for Hash {
    type Output = String;

    fn visit<S: BuiltIn>(self) -> String {
        match self.0 {
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
    let picture = painted(&frame.sized(size));
    picture.pixels.into_iter().for_each(|pixel| hash.add(pixel));
    format!("{:016x}", hash.value())
}

fn is_the_same_picture_as_here(core: &str) {
    let core = Core::find(core).expect("it is in the list");
    let (fast, fine) = (Quality::FAST, Quality::FINE);
    let pictures = [
        ("castle", &[fast, fine, Quality::SMALL][..]),
        ("mirror1", &[fast, fine]),
        ("columns", &[fast]),
    ];
    for (name, qualities) in pictures {
        for &quality in qualities {
            let size = Pixels::new(SIDE, SIDE);
            let task = Task::new(core, Scene::BuiltIn(name), size, quality);
            let figures = count(&task).unwrap_or_else(|error| panic!("{error:#}"));
            let here = scenes::visit(name, Hash(quality)).expect("it is in the list");
            assert_eq!(figures.hash, here, "{name}, {quality:?}");
        }
    }
}

#[test]
fn cortex_m0_draws_the_same_picture() {
    is_the_same_picture_as_here("m0");
}

#[test]
fn cortex_m3_draws_the_same_picture() {
    is_the_same_picture_as_here("m3");
}

#[test]
fn cortex_m4f_draws_the_same_picture() {
    is_the_same_picture_as_here("m4f");
}

#[test]
fn cortex_m33_draws_the_same_picture() {
    is_the_same_picture_as_here("m33");
}

#[test]
fn rv32imac_draws_the_same_picture() {
    is_the_same_picture_as_here("rv32");
}
