//! The model's formulas, each written once: from a pixel's ray to the light of what it meets.
//!
//! These files are compiled for the reference, and once more for each rival in single precision
//! (`xtask/float_picture`, `xtask/float_port`), of which one runs on boards. So they use neither
//! `std` nor an allocator. What they compute in is said beside them, in the module `real`.
//!
//! How the colours along a path of mirrors add up is not written here: the reference and the float
//! port each do it in their own way.

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
