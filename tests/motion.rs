//! Tests parts that move: their pictures are those of a scene that is built with the parts in their new
//! places, errors change nothing, and a prepared frame refuses a scene that has changed.

use embedded_graphics::prelude::Size;
use reflet::__private::Drawable;
use reflet::description::{Cylinder, Disc, Light, Sphere};
use reflet::host::painted;
use reflet::host::reference::Picture;
use reflet::quality::{Exact, Fast, Quality};
use reflet::scenes::{Castle, Mirror1};
use reflet::shading::{BlinnPhong, Phong};
use reflet::{
    Camera, Error, ErrorKind, FrameBuilder, Handle, Material, MaterialId, MovingScene,
    PreparedFrame, Rows, RuntimeScene, Scene, SceneBuilder, room, scene,
};

type Parts = room!(spheres: 5, planes: 1, cylinders: 3, discs: 3, lights: 2, materials: 4);

const GOLD: Material = Material::new([0.7, 0.6, 0.0])
    .specular(0.8, 4.0)
    .mirror(0.4);
const GLASS: Material = Material::new([0.9; 3]).diffuse(0.2).mirror(0.8);
const CHALK: Material = Material::new([0.9, 0.9, 0.8]);
const WATER: Material = Material::new([0.3, 0.4, 0.6]).mirror(0.3);

const LOW: [f64; 3] = [-4.0, -4.0, -0.5];
const HIGH: [f64; 3] = [4.0, 4.0, 5.0];
const CAMERA: Camera = Camera::look_at([1.0, -9.0, 4.0], [0.0, 0.0, 1.5], [0.0, 0.0, 1.0]);

scene! {
    /// Parts that move between parts that stand; both have round mirrors.
    struct Tower {
        motion([-4.0, -4.0, -0.5], [4.0, 4.0, 5.0]);
        sphere BALL([0.0, 0.0, 1.0], 0.75, GOLD);
        sphere MARBLE([1.0, -1.0, 2.0], 0.5, CHALK);
        sphere([-1.5, 0.5, 0.75], 0.75, GLASS);
        sphere([1.75, 1.0, 0.5], 0.5, CHALK);
        sphere([0.25, -2.0, 0.375], 0.375, GOLD);
        cylinder LOG([0.0, 1.0, 2.0], [1.0, 0.0, 0.5], 0.25, 1.5, GOLD);
        cylinder([2.25, -0.5, 1.0], [0.0, 0.0, 1.0], 0.375, 2.0, CHALK);
        cylinder([-2.5, -1.0, 1.25], [0.0, 0.25, 1.0], 0.25, 2.5, GLASS);
        disc LID([0.0, 0.0, 3.0], [0.0, -0.5, 1.0], 0.75, GLASS);
        disc([-1.0, 2.0, 1.5], [0.25, -1.0, 0.0], 1.0, GLASS);
        disc([2.0, 2.0, 2.5], [1.0, 1.0, 0.5], 0.5, CHALK);
        plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], WATER);
        light([2.5, -2.5, 4.5], [0.9, 0.9, 0.8]);
        light([-2.5, -1.0, 4.0], [0.4, 0.4, 0.5]);
        background([0.2, 0.3, 0.5]);
        camera(CAMERA);
    }
}

/// Where the parts of a scene are. Materials go with the index of a part.
#[derive(Clone)]
struct Places {
    spheres: [([f64; 3], f64); 5],
    cylinders: [([f64; 3], [f64; 3], f64, f64); 3],
    discs: [([f64; 3], [f64; 3], f64); 3],
    lights: [[f64; 3]; 2],
}

