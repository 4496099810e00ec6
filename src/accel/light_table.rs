//! Which shapes lie in which direction from a light.
//!
//! 8 x 8 x 8 cells and 64 sets: 1 KB a light. A ball is widened by 2⁻¹² of its radius and 16 steps. A
//! cylinder's wall is a chain of balls.

use super::direction_table::{CellSets, DirectionTable};
use crate::scene::Parts;
use crate::scene::shape_set::{SetLayout, ShapeSet};
use crate::shape::cylinder::PreparedCylinder;
use crate::shape::sphere::PreparedSphere;
use crate::vector::Point;

/// The shapes around a light.
pub(crate) type LightTable = DirectionTable<8, 512, 64>;

impl LightTable {
    /// Of a light at a near point.
    pub(crate) const fn around(light: Point, parts: &Parts<'_>) -> Self {
        let layout = SetLayout::new(parts.lengths());
        let mut cells = CellSets::NONE;
        let mut index = 0;
        while index < parts.spheres.len() {
            let mut link = 0;
            while link < PreparedSphere::LINKS {
                let (center, radius) = parts.spheres[index].link(link);
                cells.add_ball(light.to(center), radius, ShapeSet::of(layout.bit(0, index)));
                link += 1;
            }
            index += 1;
        }
        index = 0;
        while index < parts.cylinders.len() {
            let mut link = 0;
            while link < PreparedCylinder::LINKS {
                let (center, radius) = parts.cylinders[index].link(link);
                cells.add_ball(light.to(center), radius, ShapeSet::of(layout.bit(1, index)));
                link += 1;
            }
            index += 1;
        }
        Self::of(&cells)
    }
}
