//! Tests the areas of a picture that depend on a shape: outside of them nothing changes when the shape moves, and not
//! much more than what changes is inside.

use embedded_graphics::prelude::*;
use embedded_graphics::primitives::Rectangle;
use reflet::description::{Cylinder, Disc, Sphere};
use reflet::display::Areas;
use reflet::host::file::FileScene;
use reflet::quality::{Exact, Fast, Quality, Small, Smooth};
use reflet::shading::BlinnPhong;
use reflet::{Camera, ErrorKind, Handle, Material};

use super::motion::Random;
use super::near::{Scenery, UP, apart, drawn};

const SIZE: Size = Size::new(56, 48);

/// Size of a board's display.
const DISPLAY: Size = Size::new(240, 240);

/// A shape that can move.
enum Shape {
    Sphere(Handle<Sphere>),
    Cylinder(Handle<Cylinder>),
    Disc(Handle<Disc>),
}

impl Shape {
    fn areas<Q: Quality>(&self, scene: &FileScene, camera: &Camera) -> Areas {
        let frame = scene.frame(camera).quality::<Q>();
        let areas = match self {
            Self::Sphere(it) => frame.areas_of(*it, SIZE),
            Self::Cylinder(it) => frame.areas_of(*it, SIZE),
            Self::Disc(it) => frame.areas_of(*it, SIZE),
        };
        areas.unwrap()
    }

    /// Moves to a place near `at`.
    fn take(&self, scene: &mut FileScene, random: &mut Random, at: [f64; 3]) {
        let step = at.map(|it| it + random.within(-0.4, 0.4));
        let place = [step[0], step[1], step[2].max(0.1)];
        let moved = match self {
            Self::Sphere(it) => scene.set_sphere(*it, place, random.within(0.2, 0.6)),
            Self::Cylinder(it) => {
                scene.set_cylinder(*it, place, random.direction(), 0.2, random.within(0.3, 1.0))
            }
            Self::Disc(it) => scene.set_disc(*it, place, random.direction(), 0.5),
        };
        moved.unwrap();
    }
}

/// A scene of some shapes over a floor, under lamps and suns.
struct Drawn {
    scene: FileScene,
    camera: Camera,
    shape: Shape,
    at: [f64; 3],
    /// Whether no round or bounded mirror is in it.
    is_plain: bool,
}

fn random_scene(random: &mut Random) -> Drawn {
    let mut scene = Scenery::new();
    scene.set_motion([-8.0; 3], [8.0; 3]).unwrap();
    let chalk = Material::new([0.9, 0.8, 0.7]).specular(0.3, 8.0);
    let chalk = scene.add_material(chalk).unwrap();
    let glass = scene
        .add_material(Material::new([0.5, 0.6, 0.7]).mirror(0.6))
        .unwrap();
    let (mirrors, is_plain) = (random.below(2) > 0, random.below(3) > 0);
    let other = if is_plain { chalk } else { glass };
    let floor = if mirrors { glass } else { chalk };
    scene.add_plane([0.0; 3], UP, floor).unwrap();
    if random.below(3) == 0 {
        let wall = if random.below(2) > 0 { glass } else { chalk };
        scene
            .add_plane([0.0, 4.5, 0.0], [random.within(-0.3, 0.3), -1.0, 0.0], wall)
            .unwrap();
    }
    for _ in 0..1 + random.below(3) {
        let place = [
            random.within(-3.0, 3.0),
            random.within(-3.0, 3.0),
            random.within(0.5, 7.0),
        ];
        if random.below(3) == 0 {
            scene.add_sun(place, [0.5; 3], 0).unwrap();
        } else {
            scene.add_light(place, [0.5; 3]).unwrap();
        }
    }
    for _ in 0..1 + random.below(4) {
        let place = [
            random.within(-3.0, 3.0),
            random.within(-2.0, 3.0),
            random.within(0.2, 2.0),
        ];
        match random.below(3) {
            0 => drop(
                scene
                    .add_cylinder(place, random.direction(), 0.3, 1.2, other)
                    .unwrap(),
            ),
            1 => drop(
                scene
                    .add_disc(place, random.direction(), 0.6, other)
                    .unwrap(),
            ),
            _ => drop(
                scene
                    .add_sphere(place, random.within(0.2, 0.8), other)
                    .unwrap(),
            ),
        }
    }
    let at = [
        random.within(-1.5, 1.5),
        random.within(-1.5, 1.5),
        random.within(0.4, 2.0),
    ];
    let own = if random.below(2) > 0 { chalk } else { glass };
    let shape = match random.below(3) {
        0 => Shape::Cylinder(scene.add_cylinder(at, UP, 0.2, 0.8, own).unwrap()),
        1 => Shape::Disc(scene.add_disc(at, UP, 0.5, own).unwrap()),
        _ => Shape::Sphere(scene.add_sphere(at, 0.5, own).unwrap()),
    };
    let eye = [
        random.within(-4.0, 4.0),
        random.within(-7.5, -4.0),
        random.within(0.5, 5.0),
    ];
    Drawn {
        scene: scene.build().unwrap(),
        camera: Camera::new(eye, [0.0, 0.0, 0.8], UP, 50).unwrap(),
        shape,
        at,
        is_plain,
    }
}

