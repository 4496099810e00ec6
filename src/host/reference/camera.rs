//! Where a picture is taken from, as anyone may fill it in; it makes no ray.

use serde::Deserialize;

/// Where a picture is taken from, in plain doubles.
///
/// Nothing is checked: `target` differs from `position`, `up` is not along the view, and `fov` is
/// between 0 and 180.
#[derive(Clone, Debug, PartialEq, Deserialize)]
#[serde(deny_unknown_fields)]
pub struct Camera {
    /// Where it stands.
    pub position: [f64; 3],
    /// What it looks at: the middle of the picture.
    pub target: [f64; 3],
    /// What is up; only its direction across the view matters.
    pub up: [f64; 3],
    /// Full horizontal field of view in degrees.
    pub fov: f64,
}
