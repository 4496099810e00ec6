//! Whether a row shows thin bounded shapes or, in a small picture, small mirroring balls. A thin shape may lie between the
//! corners of pixels, and its brightness changes from one corner to the next. What a small ball mirrors is much smaller still.
//!
//! It is an estimate: a shape counts as far away as its centre, and mirrored shapes do not count.

use super::World;
use crate::number::{Unit, scaled_by_unit, shifted, wide};
use crate::ray::RowPlane;
use crate::scene::access::{Parts, ShapeId};
use crate::vector::Vector;

/// Tests whether a row of a picture of this width shows a thin shape or a small mirroring ball. `row` holds the rays
/// along its upper edge.
#[inline(never)]
pub(crate) fn shows_thin<W: World>(world: &W, row: &RowPlane, width: u32) -> bool {
    let parts = world.parts();
    (0..parts.bounded()).any(|number| is_shown_thin(&parts, ShapeId::at(number), row, width))
}

/// Thickness below which shapes are thin, in pixels.
const THIN: i64 = 4;

/// Diameter below which mirroring balls are small, in pixels.
const SMALL: i64 = 20;

/// Width below which small balls count, in pixels: they cover much of such a picture.
const SMALL_PICTURE: u32 = 160;

/// Tests whether a bounded shape looks thinner than [`THIN`], or a mirroring ball in a small picture than [`SMALL`], and lies
/// at most a pixel above or below the rays of a row.
pub(crate) fn is_shown_thin(parts: &Parts<'_>, shape: ShapeId, row: &RowPlane, width: u32) -> bool {
    let Some((center, half, radius)) = parts.outline(shape) else {
        return false;
    };
    let Some((normal, material)) = parts.outside(shape, center) else {
        return false;
    };
    let axis = &row.axis;
    let way = axis.origin.to(center);
    let depth = i64::from(way.dot(axis.ahead));
    // The length of a pixel at the shape's depth, times `distance`.
    let pixel = 2 * shifted(depth, (-axis.scale).min(26));
    let is_below = |length: i32, pixels: i64| wide(length, axis.distance) < pixels * pixel;
    let is_flat = parts.bending_radius(shape).is_none();
    // Seen from its side, a flat shape is thin.
    let share = if is_flat { normal.dot(axis.ahead) } else { Unit::ONE };
    let thickness = 2 * scaled_by_unit(radius, share).abs();
    let reach = radius + half.dot(row.normal).abs();
    let gap = way.dot(row.normal).abs() - reach;
    let is_mirroring_ball =
        !is_flat && half == Vector::ZERO && parts.material(material).mirror > Unit::ZERO;
    let is_small = width < SMALL_PICTURE && is_mirroring_ball && is_below(thickness, SMALL);
    depth > 0 && (is_small || is_below(thickness, THIN)) && is_below(gap, 1)
}
