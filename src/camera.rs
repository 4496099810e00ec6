//! Floor 2: the camera turns a pixel into the direction of a ray. Knows no scene.

use core::fmt;

use crate::number::{
    Number, Scaled, cotangent_of_half, shifted, signed, signed_wide, sine_and_cosine_of, stepped,
    unsigned_wide, wide,
};
use crate::ray::ScreenAxis;
use crate::vector::{Direction, Point, Position, Vector};

/// What is wrong with a camera.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub enum CameraError {
    /// A coordinate that is not a finite number within ±2³⁰.
    Coordinate,
    /// Position and target are the same point.
    View,
    /// `up` is zero or parallel to the view direction.
    Up,
    /// A field of view that is not between 0.001 and 179.999 degrees.
    FieldOfView,
}

impl CameraError {
    /// One sentence that names the field and the fix.
    pub const fn words(self) -> &'static str {
        match self {
            Self::Coordinate => {
                "camera coordinates must be finite and within -2^30 to 2^30 scene units"
            }
            Self::View => "camera target must differ from its position",
            Self::Up => "camera up must not be zero or parallel to the view direction",
            Self::FieldOfView => "camera fov must be between 0.001 and 179.999 degrees",
        }
    }
}

impl fmt::Display for CameraError {
    fn fmt(&self, formatter: &mut fmt::Formatter<'_>) -> fmt::Result {
        formatter.write_str(self.words())
    }
}

impl core::error::Error for CameraError {}

/// The narrowest and the widest field of view, in degrees. In the narrowest picture of 320 pixels
/// a pixel is 2⁻²⁴ wide and a direction, which is known to 2⁻²⁹, right to a 32nd of it; in the
/// widest the middle is as narrow beside the width of the whole.
const NARROWEST: Number = Number::new(0.001);
const WIDEST: Number = Number::new(179.999);

/// A camera as it was described.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct CameraDescription {
    /// Where it stands.
    pub position: Position,
    /// What it looks at.
    pub target: Position,
    /// What is up in the picture.
    pub up: Position,
    /// The full horizontal field of view in degrees.
    pub fov: Number,
}

/// A pinhole camera: position, target, up and the full horizontal field of view.
///
/// ```
/// use reflet::Camera;
/// const CAMERA: Camera =
///     Camera::look_at([0.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).fov(50.0);
/// ```
///
/// A camera that looks along its `up` does not compile:
///
/// ```compile_fail
/// use reflet::Camera;
/// const CAMERA: Camera = Camera::look_at([0.0; 3], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
/// ```
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Camera {
    description: CameraDescription,
    forward: Direction,
    right: Direction,
    up: Direction,
    /// 1 / tan(fov / 2)
    cotangent: Scaled,
}

impl Camera {
    /// A camera with a field of view of 50 degrees.
    ///
    /// For constants. Panics, which stops the compiler, with the words of a [`CameraError`].
    pub const fn look_at(position: [f64; 3], target: [f64; 3], up: [f64; 3]) -> Self {
        Self::checked(CameraDescription {
            position: Position::new(position),
            target: Position::new(target),
            up: Position::new(up),
            fov: Number::new(50.0),
        })
    }

    /// The same camera with another full horizontal field of view, in degrees.
    ///
    /// For constants. Panics, which stops the compiler, outside 0.001 to 179.999.
    pub const fn fov(self, degrees: f64) -> Self {
        Self::checked(CameraDescription {
            fov: Number::new(degrees),
            ..self.description
        })
    }

    /// A camera from numbers known at run time; no float instruction is executed.
    ///
    /// # Errors
    /// The first field that is wrong.
    pub fn new(
        position: impl Into<Position>,
        target: impl Into<Position>,
        up: impl Into<Position>,
        fov: impl Into<Number>,
    ) -> Result<Self, CameraError> {
        Self::try_from_description(CameraDescription {
            position: position.into(),
            target: target.into(),
            up: up.into(),
            fov: fov.into(),
        })
    }

