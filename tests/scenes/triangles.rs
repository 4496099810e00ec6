//! Tests triangles in pictures: compared with double precision, in every quality, and as a constant scene.

use embedded_graphics::prelude::Size;
use reflet::host::{compare::compare, reference};
use reflet::quality::{Fast, Small};
use reflet::shading::{BlinnPhong, Phong, Shading};
use reflet::{Camera, Error, Material, MaterialId, scene};

use super::discs::materials;
use super::near::{Scenery, UP, assert_near, drawn};

const SIZE: Size = Size::new_equal(160);

type Triple = [f64; 3];

fn unit(a: Triple) -> Triple {
    let length = a.iter().map(|it| it * it).sum::<f64>().sqrt();
    a.map(|it| it / length)
}

/// Returns the triangles of an icosahedron whose sides are halved, with corners on the unit sphere.
fn ball() -> Vec<[Triple; 3]> {
    let golden = f64::midpoint(1.0, 5f64.sqrt());
    let mut corners = Vec::new();
    for one in [-1.0, 1.0] {
        for other in [-golden, golden] {
            corners.extend([[0.0, one, other], [one, other, 0.0], [other, 0.0, one]]);
        }
    }
    let apart = |a: Triple, b: Triple| {
        let square: f64 = (0..3).map(|axis| (a[axis] - b[axis]).powi(2)).sum();
        square.sqrt()
    };
    let mut triangles = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                let [p, q, r] = [a, b, c].map(|it: usize| corners[it]);
                let sides = [apart(p, q), apart(q, r), apart(r, p)];
                if sides.iter().all(|side| (side - 2.0).abs() < 1e-9) {
                    triangles.push([p, q, r].map(unit));
                }
            }
        }
    }
    let halved = triangles.iter().flat_map(|&[p, q, r]| {
        let middle = |a: Triple, b: Triple| unit([0, 1, 2].map(|axis| a[axis] + b[axis]));
        let [s, t, u] = [middle(p, q), middle(q, r), middle(r, p)];
        [[p, s, u], [s, q, t], [u, t, r], [s, t, u]]
    });
    halved.collect()
}

fn furnished(mirror: f64) -> Result<(Scenery, [MaterialId; 4], Camera), Error> {
    let mut scene = Scenery::new();
    let ids = materials(&mut scene);
    let floor = Material::new([0.5, 0.6, 0.7]).mirror(mirror);
    let floor = scene.add_material(floor)?;
    scene.add_plane([0, 0, 0], [0, 0, 1], floor)?;
    scene.add_sphere([1.6, 1.0, 0.6], 0.6, ids[0])?;
    scene.add_light([3.0, -5.0, 6.0], [0.8; 3])?;
    scene.add_light([-6.0, -3.0, 3.0], [0.4; 3])?;
    scene.set_background([0.21, 0.29, 0.52])?;
    let camera = Camera::look_at([0.5, -6.0, 2.3], [0.1, 0.0, 1.0], UP).fov(45.0);
    Ok((scene, ids, camera))
}

/// A ball of 80 flat triangles, some of which mirror, above a mirroring floor.
fn facets() -> Result<(Scenery, Camera), Error> {
    let (mut scene, ids, camera) = furnished(0.5)?;
    for (index, corners) in ball().into_iter().enumerate() {
        let place = |it: Triple| [it[0] - 0.4, it[1], it[2] + 1.2];
        scene.add_triangle(corners.map(place), None, ids[index % 3])?;
    }
    Ok((scene, camera))
}

/// A ball of 20 triangles with the normals of a sphere, and triangles seen edge-on and as needles.
fn smooth() -> Result<(Scenery, Camera), Error> {
    let (mut scene, [red, gold, chalk, _], camera) = furnished(0.0)?;
    for corners in ball() {
        let place = |it: Triple| [0.8 * it[0] - 0.6, 0.8 * it[1], 0.8 * it[2] + 1.0];
        scene.add_triangle(corners.map(place), corners, red)?;
    }
    for corners in [
        // A needle of 1 to 10^4.
        [[1.0, -1.0, 0.5], [1.5, -1.0, 2.5], [1.5002, -1.0, 2.5]],
        // In the plane of the eye.
        [[0.5, -6.0, 2.3], [-1.0, 0.0, 2.3], [1.0, 0.0, 2.3]],
        [[0.9, 0.5, 1.6], [1.9, 0.5, 1.6], [1.4, -0.5, 1.9]],
    ] {
        scene.add_triangle(corners, None, chalk)?;
    }
    let leaning = [[-2.5, 1.0, 0.0], [-1.0, 1.5, 0.0], [-1.8, 1.6, 2.2]];
    let normals = [[-0.5, -1.0, 0.2], [0.5, -1.0, 0.0], [0.0, -1.0, -0.5]];
    scene.add_triangle(leaning, normals, gold)?;
    Ok((scene, camera))
}

