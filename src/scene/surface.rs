//! The surface at a hit: its normal, its material, and the point where rays leave it.

use super::access::{Parts, SceneAccess, ShapeId};
use crate::checker::PreparedChecker;
use crate::color::Color;
use crate::material::PreparedMaterial;
use crate::number::{
    Quotient, Unit, absolute, divide, narrowed, shifted, signed, signed_wide, unit_product,
    unsigned, wide_unsigned,
};
use crate::ray::{ScaledPoint, ScaledRay};
use crate::shape::MaterialId;
use crate::shape::bounded::Bounded;
use crate::shape::plane::PreparedPlane;
use crate::vector::{Direction, Point, Vector};

/// The surface at a hit: its normal, its material, and the point where rays leave it.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a> {
    /// Point where rays leave: epsilon above the surface, on the viewer's side.
    pub(crate) place: ScaledPoint,
    /// The normal on the viewer's side.
    pub(crate) normal: Direction,
    /// Direction of the ray that hit the surface.
    pub(crate) view: Direction,
    /// Cosine between the normal and the direction back to the viewer, 0 to 1.
    pub(crate) facing: Unit,
    /// The shape that was hit.
    pub(crate) shape: ShapeId,
    /// Whether the ray hit the surface from inside, or a plane against its normal.
    pub(crate) is_inside: bool,
    /// The shape that rays from here need not test: see [`Surface::skip`].
    left: ShapeId,
    material: &'a PreparedMaterial,
    /// Number of the material; only read in a scene with checkers.
    number: MaterialId,
}

/// Largest error of the cosine at a curved surface: 2⁻¹⁶, in Q4.28.
const RIM: i32 = 1 << 12;

impl<'a> Surface<'a> {
    /// Returns the surface of a shape at point `at`, hit along `view`; `None` if there is no such
    /// shape.
    #[inline(always)]
    pub(crate) fn new<W: SceneAccess>(
        world: &'a W,
        at: ScaledPoint,
        shape: ShapeId,
        view: Direction,
    ) -> Option<Self> {
        let parts = world.parts();
        let (outward, number) = parts.outside(shape, at.point)?;
        // In Q4.28.
        let climb = view.raw().quarter_dot(outward);
        // At the rim of a shape, rounding must not make the outside an inside.
        let (is_inside, left, epsilon) = match parts.bending_radius(shape) {
            None => (climb > 0, shape, parts.epsilon),
            Some(_) if climb > RIM => (true, ShapeId::NONE, parts.inner_epsilon),
            Some(_) => (false, shape, parts.epsilon),
        };
        let normal = outward.reversed_if(is_inside);
        let surface = Self {
            place: at.lifted(normal, epsilon),
            normal,
            view,
            // The cosine is at most 1.0001 in magnitude.
            facing: Unit::from_bits(absolute(climb) << 2),
            shape,
            is_inside,
            left,
            material: parts.material(number),
            number,
        };
        Some(if W::NEEDS.triangles { surface.bent(&parts, at.point) } else { surface })
    }

    /// Returns a plane, seen at right angles from one side: from behind if `is_inside`. Rays leave at `place`.
    pub(crate) fn flat(
        parts: &Parts<'a>,
        (plane, shape, is_inside): (&PreparedPlane, ShapeId, bool),
        place: ScaledPoint,
    ) -> Self {
        let normal = plane.normal.reversed_if(is_inside);
        Self {
            place,
            normal,
            view: normal.reversed(),
            facing: Unit::ONE,
            shape,
            is_inside,
            left: shape,
            material: parts.material(plane.material),
            number: plane.material,
        }
    }

    /// Returns the surface as seen along `view`, from its viewer's side.
    pub(crate) fn seen_along(self, view: Direction) -> Self {
        let facing = (-view.dot(self.normal)).max(Unit::ZERO);
        Self {
            view,
            facing,
            ..self
        }
    }

    /// Returns the surface with the normal of a smooth shape at a near point on it, if it has one.
    #[inline(always)]
    fn bent(self, parts: &Parts<'_>, at: Point) -> Self {
        match parts.bent(self.shape, at, (self.normal, self.view)) {
            None => self,
            Some(normal) => Self {
                normal,
                facing: (-self.view.dot(normal)).max(Unit::ZERO),
                ..self
            },
        }
    }

