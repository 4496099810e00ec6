//! The bounded shapes that the rays of one row of pixels can hit: rays of the camera, and their first
//! reflection in a plane. The quality `Small` reads the lists.
//!
//! The rays of a row lie in a plane through the eye, and their reflections in the image of that plane. A
//! shape is left out if its ball does not reach the plane. Bound: a radius is widened as in
//! [`screen_bounds`](super::screen_bounds), by two epsilon more if mirrored, and by the distance of the ball
//! times the error of a ray's direction.

use super::screen_axis::widened;
use crate::number::unsigned;
use crate::ray::RowPlane;
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::shape_set::{SetLayout, ShapeSet};
use crate::vector::{Direction, Point, Vector};

/// The lists of one row.
pub(crate) struct RowLists {
    /// The shapes that rays of the camera can hit.
    pub(crate) direct: ShapeSet,
    /// The first plane that mirrored a ray of the row. Rays off another plane test every shape.
    plane: ShapeId,
    /// The shapes that rays off `plane` can hit.
    mirrored: ShapeSet,
    /// The error of a ray's direction is below 2⁻ᵇⁱᵗˢ.
    bits: u32,
}

/// Error of a direction that a plane has mirrored, as a power of 1/2: the cosine is known to 2⁻²⁷, and it
/// counts twice.
const MIRRORED_BITS: u32 = 24;

/// The plane that holds the rays of a row, or their images.
struct Sheet {
    eye: Point,
    normal: Direction,
    /// What radii are enlarged by, in steps.
    lift: i32,
    /// The error of a ray's direction is below 2⁻ᵇⁱᵗˢ.
    bits: u32,
}

impl Sheet {
    /// Returns the shapes whose balls reach the plane.
    #[inline(never)]
    fn met<W: SceneAccess>(&self, world: &W) -> ShapeSet {
        let parts = world.parts();
        let lengths = parts.lengths();
        let layout = SetLayout::new(lengths);
        let mut set = ShapeSet::NONE;
        let mut number = 0;
        while let Some((ball, _)) = parts.ball(number) {
            if self.reaches(ball) {
                set = set.with(ShapeSet::of(layout.bit_of(lengths, number)));
            }
            number += 1;
        }
        set
    }

    /// Tests whether a ball reaches the plane.
    #[inline(always)]
    fn reaches(&self, (center, radius): (Point, i32)) -> bool {
        let way = self.eye.to(center);
        let height = way.dot(self.normal).unsigned_abs();
        height <= unsigned(widened(radius) + self.lift) + (length_bound(way) >> self.bits)
    }
}

/// Returns the sum of the magnitudes of a vector's coordinates. Each is within ±2³⁰.
fn length_bound(way: Vector) -> u32 {
    way.x.unsigned_abs() + way.y.unsigned_abs() + way.z.unsigned_abs()
}

impl RowLists {
    /// Lists that hold every shape.
    pub(crate) const ALL: Self = Self {
        direct: *ShapeSet::ALL,
        plane: ShapeId::NONE,
        mirrored: *ShapeSet::ALL,
        bits: 0,
    };

    /// Makes the lists of a row for a camera at `eye`. `bits` is the length of the shortest vector from the
    /// camera to a pixel of the row, as a power of two.
    pub(crate) fn new<W: SceneAccess>(
        world: &W,
        (eye, row): (Point, &RowPlane),
        bits: u32,
    ) -> Self {
        // The coordinates of the vector are rounded down, and so are the direction and the row's normal.
        let bits = bits.saturating_sub(2).min(31);
        let sheet = Sheet {
            eye,
            normal: row.normal,
            lift: 0,
            bits,
        };
        Self {
            direct: sheet.met(world),
            bits,
            ..Self::ALL
        }
    }

    /// Returns the shapes that a ray can hit after its first reflection, in the plane `id`. `eye` is the
    /// camera, and `normal` that of the row's plane.
    #[inline(always)]
    pub(crate) fn mirrored<W: SceneAccess>(
        &mut self,
        world: &W,
        id: ShapeId,
        (eye, normal): (Point, Direction),
    ) -> ShapeSet {
        if self.plane == ShapeId::NONE {
            self.plane = id;
            self.mirrored = self.image(world, id, (eye, normal));
        }
        match self.plane == id {
            true => self.mirrored,
            false => *ShapeSet::ALL,
        }
    }

    /// Returns the shapes that reach the image of the row's plane in a plane of the scene. Returns all if
    /// the image of the eye is far.
    #[inline(never)]
    fn image<W: SceneAccess>(
        &self,
        world: &W,
        id: ShapeId,
        (eye, normal): (Point, Direction),
    ) -> ShapeSet {
        let parts = world.parts();
        let Some(plane) = parts.plane(id) else {
            return *ShapeSet::ALL;
        };
        let Some(eye) = plane.mirrored(eye, parts.epsilon) else {
            return *ShapeSet::ALL;
        };
        let sheet = Sheet {
            eye,
            normal: normal.reflected(plane.normal, normal.dot(plane.normal)),
            lift: 2 * parts.epsilon.to_bits(),
            bits: self.bits.min(MIRRORED_BITS),
        };
        sheet.met(world)
    }
}
