//! Moves parts of a prepared scene in place. Only the part that moves is prepared again.
//!
//! The grid of the scene was chosen for its whole motion box. So a part that moves in the box changes no
//! bit of the others.

use super::Description;
use super::capacity::{Capacity, Room};
use super::prepare::PlainScene;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::shape::Extent;
use crate::vector::Position;

macro_rules! motion {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $($more:tt)* })*
    ) => {
        impl<R: Capacity> PlainScene<R> {
            $(
                #[doc = concat!(
                    "Changes place and size of a ", stringify!($kind), " and prepares it again. It keeps its material."
                )]
                #[inline(never)]
                pub(crate) fn $kind(
                    &mut self,
                    index: usize,
                    $kind: &crate::shape::$described,
                ) -> Result<(), Error> {
                    let mut put = || {
                        if let Some(fault) = $kind.fault() {
                            return Err(fault);
                        }
                        // A shape that is larger than the motion box may not fit the grid.
                        if !self.is_in_motion_box(&$kind.extent()) {
                            return Err(ErrorKind::Motion);
                        }
                        let moved = crate::shape::$prepared::prepare($kind, &self.grid)?;
                        let old = known(self.$list.as_mut(), self.counts.$list, index)?;
                        let material = old.material;
                        *old = moved.touching(true);
                        old.material = material;
                        Ok(())
                    };
                    put().map_err(|kind| Error::at(stringify!($kind), index, kind))
                }
            )*
        }

        impl<$($header)*> PlainScene<Room<$($arguments)*>> {
            /// Returns the constant scene with the shapes marked that move, given by kind and index.
            ///
            /// Panics if the ball around one of them does not lie inside of the motion box. In a
            /// constant, this stops the compiler.
            pub(crate) const fn marked(
                mut self,
                moving: &[Option<(&'static str, usize)>],
                described: &Description<'_>,
            ) -> Self {
                let [$($list),*] = self.constant_parts().kinds();
                let mut number = 0;
                while number < moving.len() {
                    if let Some((name, index)) = moving[number] {
                        $(
                            if super::capacity::is_same(name, stringify!($kind)) && index < $room {
                                if !self.is_in_motion_box(&described.$list[index].extent()) {
                                    Error::at(name, index, ErrorKind::Motion).stop();
                                }
                                self.moving = self.moving.with($list.set_of(index));
                            }
                        )*
                    }
                    number += 1;
                }
                self
            }
        }
    };
}
kinds!(motion);

impl<R: Capacity> PlainScene<R> {
    /// Changes the position of a light, in scene units, or the direction of a sun. It keeps its colour.
    #[inline(never)]
    pub(crate) fn light(&mut self, index: usize, position: Position) -> Result<(), Error> {
        let error = |fault| Error::at("light", index, fault);
        if !position.is_in_range() {
            return Err(error(ErrorKind::Coordinate));
        }
        let light = known(self.lights.as_mut(), self.counts.lights, index).map_err(error)?;
        if light.sun().is_some() && position.magnitude() == 0 {
            return Err(error(ErrorKind::Sun));
        }
        *light = light.moved(position, &self.grid);
        Ok(())
    }

    /// Tests whether a shape with this extent lies inside of the motion box. Returns `false` if the
    /// scene has no motion box. The grid was chosen for the same extent.
    const fn is_in_motion_box(&self, extent: &Extent) -> bool {
        let center = self.grid.place(extent.center).point;
        let radius = self.grid.length(extent.radius).to_bits();
        let Some([low, high]) = self.motion else {
            return false;
        };
        holds(low.x, center.x, high.x, radius)
            && holds(low.y, center.y, high.y, radius)
            && holds(low.z, center.z, high.z, radius)
    }
}

/// Returns the part with this index among the first `count`.
fn known<T>(parts: &mut [T], count: usize, index: usize) -> Result<&mut T, ErrorKind> {
    let known = parts.get_mut(index).filter(|_| index < count);
    known.ok_or(ErrorKind::UnknownHandle)
}

/// Tests whether a ball lies between two opposite sides of the motion box, in steps along one axis.
const fn holds(low: i32, center: i32, high: i32, radius: i32) -> bool {
    // Side, centre and radius are each rounded to a step.
    let (center, radius) = (center as i64, radius as i64 - 2);
    low as i64 <= center - radius && high as i64 >= center + radius
}
