//! Which pixels a sphere or cylinder can be seen in: rectangles, worked out once a frame.
//!
//! Seen along the columns of pixels a sphere is a circle, and the tangents from the camera to it
//! bound the columns in which it can be seen; seen along the rows likewise. A cylinder lies between
//! the spheres around its ends. What a mirroring plane shows first are the shapes mirrored in it, as
//! the camera sees them. Bounds are widened by more than rounding can be wrong.

use super::{World, used};
use crate::number::{
    Quotient, Unit, difference_modulo_2_16, divide, narrowed_unsigned, ratio, scaled_by_unit,
    signed, square_root, to_u16, to_u32, unsigned, unsigned_wide, wide,
};
use crate::quality::LONGEST_STRIDE;
use crate::ray::ScreenAxis;
use crate::shape::plane::PreparedPlane;
use crate::vector::{Point, Vector};

/// A rectangle of pixels in which a shape can be seen, the last row and column included.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Extent {
    pub(super) left: u16,
    pub(super) right: u16,
    /// The first and the last row, less [`BESIDE`].
    top: u16,
    bottom: u16,
    /// The columns of what is highest and of what is lowest.
    tips: [u16; 2],
    /// Which of its kind it is, and [`THIN_SHAPE`].
    shape: u16,
}

/// How many rows lie between the first in which a shape is looked for and the first in which its tip
/// may be seen, and as many at the other end.
const BESIDE: u16 = 2;

/// In how many rows from there on a round shape may be thin; in further ones it is wider than
/// [`LONGEST_STRIDE`] or thin all over.
const TIP_ROWS: u16 = 2;

/// Marks a shape that is so thin that it may lie between two pixels that are traced in a row.
const THIN_SHAPE: u16 = 1 << 15;

impl Extent {
    const ALL: Self = Self {
        left: 0,
        right: u16::MAX,
        top: 0,
        bottom: u16::MAX,
        tips: [0; 2],
        shape: 0,
    };

    /// Of the shape with a number, where it is not seen.
    fn of_nothing(shape: usize) -> Self {
        Self {
            left: u16::MAX,
            right: 0,
            shape: to_u16(to_u32(shape)) % THIN_SHAPE,
            ..Self::ALL
        }
    }

    /// Of the shape with a number; the columns of its tips matter only where a ray passes it.
    fn new(shape: usize, columns: Columns, rows: Columns, tips: Option<[i32; 2]>) -> Self {
        let held = |column: i32| to_u16(unsigned(column.clamp(0, 0xffff)));
        let shape = to_u16(to_u32(shape)) % THIN_SHAPE;
        let [highest, lowest] = tips.unwrap_or_default();
        let tips = match rows.first + i32::from(BESIDE) < 0 {
            // The highest point lies above the picture, not in the row that stands for it.
            true => [lowest; 2],
            false => [highest, lowest],
        };
        // At most one less than beyond all columns.
        let tip = |column: i32| to_u16(unsigned(column.clamp(0, 0xfffe)));
        Self {
            left: held(columns.first),
            right: held(columns.last),
            top: held(rows.first.saturating_add(BESIDE.into())),
            bottom: held(rows.last.saturating_sub(BESIDE.into())),
            tips: tips.map(tip),
            shape: match columns.is_thin {
                true => shape | THIN_SHAPE,
                false => shape,
            },
        }
    }

    /// Which of its kind the shape is.
    #[inline(always)]
    pub(super) fn shape(&self) -> usize {
        usize::from(self.shape % THIN_SHAPE)
    }

    /// The column in the middle of a shape that is thin, or of which only the tip may be seen in
    /// row `y`; beyond all columns for any other.
    #[inline(always)]
    pub(super) fn middle(&self, y: u16) -> u16 {
        let [highest, lowest] = self.tips;
        // A row above the first one, or below the last, wraps to one that is far away.
        if difference_modulo_2_16(y, self.top) < TIP_ROWS {
            highest
        } else if difference_modulo_2_16(self.bottom, y) < TIP_ROWS {
            lowest
        } else if self.shape & THIN_SHAPE != 0 {
            highest.midpoint(lowest)
        } else {
            u16::MAX
        }
    }

