//! Floor 2: checkers: two colours in cells of space.

mod area;

pub(crate) use area::Area;

use crate::color::Color;
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::material::{are_same, is_color};
use crate::number::{
    Number, low_word, narrowed, narrowed_128, narrowed_unsigned, narrowed_unsigned_128,
    sum_modulo_2_32, twos_complement, wide,
};
use crate::ray::ScaledPoint;
use crate::vector::{Direction, Position};

/// Checker of a material as the user describes it: space is divided into cells, and every other cell has the
/// checker's colour instead of the material's.
///
/// Along each axis, a point x lies in cell ⌊x / size⌋. Where the sum of the three cells is even, the surface
/// has the material's colour. The point is that from which rays leave the surface: epsilon above it.
///
/// ```
/// use reflet::description::Checker;
/// use reflet::{Material, Number};
///
/// const TILES: Material = Material::new([0.9; 3]).checker([0.1, 0.1, 0.2], [0.5, 0.5, 0.0]);
/// let Some(Checker { color, size, .. }) = TILES.described_checker() else { unreachable!() };
/// assert_eq!((color[2], size), (Number::new(0.2), [0.5, 0.5, 0.0].map(Number::new)));
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct Checker {
    /// Colour of every other cell: red, green and blue, 0 to 16 each.
    pub color: [Number; 3],
    /// Size of a cell along x, y and z, in scene units; 0 along an axis in which it has no end.
    pub size: [Number; 3],
}

impl Checker {
    /// Creates a checker that is not checked.
    pub(crate) const fn new(color: [Number; 3], size: [Number; 3]) -> Self {
        Self { color, size }
    }

    /// Returns the fault of the first field that is out of range, or `None`.
    pub(crate) const fn fault(&self) -> Option<ErrorKind> {
        let [x, y, z] = self.size;
        const MOST: i64 = Position::MAX_COORDINATE;
        let is_sized = x.to_bits() | y.to_bits() | z.to_bits() != 0;
        let is_in_range = x.is_within(0, MOST) && y.is_within(0, MOST) && z.is_within(0, MOST);
        if !is_color(self.color) {
            Some(ErrorKind::Color)
        } else if !(is_sized && is_in_range) {
            Some(ErrorKind::Checker)
        } else {
            None
        }
    }

    /// Tests whether two checkers are equal. It can be called in constants, unlike `==`.
    pub(crate) const fn same(&self, other: &Self) -> bool {
        are_same(self.color, other.color) && are_same(self.size, other.size)
    }
}

/// Checker as the kernels read it: the cell of a point on the grid takes a product for each axis.
#[derive(Clone, Copy, Debug)]
pub struct PreparedChecker {
    /// Colour of every other cell, scaled by [`Color::in_levels`].
    pub(crate) color: Color,
    axes: [Axis; 3],
}

/// Number of fraction bits of a place in cells.
pub(crate) const PLACES: u32 = 31;

/// A point so many steps below a border counts as on it, so that rounding does not divide pixels that show a border. It is
/// less than the smallest epsilon.
const TIE: i128 = 1;

/// The cells along one axis.
#[derive(Clone, Copy, Debug)]
struct Axis {
    /// Cells in a step, times 2^([`PLACES`] + `shift`): 2²⁹ to 2³⁰, less if a cell has 2³³ steps or more, and 0
    /// if it has no end.
    cells: i32,
    /// At most 31.
    shift: u32,
    /// Place of the grid's middle in cells, [`TIE`] steps further, modulo 2, with [`PLACES`] fraction bits.
    middle: u32,
}

impl PreparedChecker {
    /// The checker of a material that has none: one cell without end.
    pub(crate) const NONE: Self = Self {
        color: Color::BLACK,
        axes: [Axis::NONE; 3],
    };

    /// Converts a checker that was checked to the scene's grid. Fails with [`ErrorKind::Checker`] if a cell
    /// is smaller than two steps, or larger than 2⁴⁴.
    pub(crate) const fn prepare(checker: &Checker, grid: &Grid) -> Result<Self, ErrorKind> {
        let mut prepared = Self {
            color: Color::from_numbers(checker.color).in_levels(),
            ..Self::NONE
        };
        let mut axis = 0;
        while axis < 3 {
            let size = checker.size[axis].to_bits();
            if size > 0 {
                prepared.axes[axis] = match Axis::new(size, grid.middle().0[axis], grid.drop()) {
                    Some(axis) => axis,
                    None => return Err(ErrorKind::Checker),
                };
            }
            axis += 1;
        }
        Ok(prepared)
    }

    /// Tests whether there is more than one cell.
    pub(crate) const fn has_cells(&self) -> bool {
        let [x, y, z] = &self.axes;
        x.cells | y.cells | z.cells != 0
    }

