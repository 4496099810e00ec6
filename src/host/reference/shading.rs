//! The ways of shading.

/// How a hit becomes a colour.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Shading {
    /// The highlight by the angle between the normal and the half-way vector.
    BlinnPhong,
    /// The highlight by the angle between the mirrored light and the viewer.
    Phong,
    /// No light: the normal n of what is met first, as the colour (n + 1) / 2, and blue where
    /// nothing is met.
    Normals,
}
