//! Tests: the sets of shapes that a scene keeps change the work, never the picture.

use super::{BuiltIn, NAMES, Visitor, visit};
use crate::quality::Fine;
use crate::ray::Path;
use crate::scene::World;
use crate::scene::sight::Sight;
use crate::scene::{RuntimeScene, Scene, Static};
use crate::shade::BlinnPhong;
use crate::trace::trace;
use crate::{Camera, Material};

const SIZE: (u32, u32) = (40, 32);

/// Compares every pixel with the one for which every ray asks every shape.
fn compare<W: World>(world: &W, camera: &Camera, name: &str) {
    let lens = camera.lens(SIZE.0, SIZE.1);
    let from = world.parts().grid.place(camera.description().position);
    for y in 0..SIZE.1 {
        let fan = from.is_near().then(|| lens.fan(y, from.point));
        let mut sight = Sight::new(world, fan);
        let mut everything = Sight::new(world, None);
        let mut directions = lens.row(y, 0);
        for x in 0..SIZE.0 {
            let path = Path {
                from,
                direction: directions.next_direction(),
            };
            let some = trace::<W, BlinnPhong, Fine>(world, &mut sight, x, path, 3);
            let all = trace::<W, BlinnPhong, Fine>(world, &mut everything, x, path, 3);
            assert_eq!(some.sum, all.sum, "{name}: pixel {x}, {y} of {camera:?}");
        }
    }
}

fn from_all_sides<W: World>(world: &W, camera: &Camera, name: &str) {
    for (azimuth, elevation) in [(0, 0), (35, 10), (100, -20), (180, 5), (-75, -8)] {
        if let Ok(camera) = camera.orbited(azimuth, elevation) {
            compare(world, &camera, name);
        }
    }
}

#[test]
fn rows_of_the_built_in_scenes_miss_no_shape() {
    struct Rows;
    impl Visitor for Rows {
        type Output = ();
        fn visit<S: BuiltIn>(self) {
            from_all_sides(&Static::<S>::new(), &S::CAMERA, S::NAME);
        }
    }
    for name in NAMES {
        visit(name, Rows).expect("a built-in scene");
    }
}

/// A generator good enough for scenes (Marsaglia, "Xorshift RNGs", 2003).
struct Random(u64);

impl Random {
    /// From -1 to 1.
    fn number(&mut self) -> f64 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 11) as f64 / (1_u64 << 52) as f64 - 1.0
    }

    fn point(&mut self) -> [f64; 3] {
        [self.number(), self.number(), self.number()]
    }
}

type Crowd = Scene<100, 2, 40, 2, 1>;

/// More shapes than a mask has bits, some mirrors, two lights; one of them among the shapes.
fn crowd(random: &mut Random) -> Crowd {
    let mut scene = RuntimeScene::<100, 2, 40, 2, 1>::new();
    let glass = Material::new([0.9, 0.8, 0.7]).mirror(0.5);
    let glass = scene.add_material(glass).unwrap();
    for _ in 0..100 {
        let radius = 0.02 + 0.08 * random.number().abs();
        scene.add_sphere(random.point(), radius, glass).unwrap();
    }
    for _ in 0..40 {
        let (radius, height) = (0.01 + 0.03 * random.number().abs(), random.number().abs());
        let (center, axis) = (random.point(), random.point());
        scene
            .add_cylinder(center, axis, radius, height + 0.01, glass)
            .unwrap();
    }
    scene
        .add_plane([0.0, 0.0, -1.1], [0.0, 0.0, 1.0], glass)
        .unwrap();
    scene
        .add_plane(random.point().map(|x| 3.0 * x), random.point(), glass)
        .unwrap();
    for place in [random.point(), random.point().map(|x| 4.0 * x)] {
        scene.add_light(place, [0.5, 0.5, 0.5]).unwrap();
    }
    scene.build().unwrap()
}

#[test]
fn rows_and_cells_of_crowded_scenes_miss_no_shape() {
    let mut random = Random(0x9e37_79b9_7f4a_7c15);
    for round in 0..6 {
        let scene = crowd(&mut random);
        let position = random.point().map(|x| 2.5 * x);
        let fov = 60.0 + 50.0 * random.number();
        let camera = Camera::new(position, [0.0; 3], [0.1, 0.2, 1.0], fov).unwrap();
        compare(&scene, &camera, &format!("crowd {round}"));
    }
}

#[test]
fn cells_miss_no_shape() {
    use crate::ray::{REACH, Ray};
    use crate::scene::mask::Mask;
    use crate::scene::query::blocked_by_bounded;
    use crate::vector::Position;
    let mut random = Random(0x2545_f491_4f6c_dd1d);
    let mut blocked = 0;
    for _ in 0..4 {
        let scene = crowd(&mut random);
        for lamp in scene.parts().lamps {
            for _ in 0..4000 {
                let direction = Position::new(random.point()).direction().unwrap();
                let ray = Ray {
                    origin: lamp.light.place.point,
                    direction,
                };
                let all = blocked_by_bounded(&scene, Mask::ALL, &ray, REACH);
                let mask = lamp.cells.mask(direction);
                assert_eq!(
                    blocked_by_bounded(&scene, mask, &ray, REACH),
                    all,
                    "{ray:?}"
                );
                blocked += u32::from(all);
            }
        }
    }
    assert!(blocked > 4000, "too few shapes to say anything: {blocked}");
}