/// Places of all parts of the scene [`Tower`] before anything moves.
const START: Places = Places {
    spheres: [
        ([0.0, 0.0, 1.0], 0.75),
        ([1.0, -1.0, 2.0], 0.5),
        ([-1.5, 0.5, 0.75], 0.75),
        ([1.75, 1.0, 0.5], 0.5),
        ([0.25, -2.0, 0.375], 0.375),
    ],
    cylinders: [
        ([0.0, 1.0, 2.0], [1.0, 0.0, 0.5], 0.25, 1.5),
        ([2.25, -0.5, 1.0], [0.0, 0.0, 1.0], 0.375, 2.0),
        ([-2.5, -1.0, 1.25], [0.0, 0.25, 1.0], 0.25, 2.5),
    ],
    discs: [
        ([0.0, 0.0, 3.0], [0.0, -0.5, 1.0], 0.75),
        ([-1.0, 2.0, 1.5], [0.25, -1.0, 0.0], 1.0),
        ([2.0, 2.0, 2.5], [1.0, 1.0, 0.5], 0.5),
    ],
    lights: [[2.5, -2.5, 4.5], [-2.5, -1.0, 4.0]],
};

/// A built scene and the handles of its parts.
struct Built {
    scene: Scene<Parts>,
    spheres: Vec<Handle<Sphere>>,
    cylinders: Vec<Handle<Cylinder>>,
    discs: Vec<Handle<Disc>>,
    lights: Vec<Handle<Light>>,
}

impl Places {
    fn built(&self) -> Built {
        self.built_in(Some([LOW, HIGH]))
    }

    /// Builds the scene with a motion box, or without one.
    fn built_in(&self, motion: Option<[[f64; 3]; 2]>) -> Built {
        let mut scene = RuntimeScene::<Parts>::new();
        if let Some([low, high]) = motion {
            scene.set_motion(low, high).unwrap();
        }
        let ids = [GOLD, CHALK, GLASS, WATER].map(|it| scene.add_material(it).unwrap());
        let [gold, chalk, glass, water] = ids;
        let of = |materials: [MaterialId; 5]| materials.into_iter();
        let spheres = self
            .spheres
            .iter()
            .zip(of([gold, chalk, glass, chalk, gold]));
        let spheres = spheres.map(|((center, radius), id)| scene.add_sphere(*center, *radius, id));
        let spheres = spheres.map(Result::unwrap).collect();
        let cylinders = self
            .cylinders
            .iter()
            .zip(of([gold, chalk, glass, gold, gold]));
        let cylinders = cylinders.map(|((center, axis, radius, height), id)| {
            scene.add_cylinder(*center, *axis, *radius, *height, id)
        });
        let cylinders = cylinders.map(Result::unwrap).collect();
        let discs = self.discs.iter().zip(of([glass, glass, chalk, gold, gold]));
        let discs = discs
            .map(|((center, normal, radius), id)| scene.add_disc(*center, *normal, *radius, id));
        let discs = discs.map(Result::unwrap).collect();
        scene.add_plane([0, 0, 0], [0, 0, 1], water).unwrap();
        let colors = [[0.9, 0.9, 0.8], [0.4, 0.4, 0.5]];
        let lights = self.lights.iter().zip(colors);
        let lights = lights.map(|(position, color)| scene.add_light(*position, color));
        let lights = lights.map(Result::unwrap).collect();
        scene.set_background([0.2, 0.3, 0.5]).unwrap();
        scene.set_camera(CAMERA);
        Built {
            scene: scene.build().unwrap(),
            spheres,
            cylinders,
            discs,
            lights,
        }
    }
}

fn picture_in<S: Drawable, Q: Quality>(scene: &S, camera: &Camera) -> Picture {
    let frame = FrameBuilder::new(scene, camera).quality::<Q>();
    painted(&frame.prepare(Size::new(48, 40)).on(scene).unwrap())
}

/// Draws a scene in the qualities `Fast` and `Exact`.
fn pictures<S: Drawable>(scene: &S, camera: &Camera) -> [Picture; 2] {
    [
        picture_in::<S, Fast>(scene, camera),
        picture_in::<S, Exact>(scene, camera),
    ]
}

/// Random numbers that are the same in every run: xorshift, 64 bits.
struct Random(u64);

