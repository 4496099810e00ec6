//! The column at which a stretch is best divided. A wrong column costs time and changes nothing else: both parts are
//! treated as any stretch is.

use super::stops::Stop;
use super::stretch::Between;
use super::{PathQuality, Progress, Stops, Tracer};
use crate::accel::World;
use crate::number::{narrowed_unsigned, root_of_square, unsigned};
use crate::ray::ScaledPoint;
use crate::shade::highlight::sealed::Shading;
use crate::shape::plane::PreparedPlane;
use crate::vector::Point;

impl<W: World, K: Shading, Q: PathQuality> Tracer<'_, W, K, Q> {
    /// Returns the last column before a shape or a shadow ends or begins between two traced pixels: one that kept
    /// `proved` from going on, or one that one of the pixels shows and the other does not, directly or in flat mirrors.
    /// `None` if no such column is known.
    #[inline(never)]
    pub(crate) fn border(
        &mut self,
        between: Between<'_>,
        ends: [&Stops; 2],
        proved: &Progress,
    ) -> Option<u32> {
        let [first, last] = between.1;
        if let Some(border) = proved.border.filter(|it| (first..last).contains(it)) {
            return Some(border);
        }
        let (parts, eye) = (self.world.parts(), self.visibility.from);
        let paths @ [start, end] = ends.map(Stops::all);
        let mut mirror = None;
        for (level, (one, other)) in start.iter().zip(end).enumerate() {
            if one.shape != other.shape {
                let shapes = [one.shape, other.shape];
                if parts.planes.len() > 1 && shapes.iter().all(|it| parts.is_plane(*it)) {
                    return planes_meet(self.world, eye, between.1, (paths, level));
                }
                return match level < 2 && parts.has_bounded() {
                    true => self.culling.border(self.world, mirror, between, shapes),
                    false => None,
                };
            }
            if level < 2 {
                let until = self.far_lights_until(between.1, start, level)?;
                if until < last {
                    return Some(until);
                }
            }
            mirror = Some((one.shape, parts.plane(one.shape)?));
        }
        None
    }
}

/// Returns the last column before two planes meet: the first of two paths shows one of them at this level, the last
/// shows the other. Before, both have met the same flat mirrors. `None` if a place is far.
///
/// A ray's slope is the height of its start above the plane that it ends on, over its length. Slope times height of
/// the end above the other plane is 0 where both planes meet. Along the row this product is linear, apart from the
/// cosine of the angle to the row's middle, which hardly changes in a block. So the border divides the columns as the
/// products at both ends divide their sum.
#[inline(never)]
fn planes_meet<W: World>(
    world: &W,
    eye: ScaledPoint,
    [first, last]: [u32; 2],
    (paths, level): ([&[Stop]; 2], usize),
) -> Option<u32> {
    let parts = world.parts();
    let (mut slopes, mut above, mut lengths) = ([0; 2], [0; 2], [0; 2]);
    for side in 0..2 {
        let other = paths[1 - side].get(level)?.shape;
        let (end, before) = paths[side].get(..=level)?.split_last()?;
        let from = before.last().map_or(eye, |stop| stop.place);
        if !from.is_near() || !end.place.is_near() {
            return None;
        }
        let [from, at] = [from, end.place].map(|it| it.point);
        slopes[side] = height(parts.plane(end.shape)?, from);
        above[side] = height(parts.plane(other)?, at);
        lengths[1 - side] = unsigned(root_of_square(from.to(at).square()));
    }
    let factors = [slopes, above, lengths].map(coarse);
    let [start, end] = [0, 1].map(|side| factors.iter().map(|it| it[side]).product::<u32>());
    Some((first + start * (last - first) / (start + end).max(1)).min(last - 1))
}

/// Returns the height of a point above or below a plane, in steps.
#[inline(never)]
fn height(plane: &PreparedPlane, at: Point) -> u32 {
    let height = (plane.height(at) >> 30).unsigned_abs();
    narrowed_unsigned(height.min(u32::MAX.into()))
}

/// Returns two numbers in eight bits, with their largest common scale: a product of three of them and the length of a
/// block fits 32 bits.
fn coarse(numbers: [u32; 2]) -> [u32; 2] {
    let drop = 24_u32.saturating_sub((numbers[0] | numbers[1]).leading_zeros());
    numbers.map(|number| number >> drop)
}
