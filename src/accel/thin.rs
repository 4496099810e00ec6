//! Whether a row shows thin bounded shapes. Such a shape may lie between the corners of pixels, and its brightness changes
//! from one corner to the next.
//!
//! It is an estimate: a shape counts as far away as its centre, and mirrored shapes do not count.

use super::World;
use crate::number::{shifted, wide};
use crate::ray::RowPlane;
use crate::shape::bounded::Bounded;

macro_rules! shows_thin {
    ($header:tt $({ $list:ident $($more:tt)* })*) => {
        /// Tests whether a row shows a thin shape. `row` holds the rays along its upper edge.
        #[inline(never)]
        pub(crate) fn shows_thin<W: World>(world: &W, row: &RowPlane) -> bool {
            let parts = world.parts();
            $(W::NEEDS.$list && parts.$list.iter().any(|shape| is_thin(shape, row)))||*
        }
    };
}
kinds!(shows_thin);

/// Thickness below which shapes are thin, in pixels.
const THIN: i64 = 4;

/// Tests whether a shape looks thinner than [`THIN`] and lies at most a pixel above or below the rays of a row.
fn is_thin<K: Bounded>(shape: &K, row: &RowPlane) -> bool {
    let (center, half, radius) = shape.outline();
    let axis = &row.axis;
    let way = axis.origin.to(center);
    let depth = i64::from(way.dot(axis.ahead));
    // The length of a pixel at the shape's depth, times `distance`.
    let pixel = 2 * shifted(depth, (-axis.scale).min(28));
    let is_below = |length: i32, pixels: i64| wide(length, axis.distance) < pixels * pixel;
    let (thickness, reach) = match K::IS_FLAT {
        true => (2 * half.dot(axis.ahead).abs(), radius),
        false => (2 * radius, radius + half.dot(row.normal).abs()),
    };
    let gap = way.dot(row.normal).abs() - reach;
    depth > 0 && is_below(thickness, THIN) && is_below(gap, 1)
}
