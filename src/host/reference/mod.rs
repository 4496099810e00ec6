//! The double-precision reference: computes the exact picture in `f64` with the textbook formulas.
//!
//! With the feature `files` alone, this module has the descriptions of scenes and cameras only.
//!
//! It is written independently of the fixed-point core and shares no code with it. The reference defines
//! a picture as follows:
//!
//! - **Camera**: rays go through pixel centres, row 0 on top. Forward is unit(target − position),
//!   right is unit(forward × up), and the vertical half-tangent is the horizontal one times
//!   height / width.
//! - **Hit**: the nearest t > 0 at which the ray hits a shape. Planes are infinite, and cylinders are
//!   open. The normal n faces the incoming ray.
//! - **Leaving a surface**: shadow and reflected rays start at q = p + ε n. Light directions and
//!   distances are taken from q.
//! - **Own colour** cᵢ: ambient · colour, and for every light with n·l > 0 that is not blocked
//!   (diffuse · n·l + specular · s^shininess) · colour · light colour. The highlight's s is n·h
//!   with h = unit(l + v) for Blinn-Phong and v·r for Phong, 0 where that is negative. A light is
//!   blocked if the ray from q hits a shape at t < distance − ε.
//! - **Mirrors**: cⁱ = (1 − αᵢ) cᵢ + αᵢ cⁱ⁺¹, where cⁱ is the background if ray i hits nothing
//!   and 0 if i exceeds the number of reflections.
//! - **Output**: round(255 c) after clamping to 0 to 1.
//!
//! ```
//! use reflet::host::reference::{Camera, Light, Material, Scene, Shading, Sphere, pixel};
//!
//! let chalk = Material {
//!     color: [1.0, 0.5, 0.0],
//!     ambient: 0.25,
//!     diffuse: 0.5,
//!     specular: 0.0,
//!     shininess: 1.0,
//!     mirror: 0.0,
//!     checker: None,
//! };
//! let scene = Scene {
//!     spheres: vec![Sphere { center: [0.0; 3], radius: 1.0, material: 0 }],
//!     lights: vec![Light { position: [0.0, -9.0, 0.0], color: [1.0; 3], sun: None, range: None }],
//!     materials: vec![chalk],
//!     ..Scene::default()
//! };
//! let camera =
//!     Camera { position: [0.0, -5.0, 0.0], target: [0.0; 3], up: [0.0, 0.0, 1.0], fov: 50.0 };
//! let color = pixel(&scene, &camera, (1, 1), (0, 0), 4, Shading::BlinnPhong);
//! assert_eq!(color, [0.75, 0.375, 0.0]);
//! ```

#[cfg(feature = "host")]
pub mod bound;
mod convert;
#[cfg(feature = "host")]
mod model;
#[cfg(feature = "host")]
mod picture;
#[cfg(feature = "host")]
mod prepared;
#[cfg(feature = "host")]
mod real;
mod scene;
#[cfg(feature = "host")]
mod shading;
#[cfg(feature = "host")]
mod trace;

#[cfg(feature = "host")]
pub use self::model::Vector;
#[cfg(feature = "host")]
pub use self::picture::{Picture, pixel, render, sampled};
pub use self::scene::*;
#[cfg(feature = "host")]
pub use self::shading::Shading;

/// Number type of all computations of the reference. `xtask/float_picture` compiles the same files with
/// `f32` instead.
#[cfg(feature = "host")]
type Real = f64;

#[cfg(feature = "host")]
#[cfg(test)]
mod tests;
