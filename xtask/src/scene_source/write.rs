//! Writes the Rust source of a scene, before rustfmt formats it.

use std::collections::BTreeSet;

use reflet::host::reference::{Camera, Light, Material, Scene, Shape};

use super::moving::Moving;

/// Default of a scene's epsilon, the distance by which rays are lifted off surfaces.
const EPSILON: f64 = 1e-3;

/// Returns the source of a constant scene. `materials` are the names of the materials' constants;
/// `moving` is the shape that moves, if one does.
pub fn source(
    [name, type_name]: [&str; 2],
    materials: &[String],
    scene: &Scene,
    camera: &Camera,
    moving: Option<&Moving>,
) -> String {
    let used = used_materials(scene);
    let mut constants = String::new();
    for index in &used {
        let material = constant(&materials[*index], &scene.materials[*index]);
        constants += &material;
    }
    let import = if used.is_empty() { "" } else { "Material, " };
    let name = name.escape_debug();
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
        parts(scene, materials, moving),
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
fn parts(scene: &Scene, materials: &[String], moving: Option<&Moving>) -> String {
    let mut is_first = moving.is_some();
    let shape = |it: Shape| {
        let moves = is_first && moving.is_some_and(|moving| moving.kind == it.kind);
        is_first &= !moves;
        let handle = if moves { " MOVING" } else { "" };
        let fields: Vec<_> = fields(&it).collect();
        let (fields, material) = (fields.join(", "), &materials[it.material]);
        format!("{}{handle}({fields}, {material})", it.kind)
    };
    let light = |it: &Light| format!("light({}, {})", vector(it.position), vector(it.color));
    let mut parts: Vec<String> = moving.map(Moving::motion).into_iter().collect();
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

/// Returns the arguments of a shape's line without the material.
pub(super) fn fields(shape: &Shape<'_>) -> impl Iterator<Item = String> {
    shape.fields.iter().map(|field| format!("{field:?}"))
}

pub(super) fn vector([x, y, z]: [f64; 3]) -> String {
    format!("[{}, {}, {}]", number(x), number(y), number(z))
}

/// Returns the shortest digits that parse to the same number.
fn number(value: f64) -> String {
    format!("{value:?}")
}
