//! What the kernels read of a scene, wherever it lives, and how they name its shapes.

use super::needs::Needs;
use crate::color::Color;
use crate::grid::Grid;
use crate::light::PreparedLight;
use crate::material::PreparedMaterial;
use crate::number::{Brightness, Length, Unit, to_u32, unit_product};
use crate::ray::spread;
use crate::shape::MaterialId;
use crate::shape::bounded::Bounded;
use crate::shape::cylinder::PreparedCylinder;
use crate::shape::plane::PreparedPlane;
use crate::shape::sphere::PreparedSphere;
use crate::vector::{Direction, Point};

/// How many kinds of bounded shapes there are.
pub(crate) const KINDS: usize = 2;

/// What the kernels read from a scene.
#[derive(Clone, Copy, Debug)]
pub struct Parts<'a> {
    pub(crate) spheres: &'a [PreparedSphere],
    pub(crate) planes: &'a [PreparedPlane],
    pub(crate) cylinders: &'a [PreparedCylinder],
    pub(crate) lights: &'a [PreparedLight],
    pub(crate) materials: &'a [PreparedMaterial],
    pub(crate) background: Color,
    /// The largest component of any colour that a path can meet, [`Color::in_levels`]; rounded up.
    pub(crate) brightest: Brightness,
    /// One over the brightest, rounded down to 8 leading bits, and at most 1.
    pub(crate) dimness: Unit,
    /// Offset along the normal where rays that leave a surface start: at least 2 steps.
    pub(crate) epsilon: Length,
    /// The same inside of a sphere or cylinder: at least 8 steps, or 16 in a scene with cylinders.
    pub(crate) inner_epsilon: Length,
    pub(crate) grid: &'a Grid,
}

impl<'a> Parts<'a> {
    /// A material; black if there is none of that number.
    #[inline(always)]
    pub(crate) fn material(&self, material: MaterialId) -> &'a PreparedMaterial {
        const NONE: &PreparedMaterial = &PreparedMaterial::NONE;
        match self.materials {
            // So that the compiler knows which.
            [only] => only,
            several => several.get(material.index()).unwrap_or(NONE),
        }
    }

    /// The smallest weight with which a path can still change a channel by `change`, 0 to 1.
    pub(crate) const fn smallest_weight(&self, change: Unit) -> Unit {
        unit_product(change, self.dimness)
    }

    /// Whether there is nothing to be met.
    #[inline(always)]
    pub(crate) fn is_empty(&self) -> bool {
        !self.has_bounded() && self.planes.is_empty()
    }

    /// Whether there are spheres or cylinders.
    #[inline(always)]
    pub(crate) fn has_bounded(&self) -> bool {
        !(self.spheres.is_empty() && self.cylinders.is_empty())
    }

    /// How many bounded shapes there are.
    pub(crate) const fn count_bounded(&self) -> usize {
        self.spheres.len() + self.cylinders.len()
    }

    /// The material of the bounded shape that stands there among them, if there is one.
    pub(crate) const fn material_of(&self, index: usize) -> Option<MaterialId> {
        let mut first = 0;
        if index - first < self.spheres.len() {
            return Some(self.spheres[index - first].material);
        }
        first += self.spheres.len();
        if index - first < self.cylinders.len() {
            return Some(self.cylinders[index - first].material);
        }
        None
    }

    /// How many shapes of each bounded kind there are.
    #[inline(always)]
    pub(crate) const fn lengths(&self) -> [usize; KINDS] {
        [self.spheres.len(), self.cylinders.len()]
    }
}

/// A scene that the plain kernels can read.
pub trait SceneAccess {
    /// What it can need: what it does not is not linked.
    const NEEDS: Needs;

    /// Whether rays are given fewer candidates to hit than all shapes.
    const CHOOSES_HITS: bool;

    /// The scene's parts.
    fn parts(&self) -> Parts<'_>;
}

impl<W: SceneAccess> SceneAccess for &W {
    const NEEDS: Needs = W::NEEDS;
    const CHOOSES_HITS: bool = W::CHOOSES_HITS;

    #[inline(always)]
    fn parts(&self) -> Parts<'_> {
        (**self).parts()
    }
}

/// Names a shape of a scene, or none: bounded shapes in the order of their kinds, then planes.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct ShapeId(pub(super) u32);

impl ShapeId {
    /// No shape.
    pub(crate) const NONE: Self = Self(u32::MAX);

    /// Not known: further away than near rays look.
    pub(crate) const BEYOND: Self = Self(u32::MAX - 1);

    /// Names one side of it.
    pub(crate) const fn side(self, is_inside: bool) -> u32 {
        self.0 << 1 | is_inside as u32
    }

    /// What a path notes that passes it on one side and not on the other; spread, so that several
    /// together are told from others.
    #[inline(always)]
    pub(crate) const fn passed(self) -> u32 {
        spread(self.0 + 1)
    }

    /// Where it stands among all shapes.
    #[inline(always)]
    pub(crate) const fn index(self) -> usize {
        self.0 as usize
    }

    /// The shape that stands there among all shapes.
    #[inline(always)]
    pub(crate) const fn at(index: usize) -> Self {
        Self(to_u32(index))
    }
}

impl Parts<'_> {
    /// The number that the planes begin with.
    #[inline(always)]
    pub(super) fn first_plane(&self) -> u32 {
        to_u32(self.spheres.len() + self.cylinders.len())
    }

    /// Whether a shape is a plane.
    #[inline(always)]
    pub(crate) fn is_plane(&self, shape: ShapeId) -> bool {
        shape != ShapeId::NONE && shape.0 >= self.first_plane()
    }
}

impl<'a> Parts<'a> {
    /// The outward normal of a shape at a near point of it, and its material.
    #[inline(always)]
    pub(super) fn outside(&self, shape: ShapeId, at: Point) -> Option<(Direction, MaterialId)> {
        let index = shape.index();
        if let Some(sphere) = self.spheres.get(index) {
            return Some((sphere.normal(at), sphere.material()));
        }
        let index = index - self.spheres.len();
        if let Some(cylinder) = self.cylinders.get(index) {
            return Some((cylinder.normal(at), cylinder.material()));
        }
        let index = index - self.cylinders.len();
        let plane = self.planes.get(index)?;
        Some((plane.normal, plane.material))
    }

    /// The plane with a number, if it is one.
    #[inline(always)]
    pub(crate) fn plane(&self, shape: ShapeId) -> Option<&'a PreparedPlane> {
        self.planes.get(self.plane_index(shape)?)
    }

    /// Where a plane stands among the planes.
    #[inline(always)]
    pub(crate) fn plane_index(&self, shape: ShapeId) -> Option<usize> {
        shape
            .0
            .checked_sub(self.first_plane())
            .map(|it| it as usize)
    }
}
