//! Tests the films of the render example.

use std::fs;

use gif::{ColorOutput, DecodeOptions, Repeat};

use super::program::Folder;
use super::{call_and_words, floor, printed, refused};

/// Returns how often a film repeats, how long it shows each frame, and the RGBA8 bytes of each frame.
fn film(bytes: &[u8]) -> (Repeat, Vec<u16>, Vec<Vec<u8>>) {
    let mut options = DecodeOptions::new();
    options.set_color_output(ColorOutput::RGBA);
    let mut decoder = options.read_info(bytes).unwrap();
    let (mut delays, mut frames) = (Vec::new(), Vec::new());
    while let Some(frame) = decoder.read_next_frame().unwrap() {
        delays.push(frame.delay);
        frames.push(frame.buffer.to_vec());
    }
    (decoder.repeat(), delays, frames)
}

/// Returns the root of the mean squared difference of two pictures, in levels of 255.
fn difference(rgba: &[u8], rgb: &[u8]) -> f64 {
    let shown = rgba.chunks_exact(4).flat_map(|pixel| &pixel[..3]);
    let squares = shown
        .zip(rgb)
        .map(|(&one, &other)| f64::from(one.abs_diff(other)).powi(2));
    (squares.sum::<f64>() / rgb.len() as f64).sqrt()
}

#[test]
fn film_is_an_orbit_that_repeats_without_end() {
    let folder = Folder::new("film");
    let call = "mirror1 --size 96x72 --orbit 7 --gif a.gif --frames a/b";
    let words = printed(&folder, call);
    let end = "\n7 frames written to the folder a/b\n7 frames written to a.gif\n";
    assert!(words.ends_with(end), "{words}");
    let (repeat, delays, frames) = film(&folder.read("a.gif"));
    assert_eq!((repeat, delays), (Repeat::Infinite, vec![10; 7]));
    assert_eq!(fs::read_dir(folder.path("a/b")).unwrap().count(), 7);
    for (index, frame) in frames.iter().enumerate() {
        let still = folder.png(&format!("a/b/frame-{index:03}.png"));
        assert_eq!((still.dimensions(), frame.len()), ((96, 72), 96 * 72 * 4));
        let error = difference(frame, &still);
        assert!(error < 3.0, "frame {index}: {error}");
    }
    printed(&folder, "mirror1 --size 96x72 --out still.png");
    assert_eq!(folder.png("still.png"), folder.png("a/b/frame-000.png"));
}

#[test]
fn frames_are_a_whole_turn_apart_from_their_first() {
    let folder = Folder::new("turn");
    for count in [2, 4] {
        let call = format!("columns --size 24x24 --orbit {count} --frames {count}");
        printed(&folder, &call);
    }
    let pictures = [
        "2/frame-001.png",
        "4/frame-002.png",
        "4/frame-001.png",
        "4/frame-003.png",
    ];
    let [half, two_quarters, one, three] = pictures.map(|name| folder.png(name));
    assert_eq!(half, two_quarters);
    assert!(one != half && one != three);
}

#[test]
fn film_with_few_colours_keeps_them() {
    let folder = Folder::new("few_colours");
    let call = "columns --size 32x32 --dither gray4";
    printed(&folder, &format!("{call} --orbit 360 --gif a.gif"));
    printed(&folder, &format!("{call} --out a.png"));
    let (_, delays, frames) = film(&folder.read("a.gif"));
    assert_eq!(delays, [2; 360]);
    let still = folder.png("a.png");
    assert!(difference(&frames[0], &still) == 0.0);
}

#[test]
fn film_that_cannot_be_drawn_is_refused_in_one_line() {
    let folder = Folder::new("no_film");
    folder.write("file", "");
    folder.write("frame-001.png", floor().to_string());
    for case in [
        "--orbit 0 --gif a.gif => invalid value '0' for '--orbit <N>': 0 is not in 2..=360",
        "--orbit 1 --gif a.gif => invalid value '1' for '--orbit <N>': 1 is not in 2..=360",
        "--orbit 361 --gif a.gif => invalid value '361' for '--orbit <N>': 361 is not in 2..=360",
        "--orbit 4 => the following required arguments were not provided:; <--gif <F.gif>|--frames <DIR>>",
        "--gif a.gif => the following required arguments were not provided:; --orbit <N>",
        "--frames a => the following required arguments were not provided:; --orbit <N>",
        "--orbit 4 --gif a.png => a.png: films are written as GIF only: name it a.gif",
        "--orbit 4 --gif a.gif --out a.png => the argument '--orbit <N>' cannot be used with '--out <F.png>'",
        "--orbit 4 --gif no/a.gif => no/a.gif cannot be written: there is no folder no",
        "--orbit 4 --frames file => the folder file cannot be made: File exists (os error 17)",
        "--orbit 4 --frames . --scene floor => ./frame-001.png is the scene file: it is not written over",
    ] {
        let (call, words) = call_and_words(case);
        let is_file = call.contains("--scene");
        let scene = if is_file { "./frame-001.png" } else { "floor" };
        let line = refused(&folder, &format!("{scene} --size 2x2 {call}"));
        assert_eq!(line, words);
    }
    assert_eq!(folder.files(), ["file", "frame-001.png"]);
}
