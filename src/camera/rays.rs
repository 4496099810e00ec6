//! Floor 2: the rays of a camera through the pixels of a picture, and the two axes of its screen.

use super::Camera;
use crate::number::{
    Quotient, Unit, divide, narrowed, shifted, signed, signed_wide, square_root, stepped, unsigned,
    unsigned_wide, wide,
};
use crate::ray::{RowPlane, ScreenAxis};
use crate::vector::{Direction, Point, Vector};

impl Camera {
    /// Prepares the camera's rays through the pixels of a picture of `width` by `height` pixels, each 1
    /// to 65535.
    pub(crate) fn generator(&self, width: u32, height: u32) -> RayGenerator {
        // The picture is width · cot(fov / 2) half pixels in front of the camera.
        let product = u64::from(width) * u64::from(self.cotangent.mantissa);
        let Quotient { exponent, .. } = self.cotangent;
        let bits = |value: u64| 64 - signed(value.leading_zeros());
        let largest = (bits(product) + exponent).max(bits(u64::from(width.max(height))));
        // The largest component is scaled to 2³⁰, so that the vector of a ray stays below 2⁶¹ in Q30.
        let scale = 30 - largest;
        let ahead = shifted(signed_wide(product), (exponent + scale).max(-63));
        RayGenerator {
            ahead: raw(self.forward).map(|coordinate| coordinate * ahead),
            right: self.right,
            up: raw(self.up).map(|coordinate| shifted(coordinate, scale)),
            scale,
            width,
            height,
        }
    }

    /// Prepares the camera's rays through the corners of the pixels of a picture of `width` by `height` pixels, each 1 to
    /// 65534. There is a column and a row of corners more than of pixels.
    pub(crate) fn corners(&self, width: u32, height: u32) -> RayGenerator {
        let pixels = self.generator(width, height);
        RayGenerator {
            width: width + 1,
            height: height + 1,
            ..pixels
        }
    }

    /// Returns two screen axes for rays from `origin`: one through the centres of the picture's columns,
    /// one through those of its rows.
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

/// Camera, prepared for one size of picture. Its vectors are in half pixels, scaled by 2^`scale`;
/// `right` is a unit vector.
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
    /// Prepares the directions through the centres of the pixels of row `y`, which must lie in the
    /// picture.
    pub(crate) fn row(&self, y: u32) -> RowDirections {
        debug_assert!(y < self.height && self.height < 1 << 16);
        self.directions(self.middle(y, 0))
    }

    /// Prepares the directions through points at a distance below the centres of row `y`, in 64ths of a pixel.
    #[inline(never)]
    pub(crate) fn row_below(&self, y: u32, down: i32) -> RowDirections {
        self.directions(self.middle(y, down))
    }

    /// Returns the plane of the rays through points below the centres of row `y`, as [`RayGenerator::row_below`] does.
    #[inline(never)]
    pub(crate) fn row_plane_below(&self, (y, down): (u32, i32), origin: Point) -> RowPlane {
        self.plane(self.middle(y, down), origin)
    }

    /// Returns the direction of the ray through a point to the right of the centre of a pixel, and below it, in 64ths of a
    /// pixel.
    pub(crate) fn through(&self, [column, y]: [u32; 2], [right, down]: [i32; 2]) -> Direction {
        // Distances from the middle of the picture, in 64ths of a pixel.
        let [across, up] = [
            32 * (1 - signed(self.width) + 2 * signed(column)) + right,
            32 * (signed(self.height) - 1 - 2 * signed(y)) - down,
        ];
        let aside = ((self.side() >> 5) * i64::from(across)) >> 32;
        let at = |axis: usize, right: i32| {
            let middle = self.ahead[axis] + (self.up[axis] >> 5) * i64::from(up);
            ((middle + wide(right, aside as i32)) >> 32) as i32
        };
        let Vector { x, y, z } = self.right.raw();
        let way = Vector::new(at(0, x), at(1, y), at(2, z));
        way.direction_of_square(way.square())
    }

    /// Returns the direction of the camera's view, and the sides of its pixels.
    pub(crate) fn pixel(&self) -> PixelSides {
        let [x, y, z] = self.ahead.map(|coordinate| (coordinate >> 32) as i32);
        let (ahead, distance) = Vector::new(x, y, z).direction_and_length();
        let [x, y, z] = self
            .up
            .map(|coordinate| narrowed(shifted(-coordinate, -self.scale)));
        // A pixel is 2^(scale - 1) wide in the unit of the distance, which is at least 1.
        let width = divide(1 << 31, unsigned(distance.to_bits()));
        let width = shifted(
            width.mantissa.into(),
            (width.exponent + self.scale - 2).max(-63),
        );
        PixelSides {
            ahead,
            sides: [self.right, Direction::from_raw(Vector::new(x, y, z))],
            width: Unit::from_bits(narrowed(width.min(1 << 30))),
        }
    }

    /// Returns four times the length of half a pixel, with 32 more fraction bits.
    fn side(&self) -> i64 {
        shifted(1 << 32, self.scale)
    }

