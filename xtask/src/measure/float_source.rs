//! A scene as the Rust source of the float port's constants.

use float_picture::port::{self, Prepared};
use reflet::host::reference::{Camera, Scene};

use super::{Scene as Source, Shading};

/// How the firmware sees a scene: its `FloatView`.
pub fn view(scene: &Source, reflections: u8, shading: Shading) -> String {
    let (exact, eye) = scene.reference();
    let (scene, camera, shading) = (self::scene(&exact), camera(&eye), shading.type_name());
    format!(
        "impl firmware::FloatView for Seen {{\n\
             const SCENE: float_port::Scene<'static> = {scene};\n\
             const CAMERA: float_port::Camera = {camera};\n\
             const REFLECTIONS: u32 = {reflections};\n\
             const SHADING: float_port::Shading = float_port::Shading::{shading};\n\
         }}\n\n"
    )
}

fn scene(scene: &Scene) -> String {
    let prepared = Prepared::new(scene);
    // What `derive(Debug)` writes of plain data is Rust, but for the lists.
    let scene = format!("{:?}", prepared.scene()).replace(": [", ": &[");
    format!("{{ use float_port::*; {scene} }}")
}

fn camera(camera: &Camera) -> String {
    format!("{{ use float_port::*; {:?} }}", port::camera(camera))
}
