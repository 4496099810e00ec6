//! Writes the lines of the Rust source of a scene. A number is written as `Debug` writes it: with the shortest
//! digits that parse to the same number.

use alloc::borrow::ToOwned;
use alloc::string::String;
use alloc::vec::Vec;

use super::{Motion, RustSource};
use crate::host::reference::{Checker, EPSILON, Light, Material, Scene, Shape};

/// Returns the source of a constant scene. `materials` are the names of the materials' constants.
pub(super) fn text(source: &RustSource<'_>, type_name: &str, materials: &[String]) -> String {
    let (scene, camera) = (source.scene, &source.camera);
    let is_used = |index: usize| scene.shapes().any(|shape| shape.material == index);
    let named = materials.iter().zip(&scene.materials).enumerate();
    let used = named.filter(|(index, _)| is_used(*index));
    let constants: String = used
        .map(|(_, (name, material))| constant(name, material))
        .collect();
    let import = if constants.is_empty() { "" } else { "Material, " };
    let name = source.name.escape_debug();
    format!(
        "//! The scene `{name}`, written from a scene file by `cargo xtask scene`.\n\n\
         use reflet::{{Camera, {import}scene}};\n\n\
         {constants}\n\
         /// The view the scene was made for.\n\
         pub const CAMERA: Camera = Camera::look_at({:?}, {:?}, {:?}).fov({:?});\n\n\
         scene! {{\n    \
             /// The scene `{name}`.\n    \
             pub struct {type_name} {{\n\
                 {}    \
             }}\n\
         }}\n",
        camera.position,
        camera.target,
        camera.up,
        camera.fov,
        parts(scene, materials, source.motion.as_ref()),
    )
}

fn constant(name: &str, material: &Material) -> String {
    let mut text = format!(
        "const {name}: Material = \
         Material::new({:?}).ambient({:?}).diffuse({:?}).specular({:?}, {:?})",
        material.color, material.ambient, material.diffuse, material.specular, material.shininess,
    );
    if material.mirror != 0.0 {
        text += &format!(".mirror({:?})", material.mirror);
    }
    if let Some(Checker { color, size }) = &material.checker {
        text += &format!(".checker({color:?}, {size:?})");
    }
    text + ";\n"
}

/// Returns a line for each part. rustfmt leaves what is inside of a macro as it is.
fn parts(scene: &Scene, materials: &[String], motion: Option<&Motion>) -> String {
    let mut is_first = motion.is_some();
    let shape = |it: Shape| {
        let moves = is_first && motion.is_some_and(|motion| motion.kind == it.kind);
        is_first &= !moves;
        let handle = if moves { " MOVING" } else { "" };
        let fields = it.fields.iter().map(|field| format!("{field:?}, "));
        let (fields, material) = (fields.collect::<String>(), &materials[it.material]);
        format!("{}{handle}({fields}{material})", it.kind)
    };
    let light = |it: &Light| {
        let (position, color) = (it.position, it.color);
        match (it.sun, it.range) {
            (None, None) => format!("light({position:?}, {color:?})"),
            (None, Some(range)) => format!("light_with_range({position:?}, {color:?}, {range:?})"),
            (Some(0.0), _) => format!("sun({position:?}, {color:?})"),
            (Some(disc), _) => format!("sun_with_disc({position:?}, {color:?}, {disc:?})"),
        }
    };
    let corners = |motion: &Motion| format!("motion({:?}, {:?})", motion.low, motion.high);
    let mut parts: Vec<String> = motion.map(corners).into_iter().collect();
    parts.extend(scene.shapes().map(shape));
    parts.extend(scene.lights.iter().map(light));
    if let Some(sky) = &scene.sky {
        let colors = [sky.below, sky.horizon, sky.above];
        parts.push(format!("sky({:?}, {colors:?})", sky.up));
    }
    if scene.background != [0.0; 3] {
        parts.push(format!("background({:?})", scene.background));
    }
    if scene.epsilon != EPSILON {
        parts.push(format!("epsilon({:?})", scene.epsilon));
    }
    parts.push("camera(CAMERA)".to_owned());
    let line = |part: String| format!("        {part};\n");
    parts.into_iter().map(line).collect()
}