/// Checks how near a scene is to double precision in every quality, and that `Fast` is within 1 of `Exact`.
fn assert_all_near<K: Shading>((scene, camera): (Scenery, Camera), shading: reference::Shading) {
    let (fast, small) = ([0.985, 0.998, 0.0], [0.99, 0.9995, 0.0]);
    let bars = [fast, small, [0.999, 0.9997, 0.0]];
    let [fast, _, exact] = assert_near::<K>((&scene, &camera), SIZE, shading, bars);
    let found = compare(&fast, &exact).unwrap();
    println!("fast and exact: {found:?}");
    assert!(found.within1 >= 0.999, "{found:?}");
}

#[test]
fn flat_triangles_are_painted_as_double_precision_paints_them() {
    assert_all_near::<BlinnPhong>(facets().unwrap(), reference::Shading::BlinnPhong);
}

#[test]
fn smooth_triangles_are_painted_as_double_precision_paints_them() {
    assert_all_near::<BlinnPhong>(smooth().unwrap(), reference::Shading::BlinnPhong);
    assert_all_near::<Phong>(smooth().unwrap(), reference::Shading::Phong);
}

/// A closed mesh around the camera hides the background from it.
#[test]
fn no_pixel_shows_what_is_outside_of_a_mesh() {
    let mut scene = Scenery::new();
    let grey = Material::new([0.5; 3]).ambient(1.0).diffuse(0.0);
    let grey = scene.add_material(grey).unwrap();
    for corners in ball() {
        scene.add_triangle(corners, None, grey).unwrap();
    }
    scene.set_background([1.0, 0.0, 0.0]).unwrap();
    let built = scene.build().unwrap();
    for target in [[0.0, 1.0, 0.0], [0.3, -0.2, 1.0], [-0.5, 0.1, -0.4]] {
        let camera = Camera::look_at([0.05, 0.1, -0.2], target, [0.1, 0.2, 0.9]).fov(120.0);
        for picture in [
            drawn::<Fast, BlinnPhong>(&built, &camera, Size::new_equal(200)),
            drawn::<Small, BlinnPhong>(&built, &camera, Size::new_equal(200)),
        ] {
            let is_grey = |[red, green, blue]: &[u8; 3]| red == green && green == blue;
            assert!(picture.pixels.iter().all(is_grey));
        }
    }
}

const CLAY: Material = Material::new([0.8, 0.5, 0.3]).ambient(0.2);
const FACE: [[f64; 3]; 3] = [[-1.0, 0.0, 0.0], [1.0, 0.0, 0.0], [0.0, 0.0, 1.5]];

scene! {
    /// A flat and a smooth triangle, in light that falls off.
    struct Sail {
        motion([-4.0, -4.0, -4.0], [4.0, 4.0, 4.0]);
        triangle(FACE, None, CLAY);
        triangle FORE([[0.2, -0.5, 0.0], [1.5, -0.5, 0.0], [0.2, -0.5, 1.2]],
            Some([[0.0, -1.0, 0.0], [0.7, -0.7, 0.0], [0.0, -0.7, 0.7]]), CLAY);
        light_with_range([3.0, -4.0, 6.0], [4.0; 3], 5.0);
    }
}

#[test]
fn constant_scene_is_the_same_picture_as_one_that_is_filled_and_moved() {
    let camera = Camera::look_at([0.3, -4.0, 1.0], [0.3, 0.0, 0.6], UP).fov(50.0);
    let size = Size::new(64, 64);
    let constant = drawn::<Fast, BlinnPhong>(&Sail, &camera, size);
    let mut scene = Scenery::new();
    let clay = scene.add_material(CLAY).unwrap();
    scene.set_motion([-4, -4, -4], [4, 4, 4]).unwrap();
    scene.add_triangle(FACE, None, clay).unwrap();
    let fore = scene.add_triangle(FACE, None, clay).unwrap();
    scene.add_light_with_range([3, -4, 6], [4; 3], 5).unwrap();
    let mut built = scene.build().unwrap();
    let corners = [[0.2, -0.5, 0.0], [1.5, -0.5, 0.0], [0.2, -0.5, 1.2]];
    let normals = [[0.0, -1.0, 0.0], [0.7, -0.7, 0.0], [0.0, -0.7, 0.7]];
    built.set_triangle(fore, corners, normals).unwrap();
    let filled = drawn::<Fast, BlinnPhong>(&built, &camera, size);
    assert_eq!(constant, filled);
    let mut moving = reflet::MovingScene::<Sail>::new();
    moving.set_triangle(Sail::FORE, FACE, None).unwrap();
    let moved = drawn::<Fast, BlinnPhong>(&moving, &camera, size);
    assert_ne!(constant, moved);
    let moved_back = moving.set_triangle(Sail::FORE, corners, Some(normals));
    moved_back.unwrap();
    let back = drawn::<Fast, BlinnPhong>(&moving, &camera, size);
    assert_eq!(constant, back);
}
