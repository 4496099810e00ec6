//! Whether all paths between two traced ones surely meet the same shapes, lit by the same lights.
//!
//! It is known for the first hit, and for the second if a plane mirrored the path: these rays start at one
//! eye and lie in one plane. docs/edges.md has the proof.

use super::{PathQuality, Stop, Stops, Tracer};
use crate::accel::light_occluders::LightOccluders;
use crate::accel::stretch::{Body, Chord, Stretch};
use crate::accel::{LitStretch, Window, World, is_clear_way, lights_all};
use crate::material::PreparedMaterial;
use crate::number::{
    Brightness, Unit, narrowed, ratio, root_of_unit, scaled_by_unit, square_root, unit_product,
    unsigned, unsigned_wide, wide,
};
use crate::ray::ScaledPoint;
use crate::scene::access::ShapeId;
use crate::shade::highlight::sealed::Shading;
use crate::shade::{Glance, is_little};
use crate::shape::bordered::{Ball, Rays};
use crate::shape::plane::PreparedPlane;
use crate::vector::{Direction, Point};

/// Pixels between two traced ones: the window of the row, and the columns of the two.
pub(crate) type Between<'a> = (&'a Window, [u32; 2]);

/// Largest change of a direction, the normal or that to a light, for which three pixels show how diffuse light
/// changes: about 20 degrees.
const LARGEST_TURN: Unit = Unit::from_bits(3 << 27);

/// How much is proved of the paths of a stretch. It holds for each part of the stretch, too.
#[derive(Clone, Copy, Debug)]
pub(crate) struct Progress {
    /// Number of hits that are proved.
    hits: usize,
    /// Of the next hit, 0 if nothing is proved, else 1 + the number of lights.
    steps: usize,
}

impl Progress {
    /// Nothing is proved.
    pub(crate) const NONE: Self = Self { hits: 0, steps: 0 };
}

/// Where the rays of a stretch come from.
#[derive(Clone, Copy)]
struct Origin<'a> {
    /// The camera, or its image in one plane after another.
    eye: Point,
    /// Normal of the plane in which the rays lie.
    row: Direction,
    /// Number of reflections.
    level: usize,
    /// The plane that mirrored the rays last.
    mirror: Option<(ShapeId, &'a PreparedPlane)>,
}

/// The surface that a stretch shows.
struct Shown<'a> {
    material: &'a PreparedMaterial,
    lit: LitStretch,
    /// Normals at the two ends.
    normals: [Direction; 2],
    /// Length of their difference.
    turn: Unit,
    /// Ball around all points, if they are near.
    ball: Option<Ball>,
    eye: Point,
}

impl<'a, W: World, K: Shading, Q: PathQuality> Tracer<'a, W, K, Q> {
    /// Tests whether all paths between two traced ones surely meet the same shapes, lit by the same lights, as
    /// far as the paths have known bounds. The two have equal signatures. `proved` is known before, and gets
    /// what is proved now.
    #[inline(never)]
    pub(crate) fn is_steady(
        &mut self,
        between: Between<'_>,
        ends: [&Stops; 2],
        proved: &mut Progress,
    ) -> bool {
        let parts = self.world.parts();
        let Some((eye, row)) = self.culling.eye() else {
            return false;
        };
        let mut origin = Origin {
            eye,
            row,
            level: 0,
            mirror: None,
        };
        let [start, end] = ends.map(Stops::all);
        for (first, last) in start.iter().zip(end) {
            let is_one = first.shape == last.shape && first.is_inside == last.is_inside;
            if !is_one {
                return false;
            }
            if origin.level == proved.hits {
                match self.keeps_shape(between, &origin, [first, last], proved.steps) {
                    Ok(()) => {
                        *proved = Progress {
                            hits: proved.hits + 1,
                            steps: 0,
                        }
                    }
                    Err(steps) => {
                        proved.steps = steps;
                        return false;
                    }
                }
            }
            let Some(plane) = parts.plane(first.shape) else {
                return true;
            };
            let mirrors = K::REFLECTS && parts.material(plane.material).mirrors();
            if !mirrors {
                return true;
            }
            // Rays that a far point mirrors have no known bounds.
            let is_near = first.place.is_near() && last.place.is_near();
            let image = plane.mirrored(origin.eye, parts.epsilon);
            let Some(eye) = image.filter(|_| is_near) else {
                return false;
            };
            origin = Origin {
                eye,
                row: origin
                    .row
                    .reflected(plane.normal, origin.row.dot(plane.normal)),
                level: origin.level + 1,
                mirror: Some((first.shape, plane)),
            };
        }
        // Hits that are not stored make the signature coarse.
        true
    }

