//! A row of pixels as a plane through the eye, and the columns in which it shows what it cuts.
//!
//! The rays of a row lie in one plane. It cuts a sphere in a circle and a disc in a chord. Seen from the
//! eye, each covers one interval of columns. A shape's interval is widened by an eighth of a column, which
//! is more than the rounding error where [`Span::is_sure`].

use super::ScreenAxis;
use crate::number::{
    Unit, ratio, root_of_square, root_of_unit, scaled_by_unit, signed, to_u16, unit_product,
    unsigned, unsigned_wide, wide,
};
use crate::vector::{Direction, Vector};

/// A row of pixels as a plane through the eye.
#[derive(Clone, Copy, Debug)]
pub struct RowPlane {
    /// The columns of the row: `ahead` leads to the middle of the row.
    pub(crate) axis: ScreenAxis,
    /// Normal of the plane.
    pub(crate) normal: Direction,
    /// Rounding moves a point of a ray off the plane by up to 2^-`places` times its distance ahead.
    pub(crate) places: u32,
}

/// What a radius is enlarged by, in steps: more than the error of a distance from the row's plane, and
/// more than rounding moves the edge of a shape.
pub(crate) const SLACK: i32 = 16;

/// Where a row shows a direction in its plane.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub enum Seen {
    /// Behind the eye.
    Behind,
    /// To the left of all columns.
    Left,
    /// To the right of all columns.
    Right,
    /// Rounding leaves it open.
    Unknown,
    /// Between two columns, in sixteenths.
    At([i32; 2]),
}

/// Sentinel for no column.
pub(crate) const NO_COLUMN: u16 = u16::MAX;

/// Sentinel for a column that is not known.
pub(crate) const ANY_COLUMN: u16 = u16::MAX - 1;

/// The columns of a row in which rays can hit a shape, and where hits begin and end.
#[derive(Clone, Copy, Debug)]
pub struct Span<T> {
    /// First column whose ray can hit the shape.
    pub(crate) first: u16,
    /// Last column whose ray can hit the shape.
    pub(crate) last: u16,
    /// Whether all rays between the first and the last column cut the shape. Rays through these two
    /// columns may miss it.
    pub(crate) is_sure: bool,
    /// Further columns after which another part of the shape may come to the front: where the rims of an
    /// open cylinder begin and end. Exact to one column to the right.
    pub(crate) rims: T,
}

impl<T> Span<T> {
    /// Returns the span between two borders in sixteenths of a column, `None` if no column lies between.
    pub(crate) fn new([first, last]: [i32; 2], is_sure: bool, rims: T) -> Option<Self> {
        // The borders are rounded down. Widen the span by an eighth of a column on both sides.
        let (first, last) = ((first + 13) >> 4, (last + 3) >> 4);
        (first <= last && last >= 0).then(|| Self {
            first: column(first),
            last: column(last),
            is_sure,
            rims,
        })
    }

    /// Returns the span of a shape of which only its columns on the screen are known.
    pub(crate) fn unsure([first, last]: [u16; 2], rims: T) -> Self {
        Self {
            first,
            last,
            is_sure: false,
            rims,
        }
    }
}

/// Returns a column as 16 bits, clamped.
pub(crate) fn column(column: i32) -> u16 {
    to_u16(unsigned(column.clamp(0, 0xffff)))
}

/// The chord in which a row's plane cuts a disc.
pub(crate) enum Chord {
    /// The plane passes the disc.
    None,
    /// The disc is almost in the plane, or reaches beside the eye.
    Unknown,
    /// The columns of both ends in sixteenths, in ascending order, and whether they are exact to an eighth
    /// of a column.
    Ends([i32; 2], bool),
}

impl RowPlane {
    /// Returns the components of a vector ahead, to the middle of the row, and aside, along the row. They are
    /// in steps, rounded down.
    #[inline(always)]
    pub(crate) fn flat(&self, way: Vector) -> [i32; 2] {
        [way.dot(self.axis.ahead), way.dot(self.axis.aside)]
    }

