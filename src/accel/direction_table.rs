//! Which shapes can be met in which direction from one point, or from a ball around it.
//!
//! Directions are cut into [cells](super::cap). A cell has the number of a set of shapes that reach into
//! it; cells next to each other mostly share one, so the sets are kept apart from the cells.

use super::cap::{Cap, cell, cell_of};
use crate::number::{signed, to_u8, to_u32};
use crate::scene::shape_set::ShapeSet;
use crate::vector::{Direction, Vector};

/// A set of shapes for each of `CELLS` = `SIDE`³ cells, `SETS` different ones at most.
#[derive(Clone, Copy, Debug)]
pub struct DirectionTable<const SIDE: usize, const CELLS: usize, const SETS: usize> {
    /// Which set a cell has.
    numbers: [u8; CELLS],
    sets: [ShapeSet; SETS],
}

impl<const SIDE: usize, const CELLS: usize, const SETS: usize> DirectionTable<SIDE, CELLS, SETS> {
    /// Every shape in every direction.
    pub(crate) const ALL: Self = Self {
        numbers: [0; CELLS],
        sets: [*ShapeSet::ALL; SETS],
    };

    /// The shapes that can be met in a direction.
    #[inline(always)]
    pub(crate) fn at(&self, direction: Direction) -> &ShapeSet {
        // Never out of range; said so, it need not be asked.
        let cell = cell_of::<SIDE>(direction) % CELLS;
        let number = self.numbers.get(cell).copied().unwrap_or(0);
        let set = self.sets.get(usize::from(number) % SETS);
        set.unwrap_or(ShapeSet::ALL)
    }

    /// One set for all cells that have the same; where there are too many, the most alike become one.
    pub(super) const fn of(cells: &CellSets<SIDE, CELLS>) -> Self {
        let mut table = Self {
            numbers: [0; CELLS],
            sets: [ShapeSet::NONE; SETS],
        };
        // No shape is the first set.
        let mut used = 1;
        let mut index = 0;
        while index < CELLS {
            let set = cells.0[index];
            let mut nearest = 0;
            let mut number = 1;
            // More are never used; said so, nothing can panic.
            while number < used && number < SETS {
                if table.sets[number].difference(set) < table.sets[nearest].difference(set) {
                    nearest = number;
                }
                number += 1;
            }
            let is_new = table.sets[nearest].difference(set) > 0;
            if is_new && used < SETS {
                nearest = used;
                used += 1;
            }
            // What the set held already stays in it: other cells may have it.
            table.sets[nearest] = table.sets[nearest].with(set);
            table.numbers[index] = to_u8(to_u32(nearest));
            index += 1;
        }
        table
    }
}

/// The shapes in each cell, while a table is made.
pub(super) struct CellSets<const SIDE: usize, const CELLS: usize>([ShapeSet; CELLS]);

impl<const SIDE: usize, const CELLS: usize> CellSets<SIDE, CELLS> {
    /// No shape in any.
    pub(super) const NONE: Self = Self([ShapeSet::NONE; CELLS]);

    /// Adds a shape to all cells.
    pub(super) const fn add_everywhere(&mut self, shape: ShapeSet) {
        self.add_ball(Vector::ZERO, 1, shape);
    }

    /// Adds a ball, whose middle lies so far from the point, to the cells that it reaches.
    pub(super) const fn add_ball(&mut self, way: Vector, radius: i32, shape: ShapeSet) {
        let (direction, distance) = way.direction_and_length();
        let radius = radius + (radius >> 12) + 16;
        let cap = if distance.to_bits() > radius {
            Some(Cap::new(direction, radius, distance.to_bits()))
        } else {
            None
        };
        let half = signed(to_u32(SIDE / 2));
        let mut bounds = [(-half, half - 1); 3];
        if let Some(cap) = &cap {
            let mut axis = 0;
            while axis < 3 {
                bounds[axis] = cap.cells::<SIDE>(axis);
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
                        Some(cap) => cap.reaches::<SIDE>(at),
                        None => true,
                    };
                    let index = cell::<SIDE>(at[0], at[1], at[2]);
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
