//! No ray passes between the triangles of a closed mesh.

use super::*;

/// Returns the 80 triangles of an icosahedron whose sides are halved, as corners on a sphere around a point.
fn icosphere(center: [i32; 3], radius: f64) -> Vec<[[i32; 3]; 3]> {
    let golden = f64::midpoint(1.0, 5f64.sqrt());
    let mut corners = Vec::new();
    for one in [-1.0, 1.0] {
        for other in [-golden, golden] {
            corners.extend([[0.0, one, other], [one, other, 0.0], [other, 0.0, one]]);
        }
    }
    let are_near = |a: Triple, b: Triple| (length(plus(a, -1.0, b)) - 2.0).abs() < 1e-9;
    let halfway = |a: Triple, b: Triple| unit(plus(a, 1.0, b));
    let place = |at: Triple| {
        let at = unit(at);
        [0, 1, 2].map(|axis| center[axis] + (radius * at[axis]).round() as i32)
    };
    let mut triangles = Vec::new();
    for a in 0..12 {
        for b in a + 1..12 {
            for c in b + 1..12 {
                let [p, q, r] = [a, b, c].map(|it| corners[it]);
                if are_near(p, q) && are_near(q, r) && are_near(r, p) {
                    let [s, t, u] = [halfway(p, q), halfway(q, r), halfway(r, p)];
                    let four = [[p, s, u], [s, q, t], [u, t, r], [s, t, u]];
                    triangles.extend(four.map(|it| it.map(place)));
                }
            }
        }
    }
    triangles
}

fn sphere(radius: f64) -> Vec<PreparedTriangle> {
    let corners = icosphere([1 << 20, -(1 << 21), 77], radius);
    assert_eq!(corners.len(), 80);
    corners
        .into_iter()
        .map(|it| triangle(it).unwrap())
        .collect()
}

fn met(mesh: &[PreparedTriangle], ray: &Ray) -> usize {
    let everywhere = || Range {
        start: Length::from_bits(0),
        reach: EVERYWHERE,
    };
    mesh.iter()
        .filter(|it| it.intersect(ray, everywhere()).is_some())
        .count()
}

/// Returns a random point on a side or in a corner of one of the triangles, rounded to a step.
fn on_a_side(sweep: &mut Sweep, mesh: &[PreparedTriangle]) -> [i32; 3] {
    let index = sweep.within(0, 79) as usize;
    let corners = corners_of(&mesh[index]);
    let (one, other) = (corners[0], corners[sweep.within(0, 2) as usize]);
    let share = f64::from(sweep.within(0, 1000)) / 1000.0;
    plus(in_doubles(one), share, in_doubles(other.minus(one))).map(|it| it.round() as i32)
}

#[test]
fn no_ray_from_inside_of_a_closed_mesh_gets_out() {
    follow_from_inside(17_000);
}

#[test]
#[ignore = "long: a million rays each from inside and from outside"]
fn none_of_a_million_rays_passes_a_closed_mesh() {
    follow_from_inside(340_000);
    follow_from_outside(340_000);
}

/// Follows rays from inside of meshes of three sizes, `count` of each.
fn follow_from_inside(count: u32) {
    let mut sweep = Sweep::new(11);
    for radius in [2000.0, 1e6, 2e8] {
        let mesh = sphere(radius);
        for number in 0..count {
            let by = sweep.triple((0.4 * radius) as i32);
            let origin = [0, 1, 2].map(|axis| [1 << 20, -(1 << 21), 77][axis] + by[axis]);
            let direction = match number % 2 {
                0 => any_direction(&mut sweep),
                _ => {
                    let target = on_a_side(&mut sweep, &mesh);
                    point(origin).to(point(target)).direction_and_length().0
                }
            };
            let ray = Ray {
                origin: point(origin),
                direction,
            };
            assert!(met(&mesh, &ray) > 0, "{radius} {ray:?}");
        }
    }
}

#[test]
fn no_ray_from_outside_of_a_closed_mesh_hits_it_once_only() {
    follow_from_outside(17_000);
}

/// Follows rays from outside, `count` at each mesh. A ray that goes into the mesh comes out again, so it hits two
/// triangles at least. One that is aimed at a side may touch the mesh in one point.
fn follow_from_outside(count: u32) {
    let mut sweep = Sweep::new(12);
    let mut hits = 0;
    for radius in [2000.0, 1e6, 2e8] {
        let mesh = sphere(radius);
        for number in 0..count {
            let origin = sweep.triple(3 << 27);
            let away = length(plus(
                [1048576.0, -2097152.0, 77.0],
                -1.0,
                origin.map(f64::from),
            ));
            if away < 1.01 * radius {
                continue;
            }
            let target = match number % 2 {
                0 => [0, 1, 2].map(|axis| {
                    [1 << 20, -(1 << 21), 77][axis] + sweep.triple(radius as i32)[axis]
                }),
                _ => on_a_side(&mut sweep, &mesh),
            };
            let direction = point(origin).to(point(target)).direction_and_length().0;
            let ray = Ray {
                origin: point(origin),
                direction,
            };
            let count = met(&mesh, &ray);
            assert!(count != 1, "{radius} {ray:?}");
            hits += u32::from(count > 1);
        }
    }
    println!("{hits} of {} rays hit the mesh", 3 * count);
    assert!(hits > count * 15 / 17, "{hits}");
}

/// Rays whose lines cut a common side, to the last bit.
#[test]
fn ray_at_a_common_side_hits_one_of_two_triangles() {
    let mut sweep = Sweep::new(13);
    let mut exact = 0;
    for _ in 0..30_000 {
        let [x, y, _] = sweep.triple(1 << 20);
        // Both triangles have the side from (0, 0, 0) to (2^20, 2^20, 0).
        let far = 1 << 20;
        let one = triangle([[0; 3], [far, far, 0], [far, -far, y]]).unwrap();
        let other = triangle([[far, far, 0], [0; 3], [-far, far, x]]).unwrap();
        let at = sweep.within(0, far);
        let by = sweep.within(-1, 1);
        let origin = [at, at + by, sweep.within(1 << 22, 1 << 23)];
        let ray = ray(origin, [0, 0, -1]);
        let hits = [one, other].map(|it| intersect(&it, &ray).is_some());
        assert!(hits[0] || hits[1], "{ray:?}");
        exact += u32::from(hits[0] && hits[1]);
    }
    assert!(exact > 9_000, "{exact}");
}
