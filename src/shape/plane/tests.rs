use super::*;
use crate::number::sweep::Sweep;
use crate::number::unsigned;
use crate::ray::{ScaledPoint, ScaledRay};
use crate::shape::fixture::*;
use crate::vector::Vector;

impl PreparedPlane {
    /// Returns the distance at which the ray hits the plane, below `reach`.
    pub(crate) fn intersect(&self, ray: &Ray, reach: Length) -> Option<Length> {
        let approach = self.bearing(ray).approach()?;
        approach
            .is_before(&Approach::at(reach))
            .then(|| approach.distance())
    }
}

/// Converts a near ray to a scaled ray.
fn from_near(ray: &Ray) -> ScaledRay {
    ScaledRay::new(ScaledPoint::new(ray.origin, 0), ray.direction)
}

/// Creates the plane z = `height` steps.
fn floor_at(height: i32) -> PreparedPlane {
    plane(direction([0, 0, 1]), i64::from(height) << 30)
}

fn plane(normal: Direction, offset: i64) -> PreparedPlane {
    PreparedPlane::new(normal, offset, 0, MaterialId(0))
}

/// Returns random planes through the ball, each with a random ray from a near point.
fn pairs(seed: u64) -> impl Iterator<Item = (PreparedPlane, Ray)> {
    let mut sweep = Sweep::new(seed);
    (0..200_000).map(move |_| {
        let normal = any_direction(&mut sweep).renormalised();
        let through = point(sweep.triple(1 << 28));
        let plane = plane(normal, through.to_vector().dot_wide(normal));
        (plane, ray_towards(&mut sweep, [0; 3], 1 << 28))
    })
}

/// Returns the distance along a ray to a plane, in double precision; negative if the plane is behind.
fn in_double_precision(plane: &PreparedPlane, ray: &Ray) -> f64 {
    let normal = in_doubles(plane.normal.raw());
    let height = dot(in_doubles(ray.origin.to_vector()), normal) - plane.offset as f64;
    -height / dot(in_doubles(ray.direction.raw()), normal) * 2f64.powi(30)
}

/// Returns the largest error of a hit on a plane along the ray, in steps. A quotient is known to 2⁻²⁶
/// and rounded down, the height lost per step is known to 2⁻²⁸, and heights are known to a step.
fn known_to(plane: &PreparedPlane, ray: &Ray, distance: f64) -> f64 {
    let climb = ray.direction.dot(plane.normal).to_num::<f64>();
    2.0 + distance.abs() * (2f64.powi(-26) + 2f64.powi(-28) / climb.abs()) + 1.0 / climb.abs()
}

#[test]
fn plane_in_front_is_met_from_both_sides() {
    for (start, towards) in [(1 << 26, [0, 0, -1]), (-(1 << 26), [0, 0, 1])] {
        let found = floor_at(0).intersect(&ray([5, 7, start], towards), EVERYWHERE);
        // A quotient has a relative error of 2^-26.
        let distance = steps(found).unwrap();
        assert!((distance - (1 << 26)).abs() <= 1, "{distance}");
    }
}

#[test]
fn plane_behind_is_missed() {
    for (start, towards) in [
        (9, [0, 0, 1]),
        (1, [3, 4, 1]),
        (-9, [0, 0, -1]),
        (-1, [3, 4, -1]),
    ] {
        assert_eq!(
            floor_at(0).intersect(&ray([0, 0, start], towards), EVERYWHERE),
            None
        );
    }
}

#[test]
fn ray_along_a_plane_misses_it() {
    for height in [-9, 0, 9] {
        let along = ray([0, 0, height], [3, 4, 0]);
        assert_eq!(
            floor_at(0).intersect(&along, EVERYWHERE),
            None,
            "at height {height}"
        );
        assert!(
            !floor_at(0).blocks(&from_near(&along), EVERYWHERE, 0),
            "at height {height}"
        );
    }
}

#[test]
fn ray_from_inside_a_plane_misses_it() {
    for towards in [[0, 0, 1], [0, 0, -1], [1, 2, 3]] {
        assert_eq!(
            floor_at(77).intersect(&ray([5, 6, 77], towards), EVERYWHERE),
            None
        );
    }
}

