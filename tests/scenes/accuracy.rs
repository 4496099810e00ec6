//! Tests how close fixed point is to double precision, on every built-in scene and in a telephoto
//! view.

use std::fmt::Display;

use command_line::{Quality, Settings, Shading, Source};
use embedded_graphics::prelude::Size;
use reflet::description::Description;
use reflet::host::compare::{Difference, compare};
use reflet::host::reference::render;
use reflet::scenes::NAMES;
use reflet::{Camera, Material, SceneBuilder, room};

const SIDE: u32 = 320;
const REFLECTIONS: u8 = 4;

/// Smallest shares of equal pixels and smallest PSNR that a picture must reach.
struct Bar {
    name: &'static str,
    same: f64,
    within1: f64,
    psnr: f64,
}

const fn bar(name: &'static str, same: f64, within1: f64, psnr: f64) -> Bar {
    Bar {
        name,
        same,
        within1,
        psnr,
    }
}

const FAST: Bar = bar("fast", 0.0, 0.999, 46.0);

/// Bar of the quality `Exact`: as good as single precision, or better.
const EXACT: Bar = bar("exact", 0.998, 0.999, 55.0);

/// Bar of the quality `Draft`, which guesses.
const DRAFT: Bar = bar("draft", 0.0, 0.998, 40.0);

/// Bar of the quality `Small`: that of `Fast`.
const SMALL: Bar = Bar {
    name: "small",
    ..FAST
};

const NORMALS: Bar = bar("normals", 0.0, 0.999, 46.0);

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

/// Draws a scene in some qualities and compares each picture with the reference.
fn differences(
    source: &Source,
    shading: Shading,
    qualities: impl IntoIterator<Item = Quality>,
) -> impl Iterator<Item = Difference> {
    let ((scene, camera), n) = (source.reference(), REFLECTIONS.into());
    let truth = render(&scene, &camera, SIDE, SIDE, n, shading.into());
    qualities.into_iter().map(move |quality| {
        let settings = Settings {
            reflections: REFLECTIONS,
            shading,
            quality,
        };
        let picture = source.drawn(Size::new(SIDE, SIDE), settings);
        compare(&picture, &truth).unwrap()
    })
}

/// Returns a line for each bar that a scene misses in one shading.
fn missed(name: &str, shading: Shading) -> Vec<String> {
    let source = Source::built_in(name).unwrap();
    let (bars, qualities) = match shading {
        Shading::Normals => (vec![NORMALS], vec![Quality::Fast]),
        _ => (
            vec![DRAFT, FAST, SMALL, EXACT],
            vec![
                Quality::Draft,
                Quality::Fast,
                Quality::Small,
                Quality::Exact,
            ],
        ),
    };
    let found = differences(&source, shading, qualities);
    let missed = bars.iter().zip(found);
    missed
        .filter_map(|(bar, found)| bar.missed(name, &found))
        .collect()
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

/// Returns a scene that is seen by its own camera.
fn described(scene: &Description<'_>) -> Source {
    let camera = scene.camera.expect("the scene has a camera");
    let (scene, camera) = (scene.into(), (&camera).into());
    Source::described("described".to_owned(), scene, camera).unwrap()
}

#[test]
fn reflection_of_something_bright_is_not_cut_off() {
    let source = described(&LAMPLIGHT.description());
    let qualities = [Quality::Fast, Quality::Small];
    for found in differences(&source, Shading::BlinnPhong, qualities) {
        assert!(found.within1 >= 0.999, "{found:?}");
    }
}

#[test]
fn telephoto_view_does_not_hurt_fixed_point() {
    let bar = Bar {
        psnr: 60.0,
        ..EXACT
    };
    let source = described(&TELEPHOTO.description());
    for shading in [Shading::BlinnPhong, Shading::Phong] {
        for found in differences(&source, shading, [Quality::Exact]) {
            assert_eq!(bar.missed(format!("{shading:?}"), &found), None);
        }
    }
}
