//! Tests of the columns of a row in which a sphere lies.

use super::*;
use crate::ray::SLACK;
use crate::shape::bordered::Bordered;
use crate::shape::fixture::rows::{any_row, approach, steep_row};

/// In a view of almost 180 degrees, rays are off the plane of their row. They hit no sphere that has no span.
#[test]
fn span_holds_rays_that_are_off_the_rows_plane() {
    let mut sweep = Sweep::new(47);
    let mut off = 0;
    for _ in 0..40_000 {
        let radius = sweep.octaves(6, 25);
        let (row, center) = steep_row(&mut sweep, radius);
        let sphere = sphere(center, radius);
        let from = sphere.seen_from_eye(row.eye);
        let span = sphere.span(&from, &row.plane, [0, u16::MAX]);
        let [first, last] = span.map_or([1, 0], |span| [span.first, span.last]);
        for column in row.columns(&mut sweep, &[]) {
            let (aside, ahead) = approach(row.way(sphere.center), row.along(column));
            let is_hit = aside <= f64::from(radius) && ahead > 0.0;
            let is_within = (u32::from(first)..=u32::from(last)).contains(&column);
            assert!(
                !is_hit || is_within,
                "{column}, {span:?}: {sphere:?} {row:?}"
            );
            let apart = row.eye.to(sphere.center).dot(row.plane.normal);
            off += u32::from(is_hit && apart.abs() > radius + SLACK);
        }
    }
    assert!(off > 10, "{off}");
}

/// A sphere's span in any row holds all columns whose rays hit it. If it is sure, all rays between the
/// first and the last column hit it.
#[test]
fn span_begins_and_ends_with_the_sphere() {
    let mut sweep = Sweep::new(41);
    let (mut hits, mut sure, mut inner) = (0, 0, 0);
    for _ in 0..40_000 {
        let radius = sweep.octaves(6, 25);
        let (row, center) = any_row(&mut sweep, radius);
        let sphere = sphere(center, radius);
        let from = sphere.seen_from_eye(row.eye);
        let span = sphere.span(&from, &row.plane, [0, u16::MAX]);
        let [first, last] = span.map_or([1, 0], |span| [span.first, span.last]);
        let middle = row.column_of(sphere.center).unwrap_or(0);
        let is_sure = span.is_some_and(|span| span.is_sure);
        sure += u32::from(is_sure);
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
            hits += u32::from(is_hit);
            if is_sure && u32::from(first) < column && column < u32::from(last) {
                let is_cut = aside <= f64::from(radius) && ahead > 0.0 && hit.is_some();
                assert!(is_cut, "{column}, {span:?}: {sphere:?} {row:?}");
                inner += 1;
            }
        }
    }
    assert!(
        hits > 500_000 && sure > 10_000 && inner > 100_000,
        "{hits} {sure} {inner}"
    );
}
