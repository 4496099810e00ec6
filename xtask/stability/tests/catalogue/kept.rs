//! Tests what every picture preserves: it has no more light than the scene, and changes little if
//! the camera moves by a step.

use command_line::Quality;
use embedded_graphics::geometry::Size;
use lost::case::difference;
use proptest::prelude::*;
use proptest::test_runner::{Config, RngAlgorithm, TestCaseError, TestRng, TestRunner};

use super::symmetry::{SIDE, drawn};
use stability::catalogue::draft::{Draft, EYE, Setting, TARGET, UP, still_life, usual};
use stability::catalogue::judge::is_edge;
use stability::catalogue::scene::Scene;

fn runner(cases: u32) -> TestRunner {
    let mut config = Config::with_cases(cases);
    config.failure_persistence = None;
    TestRunner::new_with_rng(config, TestRng::deterministic_rng(RngAlgorithm::ChaCha))
}

/// Returns shapes of one glowing material in front of a background, without lights.
fn unlit(color: f64, mirror: f64, background: f64, spheres: &[([f64; 3], f64)]) -> Draft {
    let draft = Draft::through([0.1, -3.0, 0.3], [0.0; 3], UP, 80.0)
        .material("own", [color; 3], [1.0, 0.0, 0.0, 1.0, mirror])
        .plane([0.0, 0.0, -1.0], [0.1, 0.0, 1.0], "own")
        .cylinder([0.0, 0.5, 0.0], [0.3, 0.2, 1.0], (0.3, 1.5), "own")
        .background([background; 3]);
    let spheres = spheres.iter();
    spheres.fold(draft, |draft, it| draft.sphere(it.0, it.1, "own"))
}

/// Fails if a channel of the scene's picture is brighter than `most`, in any quality.
fn none_is_brighter(draft: &Draft, most: u8) -> Result<(), TestCaseError> {
    let scene = Scene::read(draft).unwrap();
    for quality in [Quality::Exact, Quality::Fast] {
        let picture = scene.drawn(quality, Size::new(48, 24));
        let brightest = picture.pixels.into_iter().flatten().max().unwrap();
        prop_assert!(brightest <= most, "{quality:?}: {brightest} of {most}");
    }
    Ok(())
}

/// Returns a sphere and a cylinder on a floor, of one material with this colour, with a black
/// background.
fn set(color: f64, coefficients: [f64; 5]) -> Draft {
    usual()
        .material("own", [color; 3], coefficients)
        .sphere([-0.5, 0.0, 0.5], 0.5, "own")
        .cylinder([0.7, 0.0, 0.5], [0.0, 0.0, 1.0], (0.4, 1.0), "own")
        .plane([0.0; 3], [0.0, 0.0, 1.0], "own")
        .background([0.0; 3])
}

#[test]
fn no_pixel_is_brighter_than_the_brightest_surface() {
    let spheres = prop::collection::vec((prop::array::uniform3(-1.0..1.0), 0.05..0.6), 0..6);
    let scenes = (0.0..1.0, 0.0..=1.0, 0.0..1.0, spheres, any::<u8>());
    let outcome = runner(400).run(&scenes, |(color, mirror, background, spheres, n)| {
        let most = (255.0 * f64::max(color, background)).round() as u8;
        let draft = unlit(color, mirror, background, &spheres);
        none_is_brighter(&draft.reflections(n), most)
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn lit_pixel_is_no_brighter_than_its_material_may_shine() {
    // The coefficients add up to 1 under a light of 1.
    let coefficients = (0.0..1.0, 0.0..1.0, 0.0..=1.0, 0.0..300.0);
    // A light at the camera makes diffuse and specular term as large as they can be in one point.
    let scenes = (coefficients, 0.05..1.0, any::<u8>(), any::<bool>());
    let outcome = runner(200).run(&scenes, |(coefficients, color, n, is_beside)| {
        let (ambient, part, mirror, shininess) = coefficients;
        let (diffuse, specular) = ((1.0 - ambient) * part, (1.0 - ambient) * (1.0 - part));
        let draft = set(color, [ambient, diffuse, specular, shininess, mirror]);
        let draft = draft.light(if is_beside { [0.7, -3.0, 2.0] } else { EYE });
        none_is_brighter(&draft.reflections(n), (255.0 * color).round() as u8)
    });
    outcome.unwrap_or_else(|error| panic!("{error}"));
}

#[test]
fn black_absorbs_everything() {
    let soot = set(0.0, [1.0, 1.0, 1.0, 4.0, 0.0]);
    let soot = soot.plane([0.0, 9.0, 0.0], [0.0, 1.0, 0.0], "own");
    none_is_brighter(&Setting::HERE.lit(soot), 0).unwrap();
}

/// Moving the camera by a step or two of the grid changes no pixel by more than two levels, except
/// at edges, where the pixel's ray may hit another surface.
#[test]
fn camera_moved_by_a_step_changes_edges_alone() {
    let eyes = [EYE, [-3.0, -2.5, 0.7], [1.0, -0.9, 0.1]];
    let mut changed = 0;
    for [x, y, z] in eyes {
        let seen_from = |eye| drawn(&still_life(eye, TARGET, 60.0));
        let before = seen_from([x, y, z]);
        // The grid of the still life has steps of 2^-23 to 2^-22.
        let step = 2f64.powi(-22);
        for moved in [[x + step, y, z], [x, y + step, z], [x, y, z - step]] {
            let after = seen_from(moved);
            for (index, (a, b)) in before.pixels.iter().zip(&after.pixels).enumerate() {
                let apart = difference(*a, *b);
                changed += u32::from(apart > 0);
                let is_held = apart <= 2 || is_edge(&before, index, 4);
                assert!(is_held, "pixel {index}: {a:?} {b:?}, {moved:?}");
            }
        }
    }
    assert!(changed < 9 * SIDE * SIDE / 100, "{changed} pixels");
}
