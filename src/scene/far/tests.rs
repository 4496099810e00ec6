use super::*;
use crate::material::Material;
use crate::number::sweep::Sweep;
use crate::ray::NEAR;
use crate::scene::access::ShapeId;
use crate::scene::nearest::{Hit, NOWHERE, any_blocks, nearest_of};
use crate::scene::query::{located, nearest_hit};
use crate::scene::shape_set::ShapeSet;
use crate::scene::{PlainScene, Room, RuntimeScene, planes, query};
use crate::vector::{Point, Position, Vector};

type Built = PlainScene<Room<1, 2, 2, 0, 1>>;

/// Radius in steps of the ball that the shapes need. The planes make the scene's ball larger.
const SHAPES: i32 = BALL / 8;

/// Returns a scene with a sphere of half the shapes' radius in the middle, small tubes above and below
/// it, and a floor and a wall far away.
fn scene() -> Built {
    let mut scene = RuntimeScene::<Room<1, 2, 2, 0, 1>>::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.add_sphere([0, 0, 0], 0.5, white).unwrap();
    let axis = [0, 1, 0];
    for z in [-0.6, 0.6] {
        scene
            .add_cylinder([0.0, 0.0, z], axis, 0.1, 0.2, white)
            .unwrap();
    }
    scene.add_plane([0.0, 0.0, -0.7], [0, 0, 1], white).unwrap();
    scene.add_plane([0.0, 9e6, 0.0], [0, 1, 0], white).unwrap();
    let scene = scene.plain().unwrap();
    assert_eq!(scene.grid.fraction_bits(), 25);
    assert_eq!(scene.grid.middle(), Position::ORIGIN);
    scene
}

/// Returns the first hit of a ray, by the near kernels where they can tell.
fn first(scene: &Built, path: &ScaledRay) -> Option<(ScaledPoint, ShapeId)> {
    let skip = ShapeId::NONE;
    let hit = if path.from().is_near() {
        let ray = (&path.ray, NOWHERE);
        let bounded = nearest_of(scene, ray, skip);
        planes::nearest(scene, &path.ray, skip, bounded)
    } else {
        Hit::BEYOND
    };
    located::<_, false>(scene, path, skip, hit)
}

/// Returns the first hit of a ray, by the plain query.
fn far_first(scene: &Built, path: &ScaledRay) -> Option<(ScaledPoint, ShapeId)> {
    nearest_hit(scene, path, ShapeId::NONE)
}

/// Returns a ray from a point, aimed at a random point among the shapes.
fn aimed(sweep: &mut Sweep, from: ScaledPoint) -> ScaledRay {
    let [x, y, z] = sweep.triple(SHAPES);
    let target = ScaledPoint::new(Point::new(x, y, z), 0);
    let (direction, _) = from.to(target).0.direction_and_length();
    ScaledRay::new(from, direction)
}

/// Returns a random point up to 2^`octaves` times further out than the near region.
fn far_place(sweep: &mut Sweep, octaves: u32) -> ScaledPoint {
    let scale = sweep.within(1, octaves as i32);
    loop {
        let place = ScaledPoint::from_wide(sweep.triple(NEAR).map(|it| i64::from(it) << scale));
        if !place.is_near() {
            return place;
        }
    }
}

/// Converts a point to double precision, in steps.
fn wide(place: ScaledPoint) -> [f64; 3] {
    let Point { x, y, z } = place.point;
    [x, y, z].map(|it| f64::from(it) * 2f64.powi(place.scale as i32))
}

fn length(a: [f64; 3]) -> f64 {
    a.into_iter().map(|it| it * it).sum::<f64>().sqrt()
}

/// Returns the name of the kind of shape that was hit.
fn kind(scene: &Built, hit: Option<(ScaledPoint, ShapeId)>) -> &'static str {
    let parts = scene.parts();
    match hit.map(|(_, shape)| shape) {
        None => "nothing",
        Some(shape) if parts.is_plane(shape) => "plane",
        Some(shape) if shape.index() < parts.spheres.len() => "sphere",
        Some(_) => "cylinder",
    }
}

