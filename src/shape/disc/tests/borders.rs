//! Tests of the columns of a row in which a disc lies.

use super::*;
use crate::shape::bordered::Bordered;
use crate::shape::fixture::rows::{Row, any_row};

/// Tests whether a ray through a column hits a disc, in double precision.
fn is_cut(disc: &PreparedDisc, row: &Row, column: u32) -> bool {
    let (way, along) = (row.way(disc.center), row.along(column));
    let normal = unit(in_doubles(disc.normal.raw()));
    let distance = dot(way, normal) / dot(along, normal);
    distance > 0.0 && length(plus(way, -distance, along)) <= f64::from(disc.radius)
}

/// A disc's span in any row holds all columns whose rays hit it. If it is sure, all rays between the
/// first and the last column hit it.
#[test]
fn span_begins_and_ends_with_the_disc() {
    let mut sweep = Sweep::new(42);
    let (mut hits, mut sure, mut inner) = (0, 0, 0);
    for _ in 0..40_000 {
        let radius = sweep.octaves(6, 25);
        let (row, center) = any_row(&mut sweep, radius);
        let disc = disc(center, any_direction(&mut sweep), radius);
        let from = disc.seen_from_eye(row.eye);
        let span = disc.span(&from, &row.plane, [0, u16::MAX]);
        let [first, last] = span.map_or([1, 0], |span| [span.first, span.last]);
        let middle = row.column_of(disc.center).unwrap_or(0);
        let is_sure = span.is_some_and(|span| span.is_sure);
        sure += u32::from(is_sure);
        for column in row.columns(&mut sweep, &[first, middle, last]) {
            let range = Range {
                start: Length::from_bits(0),
                reach: EVERYWHERE,
            };
            let hit = disc.intersect_from(&from, &row.direction(column), range);
            let is_cut = is_cut(&disc, &row, column);
            let is_within = (u32::from(first)..=u32::from(last)).contains(&column);
            let is_hit = hit.is_some() || is_cut;
            assert!(!is_hit || is_within, "{column}, {span:?}: {disc:?} {row:?}");
            hits += u32::from(is_hit);
            if is_sure && u32::from(first) < column && column < u32::from(last) {
                assert!(
                    is_cut && hit.is_some(),
                    "{column}, {span:?}: {disc:?} {row:?}"
                );
                inner += 1;
            }
        }
    }
    assert!(
        hits > 300_000 && sure > 5_000 && inner > 50_000,
        "{hits} {sure} {inner}"
    );
}
