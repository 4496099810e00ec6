//! Tests of what a sphere surely does to a light's rays.

use super::*;
use crate::ray::ScaledPoint;
use crate::shape::bordered::Bordered;
use crate::shape::fixture::fans::{any_fan, segment_distance};
use crate::shape::rays::Rays;

/// The ends of a wide fan do not tell of a small sphere in its middle.
#[test]
fn small_sphere_in_the_middle_of_wide_rays_is_not_spared() {
    let sphere = sphere([0, 1 << 24, 0], 1 << 18);
    let from = sphere.seen_from_light(Point::ORIGIN);
    for aside in (1..29).map(|it| it << 20) {
        let places = [-aside, aside].map(|x| ScaledPoint::at(Point::new(x, 1 << 25, 0)));
        let spread = Rays::new(ScaledPoint::ORIGIN, places).spread(0);
        assert_ne!(sphere.told(&from, &spread), Some(false), "{aside}");
    }
}

/// A sphere that spares a fan meets none of its rays. One that hides it meets all of them, if it hides both ends.
#[test]
fn sphere_spares_and_hides_whole_fans() {
    let mut sweep = Sweep::new(51);
    let (mut spared, mut hidden, mut told) = (0, 0, [0; 2]);
    for _ in 0..60_000 {
        let radius = sweep.octaves(8, 25);
        let center = sweep.triple(1 << 26);
        let sphere = sphere(center, radius);
        let lit = any_fan(&mut sweep, center, radius);
        let from = sphere.seen_from_light(lit.light);
        let way = in_doubles(lit.light.to(sphere.center));
        let points = lit.points(&mut sweep);
        let are_met = points.map(|to| segment_distance(to, way) < f64::from(radius));
        // The kernel asks for both ends first.
        let hides = are_met[0] && are_met[8] && sphere.hides(&from, &lit.fan);
        let spares = sphere.spares(&from, &lit.fan);
        assert!(!spares || !are_met.contains(&true), "{sphere:?} {lit:?}");
        assert!(!hides || !are_met.contains(&false), "{sphere:?} {lit:?}");
        // A light in a sphere asks nothing, and no point lies in a sphere.
        let is_outside = !from.is_around()
            && !points
                .iter()
                .any(|to| length(plus(*to, -1.0, way)) < f64::from(radius));
        if let (Some(hides), true) = (sphere.told(&from, &lit.spread), is_outside) {
            assert!(!are_met.contains(&!hides), "{hides} {sphere:?} {lit:?}");
            told[usize::from(hides)] += 1;
        }
        spared += u32::from(spares);
        hidden += u32::from(hides);
    }
    assert!(
        spared > 10_000 && hidden > 2_000 && told[0].min(told[1]) > 2_000,
        "{spared} {hidden} {told:?}"
    );
}