    /// Tests whether rays stay within [`SLACK`] of the plane until they are `ahead` steps ahead of the eye. They do, unless the
    /// view is of almost 180 degrees: nothing is known then of what a row shows so far away.
    #[inline(always)]
    pub(crate) fn holds_rays(&self, ahead: i32) -> bool {
        ahead >> self.places <= SLACK
    }

    /// Returns where the row shows the direction of a vector, given by its parts ahead and aside in any
    /// unit. Each part is known to `off`.
    ///
    /// With both parts off by e, the tangent t = aside / ahead is off by e (1 + |t|) / (ahead - e).
    #[inline(never)]
    pub(crate) fn seen(&self, ahead: i64, aside: i64, off: i64) -> Seen {
        if ahead <= -off {
            return Seen::Behind;
        }
        let beside = aside.abs() - off;
        if ahead <= 8 * off {
            if beside <= 0 || !self.axis.is_beside(beside, ahead + off) {
                return Seen::Unknown;
            }
            return if aside < 0 { Seen::Left } else { Seen::Right };
        }
        let tangent = 2 + (aside.abs() >> (63 - signed(ahead.unsigned_abs().leading_zeros())));
        let off = (off + (off >> 2)) * tangent;
        let scale = self.axis.columns_for_each(ahead);
        let [low, high] = self.axis.sixteenths(aside, off, scale);
        let last = 16 * signed(self.axis.width);
        match (high < -16, low > 2 * last) {
            (true, _) => Seen::Left,
            (_, true) => Seen::Right,
            _ => Seen::At([low - 2, high + 3]),
        }
    }

    /// Returns the span of a ball. `way` is the vector from the eye to its centre.
    ///
    /// The plane cuts the ball in a circle of radius ρ, ρ² = (r - w) (r + w), where w is the distance of
    /// the centre from the plane. With the circle's centre u ahead and v aside, its tangents from the eye
    /// are at (u v ± ρ √(u² + v² - ρ²)) / (u² - ρ²).
    pub(crate) fn ball(&self, way: Vector, radius: i32) -> Option<Span<[u16; 0]>> {
        let apart = way.dot(self.normal).abs();
        let (ahead, aside) = (way.dot(self.axis.ahead), way.dot(self.axis.aside));
        let radius = radius + SLACK;
        if !self.holds_rays(ahead + radius) {
            return Some(Span::unsure([0, u16::MAX], []));
        }
        if apart >= radius {
            return None;
        }
        let square = wide(radius - apart, radius + apart);
        let circle = root_of_square(unsigned_wide(square));
        if ahead - circle < (ahead >> 10) + 64 * SLACK {
            // The circle holds the eye or reaches beside it.
            return if ahead + circle < -SLACK {
                None
            } else {
                Some(Span::unsure([0, u16::MAX], []))
            };
        }
        let rest = wide(ahead, ahead) - square;
        let tangent = root_of_square(unsigned_wide(rest + wide(aside, aside)));
        let (middle, spread) = (wide(ahead, aside), wide(circle, tangent));
        let scale = self.axis.columns_for_each(rest);
        // Both roots are rounded by up to one step.
        let off = 2 * (i64::from(circle) + i64::from(tangent));
        let [first, last] = [middle - spread, middle + spread]
            .map(|numerator| self.axis.sixteenths(numerator, off, scale));
        let is_narrow = first[1] - first[0] <= 6;
        let ends = [first[0], last[1]];
        // Near the eye, a border is further off than in proportion: by 1 / (u - ρ) of its tangent.
        let [first, last] = ends.map(|end| (end - 8 * signed(self.axis.width)).abs());
        let is_far_ahead = 8 * wide(first.max(last), radius) <= wide(circle, ahead - circle);
        let is_sure = is_narrow && is_far_ahead && is_exact(ends, radius, square);
        Span::new(ends, is_sure, [])
    }

