//! Tests of `reference::model::shape`.

use crate::host::reference::model::{Cylinder, Disc, Plane, Ray, Shape, Sphere, Vector};
use crate::number::sweep::Sweep;

const BALL: Sphere = Sphere {
    center: Vector::ZERO,
    radius: 2.0,
    material: 0,
};

const FLOOR: Plane = Plane {
    point: Vector([7.0, -3.0, 1.0]),
    normal: Vector([0.0, 0.0, 1.0]),
    material: 0,
};

const TUBE: Cylinder = Cylinder {
    center: Vector::ZERO,
    axis: Vector([0.0, 0.0, 1.0]),
    radius: 2.0,
    half_height: 3.0,
    material: 0,
};

const LID: Disc = Disc {
    center: Vector([0.0, 0.0, 1.0]),
    normal: Vector([0.0, 0.0, 1.0]),
    radius: 2.0,
    material: 0,
};

fn ray(origin: [f64; 3], direction: [f64; 3]) -> Ray {
    Ray {
        origin: Vector(origin),
        direction: Vector(direction).unit(),
    }
}

fn meet(shape: &impl Shape, origin: [f64; 3], direction: [f64; 3]) -> Option<f64> {
    shape.meet(&ray(origin, direction), f64::INFINITY)
}

#[test]
fn sphere_in_front_is_met_on_its_near_side() {
    assert_eq!(meet(&BALL, [0.0, -5.0, 0.0], [0.0, 1.0, 0.0]), Some(3.0));
}

#[test]
fn sphere_behind_is_not_met() {
    assert_eq!(meet(&BALL, [0.0, 5.0, 0.0], [0.0, 1.0, 0.0]), None);
}

#[test]
fn sphere_is_met_from_inside() {
    assert_eq!(meet(&BALL, [0.0, 0.5, 0.0], [0.0, 1.0, 0.0]), Some(1.5));
}

#[test]
fn sphere_is_met_up_to_its_tangent() {
    let at = |aside| meet(&BALL, [aside, -5.0, 0.0], [0.0, 1.0, 0.0]);
    assert_eq!(at(2.0), Some(5.0));
    assert!((at(2.0 - 1e-12).unwrap() - 5.0).abs() < 1e-5);
    assert_eq!(at(2.0 + 1e-12), None);
}

#[test]
fn ray_leaving_a_sphere_misses_it() {
    for slope in [0.0, 1e-3, 0.1, 1.0, 1e3] {
        assert_eq!(meet(&BALL, [0.0, 0.0, 2.0 + 1e-3], [1.0, 0.0, slope]), None);
    }
}

#[test]
fn sphere_far_away_keeps_its_digits() {
    let near = meet(&BALL, [1.2, -1e8, 0.0], [0.0, 1.0, 0.0]).unwrap();
    assert!((near - (1e8 - 1.6)).abs() < 2e-8, "{near}");
}

#[test]
fn plane_is_met_from_both_sides() {
    assert_eq!(meet(&FLOOR, [0.0, 0.0, 4.0], [0.0, 0.0, -1.0]), Some(3.0));
    assert_eq!(meet(&FLOOR, [0.0, 0.0, -4.0], [0.0, 0.0, 1.0]), Some(5.0));
}

#[test]
fn plane_behind_or_alongside_is_not_met() {
    assert_eq!(meet(&FLOOR, [0.0, 0.0, 4.0], [0.0, 0.0, 1.0]), None);
    assert_eq!(meet(&FLOOR, [0.0, 0.0, 4.0], [0.0, 1.0, 0.0]), None);
    assert_eq!(meet(&FLOOR, [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]), None);
}

#[test]
fn plane_is_not_met_where_the_ray_starts() {
    assert_eq!(meet(&FLOOR, [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]), None);
    assert_eq!(meet(&FLOOR, [0.0, 0.0, 1.0], [0.0, 0.0, -1.0]), None);
}

#[test]
fn plane_is_met_at_a_slant() {
    let distance = meet(&FLOOR, [0.0, 0.0, 4.0], [4.0, 0.0, -3.0]).unwrap();
    assert!((distance - 5.0).abs() < 1e-14, "{distance}");
}

