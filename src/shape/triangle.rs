//! Triangles, which are visible from both sides: flat, or with normals at their corners.
//!
//! Whether a ray passes a side is the sign of an integer. It is exact, so a ray between two triangles that share a
//! side hits at least one of them. The distance is known to about two steps, as for a disc.

mod borders;
mod crossing;
mod described;
mod smooth;

use described::larger;
pub use described::{Corners, Normals, Triangle};

use super::bounded::{Bounded, LightRay, Own, Range};
use super::flat::FlatFromPoint;
use super::{MaterialId, SMALLEST};
use crate::error_kind::ErrorKind;
use crate::grid::Grid;
use crate::number::{Length, square_root, unsigned};
use crate::ray::Ray;
use crate::vector::{Direction, Point, Vector};
use smooth::Smooth;

/// Triangle as the kernels read it: in raw steps, inside the ball that holds all bounded shapes.
#[derive(Clone, Copy, Debug)]
pub struct PreparedTriangle {
    /// First corner.
    corner: Point,
    /// Vectors from the first corner to the second and to the third.
    sides: [Vector; 2],
    /// Direction of the cross product of `sides`.
    normal: Direction,
    center: Point,
    radius: i32,
    smooth: Option<Smooth>,
    pub(crate) material: MaterialId,
}

/// Enlargement of the ball around a triangle, in steps: its centre and its radius are rounded.
const RIM: i32 = 4;

/// The plane of a triangle whose sides are lifted: shifted to the left until the largest coordinate has 29 bits.
struct Face {
    lifted: [Vector; 2],
    lifts: [u32; 2],
    normal: Direction,
    /// Length of the cross product of the lifted sides: `area` · 2^`shift`.
    area: i32,
    shift: u32,
}

impl Face {
    const fn new(sides: [Vector; 2]) -> Self {
        let lifts = [lift(sides[0]), lift(sides[1])];
        let lifted = [sides[0].lifted(lifts[0]), sides[1].lifted(lifts[1])];
        let (crossed, shift) = Vector::leading(lifted[0].cross_wide(lifted[1]), 29);
        Self {
            lifted,
            lifts,
            normal: crossed.precise_direction(),
            area: square_root(crossed.square()),
            shift,
        }
    }

    /// Returns the smallest altitude of the triangle, in steps, rounded down. `longest` is its longest side.
    const fn altitude(&self, longest: u32) -> u64 {
        let area = (unsigned(self.area) as u64) << self.shift;
        (area / (longest | 1) as u64) >> (self.lifts[0] + self.lifts[1])
    }
}

/// Returns the left shift after which the largest coordinate of a vector has 29 bits, or 30 with its sign.
const fn lift(vector: Vector) -> u32 {
    let bits = vector.x.unsigned_abs() | vector.y.unsigned_abs() | vector.z.unsigned_abs();
    let zeros = bits.leading_zeros();
    if zeros < 3 || zeros > 31 { 0 } else { zeros - 3 }
}

impl PreparedTriangle {
    /// Placeholder for an unused slot: a scene's type may allow more triangles than the scene has.
    pub(crate) const NONE: Self = Self {
        corner: Point::ORIGIN,
        sides: [Vector::ZERO; 2],
        normal: Direction::X,
        center: Point::ORIGIN,
        radius: RIM,
        smooth: None,
        material: MaterialId(0),
    };

    /// Placeholder for an unused slot in a light's list of triangles.
    pub(crate) const NOT_SEEN: FlatFromPoint = FlatFromPoint::NONE;

    /// Smallest epsilon of a ray that leaves a triangle, in steps. A triangle has no inside, so this is the
    /// smallest epsilon of any surface.
    pub(crate) const SMALLEST_INSIDE: i32 = 2;

    /// Number of balls that together cover a triangle.
    pub(crate) const LINKS: usize = 1;

    /// Returns centre and radius, in steps, of the ball that covers the triangle.
    pub(crate) const fn link(&self, _: usize) -> (Point, i32) {
        self.ball()
    }

