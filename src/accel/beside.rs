//! The bounded shapes that rays beside the centres of pixels can hit: those whose rectangles reach into a part of the row.
//! It serves the corners' sides and the samples of smooth edges, for rays of the camera and for their first reflection in a
//! plane.
//!
//! Bound: [`super::screen_bounds`]. A rectangle is widened by at least one pixel, and a ray passes by the centre of its
//! pixel at most one pixel to the side, and at most one above or below.

use super::World;
use super::screen_bounds::Rects;
use super::screen_rect::ScreenRect;
use crate::number::to_u16;
use crate::scene::access::ShapeId;
use crate::scene::shape_set::{ShapeKind, ShapeSet};
use crate::scene::used;

/// Number of columns of a part of a row, as a power of two.
const PART: u32 = 2;

/// The shapes that rays through one part of a row can hit, directly and in the latest plane.
pub(crate) struct Beside([Option<(Part, ShapeSet)>; 2]);

/// A part of a row.
#[derive(Clone, Copy, PartialEq, Eq)]
pub(super) struct Part {
    /// The plane that mirrors the rays; [`ShapeId::NONE`] if none does.
    mirror: ShapeId,
    /// Number of the part, from the left.
    number: u32,
    /// The row.
    y: u16,
}

impl Part {
    /// Returns the part that a pixel lies in, for rays that `mirror` has mirrored.
    #[inline(always)]
    pub(super) fn of(mirror: ShapeId, column: u32, y: u16) -> Self {
        let number = column >> PART;
        Self { mirror, number, y }
    }
}

impl Beside {
    /// No shapes are known yet.
    pub(crate) const NONE: Self = Self([None; 2]);

    /// Returns the shapes that rays through a part can hit.
    #[inline(always)]
    pub(super) fn of<W: World>(
        &mut self,
        world: &W,
        rects: &Rects<W::Room>,
        part: Part,
    ) -> ShapeSet {
        let [direct, mirrored] = &mut self.0;
        let kept = if part.mirror == ShapeId::NONE { direct } else { mirrored };
        match kept {
            Some((known, set)) if *known == part => *set,
            _ => {
                let set = reaching(world, rects, part);
                *kept = Some((part, set));
                set
            }
        }
    }
}

macro_rules! beside {
    (
        $header:tt
        $({ $list:ident $($more:tt)* })*
    ) => {
        /// Returns the shapes whose rectangles reach into a part of a row.
        #[inline(never)]
        fn reaching<W: World>(world: &W, rects: &Rects<W::Room>, part: Part) -> ShapeSet {
            let mut set = ShapeSet::NONE;
            let parts = world.parts();
            let [$($list),*] = parts.kinds();
            $(
                if W::NEEDS.$list {
                    let rects = used(rects.$list.as_ref(), parts.$list.len());
                    add(&mut set, $list, rects, part);
                }
            )*
            set
        }
    };
}
kinds!(beside);

/// Adds to a set the shapes of one kind whose rectangles reach into a part of a row.
#[inline(always)]
fn add(set: &mut ShapeSet, kind: ShapeKind, rects: &[ScreenRect], part: Part) {
    let first = to_u16(part.number << PART);
    let last = first | ((1 << PART) - 1);
    for rect in rects {
        if rect.left > last {
            break;
        }
        if rect.right >= first && rect.has_row(part.y) {
            *set = set.with(kind.set_of(rect.shape()));
        }
    }
}
