//! How a hierarchy of balls is made: the shapes are halved along the widest axis until a leaf has one or
//! two. Runs in the compiler for constant scenes.
//!
//! Bound: a kernel finds no hit if the ray's line passes the shape's ball by more than a root of
//! r² + [`UNSURE`], and no shadow if it passes it by more than r (1 + 2⁻¹²) + 16 steps. So each ball is
//! widened by more than both.

use super::{Hierarchy, HierarchyNode};
use crate::number::{square_root, to_u16, to_u32, unsigned_wide, wide};
use crate::ray::BALL;
use crate::scene::Parts;
use crate::scene::shape_set::SetLayout;
use crate::vector::Point;

/// Largest number of bounded shapes without a hierarchy. To test all of so few takes no longer.
const MOST: usize = 12;

/// Upper bound on the rounding error of the squares in `Vector::passes_by`, the first test of a kernel.
///
/// In units of 2³², the parts are: 24 for the length of a direction and the term that corrects it (2⁻²⁴
/// and 2⁻²⁵ of a square below 2⁶⁰), 8 for the constant that the test adds, 4 for a quarter of the length along
/// the ray, rounded down, and one for each product.
const UNSURE: u64 = 40 << 32;

impl<'a> Hierarchy<'a> {
    /// Returns the number of nodes for the bounded shapes of a scene; 0 if they are too few, or too many
    /// for 16 bits.
    pub(in crate::accel) const fn room(bounded: usize) -> usize {
        if bounded <= MOST || bounded > 1 << 15 {
            return 0;
        }
        bounded.next_power_of_two()
    }

    /// Makes the hierarchy of a scene in the first nodes of `memory`. Returns [`Self::NONE`] if `memory` is
    /// too short, or if the scene has too few or too many bounded shapes.
    pub(in crate::accel) const fn of(parts: &Parts<'_>, memory: &'a mut [HierarchyNode]) -> Self {
        let room = Self::room(parts.bounded());
        if room == 0 {
            return Self::NONE;
        }
        match memory.split_at_mut_checked(room) {
            Some((nodes, _)) => {
                fill(parts, nodes);
                Self { nodes }
            }
            None => Self::NONE,
        }
    }

    /// Returns the hierarchy whose nodes [`fill`] has made.
    pub(in crate::accel) const fn filled(nodes: &'a [HierarchyNode]) -> Self {
        Self { nodes }
    }
}

/// Tests whether a constant scene gains by a hierarchy: it has a mesh, a crowd under a far light, or at least two planes that
/// mirror; or at least an eighth of its shapes mirror, each counted as the square of its ball's radius.
pub(in crate::accel) const fn is_useful(parts: &Parts<'_>) -> bool {
    let (mut all, mut mirroring, mut shape) = (0, 0, 0);
    while let Some(((_, radius), material)) = parts.ball(shape) {
        // Radii are below 2²⁹, so the sum of 2¹⁵ squares fits.
        let square = unsigned_wide(wide(radius, radius)) >> 16;
        all += square;
        mirroring += square * parts.mirrors(material) as u64;
        shape += 1;
    }
    let needs = parts.needs();
    let is_sunlit_crowd = parts.bounded() > SUNLIT && needs.far_lights;
    needs.facing_mirrors || 8 * mirroring >= all || has_mesh(parts) || is_sunlit_crowd
}

/// Largest number of bounded shapes of which a shadow ray to a far light asks all in less time than a hierarchy.
const SUNLIT: usize = 48;

/// Tests whether a scene has a mesh: more than 16 triangles. The test of a triangle takes longer than that of a ball around
/// several, and a light's table names many that lie close together.
pub(in crate::accel) const fn has_mesh(parts: &Parts<'_>) -> bool {
    parts.triangles.len() > 16
}

/// Makes all nodes of a hierarchy if their number is [`Hierarchy::room`]. Else nothing reads them.
pub(in crate::accel) const fn fill(parts: &Parts<'_>, nodes: &mut [HierarchyNode]) {
    let (count, leaves) = (parts.bounded(), nodes.len() / 2);
    if nodes.len() != Hierarchy::room(count) {
        return;
    }
    // While the nodes are made, `leaf` is the list of the shapes in their order.
    let mut index = 0;
    while index < nodes.len() {
        // Lent memory may hold what it was used for before.
        nodes[index].leaf = if index < count { to_u16(to_u32(index)) } else { 0 };
        index += 1;
    }
    let mut node = 1;
    while node < nodes.len() {
        let level = node.ilog2();
        let width = leaves >> level;
        // The leaves below the node, and their shapes.
        let first = (node << (leaves.ilog2() - level)) - leaves;
        let range = (
            start(first, count, leaves),
            start(first + width, count, leaves),
        );
        let bounds = Bounds::of(parts, nodes, range);
        if width > 1 {
            sort(parts, nodes, range, bounds.widest_axis());
        }
        let center = bounds.center();
        nodes[node] = HierarchyNode {
            center,
            radius: radius(parts, nodes, range, center),
            shapes: [shape_at(nodes, range.0), shape_at(nodes, range.1 - 1)],
            leaf: nodes[node].leaf,
        };
        node += 1;
    }
    note_leaves(nodes, count);
}

