//! Ray-traced mirrors on microcontrollers.
//!
//! The library renders scenes of spheres, planes, open cylinders, discs and triangles under lamps and suns. It computes in
//! fixed point, row by row and without a frame buffer, and draws into any [embedded-graphics]
//! `DrawTarget`. Each pixel is
//!
//! > c = Σᵢ (1 − αᵢ) · (Π over k < i of αₖ) · cᵢ
//!
//! αᵢ is how mirror-like the i-th surface on the ray's path is: 0 for a matt surface, 1 for a perfect
//! mirror. cᵢ is the colour of that surface by Phong or Blinn-Phong shading, without reflections. A ray
//! that hits nothing adds the background: black by default, one colour, or a sky.
//!
//! # A picture on a desk
//!
//! [`scene!`] declares a constant scene. The compiler checks and prepares it. A scene with a mistake
//! does not compile.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
//! use reflet::{Camera, Material, scene};
//!
//! const GOLD: Material = Material::new([0.7, 0.6, 0.0]).specular(0.8, 4.0).mirror(0.4);
//! const WATER: Material = Material::new([0.6, 0.8, 1.0]).diffuse(0.1).mirror(0.7);
//!
//! scene! {
//!     /// A golden ball over water.
//!     struct Harbour {
//!         sphere([0.0, 0.0, 1.0], 1.0, GOLD);
//!         plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], WATER);
//!         light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0]);
//!         background([0.3, 0.4, 0.6]);
//!     }
//! }
//!
//! const CAMERA: Camera = Camera::look_at([0.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
//!
//! let mut display = MockDisplay::<Rgb888>::new(); // any display of embedded-graphics
//! let report = Harbour::frame(&CAMERA).reflections(4).draw(&mut display)?;
//! assert!(report.rays > 0);
//! # Ok::<(), core::convert::Infallible>(())
//! ```
//!
//! # An animation
//!
//! A shape with a name can move, inside of a box that the scene declares. Only the shape that moves is
//! prepared again. Numbers may be integers, floats or fixed-point numbers. No float instruction is executed.
//!
//! ```
//! use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
//! use reflet::{Camera, Material, MovingScene, scene};
//!
//! scene! {
//!     struct Bounce {
//!         motion([-1.0, -1.0, 0.0], [1.0, 1.0, 6.0]);
//!         sphere BALL([0.0, 0.0, 1.0], 1.0, Material::new([0.9, 0.1, 0.1]).mirror(0.3));
//!         plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], Material::new([0.8, 0.8, 0.8]).mirror(0.3));
//!         light([3.0, -4.0, 9.0], [1.0, 1.0, 1.0]);
//!     }
//! }
//!
//! const CAMERA: Camera = Camera::look_at([0.0, -9.0, 3.0], [0.0, 0.0, 1.5], [0.0, 0.0, 1.0]);
//!
//! let mut display = MockDisplay::<Rgb888>::new();
//! # display.set_allow_overdraw(true);
//! let mut scene = MovingScene::<Bounce>::new();
//! for (height, angle) in [(1, 0), (2, 10), (3, 20)] {
//!     scene.set_sphere(Bounce::BALL, [0, 0, height], 1)?;
//!     let camera = CAMERA.orbited(angle, 0)?;
//!     scene.frame(&camera).draw(&mut display).unwrap();
//! }
//! # Ok::<(), reflet::Error>(())
//! ```
//!
//! # A board
//!
//! The same calls draw on a board, where the display's driver is the target. [`FrameBuilder::prepare`]
//! lets a program compute rows one by one, in any order and on any core. `examples/pico` and
//! `examples/board` in the repository are complete programs for a Raspberry Pi Pico and an LM3S6965. A
//! [`RuntimeScene`] is filled while the program runs, for example from text that arrives over a serial
//! line.
//!
//! # What is not supported
//!
//! Refraction, textures, soft shadows.
//!
//! # Where things are
//!
//! | what | where |
//! |---|---|
//! | qualities, which say how exact a picture is: `Fast`, `Exact`, `Small`; smooth edges: `Smooth` | [`quality`] |
//! | shading models: Phong, Blinn-Phong | [`shading`] |
//! | dithering for displays with few levels, larger pixels; [`AnyScene`](display::AnyScene) | [`display`] |
//! | frames with a budget of instructions or time | [`budget`] |
//! | features of the library that a scene needs | [`needs`] |
//! | numbers that a scene was written with | [`description`] |
//!
//! With the same settings, a scene gives the same picture on every machine, to the bit. Code that a
//! scene does not need is not linked. The needs are derived from a constant scene itself, or from the
//! room in the type of a scene that is filled at run time.
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
//! | lto = true, codegen-units = 1 | 52864 | 1292 | 15628 | 219 |
//! | Cargo's default release | 70092 | 1337 | 20716 | 254 |
//! | lto = true, codegen-units = 1, opt-level = "s" | 51232 | 2316 | 17088 | 288 |
//! | lto = true, codegen-units = 1, opt-level = "z" | 49304 | 3837 | 17028 | 472 |
//! | Cargo's default dev (debug) | 659188 | 40744 | 609236 | 6363 |
//!
//! Every profile draws the same picture. If flash is scarce, the quality [`Small`](quality::Small) saves
//! more than an `opt-level`.
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
//! | distance at which half of a light is left (`range`) | 2⁻⁶⁴ to 2³⁰ scene units |
//! | shininess | 0 to 2²⁰, any real number |
//! | mirror (α) | 0 to 1 |
//! | size of a checker's cells | 0, or 2⁻²⁷ to 2¹⁶ of the scene's extent |
//! | field of view | 0.001 to 179.999 degrees |
//! | angle between view and up | at least 2⁻²⁴ |
//! | reflections | 0 to 255 |
//! | picture | 1 to 65535 pixels a side |
//!
//! Coordinates become whole steps of a grid, which is chosen for each scene when it is built. The shapes
//! fill a ball with a radius of 2²⁸ steps, or 2²⁵ steps in a scene with planes. They fill fewer steps if
//! lights, camera or planes stand up to 32 times as far from the middle, because the grid then includes
//! these, too. The scene's own camera may stand further away. But the steps are never coarser than the
//! smallest shape and epsilon need. So a scene in millimetres and the same scene in kilometres give the
//! same picture.
//!
//! # Features
//!
//! No feature is on by default.
//!
//! | feature | adds |
//! |---|---|
//! | `scenes` | eleven built-in scenes |
//! | `defmt` | `defmt::Format` for errors and reports |
//! | `micromath` | the numbers and vectors of `micromath` as input for cameras and run-time scenes |
//! | `files` | scene files, their Rust source, and the path of a pixel; needs `alloc` |
//! | `host` | `files`, and tools for the desktop: double-precision reference, picture comparison |
//! | `film` | films as GIF for the example `render` |
//! | `window` | a window for the example `render` |
//!
//! # Oldest supported Rust
//!
//! 1.87.
//!
//! [embedded-graphics]: https://docs.rs/embedded-graphics
#![no_std]
#![forbid(unsafe_code)]
#![deny(missing_docs)]
// Overflow checks do not detect an `as` that loses bits or the sign: the functions of `number::narrow` do. The last one
// limits the length of functions, by the number in clippy.toml.
#![cfg_attr(
    not(test),
    deny(
        clippy::cast_possible_truncation,
        clippy::cast_possible_wrap,
        clippy::cast_sign_loss,
        clippy::too_many_lines
    )
)]

