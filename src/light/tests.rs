use super::*;
use crate::number::sweep::Sweep;

/// Returns a lamp at the middle of a grid of 2^-18 scene units, and the range in steps of the grid.
fn ranged(range: Number) -> (PreparedLight, f64) {
    let grid = Grid::new(Position::ORIGIN, Number::new(1024.0).to_bits() as u128);
    let light = Light::ranged(Position::ORIGIN, [Number::ONE; 3], range);
    assert_eq!(light.fault(), None);
    let steps = range.to_f64() * 2f64.powi(grid.fraction_bits());
    (PreparedLight::new(&light, &grid), steps)
}

fn strength(light: &PreparedLight, distance: i32, scale: u32) -> f64 {
    let Kind::Ranged { drop, mantissa } = light.kind else {
        panic!("it has a range");
    };
    let range = (mantissa, 97 - i32::from(drop));
    falloff(range, Length::from_bits(distance), scale).to_num()
}

/// Ranges of all sizes, distances of all sizes and scales.
#[test]
fn falloff_is_known_to_24_bits() {
    let mut sweep = Sweep::new(7);
    let mut worst = 0.0_f64;
    for _ in 0..200_000 {
        let bits = i128::from(sweep.octaves(0, 30)) << sweep.within(0, 64);
        let (light, range) = ranged(Number::from_bits(bits));
        let scale = [0, sweep.within(0, 31) as u32][sweep.within(0, 1) as usize];
        // Every other distance is about the range, where the strength changes most.
        let about = (range * 2f64.powi(-(scale as i32))) as i64;
        let about = about.saturating_mul(i64::from(sweep.within(1, 1000))) / 500;
        let distance = match i32::try_from(about.max(1)) {
            Ok(distance) if sweep.within(0, 1) == 1 => distance,
            _ => sweep.octaves(0, 30),
        };
        let ratio = f64::from(distance) * 2f64.powi(scale as i32) / range;
        let error = strength(&light, distance, scale) - 1.0 / (1.0 + ratio * ratio);
        worst = worst.max(error.abs());
    }
    assert!(worst < 2f64.powi(-24), "{}", worst.log2());
    assert!(worst > 2f64.powi(-28), "{}", worst.log2());
}

#[test]
fn strength_is_a_half_at_the_range_and_never_above_one() {
    for range in [
        Number::from_bits(1),
        Number::new(0.5),
        Number::new(1_073_741_824.0),
    ] {
        let (light, steps) = ranged(range);
        assert!((0.0..=1.0).contains(&strength(&light, 1, 0)));
        assert!((0.0..=1.0).contains(&strength(&light, i32::MAX, 31)));
        if (1.0..1e9).contains(&steps) {
            assert!((strength(&light, steps as i32, 0) - 0.5).abs() < 1e-7);
        }
    }
    let far = strength(&ranged(Number::new(1e9)).0, 1 << 20, 0);
    assert!((1.0 - 2f64.powi(-24)..=1.0).contains(&far), "{far}");
    assert_eq!(strength(&ranged(Number::from_bits(1)).0, 1 << 20, 0), 0.0);
}

#[test]
fn light_takes_no_more_room_than_without_a_range() {
    assert_eq!(size_of::<Kind>(), 8);
    assert_eq!(size_of::<PreparedLight>(), 40);
}

#[test]
fn lamp_that_moves_keeps_its_range() {
    let (light, _) = ranged(Number::new(2.0));
    let grid = Grid::new(Position::ORIGIN, Number::new(1024.0).to_bits() as u128);
    let moved = light.moved(Position::new([5.0, 0.0, 0.0]), &grid);
    assert!(moved.is_ranged() && strength(&moved, 1 << 19, 0) > 0.499);
}