#[test]
fn reach_ends_before_the_distance_it_names() {
    let from_above = ray([0, 0, 1 << 26], [0, 0, -1]);
    for (reach, blocks) in [(-1, false), (0, false), (1, true)] {
        let reach = Length::from_bits((1 << 26) + reach);
        assert_eq!(
            floor_at(0).blocks(&from_near(&from_above), reach, 0),
            blocks,
            "{reach:?}"
        );
        let met = floor_at(0).intersect(&from_above, reach);
        assert_eq!(met.is_some(), blocks, "{reach:?}");
    }
}

#[test]
fn blocks_agrees_with_intersect() {
    let mut sweep = Sweep::new(1);
    let mut counts = [0; 2];
    for (plane, ray) in pairs(2) {
        let reach = Length::from_bits(sweep.within(1, 1 << 30));
        let blocks = plane.blocks(&from_near(&ray), reach, 0);
        counts[usize::from(blocks)] += 1;
        let distance = in_double_precision(&plane, &ray);
        // The two tests may differ only where rounding decides.
        let at_an_end =
            distance.abs() <= SLACK || (distance - f64::from(reach.to_bits())).abs() <= SLACK;
        let intersects = plane.intersect(&ray, reach).is_some();
        assert!(
            blocks == intersects || at_an_end,
            "{plane:?} {ray:?} {reach:?}"
        );
    }
    assert!(counts.into_iter().all(|count| count > 20_000), "{counts:?}");
}

#[test]
fn every_plane_is_met_where_double_precision_meets_it() {
    let (mut hits, mut misses) = (0, 0);
    for (plane, ray) in pairs(3) {
        let truth = in_double_precision(&plane, &ray);
        let found = steps(plane.intersect(&ray, EVERYWHERE));
        let reach = f64::from(EVERYWHERE.to_bits());
        let bound = known_to(&plane, &ray, truth);
        if truth.abs() <= bound || (truth - reach).abs() <= bound {
            continue;
        }
        assert_eq!(
            found.is_some(),
            0.0 < truth && truth < reach,
            "{truth}: {plane:?} {ray:?}"
        );
        let Some(distance) = found else {
            misses += 1;
            continue;
        };
        hits += 1;
        assert!(
            (f64::from(distance) - truth).abs() <= bound,
            "{distance}, not {truth}"
        );
    }
    assert!(hits > 50_000 && misses > 50_000, "{hits} {misses}");
}

#[test]
fn paths_meet_near_planes_where_rays_do() {
    let mut hits = 0;
    for (plane, ray) in pairs(4) {
        let path = ScaledRay::new(ScaledPoint::new(ray.origin, 0), ray.direction);
        let Some(near) = steps(plane.intersect(&ray, EVERYWHERE)) else {
            continue;
        };
        hits += 1;
        let far = plane.intersect_far(&path) as f64;
        // The far test knows the height lost per step to 2^-30, and its quotient to 2^-26 as well.
        let bound = known_to(&plane, &ray, far) * 1.25 + far * 2f64.powi(-26);
        assert!(
            (f64::from(near) - far).abs() <= bound,
            "{near}, not {far}: {plane:?} {ray:?}"
        );
    }
    assert!(hits > 50_000, "{hits}");
}

#[test]
fn paths_are_blocked_where_rays_are() {
    let mut sweep = Sweep::new(5);
    for (plane, ray) in pairs(6) {
        let path = ScaledRay::new(ScaledPoint::new(ray.origin, 0), ray.direction);
        let reach = Length::from_bits(sweep.within(1, 1 << 30));
        let height = plane.height(ray.origin);
        let near = descent(height, ray.direction.dot(plane.normal).to_bits()).is_some_and(
            |(height, descent)| height < u64::from(descent) * u64::from(unsigned(reach.to_bits())),
        );
        assert_eq!(
            plane.blocks(&path, reach, 0),
            near,
            "{plane:?} {ray:?} {reach:?}"
        );
    }
}

#[test]
fn reach_of_a_path_counts_in_its_scale() {
    let path = ScaledRay::new(ScaledPoint::ORIGIN, direction([0, 0, -1]));
    let plane = floor_at(-(1 << 28));
    for (reach, scale, blocks) in [
        (1 << 28, 0, false),
        (1 << 20, 8, false),
        ((1 << 20) + 1, 8, true),
        (1, 29, true),
    ] {
        let found = plane.blocks(&path, Length::from_bits(reach), scale);
        assert_eq!(found, blocks, "{reach} at scale {scale}");
    }
}

