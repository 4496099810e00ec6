//! Prepares a described scene for the model: rounds every double to `Real` and gives every direction
//! unit length.

use std::vec::Vec;

use super::{
    Camera, Checker, Cylinder, Disc, Light, Material, Plane, Real, Scene, Shape, Sky, Sphere,
    Triangle, model,
};

macro_rules! prepared {
    ($parameters:tt $({ $list:ident $kind:ident $described:ident $($more:tt)* })*) => {
        /// A scene prepared for tracing. It owns the lists that a [`model::Scene`] borrows.
        #[derive(Clone, Debug)]
        pub struct Prepared {
            $($list: Vec<model::$described>,)*
            lights: Vec<model::Light>,
            materials: Vec<model::Material>,
            background: model::Vector,
            sky: Option<model::Sky>,
            epsilon: Real,
        }

        impl Prepared {
            /// Prepares a scene for tracing.
            ///
            /// # Panics
            ///
            /// A shape names a material that the scene does not have.
            pub fn new(scene: &Scene) -> Self {
                for Shape { material, .. } in scene.shapes() {
                    assert!(material < scene.materials.len(), "no material {material}");
                }
                Self {
                    $($list: scene.$list.iter().map($kind).collect(),)*
                    lights: scene.lights.iter().map(light).collect(),
                    materials: scene.materials.iter().map(material).collect(),
                    background: vector(scene.background),
                    sky: scene.sky.as_ref().map(sky),
                    epsilon: scene.epsilon as Real,
                }
            }

            /// Returns the scene that the model traces rays in; it borrows the lists.
            pub fn scene(&self) -> model::Scene<'_> {
                model::Scene {
                    $($list: &self.$list,)*
                    lights: &self.lights,
                    materials: &self.materials,
                    background: self.background,
                    sky: self.sky,
                    epsilon: self.epsilon,
                }
            }
        }
    };
}
kinds!(shapes, prepared);

fn sphere(sphere: &Sphere) -> model::Sphere {
    model::Sphere {
        center: vector(sphere.center),
        radius: sphere.radius as Real,
        material: sphere.material,
    }
}

fn plane(plane: &Plane) -> model::Plane {
    model::Plane {
        point: vector(plane.point),
        normal: vector(plane.normal).unit(),
        material: plane.material,
    }
}

fn cylinder(cylinder: &Cylinder) -> model::Cylinder {
    model::Cylinder {
        center: vector(cylinder.center),
        axis: vector(cylinder.axis).unit(),
        radius: cylinder.radius as Real,
        half_height: cylinder.height as Real / 2.0,
        material: cylinder.material,
    }
}

fn disc(disc: &Disc) -> model::Disc {
    model::Disc {
        center: vector(disc.center),
        normal: vector(disc.normal).unit(),
        radius: disc.radius as Real,
        material: disc.material,
    }
}

fn triangle(triangle: &Triangle) -> model::Triangle {
    let [corner, second, third] = triangle.corners.map(vector);
    let unit = |normal| vector(normal).unit();
    model::Triangle {
        corner,
        sides: [second - corner, third - corner],
        normals: triangle.normals.map(|it| it.map(unit)),
        material: triangle.material,
    }
}

fn sky(sky: &Sky) -> model::Sky {
    model::Sky {
        up: vector(sky.up).unit(),
        below: vector(sky.below),
        horizon: vector(sky.horizon),
        above: vector(sky.above),
    }
}

fn light(light: &Light) -> model::Light {
    let position = vector(light.position);
    model::Light {
        position: if light.sun.is_some() { position.unit() } else { position },
        color: vector(light.color),
        sun: light.sun.map(|degrees| {
            if degrees > 0.0 { (degrees.to_radians() / 2.0).cos() as Real } else { 2.0 }
        }),
        range: light.range.map(|range| range as Real),
    }
}

fn material(material: &Material) -> model::Material {
    model::Material {
        color: vector(material.color),
        ambient: material.ambient as Real,
        diffuse: material.diffuse as Real,
        specular: material.specular as Real,
        shininess: material.shininess as Real,
        mirror: material.mirror as Real,
        checker: material.checker.as_ref().map(checker),
    }
}

fn checker(checker: &Checker) -> model::Checker {
    let cells = |size: f64| if size > 0.0 { 1.0 / size } else { 0.0 };
    model::Checker {
        color: vector(checker.color),
        cells: vector(checker.size.map(cells)),
    }
}

/// Prepares a camera for the model: rounds its doubles to `Real`. A [`model::View`] is made of it.
pub fn camera(camera: &Camera) -> model::Camera {
    model::Camera {
        position: vector(camera.position),
        target: vector(camera.target),
        up: vector(camera.up),
        fov: camera.fov as Real,
    }
}

fn vector(numbers: [f64; 3]) -> model::Vector {
    model::Vector(numbers.map(|number| number as Real))
}
