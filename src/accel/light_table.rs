//! The bounded shapes in each direction from a light: a [`DirectionTable`] for each light.
//!
//! A table has 8 x 8 x 8 cells and at most 64 different sets: 1 KB a light. Bound: the radius of each
//! ball is widened by 2⁻¹² of it and 16 steps. A cylinder's wall is covered by a chain of balls.

use super::direction_table::{CellSets, DirectionTable};
use super::{CullingQuality, World};
use crate::light::PreparedLight;
use crate::scene::Parts;
use crate::scene::shape_set::{SetLayout, ShapeSet};
use crate::shape::bordered::Rays;
use crate::vector::{Direction, Point};

/// Table of the bounded shapes in each direction from one light.
pub type LightTable = DirectionTable<8, 512, 64>;

macro_rules! light_table {
    (
        $header:tt
        $({ $list:ident $kind:ident $described:ident $prepared:ident $($more:tt)* })*
    ) => {
        impl LightTable {
            /// Makes the table of a light at a near point.
            pub(crate) const fn around(light: Point, parts: &Parts<'_>) -> Self {
                let layout = SetLayout::new(parts.lengths());
                let mut cells = CellSets::NONE;
                let kind = 0;
                $(
                    let mut index = 0;
                    while index < parts.$list.len() {
                        let shape = ShapeSet::of(layout.bit(kind, index));
                        if parts.moving.meets(shape) {
                            cells.add_everywhere(shape);
                        }
                        let mut link = 0;
                        while link < crate::shape::$prepared::LINKS {
                            let (center, radius) = parts.$list[index].link(link);
                            cells.add_ball(light.to(center), radius, shape);
                            link += 1;
                        }
                        index += 1;
                    }
                    let kind = kind + 1;
                )*
                let _ = kind;
                Self::of(&cells)
            }
        }
    };
}
kinds!(light_table);

impl LightTable {
    /// Makes the table of a light. If the light is far, every direction holds every shape.
    pub(super) const fn of_light(light: &PreparedLight, parts: &Parts<'_>) -> Self {
        match light.place.is_near() {
            true => Self::around(light.place.point, parts),
            false => Self::ALL,
        }
    }

    /// Makes the tables of all lights of a scene, in their order. Unused places hold every shape.
    pub(super) const fn of_lights<const L: usize>(parts: &Parts<'_>) -> [Self; L] {
        let mut tables = [Self::ALL; L];
        let mut index = 0;
        while index < parts.lights.len() && index < L {
            tables[index] = Self::of_light(&parts.lights[index], parts);
            index += 1;
        }
        tables
    }
}

/// Returns the bounded shapes that rays from a light to a curve can hit, by the light's index. `bulge` is
/// that of the curve.
pub(super) fn rays_set<W: World, Q: CullingQuality>(
    world: &W,
    light: usize,
    rays: &Rays,
    bulge: i32,
) -> ShapeSet {
    let table = match W::NEEDS.sets && Q::CULLING.light_tables {
        true => world.tables().light_tables.get(light),
        false => None,
    };
    table.map_or(*ShapeSet::ALL, |table| {
        table.between(rays.ends, rays.widening(bulge))
    })
}

/// Returns the bounded shapes in a direction from a light, by the light's index. Returns all shapes if
/// the light has no table or `Q` does not use tables.
#[inline(always)]
pub(crate) fn light_set<W: World, Q: CullingQuality>(
    world: &W,
    light: usize,
    direction: Direction,
) -> &ShapeSet {
    let table = match W::NEEDS.sets && Q::CULLING.light_tables {
        true => world.tables().light_tables.get(light),
        false => None,
    };
    table.map_or(ShapeSet::ALL, |table| table.at(direction))
}

#[cfg(test)]
mod tests;
