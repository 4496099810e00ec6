//! Tests where edges are, and where samples lie.

use super::*;
use std::vec::Vec;

use crate::camera::Camera;
use crate::vector::Direction;

fn paths(notes: &[u32]) -> Paths {
    core::array::from_fn(|index| {
        let mut path = PathSignature::new();
        path.note(notes.get(index).copied().unwrap_or(0));
        path.ended(index % 2 == 0)
    })
}

#[test]
fn pixels_on_both_sides_of_a_change_have_an_edge() {
    assert_eq!(changes(&paths(&[]), None), 0);
    assert_eq!(changes(&paths(&[7]), None), 0b11);
    assert_eq!(changes(&paths(&[0, 0, 7, 7]), None), 0b11110);
}

#[test]
fn pixel_that_differs_from_the_row_above_has_an_edge() {
    let (one, other) = (paths(&[]), paths(&[]));
    assert_eq!(changes(&one, Some(&other)), 0);
    let above = paths(&[0, 0, 0, 5]);
    assert_eq!(changes(&one, Some(&above)), 0b1000);
}

/// The first further sample lies right of and above the centre, so the last one lies left and below.
#[test]
fn places_of_samples_are_symmetric_and_inside_of_the_pixel() {
    for Places { rows, more } in [TWO, FOUR] {
        let opposite = |[right, down]: [i32; 2]| [-right, -down];
        assert!(
            more.iter()
                .rev()
                .copied()
                .map(opposite)
                .eq(more.iter().copied())
        );
        assert!(rows.iter().rev().map(|row| -row).eq(rows.iter().copied()));
        assert!(more.iter().flatten().chain(rows).all(|part| part.abs() < 8));
        // No two samples lie in one row.
        let mut lines: Vec<_> = more
            .iter()
            .map(|[_, down]| *down)
            .chain(rows.iter().copied())
            .collect();
        lines.sort_unstable();
        lines.dedup();
        assert_eq!(lines.len(), rows.len() + more.len());
    }
}

#[test]
fn sixteen_sixteenths_are_one_pixel() {
    let camera = Camera::look_at([1.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
    let generator = camera.generator(120, 90);
    let far = |one: Direction, other: Direction| {
        let change = one.change_to(other).unwrap();
        change.square() > 1 << 12
    };
    for y in [0, 30, 88] {
        let (row, below, next) = (
            generator.row(y),
            generator.row_below(y, 16),
            generator.row(y + 1),
        );
        for column in [0, 59, 118] {
            assert!(
                !far(below.of(column), next.of(column)),
                "row {y}, column {column}"
            );
            assert!(
                !far(row.beside(column, 16), row.of(column + 1)),
                "row {y}, column {column}"
            );
            assert!(
                far(row.beside(column, 1), row.of(column)),
                "row {y}, column {column}"
            );
        }
    }
}
