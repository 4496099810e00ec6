//! Which spheres and cylinders the rays of one row of pixels can meet, and in which columns.
//!
//! The rays of a row leave one point and lie in one plane. That plane cuts a sphere in a disc, and
//! the tangents from the point to the disc bound the columns in which the sphere can be met. A
//! cylinder lies between the discs around its ends. The rays that a mirroring plane sends on do
//! the same with the shapes mirrored in it. Bounds are widened by more than rounding can be wrong.

use heapless::Vec;

use super::World;
use super::mask::Mask;
use crate::number::{Quotient, divide, square_root};
use crate::ray::Fan;
use crate::shape::plane::PreparedPlane;
use crate::vector::{Point, Vector};

/// The columns, first and last, in which a shape can be met.
#[derive(Clone, Copy, Debug)]
struct Columns {
    first: i32,
    last: i32,
}

impl Columns {
    const ALL: Self = Self {
        first: 0,
        last: i32::MAX,
    };

    fn with(self, other: Self) -> Self {
        Self {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
        }
    }
}

/// The columns in which a run of shapes can be met, held to the 16 bits of a picture's side.
#[derive(Clone, Copy, Debug)]
struct Span {
    first: u16,
    last: u16,
    bit: u8,
}

/// The shapes that can be met in each column of a row.
#[derive(Debug)]
pub(crate) struct Row {
    /// In rising order of bits, a bit once.
    spans: Vec<Span, 64>,
    /// The set for the columns from `since` to before `until`.
    mask: Mask,
    since: u32,
    until: u32,
}

impl Row {
    /// Every shape in every column.
    pub(crate) const ALL: Self = Self {
        spans: Vec::new(),
        mask: Mask::ALL,
        since: 0,
        until: u32::MAX,
    };

    /// Turns into what the rays of a fan can meet.
    pub(crate) fn see<W: World>(&mut self, world: &W, fan: &Fan) {
        self.fill(world, fan, 0, |center, half_axis| {
            Some((fan.origin.to(center), half_axis))
        });
    }

    /// Turns into what the rays of a fan can meet once `plane` has mirrored them.
    pub(crate) fn see_mirrored<W: World>(&mut self, world: &W, fan: &Fan, plane: &PreparedPlane) {
        // Rays leave epsilon above the plane: as good as shapes that much larger.
        let lift = 2 * world.parts().epsilon.to_bits();
        self.fill(world, fan, lift, |center, half_axis| {
            let height = i32::try_from(plane.height(center) >> 30).ok()?;
            if height.unsigned_abs() > 1 << 28 {
                return None;
            }
            let way = fan.origin.to(center).without(plane.normal, 2 * height);
            let along = half_axis.dot(plane.normal);
            Some((way, half_axis.without(plane.normal, 2 * along)))
        });
    }

    /// `seen` gives the way to a shape's middle and its half axis as the fan's rays see them, or
    /// nothing where that cannot be told; every radius is widened by `lift`.
    fn fill<W: World>(
        &mut self,
        world: &W,
        fan: &Fan,
        lift: i32,
        seen: impl Fn(Point, Vector) -> Option<(Vector, Vector)>,
    ) {
        let parts = world.parts();
        let runs = parts.runs();
        self.spans.clear();
        (self.since, self.until) = (0, 0);
        for (index, sphere) in parts.spheres.iter().enumerate() {
            let (center, radius) = sphere.ball();
            let columns = match seen(center, Vector::ZERO) {
                Some((way, _)) => fan.sphere_columns(way, widened(radius) + lift),
                None => Some(Columns::ALL),
            };
            self.add(runs.sphere_bit(index), columns);
        }
        for (index, cylinder) in parts.cylinders.iter().enumerate() {
            let (center, half_axis, radius) = cylinder.capsule();
            let columns = match seen(center, half_axis) {
                Some((way, half)) => fan.capsule_columns(way, half, widened(radius) + lift),
                None => Some(Columns::ALL),
            };
            self.add(runs.cylinder_bit(index), columns);
        }
    }

    fn add(&mut self, bit: usize, columns: Option<Columns>) {
        let Some(Columns { first, last }) = columns else {
            return;
        };
        let held = |column: i32| column.clamp(0, 0xffff) as u16;
        let (first, last, bit) = (held(first), held(last), bit as u8);
        match self.spans.last_mut() {
            Some(span) if span.bit == bit => {
                span.first = span.first.min(first);
                span.last = span.last.max(last);
            }
            _ => {
                // There are 64 bits, so there is room.
                let _ = self.spans.push(Span { first, last, bit });
            }
        }
    }