    /// Tests whether all rays between two hit the same shape, lit by the same lights. `steps` are proved
    /// before. Returns how many are if not all are.
    fn keeps_shape(
        &mut self,
        between: Between<'_>,
        origin: &Origin<'_>,
        stops: [&Stop; 2],
        steps: usize,
    ) -> Result<(), usize> {
        let [first, _] = stops;
        let parts = self.world.parts();
        let stretch = Stretch {
            columns: between.1,
            shape: first.shape,
            body: Body::None,
            chord: None,
            reach: None,
            mirror: origin.mirror.map(|(_, plane)| plane),
        };
        if first.shape == ShapeId::NONE {
            if origin.level < 2 {
                return sure(self.keeps(between, origin, &stretch), 0);
            }
            let beyond = LitStretch {
                shape: ShapeId::NONE,
                is_hollow: false,
                bulge: 0,
                slack: 0,
                ends: stops.map(|stop| stop.place),
            };
            return sure(is_clear_way(self.world, origin.eye, &beyond), 0);
        }
        let Some(shown) = self.shown(origin, stops) else {
            return Err(steps);
        };
        let keeps = if steps > 0 || !parts.has_bounded() {
            true
        } else if origin.level > 1 {
            shown.ball.is_some() && is_clear_way(self.world, origin.eye, &shown.lit)
        } else {
            let body = match parts.plane(first.shape) {
                Some(plane) => Body::Plane(plane),
                None => match parts.ball(first.shape.index()) {
                    Some((ball, _)) => Body::Ball(ball),
                    None => Body::None,
                },
            };
            // The curve is not further from the eye than its chord.
            let [one, other] =
                stops.map(|stop| square_root(origin.eye.to(stop.place.point).square()));
            let reach = one.max(other) + shown.lit.slack;
            let stretch = Stretch {
                body,
                chord: shown.ball.map(|ball| Chord {
                    ball,
                    ends: stops.map(|stop| stop.place.point),
                    bulge: shown.lit.bulge + shown.lit.slack,
                }),
                reach: (!shown.lit.is_hollow).then_some(reach),
                ..stretch
            };
            self.keeps(between, origin, &stretch)
        };
        sure(keeps, 0)?;
        self.keeps_lights(&shown, steps.max(1))
    }

    /// Tests whether no other shape comes to the front in a stretch.
    fn keeps(&mut self, between: Between<'_>, origin: &Origin<'_>, stretch: &Stretch<'_>) -> bool {
        self.culling
            .keeps(self.world, origin.mirror, between.0, stretch)
    }

