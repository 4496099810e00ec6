//! The source text, before it is laid out.

use std::collections::BTreeSet;

use reflet::host::reference::{Camera, Cylinder, Light, Material, Plane, Scene, Sphere};

/// How far rays are lifted off surfaces unless the scene says otherwise.
const EPSILON: f64 = 1e-3;

/// The source of a constant scene; `materials` are the names of the materials' constants.
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
    let scene_type = format!(
        "Scene<{}, {}, {}, {}, {}>",
        scene.spheres.len(),
        scene.planes.len(),
        scene.cylinders.len(),
        scene.lights.len(),
        used.len(),
    );
    let import = if used.is_empty() { "" } else { "Material, " };
    let name = name.escape_debug();
    format!(
        "//! The scene `{name}`, written from a scene file by `cargo xtask scene`.\n\n\
         use reflet::{{Camera, {import}Scene, StaticScene}};\n\n\
         {constants}\n\
         /// The view the scene was made for.\n\
         pub const CAMERA: Camera = Camera::look_at({}, {}, {}).fov({});\n\n\
         /// The scene `{name}`.\n\
         #[derive(Clone, Copy, Debug)]\n\
         pub struct {type_name};\n\n\
         impl StaticScene for {type_name} {{\n\
             type Scene = {scene_type}; // spheres, planes, cylinders, lights, materials\n\
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
    let spheres = scene.spheres.iter().map(|sphere| sphere.material);
    let planes = scene.planes.iter().map(|plane| plane.material);
    let cylinders = scene.cylinders.iter().map(|cylinder| cylinder.material);
    spheres.chain(planes).chain(cylinders).collect()
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
    let sphere = |it: &Sphere| {
        let (center, radius) = (vector(it.center), number(it.radius));
        format!(".sphere({center}, {radius}, {})", materials[it.material])
    };
    let plane = |it: &Plane| {
        let (point, normal) = (vector(it.point), vector(it.normal));
        format!(".plane({point}, {normal}, {})", materials[it.material])
    };
    let cylinder = |it: &Cylinder| {
        let (center, axis) = (vector(it.center), vector(it.axis));
        let (radius, height) = (number(it.radius), number(it.height));
        let material = &materials[it.material];
        format!(".cylinder({center}, {axis}, {radius}, {height}, {material})")
    };
    let light = |it: &Light| format!(".light({}, {})", vector(it.position), vector(it.color));
    let mut text = String::from("Scene::builder()");
    text.extend(scene.spheres.iter().map(sphere));
    text.extend(scene.planes.iter().map(plane));
    text.extend(scene.cylinders.iter().map(cylinder));
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

/// The shortest digits that are read as the same number again.
fn number(value: f64) -> String {
    format!("{value:?}")
}
