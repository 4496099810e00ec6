//! Tests discs in pictures: compared with double precision, seen edge-on, and where they close a
//! cylinder.

use embedded_graphics::prelude::Size;
use reflet::host::precision;
use reflet::host::reference::{self, bound::Paths};
use reflet::quality::{Exact, Fast, Quality, Small};
use reflet::shading::{BlinnPhong, Phong};
use reflet::{Camera, Error, Material, MaterialId};

use super::held::{ending, held};
use super::near::{Scenery, UP, assert_near, drawn};

const SIZE: Size = Size::new_equal(160);
const REFLECTIONS: u8 = 4;

pub fn materials(scene: &mut Scenery) -> [MaterialId; 4] {
    let red = Material::new([0.9, 0.2, 0.1]).ambient(0.2).diffuse(0.6);
    let gold = Material::new([0.7, 0.6, 0.0]).ambient(0.2).diffuse(0.4);
    let chalk = Material::new([0.9, 0.9, 0.8]).ambient(0.2).diffuse(0.8);
    let mirror = Material::new([1.0; 3]).ambient(0.0).diffuse(0.0);
    [
        red.specular(0.5, 20.0),
        gold.specular(0.8, 4.0).mirror(0.4),
        chalk,
        mirror.mirror(1.0),
    ]
    .map(|material| scene.add_material(material).unwrap())
}

/// Returns a leaning cylinder with a disc at each end, in front of a round mirror, under a lamp with
/// a shade.
fn lids() -> Result<(Scenery, Camera), Error> {
    let mut scene = Scenery::new();
    let [red, gold, chalk, mirror] = materials(&mut scene);
    scene.add_sphere([1.4, -0.5, 0.5], 0.5, gold)?;
    scene.add_plane([0, 0, 0], [0, 0, 1], chalk)?;
    let axis = [0.75, -0.5, 2.5];
    let half = 0.5 * f64::sqrt(0.75 * 0.75 + 0.5 * 0.5 + 2.5 * 2.5);
    let center = [-0.6, 0.0, 1.5];
    scene.add_cylinder(center, axis, 0.7, 2.0 * half, red)?;
    for (end, lid) in [(0.5, red), (-0.5, gold)] {
        let [x, y, z] = [0, 1, 2].map(|at| center[at] + end * axis[at]);
        scene.add_disc([x, y, z], axis, 0.7, lid)?;
    }
    for (center, normal, radius, id) in [
        ([1.2, 2.0, 1.5], [0.2, 1.0, -0.1], 1.3, mirror),
        ([0.5, -1.0, 3.3], [0.0, 0.2, 1.0], 0.5, gold),
        ([2.3, -1.0, 1.1], [0.98, 0.02, 0.195], 0.4, chalk),
    ] {
        scene.add_disc(center, normal, radius, id)?;
    }
    scene.add_light([0.5, -1.5, 5.0], [1.0; 3])?;
    scene.add_light([6.0, -4.0, 2.0], [0.4; 3])?;
    scene.set_background([0.21, 0.29, 0.52])?;
    let camera = Camera::look_at([2.5, -6.0, 3.3], [0.0, 0.0, 1.2], UP).fov(50.0);
    Ok((scene, camera))
}

/// Returns discs at the height of the eye: some of them mirrors, one that touches a ball, one
/// upright.
fn edges() -> Result<(Scenery, Camera), Error> {
    let mut scene = Scenery::new();
    let [red, gold, _, mirror] = materials(&mut scene);
    scene.add_sphere([0.0, 0.0, 1.5], 0.5, red)?;
    for (center, normal, radius, id) in [
        ([1.2, 0.0, 1.0], [0.0, 0.0, 1.0], 0.4, gold),
        ([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], 0.7, mirror),
        ([-0.2, 0.0, 0.9], [0.0, 0.03, 1.0], 0.7, gold),
        ([0.0, 0.0, 0.3], [1.0, 0.0, 0.0], 0.5, gold),
        ([-1.2, 0.0, 1.0], [1.0, 0.2, 0.05], 0.6, mirror),
    ] {
        scene.add_disc(center, normal, radius, id)?;
    }
    scene.add_light([2.0, -5.0, 4.0], [1.0; 3])?;
    scene.set_background([0.21, 0.29, 0.52])?;
    let camera = Camera::look_at([0.0, -6.0, 1.0], [0.0, 0.0, 1.0], UP).fov(40.0);
    Ok((scene, camera))
}

