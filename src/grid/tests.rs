use super::*;
use crate::number::sweep::Sweep;
use crate::ray::{BALL, NEAR};

/// Creates a grid around `middle` with a ball of `radius` scene units.
fn grid(middle: [f64; 3], radius: f64) -> Grid {
    Grid::new(Position::new(middle), Number::new(radius).to_bits() as u128)
}

fn raw(place: ScaledPoint) -> [i32; 3] {
    [place.point.x, place.point.y, place.point.z]
}

#[test]
fn radius_fills_the_ball_but_for_less_than_half() {
    let mut sweep = Sweep::new(1);
    for power in -29..=30 {
        let odd = 1.0 + f64::from(sweep.within(1, 999)) / 1000.0;
        for radius in [2f64.powi(power), 2f64.powi(power) * odd] {
            let steps = grid([0.0; 3], radius).length(Number::new(radius)).to_bits();
            assert!((BALL / 2 < steps) && (steps <= BALL), "{radius}: {steps}");
        }
    }
}

#[test]
fn power_of_two_fills_the_ball_exactly() {
    for power in -29..=30 {
        let grid = grid([0.0; 3], 2f64.powi(power));
        assert_eq!(grid.length(Number::new(2f64.powi(power))).to_bits(), BALL);
        assert_eq!(grid.fraction_bits(), 28 - power);
    }
}

#[test]
fn middle_of_the_scene_is_the_origin() {
    let middle = [1234.5, -0.001, 1e9];
    let grid = grid(middle, 8.0);
    assert_eq!(grid.place(Position::new(middle)), ScaledPoint::ORIGIN);
    assert_eq!(grid.middle(), Position::new(middle));
}

#[test]
fn lengths_and_places_are_rounded_to_the_nearest_step() {
    let grid = grid([0.0; 3], 2f64.powi(28)); // A step is one scene unit.
    for (value, steps) in [
        (0.0, 0),
        (0.49, 0),
        (0.5, 1),
        (1.49, 1),
        (77.0, 77),
        (2e8, 200_000_000),
    ] {
        assert_eq!(grid.length(Number::new(value)).to_bits(), steps, "{value}");
        assert_eq!(
            raw(grid.place(Position::new([value, 0.0, 1.0]))),
            [steps, 0, 1],
            "{value}"
        );
    }
    assert_eq!(
        raw(grid.place(Position::new([-0.49, -0.51, -2.0]))),
        [0, -1, -2]
    );
}

#[test]
fn length_that_does_not_fit_is_the_largest() {
    let grid = grid([0.0; 3], 1.0);
    for (value, steps) in [
        (4.0, 1 << 30),
        (4.1, 1 << 30),
        (1e9, 1 << 30),
        (3.5, 7 << 27),
    ] {
        assert_eq!(grid.length(Number::new(value)).to_bits(), steps, "{value}");
    }
}

#[test]
fn place_is_near_up_to_three_halves_of_the_ball() {
    let grid = grid([0.0; 3], 1.0);
    for (coordinate, is_near) in [(0.0, true), (1.49, true), (1.51, false), (1e6, false)] {
        for sign in [-1.0, 1.0] {
            let place = grid.place(Position::new([0.1, sign * coordinate, 0.2]));
            assert_eq!(place.is_near(), is_near, "{coordinate}");
        }
    }
    assert_eq!(
        raw(grid.place(Position::new([-1.5, 0.0, 0.0]))),
        [-NEAR, 0, 0]
    );
}

#[test]
fn far_place_is_right_to_a_step_of_its_scale() {
    let mut sweep = Sweep::new(2);
    for _ in 0..10_000 {
        let factor = 2f64.powi(sweep.within(-9, 0));
        let position = sweep.triple(1 << 30).map(|it| f64::from(it) * factor);
        let grid = grid([0.25, -0.5, 0.125], 2f64.powi(sweep.within(-20, 4)));
        let place = grid.place(Position::new(position));
        let step = 2f64.powi(place.scale as i32 - grid.fraction_bits());
        let middle = [0.25, -0.5, 0.125];
        for axis in 0..3 {
            let found = f64::from(raw(place)[axis]) * step + middle[axis];
            // Rounded to nearest; rounded down if a last shift brings the point to normal form.
            assert!(
                (found - position[axis]).abs() <= 1.5 * step,
                "{position:?}: {place:?}"
            );
        }
    }
}

#[test]
fn scaled_scene_has_the_same_places_on_a_scaled_grid() {
    let mut sweep = Sweep::new(3);
    for _ in 0..10_000 {
        let coordinates = sweep.triple(1 << 20).map(f64::from);
        let at = |power: i32| {
            let scaled = |value: f64| value * 2f64.powi(power);
            let grid = grid([scaled(17.0); 3], scaled(1_200_000.0));
            let length = grid.length(Number::new(scaled(345.75)));
            (grid.place(Position::new(coordinates.map(scaled))), length)
        };
        for power in [-30, -9, 1, 9] {
            assert_eq!(at(power), at(0), "2^{power}");
        }
    }
}
