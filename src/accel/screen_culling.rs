//! What the rays of one row of pixels can meet: directly, and after the first mirroring plane.
//!
//! Bound: [`super::screen_bounds`]. Rays that a plane has mirrored are followed from the camera's image
//! in it; they differ from the plain ones by the rounding of that image, a few steps of the grid.

use super::World;
use super::active_list::Window;
use super::active_lists::ActiveLists;
use super::screen_bounds::ScreenBounds;
use crate::ray::{PathSignature, Ray, ScaledPoint};
use crate::scene::access::ShapeId;
use crate::scene::nearest::{Hit, NOWHERE, nearest_of};
use crate::scene::shape_set::ShapeSet;
use crate::shape::plane::PreparedPlane;
use crate::vector::Point;

/// What the rays of a row can meet.
pub(crate) struct ScreenCulling<'a, W: World> {
    /// What the shapes cover, if that is known.
    bounds: Option<&'a ScreenBounds<W::Room>>,
    /// Where the camera is, if it is near.
    camera: Option<Point>,
    y: u16,
    /// Whether every shape is asked in every column.
    is_full: bool,
    direct: ActiveLists<'a, W::Room>,
    /// The plane into which `mirrored` looks: that of the latest mirrored ray.
    plane: ShapeId,
    /// The shapes that rays can meet after that plane.
    mirrored: ActiveLists<'a, W::Room>,
}

impl<'a, W: World> ScreenCulling<'a, W> {
    /// Of the row `y`, below 2¹⁶, seen from the camera; every shape in every column where it `is_full`.
    /// `USED` is false where it is never asked.
    #[inline(always)]
    pub(crate) fn new<const USED: bool>(
        bounds: Option<&'a ScreenBounds<W::Room>>,
        from: ScaledPoint,
        y: u32,
        is_full: bool,
    ) -> Self {
        Self {
            bounds,
            camera: from.is_near().then_some(from.point),
            // `to_u16` would change what the compiler puts in line: `RayGenerator::row` asserts the range.
            y: (y & 0xffff) as u16,
            is_full,
            direct: ActiveLists::new::<USED>(from.point, is_full || !from.is_near()),
            plane: ShapeId::NONE,
            mirrored: ActiveLists::new::<USED>(Point::ORIGIN, true),
        }
    }

    /// Advances to the columns from `first` to `last`; `first` never decreases.
    #[inline(always)]
    pub(crate) fn advance(&mut self, world: &'a W, first: u32, last: u32) -> Window {
        let window = Window { first, last };
        if let (Some(bounds), true) = (self.bounds, world.parts().has_bounded()) {
            self.direct.advance(world, bounds.direct(), self.y, &window);
        }
        window
    }

    /// If no ray of a window meets anything, the column up to which it is known that none does; not known
    /// where there are planes.
    #[inline(always)]
    pub(crate) fn clear_until(&self, world: &W, window: &Window) -> Option<u32> {
        match world.parts().planes.is_empty() {
            true => self.direct.clear_until::<W>(window),
            false => None,
        }
    }

    /// The nearest bounded shape that a ray of the camera meets, through a column of the latest window.
    #[inline(always)]
    pub(crate) fn direct(
        &self,
        world: &W,
        column: u32,
        ray: &Ray,
        signature: &mut PathSignature,
    ) -> Hit {
        if self.camera.is_none() {
            return nearest_of(
                world,
                ShapeSet::ALL,
                (ray, NOWHERE),
                ShapeId::NONE,
                signature,
            );
        }
        let ray = (&ray.direction, NOWHERE);
        self.direct.nearest(world, column, ray, signature)
    }

    /// The nearest that such a ray meets once a plane has mirrored it.
    #[inline(always)]
    pub(crate) fn mirrored(
        &mut self,
        world: &'a W,
        (id, plane): (ShapeId, &PreparedPlane),
        (window, column): (&Window, u32),
        ray: &Ray,
        signature: &mut PathSignature,
    ) -> Hit {
        let index = world.parts().plane_index(id);
        let bounds = self.bounds.zip(index);
        let rects = bounds.and_then(|(bounds, index)| bounds.mirrored(index));
        let is_known = self.plane == id || self.look_into(world, id, plane).is_some();
        let (Some(rects), true) = (rects, is_known) else {
            // It is not known what is thin: no other ray has been alike.
            signature.note(column);
            return nearest_of(world, ShapeSet::ALL, (ray, NOWHERE), id, signature);
        };
        self.mirrored.advance(world, rects, self.y, window);
        let ray = (&ray.direction, self.mirrored.distance(ray));
        self.mirrored.nearest(world, column, ray, signature)
    }

    /// Turns to what the row's rays can meet once a plane has mirrored them; `None` where that is
    /// not known.
    #[inline(never)]
    fn look_into(&mut self, world: &W, id: ShapeId, plane: &PreparedPlane) -> Option<()> {
        let eye = plane.mirrored(self.camera?, world.parts().epsilon)?;
        self.plane = id;
        self.mirrored.restart(eye, self.is_full);
        Some(())
    }
}
