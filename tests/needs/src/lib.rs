//! Tests that leaving out what a scene does not need changes nothing: pictures are the same as with
//! everything.

#![cfg(test)]

use std::cell::Cell;

use embedded_graphics::prelude::Size;
use proptest::prelude::*;
use proptest::test_runner::{RngSeed, TestRunner};
use reflet::__private::Everything;
use reflet::display::AnyScene;
use reflet::host::compare::compare;
use reflet::host::file::{FileScene, built};
use reflet::host::painted;
use reflet::host::reference::{self, Picture};
use reflet::needs::{Limited, Mirrors, MostReflections, Needs, NeedsLimit, Shininess};
use reflet::quality::{Exact, Fast, Quality, Small};
use reflet::scenes::{BuiltIn, Castle, Floor, Mirror1, NAMES, Primitives, Visitor, visit};
use reflet::shading::{BlinnPhong, Phong, Shading};
use reflet::{Camera, ErrorKind, FrameBuilder, Material, RuntimeScene, Scene, room};

/// Size of the built-in scenes' pictures in these tests.
const SIZE: Size = Size::new(80, 60);

/// Returns a built-in scene that is filled at run time, in a type with room for everything.
fn refilled<S: BuiltIn>() -> Box<FileScene> {
    let scene = S::with_description(|description| reference::Scene::from(&description));
    built(&scene, &reference::Camera::from(&S::CAMERA)).unwrap()
}

/// Compares a constant scene, of which only the needed parts are linked, with the same scene filled
/// at run time in a type that has room for everything.
fn assert_is_the_same_at_run_time<S: BuiltIn>() {
    let (fixed, filled, view) = (S::INSTANCE, &*refilled::<S>(), (&S::CAMERA, SIZE, 4));
    assert_alike::<Fast, BlinnPhong>(S::NAME, view, fixed, filled);
    assert_alike::<Exact, Phong>(S::NAME, view, fixed, filled);
    assert_alike::<Small, BlinnPhong>(S::NAME, view, fixed, filled);
    assert_alike::<Fast, BlinnPhong>(S::NAME, view, fixed, &Everything::of(fixed));
}

/// Compares the needs of a constant scene with those that are found at run time.
struct SameNeeds;

impl Visitor for SameNeeds {
    type Output = ();

    fn visit<S: BuiltIn>(self) {
        assert_eq!(Needs::of::<S>(), refilled::<S>().needs(), "{}", S::NAME);
    }
}

/// A camera, the size of a picture, and the number of reflections.
type View<'a> = (&'a Camera, Size, u8);

/// Compares the pictures of two scenes.
fn assert_alike<Q: Quality, K: Shading>(
    name: &str,
    view: View,
    fixed: &impl AnyScene,
    filled: &impl AnyScene,
) {
    let is_same = picture::<Q, K>(fixed, view) == picture::<Q, K>(filled, view);
    assert!(is_same, "{name}");
}

fn picture<Q: Quality, K: Shading>(scene: &impl AnyScene, view: View) -> Picture {
    let (camera, size, reflections) = view;
    let frame = FrameBuilder::new(scene, camera).reflections(reflections);
    let frame = frame.quality::<Q>().shading::<K>().prepare(size);
    painted(&frame.on(scene).unwrap())
}

#[test]
fn scene_in_flash_and_scene_filled_at_run_time_give_the_same_picture() {
    // Each scene is compiled eight times. xtask/tests/one_picture.rs has the others.
    assert_is_the_same_at_run_time::<Castle>();
    assert_is_the_same_at_run_time::<Floor>();
    assert_is_the_same_at_run_time::<Primitives>();
}

#[test]
fn scene_in_flash_and_scene_filled_at_run_time_have_the_same_needs() {
    for name in NAMES {
        visit(name, SameNeeds).unwrap();
    }
}

/// Compares a number of reflections known at compile time with the same number set at run time.
fn assert_known<S: BuiltIn, const N: u8>() {
    let (name, view) = (S::NAME, (&S::CAMERA, Size::new(64, 48), N));
    let known = Limited::<_, MostReflections<N>>::new(S::INSTANCE).unwrap();
    let what = |quality| format!("{name}, {N}, {quality}");
    assert_alike::<Fast, BlinnPhong>(&what("fast"), view, &known, S::INSTANCE);
    assert_alike::<Small, BlinnPhong>(&what("small"), view, &known, S::INSTANCE);
}

