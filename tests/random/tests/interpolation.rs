//! Tests pictures in which untraced pixels are interpolated: which pixels equal those with every
//! pixel traced, and what cannot be lost.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::prelude::Size;
use proptest::prelude::*;
use reflet::host::painted;
use reflet::host::{compare::compare, reference};
use reflet::quality::{Exact, Fast, Fine, Quality};
use reflet::scenes::{BuiltIn, Corner1, Floor, NAMES, Visitor, visit};
use reflet::{Camera, Material, RuntimeScene, Unit, room};

/// A quality that traces every fourth pixel and accepts any interpolation between them.
struct Coarse;

impl Quality for Coarse {
    const SMALLEST_WEIGHT: Unit = Unit::DELTA;
    const STRIDE: u32 = 4;
    const TOLERANCE: Unit = Unit::ONE;
}

/// A quality like [`Coarse`] that traces every pixel. [`Exact`] would not do, because it rounds more
/// finely.
struct All;

impl Quality for All {
    const SMALLEST_WEIGHT: Unit = Unit::DELTA;
    const STRIDE: u32 = 1;
    const TOLERANCE: Unit = Unit::ZERO;
}

/// Compares the pixels that are traced in both qualities.
struct Traced;

impl Visitor for Traced {
    type Output = ();

    fn visit<S: BuiltIn>(self) {
        // Both widths end inside a stretch. In the second picture nothing beyond the edge is traced.
        for size in [Size::new(61, 40), Size::new(7, 9)] {
            let frame = S::frame(&S::CAMERA);
            let all = painted(
                &frame
                    .quality::<All>()
                    .prepare(size)
                    .on(S::INSTANCE)
                    .unwrap(),
            );
            let frame = S::frame(&S::CAMERA);
            let coarse = painted(
                &frame
                    .quality::<Coarse>()
                    .prepare(size)
                    .on(S::INSTANCE)
                    .unwrap(),
            );
            let pixels = all.pixels.iter().zip(&coarse.pixels).enumerate();
            for (index, (all, coarse)) in pixels {
                let column = index % size.width as usize;
                if column.is_multiple_of(4) {
                    assert_eq!(all, coarse, "{} at {index}", S::NAME);
                }
            }
        }
    }
}

#[test]
fn every_fourth_pixel_is_traced_whatever_lies_between() {
    for name in NAMES {
        visit(name, Traced).unwrap();
    }
}

/// Returns the share of the pixels that are within 1 of the picture with every pixel traced.
fn share<S: BuiltIn, Q: Quality>(size: Size) -> f64 {
    let frame = S::frame(&S::CAMERA);
    let exact = painted(
        &frame
            .quality::<Exact>()
            .prepare(size)
            .on(S::INSTANCE)
            .unwrap(),
    );
    let frame = S::frame(&S::CAMERA);
    let found = painted(&frame.quality::<Q>().prepare(size).on(S::INSTANCE).unwrap());
    compare(&found, &exact).unwrap().within1
}

#[test]
fn scene_of_planes_loses_nothing() {
    for (width, height) in [(64, 48), (31, 50), (5, 8)] {
        let size = Size::new(width, height);
        assert_eq!(share::<Floor, Fine>(size), 1.0, "{size}");
        assert_eq!(share::<Corner1, Fine>(size), 1.0, "{size}");
    }
}

type Ball = RuntimeScene<room!(spheres: 2, planes: 1, lights: 1, materials: 2)>;

/// A scene with at most thirty balls, more than an active list holds, and one behind the camera.
type Balls = RuntimeScene<room!(spheres: 31, lights: 1, materials: 1)>;

/// Returns a scene with a white ball, and another ball behind the camera.
fn ball(center: [f64; 3], radius: f64) -> Ball {
    let mut scene = Ball::new();
    let white = Material::from_numbers([1; 3], 1, 0, (0, 0), 0).unwrap();
    let white = scene.add_material(white).unwrap();
    scene.add_sphere(center, radius, white).unwrap();
    scene.add_sphere([0, -10, 0], 1, white).unwrap();
    scene
}

/// Returns the row and column of each pixel in which two pictures differ.
fn differences(one: &reference::Picture, other: &reference::Picture) -> Vec<(u32, u32)> {
    let pixels = one.pixels.iter().zip(&other.pixels).enumerate();
    let different = pixels.filter(|(_, (one, other))| one != other);
    let place = |index: usize| (index as u32 / one.width, index as u32 % one.width);
    different.map(|(index, _)| place(index)).collect()
}

