use super::*;
use crate::number::sweep::Sweep;

type Triple = [f64; 3];

fn dot(a: Triple, b: Triple) -> f64 {
    a[0] * b[0] + a[1] * b[1] + a[2] * b[2]
}

fn unit(a: Triple) -> Triple {
    a.map(|coordinate| coordinate / dot(a, a).sqrt())
}

fn cross(a: Triple, b: Triple) -> Triple {
    [
        a[1] * b[2] - a[2] * b[1],
        a[2] * b[0] - a[0] * b[2],
        a[0] * b[1] - a[1] * b[0],
    ]
}

/// Returns the direction of the ray through the middle of a pixel, computed in double precision.
fn in_double_precision(
    [position, target, up]: [Triple; 3],
    degrees: f64,
    (width, height): (u32, u32),
    (x, y): (u32, u32),
) -> Triple {
    let forward = unit([0, 1, 2].map(|axis| target[axis] - position[axis]));
    let right = unit(cross(forward, up));
    let upward = cross(right, forward);
    let half = (degrees / 2.0).to_radians().tan();
    let [width, height] = [width, height].map(f64::from);
    let across = (2.0 * (f64::from(x) + 0.5) / width - 1.0) * half;
    let above = (1.0 - 2.0 * (f64::from(y) + 0.5) / height) * half * height / width;
    unit([0, 1, 2].map(|axis| forward[axis] + across * right[axis] + above * upward[axis]))
}

fn in_doubles(direction: Direction) -> Triple {
    direction.components().map(|unit| unit.to_num::<f64>())
}

/// Asserts that a camera's ray equals the ray in double precision, within the bound of rounding.
fn assert_ray(at: [Triple; 3], degrees: f64, size: (u32, u32), pixel: (u32, u32)) {
    let [position, target, up] = at;
    let camera = Camera::new(position, target, up, degrees).unwrap();
    let (x, y) = pixel;
    let found = in_doubles(camera.generator(size.0, size.1).row(y).of(x));
    let truth = in_double_precision(at, degrees, size, pixel);
    // The axes are right to 2^-29, a reciprocal root to 2^-27.5. The vector from the middle of the
    // picture to a pixel is rounded to 2^-28 of the vector to the corner, whose length is the tangent of
    // half the wider angle.
    let tangent = (degrees / 2.0).to_radians().tan();
    let corner = tangent * (f64::from(size.1) / f64::from(size.0)).max(1.0);
    let bound = 2f64.powi(-26) + corner * 2f64.powi(-26);
    for axis in 0..3 {
        let off = (found[axis] - truth[axis]).abs();
        assert!(off <= bound, "{off:e}: {at:?} {degrees} {size:?} {pixel:?}");
    }
}

#[test]
fn every_ray_is_the_one_of_double_precision() {
    let mut sweep = Sweep::new(1);
    let mut checked = 0;
    while checked < 50_000 {
        let at = [0; 3].map(|_| sweep.triple(1 << 20).map(|it| f64::from(it) / 1024.0));
        let [position, target, up] = at;
        let forward = unit([0, 1, 2].map(|axis| target[axis] - position[axis]));
        // If up is almost parallel to the view, its rounding error turns the picture noticeably.
        if dot(forward, unit(up)).abs() > 0.9 {
            continue;
        }
        let degrees = f64::from(sweep.within(1, 179_000)) / 1000.0;
        let (width, height) = (sweep.octaves(0, 12) as u32, sweep.octaves(0, 12) as u32);
        let x = sweep.within(0, width as i32 - 1) as u32;
        let y = sweep.within(0, height as i32 - 1) as u32;
        assert_ray(at, degrees, (width, height), (x, y));
        checked += 1;
    }
}

#[test]
fn corners_of_the_largest_picture_are_the_ones_of_double_precision() {
    let at = [[1.0, 2.0, 3.0], [-4.0, 5.0, 6.5], [0.1, 0.2, 1.0]];
    for (width, height) in [(65_535, 65_535), (65_535, 1), (1, 65_535), (1, 1)] {
        for x in [0, width - 1] {
            for y in [0, height - 1] {
                for degrees in [0.001, 1.0, 50.0, 179.0] {
                    assert_ray(at, degrees, (width, height), (x, y));
                }
            }
        }
    }
}

