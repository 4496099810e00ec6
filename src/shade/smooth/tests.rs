use super::*;
use crate::number::sweep::Sweep;

type Place = [f64; 3];

fn minus(one: Place, other: Place) -> Place {
    [0, 1, 2].map(|axis| one[axis] - other[axis])
}

fn length(way: Place) -> f64 {
    way.iter().map(|it| it * it).sum::<f64>().sqrt()
}

fn unit(way: Place) -> Place {
    way.map(|it| it / length(way))
}

fn bits(share: f64) -> i32 {
    (share * f64::from(1 << 30)) as i32
}

fn on_line([one, other]: [Place; 2], share: f64) -> Place {
    [0, 1, 2].map(|axis| one[axis] + (other[axis] - one[axis]) * share)
}

/// Returns the distance of a place from the line between two others.
fn aside(place: Place, [one, other]: [Place; 2]) -> f64 {
    let (way, from) = (minus(other, one), minus(place, one));
    let dot: f64 = (0..3).map(|axis| way[axis] * from[axis]).sum();
    let share = dot / length(way).powi(2).max(1e-300);
    length(minus(place, on_line([one, other], share.clamp(0.0, 1.0))))
}

/// Directions from a floor to a light and to an eye that lie opposite, so that half-way vectors turn faster than both.
#[test]
fn half_way_vector_is_no_further_off_its_line_than_its_bend() {
    let mut sweep = Sweep::new(64);
    let mut number = || f64::from(sweep.triple(1 << 20)[0]) / 1_048_576.0;
    let (mut seen, mut closest) = (0, f64::INFINITY);
    for _ in 0..40_000 {
        let (eye, light) = (
            [0.0, 0.0, 1.0],
            [12.0 * number(), 12.0 * number(), 0.05 + number().abs()],
        );
        let first = [12.0 * number(), 12.0 * number(), 0.0];
        let last = minus(first, [number(), number(), 0.0]);
        let ways = |place| [light, eye].map(|end| unit(minus(end, place)));
        let sum = |place| {
            let [one, other] = ways(place);
            minus(one, other.map(|it| -it))
        };
        let ([to_light, to_eye], [light_after, eye_after]) = (ways(first), ways(last));
        let [turn, view] = [(to_light, light_after), (to_eye, eye_after)]
            .map(|(one, other)| length(minus(one, other)));
        let shortest = length(sum(first)).min(length(sum(last)));
        if turn.max(view) > 0.9 || shortest > 1.0 {
            continue;
        }
        let turns = Turns {
            normal: 0,
            light: bits(turn),
            view: bits(view),
            circle: Unit::ONE,
        };
        let Some(bend) = turns.bend(Unit::from_bits(bits(shortest * shortest / 4.0))) else {
            continue;
        };
        let bend = f64::from(bend) / f64::from(1 << 28);
        let ends = [first, last].map(|place| unit(sum(place)));
        for part in 1..16 {
            let place = on_line([first, last], f64::from(part) / 16.0);
            let off = aside(unit(sum(place)), ends);
            assert!(off <= bend + 1e-7, "{light:?} {first:?} {last:?}");
            if off > 1e-3 {
                closest = closest.min(bend / off);
            }
        }
        seen += 1;
    }
    assert!(seen > 2000 && closest < 2.0, "{seen} {closest}");
}

#[test]
fn highlight_has_no_bound_where_everything_turns_by_sixty_degrees() {
    let bend = |[normal, light, view]: [i32; 3], square| {
        let circle = Unit::ONE;
        let turns = Turns {
            normal,
            light,
            view,
            circle,
        };
        turns.bend(square)
    };
    let one = Unit::ONE.to_bits();
    assert_eq!(bend([one; 3], Unit::ONE), None);
    assert_eq!(bend([one, one, 0], Unit::ONE), None);
    assert_eq!(bend([0, one / 4, one / 4], Unit::ZERO), None);
    assert_eq!(bend([0, one, one / 8 * 7], Unit::ZERO), None);
    // A quarter of the square of the sum.
    let bend = bend([one / 4; 3], Unit::ONE).unwrap();
    assert!((bend - one / 256 * 9).abs() < 16, "{bend}");
}
