//! Tests what a pixel takes from its corners, and where samples lie.

use std::vec::Vec;

use super::cell::Cell;
use super::corner::{Corner, Line, Side};
use super::places::{CENTER, PIXEL, Place, enough};
use crate::camera::Camera;
use crate::color::{Color, Levels, Sum};
use crate::number::{Number, Unit};
use crate::ray::PathSignature;
use crate::vector::Direction;

/// Returns a corner whose path met `met`, white or black.
fn corner(met: u32, is_white: bool) -> Corner {
    let mut path = PathSignature::new();
    path.note(met);
    let mut sum = Sum::DARK;
    if is_white {
        let white = Color::from_numbers([Number::new(1.0); 3]);
        sum.add(Unit::ONE, white.in_levels());
    }
    Corner {
        color: Levels::of(sum),
        path: path.ended(true).mark(),
    }
}

/// Returns the level of a pixel with these sides, whose corners are white where `white` says so.
fn level(white: [bool; 4], sides: [Side; 4]) -> u8 {
    let corners = white.map(|is_white| corner(is_white.into(), is_white));
    let [level, ..] = Cell { corners, sides }.color().sum().to_rgb8();
    level
}

#[test]
fn corners_count_by_the_area_that_edges_bound() {
    let at = Side::divided;
    // An upright edge: a quarter, and a slanted one from a quarter to three quarters.
    let (left, whole) = ([true, false, false, true], Side::WHOLE);
    assert_eq!(level(left, [at(8), whole, at(8), whole]), 64);
    assert_eq!(level(left, [at(8), whole, at(24), whole]), 128);
    // A level edge.
    let top = [true, true, false, false];
    assert_eq!(level(top, [whole, at(24), whole, at(24)]), 191);
    // A triangle at a corner: half of a half by a quarter.
    let one = [true, false, false, false];
    assert_eq!(level(one, [at(16), whole, whole, at(8)]), 16);
    // Two opposite corners.
    let two = [true, false, true, false];
    assert_eq!(level(two, [at(16); 4]), 128);
}

#[test]
fn shares_of_all_corners_are_the_whole_pixel() {
    for top in 1..32 {
        for left in 1..32 {
            let sides = [top, 32 - left, left, top].map(Side::divided);
            assert_eq!(level([true; 4], sides), 255, "{top}, {left}");
            let three = [sides[0], sides[1], Side::WHOLE, sides[3]];
            let white = level([true; 4], three);
            assert!(white >= 254, "{top}, {left}: {white}");
        }
    }
}

#[test]
fn only_a_tangle_and_steep_colours_are_sampled() {
    let cell = |white: [bool; 4], sides| {
        let corners = white.map(|is_white| corner(is_white.into(), is_white));
        Cell { corners, sides }.contrast()
    };
    let (at, whole) = (Side::divided(9), Side::WHOLE);
    assert_eq!(cell([true, false, false, true], [at, whole, at, whole]), 0);
    assert_eq!(cell([true, false, true, false], [at; 4]), 255);
    let tangled = Side::tangled(9);
    assert_eq!(
        cell([true, false, false, true], [tangled, whole, at, whole]),
        255
    );
    assert_eq!(cell([true; 4], [tangled, whole, at, whole]), 0);
    // The left corners meet the same, in different colours.
    let mut corners = [
        corner(1, true),
        corner(2, true),
        corner(2, true),
        corner(1, false),
    ];
    let sides = [at, whole, at, whole];
    assert_eq!(Cell { corners, sides }.contrast(), 255);
    corners[3] = corner(1, true);
    assert_eq!(Cell { corners, sides }.contrast(), 0);
}

#[test]
fn side_knows_where_an_edge_crosses_it() {
    for at in 1..32 {
        let (divided, tangled) = (Side::divided(at), Side::tangled(at));
        assert_eq!([divided.at(), tangled.at()], [i32::from(at); 2]);
        assert!(!divided.is_whole() && !divided.is_tangled());
        assert!(!tangled.is_whole() && tangled.is_tangled());
    }
    assert!(Side::WHOLE.is_whole() && !Side::WHOLE.is_tangled());
}

#[test]
fn line_is_known_for_its_own_chunk_only() {
    let mut line = Line::NONE;
    assert!(!line.is_of([0, 0], false));
    line.begin([3, 32], false);
    assert!(line.is_of([3, 32], false) && !line.is_of([3, 32], true));
    assert!(!line.is_of([3, 0], false) && !line.is_of([4, 32], false));
    // As the pages say.
    assert_eq!(size_of::<Line>(), 308);
}

