//! Tests the examples that draw one picture each, and the example scenes, by the files that are
//! written.

use std::fs;
use std::path::{Path, PathBuf};

use embedded_graphics::pixelcolor::{Rgb565, Rgb888, RgbColor};
use image::{Rgb, RgbImage};
use serde_json::Value;

use super::program::Folder;

/// Runs an example for a test and returns the only picture that it writes, and what it prints.
fn picture(test: &str, name: &'static str) -> (RgbImage, String) {
    let folder = Folder::new(test);
    let outcome = folder.example(name);
    assert_eq!((outcome.code, &*outcome.stderr), (0, ""));
    let file = format!("{name}.png");
    assert_eq!(folder.files(), [file.as_str()]);
    (folder.png(&file), outcome.stdout)
}

#[test]
fn harbour_shows_a_golden_ball_and_its_mirror_image() {
    let (image, printed) = picture("harbour", "harbour");
    assert_eq!(image.dimensions(), (240, 240));
    // Four reflections between ball and water leave some light to follow.
    let (start, end) = (
        " rays, reflections cut off: at most ",
        " of 255 levels missing\n",
    );
    assert!(printed.starts_with("harbour.png: "), "{printed}");
    assert!(
        printed.contains(start) && printed.ends_with(end),
        "{printed}"
    );
    let is_golden = |y| {
        let [red, _, blue] = image.get_pixel(125, y).0;
        red > blue
    };
    // The ball from above its middle to its lower rim, the sky above it, its image below it.
    assert!(is_golden(90) && !is_golden(30) && is_golden(230));
}

/// Returns the first and the last row of a frame of the strip with such a pixel.
fn rows(image: &RgbImage, frame: u32, is_it: impl Fn([u8; 3]) -> bool) -> Option<(u32, u32)> {
    let columns = || 120 * frame..120 * (frame + 1);
    let has_it = |y: &u32| columns().any(|x| is_it(image.get_pixel(x, *y).0));
    let first = (0..120).find(has_it)?;
    Some((first, (0..120).rfind(has_it)?))
}

#[test]
fn bounce_moves_the_ball_its_shadow_and_its_mirror_image() {
    let (image, _) = picture("bounce", "bounce");
    assert_eq!(image.dimensions(), (960, 120));
    // Only the lit ball is that yellow.
    let is_ball = |[red, green, blue]: [u8; 3]| {
        u32::from(green) * 4 > u32::from(red) * 3 && u32::from(red) > 2 * u32::from(blue)
    };
    let tops: Vec<_> = (0..8)
        .map(|frame| rows(&image, frame, is_ball).unwrap().0)
        .collect();
    assert!(tops[..5].is_sorted_by(|a, b| a > b), "it rises: {tops:?}");
    assert!(tops[4..].is_sorted_by(|a, b| a < b), "it falls: {tops:?}");
    assert!(tops[0] > tops[4] + 20, "by much: {tops:?}");
    // The shadow is where it is in one of the frames only.
    let is_shadow = |frame: u32, x, y| image.get_pixel(120 * frame + x, y).0 == [58, 73, 99];
    assert!(is_shadow(0, 45, 76) && !is_shadow(4, 45, 76));
    assert!(is_shadow(4, 60, 68) && !is_shadow(0, 60, 68));
    // The mirror image, below the shadow, moves downwards while the ball rises.
    let image_top = |frame: u32| {
        let is_image = |y: &u32| image.get_pixel(120 * frame + 60, *y).0[2] < 120;
        (80..120).find(is_image).unwrap()
    };
    assert!(image_top(0) + 10 < image_top(4));
}

/// Returns the scene files of `examples/scenes`, sorted by name.
fn scene_files() -> Vec<PathBuf> {
    let folder = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes");
    let entries = fs::read_dir(folder).unwrap();
    let mut files: Vec<_> = entries.map(|entry| entry.unwrap().path()).collect();
    files.sort();
    files
}

/// Draws a scene file with the example `render`.
fn drawn(folder: &Folder, file: &Path, size: &str) -> RgbImage {
    let file = file.to_str().unwrap();
    let outcome = folder.run(&[file, "--size", size, "--out", "drawn.png"]);
    assert_eq!((outcome.code, &*outcome.stderr), (0, ""), "{file}");
    folder.png("drawn.png")
}

#[test]
fn every_example_scene_is_drawn() {
    let folder = Folder::new("scenes");
    let mut names = Vec::new();
    for file in scene_files() {
        let scene: Value = serde_json::from_str(&fs::read_to_string(&file).unwrap()).unwrap();
        assert_eq!(scene["$schema"], "../../docs/scene.schema.json");
        assert_eq!(scene["name"], file.file_stem().unwrap().to_str().unwrap());
        names.push(scene["name"].as_str().unwrap().to_owned());
        let image = drawn(&folder, &file, "64x64");
        let first = image.get_pixel(0, 0);
        assert!(image.pixels().any(|pixel| pixel != first), "{file:?}");
    }
    let expected = "bounce checkers chrome3 fence harbour harbour_sun icosahedron matt3 pybadge \
                    tetrahedron tree wire";
    assert_eq!(names.join(" "), expected);
}

#[test]
fn harbour_of_the_file_is_the_harbour_of_the_example() {
    let (example, _) = picture("harbour_example", "harbour");
    let file = Path::new(env!("CARGO_MANIFEST_DIR")).join("examples/scenes/harbour.json");
    let mut image = drawn(&Folder::new("harbour_file"), &file, "240x240");
    // The example draws on a display of 16 bits a pixel.
    for pixel in image.pixels_mut() {
        let [red, green, blue] = pixel.0;
        let shown = Rgb888::from(Rgb565::from(Rgb888::new(red, green, blue)));
        *pixel = Rgb([shown.r(), shown.g(), shown.b()]);
    }
    assert!(image == example);
}
