//! The shadows of a light on a line of a row's plane: the columns at which one begins or ends.

use super::line::{Cut, Line};
use super::row_plane::{Border, RowPlane, SLACK};
use super::{REACH, ScaledPoint};
use crate::number::{
    Quotient, Unit, divide, narrowed, narrowed_unsigned, over, scaled_by_unit, signed, signed_wide,
    to_u16, unsigned,
};
use crate::vector::{Direction, Point, Vector};

/// A light over a line: the plane of both, with the line as its first axis.
#[derive(Clone, Copy, Debug)]
pub struct Lamp {
    /// Direction from the line to the light, at right angles to the line.
    pub(crate) up: Direction,
    /// Normal of the plane.
    pub(crate) across: Direction,
    /// The light: along the line from its start, and height above it, in steps of 2^`scale`. If its rays are parallel,
    /// the parts of the direction towards it, Q2.30.
    pub(crate) along: i32,
    pub(crate) height: i32,
    pub(crate) scale: u32,
    /// Whether the light's rays are parallel. Its height over its distance then is at least 2^-`bits`.
    pub(crate) is_parallel: bool,
    bits: u32,
}

/// Scale from which on a light's rays to near points are parallel, within rounding: that of suns.
const PARALLEL: u32 = 30;

impl Line {
    /// Returns a light over the line. `start` leads from the eye to the line's start. `None` if the light is
    /// almost on the line, or too far.
    pub(crate) fn lamp(&self, eye: Point, start: Vector, light: ScaledPoint) -> Option<Lamp> {
        let Point { x, y, z } = eye;
        let [x, y, z] = [x + start.x, y + start.y, z + start.z];
        let (way, scale) = ScaledPoint::new(Point::new(x, y, z), 0).to(light);
        if scale >= PARALLEL {
            return self.parallel(way);
        }
        if scale > 12 {
            return None;
        }
        let along = way.dot(self.along);
        let (up, height) = way.without(self.along, along).normalised();
        let height = height.to_bits();
        (height > 64 * SLACK + 4 * (self.off >> scale)).then(|| Lamp {
            up,
            across: self.along.crossed(up),
            along,
            height,
            scale,
            is_parallel: false,
            bits: 0,
        })
    }

    /// Returns a light with parallel rays. `None` if they are almost along the line.
    fn parallel(&self, towards: Vector) -> Option<Lamp> {
        let towards = towards.normalised().0.raw();
        let along = towards.dot(self.along);
        let (up, height) = towards.without(self.along, along).normalised();
        let height = height.to_bits().min(Unit::ONE.to_bits());
        (height > Unit::ONE.to_bits() >> 6).then(|| Lamp {
            up,
            across: self.along.crossed(up),
            along,
            height,
            scale: 0,
            is_parallel: true,
            bits: height.leading_zeros() - 1,
        })
    }
}

impl Lamp {
    /// Returns what the distance of a body from the plane of line and light may be off by, in steps.
    pub(crate) fn off(&self, line: &Line) -> i32 {
        ((2 * SLACK) << self.scale << self.bits) + line.off
    }

    /// Returns a length at right angles to parallel rays, as it falls on the line, clamped.
    pub(crate) fn cast(&self, length: i32) -> i32 {
        over(length, Unit::from_bits(self.height)).unwrap_or(REACH.to_bits() * length.signum())
    }

    /// Returns where the parallel ray through a point meets the line: two places. The point lies between two places
    /// along the line, and two heights above it.
    ///
    /// A point at (a, h) falls on a - h s / z, for the direction (s, z) towards the light. Both are off by 2⁻²⁸, so
    /// the place is off by h 2⁻²⁷ / z².
    pub(crate) fn under(&self, [along, height]: [[i32; 2]; 2]) -> [i32; 2] {
        let slope = Unit::from_bits(self.along);
        let [one, other] = height.map(|it| self.cast(scaled_by_unit(it, slope)));
        let highest = height[0].abs().max(height[1].abs());
        let off = 4 + i64::from(((highest >> 27) + 1) << (2 * self.bits));
        let low = i64::from(along[0]) - i64::from(one.max(other)) - off;
        let high = i64::from(along[1]) - i64::from(one.min(other)) + off;
        [low, high].map(within_reach)
    }
}

/// Returns a place on a line, limited to [`REACH`].
pub(crate) fn within_reach(place: i64) -> i32 {
    let most = i64::from(REACH.to_bits());
    narrowed(place.max(-most).min(most))
}

/// The borders of a row that lie after a column, in no order.
#[derive(Clone, Copy, Debug)]
pub struct Borders {
    borders: [[u16; 2]; BORDERS],
    count: u8,
    /// First column that the borders hold for, and the column after the last.
    first: u16,
    end: u16,
}

/// Largest number of borders that are noted. If a row has more, they lie so close together that little could be
/// interpolated.
const BORDERS: usize = 12;

impl Borders {
    /// No column.
    pub(crate) const NONE: Self = Self {
        borders: [[0; 2]; BORDERS],
        count: 0,
        first: 0,
        end: 0,
    };

    /// Starts without a border, from one column up to another.
    pub(crate) fn new(column: u32, until: u32) -> Self {
        Self {
            first: to_u16(column),
            end: to_u16(until.min(0xfffe) + 1),
            ..Self::NONE
        }
    }