#[test]
fn reflections_may_be_known_when_the_program_is_compiled() {
    assert_known::<Castle, 0>();
    assert_known::<Castle, 3>();
    assert_known::<Mirror1, 1>();
}

/// A bound with the needs of the castle.
struct Like;

impl NeedsLimit for Like {
    const NEEDS: Needs = Needs::of::<Castle>();
}

/// A bound with the needs of a bare floor.
struct Bare;

impl NeedsLimit for Bare {
    const NEEDS: Needs = Needs::of::<Floor>();
}

#[test]
fn bounded_frame_gives_the_same_picture_or_names_what_is_too_much() {
    let castle = &*refilled::<Castle>();
    let limited = Limited::<_, Like>::new(castle).unwrap();
    let view = (&Castle::CAMERA, SIZE, 4);
    assert_alike::<Fast, BlinnPhong>("castle", view, castle, &limited);

    let floor = &*refilled::<Floor>();
    let limited = Limited::<_, Bare>::new(floor).unwrap();
    let view = (&Floor::CAMERA, SIZE, 4);
    assert_alike::<Fast, BlinnPhong>("floor", view, floor, &limited);
    assert_eq!(excess(castle), Some("spheres"));
    assert_eq!(excess(floor), None);
    let mut two_floors = Few::new();
    let glass = Material::new([0.5; 3]).mirror(0.5);
    let glass = two_floors.add_material(glass).unwrap();
    two_floors.add_plane([0, 0, -1], [0, 0, 1], glass).unwrap();
    two_floors.add_plane([0, 0, 1], [0, 0, 1], glass).unwrap();
    let excess = excess(&two_floors.build().unwrap());
    assert_eq!(excess, Some("mirrored"));
}

/// Returns the first need that a scene has and a bare floor has not, `None` if there is none.
fn excess(scene: &impl AnyScene) -> Option<&'static str> {
    let error = Limited::<_, Bare>::new(scene).err()?;
    assert_eq!((error.kind(), error.index()), (ErrorKind::Limit, None));
    Some(error.part())
}

#[test]
fn castle_and_mirrors_need_what_is_expected_of_them() {
    let castle = Needs::of::<Castle>();
    assert!(castle.spheres && castle.planes && castle.cylinders && castle.shadows);
    let found = (castle.shininess, castle.mirrors);
    assert_eq!(found, (Shininess::Even, Mirrors::Some));
    let mirror1 = Needs::of::<Mirror1>();
    assert!(mirror1.mirrored && mirror1.within(&Needs::ALL.without_planes()).is_err());
}

fn coefficient() -> impl Strategy<Value = f64> {
    prop_oneof![Just(0.0), 0.0..1.0]
}

prop_compose! {
    fn material()(
        grey in any::<bool>(),
        color in [0.0..1.0, 0.0..1.0, 0.0..1.0],
        rest in [coefficient(), coefficient(), coefficient()],
        shininess in prop_oneof![Just(4.0), Just(5.0), 0.5..30.0],
        mirror in prop_oneof![Just(0.0), Just(1.0), 0.0..1.0],
        checker in prop::option::weighted(0.3, coefficient()),
    ) -> Material {
        let color = if grey { [color[0]; 3] } else { color };
        let [ambient, diffuse, specular] = rest;
        let made = Material::from_numbers(color, ambient, diffuse, (specular, shininess), mirror);
        match checker {
            Some(shade) => made.unwrap().with_checker([shade; 3], [0.7, 0.0, 1.1]).unwrap(),
            None => made.unwrap(),
        }
    }
}

prop_compose! {
    fn point()(point in [-2.0..2.0, -2.0..2.0, -2.0..2.0]) -> [f64; 3] {
        point
    }
}

type Few = RuntimeScene<Little>;
type Little = room!(spheres: 2, planes: 2, cylinders: 1, discs: 2, lights: 2, materials: 2);

