//! Tests that the error of a picture stays within its bound, except where rounding changes what a
//! path hits; and that a room of mirrors converges as the formula says.

use command_line::{Quality as Known, Settings, Shading as Tested, Source};
use embedded_graphics::prelude::Size;
use reflet::host::reference::Picture;
use reflet::host::reference::bound::{Ending, Paths};
use reflet::host::{painted, precision};
use reflet::quality::{Exact, Fast, Quality};
use reflet::scenes::NAMES;
use reflet::shading::{BlinnPhong, Phong, Shading};
use reflet::{Camera, Material, Unit};

use super::held::{ending, held};
use super::near::Scenery;

const SIDE: u32 = 96;

/// Number of reflections after which nothing is left of any path of the scenes.
const ALL: usize = 300;

/// A quality that stops paths whose weight is below an eighth.
struct Short;

impl Quality for Short {
    const SMALLEST_WEIGHT: Unit = Unit::from_bits(1 << 27);
    const TOLERANCE: Unit = Fast::TOLERANCE;
}

/// A quality that interpolates where the error may be 16 times as large.
struct Rough;

impl Quality for Rough {
    const SMALLEST_WEIGHT: Unit = Fast::SMALLEST_WEIGHT;
    const TOLERANCE: Unit = Unit::from_bits(16 * Fast::TOLERANCE.to_bits());
}

/// Returns a line for each picture of a scene, with these numbers of reflections, that is further off than its bound.
fn complaints(name: &str, reflections: &[u8]) -> Vec<String> {
    let source = Source::built_in(name).unwrap();
    let (scene, camera) = source.reference();
    let precision = precision(source.scene());
    let mut complaints = Vec::new();
    for shading in [Tested::BlinnPhong, Tested::Phong] {
        let (size, model) = ((SIDE, SIDE), shading.into());
        let paths = Paths::follow(&scene, &camera, size, ALL, model, &precision);
        for &reflections in reflections {
            let pictures = match shading {
                Tested::Phong => pictures::<Phong>(&source, shading, reflections),
                _ => pictures::<BlinnPhong>(&source, shading, reflections),
            };
            for (quality, ending, picture) in pictures {
                let held = held(&paths, &ending, &picture, ALL);
                let line = format!("{name:<18} {shading:?} {quality} {reflections} {held:?}");
                println!("{line}");
                // Up to two thirds of the pixels may be unsure because of edges, but few of them
                // are wrong.
                let is_well = held.broken == 0
                    && 3 * held.sure >= held.pixels
                    && 100 * held.decided <= held.pixels;
                complaints.extend((!is_well).then_some(line));
            }
        }
    }
    complaints
}

fn pictures<K: Shading>(
    source: &Source,
    shading: Tested,
    n: u8,
) -> [(&'static str, Ending, Picture); 4] {
    let size = Size::new(SIDE, SIDE);
    let drawn = |quality| {
        let settings = Settings {
            reflections: n,
            shading,
            quality,
        };
        source.drawn(size, settings)
    };
    let short = source.painted::<Short, K>(size, n);
    let rough = source.painted::<Rough, K>(size, n);
    [
        ("fast", ending::<Fast>(n, SIDE), drawn(Known::Fast)),
        ("exact", ending::<Exact>(n, SIDE), drawn(Known::Exact)),
        ("short", ending::<Short>(n, SIDE), short),
        ("rough", ending::<Rough>(n, SIDE), rough),
    ]
}

#[test]
fn no_pixel_of_a_scene_is_further_off_than_its_bound() {
    are_within_their_bounds(&[1, 4]);
}

#[test]
#[ignore = "long: more reflections"]
fn no_pixel_with_any_reflections_is_further_off_than_its_bound() {
    are_within_their_bounds(&[0, 2, 8, 255]);
}

fn are_within_their_bounds(reflections: &[u8]) {
    let complaints = NAMES.map(|name| complaints(name, reflections)).concat();
    assert!(complaints.is_empty(), "{}", complaints.join("\n"));
}

/// Returns a closed room that mirrors and glows: every hit of a path has the same α and the same
/// colour.
fn room(alpha: f64, is_round: bool) -> Scenery {
    let mut room = Scenery::new();
    let glass = Material::from_numbers(COLOR, 1, 0, (0, 1), alpha).unwrap();
    let glass = room.add_material(glass).unwrap();
    if is_round {
        room.add_sphere([0, 0, 0], 2, glass).unwrap();
        return room;
    }
    for axis in 0..3 {
        for side in [-1, 1] {
            let mut wall = [0; 3];
            wall[axis] = 2 * side;
            room.add_plane(wall, wall, glass).unwrap();
        }
    }
    room
}

const COLOR: [f64; 3] = [0.75, 0.5, 1.0];

#[test]
fn closed_room_of_mirrors_converges_as_the_formula_says() {
    let camera = Camera::new([0.3, -0.4, 0.2], [1.0, 1.3, 0.7], [0, 0, 1], 80).unwrap();
    for is_round in [false, true] {
        for alpha in [0.5, 0.9, 0.99, 0.999] {
            let scene = room(alpha, is_round).build().unwrap();
            for reflections in 0..=255_u8 {
                let frame = scene.frame(&camera).reflections(reflections);
                let frame = frame.quality::<Exact>().prepare(Size::new(6, 5));
                let picture = painted(&frame.on(&scene).unwrap());
                let share = 1.0 - alpha.powi(i32::from(reflections) + 1);
                for pixel in picture.pixels {
                    for (channel, color) in pixel.into_iter().zip(COLOR) {
                        let expected = 255.0 * color * share;
                        let apart = (f64::from(channel) - expected).abs();
                        assert!(apart <= 1.0, "{alpha} {reflections}: {channel} {expected}");
                    }
                }
            }
        }
    }
}