/// Returns balls beside each other at some distances. None hides another. Together they are `width`
/// wide, where the view is 9 wide at a distance of 10.
fn balls(places: &[(f64, f64, f64)], width: f64) -> Balls {
    let mut scene = Balls::new();
    let white = Material::from_numbers([1; 3], 1, 0, (0, 0), 0).unwrap();
    let white = scene.add_material(white).unwrap();
    scene.add_sphere([0, -10, 0], 1, white).unwrap();
    let slots = places.len() as f64;
    for (slot, &(shift, size, distance)) in places.iter().enumerate() {
        let middle = ((slot as f64 + 0.5 + 0.3 * shift) / slots - 0.5) * width;
        let radius = 0.15 * width / slots * size;
        let center = [middle, 10.0, 0.0].map(|it| it * distance);
        scene.add_sphere(center, radius * distance, white).unwrap();
    }
    scene
}

fn painted_with<Q: Quality>(scene: &Ball, camera: &Camera) -> reference::Picture {
    let built = scene.build().unwrap();
    let frame = built.frame(camera).quality::<Q>();
    painted(&frame.prepare(Size::new(61, 47)).on(&built).unwrap())
}

proptest! {
    #![proptest_config(ProptestConfig { cases: 1000, failure_persistence: None, ..ProptestConfig::default() })]

    /// For spheres of any size and position, even smaller than a stride.
    #[test]
    fn no_part_of_a_sphere_is_lost(
        x in -5.0..5.0,
        y in -4.0..4.0,
        radius in 0.02..2.0,
    ) {
        let scene = ball([x, 10.0, y], radius);
        let camera = Camera::look_at([0.0; 3], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        let exact = painted_with::<Exact>(&scene, &camera);
        prop_assert_eq!(differences(&painted_with::<Fast>(&scene, &camera), &exact), []);
        prop_assert_eq!(differences(&painted_with::<Fine>(&scene, &camera), &exact), []);
    }

    /// For spheres that are visible in a mirror below them.
    #[test]
    fn no_part_of_a_mirrored_sphere_is_lost(
        x in -5.0..5.0,
        y in -2.0..2.0,
        radius in 0.02..1.0,
    ) {
        let mut scene = ball([x, 10.0, y], radius);
        let mirror = Material::from_numbers([1; 3], 0, 0, (0, 0), 1).unwrap();
        let mirror = scene.add_material(mirror).unwrap();
        scene.add_plane([0, 0, -4], [0, 0, 1], mirror).unwrap();
        let camera = Camera::look_at([0.0; 3], [0.0, 1.0, -0.4], [0.0, 0.0, 1.0]);
        let exact = painted_with::<Exact>(&scene, &camera);
        prop_assert_eq!(differences(&painted_with::<Fast>(&scene, &camera), &exact), []);
    }

    /// For several spheres at different distances, also if there are more than an active list holds.
    #[test]
    fn no_part_of_one_of_many_spheres_is_lost(
        few in prop::collection::vec((-1.0..1.0, 0.05..1.0, 0.5..4.0), 7),
        many in prop::collection::vec((-1.0..1.0, 0.3..1.0, 0.5..4.0), 30),
    ) {
        let camera = Camera::look_at([0.0; 3], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        for places in [few, many] {
            let built = balls(&places, 8.0).build().unwrap();
            let size = Size::new(61, 9);
            let exact = painted(&built.frame(&camera).quality::<Exact>().prepare(size).on(&built).unwrap());
            let fast = painted(&built.frame(&camera).quality::<Fast>().prepare(size).on(&built).unwrap());
            prop_assert_eq!(differences(&fast, &exact), []);
            let fine = painted(&built.frame(&camera).quality::<Fine>().prepare(size).on(&built).unwrap());
            prop_assert_eq!(differences(&fine, &exact), []);
        }
    }

    /// Also if there are more shapes than an active list holds.
    #[test]
    fn part_of_a_row_has_the_colors_of_the_whole(
        places in prop::collection::vec((-1.0..1.0, 0.3..1.0, 0.5..4.0), 30),
        width in 1.0..9.0,
        first in 0_u32..61,
    ) {
        let camera = Camera::look_at([0.0; 3], [0.0, 1.0, 0.0], [0.0, 0.0, 1.0]);
        let built = balls(&places, width).build().unwrap();
        let picture = built.frame(&camera).prepare(Size::new(61, 9));
        let picture = picture.on(&built).unwrap();
        for y in 0..9 {
            let (mut whole, mut part) = ([Rgb888::RED; 61], [Rgb888::RED; 61]);
            picture.row(y, 0, &mut whole);
            picture.row(y, first, &mut part);
            let first = first as usize;
            prop_assert_eq!(&whole[first..], &part[..61 - first]);
        }
    }
}
