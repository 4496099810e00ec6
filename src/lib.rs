//! Ray-traced mirrors on microcontrollers.
//!
//! A bounded scene (spheres, planes, open cylinders, discs, point lights) is rendered in fixed point, a
//! row at a time and without a frame buffer, into any [embedded-graphics] `DrawTarget`. A pixel is
//!
//! > c = Σᵢ (1 − αᵢ) · (Π over k < i of αₖ) · cᵢ
//!
//! where αᵢ is how mirror-like the i-th surface met is, and cᵢ its colour by Phong or Blinn-Phong
//! without reflections. A ray that meets nothing adds the background, black unless it is named.
//!
//! # The smallest picture
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
//! use reflet::{Camera, Material, Scene, StaticFrame, StaticScene};
//!
//! const CHALK: Material = Material::new([0.9, 0.9, 0.8]);
//!
//! struct Ball;
//! impl StaticScene for Ball {
//!     type Scene = Scene<room!(spheres: 1, lights: 1)>; // spheres, planes, cylinders, lights
//!     const SCENE: &'static Self::Scene = &Scene::builder()
//!         .sphere([0.0, 0.0, 0.0], 1.0, CHALK)
//!         .light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0])
//!         .build();
//! }
//!
//! const CAMERA: Camera = Camera::look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
//!
//! let mut display = MockDisplay::<Rgb888>::new(); // 64 by 64
//! let report = Ball::frame(&CAMERA).draw(&mut display).unwrap();
//! assert!(report.rays < 64 * 64 / 2); // the other pixels lie between some that were traced
//! ```
//!
//! # Two ways to a scene
//!
//! - [`Scene::builder`] in a constant: plain decimal numbers, checked and prepared by the
//!   compiler, in flash. A bad scene does not compile. [`StaticScene`] makes it a type.
//! - [`RuntimeScene`]: filled while the program runs, up to the bounds of its type. A bad part is
//!   refused with a [`SceneError`].
//!
//! Both are drawn by the same kernels and give the same picture, to the bit, on every machine: no
//! float instruction is executed for a frame.
//!
//! # What is linked
//!
//! What a scene does not need is not in the program: it is derived from a constant scene, or from the
//! room in the type of one filled at run time; [`Needs`] says it in words. Where flash is scarcer than
//! time, the quality [`Small`] leaves out the tables and the code that make a frame fast.
//!
//! # The build profile of a firmware
//!
//! A firmware is smaller and faster with link-time optimisation and one codegen unit. Put this into its
//! `Cargo.toml`:
//!
//! ```toml
//! [profile.release]
//! codegen-units = 1
//! lto = true
//! ```
//!
//! Bytes of flash and instructions a pixel of two scenes at 64x64 on an emulated Cortex-M3, written by
//! `cargo xtask measure --profiles`:
//!
//! | profile | castle flash | castle instr/pixel | corner1 flash | corner1 instr/pixel |
//! |---|--:|--:|--:|--:|
//! | lto = true, codegen-units = 1 | 30752 | 1056 | 11644 | 197 |
//! | Cargo's default release | 39228 | 1084 | 14548 | 202 |
//! | lto = true, codegen-units = 1, opt-level = "s" | 28400 | 1563 | 12076 | 250 |
//! | lto = true, codegen-units = 1, opt-level = "z" | 28324 | 2215 | 12140 | 369 |
//! | Cargo's default dev (debug) | 259972 | 23351 | 231312 | 5005 |
//!
//! Every profile draws the same picture. Where flash is scarce, the quality [`Small`] saves more than an
//! `opt-level`.
//!
//! # The floors
//!
//! | floor | modules | what lives there |
//! |---|---|---|
//! | 8 | `display` | rows into a display, dithered if it has few levels |
//! | 7 | `render` | a frame made ready, its quality; a row's colours, most between traced ones |
//! | 6 | `trace` | one ray to one colour: the accumulation |
//! | 5 | `accel` | what only makes it faster: which shapes a ray need ask |
//! | 4 | `shade` | the light at one hit |
//! | 3 | `scene` | the checked scene; what a ray meets, whether it is blocked |
//! | 2 | `shape`, `camera`, `material`, `light` | intersections; a pixel's ray; plain data |
//! | 1 | `vector`, `ray`, `grid`, `color` | points, directions, rays, the scene's grid, linear colour |
//! | 0 | `number`, `fault`, `kinds` | the formats, shifts, roots; the words for what is wrong; the list of bounded kinds |
//!
//! A file uses only floors below its own. Beside them stand `scenes` (behind a feature of that
//! name) and `host` (likewise: the double-precision reference, image comparison and scene files;
//! needs `std`).
//!
//! # Numbers and their limits
//!
//! | what | range |
//! |---|---|
//! | coordinates, radii, heights | within ±2³⁰ scene units |
//! | extent of the shapes | at least 2⁻³⁰ scene units |
//! | smallest radius, half of the smallest height | 2⁻²² of the scene's extent |
//! | epsilon | above 0, below the scene's extent |
//! | distance at which a plane is still met | 2³³ extents |
//! | colours, ambient, diffuse, specular, lights | 0 to 16 |
//! | brightest that a material may be under its lights | 30 times white |
//! | shininess | 0 to 2²⁰, any real number |
//! | mirror (α) | 0 to 1 |
//! | field of view | 0.001 to 179.999 degrees |
//! | angle between view and up | at least 2⁻²⁴ |
//! | reflections | 0 to 255 |
//! | picture | 1 to 65535 pixels a side |
//!
//! The binary point of a scene is chosen when it is built: its shapes fill a ball of 2²⁸ steps (of
//! 2²⁵ where there are planes, fewer where lights, camera or planes stand up to 32 times as far; but
//! what the smallest shape and epsilon need of these bits stays theirs). So a scene in millimetres and
//! the same scene in kilometres give the same picture.
//!
//! # What is not supported
//!
//! Refraction, textures, soft shadows, anti-aliasing, triangles, light that falls
//! off with distance.
//!
//! # Features
//!
//! None is on by default. `scenes`: eleven ready scenes. `micromath`: its `F32` and vectors as
//! input for cameras and run-time scenes. `host`: see above. `window`: the simulator's window for
//! the `render` example.
//!
//! # Oldest supported Rust
//!
//! 1.87.
//!
//! [embedded-graphics]: https://docs.rs/embedded-graphics
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
// Overflow checks do not see an `as` that loses bits or a sign. `number::narrow` has functions that do.
#![cfg_attr(
    not(test),
    deny(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        clippy::cast_sign_loss
    )
)]

