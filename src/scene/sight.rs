//! What the rays of one row of pixels can meet: first of all, and after the first mirror.

use super::World;
use super::mask::Mask;
use super::row::Row;
use crate::ray::Fan;
use crate::shape::plane::PreparedPlane;

/// What the rays of a row can meet.
pub(crate) struct Sight<'a> {
    /// The row's rays; none where there is nothing to tell apart or the camera is far away.
    fan: Option<Fan>,
    first: Row,
    /// The plane that mirrored the latest ray of this row.
    plane: Option<&'a PreparedPlane>,
    /// What can be met after it.
    mirrored: Row,
}

impl<'a> Sight<'a> {
    /// Of a fan; without one, everything.
    pub(crate) fn new<W: World>(world: &W, fan: Option<Fan>) -> Self {
        let mut sight = Self {
            fan,
            first: Row::ALL,
            plane: None,
            mirrored: Row::ALL,
        };
        if let Some(fan) = &sight.fan {
            sight.first.see(world, fan);
        }
        sight
    }

    /// What the ray of a column can meet.
    pub(crate) fn first(&mut self, column: u32) -> Mask {
        self.first.at(column)
    }

    /// What the ray of a column can meet once `plane` has mirrored it.
    pub(crate) fn mirrored<W: World>(
        &mut self,
        world: &W,
        plane: &'a PreparedPlane,
        column: u32,
    ) -> Mask {
        let is_known = self.plane.is_some_and(|known| core::ptr::eq(known, plane));
        if let (Some(fan), false) = (&self.fan, is_known) {
            self.plane = Some(plane);
            self.mirrored.see_mirrored(world, fan, plane);
        }
        self.mirrored.at(column)
    }
}