    /// What the camera was made from.
    pub const fn description(&self) -> CameraDescription {
        self.description
    }

    /// The same camera turned around its target: `azimuth` degrees about `up`, to the right for
    /// positive angles, and `elevation` degrees upwards. The distance is kept to 2⁻²⁷ of it.
    ///
    /// No float instruction is executed.
    ///
    /// # Errors
    /// [`CameraError::Up`] where the camera would look along `up`, and
    /// [`CameraError::Coordinate`] where an angle or the new position is out of range.
    pub fn orbited(
        &self,
        azimuth: impl Into<Number>,
        elevation: impl Into<Number>,
    ) -> Result<Self, CameraError> {
        self.turned(azimuth.into(), elevation.into())
    }

    #[inline(never)]
    fn turned(&self, azimuth: Number, elevation: Number) -> Result<Self, CameraError> {
        if !Position([azimuth, elevation, Number::ZERO]).is_in_range() {
            return Err(CameraError::Coordinate);
        }
        let CameraDescription {
            position,
            target,
            up,
            ..
        } = self.description;
        let offset = position.minus(target).leading().ok_or(CameraError::View)?;
        let axis = up.direction().ok_or(CameraError::Up)?;
        let raised = self
            .forward
            .reversed()
            .turned_towards(self.up, sine_and_cosine_of(elevation));
        let turned = raised.turned_about(axis, sine_and_cosine_of(azimuth));
        Self::aimed(
            CameraDescription {
                position: target.plus(turned, offset),
                ..self.description
            },
            Some(self.cotangent),
        )
    }

    const fn checked(description: CameraDescription) -> Self {
        match Self::try_from_description(description) {
            Ok(camera) => camera,
            Err(error) => panic!("{}", error.words()),
        }
    }

    const fn try_from_description(description: CameraDescription) -> Result<Self, CameraError> {
        let fov = description.fov;
        let is_held = fov.to_bits() >= NARROWEST.to_bits() && fov.to_bits() <= WIDEST.to_bits();
        let cotangent = match is_held {
            true => cotangent_of_half(fov),
            false => None,
        };
        Self::aimed(description, cotangent)
    }

    /// With the cotangent of half the field of view, if it has one.
    #[inline(never)]
    const fn aimed(
        description: CameraDescription,
        cotangent: Option<Scaled>,
    ) -> Result<Self, CameraError> {
        let CameraDescription {
            position,
            target,
            up,
            ..
        } = description;
        if !(position.is_in_range() && target.is_in_range() && up.is_in_range()) {
            return Err(CameraError::Coordinate);
        }
        let Some(forward) = target.minus(position).direction() else {
            return Err(CameraError::View);
        };
        let Some(upward) = up.direction() else {
            return Err(CameraError::Up);
        };
        // Closer to parallel than 2⁻²⁴, rounding alone would say where right is.
        let right = match forward.cross(upward) {
            Some((vector, shift)) if shift >= 8 => vector.precise_direction(),
            _ => return Err(CameraError::Up),
        };
        let Some(up) = right.perpendicular(forward) else {
            return Err(CameraError::Up);
        };
        let Some(cotangent) = cotangent else {
            return Err(CameraError::FieldOfView);
        };
        Ok(Self {
            description,
            forward,
            right,
            up,
            cotangent,
        })
    }

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

fn raw(direction: Direction) -> [i64; 3] {
    direction.components().map(|unit| i64::from(unit.to_bits()))
}

fn times(direction: Direction, factor: i64) -> [i64; 3] {
    raw(direction).map(|coordinate| coordinate * factor)
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

    /// The same, but shorter: below half as long as a direction is. For what depends on signs alone.
    #[inline(always)]
    pub(crate) fn short_of(&self, column: u32) -> Direction {
        Direction::from_raw(self.way(self.aside(column)))
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

#[cfg(test)]
mod sweeps;
