//! Tests of the culling switches. Switching off a technique that chooses candidates changes no bit of a
//! path; switching off one that replaces a computation changes few pixels.

use super::super::Mirror1;
use super::*;
use crate::accel::light_lists::LightLists;
use crate::accel::row_list::row_list;
use crate::accel::{HierarchyNode, Tables};
use crate::color::Sum;
use crate::qualities::{Culling, Quality};
use crate::ray::PathSignature;
use crate::scene::{Needs, Parts};

/// The quality [`Fast`] with light tables and the hierarchy switched on or off. No path is cut short.
struct With<const LIGHT_TABLES: bool, const HIERARCHY: bool = true>;

impl<const L: bool, const H: bool> Quality for With<L, H> {
    const SMALLEST_WEIGHT: Unit = Unit::DELTA;
    const TOLERANCE: Unit = Fast::TOLERANCE;
    const CULLING: Culling = Culling {
        light_tables: L,
        hierarchy: H,
        ..Culling::ALL
    };
}

/// The quality [`Fast`] with all culling switched off: the plain path. No path is cut short.
struct PlainPath;

impl Quality for PlainPath {
    const SMALLEST_WEIGHT: Unit = Unit::DELTA;
    const TOLERANCE: Unit = Fast::TOLERANCE;
    const CULLING: Culling = Culling::NONE;
}

/// The quality [`PlainPath`] with its lists of candidates.
struct Listed;

impl Quality for Listed {
    const SMALLEST_WEIGHT: Unit = Unit::DELTA;
    const TOLERANCE: Unit = Fast::TOLERANCE;
    const CULLING: Culling = Culling::LISTS;
}

/// Returns the sum and the signature of the path through each pixel. Camera rays test every shape.
fn traced<W: World, Q: Quality>(world: &W, camera: &Camera) -> std::vec::Vec<(Sum, PathSignature)> {
    let from = world.parts().grid.place(camera.description().position);
    traced_by::<W, Q>(world, camera, &LightVisibility::new(world, from))
}

/// Returns the sum and the signature of the path through each pixel, with the given visibility of the
/// lights. Camera rays test every shape.
fn traced_by<W: World, Q: Quality>(
    world: &W,
    camera: &Camera,
    view: &LightVisibility,
) -> std::vec::Vec<(Sum, PathSignature)> {
    let generator = camera.generator(SIZE.0, SIZE.1);
    let from = view.from;
    let rows = (0..SIZE.1).flat_map(|y| {
        let row = (from, generator.row_plane(y, from.point));
        let list = row_list::<_, Q>(world, from, &generator.row(y));
        let culling = ScreenCulling::new::<true>(None, row, y, true);
        let mut tracer = Tracer::<W, BlinnPhong, Q>::new(world, view, (culling, list), 5);
        let directions = generator.row(y);
        let pixels = (0..SIZE.0).map(|x| {
            let window = tracer.advance(x, x);
            let mut stops = Stops::NONE;
            let traced = tracer.trace(
                Pixel::Center(&window, x),
                (directions.of(x), None),
                (&mut stops, true),
            );
            (traced.sum, traced.signature)
        });
        pixels.collect::<std::vec::Vec<_>>()
    });
    rows.collect()
}

#[test]
fn paths_in_built_in_scenes_come_to_the_same_without_tables() {
    // A constant scene compiles the whole path anew. The run-time scenes below are all of one type.
    let world = &Static::<Castle>::new();
    let all = traced::<_, With<true>>(world, &Castle::CAMERA);
    assert!(traced::<_, With<false>>(world, &Castle::CAMERA) == all);
    const { assert!(<Static<Castle> as SceneAccess>::NEEDS.sets) };
    for name in NAMES {
        let (scene, camera) = at_run_time(name);
        let world = &scene.tabled();
        let all = traced::<_, With<true>>(world, &camera);
        assert!(traced::<_, With<false>>(world, &camera) == all, "{name}");
    }
}

/// A scene filled at run time with the lists of its lights that a constant scene would have.
struct WithLists<'a, W> {
    scene: &'a W,
    lights: [LightLists; 8],
}

impl<W: World> SceneAccess for WithLists<'_, W> {
    const NEEDS: Needs = W::NEEDS;

    fn parts(&self) -> Parts<'_> {
        self.scene.parts()
    }
}

impl<W: World> World for WithLists<'_, W> {
    type Room = W::Room;
    const IS_CROWD: bool = false;

    fn tables(&self) -> Tables<'_, Self::Room> {
        Tables {
            light_lists: &self.lights,
            ..self.scene.tables()
        }
    }
}

/// Returns a scene with the lists of its lights.
fn listed<W: World>(scene: &W) -> WithLists<'_, W> {
    assert!(scene.parts().lights.len() <= 8);
    WithLists {
        scene,
        lights: LightLists::of_lights(&scene.parts()),
    }
}

/// Asserts that the plain path comes to the same with its lists, seen from several sides.
fn compare_lists<W: World>(world: &W, first: &Camera, name: &str) {
    for (azimuth, elevation) in [(0, 0), (35, 10), (100, -20), (180, 5), (-75, -8)] {
        let Ok(camera) = first.orbited(azimuth, elevation) else {
            continue;
        };
        let plain = traced::<_, PlainPath>(world, &camera);
        assert!(traced::<_, Listed>(world, &camera) == plain, "{name}");
    }
}