    /// Prepares the directions of a row from the vector to its middle.
    #[inline(always)]
    fn directions(&self, middle: [i64; 3]) -> RowDirections {
        let horizontal = 1 - i64::from(self.width);
        let [x, y, z] = middle.map(|coordinate| (coordinate >> 32) as i32);
        let side = self.side();
        RowDirections {
            middle,
            right: self.right,
            square: Vector::new(x, y, z).square(),
            aside: side * horizontal,
            step_aside: 2 * side,
        }
    }

    /// Returns the plane of row `y`, for rays from `origin`.
    pub(crate) fn row_plane(&self, y: u32, origin: Point) -> RowPlane {
        self.plane(self.middle(y, 0), origin)
    }

    /// Returns the plane of a row from the vector to its middle.
    #[inline(always)]
    fn plane(&self, middle: [i64; 3], origin: Point) -> RowPlane {
        // In a wide view the middle of a row is near. Its largest coordinate is scaled to 2⁶⁰.
        let bits = middle.map(|it| it.unsigned_abs().leading_zeros());
        let up = signed(bits[0].min(bits[1]).min(bits[2]).saturating_sub(4));
        let [x, y, z] = middle.map(|coordinate| (shifted(coordinate, up) >> 32) as i32);
        let (ahead, distance) = Vector::new(x, y, z).direction_and_length();
        RowPlane {
            axis: ScreenAxis {
                origin,
                ahead,
                aside: self.right,
                distance: distance.to_bits(),
                scale: 2 - self.scale - up,
                width: self.width,
            },
            normal: self.right.crossed(ahead),
            // The vector to the row's middle is at least 2^(27 - `up`) long. Rounding moves a vector to a pixel
            // off the plane by less than 2.
            places: unsigned((26 - up).max(0)),
        }
    }

    /// Returns the vector to the middle of a line at a distance below the centres of row `y`, in 64ths of a
    /// pixel, scaled as [`RowDirections`] says.
    #[inline(always)]
    fn middle(&self, y: u32, down: i32) -> [i64; 3] {
        // In half pixels, each 32 64ths of a pixel.
        let up_from_middle = i64::from(self.height) - 1 - 2 * i64::from(y);
        [0, 1, 2].map(|axis| {
            let middle = self.ahead[axis] + self.up[axis] * up_from_middle;
            middle - (self.up[axis] >> 5) * i64::from(down)
        })
    }
}

/// The sides of a picture's pixels.
#[derive(Clone, Copy)]
pub(crate) struct PixelSides {
    /// The camera's view, at right angles to the picture.
    pub(crate) ahead: Direction,
    /// Directions to the next pixel to the right, and to the next one below.
    pub(crate) sides: [Direction; 2],
    /// Length of a side, where the picture is at distance 1; at most 1.
    pub(crate) width: Unit,
}

/// Directions of the rays through one row of pixels.
///
/// The vector to the middle of the row and the vector from there to a pixel are perpendicular. So the
/// squared length of a ray's vector is the sum of their squares, and only the second one changes along
/// the row.
pub(crate) struct RowDirections {
    /// Vector from the camera to the middle of the row, with 32 more fraction bits.
    middle: [i64; 3],
    /// Direction from one column to the next.
    right: Direction,
    /// Squared length of the vector to the middle of the row.
    square: u64,
    /// Four times the signed distance from the middle of the row to the first pixel along `right`, with
    /// 32 more fraction bits.
    aside: i64,
    /// Four times the distance from one pixel to the next, with 32 more fraction bits.
    step_aside: i64,
}

impl RowDirections {
    /// Returns a normal of the plane of the row's rays, rounded to whole numbers below 2²⁹, and a bound of its
    /// length.
    pub(crate) fn plane(&self) -> (Vector, i32) {
        let [x, y, z] = self.middle.map(|coordinate| (coordinate >> 32) as i32);
        let normal = self.right.crossed_with(Vector::new(x, y, z));
        (normal, square_root(self.square) + 4)
    }

    /// Returns the direction of the ray through the pixel of a column, which is below 2¹⁶.
    #[inline(always)]
    pub(crate) fn of(&self, column: u32) -> Direction {
        // Four times the signed distance of the pixel from the middle of the row.
        let aside = (stepped(self.aside, self.step_aside, column) >> 32) as i32;
        let square = self.square + unsigned_wide(wide(aside >> 2, aside >> 2));
        // The vector to a pixel is below 2⁶¹ (`Camera::generator`), and that to the column after the picture, where smooth
        // edges have corners, below 2⁶². So the sum does not wrap.
        let ([x, y, z], right) = (self.middle, self.right.raw());
        let at = |middle: i64, right: i32| ((middle + wide(right, aside)) >> 32) as i32;
        let way = Vector::new(at(x, right.x), at(y, right.y), at(z, right.z));
        way.direction_of_square(square)
    }
}

/// Returns the coordinates of a direction as raw Q2.30 bits.
fn raw(direction: Direction) -> [i64; 3] {
    direction.components().map(|unit| i64::from(unit.to_bits()))
}
