//! A scene as constants.

use crate::vector::Vector;

/// A scene; shapes name their material by its place.
#[derive(Clone, Copy, Debug)]
pub struct Scene<'a> {
    /// The spheres.
    pub spheres: &'a [Sphere],
    /// The planes.
    pub planes: &'a [Plane],
    /// The open cylinders.
    pub cylinders: &'a [Cylinder],
    /// The lights.
    pub lights: &'a [Light],
    /// The materials.
    pub materials: &'a [Material],
    /// What a ray that meets nothing adds.
    pub background: Vector,
    /// How far a ray is lifted off the surface it leaves.
    pub epsilon: f32,
}

/// A sphere.
#[derive(Clone, Copy, Debug)]
pub struct Sphere {
    /// Its centre.
    pub center: Vector,
    /// Its radius.
    pub radius: f32,
    /// Its place in [`Scene::materials`].
    pub material: usize,
}

/// An infinite plane.
#[derive(Clone, Copy, Debug)]
pub struct Plane {
    /// A point in it.
    pub point: Vector,
    /// Of length one.
    pub normal: Vector,
    /// Its place in [`Scene::materials`].
    pub material: usize,
}

/// An open cylinder.
#[derive(Clone, Copy, Debug)]
pub struct Cylinder {
    /// Its middle.
    pub center: Vector,
    /// Of length one.
    pub axis: Vector,
    /// Its radius.
    pub radius: f32,
    /// Half its height.
    pub half_height: f32,
    /// Its place in [`Scene::materials`].
    pub material: usize,
}

/// A point light.
#[derive(Clone, Copy, Debug)]
pub struct Light {
    /// Where it stands.
    pub position: Vector,
    /// Its colour.
    pub color: Vector,
}

/// What a surface is made of.
#[derive(Clone, Copy, Debug)]
pub struct Material {
    /// Its colour.
    pub color: Vector,
    /// Share of the colour without any light.
    pub ambient: f32,
    /// Share of the light scattered evenly.
    pub diffuse: f32,
    /// Strength of the highlight.
    pub specular: f32,
    /// Its exponent.
    pub shininess: f32,
    /// Share of what is shown that is a reflection.
    pub mirror: f32,
}
