//! Tests of the counting and of the random scenes, and that a small run loses nothing.

use embedded_graphics::geometry::Size;
use lost::case::{Case, Quality};
use lost::families::{Family, scene_of_run};
use lost::file;
use lost::parallel::in_order;
use lost::table::FamilyTable;
use lost::truth::truth;
use reflet::host::file::{SceneFile, built};
use reflet::host::reference::{Camera, Cylinder, Material, Scene, Shading, Sphere, render};

/// Least percentage of pixels that `Exact` has within 1, without shadows and highlights.
const BAR_PLAIN: f64 = 95.0;

const SEED: u64 = 1;
const SCENES: usize = 10 * Family::ALL.len();
const SIZE: Size = Size::new(64, 48);

/// Calls `check` with the first scenes of every family.
fn for_scenes<T: Send>(check: impl Fn(Family, Case) -> T + Sync, done: impl FnMut(T)) {
    let run = |index| {
        let (family, case) = scene_of_run(&Family::ALL, SEED, index);
        check(family, case)
    };
    in_order(SCENES, run, done);
}

#[test]
fn no_quality_loses_a_pixel_of_random_scenes() {
    let mut table = FamilyTable::new(&Family::ALL, &Quality::SURE);
    for_scenes(
        |family, case| (family, case.judge(SIZE, &Quality::SURE).unwrap()),
        |(family, judged)| table.add(family, &judged),
    );
    let lines = table.lines().join("\n");
    for row in &table.all {
        let most = row.lost.worst.max(row.apart.worst);
        assert!(most == 0.0, "{lines}");
    }
}

#[test]
fn quality_that_guesses_loses_pixels() {
    let mut lost: f64 = 0.0;
    for_scenes(
        |_, case| case.judge(SIZE, &[Quality::Draft]).unwrap(),
        |judged| {
            let mut table = FamilyTable::new(&[], &[Quality::Draft]);
            table.add(Family::ALL[0], &judged);
            lost = lost.max(table.all[0].lost.worst);
        },
    );
    assert!(lost > 1.0, "{lost} %");
}

#[test]
fn every_random_scene_is_accepted() {
    let count = 200 * Family::ALL.len();
    let made = |index| {
        let (_, case) = scene_of_run(&Family::ALL, SEED, index);
        (built(&case.scene, &case.camera).err(), case.name)
    };
    in_order(count, made, |(error, name)| {
        assert!(error.is_none(), "{name}: {error:?}");
    });
}

#[test]
fn random_scene_is_the_same_each_time_and_from_its_file() {
    let check = |family: Family, case: Case| {
        let number = case.name.split('-').nth(2).unwrap().parse().unwrap();
        assert_eq!(family.case(SEED, number), case);
        assert_ne!(family.case(SEED + 1, number).scene, case.scene);
        let file = SceneFile::parse(&file::json(&case), None).unwrap();
        assert_eq!(file.name(), Some(case.name.as_str()));
        assert_eq!(file.reference(), (case.scene, case.camera));
    };
    for_scenes(check, |()| ());
}

#[test]
fn truth_is_the_picture_of_the_reference() {
    let check = |_, case: Case| {
        let (scene, eye, n) = (&case.scene, &case.camera, u32::from(case.reflections));
        let expected = render(scene, eye, 32, 24, n, Shading::BlinnPhong);
        assert_eq!(truth(scene, eye, (32, 24), n).lit, expected.pixels);
    };
    for_scenes(check, |()| ());
}

#[test]
fn exact_draws_what_truth_draws_without_shadows_and_highlights() {
    let mut sum = 0.0;
    for_scenes(
        |_, case| (case.plain_exact(SIZE).unwrap(), case.name),
        |(right, name)| {
            assert!(right >= BAR_PLAIN, "{name}: {right} %");
            sum += right;
        },
    );
    assert!(sum / SCENES as f64 > 99.0, "{sum}");
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
    let mut judged = None;
    // On a thread with a large stack: a scene with the room of a scene file is built on it.
    in_order(
        1,
        |_| case.judge(Size::new(96, 96), &Quality::SURE),
        |it| judged = it.ok(),
    );
    let judged = judged.expect("the rod is accepted");
    let truth = render(&case.scene, &CAMERA, 96, 96, 4, Shading::BlinnPhong).pixels;
    for lost in &judged.lost {
        let counts = lost.counts;
        assert_eq!((counts.pixels, counts.light, counts.apart), (96 * 96, 0, 0));
        let wrong = lost.pixels.iter().zip(&truth).filter(|(a, b)| {
            let mut channels = a.iter().zip(*b);
            channels.any(|(a, b)| a.abs_diff(*b) > 8)
        });
        assert_eq!(counts.seen, wrong.count());
    }
}
