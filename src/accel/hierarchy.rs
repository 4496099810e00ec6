//! A hierarchy of balls around the bounded shapes: rays that no table covers test few shapes of many.
//!
//! A complete binary tree, in the order of a heap: the balls of node n hold those of the nodes 2n and
//! 2n + 1. A leaf has one or two shapes. A ray that leaves a bounded shape starts at that shape's leaf and
//! visits the sibling of each node on the way to the root, but no node on that way: they hold the ray's
//! start. No stack is needed: after node n and all below it comes n + 1 without its trailing zeros.
//!
//! Bound: a node is left out only if the ray's line passes a ball that holds the balls of all of its
//! shapes, each widened by [`build`]. So the shapes that are left out have no hit.
//!
//! The nearest hit is that of the plain path, to the bit. The kernels of the shapes promise
//! ([`Bounded::intersect`](crate::shape::bounded::Bounded::intersect)) that a hit's distance does not
//! depend on the range, and that each hit is found that is nearer than the range's end by [`SURE`] steps.
//! If the nearest hit found is nearer than all others by more than that, the plain path finds it in any
//! order of the shapes, and none after it. If not, the plain path decides.

mod build;

pub(super) use build::{fill, has_mesh, is_useful};

use super::World;
use crate::number::{Length, to_u32};
use crate::qualities::Quality;
use crate::ray::{REACH, Ray};
use crate::scene::access::ShapeId;
use crate::scene::nearest::{Hit, NOWHERE, nearest_of};
use crate::shape::bounded::{Range, SURE};
use crate::vector::Point;

/// A node of the hierarchy of balls that [`Tabled::with_hierarchy`](super::Tabled::with_hierarchy) makes.
/// It takes 24 bytes.
#[derive(Clone, Copy, Debug)]
pub struct HierarchyNode {
    center: Point,
    /// Radius of the node's ball, in steps.
    radius: i32,
    /// The shapes of a leaf. Both are the same if it has one.
    shapes: [u16; 2],
    /// The leaf of the shape with this node's number, counted from the first leaf.
    leaf: u16,
}

impl HierarchyNode {
    /// A node that is not used yet.
    pub const NONE: Self = Self {
        center: Point::ORIGIN,
        radius: 0,
        shapes: [0; 2],
        leaf: 0,
    };
}

/// A hierarchy of balls; without nodes if the scene has none.
#[derive(Clone, Copy, Debug)]
pub struct Hierarchy<'a> {
    /// The nodes by their numbers. Their count is a power of two; the second half are the leaves.
    nodes: &'a [HierarchyNode],
}

impl Hierarchy<'_> {
    /// The hierarchy of a scene that has none.
    pub(super) const NONE: Self = Self { nodes: &[] };

    /// Returns whether there is no hierarchy.
    #[inline(always)]
    pub(crate) const fn is_empty(&self) -> bool {
        self.nodes.is_empty()
    }

    /// Calls `ask` for each shape that a ray can hit, until it returns `true`. Returns whether it did.
    /// A shape may come twice. `mirror` is the shape where the ray starts or ends, if it is bounded.
    #[inline(always)]
    pub(super) fn any(
        &self,
        ray: &Ray,
        mirror: ShapeId,
        mut ask: impl FnMut(usize) -> bool,
    ) -> bool {
        let leaves = to_u32(self.nodes.len() / 2);
        // A node's number, in a tree that is turned so that the mirror's leaf comes first; what turns
        // its level; how far the level is above the leaves.
        let levels = leaves.trailing_zeros();
        let (mut node, turn, mut above) = match self.nodes.get(mirror.index()) {
            Some(own) => (leaves, u32::from(own.leaf), 0),
            None => (1, 0, levels),
        };
        while let Some(ball) = self.nodes.get((node ^ (turn >> above)) as usize) {
            let way = ray.origin.to(ball.center);
            if !way.passes_by(ray.direction, ball.radius) {
                if above > 0 {
                    (node, above) = (2 * node, above - 1);
                    continue;
                }
                if ball.shapes.into_iter().any(|shape| ask(shape.into())) {
                    return true;
                }
            }
            node += 1;
            let up = node.trailing_zeros();
            (node, above) = (node >> (up & 31), (above + up) & 31);
            if node == 1 {
                return false;
            }
        }
        false
    }
}

/// Returns the nearest bounded hit of a ray that leaves `mirror`. `skip` is as in [`nearest_of`].
#[inline(never)]
pub(super) fn nearest<W: World>(world: &W, ray: &Ray, (mirror, skip): (ShapeId, ShapeId)) -> Hit {
    let parts = world.parts();
    let mut nearest = Hit::NONE;
    let is_close = world.tables().hierarchy.any(ray, mirror, |index| {
        let id = ShapeId::at(index);
        if id == skip {
            return false;
        }
        let reach = nearest.distance.to_bits() + 2 * SURE;
        let range = Range {
            start: NOWHERE,
            reach: Length::from_bits(reach.min(REACH.to_bits())),
        };
        let Some(distance) = parts.intersect(id, ray, range) else {
            return false;
        };
        let nearer = nearest.distance.to_bits() - distance.to_bits();
        if nearer > SURE || nearest.shape == ShapeId::NONE {
            nearest = Hit {
                distance,
                shape: id,
            };
            return false;
        }
        nearer >= -SURE && nearest.shape != id
    });
    if is_close { nearest_of(world, (ray, NOWHERE), skip) } else { nearest }
}

/// Tests whether rays of `Q` ask the hierarchy of a scene.
#[inline(always)]
pub(crate) fn is_used<W: World, Q: Quality>(world: &W) -> bool {
    W::IS_CROWD && Q::CULLING.hierarchy && !world.tables().hierarchy.is_empty()
}

/// Tests whether a bounded shape blocks a ray before `reach`. Skips the shape that the ray leaves.
#[inline(never)]
pub(crate) fn is_blocked<W: World>(world: &W, ray: &Ray, skip: ShapeId, reach: Length) -> bool {
    let parts = world.parts();
    world.tables().hierarchy.any(ray, skip, |index| {
        ShapeId::at(index) != skip && parts.blocks(ShapeId::at(index), ray, reach)
    })
}

#[cfg(test)]
mod tests;
