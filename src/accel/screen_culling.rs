//! The candidates for the rays of one row of pixels: for rays of the camera, and for their first
//! reflection in a plane.
//!
//! Bound: [`super::screen_bounds`]. Rays that a plane has mirrored are followed from the camera's image
//! in the plane. They differ from the plain rays by the rounding of that image, a few steps of the
//! grid.

use super::World;
use super::active_list::Window;
use super::active_lists::ActiveLists;
use super::beside::{Beside, Part};
use super::screen_bounds::ScreenBounds;
use super::stretch::Stretch;
use crate::number::to_u16;
use crate::ray::{Ray, RowPlane, ScaledPoint};
use crate::scene::access::ShapeId;
use crate::scene::nearest::{Hit, NOWHERE, nearest_listed, nearest_of};
use crate::shape::plane::PreparedPlane;
use crate::vector::{Direction, Point};

/// The active lists of one row: for the camera's rays, and for rays that a plane has mirrored.
pub(crate) struct ScreenCulling<'a, W: World> {
    /// The rectangles that the shapes cover, if they are known.
    bounds: Option<&'a ScreenBounds<W::Room>>,
    /// Position of the camera, `None` if it is far.
    camera: Option<Point>,
    /// The row, counted from the top.
    y: u16,
    /// Whether the rays of all columns test every shape.
    is_full: bool,
    /// The active list of the camera's rays.
    direct: ActiveLists<'a, W::Room>,
    /// The plane that mirrors the rays of the second list: that of the latest mirrored ray.
    plane: ShapeId,
    /// The active list of rays that the latest plane has mirrored.
    mirrored: ActiveLists<'a, W::Room>,
}

impl<'a, W: World> ScreenCulling<'a, W> {
    /// Makes the culling of row `y`, below 2¹⁶, for rays from a camera at `from`.
    ///
    /// If `is_full`, the rays of all columns test every shape. If the culling is never used, `USED` is
    /// false.
    #[inline(always)]
    pub(crate) fn new<const USED: bool>(
        bounds: Option<&'a ScreenBounds<W::Room>>,
        (from, row): (ScaledPoint, RowPlane),
        y: u32,
        is_full: bool,
    ) -> Self {
        Self {
            bounds,
            camera: from.is_near().then_some(from.point),
            // `to_u16` would change what the compiler inlines. `RayGenerator::row` asserts the range.
            y: (y & 0xffff) as u16,
            is_full,
            direct: ActiveLists::new::<USED>((from.point, row), is_full || !from.is_near()),
            plane: ShapeId::NONE,
            mirrored: ActiveLists::new::<USED>((Point::ORIGIN, row), true),
        }
    }

