//! Tests of the counting and of the random scenes, and that a small run loses nothing.

use clap::ValueEnum;
use embedded_graphics::geometry::Size;
use lost::case::{Case, Quality};
use lost::count::{Counts, VISIBLE, difference};
use lost::families::{Family, scene_of_run};
use lost::table::{HEAD, Summary, row};
use lost::truth::truth;
use lost::{file, on_all_cores};
use reflet::host::file::{SceneFile, built};
use reflet::host::reference::{Camera, Cylinder, Material, Scene, Shading, Sphere, pixel, render};

/// Least percentage of pixels that `Exact` has within 1, without shadows and highlights.
const BAR_PLAIN: f64 = 95.0;

const SEED: u64 = 1;
const SIZE: Size = Size::new(64, 48);

/// Returns the results of `check` for the first scenes of every family, in turns.
fn for_scenes<T: Send>(of_each: usize, check: impl Fn(Family, Case) -> T + Sync) -> Vec<T> {
    let families = Family::value_variants();
    on_all_cores(of_each * families.len(), |index| {
        let (family, case) = scene_of_run(families, SEED, index);
        check(family, case)
    })
}

/// Returns the largest percentages of lost pixels that are not apart, and that are.
fn worst(quality: Quality) -> [f64; 2] {
    let judged = for_scenes(10, |_, case| case.judge(SIZE, &[quality]).unwrap());
    let judged: Vec<_> = judged.iter().collect();
    println!("{HEAD}\n{}", row("all", quality, &judged));
    let percents: [fn(&Counts) -> f64; 2] = [Counts::lost, |it| it.percent(it.apart)];
    percents.map(|percent| Summary::of(&judged, quality, percent).worst)
}

#[test]
fn default_quality_loses_no_pixel_of_random_scenes() {
    assert_eq!(worst(Quality::Fast), [0.0; 2]);
}

#[test]
fn highlight_of_a_pixel_on_a_plane_is_not_lost_where_the_view_turns() {
    let case = Family::Glossy.case(SEED, 227);
    let judged = case.judge(Size::new(96, 72), &[Quality::Fast]).unwrap();
    assert_eq!(
        Summary::of(&[&judged], Quality::Fast, Counts::lost).worst,
        0.0
    );
}

/// Tests whether rays a 32nd of a pixel to each side have the colour of a pixel in double precision.
fn is_sure(case: &Case, index: usize) -> bool {
    let Size { width, height } = SIZE;
    let (x, y) = (index as u32 % width, index as u32 / width);
    let color = |size, at| {
        let n = case.reflections.into();
        let color = pixel(&case.scene, &case.camera, size, at, n, Shading::BlinnPhong);
        color.map(|it| (255.0 * it).round().clamp(0.0, 255.0) as u8)
    };
    let own = color((width, height), (x, y));
    // In a picture 16 times as large, these are the four pixels in the middle of this one.
    let mut beside = [(7, 7), (7, 8), (8, 7), (8, 8)].into_iter();
    beside.all(|(right, down)| {
        let at = (16 * x + right, 16 * y + down);
        difference(color((16 * width, 16 * height), at), own) <= VISIBLE
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
        let causes = judged.lost[0].causes.iter().enumerate();
        let lost = causes.filter(|(index, cause)| cause.is_some() && is_sure(&case, *index));
        (lost.count() > 0).then_some(case.name)
    });
    let losers: Vec<_> = losers.into_iter().flatten().collect();
    assert!(losers.is_empty(), "{losers:?}");
}