#[test]
fn plane_too_far_for_rays_is_met_by_paths() {
    // 2^61 · 2^10 with 30 fraction bits is 2^41 steps.
    let far = PreparedPlane::new(direction([0, 0, 1]), -(1 << 61), 10, MaterialId(0));
    let down = ray([0, 0, 1 << 20], [0, 0, -1]);
    assert_eq!(far.intersect(&down, EVERYWHERE), None);
    assert!(!far.blocks(&from_near(&down), EVERYWHERE, 0));
    let path = ScaledRay::new(ScaledPoint::new(down.origin, 0), down.direction);
    let distance = far.intersect_far(&path) as f64;
    let truth = 2f64.powi(41) + 2f64.powi(20);
    assert!(
        (distance / truth - 1.0).abs() < 2f64.powi(-26),
        "{distance}, not {truth}"
    );
    for (reach, blocks) in [
        ((1 << 29) + (1 << 8) - 16, false),
        ((1 << 29) + (1 << 8) + 16, true),
    ] {
        assert_eq!(
            far.blocks(&path, Length::from_bits(reach), 12),
            blocks,
            "{reach}"
        );
    }
}

#[test]
fn path_from_far_away_comes_down_on_a_near_plane() {
    for scale in [1, 5, 20, 30] {
        let from = ScaledPoint::new(Point::new(1 << 28, 0, 1 << 28), scale);
        let path = ScaledRay::new(from, direction([-3, 0, -4]));
        let distance = floor_at(0).intersect_far(&path) as f64;
        let truth = 2f64.powi(28 + scale as i32) / 0.8;
        assert!(
            (distance / truth - 1.0).abs() < 2f64.powi(-26),
            "{distance}, not {truth}"
        );
        let upward = ScaledRay::new(from, direction([-3, 0, 4]));
        assert_eq!(floor_at(0).intersect_far(&upward), NOT_MET);
        assert!(!floor_at(0).blocks(&upward, EVERYWHERE, 40));
    }
}

#[test]
fn height_is_counted_along_the_normal() {
    let slope = direction([0, 3, 4]);
    let offset = Vector::new(0, 0, 5000).dot_wide(slope);
    // The point is 5000 steps above the plane along z: 0.8 · 5000 along the normal. The coordinates of
    // the normal are off by less than two units of 2⁻³⁰ each.
    let height = plane(slope, offset).height(Point::new(123, 0, 10_000));
    assert!((height - (4000 << 30)).abs() <= 10_000, "{height}");
    assert_eq!(plane(slope, offset).height(Point::new(-77, 0, 5000)), 0);
}

#[test]
fn plane_across_an_axis_is_asked_as_any_other() {
    let mut sweep = Sweep::new(7);
    let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    for (index, axis) in axes.iter().cycle().take(60_000).enumerate() {
        let normal = match index % 2 {
            0 => direction(*axis),
            _ => direction(*axis).reversed(),
        };
        // Offsets need not be whole steps.
        let level = i64::from(sweep.within(-(1 << 30), 1 << 30));
        let offset = (level << 30) + i64::from(sweep.within(0, (1 << 30) - 1)) * (level.signum());
        let upright = plane(normal, offset);
        assert!(
            matches!(upright.upright, Upright::Yes { .. }),
            "{upright:?}"
        );
        let general = PreparedPlane {
            upright: Upright::No,
            ..upright
        };
        let ray = ray_towards(&mut sweep, [0; 3], 1 << 28);
        let [found, truth] = [upright, general].map(|plane| {
            let Bearing { steps, sign, climb } = plane.bearing(&ray);
            (steps, sign, climb)
        });
        assert_eq!(found, truth, "{upright:?} {ray:?}");
        let cosine = ray.direction.dot(normal);
        let [turned, reflected] =
            [upright, general].map(|plane| plane.reflected(ray.direction, normal, cosine));
        assert_eq!(turned, reflected, "{upright:?} {ray:?}");
    }
}

#[test]
fn plane_across_no_axis_or_too_far_away_is_asked_by_products() {
    let far = (1 << 60) + (1 << 30);
    for (normal, offset) in [
        (direction([0, 3, 4]), 0),
        (Direction::X, far),
        (Direction::X.reversed(), -far),
    ] {
        let plane = plane(normal, offset);
        assert!(matches!(plane.upright, Upright::No), "{plane:?}");
    }
}
