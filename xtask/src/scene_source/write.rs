//! Writes the Rust source of a scene, before rustfmt formats it.

use std::collections::BTreeSet;

use reflet::host::reference::{Camera, Light, Material, PARAMETERS, Scene, Shape};

/// Default of a scene's epsilon, the distance by which rays are lifted off surfaces.
const EPSILON: f64 = 1e-3;

/// Returns the source of a constant scene. `materials` are the names of the materials' constants.
pub fn source(
    name: &str,
    type_name: &str,
    materials: &[String],
    scene: &Scene,
    camera: &Camera,
) -> String {
    let used = used_materials(scene);
    let mut constants = String::new();
    for index in &used {
        let material = constant(&materials[*index], &scene.materials[*index]);
        constants += &material;
    }
    let room = room(scene, used.len());
    let (lists, counts): (Vec<_>, Vec<_>) = room.into_iter().unzip();
    let (lists, scene_type) = (lists.join(", "), format!("Scene<{}>", counts.join(", ")));
    let import = if used.is_empty() { "" } else { "Material, " };
    let name = name.escape_debug();
    format!(
        "//! The scene `{name}`, written from a scene file by `cargo xtask scene`.\n\n\
         use reflet::Camera;
         use reflet::{import}Scene;\n\n\
         {constants}\n\
         /// The view the scene was made for.\n\
         pub const CAMERA: Camera = Camera::look_at({}, {}, {}).fov({});\n\n\
         /// The scene `{name}`.\n\
         #[derive(Clone, Copy, Debug)]\n\
         pub struct {type_name};\n\n\
         impl StaticScene for {type_name} {{\n\
             type Scene = {scene_type}; // {lists}\n\
             const SCENE: &'static Self::Scene = &{};\n\
         }}\n",
        vector(camera.position),
        vector(camera.target),
        vector(camera.up),
        number(camera.fov),
        builder(scene, materials),
    )
}

fn used_materials(scene: &Scene) -> BTreeSet<usize> {
    scene.shapes().map(|shape| shape.material).collect()
}

/// Returns the parameters of the scene's type: the name of each list and its length. Zeros at the
/// end are left out down to the materials: the type's defaults are 0.
fn room(scene: &Scene, materials: usize) -> Vec<(&'static str, String)> {
    let count = |list: &str| match list {
        "lights" => scene.lights.len(),
        "materials" => materials,
        list => scene.shapes().filter(|shape| shape.list == list).count(),
    };
    let mut room: Vec<_> = PARAMETERS.iter().map(|list| (*list, count(list))).collect();
    while room.pop_if(|it| it.0 != "materials" && it.1 == 0).is_some() {}
    room.into_iter()
        .map(|(list, count)| (list, count.to_string()))
        .collect()
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
    text + ";\n"
}

fn builder(scene: &Scene, materials: &[String]) -> String {
    let shape = |it: Shape| {
        let fields: String = it
            .fields
            .iter()
            .map(|field| format!("{field:?}, "))
            .collect();
        format!(".{}({fields}{})", it.kind, materials[it.material])
    };
    let light = |it: &Light| format!(".light({}, {})", vector(it.position), vector(it.color));
    let mut text = String::from("Scene::builder()");
    text.extend(scene.shapes().map(shape));
    text.extend(scene.lights.iter().map(light));
    if scene.background != [0.0; 3] {
        text += &format!(".background({})", vector(scene.background));
    }
    if scene.epsilon != EPSILON {
        text += &format!(".epsilon({})", number(scene.epsilon));
    }
    text + ".camera(CAMERA).build()"
}

fn vector([x, y, z]: [f64; 3]) -> String {
    format!("[{}, {}, {}]", number(x), number(y), number(z))
}

/// Returns the shortest digits that parse to the same number.
fn number(value: f64) -> String {
    format!("{value:?}")
}
