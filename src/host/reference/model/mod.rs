//! The formulas of the model, each written once: the ray of a pixel, its nearest hit, and the light
//! there.
//!
//! These files are compiled for the reference, and again for each comparison in single precision
//! (`xtask/float_picture`, `xtask/float_port`). `float_port` runs on boards, so these files use neither
//! `std` nor an allocator. The module `real` beside them defines the number type.
//!
//! The sum of the colours along a path of mirrors is not computed here. The reference and the float
//! port each do that in their own way.

mod scene;
mod shade;
mod shape;
mod vector;
mod view;

pub use self::scene::*;
pub use self::shape::*;
pub use self::vector::{Vector, quantised};
pub use self::view::{Camera, View};
use super::Shading;
use super::real::{IS_CAREFUL, Real, power, square_root, tangent};
