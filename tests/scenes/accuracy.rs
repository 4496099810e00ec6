//! Tests how close fixed point is to double precision, on every built-in scene and in a telephoto
//! view.

use command_line::{Quality, Settings, Shading, Source};
use embedded_graphics::prelude::Size;
use reflet::description::Description;
use reflet::host::compare::compare;
use reflet::host::reference::render;
use reflet::scenes::NAMES;
use reflet::shading::BlinnPhong;
use reflet::{Camera, Material, SceneBuilder, room};

use super::near::{Bar, Scenery, UP, apart, assert_near, is_met};

const SIDE: u32 = 320;
const REFLECTIONS: u8 = 4;

const FAST: Bar = [0.0, 0.999, 46.0];
/// As good as single precision, or better.
const EXACT: Bar = [0.998, 0.999, 55.0];

const BARS: [(Quality, Bar); 3] = [
    (Quality::Fast, FAST),
    (Quality::Small, FAST),
    (Quality::Exact, EXACT),
];

/// Draws a scene in some qualities, and prints a line for each. Returns the lines of those that miss their bars.
fn missed(source: &Source, shading: Shading, bars: &[(Quality, Bar)]) -> Vec<String> {
    let ((scene, camera), n) = (source.reference(), REFLECTIONS.into());
    let truth = render(&scene, &camera, SIDE, SIDE, n, shading.into());
    let missed = bars.iter().filter_map(|&(quality, bar)| {
        let settings = Settings {
            reflections: REFLECTIONS,
            shading,
            quality,
        };
        let picture = source.drawn(Size::new(SIDE, SIDE), settings);
        let found = compare(&picture, &truth).unwrap();
        let (name, quality) = (source.name(), quality.name());
        let line = format!("{name:<18} {shading:?} {quality:<6} {found:?}");
        println!("{line}");
        (!is_met(bar, &found)).then_some(line)
    });
    missed.collect()
}

fn assert_bars_are_met(shading: Shading, bars: &[(Quality, Bar)]) {
    let missed = NAMES.map(|name| missed(&Source::built_in(name).unwrap(), shading, bars));
    assert!(missed.concat().is_empty(), "{:#?}", missed.concat());
}

#[test]
fn every_scene_in_blinn_phong_is_close_to_double_precision() {
    assert_bars_are_met(Shading::BlinnPhong, &BARS);
}

#[test]
fn every_scene_in_phong_is_close_to_double_precision() {
    assert_bars_are_met(Shading::Phong, &BARS);
}

#[test]
fn normals_of_every_scene_are_close_to_double_precision() {
    assert_bars_are_met(Shading::Normals, &[(Quality::Fast, FAST)]);
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
    let bars = [Quality::Fast, Quality::Small].map(|it| (it, [0.0, 0.999, 0.0]));
    let missed = missed(&source, Shading::BlinnPhong, &bars);
    assert!(missed.is_empty(), "{missed:#?}");
}

/// Floors under a low lamp: the camera's height, how far ahead it looks, its field of view, the lamp's position, and the
/// strength and the shininess of highlights. In some pixels, light and viewer are almost opposite.
const LOW_LAMPS: [[f64; 8]; 4] = [
    [0.1, 0.34, 112.0, 0.0, 1.1, 0.27, 1.0, 30.0],
    [0.734, 1.73, 137.773, -0.047, 2.556, 0.115, 1.0, 2.752],
    [0.478, 1.686, 131.087, -0.721, 0.324, 0.051, 1.0, 15.363],
    [0.061, 0.65, 133.679, 0.213, 1.203, 0.35, 1.595, 6.959],
];

#[test]
fn highlights_of_low_lamps_on_a_floor_are_not_missed() {
    let size = Size::new(64, 64);
    for [height, ahead, field, x, y, z, strength, shininess] in LOW_LAMPS {
        let mut scene = Scenery::new();
        let grey = Material::from_numbers([0.5; 3], 0.1, 0.5, (strength, shininess), 0.0).unwrap();
        let grey = scene.add_material(grey).unwrap();
        scene.add_plane([0.0; 3], UP, grey).unwrap();
        scene.add_light([x, y, z], [1.0; 3]).unwrap();
        let camera = Camera::new([0.0, 0.0, height], [0.0, ahead, 0.0], UP, field).unwrap();
        let shading = reflet::host::reference::Shading::BlinnPhong;
        let bars = [[0.0, 0.999, 46.0], [0.99, 1.0, 60.0], [0.99, 1.0, 60.0]];
        let [fast, small, _] = assert_near::<BlinnPhong>((&scene, &camera), size, shading, bars);
        assert_eq!(apart(&fast, &small, 2), 0, "the lamp at {x} {y} {z}");
    }
}

#[test]
fn telephoto_view_does_not_hurt_fixed_point() {
    let [same, within1, _] = EXACT;
    let source = described(&TELEPHOTO.description());
    for shading in [Shading::BlinnPhong, Shading::Phong] {
        let missed = missed(&source, shading, &[(Quality::Exact, [same, within1, 60.0])]);
        assert!(missed.is_empty(), "{missed:#?}");
    }
}
