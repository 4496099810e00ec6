//! Pictures in single precision, in the form that the reference's are compared in: of the float port,
//! as a program on a board would be written, and of the reference's own formulas.
#![deny(missing_docs)]

pub mod single;

pub use float_port::Shading;
use float_port::{Camera, Cylinder, Light, Material, Plane, Scene, Sphere, Vector, View};
use reflet::host::reference;

fn vector([x, y, z]: [f64; 3]) -> Vector {
    Vector::new(x as f32, y as f32, z as f32)
}

fn unit(direction: [f64; 3]) -> Vector {
    let square: f64 = direction.iter().map(|it| it * it).sum();
    vector(direction.map(|coordinate| coordinate / square.sqrt()))
}

/// The float port's picture of a scene, every number of which is the nearest `f32`.
pub fn render(
    scene: &reference::Scene,
    camera: &reference::Camera,
    (width, height): (u32, u32),
    reflections: u32,
    shading: Shading,
) -> reference::Picture {
    let spheres = scene.spheres.iter().map(|sphere| Sphere {
        center: vector(sphere.center),
        radius: sphere.radius as f32,
        material: sphere.material,
    });
    let planes = scene.planes.iter().map(|plane| Plane {
        point: vector(plane.point),
        normal: unit(plane.normal),
        material: plane.material,
    });
    let cylinders = scene.cylinders.iter().map(|cylinder| Cylinder {
        center: vector(cylinder.center),
        axis: unit(cylinder.axis),
        radius: cylinder.radius as f32,
        half_height: cylinder.height as f32 / 2.0,
        material: cylinder.material,
    });
    let lights = scene.lights.iter().map(|light| Light {
        position: vector(light.position),
        color: vector(light.color),
    });
    let materials = scene.materials.iter().map(|material| Material {
        color: vector(material.color),
        ambient: material.ambient as f32,
        diffuse: material.diffuse as f32,
        specular: material.specular as f32,
        shininess: material.shininess as f32,
        mirror: material.mirror as f32,
    });
    let scene = Scene {
        spheres: &spheres.collect::<Vec<_>>(),
        planes: &planes.collect::<Vec<_>>(),
        cylinders: &cylinders.collect::<Vec<_>>(),
        lights: &lights.collect::<Vec<_>>(),
        materials: &materials.collect::<Vec<_>>(),
        background: vector(scene.background),
        epsilon: scene.epsilon as f32,
    };
    let camera = Camera {
        position: vector(camera.position),
        target: vector(camera.target),
        up: vector(camera.up),
        fov: camera.fov as f32,
    };
    let view = View::new(&camera, (width, height));
    let places = (0..height).flat_map(|y| (0..width).map(move |x| (x, y)));
    let pixels =
        places.map(|(x, y)| float_port::pixel(&scene, shading, &view.ray(x, y), reflections));
    reference::Picture {
        width,
        height,
        pixels: pixels.collect(),
    }
}
