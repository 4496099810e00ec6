mod borders;
mod fans;

use super::super::LIFT;
use super::*;
use crate::number::sweep::Sweep;
use crate::ray::{Ray, ScaledPoint};
use crate::shape::fixture::*;

const RADIUS: i32 = 1 << 24;

impl PreparedSphere {
    /// Returns the distance at which the ray enters the sphere, or else leaves it, above 0 and below
    /// `reach`.
    pub(crate) fn intersect_alone(&self, ray: &Ray, reach: Length) -> Option<Length> {
        let way = ray.origin.to(self.center);
        if way.dot(ray.direction) < -self.radius {
            return None;
        }
        let start = Length::from_bits(0);
        self.met(way, ray.direction, Range { start, reach })
    }
}

fn sphere(center: [i32; 3], radius: i32) -> PreparedSphere {
    PreparedSphere::new(point(center), Length::from_bits(radius), MaterialId(0))
}

/// Returns the distance, in steps, at which a ray hits the sphere of [`RADIUS`] around the middle of the
/// scene.
fn met(origin: [i32; 3], towards: [i32; 3]) -> Option<i32> {
    steps(sphere([0; 3], RADIUS).intersect_alone(&ray(origin, towards), EVERYWHERE))
}

/// Returns, in double precision, the distances at which the line of a ray hits a sphere, in order, and
/// the distance from the line to the sphere's centre.
fn in_double_precision(sphere: &PreparedSphere, ray: &Ray) -> (Vec<f64>, f64) {
    let center = in_doubles(ray.origin.to(sphere.center));
    let along = unit(in_doubles(ray.direction.raw()));
    let middle = dot(center, along);
    let aside = length(plus(center, -middle, along));
    let radius = f64::from(sphere.radius);
    (roots(middle, radius * radius - aside * aside), aside)
}

/// Returns random spheres with radii from 64 steps to half of the ball, each with a ray from a near
/// point that hits it or passes it.
fn pairs(seed: u64) -> impl Iterator<Item = (PreparedSphere, Ray)> {
    let mut sweep = Sweep::new(seed);
    (0..200_000).map(move |_| {
        let (center, radius) = (sweep.triple(1 << 27), sweep.octaves(6, 27));
        (
            sphere(center, radius),
            ray_towards(&mut sweep, center, radius),
        )
    })
}

#[test]
fn sphere_in_front_is_met_on_its_near_side() {
    // The root of 2^48 has a relative error of at most 2^-27 and is rounded down.
    for (axis, sign) in [(0, 1), (0, -1), (1, 1), (1, -1), (2, 1), (2, -1)] {
        let (mut origin, mut towards) = ([0; 3], [0; 3]);
        (origin[axis], towards[axis]) = (-4 * sign * RADIUS, sign);
        let distance = met(origin, towards).unwrap();
        assert!(
            (3 * RADIUS..=3 * RADIUS + 1).contains(&distance),
            "{axis} {sign}: {distance}"
        );
    }
}

#[test]
fn sphere_behind_is_missed() {
    assert_eq!(met([4 * RADIUS, 0, 0], [1, 0, 0]), None);
    assert_eq!(met([RADIUS + 1, 0, 0], [1, 0, 0]), None);
    assert_eq!(met([RADIUS + 1, 0, 0], [1, 5, -9]), None);
}

#[test]
fn ray_from_inside_meets_the_far_side() {
    for (start, truth) in [
        (0, RADIUS),
        (RADIUS / 2, RADIUS / 2),
        (-RADIUS / 2, 3 * RADIUS / 2),
    ] {
        let distance = met([start, 0, 0], [1, 0, 0]).unwrap();
        assert!(
            (truth - 1..=truth).contains(&distance),
            "from {start}: {distance}"
        );
    }
}

#[test]
fn tangent_is_met_where_it_touches_and_missed_a_step_further_out() {
    let touching = [-4 * RADIUS, RADIUS, 0];
    assert_eq!(met(touching, [1, 0, 0]), Some(4 * RADIUS));
    assert_eq!(met([-4 * RADIUS, RADIUS + 1, 0], [1, 0, 0]), None);
    assert!(sphere([0; 3], RADIUS).blocks(&ray(touching, [1, 0, 0]), Length::from_bits(i32::MAX)));
}

