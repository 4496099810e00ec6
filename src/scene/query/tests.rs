use super::*;
use crate::material::Material;
use crate::number::Number;
use crate::scene::{PlainScene, Room, RuntimeScene};
use crate::shape::bounded::Bounded;
use crate::shape::{MaterialId, PreparedCylinder, PreparedSphere};
use crate::vector::{Direction, Point, Position, Vector};

type Scenery = RuntimeScene<Room<4, 3, 2, 2, 1>>;
type Built = PlainScene<Room<4, 3, 2, 2, 1>>;

/// A step of these scenes, in scene units. One unit is the radius of the ball that the shapes need,
/// which is an eighth of the scene's ball because there are planes.
const STEP: f64 = 1.0 / (1 << 25) as f64;

/// Returns a scene with planes on a grid of 2⁻²⁵, filled by `fill`, with an epsilon of 1000 steps. Two
/// small spheres at its ends give it its size.
fn scenery(fill: impl FnOnce(&mut Scenery, MaterialId)) -> Built {
    let mut scene = Scenery::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.set_epsilon(1000.0 * STEP).unwrap();
    for y in [-0.75, 0.75] {
        scene.add_sphere([0.0, y, 0.0], 0.125, white).unwrap();
    }
    fill(&mut scene, white);
    let built = scene.plain().unwrap();
    assert_eq!(built.grid.fraction_bits(), 25);
    assert_eq!(built.grid.middle(), Position::ORIGIN);
    built
}

/// Returns a ray along the x axis, from a point on it.
fn along_x(scene: &Built, x: f64) -> ScaledRay {
    let from = scene
        .grid
        .place(Position([Number::new(x), Number::ZERO, Number::ZERO]));
    ScaledRay::new(from, Direction::X)
}

/// Returns the id of the plane with this index among the planes.
fn plane_number(scene: &Built, index: u32) -> ShapeId {
    ShapeId(scene.parts().first_plane() + index)
}

/// Returns where a ray along the x axis from `x` hits a shape, in scene units, and which. Skips `left`.
fn met_at(scene: &Built, x: f64, left: ShapeId) -> Option<(f64, ShapeId)> {
    let ray = along_x(scene, x);
    let (at, shape) = nearest_hit(scene, &ray, left)?;
    let x = f64::from(at.point.x) * 2f64.powi(at.scale as i32) * STEP;
    Some((x, shape))
}

/// Returns a scene with planes at ±x.
fn two_planes(x: f64) -> Built {
    scenery(|scene, white| {
        scene.add_plane([x, 0.0, 0.0], [1, 0, 0], white).unwrap();
        scene.add_plane([-x, 0.0, 0.0], [1, 0, 0], white).unwrap();
    })
}

#[test]
fn nearest_shape_is_met_whatever_its_kind() {
    let scene = scenery(|scene, white| {
        scene
            .add_sphere([0.46875, 0.0, 0.0], 0.09375, white)
            .unwrap();
        scene.add_sphere([-0.8125, 0.0, 0.0], 0.125, white).unwrap();
        scene
            .add_cylinder([0, 0, 0], [0, 0, 1], 0.25, 0.25, white)
            .unwrap();
        scene
            .add_cylinder([0.75, 0.0, 0.0], [0, 0, 1], 0.125, 0.125, white)
            .unwrap();
        scene.add_plane([-0.5, 0.0, 0.0], [2, 0, 0], white).unwrap();
        scene
            .add_plane([0.3125, 0.0, 0.0], [-1, 0, 0], white)
            .unwrap();
    });
    // Two spheres give the scene its size; these are numbers 2 and 3, the cylinders 4 and 5, and
    // the planes 6 and 7.
    let surfaces = [
        (-0.9375, 3),
        (-0.6875, 3),
        (-0.5, 6),
        (-0.25, 4),
        (0.25, 4),
        (0.3125, 7),
        (0.375, 2),
        (0.5625, 2),
        (0.625, 5),
        (0.875, 5),
    ];
    let mut before = -1.25;
    for (surface, number) in surfaces {
        let from = (before + surface) / 2.0;
        let (found, shape) = met_at(&scene, from, ShapeId::NONE).unwrap();
        assert!(
            (found - surface).abs() <= 4.0 * STEP,
            "from {from}: {found}, not {surface}"
        );
        assert_eq!(shape, ShapeId(number), "from {from}");
        before = surface;
    }
    assert_eq!(met_at(&scene, 1.125, ShapeId::NONE), None);
}

#[test]
fn plane_just_left_is_not_met() {
    let scene = two_planes(0.5);
    let [right, left] = [0, 1].map(|index| plane_number(&scene, index));
    for (just_left, truth, number) in [
        (ShapeId::NONE, -0.5, left),
        (right, -0.5, left),
        (left, 0.5, right),
    ] {
        let (found, shape) = met_at(&scene, -0.75, just_left).unwrap();
        assert!((found - truth).abs() <= 8.0 * STEP, "{found}, not {truth}");
        assert_eq!(shape, number);
    }
}

