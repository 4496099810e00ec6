use super::*;
use crate::number::sweep::Sweep;

/// Returns random unit vectors to the light and to the viewer, above a surface, with their cosines.
fn angles(seed: u64) -> impl Iterator<Item = ([f64; 3], [f64; 3], Cosines)> {
    let mut sweep = Sweep::new(seed);
    (0..200_000).map(move |_| {
        let [light, viewer] = [0; 2].map(|_| {
            let [x, y, z] = sweep.triple(1 << 20).map(f64::from);
            let length = (x * x + y * y + (z * z + 1.0)).sqrt();
            [x / length, y / length, (z * z + 1.0).sqrt() / length]
        });
        let quantised = |cosine: f64| Unit::from_bits((cosine * 2f64.powi(30)).floor() as i32);
        let cosines = Cosines {
            light: quantised(light[2]),
            viewer: quantised(viewer[2]),
            between: quantised(dot(light, viewer)),
        };
        (light, viewer, cosines)
    })
}

fn dot(a: [f64; 3], b: [f64; 3]) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

#[test]
fn half_way_cosine_is_the_one_of_the_half_way_vector() {
    for (light, viewer, cosines) in angles(2) {
        let sum = [0, 1, 2].map(|axis| light[axis] + viewer[axis]);
        let length = dot(sum, sum).sqrt();
        let truth = sum[2] / length;
        let square = cosines.half_way_square();
        // A quotient is known to 2^-26 of its value and rounded to a last place. Let s = n·l + n·v,
        // known to two last places, and let L be the length of light + viewer, which is at least s.
        // Then s² / 4 is known to s + 1 last places and L² / 4 to 3/2. If light and viewer face each
        // other, L is short, and rounding counts more.
        let rounded = (length + 2.5) * 2f64.powi(-28) / (length * length);
        let bound = 2f64.powi(-26) + 2f64.powi(-30) + rounded;
        let off = (square.to_num::<f64>() - truth * truth).abs();
        assert!(off <= bound, "{off:e}: {light:?} {viewer:?}");
        // a² - b² = (a - b) (a + b); a root is known to 2^-27 of it.
        let found = root_of_unit(square).to_num::<f64>();
        assert!(
            (found - truth).abs() <= bound / (found + truth) + 2f64.powi(-27) + 2f64.powi(-30),
            "{found}, not {truth}: {light:?} {viewer:?}"
        );
    }
}

#[test]
fn mirrored_cosine_is_the_one_of_the_mirrored_light() {
    for (light, viewer, cosines) in angles(3) {
        let mirrored = [-light[0], -light[1], light[2]];
        let truth = dot(mirrored, viewer).max(0.0);
        let found = cosines.mirrored().to_num::<f64>();
        assert!(
            (found - truth).abs() <= 8.0 * 2f64.powi(-30),
            "{found}, not {truth}"
        );
    }
}