#[test]
fn quality_that_guesses_loses_pixels() {
    let [lost, _] = worst(Quality::Draft);
    assert!(lost > 1.0, "{lost} %");
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
fn truth_is_the_picture_of_the_reference() {
    for_scenes(10, |_, case| {
        let (scene, eye, n) = (&case.scene, &case.camera, u32::from(case.reflections));
        let expected = render(scene, eye, 32, 24, n, Shading::BlinnPhong);
        assert_eq!(truth(scene, eye, (32, 24), n).lit, expected.pixels);
    });
}

#[test]
fn exact_draws_what_truth_draws_without_shadows_and_highlights() {
    let shares = for_scenes(10, |_, case| {
        let right = case.plain_exact(SIZE).unwrap();
        assert!(right >= BAR_PLAIN, "{}: {right} %", case.name);
        right
    });
    let mean = shares.iter().sum::<f64>() / shares.len() as f64;
    assert!(mean > 99.0, "{mean}");
}

const CAMERA: Camera = Camera {
    position: [0.0, -5.0, 0.0],
    target: [0.0; 3],
    up: [0.0, 0.0, 1.0],
    fov: 40.0,
};

fn material(mirror: f64) -> Material {
    Material {
        color: [1.0, 0.5, 0.2],
        ambient: 1.0,
        diffuse: 0.0,
        specular: 0.0,
        shininess: 1.0,
        mirror,
        checker: None,
    }
}

fn scene(mirror: f64) -> Scene {
    Scene {
        materials: vec![material(mirror)],
        background: [0.1, 0.3, 0.6],
        ..Scene::default()
    }
}

#[test]
fn path_is_apart_if_it_goes_on_after_a_round_mirror() {
    let ball = |mirror| Scene {
        spheres: vec![Sphere {
            center: [0.0; 3],
            radius: 0.5,
            material: 0,
        }],
        ..scene(mirror)
    };
    let is_middle_apart = |mirror, reflections| {
        let picture = truth(&ball(mirror), &CAMERA, (9, 9), reflections);
        assert!(!picture.is_apart[0]);
        picture.is_apart[4 * 9 + 4]
    };
    assert!(is_middle_apart(0.5, 1));
    assert!(!is_middle_apart(0.5, 0));
    assert!(!is_middle_apart(0.0, 4));
}

#[test]
fn path_is_apart_from_the_second_flat_mirror_on() {
    let [front, back] = [1.0, -9.0].map(|y| reflet::host::reference::Plane {
        point: [0.0, y, 0.0],
        normal: [0.0, 1.0, 0.0],
        material: 0,
    });
    let one = Scene {
        planes: vec![front],
        ..scene(0.5)
    };
    let two = Scene {
        planes: vec![front, back],
        ..scene(0.5)
    };
    let is_apart = |scene: &Scene, reflections| {
        let picture = truth(scene, &CAMERA, (3, 3), reflections);
        picture.is_apart[4]
    };
    assert!(!is_apart(&one, 4));
    assert!(is_apart(&two, 2));
    assert!(!is_apart(&two, 1));
}

#[test]
fn rod_thinner_than_a_pixel_is_right_or_counted_as_seen() {
    let rod = Scene {
        cylinders: vec![Cylinder {
            center: [0.05, 0.0, 0.02],
            axis: [0.0, 0.9781, 0.2079],
            radius: 0.03,
            height: 6.0,
            material: 0,
        }],
        ..scene(0.0)
    };
    let case = Case {
        name: "rod".to_owned(),
        scene: rod,
        camera: CAMERA,
        reflections: 4,
    };
    // On a thread with a large stack: a scene with the room of a scene file is built on it.
    let judged = on_all_cores(1, |_| case.judge(Size::new(96, 96), &[Quality::Fast]));
    let judged = judged[0].as_ref().expect("the rod is accepted");
    let truth = render(&case.scene, &CAMERA, 96, 96, 4, Shading::BlinnPhong).pixels;
    for lost in &judged.lost {
        let counts = lost.counts;
        assert_eq!((counts.pixels, counts.light, counts.apart), (96 * 96, 0, 0));
        let pairs = lost.pixels.iter().zip(&truth);
        let wrong = pairs.filter(|(a, b)| difference(**a, **b) > 8);
        assert_eq!(counts.seen, wrong.count());
    }
}
