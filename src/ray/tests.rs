use super::*;
use crate::number::sweep::Sweep;

const NORMAL: Direction = Direction::X;

/// Returns the coordinates of a point in raw steps.
fn wide(place: ScaledPoint) -> [i64; 3] {
    let Point { x, y, z } = place.point;
    [x, y, z].map(|coordinate| i64::from(coordinate) << place.scale)
}

/// Tests whether the scale of a point is the smallest possible.
fn is_normal(place: ScaledPoint) -> bool {
    let Point { x, y, z } = place.point;
    let largest = x.abs().max(y.abs()).max(z.abs());
    // A coordinate that is too large by less than two may lose one step when it is rounded down.
    largest <= NEAR && (place.scale == 0 || 2 * largest + 2 > NEAR)
}

#[test]
fn point_that_is_near_stays_as_it_is() {
    let mut sweep = Sweep::new(1);
    for edge in [[0; 3], [NEAR - 1; 3], [-NEAR; 3]]
        .into_iter()
        .chain((0..9999).map(|_| sweep.triple(NEAR)))
    {
        let [x, y, z] = edge;
        let place = ScaledPoint::new(Point::new(x, y, z), 0);
        assert!(place.is_near());
        assert_eq!(place.point, Point::new(x, y, z));
    }
}

#[test]
fn point_beyond_the_near_region_is_kept_in_coarser_steps() {
    for (x, found) in [
        (NEAR, (NEAR / 2, 1)),
        (-NEAR - 1, (-NEAR / 2 - 1, 1)),
        (i32::MAX, (i32::MAX >> 3, 3)),
        (i32::MIN, (i32::MIN >> 3, 3)),
    ] {
        let place = ScaledPoint::new(Point::new(x, 0, 1), 0);
        assert_eq!((place.point.x, place.scale), found, "{x}");
        assert!(!place.is_near() && is_normal(place));
    }
}

#[test]
fn wide_coordinates_lose_less_than_a_step_of_their_scale() {
    let mut sweep = Sweep::new(2);
    for _ in 0..100_000 {
        let up = sweep.within(0, 32);
        let coordinates = sweep.triple(1 << 30).map(|it| i64::from(it) << up | 1);
        let place = ScaledPoint::from_wide(coordinates);
        assert!(is_normal(place), "{coordinates:?}: {place:?}");
        for (found, truth) in wide(place).into_iter().zip(coordinates) {
            let lost = truth - found;
            assert!(
                (0..1 << place.scale).contains(&lost),
                "{coordinates:?}: {place:?}"
            );
        }
    }
}

#[test]
fn way_between_near_places_is_exact() {
    let mut sweep = Sweep::new(3);
    for _ in 0..10_000 {
        let ([ax, ay, az], [bx, by, bz]) = (sweep.triple(NEAR), sweep.triple(NEAR));
        let a = ScaledPoint::new(Point::new(ax, ay, az), 0);
        let b = ScaledPoint::new(Point::new(bx, by, bz), 0);
        assert_eq!(a.to(b), (Vector::new(bx - ax, by - ay, bz - az), 0));
    }
}

#[test]
fn way_between_places_of_any_scale_loses_less_than_two_steps_of_the_larger() {
    let mut sweep = Sweep::new(4);
    for _ in 0..100_000 {
        let [a, b] = [0; 2].map(|_| {
            let up = sweep.within(0, 32);
            ScaledPoint::from_wide(sweep.triple(NEAR).map(|it| i64::from(it) << up))
        });
        let (way, scale) = a.to(b);
        assert_eq!(scale, a.scale.max(b.scale));
        let found = [way.x, way.y, way.z].map(|it| i128::from(it) << scale);
        for (axis, found) in found.into_iter().enumerate() {
            let truth = i128::from(wide(b)[axis]) - i128::from(wide(a)[axis]);
            let lost = truth - found;
            assert!(lost.abs() < 1 << scale, "{lost}: {a:?} {b:?}");
        }
    }
}

