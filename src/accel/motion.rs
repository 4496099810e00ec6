//! Scenes whose parts move: the part is prepared again, and so are its views from the lights.
//!
//! A scene that was filled at run time moves any shape and any light. In a constant scene the named
//! shapes move; the others, and all tables, stay constants.

use super::fingerprint::Fingerprint;
use super::static_scene::{Apart, StaticScene};
use super::{Scene, Tables, World};
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::light::Light;
use crate::number::Number;
use crate::scene::access::SceneAccess;
use crate::scene::shape_set::{SetLayout, ShapeSet};
use crate::scene::{Capacity, Handle, Needs, Parts, used};
use crate::shape::MaterialId;
use crate::vector::Position;

/// A constant scene in RAM, of which the named shapes move.
///
/// Materials, lights, planes and tables stay in flash.
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
pub struct MovingScene<T: StaticScene>(Scene<T::Room>);

impl<T: StaticScene> Clone for MovingScene<T> {
    fn clone(&self) -> Self {
        Self(self.0)
    }
}

impl<T: StaticScene> MovingScene<T> {
    /// Copies the scene into RAM, with its shapes where they are described.
    pub fn new() -> Self {
        Self(*T::SCENE)
    }

    /// Returns a number that changes with the scene.
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
                    "Changes a ", stringify!($kind), " in place. Only it is prepared again; it keeps its material."
                )]
                ///
                /// # Errors
                #[doc = concat!("What is wrong with the ", stringify!($kind), "; [`ErrorKind::Motion`] unless the")]
                /// ball around it lies inside of the motion box. The scene is as it was.
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
                #[doc = concat!("Changes a named ", stringify!($kind), " in place. Only it is prepared again;")]
                /// it keeps its material.
                ///
                /// # Errors
                #[doc = concat!("What is wrong with the ", stringify!($kind), "; [`ErrorKind::Motion`] unless the")]
                /// ball around it lies inside of the motion box. The scene is as it was.
                pub fn $set(
                    &mut self,
                    $kind: Handle<crate::shape::$described>,
                    $($field: impl Into<$type>),*
                ) -> Result<(), Error> {
                    let index = $kind.index();
                    match Self::moves(stringify!($kind), index) {
                        true => self.0.$set($kind, $($field),*),
                        false => Err(Error::at(stringify!($kind), index, ErrorKind::UnknownHandle)),
                    }
                }
            )*

            /// Tests whether a shape is one of those that move.
            fn moves(name: &str, index: usize) -> bool {
                let layout = SetLayout::new(T::PARTS.lengths());
                let kind = [$(stringify!($kind)),*].iter().position(|it| *it == name);
                kind.is_some_and(|kind| T::PARTS.moving.meets(ShapeSet::of(layout.bit(kind, index))))
            }
        }

        impl<T: Apart> SceneAccess for MovingScene<T> {
            const NEEDS: Needs = <T as Apart>::NEEDS;
            const CHOOSES_HITS: bool = !T::MIRROR_TABLES.tables.is_empty();

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

    #[inline(always)]
    fn tables(&self) -> Tables<'_, T::Room> {
        Tables {
            light_occluders: used(self.0.light_occluders.as_ref(), T::PARTS.lights.len()),
            light_tables: T::LIGHT_TABLES,
            mirror_tables: T::MIRROR_TABLES,
        }
    }
}

impl<R: Capacity> Scene<R> {
    /// Changes the position of a light in place; it keeps its colour. Only what the light sees of the
    /// shapes is prepared again.
    ///
    /// # Errors
    /// [`ErrorKind::Coordinate`]. The scene is as it was.
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
