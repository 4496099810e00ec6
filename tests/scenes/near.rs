//! Scenes that tests fill, their pictures, and how near these are to double precision. Knows no scene.

use embedded_graphics::prelude::Size;
use reflet::display::AnyScene;
use reflet::host::compare::{Difference, compare};
use reflet::host::file::FileRuntimeScene;
use reflet::host::painted;
use reflet::host::reference::{self, Picture, render};
use reflet::quality::{Exact, Fast, Quality, Small};
use reflet::shading::Shading;
use reflet::{Camera, FrameBuilder};

/// A scene with room for all that a test needs. The crate `command_line` draws the same type, so that no test compiles
/// the renderer again for it.
pub type Scenery = FileRuntimeScene;

pub const UP: [f64; 3] = [0.0, 0.0, 1.0];

/// Draws a scene with four reflections.
pub fn drawn<Q: Quality, K: Shading>(
    scene: &impl AnyScene,
    camera: &Camera,
    size: Size,
) -> Picture {
    let frame = FrameBuilder::new(scene, camera);
    let frame = frame.quality::<Q>().shading::<K>().prepare(size);
    painted(&frame.on(scene).unwrap())
}

/// The smallest share of pixels that are equal to the reference, that of pixels within 1 of it, and the smallest PSNR.
pub type Bar = [f64; 3];

pub fn is_met([same, within1, psnr]: Bar, found: &Difference) -> bool {
    found.same >= same && found.within1 >= within1 && found.psnr >= psnr
}

/// Checks how near a scene is to the reference in the qualities `Fast`, `Small` and `Exact`. Returns the pictures.
#[track_caller]
pub fn assert_near<K: Shading>(
    (scene, camera): (&Scenery, &Camera),
    size: Size,
    shading: reference::Shading,
    bars: [Bar; 3],
) -> [Picture; 3] {
    let exact = reference::Scene::from(&scene.description());
    let truth = render(&exact, &camera.into(), size.width, size.height, 4, shading);
    let built = scene.build().unwrap();
    let pictures = [
        drawn::<Fast, K>(&built, camera, size),
        drawn::<Small, K>(&built, camera, size),
        drawn::<Exact, K>(&built, camera, size),
    ];
    let names = ["fast", "small", "exact"].into_iter().zip(bars);
    for ((name, bar), picture) in names.zip(&pictures) {
        let found = compare(picture, &truth).unwrap();
        println!("{name}: {found:?}");
        assert!(is_met(bar, &found), "{name}: {found:?}");
    }
    pictures
}

/// Returns the number of pixels that differ by more than `most` in a channel.
pub fn apart(one: &Picture, other: &Picture, most: u8) -> usize {
    let pairs = one.pixels.iter().zip(&other.pixels);
    let differ = |(one, other): &(&[u8; 3], &[u8; 3])| {
        one.iter().zip(*other).any(|(a, b)| a.abs_diff(*b) > most)
    };
    pairs.filter(differ).count()
}
