use super::*;
use crate::accel::Scene;
use crate::material::Material;
use crate::number::sweep::Sweep;
use crate::ray::{BALL, NEAR, ScaledRay};
use crate::scene::Room;
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::query::occluded;
use crate::scene::{Needs, RuntimeScene};
use crate::vector::Point;

type Built = Scene<Room<2, 2, 2, 1, 1>>;

/// Returns a scene with a sphere in the middle, a small sphere beside it, tubes above and below it, a
/// floor and a wall.
fn scene() -> Built {
    let mut scene = RuntimeScene::<Room<2, 2, 2, 1, 1>>::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.add_sphere([0, 0, 0], 0.5, white).unwrap();
    scene.add_sphere([0.8, 0.0, 0.0], 0.1, white).unwrap();
    for z in [-0.6, 0.6] {
        let axis = [0, 1, 0];
        scene
            .add_cylinder([0.0, 0.0, z], axis, 0.1, 0.2, white)
            .unwrap();
    }
    scene.add_plane([0.0, 0.0, -0.7], [0, 0, 1], white).unwrap();
    scene.add_plane([0.0, 0.9, 0.0], [0, 1, 0], white).unwrap();
    scene.build().unwrap()
}

fn needs<W: SceneAccess>(_: &W) -> Needs {
    W::NEEDS
}

#[test]
fn plain_shadow_rays_are_blocked_alike_with_a_table_and_without() {
    let (scene, mut sweep) = (scene(), Sweep::new(3));
    let scene = scene.tabled();
    assert!(needs(&scene).sets);
    let parts = scene.parts();
    let (mut counts, mut left_out) = ([0; 2], 0);
    for round in 0..30_000 {
        // Every second start and every third light lie anywhere near, all others close to the shapes.
        let limit = |is_wide: bool| if is_wide { NEAR } else { BALL / 8 };
        let [from, light] = [round % 2 == 0, round % 3 == 0].map(|is_wide| {
            let [x, y, z] = sweep.triple(limit(is_wide));
            ScaledPoint::new(Point::new(x, y, z), 0)
        });
        let (direction, distance) = from.to(light).0.direction_and_length();
        let ray = ScaledRay::new(from, direction);
        let table = LightTable::around(light, &parts);
        let set = table.at(direction.reversed());
        let skip = match round % 5 {
            index @ 0..4 => ShapeId::at(index),
            _ => ShapeId::NONE,
        };
        let to_light = (light, distance, 0);
        let some = occluded(&scene, set, &ray, skip, to_light);
        let all = occluded(&scene, ShapeSet::ALL, &ray, skip, to_light);
        assert_eq!(some, all, "{ray:?} {light:?}");
        counts[usize::from(all)] += 1;
        let layout = SetLayout::new(parts.lengths());
        left_out += (0..4)
            .filter(|shape| !set.meets(layout.set_of(*shape)))
            .count();
    }
    assert!(counts.into_iter().all(|count| count > 3000), "{counts:?}");
    assert!(left_out > 30_000, "{left_out}");
}
