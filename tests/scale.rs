//! Tests that a scene has no size and position of its own: scaled by a power of two, or moved by
//! numbers that the format holds, it gives the same picture to the bit.

use embedded_graphics::prelude::Size;
use reflet::host::painted;
use reflet::host::reference::{Picture, Vector};
use reflet::quality::Exact;
use reflet::{Camera, Material, RuntimeScene, room};

/// Scale (a power of two) and offset of the scene, and the distance of its camera.
#[derive(Clone, Copy, Debug)]
struct Setting {
    power: i32,
    offset: [f64; 3],
    distance: f64,
}

const HERE: Setting = Setting {
    power: 0,
    offset: [0.0; 3],
    distance: 1.0,
};

impl Setting {
    fn length(self, length: f64) -> f64 {
        length * 2f64.powi(self.power)
    }

    fn placed(self, at: [f64; 3]) -> [f64; 3] {
        (Vector(at) + Vector(self.offset))
            .0
            .map(|it| self.length(it))
    }

    /// Draws a scene with mirrors, shadows, a far light and an infinite floor. Every coordinate is a
    /// multiple of 1/64.
    fn picture(self) -> Picture {
        let mut scene = RuntimeScene::<
            room!(spheres: 3, planes: 2, cylinders: 2, lights: 2, materials: 3),
        >::new();
        let mut add = |color: [f64; 3], mirror: f64| {
            let made = Material::from_numbers(color, 0.25, 0.5, (0.5, 7.5), mirror);
            scene.add_material(made.unwrap()).unwrap()
        };
        let (chalk, gold, water) = (
            add([1.0; 3], 0.0),
            add([0.75, 0.5, 0.25], 0.5),
            add([0.25, 0.5, 1.0], 0.75),
        );
        let at = |at| self.placed(at);
        scene
            .add_sphere(at([-1.0, 0.0, 0.75]), self.length(0.75), gold)
            .unwrap();
        scene
            .add_sphere(at([0.5, -1.0, 0.25]), self.length(0.25), chalk)
            .unwrap();
        scene
            .add_sphere(at([1.5, 0.5, 0.5]), self.length(0.5), water)
            .unwrap();
        let (wide, high) = (self.length(0.375), self.length(1.5));
        scene
            .add_cylinder(at([0.5, 0.75, 0.75]), [0.0, 0.25, 1.0], wide, high, gold)
            .unwrap();
        let (wide, high) = (self.length(0.125), self.length(4.0));
        scene
            .add_cylinder(at([0.0, 1.5, 0.25]), [1.0, 0.0, 0.0], wide, high, chalk)
            .unwrap();
        scene
            .add_plane(at([5.0, 7.0, 0.0]), [0, 0, 1], water)
            .unwrap();
        scene
            .add_plane(at([0.0, 40.0, 0.0]), [1, -9, 0], chalk)
            .unwrap();
        scene
            .add_light(at([3.0, -4.0, 6.0]), [0.75, 0.75, 0.5])
            .unwrap();
        scene
            .add_light(at([-3000.0, -4000.0, 6000.0]), [0.5; 3])
            .unwrap();
        scene.set_background([0.25, 0.5, 0.75]).unwrap();
        scene.set_epsilon(self.length(1.0 / 1024.0)).unwrap();
        let eye = [0.5, -5.5, 2.0].map(|it| it * self.distance);
        let up = [0.0, 0.125, 1.0];
        let camera = Camera::new(at(eye), at([0.0, 0.0, 0.5]), up, 50.0 / self.distance).unwrap();
        scene.set_camera(camera);
        let built = scene.build().unwrap();
        let frame = built.frame(&camera).reflections(6).quality::<Exact>();
        painted(&frame.prepare(Size::new(64, 48)).on(&built).unwrap())
    }
}

#[test]
fn picture_shows_enough_to_compare() {
    for distance in [1.0, 16.0] {
        let mut colors = Setting { distance, ..HERE }.picture().pixels;
        colors.sort_unstable();
        colors.dedup();
        assert!(colors.len() > 1000, "{} colours", colors.len());
    }
}

#[test]
fn scene_scaled_by_a_power_of_two_gives_the_same_picture() {
    for distance in [1.0, 16.0] {
        let here = Setting { distance, ..HERE };
        let picture = here.picture();
        for power in [-20, -10, -3, -1, 1, 5, 10, 16] {
            let scaled = Setting { power, ..here };
            assert!(scaled.picture() == picture, "{scaled:?}");
        }
    }
}

#[test]
fn scene_that_is_moved_gives_the_same_picture() {
    for distance in [1.0, 16.0] {
        let here = Setting { distance, ..HERE };
        let picture = here.picture();
        for offset in [
            [1.0, 0.0, 0.0],
            [-0.015625, 1000.0, 3.5],
            [1e8, -1e8, 123_456_789.0],
        ] {
            let moved = Setting { offset, ..here };
            assert!(moved.picture() == picture, "{moved:?}");
        }
    }
}

#[test]
fn scene_that_is_moved_and_scaled_gives_the_same_picture() {
    let picture = HERE.picture();
    for (power, offset) in [(-9, [1e6, 2e6, -3e6]), (9, [-7777.5, 0.25, 31.0])] {
        let there = Setting {
            power,
            offset,
            ..HERE
        };
        assert!(there.picture() == picture, "{there:?}");
    }
}
