//! Which spheres and cylinders lie in which direction from one fixed point: from a light.
//!
//! Each coordinate of a direction is cut into eighths of its range, so that a direction belongs to
//! one of 8 x 8 x 8 cells without a comparison of coordinates; those that the sphere of directions
//! does not pass through stay empty. A cell names a set of the shapes that reach into it; cells that
//! are next to each other mostly share one, so the sets are kept apart from the cells. A shape's
//! ball is seen as a cap of angle φ around a direction c, the coordinates of a cap are bounded by
//! cos(θ ± φ) where θ is the angle from c to the axis, and a cell is left out as well where all of
//! its points have a smaller cosine to c than cos φ; rounding is covered by a margin.

use super::mask::{Mask, Runs};
use crate::number::{Unit, divide, square_root};
use crate::shape::cylinder::PreparedCylinder;
use crate::shape::sphere::PreparedSphere;
use crate::vector::{Direction, Point, Vector};

/// Cells along one axis.
const SIDE: usize = 8;

/// A coordinate of Q2.30 without these bits is the number of its cell, -4 to 3.
const CELL_BITS: u32 = 28;

/// How many cells there are.
const CELLS: usize = SIDE * SIDE * SIDE;

/// How many different sets are kept; where there are more, those that are most alike become one.
const SETS: usize = 64;

/// The shapes in each cell.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Cells {
    /// Which set a cell has.
    numbers: [u8; CELLS],
    sets: [Mask; SETS],
}

/// What a bound of a coordinate is widened by: 2⁻¹⁶.
const MARGIN: i32 = 1 << 14;

impl Cells {
    pub(crate) const ALL: Self = Self {
        numbers: [0; CELLS],
        sets: [Mask::ALL; SETS],
    };

    /// The cells around a near point.
    pub(crate) const fn around(
        origin: Point,
        spheres: &[PreparedSphere],
        cylinders: &[PreparedCylinder],
    ) -> Self {
        let runs = Runs::new(spheres.len(), cylinders.len());
        let mut table = Table([Mask::NONE; CELLS]);
        let mut index = 0;
        while index < spheres.len() {
            let (center, radius) = spheres[index].ball();
            table.add_ball(origin.to(center), radius, Mask::of(runs.sphere_bit(index)));
            index += 1;
        }
        index = 0;
        while index < cylinders.len() {
            table.add_cylinder(
                origin,
                &cylinders[index],
                Mask::of(runs.cylinder_bit(index)),
            );
            index += 1;
        }
        table.packed()
    }

    /// The shapes that can be met in a direction.
    #[inline(always)]
    pub(crate) fn mask(&self, direction: Direction) -> Mask {
        let Vector { x, y, z } = direction.raw();
        let index = cell(cell_number(x), cell_number(y), cell_number(z));
        // Never out of range; said so, it need not be asked.
        let number = self.numbers.get(index % CELLS).copied().unwrap_or(0);
        let set = self.sets.get(usize::from(number) % SETS);
        set.copied().unwrap_or(Mask::ALL)
    }
}

/// The shapes in each cell, each with a set of its own.
struct Table([Mask; CELLS]);

