//! The hits of a traced path, stored to find out what lies between two paths.

use crate::ray::ScaledPoint;
use crate::scene::Surface;
use crate::scene::access::ShapeId;
use crate::vector::Direction;

/// The hits of a path that can be seen, the first of them.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Stops {
    stops: [Stop; STOPS],
    count: usize,
}

/// Largest number of hits that are stored.
pub(super) const STOPS: usize = 5;

/// A hit of a path.
#[derive(Clone, Copy, Debug)]
pub(super) struct Stop {
    /// The shape; [`ShapeId::NONE`] if the path hit nothing.
    pub(super) shape: ShapeId,
    pub(super) is_inside: bool,
    /// The lights that shine on it, as in [`Lit::lights`](crate::shade::Lit).
    pub(super) lights: u32,
    /// Point epsilon above the surface; if nothing is hit, a point very far away.
    pub(super) place: ScaledPoint,
}

impl Stops {
    /// No hit. All bits are 0, which is the quickest to store.
    pub(crate) const NONE: Self = Self {
        stops: [Stop {
            shape: ShapeId::at(0),
            is_inside: false,
            lights: 0,
            place: ScaledPoint::ORIGIN,
        }; STOPS],
        count: 0,
    };

    /// Adds a hit, with the lights that shine on it, if there is room.
    #[inline(always)]
    pub(super) fn add(&mut self, hit: Option<(&Surface<'_>, u32)>, direction: Direction) {
        let Some(stop) = self.stops.get_mut(self.count) else {
            return;
        };
        self.count += 1;
        match hit {
            None => {
                *stop = Stop {
                    shape: ShapeId::NONE,
                    is_inside: false,
                    lights: 0,
                    place: ScaledPoint::beyond(direction),
                }
            }
            Some((surface, lights)) => {
                *stop = Stop {
                    shape: surface.shape,
                    is_inside: surface.is_inside,
                    lights,
                    place: surface.place,
                }
            }
        }
    }

    /// Removes all hits.
    #[inline(always)]
    pub(super) fn clear(&mut self) {
        self.count = 0;
    }

    /// Returns the stored hits.
    pub(super) fn all(&self) -> &[Stop] {
        self.stops.get(..self.count).unwrap_or(&[])
    }
}
