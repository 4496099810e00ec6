use super::*;
use crate::camera::Camera;
use crate::number::sweep::Sweep;
use crate::shape::MaterialId;

/// Returns the length of a vector.
fn length([x, y, z]: [f64; 3]) -> f64 {
    (x * x + y * y + z * z).sqrt()
}

/// The part of a sphere on the camera's side of a mirror lies in the ball that `in_front` returns.
#[test]
fn ball_in_front_of_a_mirror_holds_the_cap_of_a_sphere() {
    let mut sweep = Sweep::new(61);
    let camera = Camera::new([0, 0, 9], [0, 5, 0], [0, 0, 1], 60).unwrap();
    let generator = camera.generator(64, 64);
    let mut smaller = 0;
    for _ in 0..20_000 {
        let eye = Point::new(0, 0, sweep.octaves(8, 26));
        let axes = camera.screen_axes(&generator, eye);
        let [x, y, z] = [sweep.within(-99, 99), sweep.within(-99, 99), 200];
        let (normal, _) = Vector::new(x, y, z).normalised();
        let normal = normal.reversed_if(sweep.within(0, 1) == 0);
        let plane = PreparedPlane::new(normal, 0, 0, MaterialId(0));
        let epsilon = Length::from_bits(64);
        let seen = Eye {
            axes: &axes,
            plane: Some(&plane),
            epsilon,
        };
        let radius = sweep.octaves(8, 26);
        let [x, y, z] = sweep.triple(radius);
        let center = Point::new(x, y, z);
        let (middle, reach) = seen.in_front((center, radius));
        smaller += u32::from(reach < radius / 2);
        for _ in 0..20 {
            let [x, y, z] = sweep.triple(1 << 20).map(f64::from);
            let long = f64::from(radius) / length([x, y, z + 0.5]);
            let at = Vector::new((x * long) as i32, (y * long) as i32, (z * long) as i32);
            let at = Point::at(center.to_vector().plus(at));
            if plane.height(at).signum() == plane.height(eye).signum() {
                let way = middle.to(at);
                let apart = length([way.x, way.y, way.z].map(f64::from));
                assert!(
                    apart <= f64::from(widened(reach)),
                    "{center:?} {radius} {plane:?}"
                );
            }
        }
    }
    assert!(smaller > 500, "{smaller}");
}