#[test]
fn path_from_outside_the_ball_meets_what_a_near_ray_meets() {
    let (scene, mut sweep) = (scene(), Sweep::new(1));
    let (mut checked, mut other, mut kinds) = (0, 0, [0; 4]);
    while checked < 100_000 {
        // The same point in steps of one, and in steps of two as a far point.
        let [x, y, z] = sweep.triple(NEAR / 2);
        let coarse = ScaledPoint {
            point: Point::new(x, y, z),
            scale: 1,
        };
        let from = ScaledPoint::new(Point::new(2 * x, 2 * y, 2 * z), 0);
        if length(wide(from)) < 1.01 * f64::from(BALL) {
            continue;
        }
        checked += 1;
        let path = aimed(&mut sweep, from);
        let (near, far) = (
            first(&scene, &path),
            far_first(&scene, &ScaledRay::new(coarse, path.direction())),
        );
        kinds[["nothing", "sphere", "plane", "cylinder"]
            .iter()
            .position(|it| *it == kind(&scene, near))
            .unwrap()] += 1;
        // At a rim, rounding decides which shape is hit.
        if near.map(|(_, shape)| shape) != far.map(|(_, shape)| shape) {
            other += 1;
            continue;
        }
        let (Some(near), Some(far)) = (near, far) else {
            continue;
        };
        // A near ray knows its height over a plane to one step.
        let plane = scene.parts().plane(near.1);
        let climb = plane.map(|it| path.direction().dot(it.normal).to_num::<f64>());
        let along = climb.map_or(0.0, |climb| 1.0 / climb.abs());
        let [near, far] = [near.0, far.0].map(wide);
        let apart = length([0, 1, 2].map(|axis| near[axis] - far[axis]));
        // Near a rim a step aside is √(2 r) along; far away a plane is known to 2^-26.
        let bound = 8.0 + 2.0 * f64::from(SHAPES).sqrt() + length(near) * 2f64.powi(-26) + along;
        assert!(apart <= bound, "{apart}: {path:?}");
    }
    assert!(other <= 4, "{other} of {checked} paths met something else");
    assert!(kinds[1..].iter().all(|count| *count > 1000), "{kinds:?}");
}

#[test]
fn hit_of_a_far_path_lies_on_path_and_shape() {
    let (scene, mut sweep) = (scene(), Sweep::new(2));
    let (mut hits, radius) = (0, f64::from(SHAPES) / 2.0);
    for _ in 0..100_000 {
        let from = far_place(&mut sweep, 20);
        let path = aimed(&mut sweep, from);
        let hit = far_first(&scene, &path);
        if kind(&scene, hit) != "sphere" {
            continue;
        }
        hits += 1;
        let (start, at) = (wide(path.from()), wide(hit.unwrap().0));
        let off = length(at) - radius;
        assert!(off.abs() <= 8.0, "{off} steps off the sphere: {path:?}");
        let d = path.direction().components().map(|it| it.to_num::<f64>());
        let d = d.map(|it| it / length(d));
        let way = [0, 1, 2].map(|axis| at[axis] - start[axis]);
        let along: f64 = (0..3).map(|axis| way[axis] * d[axis]).sum();
        let aside = length([0, 1, 2].map(|axis| way[axis] - along * d[axis]));
        assert!(aside <= 6.0, "{aside} steps off the path: {path:?}");
        assert!(along < length(start), "on the far side: {path:?}");
    }
    assert!(hits > 10_000, "{hits}");
}

#[test]
fn near_part_is_the_whole_of_a_ray_up_to_its_reach() {
    let mut sweep = Sweep::new(3);
    for scale in 0..=40 {
        let ends = [0, 1, (1 << 30) >> scale.min(30), i32::MAX];
        let [x, y, z] = sweep.triple(NEAR);
        for reach in ends.into_iter().chain([x, y, z].map(i32::abs)) {
            let whole = u64::from(reach.unsigned_abs()) << scale.min(FURTHEST_SCALE);
            let expected = whole.min(u64::from(REACH.to_bits().unsigned_abs()));
            let part = near_part(Length::from_bits(reach), scale);
            assert_eq!(
                part.to_bits().unsigned_abs(),
                expected as u32,
                "{reach} {scale}"
            );
        }
    }
}

#[test]
fn path_to_a_near_light_is_blocked_alike_near_and_far() {
    let (scene, mut sweep) = (scene(), Sweep::new(3));
    let mut counts = [0; 2];
    for round in 0..100_000 {
        let from = sweep.triple(NEAR);
        let light = sweep.triple(if round % 2 == 0 { NEAR } else { NEAR / 8 });
        let [from, light] = [from, light].map(|[x, y, z]| ScaledPoint::new(Point::new(x, y, z), 0));
        if from.point.to_vector().square() <= u64::from(unsigned(BALL + 8)).pow(2) {
            continue; // A path from inside of the ball is never moved to where it enters it.
        }
        let (direction, distance) = from.to(light).0.direction_and_length();
        let path = ScaledRay::new(from, direction);
        let near = query::occluded(
            &scene,
            ShapeSet::ALL,
            &path,
            ShapeId::NONE,
            (light, distance, 0),
        );
        counts[usize::from(near)] += 1;
        let epsilon = scene.parts().epsilon;
        let reach = Length::from_bits((distance.to_bits() - epsilon.to_bits()).max(0));
        let mut others = planes::others(&scene, ShapeId::NONE);
        let far = others.any(|(_, plane)| plane.blocks(&path, reach, 0))
            || between(&path, (light, reach, 0), epsilon).is_some_and(|(ray, reach)| {
                any_blocks(&scene, ShapeSet::ALL, &ray, ShapeId::NONE, reach)
            });
        assert_eq!(near, far, "{path:?} {light:?}");
    }
    assert!(counts.into_iter().all(|count| count > 10_000), "{counts:?}");
}