#[test]
fn numbers_name_spheres_then_cylinders_then_planes() {
    let scene = scenery(|scene, white| {
        scene.add_sphere([0, 0, 0], 0.5, white).unwrap();
        for (axis, radius) in [([0, 0, 1], 0.25), ([1, 0, 0], 0.125)] {
            scene
                .add_cylinder([0, 0, 0], axis, radius, 0.25, white)
                .unwrap();
        }
        scene.add_plane([0, 0, 0], [1, 0, 0], white).unwrap();
    });
    let parts = scene.parts();
    let balls = parts.spheres.iter().map(PreparedSphere::ball);
    let balls = balls.chain(parts.cylinders.iter().map(PreparedCylinder::ball));
    for (number, ball) in balls.enumerate() {
        assert_eq!(parts.ball(number).unwrap().0, ball, "{number}");
    }
    assert!(parts.ball(5).is_none());
    // Points on the shapes in the order of their numbers, with the normals there.
    let spheres = parts.spheres.iter().map(|sphere| {
        let (center, radius) = sphere.ball();
        let at = center.along(Direction::X, Length::from_bits(radius));
        (at, sphere.normal(at))
    });
    let cylinders = parts.cylinders.iter().map(|cylinder| {
        let (center, _, radius) = cylinder.capsule();
        let y = Vector::new(0, 1, 0).precise_direction();
        let at = center.along(y, Length::from_bits(radius));
        (at, cylinder.normal(at))
    });
    let planes = parts.planes.iter().map(|it| (Point::ORIGIN, it.normal));
    for (number, (at, normal)) in spheres.chain(cylinders).chain(planes).enumerate() {
        let number = ShapeId::at(number);
        let (found, _) = parts.outside(number, at).unwrap();
        assert_eq!(found, normal, "{number:?}");
        assert_eq!(parts.is_plane(number), number.0 == 5);
        assert_eq!(parts.plane(number).is_some(), number.0 == 5);
    }
    for none in [ShapeId(6), ShapeId::NONE, ShapeId::BEYOND] {
        assert!(parts.outside(none, Point::ORIGIN).is_none() && parts.plane(none).is_none());
    }
    assert!(!parts.is_plane(ShapeId::NONE));
}

#[test]
fn plane_beyond_the_reach_of_near_rays_is_met() {
    // Near rays are followed for four radii of the ball.
    for x in [40.0, 100.0, 1e6, 1e9] {
        let scene = scenery(|scene, white| {
            scene.add_plane([x, 0.0, 0.0], [1, 0, 0], white).unwrap();
            scene.add_sphere([0, 0, 0], 0.5, white).unwrap();
        });
        let (found, shape) = met_at(&scene, 1.25, ShapeId::NONE).unwrap();
        assert!(
            (found / x - 1.0).abs() <= 2f64.powi(-25),
            "{found}, not {x}"
        );
        assert_eq!(shape, plane_number(&scene, 0));
    }
}

/// Tests whether a plane at `x` blocks the ray along x from 0 to a light at 0.75.
fn is_blocked_by_a_plane_at(x: f64) -> bool {
    let scene = scenery(|scene, white| {
        scene.add_plane([x, 0.0, 0.0], [1, 0, 0], white).unwrap();
    });
    let path = along_x(&scene, 0.0);
    let light = scene.grid.place(Position::new([0.75, 0.0, 0.0]));
    let (way, scale) = path.from().to(light);
    occluded(
        &scene,
        ShapeSet::ALL,
        &path,
        ShapeId::NONE,
        (light, Length::from_bits(way.x), scale),
    )
}

#[test]
fn light_is_blocked_by_what_lies_more_than_epsilon_before_it() {
    // Epsilon is 1000 steps. The position of a plane is exact to the step.
    for (steps, is_blocked) in [(-2000, true), (-1001, true), (-1000, false), (-999, false)] {
        let x = 0.75 + f64::from(steps) * STEP;
        assert_eq!(
            is_blocked_by_a_plane_at(x),
            is_blocked,
            "{steps} steps from the light"
        );
    }
    for (x, is_blocked) in [(1.0, false), (0.0, false), (-STEP, false), (STEP, true)] {
        assert_eq!(is_blocked_by_a_plane_at(x), is_blocked, "{x}");
    }
}

#[test]
fn light_is_blocked_by_every_kind_of_shape_and_by_none_behind_it() {
    let scene = scenery(|scene, white| {
        scene.add_sphere([-0.8125, 0.0, 0.0], 0.125, white).unwrap();
        scene.add_plane([0.25, 0.0, 0.0], [1, 0, 0], white).unwrap();
        scene
            .add_cylinder([0.75, 0.0, 0.0], [0, 0, 1], 0.125, 0.125, white)
            .unwrap();
    });
    let is_blocked = |from: f64, to: f64| {
        let path = along_x(&scene, from);
        let light = scene.grid.place(Position::new([to, 0.0, 0.0]));
        let distance = Length::from_bits(path.from().to(light).0.x);
        occluded(
            &scene,
            ShapeSet::ALL,
            &path,
            ShapeId::NONE,
            (light, distance, 0),
        )
    };
    for (from, to, truth) in [
        (-0.99, -0.95, false), // before the sphere
        (-0.99, -0.5, true),   // through it
        (-0.75, -0.5, true),   // out of it
        (-0.5, 0.2, false),    // behind it, before the plane
        (-0.5, 0.3, true),     // through the plane
        (0.3, 0.6, false),     // behind the plane, before the cylinder
        (0.3, 0.7, true),      // into the cylinder
        (0.75, 0.9, true),     // out of it
        (0.9, 1.4, false),     // behind everything
    ] {
        assert_eq!(is_blocked(from, to), truth, "from {from} to {to}");
    }
}

#[test]
fn light_closer_than_epsilon_is_not_blocked() {
    let scene = two_planes(0.5);
    for steps in [0, 1, 999, 1000] {
        let path = along_x(&scene, 1.0);
        let light = ScaledPoint {
            point: path
                .from()
                .point
                .along(Direction::X, Length::from_bits(steps)),
            scale: 0,
        };
        let distance = Length::from_bits(steps);
        assert!(
            !occluded(
                &scene,
                ShapeSet::ALL,
                &path,
                ShapeId::NONE,
                (light, distance, 0)
            ),
            "{steps} steps"
        );
    }
}
