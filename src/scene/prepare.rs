//! Preparation: checks a description and converts it to the steps of its grid. It uses integers only, in
//! constants and at run time.

use super::Description;
use super::access::Parts;
use super::brightness::dimness;
use super::capacity::{Capacity, Counts, Room};
use super::description::EPSILON;
use super::layout::choose_grid;
use super::shape_set::ShapeSet;
use crate::background::PreparedBackground;
use crate::camera::Camera;
use crate::checker::PreparedChecker;
use crate::color::Color;
use crate::error::Error;
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::light::{Light, PreparedLight};
use crate::material::PreparedMaterial;
use crate::number::{Brightness, Length, Number, Unit, signed_wide};
use crate::shape::plane::PreparedPlane;
use crate::shape::size_fault;
use crate::vector::{Point, Position};

pub(super) const fn epsilon_fault(epsilon: Number) -> Option<ErrorKind> {
    match size_fault(epsilon, ErrorKind::Epsilon) {
        Some(_) => Some(ErrorKind::Epsilon),
        None => None,
    }
}

/// Returns the mistake in a motion box: a corner out of range, or a coordinate of `low` above that of
/// `high`.
pub(super) const fn motion_fault([low, high]: [Position; 2]) -> Option<ErrorKind> {
    if !(low.is_in_range() && high.is_in_range()) {
        return Some(ErrorKind::Coordinate);
    }
    let mut axis = 0;
    while axis < 3 {
        if low.0[axis].to_bits() > high.0[axis].to_bits() {
            return Some(ErrorKind::Motion);
        }
        axis += 1;
    }
    None
}

/// Smallest epsilon in steps: with it, a ray that leaves a surface misses another surface in the same
/// place.
const SMALLEST_EPSILON: i32 = 2;

/// Largest light that a material may send out in its scene, Q6.26: 30, so that sums stay below 32 after
/// rounding.
const BRIGHTEST: i64 = 30 << 26;

const fn at_least(length: Length, steps: i32) -> Length {
    if length.to_bits() < steps { Length::from_bits(steps) } else { length }
}

/// The operator `?`, which constant functions do not have.
macro_rules! attempt {
    ($result:expr, |$fault:ident| $error:expr) => {
        match $result {
            Ok(value) => value,
            Err($fault) => return Err($error),
        }
    };
}

macro_rules! prepare {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $lists:ident $($more:tt)* })*
    ) => {
        /// A prepared scene as the plain kernels read it: without culling tables.
        #[derive(Clone, Copy, Debug)]
        pub struct PlainScene<R: Capacity> {
            $(pub(crate) $list: R::$lists<crate::shape::$prepared>,)*
            pub(crate) planes: R::Planes<PreparedPlane>,
            pub(crate) lights: R::Lights<PreparedLight>,
            pub(crate) materials: R::Materials<PreparedMaterial>,
            pub(crate) checkers: R::Materials<PreparedChecker>,
            pub(crate) counts: Counts,
            pub(crate) background: PreparedBackground,
            pub(crate) brightest: Brightness,
            pub(crate) dimness: Unit,
            pub(crate) epsilon: Length,
            pub(crate) inner_epsilon: Length,
            pub(crate) grid: Grid,
            pub(crate) camera: Option<Camera>,
            /// Lowest and highest corner of the box in which shapes may move, in steps.
            pub(crate) motion: Option<[Point; 2]>,
            /// Set of the shapes of a constant scene that can move.
            pub(crate) moving: ShapeSet,
        }

        impl<$($header)*> PlainScene<Room<$($arguments)*>> {
            /// Prepares a scene from a description whose parts were checked and fit the room.
            pub(crate) const fn prepare(scene: &Description<'_>) -> Result<Self, Error> {
                let (grid, epsilon) = attempt!(laid(scene), |error| error);
                let mut prepared = Self {
                    $($list: [crate::shape::$prepared::NONE; $room],)*
                    planes: [PreparedPlane::NONE; P],
                    lights: [PreparedLight::NONE; L],
                    materials: [PreparedMaterial::NONE; M],
                    checkers: [PreparedChecker::NONE; M],
                    counts: scene.counts(),
                    background: PreparedBackground::new(&scene.background()),
                    brightest: Brightness::ZERO,
                    dimness: Unit::ONE,
                    epsilon: at_least(epsilon, SMALLEST_EPSILON),
                    inner_epsilon: at_least(epsilon, scene.smallest_inside(SMALLEST_EPSILON)),
                    grid,
                    camera: scene.camera,
                    motion: match scene.motion {
                        Some([low, high]) => Some([grid.place(low).point, grid.place(high).point]),
                        None => None,
                    },
                    moving: ShapeSet::NONE,
                };
                attempt!(prepared.add_shapes(scene), |error| error);
                prepared.note_what_touches();
                let mut index = 0;
                while index < scene.lights.len() && index < L {
                    prepared.lights[index] = PreparedLight::new(&scene.lights[index], &grid);
                    index += 1;
                }
                attempt!(prepared.add_materials(scene), |error| error);
                prepared.brightest = prepared.constant_parts().brightest_color();
                prepared.dimness = dimness(prepared.brightest);
                Ok(prepared)
            }

            const fn add_shapes(&mut self, scene: &Description<'_>) -> Result<(), Error> {
                // Constant code has no iterators. The second bound always holds; with it no index can
                // panic.
                $(
                    let mut index = 0;
                    while index < scene.$list.len() && index < self.$list.len() {
                        let $kind = crate::shape::$prepared::prepare(&scene.$list[index], &self.grid);
                        self.$list[index] = attempt!($kind, |fault| Error::at(stringify!($kind), index, fault));
                        index += 1;
                    }
                )*
                let mut index = 0;
                while index < scene.planes.len() && index < P {
                    let plane = PreparedPlane::prepare(&scene.planes[index], &self.grid);
                    self.planes[index] = attempt!(plane, |fault| Error::at("plane", index, fault));
                    index += 1;
                }
                Ok(())
            }

            /// Prepares the materials. Refuses a material that is too bright under the lights of its scene.
            const fn add_materials(&mut self, scene: &Description<'_>) -> Result<(), Error> {
                let mut index = 0;
                while index < scene.materials.len() && index < M {
                    let described = &scene.materials[index];
                    let material = PreparedMaterial::new(described);
                    if let Some(checker) = &described.described_checker() {
                        let checker = PreparedChecker::prepare(checker, &self.grid);
                        self.checkers[index] = attempt!(checker, |fault| Error::at("material", index, fault));
                    }
                    let brightest = material.color.at_least(self.checkers[index].color).largest();
                    if is_too_bright(&material, brightest, scene.lights) {
                        return Err(Error::at("material", index, ErrorKind::Brightness));
                    }
                    self.materials[index] = material;
                    index += 1;
                }
                Ok(())
            }

            /// Marks each bounded shape that touches or cuts another shape, or may do so after a move.
            const fn note_what_touches(&mut self) {
                let mut number = 0;
                $(
                    let mut index = 0;
                    while index < self.counts.$list && index < $room {
                        // A shape that moves may come to touch any other shape.
                        let touches = self.motion.is_some()
                            || touches_another(&self.constant_parts(), number);
                        self.$list[index] = self.$list[index].touching(touches);
                        index += 1;
                        number += 1;
                    }
                )*
                let _ = number;
            }
        }
    };
}
kinds!(prepare);

