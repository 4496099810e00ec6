//! Tests that the built-in scenes have exactly the numbers that their authors wrote.
//!
//! The authors' file is in the folder `REFLET_COURSE`, or else next to the repository.

use std::{env, fs, path::PathBuf};

use reflet::host::file::SceneFile;
use reflet::host::reference::{Camera, Scene};
use reflet::scenes::{BuiltIn, NAMES, Visitor, visit};

#[test]
fn every_built_in_scene_has_the_figures_of_its_source() {
    let folder = env::var_os("REFLET_COURSE").map_or_else(
        || PathBuf::from(env!("CARGO_MANIFEST_DIR")).join("../shared/course"),
        PathBuf::from,
    );
    let Ok(text) = fs::read_to_string(folder.join("scenes.json")) else {
        println!("skipped: there is no scenes.json in {}", folder.display());
        return;
    };
    let sources = SceneFile::parse_all(&text).unwrap();
    let names: Vec<_> = sources.iter().filter_map(SceneFile::name).collect();
    assert_eq!(names, NAMES);
    for (name, source) in NAMES.into_iter().zip(&sources) {
        let (scene, camera) = source.reference();
        let (built_in, its_camera) = visit(name, Describe).unwrap();
        assert_eq!(camera, its_camera, "{name}");
        assert_eq!(parts(&built_in), parts(&scene), "{name}");
    }
}

/// Returns a scene as lines: one with the numbers of the whole scene, and one for each of its parts. A shape's line
/// has its material, because two scenes may list the same materials in another order.
fn parts(scene: &Scene) -> Vec<String> {
    let whole = format!("{:?} {:?} {}", scene.background, scene.sky, scene.epsilon);
    let shapes = scene.shapes().map(|it| {
        let material = &scene.materials[it.material];
        format!("{} {:?} {material:?}", it.kind, it.fields)
    });
    let lights = scene.lights.iter().map(|it| format!("{it:?}"));
    [whole].into_iter().chain(shapes).chain(lights).collect()
}

/// Converts a built-in scene to that of a file.
struct Describe;

impl Visitor for Describe {
    type Output = (Scene, Camera);

    fn visit<S: BuiltIn>(self) -> Self::Output {
        S::with_description(|scene| {
            assert_eq!(scene.camera.as_ref(), Some(&S::CAMERA));
            (Scene::from(&scene), Camera::from(&S::CAMERA))
        })
    }
}
