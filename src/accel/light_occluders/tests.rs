use super::*;
use crate::material::Material;
use crate::scene::Room;
use crate::scene::RuntimeScene;
use crate::shape::MaterialId;

type Scenery = RuntimeScene<Room<1, 0, 1, 1, 1>>;

/// Returns a scene with a sphere of radius 1 at the origin, and what `fill` adds.
fn marble<T>(fill: impl FnOnce(&mut Scenery, MaterialId) -> T) -> Scenery {
    let mut scene = Scenery::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.add_sphere([0, 0, 0], 1, white).unwrap();
    fill(&mut scene, white);
    scene
}

fn is_light_plain(scene: &Scenery) -> bool {
    let scene = scene.build().unwrap();
    scene.tables().light_occluders[0].light().is_plain
}

#[test]
fn light_is_plain_where_it_is_near_and_outside_of_all_spheres() {
    for (x, is_plain) in [
        (0.0, false),
        (0.99, false),
        (1.01, true),
        (31.9, true),
        (32.1, false),
    ] {
        let scene = marble(|scene, _| scene.add_light([x, 0.0, 0.0], [1, 1, 1]).unwrap());
        assert_eq!(is_light_plain(&scene), is_plain, "{x}");
    }
    let in_a_cylinder = marble(|scene, white| {
        let (center, axis) = ([3, 0, 0], [1, 0, 0]);
        scene.add_cylinder(center, axis, 1, 2, white).unwrap();
        scene.add_light(center, [1, 1, 1]).unwrap();
    });
    assert!(is_light_plain(&in_a_cylinder));
}