#[test]
fn far_light_is_blocked_by_what_a_near_light_in_the_same_direction_is() {
    let (scene, mut sweep) = (scene(), Sweep::new(4));
    let mut counts = [0; 2];
    for _ in 0..50_000 {
        let light = far_place(&mut sweep, 20);
        if light.scale < 3 {
            continue; // It may be nearer than what is taken for past the ball below.
        }
        let [x, y, z] = sweep.triple(SHAPES);
        let from = ScaledPoint::new(Point::new(x, y, z), 0);
        let (way, scale) = from.to(light);
        let (direction, distance) = way.direction_and_length();
        let path = ScaledRay::new(from, direction);
        let far = query::occluded(
            &scene,
            ShapeSet::ALL,
            &path,
            ShapeId::NONE,
            (light, distance, scale),
        );
        counts[usize::from(far)] += 1;
        // Three radii of the ball reach past everything but the planes.
        let past_the_ball = Length::from_bits(3 << 28);
        let near = query::occluded(
            &scene,
            ShapeSet::ALL,
            &path,
            ShapeId::NONE,
            (light, past_the_ball, 0),
        );
        let further = far_plane(&scene, &path, light);
        assert_eq!(far, near || further, "{path:?} {light:?}");
    }
    assert!(counts.into_iter().all(|count| count > 5_000), "{counts:?}");
}

/// Tests whether a plane lies between a ray's start and its light, in double precision.
fn far_plane(scene: &Built, path: &ScaledRay, light: ScaledPoint) -> bool {
    let unit = 2f64.powi(-scene.grid.fraction_bits());
    let [_, y, z] = wide(path.from());
    let [_, light_y, light_z] = wide(light);
    let crosses = |a: f64, b: f64, at: f64| (a * unit < at) != (b * unit < at);
    crosses(z, light_z, -0.7) || crosses(y, light_y, 9e6)
}

#[test]
fn near_light_is_seen_from_far_away_unless_something_hides_it() {
    let scene = scene();
    // From far to the right: the light is left of the sphere, right of it, or above it.
    for (light, hidden) in [
        (Point::new(-SHAPES, 0, 0), true),
        (Point::new(SHAPES, 0, 0), false),
        (Point::new(0, 0, SHAPES), false),
        (Point::new(0, 0, -SHAPES), true), // behind the floor
        (Point::new(0, 0, -NEAR), true),
    ] {
        for scale in [1, 3, 10, 20] {
            let light = ScaledPoint::new(light, 0);
            let from = ScaledPoint::new(Point::new(NEAR, 0, 1 << 20), scale);
            let (way, scale) = from.to(light);
            let (direction, distance) = way.direction_and_length();
            let path = ScaledRay::new(from, direction);
            let found = query::occluded(
                &scene,
                ShapeSet::ALL,
                &path,
                ShapeId::NONE,
                (light, distance, scale),
            );
            assert_eq!(found, hidden, "{light:?} at scale {scale}");
        }
    }
}

#[test]
fn wall_far_away_is_met_where_it_stands() {
    let scene = scene();
    for (x, z) in [(0, 1 << 28), (-5, 3 << 26)] {
        let from = ScaledPoint::new(Point::new(x, 0, z), 0);
        let north = Vector::new(0, 1, 0).precise_direction();
        let path = ScaledRay::new(from, north);
        let (at, _) = first(&scene, &path).unwrap();
        let [_, y, _] = wide(at).map(|it| it * 2f64.powi(-scene.grid.fraction_bits()));
        assert!((y / 9e6 - 1.0).abs() < 2f64.powi(-26), "{y}");
    }
}

#[test]
fn path_from_the_end_of_the_world_meets_nothing_but_planes() {
    let scene = scene();
    let from = ScaledPoint::new(Point::new(0, NEAR, NEAR), FURTHEST_SCALE + 1);
    let (direction, _) = from.to(ScaledPoint::ORIGIN).0.direction_and_length();
    let path = ScaledRay::new(from, direction);
    assert_eq!([first(&scene, &path), far_first(&scene, &path)], [None; 2]);
    assert!(into_ball(&path).is_none());
}
