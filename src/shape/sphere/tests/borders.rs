//! Tests of the columns of a row in which a sphere lies.

use super::*;
use crate::ray::SLACK;
use crate::shape::bordered::Bordered;
use crate::shape::fixture::rows::{Row, any_row, approach, steep_row};

/// What was tried: rays that hit a sphere, and among them those that hit it although the row's plane passes it; spans that
/// are sure, and rays inside of these.
#[derive(Default)]
struct Tried {
    hits: u32,
    off: u32,
    sure: u32,
    inner: u32,
}

/// Tests spans of random spheres in the rows that `any_row` returns: they hold all columns whose rays hit the sphere. If a
/// span is sure, all rays between its first and its last column hit it.
fn try_spans(seed: u64, any_row: impl Fn(&mut Sweep, i32) -> (Row, [i32; 3])) -> Tried {
    let mut sweep = Sweep::new(seed);
    let mut tried = Tried::default();
    for _ in 0..40_000 {
        let radius = sweep.octaves(6, 25);
        let (row, center) = any_row(&mut sweep, radius);
        let sphere = sphere(center, radius);
        let from = sphere.seen_from_eye(row.eye);
        let span = sphere.span(&from, &row.plane, [0, u16::MAX]);
        let [first, last] = span.map_or([1, 0], |span| [span.first, span.last]);
        let middle = row.column_of(sphere.center).unwrap_or(0);
        let is_sure = span.is_some_and(|span| span.is_sure);
        tried.sure += u32::from(is_sure);
        let apart = row.eye.to(sphere.center).dot(row.plane.normal);
        let passes = apart.abs() > radius + SLACK;
        for column in row.columns(&mut sweep, &[first, middle, last]) {
            let (aside, ahead) = approach(row.way(sphere.center), row.along(column));
            let range = Range {
                start: Length::from_bits(0),
                reach: EVERYWHERE,
            };
            let hit = sphere.intersect_from(&from, &row.direction(column), range);
            let is_hit = hit.is_some() || aside <= f64::from(radius) && ahead > 0.0;
            let is_within = (u32::from(first)..=u32::from(last)).contains(&column);
            assert!(
                !is_hit || is_within,
                "{column}, {span:?}: {sphere:?} {row:?}"
            );
            tried.hits += u32::from(is_hit);
            tried.off += u32::from(is_hit && passes);
            if is_sure && u32::from(first) < column && column < u32::from(last) {
                let is_cut = aside <= f64::from(radius) && ahead > 0.0 && hit.is_some();
                assert!(is_cut, "{column}, {span:?}: {sphere:?} {row:?}");
                tried.inner += 1;
            }
        }
    }
    tried
}

#[test]
fn span_begins_and_ends_with_the_sphere() {
    let Tried {
        hits, sure, inner, ..
    } = try_spans(41, any_row);
    assert!(
        hits > 500_000 && sure > 10_000 && inner > 100_000,
        "{hits} {sure} {inner}"
    );
}

/// In a view of almost 180 degrees, rounding moves rays off the plane of their row. Spans hold them, too.
#[test]
fn span_holds_rays_that_are_off_the_rows_plane() {
    let Tried { off, .. } = try_spans(47, steep_row);
    assert!(off > 10, "{off}");
}
