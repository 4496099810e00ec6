//! Tests of the cells of checkers.

use super::*;
use crate::number::sweep::Sweep;
use crate::vector::Point;

/// The cell of a point next to whose coordinate there is no border within `off` scene units.
fn parity(point: [f64; 3], size: [f64; 3], off: f64) -> Option<bool> {
    let mut sum = 0.0;
    for (at, size) in point.into_iter().zip(size).filter(|(_, size)| *size > 0.0) {
        let cells = [-off, off].map(|off| ((at + off) / size).floor());
        if cells[0] != cells[1] {
            return None;
        }
        sum += cells[0];
    }
    Some(sum.rem_euclid(2.0) == 1.0)
}

#[test]
fn cell_is_the_one_of_exact_numbers() {
    let mut random = Sweep::new(0xa54f_f53a_5f1d_36f1);
    let (mut tried, mut unsure) = (0, 0);
    for _ in 0..20_000 {
        let extent = 10_f64.powi(random.within(-6, 6));
        let middle = random.place().map(|it| it * 1e3 * extent);
        let radius = Number::new(extent).to_bits().unsigned_abs();
        let grid = Grid::new(Position::new(middle), radius);
        let mut size = random.place().map(|it| extent * 10_f64.powf(3.0 * it));
        size[0] *= f64::from(random.within(0, 1));
        let checker = Checker::new([Number::ZERO; 3], size.map(Number::new));
        let checker = PreparedChecker::prepare(&checker, &grid).unwrap();
        let offset = random.place().map(|it| it * 3.0 * extent);
        let point = [0, 1, 2].map(|axis| middle[axis] + offset[axis]);
        let found = checker.holds(grid.place(Position::new(point)));
        // Two steps of the grid, and the rounding of the doubles.
        let off = extent * 1e-7;
        match parity(point, size, off) {
            Some(expected) => assert_eq!(found, expected, "{point:?} {size:?} {extent}"),
            None => unsure += 1,
        }
        tried += 1;
    }
    assert!(100 * unsure < tried, "{unsure} of {tried}");
}

#[test]
fn point_a_step_below_a_border_counts_as_on_it() {
    let grid = Grid::new(Position::ORIGIN, Number::ONE.to_bits().unsigned_abs());
    let half = [Number::new(0.5), Number::ZERO, Number::ZERO];
    let checker = PreparedChecker::prepare(&Checker::new([Number::ZERO; 3], half), &grid).unwrap();
    // The cell below 0 is odd.
    let holds = |below: i32| checker.holds(ScaledPoint::at(Point::new(-below, 0, 0)));
    assert_eq!([0, 1, 2, 3].map(holds), [false, false, true, true]);
}

#[test]
fn ends_in_one_cell_stay_there_unless_the_curve_leaves_it() {
    let grid = Grid::new(Position::ORIGIN, Number::ONE.to_bits().unsigned_abs());
    let half = Checker::new([Number::ZERO; 3], [Number::new(0.5); 3]);
    let checker = PreparedChecker::prepare(&half, &grid).unwrap();
    let at = |x: f64| grid.place(Position::new([x, 0.25, 0.25]));
    let steps = |length: f64| grid.length(Number::new(length)).to_bits();
    let is_one = |one, other, aside| checker.is_one_cell([at(one), at(other)], steps(aside));
    assert!(is_one(0.05, 0.45, 0.0) && is_one(0.05, 0.45, 0.04));
    assert!(!is_one(0.05, 0.45, 0.06) && !is_one(0.05, 0.55, 0.0));
    // The cell after the next has the same colour.
    assert!(!is_one(0.05, 1.05, 0.0));
}
