//! Tests parts that move: their pictures are those of a scene that is built with the parts in their new
//! places, errors change nothing, and a prepared frame refuses a scene that has changed.

use embedded_graphics::prelude::Size;
use reflet::description::{self, Description};
use reflet::display::AnyScene;
use reflet::host::file::FileScene;
use reflet::host::reference::{self, Picture};
use reflet::quality::{Exact, Fast};
use reflet::scenes::{Castle, Mirror1};
use reflet::shading::{BlinnPhong, Phong};
use reflet::{
    Camera, Error, ErrorKind, FrameBuilder, Handle, Material, MovingScene, PreparedFrame, Rows,
    Scene, SceneBuilder, room, scene,
};

use super::near::{Scenery, UP, apart, drawn};
use Move::{Cylinder, Disc, Light, Sphere};

const GOLD: Material = Material::new([0.7, 0.6, 0.0])
    .specular(0.8, 4.0)
    .mirror(0.4);
const GLASS: Material = Material::new([0.9; 3]).diffuse(0.2).mirror(0.8);
const CHALK: Material = Material::new([0.9, 0.9, 0.8]);
const WATER: Material = Material::new([0.3, 0.4, 0.6]).mirror(0.3);

const LOW: [f64; 3] = [-4.0, -4.0, -0.5];
const HIGH: [f64; 3] = [4.0, 4.0, 5.0];
/// A place in the middle of the motion box.
const AT: [f64; 3] = [0.0, 0.0, 2.0];
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

/// A new place and size of a part, which is named by its number among those of its kind.
#[derive(Clone, Copy)]
enum Move {
    Sphere(usize, [f64; 3], f64),
    /// Number, centre, axis, radius and height.
    Cylinder(usize, [f64; 3], [f64; 3], f64, f64),
    /// Number, centre, normal and radius.
    Disc(usize, [f64; 3], [f64; 3], f64),
    Light(usize, [f64; 3]),
}

impl Move {
    /// Returns the kind of the part, as errors name it, and its number.
    fn part(self) -> (&'static str, usize) {
        match self {
            Sphere(index, ..) => ("sphere", index),
            Cylinder(index, ..) => ("cylinder", index),
            Disc(index, ..) => ("disc", index),
            Light(index, _) => ("light", index),
        }
    }
}

/// The parts of a scene at their first places, and the materials.
struct Places {
    parts: reference::Scene,
    materials: Vec<Material>,
}

/// Handles of the parts of a scene that may move.
struct Handles {
    spheres: Vec<Handle<description::Sphere>>,
    cylinders: Vec<Handle<description::Cylinder>>,
    discs: Vec<Handle<description::Disc>>,
    lights: Vec<Handle<description::Light>>,
}

/// A built scene and the handles of its parts.
struct Built {
    scene: FileScene,
    handles: Handles,
}

impl Places {
    fn of(described: Description<'_>) -> Self {
        Self {
            parts: (&described).into(),
            materials: described.materials.to_vec(),
        }
    }

    /// Places of all parts of the scene [`Tower`] before anything moves.
    fn start() -> Self {
        Tower::with_description(Self::of)
    }

    fn take(&mut self, moved: Move) {
        match moved {
            Sphere(index, center, radius) => {
                let it = &mut self.parts.spheres[index];
                (it.center, it.radius) = (center, radius);
            }
            Cylinder(index, center, axis, radius, height) => {
                let it = &mut self.parts.cylinders[index];
                (it.center, it.axis, it.radius, it.height) = (center, axis, radius, height);
            }
            Disc(index, center, normal, radius) => {
                let it = &mut self.parts.discs[index];
                (it.center, it.normal, it.radius) = (center, normal, radius);
            }
            Light(index, position) => self.parts.lights[index].position = position,
        }
    }

    fn built(&self) -> Built {
        self.built_in(Some([LOW, HIGH]))
    }

