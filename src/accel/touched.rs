//! Where a picture depends on one bounded shape: the pixels that show the shape, its shadows, or either of them in mirrors.
//!
//! Bound: each of these lies in a ball or in a capsule, whose rectangle on the screen is known
//! ([`super::screen_axis`]). The shadow on a plane lies in the quadrilateral that a pyramid around the shape's ball cuts
//! out of the plane. A bounded shape that the shadow reaches is taken as a whole, and so is one that mirrors. What a
//! plane mirrors is seen where its image in the plane is.

use heapless::Vec;

use super::World;
use super::screen_axis::{Columns, widened};
use crate::light::PreparedLight;
use crate::number::{Length, narrowed, square_root, unsigned_wide, wide};
use crate::ray::{ScaledPoint, ScreenAxis};
use crate::scene::access::{Parts, ShapeId};
use crate::shape::plane::PreparedPlane;
use crate::vector::{Direction, Point, Vector};

/// A kind of bounded shape, as users describe it.
pub trait BoundedShape {
    /// Name of the kind.
    #[doc(hidden)]
    const KIND: &'static str;
}

macro_rules! bounded_shapes {
    ($header:tt $({ $list:ident $kind:ident $described:ident $($more:tt)* })*) => {
        $(
            impl BoundedShape for crate::shape::$described {
                const KIND: &'static str = stringify!($kind);
            }
        )*

        impl Parts<'_> {
            /// Returns the number of a shape, given its kind and its index among those of its kind.
            pub(crate) fn shape_of<T: BoundedShape>(&self, index: usize) -> Option<ShapeId> {
                let first = 0;
                $(
                    if T::KIND == stringify!($kind) {
                        return (index < self.$list.len()).then(|| ShapeId::at(first + index));
                    }
                    let first = first + self.$list.len();
                )*
                let _ = first;
                None
            }
        }
    };
}
kinds!(bounded_shapes);

/// All points within a radius of the convex hull of some points.
#[derive(Clone, Debug)]
struct Hull {
    points: Vec<Point, 16>,
    radius: i32,
}

impl Hull {
    /// Returns the hull around a bounded shape: a ball, or a capsule around a line.
    fn around(parts: &Parts<'_>, shape: ShapeId) -> Option<Self> {
        let (middle, half, radius) = parts.outline(shape)?;
        let middle = middle.to_vector();
        let ends = [middle.plus(half), middle.minus(half)].map(Point::at);
        let count = if half == Vector::ZERO { 1 } else { 2 };
        Some(Self {
            points: ends.into_iter().take(count).collect(),
            radius,
        })
    }
}

/// Largest coordinate of a point that is looked at, in steps.
const FAR: i64 = 1 << 29;

/// Smallest rate at which rays may near a plane. Rays that are closer to parallel throw endless shadows.
const STEEP: i64 = 64;

/// Most reflections in planes that are followed one by one.
const MOST_BOUNCES: u32 = 6;

/// The pixels of a picture that depend on a shape, while they are collected.
pub(crate) struct Touched<'a, W, F> {
    world: &'a W,
    axes: &'a [ScreenAxis; 2],
    /// How often planes mirror.
    bounces: u32,
    /// Is given the first and the last column and row of each part.
    found: F,
    /// Whether the whole picture may depend on the shape.
    is_whole: bool,
}

impl<'a, W: World, F: FnMut([Columns; 2])> Touched<'a, W, F> {
    /// Calls `found` with the columns and rows of all parts of the picture that may depend on a shape. Returns `false` if that
    /// may be the whole picture. `axes` are those of a near camera, `bounces` is 0 if nothing mirrors.
    pub(crate) fn find(
        world: &'a W,
        axes: &'a [ScreenAxis; 2],
        shape: ShapeId,
        (bounces, has_shadows, found): (u32, bool, F),
    ) -> bool {
        let mut touched = Self {
            world,
            axes,
            bounces: if W::NEEDS.mirrored { bounces } else { 0 },
            found,
            is_whole: false,
        };
        let parts = world.parts();
        let Some(body) = Hull::around(&parts, shape) else {
            return true;
        };
        touched.show(&body, None, 0);
        if has_shadows && W::NEEDS.shadows {
            for light in parts.lights {
                touched.shade(light, shape);
            }
        }
        if touched.bounces > 0 {
            for other in (0..parts.bounded()).map(ShapeId::at) {
                let mirrors = |material| parts.material(material).mirrors();
                if other != shape && parts.material_of(other).is_some_and(mirrors) {
                    touched.show_shape(other);
                }
            }
        }
        !touched.is_whole
    }

    /// Takes a bounded shape as a whole.
    fn show_shape(&mut self, shape: ShapeId) {
        if let Some(hull) = Hull::around(&self.world.parts(), shape) {
            self.show(&hull, None, 0);
        }
    }

