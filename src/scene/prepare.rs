//! Checks a description and lays it on its grid: integers only, by the compiler or at run time.

use super::cells::Cells;
use super::{Counts, Description, Lamp, Scene, SceneError, used};
use crate::color::Color;
use crate::fault::Fault;
use crate::grid::Grid;
use crate::light::{Light, PreparedLight};
use crate::material::{PreparedMaterial, is_color};
use crate::number::{Length, Number};
use crate::shape::cylinder::{Cylinder, PreparedCylinder};
use crate::shape::plane::{Plane, PreparedPlane};
use crate::shape::sphere::{PreparedSphere, Sphere};
use crate::vector::Position;

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

/// The smallest radius a shape may have, in steps: below it a normal would be noise.
const SMALLEST: i32 = 4;

/// The smallest epsilon, in steps: a hit is within this of its surface.
const SMALLEST_EPSILON: i32 = 64;

/// A light, camera or plane within this many radii of the shapes is given its place in the ball:
/// rays to what is near are short. What is further out is kept as a far place, so that a distant sun
/// costs the shapes no bits; these at most 5. A scene of planes alone goes by the nearest plane.
const COMPANIONS: u128 = 32;

/// How many times larger than it need be the ball of a scene with planes is, so that most of what is
/// seen of them is near: 3 bits.
const EXPANSE: u128 = 8;

/// The same for a scene of planes alone, which has no shape to see less exactly.
const EXPANSE_OF_PLANES: u128 = 256;

/// The most a material may shine in its scene, in Q6.26: below 32 with room for rounding.
const BRIGHTEST: i64 = 30 << 26;