/// The more a pixel's contrast, the more samples.
#[test]
fn each_sample_stands_for_at_most_the_tolerance() {
    for (contrast, count) in [(1, 2), (16, 2), (17, 4), (33, 8), (65, 16), (255, 16)] {
        assert_eq!(enough(contrast, 8).len(), count, "{contrast}");
    }
}

#[test]
fn places_of_samples_are_symmetric_and_inside_of_the_pixel() {
    for contrast in [16, 32, 64, 128] {
        let places = enough(contrast, 8);
        let opposite = |place: &Place| place.map(|part| PIXEL - part);
        assert!(places.iter().rev().map(opposite).eq(places.iter().copied()));
        for axis in [0, 1] {
            let mut lines: Vec<_> = places.iter().map(|place| place[axis]).collect();
            assert!(lines.iter().all(|line| (1..PIXEL).contains(line)));
            // No two samples lie in one row or column.
            lines.sort_unstable();
            lines.dedup();
            assert_eq!(lines.len(), places.len());
        }
    }
    assert_eq!(CENTER, [[PIXEL / 2; 2]]);
}

#[test]
fn sixty_four_steps_are_one_pixel() {
    let camera = Camera::look_at([1.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
    let generator = camera.generator(120, 90);
    let far = |one: Direction, other: Direction| {
        let change = one.change_to(other).unwrap();
        change.square() > 1 << 12
    };
    for y in [0, 30, 88] {
        let [row, next] = [y, y + 1].map(|y| generator.row(y));
        for column in [0, 59, 118] {
            let through = |right, down| generator.through([column, y], [right, down]);
            let place = format!("row {y}, column {column}");
            assert!(!far(through(0, 64), next.of(column)), "{place}");
            assert!(!far(through(64, 0), row.of(column + 1)), "{place}");
            assert!(far(through(1, 0), row.of(column)), "{place}");
            assert!(far(through(0, 1), row.of(column)), "{place}");
            let below = generator.row_below(y, 23).of(column);
            assert!(!far(through(0, 23), below), "{place}");
        }
    }
}

/// Corners lie half a pixel to the left of the centres of pixels, and above them.
#[test]
fn corners_are_half_a_pixel_from_the_centres() {
    let camera = Camera::look_at([1.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
    let (pixels, corners) = (camera.generator(120, 90), camera.corners(120, 90));
    for y in [0, 45, 89] {
        for x in [0, 60, 119] {
            let center = pixels.row(y).of(x);
            let found = corners.through([x, y], [32, 32]);
            let off = center.change_to(found).unwrap().square();
            assert!(off < 1 << 12, "pixel {x}, {y}: {off}");
        }
    }
}

/// The sides of a pixel lead to the next directions, but for their part along the ray.
#[test]
fn sides_of_a_pixel_lead_to_its_neighbours() {
    for (fov, size) in [
        (50.0, [120, 90]),
        (0.01, [120, 90]),
        (120.0, [64, 64]),
        (170.0, [320, 20]),
    ] {
        let camera = Camera::look_at([1.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.1, 0.0, 1.0]).fov(fov);
        let generator = camera.generator(size[0], size[1]);
        let pixel = generator.pixel();
        for at in [[1, 1], [size[0] / 2, size[1] / 2], [size[0] - 2, 3]] {
            let [here, right, down] =
                [[0, 0], [1, 0], [0, 1]].map(|step| generator.through(at, step.map(|it| 64 * it)));
            let width = f64::from(pixel.width) * f64::from(pixel.ahead.dot(here));
            for (next, side) in [(right, pixel.sides[0]), (down, pixel.sides[1])] {
                let parts = |it: Direction| it.components().map(f64::from);
                let (here, next, side) = (parts(here), parts(next), parts(side));
                let along: f64 = [0, 1, 2].map(|axis| side[axis] * here[axis]).iter().sum();
                let off = [0, 1, 2].map(|axis| {
                    next[axis] - here[axis] - width * (side[axis] - along * here[axis])
                });
                let off = off.map(|it| it * it).iter().sum::<f64>().sqrt();
                assert!(
                    off <= width * width + 1e-8,
                    "{fov} {at:?}: {off} of {width}"
                );
            }
        }
    }
}