impl Random {
    fn below(&mut self, end: u32) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 32) as u32 % end
    }

    fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(self.below(1 << 20)) / f64::from(1 << 20)
    }

    /// Returns a point of the motion box that is not nearer to its sides than `margin`.
    fn place(&mut self, margin: f64) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.within(LOW[axis] + margin, HIGH[axis] - margin))
    }

    /// Returns a direction of any length but 0.
    fn direction(&mut self) -> [f64; 3] {
        [
            self.within(-1.0, 1.0),
            self.within(-1.0, 1.0),
            0.125 + self.within(0.0, 1.0),
        ]
    }

    fn sphere(&mut self) -> ([f64; 3], f64) {
        let radius = self.within(0.25, 1.0);
        (self.place(radius), radius)
    }

    fn cylinder(&mut self) -> ([f64; 3], [f64; 3], f64, f64) {
        let (radius, height) = (self.within(0.25, 0.75), self.within(0.5, 2.5));
        // A scene that is built anew takes a cylinder to reach that far.
        let around = radius + height / 2.0;
        (self.place(around), self.direction(), radius, height)
    }

    fn disc(&mut self) -> ([f64; 3], [f64; 3], f64) {
        let radius = self.within(0.25, 1.0);
        (self.place(radius), self.direction(), radius)
    }

    fn camera(&mut self) -> Camera {
        CAMERA
            .orbited(self.below(360) as i32, self.within(-10.0, 40.0))
            .unwrap()
    }
}

/// Fails unless a changed scene is drawn as the scene that is built with the parts in their new places.
#[track_caller]
fn assert_drawn_as_built<S: Drawable>(scene: &S, places: &Places, camera: &Camera, step: u32) {
    let expected = pictures(&places.built().scene, camera);
    let found = pictures(scene, camera);
    // Tables of lights choose which pixels `Fast` interpolates, but all are exact to its tolerance.
    let names = [("fast", 1), ("exact", 0)];
    for ((name, most), (found, expected)) in names.into_iter().zip(found.iter().zip(&expected)) {
        let pixels = found.pixels.iter().zip(&expected.pixels);
        let is_off = |a: &[u8; 3], b: &[u8; 3]| (0..3).any(|it| a[it].abs_diff(b[it]) > most);
        let different = pixels.filter(|(a, b)| is_off(a, b)).count();
        assert_eq!(different, 0, "{name}, step {step}");
    }
}

#[test]
fn scene_whose_parts_have_moved_is_drawn_as_one_that_is_built_there() {
    for seed in [0x5eed, 0xba11, 0x1097] {
        let mut random = Random(seed);
        let (mut built, mut places) = (START.built(), START.clone());
        for step in 0..60 {
            match random.below(4) {
                0 => {
                    let (index, (center, radius)) = (random.below(5) as usize, random.sphere());
                    places.spheres[index] = (center, radius);
                    let moved = built.scene.set_sphere(built.spheres[index], center, radius);
                    moved.unwrap();
                }
                1 => {
                    let (index, moved) = (random.below(3) as usize, random.cylinder());
                    places.cylinders[index] = moved;
                    let (handle, (center, axis, radius, height)) = (built.cylinders[index], moved);
                    let moved = built
                        .scene
                        .set_cylinder(handle, center, axis, radius, height);
                    moved.unwrap();
                }
                2 => {
                    let (index, moved) = (random.below(3) as usize, random.disc());
                    places.discs[index] = moved;
                    let (handle, (center, normal, radius)) = (built.discs[index], moved);
                    let moved = built.scene.set_disc(handle, center, normal, radius);
                    moved.unwrap();
                }
                _ => {
                    let (index, position) = (random.below(2) as usize, random.place(0.0));
                    places.lights[index] = position;
                    built
                        .scene
                        .set_light(built.lights[index], position)
                        .unwrap();
                }
            }
            let camera = random.camera();
            assert_drawn_as_built(&built.scene, &places, &camera, step);
            assert_drawn_as_built(&built.scene.tabled(), &places, &camera, step);
        }
    }
}

