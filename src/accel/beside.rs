//! The bounded shapes that a ray beside the centre of a pixel can hit: those whose rectangles hold the pixel. It serves
//! the further samples of smooth edges, for rays of the camera and for their first reflection in a plane.
//!
//! Bound: [`super::screen_bounds`]. A rectangle is widened by at least one pixel, and a sample lies at most half a pixel
//! beside the centre.

use super::World;
use super::screen_bounds::Rects;
use super::screen_rect::ScreenRect;
use crate::ray::Ray;
use crate::scene::access::ShapeId;
use crate::scene::nearest::{Hit, NOWHERE, Nearest};
use crate::scene::used;
use crate::shape::bounded::Bounded;

macro_rules! beside {
    (
        $header:tt
        $({ $list:ident $($more:tt)* })*
    ) => {
        /// Returns the nearest hit of a ray through a pixel, given by its column and row, among the shapes whose rectangles
        /// hold the pixel. Skips the shape that the ray leaves.
        #[inline(never)]
        pub(super) fn nearest_beside<W: World>(
            world: &W,
            rects: &Rects<W::Room>,
            pixel: [u16; 2],
            (ray, skip): (&Ray, ShapeId),
        ) -> Hit {
            let mut nearest = Nearest::beyond(NOWHERE);
            let parts = world.parts();
            let first = 0;
            $(
                if W::NEEDS.$list {
                    let rects = used(rects.$list.as_ref(), parts.$list.len());
                    ask(&mut nearest, (parts.$list, first), rects, pixel, (ray, skip));
                }
                let first = first + parts.$list.len();
            )*
            let _ = first;
            nearest.hit()
        }
    };
}
kinds!(beside);

/// Intersects a ray with the shapes of one kind whose rectangles hold a pixel. `first` is the number of the first shape.
#[inline(always)]
fn ask<K: Bounded>(
    nearest: &mut Nearest,
    (shapes, first): (&[K], usize),
    rects: &[ScreenRect],
    [column, row]: [u16; 2],
    (ray, skip): (&Ray, ShapeId),
) {
    for rect in rects {
        if rect.left > column {
            break;
        }
        if rect.right >= column && rect.has_row(row) {
            if let Some(shape) = shapes.get(rect.shape()) {
                nearest.ask(shape, ray, ShapeId::at(first + rect.shape()), skip);
            }
        }
    }
}