#[test]
fn cylinder_in_front_is_met_on_its_near_side() {
    assert_eq!(meet(&TUBE, [0.0, -5.0, 1.0], [0.0, 1.0, 0.0]), Some(3.0));
}

#[test]
fn cylinder_behind_is_not_met() {
    assert_eq!(meet(&TUBE, [0.0, 5.0, 1.0], [0.0, 1.0, 0.0]), None);
}

#[test]
fn cylinder_is_met_from_inside() {
    assert_eq!(meet(&TUBE, [0.0, 0.5, 1.0], [0.0, 1.0, 0.0]), Some(1.5));
}

#[test]
fn cylinder_is_met_up_to_its_tangent() {
    let at = |aside| meet(&TUBE, [aside, -5.0, 1.0], [0.0, 1.0, 0.0]);
    assert_eq!(at(2.0), Some(5.0));
    assert_eq!(at(2.0 + 1e-12), None);
}

#[test]
fn cylinder_ends_at_half_its_height_and_the_rim_belongs_to_it() {
    let at = |height| meet(&TUBE, [0.0, -5.0, height], [0.0, 1.0, 0.0]);
    for end in [-3.0, 3.0] {
        assert_eq!(at(end), Some(3.0));
        assert_eq!(at(end * (1.0 + 1e-12)), None);
    }
}

#[test]
fn ray_over_the_rim_meets_the_far_wall_inside() {
    // The ray is 3.5 high at y = -2, above the rim, and 1.5 high at y = 2.
    let distance = meet(&TUBE, [0.0, -4.0, 4.5], [0.0, 2.0, -1.0]).unwrap();
    assert!((distance - 45.0_f64.sqrt()).abs() < 1e-14, "{distance}");
}

#[test]
fn ray_along_the_axis_passes_through_the_open_ends() {
    for origin in [
        [0.0, 0.0, -9.0],
        [1.0, 1.0, -9.0],
        [2.0, 0.0, -9.0],
        [3.0, 0.0, 0.0],
    ] {
        assert_eq!(meet(&TUBE, origin, [0.0, 0.0, 1.0]), None, "{origin:?}");
    }
}

#[test]
fn ray_leaving_a_cylinder_misses_it() {
    for slope in [0.0, 1e-3, 0.1, 1.0, 1e3] {
        assert_eq!(meet(&TUBE, [0.0, 2.0 + 1e-3, 0.0], [1.0, slope, 0.1]), None);
    }
}

#[test]
fn disc_is_met_from_both_sides() {
    assert_eq!(meet(&LID, [1.0, 1.0, 4.0], [0.0, 0.0, -1.0]), Some(3.0));
    assert_eq!(meet(&LID, [1.0, 1.0, -4.0], [0.0, 0.0, 1.0]), Some(5.0));
    let distance = meet(&LID, [-3.0, 0.0, 5.0], [3.0, 0.0, -4.0]).unwrap();
    assert!((distance - 5.0).abs() < 1e-14, "{distance}");
}

#[test]
fn disc_behind_or_alongside_is_not_met() {
    assert_eq!(meet(&LID, [0.0, 0.0, 4.0], [0.0, 0.0, 1.0]), None);
    assert_eq!(meet(&LID, [0.0, -4.0, 4.0], [0.0, 1.0, 0.0]), None);
    assert_eq!(meet(&LID, [0.0, -4.0, 1.0], [0.0, 1.0, 0.0]), None);
    assert_eq!(meet(&LID, [0.0, 0.0, 1.0], [0.0, 0.0, 1.0]), None);
    assert_eq!(meet(&LID, [0.0, 0.0, 1.0], [0.0, 1.0, 0.0]), None);
}

#[test]
fn disc_ends_at_its_rim_which_belongs_to_it() {
    let at = |aside| meet(&LID, [0.0, aside, 4.0], [0.0, 0.0, -1.0]);
    for end in [-2.0, 2.0] {
        assert_eq!(at(end), Some(3.0));
        assert_eq!(at(end * (1.0 + 1e-12)), None);
    }
}

