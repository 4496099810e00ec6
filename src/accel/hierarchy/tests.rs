use super::*;
use crate::accel::Scene;
use crate::material::Material;
use crate::number::sweep::Sweep;
use crate::scene::access::SceneAccess;
use crate::scene::nearest::any_blocks;
use crate::scene::shape_set::ShapeSet;
use crate::scene::{Room, RuntimeScene};
use crate::vector::{Direction, Vector};

type Scenery = RuntimeScene<Room<40, 1, 16, 1, 2, 16>>;
type Built = Scene<Room<40, 1, 16, 1, 2, 16>>;

/// Returns a scene of 72 mirrors. Each disc closes a cylinder, and spheres of some scenes touch each other.
fn crowd(sweep: &mut Sweep, number: usize) -> Built {
    let mut scene = Scenery::new();
    let mirror = Material::new([0.5; 3]).mirror(0.5);
    let mirror = scene.add_material(mirror).unwrap();
    let mut coordinate = |limit: i32| f64::from(sweep.within(-limit, limit)) / 256.0;
    for index in 0..40 {
        let center = match number % 3 {
            0 => [f64::from(index % 7), f64::from(index / 7), 0.0],
            _ => [0; 3].map(|_| coordinate(2048)),
        };
        let radius = match number % 3 {
            0 => 0.5,
            _ => 2f64.powf(coordinate(1024) - 2.0),
        };
        scene.add_sphere(center, radius, mirror).unwrap();
    }
    for _ in 0..16 {
        let center = [0; 3].map(|_| coordinate(2048));
        let [radius, height] = [0; 2].map(|_| 2f64.powf(coordinate(768) - 1.0));
        let [x, y, z] = center;
        let up = [0.0, 0.0, 1.0];
        scene
            .add_cylinder(center, up, radius, height, mirror)
            .unwrap();
        scene
            .add_disc([x, y, z + height / 2.0], up, radius, mirror)
            .unwrap();
    }
    if number % 2 == 1 {
        scene
            .add_plane([0.0, 0.0, -9.0], [0.0, 0.0, 1.0], mirror)
            .unwrap();
    }
    scene.add_light([9, -20, 12], [1.0; 3]).unwrap();
    scene.build().unwrap()
}

fn any_direction(sweep: &mut Sweep) -> Direction {
    let [x, y, z] = sweep.triple(1 << 28);
    Vector::new(x, y, z).direction_and_length().0
}

/// Returns a random point in the ball of the shapes.
fn any_point(sweep: &mut Sweep) -> Point {
    let [x, y, z] = sweep.triple(1 << 27);
    Point::new(x, y, z)
}

/// Returns a ray, and the shape that it leaves. Half of the rays continue an earlier ray off the shape that
/// it hit. Of the others, every other one passes near the rim of a shape.
fn next_ray(
    scene: &Built,
    sweep: &mut Sweep,
    before: Option<(Ray, Hit)>,
) -> (Ray, ShapeId, ShapeId) {
    let parts = scene.parts();
    if let Some((ray, hit)) = before.filter(|(_, hit)| hit.shape != ShapeId::NONE) {
        let at = ray.origin.along(ray.direction, hit.distance);
        if let Some((outward, _)) = parts.outside(hit.shape, at) {
            let climb = ray.direction.dot(outward);
            let is_inside = climb.to_bits() > 0;
            let normal = outward.reversed_if(is_inside);
            let origin = crate::ray::ScaledPoint::new(at, 0)
                .lifted(normal, parts.inner_epsilon)
                .point;
            let direction = ray.direction.reflected(outward, climb).renormalised();
            let skip = if is_inside { ShapeId::NONE } else { hit.shape };
            return (Ray { origin, direction }, hit.shape, skip);
        }
    }
    let origin = any_point(sweep);
    let shape = sweep.within(0, 72 * 2) as usize;
    let direction = match parts.ball(shape) {
        Some(((center, radius), _)) => {
            let (towards, _) = origin.to(center).direction_and_length();
            let across = towards.perpendicular(any_direction(sweep));
            let rim = across.map_or(center, |across| {
                center.along(across, Length::from_bits(radius))
            });
            origin.to(rim).direction_and_length().0
        }
        None => any_direction(sweep),
    };
    (Ray { origin, direction }, ShapeId::NONE, ShapeId::NONE)
}

/// Follows rays in random scenes, and compares their hits with those of the plain path. Returns how many
/// hit a shape.
fn compare(scenes: usize, rays: usize) -> usize {
    let mut sweep = Sweep::new(19);
    let mut met = 0;
    for number in 0..scenes {
        let scene = crowd(&mut sweep, number);
        let mut memory = [HierarchyNode::NONE; 128];
        let tabled = scene.tabled().with_hierarchy(&mut memory);
        assert!(!tabled.tables().hierarchy.is_empty());
        let mut before = None;
        for _ in 0..rays {
            let (ray, mirror, skip) = next_ray(&scene, &mut sweep, before);
            let hit = nearest(&tabled, &ray, (mirror, skip));
            let plain = nearest_of(&scene, (&ray, NOWHERE), skip);
            assert_eq!(hit, plain, "{ray:?} off {mirror:?}");
            let reach = Length::from_bits(sweep.within(0, 1 << 29));
            let blocks = any_blocks(&scene, ShapeSet::ALL, &ray, skip, reach);
            assert_eq!(is_blocked(&tabled, &ray, skip, reach), blocks, "{ray:?}");
            met += usize::from(hit.shape != ShapeId::NONE);
            before = match sweep.within(0, 2) {
                0 => None,
                _ => Some((ray, hit)),
            };
        }
    }
    met
}