#[test]
fn constant_scene_is_drawn_the_same_in_flash_in_ram_and_built_at_run_time() {
    let built = START.built();
    for camera in [CAMERA, CAMERA.orbited(100, 10).unwrap()] {
        let expected = pictures(&built.scene, &camera);
        assert!(pictures(&Tower, &camera) == expected);
        assert!(pictures(&MovingScene::<Tower>::new(), &camera) == expected);
        let colors: std::collections::BTreeSet<_> = expected[1].pixels.iter().collect();
        assert!(colors.len() > 300, "{} colours", colors.len());
    }
}

#[test]
fn constant_scene_whose_parts_have_moved_is_drawn_as_one_that_is_built_there() {
    for seed in [0x5eed, 0xba11, 0x1097] {
        let mut random = Random(seed);
        let (mut scene, mut places) = (MovingScene::<Tower>::new(), START.clone());
        let mut filled = START.built();
        for step in 0..60 {
            match random.below(4) {
                0 => {
                    let (center, radius) = random.sphere();
                    places.spheres[0] = (center, radius);
                    scene.set_sphere(Tower::BALL, center, radius).unwrap();
                    filled
                        .scene
                        .set_sphere(Tower::BALL, center, radius)
                        .unwrap();
                }
                1 => {
                    let (center, radius) = random.sphere();
                    places.spheres[1] = (center, radius);
                    scene.set_sphere(Tower::MARBLE, center, radius).unwrap();
                    filled
                        .scene
                        .set_sphere(Tower::MARBLE, center, radius)
                        .unwrap();
                }
                2 => {
                    let moved @ (center, axis, radius, height) = random.cylinder();
                    places.cylinders[0] = moved;
                    let set = scene.set_cylinder(Tower::LOG, center, axis, radius, height);
                    set.unwrap();
                    let set = filled
                        .scene
                        .set_cylinder(Tower::LOG, center, axis, radius, height);
                    set.unwrap();
                }
                _ => {
                    let moved @ (center, normal, radius) = random.disc();
                    places.discs[0] = moved;
                    scene.set_disc(Tower::LID, center, normal, radius).unwrap();
                    filled
                        .scene
                        .set_disc(Tower::LID, center, normal, radius)
                        .unwrap();
                }
            }
            let camera = random.camera();
            assert_drawn_as_built(&scene, &places, &camera, step);
            assert_drawn_as_built(&filled.scene, &places, &camera, step);
        }
    }
}

scene! {
    /// Mirrors so many that rays off them ask a hierarchy; one of them moves.
    struct Swarm {
        motion([-4.0, -4.0, -0.5], [4.0, 4.0, 5.0]);
        sphere BALL([0.0, 0.0, 1.0], 0.75, GOLD);
        sphere([-3.0, -2.0, 0.5], 0.5, GLASS);
        sphere([-1.5, -2.0, 0.5], 0.5, GLASS);
        sphere([1.5, -2.0, 0.5], 0.5, GLASS);
        sphere([3.0, -2.0, 0.5], 0.5, GLASS);
        sphere([-3.0, 0.0, 0.5], 0.5, GLASS);
        sphere([-1.5, 0.0, 0.5], 0.5, GLASS);
        sphere([1.5, 0.0, 0.5], 0.5, GLASS);
        sphere([3.0, 0.0, 0.5], 0.5, GLASS);
        sphere([-3.0, 2.0, 0.5], 0.5, GLASS);
        sphere([-1.5, 2.0, 0.5], 0.5, GLASS);
        sphere([0.0, 2.0, 0.5], 0.5, GLASS);
        sphere([1.5, 2.0, 0.5], 0.5, GLASS);
        sphere([3.0, 2.0, 0.5], 0.5, GLASS);
        sphere([-1.0, 1.0, 2.0], 0.5, GLASS);
        sphere([1.0, 1.0, 2.0], 0.5, GLASS);
        sphere([-1.0, -1.0, 2.0], 0.5, GLASS);
        sphere([1.0, -1.0, 2.0], 0.5, GLASS);
        light([2.5, -2.5, 4.5], [0.9, 0.9, 0.8]);
        background([0.2, 0.3, 0.5]);
        camera(CAMERA);
    }
}