    /// Converts a checked triangle to steps of the scene's grid. Fails with [`ErrorKind::Tiny`] if an altitude is
    /// below [`SMALLEST`] steps.
    pub(crate) const fn prepare(triangle: &Triangle, grid: &Grid) -> Result<Self, ErrorKind> {
        let [one, two, three] = triangle.corners.positions();
        let corner = grid.place(one).point;
        let sides = [
            corner.to(grid.place(two).point),
            corner.to(grid.place(three).point),
        ];
        let face = Face::new(sides);
        if face.altitude(longest(sides)) < unsigned(SMALLEST) as u64 {
            return Err(ErrorKind::Tiny);
        }
        let extent = triangle.extent();
        Ok(Self {
            corner,
            sides,
            normal: face.normal,
            center: grid.place(extent.center).point,
            radius: grid.length(extent.radius).to_bits() + RIM,
            smooth: match triangle.normals.0 {
                Some(normals) => Smooth::new(&face, normals),
                None => None,
            },
            material: triangle.material,
        })
    }

    /// Returns centre and radius, in steps, of a ball around the triangle.
    #[inline(always)]
    pub(crate) const fn ball(&self) -> (Point, i32) {
        (self.center, self.radius)
    }

    /// Returns the triangle unchanged. Its tests do not depend on whether it touches another shape.
    pub(crate) const fn touching(self, _: bool) -> Self {
        self
    }

    /// Prepares the tests of rays from a near point against the triangle.
    pub(crate) const fn seen_from(&self, point: Point) -> FlatFromPoint {
        FlatFromPoint::new(point, self.corner, self.normal)
    }

    /// Prepares the tests of rays from a light at a near point against the triangle.
    pub(crate) const fn seen_from_light(&self, light: Point) -> FlatFromPoint {
        self.seen_from(light)
    }
}

/// Returns the length of the longest side, in steps, at least 1.
const fn longest(sides: [Vector; 2]) -> u32 {
    let third = sides[1].minus(sides[0]);
    let squares = [sides[0].square(), sides[1].square(), third.square()];
    let square = larger(squares[0], larger(squares[1], squares[2]));
    unsigned(square_root(square)) | 1
}

impl Bounded for PreparedTriangle {
    type FromPoint = FlatFromPoint;
    type FromLight = FlatFromPoint;

    const IS_BALL: bool = false;
    const IS_FLAT: bool = true;

    fn outline(&self) -> (Point, Vector, i32) {
        (self.center, Vector::ZERO, self.radius)
    }

    fn seen_from_eye(&self, eye: Point) -> FlatFromPoint {
        self.seen_from(eye)
    }

    #[inline(always)]
    fn intersect(&self, ray: &Ray, range: Range) -> Option<Length> {
        let way = ray.origin.to(self.center);
        if way.passes_by(ray.direction, self.radius) {
            None
        } else {
            self.met(&self.seen_from(ray.origin), &ray.direction, range)
        }
    }

    #[inline(always)]
    fn intersect_from(
        &self,
        from: &FlatFromPoint,
        direction: &Direction,
        range: Range,
    ) -> Option<Length> {
        self.met(from, direction, range)
    }

    #[inline(always)]
    fn occludes<const PRECISE: bool>(
        &self,
        from: &FlatFromPoint,
        ray: &LightRay,
        own: Own,
    ) -> bool {
        let is_tested = own == Own::No || self.is_smooth();
        // A copy, as for cylinders.
        let direction = ray.direction;
        is_tested && self.met(from, &direction, ray.range()).is_some()
    }

    #[inline(always)]
    fn normal(&self, _: Point) -> Direction {
        self.normal
    }

    fn bent(&self, at: Point, flat: Direction, view: Direction) -> Option<Direction> {
        let smooth = self.smooth.as_ref()?;
        Some(smooth.bent(self.corner.to(at), flat, view))
    }

    fn is_smooth(&self) -> bool {
        self.smooth.is_some()
    }
}

#[cfg(test)]
mod tests;
