//! The macros for users: `room!` writes the room of a scene, `scene!` declares a constant scene.
//!
//! The compiler looks up the words of a macro where a user calls it. So that no word finds an item of
//! the user, every path begins with `$crate`, constants are items of a trait, and arguments begin with
//! two underscores.

use super::builder::SceneBuilder;
use super::capacity::{Capacity, Counts};

/// The lines of a [`scene!`](crate::scene) as constants. They are items of a trait, because a plain constant
/// would be visible in the user's lines.
pub trait SceneLines {
    /// Number of parts of each kind.
    const COUNTS: Counts;
    /// Room that holds exactly these parts.
    type Room: Capacity;
    /// Builder that has all parts.
    const BUILDER: SceneBuilder<Self::Room>;
    /// Kind and name of each part, in their order. The name is empty if the part has none.
    const NAMES: &'static [(&'static str, &'static str)];
}

/// Types of the parts, each under the name that its lines have in [`scene!`](crate::scene). Only bounded
/// shapes can move: `SceneBuilder::moves_as` rejects other parts.
pub mod described {
    pub use crate::light::Light as light;
    pub use crate::light::Light as light_with_range;
    pub use crate::light::Light as sun;
    pub use crate::light::Light as sun_with_disc;
    pub use crate::shape::plane::Plane as plane;
    pub use crate::shape::{
        Cylinder as cylinder, Disc as disc, Sphere as sphere, Triangle as triangle,
    };
}

/// Writes the type of a scene's room: how many parts of each kind the scene can hold.
///
/// The lists are `spheres`, `planes`, `cylinders`, `discs`, `triangles`, `lights` and `materials`. A list that is not
/// named has no room, and the code for it is not linked. `materials` defaults to 8. Write it where a
/// type stands.
///
/// ```
/// use reflet::{RuntimeScene, room};
///
/// let pond = RuntimeScene::<room!(spheres: 8, planes: 1, lights: 2)>::new();
/// # let _ = pond;
/// ```
#[macro_export]
macro_rules! room {
    ($($list:ident: $count:expr),* $(,)?) => {
        $crate::__room!($crate::__private::Counts::of_fields(
            &[$(($crate::__private::stringify!($list), $count)),*]
        ))
    };
}

/// Declares a constant scene: a type without fields, whose scene the compiler checks and prepares.
///
/// Each line is a method of [`SceneBuilder`](crate::SceneBuilder) with its arguments. The lines may stand in any order:
///
/// | line | most | arguments |
/// |---|--:|---|
/// | `sphere(center, radius, material)` | 512 | |
/// | `cylinder(center, axis, radius, height, material)` | 128 | open at both ends; the middle of the axis, and the height from end to end |
/// | `disc(center, normal, radius, material)` | 128 | |
/// | `triangle(corners, normals, material)` | 256 | three corners; `Some` three normals, or `None` if it is flat |
/// | `plane(point, normal, material)` | 32 | infinite, through any point of it |
/// | `light(position, color)` | 16 | a lamp |
/// | `light_with_range(position, color, range)` | | a lamp whose light falls off: half is left at the distance `range` |
/// | `sun(direction, color)` | | a light far away; counts as a lamp does. The direction points towards it |
/// | `sun_with_disc(direction, color, degrees)` | | the same, seen as a disc of this angle |
/// | `background(color)` | 1 | what rays show that meet nothing |
/// | `sky(up, [below, horizon, above])` | 1 | three colours instead of one |
/// | `epsilon(length)` | 1 | how far above a surface the next ray starts; 0.001 |
/// | `motion(low, high)` | 1 | two corners of the box in which shapes move |
/// | `camera(camera)` | 1 | a camera to keep with the scene |
///
/// Vectors and colours are arrays of three `f64`, lengths and angles are `f64`. Up to 256 different materials are used; one
/// that is used twice counts once. The macro counts the parts and chooses the room. A mistake stops the compiler with a
/// message that names the part and the fix, and the line if the part is wrong by itself.
///
/// The type has a function `frame`, which views the scene through a camera and returns a
/// [`FrameBuilder`](crate::FrameBuilder).
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
/// use reflet::{Camera, Material, scene};
///
/// scene! {
///     /// A red marble.
///     pub struct Marble {
///         sphere([0.0, 0.0, 1.0], 1.0, Material::new([0.9, 0.1, 0.1]));
///         light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0]);
///     }
/// }
/// const CAMERA: Camera = Camera::look_at([0.0, -5.0, 1.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
///
/// let mut display = MockDisplay::<Rgb888>::new();
/// Marble::frame(&CAMERA).draw(&mut display).unwrap();
/// ```
///
/// A shape with a name can move. The name becomes a constant [`Handle`](crate::Handle) of the type:
/// `sphere BALL(..)` in a scene `Bounce` gives `Bounce::BALL`. [`MovingScene`](crate::MovingScene) has
/// an example.
#[macro_export]
macro_rules! scene {
    (
        $(#[$attribute:meta])*
        $visibility:vis struct $name:ident {
            $($part:tt $first:tt $(($($named:tt)*))?;)*
        }
    ) => {
        $(#[$attribute])*
        #[derive($crate::__private::Clone, $crate::__private::Copy, $crate::__private::Debug)]
        $visibility struct $name;

        impl $crate::__private::SceneLines for $name {
            const COUNTS: $crate::__private::Counts = {
                let __scene = $crate::SceneBuilder::<$crate::__private::LargestRoom>::new();
                $(let __scene = $crate::__line!(add __scene $part $first $(($($named)*))?);)*
                $crate::SceneBuilder::counts(&__scene)
            };

            type Room = $crate::__room!(<$name as $crate::__private::SceneLines>::COUNTS);

            const BUILDER: $crate::SceneBuilder<Self::Room> = {
                let __scene = $crate::SceneBuilder::<Self::Room>::new();
                $(let __scene = $crate::__line!(add __scene $part $first $(($($named)*))?);)*
                __scene
            };

            const NAMES: &'static [(&'static $crate::__private::str, &'static $crate::__private::str)] =
                &[$((
                    $crate::__private::stringify!($part),
                    $crate::__line!(name $first $(($($named)*))?),
                )),*];
        }

        impl $crate::__private::StaticScene for $name {
            type Room = <Self as $crate::__private::SceneLines>::Room;
            const SCENE: &'static $crate::Scene<<Self as $crate::__private::SceneLines>::Room> =
                &$crate::SceneBuilder::build(&<Self as $crate::__private::SceneLines>::BUILDER);
            const INSTANCE: &'static Self = &Self;

            fn with_description<__R>(
                __read: impl $crate::__private::FnOnce($crate::description::Description<'_>) -> __R,
            ) -> __R {
                __read($crate::SceneBuilder::description(
                    &<Self as $crate::__private::SceneLines>::BUILDER,
                ))
            }
        }

        #[allow(dead_code, reason = "a scene need not be drawn and moved")]
        impl $name {
            $($crate::__line! { handle $part $first $(($($named)*))? })*

            /// Passes the numbers that the scene was written with to a function, and returns the result.
            pub fn with_description<__R>(
                __read: impl $crate::__private::FnOnce($crate::description::Description<'_>) -> __R,
            ) -> __R {
                <Self as $crate::__private::StaticScene>::with_description(__read)
            }

            /// Views the scene through a camera: 4 reflections, quality `Fast`, shading `BlinnPhong`.
            pub fn frame(__camera: &$crate::Camera) -> $crate::FrameBuilder<'_, Self> {
                $crate::FrameBuilder::new(&Self, __camera)
            }
        }
    };
}