/// Returns the scene [`Swarm`], built at run time, without a hierarchy, with its ball in another place.
fn swarm(center: [f64; 3], radius: f64) -> Scene<room!(spheres: 18, lights: 1, materials: 2)> {
    let mut scene = RuntimeScene::new();
    let [gold, glass] = [GOLD, GLASS].map(|it| scene.add_material(it).unwrap());
    scene.add_sphere(center, radius, gold).unwrap();
    Swarm::with_description(|swarm| {
        for ball in swarm.spheres.iter().skip(1) {
            scene.add_sphere(ball.center, ball.radius, glass).unwrap();
        }
    });
    scene.add_light([2.5, -2.5, 4.5], [0.9, 0.9, 0.8]).unwrap();
    scene.set_background([0.2, 0.3, 0.5]).unwrap();
    scene.set_motion(LOW, HIGH).unwrap();
    scene.build().unwrap()
}

#[test]
fn mirror_that_moves_among_many_is_drawn_as_one_that_is_built_there() {
    let mut random = Random(0x5a4);
    let mut scene = MovingScene::<Swarm>::new();
    for step in 0..40 {
        let (center, radius) = random.sphere();
        scene.set_sphere(Swarm::BALL, center, radius).unwrap();
        let camera = random.camera();
        let built = swarm(center, radius);
        let [fast, exact] = pictures(&scene, &camera);
        let [built_fast, built_exact] = pictures(&built, &camera);
        assert!(exact == built_exact, "{step}");
        // How much is certain between two pixels depends on the tables, which know where a ball may move.
        let pixels = fast.pixels.iter().zip(&built_fast.pixels);
        let is_further = |(one, other): (&[u8; 3], &[u8; 3])| {
            one.iter()
                .zip(other)
                .any(|(one, other)| one.abs_diff(*other) > 1)
        };
        assert_eq!(pixels.filter(|it| is_further(*it)).count(), 0, "{step}");
    }
}

#[test]
fn handle_of_a_constant_scene_counts_parts_of_its_kind() {
    assert_eq!((Tower::BALL.index(), Tower::MARBLE.index()), (0, 1));
    assert_eq!((Tower::LOG.index(), Tower::LID.index()), (0, 0));
    let built = START.built();
    assert_eq!(
        (built.spheres[1], built.discs[0]),
        (Tower::MARBLE, Tower::LID)
    );
}

#[track_caller]
fn assert_refused<S: Drawable>(frame: &PreparedFrame<S>, scene: &S) {
    let error = frame.on(scene).err().expect("the scene is refused");
    let found = (error.part(), error.index(), error.kind());
    assert_eq!(found, ("scene", None, ErrorKind::Changed));
}

/// A change of a scene that is refused.
type Change = fn(&mut Built) -> Result<(), Error>;

#[test]
fn prepared_frame_refuses_a_scene_that_has_changed() {
    let mut built = START.built();
    let frame = |scene: &Scene<Parts>| scene.frame(&CAMERA).prepare(Size::new(9, 9));
    let changes: [Change; 4] = [
        |it| it.scene.set_sphere(it.spheres[2], [0.5, 0.5, 2.5], 0.5),
        |it| {
            it.scene
                .set_cylinder(it.cylinders[1], [0, 0, 2], [0, 1, 1], 0.5, 1)
        },
        |it| {
            it.scene
                .set_disc(it.discs[1], [0.5, 0.5, 2.5], [0, 0, 1], 0.5)
        },
        |it| it.scene.set_light(it.lights[1], [0.5, 0.5, 2.5]),
    ];
    for change in changes {
        let before = frame(&built.scene);
        assert!(before.on(&built.scene).is_ok());
        change(&mut built).unwrap();
        assert_refused(&before, &built.scene);
        assert!(frame(&built.scene).on(&built.scene).is_ok());
    }
    let mut scene = MovingScene::<Tower>::new();
    let before = scene.frame(&CAMERA).prepare(Size::new(9, 9));
    scene.set_disc(Tower::LID, [0, 0, 2], [0, 0, 1], 1).unwrap();
    assert_refused(&before, &scene);
}

