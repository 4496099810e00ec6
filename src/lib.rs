//! Ray-traced mirrors on microcontrollers.
//!
//! A scene of spheres, planes, open cylinders, discs and point lights is rendered in fixed point, row by
//! row and without a frame buffer, into any [embedded-graphics] `DrawTarget`. Each pixel is
//!
//! > c = Σᵢ (1 − αᵢ) · (Π over k < i of αₖ) · cᵢ
//!
//! αᵢ is how mirror-like the i-th surface hit is. cᵢ is its colour by Phong or Blinn-Phong, without
//! reflections. A ray that hits nothing adds the background, which is black unless the scene names it.
//!
//! # A picture on a desk
//!
//! [`scene!`] declares a constant scene. The compiler checks and prepares it; a wrong one does not compile.
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
//! A shape with a name moves, inside of a box that the scene declares. Only what moves is prepared again.
//! The numbers may be integers or fixed-point numbers: no float instruction is executed.
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
//! The same calls draw on a board: its display driver is the target. Rows can also be computed one by one,
//! in any order and on any core: [`FrameBuilder::prepare`]. `examples/pico` and `examples/board` in the
//! repository are complete programs for a Raspberry Pi Pico and an LM3S6965. A scene that arrives while the
//! program runs, such as text over a serial line, goes into a [`RuntimeScene`].
//!
//! # What is not supported
//!
//! Refraction, textures, soft shadows, anti-aliasing, triangles, light that falls off with distance.
//!
//! # Where things are
//!
//! | what | where |
//! |---|---|
//! | how exact a picture is: `Fast`, `Fine`, `Exact`, `Small` | [`quality`] |
//! | Phong, Blinn-Phong | [`shading`] |
//! | displays with few levels, larger pixels | [`display`] |
//! | a frame for so many instructions or so much time | [`budget`] |
//! | what a scene needs of the library | [`needs`] |
//! | the numbers of a scene as it was described | [`description`] |
//!
//! Every way draws the same picture on every machine, to the bit. What a scene does not need is not linked:
//! it is derived from a constant scene, or from the room in the type of one that is filled at run time.
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
//! | lto = true, codegen-units = 1 | 30820 | 1056 | 11668 | 198 |
//! | Cargo's default release | 43200 | 1087 | 16756 | 203 |
//! | lto = true, codegen-units = 1, opt-level = "s" | 28956 | 1563 | 12556 | 248 |
//! | lto = true, codegen-units = 1, opt-level = "z" | 29148 | 2216 | 12908 | 369 |
//! | Cargo's default dev (debug) | 267756 | 23587 | 237184 | 5072 |
//!
//! Every profile draws the same picture. Where flash is scarce, the quality [`Small`](quality::Small) saves more than an
//! `opt-level`.
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
mod error_kind;
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
pub use error_kind::ErrorKind;
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
