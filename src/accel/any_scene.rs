//! The trait of all scenes that frames can be drawn of: constant scenes, scenes in RAM, limited ones.

use super::within::{Limited, Within};
use super::{ActiveRoom, Apart, MovingScene, Scene, Static, Tabled, World};
use crate::scene::NeedsLimit;

/// A scene that frames can be drawn of. The crate implements it for all scenes: those of [`scene!`](crate::scene), those
/// that are built or move at run time, [limited](crate::needs::Limited) ones and those with
/// [tables](crate::needs::Tabled). It cannot be implemented elsewhere.
///
/// A function that is generic over it draws any scene. It makes the frame by [`FrameBuilder::new`](crate::FrameBuilder::new).
/// One that takes frames of any quality and shading is generic over [`Quality`](crate::quality::Quality) and
/// [`Shading`](crate::shading::Shading), too.
///
/// ```
/// use embedded_graphics::mock_display::MockDisplay;
/// use embedded_graphics::{pixelcolor::Rgb888, prelude::*};
/// use reflet::display::AnyScene;
/// use reflet::{Camera, FrameBuilder, Material, MovingScene, scene};
///
/// scene! {
///     struct Ball {
///         motion([-1.0; 3], [1.0; 3]);
///         sphere BALL([0.0, 0.0, 0.0], 1.0, Material::new([0.9, 0.1, 0.1]));
///         light([3.0, -4.0, 6.0], [1.0, 1.0, 1.0]);
///     }
/// }
/// const CAMERA: Camera = Camera::look_at([0.0, -5.0, 0.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]);
///
/// fn show<S: AnyScene, D>(scene: &S, display: &mut D) -> Result<(), D::Error>
/// where
///     D: DrawTarget,
///     D::Color: From<Rgb888>,
/// {
///     FrameBuilder::new(scene, &CAMERA).reflections(2).draw(display)?;
///     Ok(())
/// }
///
/// let mut display = MockDisplay::<Rgb888>::new(); // 64 by 64
/// display.set_allow_overdraw(true);
/// show(&Ball, &mut display).unwrap();
/// show(&MovingScene::<Ball>::new(), &mut display).unwrap();
/// ```
#[diagnostic::on_unimplemented(
    message = "`{Self}` is not a scene",
    note = "a scene is a struct of `scene!`, or a value of `Scene`, `MovingScene`, `Limited` or `Tabled`; `build` makes a `Scene`"
)]
pub trait AnyScene: Sized {
    /// Room of the scene: the capacities of its lists.
    #[doc(hidden)]
    type Room: ActiveRoom;

    /// Type through which the kernels read the scene.
    #[doc(hidden)]
    type World<'a>: World<Room = Self::Room> + Copy
    where
        Self: 'a;

    /// Whether the scene can change while the program runs.
    #[doc(hidden)]
    const CHANGES: bool;

    /// Returns the access through which the kernels read the scene.
    #[doc(hidden)]
    fn world(&self) -> Self::World<'_>;

    /// Returns a number that changes when the scene changes. A frame compares it to refuse a changed
    /// scene.
    #[doc(hidden)]
    fn stamp(&self) -> u32;
}

impl<T: Apart> AnyScene for T {
    type Room = T::Room;
    type World<'a> = Static<T>;
    const CHANGES: bool = false;

    #[inline(always)]
    fn world(&self) -> Static<T> {
        Static::new()
    }

    #[inline(always)]
    fn stamp(&self) -> u32 {
        0
    }
}

/// Implements [`AnyScene`] for a scene that the kernels read through a reference.
macro_rules! drawn_in_place {
    ([$($parameters:tt)*] $scene:ty, $room:ty, |$it:ident| $stamp:expr) => {
        impl<$($parameters)*> AnyScene for $scene {
            type Room = $room;
            type World<'w>
                = &'w Self
            where
                Self: 'w;
            const CHANGES: bool = true;

            #[inline(always)]
            fn world(&self) -> &Self {
                self
            }

            fn stamp(&self) -> u32 {
                let $it = self;
                $stamp
            }
        }
    };
}
drawn_in_place!([R: ActiveRoom] Scene<R>, R, |scene| scene.stamp);
drawn_in_place!(['a, R: ActiveRoom] Tabled<'a, R>, R, |tabled| tabled.scene.stamp);
drawn_in_place!([T: Apart] MovingScene<T>, T::Room, |moving| moving.stamp());

impl<S: AnyScene, L: NeedsLimit> AnyScene for Limited<'_, S, L> {
    type Room = S::Room;
    type World<'w>
        = Within<S::World<'w>, L>
    where
        Self: 'w;
    const CHANGES: bool = S::CHANGES;

    #[inline(always)]
    fn world(&self) -> Self::World<'_> {
        Within::new(self.scene().world())
    }

    fn stamp(&self) -> u32 {
        self.scene().stamp()
    }
}
