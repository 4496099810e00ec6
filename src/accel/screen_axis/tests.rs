use super::*;
use crate::number::sweep::Sweep;
use crate::vector::{Direction, Point};

/// Returns the axis of a camera at the origin that looks along x.
fn screen_axis(aside: Direction) -> ScreenAxis {
    ScreenAxis {
        origin: Point::ORIGIN,
        ahead: Direction::X,
        aside,
        distance: 1 << 29,
        scale: -20,
        width: 64,
    }
}

/// The root in [`ScreenAxis::tips`] is rounded down. The difference that remains is smallest where the
/// sphere almost reaches the plane through the eye and is as large as the ball.
#[test]
fn tips_of_a_sphere_that_is_just_ahead_lie_ahead() {
    let y = Direction::from_raw(Vector::new(0, 1 << 30, 0));
    let z = Direction::from_raw(Vector::new(0, 0, 1 << 30));
    let mut sweep = Sweep::new(31);
    for _ in 0..100_000 {
        let radius = sweep.octaves(25, 28);
        let [ahead, down] = [radius + sweep.within(1, 8), sweep.octaves(26, 30)];
        let way = Vector::new(ahead, down, sweep.octaves(3, 28));
        // The assertions inside of `tips` check that the points lie ahead.
        let [below, above] = [way, Vector::new(ahead, -down, way.z)].map(|way| {
            screen_axis(z)
                .tips(&screen_axis(y), way, radius)
                .expect("it is ahead")
        });
        assert_eq!(below, [above[1], above[0]], "{way:?}, {radius}");
    }
}
