//! What the rays of one row of pixels can meet: first of all, and after the first mirror.

use super::World;
use super::extent::Outlooks;
use super::nearest::{NOWHERE, nearest_bounded};
use super::query::{Hit, ShapeId};
use super::row::{Cut, Row};
use crate::ray::{PathSignature, Ray, ScaledPoint};
use crate::shape::plane::PreparedPlane;
use crate::vector::Point;

/// What the rays of a row can meet.
pub(crate) struct ScreenCulling<'a, W: World> {
    /// What the shapes cover, if that is known.
    outlook: Option<&'a W::Outlook>,
    /// Where the camera is, if it is near.
    camera: Option<Point>,
    y: u16,
    /// The columns it has been turned to, the last one included.
    columns: (u32, u32),
    /// The column of the ray that is followed.
    pub(crate) column: u32,
    /// Whether shapes that cannot be met are left out.
    is_choosy: bool,
    first: Row<'a>,
    /// The plane that mirrored the latest ray of this row.
    plane: ShapeId,
    /// What can be met after it.
    mirrored: Row<'a>,
}

impl<'a, W: World> ScreenCulling<'a, W> {
    /// Of the row `y`, below 2¹⁶; `USED` unless nobody is going to ask.
    #[inline(always)]
    pub(crate) fn new<const USED: bool>(
        outlook: Option<&'a W::Outlook>,
        from: ScaledPoint,
        y: u32,
    ) -> Self {
        Self {
            is_choosy: true,
            // `to_u16` would change what the compiler puts in line: `RayGenerator::row` asserts the range.
            y: (y & 0xffff) as u16,
            ..Self::of_everything::<USED>(outlook, from)
        }
    }

    /// Of every shape in every column.
    #[inline(always)]
    pub(crate) fn of_everything<const USED: bool>(
        outlook: Option<&'a W::Outlook>,
        from: ScaledPoint,
    ) -> Self {
        Self {
            outlook,
            camera: from.is_near().then_some(from.point),
            y: 0,
            columns: (0, 0),
            column: 0,
            is_choosy: false,
            first: Row::of_everything::<USED>(from.point),
            plane: ShapeId::NONE,
            mirrored: Row::of_everything::<USED>(Point::ORIGIN),
        }
    }

    /// Finds out what the rays of the row can meet.
    #[inline(never)]
    pub(crate) fn look(&mut self) {
        if self.is_choosy && self.camera.is_some() {
            self.first.see();
        }
    }

    /// Turns to the rays of some columns, which do not begin before those it was turned to.
    #[inline(always)]
    pub(crate) fn turn_to(&mut self, world: &'a W, first: u32, last: u32) {
        let Some(outlook) = self.outlook else {
            return;
        };
        if !world.parts().has_bounded() {
            return;
        }
        self.columns = (first, last);
        let y = self.y;
        let cut = || Cut {
            covered: outlook.first().of(world),
            y,
        };
        self.first.turn_to(world, cut, self.columns);
    }

    /// If no ray of the columns it has been turned to meets anything, the column up to which it is
    /// known that none does; not known where there are planes.
    #[inline(always)]
    pub(crate) fn clear_until(&self, world: &W) -> Option<u32> {
        match world.parts().planes.is_empty() {
            true => self.first.clear_until::<W>(self.columns.0),
            false => None,
        }
    }

    /// What a ray of the camera meets first of the spheres and cylinders.
    #[inline(always)]
    pub(crate) fn first(&self, world: &W, ray: &Ray, signature: &mut PathSignature) -> Hit {
        if self.camera.is_none() {
            return nearest_bounded::<W, false>(world, ray, NOWHERE, ShapeId::NONE, signature);
        }
        let ray = (&ray.direction, NOWHERE);
        self.first.meet(world, self.column, ray, signature)
    }

    /// What such a ray meets first of them once a plane with a number has mirrored it.
    #[inline(always)]
    pub(crate) fn mirrored(
        &mut self,
        world: &'a W,
        (number, plane): (ShapeId, &PreparedPlane),
        ray: &Ray,
        signature: &mut PathSignature,
    ) -> Hit {
        let index = world.parts().plane_index(number);
        let covered = self.outlook.zip(index);
        let covered = covered.and_then(|(outlook, index)| outlook.mirrored(index));
        let is_known = self.plane == number || self.look_into(world, number, plane).is_some();
        let (Some(covered), true) = (covered, is_known) else {
            // It is not known what is thin: no other ray has been alike.
            signature.note(self.column);
            return nearest_bounded::<W, false>(world, ray, NOWHERE, number, signature);
        };
        let y = self.y;
        let cut = || Cut {
            covered: covered.of(world),
            y,
        };
        self.mirrored.turn_to(world, cut, self.columns);
        let ray = (&ray.direction, self.mirrored.distance(ray));
        self.mirrored.meet(world, self.column, ray, signature)
    }

    /// Turns to what the row's rays can meet once a plane has mirrored them; `None` where that is
    /// not known.
    #[inline(never)]
    fn look_into(&mut self, world: &W, number: ShapeId, plane: &PreparedPlane) -> Option<()> {
        let origin = plane.mirrored(self.camera?, world.parts().epsilon)?;
        self.plane = number;
        self.mirrored.look_from(origin);
        if self.is_choosy {
            self.mirrored.see();
        }
        Some(())
    }
}
