mod borders;
mod fans;

use super::super::LIFT;
use super::intersect::{STEEP, root_of_lifted};
use super::*;
use crate::number::sweep::Sweep;
use crate::ray::ScaledPoint;
use crate::shape::fixture::*;

const RADIUS: i32 = 1 << 24;
const HALF_HEIGHT: i32 = 1 << 25;

fn cylinder(center: [i32; 3], axis: Direction, radius: i32, half: i32) -> PreparedCylinder {
    let (radius, half) = (Length::from_bits(radius), Length::from_bits(half));
    PreparedCylinder::new(point(center), axis, radius, half, MaterialId(0))
}

/// Creates an upright cylinder around the middle of the scene.
fn tube() -> PreparedCylinder {
    cylinder([0; 3], direction([0, 0, 1]), RADIUS, HALF_HEIGHT)
}

/// Returns the distance at which a ray hits the wall. Does not test the ball around the cylinder.
fn intersect(cylinder: &PreparedCylinder, ray: &Ray, reach: Length) -> Option<Length> {
    let seen = cylinder.seen_from(ray.origin);
    let start = Length::from_bits(0);
    cylinder.intersect_from(&seen, &ray.direction, Range { start, reach })
}

fn met(origin: [i32; 3], towards: [i32; 3]) -> Option<i32> {
    steps(intersect(&tube(), &ray(origin, towards), EVERYWHERE))
}

/// Asserts that a ray hits the upright cylinder at the distance `truth`, in steps. The allowed error is that
/// of three factors, each rounded to 2⁻³⁰ to 2⁻²⁷.
fn assert_met(origin: [i32; 3], towards: [i32; 3], truth: i32) {
    let distance = met(origin, towards).unwrap();
    assert!((distance - truth).abs() <= 4, "{distance}, not {truth}");
}

/// Hits of a ray on a cylinder, computed in double precision.
struct Truth {
    /// Distances at which the ray's line hits the infinite cylinder, in order.
    roots: Vec<f64>,
    /// For each root, the height of the hit beyond the rim, in steps; negative on the wall.
    beyond: Vec<f64>,
    /// Distance between the lines of ray and axis, in steps.
    aside: f64,
    /// Sine of the angle between ray and axis.
    sine: f64,
}

impl Truth {
    fn new(cylinder: &PreparedCylinder, ray: &Ray) -> Self {
        let axis = unit(in_doubles(cylinder.axis.raw()));
        let center = in_doubles(ray.origin.to(cylinder.center));
        let along = unit(in_doubles(ray.direction.raw()));
        let flat = |vector: Triple| plus(vector, -dot(vector, axis), axis);
        let square = dot(flat(along), flat(along));
        let middle = dot(flat(center), flat(along)) / square;
        let aside = length(plus(flat(center), -middle, flat(along)));
        let roots = roots(
            middle,
            (f64::from(cylinder.radius).powi(2) - aside * aside) / square,
        );
        let height = |root: &f64| (dot(along, axis) * root - dot(center, axis)).abs();
        let beyond = roots
            .iter()
            .map(|root| height(root) - f64::from(cylinder.half_height));
        Self {
            beyond: beyond.collect(),
            roots,
            aside,
            sine: square.sqrt(),
        }
    }

    /// Returns the error along the ray, in steps, that one step of rounding causes: 1 / sine for rays
    /// almost parallel to the axis, and 1 / sine² for others, because they divide lengths across the
    /// axis by sine².
    fn stretch(&self) -> f64 {
        if self.sine * self.sine * 2f64.powi(30) < f64::from(STEEP) {
            1.0 / self.sine
        } else {
            1.0 / (self.sine * self.sine)
        }
    }

    fn nearest(&self) -> Option<f64> {
        let on_the_wall = self.roots.iter().zip(&self.beyond);
        on_the_wall
            .filter(|(root, beyond)| **root > 0.0 && **beyond <= 0.0)
            .map(|(r, _)| *r)
            .next()
    }