    /// Takes the pixels that show a hull, and those that show it in mirroring planes. It is mirrored by `mirror`, after so
    /// many bounces.
    fn show(&mut self, hull: &Hull, mirror: Option<usize>, bounces: u32) {
        let origin = self.axes[0].origin;
        let radius = widened(hull.radius);
        let ways: Vec<_, 16> = hull.points.iter().map(|point| origin.to(*point)).collect();
        let sides = self.axes.each_ref();
        if let [Some(columns), Some(rows)] = sides.map(|axis| axis.hull_columns(&ways, radius)) {
            (self.found)([columns, rows]);
        }
        if bounces >= self.bounces || !W::NEEDS.plane_mirrors {
            return;
        }
        let parts = self.world.parts();
        for (index, plane) in parts.planes.iter().enumerate() {
            if mirror == Some(index) || !parts.material(plane.material).mirrors() {
                continue;
            }
            match self.mirrored(hull, plane) {
                Some(image) if bounces < MOST_BOUNCES => {
                    self.show(&image, Some(index), bounces + 1)
                }
                _ => self.is_whole = true,
            }
        }
    }

    /// Returns the image of a hull in a plane. `None` if it is too far away. Mirrored rays start up to two epsilon aside.
    fn mirrored(&self, hull: &Hull, plane: &PreparedPlane) -> Option<Hull> {
        let mut is_held = true;
        let images = hull.points.iter().map(|point| {
            let height = plane.height(*point) >> 30;
            is_held &= height.abs() < FAR;
            let height = narrowed(height.clamp(-FAR, FAR));
            let image = point.to_vector().without(plane.normal, 2 * height);
            let Vector { x, y, z } = image;
            is_held &= [x, y, z]
                .iter()
                .all(|it| i64::from(it.unsigned_abs()) < FAR);
            Point::at(image)
        });
        let points = images.collect();
        is_held.then_some(Hull {
            points,
            radius: hull.radius + 2 * self.world.parts().epsilon.to_bits(),
        })
    }

    /// Takes what the shadow of a shape in one light reaches.
    fn shade(&mut self, light: &PreparedLight, shape: ShapeId) {
        let parts = self.world.parts();
        let body = Hull::around(&parts, shape);
        let cone = ball_of(&parts, shape).and_then(|ball| Cone::new(light, ball));
        let (Some(body), Some(cone)) = (body, cone) else {
            self.is_whole = true;
            return;
        };
        for plane in parts.planes {
            let mut cut = Hull {
                points: Vec::new(),
                radius: 0,
            };
            // The shadow of a hull is the hull of the shadows.
            for point in &body.points {
                let cone = Cone::new(light, (*point, widened(body.radius)));
                let is_cut = cone.and_then(|cone| cone.cut(plane, parts.epsilon, &mut cut));
                self.is_whole |= is_cut.is_none();
            }
            if !cut.points.is_empty() {
                self.show(&cut, None, 0);
            }
        }
        for other in (0..parts.bounded()).map(ShapeId::at) {
            let is_reached = ball_of(&parts, other).is_some_and(|ball| cone.reaches(ball));
            if other != shape && is_reached {
                self.show_shape(other);
            }
        }
    }
}

/// Returns the centre and the radius of a ball around a bounded shape.
fn ball_of(parts: &Parts<'_>, shape: ShapeId) -> Option<(Point, i32)> {
    let (middle, half, radius) = parts.outline(shape)?;
    Some((middle, widened(radius + square_root(half.square()))))
}

/// Returns the direction and the distance from a lamp to the centre of a ball, and the radius there of the cone of its tangents.
/// `None` if the lamp is far away, or in the ball.
fn tangents(lamp: ScaledPoint, (center, radius): (Point, i32)) -> Option<(Direction, i32, i32)> {
    let way = lamp.is_near().then(|| lamp.point.to(center))?;
    let (axis, distance) = way.direction_and_length();
    let distance = distance.to_bits();
    if distance <= radius + (radius >> 4) {
        return None;
    }
    let square = wide(distance - radius, distance) + wide(distance - radius, radius);
    let tangent = square_root(unsigned_wide(square)).max(1);
    let spread = narrowed(wide(radius, distance) / i64::from(tangent));
    Some((axis, distance, widened(spread)))
}

/// Returns a direction across another one.
fn across(axis: Direction) -> Option<Direction> {
    let Vector { x, y, z } = axis.raw();
    let [x, y, z] = [x, y, z].map(i32::unsigned_abs);
    // The coordinate axis that is least along it.
    let along = match x.min(y).min(z) {
        least if least == x => Vector::new(1 << 30, 0, 0),
        least if least == y => Vector::new(0, 1 << 30, 0),
        _ => Vector::new(0, 0, 1 << 30),
    };
    axis.perpendicular(Direction::from_raw(along))
}

