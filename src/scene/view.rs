//! What is the same for all rays of a frame: where they come from, and what that says about
//! shadows.
//!
//! No ray crosses a plane. So all surfaces that a frame's rays come to lie on the camera's side of
//! every plane, and a light on the other side of one is hidden from all of them; planes in front of
//! which camera and light both stand hide it from none.

use super::World;
use crate::number::bit_modulo_32;
use crate::ray::ScaledPoint;
use crate::shape::plane::Side;

/// Whether the planes of a scene stand between a light and what a frame shows.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) enum Visible {
    /// No plane hides the light, and what spheres and cylinders hide can be told by how it sees them.
    Clear,
    /// A plane hides it from everything.
    Hidden,
    /// It depends: the light is far away, or the light or the camera stands inside of a sphere or
    /// within epsilon of a plane.
    Unclear,
}

/// A frame's point of view.
#[derive(Clone, Copy, Debug)]
pub(crate) struct LightVisibility {
    /// Where the rays come from.
    pub(crate) from: ScaledPoint,
    /// A bit for each light that is [`Visible::Hidden`].
    hidden: u32,
    /// A bit for each light that is [`Visible::Unclear`].
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
        let mut seen = parts.spheres.iter().map(|it| it.seen_from(from.point));
        if from.is_near() && seen.any(|it| it.is_around()) {
            view.unclear = u32::MAX;
        }
        if parts.lights.len() > u32::BITS as usize {
            view.unclear = u32::MAX;
            return view;
        }
        for (index, light) in parts.lights.iter().enumerate() {
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

    /// How the light with a number stands.
    #[inline(always)]
    pub(crate) fn standing(&self, light: usize) -> Visible {
        // Of more than 32 lights every bit is set.
        let bit = bit_modulo_32(light);
        if (self.hidden | self.unclear) & bit == 0 {
            Visible::Clear
        } else if self.hidden & bit != 0 {
            Visible::Hidden
        } else {
            Visible::Unclear
        }
    }
}
