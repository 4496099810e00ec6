//! Tests of the counting and of the random scenes, and that a small run loses nothing.

use command_line::Quality;
use embedded_graphics::geometry::Size;
use lost::case::{Case, VISIBLE, difference};
use lost::families::{Family, scene_of_run};
use lost::table::{HEAD, Summary, row};
use lost::{file, on_all_cores};
use reflet::host::file::{SceneFile, built};

/// Least percentage of pixels that `Exact` has within 1.
const BAR: f64 = 95.0;

const SEED: u64 = 1;
const SIZE: Size = Size::new(64, 48);

/// Returns the results of `check` for the first scenes of every family, in turns.
fn for_scenes<T: Send>(of_each: usize, check: impl Fn(Family, Case) -> T + Sync) -> Vec<T> {
    let families = &Family::ALL;
    on_all_cores(of_each * families.len(), |index| {
        let (family, case) = scene_of_run(families, SEED, index);
        check(family, case)
    })
}

#[test]
fn default_quality_loses_no_pixel_of_random_scenes() {
    let judged = for_scenes(10, |_, case| case.judge(SIZE, &[Quality::Fast]).unwrap());
    let judged: Vec<_> = judged.iter().collect();
    println!("{HEAD}\n{}", row("all", Quality::Fast, &judged));
    assert_eq!(Summary::of(&judged, Quality::Fast).worst, 0.0);
}

/// A highlight of a pixel where the view turns, highlights where light and view are almost opposite, steps at which a
/// highlight of a low power begins, a plane before the inside of a cylinder, and a ball that sticks out of a floor behind
/// two mirrors.
#[test]
fn pixels_that_were_lost_once_are_not() {
    for (family, seed, number) in [
        (Family::Glossy, 1, 227),
        (Family::Glossy, 77001, 126),
        (Family::Glossy, 77001, 884),
        (Family::Any, 5, 292),
        (Family::Any, 7, 5191),
        (Family::Sunk, 4242, 2684),
        (Family::Mirrors, 4242, 1660),
    ] {
        let case = family.case(seed, number);
        let judged = case.judge(Size::new(96, 72), &[Quality::Fast]).unwrap();
        assert_eq!(judged.lost[0].count(), 0, "{}", case.name);
    }
}

/// Tests whether rays a 32nd of a pixel to each side have the colour of a pixel in double precision.
fn is_sure(case: &Case, index: usize) -> bool {
    let (x, y) = (index as u32 % SIZE.width, index as u32 / SIZE.width);
    let own = case.true_pixel(SIZE, (x, y));
    // In a picture 16 times as large, these are the four pixels in the middle of this one.
    let mut beside = [(7, 7), (7, 8), (8, 7), (8, 8)].into_iter();
    beside.all(|(right, down)| {
        let at = (16 * x + right, 16 * y + down);
        difference(case.true_pixel(SIZE * 16, at), own) <= VISIBLE
    })
}

/// `Exact` decides shadows by tangents. `Small` tests every shape.
#[test]
fn exact_loses_no_pixel_where_shapes_touch() {
    let losers = on_all_cores(200, |number| {
        let mut case = Family::Touching.case(SEED, number as u64);
        // Rays start far above the surfaces that touch, as far as a small shape is wide, or hardly.
        case.scene.epsilon = [1e-2, 1e-3, 1e-4, 1e-9][number % 4];
        let judged = case.judge(SIZE, &[Quality::Exact]).unwrap();
        let pixels = judged.lost[0].is_lost.iter().enumerate();
        let lost = pixels.filter(|(index, is_lost)| **is_lost && is_sure(&case, *index));
        (lost.count() > 0).then_some(case.name)
    });
    let losers: Vec<_> = losers.into_iter().flatten().collect();
    assert!(losers.is_empty(), "{losers:?}");
}

#[test]
fn every_random_scene_is_accepted() {
    for_scenes(200, |_, case| {
        let error = built(&case.scene, &case.camera).err();
        assert!(error.is_none(), "{}: {error:?}", case.name);
    });
}

#[test]
fn random_scene_is_the_same_each_time_and_from_its_file() {
    for_scenes(10, |family, case| {
        let number = case.name.split('-').nth(2).unwrap().parse().unwrap();
        assert_eq!(family.case(SEED, number), case);
        assert_ne!(family.case(SEED + 1, number).scene, case.scene);
        let file = SceneFile::parse(&file::json(&case), None).unwrap();
        assert_eq!(file.name(), Some(case.name.as_str()));
        assert_eq!(file.reference(), (case.scene, case.camera));
    });
}

#[test]
fn exact_draws_random_scenes_as_the_reference_does() {
    let shares = for_scenes(10, |_, case| {
        let right = case.judge(SIZE, &[]).unwrap().exact;
        assert!(right >= BAR, "{}: {right} %", case.name);
        right
    });
    let mean = shares.iter().sum::<f64>() / shares.len() as f64;
    assert!(mean > 99.0, "{mean}");
}
