//! Tests suns in pictures: compared with double precision, moved, seen in mirrors, and as the limit of a far lamp.

use embedded_graphics::pixelcolor::Rgb888;
use embedded_graphics::prelude::{RgbColor, Size};
use reflet::host::reference::{self, Picture};
use reflet::host::{compare::compare, painted};
use reflet::quality::{Exact, Fast, Quality};
use reflet::shading::BlinnPhong;
use reflet::{Camera, Material};

use super::near::{Scenery, UP, apart, assert_near, drawn};

const SIZE: Size = Size::new(120, 90);
const NOON: [f64; 3] = [3.0, -2.0, 5.0];
const EVENING: [f64; 3] = [-8.0, 2.0, 1.5];

/// Returns balls, a cylinder and a disc over a floor, without a light.
fn garden() -> Scenery {
    let mut scene = Scenery::new();
    let clay = scene.add_material(Material::new([0.9, 0.3, 0.2])).unwrap();
    let chalk = Material::new([0.8, 0.8, 0.7]).specular(0.0, 1.0);
    let chalk = scene.add_material(chalk).unwrap();
    let chrome = Material::new([0.9; 3]).diffuse(0.2).mirror(0.8);
    let chrome = scene.add_material(chrome).unwrap();
    let pond = Material::new([0.1, 0.2, 0.3]).mirror(0.5);
    let pond = scene.add_material(pond).unwrap();
    for (center, radius, material) in [
        ([-1.4, 0.0, 1.0], 1.0, clay),
        ([1.2, 0.4, 0.9], 0.9, chrome),
        ([0.1, -1.1, 0.4], 0.4, chrome),
    ] {
        scene.add_sphere(center, radius, material).unwrap();
    }
    let post = ([-0.2, 1.8, 0.9], [0.1, 0.0, 1.0]);
    scene.add_cylinder(post.0, post.1, 0.3, 2.0, chalk).unwrap();
    scene.add_disc([0.0, -2.0, 0.02], UP, 0.8, pond).unwrap();
    scene.add_plane([0.0; 3], UP, chalk).unwrap();
    scene.set_background([0.2, 0.3, 0.5]).unwrap();
    scene
}

fn view() -> Camera {
    Camera::new([0.5, -6.5, 2.2], [0.0, 0.0, 0.8], UP, 45).unwrap()
}

fn picture<Q: Quality>(scene: &Scenery) -> Picture {
    drawn::<Q, BlinnPhong>(&scene.build().unwrap(), &view(), SIZE)
}

#[test]
fn suns_are_as_double_precision_says() {
    for (direction, disc) in [(NOON, 0.0), (EVENING, 0.0), (EVENING, 25.0), (UP, 8.0)] {
        let mut scene = garden();
        scene.add_sun(direction, [1.0, 0.9, 0.7], disc).unwrap();
        let faint = scene.add_sun([1.0, -9.0, 4.0], [0.2, 0.2, 0.3], 0.0);
        faint.unwrap();
        let (view, shading) = (view(), reference::Shading::BlinnPhong);
        let bars = [[0.0, 0.998, 0.0]; 3];
        let [fast, _, exact] = assert_near::<BlinnPhong>((&scene, &view), SIZE, shading, bars);
        let apart = compare(&fast, &exact).unwrap().within1;
        assert!(apart >= 0.9995, "{direction:?} {disc}: {apart}");
    }
}

#[test]
fn sun_is_the_limit_of_a_far_lamp() {
    let mut near = garden();
    near.add_sun(NOON, [1.0; 3], 0.0).unwrap();
    let mut far = garden();
    far.add_light(NOON.map(|it| it * 1e8), [1.0; 3]).unwrap();
    let [sun, lamp] = [near, far].map(|scene| picture::<Exact>(&scene));
    let within_one = compare(&sun, &lamp).unwrap().within1;
    assert!(within_one >= 0.999, "{within_one}");
}

#[test]
fn sun_that_moved_is_one_made_there() {
    let mut scene = garden();
    let sun = scene.add_sun(NOON, [1.0; 3], 20.0).unwrap();
    let mut moved = scene.build().unwrap();
    moved.set_light(sun, EVENING).unwrap();
    let mut scene = garden();
    scene.add_sun(EVENING, [1.0; 3], 20.0).unwrap();
    let there = drawn::<Fast, BlinnPhong>(&moved, &view(), SIZE);
    assert!(there == picture::<Fast>(&scene));
    assert!(moved.set_light(sun, [0.0; 3]).is_err());
}

/// Returns the number of pixels that change if a disc is seen. It covers 12 degrees.
fn changed(direction: [f64; 3]) -> usize {
    let [with, without] = [12.0, 0.0].map(|disc| {
        let mut scene = garden();
        scene.add_sun(direction, [1.0, 0.8, 0.0], disc).unwrap();
        picture::<Exact>(&scene)
    });
    apart(&with, &without, 0)
}

#[test]
fn disc_is_seen_in_the_sky_and_in_mirrors() {
    let [ahead, behind, below] = [[0.6, 9.0, 1.0], [0.5, -9.0, 4.0], [0.0, 1.0, -9.0]].map(changed);
    // The radius is 15 columns. The picture shows the lower 37 % of it.
    assert!((250..350).contains(&ahead), "{ahead}");
    assert!((5..100).contains(&behind), "{behind}");
    assert_eq!(below, 0);
}

/// A matt ball that fills the picture has few edges: most of its pixels lie between traced ones. A post beside it throws its
/// shadow on a part of it.
#[test]
fn matt_ball_under_a_sun_is_interpolated() {
    let mut scene = Scenery::new();
    let clay = scene.add_material(Material::new([0.9, 0.3, 0.2])).unwrap();
    scene.add_sphere([0.0; 3], 2.0, clay).unwrap();
    let post = scene.add_cylinder([1.2, -2.6, 0.4], UP, 0.1, 1.0, clay);
    post.unwrap();
    scene.add_sun(NOON, [1.0; 3], 0.0).unwrap();
    let scene = scene.build().unwrap();
    let camera = Camera::new([0.0, -4.0, 0.0], [0.0; 3], UP, 40).unwrap();
    let frame = scene.frame(&camera).quality::<Fast>().prepare(SIZE);
    let rows = frame.on(&scene).unwrap();
    let mut pixels = [Rgb888::BLACK; SIZE.width as usize];
    let rays = (0..SIZE.height).map(|y| rows.row(y, 0, &mut pixels).rays);
    let share = rays.sum::<u64>() as f64 / f64::from(SIZE.width * SIZE.height);
    assert!(share < 0.7, "{share} of the pixels are traced");
    let exact = scene.frame(&camera).quality::<Exact>().prepare(SIZE);
    let difference = compare(&painted(&rows), &painted(&exact.on(&scene).unwrap())).unwrap();
    assert!(difference.within1 >= 0.999, "{difference:?}");
}