impl Table {
    /// With one set for all cells that have the same.
    const fn packed(&self) -> Cells {
        let mut cells = Cells {
            numbers: [0; CELLS],
            sets: [Mask::NONE; SETS],
        };
        // No shape is the first set.
        let mut used = 1;
        let mut index = 0;
        while index < CELLS {
            let mask = self.0[index];
            let mut nearest = 0;
            let mut number = 1;
            // More are never used; said so, nothing can panic.
            while number < used && number < SETS {
                if cells.sets[number].difference(mask) < cells.sets[nearest].difference(mask) {
                    nearest = number;
                }
                number += 1;
            }
            let is_new = cells.sets[nearest].difference(mask) > 0;
            if is_new && used < SETS {
                nearest = used;
                used += 1;
            }
            // What the set held already stays in it: other cells may have it.
            cells.sets[nearest] = cells.sets[nearest].with(mask);
            cells.numbers[index] = nearest as u8;
            index += 1;
        }
        cells
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
        let cap = if distance.to_bits() > radius {
            Some(Cap::new(direction, radius, distance.to_bits()))
        } else {
            None
        };
        let mut bounds = [(-(SIDE as i32) / 2, SIDE as i32 / 2 - 1); 3];
        if let Some(cap) = &cap {
            let coordinates = direction.components();
            let mut axis = 0;
            while axis < 3 {
                let (low, high) = cap.bounds(coordinates[axis].to_bits());
                bounds[axis] = (cell_number(low), cell_number(high));
                axis += 1;
            }
        }
        let [x, y, z] = bounds;
        let mut at = [x.0, y.0, z.0];
        while at[0] <= x.1 {
            at[1] = y.0;
            while at[1] <= y.1 {
                at[2] = z.0;
                while at[2] <= z.1 {
                    let reaches = match &cap {
                        Some(cap) => cap.reaches(at),
                        None => true,
                    };
                    let index = cell(at[0], at[1], at[2]);
                    // It always is; said so, nothing can panic.
                    if reaches && index < self.0.len() {
                        self.0[index] = self.0[index].with(shape);
                    }
                    at[2] += 1;
                }
                at[1] += 1;
            }
            at[0] += 1;
        }
    }
}

/// The number of the cell that a coordinate lies in.
#[inline(always)]
const fn cell_number(coordinate: i32) -> i32 {
    // One beyond ±1 by a few last places, for which there is no cell, is drawn in; less than the margin.
    (coordinate - (coordinate >> 25)) >> CELL_BITS
}

#[inline(always)]
const fn cell(x: i32, y: i32, z: i32) -> usize {
    const SIDES: i32 = SIDE as i32;
    const MIDDLE: i32 = (SIDES / 2) * (SIDES * SIDES + SIDES + 1);
    ((x * SIDES + y) * SIDES + z + MIDDLE) as usize
}

/// A cap of directions: everything within an angle φ of one direction.
struct Cap {
    direction: Direction,
    sine: Unit,
    cosine: Unit,
}

impl Cap {
    /// Of a ball of this radius at this distance.
    const fn new(direction: Direction, radius: i32, distance: i32) -> Self {
        let quotient = divide((radius as u64) << 30, distance as u32);
        let sine = (quotient.mantissa >> -quotient.exponent) as i64 + 64;
        let sine = if sine > 1 << 30 { 1 << 30 } else { sine };
        let cosine = square_root(((1 << 60) - sine * sine) as u64);
        Self {
            direction,
            sine: Unit::from_bits(sine as i32),
            cosine: Unit::from_bits(cosine),
        }
    }

    /// Whether a point of a cell has as large a cosine to the middle as the cap.
    const fn reaches(&self, cell: [i32; 3]) -> bool {
        let coordinates = self.direction.components();
        let mut largest = 0_i64;
        let mut axis = 0;
        while axis < 3 {
            // From 2⁻¹⁶ below the cell to as much above it.
            let low = ((cell[axis] as i64) << CELL_BITS) - MARGIN as i64;
            let high = ((cell[axis] as i64 + 1) << CELL_BITS) + MARGIN as i64;
            let coordinate = coordinates[axis].to_bits() as i64;
            largest += coordinate * if coordinate > 0 { high } else { low };
            axis += 1;
        }
        largest >> 30 >= (self.cosine.to_bits() - MARGIN) as i64
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
            let low = (along - spread) as i32 - MARGIN;
            if low < -(1 << 30) { -(1 << 30) } else { low }
        };
        let high = if middle >= cosine - MARGIN {
            1 << 30
        } else {
            let high = (along + spread) as i32 + MARGIN;
            if high > 1 << 30 { 1 << 30 } else { high }
        };
        (low, high)
    }
}
