//! Which spheres and cylinders lie in which direction from one fixed point: from a light.
//!
//! A direction belongs to one of six faces by its largest coordinate, and on the face to one of
//! 8 x 8 cells by the other two (a cube map over coordinates, so no division is needed to find a
//! cell). A cell holds a mask of the shapes that reach into it. A shape's ball
//! is seen as a cap of angle φ around a direction c, and the coordinates of a cap are bounded by
//! cos(θ ± φ) where θ is the angle from c to the axis; rounding is covered by a margin.

use super::mask::{Mask, Runs};
use crate::number::{Unit, divide, square_root};
use crate::shape::cylinder::PreparedCylinder;
use crate::shape::sphere::PreparedSphere;
use crate::vector::{Direction, Point, Vector};

/// Cells along one side of a face.
const SIDE: usize = 8;

/// A coordinate of Q2.30 times this, without its low 32 bits, is the number of its cell: -4 to 3,
/// for directions that are 64 steps too long, too.
const CELLS: i64 = ((SIDE as i64 / 2) << 32) / (LARGEST_SECOND as i64 + 64);

const FACE: usize = SIDE * SIDE;

/// The shapes in each cell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cells([Mask; 6 * FACE]);

/// 1/√3 in Q2.30, rounded down: the largest coordinate of a direction is at least this.
const SMALLEST_LARGEST: i32 = 619_925_130;

/// 1/√2 in Q2.30, rounded up: the second largest coordinate is at most this.
const LARGEST_SECOND: i32 = 759_250_126;

/// What a bound of a coordinate is widened by: 2⁻¹⁶.
const MARGIN: i32 = 1 << 14;

impl Cells {
    pub(crate) const ALL: Self = Self([Mask::ALL; 6 * FACE]);

    /// The cells around a near point.
    pub(crate) const fn around(
        origin: Point,
        spheres: &[PreparedSphere],
        cylinders: &[PreparedCylinder],
    ) -> Self {
        let runs = Runs::new(spheres.len(), cylinders.len());
        let mut cells = Self([Mask::NONE; 6 * FACE]);
        let mut index = 0;
        while index < spheres.len() {
            let (center, radius) = spheres[index].ball();
            cells.add_ball(origin.to(center), radius, Mask::of(runs.sphere_bit(index)));
            index += 1;
        }
        index = 0;
        while index < cylinders.len() {
            cells.add_cylinder(
                origin,
                &cylinders[index],
                Mask::of(runs.cylinder_bit(index)),
            );
            index += 1;
        }
        cells
    }

    /// The shapes that can be met in a direction.
    pub(crate) fn mask(&self, direction: Direction) -> Mask {
        let Vector { x, y, z } = direction.raw();
        let (ax, ay, az) = (x.unsigned_abs(), y.unsigned_abs(), z.unsigned_abs());
        let (axis, largest, a, b) = if ax >= ay && ax >= az {
            (0, x, y, z)
        } else if ay >= az {
            (1, y, z, x)
        } else {
            (2, z, x, y)
        };
        let index = cell(axis, largest < 0, cell_number(a), cell_number(b));
        self.0.get(index).copied().unwrap_or(Mask::ALL)
    }

    /// A chain of balls along the axis covers the wall.
    const fn add_cylinder(&mut self, origin: Point, cylinder: &PreparedCylinder, shape: Mask) {
        let (center, half_axis, radius) = cylinder.capsule();
        let way = origin.to(center);
        const LINKS: i32 = 8;
        let step = Vector::new(
            half_axis.x / LINKS,
            half_axis.y / LINKS,
            half_axis.z / LINKS,
        );
        let square = radius as i64 as u64 * radius as u64 + step.square();
        let reach = square_root(square) + LINKS;
        let mut link = 1 - LINKS;
        while link < LINKS {
            let along = Vector::new(step.x * link, step.y * link, step.z * link);
            self.add_ball(way.plus(along), reach, shape);
            link += 2;
        }
    }

