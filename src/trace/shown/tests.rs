use super::*;
use crate::shape::rays::turn_between;
use crate::vector::Vector;

/// Opposite directions along an axis, each a few last places longer than one.
fn opposite() -> [Direction; 2] {
    [1, -1].map(|sign| Direction::from_raw(Vector::new(sign * ((1 << 30) + 3), 0, 0)))
}

#[test]
fn opposite_normals_turn_too_much() {
    let across = Direction::from_raw(Vector::new(0, 0, 1 << 30));
    assert!(turn_in_plane(opposite(), across).is_none());
}

/// Arcs of ellipses, against their chords.
#[test]
fn ellipse_is_no_further_from_its_chord_than_its_bulge() {
    let mut sweep = crate::number::sweep::Sweep::new(63);
    let (mut arcs, mut closest) = (0, f64::INFINITY);
    for _ in 0..40_000 {
        let [flat, start, length] = sweep.triple(1 << 20).map(|it| f64::from(it) / 1048576.0);
        let (wide, high) = (1e6, 1e6 * (0.02 + flat.abs()));
        let [first, last] = [0.0, 1.0].map(|it| 3.2 * start + it * 2.5 * length);
        let point = |angle: f64| (wide * angle.cos(), high * angle.sin());
        let normal = |angle: f64| (high * angle.cos()).atan2(wide * angle.sin());
        let turn = (normal(last) - normal(first)).abs();
        let turn = turn.min(core::f64::consts::TAU - turn);
        if turn > core::f64::consts::FRAC_PI_3 {
            continue;
        }
        let ((x, y), (right, top)) = (point(first), point(last));
        let chord = (right - x).hypot(top - y);
        let angle = 2.0 * (turn / 2.0).sin() * f64::from(1 << 30);
        let bound = f64::from(bulge(
            (chord / 2.0) as i32 + 1,
            Unit::from_bits(angle as i32),
        ));
        for part in 1..16 {
            let (across, up) = point(first + (last - first) * f64::from(part) / 16.0);
            let off = ((right - x) * (up - y) - (top - y) * (across - x)).abs() / chord.max(1.0);
            assert!(off <= bound, "{flat} {first} {last}: {off}, {bound}");
            if off > 1e4 {
                closest = closest.min(bound / off);
            }
        }
        arcs += 1;
    }
    assert!(arcs > 5000 && closest < 1.2, "{arcs} {closest}");
}

/// Heights of lights above circles, against their straight lines.
#[test]
fn height_of_a_light_bends_no_more_than_its_bound() {
    let mut sweep = crate::number::sweep::Sweep::new(62);
    let mut bent = 0.0_f64;
    for _ in 0..20_000 {
        let [away, aside, shift] = sweep.triple(1 << 20).map(|it| f64::from(it) / 1048576.0);
        let (circle, radius) = (1.0 - away * away, 1.0);
        let (circle, angle) = (circle.sqrt(), aside * 1.04);
        let light = (1.2 + 5.0 * shift.abs(), 7.0 * shift, 3.0 * away);
        let height = |angle: f64| {
            circle * (light.0 * angle.cos() + light.1 * angle.sin()) + away * light.2 - radius
        };
        let from = |angle: f64| {
            let (x, y) = (circle * angle.cos(), circle * angle.sin());
            let ways = [light.0 - x, light.1 - y, light.2 - away];
            ways.iter().map(|it| it * it).sum::<f64>().sqrt()
        };
        let distance = from(0.0).min(from(angle));
        let turn = 2.0 * circle * (angle.abs() / 2.0).sin();
        let bits = |share: f64| Unit::from_bits((share * f64::from(1 << 30)) as i32);
        let steps = [radius, distance].map(|it| (it * f64::from(1 << 24)) as i32);
        let Some(bound) = bend_of_height(bits(turn), bits(circle), steps) else {
            continue;
        };
        for part in 0..=8 {
            let share = f64::from(part) / 8.0;
            let line = height(0.0) * (1.0 - share) + height(angle) * share;
            let off = (height(share * angle) - line).abs() / distance;
            bent = bent.max(off);
            assert!(
                off <= f64::from(bound) / f64::from(1 << 30) + 1e-7,
                "{light:?} {angle}"
            );
        }
    }
    assert!(bent > 0.05, "{bent}");
}

#[test]
fn light_between_two_places_turns_too_much() {
    let [first, last] = opposite();
    assert_eq!(turn_between(first, last), Unit::ONE);
}