    /// Whether the shape can be seen in a row of pixels.
    #[inline(always)]
    pub(super) fn has_row(&self, y: u16) -> bool {
        let (y, beside) = (u32::from(y), u32::from(BESIDE));
        u32::from(self.top) <= y + beside && y <= u32::from(self.bottom) + beside
    }
}

/// What the shapes of a scene cover, in rising order of their left columns.
#[derive(Clone, Copy, Debug)]
pub struct Covered<'a> {
    pub(super) spheres: &'a [Extent],
    pub(super) cylinders: &'a [Extent],
}

impl Covered<'_> {
    /// Without what stands for no shape.
    pub(super) fn of<W: World>(self, world: &W) -> Self {
        let parts = world.parts();
        Self {
            spheres: used(self.spheres, parts.spheres.len()),
            cylinders: used(self.cylinders, parts.cylinders.len()),
        }
    }
}

/// What the shapes of a scene cover, themselves and mirrored in each plane.
#[derive(Clone, Copy, Debug)]
pub struct Outlook<const S: usize, const P: usize, const C: usize> {
    spheres: [Extent; S],
    cylinders: [Extent; C],
    mirrored: [([Extent; S], [Extent; C]); P],
}

/// An [`Outlook`], whatever its room.
pub trait Outlooks: Copy {
    /// Everything everywhere.
    const ALL: Self;

    /// Turns from everything to a scene as the rays through the columns and those through the rows of
    /// a picture see it; mirrored only where a plane mirrors.
    #[allow(private_interfaces)]
    fn look<W: World>(&mut self, world: &W, screen_axes: &[ScreenAxis; 2]);

    /// What the shapes themselves cover.
    fn first(&self) -> Covered<'_>;

    /// What the shapes mirrored in a plane cover.
    fn mirrored(&self, plane: usize) -> Option<Covered<'_>>;
}

impl<const S: usize, const P: usize, const C: usize> Outlooks for Outlook<S, P, C> {
    const ALL: Self = Self {
        spheres: [Extent::ALL; S],
        cylinders: [Extent::ALL; C],
        mirrored: [([Extent::ALL; S], [Extent::ALL; C]); P],
    };

    #[allow(private_interfaces)]
    fn look<W: World>(&mut self, world: &W, screen_axes: &[ScreenAxis; 2]) {
        const {
            assert!(
                S <= THIN_SHAPE as usize && C <= THIN_SHAPE as usize,
                "a scene has room for at most 32768 spheres and 32768 cylinders"
            );
        }
        let parts = world.parts();
        look(
            world,
            screen_axes,
            None,
            (&mut self.spheres, &mut self.cylinders),
        );
        for (plane, mirrored) in parts.planes.iter().zip(&mut self.mirrored) {
            if parts.material(plane.material).mirrors() {
                look(
                    world,
                    screen_axes,
                    Some(plane),
                    (&mut mirrored.0, &mut mirrored.1),
                );
            }
        }
    }

    fn first(&self) -> Covered<'_> {
        Covered {
            spheres: &self.spheres,
            cylinders: &self.cylinders,
        }
    }

    fn mirrored(&self, plane: usize) -> Option<Covered<'_>> {
        let (spheres, cylinders) = self.mirrored.get(plane)?;
        Some(Covered { spheres, cylinders })
    }
}

/// Finds out what the shapes cover, mirrored in a plane if there is one.
#[inline(never)]
fn look<W: World>(
    world: &W,
    screen_axes: &[ScreenAxis; 2],
    plane: Option<&PreparedPlane>,
    (spheres, cylinders): (&mut [Extent], &mut [Extent]),
) {
    let parts = world.parts();
    let origin = screen_axes[0].origin;
    // Rays leave epsilon above a plane: as good as shapes that much larger.
    let lift = plane.map_or(0, |_| 2 * parts.epsilon.to_bits());
    for (index, sphere) in parts.spheres.iter().enumerate() {
        let (center, radius) = sphere.ball();
        let extent = match seen(plane, origin, center, Vector::ZERO) {
            Some((way, _)) => sphere_extent(index, screen_axes, way, (radius, lift)),
            None => Extent::new(index, Columns::ALL, Columns::ALL, None),
        };
        insert(spheres, index, extent);
    }
    for (index, cylinder) in parts.cylinders.iter().enumerate() {
        let (center, half_axis, radius) = cylinder.capsule();
        let extent = match seen(plane, origin, center, half_axis) {
            Some((way, half)) => {
                let [columns, rows] = [0, 1].map(|it| {
                    let screen_axis: &ScreenAxis = &screen_axes[it];
                    screen_axis.capsule_columns(way, half, widened(radius) + lift)
                });
                match (columns, rows) {
                    (Some(columns), Some(rows)) => {
                        Extent::new(index, columns.with_neighbours(), rows, None)
                    }
                    _ => Extent::of_nothing(index),
                }
            }
            None => Extent::new(index, Columns::ALL, Columns::ALL, None),
        };
        insert(cylinders, index, extent);
    }
}

