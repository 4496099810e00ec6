//! Checks a description and lays it on its grid: integers only, by the compiler or at run time.

use super::brightness::{brightest, dimness};
use super::cells::Cells;
use super::layout::choose_grid;
use super::{Description, LightOccluders, Scene, SceneError, used};
use crate::color::Color;
use crate::fault::Fault;
use crate::grid::Grid;
use crate::light::{Light, PreparedLight};
use crate::material::{PreparedMaterial, is_color};
use crate::number::{Brightness, Length, Number, Unit, signed_wide};
use crate::shape::plane::PreparedPlane;
use crate::shape::size_fault;
use crate::vector::Point;

pub(super) const fn background_fault(color: [Number; 3]) -> Option<Fault> {
    if is_color(color) {
        None
    } else {
        Some(Fault::Background)
    }
}

pub(super) const fn epsilon_fault(epsilon: Number) -> Option<Fault> {
    match size_fault(epsilon, Fault::Epsilon) {
        Some(_) => Some(Fault::Epsilon),
        None => None,
    }
}

/// The smallest epsilon, in steps: what lies in the same place as a surface is not met from it.
const SMALLEST_EPSILON: i32 = 2;

/// The most a material may shine in its scene, in Q6.26: below 32 with room for rounding.
const BRIGHTEST: i64 = 30 << 26;

const fn at_least(length: Length, steps: i32) -> Length {
    if length.to_bits() < steps {
        Length::from_bits(steps)
    } else {
        length
    }
}

macro_rules! prepare {
    (
        { $declaration:tt [$($header:tt)*] [$($arguments:tt)*] }
        $({ $list:ident $kind:ident $described:ident $prepared:ident $room:ident $($more:tt)* })*
    ) => {
        impl<$($header)*> Scene<$($arguments)*> {
            /// Prepares a description whose parts have been checked and fit.
            pub(super) const fn prepare(scene: &Description<'_>) -> Result<Self, SceneError> {
                let (grid, epsilon) = match laid(scene) {
                    Ok(laid) => laid,
                    Err(fault) => return Err(SceneError::Scene(fault)),
                };
                let mut prepared = Self {
                    $($list: [crate::shape::$prepared::NONE; $room],)*
                    planes: [PreparedPlane::NONE; P],
                    lights: [PreparedLight::NONE; L],
                    cells: [Cells::ALL; L],
                    lamps: [LightOccluders::NONE; L],
                    materials: [PreparedMaterial::NONE; M],
                    counts: scene.counts(),
                    background: Color::from_numbers(scene.background).in_levels(),
                    brightest: Brightness::ZERO,
                    dimness: Unit::ONE,
                    epsilon: at_least(epsilon, SMALLEST_EPSILON),
                    inner_epsilon: at_least(epsilon, scene.smallest_inside(SMALLEST_EPSILON)),
                    grid,
                    camera: scene.camera,
                };
                if let Err(error) = prepared.add_shapes(scene) {
                    return Err(error);
                }
                prepared.note_what_touches();
                let mut index = 0;
                while index < scene.lights.len() && index < L {
                    prepared.add_light(index, &scene.lights[index]);
                    index += 1;
                }
                if let Err(error) = prepare_materials(&mut prepared.materials, scene) {
                    return Err(error);
                }
                prepared.brightest = brightest(
                    used(&prepared.materials, scene.materials.len()),
                    used(&prepared.lights, scene.lights.len()),
                    prepared.background,
                );
                prepared.dimness = dimness(prepared.brightest);
                Ok(prepared)
            }

            const fn add_shapes(&mut self, scene: &Description<'_>) -> Result<(), SceneError> {
                // Constants know no iterators. The second bounds always hold; with them, nothing can panic.
                $(
                    let mut index = 0;
                    while index < scene.$list.len() && index < self.$list.len() {
                        let $kind = &scene.$list[index];
                        self.$list[index] = match crate::shape::$prepared::prepare($kind, &self.grid) {
                            Ok($kind) => $kind,
                            Err(fault) => return Err(SceneError::$described(index, fault)),
                        };
                        index += 1;
                    }
                )*
                let mut index = 0;
                while index < scene.planes.len() && index < P {
                    self.planes[index] = match PreparedPlane::prepare(&scene.planes[index], &self.grid) {
                        Ok(plane) => plane,
                        Err(fault) => return Err(SceneError::Plane(index, fault)),
                    };
                    index += 1;
                }
                Ok(())
            }

            /// The ball around a bounded shape with this number; the kinds follow each other.
            const fn ball(&self, number: usize) -> Option<(Point, i32)> {
                $(
                    let shapes = used(&self.$list, self.counts.$list);
                    if number < shapes.len() {
                        return Some(shapes[number].ball());
                    }
                    let number = number - shapes.len();
                )*
                let _ = number;
                None
            }

            /// Notes which spheres touch or cut another shape.
            const fn note_what_touches(&mut self) {
                let mut index = 0;
                while index < self.counts.spheres && index < S {
                    let touches = self.touches_another(index);
                    self.spheres[index] = self.spheres[index].touching(touches);
                    index += 1;
                }
            }

            /// Whether a bounded shape comes so near to another that epsilon may lift points into it. Of
            /// each, the ball around it counts.
            const fn touches_another(&self, number: usize) -> bool {
                let Some((center, radius)) = self.ball(number) else {
                    return false;
                };
                // Twice as far, and a few steps for rounding.
                let reach = radius as i64 + 2 * self.inner_epsilon.to_bits() as i64 + 8;
                let mut other = 0;
                while let Some(ball) = self.ball(other) {
                    if other != number && is_within(center, ball, reach) {
                        return true;
                    }
                    other += 1;
                }
                other = 0;
                while other < self.counts.planes && other < P {
                    if (self.planes[other].height(center) >> 30).abs() <= reach {
                        return true;
                    }
                    other += 1;
                }
                false
            }
        }
    };
}
kinds!(prepare);

