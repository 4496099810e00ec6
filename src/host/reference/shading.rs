//! The list of shading models of the reference.

/// The shading model: how the reference computes a colour at a hit.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// The highlight depends on the angle between the normal and the half-way vector, unit(light +
    /// viewer).
    BlinnPhong,
    /// The highlight depends on the angle between the mirrored light direction and the viewer.
    Phong,
    /// The colour is (n + 1) / 2, with n the normal at the first hit, and blue if the ray hits nothing.
    /// Lights and mirrors are ignored.
    Normals,
}