#[test]
fn hits_are_those_of_the_plain_path() {
    let met = compare(30, 1000);
    assert!(met > 10_000, "{met}");
}

/// Returns a scene of so many mirrors in a row.
fn row(count: i32) -> Built {
    let mut scene = Scenery::new();
    let mirror = Material::new([0.5; 3]).mirror(0.5);
    let mirror = scene.add_material(mirror).unwrap();
    for index in 0..count {
        scene.add_sphere([index, 0, 0], 0.5, mirror).unwrap();
    }
    scene.build().unwrap()
}

#[test]
fn thirteen_shapes_are_the_fewest_with_a_hierarchy() {
    let mut memory = [HierarchyNode::NONE; 16];
    let few = row(12);
    assert!(
        few.tabled()
            .with_hierarchy(&mut memory)
            .tables()
            .hierarchy
            .is_empty()
    );
    let scene = row(13);
    let tabled = scene.tabled().with_hierarchy(&mut memory);
    assert_eq!(tabled.tables().hierarchy.nodes.len(), 16);
    let (mut sweep, mut met) = (Sweep::new(23), 0);
    for _ in 0..4000 {
        let (ray, mirror, skip) = next_ray(&scene, &mut sweep, None);
        let hit = nearest(&tabled, &ray, (mirror, skip));
        assert_eq!(hit, nearest_of(&scene, (&ray, NOWHERE), skip), "{ray:?}");
        met += usize::from(hit.shape != ShapeId::NONE);
    }
    assert!(met > 100, "{met}");
}

#[test]
#[ignore = "a million rays"]
fn a_million_hits_are_those_of_the_plain_path() {
    let met = compare(200, 5000);
    assert!(met > 300_000, "{met}");
}

#[test]
fn kernels_find_each_hit_that_is_surely_in_range() {
    let mut sweep = Sweep::new(20);
    let mut hits = 0;
    for number in 0..20 {
        let scene = crowd(&mut sweep, number);
        let parts = scene.parts();
        for _ in 0..200 {
            let (ray, ..) = next_ray(&scene, &mut sweep, None);
            for shape in (0..72).map(ShapeId::at) {
                let within = |reach: i32| {
                    let reach = Length::from_bits(reach.min(REACH.to_bits()));
                    parts.intersect(
                        shape,
                        &ray,
                        Range {
                            start: NOWHERE,
                            reach,
                        },
                    )
                };
                let Some(distance) = within(i32::MAX) else {
                    continue;
                };
                hits += 1;
                assert_eq!(within(distance.to_bits() + SURE), Some(distance));
                let less = within(distance.to_bits() + sweep.within(1, SURE));
                assert!(less.is_none_or(|less| less == distance));
            }
        }
    }
    assert!(hits > 2000, "{hits}");
}

#[test]
fn balls_hold_those_below_them() {
    let mut sweep = Sweep::new(21);
    let scene = crowd(&mut sweep, 1);
    let mut memory = [HierarchyNode::NONE; 128];
    let tabled = scene.tabled().with_hierarchy(&mut memory);
    let nodes = tabled.tables().hierarchy.nodes;
    for (shape, sphere) in scene.parts().spheres.iter().enumerate() {
        let mut node = nodes.len() / 2 + usize::from(nodes[shape].leaf);
        assert!(
            nodes[node]
                .shapes
                .contains(&crate::number::to_u16(to_u32(shape)))
        );
        while node > 0 {
            let (center, radius) = sphere.ball();
            let (_, length) = center.to(nodes[node].center).direction_and_length();
            assert!(length.to_bits() + radius <= nodes[node].radius);
            node /= 2;
        }
    }
}

#[test]
fn too_little_memory_gives_no_hierarchy() {
    let scene = crowd(&mut Sweep::new(22), 1);
    let mut memory = [HierarchyNode::NONE; 127];
    let tabled = scene.tabled().with_hierarchy(&mut memory);
    assert!(tabled.tables().hierarchy.is_empty());
}

#[test]
fn lent_memory_may_hold_what_it_was_used_for_before() {
    let scene = crowd(&mut Sweep::new(22), 1);
    let used = HierarchyNode {
        leaf: 99,
        ..HierarchyNode::NONE
    };
    let (mut fresh, mut used) = ([HierarchyNode::NONE; 128], [used; 128]);
    let leaves = |memory: &mut [HierarchyNode]| {
        let tabled = scene.tabled().with_hierarchy(memory);
        let nodes = tabled.tables().hierarchy.nodes;
        nodes
            .iter()
            .map(|node| node.leaf)
            .collect::<std::vec::Vec<_>>()
    };
    assert_eq!(leaves(&mut used), leaves(&mut fresh));
}