#[test]
fn middle_of_a_picture_looks_straight_at_the_target() {
    let camera = Camera::look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
    let middle = camera.generator(65, 33).row(16).of(32);
    let [x, y, z] = in_doubles(middle);
    assert_eq!((x, z), (0.0, 0.0));
    assert!((y - 1.0).abs() <= 2f64.powi(-29), "{y}");
}

#[test]
fn orbit_keeps_target_and_distance() {
    let mut sweep = Sweep::new(2);
    for _ in 0..2000 {
        let position = sweep.triple(1 << 20).map(|it| f64::from(it) / 1024.0);
        let camera = Camera::new(position, [0.5, 0.25, -0.75], [0.0, 0.0, 1.0], 50.0).unwrap();
        let (azimuth, elevation) = (sweep.within(-720, 720), sweep.within(-3, 3));
        let Ok(turned) = camera.orbited(azimuth, elevation) else {
            // The camera is so near to the pole that it would pass it.
            let [x, y, z] = [position[0] - 0.5, position[1] - 0.25, position[2] + 0.75];
            assert!(x.hypot(y) < 0.053 * z.abs(), "{position:?} {elevation}");
            continue;
        };
        let turned = turned.description();
        assert_eq!(turned.target, camera.description().target);
        let distance = |position: Position| {
            let offset = position.minus(turned.target).0.map(Number::to_f64);
            dot(offset, offset).sqrt()
        };
        let ratio = distance(turned.position) / distance(camera.description().position);
        assert!(
            (ratio - 1.0).abs() <= 2f64.powi(-26),
            "{ratio}: {position:?} {azimuth} {elevation}"
        );
    }
}

#[test]
fn orbit_of_four_quarters_comes_back() {
    let mut camera = Camera::look_at([3.0, -5.0, 2.0], [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]);
    let start = camera.description().position.0.map(Number::to_f64);
    for _ in 0..4 {
        camera = camera.orbited(90, 0).unwrap();
    }
    let end = camera.description().position.0.map(Number::to_f64);
    for axis in 0..3 {
        assert!(
            (end[axis] - start[axis]).abs() <= 1e-6,
            "{end:?}, not {start:?}"
        );
    }
}

#[test]
fn orbit_to_the_right_shows_the_right_side() {
    let camera = Camera::look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
    let [x, y, z] = camera
        .orbited(90, 0)
        .unwrap()
        .description()
        .position
        .0
        .map(Number::to_f64);
    assert!(
        (x - 5.0).abs() < 1e-6 && y.abs() < 1e-6 && z.abs() < 1e-6,
        "{x} {y} {z}"
    );
    let [x, y, z] = camera
        .orbited(0, 45)
        .unwrap()
        .description()
        .position
        .0
        .map(Number::to_f64);
    let half = 12.5_f64.sqrt();
    let off = [x, y + half, z - half];
    assert!(off.into_iter().all(|it| it.abs() < 1e-6), "{x} {y} {z}");
}

#[test]
fn orbit_over_the_pole_is_refused() {
    let camera = Camera::look_at([0.0, -5.0, 0.0], [0.0; 3], [0.0, 0.0, 1.0]);
    for (azimuth, elevation) in [(0, 90), (0, 91), (30, 95), (0, -100), (180, 180), (0, 270)] {
        assert_eq!(
            camera.orbited(azimuth, elevation).unwrap_err(),
            Error::of("camera", ErrorKind::Up),
            "{elevation}"
        );
    }
    let mut steps = 0;
    let mut raised = camera;
    while let Ok(next) = raised.orbited(0, 20) {
        (raised, steps) = (next, steps + 1);
    }
    assert_eq!(steps, 4);
    assert!(camera.orbited(0, 360).is_ok());
    assert_eq!(
        camera.orbited(f64::NAN, 0).unwrap_err(),
        Error::of("camera", ErrorKind::Coordinate)
    );
}
