//! Normals between the corners.

use super::*;
use crate::number::Unit;

/// Returns the normal of a weighted sum of normals, in double precision, bent as the reference bends it.
fn truth(
    triangle: &PreparedTriangle,
    normals: [Triple; 3],
    at: Vector,
    flat: Triple,
    view: Triple,
) -> Triple {
    let [one, other] = triangle.sides.map(in_doubles);
    let at = in_doubles(at);
    let cross = |a: Triple, b: Triple| {
        [0, 1, 2].map(|i| {
            let (j, k) = ((i + 1) % 3, (i + 2) % 3);
            a[j] * b[k] - a[k] * b[j]
        })
    };
    let across = cross(one, other);
    let weight = |area: Triple| (dot(area, across) / dot(across, across)).clamp(0.0, 1.0);
    let b = weight(cross(at, other));
    let c = weight(cross(one, at)).min(1.0 - b);
    let sum = plus(
        plus(normals[0].map(|it| it * (1.0 - b - c)), b, normals[1]),
        c,
        normals[2],
    );
    let normal = unit(sum);
    let normal = normal.map(|it| if dot(normal, flat) < 0.0 { -it } else { it });
    let mirrored = plus(view, -2.0 * dot(view, normal), normal);
    let height = dot(mirrored, flat);
    if height < 0.0 {
        unit(plus(unit(plus(mirrored, -height, flat)), -1.0, view))
    } else {
        normal
    }
}

#[test]
fn normals_are_those_of_double_precision_on_the_viewers_side() {
    let mut sweep = Sweep::new(21);
    let (mut bent, mut count) = (0, 0);
    for (shape, ray) in pairs(22, 60_000) {
        let Some(distance) = intersect(&shape, &ray) else {
            continue;
        };
        let climb = ray.direction.dot(shape.normal);
        if climb.to_bits().abs() < 1 << 26 {
            continue;
        }
        // Normals up to 60 degrees off the triangle's own, turned to any side.
        let near = |sweep: &mut Sweep| {
            let by = in_doubles(Vector::new(
                sweep.within(-3, 3),
                sweep.within(-3, 3),
                sweep.within(-3, 3),
            ));
            plus(unit(in_doubles(shape.normal.raw())), 0.25, by)
        };
        let normals = [near(&mut sweep), near(&mut sweep), near(&mut sweep)];
        let corners = corners_of(&shape).map(|it| [it.x, it.y, it.z]);
        let smooth = prepared(corners, Normals::new(Some(normals))).unwrap();
        let normals = normals.map(unit);
        let at = ray.origin.precisely_along(ray.direction, distance);
        let flat = shape.normal.reversed_if(climb > Unit::ZERO);
        let own = smooth.bent(at, flat, ray.direction).unwrap();
        let [own_d, flat_d, view] = [own, flat, ray.direction].map(|it| unit(in_doubles(it.raw())));
        let expected = truth(&shape, normals, shape.corner.to(at), flat_d, view);
        // A point is known to two steps, and a weight changes by them over the altitude.
        let altitude = f64::from(altitude_of(&shape));
        let slack = 16.0 / altitude + 1e-6;
        count += 1;
        let off = length(plus(own_d, -1.0, expected));
        if slack < 1e-3 && is_steady(normals) {
            assert!(off < 40.0 * slack, "{off} {slack}: {smooth:?} {ray:?}");
        }
        // It faces the viewer, and so does the mirrored ray.
        assert!(
            own.dot(flat) > Unit::ZERO && dot(own_d, view) < 1e-6,
            "{smooth:?} {ray:?}"
        );
        let mirrored = plus(view, -2.0 * dot(view, own_d), own_d);
        assert!(dot(mirrored, flat_d) > -1e-6, "{smooth:?} {ray:?}");
        bent += u32::from(dot(mirrored, flat_d) < 1e-6);
        assert!((length(in_doubles(own.raw())) / 2f64.powi(30) - 1.0).abs() < 1e-7);
    }
    assert!(count > 15_000 && bent > 100, "{count} {bent}");
}

/// Tests whether sums of the normals are long, so that their directions are known well.
fn is_steady(normals: [Triple; 3]) -> bool {
    let [a, b, c] = normals;
    dot(a, b) > -0.5 && dot(b, c) > -0.5 && dot(c, a) > -0.5
}

fn altitude_of(triangle: &PreparedTriangle) -> u32 {
    let face = Face::new(triangle.sides);
    face.altitude(longest(triangle.sides)) as u32
}

#[test]
fn normal_at_a_corner_is_that_of_the_corner() {
    let normals = [[0.0, 0.0, 1.0], [0.6, 0.0, 0.8], [0.0, -0.6, 0.8]];
    let corners = [[0; 3], [SIZE, 0, 0], [0, SIZE, 0]];
    let smooth = prepared(corners, Normals::new(Some(normals))).unwrap();
    let [up, down] = [direction([0, 0, 1]), direction([0, 0, -1])];
    for (corner, normal) in corners.into_iter().zip(normals) {
        let seen = smooth.bent(point(corner), up, down).unwrap();
        assert!(
            length(plus(unit(in_doubles(seen.raw())), -1.0, normal)) < 1e-6,
            "{seen:?}"
        );
        // From below, the normals are turned.
        let below = smooth.bent(point(corner), down, up).unwrap();
        assert!(
            length(plus(unit(in_doubles(below.raw())), 1.0, normal)) < 1e-6,
            "{below:?}"
        );
    }
    assert!(smooth.is_smooth() && !level().is_smooth());
    assert_eq!(level().bent(point([0; 3]), up, down), None);
}