#[test]
fn reach_ends_before_the_distance_it_names() {
    let sphere = sphere([0; 3], RADIUS);
    let ray = ray([-4 * RADIUS, 0, 0], [1, 0, 0]);
    let distance = sphere.intersect_alone(&ray, EVERYWHERE).unwrap();
    assert_eq!(sphere.intersect_alone(&ray, distance), None);
    let further = Length::from_bits(distance.to_bits() + 1);
    assert_eq!(sphere.intersect_alone(&ray, further), Some(distance));
    for (reach, blocks) in [(-2, false), (0, false), (1, true), (2, true)] {
        let reach = Length::from_bits(3 * RADIUS + reach);
        assert_eq!(sphere.blocks(&ray, reach), blocks, "{reach:?}");
    }
}

#[test]
fn blocks_agrees_with_intersect() {
    let mut sweep = Sweep::new(2);
    let mut counts = [0; 2];
    for (sphere, ray) in pairs(3) {
        let reach = Length::from_bits(sweep.within(1, 1 << 30));
        let (roots, aside) = in_double_precision(&sphere, &ray);
        // The two tests may differ only where rounding decides.
        let at_an_end =
            |root: &f64| root.abs() <= SLACK || (root - f64::from(reach.to_bits())).abs() <= SLACK;
        let at_the_rim = (aside - f64::from(sphere.radius)).abs() <= SLACK;
        let blocks = sphere.blocks(&ray, reach);
        counts[usize::from(blocks)] += 1;
        assert!(
            blocks == sphere.intersect_alone(&ray, reach).is_some()
                || at_the_rim
                || roots.iter().any(at_an_end),
            "{sphere:?} {ray:?} {reach:?}"
        );
    }
    assert!(counts.into_iter().all(|count| count > 20_000), "{counts:?}");
}

#[test]
fn every_sphere_is_met_where_double_precision_meets_it() {
    let (mut hits, mut misses) = (0, 0);
    for (sphere, ray) in pairs(4) {
        let (roots, aside) = in_double_precision(&sphere, &ray);
        let radius = f64::from(sphere.radius);
        if (aside - radius).abs() <= SLACK {
            continue;
        }
        let truth = roots.iter().copied().find(|root| *root > 0.0);
        let found = steps(sphere.intersect_alone(&ray, EVERYWHERE)).map(f64::from);
        assert_eq!(found.is_some(), truth.is_some(), "{sphere:?} {ray:?}");
        let (Some(found), Some(truth)) = (found, truth) else {
            misses += 1;
            continue;
        };
        hits += 1;
        // If the line is known to 2 steps, a half chord of length c is known to 2 r / c steps.
        let half_chord = (roots[1] - roots[0]) / 2.0;
        let bound = SLACK + 2.0 * radius / half_chord;
        assert!(
            (found - truth).abs() <= bound,
            "{found}, not {truth}: {sphere:?} {ray:?}"
        );
    }
    assert!(hits > 50_000 && misses > 20_000, "{hits} {misses}");
}

#[test]
fn sphere_that_is_met_is_left_out_by_nothing() {
    let (mut met, mut passed_by, mut left_out) = (0, 0, 0);
    for (sphere, ray) in pairs(10) {
        let way = ray.origin.to(sphere.center);
        let passes_by = way.passes_by(ray.direction, sphere.radius);
        let seen = sphere.seen_from_eye(ray.origin);
        let may_be_met = seen.may_be_met(ray.direction);
        passed_by += u32::from(passes_by);
        left_out += u32::from(!may_be_met);
        if sphere.intersect_alone(&ray, EVERYWHERE).is_some() {
            met += 1;
            assert!(!passes_by && may_be_met, "{sphere:?} {ray:?}");
        }
    }
    assert!(
        met > 50_000 && passed_by > 15_000 && left_out > 15_000,
        "{met} {passed_by} {left_out}"
    );
}

#[test]
fn hit_lies_on_its_sphere() {
    let mut hits = 0;
    for (sphere, ray) in pairs(5) {
        let Some(distance) = sphere.intersect_alone(&ray, EVERYWHERE) else {
            continue;
        };
        hits += 1;
        let outward = sphere.center.to(ray.origin.along(ray.direction, distance));
        let off = length(in_doubles(outward)) - f64::from(sphere.radius);
        assert!(off.abs() <= SLACK, "{off} steps: {sphere:?} {ray:?}");
    }
    assert!(hits > 50_000, "{hits}");
}