/// Tests whether a bounded shape is so near to another shape that epsilon may lift a point of one into
/// the other. Compares the balls around the shapes.
const fn touches_another(parts: &Parts<'_>, number: usize) -> bool {
    let Some(((center, radius), _)) = parts.ball(number) else {
        return false;
    };
    // Twice epsilon, and 8 steps for rounding.
    let reach = radius as i64 + 2 * parts.inner_epsilon.to_bits() as i64 + 8;
    let mut other = 0;
    while let Some((ball, _)) = parts.ball(other) {
        if other != number && is_within(center, ball, reach) {
            return true;
        }
        other += 1;
    }
    other = 0;
    while other < parts.planes.len() {
        if (parts.planes[other].height(center) >> 30).abs() <= reach {
            return true;
        }
        other += 1;
    }
    false
}

/// Returns the grid of a scene, and its epsilon in steps; epsilon must be below 2²⁸ steps.
const fn laid(scene: &Description<'_>) -> Result<(Grid, Length), Error> {
    let grid = attempt!(choose_grid(scene), |fault| Error::of("scene", fault));
    let epsilon = grid.length(scene.epsilon);
    if epsilon.to_bits() >= crate::ray::BALL {
        return Err(epsilon_above_the_shapes(scene));
    }
    Ok((grid, epsilon))
}

/// Returns the error of a scene whose shapes are together not larger than its epsilon. If epsilon is at
/// most its default, a shape is at fault: the user may never have set epsilon.
const fn epsilon_above_the_shapes(scene: &Description<'_>) -> Error {
    match scene.first_kind() {
        Some(kind) if scene.epsilon.to_bits() <= Number::new(EPSILON).to_bits() => {
            Error::at(kind, 0, ErrorKind::BelowEpsilon)
        }
        _ => Error::of("scene", ErrorKind::Epsilon),
    }
}

/// Returns the extent of a scene in scene units: the radius of the ball that its grid holds. It is
/// `None` if the scene has no grid.
#[cfg(feature = "files")]
pub(crate) fn extent_of(scene: &Description<'_>) -> Option<f64> {
    let grid = choose_grid(scene).ok()?;
    Some(f64::from(crate::ray::BALL) * crate::number::power_of_two(-grid.fraction_bits()))
}

/// Tests whether the light that a material sends out may exceed [`BRIGHTEST`] at any step of its sum.
const fn is_too_bright(material: &PreparedMaterial, color: Brightness, lights: &[Light]) -> bool {
    let sent = material.diffuse.to_bits() as i64 + material.specular.to_bits() as i64;
    let mut sum = material.ambient.to_bits() as i64;
    let mut index = 0;
    while index < lights.len() {
        let largest = Color::from_numbers(lights[index].color).largest().to_bits() as i64;
        sum += (sent * largest) >> 26;
        index += 1;
    }
    // `sum` grows by less than 2^35 for each light, and `color` is at most 2^30. The product is computed
    // only if `sum` is small enough.
    let color = color.to_bits() as i64;
    sent > BRIGHTEST || sum > BRIGHTEST || (sum * color) >> 26 > BRIGHTEST
}

/// Tests whether a ball comes within `reach` of a point.
const fn is_within(point: Point, (center, radius): (Point, i32), reach: i64) -> bool {
    // Both are below 2³⁰, or a little above: the square fits.
    let most = reach + radius as i64;
    signed_wide(point.to(center).square()) < most * most
}

#[cfg(test)]
mod tests;