#[cfg(any(feature = "host", test))]
#[macro_use]
extern crate std;

#[macro_use]
mod kinds;

mod accel;
mod camera;
mod color;
pub mod display;
mod error;
mod fault;
mod grid;
#[cfg(feature = "host")]
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "the reference computes in floats"
)]
pub mod host;
mod light;
mod material;
mod number;
mod ray;
mod render;
mod scene;
#[cfg(feature = "scenes")]
#[allow(
    clippy::cast_possible_truncation,
    clippy::cast_possible_wrap,
    clippy::cast_sign_loss,
    reason = "constants, which the compiler works out"
)]
pub mod scenes;
mod shade;
mod shape;
mod trace;
mod vector;

pub use accel::{MovingScene, Scene};
pub use camera::Camera;
pub use error::Error;
pub use fault::Fault as ErrorKind;
pub use material::Material;
pub use number::{Number, Unit};
pub use render::{FrameBuilder, PreparedFrame, Report, Rows};
pub use scene::{Handle, RuntimeScene, SceneBuilder};
pub use shape::MaterialId;
pub use vector::Position;

/// How exact a picture is, as a type: what a frame leaves out.
pub mod quality {
    pub use crate::render::{Exact, Fast, Fine, Quality, Small};
}

/// How surfaces are lit, as a type.
pub mod shading {
    pub use crate::shade::{BlinnPhong, Normals, Phong, Shading, Unshadowed};
}

/// Frames for so many instructions, or so much time.
pub mod budget {
    pub use crate::display::budget::{Budgeted, Choice, FrontPoint, ParetoFront, QualityLevel};
}

/// What a scene needs of the library: what it does not need is not linked.
pub mod needs {
    pub use crate::accel::Limited;
    pub use crate::scene::{Mirrors, MostReflections, Need, Needs, NeedsLimit, Shininess};
}

/// Scenes as they were described: plain numbers, before they are prepared.
pub mod description {
    pub use crate::camera::CameraDescription;
    pub use crate::light::Light;
    pub use crate::scene::Description;
    pub use crate::shape::{cylinder::Cylinder, disc::Disc, plane::Plane, sphere::Sphere};
}

/// What the macros of the crate name; not part of the interface.
#[doc(hidden)]
pub mod __private {
    pub use crate::accel::drawable::{Drawable, Everything};
    pub use crate::accel::{Apart, StaticScene};
    pub use crate::scene::{Capacity, Counts, Room};

    /// The room in which the parts of a constant scene are counted.
    pub type LargestRoom = Room<512, 32, 128, 16, 256, 128>;
}
