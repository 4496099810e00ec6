//! Lights that a plane hides from all surfaces of a frame, and lights that no plane hides from any.
//!
//! No ray crosses a plane. So all surfaces that a frame's rays hit lie on the camera's side of every
//! plane. A light on the other side of a plane is hidden from all of them. A plane in front of which
//! both camera and light stand hides the light from none of them.

use super::World;
use super::light_occluders::LightOccluders;
use crate::number::bit_modulo_32;
use crate::ray::ScaledPoint;
use crate::shape::plane::Side;

/// The camera's position, and which lights the planes hide in this frame.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightVisibility {
    /// Position of the camera.
    pub(crate) from: ScaledPoint,
    /// One bit for each light that a plane hides from all surfaces. Set with the bit in `unclear`, no plane hides
    /// the light, but its tables do not tell what bounded shapes hide. Such a light is far or stands inside of a
    /// sphere, or the camera is inside of a sphere.
    hidden: u32,
    /// One bit for each light for which each ray must be tested. Alone, a plane may hide the light from some
    /// surfaces: the light or the camera is within epsilon of a plane, or there are more than 32 lights.
    unclear: u32,
}

impl LightVisibility {
    /// Returns a visibility that knows nothing about the lights, for a camera at `from`.
    pub(crate) const fn unclear(from: ScaledPoint) -> Self {
        Self {
            from,
            hidden: 0,
            unclear: u32::MAX,
        }
    }

    /// Computes which lights the planes hide from all surfaces that a camera at `from` can show.
    pub(crate) fn new<W: World>(world: &W, from: ScaledPoint) -> Self {
        let parts = world.parts();
        let (mut hidden, mut partly, mut untold) = (0, 0, 0);
        // Rays that start inside of a sphere stay there.
        if from.is_near() && parts.hold(from.point) {
            untold = u32::MAX;
        }
        let lights = world.tables().light_occluders;
        if lights.len() > u32::BITS as usize {
            return Self::unclear(from);
        }
        for (index, light) in lights.iter().map(LightOccluders::light).enumerate() {
            if !light.is_plain {
                untold |= 1 << index;
            }
            let is_near = light.place.is_near();
            for plane in parts.planes {
                let (viewer, light) = (
                    plane.side(from, parts.epsilon),
                    plane.side(light.place, parts.epsilon),
                );
                match (viewer, light) {
                    // A ray that ends in a plane does not cross it.
                    (_, Side::In) if is_near => {}
                    (Side::In | Side::Close, _) | (_, Side::In | Side::Close) => {
                        partly |= 1 << index;
                    }
                    _ if viewer == light => {}
                    _ => hidden |= 1 << index,
                }
            }
        }
        let untold = untold & !hidden & !partly;
        Self {
            from,
            hidden: hidden | untold,
            unclear: partly & !hidden | untold,
        }
    }

    /// Tests whether no plane hides a light, and the light's tables are enough to find what bounded shapes
    /// hide from it. `light` is the light's index.
    #[inline(always)]
    pub(crate) fn is_clear(&self, light: usize) -> bool {
        // With more than 32 lights every bit is set.
        (self.hidden | self.unclear) & bit_modulo_32(light) == 0
    }

    /// Tests whether no plane hides a light from any surface. `light` is the light's index.
    #[inline(always)]
    pub(crate) fn is_open(&self, light: usize) -> bool {
        (self.hidden ^ self.unclear) & bit_modulo_32(light) == 0
    }

    /// Tests whether a plane hides a light from all surfaces. `light` is the light's index.
    #[inline(always)]
    pub(crate) fn is_hidden(&self, light: usize) -> bool {
        self.hidden & !self.unclear & bit_modulo_32(light) != 0
    }
}