    /// Returns the surface that a stretch shows. `None` if it turns too much.
    fn shown(&self, origin: &Origin<'_>, stops: [&Stop; 2]) -> Option<Shown<'a>> {
        let parts = self.world.parts();
        let [first, last] = stops.map(|stop| {
            let (outward, material) = parts.outside(stop.shape, stop.place.point)?;
            Some((outward.reversed_if(stop.is_inside), material))
        });
        let ((one, material), (other, _)) = (first?, last?);
        let [first, last] = stops;
        let is_curved = !parts.is_flat(first.shape);
        let mut shown = Shown {
            material: parts.material(material),
            lit: LitStretch {
                shape: first.shape,
                is_hollow: is_curved && first.is_inside,
                bulge: 0,
                slack: 0,
                ends: [first.place, last.place],
            },
            normals: [one, other],
            turn: Unit::ZERO,
            ball: None,
            eye: origin.eye,
        };
        if first.place.is_near() && last.place.is_near() {
            let epsilon = parts.epsilon.to_bits().max(parts.inner_epsilon.to_bits());
            let ball = ball_over(first.place.point, last.place.point, 2 * epsilon);
            shown.ball = Some(ball);
            shown.lit.slack = 2 * epsilon + 8;
            if is_curved {
                let turn = turn_in_plane([one, other], origin.row)?;
                // The curve lies in the triangle of its chord and its tangents. With the angle τ between
                // them its height is at most half the chord times tan(τ / 2).
                shown.lit.bulge = scaled_by_unit(ball.1 + (ball.1 >> 2), turn) / 2 + 1;
                let change = other.raw().minus(one.raw()).square();
                shown.turn = Unit::from_bits(square_root(change));
            }
        }
        Some(shown)
    }

    /// Tests whether each light shines on a whole stretch or on nothing of it, with a highlight that can be
    /// interpolated. `steps` are proved before. Returns how many are if not all are.
    fn keeps_lights(&self, shown: &Shown<'_>, steps: usize) -> Result<(), usize> {
        let lights = self.world.tables().light_occluders;
        for (index, light) in lights.iter().enumerate().skip(steps - 1) {
            let is_hidden = self.visibility.is_hidden(index);
            sure(
                is_hidden || self.keeps_light(shown, light, index),
                1 + index,
            )?;
        }
        Ok(())
    }

    /// Tests whether a light shines on a whole stretch or on nothing of it, with a highlight that can be
    /// interpolated.
    fn keeps_light(
        &self,
        shown: &Shown<'_>,
        light: &LightOccluders<W::Room>,
        index: usize,
    ) -> bool {
        let world = self.world;
        let has_shadows = K::SHADOWS && W::NEEDS.shadows && world.parts().has_bounded();
        let has_highlight = W::NEEDS.highlights && shown.material.specular > Brightness::ZERO;
        let place = light.light().place;
        let ([first, last], [one, other]) = (shown.lit.ends, shown.normals);
        let faces = |end: ScaledPoint, normal| end.to(place).0.dot(normal) > 0;
        match [faces(first, one), faces(last, other)] {
            [false, false] => return true,
            [true, true] => {}
            _ => return false,
        }
        let rays = Rays::new(place, shown.lit.ends);
        if rays.turn() > LARGEST_TURN || shown.turn > LARGEST_TURN {
            return false;
        }
        if has_shadows {
            if !self.visibility.is_clear(index) {
                return false;
            }
            match lights_all::<W, Q>(world, (light, index), &shown.lit, &rays) {
                None => return false,
                Some(false) => return true,
                Some(true) => {}
            }
        }
        !has_highlight || shown.keeps_highlight::<K>(&rays)
    }
}

impl Shown<'_> {
    /// Tests whether the highlight of a light can be interpolated. `rays` are those of the light.
    fn keeps_highlight<K: Shading>(&self, rays: &Rays) -> bool {
        if self.is_surely_smooth::<K>(rays) {
            return true;
        }
        let eye = ScaledPoint {
            point: self.eye,
            scale: 0,
        };
        let glance = |normal, end, along| Glance {
            normal,
            view: eye.to(end).0.direction_and_length().0,
            along,
        };
        let ([first, last], [one, other]) = (self.lit.ends, self.normals);
        let [start, end] = rays.ends;
        let glances = [glance(one, first, start), glance(other, last, end)];
        K::is_smooth(&glances, self.material.shininess)
    }

    /// Tests whether a highlight surely changes little, from bounds of the changes of the normal and of the
    /// directions to the light and to the eye.
    ///
    /// The direction to the eye changes by at most the diameter of the ball over the distance. The half-way
    /// vector is the sum of both directions over its length, which is at least the sum of their cosines to
    /// the normal.
    fn is_surely_smooth<K: Shading>(&self, rays: &Rays) -> bool {
        let Some((middle, radius)) = self.ball else {
            return false;
        };
        let (view, distance) = self.eye.to(middle).direction_and_length();
        let distance = distance.to_bits();
        if distance >> 3 <= radius {
            return false;
        }
        let [first, _] = rays.ends;
        let light = rays.turn().to_bits();
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

/// Returns an error with the number of steps before if a step is not proved.
fn sure(is_proved: bool, steps: usize) -> Result<(), usize> {
    match is_proved {
        true => Ok(()),
        false => Err(steps),
    }
}

/// Returns an upper bound of the angle by which a curve in a plane turns between two points, as the length
/// of a chord of the unit circle, Q2.30. The curve lies on a surface with these normals. `None` if it may
/// turn by more than 60 degrees.
fn turn_in_plane([one, other]: [Direction; 2], plane: Direction) -> Option<Unit> {
    let change = other.raw().minus(one.raw());
    let across = change.dot(plane);
    let square = change
        .square()
        .saturating_sub(unsigned_wide(wide(across, across)));
    let turn = square_root(square) + 4;
    let steepest = one
        .dot(plane)
        .to_bits()
        .abs()
        .max(other.dot(plane).to_bits().abs());
    let steepest = Unit::from_bits(steepest.min(Unit::ONE.to_bits()));
    let least = root_of_unit(Unit::ONE - unit_product(steepest, steepest)).to_bits();
    (turn < least).then(|| Unit::from_bits(ratio(unsigned(turn), unsigned(least))))
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
