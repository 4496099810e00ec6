//! Tests groups of spheres and cylinders that touch or intersect. `Exact` decides shadows by
//! tangents, and must not lose pixels that `Small`, which tests every shape, gets right.

use embedded_graphics::prelude::Size;
use proptest::prelude::*;
use proptest::strategy::ValueTree;
use proptest::test_runner::{Config, RngAlgorithm, TestRng, TestRunner};
use reflet::host::painted;
use reflet::host::reference::{self, Picture, Shading};
use reflet::quality::{Exact, Quality, Small};
use reflet::{Camera, Material, RuntimeScene, room};

type Triple = [f64; 3];
type Scenery = RuntimeScene<room!(spheres: 12, planes: 1, cylinders: 12, lights: 2, materials: 2)>;

const WIDTH: u32 = 64;
const HEIGHT: u32 = 48;
const REFLECTIONS: u8 = 2;
const CROWDS: u32 = 200;

/// A shape beside or inside the one before it.
#[derive(Clone, Debug)]
struct Neighbour {
    /// Direction from the shape before to this one's centre.
    way: Triple,
    radius: f64,
    /// Distance of the centres, divided by the sum of the radii: at 1 spheres touch, below 1 they
    /// intersect, at 0 their centres coincide.
    apart: f64,
    /// Axis and height of a cylinder; `None` for a sphere.
    wall: Option<(Triple, f64)>,
}

#[derive(Clone, Debug)]
struct Crowd {
    neighbours: Vec<Neighbour>,
    has_floor: bool,
    mirror: f64,
    epsilon: f64,
    lights: [Triple; 2],
    eye: Triple,
}

fn triple() -> impl Strategy<Value = Triple> {
    prop::array::uniform3(-1.0..1.0).prop_filter("a direction", |it| {
        it.iter().map(|it| it * it).sum::<f64>() > 0.01
    })
}

fn neighbour() -> impl Strategy<Value = Neighbour> {
    let apart = prop_oneof![2 => Just(1.0), 2 => 0.3..1.0, 1 => 0.99..1.01, 1 => Just(0.0)];
    let radius = prop_oneof![1 => Just(0.25), 2 => 0.1..0.5];
    let wall = prop::option::of((triple(), 0.3..1.5));
    (triple(), radius, apart, wall).prop_map(|(way, radius, apart, wall)| Neighbour {
        way,
        radius,
        apart,
        wall,
    })
}

fn crowd() -> impl Strategy<Value = Crowd> {
    let epsilon = prop_oneof![Just(2e-2), Just(1e-3), Just(1e-4), Just(1e-9)];
    let all = prop::collection::vec(neighbour(), 2..12);
    let lights = [triple(), triple()];
    (all, any::<bool>(), 0.0..0.8, epsilon, lights, triple()).prop_map(
        |(neighbours, has_floor, mirror, epsilon, lights, eye)| Crowd {
            neighbours,
            has_floor,
            mirror,
            epsilon,
            lights,
            eye,
        },
    )
}

/// Returns the vector scaled to a length.
fn scaled([x, y, z]: Triple, length: f64) -> Triple {
    let factor = length / (x * x + y * y + z * z).sqrt();
    [x * factor, y * factor, z * factor]
}

fn sum([ax, ay, az]: Triple, [bx, by, bz]: Triple) -> Triple {
    [ax + bx, ay + by, az + bz]
}

impl Crowd {
    fn scene(&self) -> Scenery {
        let mut scene = Scenery::new();
        let ball = Material::from_numbers([0.9, 0.6, 0.3], 0.1, 0.7, (0.3, 8), self.mirror);
        let floor = Material::from_numbers([0.6, 0.7, 0.8], 0.1, 0.8, (0, 1), self.mirror / 2.0);
        let ball = scene.add_material(ball.unwrap()).unwrap();
        let floor = scene.add_material(floor.unwrap()).unwrap();
        let (mut center, mut last) = ([0.0; 3], 0.0);
        for it in &self.neighbours {
            center = sum(center, scaled(it.way, it.apart * (last + it.radius)));
            last = it.radius;
            match it.wall {
                None => {
                    scene.add_sphere(center, it.radius, ball).unwrap();
                }
                Some((axis, height)) => {
                    let added = scene.add_cylinder(center, axis, it.radius, height, ball);
                    added.unwrap();
                }
            }
        }
        if self.has_floor {
            scene.add_plane([0.0, 0.0, -0.5], [0, 0, 1], floor).unwrap();
        }
        for light in self.lights {
            let above = [light[0], light[1], light[2].abs() + 0.2];
            scene.add_light(scaled(above, 9.0), [0.7; 3]).unwrap();
        }
        scene.set_background([0.2, 0.3, 0.5]).unwrap();
        scene.set_epsilon(self.epsilon).unwrap();
        scene
    }

