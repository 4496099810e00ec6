//! A scene as the Rust source of the float port's constants.

use float_picture::port::{self, Prepared};
use reflet::host::reference::{Camera, Scene};

pub fn scene(scene: &Scene) -> String {
    let prepared = Prepared::new(scene);
    let scene = prepared.scene();
    // What `derive(Debug)` writes of plain data is Rust, but for the lists.
    format!(
        "{{ use float_port::*; Scene {{ spheres: &{:?}, planes: &{:?}, cylinders: &{:?}, \
         lights: &{:?}, materials: &{:?}, background: {:?}, epsilon: {:?} }} }}",
        scene.spheres,
        scene.planes,
        scene.cylinders,
        scene.lights,
        scene.materials,
        scene.background,
        scene.epsilon,
    )
}

pub fn camera(camera: &Camera) -> String {
    format!("{{ use float_port::*; {:?} }}", port::camera(camera))
}
