//! Which lights are visible from all that a frame shows, and which from nothing, as far as planes go.
//!
//! No ray crosses a plane. So all surfaces that a frame's rays come to lie on the camera's side of
//! every plane, and a light on the other side of one is hidden from all of them; planes in front of
//! which camera and light both stand hide it from none.

use super::World;
use super::light_occluders::LightOccluders;
use crate::number::bit_modulo_32;
use crate::ray::ScaledPoint;
use crate::shape::plane::Side;

/// The camera's place, and which lights are visible from all that its rays hit.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightVisibility {
    /// Where the rays come from.
    pub(crate) from: ScaledPoint,
    /// A bit for each light that a plane hides from everything.
    hidden: u32,
    /// A bit for each light of which it depends on the ray: the light is far away, or the light or the
    /// camera stands inside of a sphere or within epsilon of a plane.
    unclear: u32,
}

impl LightVisibility {
    /// The view from a place, with nothing known about the lights.
    pub(crate) const fn unclear(from: ScaledPoint) -> Self {
        Self {
            from,
            hidden: 0,
            unclear: u32::MAX,
        }
    }

    /// The view from a place.
    pub(crate) fn new<W: World>(world: &W, from: ScaledPoint) -> Self {
        let parts = world.parts();
        let mut view = Self {
            from,
            hidden: 0,
            unclear: 0,
        };
        // Rays from inside of a sphere stay there.
        if from.is_near() && parts.hold(from.point) {
            view.unclear = u32::MAX;
        }
        let lights = world.tables().light_occluders;
        if lights.len() > u32::BITS as usize {
            view.unclear = u32::MAX;
            return view;
        }
        for (index, light) in lights.iter().map(LightOccluders::light).enumerate() {
            if !light.is_plain {
                view.unclear |= 1 << index;
            }
            for plane in parts.planes {
                let (viewer, light) = (
                    plane.side(from, parts.epsilon),
                    plane.side(light.place, parts.epsilon),
                );
                match (viewer, light) {
                    // What ends in a plane does not go through it.
                    (_, Side::In) => {}
                    (Side::In | Side::Close, _) | (_, Side::Close) => view.unclear |= 1 << index,
                    _ if viewer == light => {}
                    _ => view.hidden |= 1 << index,
                }
            }
        }
        view
    }

    /// Whether no plane hides the light with a number, and what bounded shapes hide can be told by how it
    /// sees them.
    #[inline(always)]
    pub(crate) fn is_clear(&self, light: usize) -> bool {
        // Of more than 32 lights every bit is set.
        (self.hidden | self.unclear) & bit_modulo_32(light) == 0
    }

    /// Whether a plane hides the light with a number from everything.
    #[inline(always)]
    pub(crate) fn is_hidden(&self, light: usize) -> bool {
        self.hidden & bit_modulo_32(light) != 0
    }
}
