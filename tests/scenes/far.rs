//! Tests lights and cameras that are far from the shapes, beyond the near region.

use embedded_graphics::prelude::Size;
use reflet::host::reference::{Picture, Shading};
use reflet::shading::BlinnPhong;
use reflet::{Camera, Material};

use super::near::{Scenery, assert_near};

/// Returns the picture in `Exact`. Checks that it is within 1 of the reference in every pixel.
fn exact(scene: &Scenery, camera: &Camera) -> Picture {
    let bars = [[0.0; 3], [0.0; 3], [0.0, 1.0, 0.0]];
    let (seen, size) = ((scene, camera), Size::new(33, 33));
    let [.., exact] = assert_near::<BlinnPhong>(seen, size, Shading::BlinnPhong, bars);
    exact
}

#[test]
fn shape_behind_a_light_casts_no_shadow() {
    let mut scene = Scenery::new();
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
        let mut scene = Scenery::new();
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