#[test]
fn prepared_frame_refuses_another_scene_of_the_same_type() {
    let one = START.built();
    let mut places = START;
    places.spheres[4].1 = 0.5;
    let frame = one.scene.frame(&CAMERA).prepare(Size::new(9, 9));
    assert_refused(&frame, &places.built().scene);
    assert_refused(&frame, &START.built_in(None).scene);
    // A copy, and a scene that is described in the same way, are the same scene.
    let copy = one.scene;
    assert!(frame.on(&copy).is_ok() && frame.on(&START.built().scene).is_ok());
    let tabled = one.scene.tabled();
    let frame = tabled.frame(&CAMERA).prepare(Size::new(9, 9));
    assert_refused(&frame, &places.built().scene.tabled());
}

#[test]
fn prepared_frame_refuses_a_copy_that_has_changed_in_another_way() {
    let mut one = START.built();
    let mut other = one.scene;
    let handle = one.spheres[0];
    one.scene.set_sphere(handle, [1, 0, 1], 0.5).unwrap();
    other.set_sphere(handle, [0, 1, 1], 0.5).unwrap();
    let frame = one.scene.frame(&CAMERA).prepare(Size::new(9, 9));
    assert_refused(&frame, &other);

    let mut other = START.built().scene;
    other.set_light(one.lights[0], [0, 1, 1]).unwrap();
    assert_refused(&frame, &other);

    let [mut one, mut other] = [MovingScene::<Tower>::new(), MovingScene::new()];
    one.set_sphere(Tower::BALL, [1, 0, 1], 0.5).unwrap();
    other.set_sphere(Tower::BALL, [0, 1, 1], 0.5).unwrap();
    let frame = one.frame(&CAMERA).prepare(Size::new(9, 9));
    assert_refused(&frame, &other);
}

type Lone = Scene<room!(spheres: 1, materials: 1)>;

const NEAR: Lone = SceneBuilder::new().sphere([0.0; 3], 1.0, CHALK).build();
const FAR: Lone = SceneBuilder::new()
    .sphere([0.0, 9.0, 0.0], 1.0, CHALK)
    .build();

#[test]
fn prepared_frame_refuses_another_constant_scene_of_the_same_type() {
    let frame = NEAR.frame(&CAMERA).prepare(Size::new(9, 9));
    assert!(frame.on(&NEAR).is_ok());
    assert_refused(&frame, &FAR);
}

/// Fails unless a change is refused with this error, and the scene is as it was.
#[track_caller]
fn assert_unchanged<S: Drawable>(
    scene: &mut S,
    expected: (&str, usize, ErrorKind),
    change: impl FnOnce(&mut S) -> Result<(), Error>,
) {
    let before = pictures(scene, &CAMERA);
    let frame = FrameBuilder::new(scene, &CAMERA).prepare(Size::new(9, 9));
    let error = change(scene).expect_err("the change is refused");
    let (part, index, kind) = expected;
    assert_eq!(
        (error.part(), error.index(), error.kind()),
        (part, Some(index), kind)
    );
    assert!(pictures(scene, &CAMERA) == before);
    assert!(
        frame.on(scene).is_ok(),
        "a scene that is as it was is the same scene"
    );
}

