//! Tests of colours and sums of them.

use super::*;

fn quantised(value: f64) -> u8 {
    let mut sum = Sum::DARK;
    let color = Color::grey(brightness(Number::new(value)));
    sum.add(Unit::ONE, color.in_levels());
    sum.to_rgb8()[0]
}

#[test]
fn every_level_is_hit_in_its_middle() {
    for level in 0..=255_u8 {
        assert_eq!(quantised(f64::from(level) / 255.0), level);
    }
}

#[test]
fn levels_change_half_way_between() {
    for level in 0..255_u8 {
        let edge = (f64::from(level) + 0.5) / 255.0;
        assert_eq!(quantised(edge - 1e-6), level);
        assert_eq!(quantised(edge + 1e-6), level + 1);
    }
}

/// Returns the sums at 0 to 16 of a parabola with these factors, which are exact multiples.
fn curve([square, slope, start]: [i32; 3]) -> [Sum; 17] {
    let at = |x: i32, sign: i32| start + sign * (square * x * x + slope * x);
    core::array::from_fn(|x| Sum([1, -1, 2].map(|sign| at(x as i32, sign))))
}

#[test]
fn parabola_goes_through_all_sums_of_a_parabola() {
    for factors in [
        [0, 0, 5],
        [0, 700, -3],
        [64, -9000, 1 << 24],
        [-123, 4567, 9],
    ] {
        let sums = curve(factors);
        for half in [2, 4, 8] {
            let mut filled = [Sum::ZERO; 17];
            let three = [sums[0], sums[half], sums[2 * half]];
            let curve = Parabola::through(three, half as u32, 2 * half as u32);
            curve.fill(filled.iter_mut().take(2 * half), |sum| sum);
            for (place, (found, truth)) in filled.iter().zip(&sums).enumerate() {
                if place < 2 * half {
                    assert!(found.less(*truth).is_within(16), "{place} of {half}")
                } else {
                    assert_eq!(*found, Sum::ZERO)
                }
            }
        }
    }
}

#[test]
fn rounding_of_a_parabola_stays_below_four_hundredths_of_a_level() {
    let mut sweep = crate::number::sweep::Sweep::new(51);
    for round in 0..20_000 {
        let length = 3 + round % (LONGEST - 2);
        let half = length / 2;
        let three = [0; 3].map(|_| sweep.triple(1 << 25));
        let mut filled = [Sum::ZERO; LONGEST];
        let curve = Parabola::through(three.map(Sum), half as u32, length as u32);
        curve.fill(filled.iter_mut().take(length), |sum| sum);
        for (place, found) in filled.iter().take(length).enumerate() {
            for axis in 0..3 {
                let [start, middle, end] = three.map(|it| f64::from(it[axis]));
                let slope = (middle - start) / half as f64;
                let second = (end - middle) / (length - half) as f64 - slope;
                let way = second * (place as f64 - half as f64) / length as f64 + slope;
                let off = (f64::from(found.0[axis]) - (start + way * place as f64)).abs();
                let most = if length.is_power_of_two() { 400.0 } else { 650.0 };
                // The error of the second difference grows with the square of the length.
                let most = if length > 32 { 4.0 * most } else { most };
                assert!(off < most, "{off} at {place} of {length}: {three:?}");
            }
        }
        let found = curve.bend(half as u32);
        if length == 2 * half {
            let [start, middle, end] = three.map(Sum);
            let exact = bend(start, middle, end);
            assert!(
                found.less(exact).is_within(2 * (half * half) as i32 + 2),
                "{length}"
            );
        }
    }
}

/// Returns the second difference of three sums.
fn bend(before: Sum, middle: Sum, after: Sum) -> Bend {
    after.less(middle).less(middle.less(before))
}

#[test]
fn half_way_is_exact_with_the_bend_of_the_three() {
    for factors in [
        [0, 0, 5],
        [0, 700, -4],
        [64, -9000, 1 << 24],
        [-124, 4568, 10],
    ] {
        let sums = curve(factors);
        for (start, middle, end) in [(0, 1, 2), (3, 5, 7), (0, 8, 16)] {
            let bent = bend(sums[start], sums[middle], sums[end]);
            let found = sums[start].half_way(sums[end], bent);
            assert!(found.less(sums[middle]).is_within(1), "{factors:?}");
        }
    }
}

/// The halves of a stretch may have different lengths. Each expects the bend for its own.
#[test]
fn parabola_knows_its_bend_for_each_distance() {
    for factors in [[0, 0, 5], [0, 700, -4], [64, -9000, 1 << 20]] {
        let sums = curve(factors);
        let parabola = Parabola::through([sums[0], sums[5], sums[11]], 5, 11);
        for half in 1..6 {
            let exact = bend(sums[0], sums[half], sums[2 * half]);
            let found = parabola.bend(half as u32);
            let off = (half * half) as i32 + 1;
            assert!(found.less(exact).is_within(off), "{factors:?}, {half}");
        }
    }
}

#[test]
fn what_is_brighter_than_white_is_white() {
    assert_eq!(quantised(16.0), 255);
}

#[test]
fn mean_of_samples_is_that_of_the_clamped_ones() {
    let sample = |level: i32| Levels::of(Sum([(level << 16) + HALF; 3]));
    for count in [1, 2, 3, 5, 16, 17, 2048] {
        let mut mixture = Mixture::NONE;
        (0..count).for_each(|index| mixture.add(sample(if index == 0 { -90 } else { 300 }), 1));
        let level = 255.0 * f64::from(count - 1) / f64::from(count);
        let Sum([mean, ..]) = mixture.mean(count as u32).sum();
        let off = f64::from(mean - HALF) - level * 65_536.0;
        assert!((-512.0..=0.0).contains(&off), "{count}: {off}");
    }
}

#[test]
fn contrast_is_the_largest_difference_in_levels() {
    let color = |levels: [i32; 3]| Levels::of(Sum(levels.map(|level| (level << 16) + HALF)));
    let (one, other) = (color([10, 200, 30]), color([12, 120, 30]));
    assert_eq!(
        [one.contrast(other), other.contrast(one), one.contrast(one)],
        [80, 80, 0]
    );
    // Half a level is added to each component.
    assert_eq!(one.brightness(), (240 << 8) + 3 * 128);
}
