use super::*;
use crate::accel::{Scene, Static, StaticScene, World};
use crate::material::Material;
use crate::number::sweep::Sweep;
use crate::number::{Length, scaled_by_unit};
use crate::ray::{REACH, Ray};
use crate::scene::Room;
use crate::scene::access::SceneAccess;
use crate::scene::{Description, RuntimeScene, SceneBuilder};
use crate::shape::bounded::{Bounded, Range};
use crate::shape::{PreparedCylinder, PreparedSphere};
use crate::vector::{Direction, Vector};

type Scenery = RuntimeScene<Room<6, 1, 5, 1, 2>>;
pub(crate) type Built = Scene<Room<6, 1, 5, 1, 2>>;

/// Returns a scene of spheres and cylinders of all sizes, all of them mirrors. Every other scene has a
/// plane too, so that its ball is larger.
pub(crate) fn crowd(sweep: &mut Sweep, number: usize) -> Built {
    let mut scene = Scenery::new();
    let mirror = scene
        .add_material(Material::new([0.5; 3]).mirror(0.5))
        .unwrap();
    let mut coordinate = |limit: i32| f64::from(sweep.within(-limit, limit)) / 256.0;
    for _ in 0..6 {
        let center = [0; 3].map(|_| coordinate(2048));
        let radius = 2f64.powf(coordinate(1024) - 2.0);
        scene.add_sphere(center, radius, mirror).unwrap();
    }
    for _ in 0..5 {
        let center = [0; 3].map(|_| coordinate(2048));
        let axis = [0; 3].map(|_| coordinate(256) + 1e-3);
        let [radius, height] = [0; 2].map(|_| 2f64.powf(coordinate(1024) - 1.0));
        scene
            .add_cylinder(center, axis, radius, height, mirror)
            .unwrap();
    }
    if number % 2 == 1 {
        let floor = [0.0, 0.0, -9.0];
        scene.add_plane(floor, [0.0, 0.0, 1.0], mirror).unwrap();
    }
    scene.add_light([9, -20, 12], [1.0; 3]).unwrap();
    scene.build().unwrap()
}

/// Returns the mirror tables that the scene would have as a constant. Leaks their memory.
pub(crate) fn leaked(scene: &Built) -> MirrorTables {
    let parts = scene.parts();
    let tables = std::boxed::Box::new(MirrorTables::tables::<12>(&parts));
    MirrorTables {
        numbers: MirrorTables::numbered(&parts).0,
        tables: std::boxed::Box::leak(tables),
    }
}

fn any_direction(sweep: &mut Sweep) -> Direction {
    let [x, y, z] = sweep.triple(1 << 28);
    Vector::new(x, y, z).direction_and_length().0
}

/// Returns the point that lies `length` steps from another in a direction.
fn beside(from: Point, direction: Direction, length: i32) -> Point {
    let [x, y, z] = direction.components().map(|it| scaled_by_unit(length, it));
    Point::new(from.x + x, from.y + y, from.z + z)
}

/// Returns, for each sphere and cylinder, a random point from which a ray may leave it, and its table.
fn mirrors(scene: &Built, sweep: &mut Sweep) -> std::vec::Vec<(Point, MirrorTable)> {
    let parts = scene.parts();
    let epsilon = parts.inner_epsilon.to_bits();
    let mut mirrors = std::vec::Vec::new();
    // All eleven shapes are mirrors.
    let tables = MirrorTables::tables::<12>(&parts);
    for (sphere, ahead) in parts.spheres.iter().zip(tables) {
        let (center, radius) = sphere.ball();
        // The point lies inside or outside.
        let length = radius + sweep.within(-epsilon, epsilon);
        let from = beside(center, any_direction(sweep), length);
        mirrors.push((from, ahead));
    }
    for (cylinder, ahead) in parts.cylinders.iter().zip(tables.into_iter().skip(6)) {
        let (center, half, radius) = cylinder.capsule();
        let (axis, length) = half.direction_and_length();
        let up = beside(
            center,
            axis,
            sweep.within(-length.to_bits(), length.to_bits()),
        );
        let across = axis.perpendicular(any_direction(sweep)).unwrap();
        let from = beside(up, across, radius + sweep.within(-epsilon, epsilon));
        mirrors.push((from, ahead));
    }
    mirrors
}

/// Returns a random direction, mostly one that passes close to the rim of a shape.
fn direction_from(origin: Point, scene: &Built, sweep: &mut Sweep) -> Direction {
    let parts = scene.parts();
    let balls = parts.spheres.iter().map(PreparedSphere::ball);
    let mut balls = balls.chain(parts.cylinders.iter().map(PreparedCylinder::ball));
    let Some((center, radius)) = balls.nth(sweep.within(0, 12) as usize) else {
        return any_direction(sweep);
    };
    let (towards, _) = origin.to(center).direction_and_length();
    let Some(across) = towards.perpendicular(any_direction(sweep)) else {
        return towards;
    };
    let beyond = sweep.within(-64, 16);
    let rim = beside(center, across, radius + (radius >> 8) * beyond / 16);
    let (direction, _) = origin.to(rim).direction_and_length();
    match sweep.within(0, 3) {
        0 => direction.reversed(),
        _ => direction,
    }
}

