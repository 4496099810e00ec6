//! Tests of the columns of a row in which a triangle lies, and of what it surely does to a light's rays.

use super::*;
use crate::ray::{ANY_COLUMN, NO_COLUMN};
use crate::shape::bordered::Bordered;
use crate::shape::fixture::fans::any_fan;
use crate::shape::fixture::rows::any_row;

/// Returns a random triangle around a point, often a narrow one.
fn around(sweep: &mut Sweep, center: [i32; 3], radius: i32) -> Option<PreparedTriangle> {
    let near = |sweep: &mut Sweep| {
        let by = sweep.triple(radius / 2);
        [0, 1, 2].map(|axis| center[axis] + by[axis])
    };
    let [one, two, mut three] = [near(sweep), near(sweep), near(sweep)];
    if sweep.within(0, 3) == 0 {
        let by = sweep.triple((radius >> 8).max(100));
        three = [0, 1, 2].map(|axis| two[axis] + by[axis]);
    }
    triangle([one, two, three])
}

/// A triangle's span in any row holds all columns whose rays hit it. If it is sure, all rays between the first and the
/// last column hit it. If its rims are known, it is hit between any two columns that hit it.
#[test]
fn span_begins_and_ends_with_the_triangle() {
    let mut sweep = Sweep::new(61);
    let (mut hits, mut sure, mut inner) = (0, 0, 0);
    for _ in 0..60_000 {
        let radius = sweep.octaves(8, 25);
        let (row, center) = any_row(&mut sweep, radius);
        let Some(triangle) = around(&mut sweep, center, radius) else {
            continue;
        };
        let from = triangle.seen_from_eye(row.eye);
        let span = triangle.span(&from, &row.plane, [0, u16::MAX]);
        let [first, last] = span.map_or([1, 0], |span| [span.first, span.last]);
        let middle = row.column_of(triangle.center).unwrap_or(0);
        let is_sure = span.is_some_and(|span| span.is_sure);
        assert!(span.is_none_or(|it| it.rims == [if is_sure { NO_COLUMN } else { ANY_COLUMN }]));
        sure += u32::from(is_sure);
        let mut met = Vec::new();
        for column in row.columns(&mut sweep, &[first, middle, last]) {
            let range = Range {
                start: Length::from_bits(0),
                reach: EVERYWHERE,
            };
            let hit = triangle
                .intersect_from(&from, &row.direction(column), range)
                .is_some();
            let is_within = (u32::from(first)..=u32::from(last)).contains(&column);
            assert!(
                !hit || is_within,
                "{column}, {span:?}: {triangle:?} {row:?}"
            );
            hits += u32::from(hit);
            met.push(hit);
            if is_sure && u32::from(first) < column && column < u32::from(last) {
                assert!(hit, "{column}, {span:?}: {triangle:?} {row:?}");
                inner += 1;
            }
        }
        let from = met.iter().position(|it| *it).unwrap_or(0);
        let to = met.iter().rposition(|it| *it).unwrap_or(0);
        assert!(!is_sure || from == to || met[from..=to].iter().all(|it| *it));
    }
    assert!(
        hits > 20_000 && sure > 5_000 && inner > 10_000,
        "{hits} {sure} {inner}"
    );
}

/// A triangle that spares a fan meets none of its rays.
#[test]
fn triangle_spares_whole_fans() {
    let mut sweep = Sweep::new(62);
    let (mut spared, mut beside) = (0, 0);
    for _ in 0..60_000 {
        let radius = sweep.octaves(10, 25);
        let center = sweep.triple(1 << 26);
        let Some(triangle) = around(&mut sweep, center, radius) else {
            continue;
        };
        let lit = any_fan(&mut sweep, center, radius);
        let from = triangle.seen_from_light(lit.light);
        let spares = triangle.spares(&from, &lit.fan);
        let is_met = lit.points(&mut sweep).iter().any(|to| {
            let way = to.map(|it| it.round() as i32);
            let [x, y, z] = way;
            if way == [0; 3] {
                return false;
            }
            let (direction, reach) = Vector::new(x, y, z).direction_and_length();
            let ray = Ray {
                origin: lit.light,
                direction,
            };
            triangle.blocks(&ray, reach)
        });
        assert!(!spares || !is_met, "{triangle:?} {lit:?}");
        spared += u32::from(spares);
        let way = from.way.plus(triangle.corner.to(triangle.center));
        beside += u32::from(spares && !lit.fan.avoids_ball(way, triangle.radius));
    }
    assert!(spared > 10_000 && beside > 3_000, "{spared} {beside}");
}