    const fn add_ball(&mut self, way: Vector, radius: i32, shape: Mask) {
        let (direction, distance) = way.direction_and_length();
        let radius = radius + (radius >> 12) + 16;
        let mut bounds = [(-LARGEST_SECOND, LARGEST_SECOND); 3];
        let mut ends = [(-(1 << 30), 1 << 30); 3];
        if distance.to_bits() > radius {
            let cap = Cap::new(radius, distance.to_bits());
            let coordinates = direction.components();
            let mut axis = 0;
            while axis < 3 {
                ends[axis] = cap.bounds(coordinates[axis].to_bits());
                bounds[axis] = ends[axis];
                axis += 1;
            }
        }
        let mut axis = 0;
        while axis < 3 {
            let (low, high) = ends[axis];
            let (a, b) = (bounds[(axis + 1) % 3], bounds[(axis + 2) % 3]);
            if high >= SMALLEST_LARGEST {
                self.fill(axis, false, a, b, shape);
            }
            if low <= -SMALLEST_LARGEST {
                self.fill(axis, true, a, b, shape);
            }
            axis += 1;
        }
    }

    const fn fill(
        &mut self,
        axis: usize,
        negative: bool,
        a: (i32, i32),
        b: (i32, i32),
        shape: Mask,
    ) {
        let mut i = cell_number(clamp(a.0));
        while i <= cell_number(clamp(a.1)) {
            let mut j = cell_number(clamp(b.0));
            while j <= cell_number(clamp(b.1)) {
                let index = cell(axis, negative, i, j);
                // It always is; said so, nothing can panic.
                if index < self.0.len() {
                    self.0[index] = self.0[index].with(shape);
                }
                j += 1;
            }
            i += 1;
        }
    }
}

/// The number of the cell that a coordinate lies in.
const fn cell_number(coordinate: i32) -> isize {
    ((coordinate as i64 * CELLS) >> 32) as isize
}

const fn clamp(value: i32) -> i32 {
    if value > LARGEST_SECOND {
        LARGEST_SECOND
    } else if value < -LARGEST_SECOND {
        -LARGEST_SECOND
    } else {
        value
    }
}

const fn cell(axis: usize, negative: bool, i: isize, j: isize) -> usize {
    let half = SIDE as isize / 2;
    (2 * axis + negative as usize) * FACE + ((i + half) * SIDE as isize + j + half) as usize
}

/// A cap of directions: everything within an angle φ of one direction.
struct Cap {
    sine: Unit,
    cosine: Unit,
}

impl Cap {
    /// Of a ball of this radius at this distance.
    const fn new(radius: i32, distance: i32) -> Self {
        let quotient = divide((radius as u64) << 30, distance as u32);
        let sine = (quotient.mantissa >> -quotient.exponent) as i64 + 64;
        let sine = if sine > 1 << 30 { 1 << 30 } else { sine };
        let cosine = square_root(((1 << 60) - sine * sine) as u64);
        Self {
            sine: Unit::from_bits(sine as i32),
            cosine: Unit::from_bits(cosine),
        }
    }

    /// The least and the largest value of a coordinate whose value in the middle is `middle`.
    const fn bounds(&self, middle: i32) -> (i32, i32) {
        let middle = if middle > 1 << 30 {
            1 << 30
        } else if middle < -(1 << 30) {
            -(1 << 30)
        } else {
            middle
        };
        let across = square_root(((1 << 60) - middle as i64 * middle as i64) as u64) as i64;
        let along = (middle as i64 * self.cosine.to_bits() as i64) >> 30;
        let spread = (across * self.sine.to_bits() as i64) >> 30;
        // Where the cap holds the axis itself, its end is the axis.
        let cosine = self.cosine.to_bits();
        let low = if -middle >= cosine - MARGIN {
            -(1 << 30)
        } else {
            (along - spread) as i32 - MARGIN
        };
        let high = if middle >= cosine - MARGIN {
            1 << 30
        } else {
            (along + spread) as i32 + MARGIN
        };
        (low, high)
    }
}