/// What a sphere covers, `lift` larger than it is.
fn sphere_extent(
    index: usize,
    screen_axes: &[ScreenAxis; 2],
    way: Vector,
    (radius, lift): (i32, i32),
) -> Extent {
    let [columns, rows] = [0, 1].map(|it| {
        let screen_axis: &ScreenAxis = &screen_axes[it];
        screen_axis.sphere_columns(way, widened(radius) + lift)
    });
    let (Some(mut columns), Some(rows)) = (columns, rows) else {
        return Extent::of_nothing(index);
    };
    // If it is half a pixel and more, its bounds do not say where the tips are.
    let height = i64::from(rows.last) - i64::from(rows.first);
    columns.is_thin |= i64::from(lift) * height >= i64::from(radius);
    Extent::new(
        index,
        columns,
        rows,
        screen_axes[0].tips(&screen_axes[1], way, radius),
    )
}

/// Puts an extent behind the first `count`, which are in rising order of their left columns, and
/// then where it belongs among them.
fn insert(extents: &mut [Extent], count: usize, extent: Extent) {
    let mut rest = extents.get_mut(..=count).unwrap_or_default();
    while let [sorted @ .., place] = rest {
        match sorted.last() {
            Some(before) if before.left > extent.left => *place = *before,
            _ => {
                *place = extent;
                break;
            }
        }
        rest = sorted;
    }
}

/// The way to a shape's middle and its half axis, mirrored in a plane if there is one; `None` where
/// that is too far away to be told.
fn seen(
    plane: Option<&PreparedPlane>,
    origin: Point,
    center: Point,
    half_axis: Vector,
) -> Option<(Vector, Vector)> {
    let way = origin.to(center);
    let Some(plane) = plane else {
        return Some((way, half_axis));
    };
    let height = i32::try_from(plane.height(center) >> 30).ok()?;
    if height.unsigned_abs() > 1 << 28 {
        return None;
    }
    let along = half_axis.dot(plane.normal);
    Some((
        way.without(plane.normal, 2 * height),
        half_axis.without(plane.normal, 2 * along),
    ))
}

/// The columns, first and last, in which a shape can be met.
#[derive(Clone, Copy, Debug)]
struct Columns {
    first: i32,
    last: i32,
    /// Whether something may be so thin that it lies between two pixels that are traced.
    is_thin: bool,
}

/// What is bound to so few columns, or rather some less for the bounds are wide, is thin.
const THIN: i32 = signed(LONGEST_STRIDE) + 4;

impl Columns {
    const ALL: Self = Self {
        first: 0,
        last: i32::MAX,
        is_thin: true,
    };

    /// With the pixels beside something thin that are traced for sure, so that it is known on which
    /// side of it their rays pass.
    fn with_neighbours(self) -> Self {
        match self.is_thin {
            true => Self {
                first: self.first.saturating_sub(signed(LONGEST_STRIDE)),
                last: self.last.saturating_add(signed(LONGEST_STRIDE)),
                ..self
            },
            false => self,
        }
    }

    fn with(self, other: Self) -> Self {
        Self {
            first: self.first.min(other.first),
            last: self.last.max(other.last),
            is_thin: self.is_thin || other.is_thin,
        }
    }
}

/// A radius widened by what rounding can be wrong.
fn widened(radius: i32) -> i32 {
    radius + (radius >> 10) + 64
}