prop_compose! {
    /// Makes a scene with few shapes, so that each need is often missing.
    fn few()(
        materials in [material(), material()],
        one_material in any::<bool>(),
        spheres in prop::collection::vec(point(), 0..=2),
        planes in prop::collection::vec(point(), 0..=2),
        cylinders in prop::collection::vec(point(), 0..=1),
        discs in prop::collection::vec((point(), point()), 0..=2),
        lights in prop::collection::vec((point(), coefficient()), 0..=2),
        sky in prop::option::weighted(0.3, point()),
    ) -> Few {
        let mut scene = Few::new();
        let ids = materials.map(|it| scene.add_material(it).unwrap());
        let id = |index: usize| ids[if one_material { 0 } else { index % 2 }];
        for (index, at) in spheres.into_iter().enumerate() {
            scene.add_sphere(at, 0.7, id(index)).unwrap();
        }
        for (index, at) in planes.into_iter().enumerate() {
            // The planes are below and behind the shapes. The camera is always on the same side of
            // them.
            let point = [at[0], 3.0 + at[1].abs(), at[2] - 4.0];
            let normal = if index == 0 { [0.1, 0.2, 1.0] } else { [0.0, -1.0, 0.3] };
            scene.add_plane(point, normal, id(index + 1)).unwrap();
        }
        for at in cylinders {
            scene.add_cylinder(at, [0.3, 0.2, 1.0], 0.4, 1.5, id(1)).unwrap();
        }
        for (index, (at, normal)) in discs.into_iter().enumerate() {
            scene.add_disc(at, normal, 0.8, id(index)).unwrap();
        }
        for (at, green) in lights {
            scene.add_light(at.map(|it| 4.0 * it), [0.5, green, 0.5]).unwrap();
        }
        if let Some(up) = sky {
            scene.set_sky(up, [[0.5; 3], [0.75; 3], [1.0; 3]]).unwrap();
        }
        scene
    }
}

/// Bounds that each leave out one thing: number `I` of [`OFF`].
struct Off<const I: usize>;

const OFF: [Needs; 14] = [
    Needs::ALL.without_spheres(),
    Needs::ALL.without_planes(),
    Needs::ALL.without_cylinders(),
    Needs::ALL.without_lights(),
    Needs::ALL.without_highlights(),
    Needs::ALL.with_shininess(Shininess::Even),
    Needs::ALL.without_mirrors(),
    Needs::ALL.with_mirrors(Mirrors::All),
    Needs::ALL.without_colors(),
    Needs::ALL.without_discs(),
    Needs::ALL.without_triangles(),
    Needs::ALL.without_sky(),
    Needs::ALL.without_checkers(),
    Needs::ALL.without_ranges(),
];

impl<const I: usize> NeedsLimit for Off<I> {
    const NEEDS: Needs = OFF[I];
}

/// Tests whether a scene is within a bound. If so, checks that its pictures equal those without a
/// bound.
fn is_held<const I: usize>(scene: &Scene<Little>) -> bool {
    let Ok(bound) = Limited::<_, Off<I>>::new(scene) else {
        return false;
    };
    let view = (&FRONT, Size::new(24, 20), 4);
    let what = |name| format!("{name} of {:?}, bound {:?}", scene.needs(), OFF[I]);
    assert_alike::<Fast, BlinnPhong>(&what("fast"), view, &bound, scene);
    assert_alike::<Small, Phong>(&what("small"), view, &bound, scene);
    true
}

const FRONT: Camera = Camera::look_at([0.3, -6.0, 1.0], [0.0; 3], [0.0, 0.0, 1.0]);

/// Returns the settings of a test of so many random cases.
fn cases(count: u32, rng_seed: RngSeed) -> ProptestConfig {
    ProptestConfig {
        rng_seed,
        ..ProptestConfig::with_cases(count)
    }
}

#[test]
fn what_a_bound_leaves_out_is_missed_by_no_scene_within_it() {
    nothing_is_missed(cases(100, RngSeed::Fixed(1)));
}

#[test]
#[ignore = "long: more scenes, others in each run"]
fn what_a_bound_leaves_out_is_missed_by_none_of_many_more_scenes() {
    nothing_is_missed(cases(1000, RngSeed::Random));
}

fn nothing_is_missed(cases: ProptestConfig) {
    let least = cases.cases / 30;
    let mut runner = TestRunner::new(cases);
    let counts = [const { Cell::new(0) }; OFF.len()];
    let held = runner.run(&few(), |scene| {
        let Ok(scene) = scene.build() else {
            return Ok(());
        };
        let held = [
            is_held::<0>(&scene),
            is_held::<1>(&scene),
            is_held::<2>(&scene),
            is_held::<3>(&scene),
            is_held::<4>(&scene),
            is_held::<5>(&scene),
            is_held::<6>(&scene),
            is_held::<7>(&scene),
            is_held::<8>(&scene),
            is_held::<9>(&scene),
            is_held::<10>(&scene),
            is_held::<11>(&scene),
            is_held::<12>(&scene),
            is_held::<13>(&scene),
        ];
        for (count, held) in counts.iter().zip(held) {
            count.set(count.get() + u32::from(held));
        }
        Ok(())
    });
    held.unwrap();
    let counts = counts.map(|count| count.get());
    assert!(counts.iter().all(|count| *count >= least), "{counts:?}");
}

