//! The shadows of a light on a plane, as a row shows them: the columns at which one begins or ends.
//!
//! A row shows a line of a plane. The line and a light span a plane, which cuts each body. Two rays of the
//! light touch that cut; where they meet the line, and where the body itself cuts it, a shadow begins or ends.
//! Bound: docs/internals/edges.md derives the error of each border.

use super::{LONGEST_BLOCK, World};
use crate::number::Length;
use crate::ray::{Borders, Cut, RowPlane, ScaledPoint, Shadows};
use crate::scene::access::ShapeId;
use crate::shape::bordered::{Bordered, CastsShadow};
use crate::shape::plane::{PreparedPlane, Side};
use crate::vector::{Point, Vector};

/// The rays of a row from one eye: the camera, or its image in one plane after another.
#[derive(Clone, Copy)]
pub(crate) struct Pencil {
    pub(crate) eye: Point,
    pub(crate) row: RowPlane,
}

impl Pencil {
    /// Returns the rays after a plane has mirrored them, `None` if the image of the eye is far.
    pub(crate) fn mirrored(&self, plane: &PreparedPlane, epsilon: Length) -> Option<Self> {
        Some(Self {
            eye: plane.mirrored(self.eye, epsilon)?,
            row: self.row.mirrored(plane.normal),
        })
    }
}

/// The rays of a row, a plane that they meet, and the position of a light.
pub(crate) type Shadow<'a> = (&'a Pencil, &'a PreparedPlane, ScaledPoint);

/// Returns the borders of the shadows of a light on a plane, from a column on. No plane hides the light.
pub(crate) fn borders_from<W: World>(
    column: u32,
    world: &W,
    (pencil, plane, light): Shadow<'_>,
) -> Borders {
    let mut borders = Borders::new(column, pencil.row.axis.width + LONGEST_BLOCK);
    shadows(world, pencil, plane, light, &mut borders);
    borders
}

/// Says which shadows are meant: those of one light on one plane, which a row shows directly or in one mirror.
#[derive(Clone, Copy, Debug, PartialEq, Eq)]
pub(crate) struct Cast {
    /// The plane that mirrors the rays; [`ShapeId::NONE`] if none does.
    pub(crate) mirror: ShapeId,
    pub(crate) plane: ShapeId,
    /// Index of the light.
    pub(crate) light: usize,
}

/// Keeps the borders of shadows that a row asked for last: of lights with even numbers, and of those with odd ones. So two
/// far lights do not take each other's place.
#[derive(Clone, Copy, Debug)]
pub(crate) struct RowShadows([Option<(Cast, Borders)>; 2]);

impl RowShadows {
    /// No shadows.
    pub(crate) const NONE: Self = Self([None; 2]);

    /// Returns the borders of shadows in the whole row. No plane hides the light.
    pub(crate) fn of<W: World>(&mut self, world: &W, cast: Cast, shadow: Shadow<'_>) -> &Borders {
        let kept = &mut self.0[cast.light % 2];
        kept.take_if(|(of, _)| *of != cast);
        let (_, borders) = kept.get_or_insert_with(|| (cast, borders_from(0, world, shadow)));
        borders
    }
}

/// Finds the columns at which the shadows of a light on a plane begin or end, from the first of `borders` on. No
/// plane hides the light.
#[inline(never)]
fn shadows<W: World>(
    world: &W,
    pencil: &Pencil,
    plane: &PreparedPlane,
    light: ScaledPoint,
    borders: &mut Borders,
) {
    let parts = world.parts();
    let eye = ScaledPoint::at(pencil.eye);
    let (row, height) = (&pencil.row, plane.height(pencil.eye) >> 30);
    // Light arrives epsilon above the plane, and does not from below.
    let epsilon = i64::from(parts.epsilon.to_bits());
    let lamp = match light.scale {
        0 => (plane.height(light.point) >> 30) * height.signum(),
        _ => i64::MAX,
    };
    match [eye, light].map(|it| plane.side(it, parts.epsilon)) {
        [Side::In | Side::Close, _] => return borders.end(),
        [Side::Above, Side::Below] | [Side::Below, Side::Above] => return,
        _ if lamp < epsilon - 64 => return,
        [_, Side::In | Side::Close] => return borders.end(),
        _ => {}
    }
    let Cut::Some(line) = row.cut(plane.normal, height) else {
        return borders.end();
    };
    // Light arrives epsilon above the line that the row shows.
    let lift = plane.normal.reversed_if(height < 0);
    let start = line.start.plus(lift.scaled(parts.epsilon.to_bits()));
    let Some(lamp) = line.lamp(pencil.eye, start, light) else {
        return borders.end();
    };
    let mut shadows = Shadows {
        row,
        line: &line,
        lamp: &lamp,
        borders,
    };
    all_shade(world, (pencil.eye, start), &mut shadows);
}

macro_rules! all_shade {
    (
        $header:tt
        $({ $list:ident $($more:tt)* })*
    ) => {
        /// Adds the borders of the shadows of all bounded shapes. The line starts at `eye` + `start`.
        #[inline(never)]
        fn all_shade<W: World>(world: &W, (eye, start): (Point, Vector), shadows: &mut Shadows<'_>) {
            let parts = world.parts();
            $(
                if W::NEEDS.$list {
                    for shape in parts.$list {
                        let (center, radius) = shape.bounding_ball();
                        let to = eye.to(center).minus(start);
                        // What the plane of light and line passes casts no shadow there.
                        let off = shadows.lamp.off(shadows.line);
                        if to.dot(shadows.lamp.across).abs() < radius + off {
                            shape.shade(to, shadows);
                        }
                        if shadows.borders.has_ended() {
                            return;
                        }
                    }
                }
            )*
        }
    };
}
kinds!(all_shade);

#[cfg(test)]
mod tests;
