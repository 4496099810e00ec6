//! The surface that a stretch of pixels shows: where its points lie, how its normal turns, and whether a
//! highlight on it can be interpolated. docs/internals/edges.md has the proofs.

use super::stops::Stop;
use super::stretch::LARGEST_TURN;
use crate::accel::stretch::Chord;
use crate::accel::{LitStretch, World};
use crate::material::PreparedMaterial;
use crate::number::{
    Unit, narrowed, ratio, root_of_unit, scaled_by_unit, square_root, unit_product, unsigned,
    unsigned_wide, wide,
};
use crate::ray::ScaledPoint;
use crate::scene::access::Parts;
use crate::shade::highlight::sealed::Shading;
use crate::shade::{Glance, Samples, Turns, begins_sharply, is_little};
use crate::shape::bordered::Ball;
use crate::shape::rays::Rays;
use crate::vector::{Direction, Point};

/// The surface that a stretch shows.
pub(super) struct Shown<'a> {
    pub(super) material: &'a PreparedMaterial,
    pub(super) lit: LitStretch,
    /// Normals at the two ends.
    pub(super) normals: [Direction; 2],
    /// Length of their difference.
    pub(super) turn: Unit,
    /// Least radius of the circle on which the normals turn.
    circle: Unit,
    /// Ball around all points, if they are near.
    pub(super) ball: Option<Ball>,
    pub(super) eye: Point,
    /// Radius on which the normals turn, in steps; 0 if the surface is flat.
    radius: i32,
}

/// Returns the surface that a stretch shows. `None` if it turns too much.
pub(super) fn shown<'a, W: World>(
    world: &'a W,
    eye: Point,
    row: Direction,
    stops: [&Stop; 2],
) -> Option<Shown<'a>> {
    let parts = world.parts();
    let [first, last] = stops;
    // How the normals of a smooth triangle turn is not known.
    if W::NEEDS.triangles && parts.is_smooth(first.shape) {
        return None;
    }
    let (normals, material) = normals(&parts, stops)?;
    let is_curved = parts.bending_radius(first.shape).is_some();
    if first.place.is_near() != last.place.is_near() {
        return None;
    }
    // From inside, an arc may be longer than half a circle.
    if is_curved && first.is_inside && are_apart(eye, stops) {
        return None;
    }
    let mut shown = Shown {
        material,
        lit: LitStretch {
            shape: first.shape,
            is_hollow: is_curved && first.is_inside,
            bulge: 0,
            slack: 0,
            ends: [first.place, last.place],
        },
        normals,
        turn: Unit::ZERO,
        circle: Unit::ONE,
        ball: None,
        eye,
        radius: parts.bending_radius(first.shape).unwrap_or(0),
    };
    if first.place.is_near() && last.place.is_near() {
        let epsilon = parts.epsilon.to_bits().max(parts.inner_epsilon.to_bits());
        let ball = ball_over(first.place.point, last.place.point, 2 * epsilon);
        shown.ball = Some(ball);
        shown.lit.slack = 2 * epsilon + 8;
        if is_curved {
            let (angle, least, change) = turn_in_plane(normals, row)?;
            (shown.circle, shown.turn) = (least, change);
            shown.lit.bulge = bulge(ball.1, angle);
        }
    }
    Some(shown)
}

/// Tests whether two stops are seen at least a right angle apart.
#[inline(always)]
fn are_apart(eye: Point, [first, last]: [&Stop; 2]) -> bool {
    let view = |stop: &Stop| eye.to(stop.place.point).normalised().0;
    view(first).dot(view(last)) <= Unit::ZERO
}

/// Returns the normals at two stops on one surface, and its material. `None` if the stops are lifted by
/// more than a quarter of the radius: a normal there would be much longer than one.
#[inline(always)]
fn normals<'a>(
    parts: &Parts<'a>,
    stops: [&Stop; 2],
) -> Option<([Direction; 2], &'a PreparedMaterial)> {
    let [first, last] = stops;
    let epsilon = parts.epsilon.to_bits().max(parts.inner_epsilon.to_bits());
    let radius = parts.bending_radius(first.shape);
    if radius.is_some_and(|radius| radius >> 2 < epsilon) {
        return None;
    }
    let (one, material) = parts.outside(first.shape, first.place.point)?;
    let (other, _) = parts.outside(last.shape, last.place.point)?;
    let normals = [
        one.reversed_if(first.is_inside),
        other.reversed_if(last.is_inside),
    ];
    Some((normals, parts.material(material)))
}