    /// Tests whether rounding decides if a root counts as a hit. Rounding is a few steps across the
    /// axis.
    fn is_close_call(&self, cylinder: &PreparedCylinder) -> bool {
        let slack = SLACK / self.sine;
        (self.aside - f64::from(cylinder.radius)).abs() <= SLACK
            || self.roots.iter().any(|root| root.abs() <= slack)
            || self.beyond.iter().any(|beyond| beyond.abs() <= slack)
    }
}

/// Returns random cylinders with radii from 64 steps to half of the ball, each with a ray from a near
/// point that hits it or passes it.
fn pairs(seed: u64) -> impl Iterator<Item = (PreparedCylinder, Ray)> {
    let mut sweep = Sweep::new(seed);
    (0..200_000).map(move |_| {
        let center = sweep.triple(1 << 26);
        let axis = any_direction(&mut sweep).renormalised();
        let (radius, half) = (sweep.octaves(6, 27), sweep.octaves(6, 27));
        let ray = ray_towards(&mut sweep, center, radius.max(half));
        (cylinder(center, axis, radius, half), ray)
    })
}

#[test]
fn cylinder_in_front_is_met_on_its_near_side() {
    assert_met([-4 * RADIUS, 0, 0], [1, 0, 0], 3 * RADIUS);
    assert_met([0, 4 * RADIUS, 0], [0, -1, 0], 3 * RADIUS);
    // The ray goes three across and four up: its length is 5/3 of that across.
    assert_met([-4 * RADIUS, 0, -4 * RADIUS], [3, 0, 4], 5 * RADIUS);
}

#[test]
fn cylinder_behind_is_missed() {
    assert_eq!(met([4 * RADIUS, 0, 0], [1, 0, 0]), None);
    assert_eq!(met([RADIUS + 1, 0, 0], [1, 0, 0]), None);
    assert_eq!(met([RADIUS + 1, 0, 0], [1, 7, 3]), None);
}

#[test]
fn ray_from_inside_meets_the_wall() {
    assert_met([0; 3], [0, 1, 0], RADIUS);
    assert_met([RADIUS / 2, 0, 0], [-1, 0, 0], 3 * RADIUS / 2);
}

#[test]
fn ray_through_the_open_ends_meets_nothing() {
    for origin in [[0, 0, 4 * RADIUS], [RADIUS / 2, 9, 4 * RADIUS], [0; 3]] {
        assert_eq!(
            met(origin, [0, 0, -1]),
            None,
            "along the axis from {origin:?}"
        );
    }
    assert_eq!(met([0, 0, 4 * RADIUS], [1, 0, -9]), None);
}

#[test]
fn ray_through_one_open_end_meets_the_wall_from_inside() {
    // From the axis, two half heights up. The wall is one radius across.
    let distance = met([0, 0, 2 * HALF_HEIGHT], [3, 0, -10]).unwrap();
    let truth = f64::from(RADIUS) * (9.0_f64 + 100.0).sqrt() / 3.0;
    assert!(
        (f64::from(distance) - truth).abs() <= SLACK,
        "{distance}, not {truth}"
    );
}

#[test]
fn wall_ends_at_its_rim() {
    for (height, is_met) in [
        (0, true),
        (1, false),
        (-2 * HALF_HEIGHT, true),
        (-2 * HALF_HEIGHT - 1, false),
    ] {
        let origin = [-4 * RADIUS, 0, HALF_HEIGHT + height];
        assert_eq!(
            met(origin, [1, 0, 0]).is_some(),
            is_met,
            "{height} above the rim"
        );
    }
}

#[test]
fn tangent_is_met_where_it_touches_and_missed_two_steps_further_out() {
    // A line one step further in has a half chord of √(2 r). Three more steps are for rounding.
    let half_chord = f64::from(2 * RADIUS).sqrt() as i32 + 3;
    let distance = met([-4 * RADIUS, RADIUS, 0], [1, 0, 0]).unwrap();
    assert!(
        (4 * RADIUS - half_chord..=4 * RADIUS).contains(&distance),
        "{distance}"
    );
    assert_eq!(met([-4 * RADIUS, RADIUS + 2, 0], [1, 0, 0]), None);
}