/// Counts of pixels: those that change, and those of the areas.
#[derive(Default)]
struct Counts {
    changed: usize,
    drawn: usize,
}

impl Counts {
    fn say(&self, what: &str) {
        let ratio = self.drawn as f64 / self.changed as f64;
        println!("{what}: {ratio:.2} times the pixels that change are drawn");
    }
}

/// Returns for each pixel of a picture whether it lies in an area.
fn covered(areas: &Areas, size: Size) -> Vec<bool> {
    let pixels = Rectangle::new(Point::zero(), size).points();
    let is_in = |at| areas.iter().any(|area| area.contains(at));
    pixels.map(is_in).collect()
}

/// Moves shapes, and fails if a pixel outside of the areas changes by more than `most`.
fn nothing_else_changes<Q: Quality>(seed: u64, moves: usize, most: u8) -> Counts {
    let (mut random, mut counts) = (Random(seed), Counts::default());
    for number in 0..moves {
        let Drawn {
            mut scene,
            camera,
            shape,
            at,
            is_plain,
        } = random_scene(&mut random);
        let before = drawn::<Q, BlinnPhong>(&scene, &camera, SIZE);
        let areas = shape.areas::<Q>(&scene, &camera);
        shape.take(&mut scene, &mut random, at);
        let after = drawn::<Q, BlinnPhong>(&scene, &camera, SIZE);
        let areas = areas.with(&shape.areas::<Q>(&scene, &camera));
        let is_in = covered(&areas, SIZE);
        for (place, (one, other)) in before.pixels.iter().zip(&after.pixels).enumerate() {
            let change = one
                .iter()
                .zip(other)
                .map(|(one, other)| one.abs_diff(*other))
                .max();
            assert!(
                is_in[place] || change <= Some(most),
                "move {number}: pixel {} {} {one:?} {other:?} {areas:?}",
                place % SIZE.width as usize,
                place / SIZE.width as usize
            );
            if is_plain {
                counts.changed += usize::from(change > Some(0));
                counts.drawn += usize::from(is_in[place]);
            }
        }
    }
    counts
}

#[test]
fn nothing_changes_outside_of_the_areas_of_a_shape_that_moves() {
    nothing_else_changes::<Exact>(0xa4ea, 1000, 0).say("random scenes");
    nothing_else_changes::<Small>(0xa4f0, 200, 0);
    nothing_else_changes::<Fast>(0xa4eb, 200, 2);
    nothing_else_changes::<Smooth<2>>(0xa4ec, 40, 2);
}

#[test]
fn areas_of_a_ball_over_a_mirror_are_some_twice_what_changes() {
    let (mut scenery, mut counts) = (Scenery::new(), Counts::default());
    scenery
        .set_motion([-3.0, -3.0, 0.0], [3.0, 3.0, 5.0])
        .unwrap();
    let red = scenery
        .add_material(Material::new([0.9, 0.2, 0.1]).mirror(0.3))
        .unwrap();
    let water = scenery
        .add_material(Material::new([0.5, 0.6, 0.8]).mirror(0.5))
        .unwrap();
    let ball = scenery.add_sphere([0.0, 0.0, 1.0], 0.7, red).unwrap();
    scenery.add_plane([0.0; 3], UP, water).unwrap();
    scenery.add_light([3.0, -4.0, 8.0], [1.0; 3]).unwrap();
    let camera = Camera::new([0.0, -8.0, 3.0], [0.0, 0.0, 1.0], UP, 50).unwrap();
    let mut scene = scenery.build().unwrap();
    for step in 0..8 {
        let before = drawn::<Exact, BlinnPhong>(&scene, &camera, DISPLAY);
        let old = scene.frame(&camera).areas_of(ball, DISPLAY).unwrap();
        let along = 0.125 * f64::from(step);
        scene
            .set_sphere(ball, [along, 0.0, 1.0 + along], 0.7)
            .unwrap();
        let after = drawn::<Exact, BlinnPhong>(&scene, &camera, DISPLAY);
        let areas = old.with(&scene.frame(&camera).areas_of(ball, DISPLAY).unwrap());
        if step > 0 {
            counts.changed += apart(&before, &after, 0);
            let is_in = covered(&areas, DISPLAY);
            counts.drawn += is_in.iter().filter(|it| **it).count();
        }
    }
    counts.say("a ball over a mirror");
    assert!(10 * counts.drawn < 21 * counts.changed);
}

