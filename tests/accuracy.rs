//! Tests how close fixed point is to double precision, on every built-in scene and in a telephoto
//! view.

use std::fmt::Display;

use command_line::{Quality, Settings, Shading, Source};
use embedded_graphics::prelude::Size;
use reflet::host::compare::{Difference, compare};
use reflet::host::painted;
use reflet::host::reference::{self, render};
use reflet::quality::{Exact, Fast, Small};
use reflet::scenes::NAMES;
use reflet::shading::Phong;
use reflet::{Camera, Material, Scene, SceneBuilder, room};

const SIDE: u32 = 320;
const REFLECTIONS: u8 = 4;

/// Smallest shares of equal pixels and smallest PSNR that a picture must reach.
struct Bar {
    name: &'static str,
    same: f64,
    within1: f64,
    psnr: f64,
}

const FAST: Bar = Bar {
    name: "fast",
    same: 0.0,
    within1: 0.999,
    psnr: 46.0,
};

/// Bar of the quality `Exact`: as good as single precision, or better.
const EXACT: Bar = Bar {
    name: "exact",
    same: 0.998,
    within1: 0.999,
    psnr: 55.0,
};

/// Bar of the quality `Draft`, which guesses.
const DRAFT: Bar = Bar {
    name: "draft",
    same: 0.0,
    within1: 0.998,
    psnr: 40.0,
};

/// Bar of the quality `Small`: that of `Fast`.
const SMALL: Bar = Bar {
    name: "small",
    ..FAST
};

const NORMALS: Bar = Bar {
    name: "normals",
    same: 0.0,
    within1: 0.999,
    psnr: 46.0,
};

impl Bar {
    /// Prints a line of the table, and returns this line if the bar is missed.
    fn missed(&self, name: impl Display, found: &Difference) -> Option<String> {
        let Difference {
            same,
            within1,
            psnr,
            max,
            ..
        } = found;
        let line = format!(
            "{name:<18} {:<8} same {same:.5}  within 1 {within1:.5}  {psnr:6.2} dB  max {max}",
            self.name
        );
        println!("{line}");
        let is_met = *same >= self.same && *within1 >= self.within1 && *psnr >= self.psnr;
        (!is_met).then_some(line)
    }
}

/// Draws a scene in one shading and compares it with the reference. Returns a line for each missed
/// bar.
fn missed(name: &str, shading: Shading) -> Vec<String> {
    let source = Source::built_in(name).unwrap();
    let (scene, camera) = source.reference();
    let truth = render(
        &scene,
        &camera,
        SIDE,
        SIDE,
        REFLECTIONS.into(),
        shading.into(),
    );
    let size = Size::new(SIDE, SIDE);
    let bars = match shading {
        Shading::Normals => vec![(NORMALS, Quality::Fast)],
        _ => vec![
            (DRAFT, Quality::Draft),
            (FAST, Quality::Fast),
            (SMALL, Quality::Small),
            (EXACT, Quality::Exact),
        ],
    };
    let missed = bars.into_iter().filter_map(|(bar, quality)| {
        let settings = Settings {
            reflections: REFLECTIONS,
            shading,
            quality,
        };
        let picture = source.drawn(size, settings);
        bar.missed(name, &compare(&picture, &truth).unwrap())
    });
    missed.collect()
}

fn assert_bars_are_met(shading: Shading) {
    println!("{shading:?}");
    let missed = NAMES.map(|name| missed(name, shading)).concat();
    assert!(missed.is_empty(), "{shading:?}: {}", missed.join("\n"));
}

#[test]
fn every_scene_in_blinn_phong_is_close_to_double_precision() {
    assert_bars_are_met(Shading::BlinnPhong);
}

#[test]
fn every_scene_in_phong_is_close_to_double_precision() {
    assert_bars_are_met(Shading::Phong);
}

#[test]
fn normals_of_every_scene_are_close_to_double_precision() {
    assert_bars_are_met(Shading::Normals);
}

const GOLD: Material = Material::new([0.7, 0.6, 0.0])
    .ambient(0.2)
    .diffuse(0.4)
    .specular(0.8, 4.0)
    .mirror(0.4);
const WATER: Material = Material::new([0.6, 0.8, 1.0])
    .ambient(0.2)
    .diffuse(0.3)
    .specular(1.0, 50.0)
    .mirror(0.5);
const CHALK: Material = Material::new([0.9, 0.9, 0.8]).ambient(0.2).diffuse(0.8);

