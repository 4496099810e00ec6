//! A table of the shapes that rays can hit in each direction from one point, or from a ball around it.
//!
//! Directions are divided into [cells](super::cap). A cell stores the number of a set of shapes: all
//! shapes that reach into the cell. Neighbouring cells mostly have equal sets, so each different set is
//! stored once.

use super::cap::{Cap, cell, cell_of, cells_between};
use crate::number::{Unit, signed, to_u8, to_u32};
use crate::scene::shape_set::ShapeSet;
use crate::vector::{Direction, Vector};

/// Table from a direction to a set of shapes. It has `CELLS` = `SIDE`³ cells and at most `SETS`
/// different sets.
#[derive(Clone, Copy, Debug)]
pub struct DirectionTable<const SIDE: usize, const CELLS: usize, const SETS: usize> {
    /// For each cell, the index of its set in `sets`.
    numbers: [u8; CELLS],
    sets: [ShapeSet; SETS],
}

impl<const SIDE: usize, const CELLS: usize, const SETS: usize> DirectionTable<SIDE, CELLS, SETS> {
    /// The table that holds every shape in every direction.
    pub(crate) const ALL: Self = Self {
        numbers: [0; CELLS],
        sets: [*ShapeSet::ALL; SETS],
    };

    /// Returns the shapes that a ray in this direction can hit.
    #[inline(always)]
    pub(crate) fn at(&self, direction: Direction) -> &ShapeSet {
        // The cell is always in range. The remainder tells the compiler, so that it makes no check.
        let cell = cell_of::<SIDE>(direction) % CELLS;
        let number = self.numbers.get(cell).copied().unwrap_or(0);
        let set = self.sets.get(usize::from(number) % SETS);
        set.unwrap_or(ShapeSet::ALL)
    }

    /// Returns the shapes that rays can hit whose direction lies between two, or differs from such a one by
    /// at most `more`.
    pub(crate) fn between(&self, [first, last]: [Direction; 2], more: Unit) -> ShapeSet {
        let (first, last) = (first.raw(), last.raw());
        let within = |first: i32, last: i32| {
            cells_between::<SIDE>([first.min(last), first.max(last)], more.to_bits())
        };
        let x = within(first.x, last.x);
        let y = within(first.y, last.y);
        let z = within(first.z, last.z);
        let mut set = ShapeSet::NONE;
        for x in x.0..=x.1 {
            for y in y.0..=y.1 {
                for z in z.0..=z.1 {
                    let number = self.numbers.get(cell::<SIDE>(x, y, z) % CELLS);
                    let number = usize::from(number.copied().unwrap_or(0));
                    set = set.with(*self.sets.get(number % SETS).unwrap_or(ShapeSet::ALL));
                }
            }
        }
        set
    }

    /// Makes a table from the sets of all cells. Equal sets are stored once.
    ///
    /// If there are more than `SETS` different sets, a cell's set is merged into the stored one that
    /// differs least from it.
    pub(super) const fn of(cells: &CellSets<SIDE, CELLS>) -> Self {
        let mut table = Self {
            numbers: [0; CELLS],
            sets: [ShapeSet::NONE; SETS],
        };
        // The first set is empty.
        let mut used = 1;
        let mut index = 0;
        while index < CELLS {
            let set = cells.0[index];
            let mut nearest = 0;
            let mut number = 1;
            // `number < SETS` always holds here. The condition tells the compiler that nothing can
            // panic.
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
            // The stored set keeps its shapes: other cells may use it.
            table.sets[nearest] = table.sets[nearest].with(set);
            table.numbers[index] = to_u8(to_u32(nearest));
            index += 1;
        }
        table
    }
}

/// The sets of shapes of all cells while a [`DirectionTable`] is made.
pub(super) struct CellSets<const SIDE: usize, const CELLS: usize>([ShapeSet; CELLS]);

impl<const SIDE: usize, const CELLS: usize> CellSets<SIDE, CELLS> {
    /// A table in the making, with an empty set of shapes in every cell.
    pub(super) const NONE: Self = Self([ShapeSet::NONE; CELLS]);

    /// Adds a shape to all cells.
    pub(super) const fn add_everywhere(&mut self, shape: ShapeSet) {
        self.add_ball(Vector::ZERO, 1, shape);
    }

    /// Adds a shape inside of a ball to all cells that the ball reaches.
    ///
    /// `way` is the vector from the table's point to the ball's centre. The radius is widened by 2⁻¹²
    /// of it and 16 steps. If the ball holds the point, the shape is added to all cells.
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
                    // The index is always in range. The condition tells the compiler that nothing can
                    // panic.
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