    /// Builds the scene with a motion box, or without one.
    fn built_in(&self, motion: Option<[[f64; 3]; 2]>) -> Built {
        let mut scene = Scenery::new();
        if let Some([low, high]) = motion {
            scene.set_motion(low, high).unwrap();
        }
        let ids = self.materials.iter();
        let ids: Vec<_> = ids.map(|it| scene.add_material(*it).unwrap()).collect();
        let parts = &self.parts;
        for it in &parts.planes {
            let id = ids[it.material];
            scene.add_plane(it.point, it.normal, id).unwrap();
        }
        let spheres = parts.spheres.iter().map(|it| {
            let id = ids[it.material];
            scene.add_sphere(it.center, it.radius, id).unwrap()
        });
        let spheres = spheres.collect();
        let cylinders = parts.cylinders.iter().map(|it| {
            let id = ids[it.material];
            let added = scene.add_cylinder(it.center, it.axis, it.radius, it.height, id);
            added.unwrap()
        });
        let cylinders = cylinders.collect();
        let discs = parts.discs.iter().map(|it| {
            let id = ids[it.material];
            scene.add_disc(it.center, it.normal, it.radius, id).unwrap()
        });
        let discs = discs.collect();
        let lights = parts.lights.iter();
        let lights = lights.map(|it| scene.add_light(it.position, it.color).unwrap());
        let handles = Handles {
            spheres,
            cylinders,
            discs,
            lights: lights.collect(),
        };
        scene.set_background(parts.background).unwrap();
        scene.set_camera(CAMERA);
        let scene = scene.build().unwrap();
        Built { scene, handles }
    }
}

impl Handles {
    /// Returns the handles of the parts of [`Tower`] that have a name.
    fn of_tower() -> Self {
        Self {
            spheres: vec![Tower::BALL, Tower::MARBLE],
            cylinders: vec![Tower::LOG],
            discs: vec![Tower::LID],
            lights: Vec::new(),
        }
    }
}

/// A scene in which parts move.
trait Moving: AnyScene {
    fn take(&mut self, handles: &Handles, moved: Move) -> Result<(), Error>;
}

macro_rules! moving {
    ($scene:ty, $set_light:expr) => {
        impl Moving for $scene {
            fn take(&mut self, handles: &Handles, moved: Move) -> Result<(), Error> {
                match moved {
                    Sphere(it, center, radius) => {
                        self.set_sphere(handles.spheres[it], center, radius)
                    }
                    Cylinder(it, center, axis, radius, height) => {
                        self.set_cylinder(handles.cylinders[it], center, axis, radius, height)
                    }
                    Disc(it, center, normal, radius) => {
                        self.set_disc(handles.discs[it], center, normal, radius)
                    }
                    Light(it, position) => $set_light(self, handles.lights[it], position),
                }
            }
        }
    };
}
moving!(FileScene, FileScene::set_light);
// It has no lights that move.
moving!(MovingScene<Tower>, |_: &mut _, _, _| unreachable!());

/// Draws a scene in the qualities `Fast` and `Exact`.
fn pictures<S: AnyScene>(scene: &S, camera: &Camera) -> [Picture; 2] {
    let size = Size::new(48, 40);
    [
        drawn::<Fast, BlinnPhong>(scene, camera, size),
        drawn::<Exact, BlinnPhong>(scene, camera, size),
    ]
}

/// Random numbers that are the same in every run: xorshift, 64 bits.
pub(crate) struct Random(pub(crate) u64);

impl Random {
    pub(crate) fn below(&mut self, end: u32) -> u32 {
        self.0 ^= self.0 << 13;
        self.0 ^= self.0 >> 7;
        self.0 ^= self.0 << 17;
        (self.0 >> 32) as u32 % end
    }

    pub(crate) fn within(&mut self, low: f64, high: f64) -> f64 {
        low + (high - low) * f64::from(self.below(1 << 20)) / f64::from(1 << 20)
    }

    /// Returns a point of the motion box that is not nearer to its sides than `margin`.
    fn place(&mut self, margin: f64) -> [f64; 3] {
        [0, 1, 2].map(|axis| self.within(LOW[axis] + margin, HIGH[axis] - margin))
    }

