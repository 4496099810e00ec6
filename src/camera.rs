//! Floor 2: the camera as it is described, checked, and turned around its target; its [`rays`] turn a
//! pixel into a direction. Knows no scene.

mod rays;

pub(crate) use rays::{RayGenerator, RowDirections};

use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::number::{Number, Scaled, cotangent_of_half, sine_and_cosine_of};
use crate::vector::{Direction, Position};

/// The narrowest and the widest field of view, in degrees. In the narrowest picture of 320 pixels
/// a pixel is 2⁻²⁴ wide and a direction, which is known to 2⁻²⁹, right to a 32nd of it; in the
/// widest the middle is as narrow beside the width of the whole.
const NARROWEST: Number = Number::new(0.001);
const WIDEST: Number = Number::new(179.999);

/// A camera as it was described.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
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
    /// For constants. Panics, which stops the compiler, with the message of an [`Error`].
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
    ) -> Result<Self, Error> {
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
    /// [`ErrorKind::Up`] where the camera would look along `up`, and
    /// [`ErrorKind::Coordinate`] where an angle or the new position is out of range.
    pub fn orbited(
        &self,
        azimuth: impl Into<Number>,
        elevation: impl Into<Number>,
    ) -> Result<Self, Error> {
        self.turned(azimuth.into(), elevation.into())
    }

    #[inline(never)]
    fn turned(&self, azimuth: Number, elevation: Number) -> Result<Self, Error> {
        if !Position([azimuth, elevation, Number::ZERO]).is_in_range() {
            return Err(Error::of("camera", ErrorKind::Coordinate));
        }
        let CameraDescription {
            position,
            target,
            up,
            ..
        } = self.description;
        let offset = position
            .minus(target)
            .leading()
            .ok_or(Error::of("camera", ErrorKind::View))?;
        let axis = up.direction().ok_or(Error::of("camera", ErrorKind::Up))?;
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
            Err(error) => error.stop(),
        }
    }

    const fn try_from_description(description: CameraDescription) -> Result<Self, Error> {
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
    ) -> Result<Self, Error> {
        let CameraDescription {
            position,
            target,
            up,
            ..
        } = description;
        if !(position.is_in_range() && target.is_in_range() && up.is_in_range()) {
            return Err(Error::of("camera", ErrorKind::Coordinate));
        }
        let Some(forward) = target.minus(position).direction() else {
            return Err(Error::of("camera", ErrorKind::View));
        };
        let Some(upward) = up.direction() else {
            return Err(Error::of("camera", ErrorKind::Up));
        };
        // Closer to parallel than 2⁻²⁴, rounding alone would say where right is.
        let right = match forward.cross(upward) {
            Some((vector, shift)) if shift >= 8 => vector.precise_direction(),
            _ => return Err(Error::of("camera", ErrorKind::Up)),
        };
        let Some(up) = right.perpendicular(forward) else {
            return Err(Error::of("camera", ErrorKind::Up));
        };
        let Some(cotangent) = cotangent else {
            return Err(Error::of("camera", ErrorKind::FieldOfView));
        };
        Ok(Self {
            description,
            forward,
            right,
            up,
            cotangent,
        })
    }
}

#[cfg(test)]
mod sweeps;