/// A thin shape has whole rows divided, although it lies beside the picture.
#[test]
fn smooth_rows_beside_a_thin_shape_belong_to_its_areas() {
    let mut scenery = Scenery::new();
    scenery.set_motion([-9.0; 3], [9.0; 3]).unwrap();
    let chalk = scenery.add_material(Material::new([0.9; 3])).unwrap();
    scenery.add_sphere([0.0; 3], 1.0, chalk).unwrap();
    let dot = scenery.add_sphere([-8.0, 0.0, 0.0], 0.02, chalk).unwrap();
    scenery.add_light([3.0, -4.0, 9.0], [0.7; 3]).unwrap();
    let camera = Camera::new([0.0, -5.0, 0.0], [0.0; 3], UP, 50).unwrap();
    let mut scene = scenery.build().unwrap();
    let size = Size::new(64, 64);
    let before = drawn::<Smooth<2, Exact>, BlinnPhong>(&scene, &camera, size);
    let areas = |scene: &FileScene| {
        let frame = scene.frame(&camera).quality::<Smooth<2, Exact>>();
        frame.areas_of(dot, size).unwrap()
    };
    let old = areas(&scene);
    scene.set_sphere(dot, [-8.0, 0.0, 0.7], 0.02).unwrap();
    let after = drawn::<Smooth<2, Exact>, BlinnPhong>(&scene, &camera, size);
    let is_in = covered(&old.with(&areas(&scene)), size);
    let changes = before.pixels.iter().zip(&after.pixels);
    let changes: Vec<bool> = changes.map(|(one, other)| one != other).collect();
    assert!(changes.contains(&true));
    assert!(
        changes
            .iter()
            .zip(&is_in)
            .all(|(change, is_in)| !change || *is_in)
    );
}

#[test]
fn shadow_of_a_shape_that_is_higher_than_the_lamp_has_no_end() {
    let mut scenery = Scenery::new();
    scenery
        .set_motion([-3.0, -3.0, 0.0], [3.0, 3.0, 5.0])
        .unwrap();
    let chalk = scenery.add_material(Material::new([0.9; 3])).unwrap();
    let post = scenery
        .add_cylinder([0.0, 0.0, 1.5], UP, 0.2, 2.5, chalk)
        .unwrap();
    scenery.add_plane([0.0; 3], UP, chalk).unwrap();
    scenery.add_light([2.0, 0.0, 1.5], [1.0; 3]).unwrap();
    let camera = Camera::new([0.0, -8.0, 3.0], [0.0, 0.0, 1.0], UP, 50).unwrap();
    let scene = scenery.build().unwrap();
    let areas = scene.frame(&camera).areas_of(post, SIZE).unwrap();
    assert!(areas.iter().eq([Rectangle::new(Point::zero(), SIZE)]));
}

#[test]
fn areas_that_touch_become_one_and_an_unknown_shape_has_none() {
    let mut random = Random(0xa4ef);
    let Drawn {
        scene,
        camera,
        shape,
        ..
    } = random_scene(&mut random);
    let areas = shape.areas::<Exact>(&scene, &camera);
    assert!(areas.iter().count() > 0);
    let both = areas.clone().with(&areas);
    assert_eq!(both.iter().count(), areas.iter().count());
    let (mut scenery, mut handle) = (Scenery::new(), None);
    let chalk = scenery.add_material(Material::new([0.9; 3])).unwrap();
    for _ in 0..9 {
        handle = Some(scenery.add_sphere([0.0; 3], 1.0, chalk).unwrap());
    }
    let refused = scene.frame(&camera).areas_of(handle.unwrap(), SIZE);
    assert_eq!(refused.unwrap_err().kind(), ErrorKind::UnknownHandle);
}

#[test]
#[ignore = "long: more moves"]
fn nothing_changes_outside_of_the_areas_of_more_moves() {
    nothing_else_changes::<Exact>(0xa4ed, 10_000, 0);
    nothing_else_changes::<Fast>(0xa4ee, 3000, 2);
}
