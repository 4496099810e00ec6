//! A table of the bounded shapes in each direction from a light.
//!
//! Directions are divided into 8 x 8 x 8 [cells](super::cap). A cell stores the number of a set of shapes: all
//! shapes that reach into the cell. Neighbouring cells mostly have equal sets, so each different set is stored
//! once, at most 64: 1 KB a light. Bound: the radius of each ball is widened by 2⁻¹² of it and 16 steps. A
//! cylinder's wall is covered by a chain of balls.

use super::World;
use super::cap::{Cap, SIDE, cell, cell_of, cells_between};
use crate::number::{Unit, signed, to_u8, to_u32};
use crate::qualities::Quality;
use crate::ray::ScaledPoint;
use crate::scene::shape_set::{SetLayout, ShapeSet};
use crate::scene::{FEW, Parts};
use crate::shape::rays::Spread;
use crate::vector::{Direction, Vector};

/// Number of cells of a table.
const CELLS: usize = SIDE * SIDE * SIDE;

/// Largest number of different sets of a table.
const SETS: usize = 64;

/// Table of the bounded shapes in each direction from one light.
#[derive(Clone, Copy, Debug)]
pub struct LightTable {
    /// For each cell, the index of its set in `sets`.
    numbers: [u8; CELLS],
    sets: [ShapeSet; SETS],
}

impl LightTable {
    /// The table that holds every shape in every direction.
    pub(crate) const ALL: Self = Self {
        numbers: [0; CELLS],
        sets: [*ShapeSet::ALL; SETS],
    };

    /// Returns the shapes that a ray in this direction can hit.
    #[inline(always)]
    pub(crate) fn at(&self, direction: Direction) -> &ShapeSet {
        // The cell is always in range. The remainder tells the compiler, so that it makes no check.
        let cell = cell_of(direction) % CELLS;
        let number = self.numbers.get(cell).copied().unwrap_or(0);
        let set = self.sets.get(usize::from(number) % SETS);
        set.unwrap_or(ShapeSet::ALL)
    }

    /// Returns the shapes that rays can hit whose direction lies between two, or differs from such a one by
    /// at most `more`.
    pub(crate) fn between(&self, [first, last]: [Direction; 2], more: Unit) -> ShapeSet {
        let (first, last) = (first.raw(), last.raw());
        let within = |first: i32, last: i32| {
            cells_between([first.min(last), first.max(last)], more.to_bits())
        };
        let x = within(first.x, last.x);
        let y = within(first.y, last.y);
        let z = within(first.z, last.z);
        let mut set = ShapeSet::NONE;
        for x in x.0..=x.1 {
            for y in y.0..=y.1 {
                for z in z.0..=z.1 {
                    let number = self.numbers.get(cell(x, y, z) % CELLS);
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
    const fn of(cells: &CellSets) -> Self {
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

/// The sets of shapes of all cells while a [`LightTable`] is made.
struct CellSets([ShapeSet; CELLS]);

impl CellSets {
    /// Adds a shape inside of a ball to all cells that the ball reaches.
    ///
    /// `way` is the vector from the table's point to the ball's centre. The radius is widened by 2⁻¹²
    /// of it and 16 steps. If the ball holds the point, the shape is added to all cells.
    const fn add_ball(&mut self, way: Vector, radius: i32, shape: ShapeSet) {
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
                bounds[axis] = cap.cells(axis);
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

impl LightTable {
    /// Makes the table of a light. If the light is far, every direction holds every shape.
    pub(crate) const fn around(light: ScaledPoint, parts: &Parts<'_>) -> Self {
        if !light.is_near() {
            return Self::ALL;
        }
        let layout = SetLayout::new(parts.lengths());
        // A shape that moves may be anywhere.
        let mut cells = CellSets([parts.moving; CELLS]);
        let mut number = 0;
        while let Some(((center, radius), shape)) = parts.link(number) {
            cells.add_ball(light.point.to(center), radius, layout.set_of(shape));
            number += 1;
        }
        Self::of(&cells)
    }

    /// Makes the tables of all lights of a scene, in their order. Unused places hold every shape.
    pub(super) const fn of_lights<const L: usize>(parts: &Parts<'_>) -> [Self; L] {
        let mut tables = [Self::ALL; L];
        let mut index = 0;
        while index < parts.lights.len() && index < L {
            tables[index] = Self::around(parts.lights[index].place, parts);
            index += 1;
        }
        tables
    }
}

/// Returns the bounded shapes that rays from a light to a curve can hit, by the light's index. `spread`
/// bounds these rays.
pub(super) fn rays_set<W: World, Q: Quality>(world: &W, light: usize, spread: &Spread) -> ShapeSet {
    table_of::<W, Q>(world, light).map_or(*ShapeSet::ALL, |table| {
        table.between(spread.ends, spread.aside)
    })
}

/// Returns the bounded shapes in a direction from a light, by the light's index. Returns all shapes if
/// the light has no table or `Q` does not use tables.
#[inline(always)]
pub(crate) fn light_set<W: World, Q: Quality>(
    world: &W,
    light: usize,
    direction: Direction,
) -> &ShapeSet {
    table_of::<W, Q>(world, light).map_or(ShapeSet::ALL, |table| table.at(direction))
}

/// Returns the table of a light, if it has one and `Q` uses tables.
#[inline(always)]
fn table_of<W: World, Q: Quality>(world: &W, light: usize) -> Option<&LightTable> {
    let is_used = W::NEEDS.sets && Q::CULLING.light_tables && world.parts().bounded() > FEW;
    is_used.then(|| world.tables().light_tables.get(light))?
}

#[cfg(test)]
mod tests;
