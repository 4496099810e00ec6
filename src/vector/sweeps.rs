use super::*;
use crate::number::sweep::Sweep;
use crate::number::{Number, sine_and_cosine_of};

/// Value of the last bit of Q2.30.
const ULP: f64 = 1.0 / (1 << 30) as f64;

fn in_doubles(vector: Vector) -> [f64; 3] {
    [vector.x, vector.y, vector.z].map(f64::from)
}

fn components(direction: Direction) -> [f64; 3] {
    in_doubles(direction.raw()).map(|coordinate| coordinate * ULP)
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn length(a: [f64; 3]) -> f64 {
    dot(a, a).sqrt()
}

/// Returns the largest difference between the coordinates of two vectors.
fn apart(a: [f64; 3], b: [f64; 3]) -> f64 {
    let gaps = [0, 1, 2].map(|axis| (a[axis] - b[axis]).abs());
    gaps.into_iter().fold(0.0, f64::max)
}

/// Returns random vectors with coordinates from a few steps to ±2³⁰.
fn vectors(seed: u64) -> impl Iterator<Item = Vector> {
    let mut sweep = Sweep::new(seed);
    (0..200_000).map(move |_| {
        let longest = sweep.octaves(2, 30);
        let [x, y, z] = sweep.triple(longest);
        Vector::new(x, y, if x | y | z == 0 { 1 } else { z })
    })
}

/// Returns random directions, exact to the last bit.
fn directions(seed: u64) -> impl Iterator<Item = Direction> {
    vectors(seed)
        .filter(|vector| vector.square() >= 1 << 32)
        .map(Vector::precise_direction)
}

/// Returns the relative error of a length whose square is even: the last bit of a square is set, so that
/// it is never zero.
fn lost_by_odd_squares(vector: [f64; 3]) -> f64 {
    0.5 / dot(vector, vector)
}

#[test]
fn direction_and_length_are_within_their_bounds() {
    let mut worst = 0.0_f64;
    for vector in vectors(1) {
        let truth = in_doubles(vector);
        let (direction, found) = vector.direction_and_length();
        // A reciprocal root is known to 2^-27.5. Each coordinate is also rounded down.
        let bound = 2f64.powf(-27.5) + ULP + lost_by_odd_squares(truth);
        let exact = truth.map(|coordinate| coordinate / length(truth));
        let off = apart(components(direction), exact);
        worst = worst.max(off);
        assert!(off <= bound, "{vector:?}: {direction:?} is {off:e} off");
        let off = f64::from(found.to_bits()) - length(truth);
        assert!(
            off.abs() <= 1.0 + length(truth) * 2f64.powi(-27),
            "{vector:?}: {found:?}"
        );
    }
    assert!(
        worst > ULP / 2.0,
        "a bound this loose says nothing: {worst:e}"
    );
}

#[test]
fn precise_direction_is_right_to_the_last_places() {
    for vector in vectors(2) {
        let truth = in_doubles(vector);
        let exact = truth.map(|coordinate| coordinate / length(truth));
        let found = components(vector.precise_direction());
        // Coordinates are rounded down before the correction and to nearest in it. The correction
        // squares the relative error.
        let bound = 2.0 * ULP + 1.6 * lost_by_odd_squares(truth).powi(2);
        assert!(
            apart(found, exact) <= bound,
            "{vector:?}: {found:?}, not {exact:?}"
        );
        assert!((length(found) - 1.0).abs() <= bound, "{vector:?}");
    }
}

#[test]
fn zero_vector_has_no_direction_and_no_length() {
    let zero = Vector::new(0, 0, 0);
    let (direction, length) = zero.direction_and_length();
    assert_eq!((direction.raw(), length), (zero, Length::from_bits(0)));
    assert_eq!(Position::ORIGIN.direction(), None);
    assert_eq!(Position::ORIGIN.leading(), None);
}

#[test]
fn renormalising_repairs_a_length() {
    let mut sweep = Sweep::new(3);
    for direction in directions(4) {
        let [x, y, z] = components(direction);
        let wrong = f64::from(sweep.within(-1000, 1000)) / 1000.0 * 2f64.powi(-11);
        let spoilt = [x, y, z].map(|it| Unit::from_bits((it * (1.0 + wrong) / ULP) as i32));
        // The step leaves 5/2 of the third power of the error, which is a third of the last bit, and the
        // rounding error.
        let [x, y, z] = spoilt;
        let spoilt = Direction { x, y, z };
        for repaired in [spoilt.renormalised(), spoilt.quickly_renormalised()] {
            let error = length(components(repaired)) - 1.0;
            assert!(error.abs() <= 4.0 * ULP, "{wrong}: {direction:?}");
        }
    }
}

#[test]
fn reflection_keeps_the_length_and_turns_the_cosine_around() {
    for (direction, normal) in directions(5).zip(directions(6)) {
        let cosine = direction.dot(normal);
        let reflected = direction.reflected(normal, cosine);
        let [d, n] = [direction, normal].map(components);
        let exact = [0, 1, 2].map(|axis| d[axis] - 2.0 * dot(d, n) * n[axis]);
        // The cosine is rounded down and doubled, and each product is rounded down again.
        let bound = 4.0 * ULP;
        assert!(
            apart(components(reflected), exact) <= bound,
            "{direction:?} {normal:?}"
        );
        assert!(
            (length(components(reflected)) - 1.0).abs() <= 8.0 * ULP,
            "{direction:?} {normal:?}"
        );
        let turned = reflected.dot(normal).to_bits() + cosine.to_bits();
        assert!(turned.abs() <= 12, "{turned}: {direction:?} {normal:?}");
    }
}

#[test]
fn head_on_reflection_turns_around() {
    let axes = [[1, 0, 0], [0, 1, 0], [0, 0, 1]];
    for axis in axes.map(|[x, y, z]| Vector::new(x, y, z).precise_direction()) {
        for normal in [axis, axis.reversed()] {
            let reflected = axis.reflected(normal, axis.dot(normal));
            assert_eq!(reflected, axis.reversed(), "{normal:?}");
        }
    }
}

#[test]
fn cosine_of_two_directions_is_rounded_down() {
    for (a, b) in directions(7).zip(directions(8)) {
        let exact = dot(components(a), components(b)) / ULP;
        let below = exact - f64::from(a.dot(b).to_bits());
        // The sum in doubles is itself known to 2^-20 of the last bit of Q2.30.
        assert!((-1e-5..1.0 + 1e-5).contains(&below), "{below}: {a:?} {b:?}");
        assert_eq!(a.dot(b), b.dot(a));
    }
}

#[test]
fn what_is_left_without_a_direction_is_perpendicular_to_it() {
    for (vector, direction) in vectors(9).zip(directions(10)) {
        let rest = vector.without(direction, vector.dot(direction));
        let along = dot(in_doubles(rest), components(direction));
        // Rounding moves each coordinate by a step, and a direction's length is known to 2^-29.
        let bound = 4.0 + length(in_doubles(vector)) * 2f64.powi(-28);
        assert!(
            along.abs() <= bound,
            "{along} of {vector:?} is left along {direction:?}"
        );
    }
}

#[test]
fn cross_product_is_perpendicular_to_both() {
    for (a, b) in directions(11).zip(directions(12)) {
        let (crossed, shift) = a.cross(b).unwrap();
        let [p, q] = [a, b].map(components);
        let exact = [
            p[1] * q[2] - p[2] * q[1],
            p[2] * q[0] - p[0] * q[2],
            p[0] * q[1] - p[1] * q[0],
        ];
        let found = in_doubles(crossed).map(|it| it * 2f64.powi(shift as i32 - 60));
        assert!(
            apart(found, exact) <= 2f64.powi(shift as i32 - 60),
            "{a:?} {b:?}"
        );
        assert!((1..=32).contains(&shift), "{shift}");
        let perpendicular = components(a.perpendicular(b).unwrap());
        let unit = exact.map(|coordinate| coordinate / length(exact));
        // The product was scaled so that its largest coordinate has 29 bits.
        assert!(apart(perpendicular, unit) <= 6.0 * ULP, "{a:?} {b:?}");
    }
}

#[test]
fn parallel_directions_have_no_perpendicular() {
    for direction in directions(13) {
        assert_eq!(direction.perpendicular(direction), None, "{direction:?}");
        assert_eq!(
            direction.perpendicular(direction.reversed()),
            None,
            "{direction:?}"
        );
    }
}

#[test]
fn crossed_axes_make_the_third() {
    let [x, y, z] =
        [[1, 0, 0], [0, 1, 0], [0, 0, 1]].map(|[x, y, z]| Vector::new(x, y, z).precise_direction());
    assert_eq!(x.crossed(y), z);
    assert_eq!(y.crossed(z), x);
    assert_eq!(z.crossed(x), y);
    assert_eq!(y.crossed(x), z.reversed());
}

#[test]
fn point_along_a_direction_is_rounded_down_to_even_steps() {
    let mut sweep = Sweep::new(14);
    for direction in directions(15).take(20_000) {
        let [x, y, z] = sweep.triple(3 << 27);
        let from = Point::new(x, y, z);
        let distance = Length::from_bits(sweep.octaves(0, 30));
        let way = in_doubles(from.to(from.along(direction, distance)));
        let exact = components(direction).map(|it| it * f64::from(distance.to_bits()));
        for axis in 0..3 {
            let below = exact[axis] - way[axis];
            assert!(
                (0.0..2.0).contains(&below),
                "{below}: {from:?} {direction:?} {distance:?}"
            );
        }
    }
}

#[test]
fn direction_of_a_description_does_not_depend_on_its_scale() {
    for vector in vectors(16).take(20_000) {
        let position = |power: i32| {
            Position::new(in_doubles(vector).map(|it| it / 2f64.powi(30) * 2f64.powi(power)))
        };
        let direction = position(0).direction();
        assert!(direction.is_some(), "{vector:?}");
        for power in [-3, 7, 30] {
            assert_eq!(
                position(power).direction(),
                direction,
                "{vector:?} · 2^{power}"
            );
        }
    }
}

#[test]
fn leading_bits_of_a_description_are_its_coordinates() {
    for position in [
        [1.0, 2.0, 3.0],
        [1e-9, -3e-10, 0.0],
        [0.0, 0.0, -1e9],
        [1e9, 1e-9, 1.0],
    ] {
        let (vector, shift) = Position::new(position).leading().unwrap();
        let largest = in_doubles(vector)
            .into_iter()
            .map(f64::abs)
            .fold(0.0, f64::max);
        assert!(
            (2f64.powi(28)..=2f64.powi(29)).contains(&largest),
            "{position:?}: {vector:?}"
        );
        let found = in_doubles(vector).map(|it| it * 2f64.powi(shift - 64));
        assert!(
            apart(found, position) <= 2f64.powi(shift - 65),
            "{found:?}, not {position:?}"
        );
    }
}

#[test]
fn range_of_a_description_ends_at_two_to_the_thirtieth() {
    let limit = 2f64.powi(30);
    for sign in [-1.0, 1.0] {
        for axis in 0..3 {
            let at = |coordinate: f64| {
                let mut coordinates = [0.0; 3];
                coordinates[axis] = sign * coordinate;
                Position::new(coordinates).is_in_range()
            };
            assert!(at(limit) && at(0.0));
            assert!(!at(limit + 2f64.powi(-22)) && !at(f64::NAN) && !at(f64::INFINITY));
        }
    }
}

#[test]
fn a_turn_about_an_axis_is_a_turn() {
    let axis = Position::new([0.0, 0.0, 1.0]).direction().unwrap();
    let quarter = sine_and_cosine_of(Number::from(90));
    let turned = Direction::X.turned_about(axis, quarter);
    let [x, y, z] = turned.components().map(|unit| unit.to_num::<f64>());
    assert!(
        x.abs() < 1e-8 && (y - 1.0).abs() < 1e-8 && z.abs() < 1e-8,
        "{x} {y} {z}"
    );
}

#[test]
fn directions_of_axes_are_exact() {
    assert_eq!(
        Position::new([3.7, 0.0, 0.0]).direction(),
        Some(Direction::X)
    );
    assert_eq!(
        Position::new([1e-12, 0.0, 0.0]).direction(),
        Some(Direction::X)
    );
    assert_eq!(
        Position::new([1e9, 0.0, 0.0]).direction(),
        Some(Direction::X)
    );
}