/// Tests whether a set holds a shape. The scene must have fewer shapes than the set has bits.
fn has(set: &ShapeSet, shape: usize) -> bool {
    set.with(ShapeSet::of(shape)) == *set
}

#[test]
fn what_is_not_ahead_is_not_hit() {
    let mut sweep = Sweep::new(1);
    let (mut asked, mut left_out, mut met) = (0, 0, 0);
    for number in 0..600 {
        let scene = crowd(&mut sweep, number);
        let parts = scene.parts();
        for (origin, ahead) in mirrors(&scene, &mut sweep) {
            for _ in 0..200 {
                let direction = direction_from(origin, &scene, &mut sweep);
                let ray = Ray { origin, direction };
                let set = ahead.at(direction);
                let is_ahead: [_; 11] = core::array::from_fn(|shape| has(set, shape));
                for (sphere, is_ahead) in parts.spheres.iter().zip(&is_ahead) {
                    let hit = sphere.intersect_alone(&ray, REACH);
                    met += u32::from(hit.is_some());
                    assert!(*is_ahead || hit.is_none(), "{sphere:?} {ray:?}");
                }
                for (cylinder, is_ahead) in parts.cylinders.iter().zip(&is_ahead[6..]) {
                    let range = Range {
                        start: Length::from_bits(0),
                        reach: REACH,
                    };
                    let hit = Bounded::intersect(cylinder, &ray, range);
                    met += u32::from(hit.is_some());
                    assert!(*is_ahead || hit.is_none(), "{cylinder:?} {ray:?}");
                }
                asked += is_ahead.iter().filter(|it| **it).count();
                left_out += is_ahead.iter().filter(|it| !**it).count();
            }
        }
    }
    assert!(met > 1_000_000, "{met}");
    assert!(left_out > asked / 2, "{left_out} left out, {asked} asked");
}

#[test]
fn only_what_mirrors_has_a_table() {
    let mut scene = Scenery::new();
    let chalk = scene.add_material(Material::new([0.5; 3])).unwrap();
    let mirror = Material::new([0.5; 3]).mirror(0.5);
    let mirror = scene.add_material(mirror).unwrap();
    for (x, material) in [(-6.0, chalk), (-2.0, mirror), (2.0, chalk), (6.0, chalk)] {
        scene.add_sphere([x, 0.0, 0.0], 0.5, material).unwrap();
    }
    let scene = scene.build().unwrap();
    let (numbers, room) = MirrorTables::numbered(&scene.parts());
    assert_eq!(&numbers[..4], [u8::MAX, 0, u8::MAX, u8::MAX]);
    assert_eq!(room, 1);
    let [ahead] = MirrorTables::tables(&scene.parts());
    // No other shape lies above the mirror. Its table always holds the mirror itself.
    let up = Direction::from_raw(Vector::new(0, 0, 1 << 30));
    let shapes = |direction| core::array::from_fn(|shape| has(ahead.at(direction), shape));
    assert_eq!(shapes(up), [false, true, false, false]);
    assert_eq!(shapes(Direction::X), [false, true, true, true]);
}

const MIRROR: Material = Material::new([0.5; 3]).mirror(0.5);

/// A constant scene of `N` mirroring spheres in a row.
struct Row<const N: usize>;
impl<const N: usize> StaticScene for Row<N> {
    type Room = Room<N, 0, 0, 0>;
    const SCENE: &'static Scene<Self::Room> = &{
        let (mut scene, mut index) = (SceneBuilder::new(), 0);
        while index < N {
            scene = scene.sphere([4.0 * index as f64, 0.0, 0.0], 1.0, MIRROR);
            index += 1;
        }
        scene.build()
    };
    const INSTANCE: &'static Self = &Self;

    fn with_description<R>(_: impl FnOnce(Description<'_>) -> R) -> R {
        unreachable!("nothing reads how it was described")
    }
}

crate::scene! {
/// A constant scene in which only the floor mirrors.
    struct Floor {
        sphere([0.0, 0.0, 0.0], 1.0, Material::new([0.5; 3]));
        sphere([4.0, 0.0, 0.0], 1.0, Material::new([0.5; 3]));
        sphere([8.0, 0.0, 0.0], 1.0, Material::new([0.5; 3]));
        sphere([12.0, 0.0, 0.0], 1.0, Material::new([0.5; 3]));
        plane([0.0, 0.0, -1.0], [0.0, 0.0, 1.0], MIRROR);
    }
}

#[test]
fn only_constant_scenes_with_round_mirrors_and_some_shapes_have_tables() {
    let have_tables = [
        <Static<Row<3>> as SceneAccess>::CHOOSES_HITS,
        <Static<Row<4>> as SceneAccess>::CHOOSES_HITS,
        <Static<Row<16>> as SceneAccess>::CHOOSES_HITS,
        <Static<Row<17>> as SceneAccess>::CHOOSES_HITS,
        <Static<Floor> as SceneAccess>::CHOOSES_HITS,
        <Scene<Room<4, 1, 0, 0>> as SceneAccess>::CHOOSES_HITS,
    ];
    assert_eq!(have_tables, [false, true, true, false, false, false]);
    fn tables<const N: usize>() -> usize {
        Static::<Row<N>>::new().tables().mirror_tables.tables.len()
    }
    assert_eq!([tables::<4>(), tables::<5>(), tables::<16>()], [4, 6, 16]);
}
