//! Scenes whose parts move. The part that moves is prepared again, and so are its entries in the
//! occluders of the lights.
//!
//! In a scene filled at run time every bounded shape and every light can move. In a constant scene the
//! named shapes can move. Its other parts and all its tables stay constants.

use super::fingerprint::Fingerprint;
use super::static_scene::{Apart, StaticScene};
use super::{Scene, Tables, World};
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::light::Light;
use crate::number::Number;
use crate::scene::access::SceneAccess;
use crate::scene::{Capacity, Handle, Needs, Parts, used};
use crate::shape::{Corners, MaterialId, Normals};
use crate::vector::Position;

/// A copy of a constant scene in RAM, whose named shapes can move.
///
/// Frames read materials, lights, planes and tables from flash.
///
/// ```
/// use embedded_graphics::{mock_display::MockDisplay, pixelcolor::Rgb888};
/// use reflet::{Camera, Material, MovingScene, scene};
///
/// const GOLD: Material = Material::new([0.7, 0.6, 0.0]).mirror(0.4);
///
/// scene! {
///     struct Bounce {
///         motion([-1.0, -1.0, 0.0], [1.0, 1.0, 6.0]);
///         sphere BALL([0.0, 0.0, 1.0], 1.0, GOLD);
///         plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], GOLD);
///         light([3.0, -4.0, 9.0], [1.0, 1.0, 1.0]);
///     }
/// }
/// const CAMERA: Camera = Camera::look_at([0.0, -9.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
///
/// let mut scene = MovingScene::<Bounce>::new();
/// scene.set_sphere(Bounce::BALL, [0.0, 0.0, 2.5], 1)?;
/// let mut display = MockDisplay::<Rgb888>::new();
/// scene.frame(&CAMERA).draw(&mut display).unwrap();
///
/// let too_high = scene.set_sphere(Bounce::BALL, [0, 0, 7], 1);
/// assert_eq!(too_high.unwrap_err().kind(), reflet::ErrorKind::Motion);
/// # Ok::<(), reflet::Error>(())
/// ```
///
/// Cylinders and discs move in the same way:
///
/// ```
/// use reflet::{Material, MovingScene, scene};
///
/// const TIN: Material = Material::new([0.8, 0.8, 0.8]);
///
/// scene! {
///     struct Can {
///         motion([-3.0, -3.0, -1.0], [3.0, 3.0, 4.0]);
///         cylinder WALL([0.0, 0.0, 1.0], [0.0, 0.0, 1.0], 1.0, 2.0, TIN);
///         disc LID([0.0, 0.0, 2.0], [0.0, 0.0, 1.0], 1.0, TIN);
///         light([3.0, -4.0, 9.0], [1.0, 1.0, 1.0]);
///     }
/// }
///
/// let mut scene = MovingScene::<Can>::new();
/// scene.set_cylinder(Can::WALL, [1, 0, 1], [0, 0, 1], 1, 2)?;
/// scene.set_disc(Can::LID, [1, 0, 2], [1, 0, 2], 1)?;
/// # Ok::<(), reflet::Error>(())
/// ```
///
/// Executed instructions of one `set_sphere` and of the preparation of the next frame, and flash in
/// percent of the constant scene, at 64x64 in quality `Fast`, written by `cargo xtask measure --all`:
///
/// | core | scene | move | preparation | flash |
/// |---|---|--:|--:|--:|
/// | m0 | castle | 3690 | 346741 | 108.6 % |
/// | m0 | mirror1 | 2881 | 52159 | 107.7 % |
/// | m0 | primitives | 2701 | 20723 | 110.4 % |
/// | m3 | castle | 2239 | 75000 | 110.3 % |
/// | m3 | mirror1 | 1658 | 11641 | 111.4 % |
/// | m3 | primitives | 1545 | 5066 | 112.6 % |
#[derive(Debug)]
pub struct MovingScene<T: StaticScene>(Scene<T::Room>);

impl<T: StaticScene> Clone for MovingScene<T> {
    fn clone(&self) -> Self {
        Self(self.0)
    }
}

impl<T: StaticScene> MovingScene<T> {
    /// Copies the constant scene `T` into RAM. The shapes are where the description puts them.
    pub const fn new() -> Self {
        Self(*T::SCENE)
    }

    /// Returns a number that changes whenever a shape moves.
    pub(crate) fn stamp(&self) -> u32 {
        self.0.stamp
    }
}

impl<T: StaticScene> Default for MovingScene<T> {
    fn default() -> Self {
        Self::new()
    }
}

