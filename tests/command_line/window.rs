//! Tests what the window shows, without a screen: its title, and the scene file that it watches.

#[path = "../../examples/render/title.rs"]
mod title;
#[path = "../../examples/render/watch.rs"]
mod watch;

use std::fs::{self, File};
use std::path::Path;
use std::time::{Duration, SystemTime};

use command_line::{Chosen, Quality, Settings};
use embedded_graphics::geometry::{Point, Size};
use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics_simulator::SimulatorDisplay;

use super::{changed, floor, program::Folder};
use title::title;
use watch::{Watch, draw_error};

#[test]
fn title_names_scene_quality_time_and_keys() {
    let settings = Settings::blinn_phong(Quality::Fast, 4);
    assert_eq!(
        title("ball and floor", settings, 0.01234),
        "ball and floor, fast, 4 reflections: 12.3 ms here | arrows orbit, + - reflections, \
         Tab next scene, Escape leaves"
    );
}

/// Returns what a watch has read anew: the name of the scene, or what is wrong with the file.
fn news(watch: &mut Watch<'_>) -> Option<Result<String, String>> {
    let read = watch.change()?;
    Some(match read {
        Ok(source) => Ok(source.name().to_owned()),
        Err(error) => Err(error.to_string()),
    })
}

/// Writes a file as if `seconds` after the first time.
fn write(path: &Path, text: &str, seconds: u64) {
    fs::write(path, text).unwrap();
    let time = SystemTime::UNIX_EPOCH + Duration::from_secs(1_000_000_000 + seconds);
    let file = File::options().write(true).open(path).unwrap();
    file.set_modified(time).unwrap();
}

#[test]
fn watched_file_is_read_again_when_it_changes_and_only_then() {
    let path = Folder::new("watched_file").path("scene.json");
    write(&path, &floor().to_string(), 0);
    let chosen = Chosen { name: None };
    let mut watch = Watch::new(&path, &chosen);
    assert_eq!(news(&mut watch), Some(Ok("floor".to_owned())));
    assert_eq!(news(&mut watch), None);

    let renamed = changed(|scene| scene["name"] = "pond".into());
    write(&path, &renamed, 1);
    assert_eq!(news(&mut watch), Some(Ok("pond".to_owned())));
    assert_eq!(news(&mut watch), None);

    write(
        &path,
        &changed(|scene| scene["planes"][0]["material"] = "grey".into()),
        2,
    );
    let error = news(&mut watch).unwrap().unwrap_err();
    assert!(error.contains("grey"), "{error}");
    assert_eq!(news(&mut watch), None);

    write(&path, &floor().to_string(), 3);
    assert_eq!(news(&mut watch), Some(Ok("floor".to_owned())));

    fs::remove_file(&path).unwrap();
    let error = news(&mut watch).unwrap().unwrap_err();
    assert!(error.contains("scene.json"), "{error}");
}

#[test]
fn error_is_drawn_over_the_top_of_the_picture() {
    let mut display = SimulatorDisplay::with_default_color(Size::new(60, 64), Rgb888::BLUE);
    // Ten letters fit in a line: this takes two lines of ten pixels.
    draw_error("no material", &mut display);
    let rows = |color| {
        let is_in = |y: &i32| (0..60).any(|x| display.get_pixel(Point::new(x, *y)) == color);
        (0..64).filter(is_in).collect::<Vec<_>>()
    };
    let written = [Rgb888::RED, Rgb888::WHITE].map(|color| rows(color).last().copied());
    assert_eq!(written[0], Some(19));
    assert!(written[1].is_some_and(|last| (10..20).contains(&last)));
    assert_eq!(rows(Rgb888::BLUE).first(), Some(&10));
}
