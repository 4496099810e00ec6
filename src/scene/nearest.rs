//! The bounded shapes on a near ray: the nearest of them, or whether there is any. All are asked, or
//! candidates.

use super::access::{SceneAccess, ShapeId};
use super::shape_set::ShapeSet;
use crate::number::Length;
use crate::ray::{PathSignature, REACH, Ray};
use crate::shape::bounded::{Bounded, Range};
use crate::vector::Direction;

/// No distance.
pub(crate) const NOWHERE: Length = Length::from_bits(0);

/// Where a near ray meets a shape first: [`ShapeId::NONE`] where it meets none.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Hit {
    pub(crate) distance: Length,
    pub(crate) shape: ShapeId,
}

impl Hit {
    /// Nothing as far as a near ray looks.
    pub(crate) const NONE: Self = Self {
        distance: REACH,
        shape: ShapeId::NONE,
    };

    /// Not known to a near ray.
    pub(crate) const BEYOND: Self = Self {
        distance: REACH,
        shape: ShapeId::BEYOND,
    };
}

macro_rules! questions {
    (
        $header:tt
        $({ $list:ident $($more:tt)* })*
    ) => {
        /// The nearest candidate further than `start` along a ray; the distance is from there. Skips the
        /// shape whose outside the ray leaves. Notes on which side of a shape the ray certainly passes.
        #[inline(never)]
        pub(crate) fn nearest_of<W: SceneAccess>(
            world: &W,
            candidates: &ShapeSet,
            (ray, start): (&Ray, Length),
            skip: ShapeId,
            signature: &mut PathSignature,
        ) -> Hit {
            let mut nearest = Nearest::beyond(start);
            let parts = world.parts();
            let lengths = parts.lengths();
            let (kind, first) = (0, 0);
            $(
                candidates.any(W::CHOOSES_HITS, (kind, lengths), parts.$list, |index, shape| {
                    nearest.ask(shape, ray, ShapeId::at(first + index), skip)
                });
                let (kind, first) = (kind + 1, first + lengths[kind]);
            )*
            let _ = (kind, first);
            nearest.hit(signature)
        }

        /// Whether a ray hits a candidate before `reach`. Skips the shape whose outside the ray leaves.
        #[inline(never)]
        pub(super) fn any_blocks<W: SceneAccess>(
            world: &W,
            candidates: &ShapeSet,
            ray: &Ray,
            skip: ShapeId,
            reach: Length,
        ) -> bool {
            let parts = world.parts();
            let lengths = parts.lengths();
            let (kind, first) = (0, 0);
            $(
                if candidates.any(W::NEEDS.sets, (kind, lengths), parts.$list, |index, shape| {
                    ShapeId::at(first + index) != skip && shape.blocks(ray, reach)
                }) {
                    return true;
                }
                let (kind, first) = (kind + 1, first + lengths[kind]);
            )*
            let _ = (kind, first);
            false
        }
    };
}
kinds!(questions);

/// The nearest of the shapes that a ray has been held against.
pub(crate) struct Nearest {
    start: Length,
    hit: Hit,
    /// On which sides of shapes the ray passes.
    passed: u32,
}

impl Nearest {
    /// Nothing yet, and nothing that is met before `start`.
    #[inline(always)]
    pub(crate) fn beyond(start: Length) -> Self {
        Self {
            start,
            hit: Hit::NONE,
            passed: 0,
        }
    }

    /// Asks a shape unless it is to be skipped; always goes on to the next.
    #[inline(always)]
    fn ask<K: Bounded>(&mut self, shape: &K, ray: &Ray, id: ShapeId, skip: ShapeId) -> bool {
        if id != skip {
            let mut is_passed = false;
            if let Some(distance) = shape.intersect(ray, self.range(), &mut is_passed) {
                self.hit = Hit {
                    distance,
                    shape: id,
                };
            }
            if is_passed {
                self.pass(id.passed());
            }
        }
        false
    }

    /// Asks a shape by how rays from one point meet it; whether it is the nearest up to now. Notes the
    /// side on which the ray passes a shape that `is_thin`.
    #[inline(always)]
    pub(crate) fn ask_from<K: Bounded>(
        &mut self,
        shape: &K,
        from: &K::FromPoint,
        direction: &Direction,
        (id, is_thin): (ShapeId, bool),
    ) -> bool {
        let mut is_passed = false;
        let distance = shape.intersect_from(from, direction, self.range(), &mut is_passed);
        if is_passed && is_thin {
            self.pass(id.passed());
        }
        self.take(distance, id)
    }

    #[inline(always)]
    fn range(&self) -> Range {
        Range {
            start: self.start,
            reach: self.hit.distance,
        }
    }

    #[inline(always)]
    fn take(&mut self, distance: Option<Length>, shape: ShapeId) -> bool {
        if let Some(distance) = distance {
            self.hit = Hit { distance, shape };
        }
        distance.is_some()
    }

    /// Whether part of a shape may be nearer than what has been hit.
    #[inline(always)]
    pub(crate) fn may_see<K: Bounded>(&self, from: &K::FromPoint) -> bool {
        K::may_be_nearer(from, self.hit.distance)
    }

    /// Notes that the ray passes by something.
    #[inline(always)]
    pub(crate) fn pass(&mut self, passed: u32) {
        self.passed ^= passed;
    }

    /// The nearest, and how far behind `start` it is met.
    #[inline(always)]
    pub(crate) fn hit(self, signature: &mut PathSignature) -> Hit {
        signature.note(self.passed);
        let distance = self.hit.distance.to_bits() - self.start.to_bits();
        Hit {
            distance: if self.hit.shape == ShapeId::NONE {
                REACH
            } else {
                Length::from_bits(distance)
            },
            shape: self.hit.shape,
        }
    }
}