/// A few shapes on a floor, from 90 units away and just above the horizon. Single precision only
/// reaches 30 decibels here.
const TELEPHOTO: SceneBuilder<room!(spheres: 4, planes: 1, cylinders: 1, lights: 2)> =
    SceneBuilder::new()
        .sphere([-1.0, 0.0, 0.6], 0.6, GOLD)
        .sphere([0.6, -0.4, 0.4], 0.4, WATER)
        .sphere([1.3, 0.7, 0.8], 0.8, CHALK)
        .sphere([-0.1, -1.1, 0.2], 0.2, GOLD)
        .cylinder([0.2, 1.2, 0.7], [0.1, 0.0, 1.0], 0.4, 1.4, GOLD)
        .plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], WATER)
        .light([30.0, -50.0, 40.0], [0.8, 0.8, 0.7])
        .light([-20.0, -60.0, 15.0], [0.3, 0.3, 0.4])
        .background([0.3, 0.5, 0.9])
        .camera(FAR_AWAY);

const FAR_AWAY: Camera =
    Camera::look_at([12.0, -89.0, 4.5], [0.1, 0.0, 0.5], [0.0, 0.0, 1.0]).fov(2.5);

const TELEPHOTO_SCENE: Scene<room!(spheres: 4, planes: 1, cylinders: 1, lights: 2)> =
    TELEPHOTO.build();

const LAMP: Material = Material::new([1.8; 3]).ambient(16.0).diffuse(0.0);
const DULL: Material = Material::new([0.2; 3])
    .ambient(1.0)
    .diffuse(0.0)
    .mirror(0.0038);

const ABOVE_THE_FLOOR: Camera =
    Camera::look_at([0.0, -3.0, 2.0], [0.0, 0.0, 0.0], [0.0, 0.0, 1.0]).fov(60.0);

/// A floor that mirrors less than 1/256 of the light, under a ball 28.8 times as bright as white.
const LAMPLIGHT: SceneBuilder<room!(spheres: 1, planes: 1)> = SceneBuilder::new()
    .sphere([0.0, 3.0, 2.0], 2.5, LAMP)
    .plane([0.0, 0.0, 0.0], [0.0, 0.0, 1.0], DULL)
    .camera(ABOVE_THE_FLOOR);

const LAMPLIGHT_SCENE: Scene<room!(spheres: 1, planes: 1)> = LAMPLIGHT.build();

#[test]
fn reflection_of_something_bright_is_not_cut_off() {
    let scene = reference::Scene::from(&LAMPLIGHT.description());
    let camera = reference::Camera::from(&ABOVE_THE_FLOOR);
    let n = u32::from(REFLECTIONS);
    let truth = render(
        &scene,
        &camera,
        SIDE,
        SIDE,
        n,
        reference::Shading::BlinnPhong,
    );
    let frame = || {
        LAMPLIGHT_SCENE
            .frame(&ABOVE_THE_FLOOR)
            .reflections(REFLECTIONS)
    };
    let size = Size::new(SIDE, SIDE);
    for picture in [
        painted(
            &frame()
                .quality::<Fast>()
                .prepare(size)
                .on(&LAMPLIGHT_SCENE)
                .unwrap(),
        ),
        painted(
            &frame()
                .quality::<Small>()
                .prepare(size)
                .on(&LAMPLIGHT_SCENE)
                .unwrap(),
        ),
    ] {
        let found = compare(&picture, &truth).unwrap();
        assert!(found.within1 >= 0.999, "{found:?}");
    }
}

#[test]
fn telephoto_view_does_not_hurt_fixed_point() {
    let bar = Bar {
        name: "exact",
        same: 0.998,
        within1: 0.999,
        psnr: 60.0,
    };
    let scene = reference::Scene::from(&TELEPHOTO.description());
    let camera = reference::Camera::from(&FAR_AWAY);
    let frame = TELEPHOTO_SCENE
        .frame(&FAR_AWAY)
        .reflections(REFLECTIONS)
        .quality::<Exact>();
    let size = Size::new(SIDE, SIDE);
    let n = u32::from(REFLECTIONS);
    let pairs = [
        (
            painted(&frame.prepare(size).on(&TELEPHOTO_SCENE).unwrap()),
            reference::Shading::BlinnPhong,
        ),
        (
            painted(
                &frame
                    .shading::<Phong>()
                    .prepare(size)
                    .on(&TELEPHOTO_SCENE)
                    .unwrap(),
            ),
            reference::Shading::Phong,
        ),
    ];
    for (picture, shading) in pairs {
        let truth = render(&scene, &camera, SIDE, SIDE, n, shading);
        let found = compare(&picture, &truth).unwrap();
        assert_eq!(bar.missed(format!("{shading:?}"), &found), None);
    }
}
