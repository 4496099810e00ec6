//! The column at which a stretch is best divided. A wrong column costs time and changes nothing else: both parts are
//! treated as any stretch is.

use super::plane_line::{PlaneLine, coarse};
use super::stops::Stop;
use super::stretch::Between;
use super::visibility::Culled;
use super::{Progress, Stops, Tracer};
use crate::accel::World;
use crate::number::{bit_modulo_32, narrowed_unsigned, root_of_square, unsigned};
use crate::qualities::Quality;
use crate::ray::ScaledPoint;
use crate::scene::Surface;
use crate::shade::highlight::sealed::Shading;
use crate::shape::plane::PreparedPlane;
use crate::vector::Point;

/// Number of columns of the shortest stretch in which the border of a shadow is looked for. In a shorter one it is
/// not worth the time, because little could be proved of the two parts.
const WORTHWHILE: u32 = 16;

impl<W: World, K: Shading, Q: Quality> Tracer<'_, W, K, Q> {
    /// Returns the last column before a border between two traced pixels: where a shape begins or ends that kept `proved`
    /// from going on, or else where a shape or a shadow begins or ends that only one of the two pixels shows, directly or in flat mirrors. `None` if no such column is known.
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
                if let (true, [Some(one), Some(other)]) =
                    (parts.planes.len() > 1, shapes.map(|it| parts.plane(it)))
                {
                    return planes_meet([one, other], eye, between.1, (paths, level));
                }
                let is_listed = level < 2 && parts.has_bounded();
                let culling = &mut self.culling;
                return is_listed.then(|| culling.border(self.world, mirror, between, shapes))?;
            }
            let plane = parts.plane(one.shape)?;
            // A scene without bounded shapes links no code for their shadows.
            let is_long = last - first >= WORTHWHILE;
            if parts.has_bounded() && is_long && one.lights != other.lights {
                return self.shadow_border(between.1, (paths, level), plane);
            }
            mirror = Some((one.shape, plane));
        }
        None
    }

    /// Returns the last column before a light begins or ceases to shine on a plane, found by bisection. Both paths show
    /// the plane at this level, and have met the same flat mirrors before. `None` if a place is far.
    #[inline(never)]
    fn shadow_border(
        &self,
        columns: [u32; 2],
        (paths, level): ([&[Stop]; 2], usize),
        plane: &PreparedPlane,
    ) -> Option<u32> {
        let world = self.world;
        let [one, other] = [paths[0].get(level)?, paths[1].get(level)?];
        let index = (one.lights ^ other.lights).trailing_zeros() as usize;
        let light = world.tables().light_occluders.get(index)?;
        if !(one.place.is_near() && other.place.is_near()) {
            return None;
        }
        let line = PlaneLine::new(self.culling.ahead()?, columns, (paths, level), &|it| {
            it.place
        })?;
        let (parts, plane) = (world.parts(), (plane, one.shape, one.is_inside));
        let visibility = Culled::<W, Q>::new(world, self.visibility);
        let is_lit = one.lights & bit_modulo_32(index) != 0;
        Some(line.last_column(|place| {
            let surface = Surface::flat(&parts, plane, place);
            K::shines::<W, Q, _>(world, &surface, &visibility, (light, index)) == is_lit
        }))
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
fn planes_meet(
    planes: [&PreparedPlane; 2],
    eye: ScaledPoint,
    [first, last]: [u32; 2],
    (paths, level): ([&[Stop]; 2], usize),
) -> Option<u32> {
    let [one, other] = planes;
    let [a, b] = [
        last_ray(eye, paths[0].get(..=level)?, planes)?,
        last_ray(eye, paths[1].get(..=level)?, [other, one])?,
    ];
    // The length of each ray counts for the other side. A product of three numbers of eight bits and the length of a block
    // fits 32 bits.
    let factors =
        [[a[0], b[0]], [a[1], b[1]], [b[2], a[2]]].map(|lengths| coarse(lengths.map(u64::from), 8));
    let [start, end] = [0, 1].map(|side| factors.iter().map(|it| it[side]).product::<u32>());
    Some((first + start * (last - first) / (start + end).max(1)).min(last - 1))
}

/// Returns three lengths in steps for a path that ends on the first of two planes: how high its last ray starts above that
/// plane, how high the ray ends above the other plane, and how long the ray is. `None` if a place is far.
#[inline(never)]
fn last_ray(eye: ScaledPoint, path: &[Stop], planes: [&PreparedPlane; 2]) -> Option<[u32; 3]> {
    let (end, before) = path.split_last()?;
    let from = before.last().map_or(eye, |stop| stop.place);
    if !from.is_near() || !end.place.is_near() {
        return None;
    }
    let ([own, other], [from, at]) = (planes, [from, end.place].map(|it| it.point));
    let length = unsigned(root_of_square(from.to(at).square()));
    Some([height(own, from), height(other, at), length])
}

/// Returns the height of a point above or below a plane, in steps.
#[inline(never)]
fn height(plane: &PreparedPlane, at: Point) -> u32 {
    let height = (plane.height(at) >> 30).unsigned_abs();
    narrowed_unsigned(height.min(u32::MAX.into()))
}
