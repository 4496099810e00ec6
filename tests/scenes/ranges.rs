//! Tests lights that fall off with distance in pictures: compared with double precision, with every pixel traced, and
//! with lights that do not.

use embedded_graphics::prelude::Size;
use reflet::host::file::SceneFile;
use reflet::host::reference::{self, Picture};
use reflet::quality::{Exact, Fast, Quality};
use reflet::shading::BlinnPhong;
use reflet::{Camera, Error, Material};

use super::near::{Scenery, UP, apart, assert_near, drawn};

const SIZE: Size = Size::new(160, 120);

/// Random numbers: SplitMix64.
struct Random(u64);

impl Random {
    /// Returns a random number between two.
    fn between(&mut self, low: f64, high: f64) -> f64 {
        self.0 = self.0.wrapping_add(0x9e37_79b9_7f4a_7c15);
        let mixed = (self.0 ^ (self.0 >> 30)).wrapping_mul(0xbf58_476d_1ce4_e5b9);
        let mixed = (mixed ^ (mixed >> 27)).wrapping_mul(0x94d0_49bb_1331_11eb);
        let share = ((mixed ^ (mixed >> 31)) >> 11) as f64 / (1_u64 << 53) as f64;
        low + (high - low) * share
    }

    fn place(&mut self, low: [f64; 3], high: [f64; 3]) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.between(low[axis], high[axis]))
    }
}

/// Returns a room of two planes with balls, a cylinder and a disc, all matt or with a wide highlight, and its camera. Its
/// lights have ranges of 2^`power` to twice that, and are so bright that they are seen.
fn room_of(seed: u64, power: i32) -> Result<(Scenery, Camera), Error> {
    let mut random = Random(seed << 8);
    let mut scene = Scenery::new();
    let clay = Material::new([0.9, 0.4, 0.3]).specular(0.3, 8.0);
    let pond = Material::new([0.3, 0.4, 0.5]).mirror(0.4);
    let clay = scene.add_material(clay)?;
    let chalk = scene.add_material(Material::new([0.8, 0.8, 0.7]))?;
    let pond = scene.add_material(pond)?;
    scene.add_plane([0.0; 3], UP, [pond, chalk, chalk][seed as usize % 3])?;
    scene.add_plane([0.0, 4.0, 0.0], [0.1, -1.0, 0.1], chalk)?;
    for _ in 0..4 {
        let center = random.place([-2.5, -1.5, 0.2], [2.5, 3.0, 2.5]);
        let radius = random.between(0.2, 1.0);
        scene.add_sphere(center, radius, clay)?;
    }
    let post = random.place([-2.0, -1.0, 0.5], [2.0, 3.0, 1.5]);
    scene.add_cylinder(post, [0.2, 0.1, 1.0], 0.3, 2.0, chalk)?;
    let lid = random.place([-2.0, -2.0, 0.05], [2.0, 1.0, 0.5]);
    scene.add_disc(lid, [0.1, -0.2, 1.0], 0.9, clay)?;
    for _ in 0..3 {
        let place = random.place([-4.0, -4.0, 0.1], [4.0, 2.0, 4.0]);
        let range = 2f64.powi(power) * random.between(1.0, 2.0);
        let color = (1.0 / range).clamp(0.8, 8.0) * random.between(0.7, 1.0);
        scene.add_light_with_range(place, [color; 3], range)?;
    }
    let eye = random.place([-2.0, -7.0, 0.5], [2.0, -4.0, 4.0]);
    Ok((scene, Camera::new(eye, [0.0, 0.0, 0.8], UP, 50)?))
}

fn picture<Q: Quality>(scene: &Scenery, camera: &Camera) -> Picture {
    drawn::<Q, BlinnPhong>(&scene.build().unwrap(), camera, SIZE)
}

/// Checks the share of pixels within 1 of the reference, in every quality.
fn assert_all_near(scene: &Scenery, camera: &Camera, within1: f64) {
    let (shading, bars) = (reference::Shading::BlinnPhong, [[0.0, within1, 0.0]; 3]);
    assert_near::<BlinnPhong>((scene, camera), SIZE, shading, bars);
}

#[test]
fn fast_interpolates_what_falls_off() {
    let mut lost = Vec::new();
    let (mut all, mut pixels) = (0, 0);
    for power in [-6, -4, -3, -2, -1, 0, 1, 3, 6] {
        for seed in 0..4 {
            let (scene, camera) = room_of(seed, power).unwrap();
            let exact = picture::<Exact>(&scene, &camera);
            let own = apart(&picture::<Fast>(&scene, &camera), &exact, 1);
            lost.push((power, seed, own));
            all += own;
            pixels += exact.pixels.len();
        }
    }
    println!("{lost:?}");
    assert!(all * 10_000 <= pixels, "{all} of {pixels}: {lost:?}");
}

