//! Checks a description and lays it on its grid: integers only, by the compiler or at run time.

use super::brightness::{brightest, dimness};
use super::layout::choose_grid;
use super::{Counts, Description, Scene, SceneError, used};
use crate::accel::light_occluders::LightOccluders;
use crate::accel::light_table::LightTable;
use crate::color::Color;
use crate::fault::Fault;
use crate::grid::Grid;
use crate::light::{Light, PreparedLight};
use crate::material::{PreparedMaterial, is_color};
use crate::number::{Brightness, Length, Number, Unit, narrowed_128, signed_wide};
use crate::shape::cylinder::{Cylinder, PreparedCylinder};
use crate::shape::plane::{Plane, PreparedPlane};
use crate::shape::sphere::{PreparedSphere, Sphere};
use crate::vector::{Point, Position};

pub(super) const fn sphere_fault(sphere: &Sphere) -> Option<Fault> {
    if !sphere.center.is_in_range() {
        return Some(Fault::Coordinate);
    }
    size_fault(sphere.radius, Fault::Radius)
}

pub(super) const fn plane_fault(plane: &Plane) -> Option<Fault> {
    if !(plane.point.is_in_range() && plane.normal.is_in_range()) {
        Some(Fault::Coordinate)
    } else if plane.normal.magnitude() == 0 {
        Some(Fault::Normal)
    } else {
        None
    }
}

pub(super) const fn cylinder_fault(cylinder: &Cylinder) -> Option<Fault> {
    if !(cylinder.center.is_in_range() && cylinder.axis.is_in_range()) {
        Some(Fault::Coordinate)
    } else if cylinder.axis.magnitude() == 0 {
        Some(Fault::Axis)
    } else if let Some(fault) = size_fault(cylinder.radius, Fault::Radius) {
        Some(fault)
    } else {
        size_fault(cylinder.height, Fault::Height)
    }
}

pub(super) const fn light_fault(light: &Light) -> Option<Fault> {
    if !light.position.is_in_range() {
        Some(Fault::Coordinate)
    } else if !is_color(light.color) {
        Some(Fault::Color)
    } else {
        None
    }
}

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

/// A size must be greater than 0 and within the range of a coordinate.
const fn size_fault(size: Number, fault: Fault) -> Option<Fault> {
    if size.to_bits() <= 0 {
        Some(fault)
    } else if !size.is_within(0, Position::MAX_COORDINATE) {
        Some(Fault::Coordinate)
    } else {
        None
    }
}

/// The smallest radius and half height a shape may have, in steps: its hits are known to about two,
/// and so its normals to a 32nd.
const SMALLEST: i32 = 64;

/// The smallest epsilon, in steps: what lies in the same place as a surface is not met from it.
const SMALLEST_EPSILON: i32 = 2;

/// The same inside of a sphere, where the shape itself may be met next: a hit is within this of its
/// surface. Inside of a cylinder, twice as much.
const SMALLEST_INSIDE: i32 = 8;

/// The most a material may shine in its scene, in Q6.26: below 32 with room for rounding.
const BRIGHTEST: i64 = 30 << 26;