impl ScreenAxis {
    /// The columns in which a cylinder with rounded ends can be met.
    fn capsule_columns(&self, way: Vector, half_axis: Vector, radius: i32) -> Option<Columns> {
        let ends = [way.plus(half_axis), way.minus(half_axis)];
        // An end behind the picture has no columns, but what lies between may be seen.
        if ends.iter().any(|end| end.dot(self.ahead) <= radius) {
            return Some(Columns::ALL);
        }
        let [a, b] = ends.map(|end| self.sphere_bounds(end, radius));
        self.visible(a.with(b))
    }

    /// The columns in which a sphere can be met.
    fn sphere_columns(&self, way: Vector, radius: i32) -> Option<Columns> {
        let ahead = way.dot(self.ahead);
        if ahead <= radius {
            // Around the origin, or reaching behind it.
            return (ahead >= -radius).then_some(Columns::ALL);
        }
        self.visible(self.sphere_bounds(way, radius))
    }

    /// The columns between the tangents to a sphere that is ahead, as seen along the columns.
    fn sphere_bounds(&self, way: Vector, radius: i32) -> Columns {
        let (ahead, aside) = (
            i64::from(way.dot(self.ahead)),
            i64::from(way.dot(self.aside)),
        );
        let radius = i64::from(radius);
        let tangent = square_root(unsigned_wide(
            ahead * ahead + aside * aside - radius * radius,
        ));
        let spread = radius * i64::from(tangent);
        let scale = self.columns_for_each(ahead * ahead - radius * radius);
        let middle = ahead * aside;
        let first = self.column(middle - spread, scale) - 1;
        let last = self.column(middle + spread, scale) + 2;
        Columns {
            first,
            last,
            is_thin: last - first <= THIN,
        }
    }

    /// The columns in which the highest and the lowest point of a sphere that is ahead are seen,
    /// rounded down; `rows` is the screen_axis along the rows.
    ///
    /// Those points are where the planes of the rows that touch the sphere touch it, so they are as
    /// far aside as its middle, and t (a t ± b r) / (a² + b²) ahead, where it is a ahead and b down,
    /// and t long are the tangents to the circle that it is seen as along the rows.
    fn tips(&self, rows: &ScreenAxis, way: Vector, radius: i32) -> Option<[i32; 2]> {
        let ahead = way.dot(self.ahead);
        if ahead <= radius {
            return None;
        }
        let (aside, down) = (i64::from(way.dot(self.aside)), way.dot(rows.aside));
        let square = wide(ahead, ahead) + wide(down, down);
        let tangent = square_root(unsigned_wide(square - wide(radius, radius)));
        let (along, across) = (wide(ahead, tangent), wide(down, radius));
        // The square to 30 bits.
        let drop = 34_u32.saturating_sub(square.leading_zeros());
        let square = narrowed_unsigned(unsigned_wide(square >> drop));
        Some([along + across, along - across].map(|touched| {
            let share = ratio(
                narrowed_unsigned(unsigned_wide(touched >> drop)).min(square - 1),
                square,
            );
            let ahead = scaled_by_unit(tangent, Unit::from_bits(share)).max(1);
            self.column(aside, self.columns_for_each(ahead.into()))
        }))
    }

    /// Columns that can be seen, or that are traced beside the picture.
    fn visible(&self, columns: Columns) -> Option<Columns> {
        let end = signed(self.width + LONGEST_STRIDE);
        (columns.last >= 0 && columns.first < end).then_some(columns)
    }

    /// How many half pixels a unit of a numerator over this denominator is.
    fn columns_for_each(&self, denominator: i64) -> Quotient {
        let drop = 33_u32.saturating_sub(denominator.leading_zeros());
        let Quotient { mantissa, exponent } = divide(
            unsigned_wide(self.distance.into()) << 31,
            narrowed_unsigned(unsigned_wide(denominator >> drop)),
        );
        Quotient {
            mantissa,
            exponent: exponent - 31 - signed(drop) + self.scale,
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
        let half_pixels = signed(narrowed_unsigned(match scale.exponent + signed(drop) {
            0.. => BESIDE,
            shift @ -63..0 => (product >> -shift).min(BESIDE),
            _ => 0,
        }));
        let half_pixels = if numerator < 0 {
            !half_pixels
        } else {
            half_pixels
        };
        (half_pixels + signed(self.width) - 1) >> 1
    }
}

#[cfg(test)]
mod tests;
