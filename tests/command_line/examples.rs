//! Tests the examples that draw one picture each, by the files that they write.

use image::{ImageReader, RgbImage};

use super::program::Folder;

/// Runs an example and returns the only picture that it writes, and what it prints.
fn picture(name: &'static str) -> (RgbImage, String) {
    let folder = Folder::new(name);
    let outcome = folder.example(name);
    assert_eq!((outcome.code, &*outcome.stderr), (0, ""));
    let file = format!("{name}.png");
    assert_eq!(folder.files(), [file.as_str()]);
    let image = ImageReader::open(folder.path(&file)).unwrap();
    (image.decode().unwrap().to_rgb8(), outcome.stdout)
}

#[test]
fn harbour_shows_a_golden_ball_and_its_mirror_image() {
    let (image, printed) = picture("harbour");
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
    let (image, _) = picture("bounce");
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
