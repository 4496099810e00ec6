//! Which shapes can lie ahead of a ray that leaves a round mirror, by its direction.
//!
//! Rays leave a mirror from within balls around it: those of a ball that meet another ball are the
//! rays from its middle that meet one as large as both together. So each mirror has a table as a light
//! has, of 4 x 4 x 4 cells and 16 sets: 192 bytes of flash. A shape is left out only where it is missed,
//! or, if a ray may note on which side it passes, where the ball around it is passed by
//! ([`passes_by`](crate::vector::Vector::passes_by)). So path signatures stay the same, too.
//!
//! Made by the compiler for constant scenes with such mirrors and 4 to [`MOST`] bounded shapes.

use super::direction_table::{CellSets, DirectionTable};
use crate::number::{narrowed, square_root, unsigned_wide, wide};
use crate::scene::access::ShapeId;
use crate::scene::shape_set::{SetLayout, ShapeSet};
use crate::scene::{FEW, Parts};
use crate::vector::{Direction, Point, Vector};

/// How many bounded shapes a scene with mirror tables has at most.
pub(super) const MOST: usize = 16;

/// The shapes ahead of the rays that leave one mirror.
pub type MirrorTable = DirectionTable<4, 64, 16>;

type Cells = CellSets<4, 64>;

/// The tables of a scene's round mirrors.
#[derive(Clone, Copy, Debug)]
pub struct MirrorTables {
    /// Which table each bounded shape has.
    pub(super) numbers: [u8; MOST],
    pub(super) tables: &'static [MirrorTable],
}

impl MirrorTables {
    /// Of a scene without such tables.
    pub(super) const NONE: &'static Self = &Self {
        numbers: [u8::MAX; MOST],
        tables: &[],
    };

    /// The shapes that a ray can meet that leaves a mirror in a direction.
    #[inline(always)]
    pub(super) fn ahead(&self, mirror: ShapeId, direction: Direction) -> &ShapeSet {
        let number = self.numbers.get(mirror.index()).copied();
        let table = self.tables.get(usize::from(number.unwrap_or(u8::MAX)));
        table.map_or(ShapeSet::ALL, |table| table.at(direction))
    }

    /// Which table each bounded shape has, and for how many there is to be room.
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

    /// The tables, where `N` is the room for so many: of all sizes that the compiler works out, one is
    /// used.
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

/// The length of the list that holds so many tables: the compiler makes lists of nine lengths.
const fn room_for(tables: usize) -> usize {
    match tables {
        0..=4 => tables,
        5..=6 => 6,
        7..=8 => 8,
        9..=12 => 12,
        _ => MOST,
    }
}

/// Whether the bounded shape that stands there among them mirrors, and does not move. There are at most
/// 64, so its index is its bit in a set.
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
        /// What lies ahead of rays that leave a bounded shape, by where it stands among them.
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

        /// Adds all that rays from the surface of this ball, or epsilon beside it, can meet.
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
                    let is_noted = crate::shape::$prepared::IS_SIDE_NOTED;
                    match parts.moving.meets(shape) {
                        true => cells.add_everywhere(shape),
                        false => add(cells, from, parts.$list[index].ball(), (shape, is_noted)),
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

/// How far beyond a shape rays may start, apart from epsilon: a hit is known to a few steps, on a
/// cylinder that is met along its axis to some hundred.
const SLACK: i32 = 1 << 10;

/// More than the squares in `passes_by` may be off by. In units of 2³²: the length of a direction and
/// what is taken off for it, 2⁻²⁴ and 2⁻²⁵ of a square below 2⁶⁰, are 24; what it adds for products
/// rounded down 4, and those one each.
const UNSURE: u64 = 32 << 32;

/// Adds a shape in a ball to the directions of the rays from another that can meet it, or note on which
/// side they pass it.
const fn add(
    cells: &mut Cells,
    (origin, from): (Point, i32),
    (center, radius): (Point, i32),
    (shape, is_noted): (ShapeSet, bool),
) {
    let way = origin.to(center);
    let radius = square_root(unsigned_wide(wide(radius, radius)) + UNSURE) + 16;
    let both = from as i64 + radius as i64;
    let distance = square_root(way.square()) as i64;
    if distance <= both {
        return cells.add_everywhere(shape);
    }
    cells.add_ball(way, narrowed(both), shape);
    // What is this far away, √2 times the sum of the radii, lies further behind a ray that goes away
    // from it than its radius, and is passed by so.
    if is_noted && 2 * distance <= 3 * both {
        cells.add_ball(Vector::ZERO.minus(way), narrowed(both), shape);
    }
}

#[cfg(test)]
pub(crate) mod tests;
