//! Tests lights and cameras that are far from the shapes, beyond the near region.

use embedded_graphics::prelude::Size;
use reflet::host::compare::compare;
use reflet::host::painted;
use reflet::host::reference::{Picture, Shading, render};
use reflet::quality::Exact;
use reflet::{Camera, Material, RuntimeScene, room};

type Room = RuntimeScene<room!(spheres: 1, planes: 2, lights: 1, materials: 1)>;

/// Returns the picture in fixed point. Checks that it is within 1 of the reference in every pixel.
fn exact(scene: &Room, camera: &Camera) -> Picture {
    let built = scene.build().unwrap();
    let frame = built.frame(camera).quality::<Exact>();
    let picture = painted(&frame.prepare(Size::new(33, 33)).on(&built).unwrap());
    let (scene, camera) = ((&scene.description()).into(), camera.into());
    let truth = render(&scene, &camera, 33, 33, 4, Shading::BlinnPhong);
    let difference = compare(&picture, &truth).unwrap();
    assert_eq!(difference.within1, 1.0, "{difference:?}");
    picture
}

#[test]
fn shape_behind_a_light_casts_no_shadow() {
    let mut scene = Room::new();
    let chalk = Material::new([0.4; 3]).ambient(0.0).diffuse(1.0);
    let chalk = scene.add_material(chalk).unwrap();
    scene.add_sphere([0, 0, 0], 1, chalk).unwrap();
    scene.add_plane([0, 0, -1], [0, 0, 1], chalk).unwrap();
    scene.add_light([20.0, 0.0, -0.5], [16.0; 3]).unwrap();
    let camera = Camera::new([40, 0, 5], [40, 0, -1], [0, 1, 0], 50).unwrap();
    let middle = exact(&scene, &camera).pixels[16 * 33 + 16];
    assert_ne!(middle, [0; 3], "without ambient light a shadow is black");
}

#[test]
fn sun_costs_planes_no_bits() {
    let [near, mid, far] = [1e3, 1e6, 1e9].map(|height| {
        let mut scene = Room::new();
        let chalk = Material::new([0.9, 0.5, 0.3])
            .ambient(0.3)
            .diffuse(0.0)
            .mirror(0.5);
        let chalk = scene.add_material(chalk).unwrap();
        scene.add_plane([0, 0, 0], [0, 0, 1], chalk).unwrap();
        scene.add_plane([0, 5, 0], [0, 1, 0], chalk).unwrap();
        scene.add_light([0.0, 0.0, height], [1.0; 3]).unwrap();
        let camera = Camera::new([0.0, 0.0, 1.3], [0.0, 5.0, 0.5], [0.0, 0.0, 1.0], 60).unwrap();
        scene.set_camera(camera);
        exact(&scene, &camera)
    });
    assert!(near.pixels == mid.pixels && near.pixels == far.pixels);
}
