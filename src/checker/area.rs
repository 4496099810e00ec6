//! Floor 2: the share of an area that shows a checker's colour.

use super::{Axis, PLACES, PreparedChecker};
use crate::number::{
    Unit, difference_modulo_2_32, divide, high_unsigned, low_word, product_modulo_2_32, signed,
    signed_wide, sum_modulo_2_32, twos_complement, unit_product,
};
use crate::ray::ScaledPoint;
use crate::vector::Vector;
use heapless::Vec;

/// An area of a flat surface: a parallelogram.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Area {
    pub(crate) middle: ScaledPoint,
    /// Its two sides, in steps of 2^`scale`.
    pub(crate) sides: [Vector; 2],
    pub(crate) scale: u32,
}

/// An area is fine if it is wider than this along an axis: half a cell.
const FINE: u64 = 1 << (PLACES - 1);

impl PreparedChecker {
    /// Tests whether an area is wider than half a cell along an axis. If not, each of its sides crosses one border or none
    /// along each axis.
    pub(crate) fn is_fine_on(&self, area: &Area) -> bool {
        let [one, other] = self.extents(area);
        let mut pairs = one.into_iter().zip(other);
        pairs.any(|(one, other)| one.unsigned_abs() + other.unsigned_abs() > FINE)
    }

    /// Returns the share of an area that has the checker's colour, 0 to 1.
    ///
    /// Let a point be worth 1 in a cell of the material's colour, and -1 in one of the checker's. That is the product of
    /// three square waves, one for each axis. The area is divided into parts along its longer side, and the mean of
    /// the product over a part is taken as the product of the three means. Each is that of a wave over the part's width along
    /// its axis: exact if the cells have an end along one axis only.
    pub(crate) fn share_on(&self, area: &Area) -> Unit {
        let extents = self.extents(area);
        let lengths = extents.map(|it| it.iter().map(|it| it.unsigned_abs()).sum::<u64>());
        let [long, short] =
            if lengths[0] > lengths[1] { extents } else { [extents[1], extents[0]] };
        // Four or eight parts.
        let parts = if lengths[0].max(lengths[1]) > FINE { 3 } else { 2 };
        let middle = self.places(area.middle);
        let (mut sign, mut waves) = (1, Vec::<_, 3>::new());
        for (middle, sides) in middle.into_iter().zip(long.into_iter().zip(short)) {
            match Wave::new(middle, sides, parts) {
                Ok(wave) => drop(waves.push(wave)),
                Err(cell) => sign *= cell,
            }
        }
        if waves.is_empty() {
            return Unit::from_bits((1 << 29) * (1 - sign));
        }
        let mut mean = 0;
        for part in 0..1 << parts {
            let means = waves.iter().map(|wave| wave.mean(part));
            mean += means.fold(Unit::ONE, unit_product).to_bits() >> (parts + 1);
        }
        Unit::from_bits((1 << 29) - sign * mean)
    }

    /// Returns the extents of an area's two sides along each axis, counted in cells, with [`PLACES`] fraction bits.
    fn extents(&self, area: &Area) -> [[i64; 3]; 2] {
        let [x, y, z] = &self.axes;
        area.sides.map(|side| {
            [
                x.extent(side.x, area.scale),
                y.extent(side.y, area.scale),
                z.extent(side.z, area.scale),
            ]
        })
    }
}

impl Axis {
    /// Returns an extent in steps of 2^`scale`, counted in cells.
    fn extent(&self, extent: i32, scale: u32) -> i64 {
        const BEYOND: i64 = 1 << 60;
        let is_beyond = self.cells != 0 && self.shift < scale;
        if is_beyond { BEYOND } else { self.place(extent, scale) }
    }
}

/// A square wave along one axis, over the widths of an area's parts: 1 from 0 to 1, -1 from 1 to 2, and so on.
struct Wave {
    /// Where the middle of the first part is, in cells modulo 2, with [`PLACES`] fraction bits.
    first: u32,
    /// How far the middle of the next part is.
    step: u32,
    /// Half of a part's width, modulo 2.
    half: u32,
    /// Half of a part's width, shifted to 2³⁰ to 2³¹: to the left by `up`, and to the right by `down`.
    up: u32,
    down: u32,
    /// 2⁶¹ over the shifted width.
    inverse: u32,
}

impl Wave {
    /// Creates the wave of one axis for an area: `middle`, `long` and `short` are the coordinates of its middle and of its two sides
    /// along this axis, in cells. The area is divided into 2^`parts` parts along its longer side. If it lies in one cell along the
    /// axis, the wave is constant, and its value is returned: 1 or -1.
    fn new(middle: i64, (long, short): (i64, i64), parts: u32) -> Result<Self, i32> {
        let reach = signed_wide((long.unsigned_abs() + short.unsigned_abs()) / 2);
        let cell = (middle - reach) >> PLACES;
        if cell == (middle + reach) >> PLACES {
            return Err(if cell & 1 == 0 { 1 } else { -1 });
        }
        let step = long >> parts;
        let half = (step.unsigned_abs() + short.unsigned_abs()) / 2;
        let zeros = half.leading_zeros();
        let [up, down] = [zeros.saturating_sub(33), 33_u32.saturating_sub(zeros)];
        let [up, down] = [up, down].map(|it| it.min(31));
        let word = |value: i64| low_word(twos_complement(value));
        Ok(Self {
            first: word(middle - (long - step) / 2),
            step: word(step),
            half: low_word(half),
            up,
            down,
            inverse: divide(1 << 62, low_word((half << up) >> down)).mantissa,
        })
    }

    /// Returns the mean over a part, -1 to 1.
    ///
    /// The integral of the wave is a triangle wave: the distance from the nearest even number.
    #[inline(always)]
    fn mean(&self, part: u32) -> Unit {
        let middle = sum_modulo_2_32(self.first, product_modulo_2_32(self.step, part));
        // Half of the distance.
        let integral = |at: u32| at.min(difference_modulo_2_32(0, at)) / 2;
        let from = integral(difference_modulo_2_32(middle, self.half));
        let to = integral(sum_modulo_2_32(middle, self.half));
        let rise = (from.abs_diff(to) << self.up) >> self.down;
        let mean = Unit::from_bits(signed(high_unsigned(rise << 1, self.inverse)));
        if to < from { -mean } else { mean }
    }
}