    /// Returns the chord in which the plane cuts a disc. `way` is the vector from the eye to its centre.
    pub(crate) fn chord(&self, way: Vector, normal: Direction, radius: i32) -> Chord {
        let across = normal.crossed_with(self.normal.raw());
        let apart = way.dot(self.normal);
        let sine = root_of_square(across.square()).min(Unit::ONE.to_bits());
        let reach = scaled_by_unit(radius + SLACK, Unit::from_bits(sine));
        if !self.holds_rays(way.dot(self.axis.ahead) + radius) {
            return Chord::Unknown;
        }
        if apart.abs() > reach + SLACK {
            return Chord::None;
        }
        if sine < Unit::ONE.to_bits() >> 4 {
            return Chord::Unknown;
        }
        // The chord is off by what `apart` is off by, over the sine, which is at least 2^-bits.
        let bits = sine.leading_zeros() - 1;
        let radius = radius + SLACK - 4 + (4 << bits);
        let reach = scaled_by_unit(radius, Unit::from_bits(sine));
        // Distance of the chord from the centre, and half of its length, as shares of the radius.
        let share = if apart.abs() < reach {
            Unit::from_bits(ratio(apart.unsigned_abs(), unsigned(reach)))
        } else {
            Unit::ONE
        };
        let half = root_of_unit(Unit::ONE - unit_product(share, share));
        let (along, _) = across.normalised();
        let offset = scaled_by_unit(radius, share);
        let towards = normal.crossed(along);
        let foot = way.plus(towards.scaled(if apart < 0 { -offset } else { offset }));
        let half = scaled_by_unit(radius, half);
        let half_chord = along.scaled(half);
        let (Some(one), Some(other)) = (
            self.columns_of(foot.minus(half_chord), bits),
            self.columns_of(foot.plus(half_chord), bits),
        ) else {
            return Chord::Unknown;
        };
        let ends = [one[0].min(other[0]), one[1].max(other[1])];
        let square = (wide(half, half) >> 30) * i64::from(sine);
        let is_narrow = |[low, high]: [i32; 2]| high - low <= 4;
        Chord::Ends(
            ends,
            is_narrow(one) && is_narrow(other) && is_exact(ends, radius, square >> bits),
        )
    }

    /// Returns the smallest and the largest column, in sixteenths, of a point that is known to 4 << `bits`
    /// steps. Returns `None` if it does not lie ahead of the eye.
    fn columns_of(&self, way: Vector, bits: u32) -> Option<[i32; 2]> {
        let (ahead, aside) = (way.dot(self.axis.ahead), way.dot(self.axis.aside));
        (ahead > 64 * SLACK).then(|| {
            let scale = self.axis.columns_for_each(ahead.into());
            // If both change by 4, the tangent aside / ahead changes by (4 + 4 aside / ahead) / ahead.
            let off = (4 + (aside.abs() >> (29 - ahead.leading_zeros()))) << bits;
            self.axis.sixteenths(aside.into(), off.into(), scale)
        })
    }

    /// Returns the plane of the row as it appears in a mirror with this normal.
    pub(crate) fn mirrored(&self, mirror: Direction) -> Self {
        let turned = |direction: Direction| direction.reflected(mirror, direction.dot(mirror));
        Self {
            axis: ScreenAxis {
                ahead: turned(self.axis.ahead),
                aside: turned(self.axis.aside),
                ..self.axis
            },
            normal: turned(self.normal),
            places: self.places,
        }
    }
}

/// Tests whether the ends of a chord are exact to an eighth of a column. `square` is the square of half of
/// its length.
///
/// If the distance of a chord of half length h from the centre of a circle of radius r changes by one step,
/// h changes by r / h steps. The chord has `ends[1] - ends[0]` sixteenths, so h steps are half of them.
fn is_exact([first, last]: [i32; 2], radius: i32, square: i64) -> bool {
    i64::from(last - first) * i64::from(radius) < square >> 2
}