#[test]
fn normal_points_away_from_the_centre_and_has_length_one() {
    let mut sweep = Sweep::new(6);
    for _ in 0..100_000 {
        let radius = sweep.octaves(6, 28);
        let outward = any_direction(&mut sweep);
        let sphere = sphere([0; 3], radius);
        let at = Point::ORIGIN.along(outward, Length::from_bits(radius));
        let (normal, truth) = (
            in_doubles(sphere.normal(at).raw()),
            in_doubles(at.to_vector()),
        );
        let normal = normal.map(|coordinate| coordinate / 2f64.powi(30));
        // Coordinates are rounded down to 2^-28; a short normal is normalised to the last places.
        let short = u32::from(sphere.lift) > LIFT;
        let rounded = 2.0 * 2f64.powi(if short { -29 } else { -28 });
        // The normal is too long by the same factor as the vector from the centre to the hit. Rounding
        // three coordinates down to even steps changes that vector by at most √12.
        let own = if short { 1.0 } else { length(truth) / f64::from(radius) };
        let long = length(normal) - own;
        assert!(long.abs() <= rounded, "{long:e}: {radius} {outward:?}");
        assert!((own - 1.0).abs() <= 2f64.powi(-16), "{own}: {radius}");
        let aside = length(plus(unit(normal), -1.0, unit(truth)));
        assert!(aside <= rounded, "{aside:e}: {radius} {outward:?}");
    }
}

/// Returns the point from which a ray leaves after it hits the sphere, and the normal there. The point
/// is 16 steps above the surface, on the side from which the ray came.
fn left(sphere: &PreparedSphere, ray: &Ray) -> Option<(Point, Direction)> {
    let distance = sphere.intersect_alone(ray, EVERYWHERE)?;
    let at = ray.origin.along(ray.direction, distance);
    let outward = sphere.normal(at);
    let climbs = ray.direction.dot(outward).to_bits() > 0;
    let normal = if climbs { outward.reversed() } else { outward };
    Some((
        ScaledPoint::new(at, 0)
            .lifted(normal, Length::from_bits(16))
            .point,
        normal,
    ))
}

#[test]
fn ray_leaving_a_sphere_misses_it() {
    let mut sweep = Sweep::new(7);
    let mut left_outside = 0;
    for (sphere, arriving) in pairs(8) {
        let Some((origin, normal)) = left(&sphere, &arriving) else {
            continue;
        };
        if sphere.normal(origin) != normal && sphere.normal(origin).dot(normal).to_bits() < 0 {
            continue; // The ray hits the sphere from inside.
        }
        left_outside += 1;
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
                sphere.intersect_alone(&leaving, EVERYWHERE),
                None,
                "{sphere:?} {leaving:?}"
            );
            assert!(
                !sphere.blocks(&leaving, EVERYWHERE),
                "{sphere:?} {leaving:?}"
            );
        }
    }
    assert!(left_outside > 50_000, "{left_outside}");
}

#[test]
fn ray_leaving_the_inside_of_a_sphere_crosses_it() {
    let mut sweep = Sweep::new(9);
    for _ in 0..50_000 {
        let radius = sweep.octaves(12, 28);
        let sphere = sphere([0; 3], radius);
        let arriving = Ray {
            origin: Point::ORIGIN,
            direction: any_direction(&mut sweep),
        };
        let (origin, normal) = left(&sphere, &arriving).unwrap();
        let any = any_direction(&mut sweep);
        let upward = if any.dot(normal).to_bits() < 0 { any.reversed() } else { any };
        let leaving = Ray {
            origin,
            direction: upward,
        };
        let distance = f64::from(
            sphere
                .intersect_alone(&leaving, EVERYWHERE)
                .unwrap()
                .to_bits(),
        );
        let (roots, _) = in_double_precision(&sphere, &leaving);
        let bound = SLACK + 4.0 * f64::from(radius) / (roots[1] - roots[0]);
        assert!(
            (distance - roots[1]).abs() <= bound,
            "{distance}: {roots:?} {leaving:?}"
        );
    }
}

#[test]
fn ray_from_the_surface_outwards_is_not_blocked_though_it_starts_some_steps_inside() {
    let radius = 1 << 20;
    let sphere = PreparedSphere::new(Point::ORIGIN, Length::from_bits(radius), MaterialId(0));
    let reach = Length::from_bits(1 << 24);
    for (inside, is_blocked) in [(-2, false), (1, false), (3, false), (6, true), (100, true)] {
        let ray = Ray {
            origin: Point::new(radius - inside, 0, 0),
            direction: Direction::X,
        };
        assert_eq!(
            sphere.blocks(&ray, reach),
            is_blocked,
            "{inside} steps inside"
        );
    }
}
