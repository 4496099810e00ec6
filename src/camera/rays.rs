//! Floor 2: the rays of a camera through the pixels of a picture, and the axes of its screen.

use super::Camera;
use crate::number::{Scaled, shifted, signed, signed_wide, stepped, unsigned_wide, wide};
use crate::ray::ScreenAxis;
use crate::vector::{Direction, Point, Vector};

impl Camera {
    /// The camera's rays through the pixels of a picture of `width` by `height` (1 to 65535).
    pub(crate) fn generator(&self, width: u32, height: u32) -> RayGenerator {
        // In half pixels, the picture lies width · cot(fov / 2) in front of the camera.
        let product = u64::from(width) * u64::from(self.cotangent.mantissa);
        let Scaled { exponent, .. } = self.cotangent;
        let bits = |value: u64| 64 - signed(value.leading_zeros());
        let largest = (bits(product) + exponent).max(bits(u64::from(width.max(height))));
        // The largest part is brought to 2³⁰, so that a ray stays below 2⁶¹ in Q30.
        let scale = 30 - largest;
        let ahead = shifted(signed_wide(product), (exponent + scale).max(-63));
        RayGenerator {
            ahead: times(self.forward, ahead),
            right: self.right,
            up: [0, 1, 2].map(|axis| shifted(raw(self.up)[axis], scale)),
            scale,
            width,
            height,
        }
    }

    /// The camera's rays from `origin` through the middles of a picture's columns, and of its rows.
    pub(crate) fn screen_axes(&self, generator: &RayGenerator, origin: Point) -> [ScreenAxis; 2] {
        let [x, y, z] = generator.ahead.map(|coordinate| (coordinate >> 32) as i32);
        let (ahead, distance) = Vector::new(x, y, z).direction_and_length();
        let asides = [
            (self.right, generator.width),
            (self.up.reversed(), generator.height),
        ];
        asides.map(|(aside, width)| ScreenAxis {
            origin,
            ahead,
            aside,
            distance: distance.to_bits(),
            scale: 2 - generator.scale,
            width,
        })
    }
}

/// A camera made ready for one size of picture: vectors in half pixels, scaled by a power of two, but
/// for the one to the right.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RayGenerator {
    ahead: [i64; 3],
    right: Direction,
    up: [i64; 3],
    scale: i32,
    width: u32,
    height: u32,
}

impl RayGenerator {
    /// The directions through the middles of the pixels of row `y`, which lies in the picture.
    pub(crate) fn row(&self, y: u32) -> RowDirections {
        debug_assert!(y < self.height && self.height < 1 << 16);
        let vertical = i64::from(self.height) - 1 - 2 * i64::from(y);
        let horizontal = 1 - i64::from(self.width);
        let middle = [0, 1, 2].map(|axis| self.ahead[axis] + self.up[axis] * vertical);
        let [x, y, z] = middle.map(|coordinate| (coordinate >> 32) as i32);
        let side = shifted(1 << 32, self.scale);
        RowDirections {
            middle,
            right: self.right,
            square: Vector::new(x, y, z).square(),
            aside: side * horizontal,
            step_aside: 2 * side,
        }
    }
}

/// The directions of a row of pixels.
///
/// What lies ahead and what lies aside are perpendicular, so their squares add up to that of the
/// ray's length, and only the one aside changes along the row.
pub(crate) struct RowDirections {
    /// The way to the middle of the row, with 32 more fraction bits.
    middle: [i64; 3],
    /// Where the columns go.
    right: Direction,
    /// The square of the way to the middle of the row.
    square: u64,
    /// How far four times the way from there to the first pixel goes, with 32 more fraction bits.
    aside: i64,
    step_aside: i64,
}

impl RowDirections {
    /// The direction through the pixel of a column, which is below 2¹⁶.
    #[inline(always)]
    pub(crate) fn of(&self, column: u32) -> Direction {
        // A ray to a pixel is below 2⁶¹ (`Camera::generator`), one to a column beyond the picture, half
        // as wide as that at most, below 2⁶²: the sum does not wrap.
        let aside = self.aside(column);
        let square = self.square + unsigned_wide(wide(aside >> 2, aside >> 2));
        self.way(aside).direction_of_square(square)
    }

    /// The way to a pixel that lies so far aside, below 2²⁹.
    #[inline(always)]
    fn way(&self, aside: i32) -> Vector {
        let [x, y, z] = self.middle;
        let Vector {
            x: dx,
            y: dy,
            z: dz,
        } = self.right.raw();
        let at = |middle: i64, right: i32| ((middle + wide(right, aside)) >> 32) as i32;
        Vector::new(at(x, dx), at(y, dy), at(z, dz))
    }

    /// Four times the way from the middle of the row to the pixel of a column.
    #[inline(always)]
    fn aside(&self, column: u32) -> i32 {
        at(self.aside, self.step_aside, column)
    }
}

/// What is reached from `start` after so many steps, without the last 32 bits.
#[inline(always)]
fn at(start: i64, step: i64, column: u32) -> i32 {
    (stepped(start, step, column) >> 32) as i32
}

fn raw(direction: Direction) -> [i64; 3] {
    direction.components().map(|unit| i64::from(unit.to_bits()))
}

fn times(direction: Direction, factor: i64) -> [i64; 3] {
    raw(direction).map(|coordinate| coordinate * factor)
}