/// The grid of a scene, and its epsilon in steps.
const fn laid(scene: &Description<'_>) -> Result<(Grid, Length), Fault> {
    let grid = match choose_grid(scene) {
        Ok(grid) => grid,
        Err(fault) => return Err(fault),
    };
    let epsilon = grid.length(scene.epsilon);
    if epsilon.to_bits() >= crate::ray::BALL {
        return Err(Fault::Epsilon);
    }
    Ok((grid, epsilon))
}

/// Prepares the materials, none of which may be too bright under the lights.
const fn prepare_materials(
    prepared: &mut [PreparedMaterial],
    scene: &Description<'_>,
) -> Result<(), SceneError> {
    let mut index = 0;
    while index < scene.materials.len() && index < prepared.len() {
        let material = PreparedMaterial::new(&scene.materials[index]);
        if is_too_bright(&material, scene.lights) {
            return Err(SceneError::Material(index, Fault::Brightness));
        }
        prepared[index] = material;
        index += 1;
    }
    Ok(())
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize>
    Scene<S, P, C, L, M>
{
    /// Prepares a light; the shapes are prepared.
    const fn add_light(&mut self, index: usize, light: &Light) {
        let place = self.grid.place(light.position);
        let mut lamp = LightOccluders::NONE;
        let mut prepared = PreparedLight {
            place,
            color: Color::from_numbers(light.color),
            is_plain: place.is_near(),
        };
        if place.is_near() {
            let spheres = used(&self.spheres, self.counts.spheres);
            let cylinders = used(&self.cylinders, self.counts.cylinders);
            self.cells[index] = Cells::around(place.point, spheres, cylinders);
            let mut shape = 0;
            while shape < spheres.len() && shape < S {
                lamp.spheres[shape] = spheres[shape].seen_from(place.point);
                let (_, radius) = spheres[shape].ball();
                prepared.is_plain &= lamp.spheres[shape].is_told_by_tangents(radius);
                shape += 1;
            }
            shape = 0;
            while shape < cylinders.len() && shape < C {
                lamp.cylinders[shape] = cylinders[shape].lit_from(place.point);
                shape += 1;
            }
        }
        lamp.light = prepared;
        self.lamps[index] = lamp;
        self.lights[index] = prepared;
    }
}

/// Whether the light a material sends out may exceed [`BRIGHTEST`] at any step of its sum.
const fn is_too_bright(material: &PreparedMaterial, lights: &[Light]) -> bool {
    let sent = material.diffuse.to_bits() as i64 + material.specular.to_bits() as i64;
    let mut sum = material.ambient.to_bits() as i64;
    let mut index = 0;
    while index < lights.len() {
        let largest = Color::from_numbers(lights[index].color).largest().to_bits() as i64;
        sum += (sent * largest) >> 26;
        index += 1;
    }
    // sum is below 2^35 a light, color at most 2^30: the product is taken only where it fits.
    let color = material.color.largest().to_bits() as i64;
    sent > BRIGHTEST || sum > BRIGHTEST || (sum * color) >> 26 > BRIGHTEST
}

/// Whether a ball comes within `reach` of a point.
const fn is_within(point: Point, (center, radius): (Point, i32), reach: i64) -> bool {
    // Both below 2³⁰, a little more at most: the square fits.
    let most = reach + radius as i64;
    signed_wide(point.to(center).square()) < most * most
}

#[cfg(test)]
mod tests;