    /// Returns a direction of any length but 0.
    pub(crate) fn direction(&mut self) -> [f64; 3] {
        [
            self.within(-1.0, 1.0),
            self.within(-1.0, 1.0),
            0.125 + self.within(0.0, 1.0),
        ]
    }

    fn sphere(&mut self, index: usize) -> Move {
        let radius = self.within(0.25, 1.0);
        Sphere(index, self.place(radius), radius)
    }

    /// Returns a move of one of the parts to which there are handles.
    fn moved(&mut self, handles: &Handles) -> Move {
        let counts = [
            handles.spheres.len(),
            handles.cylinders.len(),
            handles.discs.len(),
            handles.lights.len(),
        ];
        let kinds = counts.iter().filter(|count| **count > 0).count();
        let kind = self.below(kinds as u32) as usize;
        let index = self.below(counts[kind] as u32) as usize;
        match kind {
            0 => self.sphere(index),
            1 => {
                let (radius, height) = (self.within(0.25, 0.75), self.within(0.5, 2.5));
                // A scene that is built anew takes a cylinder to reach that far.
                let around = radius + height / 2.0;
                Cylinder(index, self.place(around), self.direction(), radius, height)
            }
            2 => {
                let radius = self.within(0.25, 1.0);
                Disc(index, self.place(radius), self.direction(), radius)
            }
            _ => Light(index, self.place(0.0)),
        }
    }

    fn camera(&mut self) -> Camera {
        let (azimuth, elevation) = (self.below(360) as i32, self.within(-10.0, 40.0));
        CAMERA.orbited(azimuth, elevation).unwrap()
    }
}

/// Fails unless a changed scene is drawn as the scene that is built with the parts in their new places.
#[track_caller]
fn assert_drawn_as_built<S: AnyScene>(scene: &S, places: &Places, camera: &Camera, step: u32) {
    let expected = pictures(&places.built().scene, camera);
    let found = pictures(scene, camera);
    // Tables of lights choose which pixels `Fast` interpolates, but all are exact to its tolerance.
    let names = [("fast", 1), ("exact", 0)];
    for ((name, most), (found, expected)) in names.into_iter().zip(found.iter().zip(&expected)) {
        assert_eq!(apart(found, expected, most), 0, "{name}, step {step}");
    }
}

#[test]
fn scene_whose_parts_have_moved_is_drawn_as_one_that_is_built_there() {
    filled_scene_is_drawn_as_built(&[0x5eed]);
}

#[test]
fn constant_scene_whose_parts_have_moved_is_drawn_as_one_that_is_built_there() {
    constant_scene_is_drawn_as_built(&[0x5eed]);
}

#[test]
#[ignore = "long: more moves"]
fn parts_that_have_moved_in_more_ways_are_drawn_as_if_built_there() {
    filled_scene_is_drawn_as_built(&[0xba11, 0x1097]);
    constant_scene_is_drawn_as_built(&[0xba11, 0x1097]);
}

fn filled_scene_is_drawn_as_built(seeds: &[u64]) {
    for &seed in seeds {
        let (mut random, mut places) = (Random(seed), Places::start());
        let Built { mut scene, handles } = places.built();
        for step in 0..60 {
            let moved = random.moved(&handles);
            places.take(moved);
            scene.take(&handles, moved).unwrap();
            let camera = random.camera();
            assert_drawn_as_built(&scene, &places, &camera, step);
            assert_drawn_as_built(&scene.tabled(), &places, &camera, step);
        }
    }
}

#[test]
fn constant_scene_is_drawn_the_same_in_flash_in_ram_and_built_at_run_time() {
    let built = Places::start().built();
    for camera in [CAMERA, CAMERA.orbited(100, 10).unwrap()] {
        let expected = pictures(&built.scene, &camera);
        assert!(pictures(&Tower, &camera) == expected);
        assert!(pictures(&MovingScene::<Tower>::new(), &camera) == expected);
        let colors: std::collections::BTreeSet<_> = expected[1].pixels.iter().collect();
        assert!(colors.len() > 300, "{} colours", colors.len());
    }
}

