//! The reference's scene: plain doubles as anyone may fill them in; it checks and renders nothing.

use std::vec::Vec;

/// A scene in plain doubles.
///
/// Nothing is checked: a shape without size, a normal or an axis of length zero is never met, and
/// a material that is not in the list panics when the scene is rendered.
#[derive(Clone, Debug, PartialEq)]
pub struct Scene {
    /// The spheres.
    pub spheres: Vec<Sphere>,
    /// The infinite planes.
    pub planes: Vec<Plane>,
    /// The open cylinders.
    pub cylinders: Vec<Cylinder>,
    /// The point lights.
    pub lights: Vec<Light>,
    /// What the shapes are made of; they name it by its place in this list.
    pub materials: Vec<Material>,
    /// Linear colour where a ray meets nothing.
    pub background: [f64; 3],
    /// How far from a surface, along its normal, shadow and reflected rays start; in scene units.
    pub epsilon: f64,
}

impl Default for Scene {
    /// Nothing at all, on black, with an epsilon of 0.001.
    fn default() -> Self {
        Self {
            spheres: Vec::new(),
            planes: Vec::new(),
            cylinders: Vec::new(),
            lights: Vec::new(),
            materials: Vec::new(),
            background: [0.0; 3],
            epsilon: 1e-3,
        }
    }
}

/// A sphere.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Sphere {
    /// Its centre.
    pub center: [f64; 3],
    /// Its radius.
    pub radius: f64,
    /// Its place in [`Scene::materials`].
    pub material: usize,
}

/// An infinite plane, seen from both sides.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Plane {
    /// Any point in it.
    pub point: [f64; 3],
    /// What stands upright on it, of any length.
    pub normal: [f64; 3],
    /// Its place in [`Scene::materials`].
    pub material: usize,
}

/// A tube without caps, seen from outside and inside.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Cylinder {
    /// The middle of its axis.
    pub center: [f64; 3],
    /// The direction of its axis, of any length.
    pub axis: [f64; 3],
    /// Its radius.
    pub radius: f64,
    /// Its length along the axis, half of it to each side of the centre.
    pub height: f64,
    /// Its place in [`Scene::materials`].
    pub material: usize,
}

/// A point light that does not fall off with distance.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Light {
    /// Where it stands.
    pub position: [f64; 3],
    /// Its linear colour.
    pub color: [f64; 3],
}

/// What a surface is made of.
#[derive(Clone, Copy, Debug, PartialEq)]
pub struct Material {
    /// Linear colour.
    pub color: [f64; 3],
    /// Share of the colour that is there without any light.
    pub ambient: f64,
    /// Share of the light that is scattered evenly.
    pub diffuse: f64,
    /// Strength of the highlight, which has the material's colour too.
    pub specular: f64,
    /// The highlight's exponent; with 0 the highlight is everywhere the light is.
    pub shininess: f64,
    /// α, 0 to 1: the share of the picture in this surface.
    pub mirror: f64,
}