    fn camera(&self) -> Camera {
        let [x, y, z] = self.eye;
        let eye = scaled([x, y, z.abs() + 0.1], 5.0);
        let camera = Camera::new(eye, [0.0; 3], [0, 0, 1], 50.0);
        camera.unwrap_or_else(|_| Camera::new(eye, [0.0; 3], [0, 1, 0], 50.0).unwrap())
    }
}

fn rendered<Q: Quality>(scene: &Scenery, camera: &Camera) -> Picture {
    let built = scene.build().unwrap();
    let frame = built.frame(camera).reflections(REFLECTIONS).quality::<Q>();
    painted(&frame.prepare(Size::new(WIDTH, HEIGHT)).on(&built).unwrap())
}

fn apart(one: [u8; 3], other: [u8; 3]) -> u8 {
    let channels = one.into_iter().zip(other);
    channels
        .map(|(one, other)| one.abs_diff(other))
        .max()
        .unwrap()
}

/// Returns the reference's colours of four rays around that of a pixel, a 32nd of a pixel to each
/// side.
fn beside(
    scene: &reference::Scene,
    camera: &reference::Camera,
    (x, y): (u32, u32),
) -> [[u8; 3]; 4] {
    // In a picture 16 times as large, these are the four pixels in the middle of this one.
    let size = (16 * WIDTH, 16 * HEIGHT);
    [(7, 7), (7, 8), (8, 7), (8, 8)].map(|(right, down)| {
        let at = (16 * x + right, 16 * y + down);
        let n = u32::from(REFLECTIONS);
        let color = reference::pixel(scene, camera, size, at, n, Shading::BlinnPhong);
        color.map(|it| (255.0 * it).round().clamp(0.0, 255.0) as u8)
    })
}

/// Returns the pixels that `Exact` loses: off by more than 8 where `Small` is within 1, except where
/// rays beside the pixel have another colour.
fn lost(crowd: &Crowd) -> Vec<(u32, u32)> {
    let (scene, camera) = (crowd.scene(), crowd.camera());
    let exact = rendered::<Exact>(&scene, &camera);
    let small = rendered::<Small>(&scene, &camera);
    let scene = reference::Scene::from(&scene.description());
    let camera = reference::Camera::from(&camera);
    let n = u32::from(REFLECTIONS);
    let truth = reference::render(&scene, &camera, WIDTH, HEIGHT, n, Shading::BlinnPhong);
    let places = (0..HEIGHT).flat_map(|y| (0..WIDTH).map(move |x| (x, y)));
    let is_lost = |&(index, at): &(usize, (u32, u32))| {
        let own = truth.pixels[index];
        apart(exact.pixels[index], own) > 8
            && apart(small.pixels[index], own) <= 1
            && beside(&scene, &camera, at)
                .into_iter()
                .all(|color| apart(color, own) <= 8)
    };
    let lost = places.enumerate().filter(is_lost);
    lost.map(|(_, at)| at).collect()
}

/// A group of shapes in which pixels are lost.
#[derive(Debug)]
#[expect(dead_code, reason = "for the message")]
struct Loser {
    crowd: Crowd,
    pixels: Vec<(u32, u32)>,
}

/// Returns the groups of shapes in which `Exact` loses a pixel.
fn losers() -> Vec<Loser> {
    let rng = TestRng::from_seed(RngAlgorithm::ChaCha, &[1; 32]);
    let mut runner = TestRunner::new_with_rng(Config::default(), rng);
    let crowds = (0..CROWDS).map(|_| crowd().new_tree(&mut runner).unwrap().current());
    let losers = crowds.map(|crowd| Loser {
        pixels: lost(&crowd),
        crowd,
    });
    losers.filter(|it| !it.pixels.is_empty()).collect()
}

#[test]
fn exact_loses_nothing_where_shapes_touch() {
    let losers = losers();
    assert!(losers.is_empty(), "{}: {:#?}", losers.len(), losers[0]);
}