macro_rules! motion {
    (
        $header:tt
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $active:tt
            $set:ident $too_many:ident $without:ident
            $(#[$doc:meta])* $add:ident($($field:ident: $type:ident),*) })*
    ) => {
        impl<R: Capacity> Scene<R> {
            $(
                #[doc = concat!(
                    "Changes place and size of a ", stringify!($kind), ". It keeps its material."
                )]
                ///
                #[doc = concat!(
                    "Prepares only this ", stringify!($kind), " again, and its entries in the lights' occluders."
                )]
                ///
                /// # Errors
                #[doc = concat!("The mistake in the ", stringify!($kind), "; [`ErrorKind::UnknownHandle`] if there is")]
                /// no such part; [`ErrorKind::Motion`] if the ball around it does not lie inside of the
                /// motion box. After an error the scene is unchanged.
                pub fn $set(
                    &mut self,
                    $kind: Handle<crate::shape::$described>,
                    $($field: impl Into<$type>),*
                ) -> Result<(), Error> {
                    self.$kind($kind.index(), &crate::shape::$described {
                        $($field: $field.into(),)*
                        material: MaterialId::FIRST,
                    })
                }

                #[inline(never)]
                fn $kind(
                    &mut self,
                    index: usize,
                    described: &crate::shape::$described,
                ) -> Result<(), Error> {
                    self.plain.$kind(index, described)?;
                    let parts = self.plain.parts();
                    for light in self.light_occluders.as_mut().iter_mut().take(parts.lights.len()) {
                        light.$kind(index, &parts);
                        light.settle(&parts);
                    }
                    self.stamp = Fingerprint(self.stamp).$kind(index, described).0;
                    Ok(())
                }
            )*
        }

        impl<T: Apart> MovingScene<T> {
            $(
                #[doc = concat!("Changes place and size of a named ", stringify!($kind), ". It keeps its")]
                /// material. Only this shape is prepared again.
                ///
                /// # Errors
                #[doc = concat!("The mistake in the ", stringify!($kind), "; [`ErrorKind::UnknownHandle`] if no ", stringify!($kind))]
                /// with the handle's index can move in this scene; [`ErrorKind::Motion`] if the ball around it does not lie inside
                /// of the motion box. After an error the scene is unchanged.
                pub fn $set(
                    &mut self,
                    $kind: Handle<crate::shape::$described>,
                    $($field: impl Into<$type>),*
                ) -> Result<(), Error> {
                    let index = $kind.index();
                    if Self::moves(stringify!($kind), index) {
                        self.0.$set($kind, $($field),*)
                    } else {
                        Err(Error::at(stringify!($kind), index, ErrorKind::UnknownHandle))
                    }
                }
            )*

            /// Tests whether the constant scene lets the shape of this kind and index move.
            fn moves(name: &str, index: usize) -> bool {
                let kinds = T::PARTS.kinds();
                let mut named = [$(stringify!($kind)),*].into_iter().zip(kinds);
                named.any(|(it, kind)| it == name && T::PARTS.moving.meets(kind.set_of(index)))
            }
        }

        impl<T: Apart> SceneAccess for MovingScene<T> {
            const NEEDS: Needs = <T as Apart>::NEEDS;
            const HAS_BLANK: bool = T::PARTS.has_blank();

            #[inline(always)]
            fn parts(&self) -> Parts<'_> {
                Parts {
                    $($list: used(self.0.plain.$list.as_ref(), T::PARTS.$list.len()),)*
                    ..T::PARTS
                }
            }
        }
    };
}
kinds!(motion);

impl<T: Apart> World for MovingScene<T> {
    type Room = T::Room;
    const IS_CROWD: bool = !T::HIERARCHY.is_empty();

    #[inline(always)]
    fn tables(&self) -> Tables<'_, T::Room> {
        Tables {
            light_occluders: used(self.0.light_occluders.as_ref(), T::PARTS.lights.len()),
            light_tables: T::LIGHT_TABLES,
            light_lists: &[],
            hierarchy: T::HIERARCHY,
        }
    }
}

impl<R: Capacity> Scene<R> {
    /// Changes the position of a light, in scene units, or the direction towards a sun. It keeps its colour.
    ///
    /// Prepares only the occluders of this light again. A light may leave the motion box.
    ///
    /// # Errors
    /// [`ErrorKind::Coordinate`] if a coordinate is not within ±2³⁰; [`ErrorKind::Sun`] if a sun's direction is
    /// zero; [`ErrorKind::UnknownHandle`] if there is no such light. After an error the scene is unchanged.
    pub fn set_light(
        &mut self,
        light: Handle<Light>,
        position: impl Into<Position>,
    ) -> Result<(), Error> {
        let index = light.index();
        let position = position.into();
        self.plain.light(index, position)?;
        let parts = self.plain.parts();
        let occluders = self.light_occluders.as_mut().get_mut(index);
        if let Some((light, occluders)) = parts.lights.get(index).zip(occluders) {
            occluders.put(light, &parts);
        }
        self.stamp = Fingerprint(self.stamp).light(index, &position).0;
        Ok(())
    }
}