impl<const S: usize, const P: usize, const C: usize, const L: usize, const M: usize>
    Scene<S, P, C, L, M>
{
    /// Prepares a description whose parts have been checked and fit.
    pub(super) const fn prepare(scene: &Description<'_>) -> Result<Self, SceneError> {
        let grid = match choose_grid(scene) {
            Ok(grid) => grid,
            Err(fault) => return Err(SceneError::Scene(fault)),
        };
        let mut epsilon = grid.length(scene.epsilon);
        if epsilon.to_bits() >= crate::ray::BALL {
            return Err(SceneError::Scene(Fault::Epsilon));
        }
        if epsilon.to_bits() < SMALLEST_EPSILON {
            epsilon = Length::from_bits(SMALLEST_EPSILON);
        }
        let mut prepared = Self {
            spheres: [PreparedSphere::NONE; S],
            planes: [PreparedPlane::NONE; P],
            cylinders: [PreparedCylinder::NONE; C],
            lights: [PreparedLight::NONE; L],
            cells: [Cells::ALL; L],
            lamps: [Lamp::NONE; L],
            materials: [PreparedMaterial::NONE; M],
            counts: Counts {
                spheres: scene.spheres.len(),
                planes: scene.planes.len(),
                cylinders: scene.cylinders.len(),
                lights: scene.lights.len(),
                materials: scene.materials.len(),
            },
            background: Color::from_numbers(scene.background),
            epsilon,
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
        Ok(prepared)
    }

    /// Prepares a light; the shapes are prepared.
    const fn add_light(&mut self, index: usize, light: &Light) {
        let place = self.grid.place(light.position);
        let mut lamp = Lamp::NONE;
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
                prepared.is_plain &= !lamp.spheres[shape].is_around();
                shape += 1;
            }
            shape = 0;
            while shape < cylinders.len() && shape < C {
                lamp.cylinders[shape] = cylinders[shape].seen_from(place.point);
                shape += 1;
            }
        }
        lamp.light = prepared;
        self.lamps[index] = lamp;
        self.lights[index] = prepared;
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
    if radius.to_bits() < SMALLEST || half_height.to_bits() < 1 {
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
    // The offset of the rounded normal, so that the plane goes through its point exactly:
    // coordinates below 2^(31 + 64) times Q30, three of them, stay below 2^127.
    let [x, y, z] = plane.point.minus(grid.middle()).0;
    let [nx, ny, nz] = normal.components();
    let offset = x.to_bits() * nx.to_bits() as i128
        + y.to_bits() * ny.to_bits() as i128
        + z.to_bits() * nz.to_bits() as i128;
    let steps = offset >> (64 - grid.fraction_bits());
    let bits = 128 - steps.unsigned_abs().leading_zeros();
    let scale = bits.saturating_sub(61);
    Some(PreparedPlane::new(
        normal,
        (steps >> scale) as i64,
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

/// The box around what has been added so far.
struct Bounds {
    low: [i128; 3],
    high: [i128; 3],
    is_empty: bool,
}

impl Bounds {
    const EMPTY: Self = Self {
        low: [0; 3],
        high: [0; 3],
        is_empty: true,
    };

    const fn add(&mut self, center: Position, size: i128) {
        let mut axis = 0;
        while axis < 3 {
            let middle = center.0[axis].to_bits();
            let (low, high) = (middle - size, middle + size);
            if self.is_empty || low < self.low[axis] {
                self.low[axis] = low;
            }
            if self.is_empty || high > self.high[axis] {
                self.high[axis] = high;
            }
            axis += 1;
        }
        self.is_empty = false;
    }

    const fn middle(&self) -> Position {
        let mut middle = Position::ORIGIN;
        let mut axis = 0;
        while axis < 3 {
            middle.0[axis] = Number::from_bits((self.low[axis] + self.high[axis]) / 2);
            axis += 1;
        }
        middle
    }
}

/// At least the distance of two positions, in the bits of a [`Number`].
const fn distance(from: Position, to: Position) -> u128 {
    match to.minus(from).leading() {
        None => 0,
        Some((vector, shift)) => {
            let length = (vector.direction_and_length().1.to_bits() + 2) as u128;
            if shift >= 0 {
                length << shift
            } else {
                (length >> -shift) + 1
            }
        }
    }
}

/// Half the size of a cylinder, at least: radius + height / 2.
const fn cylinder_size(cylinder: &Cylinder) -> i128 {
    cylinder.radius.to_bits() + cylinder.height.to_bits() / 2
}

/// Puts the middle of the scene in the middle of its shapes, and chooses the finest step that
/// holds them and what stands near them.
const fn choose_grid(scene: &Description<'_>) -> Result<Grid, Fault> {
    let middle = middle_of(scene);
    let mut radius = 0;
    let mut index = 0;
    while index < scene.spheres.len() {
        let sphere = &scene.spheres[index];
        let far_side = distance(middle, sphere.center) + sphere.radius.to_bits() as u128;
        radius = larger(radius, far_side);
        index += 1;
    }
    index = 0;
    while index < scene.cylinders.len() {
        let cylinder = &scene.cylinders[index];
        let far_side = distance(middle, cylinder.center) + cylinder_size(cylinder) as u128;
        radius = larger(radius, far_side);
        index += 1;
    }
    let shapes = if radius > 0 {
        radius
    } else {
        nearest_plane(middle, scene.planes)
    };
    radius = shapes;
    index = 0;
    while index < scene.lights.len() {
        radius = accompanied(
            radius,
            shapes,
            distance(middle, scene.lights[index].position),
        );
        index += 1;
    }
    if let Some(camera) = scene.camera {
        radius = accompanied(
            radius,
            shapes,
            distance(middle, camera.description().position),
        );
    }
    index = 0;
    while index < scene.planes.len() {
        let away = distance_to_plane(middle, &scene.planes[index]);
        radius = accompanied(radius, shapes, away);
        index += 1;
    }
    if radius == 0 {
        radius = 1 << 64;
    }
    if !scene.planes.is_empty() {
        let is_bounded = !(scene.spheres.is_empty() && scene.cylinders.is_empty());
        radius *= if is_bounded {
            EXPANSE
        } else {
            EXPANSE_OF_PLANES
        };
    }
    if radius < 1 << 34 {
        Err(Fault::Extent)
    } else {
        Ok(Grid::new(middle, radius))
    }
}

/// The distance to the nearest plane that does not go through `middle`; 0 where there is none.
const fn nearest_plane(middle: Position, planes: &[Plane]) -> u128 {
    let mut nearest = 0;
    let mut index = 0;
    while index < planes.len() {
        let away = distance_to_plane(middle, &planes[index]);
        if away > 0 && (nearest == 0 || away < nearest) {
            nearest = away;
        }
        index += 1;
    }
    nearest
}

/// The middle of the shapes; where there are none, the camera, and without one the middle of the
/// lights.
const fn middle_of(scene: &Description<'_>) -> Position {
    let mut bounds = Bounds::EMPTY;
    let mut index = 0;
    while index < scene.spheres.len() {
        let sphere = &scene.spheres[index];
        bounds.add(sphere.center, sphere.radius.to_bits());
        index += 1;
    }
    index = 0;
    while index < scene.cylinders.len() {
        let cylinder = &scene.cylinders[index];
        bounds.add(cylinder.center, cylinder_size(cylinder));
        index += 1;
    }
    if !bounds.is_empty {
        return bounds.middle();
    }
    if let Some(camera) = scene.camera {
        return camera.description().position;
    }
    index = 0;
    while index < scene.lights.len() {
        bounds.add(scene.lights[index].position, 0);
        index += 1;
    }
    bounds.middle()
}

/// `radius` enlarged for something `away`, where that is near the shapes or there are none.
const fn accompanied(radius: u128, shapes: u128, away: u128) -> u128 {
    if shapes == 0 || away <= COMPANIONS * shapes {
        larger(radius, away)
    } else {
        radius
    }
}

const fn larger(a: u128, b: u128) -> u128 {
    if a > b { a } else { b }
}

/// The distance of a position to a plane, in the bits of a [`Number`], but for 2⁻³⁰ of it.
const fn distance_to_plane(position: Position, plane: &Plane) -> u128 {
    let Some(normal) = plane.normal.direction() else {
        return 0;
    };
    match plane.point.minus(position).leading() {
        None => 0,
        Some((vector, shift)) => {
            let length = vector.dot(normal).unsigned_abs() as u128;
            if shift >= 0 {
                length << shift
            } else {
                length >> -shift
            }
        }
    }
}

#[cfg(test)]
mod tests;