/// Returns the place of a leaf's first shape in the order of shapes.
const fn start(leaf: usize, count: usize, leaves: usize) -> usize {
    leaf * count / leaves
}

/// Replaces the order of the shapes by the leaf of each.
const fn note_leaves(nodes: &mut [HierarchyNode], count: usize) {
    let leaves = nodes.len() / 2;
    let mut leaf = 0;
    while leaf < leaves {
        let shapes = nodes[leaves + leaf].shapes;
        let mut which = 0;
        while which < 2 {
            let shape = shapes[which] as usize;
            if shape < count && shape < nodes.len() {
                nodes[shape].leaf = to_u16(to_u32(leaf));
            }
            which += 1;
        }
        leaf += 1;
    }
}

/// Returns the shape at a place of the order.
const fn shape_at(nodes: &[HierarchyNode], place: usize) -> u16 {
    if place < nodes.len() { nodes[place].leaf } else { 0 }
}

/// Returns the widened ball of a shape. A shape that moves may be anywhere.
const fn ball(parts: &Parts<'_>, shape: u16) -> (Point, i32) {
    let set = SetLayout::new(parts.lengths()).set_of(shape as usize);
    let (center, radius) = match parts.ball(shape as usize) {
        Some((ball, _)) if !parts.moving.meets(set) => ball,
        _ => (Point::ORIGIN, BALL),
    };
    let square = unsigned_wide(wide(radius, radius)) + UNSURE;
    (center, square_root(square) + (radius >> 12) + 16)
}

/// Box around the centres of some shapes.
struct Bounds {
    low: [i32; 3],
    high: [i32; 3],
}

impl Bounds {
    /// Returns the box around the centres of a range of shapes.
    const fn of(parts: &Parts<'_>, nodes: &[HierarchyNode], range: (usize, usize)) -> Self {
        let mut bounds = Self {
            low: [i32::MAX; 3],
            high: [i32::MIN; 3],
        };
        let mut place = range.0;
        while place < range.1 {
            let (center, radius) = ball(parts, shape_at(nodes, place));
            let center = [center.x, center.y, center.z];
            let mut axis = 0;
            while axis < 3 {
                if center[axis] - radius < bounds.low[axis] {
                    bounds.low[axis] = center[axis] - radius;
                }
                if center[axis] + radius > bounds.high[axis] {
                    bounds.high[axis] = center[axis] + radius;
                }
                axis += 1;
            }
            place += 1;
        }
        bounds
    }

    /// Returns the middle of the box.
    const fn center(&self) -> Point {
        let (low, high) = (self.low, self.high);
        Point::new(
            low[0] + ((high[0] - low[0]) >> 1),
            low[1] + ((high[1] - low[1]) >> 1),
            low[2] + ((high[2] - low[2]) >> 1),
        )
    }

    /// Returns the axis along which the box is longest.
    const fn widest_axis(&self) -> usize {
        let [x, y, z] = [
            self.high[0] - self.low[0],
            self.high[1] - self.low[1],
            self.high[2] - self.low[2],
        ];
        if x >= y && x >= z {
            0
        } else if y >= z {
            1
        } else {
            2
        }
    }
}

/// Sorts a range of shapes by one coordinate of their centres (Shell, with Knuth's gaps).
const fn sort(
    parts: &Parts<'_>,
    nodes: &mut [HierarchyNode],
    (from, to): (usize, usize),
    axis: usize,
) {
    let mut gap = 1;
    while gap < (to - from) / 3 {
        gap = 3 * gap + 1;
    }
    while gap > 0 {
        let mut next = from + gap;
        while next < to {
            let shape = shape_at(nodes, next);
            let key = coordinate(parts, shape, axis);
            let mut place = next;
            while place >= from + gap
                && coordinate(parts, shape_at(nodes, place - gap), axis) > key
                && place < nodes.len()
            {
                nodes[place].leaf = shape_at(nodes, place - gap);
                place -= gap;
            }
            if place < nodes.len() {
                nodes[place].leaf = shape;
            }
            next += 1;
        }
        gap /= 3;
    }
}

/// Returns a coordinate of a shape's centre.
const fn coordinate(parts: &Parts<'_>, shape: u16, axis: usize) -> i32 {
    let (center, _) = ball(parts, shape);
    match axis {
        0 => center.x,
        1 => center.y,
        _ => center.z,
    }
}

/// Returns the radius of the ball around `center` that holds the balls of a range of shapes.
const fn radius(
    parts: &Parts<'_>,
    nodes: &[HierarchyNode],
    (from, to): (usize, usize),
    center: Point,
) -> i32 {
    let mut largest = 0;
    let mut place = from;
    while place < to {
        let (own, radius) = ball(parts, shape_at(nodes, place));
        let distance = square_root(center.to(own).square());
        let reach = distance + (distance >> 24) + 2 + radius;
        if reach > largest {
            largest = reach;
        }
        place += 1;
    }
    largest
}
