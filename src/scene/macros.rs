//! The macros for users: `room!` writes the room of a scene, `scene!` declares a constant scene.

/// Writes the type of a scene's room: how many parts of each kind the scene can hold.
///
/// The lists are `spheres`, `planes`, `cylinders`, `discs`, `lights` and `materials`. A list that is not
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
        $crate::__room!($crate::__private::Counts::of_fields(&[$((stringify!($list), $count)),*]))
    };
}

/// Declares a constant scene: a type without fields, whose scene the compiler checks and prepares.
///
/// Each line is a method of [`SceneBuilder`](crate::SceneBuilder) with its arguments: `sphere`, `plane`,
/// `cylinder`, `disc`, `light`, `background`, `epsilon`, `camera`, `motion`. The macro counts the parts
/// and chooses the room. A mistake stops the compiler with a message that names the part and the fix.
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
            $($part:ident $($handle:ident)? ($($argument:expr),* $(,)?);)*
        }
    ) => {
        $(#[$attribute])*
        #[derive(Clone, Copy, Debug)]
        $visibility struct $name;

        const _: () = {
            const COUNTS: $crate::__private::Counts =
                $crate::SceneBuilder::<$crate::__private::LargestRoom>::new()
                    $(.$part($($argument),*))*
                    .counts();

            type Room = $crate::__room!(COUNTS);

            const BUILDER: $crate::SceneBuilder<Room> = $crate::SceneBuilder::new()
                $(.$part($($argument),*) $(.moves_as(stringify!($handle)))?)*;

            impl $crate::__private::StaticScene for $name {
                type Room = Room;
                const SCENE: &'static $crate::Scene<Room> = &BUILDER.build();
                const INSTANCE: &'static Self = &Self;

                fn with_description<R>(
                    read: impl FnOnce($crate::description::Description<'_>) -> R,
                ) -> R {
                    read(BUILDER.description())
                }
            }
        };

        #[allow(dead_code, reason = "a scene need not be drawn and moved")]
        impl $name {
            const PARTS: &[(&str, &str)] =
                &[$((stringify!($part), concat!($(stringify!($handle))?))),*];

            $($(
                #[doc = concat!("Handle of a ", stringify!($part), " that can move.")]
                pub const $handle: $crate::Handle<$crate::__described!($part)> =
                    $crate::Handle::named(Self::PARTS, stringify!($handle));
            )?)*

            /// Calls `read` with the numbers that the scene was written with.
            pub fn with_description<R>(
                read: impl FnOnce($crate::description::Description<'_>) -> R,
            ) -> R {
                <Self as $crate::__private::StaticScene>::with_description(read)
            }

            /// Views the scene through a camera: 4 reflections, quality `Fast`, shading `BlinnPhong`.
            pub fn frame(camera: &$crate::Camera) -> $crate::FrameBuilder<'_, Self> {
                $crate::FrameBuilder::new(&Self, camera)
            }
        }
    };
}