fn constant_scene_is_drawn_as_built(seeds: &[u64]) {
    let handles = Handles::of_tower();
    for &seed in seeds {
        let (mut random, mut places) = (Random(seed), Places::start());
        let (mut scene, mut filled) = (MovingScene::<Tower>::new(), places.built().scene);
        for step in 0..60 {
            let moved = random.moved(&handles);
            places.take(moved);
            scene.take(&handles, moved).unwrap();
            filled.take(&handles, moved).unwrap();
            let camera = random.camera();
            assert_drawn_as_built(&scene, &places, &camera, step);
            assert_drawn_as_built(&filled, &places, &camera, step);
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

/// The scene that is built at run time has no hierarchy.
#[test]
fn mirror_that_moves_among_many_is_drawn_as_one_that_is_built_there() {
    let (mut random, mut places) = (Random(0x5a4), Swarm::with_description(Places::of));
    let mut scene = MovingScene::<Swarm>::new();
    for step in 0..40 {
        let moved = random.sphere(0);
        places.take(moved);
        let Sphere(_, center, radius) = moved else {
            unreachable!()
        };
        scene.set_sphere(Swarm::BALL, center, radius).unwrap();
        assert_drawn_as_built(&scene, &places, &random.camera(), step);
    }
}

#[test]
fn handle_of_a_constant_scene_counts_parts_of_its_kind() {
    assert_eq!((Tower::BALL.index(), Tower::MARBLE.index()), (0, 1));
    assert_eq!((Tower::LOG.index(), Tower::LID.index()), (0, 0));
    let handles = Places::start().built().handles;
    let found = (handles.spheres[1], handles.discs[0]);
    assert_eq!(found, (Tower::MARBLE, Tower::LID));
}

#[track_caller]
fn assert_refused<S: AnyScene>(frame: &PreparedFrame<S>, scene: &S) {
    let error = frame.on(scene).err().expect("the scene is refused");
    let found = (error.part(), error.index(), error.kind());
    assert_eq!(found, ("scene", None, ErrorKind::Changed));
}

#[test]
fn prepared_frame_refuses_a_scene_that_has_changed() {
    let Built { mut scene, handles } = Places::start().built();
    let frame = |scene: &FileScene| scene.frame(&CAMERA).prepare(Size::new(9, 9));
    for moved in [
        Sphere(2, [0.5, 0.5, 2.5], 0.5),
        Cylinder(1, AT, [0.0, 1.0, 1.0], 0.5, 1.0),
        Disc(1, [0.5, 0.5, 2.5], UP, 0.5),
        Light(1, [0.5, 0.5, 2.5]),
    ] {
        let before = frame(&scene);
        assert!(before.on(&scene).is_ok());
        scene.take(&handles, moved).unwrap();
        assert_refused(&before, &scene);
        assert!(frame(&scene).on(&scene).is_ok());
    }
    let mut scene = MovingScene::<Tower>::new();
    let before = scene.frame(&CAMERA).prepare(Size::new(9, 9));
    scene.set_disc(Tower::LID, AT, UP, 1).unwrap();
    assert_refused(&before, &scene);
}

#[test]
fn prepared_frame_refuses_another_scene_of_the_same_type() {
    let mut places = Places::start();
    let (one, again) = (places.built().scene, places.built().scene);
    let boxless = places.built_in(None).scene;
    places.parts.spheres[4].radius = 0.5;
    let frame = one.frame(&CAMERA).prepare(Size::new(9, 9));
    assert_refused(&frame, &places.built().scene);
    assert_refused(&frame, &boxless);
    // A copy, and a scene that is described in the same way, are the same scene.
    let copy = one;
    assert!(frame.on(&copy).is_ok() && frame.on(&again).is_ok());
    let tabled = one.tabled();
    let frame = tabled.frame(&CAMERA).prepare(Size::new(9, 9));
    assert_refused(&frame, &places.built().scene.tabled());
}

#[test]
fn prepared_frame_refuses_a_copy_that_has_changed_in_another_way() {
    let Built { scene, handles } = Places::start().built();
    let [mut one, mut other, mut lit] = [scene; 3];
    let here = Sphere(0, [1.0, 0.0, 1.0], 0.5);
    let there = Sphere(0, [0.0, 1.0, 1.0], 0.5);
    one.take(&handles, here).unwrap();
    other.take(&handles, there).unwrap();
    let frame = one.frame(&CAMERA).prepare(Size::new(9, 9));
    assert_refused(&frame, &other);

    lit.take(&handles, Light(0, [0.0, 1.0, 1.0])).unwrap();
    assert_refused(&frame, &lit);

    let [mut one, mut other] = [MovingScene::<Tower>::new(), MovingScene::new()];
    one.take(&handles, here).unwrap();
    other.take(&handles, there).unwrap();
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

/// Fails unless a move is refused with this error, and the scene is as it was.
#[track_caller]
fn assert_stays(scene: &mut impl Moving, handles: &Handles, kind: ErrorKind, moved: Move) {
    let before = pictures(scene, &CAMERA);
    let frame = FrameBuilder::new(scene, &CAMERA).prepare(Size::new(9, 9));
    let error = scene.take(handles, moved);
    let error = error.expect_err("the change is refused");
    let (part, index) = moved.part();
    let found = (error.part(), error.index(), error.kind());
    assert_eq!(found, (part, Some(index), kind));
    assert!(pictures(scene, &CAMERA) == before);
    let is_same = frame.on(scene).is_ok();
    assert!(is_same, "a scene that is as it was is the same scene");
}

#[test]
fn part_that_would_leave_the_motion_box_stays() {
    let Built { mut scene, handles } = Places::start().built();
    let mut stays = |moved| assert_stays(&mut scene, &handles, ErrorKind::Motion, moved);
    // Less than a hundredth out, on each side.
    for axis in 0..3 {
        for (side, sign) in [(LOW, -1.0), (HIGH, 1.0)] {
            let mut at = AT;
            at[axis] = side[axis] - sign * 0.99;
            stays(Sphere(3, at, 1.0));
            stays(Disc(2, at, UP, 1.0));
            at[axis] = side[axis] - sign * 1.4;
            stays(Cylinder(1, at, UP, 1.0, 2.0));
            // The box itself is large enough.
            at[axis] = side[axis] - sign;
            for moved in [Sphere(3, at, 1.0), Disc(2, at, UP, 1.0)] {
                let mut scene = Places::start().built().scene;
                scene.take(&handles, moved).unwrap();
            }
        }
    }
    for power in [4, 10, 14, 20, 25, 28, 29, 30] {
        let (at, most) = (2f64.powi(power), 2f64.powi(power - 1));
        stays(Sphere(3, [at, 0.0, 0.0], 1.0));
        stays(Sphere(3, [0.0, -at, 0.0], most));
        stays(Sphere(3, [0.0; 3], most));
    }
    let (mut scene, handles) = (MovingScene::<Tower>::new(), Handles::of_tower());
    let mut stays = |moved| assert_stays(&mut scene, &handles, ErrorKind::Motion, moved);
    stays(Sphere(1, [0.0, 0.0, 6.0], 1.0));
    stays(Cylinder(0, [0.0, 0.0, 4.0], UP, 1.0, 2.0));
    stays(Disc(0, [0.0, 0.0, 0.25], UP, 1.0));
}

#[test]
fn part_of_a_scene_without_a_motion_box_stays() {
    let Built { mut scene, handles } = Places::start().built_in(None);
    let mut stays = |moved| assert_stays(&mut scene, &handles, ErrorKind::Motion, moved);
    stays(Sphere(0, AT, 1.0));
    stays(Disc(0, AT, AT, 1.0));
    stays(Cylinder(0, AT, AT, 1.0, 1.0));
    // A light needs no box.
    scene.take(&handles, Light(0, AT)).unwrap();
}

#[test]
fn handle_of_another_scene_is_refused() {
    let more = Places::start().built().handles;
    let mut scene = Scenery::new();
    scene.set_motion(LOW, HIGH).unwrap();
    let chalk = scene.add_material(CHALK).unwrap();
    scene.add_sphere([0, 0, 1], 1, chalk).unwrap();
    scene.add_light([2, -2, 4], [1, 1, 1]).unwrap();
    let mut scene = scene.build().unwrap();
    let mut stays = |moved| assert_stays(&mut scene, &more, ErrorKind::UnknownHandle, moved);
    stays(Sphere(1, AT, 1.0));
    stays(Cylinder(0, AT, AT, 1.0, 1.0));
    stays(Disc(2, AT, AT, 1.0));
    stays(Light(1, AT));

    // Parts of a constant scene that have no name do not move.
    let mut scene = MovingScene::<Tower>::new();
    let mut stays = |moved| assert_stays(&mut scene, &more, ErrorKind::UnknownHandle, moved);
    (2..5).for_each(|it| stays(Sphere(it, AT, 1.0)));
    (1..3).for_each(|it| stays(Cylinder(it, AT, AT, 1.0, 1.0)));
    (1..3).for_each(|it| stays(Disc(it, AT, AT, 1.0)));
}

#[test]
fn wrong_numbers_change_nothing() {
    use ErrorKind::{Axis, Coordinate, Height, Normal, Radius, Tiny};
    let Built { mut scene, handles } = Places::start().built();
    let (far, nan) = ([0.0, 0.0, 2e9], [0.0, f64::NAN, 2.0]);
    let mut stays = |kind, moved| assert_stays(&mut scene, &handles, kind, moved);
    stays(Radius, Sphere(1, AT, 0.0));
    stays(Radius, Sphere(1, AT, -1.0));
    stays(Tiny, Sphere(1, AT, 1e-9));
    stays(Coordinate, Sphere(1, nan, 1.0));
    stays(Coordinate, Sphere(1, AT, f64::NAN));
    stays(Coordinate, Sphere(1, far, 1.0));
    stays(Radius, Cylinder(1, AT, AT, 0.0, 1.0));
    stays(Height, Cylinder(1, AT, AT, 1.0, 0.0));
    stays(Axis, Cylinder(1, AT, [0.0; 3], 1.0, 1.0));
    stays(Radius, Disc(1, AT, AT, 0.0));
    stays(Normal, Disc(1, AT, [0.0; 3], 1.0));
    stays(Coordinate, Light(1, nan));
    stays(Coordinate, Light(1, far));
    let (mut scene, handles) = (MovingScene::<Tower>::new(), Handles::of_tower());
    let mut stays = |kind, moved| assert_stays(&mut scene, &handles, kind, moved);
    stays(Radius, Sphere(0, AT, 0.0));
    stays(Normal, Disc(0, AT, [0.0; 3], 1.0));
}

/// What can be sent to another thread or core, and shared with it.
const fn assert_send_and_sync<T: Send + Sync>() {}

const _: () = {
    assert_send_and_sync::<PreparedFrame<Castle>>();
    assert_send_and_sync::<PreparedFrame<Tower, Exact, Phong>>();
    assert_send_and_sync::<PreparedFrame<FileScene, Fast, BlinnPhong>>();
    assert_send_and_sync::<PreparedFrame<MovingScene<Tower>>>();
    assert_send_and_sync::<Rows<'static, Mirror1>>();
    assert_send_and_sync::<Rows<'static, FileScene, Exact, Phong>>();
    assert_send_and_sync::<Rows<'static, MovingScene<Tower>>>();
    assert_send_and_sync::<FrameBuilder<'static, FileScene>>();
    assert_send_and_sync::<Handle<description::Sphere>>();
};