#[test]
fn tilted_cylinder_is_met_as_the_upright_one() {
    let tilted = Cylinder {
        axis: Vector([1.0, 1.0, 1.0]).unit(),
        ..TUBE
    };
    // The ray goes through the centre, perpendicular to the axis, and starts at distance 5.
    let side = Vector([1.0, -1.0, 0.0]).unit();
    let origin = side * 5.0;
    let distance = meet(&tilted, origin.0, (-side).0).unwrap();
    assert!((distance - 3.0).abs() < 1e-14, "{distance}");
}

#[test]
fn normals_point_outwards() {
    let up = Vector([0.0, 0.0, 1.0]);
    assert_eq!(BALL.normal(up * 2.0), up);
    assert_eq!(FLOOR.normal(Vector([3.0, 9.0, 1.0])), up);
    let wall = TUBE.normal(Vector([0.0, -2.0, 1.7]));
    assert_eq!(wall, Vector([0.0, -1.0, 0.0]));
    assert_eq!(LID.normal(Vector([1.0, 1.0, 1.0])), up);
}

#[test]
fn every_hit_of_a_sweep_lies_on_its_surface_and_nothing_lies_before_it() {
    let mut sweep = Sweep::new(7);
    let mut met = 0;
    for _ in 0..2000 {
        let mut vector = |scale: f64| Vector(sweep.place()) * scale;
        let (center, axis) = (vector(2.0), vector(1.0).unit());
        let ray = ray(vector(6.0).0, vector(1.0).0);
        let ball = Sphere { center, ..BALL };
        let floor = Plane {
            point: center,
            normal: axis,
            ..FLOOR
        };
        let tube = Cylinder {
            center,
            axis,
            ..TUBE
        };
        let lid = Disc {
            center,
            normal: axis,
            ..LID
        };
        // Functions that are zero on the surface and to first order the distance from it.
        let off_ball = |at: Vector| (at - center).length() - ball.radius;
        let off_floor = |at: Vector| axis.dot(at - center);
        let off_tube = |at: Vector| axis.cross(at - center).length() - tube.radius;
        let shapes: [&dyn Shape; 4] = [&ball, &floor, &tube, &lid];
        let offs: [&dyn Fn(Vector) -> f64; 4] = [&off_ball, &off_floor, &off_tube, &off_floor];
        for (kind, (shape, off)) in shapes.into_iter().zip(offs).enumerate() {
            let Some(distance) = shape.meet(&ray, f64::INFINITY) else {
                continue;
            };
            met += 1;
            assert!(distance > 0.0);
            let at = ray.at(distance);
            let from_here = off(at).abs();
            assert!(from_here < 1e-11 * (1.0 + distance), "{kind} {ray:?}");
            assert!((shape.normal(at).length() - 1.0).abs() < 1e-14);
            if kind == 2 {
                assert!(axis.dot(at - center).abs() <= tube.half_height + 1e-11);
            } else if kind == 3 {
                assert!((at - center).length() <= lid.radius + 1e-11);
            } else {
                // All points before the hit are on one side, because a sphere and a plane have no holes.
                let sides = (1..50).map(|step| off(ray.at(distance * f64::from(step) / 50.0)));
                let above = sides.filter(|side| *side > 0.0).count();
                assert!(above == 0 || above == 49, "{kind} {ray:?}");
            }
        }
    }
    assert!((1000..3000).contains(&met), "{met}");
}

#[test]
fn shape_at_the_reach_or_further_is_not_met() {
    let ray = ray([0.0, -5.0, 0.0], [0.0, 1.0, 0.0]);
    let wall = Plane {
        point: Vector([0.0, -2.0, 0.0]),
        normal: Vector([0.0, 1.0, 0.0]),
        material: 0,
    };
    let lid = Disc {
        center: Vector([0.0, -2.0, 0.0]),
        normal: Vector([0.0, 1.0, 0.0]),
        ..LID
    };
    let shapes: [&dyn Shape; 4] = [&BALL, &wall, &TUBE, &lid];
    for shape in shapes {
        assert_eq!(shape.meet(&ray, 3.0), None);
        assert_eq!(shape.meet(&ray, 3.5), Some(3.0));
    }
}