#[test]
fn reach_ends_before_the_distance_it_names() {
    let ray = ray([-4 * RADIUS, 0, 0], [1, 0, 0]);
    let distance = intersect(&tube(), &ray, EVERYWHERE).unwrap();
    assert_eq!(intersect(&tube(), &ray, distance), None);
    assert!(!tube().blocks(&ray, distance));
    let further = Length::from_bits(distance.to_bits() + 1);
    assert_eq!(intersect(&tube(), &ray, further), Some(distance));
    assert!(tube().blocks(&ray, further));
}

#[test]
fn blocks_agrees_with_intersect() {
    let mut sweep = Sweep::new(1);
    let mut counts = [0; 2];
    for (cylinder, ray) in pairs(2) {
        let reach = Length::from_bits(sweep.within(1, 1 << 30));
        let blocks = cylinder.blocks(&ray, reach);
        counts[usize::from(blocks)] += 1;
        let truth = Truth::new(&cylinder, &ray);
        let reach_in_steps = f64::from(reach.to_bits());
        let at_the_end = |root: &f64| (root - reach_in_steps).abs() <= SLACK / truth.sine;
        assert!(
            blocks == intersect(&cylinder, &ray, reach).is_some()
                || truth.is_close_call(&cylinder)
                || truth.roots.iter().any(at_the_end),
            "{cylinder:?} {ray:?} {reach:?}"
        );
    }
    assert!(counts.into_iter().all(|count| count > 10_000), "{counts:?}");
}

#[test]
fn every_cylinder_is_met_where_double_precision_meets_it() {
    let (mut hits, mut misses) = (0, 0);
    for (cylinder, ray) in pairs(3) {
        let truth = Truth::new(&cylinder, &ray);
        if truth.is_close_call(&cylinder) {
            continue;
        }
        let found = steps(intersect(&cylinder, &ray, EVERYWHERE)).map(f64::from);
        let nearest = truth.nearest();
        assert_eq!(found.is_some(), nearest.is_some(), "{cylinder:?} {ray:?}");
        let (Some(found), Some(nearest)) = (found, nearest) else {
            misses += 1;
            continue;
        };
        hits += 1;
        // If the line is known to 2 steps, a half chord of length c is known to 2 r / c steps.
        let half_chord = (truth.roots[1] - truth.roots[0]) / 2.0 * truth.sine;
        let radius = f64::from(cylinder.radius);
        let bound = (SLACK + 2.0 * radius / half_chord) * truth.stretch();
        assert!(
            (found - nearest).abs() <= bound,
            "{found}, not {nearest}: {cylinder:?} {ray:?}"
        );
    }
    assert!(hits > 15_000 && misses > 50_000, "{hits} {misses}");
}

#[test]
fn cylinder_that_is_met_is_not_passed_by() {
    let (mut met, mut passed_by) = (0, 0);
    for (cylinder, ray) in pairs(9) {
        let is_passed_by = cylinder.is_passed_by(&ray);
        passed_by += u32::from(is_passed_by);
        if intersect(&cylinder, &ray, EVERYWHERE).is_some() {
            met += 1;
            assert!(!is_passed_by, "{cylinder:?} {ray:?}");
        }
    }
    assert!(met > 15_000 && passed_by > 10_000, "{met} {passed_by}");
}