// Both have the same macros; a test needs no feature.
#[cfg(feature = "files")]
#[cfg_attr(not(test), macro_use)]
extern crate alloc;

#[cfg(any(feature = "host", test))]
#[cfg_attr(test, macro_use)]
extern crate std;

#[macro_use]
mod kinds;

mod accel;
mod background;
mod camera;
mod checker;
mod color;
pub mod display;
mod error;
mod error_kind;
mod grid;
#[cfg(feature = "files")]
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
mod qualities;
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
pub use error_kind::ErrorKind;
pub use material::Material;
pub use number::{Number, Unit};
pub use render::{FrameBuilder, PreparedFrame, Report, Rows};
pub use scene::{Handle, RuntimeScene, SceneBuilder};
pub use shape::MaterialId;
pub use vector::Position;

/// Qualities: types that say how exact a picture is, and which approximations a frame uses.
pub mod quality {
    pub use crate::qualities::{Exact, Fast, Quality, Small, Smooth};
    pub use crate::render::Seam;
}

/// Shading models: types that say how the colour of a surface is computed.
pub mod shading {
    pub use crate::shade::{BlinnPhong, Normals, Phong, Shading, Unshadowed};
}

/// Frames with a budget: settings chosen for a number of instructions, and a limit of time.
pub mod budget {
    pub use crate::display::budget::{Budgeted, Choice, FrontPoint, ParetoFront, QualityLevel};
}

/// Needs: the features of the library that a scene uses. Code for other features is not linked.
pub mod needs {
    pub use crate::accel::{HierarchyNode, Limited, Tabled};
    pub use crate::scene::{Mirrors, MostReflections, Need, Needs, NeedsLimit, Shininess};
}

/// Descriptions of scenes: the numbers that they were written with, before they are prepared.
pub mod description {
    pub use crate::background::Sky;
    pub use crate::camera::CameraDescription;
    pub use crate::checker::Checker;
    pub use crate::light::Light;
    pub use crate::scene::Description;
    pub use crate::shape::{
        cylinder::Cylinder,
        disc::Disc,
        plane::Plane,
        sphere::Sphere,
        triangle::{Corners, Normals, Triangle},
    };
}

/// Items that the macros of the crate name. They are not part of the interface.
#[doc(hidden)]
pub mod __private {
    pub use crate::accel::{Apart, Everything, StaticScene};
    pub use crate::scene::{Capacity, Counts, Room, SceneLines, described};
    pub use core::clone::Clone;
    pub use core::fmt::Debug;
    pub use core::marker::Copy;
    pub use core::ops::FnOnce;
    pub use core::primitive::str;
    pub use core::{concat, stringify};

    /// Largest room of a constant scene. [`scene!`](crate::scene) counts the parts of a scene in it.
    pub type LargestRoom = Room<512, 32, 128, 16, 256, 128, 256>;
}
