//! The path of a pixel has the colour that `Exact` draws, in every built-in scene and both shadings.

use embedded_graphics::pixelcolor::{Rgb888, RgbColor};
use embedded_graphics::prelude::Size;
use std::vec::Vec;

use super::*;
use crate::host::file::{FileScene, built};
use crate::host::reference;
use crate::qualities::Exact;
use crate::scene::Room;
use crate::scenes::{self, BuiltIn, Empty, Floor, Mirror1, Visitor};
use crate::shade::{BlinnPhong, Phong, Shading};
use crate::{Camera, FrameBuilder, Material, RuntimeScene};

const SIZE: Size = Size::new(48, 36);

fn all_paths_are_drawn<S: AnyScene, K: Shading>(scene: &S, camera: &Camera, reflections: u8) {
    let frame = FrameBuilder::new(scene, camera).reflections(reflections);
    let frame = frame.quality::<Exact>().shading::<K>().prepare(SIZE);
    let rows = frame.on(scene).unwrap();
    let mut drawn = [Rgb888::BLACK; SIZE.width as usize];
    for y in 0..SIZE.height {
        rows.row(y, 0, &mut drawn);
        let paths = paths_of_row(&rows, y);
        let pixels: Vec<_> = paths.iter().map(|it| it.pixel).collect();
        let drawn = drawn.map(|it| [it.r(), it.g(), it.b()]);
        assert_eq!(pixels, drawn, "row {y}");
        for path in &paths {
            adds_up(path);
        }
        let at = (y % SIZE.width, y);
        assert_eq!(path_of(&rows, at).as_ref(), Some(&paths[at.0 as usize]));
    }
    assert_eq!(path_of(&rows, (SIZE.width, 0)), None);
}

/// Tests that the terms of a path add up to its sum, and the sum to its pixel.
fn adds_up(path: &Path) {
    let last = path.steps.last().map_or(1.0, |step| step.weight_after);
    for channel in 0..3 {
        let term = |step: &Step| (step.weight - step.weight_after) * step.color[channel];
        let missed = path.background.map_or(0.0, |color| last * color[channel]);
        let sum: f64 = path.steps.iter().map(term).sum::<f64>() + missed;
        // Each term is rounded down to 2^-24.
        let most = (path.steps.len() + 2) as f64 * 2f64.powi(-23);
        assert!((sum - path.sum[channel]).abs() <= most, "{path:?}");
        let level = (path.sum[channel] * 255.0).round().clamp(0.0, 255.0);
        assert_eq!(level, f64::from(path.pixel[channel]));
    }
    // A ray leads to each surface, and perhaps another beyond all of them.
    let beyond = usize::from(path.end == End::Missed);
    let rays = path.steps.len()..=path.steps.len() + beyond;
    assert!(rays.contains(&path.rays.len()), "{path:?}");
    for (step, next) in path.steps.iter().zip(path.steps.iter().skip(1)) {
        assert_eq!((step.weight_after, step.to), (next.weight, next.from));
        let alpha = step.weight_after / step.weight;
        assert!((alpha - step.alpha).abs() < 1e-6);
    }
}

struct Describe;

impl Visitor for Describe {
    type Output = (reference::Scene, Camera);

    fn visit<S: BuiltIn>(self) -> Self::Output {
        let scene = S::with_description(|description| reference::Scene::from(&description));
        (scene, S::CAMERA)
    }
}

#[test]
fn path_has_the_colour_of_its_pixel() {
    for name in scenes::NAMES {
        let (scene, camera) = scenes::visit(name, Describe).unwrap();
        let scene = built(&scene, &(&camera).into()).unwrap();
        for reflections in [0, 4] {
            all_paths_are_drawn::<FileScene, BlinnPhong>(&scene, &camera, reflections);
            all_paths_are_drawn::<FileScene, Phong>(&scene, &camera, reflections);
        }
    }
}

#[test]
fn ray_off_a_floor_starts_above_it_and_is_mirrored() {
    let mut scene = RuntimeScene::<Room<1, 1, 0, 0, 1>>::new();
    let glass = scene
        .add_material(Material::new([1.0; 3]).mirror(0.5))
        .unwrap();
    scene.add_plane([0, 0, 0], [0, 0, 1], glass).unwrap();
    scene.add_sphere([0, 0, 9], 1, glass).unwrap();
    let camera = Camera::look_at([0.0, 0.0, 2.0], [0.0; 3], [0.0, 1.0, 0.0]);
    let scene = scene.build().unwrap();
    let frame = scene.frame(&camera).quality::<Exact>().reflections(1);
    let frame = frame.prepare(Size::new(1, 1));
    let path = path_of(&frame.on(&scene).unwrap(), (0, 0)).unwrap();
    assert_eq!(path.rays, [[0.0, 0.0, -1.0], [0.0, 0.0, 1.0]]);
    assert_eq!(path.steps[0].from, [0.0, 0.0, 2.0]);
    // Two steps of the scene's grid, 2^-20 each or less.
    let height = path.steps[1].from[2];
    assert!(
        (height - 1e-3).abs() <= 2.0 / f64::from(1 << 20),
        "{height}"
    );
}

#[test]
fn constant_scenes_end_their_paths_early_and_add_up() {
    all_paths_are_drawn::<_, BlinnPhong>(&Empty, &Empty::CAMERA, 4);
    all_paths_are_drawn::<_, BlinnPhong>(&Floor, &Floor::CAMERA, 4);
    all_paths_are_drawn::<_, BlinnPhong>(&Mirror1, &Mirror1::CAMERA, 4);
}
