//! The bounded shapes that can lie ahead of a ray that leaves a bounded mirror, by the ray's direction.
//!
//! Rays leave a mirror from points inside of balls around it. A ray from any point of a ball can hit a
//! second ball only if the ray from the first ball's centre, in the same direction, hits a ball as
//! large as both together. So each mirror has a [`DirectionTable`], as each light has. It has 4 x 4 x 4
//! cells and 16 sets: 192 bytes of flash.
//!
//! Bound: a shape is left out of a cell only if every such ray misses it.
//!
//! The compiler makes these tables for constant scenes that have bounded mirrors and 4 to [`MOST`]
//! bounded shapes.

use super::direction_table::{CellSets, DirectionTable};
use crate::number::{narrowed, square_root, unsigned_wide, wide};
use crate::scene::access::ShapeId;
use crate::scene::shape_set::{SetLayout, ShapeSet};
use crate::scene::{FEW, Parts};
use crate::vector::{Direction, Point};

/// Largest number of bounded shapes in a scene with mirror tables.
pub(super) const MOST: usize = 16;

/// Table of the shapes ahead of rays that leave one mirror, by the ray's direction.
pub type MirrorTable = DirectionTable<4, 64, 16>;

/// The sets of all cells of a [`MirrorTable`] while it is made.
type Cells = CellSets<4, 64>;

/// The mirror tables of all bounded shapes of a scene that mirror.
#[derive(Clone, Copy, Debug)]
pub struct MirrorTables {
    /// For each bounded shape, the index of its table in `tables`; `u8::MAX` if it has none.
    pub(super) numbers: [u8; MOST],
    /// One table for each mirror. The list may be longer; unused tables hold all shapes.
    pub(super) tables: &'static [MirrorTable],
}

impl MirrorTables {
    /// The tables of a scene without mirror tables.
    pub(super) const NONE: &'static Self = &Self {
        numbers: [u8::MAX; MOST],
        tables: &[],
    };

    /// Returns the shapes that a ray can hit when it leaves `mirror` in a direction; all shapes if
    /// `mirror` has no table.
    #[inline(always)]
    pub(super) fn ahead(&self, mirror: ShapeId, direction: Direction) -> &ShapeSet {
        let number = self.numbers.get(mirror.index()).copied();
        let table = self.tables.get(usize::from(number.unwrap_or(u8::MAX)));
        table.map_or(ShapeSet::ALL, |table| table.at(direction))
    }

    /// Numbers the bounded shapes of a scene that mirror.
    ///
    /// Returns the index of each bounded shape's table, and the length of the list of tables. Returns
    /// no tables for a scene with too few or too many bounded shapes.
    pub(super) const fn numbered(parts: &Parts<'_>) -> ([u8; MOST], usize) {
        let mut numbers = [u8::MAX; MOST];
        let bounded = parts.bounded();
        if bounded <= FEW || bounded > MOST {
            return (numbers, 0);
        }
        let (mut index, mut used) = (0, 0);
        while index < MOST {
            if is_mirror(parts, index) {
                numbers[index] = used;
                used += 1;
            }
            index += 1;
        }
        (numbers, room_for(used as usize))
    }

    /// Makes the mirror tables of a scene if `N` is the length that [`MirrorTables::numbered`] returns.
    /// For any other `N` the tables hold all shapes, and nothing reads them.
    pub(super) const fn tables<const N: usize>(parts: &Parts<'_>) -> [MirrorTable; N] {
        let mut tables = [MirrorTable::ALL; N];
        if Self::numbered(parts).1 != N {
            return tables;
        }
        let (mut index, mut used) = (0, 0);
        while index < MOST && used < N {
            if is_mirror(parts, index) {
                tables[used] = MirrorTable::of(&ahead_of(parts, index));
                used += 1;
            }
            index += 1;
        }
        tables
    }
}

/// Returns the length of the list that stores this many tables. The compiler makes lists of nine
/// lengths only.
const fn room_for(tables: usize) -> usize {
    match tables {
        0..=4 => tables,
        5..=6 => 6,
        7..=8 => 8,
        9..=12 => 12,
        _ => MOST,
    }
}

/// Tests whether the bounded shape at `index` among all bounded shapes has a mirroring material.
const fn is_mirror(parts: &Parts<'_>, index: usize) -> bool {
    match parts.ball(index) {
        Some((_, material)) => {
            let moves = parts.moving.meets(ShapeSet::of(index));
            let index = material.index();
            !moves && index < parts.materials.len() && parts.materials[index].mirrors()
        }
        None => false,
    }
}

macro_rules! mirror_table {
    (
        $header:tt
        $({ $list:ident $kind:ident $described:ident $prepared:ident $($more:tt)* })*
    ) => {
        /// Returns the cells of the rays that leave the bounded shape at `index`: the shapes that they
        /// can hit.
        const fn ahead_of(parts: &Parts<'_>, index: usize) -> Cells {
            let mut cells = Cells::NONE;
            $(
                if index < parts.$list.len() {
                    let mut link = 0;
                    while link < crate::shape::$prepared::LINKS {
                        add_all(&mut cells, parts, parts.$list[index].link(link));
                        link += 1;
                    }
                    return cells;
                }
                let index = index - parts.$list.len();
            )*
            let _ = index;
            cells
        }

        /// Adds all shapes that rays can hit when they start on the surface of a ball, or epsilon
        /// beside it.
        const fn add_all(cells: &mut Cells, parts: &Parts<'_>, (origin, radius): (Point, i32)) {
            let layout = SetLayout::new(parts.lengths());
            let (outer, inner) = (parts.epsilon.to_bits(), parts.inner_epsilon.to_bits());
            let epsilon = if outer > inner { outer } else { inner };
            let from = (origin, radius + epsilon + SLACK);
            let kind = 0;
            $(
                let mut index = 0;
                while index < parts.$list.len() {
                    let shape = ShapeSet::of(layout.bit(kind, index));
                    match parts.moving.meets(shape) {
                        true => cells.add_everywhere(shape),
                        false => add(cells, from, parts.$list[index].ball(), shape),
                    }
                    index += 1;
                }
                let kind = kind + 1;
            )*
            let _ = kind;
        }
    };
}
kinds!(mirror_table);

/// Largest distance in steps between a mirror's surface and the start of a ray, in addition to epsilon.
/// A hit is known to a few steps; on a cylinder that is hit along its axis to some hundred.
const SLACK: i32 = 1 << 10;

/// Upper bound on the rounding error of the squares in `passes_by`.
///
/// In units of 2³², the parts are: 24 for the length of a direction and the term that corrects it (2⁻²⁴
/// and 2⁻²⁵ of a square below 2⁶⁰), 4 for the constant that `passes_by` adds because products are
/// rounded down, and one for each of these products.
pub(super) const UNSURE: u64 = 32 << 32;

/// Adds a shape to the cells of all rays that start in one ball and can hit the shape's ball.
///
/// `from` is the radius of the first ball, `origin` its centre.
const fn add(
    cells: &mut Cells,
    (origin, from): (Point, i32),
    (center, radius): (Point, i32),
    shape: ShapeSet,
) {
    let way = origin.to(center);
    let radius = square_root(unsigned_wide(wide(radius, radius)) + UNSURE) + 16;
    let both = from as i64 + radius as i64;
    let distance = square_root(way.square()) as i64;
    if distance <= both {
        // The balls overlap: rays in all directions can hit the shape.
        return cells.add_everywhere(shape);
    }
    cells.add_ball(way, narrowed(both), shape);
}

#[cfg(test)]
pub(crate) mod tests;