    /// Returns the material of the surface. It is a constant if the scene is constant and has one
    /// material.
    #[inline(always)]
    pub(crate) fn material<W: SceneAccess>(&self, world: &'a W) -> &'a PreparedMaterial {
        match world.parts().materials {
            [only] => only,
            _ => self.material,
        }
    }

    /// If the material has a checker of more than one cell, returns whether the surface lies in a cell of the checker's
    /// colour, and that colour.
    #[inline(always)]
    pub(crate) fn cell<W: SceneAccess>(&self, world: &W) -> Option<(bool, Color)> {
        if !W::NEEDS.checkers {
            return None;
        }
        let checker = world.parts().checker(self.number)?;
        checker
            .has_cells()
            .then(|| (checker.holds(self.place), checker.color))
    }

    /// Returns the shape that rays from this point need not test: the surface's own. Returns
    /// [`ShapeId::NONE`] if a ray can hit the shape again, from inside of one that is not flat.
    #[inline(always)]
    pub(crate) fn skip<W: SceneAccess>(&self, world: &W) -> ShapeId {
        // A light may shine from behind on a surface with other normals than its own.
        let is_smooth = W::NEEDS.triangles && world.parts().is_smooth(self.shape);
        if is_smooth { ShapeId::NONE } else { self.left }
    }

    /// Replaces a ray that hit the surface by the mirrored ray.
    #[inline(never)]
    pub(crate) fn reflect<W: SceneAccess>(&self, world: &W, path: &mut ScaledRay) {
        let parts = world.parts();
        let cosine = -self.facing;
        let direction = match parts.planes {
            // More than one plane takes longer to tell apart than to reflect.
            [only] if W::NEEDS.plane_mirrors && parts.is_plane(self.shape) => {
                only.reflected(self.view, self.normal, cosine)
            }
            _ => self.view.reflected(self.normal, cosine),
        };
        // A curved surface's normal differs from length one by up to 2⁻¹⁶, or 2⁻¹⁴ far away. The
        // mirrored direction is off by four times as much, so it is normalised again.
        let direction = match parts.bending_radius(self.shape) {
            None => direction,
            Some(_) => direction.quickly_renormalised(),
        };
        *path = ScaledRay::new(self.place, direction);
    }
}

/// Largest angle over which a normal is known to turn: a quarter, about 14 degrees.
const MOST: Unit = Unit::from_bits(1 << 28);

/// How the normal of a surface turns.
pub(crate) struct Bend {
    /// 2⁶¹ over the radius on which it turns; 0 if the surface is flat.
    curve: Quotient,
    /// The direction along which it does not turn.
    axis: Option<Direction>,
    /// Whether it turns backwards.
    is_hollow: bool,
}

impl Bend {
    /// Returns the angle by which the normal turns `across` a ray, over `size` steps of 2^`scale`. `None` if that is more
    /// than [`MOST`].
    pub(crate) fn over(&self, across: Direction, (size, scale): (i32, u32)) -> Option<Unit> {
        let Quotient { mantissa, exponent } = self.curve;
        let turn = signed_wide(wide_unsigned(size.unsigned_abs(), mantissa) >> 1);
        let turn = shifted(turn, (exponent + signed(scale) - 30).clamp(-63, 0));
        if turn > i64::from(MOST.to_bits()) {
            return None;
        }
        let turn = Unit::from_bits(narrowed(turn));
        let turn = if (size < 0) == self.is_hollow { turn } else { -turn };
        Some(match self.axis {
            None => turn,
            Some(axis) => {
                let along = across.dot(axis);
                unit_product(turn, Unit::ONE - unit_product(along, along))
            }
        })
    }
}

impl<'a> Parts<'a> {
    /// Returns the capsule around a bounded shape: its middle, half of its axis, and its radius.
    pub(crate) fn outline(&self, shape: ShapeId) -> Option<(Point, Vector, i32)> {
        of_kind!(self, shape, |it| it.outline())
    }

    /// Returns the outward normal of a shape at a near point on it, and the shape's material.
    #[inline(always)]
    pub(crate) fn outside(&self, shape: ShapeId, at: Point) -> Option<(Direction, MaterialId)> {
        let plane = || {
            let plane = self.planes.get(shape.index() - self.bounded())?;
            Some((plane.normal, plane.material))
        };
        of_kind!(self, shape, |it| (it.normal(at), it.material)).or_else(plane)
    }

    /// Returns the normal with which a point of a flat shape is shaded, if that is not `flat`, the shape's own
    /// normal on the viewer's side.
    #[inline(always)]
    fn bent(
        &self,
        shape: ShapeId,
        at: Point,
        (flat, view): (Direction, Direction),
    ) -> Option<Direction> {
        of_kind!(self, shape, |it| it.bent(at, flat, view)).flatten()
    }

    /// Tests whether a flat shape is shaded with other normals than its own.
    #[inline(always)]
    pub(crate) fn is_smooth(&self, shape: ShapeId) -> bool {
        of_kind!(self, shape, |it| it.is_smooth()).unwrap_or(false)
    }

    /// Returns the radius on which the normals of a shape turn, in steps. `None` if it is flat.
    #[inline(always)]
    pub(crate) fn bending_radius(&self, shape: ShapeId) -> Option<i32> {
        fn radius<K: Bounded>(shape: &K) -> Option<i32> {
            let (_, _, radius) = shape.outline();
            (!K::IS_FLAT).then_some(radius)
        }
        of_kind!(self, shape, |it| radius(it)).flatten()
    }

    /// Returns how the normal of a surface turns; `None` if that is not known.
    pub(crate) fn bend(&self, surface: &Surface<'_>) -> Option<Bend> {
        if self.is_smooth(surface.shape) {
            return None;
        }
        let curve = match self.bending_radius(surface.shape) {
            None => Quotient {
                mantissa: 0,
                exponent: 0,
            },
            Some(radius) => divide(1 << 61, unsigned(radius)),
        };
        let axis = self.outline(surface.shape).map_or(Vector::ZERO, |it| it.1);
        Some(Bend {
            curve,
            axis: (axis != Vector::ZERO).then(|| axis.normalised().0),
            is_hollow: surface.is_inside,
        })
    }

    /// Returns the material of a shape.
    #[inline(always)]
    pub(crate) fn material_of(&self, shape: ShapeId) -> Option<MaterialId> {
        let plane = || self.plane(shape).map(|it| it.material);
        of_kind!(self, shape, |it| it.material).or_else(plane)
    }

    /// Returns the checker of a material, as [`checker_of`] does.
    #[inline(always)]
    fn checker(&self, id: MaterialId) -> Option<&'a PreparedChecker> {
        let is_seen = self.material(id).mirror < Unit::ONE;
        self.checkers.get(id.index()).filter(|_| is_seen)
    }
}

/// Returns the checker of a shape's material; that of a material without one is a single cell. `None` for a
/// perfect mirror, which has no colour of its own.
pub(crate) fn checker_of<W: SceneAccess>(world: &W, shape: ShapeId) -> Option<&PreparedChecker> {
    let parts = world.parts();
    parts.checker(parts.material_of(shape)?)
}