    /// Adds a border. If there is no room for it, nothing is known any more of the columns after the first one.
    pub(crate) fn add(&mut self, border: Border) {
        let Border { first, last } = border;
        if last < i32::from(self.first) || first >= i32::from(self.end) {
            return;
        }
        let place = [first, last.saturating_add(1)].map(|it| to_u16(unsigned(it.clamp(0, 0xffff))));
        match self.borders.get_mut(usize::from(self.count)) {
            Some(free) => {
                *free = place;
                self.count += 1;
            }
            None => self.end(),
        }
    }

    /// Returns the last column to which nothing changes, from `column` on. `None` if that is not known.
    pub(crate) fn until(&self, column: u32) -> Option<u32> {
        let column = to_u16(column.min(0xffff));
        if !(self.first..self.end).contains(&column) {
            return None;
        }
        let mut until = self.end - 1;
        for &[first, end] in self.borders.iter().take(self.count.into()) {
            if end > column {
                until = until.min(first.saturating_sub(1).max(column));
            }
        }
        Some(until.into())
    }

    /// Nothing is known after the first column.
    pub(crate) fn end(&mut self) {
        self.count = 0;
        self.end = self.first + 1;
    }

    /// Tests whether nothing is known after the first column.
    pub(crate) fn has_ended(&self) -> bool {
        self.end <= self.first + 1
    }
}

/// The shadows that fall on a line of a flat surface, as a row shows it.
pub struct Shadows<'a> {
    pub(crate) row: &'a RowPlane,
    pub(crate) line: &'a Line,
    pub(crate) lamp: &'a Lamp,
    pub(crate) borders: &'a mut Borders,
}

/// Places on a line that are further from its start count as far, in steps.
const FAR: i32 = 1 << 29;

impl Shadows<'_> {
    /// A shadow begins or ends between two places of the line, in steps from its start.
    #[inline(never)]
    pub(crate) fn place(&mut self, [from, to]: [i32; 2]) {
        let border = match (from <= -FAR, to >= FAR) {
            (true, true) => Border::ANYWHERE,
            (true, false) => self.row.far_border(self.line, [-FAR, to.min(-FAR)]),
            (false, true) => self.row.far_border(self.line, [FAR, from.max(FAR)]),
            (false, false) => self.row.border(self.line, [from, to]),
        };
        self.borders.add(border);
    }

    /// A shadow begins or ends at a ray from the light whose direction is one of two, or lies between them.
    /// A direction has two components in one unit: along the line, and away from the line. The second is below
    /// 0 if the ray leads towards the line.
    pub(crate) fn rays(&mut self, [one, other]: [[i64; 2]; 2]) {
        match (self.towards(one), self.towards(other)) {
            (None, None) => {}
            (Some([a, b]), Some([c, d])) => self.place([a.min(c), b.max(d)]),
            (Some([a, b]), None) | (None, Some([a, b])) => match one[0] < 0 {
                true => self.place([-FAR, b]),
                false => self.place([a, FAR]),
            },
        }
    }

    /// A shadow ends with that of a point in a rectangle: between two places along the line, and two heights
    /// above it.
    pub(crate) fn corners(&mut self, [along, height]: [[i32; 2]; 2]) {
        let lamp = self.lamp;
        if lamp.is_parallel {
            if height[1] >= 0 {
                self.place(lamp.under([along, height]));
            }
            return;
        }
        let coarser = |[from, to]: [i32; 2], light: i32| {
            let [from, to] = [from >> lamp.scale, (to >> lamp.scale) + 1];
            [from, to].map(|it| i64::from(it) - i64::from(light))
        };
        let ([a, b], [low, high]) = (coarser(along, lamp.along), coarser(height, lamp.height));
        if height[1] < 0 {
            return;
        }
        // The outermost rays lead to two corners each.
        let [left, right] = [[[a, low], [a, high]], [[b, low], [b, high]]]
            .map(|corners| corners.map(|corner| self.towards(corner)));
        match (left, right) {
            ([Some(p), Some(q)], [Some(r), Some(s)]) => self.place([
                p[0].min(q[0]).min(r[0]).min(s[0]),
                p[1].max(q[1]).max(r[1]).max(s[1]),
            ]),
            ([None, None], [None, None]) => {}
            _ => self.borders.end(),
        }
    }

    /// A body cuts the line between two places, and again between two.
    pub(crate) fn cut(&mut self, places: Cut<[[i32; 2]; 2]>) {
        match places {
            Cut::None => {}
            Cut::Unknown => self.borders.end(),
            Cut::Some(places) => places.into_iter().for_each(|places| self.place(places)),
        }
    }

    /// Returns where a ray of the light meets the line: two places, or `None` if it does not.
    fn towards(&self, [along, down]: [i64; 2]) -> Option<[i32; 2]> {
        if down >= 0 {
            return None;
        }
        let [run, fall] = [along.unsigned_abs(), down.unsigned_abs()];
        let drop = 32_u32.saturating_sub(fall.leading_zeros());
        let Quotient { mantissa, exponent } = divide(run, narrowed_unsigned(fall >> drop));
        let product = u64::from(mantissa) * u64::from(unsigned(self.lamp.height));
        let way = match exponent - signed(drop) {
            shift @ -63..0 => product >> -shift,
            shift if shift < 0 => 0,
            _ => u64::MAX,
        };
        let way = narrowed(signed_wide(way.min(1 << 30)));
        let off = (way >> 23) + 4;
        let place = i64::from(self.lamp.along) + i64::from(if along < 0 { -way } else { way });
        Some(
            [place - i64::from(off), place + i64::from(off)]
                .map(|place| narrowed((place << self.lamp.scale).clamp(-(1 << 30), 1 << 30))),
        )
    }
}