    /// Tests whether a point lies in a cell of the checker's colour.
    #[inline(always)]
    pub(crate) fn holds(&self, ScaledPoint { point, scale }: ScaledPoint) -> bool {
        let [x, y, z] = &self.axes;
        let odd = x.is_odd(point.x, scale) ^ y.is_odd(point.y, scale);
        odd ^ z.is_odd(point.z, scale)
    }

    /// Returns the axis, x or y, whose borders are also counted by themselves on a surface with this normal. Two cells that touch at
    /// a vertex have the same colour; only this count tells them apart. The surface is not at right angles to the axis.
    pub(crate) fn axis_aside(normal: Direction) -> usize {
        let [x, y, z] = normal.components().map(|it| it.abs());
        usize::from(x > y.max(z))
    }

    /// Tests whether a point on a surface with this normal lies in an odd cell along [`PreparedChecker::axis_aside`].
    pub(crate) fn is_odd_aside(&self, at: ScaledPoint, normal: Direction) -> bool {
        let ([x, y, _], point) = (&self.axes, at.point);
        let is_x = Self::axis_aside(normal) == 0;
        if is_x { x.is_odd(point.x, at.scale) } else { y.is_odd(point.y, at.scale) }
    }

    /// Returns the place of a point along each axis: counted in cells, with [`PLACES`] fraction bits.
    pub(crate) fn places(&self, ScaledPoint { point, scale }: ScaledPoint) -> [i64; 3] {
        let [x, y, z] = &self.axes;
        [
            x.counted(point.x, scale),
            y.counted(point.y, scale),
            z.counted(point.z, scale),
        ]
    }

    /// Tests whether all points between two lie in one cell, also if each is off the line between them by up to
    /// `aside` steps.
    pub(crate) fn is_one_cell(&self, [one, other]: [ScaledPoint; 2], aside: i32) -> bool {
        let ends = [
            (one.point.x, other.point.x),
            (one.point.y, other.point.y),
            (one.point.z, other.point.z),
        ];
        let mut axes = self.axes.iter().zip(ends);
        axes.all(|(axis, (first, last))| {
            let cell = axis.cell(first - aside, one.scale);
            cell == axis.cell(first + aside, one.scale)
                && cell == axis.cell(last - aside, other.scale)
                && cell == axis.cell(last + aside, other.scale)
        })
    }
}

impl Axis {
    const NONE: Self = Self {
        cells: 0,
        shift: 0,
        middle: 0,
    };

    /// Prepares an axis from the size of a cell and the middle of the grid, in raw bits, and the number of bits
    /// that make a step. `None` if a cell is smaller than two steps, or larger than 2⁴⁴.
    const fn new(size: i128, middle: Number, drop: u32) -> Option<Self> {
        // The size has `bits` bits, so that the quotient below has 30.
        let bits = 128 - size.leading_zeros();
        if bits < drop + 2 || bits > drop + 44 {
            return None;
        }
        let shift = bits - 2 - drop;
        // Of large cells fewer bits are kept, at least 18: they place a border to 2⁻¹⁵ of the scene's extent.
        let beyond = shift.saturating_sub(31);
        Some(Self {
            cells: narrowed(narrowed_128((1 << (bits + 29)) / size)) >> beyond,
            shift: shift - beyond,
            middle: modulo_2(((middle.to_bits() + (TIE << drop)) << PLACES).div_euclid(size)),
        })
    }

    /// Returns the place of a coordinate in steps of 2^`scale`, counted in cells from the grid's middle. So
    /// far away that a step is larger than a cell, or than 2³¹ steps, all places count as the middle.
    #[inline(always)]
    fn place(&self, coordinate: i32, scale: u32) -> i64 {
        match self.shift.checked_sub(scale) {
            // Below 32, which makes the shift short.
            Some(shift) => wide(coordinate, self.cells) >> (shift & 31),
            None => 0,
        }
    }

    #[inline(always)]
    fn is_odd(&self, coordinate: i32, scale: u32) -> bool {
        let place = low_word(twos_complement(self.place(coordinate, scale)));
        sum_modulo_2_32(place, self.middle) >> PLACES != 0
    }

    /// Returns a place in cells, whose number is even where the cell has the material's colour.
    #[inline(always)]
    fn counted(&self, coordinate: i32, scale: u32) -> i64 {
        self.place(coordinate, scale) + i64::from(self.middle)
    }

    fn cell(&self, coordinate: i32, scale: u32) -> i64 {
        self.counted(coordinate, scale) >> PLACES
    }
}

/// Returns a place in cells, modulo 2.
const fn modulo_2(place: i128) -> u32 {
    let cell = (1 << (PLACES + 1)) - 1;
    narrowed_unsigned(narrowed_unsigned_128((place & cell).unsigned_abs()))
}

#[cfg(test)]
mod tests;
