//! Whether a row shows thin bounded shapes or, in a small picture, small mirroring balls. A thin shape may lie between the
//! corners of pixels, and its brightness changes from one corner to the next. What a small ball mirrors is much smaller still.
//!
//! It is an estimate: a shape counts as far away as its centre, and mirrored shapes do not count.

use super::World;
use crate::number::{Unit, scaled_by_unit, shifted, wide};
use crate::ray::RowPlane;
use crate::shape::bounded::Bounded;

macro_rules! shows_thin {
    ($header:tt $({ $list:ident $($more:tt)* })*) => {
        /// Tests whether a row of a picture of this width shows a thin shape or a small mirroring ball. `row` holds the rays
        /// along its upper edge.
        #[inline(never)]
        pub(crate) fn shows_thin<W: World>(world: &W, row: &RowPlane, width: u32) -> bool {
            let parts = world.parts();
            let may_be_small = |id| width < SMALL_PICTURE && parts.material(id).mirror > Unit::ZERO;
            $(W::NEEDS.$list && parts.$list.iter().any(|it| is_thin(it, row, may_be_small(it.material))))||*
        }
    };
}
kinds!(shows_thin);

/// Thickness below which shapes are thin, in pixels.
const THIN: i64 = 4;

/// Diameter below which mirroring balls are small, in pixels.
const SMALL: i64 = 20;

/// Width below which small balls count, in pixels: they cover much of such a picture.
const SMALL_PICTURE: u32 = 160;

/// Tests whether a shape looks thinner than [`THIN`], or a ball than [`SMALL`] if `may_be_small`, and lies at most a pixel
/// above or below the rays of a row.
fn is_thin<K: Bounded>(shape: &K, row: &RowPlane, may_be_small: bool) -> bool {
    let (center, half, radius) = shape.outline();
    let axis = &row.axis;
    let way = axis.origin.to(center);
    let depth = i64::from(way.dot(axis.ahead));
    // The length of a pixel at the shape's depth, times `distance`.
    let pixel = 2 * shifted(depth, (-axis.scale).min(26));
    let is_below = |length: i32, pixels: i64| wide(length, axis.distance) < pixels * pixel;
    // Seen from its side, a flat shape is thin.
    let share = if K::IS_FLAT { shape.normal(center).dot(axis.ahead) } else { Unit::ONE };
    let thickness = 2 * scaled_by_unit(radius, share).abs();
    let reach = radius + half.dot(row.normal).abs();
    let gap = way.dot(row.normal).abs() - reach;
    let is_small = may_be_small && K::IS_BALL && is_below(thickness, SMALL);
    depth > 0 && (is_small || is_below(thickness, THIN)) && is_below(gap, 1)
}
