//! Which spheres and cylinders can lie ahead of a ray that leaves a mirror, by its direction: for
//! mirrors that are spheres or cylinders, whose rays go anywhere.
//!
//! Rays leave a mirror from within balls around it: those of a ball that meet another ball are the
//! rays from its middle that meet one as large as both together. So each mirror has a table of the
//! [directions](super::directions) as a light has, of 4 x 4 x 4 cells with a set of 16 bits each: 128
//! bytes of flash. A sphere is left out only where it is not met, a cylinder only where the ball around
//! it is passed by ([`passes_by`](crate::vector::Vector::passes_by)), so that no side of it would be
//! noted: the picture and the signatures are those of a scene without tables.
//!
//! Made by the compiler for constant scenes with such mirrors and 4 to [`MirrorSet::SHAPES`] spheres and
//! cylinders; in all others, rays after such mirrors ask every shape.

use super::directions::{Table, cell_of};
use super::mask::Mask;
use super::needs::FEW;
use super::{Scene, used};
use crate::number::{Unit, narrowed, square_root, to_u16, unsigned_wide, wide};
use crate::shape::cylinder::PreparedCylinder;
use crate::shape::sphere::PreparedSphere;
use crate::vector::{Direction, Point, Vector};

/// A set of the shapes of a scene that has not many: a bit for each, spheres first.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct MirrorSet(u16);

impl MirrorSet {
    /// How many shapes there may be.
    pub(crate) const SHAPES: usize = 16;

    /// Every shape.
    pub(crate) const ALL: Self = Self(u16::MAX);

    /// Calls with each of the shapes of one kind that are in the set, and says what the set is for
    /// those after them.
    #[inline(always)]
    pub(crate) fn for_each<'a, T>(
        self,
        shapes: &'a [T],
        mut call: impl FnMut(usize, &'a T),
    ) -> Self {
        let (set, count) = (u32::from(self.0), shapes.len().min(Self::SHAPES));
        let mut rest = set & ((1 << count) - 1);
        while rest != 0 {
            let index = rest.trailing_zeros() as usize;
            rest &= rest - 1;
            if let Some(shape) = shapes.get(index) {
                call(index, shape);
            }
        }
        Self(to_u16(set >> count))
    }
}

/// Cells along one axis.
const SIDE: usize = 4;

/// How many cells there are.
const CELLS: usize = SIDE * SIDE * SIDE;

/// What lies ahead of the rays that leave one shape.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Ahead([MirrorSet; CELLS]);

impl Ahead {
    /// Everything in every direction.
    pub(super) const ALL: Self = Self([MirrorSet::ALL; CELLS]);

    /// What a ray in a direction can meet.
    #[inline(always)]
    pub(crate) fn shapes(&self, direction: Direction) -> MirrorSet {
        // Never out of range; said so, it need not be asked.
        let cell = cell_of::<SIDE>(direction) % CELLS;
        self.0.get(cell).copied().unwrap_or(MirrorSet::ALL)
    }

    const fn of(table: &Table<SIDE, CELLS>) -> Self {
        let mut sets = [MirrorSet::ALL; CELLS];
        let mut index = 0;
        while index < CELLS {
            sets[index] = MirrorSet(table.0[index].low());
            index += 1;
        }
        Self(sets)
    }
}

/// What lies ahead of the rays that leave each of the mirrors of a scene.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RoundMirrors {
    /// Which table each shape has.
    pub(super) numbers: [u8; MirrorSet::SHAPES],
    pub(super) tables: &'static [Ahead],
}

impl RoundMirrors {
    /// Of a scene of which nothing is known.
    pub(super) const NONE: &'static Self = &Self {
        numbers: [u8::MAX; MirrorSet::SHAPES],
        tables: &[],
    };

    /// What a ray can meet that leaves a shape, by where that stands among all shapes.
    #[inline(always)]
    pub(super) fn ahead(&self, shape: usize, direction: Direction) -> MirrorSet {
        let number = self.numbers.get(shape).copied().unwrap_or(u8::MAX);
        let table = self.tables.get(usize::from(number));
        table.map_or(MirrorSet::ALL, |ahead| ahead.shapes(direction))
    }
}

