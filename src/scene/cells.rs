//! Which spheres and cylinders lie in which direction from one fixed point: from a light.
//!
//! The [directions](super::directions) are cut into 8 x 8 x 8 cells. A cell names a set of the shapes
//! that reach into it; cells that are next to each other mostly share one, so the sets are kept apart
//! from the cells.

use super::directions::{Table, cell_of};
use super::mask::{Mask, Runs};
use crate::number::{to_u8, to_u32};
use crate::shape::cylinder::PreparedCylinder;
use crate::shape::sphere::PreparedSphere;
use crate::vector::{Direction, Point};

/// Cells along one axis.
const SIDE: usize = 8;

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
        let mut table = Table::NONE;
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
        packed(&table)
    }

    /// The shapes that can be met in a direction.
    #[inline(always)]
    pub(crate) fn mask(&self, direction: Direction) -> Mask {
        // Never out of range; said so, it need not be asked.
        let cell = cell_of::<SIDE>(direction) % CELLS;
        let number = self.numbers.get(cell).copied().unwrap_or(0);
        let set = self.sets.get(usize::from(number) % SETS);
        set.copied().unwrap_or(Mask::ALL)
    }
}

/// With one set for all cells that have the same.
const fn packed(table: &Table<SIDE, CELLS>) -> Cells {
    let mut cells = Cells {
        numbers: [0; CELLS],
        sets: [Mask::NONE; SETS],
    };
    // No shape is the first set.
    let mut used = 1;
    let mut index = 0;
    while index < CELLS {
        let mask = table.0[index];
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
        cells.numbers[index] = to_u8(to_u32(nearest));
        index += 1;
    }
    cells
}
