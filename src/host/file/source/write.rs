//! Writes the lines of the Rust source of a scene.

use alloc::borrow::ToOwned;
use alloc::collections::BTreeSet;
use alloc::string::String;
use alloc::vec::Vec;

use super::{Motion, RustSource};
use crate::host::reference::{Light, Material, Scene, Shape};

/// Default of a scene's epsilon, the distance by which rays are lifted off surfaces.
const EPSILON: f64 = 1e-3;

/// Returns the source of a constant scene. `materials` are the names of the materials' constants.
pub(super) fn text(source: &RustSource<'_>, type_name: &str, materials: &[String]) -> String {
    let (scene, camera) = (source.scene, &source.camera);
    let used = used_materials(scene);
    let mut constants = String::new();
    for index in &used {
        let material = constant(&materials[*index], &scene.materials[*index]);
        constants += &material;
    }
    let import = if used.is_empty() { "" } else { "Material, " };
    let name = source.name.escape_debug();
    format!(
        "//! The scene `{name}`, written from a scene file by `cargo xtask scene`.\n\n\
         use reflet::{{Camera, {import}scene}};\n\n\
         {constants}\n\
         /// The view the scene was made for.\n\
         pub const CAMERA: Camera = Camera::look_at({}, {}, {}).fov({});\n\n\
         scene! {{\n    \
             /// The scene `{name}`.\n    \
             pub struct {type_name} {{\n\
                 {}    \
             }}\n\
         }}\n",
        vector(camera.position),
        vector(camera.target),
        vector(camera.up),
        number(camera.fov),
        parts(scene, materials, source.motion.as_ref()),
    )
}

fn used_materials(scene: &Scene) -> BTreeSet<usize> {
    scene.shapes().map(|shape| shape.material).collect()
}

fn constant(name: &str, material: &Material) -> String {
    let mut text = format!(
        "const {name}: Material = Material::new({}).ambient({}).diffuse({}).specular({}, {})",
        vector(material.color),
        number(material.ambient),
        number(material.diffuse),
        number(material.specular),
        number(material.shininess),
    );
    if material.mirror != 0.0 {
        text += &format!(".mirror({})", number(material.mirror));
    }
    if let Some(checker) = &material.checker {
        let [color, size] = [checker.color, checker.size].map(vector);
        text += &format!(".checker({color}, {size})");
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
        let fields = it.fields.iter().map(|field| format!("{field:?}"));
        let (fields, material) = (
            fields.collect::<Vec<_>>().join(", "),
            &materials[it.material],
        );
        format!("{}{handle}({fields}, {material})", it.kind)
    };
    let light = |it: &Light| {
        let [position, color] = [it.position, it.color].map(vector);
        match (it.sun, it.range.map(number)) {
            (None, None) => format!("light({position}, {color})"),
            (None, Some(range)) => format!("light_with_range({position}, {color}, {range})"),
            (Some(0.0), _) => format!("sun({position}, {color})"),
            (Some(disc), _) => format!("sun_with_disc({position}, {color}, {})", number(disc)),
        }
    };
    let corners = |motion: &Motion| {
        let [low, high] = [motion.low, motion.high].map(vector);
        format!("motion({low}, {high})")
    };
    let mut parts: Vec<String> = motion.map(corners).into_iter().collect();
    parts.extend(scene.shapes().map(shape));
    parts.extend(scene.lights.iter().map(light));
    if let Some(sky) = &scene.sky {
        let [up, below, horizon, above] = [sky.up, sky.below, sky.horizon, sky.above].map(vector);
        parts.push(format!("sky({up}, [{below}, {horizon}, {above}])"));
    }
    if scene.background != [0.0; 3] {
        parts.push(format!("background({})", vector(scene.background)));
    }
    if scene.epsilon != EPSILON {
        parts.push(format!("epsilon({})", number(scene.epsilon)));
    }
    parts.push("camera(CAMERA)".to_owned());
    let line = |part: String| format!("        {part};\n");
    parts.into_iter().map(line).collect()
}

fn vector([x, y, z]: [f64; 3]) -> String {
    format!("[{}, {}, {}]", number(x), number(y), number(z))
}

/// Returns the shortest digits that parse to the same number.
fn number(value: f64) -> String {
    format!("{value:?}")
}