/// Of the sizes that lists of tables have, the one for so many.
pub(super) const fn room_for(tables: usize) -> usize {
    match tables {
        0..=4 => tables,
        5..=6 => 6,
        7..=8 => 8,
        9..=12 => 12,
        _ => MirrorSet::SHAPES,
    }
}

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
    table: &mut Table<SIDE, CELLS>,
    (origin, from): (Point, i32),
    (center, radius): (Point, i32),
    (bit, is_noted): (usize, bool),
) {
    let way = origin.to(center);
    let radius = square_root(unsigned_wide(wide(radius, radius)) + UNSURE) + 16;
    let both = from as i64 + radius as i64;
    let distance = square_root(way.square()) as i64;
    if distance <= both {
        // In all directions.
        return table.add_ball(Vector::ZERO, 1, Mask::of(bit));
    }
    table.add_ball(way, narrowed(both), Mask::of(bit));
    // What is this far away, √2 times the sum of the radii, lies further behind a ray that goes away
    // from it than its radius, and is passed by so.
    if is_noted && 2 * distance <= 3 * both {
        table.add_ball(Vector::ZERO.minus(way), narrowed(both), Mask::of(bit));
    }
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize>
    Scene<S, P, C, L, M>
{
    /// How many spheres and cylinders mirror; none where their rays have no tables.
    pub(super) const fn count_round_mirrors(&self) -> usize {
        let bounded = self.counts.spheres + self.counts.cylinders;
        if bounded <= FEW || bounded > MirrorSet::SHAPES {
            return 0;
        }
        let (mut index, mut count) = (0, 0);
        while index < bounded {
            count += self.is_mirror(index) as usize;
            index += 1;
        }
        count
    }

    /// Which table each shape has.
    pub(super) const fn numbers_ahead(&self) -> [u8; MirrorSet::SHAPES] {
        let mut numbers = [u8::MAX; MirrorSet::SHAPES];
        let (mut index, mut used) = (0, 0);
        while index < MirrorSet::SHAPES {
            if self.is_mirror(index) {
                numbers[index] = used;
                used += 1;
            }
            index += 1;
        }
        numbers
    }

    /// The table of each mirror, where `N` is the room for so many: of all sizes that the compiler works
    /// out, one is used.
    pub(super) const fn tables_ahead<const N: usize>(&self) -> [Ahead; N] {
        let mut tables = [Ahead::ALL; N];
        if room_for(self.count_round_mirrors()) != N {
            return tables;
        }
        let (mut index, mut used) = (0, 0);
        while index < MirrorSet::SHAPES && used < N {
            if self.is_mirror(index) {
                tables[used] = self.ahead_of(index);
                used += 1;
            }
            index += 1;
        }
        tables
    }

    /// Whether a sphere or cylinder mirrors, by where it stands among them.
    const fn is_mirror(&self, index: usize) -> bool {
        let (spheres, cylinders) = self.bounded();
        let material = if index < spheres.len() {
            spheres[index].material
        } else if index - spheres.len() < cylinders.len() {
            cylinders[index - spheres.len()].material
        } else {
            return false;
        };
        let index = material.index();
        index < M && self.materials[index].mirror.to_bits() > Unit::ZERO.to_bits()
    }

    /// What lies ahead of rays that leave a sphere or cylinder, by where it stands among them; there is
    /// one.
    const fn ahead_of(&self, index: usize) -> Ahead {
        let (spheres, cylinders) = self.bounded();
        let mut table = Table::NONE;
        if index < spheres.len() {
            self.add_all(&mut table, spheres[index].ball());
        } else {
            let cylinder = &cylinders[index - spheres.len()];
            let mut link = 0;
            while link < PreparedCylinder::LINKS {
                self.add_all(&mut table, cylinder.link(link));
                link += 1;
            }
        }
        Ahead::of(&table)
    }

    /// Adds all that rays from the surface of this ball, or epsilon beside it, can meet.
    const fn add_all(&self, table: &mut Table<SIDE, CELLS>, (origin, radius): (Point, i32)) {
        let (spheres, cylinders) = self.bounded();
        let (outer, inner) = (self.epsilon.to_bits(), self.inner_epsilon.to_bits());
        let epsilon = if outer > inner { outer } else { inner };
        let from = (origin, radius + epsilon + SLACK);
        let mut index = 0;
        while index < spheres.len() {
            add(table, from, spheres[index].ball(), (index, false));
            index += 1;
        }
        index = 0;
        while index < cylinders.len() {
            let bit = spheres.len() + index;
            add(table, from, cylinders[index].ball(), (bit, true));
            index += 1;
        }
    }

    const fn bounded(&self) -> (&[PreparedSphere], &[PreparedCylinder]) {
        (
            used(&self.spheres, self.counts.spheres),
            used(&self.cylinders, self.counts.cylinders),
        )
    }
}

#[cfg(test)]
pub(crate) mod tests;