#[test]
fn lists_change_no_bit_of_the_plain_path() {
    compare_lists(&Static::<Castle>::new(), &Castle::CAMERA, "castle");
    compare_lists(&Static::<Mirror1>::new(), &Mirror1::CAMERA, "mirror1");
    for name in NAMES {
        let (scene, camera) = at_run_time(name);
        compare_lists(&listed(&*scene), &camera, name);
    }
    let mut random = Sweep::new(0x3c6e_f372_fe94_f82b);
    for _ in 0..4 {
        let (many, few) = (crowd::<100, 40>(&mut random), crowd::<24, 8>(&mut random));
        // Every camera is among the shapes, or beside them.
        let position = random.place().map(|x| 2.5 * x);
        let camera = camera(&mut random, position);
        compare_lists(&listed(&many), &camera, "crowd");
        compare_lists(&listed(&few), &camera, "small crowd");
        let rim = about(&few, &mut random, 1.2, 3);
        let narrow = Camera::new(position, rim, [0.1, 0.2, 1.0], 0.6).unwrap();
        compare_lists(&listed(&few), &narrow, "rim");
        let wide = Camera::new(position, rim, [0.1, 0.2, 1.0], 179.0).unwrap();
        compare_lists(&listed(&few), &wide, "wide view");
    }
}

#[test]
fn paths_in_crowds_come_to_the_same_without_a_hierarchy() {
    let mut random = Sweep::new(0x510e_527f_ade6_82d1);
    for number in 0..8 {
        let scene = crowd::<24, 8>(&mut random);
        let mut memory = [HierarchyNode::NONE; 32];
        let tabled = scene.tabled().with_hierarchy(&mut memory);
        assert!(!tabled.tables().hierarchy.is_empty());
        // Every other camera is among the shapes.
        let distance = if number % 2 == 0 { 2.5 } else { 0.25 };
        let position = random.place().map(|x| distance * x);
        let camera = camera(&mut random, position);
        let with = traced::<_, With<true>>(&tabled, &camera);
        assert!(with == traced::<_, With<true, false>>(&tabled, &camera));
        assert!(with == traced::<_, With<true>>(&scene.tabled(), &camera));
    }
}

#[test]
fn paths_come_to_the_same_where_the_hierarchy_decides_all_shadows() {
    let mut random = Sweep::new(0x9b05_688c_2b3e_6c1f);
    for _ in 0..2 {
        let scene = crowd::<100, 40>(&mut random);
        let mut memory = [HierarchyNode::NONE; 256];
        let tabled = scene.tabled().with_hierarchy(&mut memory);
        assert!(!tabled.tables().hierarchy.is_empty());
        let position = random.place().map(|x| 2.5 * x);
        let camera = camera(&mut random, position);
        let with = traced::<_, With<true>>(&tabled, &camera);
        assert!(with == traced::<_, With<true, false>>(&tabled, &camera));
    }
}

/// Counts the pixels that differ by more than one level from the picture with all techniques: with the
/// plain shadow test, and on the plain path. The third number is the count of all pixels.
fn differing<W: World>(world: &W, camera: &Camera) -> [usize; 3] {
    let from = world.parts().grid.place(camera.description().position);
    let all = traced::<_, With<true>>(world, camera);
    let unclear = LightVisibility::unclear(from);
    let others = [
        traced_by::<_, With<true>>(world, camera, &unclear),
        traced_by::<_, PlainPath>(world, camera, &unclear),
    ];
    let [shadows, plain] = others.map(|other| {
        let pairs = all.iter().zip(&other);
        let levels = pairs.map(|(one, other)| [one.0, other.0].map(Sum::to_rgb8));
        let is_off = |[one, other]: &[[u8; 3]; 2]| (0..3).any(|it| one[it].abs_diff(other[it]) > 1);
        levels.filter(is_off).count()
    });
    [shadows, plain, all.len()]
}

#[test]
fn few_pixels_differ_from_those_of_the_plain_path() {
    let mut random = Sweep::new(0x1f83_d9ab_fb41_bd6b);
    let crowds = [(); 4].map(|()| {
        let scene = crowd::<24, 8>(&mut random);
        let position = random.place().map(|x| 2.5 * x);
        differing(&scene.tabled(), &camera(&mut random, position))
    });
    let built_in = NAMES.map(|name| {
        let (scene, first) = at_run_time(name);
        let around = [(0, 0), (35, 10), (100, -20), (-75, -8)].map(|(azimuth, elevation)| {
            let camera = first.orbited(azimuth, elevation);
            camera.map_or([0; 3], |camera| differing(&scene.tabled(), &camera))
        });
        [0, 1, 2].map(|it| around.iter().map(|counts| counts[it]).sum())
    });
    let sum =
        |of: &[[usize; 3]]| [0, 1, 2].map(|it| of.iter().map(|counts| counts[it]).sum::<usize>());
    for [shadows, plain, pixels] in [sum(&built_in), sum(&crowds)] {
        // Measured: no pixel of 56 320, and none of 5120. Sums differ in 3 and 9 % of the pixels, but by
        // less than a level.
        assert!(
            1000 * shadows.max(plain) <= pixels,
            "{shadows} {plain} of {pixels}"
        );
        assert!(pixels > 4000, "{pixels}");
    }
}