const fn at_least(length: Length, steps: i32) -> Length {
    if length.to_bits() < steps {
        Length::from_bits(steps)
    } else {
        length
    }
}

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize>
    Scene<S, P, C, L, M>
{
    /// Prepares a description whose parts have been checked and fit.
    pub(super) const fn prepare(scene: &Description<'_>) -> Result<Self, SceneError> {
        let grid = match choose_grid(scene) {
            Ok(grid) => grid,
            Err(fault) => return Err(SceneError::Scene(fault)),
        };
        let epsilon = grid.length(scene.epsilon);
        if epsilon.to_bits() >= crate::ray::BALL {
            return Err(SceneError::Scene(Fault::Epsilon));
        }
        let inside = if scene.cylinders.is_empty() {
            SMALLEST_INSIDE
        } else {
            2 * SMALLEST_INSIDE
        };
        let mut prepared = Self {
            spheres: [PreparedSphere::NONE; S],
            planes: [PreparedPlane::NONE; P],
            cylinders: [PreparedCylinder::NONE; C],
            lights: [PreparedLight::NONE; L],
            light_tables: [LightTable::ALL; L],
            light_occluders: [LightOccluders::NONE; L],
            materials: [PreparedMaterial::NONE; M],
            counts: Counts {
                spheres: scene.spheres.len(),
                planes: scene.planes.len(),
                cylinders: scene.cylinders.len(),
                lights: scene.lights.len(),
                materials: scene.materials.len(),
            },
            background: Color::from_numbers(scene.background).in_levels(),
            brightest: Brightness::ZERO,
            dimness: Unit::ONE,
            epsilon: at_least(epsilon, SMALLEST_EPSILON),
            inner_epsilon: at_least(epsilon, inside),
            grid,
            camera: scene.camera,
        };
        // Constants know no iterators. The second bounds always hold; with them, nothing can panic.
        let mut index = 0;
        while index < scene.spheres.len() && index < S {
            prepared.spheres[index] = match prepare_sphere(&scene.spheres[index], &grid) {
                Some(sphere) => sphere,
                None => return Err(SceneError::Sphere(index, Fault::Tiny)),
            };
            index += 1;
        }
        index = 0;
        while index < scene.planes.len() && index < P {
            prepared.planes[index] = match prepare_plane(&scene.planes[index], &grid) {
                Some(plane) => plane,
                None => return Err(SceneError::Plane(index, Fault::Normal)),
            };
            index += 1;
        }
        index = 0;
        while index < scene.cylinders.len() && index < C {
            prepared.cylinders[index] = match prepare_cylinder(&scene.cylinders[index], &grid) {
                Some(cylinder) => cylinder,
                None => return Err(SceneError::Cylinder(index, Fault::Tiny)),
            };
            index += 1;
        }
        prepared.note_what_touches();
        index = 0;
        while index < scene.lights.len() && index < L {
            prepared.add_light(index, &scene.lights[index]);
            index += 1;
        }
        index = 0;
        while index < scene.materials.len() && index < M {
            let material = PreparedMaterial::new(&scene.materials[index]);
            if is_too_bright(&material, scene.lights) {
                return Err(SceneError::Material(index, Fault::Brightness));
            }
            prepared.materials[index] = material;
            index += 1;
        }
        prepared.brightest = brightest(
            used(&prepared.materials, scene.materials.len()),
            used(&prepared.lights, scene.lights.len()),
            prepared.background,
        );
        prepared.dimness = dimness(prepared.brightest);
        Ok(prepared)
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

    /// Whether a sphere comes so near to another shape that epsilon may lift points into it. Of a
    /// cylinder, the ball around it counts.
    const fn touches_another(&self, index: usize) -> bool {
        let (center, radius) = self.spheres[index].ball();
        // Twice as far, and a few steps for rounding.
        let reach = radius as i64 + 2 * self.inner_epsilon.to_bits() as i64 + 8;
        let mut other = 0;
        while other < self.counts.spheres && other < S {
            if other != index && is_within(center, self.spheres[other].ball(), reach) {
                return true;
            }
            other += 1;
        }
        other = 0;
        while other < self.counts.cylinders && other < C {
            if is_within(center, self.cylinders[other].ball(), reach) {
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

    /// Prepares a light; the shapes are prepared.
    const fn add_light(&mut self, index: usize, light: &Light) {
        let place = self.grid.place(light.position);
        let light = PreparedLight {
            place,
            color: Color::from_numbers(light.color),
            is_plain: false,
        };
        let parts = self.plain_parts();
        let occluders = LightOccluders::new(light, &parts);
        if place.is_near() {
            self.light_tables[index] = LightTable::around(place.point, &self.plain_parts());
        }
        self.lights[index] = *occluders.light_itself();
        self.light_occluders[index] = occluders;
    }
}

const fn prepare_sphere(sphere: &Sphere, grid: &Grid) -> Option<PreparedSphere> {
    let radius = grid.length(sphere.radius);
    if radius.to_bits() < SMALLEST {
        return None;
    }
    Some(PreparedSphere::new(
        grid.place(sphere.center).point,
        radius,
        sphere.material,
    ))
}

const fn prepare_cylinder(cylinder: &Cylinder, grid: &Grid) -> Option<PreparedCylinder> {
    let radius = grid.length(cylinder.radius);
    let half_height = grid.length(Number::from_bits(cylinder.height.to_bits() / 2));
    if radius.to_bits() < SMALLEST || half_height.to_bits() < SMALLEST {
        return None;
    }
    let Some(axis) = cylinder.axis.direction() else {
        return None;
    };
    let center = grid.place(cylinder.center).point;
    Some(PreparedCylinder::new(
        center,
        axis,
        radius,
        half_height,
        cylinder.material,
    ))
}

const fn prepare_plane(plane: &Plane, grid: &Grid) -> Option<PreparedPlane> {
    let Some(normal) = plane.normal.direction() else {
        return None;
    };
    // Of the rounded normal, so that the plane goes through its point exactly.
    let steps = grid.height_of(plane.point, normal);
    let bits = 128 - steps.unsigned_abs().leading_zeros();
    let scale = bits.saturating_sub(61);
    Some(PreparedPlane::new(
        normal,
        narrowed_128(steps >> scale),
        scale,
        plane.material,
    ))
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
