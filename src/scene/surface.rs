//! The surface that a ray hits: its normal, its material, and where rays leave it.

use super::access::{SceneAccess, ShapeId};
use crate::material::PreparedMaterial;
use crate::number::{Unit, absolute};
use crate::ray::{ScaledPoint, ScaledRay};
use crate::vector::Direction;

/// A point on a surface, seen along a ray, from which rays may leave.
#[derive(Clone, Copy, Debug)]
pub struct Surface<'a> {
    /// Where rays leave: epsilon above the surface, on the side of the viewer.
    pub(crate) place: ScaledPoint,
    /// The normal on the side of the viewer.
    pub(crate) normal: Direction,
    /// The direction the surface was seen along.
    pub(crate) view: Direction,
    /// The cosine between the normal and the way back to the viewer, 0 to 1.
    pub(crate) facing: Unit,
    /// The shape it belongs to.
    pub(crate) shape: ShapeId,
    /// Whether it is seen from the inside, or against a plane's normal.
    pub(crate) is_inside: bool,
    material: &'a PreparedMaterial,
}

/// How far the cosine at a curved surface may be wrong: 2⁻¹⁶.
const RIM: Unit = Unit::from_bits(1 << 14);

impl<'a> Surface<'a> {
    /// The surface of a shape at a place that was seen along `view`; `None` where there is no such
    /// shape.
    #[inline(always)]
    pub(crate) fn new<W: SceneAccess>(
        world: &'a W,
        at: ScaledPoint,
        shape: ShapeId,
        view: Direction,
    ) -> Option<Self> {
        let parts = world.parts();
        let (outward, material) = parts.outside(shape, at.point)?;
        let climb = view.short_dot(outward);
        // At the rim of a shape rounding must not turn its outside into its inside.
        let (is_inside, epsilon) = match parts.is_flat(shape) {
            true => (climb > Unit::ZERO, parts.epsilon),
            false if climb > RIM => (true, parts.inner_epsilon),
            false => (false, parts.epsilon),
        };
        let normal = outward.reversed_if(is_inside);
        Some(Self {
            place: at.lifted(normal, epsilon),
            normal,
            view,
            // Within ±1.0001.
            facing: Unit::from_bits(absolute(climb.to_bits())),
            shape,
            is_inside,
            material: parts.material(material),
        })
    }

    /// What it is made of: a constant in a constant scene of one material.
    #[inline(always)]
    pub(crate) fn material<W: SceneAccess>(&self, world: &'a W) -> &'a PreparedMaterial {
        match world.parts().materials {
            [only] => only,
            _ => self.material,
        }
    }

    /// The shape, unless a ray that leaves it here can hit it again: from inside of one that is not flat.
    #[inline(always)]
    pub(crate) fn skip<W: SceneAccess>(&self, world: &W) -> ShapeId {
        match self.is_inside && !world.parts().is_flat(self.shape) {
            true => ShapeId::NONE,
            false => self.shape,
        }
    }

    /// Turns a path that met the surface into the mirrored one.
    #[inline(never)]
    pub(crate) fn reflect<W: SceneAccess>(&self, world: &W, path: &mut ScaledRay) {
        let cosine = Unit::from_bits(-self.facing.to_bits());
        let direction = self.view.reflected(self.normal, cosine);
        // A curved surface's normal has a length of one but for 2⁻¹⁶, or 2⁻¹⁴ far away; four times as
        // much is what the direction's is off by.
        let direction = match world.parts().is_flat(self.shape) {
            true => direction,
            false => direction.renormalised(),
        };
        *path = ScaledRay::new(self.place, direction);
    }
}