/// The rays from a light to a ball, and beyond it.
struct Cone {
    /// The light, or `None` if it is a sun.
    light: Option<Point>,
    center: Point,
    radius: i32,
    /// Direction from the light to the ball's centre, and the distance.
    axis: Direction,
    distance: i32,
    /// Radius of the cone at the centre.
    spread: i32,
    /// Corners of an octagon around the cone at the centre.
    corners: [Point; 8],
}

/// The tangent of 22.5 degrees in 1/65536, rounded up: an octagon around a circle has corners at 1 and this.
const SLANT: i64 = 27_147;

impl Cone {
    /// Creates the cone of a light around a ball. `None` if the light is a lamp that is far away, or in the ball.
    fn new(light: &PreparedLight, (center, radius): (Point, i32)) -> Option<Self> {
        let lamp = light.sun().is_none().then_some(light.place);
        let (axis, distance, spread) = match light.sun() {
            Some(towards) => (towards.reversed(), 0, radius),
            None => tangents(light.place, (center, radius))?,
        };
        let across = across(axis)?;
        let slant = narrowed(((i64::from(spread) * SLANT) >> 16) + 1);
        let [long, short] = [spread, slant]
            .map(|length| [across, axis.crossed(across)].map(|it| it.nearest(length)));
        let corner = |at: u32| {
            let (one, other) = if at & 4 == 0 { (long[0], short[1]) } else { (short[0], long[1]) };
            let middle = center.to_vector();
            let middle = if at & 1 == 0 { middle.plus(one) } else { middle.minus(one) };
            Point::at(if at & 2 == 0 { middle.plus(other) } else { middle.minus(other) })
        };
        Some(Self {
            light: lamp.map(|place| place.point),
            center,
            radius,
            axis,
            distance,
            spread,
            corners: [0, 1, 2, 3, 4, 5, 6, 7].map(corner),
        })
    }

    /// Adds to a hull what the cone cuts out of a plane. Returns `None` if that has no end. Surfaces are lit `epsilon` above
    /// themselves.
    fn cut(&self, plane: &PreparedPlane, epsilon: Length, hull: &mut Hull) -> Option<()> {
        let height = |point: Point| plane.height(point) >> 30;
        let rate = i64::from(self.axis.dot(plane.normal).to_bits());
        // The light's side of the plane counts as above it.
        let above = self.light.map_or(-rate, height).signum();
        if above == 0 || above * height(self.center) < -i64::from(widened(self.radius)) {
            return Some(());
        }
        let (mut slope, mut is_parting) = (0, true);
        let cut = self.corners.map(|corner| {
            let low = above * height(corner);
            // The way to the plane is `low` / `whole` of the way that is added to the corner.
            let (way, whole) = match self.light {
                Some(light) => (light.to(corner), above * height(light) - low),
                None => (self.axis.nearest(1 << 24), rate.abs() >> 6),
            };
            let length = i64::from(square_root(way.square()));
            is_parting &= whole <= 0;
            slope = slope.max(if whole > 0 { length / whole } else { STEEP });
            let end = |from: i32, way: i32| i64::from(from) + i64::from(way) * low / whole.max(1);
            let Vector { x, y, z } = corner.to_vector();
            [end(x, way.x), end(y, way.y), end(z, way.z)]
        });
        if is_parting {
            return Some(());
        }
        let is_near = cut.iter().flatten().all(|it| it.abs() < FAR);
        if slope >= STEEP || !is_near {
            return None;
        }
        let margin = narrowed((i64::from(epsilon.to_bits()) * (slope + 2) + 64).min(FAR / 2));
        hull.radius = hull.radius.max(margin);
        let points = cut.map(|[x, y, z]| Point::new(narrowed(x), narrowed(y), narrowed(z)));
        hull.points.extend_from_slice(&points).ok()
    }

    /// Tests whether the shadow may reach a ball.
    fn reaches(&self, (center, radius): (Point, i32)) -> bool {
        let way = self.center.to(center);
        let along = way.dot(self.axis);
        let radius = widened(radius);
        if i64::from(along) + i64::from(radius) < -i64::from(widened(self.radius)) {
            return false;
        }
        let aside = i64::from(square_root(way.without(self.axis, along).square()));
        let spread = i64::from(self.spread);
        let wider = match i64::from(self.distance) {
            0 => 0,
            // The cone's radius grows by `spread` for each `distance`, and so does the margin around its wall.
            distance => (i64::from(along) + i64::from(radius)) * spread / distance.max(1),
        };
        aside <= spread + wider.max(0) + i64::from(radius) + 64
    }
}