#[test]
fn leaving_point_lies_epsilon_along_the_normal() {
    let epsilon = Length::from_bits(1000);
    let at = |scale| ScaledPoint::new(Point::new(NEAR / 2 + 7, -5, 3), scale);
    for (scale, lift) in [(0, 1000), (1, 500), (3, 125), (9, 1), (10, 0), (40, 0)] {
        let (from, lifted) = (at(scale), at(scale).lifted(NORMAL, epsilon));
        let way = from.point.to(lifted.point);
        assert_eq!(
            (way, lifted.scale),
            (Vector::new(lift, 0, 0), scale),
            "at scale {scale}"
        );
        let below = from.lifted(NORMAL.reversed(), epsilon);
        assert_eq!(
            from.point.to(below.point),
            Vector::new(-lift, 0, 0),
            "at scale {scale}"
        );
    }
}

#[test]
fn trails_of_different_lengths_differ() {
    // A note of 0 stands for the outside of the first shape, and for no light.
    let noted = |zeros: usize| {
        let mut signature = PathSignature::new();
        (0..zeros).for_each(|_| signature.note(0));
        signature.note(u32::MAX);
        signature.ended(true)
    };
    for longer in 0..24 {
        for shorter in 0..longer {
            assert_ne!(noted(longer), noted(shorter), "{longer} and {shorter}");
        }
    }
}

#[test]
fn tangents_lie_between_their_columns() {
    let mut sweep = Sweep::new(9);
    let mut known = 0;
    for _ in 0..100_000 {
        let axis = ScreenAxis {
            origin: Point::new(0, 0, 0),
            ahead: Direction::X,
            aside: Direction::X,
            distance: sweep.within(1 << 29, 1 << 30),
            scale: -sweep.within(17, 24),
            width: 1,
        };
        let wide = |sweep: &mut Sweep| {
            let bits = sweep.within(0, 58);
            (i64::from(sweep.within(-1 << 30, 1 << 30)) << 30) >> bits
        };
        let (numerator, off) = (wide(&mut sweep), wide(&mut sweep).abs() >> 10);
        let denominator = wide(&mut sweep).abs() + 1;
        let [first, last] = axis.sixteenths(numerator, off, axis.columns_for_each(denominator));
        let each =
            8.0 * f64::from(axis.distance) * f64::from(axis.scale).exp2() / denominator as f64;
        let [low, high] = [numerator - off, numerator + off].map(|it| it as f64 * each);
        // The factor is known to 26 bits.
        let (first, last) = (f64::from(first), f64::from(last));
        let error = 2.0_f64.powi(-20);
        let limit = f64::from(1 << 23);
        assert!(
            first <= low.max(-limit) + error || low > limit,
            "{first} {low}"
        );
        assert!(
            last + 1.0 >= high.min(limit) - error || high < -limit,
            "{last} {high}"
        );
        if low > -limit && high < limit && (off as f64) * each < 1000.0 {
            known += 1;
            let wider = 3.0 + error + 2.0_f64.powi(-24) * low.abs();
            assert!(
                low - first <= wider && last - high <= wider,
                "{low}-{high}: {first}-{last}"
            );
        }
    }
    assert!(known > 10_000, "{known}");
}

#[test]
fn cells_of_checkers_do_not_make_other_paths() {
    let path = |met: u32| {
        let mut path = PathSignature::new();
        path.note(met);
        path.ended(true)
    };
    let (one, other) = (path(7), path(8));
    for borders in [[true, false], [false, true], [true, true]] {
        let beyond = one.across(borders);
        assert!(beyond.is_same_as(one) && beyond.mark().meets_same(one.mark()));
        assert!(beyond.mark() != one.mark() && !beyond.mark().meets_same(other.mark()));
        assert_eq!(beyond.across(borders), one);
    }
    let fine = one.in_fine_cells(true);
    assert!(fine.is_fine() && !one.is_fine() && fine.is_same_as(one));
    assert_eq!(fine.mark(), one.mark());
    assert!(!one.is_same_as(other) && fine.is_bounded());
}

/// The two changes of these paths leave the lower bits of a signature alone.
#[test]
fn paths_that_differ_in_shape_and_light_do_not_meet_the_same() {
    let mark = |met: [u32; 2]| {
        let mut path = PathSignature::new();
        met.into_iter().for_each(|it| path.note(it));
        path.ended(true).mark()
    };
    for shape in 0..64 {
        let (lit, other) = (mark([shape, 16]), mark([shape + 16, 0]));
        assert!(!lit.meets_same(other), "shape {shape}");
    }
}