/// Smallest cosine between normal and view, 0.3, at which five pixels are enough for a normal that turns by more
/// than [`LARGEST_TURN`]. Nearer to the outline, the normal turns ever faster from column to column.
const GRAZED: Unit = Unit::from_bits((1 << 30) / 10 * 3);

/// What a cosine of a curved surface may be off by, and more: 2⁻¹⁶.
const SURE_COSINE: i32 = 1 << 14;

impl Shown<'_> {
    /// Returns the straight line between the points at the two ends, if they are near.
    pub(super) fn chord(&self) -> Option<Chord> {
        let lit = &self.lit;
        self.ball.map(|ball| Chord {
            ball,
            ends: lit.ends.map(|end| end.point),
            bulge: lit.bulge + lit.slack,
            slack: lit.slack,
            is_hollow: lit.is_hollow,
        })
    }

    /// Returns how many pixels show how the highlight of a light changes. `rays` are those of the light.
    #[inline(never)]
    pub(super) fn highlight_samples<K: Shading>(&self, rays: &Rays) -> Samples {
        if self.is_surely_smooth::<K>(rays) {
            return Samples::Three;
        }
        let views = self.views();
        let glances = [0, 1].map(|end| Glance {
            normal: self.normals[end],
            view: views[end],
            along: rays.ends[end],
        });
        let [view, end] = views;
        let view = view.change_to(end).map(|it| square_root(it.square()));
        let Some(view) = view.filter(|view| *view < Unit::ONE.to_bits()) else {
            return Samples::All;
        };
        let least = if view > LARGEST_TURN.to_bits() { Samples::Five } else { Samples::Three };
        let turns = Turns {
            normal: self.turn.to_bits(),
            light: rays.turn.to_bits(),
            view,
            circle: self.circle,
        };
        least.max(K::samples(&glances, &turns, self.material.shininess))
    }

    /// Returns the directions from the eye to the two ends.
    #[inline(never)]
    fn views(&self) -> [Direction; 2] {
        let eye = ScaledPoint::at(self.eye);
        self.lit.ends.map(|end| eye.to(end).0.normalised().0)
    }

    /// Tests whether an end is seen at a grazing angle.
    pub(super) fn is_grazed(&self) -> bool {
        let views = self.views();
        (0..2).any(|end| views[end].reversed().dot(self.normals[end]) < GRAZED)
    }

    /// Tests whether the normal is at right angles to the light at a point between the ends, or may be. There
    /// a highlight ends at once.
    ///
    /// The light's height above the surface is its distance times the cosine. So it does not change its sign if the
    /// least of both cosines is above what [`bend_of_height`] returns.
    #[inline(never)]
    pub(super) fn may_turn_away(&self, rays: &Rays) -> bool {
        let cosines = [0, 1].map(|end| self.normals[end].dot(rays.ends[end]).to_bits().abs());
        let [one, other] = rays.reaches;
        let distance = one.min(other).to_bits();
        let bend = bend_of_height(self.turn, self.circle, [self.radius, distance]);
        bend.is_none_or(|bend| cosines[0].min(cosines[1]) <= bend + SURE_COSINE)
    }

    /// Tests whether a highlight surely changes little, from bounds of the changes of the normal and of the
    /// directions to the light and to the eye.
    ///
    /// The direction to the eye changes by at most the diameter of the ball over the distance. The half-way
    /// vector is the sum of both directions over its length, which is at least the sum of their cosines to
    /// the normal.
    fn is_surely_smooth<K: Shading>(&self, rays: &Rays) -> bool {
        if begins_sharply::<K>(self.material.shininess) {
            return false;
        }
        let Some((middle, radius)) = self.ball else {
            return false;
        };
        let (view, distance) = self.eye.to(middle).normalised();
        let distance = distance.to_bits();
        if distance >> 3 <= radius {
            return false;
        }
        let [first, _] = rays.ends;
        let light = rays.turn.to_bits();
        let [normal, _] = self.normals;
        // Half of each, so that sums fit.
        let moves = (light >> 1) + ratio(unsigned(radius), unsigned(distance));
        let cosines = -(normal.dot(view).to_bits() >> 1) - (normal.dot(first).to_bits() >> 1);
        let cosines = cosines - moves;
        if cosines <= moves {
            return false;
        }
        let change = i64::from(ratio(unsigned(moves), unsigned(cosines)));
        let change = (change + i64::from(self.turn.to_bits())) >> 2;
        let change = narrowed(change) << K::TURNS;
        is_little(change, self.material.shininess)
    }
}

