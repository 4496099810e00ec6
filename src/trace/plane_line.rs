//! The straight line that a stretch shows of a plane: which point each column shows.

use super::stops::Stop;
use crate::number::{Unit, narrowed_unsigned, ratio, scaled_by_unit, signed, unsigned};
use crate::ray::ScaledPoint;
use crate::vector::{Direction, Point};

/// What is so near to a point of a line counts as that point, as a share of the line: 2⁻²⁰.
const TIE: i32 = 1 << 10;

/// Largest scale of a way to a hit of which the line is known. The way is below 2⁴⁵ steps.
const FURTHEST: u32 = 14;

/// The straight line that a stretch shows of a plane, directly or behind flat mirrors.
pub(super) struct PlaneLine<'a> {
    pub(super) columns: [u32; 2],
    /// The hits of the two columns.
    pub(super) ends: [&'a Stop; 2],
    /// How far the two hits lie ahead of the eye, or of its image behind the mirrors, in any unit, in 23 bits. So the
    /// product with the length of a block is below 2²⁹.
    depths: [u32; 2],
}

impl<'a> PlaneLine<'a> {
    /// Returns the line between the hits of two paths at this level. `hit` returns the point of a stop through which the line
    /// goes: the hit, or the place epsilon above it where that is exact enough. `None` if a hit is further away than
    /// [`FURTHEST`].
    #[inline(never)]
    pub(super) fn new(
        (eye, ahead): (Point, Direction),
        columns: [u32; 2],
        (paths, level): ([&'a [Stop]; 2], usize),
        hit: &dyn Fn(&Stop) -> ScaledPoint,
    ) -> Option<Self> {
        let [one, other] = paths.map(|path| length((eye, ahead), path.get(..=level)?, hit));
        let [(one, length, cosine), (other, end_length, end_cosine)] = [one?, other?];
        let lengths = coarse([length, end_length], 31).map(signed);
        let depths = [(lengths[0], cosine), (lengths[1], end_cosine)]
            .map(|(length, cosine)| unsigned(scaled_by_unit(length, cosine)).into());
        Some(Self {
            columns,
            ends: [one, other],
            depths: coarse(depths, 23),
        })
    }

    /// Bisects for the last column whose point is like the first column's. All columns before it must be alike, too.
    #[inline(always)]
    pub(super) fn last_column(&self, is_like: impl Fn(ScaledPoint) -> bool) -> u32 {
        let [mut before, mut after] = self.columns;
        while after - before > 1 {
            let column = before.midpoint(after);
            if is_like(self.at(column)) { before = column } else { after = column }
        }
        before
    }

    /// Returns how many columns, from the first on, show points before the one that divides the line in two parts of these
    /// lengths, in any unit, below 2⁴⁰. One at least does. A column within 2⁻²⁰ of the line counts as behind that point if
    /// `is_behind`, else as before it.
    pub(super) fn columns_before(&self, parts: [u64; 2], is_behind: bool) -> u32 {
        let ([before, after], [near, far]) = (parts, self.depths.map(u64::from));
        let [part, rest] = [before * far, after * near];
        let drop = 34_u32.saturating_sub((part + rest).leading_zeros());
        let [part, rest] = [part, rest].map(|it| narrowed_unsigned(it >> drop));
        let off = if is_behind { -TIE } else { TIE };
        let share = Unit::from_bits((ratio(part, (part + rest).max(1)) + off).max(0));
        let [first, last] = self.columns;
        1 + unsigned(scaled_by_unit(signed(last - first), share))
    }

    /// Returns the point that a column between two near ones shows. It divides the line as the column divides the columns, each
    /// part weighted with the depth of its end.
    #[inline(never)]
    pub(super) fn at(&self, column: u32) -> ScaledPoint {
        let ([first, last], [near, far]) = (self.columns, self.depths);
        let [part, rest] = [(column - first) * near, (last - column) * far];
        let share = Unit::from_bits(ratio(part, (part + rest).max(1)));
        let [from, to] = self.ends.map(|end| end.place.point);
        ScaledPoint::at(from.towards(to, share))
    }
}

/// Returns the last hit of a path, the length of the path, and the cosine of the angle between its first ray and the direction
/// ahead. `None` if a hit is further away than [`FURTHEST`], or if a ray starts within epsilon of it.
#[inline(never)]
fn length<'a>(
    (eye, ahead): (Point, Direction),
    path: &'a [Stop],
    hit: &dyn Fn(&Stop) -> ScaledPoint,
) -> Option<(&'a Stop, u64, Unit)> {
    let (mut from, mut length, mut cosine) = (ScaledPoint::at(eye), 0, None);
    for stop in path {
        let (way, scale) = from.to(hit(stop));
        if scale > FURTHEST {
            return None;
        }
        let (direction, way) = way.normalised();
        cosine = cosine.or(Some(direction.dot(ahead)));
        from = stop.place;
        length += u64::from(unsigned(way.to_bits())) << scale;
    }
    let cosine = cosine.filter(|it| *it > Unit::ZERO)?;
    Some((path.last()?, length, cosine))
}

/// Returns two numbers in so many bits, with their largest common scale.
#[inline(never)]
pub(super) fn coarse(numbers: [u64; 2], bits: u32) -> [u32; 2] {
    let drop = (64 - bits).saturating_sub((numbers[0] | numbers[1]).leading_zeros());
    numbers.map(|number| narrowed_unsigned(number >> drop))
}

#[cfg(test)]
mod tests {
    use super::super::Stops;
    use super::*;
    use crate::number::sweep::Sweep;

    /// Returns how many columns show points before one, found for depths in steps.
    fn before(depths: [u32; 2], length: u32, parts: [u64; 2], is_behind: bool) -> u32 {
        let mut stops = Stops::NONE;
        stops.add(None, Direction::X);
        let [stop] = stops.all() else { unreachable!() };
        let line = PlaneLine {
            columns: [7, 7 + length],
            ends: [stop; 2],
            depths: coarse(depths.map(u64::from), 23),
        };
        line.columns_before(parts, is_behind)
    }

    #[test]
    fn columns_before_a_point_are_those_of_exact_numbers() {
        let mut sweep = Sweep::new(0x1f83_d9ab_fb41_bd6b);
        for _ in 0..100_000 {
            let mut some = |most| sweep.within(1, most).unsigned_abs();
            let (length, depths) = (some(64), [some(1 << 30), some(1 << 30)]);
            let parts = [some(1 << 30), some(1 << 30)].map(|it| u64::from(it) << 9);
            let [near, far] = [
                depths[0] as f64 * parts[1] as f64,
                depths[1] as f64 * parts[0] as f64,
            ];
            let border = f64::from(length) * far / (near + far);
            // A depth that is much less than the other has fewer bits.
            let [less, more] = [depths[0].min(depths[1]), depths[0].max(depths[1])];
            let off = 2e-4 + 1e-5 * f64::from(more) / f64::from(less);
            let found = f64::from(before(depths, length, parts, some(2) == 1));
            assert!(
                found - 1.0 <= border + off && border - off <= found,
                "{found} {border}"
            );
        }
    }

    #[test]
    fn column_at_a_point_is_on_the_side_that_is_asked_for() {
        for (length, at) in [(2, 1), (10, 3), (64, 1), (64, 63)] {
            for depths in [[1 << 20; 2], [3 << 20, 5 << 20], [1 << 26, 1 << 20]] {
                let parts = [at * depths[0], (length - at) * depths[1]].map(u64::from);
                assert_eq!(before(depths, length, parts, true), at);
                assert_eq!(before(depths, length, parts, false), at + 1);
            }
        }
    }
}
