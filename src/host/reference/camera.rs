//! The camera of the reference: position, target, up and field of view. This file makes no rays.

use serde::Deserialize;

/// A camera of the reference, in doubles.
///
/// Nothing is checked. The caller makes sure that `target` differs from `position`, that `up` is not
/// parallel to the view, and that `fov` is between 0 and 180.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Position of the camera, in scene units.
    pub position: [f64; 3],
    /// Point that the camera looks at, in scene units. It is in the middle of the picture.
    pub target: [f64; 3],
    /// Direction that is up in the picture. Only its part perpendicular to the view direction matters.
    pub up: [f64; 3],
    /// Full horizontal field of view in degrees.
    pub fov: f64,
}