#[test]
fn hit_lies_on_its_cylinder() {
    let mut hits = 0;
    for (cylinder, ray) in pairs(4) {
        let Some(distance) = intersect(&cylinder, &ray, EVERYWHERE) else {
            continue;
        };
        hits += 1;
        let at = in_doubles(
            cylinder
                .center
                .to(ray.origin.along(ray.direction, distance)),
        );
        let axis = unit(in_doubles(cylinder.axis.raw()));
        let up = dot(at, axis);
        let off = length(plus(at, -up, axis)) - f64::from(cylinder.radius);
        // An error of `stretch` along the ray is an error of stretch · sine across the axis.
        let truth = Truth::new(&cylinder, &ray);
        let slack = 2.0 + SLACK * (truth.stretch() * truth.sine).max(1.0);
        assert!(off.abs() <= slack, "{off} steps off: {cylinder:?} {ray:?}");
        let beyond = up.abs() - f64::from(cylinder.half_height);
        assert!(
            beyond <= SLACK * truth.stretch().max(1.0),
            "{beyond} steps beyond: {cylinder:?} {ray:?}"
        );
    }
    assert!(hits > 15_000, "{hits}");
}

#[test]
fn ray_almost_along_the_axis_keeps_its_bits() {
    // From a point on the axis, the ray rises by 2^26 steps while it goes one radius across.
    for bits in 6..24 {
        let radius = 1 << bits;
        let cylinder = cylinder([0; 3], direction([0, 0, 1]), radius, 1 << 27);
        let inside = ray([0, 0, -(1 << 26)], [radius, 0, 1 << 26]);
        let distance = f64::from(intersect(&cylinder, &inside, EVERYWHERE).unwrap().to_bits());
        let truth = &Truth::new(&cylinder, &inside).roots[1];
        // One step across the axis is 1 / sine steps along the ray.
        let step = 2f64.powi(26) / f64::from(radius);
        assert!(
            (distance - truth).abs() <= 2.0 * step + 2.0,
            "{distance}, not {truth}"
        );
    }
}

#[test]
fn normal_points_away_from_the_axis_and_has_length_one() {
    let mut sweep = Sweep::new(5);
    for _ in 0..100_000 {
        let radius = sweep.octaves(10, 28);
        let axis = any_direction(&mut sweep).renormalised();
        let Some(outward) = axis.perpendicular(any_direction(&mut sweep)) else {
            continue;
        };
        let cylinder = cylinder([0; 3], axis, radius, 1 << 27);
        let foot = Point::ORIGIN.along(axis, Length::from_bits(sweep.within(-(1 << 27), 1 << 27)));
        let at = foot.along(outward, Length::from_bits(radius));
        let normal = in_doubles(cylinder.normal(at).raw());
        let normal = normal.map(|coordinate| coordinate / 2f64.powi(30));
        let along = unit(in_doubles(axis.raw()));
        let way = in_doubles(at.to_vector());
        let truth = plus(way, -dot(way, along), along);
        // The part along the axis is rounded down to a step, is known to 2^-28, and is subtracted with
        // three coordinates rounded down: 1 + 1/2 + √3 steps. The normal's coordinates are rounded down
        // to 2^-28; a short normal is normalised to the last places.
        let moved = 3.5 / f64::from(radius);
        let short = u32::from(cylinder.lift) > LIFT;
        let rounded = 2.0 * 2f64.powi(if short { -29 } else { -28 });
        let aside = length(plus(unit(normal), -1.0, unit(truth)));
        assert!(aside <= moved + rounded, "{aside:e}: {radius}");
        // The points on axis and wall are rounded to even steps, by at most √12 each. The normal is too
        // long by the same factor as the vector between them.
        let long = length(normal) - if short { 1.0 } else { length(truth) / f64::from(radius) };
        let moved = if short { 0.0 } else { moved };
        assert!(long.abs() <= moved + rounded, "{long:e}: {radius}");
        let off = length(truth) - f64::from(radius);
        assert!(off.abs() <= 2.0 * 12_f64.sqrt() + 0.5, "{off}: {radius}");
    }
}

