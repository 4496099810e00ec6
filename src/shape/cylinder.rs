//! Open finite cylinders without caps.
//!
//! The ray is looked at along the axis: in the plane across it the cylinder is a circle. The
//! direction across, d × axis, is worked out exactly and normalised, so a ray that runs almost
//! along the axis keeps all its bits (Cychosz and Waggenspack, "Intersecting a ray with a
//! cylinder", Graphics Gems IV).

use super::{MaterialId, Normaliser};
use crate::number::{Length, Number, reciprocal_root, scaled_by_unit, square_root, unit_shift};
use crate::ray::Ray;
use crate::vector::{Direction, Point, Position, Vector};

/// A cylinder as it is described.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub struct Cylinder {
    /// Its middle, half way up.
    pub center: Position,
    /// Its axis, of any length but zero.
    pub axis: Position,
    /// Its radius, greater than 0.
    pub radius: Number,
    /// Its height, greater than 0.
    pub height: Number,
    /// What it is made of.
    pub material: MaterialId,
}

impl Cylinder {
    pub(crate) const NONE: Self = Self {
        center: Position::ORIGIN,
        axis: Position::ORIGIN,
        radius: Number::ZERO,
        height: Number::ZERO,
        material: MaterialId(0),
    };
}

/// A cylinder as the kernels read it: inside the ball.
#[derive(Clone, Copy, Debug)]
pub struct PreparedCylinder {
    center: Point,
    axis: Direction,
    /// radius²
    square: i64,
    half_height: i32,
    /// At least the distance from the middle to the rim.
    bound: i32,
    normaliser: Normaliser,
    pub(crate) material: MaterialId,
}

impl PreparedCylinder {
    /// Fills the room of a cylinder that a scene's type allows but the scene does not use.
    pub(crate) const NONE: Self = Self::new(
        Point::ORIGIN,
        Direction::X,
        Length::from_bits(4),
        Length::from_bits(4),
        MaterialId(0),
    );

    /// A cylinder inside the ball with a radius of at least 4 steps.
    pub(crate) const fn new(
        center: Point,
        axis: Direction,
        radius: Length,
        half_height: Length,
        material: MaterialId,
    ) -> Self {
        let (raw, half) = (radius.to_bits(), half_height.to_bits());
        Self {
            center,
            axis,
            square: raw as i64 * raw as i64,
            half_height: half,
            bound: raw + half,
            normaliser: Normaliser::new(radius),
            material,
        }
    }

    /// Its middle, the way from there to one end, and its radius.
    pub(crate) const fn capsule(&self) -> (Point, Vector, i32) {
        let half = self.half_height;
        let [x, y, z] = self.axis.components();
        let half_axis = Vector::new(
            scaled_by_unit(half, x),
            scaled_by_unit(half, y),
            scaled_by_unit(half, z),
        );
        (self.center, half_axis, self.bound - half)
    }

    /// The distance at which the ray first meets the wall, from outside or from inside, above 0
    /// and below `reach`.
    pub(crate) fn intersect(&self, ray: &Ray, reach: Length) -> Option<Length> {
        let center = ray.origin.to(self.center);
        let along = center.dot(ray.direction);
        if along < -self.bound || along - self.bound > reach.to_bits() {
            return None;
        }
        // |across| = sin(ray, axis) · 2^(60 - shift)
        let (across, shift) = ray.direction.cross(self.axis)?;
        let (up, mantissa) = unit_shift(across.square());
        let root = reciprocal_root(mantissa);
        let across = Direction::lengthened(across, up, root);
        let sideways = i64::from(center.dot(across));
        let half_chord_square = self.square - sideways * sideways;
        if half_chord_square < 0 {
            return None;
        }
        let half_chord = i64::from(square_root(half_chord_square as u64));
        let ahead = i64::from(center.dot(self.axis.crossed(across)));
        let climb = ray.direction.dot(self.axis);
        let base = center.dot(self.axis);
        // Distances across the axis grow by 1 / sin(ray, axis) along the ray.
        let down = shift + 1 - up;
        [ahead - half_chord, ahead + half_chord]
            .into_iter()
            .find_map(|flat| {
                let distance = (flat * i64::from(root)) >> down;
                if distance <= 0 || distance >= i64::from(reach.to_bits()) {
                    return None;
                }
                let height = scaled_by_unit(distance as i32, climb) - base;
                (height.abs() <= self.half_height).then_some(Length::from_bits(distance as i32))
            })
    }

    /// Whether the ray meets the wall above 0 and below `reach`.
    pub(crate) fn blocks(&self, ray: &Ray, reach: Length) -> bool {
        self.intersect(ray, reach).is_some()
    }

    /// The outward normal at a point of the wall.
    pub(crate) const fn normal(&self, at: Point) -> Direction {
        let outward = self.center.to(at);
        self.normaliser
            .direction(outward.without(self.axis, outward.dot(self.axis)))
    }
}

#[cfg(test)]
mod tests;