#[test]
fn discs_are_painted_as_double_precision_paints_them() {
    // `Fast` loses highlights that are narrower than a block.
    let bars = [
        [0.99, 0.998, 46.0],
        [0.9995, 0.9999, 46.0],
        [0.9999, 0.9999, 46.0],
    ];
    for (scene, camera) in [lids(), edges()].map(Result::unwrap) {
        let seen = (&scene, &camera);
        assert_near::<BlinnPhong>(seen, SIZE, reference::Shading::BlinnPhong, bars);
        assert_near::<Phong>(seen, SIZE, reference::Shading::Phong, bars);
    }
}

#[test]
fn no_pixel_of_a_disc_is_further_off_than_its_bound() {
    const ALL: usize = 200;
    const SIDE: u32 = 96;
    let shading = reference::Shading::BlinnPhong;
    for (scene, camera) in [lids(), edges()].map(Result::unwrap) {
        let exact = reference::Scene::from(&scene.description());
        let built = scene.build().unwrap();
        let found = drawn::<Fast, BlinnPhong>(&built, &camera, Size::new_equal(SIDE));
        let (precision, camera) = (precision(&built), (&camera).into());
        let paths = Paths::follow(&exact, &camera, (SIDE, SIDE), ALL, shading, &precision);
        let held = held(&paths, &ending::<Fast>(REFLECTIONS, SIDE), &found, ALL);
        println!("{held:?}");
        let is_sure = 3 * held.sure > held.pixels && 100 * held.decided < held.pixels;
        assert!(held.broken == 0 && is_sure, "{held:?}");
    }
}

/// Returns a closed black cylinder around a glowing ball. The ball's light is visible only through a
/// gap.
fn lantern(axis: [f64; 3]) -> Result<Scenery, Error> {
    let mut scene = Scenery::new();
    let dark = Material::new([0.0; 3]).ambient(0.0).diffuse(0.0);
    let shining = Material::new([1.0; 3]).ambient(1.0).diffuse(0.0);
    let dark = scene.add_material(dark)?;
    let shining = scene.add_material(shining)?;
    scene.add_sphere([0.0; 3], 0.99, shining)?;
    let half = f64::sqrt(axis.iter().map(|it| it * it).sum());
    scene.add_cylinder([0.0; 3], axis, 1.0, 2.0 * half, dark)?;
    scene.add_disc(axis, axis, 1.0, dark)?;
    scene.add_disc(axis.map(|it| -it), axis, 1.0, dark)?;
    Ok(scene)
}

fn assert_closed<Q: Quality>(scene: &Scenery, camera: &Camera) {
    let built = scene.build().unwrap();
    let picture = drawn::<Q, BlinnPhong>(&built, camera, SIZE);
    let gaps = picture.pixels.iter().filter(|it| **it != [0; 3]).count();
    assert_eq!(gaps, 0, "{:?}", camera.description());
}

#[test]
fn no_gap_shows_between_a_cylinder_and_the_discs_that_close_it() {
    for axis in [
        [0.0, 0.0, 1.0],
        [0.75, 0.0, 1.0],
        [0.3, -0.4, 0.9],
        [1.0, 1.0, 0.1],
    ] {
        let scene = lantern(axis).unwrap();
        for eye in [
            [0.0, -4.0, 0.0],
            [0.0, -4.0, 1.0],
            [3.0, -4.0, 2.5],
            [0.1, -0.2, 5.0],
            [-300.0, -400.0, 150.0],
        ] {
            let far: f64 = eye.iter().map(|it: &f64| it * it).sum::<f64>().sqrt();
            // The whole cylinder, and a part of the upper rim enlarged a hundred times.
            let [x, y, z] = axis;
            for (target, size) in [([0.0; 3], 3.0), ([x, y - 0.9, z], 0.03)] {
                let fov = 2.0 * (size / far).atan().to_degrees();
                let camera = Camera::look_at(eye, target, [0.1, 0.9, 1.0]).fov(fov);
                assert_closed::<Fast>(&scene, &camera);
                assert_closed::<Exact>(&scene, &camera);
                assert_closed::<Small>(&scene, &camera);
            }
        }
    }
}