#[test]
fn ray_leaving_a_cylinder_outward_misses_it() {
    let mut sweep = Sweep::new(6);
    let mut left_outside = 0;
    for (cylinder, arriving) in pairs(7) {
        let Some(distance) = intersect(&cylinder, &arriving, EVERYWHERE) else {
            continue;
        };
        let at = arriving.origin.along(arriving.direction, distance);
        let normal = cylinder.normal(at);
        if arriving.direction.dot(normal).to_bits() > 0 {
            continue; // The ray hits the wall from inside.
        }
        left_outside += 1;
        let origin = ScaledPoint::new(at, 0)
            .lifted(normal, Length::from_bits(16))
            .point;
        let any = any_direction(&mut sweep);
        let upward = if any.dot(normal).to_bits() < 0 { any.reversed() } else { any };
        // Reflected as at curved surfaces: renormalised, because the normal's length is not exactly one.
        let mirrored = arriving
            .direction
            .reflected(normal, arriving.direction.dot(normal))
            .renormalised();
        for direction in [upward, mirrored] {
            let leaving = Ray { origin, direction };
            assert_eq!(
                intersect(&cylinder, &leaving, EVERYWHERE),
                None,
                "{cylinder:?} {leaving:?}"
            );
            assert!(
                !cylinder.blocks(&leaving, EVERYWHERE),
                "{cylinder:?} {leaving:?}"
            );
        }
    }
    assert!(left_outside > 10_000, "{left_outside}");
}

#[test]
fn ray_leaving_the_inside_of_a_cylinder_crosses_it() {
    let mut sweep = Sweep::new(8);
    let (mut met, mut out_of_an_end) = (0, 0);
    for _ in 0..100_000 {
        let axis = any_direction(&mut sweep).renormalised();
        let cylinder = cylinder([0; 3], axis, sweep.octaves(12, 27), 1 << 27);
        let arriving = Ray {
            origin: Point::ORIGIN,
            direction: any_direction(&mut sweep),
        };
        let Some(distance) = intersect(&cylinder, &arriving, EVERYWHERE) else {
            continue;
        };
        let at = arriving.origin.along(arriving.direction, distance);
        let normal = cylinder.normal(at).reversed();
        let origin = ScaledPoint::new(at, 0)
            .lifted(normal, Length::from_bits(64))
            .point;
        let any = any_direction(&mut sweep);
        let upward = if any.dot(normal).to_bits() < 0 { any.reversed() } else { any };
        let leaving = Ray {
            origin,
            direction: upward,
        };
        let truth = Truth::new(&cylinder, &leaving);
        if truth.is_close_call(&cylinder) {
            continue;
        }
        let found = steps(intersect(&cylinder, &leaving, EVERYWHERE)).map(f64::from);
        assert_eq!(
            found.is_some(),
            truth.nearest().is_some(),
            "{cylinder:?} {leaving:?}"
        );
        let Some(found) = found else {
            out_of_an_end += 1;
            continue;
        };
        met += 1;
        let chord = (truth.roots[1] - truth.roots[0]) * truth.sine;
        // The square of half a chord is known to 2⁻²⁵ of the squared radius: 4 r / c steps.
        let bound = (SLACK + 8.0 * f64::from(cylinder.radius) / chord) * truth.stretch();
        assert!(
            (found - truth.roots[1]).abs() <= bound,
            "{found}: {:?} {leaving:?}",
            truth.roots
        );
    }
    assert!(
        met > 30_000 && out_of_an_end > 1000,
        "{met} {out_of_an_end}"
    );
}

#[test]
fn root_of_a_grazed_narrow_cylinder_is_nothing() {
    // A radius of 64 steps is shifted by 23: the root is shifted by more bits than it has.
    for square in [0, 1, 3, 1 << 9] {
        assert_eq!(root_of_lifted(square, 23), 0, "{square}");
    }
    // The lowest bit of the square is set; without a shift the root is right to a step.
    let root = f64::from(root_of_lifted(1 << 8, 0));
    let truth = 257_f64.sqrt() * 65536.0;
    assert!((root - truth).abs() <= 2.0, "{root} {truth}");
}

#[test]
fn ray_along_the_axis_may_be_longer_than_one() {
    let longer = Direction::from_raw(Vector::new(0, 0, (1 << 30) + 4));
    let ray = Ray {
        origin: point([0, 0, -2 * HALF_HEIGHT]),
        direction: longer,
    };
    assert_eq!(intersect(&tube(), &ray, EVERYWHERE), None);
}
