//! Floor 5: the rays from a light to a ball and beyond it, and what they reach.

use super::Hull;
use crate::accel::screen_axis::widened;
use crate::light::PreparedLight;
use crate::number::{Length, narrowed, square_root, unsigned_wide, wide};
use crate::ray::ScaledPoint;
use crate::shape::plane::PreparedPlane;
use crate::vector::{Direction, Point, Vector};

/// Steps that a ray goes at most for each step that it comes nearer to a plane. Shadows along flatter rays have no end.
const SLOPE: i64 = 64;

/// Largest coordinate of a point of a shadow, in steps. A longer shadow counts as one without an end.
const FAR: i64 = 1 << 29;

/// The rays from a light to a ball, and beyond it.
pub(super) struct Cone {
    /// Place of the lamp; `None` if the light is a sun.
    light: Option<Point>,
    center: Point,
    radius: i32,
    /// Direction from the light to the ball's centre, and the distance.
    axis: Direction,
    distance: i32,
    /// Radius of the cone at the ball's centre.
    spread: i32,
    /// Corners of an octagon around the cone's circle at the ball's centre.
    corners: [Point; 8],
}

/// The tangent of 22.5 degrees in 1/65536, rounded up: an octagon around a circle has corners at 1 and this.
const SLANT: i64 = 27_147;

impl Cone {
    /// Creates the cone of a light around a ball. `None` if the light is a lamp that is far away, or in the ball.
    pub(super) fn new(light: &PreparedLight, (center, radius): (Point, i32)) -> Option<Self> {
        let (lamp, radius) = (
            light.sun().is_none().then_some(light.place),
            widened(radius),
        );
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

    /// Tests whether the ball lies beyond a plane, as seen from the light. Then no shadow falls on it.
    pub(super) fn is_beyond(&self, plane: &PreparedPlane) -> bool {
        let (side, height) = (self.side(plane), plane.height(self.center) >> 30);
        side == 0 || side * height < -i64::from(self.radius)
    }

    /// Returns the side of a plane on which the light is: 1 or -1; 0 if it lies in the plane.
    fn side(&self, plane: &PreparedPlane) -> i64 {
        let rate = i64::from(self.axis.dot(plane.normal).to_bits());
        self.light
            .map_or(-rate, |light| plane.height(light) >> 30)
            .signum()
    }

    /// Adds to a hull what the cone cuts out of a plane. Returns `None` if that has no end, and `Some(false)` if no ray of the
    /// cone comes near to the plane. Surfaces are lit `epsilon` above themselves.
    pub(super) fn cut(
        &self,
        plane: &PreparedPlane,
        epsilon: Length,
        hull: &mut Hull,
    ) -> Option<bool> {
        let height = |point: Point| plane.height(point) >> 30;
        let rate = i64::from(self.axis.dot(plane.normal).to_bits());
        // The light's side of the plane counts as above it.
        let above = self.side(plane);
        let lamp = self.light.map(|light| (light, above * height(light)));
        let (mut slope, mut is_parting) = (0, true);
        let cut = self.corners.map(|corner| {
            let low = above * height(corner);
            // The way to the plane is `low` / `whole` of the way that is added to the corner.
            let (way, whole) = match lamp {
                Some((light, high)) => (light.to(corner), high - low),
                None => (self.axis.nearest(1 << 24), rate.abs() >> 6),
            };
            let length = i64::from(square_root(way.square()));
            is_parting &= whole <= 0;
            slope = slope.max(if whole > 0 { length / whole } else { SLOPE });
            let end = |from: i32, way: i32| i64::from(from) + i64::from(way) * low / whole.max(1);
            let Vector { x, y, z } = corner.to_vector();
            [end(x, way.x), end(y, way.y), end(z, way.z)]
        });
        if is_parting {
            return Some(false);
        }
        let is_near = cut.iter().flatten().all(|it| it.abs() < FAR);
        if slope >= SLOPE || !is_near {
            return None;
        }
        // A corner is known to a few steps.
        let lift = i64::from(epsilon.to_bits()) + 4;
        let margin = narrowed((lift * (slope + 2) + 64).min(FAR / 2));
        hull.radius = hull.radius.max(margin);
        let points = cut.map(|[x, y, z]| Point::new(narrowed(x), narrowed(y), narrowed(z)));
        hull.points.extend_from_slice(&points).ok()?;
        Some(true)
    }

    /// Tests whether the shadow may reach a ball.
    pub(super) fn reaches(&self, (center, radius): (Point, i32)) -> bool {
        let way = self.center.to(center);
        let along = way.dot(self.axis);
        let radius = widened(radius);
        if i64::from(along) + i64::from(radius) < -i64::from(self.radius) {
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