#[test]
fn part_that_would_leave_the_motion_box_stays() {
    use ErrorKind::Motion;
    let Built {
        mut scene,
        spheres,
        cylinders,
        discs,
        ..
    } = START.built();
    let scene = &mut scene;
    // Less than a hundredth out, on each side.
    for axis in 0..3 {
        for (side, sign) in [(LOW, -1.0), (HIGH, 1.0)] {
            let mut at = [0.0, 0.0, 2.0];
            at[axis] = side[axis] - sign * 0.99;
            let (sphere, disc) = (spheres[3], discs[2]);
            assert_unchanged(scene, ("sphere", 3, Motion), |it| {
                it.set_sphere(sphere, at, 1)
            });
            assert_unchanged(scene, ("disc", 2, Motion), |it| {
                it.set_disc(disc, at, [0, 0, 1], 1)
            });
            at[axis] = side[axis] - sign * 1.4;
            assert_unchanged(scene, ("cylinder", 1, Motion), |it| {
                it.set_cylinder(cylinders[1], at, [0, 0, 1], 1, 2)
            });
            // The box itself is large enough.
            at[axis] = side[axis] - sign;
            START.built().scene.set_sphere(sphere, at, 1).unwrap();
            START
                .built()
                .scene
                .set_disc(disc, at, [0, 0, 1], 1)
                .unwrap();
        }
    }
    for power in [4, 10, 14, 20, 25, 28, 29, 30] {
        let (at, most) = (2f64.powi(power), 2f64.powi(power - 1));
        for (place, radius) in [
            ([at, 0.0, 0.0], 1.0),
            ([0.0, -at, 0.0], most),
            ([0.0; 3], most),
        ] {
            let sphere = spheres[3];
            assert_unchanged(scene, ("sphere", 3, Motion), |it| {
                it.set_sphere(sphere, place, radius)
            });
        }
    }
    let mut scene = MovingScene::<Tower>::new();
    assert_unchanged(&mut scene, ("sphere", 1, Motion), |it| {
        it.set_sphere(Tower::MARBLE, [0, 0, 6], 1)
    });
    assert_unchanged(&mut scene, ("cylinder", 0, Motion), |it| {
        it.set_cylinder(Tower::LOG, [0, 0, 4], [0, 0, 1], 1, 2)
    });
    assert_unchanged(&mut scene, ("disc", 0, Motion), |it| {
        it.set_disc(Tower::LID, [0.0, 0.0, 0.25], [0, 0, 1], 1)
    });
}

#[test]
fn part_of_a_scene_without_a_motion_box_stays() {
    use ErrorKind::Motion;
    let Built {
        mut scene,
        spheres,
        cylinders,
        discs,
        lights,
    } = START.built_in(None);
    let at = [0, 0, 2];
    assert_unchanged(&mut scene, ("sphere", 0, Motion), |it| {
        it.set_sphere(spheres[0], at, 1)
    });
    assert_unchanged(&mut scene, ("disc", 0, Motion), |it| {
        it.set_disc(discs[0], at, at, 1)
    });
    assert_unchanged(&mut scene, ("cylinder", 0, Motion), |it| {
        it.set_cylinder(cylinders[0], at, at, 1, 1)
    });
    // A light needs no box.
    scene.set_light(lights[0], at).unwrap();
}

#[test]
fn handle_of_another_scene_is_refused() {
    use ErrorKind::UnknownHandle;
    let more = START.built();
    let mut scene = RuntimeScene::<Parts>::new();
    scene.set_motion(LOW, HIGH).unwrap();
    let chalk = scene.add_material(CHALK).unwrap();
    scene.add_sphere([0, 0, 1], 1, chalk).unwrap();
    scene.add_light([2, -2, 4], [1, 1, 1]).unwrap();
    let mut scene = scene.build().unwrap();
    let (scene, at) = (&mut scene, [0, 0, 2]);
    assert_unchanged(scene, ("sphere", 1, UnknownHandle), |it| {
        it.set_sphere(more.spheres[1], at, 1)
    });
    assert_unchanged(scene, ("cylinder", 0, UnknownHandle), |it| {
        it.set_cylinder(more.cylinders[0], at, at, 1, 1)
    });
    assert_unchanged(scene, ("disc", 2, UnknownHandle), |it| {
        it.set_disc(more.discs[2], at, at, 1)
    });
    assert_unchanged(scene, ("light", 1, UnknownHandle), |it| {
        it.set_light(more.lights[1], at)
    });

    // Parts of a constant scene that have no name do not move.
    let mut scene = MovingScene::<Tower>::new();
    for sphere in &more.spheres[2..] {
        assert_unchanged(
            &mut scene,
            ("sphere", sphere.index(), UnknownHandle),
            |it| it.set_sphere(*sphere, at, 1),
        );
    }
    for cylinder in &more.cylinders[1..] {
        assert_unchanged(
            &mut scene,
            ("cylinder", cylinder.index(), UnknownHandle),
            |it| it.set_cylinder(*cylinder, at, at, 1, 1),
        );
    }
    for disc in &more.discs[1..] {
        assert_unchanged(&mut scene, ("disc", disc.index(), UnknownHandle), |it| {
            it.set_disc(*disc, at, at, 1)
        });
    }
}