/// Paths off this plane, which is the first shape, hit nothing else; paths beside it hit nothing at
/// all. They must not be taken for equal paths.
#[test]
fn dark_plane_is_told_from_nothing() {
    let mut scene = Few::new();
    let blue = Material::new([0.0, 0.0, 0.4]).ambient(0.78).diffuse(0.0);
    let blue = scene.add_material(blue.mirror(0.983)).unwrap();
    let (point, normal) = ([0.0, 3.0, -4.0], [0.1, 0.2, 1.0]);
    scene.add_plane(point, normal, blue).unwrap();
    assert!(is_held::<0>(&scene.build().unwrap()));
}

/// A limit of a limit checks all that a scene needs.
#[test]
fn limit_within_a_limit_is_checked() {
    struct Plain;
    struct Matte;

    impl NeedsLimit for Plain {
        const NEEDS: Needs = Needs::ALL.without_checkers();
    }

    impl NeedsLimit for Matte {
        const NEEDS: Needs = Needs::ALL.without_mirrors();
    }

    let mirrors = &*refilled::<Mirror1>();
    let plain = Limited::<_, Plain>::new(mirrors).unwrap();
    let error = Limited::<_, Matte>::new(&plain).err().unwrap();
    assert_eq!((error.part(), error.kind()), ("mirrors", ErrorKind::Limit));
}

#[test]
fn reflections_beyond_a_bound_are_cut_off() {
    struct Once;

    impl NeedsLimit for Once {
        const NEEDS: Needs = Needs::ALL.with_reflections(1);
    }

    let mirrors = &*refilled::<Mirror1>();
    let view = |reflections| (&Mirror1::CAMERA, Size::new(64, 48), reflections);
    let once = picture::<Fast, BlinnPhong>(mirrors, view(1));
    let bound = Limited::<_, Once>::new(mirrors).unwrap();
    assert!(picture::<Fast, BlinnPhong>(&bound, view(4)) == once);
    let most = Limited::<_, MostReflections<1>>::new(&Mirror1).unwrap();
    assert!(picture::<Fast, BlinnPhong>(&most, view(4)) == once);
}

/// A ball between a light and a floor that is a million times as far away. The camera is as far
/// away, too.
#[test]
fn shadow_falls_on_what_is_far_from_what_throws_it() {
    let mut scene = Few::new();
    let chalk = Material::new([1.0; 3]).ambient(0.25).diffuse(0.5);
    let chalk = scene.add_material(chalk).unwrap();
    scene.add_sphere([0.0, 0.0, -0.75], 0.5, chalk).unwrap();
    let far_below = [0, 0, -1_000_000];
    scene.add_plane(far_below, [0, 0, 1], chalk).unwrap();
    scene.add_light([0.0, 0.0, 0.0], [1.0, 1.0, 1.0]).unwrap();
    let scene = scene.build().unwrap();
    let mut seen = Vec::new();
    // Below the ball, and far to the side of its shadow.
    for x in [0.0, 4e6] {
        let camera = Camera::look_at([x, -2e5, -6e5], [x, 0.0, -1e6], [0.0, 0.0, 1.0]);
        let camera = camera.fov(20.0);
        let view = (&camera, Size::new(16, 16), 4);
        let fast = picture::<Fast, BlinnPhong>(&scene, view).pixels[8 * 16 + 8];
        let small = picture::<Small, BlinnPhong>(&scene, view).pixels[8 * 16 + 8];
        assert_eq!(fast, small, "x = {x}");
        seen.push(fast[0]);
    }
    assert!(seen[0] == 64 && seen[1] > 70, "{seen:?}");
}

proptest! {
    #![proptest_config(cases(400, RngSeed::Fixed(1)))]

    /// `Small` traces rays in the general way. Except for a few pixels at edges, where rounding
    /// decides, no channel differs by more than 1 from the quality with culling.
    #[test]
    fn small_code_shows_what_fast_code_shows(scene in few()) {
        let Ok(scene) = scene.build() else { return Ok(()) };
        let view = (&FRONT, Size::new(40, 32), 4);
        let exact = picture::<Exact, BlinnPhong>(&scene, view);
        let small = picture::<Small, BlinnPhong>(&scene, view);
        let off = (1.0 - compare(&exact, &small).unwrap().within1) * (40.0 * 32.0);
        prop_assert!(off.round() <= 4.0, "{off} pixels");
    }
}