    /// Goes back to the first column, for rays of the camera through row `y` that lie in another plane.
    pub(crate) fn turn(&mut self, y: u32, row: RowPlane) {
        self.y = to_u16(y);
        if let Some(camera) = self.camera {
            self.direct.restart((camera, row), self.is_full);
        }
        self.plane = ShapeId::NONE;
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

    /// Returns the column before which no ray of the row hits a shape, if no ray of the window hits
    /// one. Returns `None` if one may hit a shape, or if the scene has planes.
    #[inline(always)]
    pub(crate) fn clear_until(&self, world: &W, window: &Window) -> Option<u32> {
        let is_open = world.parts().planes.is_empty();
        is_open.then(|| self.direct.clear_until::<W>(window))?
    }

    /// Returns the nearest bounded shape that a ray of the camera hits. The ray goes through a column
    /// of the latest window.
    #[inline(always)]
    pub(crate) fn direct(&self, world: &W, column: u32, ray: &Ray) -> Hit {
        if self.camera.is_none() {
            return nearest_of(world, (ray, NOWHERE), ShapeId::NONE);
        }
        self.direct
            .nearest(world, column, (&ray.direction, NOWHERE))
    }

    /// Returns the nearest bounded shape that a ray of the camera hits after its first reflection in a
    /// plane.
    ///
    /// `ray` is the mirrored ray; `column` is the column of the camera's ray and lies in `window`.
    #[inline(always)]
    pub(crate) fn mirrored(
        &mut self,
        world: &'a W,
        (id, plane): (ShapeId, &PreparedPlane),
        (window, column): (&Window, u32),
        ray: &Ray,
    ) -> Hit {
        if !self.has_mirrored(world, (id, plane), window) {
            return nearest_of(world, (ray, NOWHERE), id);
        }
        let ray = (&ray.direction, self.mirrored.distance(ray));
        self.mirrored.nearest(world, column, ray)
    }

    /// Returns the nearest bounded shape that a ray hits. The ray is the camera's, through a place beside the centre of
    /// the pixel at `column`, or its first reflection in the plane `mirror`. `known` keeps what the rays can hit.
    pub(crate) fn beside(
        &self,
        world: &W,
        known: &mut Beside,
        (mirror, column): (ShapeId, u32),
        ray: &Ray,
    ) -> Hit {
        let rects = self.bounds.and_then(|bounds| match mirror {
            ShapeId::NONE => Some(bounds.direct()),
            _ => bounds.mirrored(world.parts().plane_index(mirror)?),
        });
        match rects.filter(|_| self.camera.is_some()) {
            Some(rects) => {
                let set = known.of(world, rects, Part::of(mirror, column, self.y));
                nearest_listed(world, &set, ray, mirror)
            }
            None => nearest_of(world, (ray, NOWHERE), mirror),
        }
    }

    /// Makes the second list that of a plane and advances it to a window. Returns whether that is possible.
    #[inline(always)]
    fn has_mirrored(
        &mut self,
        world: &'a W,
        (id, plane): (ShapeId, &PreparedPlane),
        window: &Window,
    ) -> bool {
        if !W::NEEDS.plane_mirrors {
            return false;
        }
        let index = world.parts().plane_index(id);
        let bounds = self.bounds.zip(index);
        let rects = bounds.and_then(|(bounds, index)| bounds.mirrored(index));
        let is_known = self.plane == id || self.look_into(world, id, plane).is_some();
        let (Some(rects), true) = (rects, is_known) else {
            return false;
        };
        self.mirrored.advance(world, rects, self.y, window);
        true
    }

    /// Tests whether all rays of a stretch surely hit what its ends hit: rays of the camera, or their first
    /// reflection in a plane. The stretch lies in `window`. If another shape may come to the front, returns where it
    /// begins or ends, as far as that is known.
    pub(crate) fn keeps(
        &mut self,
        world: &'a W,
        mirror: Option<(ShapeId, &PreparedPlane)>,
        window: &Window,
        stretch: &Stretch<'_>,
    ) -> Result<(), Option<u32>> {
        if !world.parts().has_bounded() {
            return Ok(());
        }
        if W::NEEDS.planes && !stretch.is_before(world.parts().planes) {
            return Err(None);
        }
        match mirror {
            None if self.bounds.is_none() => Err(None),
            None => self.direct.keep::<W>(world, stretch),
            Some((id, plane)) => {
                if self.has_mirrored(world, (id, plane), window) {
                    self.mirrored.keep::<W>(world, stretch)
                } else {
                    Err(None)
                }
            }
        }
    }

    /// Returns the last column before a border between two columns of a window, of which one shows the first shape and
    /// the other the second. The second shape begins there, or else the first one ends. `None` if neither does.
    pub(crate) fn border(
        &mut self,
        world: &'a W,
        mirror: Option<(ShapeId, &PreparedPlane)>,
        (window, columns): (&Window, [u32; 2]),
        shapes: [ShapeId; 2],
    ) -> Option<u32> {
        match mirror {
            None => self.direct.border(world, columns, shapes),
            Some(mirror) => {
                if self.has_mirrored(world, mirror, window) {
                    self.mirrored.border(world, columns, shapes)
                } else {
                    None
                }
            }
        }
    }

    /// Returns the camera, and the normal of the plane in which the row's rays lie. `None` if the camera is
    /// far.
    pub(crate) fn eye(&self) -> Option<(Point, Direction)> {
        Some((self.camera?, self.direct.row.normal))
    }

    /// Returns the camera, and the direction ahead, to the middle of the row. `None` if the camera is far.
    pub(crate) fn ahead(&self) -> Option<(Point, Direction)> {
        Some((self.camera?, self.direct.row.axis.ahead))
    }

    /// Prepares the active list for rays mirrored in another plane. Returns `None` if the camera or its
    /// image in the plane is far.
    #[inline(never)]
    fn look_into(&mut self, world: &W, id: ShapeId, plane: &PreparedPlane) -> Option<()> {
        let eye = plane.mirrored(self.camera?, world.parts().epsilon)?;
        self.plane = id;
        let row = self.direct.row.mirrored(plane.normal);
        self.mirrored.restart((eye, row), self.is_full);
        Some(())
    }
}
