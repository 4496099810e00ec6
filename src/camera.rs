//! Floor 2: the camera: its description, its checks, and orbits around its target. The module [`rays`]
//! computes the direction of a pixel's ray. This floor knows no scene.

mod rays;

pub(crate) use rays::{PixelSides, RayGenerator, RowDirections};

use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::number::{Number, Quotient, Unit, cotangent_of_half, sine_and_cosine_of};
use crate::vector::{Direction, Position};

/// Narrowest field of view, in degrees. In a picture of 320 columns a pixel is then 2⁻²⁴ wide. A
/// direction is known to 2⁻²⁹, which is a 32nd of that pixel.
const NARROWEST: Number = Number::new(0.001);

/// Widest field of view, in degrees. The middle of such a picture is as narrow, compared with the width
/// of the whole, as a picture of the narrowest field of view.
const WIDEST: Number = Number::new(179.999);

/// The description of a camera: the numbers that it was created from.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
#[non_exhaustive]
pub struct CameraDescription {
    /// Position of the camera, in scene units; each coordinate within ±2³⁰.
    pub position: Position,
    /// Point in the middle of the picture, in scene units; differs from the position.
    pub target: Position,
    /// Direction that points up in the picture; of any length but zero, and not parallel to the view.
    pub up: Position,
    /// Full horizontal field of view in degrees, 0.001 to 179.999.
    pub fov: Number,
}

/// A pinhole camera: position, target, up direction and full horizontal field of view.
///
/// ```
/// use reflet::Camera;
/// const CAMERA: Camera =
///     Camera::look_at([0.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]).fov(50.0);
/// ```
///
/// While a program runs, cameras are created from numbers and turned around their targets:
///
/// ```
/// use reflet::description::CameraDescription;
/// use reflet::{Camera, ErrorKind, Number, Position};
///
/// let camera = Camera::new([0, -5, 0], [0, 0, 0], [0, 0, 1], 40)?;
/// let CameraDescription { position, target, fov, .. } = camera.orbited(90, 0)?.description();
/// let [x, y, _] = position.0.map(Number::to_f64);
/// assert!((x - 5.0).abs() < 1e-6 && y.abs() < 1e-6);
/// assert_eq!((target, fov), (Position::ORIGIN, Number::from(40)));
///
/// let wide = Camera::new([0, -5, 0], [0, 0, 0], [0, 0, 1], 180);
/// assert_eq!(wide.unwrap_err().kind(), ErrorKind::FieldOfView);
/// # Ok::<(), reflet::Error>(())
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
    /// Cotangent of half the field of view: 1 / tan(fov / 2).
    cotangent: Quotient,
}

impl Camera {
    /// Creates a camera with a field of view of 50 degrees, for constants. [`Camera::fov`] changes it.
    ///
    /// Positions are in scene units, each coordinate within ±2³⁰.
    ///
    /// # Panics
    /// Panics with the text of an [`Error`] where [`Camera::new`] returns one. In a constant, this stops
    /// the compiler.
    #[track_caller]
    pub const fn look_at(position: [f64; 3], target: [f64; 3], up: [f64; 3]) -> Self {
        Self::checked(CameraDescription {
            position: Position::new(position),
            target: Position::new(target),
            up: Position::new(up),
            fov: Number::new(50.0),
        })
    }

    /// Sets the full horizontal field of view, in degrees; for constants.
    ///
    /// # Panics
    /// Panics outside 0.001 to 179.999. In a constant, this stops the compiler.
    #[track_caller]
    pub const fn fov(self, degrees: f64) -> Self {
        Self::checked(CameraDescription {
            fov: Number::new(degrees),
            ..self.description
        })
    }

    /// Creates a camera from numbers known at run time. `fov` is the full horizontal field of view, in
    /// degrees.
    ///
    /// No float instruction is executed, whatever type the numbers have.
    ///
    /// # Errors
    /// [`ErrorKind::Coordinate`] if a coordinate is not within ±2³⁰, [`ErrorKind::View`] if position and
    /// target are equal, [`ErrorKind::Up`] if `up` is zero or within 2⁻²⁴ of parallel to the view
    /// direction, and [`ErrorKind::FieldOfView`] outside 0.001 to 179.999 degrees; the first of these
    /// that applies.
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

    /// Returns the numbers that the camera was created from.
    pub const fn description(&self) -> CameraDescription {
        self.description
    }

    /// Returns the camera after an orbit around its target: `azimuth` degrees about `up`, to the right
    /// if positive, and `elevation` degrees upwards.
    ///
    /// The distance to the target is kept, up to rounding by 2⁻²⁷ of the distance. No float
    /// instruction is executed.
    ///
    /// # Errors
    /// [`ErrorKind::Up`] if the new camera would look along `up`, or if it would have passed that view, and [`ErrorKind::Coordinate`] if an
    /// angle or a coordinate of the new position is not within ±2³⁰.
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
        let old = self.description;
        let offset = old.position.minus(old.target).leading();
        let offset = offset.ok_or(Error::of("camera", ErrorKind::View))?;
        let axis = old.up.direction();
        let axis = axis.ok_or(Error::of("camera", ErrorKind::Up))?;
        let rise = sine_and_cosine_of(elevation);
        // Beyond the pole, what was up in the picture would be down.
        if self.up.turned_towards(self.forward, rise).dot(axis) <= Unit::ZERO {
            return Err(Error::of("camera", ErrorKind::Up));
        }
        let raised = self.forward.reversed().turned_towards(self.up, rise);
        let turned = raised.turned_about(axis, sine_and_cosine_of(azimuth));
        let position = old.target.plus(turned, offset);
        let description = CameraDescription { position, ..old };
        Self::aimed(description, Some(self.cotangent))
    }

    #[track_caller]
    const fn checked(description: CameraDescription) -> Self {
        match Self::try_from_description(description) {
            Ok(camera) => camera,
            Err(error) => error.stop(),
        }
    }

    const fn try_from_description(description: CameraDescription) -> Result<Self, Error> {
        let fov = description.fov;
        let is_held = fov.to_bits() >= NARROWEST.to_bits() && fov.to_bits() <= WIDEST.to_bits();
        let cotangent = if is_held { cotangent_of_half(fov) } else { None };
        Self::aimed(description, cotangent)
    }

    /// Creates a camera from its description and 1 / tan(fov / 2), which is `None` if `fov` is out of
    /// range.
    #[inline(never)]
    const fn aimed(
        description: CameraDescription,
        cotangent: Option<Quotient>,
    ) -> Result<Self, Error> {
        let wanted = &description;
        let is_placed = wanted.position.is_in_range() && wanted.target.is_in_range();
        if !(is_placed && wanted.up.is_in_range()) {
            return Err(Error::of("camera", ErrorKind::Coordinate));
        }
        let Some(forward) = wanted.target.minus(wanted.position).direction() else {
            return Err(Error::of("camera", ErrorKind::View));
        };
        let Some(upward) = wanted.up.direction() else {
            return Err(Error::of("camera", ErrorKind::Up));
        };
        // If view and up were closer to parallel than 2⁻²⁴, rounding would decide where right is.
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
