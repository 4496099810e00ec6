//! Tests of the cells of checkers.

use super::*;
use crate::number::sweep::Sweep;
use crate::vector::{Point, Vector};

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

/// The share of a parallelogram that shows the checker's colour, by 64 x 64 points.
fn sampled(checker: &PreparedChecker, area: &Area) -> f64 {
    const COUNT: i32 = 64;
    let at = |part: i32, side: f64| side * (f64::from(2 * part + 1 - COUNT) / f64::from(2 * COUNT));
    let mut held = 0;
    for one in 0..COUNT {
        for other in 0..COUNT {
            let [a, b] = area
                .sides
                .map(|side| [side.x, side.y, side.z].map(f64::from));
            let Point { x, y, z } = area.middle.point;
            let [x, y, z] = [(0, x), (1, y), (2, z)]
                .map(|(axis, middle)| middle + (at(one, a[axis]) + at(other, b[axis])) as i32);
            held += u32::from(checker.holds(ScaledPoint::at(Point::new(x, y, z))));
        }
    }
    f64::from(held) / f64::from(COUNT * COUNT)
}

#[test]
fn share_of_an_area_is_that_of_its_points() {
    let mut random = Sweep::new(0x3c6e_f372_fe94_f82b);
    let grid = Grid::new(Position::ORIGIN, Number::ONE.to_bits().unsigned_abs());
    let (mut sum, mut worst) = (0.0, 0.0_f64);
    for _ in 0..600 {
        let size = [0.1, 0.07 + 0.05 * random.share(), 0.0].map(Number::new);
        let checker =
            PreparedChecker::prepare(&Checker::new([Number::ZERO; 3], size), &grid).unwrap();
        let cell = f64::from(grid.place(Position::new([0.1, 0.0, 0.0])).point.x);
        let long = cell * 10_f64.powf(random.share());
        let short = cell * random.share();
        let sides = [long, short].map(|length| {
            let [x, y, _] = random.place();
            Vector::new((length * x) as i32, (length * y) as i32, 0)
        });
        let [x, y, z] = random.triple(1 << 27);
        let middle = ScaledPoint::at(Point::new(x, y, z));
        let area = Area {
            middle,
            sides,
            scale: 0,
        };
        let (found, expected) = (f64::from(checker.share_on(&area)), sampled(&checker, &area));
        let error = (found - expected).abs();
        worst = worst.max(error);
        sum += error * error;
    }
    let off = (sum / 600.0_f64).sqrt();
    // Areas of up to 10 cells by 1.
    assert!(off < 0.036 && worst < 0.3, "{off} {worst}");
}

#[test]
fn area_in_one_cell_shows_one_colour_and_one_of_many_cells_half_of_both() {
    let grid = Grid::new(Position::ORIGIN, Number::ONE.to_bits().unsigned_abs());
    let size = [Number::new(0.5), Number::new(0.25), Number::ZERO];
    let checker = Checker::new([Number::ZERO; 3], size);
    let checker = PreparedChecker::prepare(&checker, &grid).unwrap();
    let area = |middle: [f64; 3], side: i32, scale| Area {
        middle: grid.place(Position::new(middle)),
        sides: [Vector::new(side, side, side), Vector::new(-side, side, 0)],
        scale,
    };
    let cell = grid.place(Position::new([0.25, 0.0, 0.0])).point.x;
    for (middle, share) in [
        ([0.2, 0.1, 0.3], 0.0),
        ([0.2, 0.4, 0.3], 1.0),
        ([-0.2, 0.1, 0.3], 1.0),
    ] {
        for side in [0, 1, 1000, cell / 4] {
            let area = area(middle, side, 0);
            assert_eq!(
                f64::from(checker.share_on(&area)),
                share,
                "{middle:?} {side}"
            );
            assert!(!checker.is_fine_on(&area), "{side}");
        }
        for (side, scale) in [(cell, 6), (1 << 29, 3), (1 << 29, 40), (-1, 60)] {
            let area = area(middle, side, scale);
            let found = f64::from(checker.share_on(&area));
            assert!(
                (found - 0.5).abs() < 0.01,
                "{middle:?} {side} {scale}: {found}"
            );
            assert!(checker.is_fine_on(&area), "{side} {scale}");
        }
    }
}
