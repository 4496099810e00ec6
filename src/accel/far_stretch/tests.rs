use super::*;
use crate::accel::Scene;
use crate::material::Material;
use crate::number::sweep::Sweep;
use crate::ray::ScaledRay;
use crate::scene::access::{SceneAccess, ShapeId};
use crate::scene::query::occluded;
use crate::scene::shape_set::ShapeSet;
use crate::scene::{Room, RuntimeScene};
use crate::shape::rays::Rays;
use crate::vector::Position;

type Built = Scene<Room<2, 0, 1, 1, 1, 1, 1>>;

/// Returns a scene of two spheres, a wire, a disc and a triangle at random places. Its light is a sun if `is_sun`, else a
/// lamp that is up to `far` away along each axis.
fn scene(sweep: &mut Sweep, far: f64, is_sun: bool) -> Built {
    let mut scene = RuntimeScene::<Room<2, 0, 1, 1, 1, 1, 1>>::new();
    let white = scene.add_material(Material::new([1.0; 3])).unwrap();
    scene.add_sphere(sweep.place(), 0.4, white).unwrap();
    scene.add_sphere(sweep.place(), 0.05, white).unwrap();
    let (center, axis) = (sweep.place(), sweep.place());
    scene.add_cylinder(center, axis, 0.02, 1.5, white).unwrap();
    scene
        .add_disc(sweep.place(), sweep.place(), 0.2, white)
        .unwrap();
    let corners = [0, 1, 2].map(|_| sweep.place().map(|it| 0.3 * it));
    scene.add_triangle(corners, None, white).unwrap();
    let towards = sweep.place().map(|it| far * it);
    if is_sun {
        scene.add_sun(towards, [1.0; 3], 0).unwrap()
    } else {
        scene.add_light(towards, [1.0; 3]).unwrap()
    };
    scene.build().unwrap()
}

/// Tests by the plain path whether a light shines on a point.
fn shines_on(scene: &Built, at: ScaledPoint) -> bool {
    let light = scene.parts().lights[0].place;
    let (way, scale) = at.to(light);
    let (direction, distance) = way.direction_and_length();
    let (ray, light) = (ScaledRay::new(at, direction), (light, distance, scale));
    !occluded(scene, ShapeSet::ALL, &ray, ShapeId::NONE, light)
}

/// A far light that is said to shine on a stretch shines on each point of it: a lamp that is up to a million times as far
/// away as the shapes are, or a sun. Most of the stretches that it shines on are known.
#[test]
fn far_light_shines_on_all_points_where_it_is_said_to() {
    let mut sweep = Sweep::new(83);
    let (mut said, mut lit, mut lamps, mut dark) = (0, 0, 0, [0; 2]);
    let mut parts_known = 0;
    for round in 0..2_000 {
        let far = [60.0, 100.0, 1e3, 1e6][round % 4];
        let scene = scene(&mut sweep, far, round % 8 == 7);
        let parts = scene.parts();
        let light = parts.lights[0];
        if light.place.is_near() {
            continue;
        }
        for _ in 0..10 {
            let (middle, half) = (sweep.place(), sweep.place());
            let at = |share: f64| {
                let place = [0, 1, 2].map(|axis| middle[axis] + 0.1 * share * half[axis]);
                parts.grid.place(Position::new(place))
            };
            let mut suspects = *ShapeSet::ALL;
            let mut ask = |from: i32, to: i32| {
                let stretch = LitStretch {
                    shape: ShapeId::NONE,
                    is_hollow: false,
                    bulge: 0,
                    slack: 0,
                    ends: [from, to].map(|it| at(f64::from(it) / 10.0)),
                };
                let from_light = Rays::new(light.place, stretch.ends).ends;
                let towards = from_light.map(|it| light.sun().unwrap_or(it.reversed()));
                let is_said = far_lights_all(&&scene, &stretch, towards, &mut suspects);
                let shines = || (from..=to).map(|it| shines_on(&scene, at(f64::from(it) / 10.0)));
                let (is_lit, is_dark) = (shines().all(|it| it), !shines().any(|it| it));
                let is_true = is_said.is_none_or(|it| if it { is_lit } else { is_dark });
                assert!(is_true, "round {round}, {from} to {to}");
                (is_said, is_lit, is_dark)
            };
            let (is_said, is_lit, is_dark) = ask(-10, 10);
            // Only the suspects that the whole leaves are asked about its parts.
            if is_said.is_none() {
                parts_known += u32::from(ask(-10, 0).0.is_some());
                ask(-5, 0);
            }
            said += u32::from(is_said == Some(true));
            lit += u32::from(is_lit);
            dark[0] += u32::from(is_said == Some(false));
            dark[1] += u32::from(is_dark);
            lamps += u32::from(is_said.is_some() && light.sun().is_none());
        }
    }
    assert!(
        said * 100 > lit * 93 && dark[0] * 100 > dark[1] * 99 && lit < 17_000 && lamps > 5_000,
        "{said} of {lit}, {lamps}, {dark:?}"
    );
    assert!(parts_known > 500, "{parts_known}");
}
