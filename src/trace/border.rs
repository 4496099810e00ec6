//! The column at which a stretch is best divided. A wrong column costs time and changes nothing else: both parts are
//! treated as any stretch is.

use super::stops::Stop;
use super::stretch::Between;
use super::visibility::Culled;
use super::{PathQuality, Progress, Stops, Tracer};
use crate::accel::World;
use crate::number::{
    Unit, bit_modulo_32, narrowed_unsigned, ratio, root_of_square, scaled_by_unit, unsigned,
};
use crate::ray::ScaledPoint;
use crate::scene::Surface;
use crate::shade::highlight::sealed::Shading;
use crate::shape::plane::PreparedPlane;
use crate::vector::{Direction, Point};

/// Number of columns of the shortest stretch in which the border of a shadow or of a checker's cell is looked for. In a
/// shorter one it is not worth the time, because little could be proved of the two parts.
const WORTHWHILE: u32 = 16;

impl<W: World, K: Shading, Q: PathQuality> Tracer<'_, W, K, Q> {
    /// Returns the last column before a border between two traced pixels: where a shape begins or ends that kept `proved`
    /// from going on, or else where a shape, a shadow or a checker's cell begins or ends that only one of the two pixels
    /// shows, directly or in flat mirrors. `None` if no such column is known.
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
            let is_long = last - first >= WORTHWHILE;
            let one_cell = |place| self.is_one_cell(one.shape, [one.place, place], 0);
            if W::NEEDS.checkers && is_long && !one_cell(other.place) {
                let line = PlaneLine::new(self.culling.ahead()?, between.1, (paths, level))?;
                return Some(line.last_column(one_cell));
            }
            // A scene without bounded shapes links no code for their shadows.
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
        // In a scene with checkers, the first bit says which cell is shown. The lights follow it.
        let shift = u32::from(W::NEEDS.checkers);
        let [lights, others] = [one, other].map(|stop| stop.lights.rotate_right(shift));
        let index = (lights ^ others).trailing_zeros() as usize;
        let light = world.tables().light_occluders.get(index)?;
        let line = PlaneLine::new(self.culling.ahead()?, columns, (paths, level))?;
        let (parts, plane) = (world.parts(), (plane, one.shape, one.is_inside));
        let visibility = Culled::<W, Q>::new(world, self.visibility);
        let is_lit = lights & bit_modulo_32(index) != 0;
        Some(line.last_column(|place| {
            let surface = Surface::flat(&parts, plane, place);
            K::shines::<W, Q, _>(world, &surface, &visibility, (light, index)) == is_lit
        }))
    }
}

/// The straight line that a stretch shows of a plane, directly or behind flat mirrors.
struct PlaneLine<'a> {
    columns: [u32; 2],
    /// The hits of the two columns.
    ends: [&'a Stop; 2],
    /// How far the two hits lie ahead of the eye, or of its image behind the mirrors, in any unit.
    depths: [u32; 2],
}

impl<'a> PlaneLine<'a> {
    /// Returns the line between the hits of two paths at this level. `None` if one is far.
    #[inline(never)]
    fn new(
        (eye, ahead): (Point, Direction),
        columns: [u32; 2],
        (paths, level): ([&'a [Stop]; 2], usize),
    ) -> Option<Self> {
        let [one, other] = paths.map(|path| depth((eye, ahead), path.get(..=level)?));
        let [(one, start), (other, end)] = [one?, other?];
        Some(Self {
            columns,
            ends: [one, other],
            depths: coarse([start, end]),
        })
    }

    /// Returns the last column of those from the first on whose points are like the first one's, found by bisection.
    #[inline(always)]
    fn last_column(&self, is_like: impl Fn(ScaledPoint) -> bool) -> u32 {
        let [mut before, mut after] = self.columns;
        while after - before > 1 {
            let column = before.midpoint(after);
            match is_like(self.at(column)) {
                true => before = column,
                false => after = column,
            }
        }
        before
    }

    /// Returns the point that a column between the two shows. It divides the line as the column divides the columns, each
    /// part weighted with the depth of its end.
    #[inline(never)]
    fn at(&self, column: u32) -> ScaledPoint {
        let ([first, last], [near, far]) = (self.columns, self.depths);
        let [part, rest] = [(column - first) * near, (last - column) * far];
        let share = Unit::from_bits(ratio(part, (part + rest).max(1)));
        let [from, to] = self.ends.map(|end| end.place.point);
        ScaledPoint::at(from.towards(to, share))
    }
}

/// Returns the last hit of a path, and how far it lies ahead of the eye, or of the eye's image behind flat mirrors, in
/// units of four steps. `None` if a hit is far.
#[inline(never)]
fn depth((eye, ahead): (Point, Direction), path: &[Stop]) -> Option<(&Stop, u32)> {
    let (mut from, mut length, mut cosine) = (eye, 0, None);
    for stop in path {
        if !stop.place.is_near() {
            return None;
        }
        let (direction, way) = from.to(stop.place.point).normalised();
        cosine = cosine.or(Some(direction.dot(ahead)));
        from = stop.place.point;
        length += way.to_bits() >> 2;
    }
    Some((path.last()?, unsigned(scaled_by_unit(length, cosine?))))
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
    // The length of each ray counts for the other side.
    let factors = [[a[0], b[0]], [a[1], b[1]], [b[2], a[2]]].map(coarse);
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

/// Returns two numbers in eight bits, with their largest common scale: a product of three of them and the length of a
/// block fits 32 bits.
#[inline(never)]
fn coarse(numbers: [u32; 2]) -> [u32; 2] {
    let drop = 24_u32.saturating_sub((numbers[0] | numbers[1]).leading_zeros());
    numbers.map(|number| number >> drop)
}