    /// The shapes that can be met in a column.
    #[inline(always)]
    pub(crate) fn at(&mut self, column: u32) -> Mask {
        if column < self.since || column >= self.until {
            self.find(column);
        }
        self.mask
    }

    /// Finds the set for a column, and up to which column it stays the same.
    #[inline(never)]
    fn find(&mut self, column: u32) {
        self.mask = Mask::NONE;
        self.since = column;
        self.until = u32::MAX;
        for span in &self.spans {
            if column < u32::from(span.first) {
                self.until = self.until.min(span.first.into());
            } else if column <= u32::from(span.last) {
                self.mask = self.mask.with(Mask::of(span.bit.into()));
                self.until = self.until.min(u32::from(span.last) + 1);
            }
        }
    }
}

/// A radius widened by what rounding can be wrong.
fn widened(radius: i32) -> i32 {
    radius + (radius >> 10) + 64
}

impl Fan {
    /// The columns in which a sphere can be met.
    fn sphere_columns(&self, way: Vector, radius: i32) -> Option<Columns> {
        let beside = way.dot(self.normal);
        if beside.abs() > radius {
            return None;
        }
        let square = i64::from(radius) * i64::from(radius) - i64::from(beside) * i64::from(beside);
        self.disc_columns(way, square_root(square as u64) + 2)
    }

    /// The columns in which a cylinder with rounded ends can be met.
    fn capsule_columns(&self, way: Vector, half_axis: Vector, radius: i32) -> Option<Columns> {
        if way.dot(self.normal).abs() > radius + half_axis.dot(self.normal).abs() {
            return None;
        }
        let ends = [way.plus(half_axis), way.minus(half_axis)];
        // An end behind the picture has no columns, but what lies between may be seen.
        if ends.iter().any(|end| end.dot(self.ahead) <= radius) {
            return Some(Columns::ALL);
        }
        let [a, b] = ends.map(|end| self.disc_bounds(end, radius));
        self.visible(a.with(b))
    }

    /// The columns in which a disc in the fan's plane can be met.
    fn disc_columns(&self, way: Vector, radius: i32) -> Option<Columns> {
        let ahead = way.dot(self.ahead);
        if ahead <= radius {
            // Around the origin, or reaching behind it.
            return (ahead >= -radius).then_some(Columns::ALL);
        }
        self.visible(self.disc_bounds(way, radius))
    }

    /// The columns between the tangents of a disc that is ahead.
    fn disc_bounds(&self, way: Vector, radius: i32) -> Columns {
        let (ahead, aside) = (
            i64::from(way.dot(self.ahead)),
            i64::from(way.dot(self.aside)),
        );
        let radius = i64::from(radius);
        let tangent = square_root((ahead * ahead + aside * aside - radius * radius) as u64);
        let spread = radius * i64::from(tangent);
        let scale = self.columns_for_each(ahead * ahead - radius * radius);
        let middle = ahead * aside;
        Columns {
            first: self.column(middle - spread, scale) - 1,
            last: self.column(middle + spread, scale) + 2,
        }
    }

    fn visible(&self, columns: Columns) -> Option<Columns> {
        (columns.last >= 0 && columns.first < self.width as i32).then_some(columns)
    }

    /// How many half pixels a unit of a numerator over this denominator is.
    fn columns_for_each(&self, denominator: i64) -> Quotient {
        let drop = 33_u32.saturating_sub(denominator.leading_zeros());
        let Quotient { mantissa, exponent } =
            divide((self.distance as u64) << 31, (denominator >> drop) as u32);
        Quotient {
            mantissa,
            exponent: exponent - 31 - drop as i32 + self.scale,
        }
    }

    /// The column of a ray whose tangent has this numerator, rounded down and held near the
    /// picture.
    fn column(&self, numerator: i64, scale: Quotient) -> i32 {
        let size = numerator.unsigned_abs();
        let drop = 32_u32.saturating_sub(size.leading_zeros());
        let product = (size >> drop) * u64::from(scale.mantissa);
        // Further to the side than any picture is wide.
        const BESIDE: u64 = 1 << 20;
        let half_pixels = match scale.exponent + drop as i32 {
            0.. => BESIDE,
            shift @ -63..0 => (product >> -shift).min(BESIDE),
            _ => 0,
        } as i32;
        let half_pixels = if numerator < 0 {
            -half_pixels
        } else {
            half_pixels
        };
        (half_pixels + self.width as i32 - 1) >> 1
    }
}