#[test]
fn light_that_falls_off_is_as_double_precision_says() {
    for (seed, power) in [(1, -5), (2, -1), (3, 0), (4, 2), (5, 20)] {
        let (scene, camera) = room_of(seed, power).unwrap();
        assert_all_near(&scene, &camera, 0.999);
    }
}

/// A lantern over a floor.
const LANTERN: [f64; 3] = [0.5, 1.0, 1.0];

fn floor(range: f64) -> Result<Scenery, Error> {
    let mut scene = Scenery::new();
    let chalk = scene.add_material(Material::new([0.9; 3]))?;
    scene.add_plane([0.0; 3], UP, chalk)?;
    scene.add_light_with_range(LANTERN, [2.0; 3], range)?;
    Ok(scene)
}

fn above() -> Camera {
    Camera::new([0.0, -4.0, 3.0], [0.0, 0.0, 0.0], UP, 60).unwrap()
}

#[test]
fn lamp_with_a_huge_range_is_one_without() {
    let ranged = picture::<Exact>(&floor(1e9).unwrap(), &above());
    let mut without = Scenery::new();
    let chalk = without.add_material(Material::new([0.9; 3])).unwrap();
    without.add_plane([0.0; 3], UP, chalk).unwrap();
    without.add_light(LANTERN, [2.0; 3]).unwrap();
    let plain = picture::<Exact>(&without, &above());
    assert_eq!(apart(&ranged, &plain, 1), 0);
}

#[test]
fn light_far_outside_of_the_scene_falls_off() {
    let mut scene = floor(1.0).unwrap();
    let far = scene.add_light_with_range([3e6, -2e6, 5e6], [4.0; 3], 5e6);
    far.unwrap();
    let chalk = scene.description().planes[0].material;
    scene.add_sphere([0.0, 0.0, 0.5], 0.5, chalk).unwrap();
    assert_all_near(&scene, &above(), 0.998);
}

/// The same lantern is drawn from a scene filled at run time and a file, and the file's Rust source names the range. The
/// constant scene of `triangles` has a range, too.
#[test]
fn range_is_the_same_wherever_a_scene_is_written() {
    let camera = above();
    let filled = picture::<Fast>(&floor(0.75).unwrap(), &camera);
    let text = r#"{
        "camera": {"position": [0, -4, 3], "target": [0, 0, 0], "up": [0, 0, 1], "fov": 60},
        "materials": [{"name": "chalk", "color": [0.9, 0.9, 0.9]}],
        "lights": [{"position": [0.5, 1, 1], "color": [2, 2, 2], "range": 0.75}],
        "planes": [{"center": [0, 0, 0], "normal": [0, 0, 1], "material": "chalk"}]
    }"#;
    let file = SceneFile::parse(text, None).unwrap();
    let read = drawn::<Fast, BlinnPhong>(&*file.build().unwrap(), &camera, SIZE);
    // Its camera is part of the scene, so its grid is another one.
    assert_eq!(apart(&read, &filled, 1), 0);
    let source = file.rust_source().text();
    let line = "light_with_range([0.5, 1.0, 1.0], [2.0, 2.0, 2.0], 0.75);";
    assert!(source.contains(line), "{source}");
    let sun = text
        .replace("lights", "suns")
        .replace("position\": [0.5", "direction\": [0.5");
    let error = SceneFile::parse(&sun, None).unwrap_err().to_string();
    let words = "suns[0] cannot have the key range, only direction, color, disc";
    assert!(error.contains(words), "{error}");
}

#[test]
fn moved_lamp_is_one_made_there_and_another_range_another_scene() {
    let mut scene = floor(0.75).unwrap();
    let lamp = scene.add_light_with_range([9.0; 3], [1.0; 3], 0.5).unwrap();
    let mut moved = scene.build().unwrap();
    moved.set_light(lamp, [-1.0, 0.0, 1.0]).unwrap();
    let made = |range: f64| {
        let mut scene = floor(0.75).unwrap();
        scene
            .add_light_with_range([-1.0, 0.0, 1.0], [1.0; 3], range)
            .unwrap();
        scene
    };
    let there = drawn::<Fast, BlinnPhong>(&moved, &above(), SIZE);
    let here = picture::<Fast>(&made(0.5), &above());
    assert_eq!(apart(&there, &here, 1), 0);
    // A frame of one is refused by the other.
    let [here, there] = [0.5, 0.25].map(|range| made(range).build().unwrap());
    let frame = here.frame(&above()).prepare(SIZE);
    assert!(frame.on(&here).is_ok() && frame.on(&there).is_err());
}