#[test]
fn wrong_numbers_change_nothing() {
    use ErrorKind::{Axis, Coordinate, Height, Normal, Radius, Tiny};
    let Built {
        mut scene,
        spheres,
        cylinders,
        discs,
        lights,
    } = START.built();
    let (scene, at, nan) = (&mut scene, [0, 0, 2], [0.0, f64::NAN, 2.0]);
    let (sphere, cylinder, disc) = (spheres[1], cylinders[1], discs[1]);
    assert_unchanged(scene, ("sphere", 1, Radius), |it| {
        it.set_sphere(sphere, at, 0)
    });
    assert_unchanged(scene, ("sphere", 1, Radius), |it| {
        it.set_sphere(sphere, at, -1)
    });
    assert_unchanged(scene, ("sphere", 1, Tiny), |it| {
        it.set_sphere(sphere, at, 1e-9)
    });
    assert_unchanged(scene, ("sphere", 1, Coordinate), |it| {
        it.set_sphere(sphere, nan, 1)
    });
    assert_unchanged(scene, ("sphere", 1, Coordinate), |it| {
        it.set_sphere(sphere, at, f64::NAN)
    });
    let far = [0.0, 0.0, 2e9];
    assert_unchanged(scene, ("sphere", 1, Coordinate), |it| {
        it.set_sphere(sphere, far, 1)
    });
    assert_unchanged(scene, ("cylinder", 1, Radius), |it| {
        it.set_cylinder(cylinder, at, at, 0, 1)
    });
    assert_unchanged(scene, ("cylinder", 1, Height), |it| {
        it.set_cylinder(cylinder, at, at, 1, 0)
    });
    assert_unchanged(scene, ("cylinder", 1, Axis), |it| {
        it.set_cylinder(cylinder, at, [0, 0, 0], 1, 1)
    });
    assert_unchanged(scene, ("disc", 1, Radius), |it| {
        it.set_disc(disc, at, at, 0)
    });
    assert_unchanged(scene, ("disc", 1, Normal), |it| {
        it.set_disc(disc, at, [0, 0, 0], 1)
    });
    assert_unchanged(scene, ("light", 1, Coordinate), |it| {
        it.set_light(lights[1], nan)
    });
    assert_unchanged(scene, ("light", 1, Coordinate), |it| {
        it.set_light(lights[1], far)
    });
    let mut scene = MovingScene::<Tower>::new();
    assert_unchanged(&mut scene, ("sphere", 0, Radius), |it| {
        it.set_sphere(Tower::BALL, at, 0)
    });
    assert_unchanged(&mut scene, ("disc", 0, Normal), |it| {
        it.set_disc(Tower::LID, at, [0, 0, 0], 1)
    });
}

/// What can be sent to another thread or core, and shared with it.
const fn assert_send_and_sync<T: Send + Sync>() {}

const _: () = {
    assert_send_and_sync::<PreparedFrame<Castle>>();
    assert_send_and_sync::<PreparedFrame<Tower, Exact, Phong>>();
    assert_send_and_sync::<PreparedFrame<Scene<Parts>, Fast, BlinnPhong>>();
    assert_send_and_sync::<PreparedFrame<MovingScene<Tower>>>();
    assert_send_and_sync::<Rows<'static, Mirror1>>();
    assert_send_and_sync::<Rows<'static, Scene<Parts>, Exact, Phong>>();
    assert_send_and_sync::<Rows<'static, MovingScene<Tower>>>();
    assert_send_and_sync::<FrameBuilder<'static, Scene<Parts>>>();
    assert_send_and_sync::<Handle<Sphere>>();
};