/// Returns an upper bound of how far the height of a light above a curved surface is off the straight line between its
/// values at two points, over the light's distance from the nearer one. The normals turn by `turn` on a circle of
/// radius `circle`. `None` if the light is not further away than the surface's radius, or the normals turn too much.
///
/// At a point with the normal n, the height is n · (L - c) - r, for a light L, a centre c and a radius r. The normals
/// turn on a circle of radius k. With A = |L - c|, its second derivative is at most A k. So it is off the straight line
/// by at most A k φ² / 8, where φ is the angle of the turn t. Up to 60 degrees, k φ² is below 1.1 t² / k; 1.25 is
/// taken. A is at most distance + r.
fn bend_of_height(turn: Unit, circle: Unit, [radius, distance]: [i32; 2]) -> Option<i32> {
    let square = unit_product(turn, turn);
    if radius >= distance || square >= circle {
        return None;
    }
    let [square, circle] = [square, circle].map(|it| unsigned(it.to_bits()));
    let bend = ratio(square, circle) >> 3;
    let share = Unit::from_bits(ratio(unsigned(radius), unsigned(distance)));
    let bend = bend + scaled_by_unit(bend, share);
    Some(bend + (bend >> 2))
}

/// Returns an upper bound of the angle by which a curve in a plane turns between two points, as the length
/// of a chord of the unit circle, Q2.30. The curve lies on a surface with these normals. `None` if it may
/// turn by more than 60 degrees. Also returns the least radius of the circle on which the normals turn, and
/// the length of their difference.
fn turn_in_plane([one, other]: [Direction; 2], plane: Direction) -> Option<(Unit, Unit, Unit)> {
    let change = one.change_to(other)?;
    let (across, whole) = (change.dot(plane), change.square());
    let square = whole.saturating_sub(unsigned_wide(wide(across, across)));
    let turn = square_root(square) + 4;
    let [one, other] = [one, other].map(|it| it.dot(plane).to_bits().abs());
    let steepest = Unit::from_bits(one.max(other).min(Unit::ONE.to_bits()));
    let least = root_of_unit(Unit::ONE - unit_product(steepest, steepest)).to_bits();
    (turn < least).then(|| {
        let angle = ratio(unsigned(turn), unsigned(least));
        [angle, least, square_root(whole)]
            .map(Unit::from_bits)
            .into()
    })
}

/// Returns an upper bound of the distance of a curve from its chord. It turns by an angle τ, given as [`turn_in_plane`]
/// returns it. `half` is half of the chord.
///
/// The curve lies in the triangle of its chord and its tangents, whose height is at most half the chord times tan(τ / 2).
/// A plane cuts spheres and cylinders in ellipses, and an ellipse has at most half of that height. Up to 60 degrees,
/// tan(τ / 2) / 2 is at most 5/16 of 2 sin(τ / 2).
fn bulge(half: i32, angle: Unit) -> i32 {
    scaled_by_unit(half + (half >> 2), angle) / 4 + 1
}

/// Returns the ball over the distance between two points, enlarged by `more`.
fn ball_over(one: Point, other: Point, more: i32) -> Ball {
    let way = one.to(other);
    let middle = Point::new(
        one.x + (way.x >> 1),
        one.y + (way.y >> 1),
        one.z + (way.z >> 1),
    );
    (middle, (square_root(way.square()) >> 1) + more + 8)
}

#[cfg(test)]
mod tests;
