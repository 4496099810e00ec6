//! What is wrong with a scene, and where.

use core::fmt;

use crate::fault::Fault;

/// A part of a scene, and what is wrong with it. Parts are counted from 0.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum SceneError {
    /// The sphere with this number.
    Sphere(usize, Fault),
    /// The plane with this number.
    Plane(usize, Fault),
    /// The cylinder with this number.
    Cylinder(usize, Fault),
    /// The light with this number.
    Light(usize, Fault),
    /// The material with this number.
    Material(usize, Fault),
    /// The scene as a whole.
    Scene(Fault),
}

impl SceneError {
    /// What is wrong.
    pub const fn fault(self) -> Fault {
        match self {
            Self::Sphere(_, fault)
            | Self::Plane(_, fault)
            | Self::Cylinder(_, fault)
            | Self::Light(_, fault)
            | Self::Material(_, fault)
            | Self::Scene(fault) => fault,
        }
    }
}

impl fmt::Display for SceneError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        match self {
            Self::Sphere(index, fault) => write!(formatter, "sphere {index}: {fault}"),
            Self::Plane(index, fault) => write!(formatter, "plane {index}: {fault}"),
            Self::Cylinder(index, fault) => write!(formatter, "cylinder {index}: {fault}"),
            Self::Light(index, fault) => write!(formatter, "light {index}: {fault}"),
            Self::Material(index, fault) => write!(formatter, "material {index}: {fault}"),
            Self::Scene(fault) => write!(formatter, "scene: {fault}"),
        }
    }
}

impl core::error::Error for SceneError {}
