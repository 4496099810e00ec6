//! A scene as the Rust source of the float port's constants.

use reflet::host::reference::{Camera, Cylinder, Light, Material, Plane, Scene, Sphere};

/// The expression of a scene.
pub fn scene(scene: &Scene) -> String {
    format!(
        "float_port::Scene {{ spheres: &{}, planes: &{}, cylinders: &{}, lights: &{}, materials: &{}, \
         background: {}, epsilon: {} }}",
        list(&scene.spheres, sphere),
        list(&scene.planes, plane),
        list(&scene.cylinders, cylinder),
        list(&scene.lights, light),
        list(&scene.materials, material),
        vector(scene.background),
        number(scene.epsilon),
    )
}

/// The expression of a camera.
pub fn camera(camera: &Camera) -> String {
    format!(
        "float_port::Camera {{ position: {}, target: {}, up: {}, fov: {} }}",
        vector(camera.position),
        vector(camera.target),
        vector(camera.up),
        number(camera.fov),
    )
}

fn sphere(sphere: &Sphere) -> String {
    format!(
        "float_port::Sphere {{ center: {}, radius: {}, material: {} }}",
        vector(sphere.center),
        number(sphere.radius),
        sphere.material,
    )
}

fn plane(plane: &Plane) -> String {
    format!(
        "float_port::Plane {{ point: {}, normal: {}, material: {} }}",
        vector(plane.point),
        vector(unit(plane.normal)),
        plane.material,
    )
}

fn cylinder(cylinder: &Cylinder) -> String {
    format!(
        "float_port::Cylinder {{ center: {}, axis: {}, radius: {}, half_height: {}, material: {} }}",
        vector(cylinder.center),
        vector(unit(cylinder.axis)),
        number(cylinder.radius),
        number(cylinder.height / 2.0),
        cylinder.material,
    )
}

fn light(light: &Light) -> String {
    format!(
        "float_port::Light {{ position: {}, color: {} }}",
        vector(light.position),
        vector(light.color),
    )
}

fn material(material: &Material) -> String {
    format!(
        "float_port::Material {{ color: {}, ambient: {}, diffuse: {}, specular: {}, shininess: {}, \
         mirror: {} }}",
        vector(material.color),
        number(material.ambient),
        number(material.diffuse),
        number(material.specular),
        number(material.shininess),
        number(material.mirror),
    )
}

fn list<T>(items: &[T], item: fn(&T) -> String) -> String {
    let items: Vec<_> = items.iter().map(item).collect();
    format!("[{}]", items.join(", "))
}

fn vector([x, y, z]: [f64; 3]) -> String {
    format!(
        "float_port::Vector::new({}, {}, {})",
        number(x),
        number(y),
        number(z)
    )
}

/// The nearest `f32`, in as many digits as it takes.
fn number(value: f64) -> String {
    format!("{:?}", value as f32)
}

fn unit(vector: [f64; 3]) -> [f64; 3] {
    let square: f64 = vector
        .iter()
        .map(|coordinate| coordinate * coordinate)
        .sum();
    vector.map(|coordinate| coordinate / square.sqrt())
}
