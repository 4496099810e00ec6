//! Tests of the columns of a row in which a cylinder lies.

use super::*;
use crate::ray::{ANY_COLUMN, Span};
use crate::shape::bordered::Bordered;
use crate::shape::fixture::rows::{Row, any_row};

/// What a ray does to a cylinder, in double precision.
#[derive(Clone, Copy, Debug, PartialEq)]
struct Cut {
    /// Whether the ray enters and leaves the wall, between the rims.
    walls: [bool; 2],
    /// Whether the ray hits the solid: the cylinder with closed ends.
    is_solid: bool,
}

impl Cut {
    /// The ray misses.
    const NOTHING: Self = Self {
        walls: [false; 2],
        is_solid: false,
    };

    fn new(cylinder: &PreparedCylinder, row: &Row, column: u32) -> Self {
        let (way, along) = (row.way(cylinder.center), row.along(column));
        let axis = unit(in_doubles(cylinder.axis.raw()));
        let flat = |vector: Triple| plus(vector, -dot(vector, axis), axis);
        let (square, climb) = (dot(flat(along), flat(along)), dot(along, axis));
        let middle = dot(flat(way), flat(along)) / square;
        let aside = length(plus(flat(way), -middle, flat(along)));
        let (radius, half) = (f64::from(cylinder.radius), f64::from(cylinder.half_height));
        let roots = if square > 1e-14 {
            roots(middle, (radius * radius - aside * aside) / square)
        } else if length(flat(way)) <= radius {
            // Along the axis.
            vec![-f64::INFINITY, f64::INFINITY]
        } else {
            Vec::new()
        };
        let &[near, far] = roots.as_slice() else {
            return Self::NOTHING;
        };
        let height = |distance: f64| distance * climb - dot(way, axis);
        let walls = [near, far].map(|it| it > 0.0 && height(it).abs() <= half);
        // Where the ray is between both ends.
        let ends = [half, -half].map(|end| (end + dot(way, axis)) / climb);
        let (from, to) = (ends[0].min(ends[1]), ends[0].max(ends[1]));
        let is_solid = near.max(from).max(0.0) <= far.min(to);
        Self { walls, is_solid }
    }
}

/// Tests whether a rim may lie between two columns, as `accel::stretch` does.
fn has_rim(span: &Span<[u16; 4]>, [start, end]: [u32; 2]) -> bool {
    let mut rims = span.rims.iter().map(|&rim| u32::from(rim));
    rims.any(|rim| rim == u32::from(ANY_COLUMN) || rim < end && start < rim + 2)
}

/// Returns a cylinder of any shape, from a needle to a ring, with its row.
fn any_tube(sweep: &mut Sweep) -> (PreparedCylinder, Row) {
    let size = sweep.octaves(6, 25);
    let other = (size >> sweep.within(0, 12)).max(64);
    let [radius, half] = match sweep.within(0, 1) {
        0 => [size, other],
        _ => [other, size],
    };
    let (row, center) = any_row(sweep, size);
    // Every fourth axis is almost at a right angle to the row's plane, or almost in it.
    let axis = match sweep.within(0, 7) {
        0 => row.plane.normal,
        1 => row.plane.axis.aside,
        2 => row.direction(0),
        _ => any_direction(sweep),
    };
    (cylinder(center, axis, radius, half), row)
}

/// A cylinder's span in any row holds all columns whose rays hit its solid. If it is sure, then between
/// the first and the last column the wall is hit in the same way on both sides of a column border, unless
/// a rim lies there.
#[test]
fn span_begins_and_ends_with_the_cylinder() {
    let mut sweep = Sweep::new(43);
    let (mut hits, mut sure, mut inner) = (0, 0, 0);
    for _ in 0..60_000 {
        let (tube, row) = any_tube(&mut sweep);
        let from = tube.seen_from_eye(row.eye);
        let span = tube.span(&from, &row.plane, [0, u16::MAX]);
        let [first, last] = span.map_or([1, 0], |span| [span.first, span.last].map(u32::from));
        let is_sure = span.is_some_and(|span| span.is_sure);
        sure += u32::from(is_sure);
        let mut borders: Vec<u16> = row.column_of(tube.center).into_iter().collect();
        borders.extend(span.iter().flat_map(|it| [it.first, it.last]));
        borders.extend(span.iter().flat_map(|it| it.rims));
        let mut before: Option<(u32, Cut)> = None;
        for column in row.columns(&mut sweep, &borders) {
            let range = Range {
                start: Length::from_bits(0),
                reach: EVERYWHERE,
            };
            let hit = tube.intersect_from(&from, &row.direction(column), range);
            let cut = Cut::new(&tube, &row, column);
            // The kernel is not exact along the axis.
            let is_along = row.direction(column).dot(tube.axis).to_num::<f64>().abs() > 0.998;
            let is_hit = hit.is_some() && !is_along || cut.is_solid;
            let is_within = (first..=last).contains(&column);
            assert!(
                !is_hit || is_within,
                "{column}, {span:?}, {hit:?} {cut:?}: {tube:?} {row:?}"
            );
            hits += u32::from(is_hit);
            if let (Some(span), Some((start, other)), true) = (&span, before, is_sure)
                && start + 1 == column
                && first < start
                && column < last
                && !has_rim(span, [start, column])
            {
                assert_eq!(cut, other, "{column}, {span:?}: {tube:?} {row:?}");
                inner += 1;
            }
            before = Some((column, cut));
        }
    }
    assert!(
        hits > 300_000 && sure > 5_000 && inner > 50_000,
        "{hits} {sure} {inner}"
    );
}
