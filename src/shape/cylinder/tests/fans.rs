//! Tests of what a cylinder surely does to a light's rays.

use super::*;
use crate::shape::bordered::Bordered;
use crate::shape::fixture::fans::any_fan;

/// Returns how deep a segment from a light meets the wall, in double precision: the distance of the nearest rim, in
/// steps, from the hit that is furthest from both. `None` if it does not meet the wall.
fn depth(tube: &PreparedCylinder, way: Triple, to: Triple) -> Option<f64> {
    let axis = unit(in_doubles(tube.axis.raw()));
    let flat = |vector: Triple| plus(vector, -dot(vector, axis), axis);
    let (along, across) = (flat(to), flat(way));
    let square = dot(along, along);
    let middle = dot(across, along) / square;
    let aside = length(plus(across, -middle, along));
    let radius = f64::from(tube.radius);
    let roots = roots(middle, (radius * radius - aside * aside) / square).into_iter();
    let height = |share: f64| (share * dot(to, axis) - dot(way, axis)).abs();
    let hits = roots.filter(|share| (0.0..=1.0).contains(share));
    let depths = hits.map(|share| f64::from(tube.half_height) - height(share));
    depths.filter(|depth| *depth >= 0.0).reduce(f64::max)
}

/// A cylinder that spares a fan meets none of its rays. One that hides it meets all of them, if it hides both ends.
#[test]
fn cylinder_spares_and_hides_whole_fans() {
    let mut sweep = Sweep::new(52);
    let (mut spared, mut hidden, mut passed, mut told) = (0, 0, 0, 0);
    for _ in 0..120_000 {
        let size = sweep.octaves(10, 25);
        let other = (size >> sweep.within(0, 8)).max(256);
        let [radius, half] = match sweep.within(0, 1) {
            0 => [size, other],
            _ => [other, size],
        };
        let center = sweep.triple(1 << 26);
        let tube = cylinder(center, any_direction(&mut sweep), radius, half);
        let lit = any_fan(&mut sweep, center, size);
        let from = tube.seen_from_light(lit.light);
        let way = in_doubles(lit.light.to(tube.center));
        let depths = lit.points(&mut sweep).map(|to| depth(&tube, way, to));
        let is_met = |depth: &Option<f64>| depth.is_some();
        // The kernel asks for both ends first.
        let hides = depths[0].is_some() && depths[8].is_some() && tube.hides(&from, &lit.fan);
        let is_told = tube.told(&from, &lit.spread) == Some(false);
        let spares = is_told || tube.spares(&from, &lit.fan);
        assert!(
            !spares || !depths.iter().any(is_met),
            "{depths:?} {tube:?} {lit:?}"
        );
        assert!(
            !hides || depths.iter().all(is_met),
            "{depths:?} {tube:?} {lit:?}"
        );
        spared += u32::from(spares);
        told += u32::from(is_told);
        hidden += u32::from(hides);
        passed += u32::from(spares && tube.is_passed(&from, &lit.fan));
    }
    assert!(
        spared > 20_000 && hidden > 1_000 && passed > 10_000 && told > 5_000,
        "{spared} {hidden} {passed} {told}"
    );
}
