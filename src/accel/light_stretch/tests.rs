use super::*;
use crate::number::sweep::Sweep;

/// Returns the distance between two points.
fn distance([from, to]: [[f64; 3]; 2]) -> f64 {
    let squares = [0, 1, 2].map(|axis| (to[axis] - from[axis]).powi(2));
    squares.iter().sum::<f64>().sqrt()
}

/// No point of a ray to a curve that lies in a ball is further from the fan's triangle than the thickness for that ball.
#[test]
fn fan_is_as_thick_as_rays_in_a_ball_are_off() {
    let mut sweep = Sweep::new(91);
    let (mut thin, mut closest) = (0, f64::INFINITY);
    for _ in 0..20_000 {
        let [apex, one] = [0; 2].map(|_| sweep.triple(1 << 24));
        let size = sweep.octaves(10, 23);
        let other = sweep.triple(size);
        let other = [0, 1, 2].map(|axis| one[axis] + other[axis]);
        let bulge = sweep.octaves(6, 20);
        let place = |[x, y, z]: [i32; 3]| ScaledPoint::at(Point::new(x, y, z));
        let rays = Rays::new(place(apex), [one, other].map(place));
        let sight = Sight::new(&rays, bulge);
        let [apex, one, other] = [apex, one, other].map(|it| it.map(f64::from));
        let mix = |a: [f64; 3], b: [f64; 3], share: f64| {
            [0, 1, 2].map(|axis| a[axis] + share * (b[axis] - a[axis]))
        };
        let [part, share] =
            [0; 2].map(|_| f64::from(sweep.within(0, 1 << 20)) / f64::from(1 << 20));
        let on_chord = mix(one, other, part);
        let aside = sweep.triple(1 << 20).map(f64::from);
        let length = distance([aside, [0.0; 3]]).max(1.0);
        let off = [0, 1, 2].map(|axis| aside[axis] / length * f64::from(bulge));
        let on_curve = [0, 1, 2].map(|axis| on_chord[axis] + off[axis]);
        let [point, straight] = [on_curve, on_chord].map(|end| mix(apex, end, share));
        let radius = sweep.octaves(4, 22);
        let within = sweep.triple(radius * 4 / 7);
        let [x, y, z] = [0, 1, 2].map(|axis| point[axis] as i32 + within[axis]);
        let thickness = f64::from(sight.thickness((Point::new(x, y, z), radius)));
        let found = distance([point, straight]);
        assert!(
            found <= thickness,
            "{rays:?} {bulge} {share}: {found} {thickness}"
        );
        if thickness < f64::from(bulge) {
            thin += 1;
            closest = closest.min((thickness - f64::from(SLACK)) / found.max(1.0));
        }
    }
    assert!(thin > 2_000 && closest < 1.5, "{thin} {closest}");
}
